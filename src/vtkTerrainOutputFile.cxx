// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainOutputFile.h"

#include "core/files/OutputFile.h"
#include "raster/InputFiles.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

class vtkTerrainOutputFile::vtkInternals
{
public:
  std::vector<std::string> Inputs;
  std::string Path;
  terrain::OutputFile File;
};

vtkStandardNewMacro(vtkTerrainOutputFile);

//------------------------------------------------------------------------------
vtkTerrainOutputFile::vtkTerrainOutputFile()
  : Internals(std::make_unique<vtkInternals>())
{
}

//------------------------------------------------------------------------------
vtkTerrainOutputFile::~vtkTerrainOutputFile() = default;

//------------------------------------------------------------------------------
bool vtkTerrainOutputFile::Finish(const std::string& error)
{
  this->ErrorMessage = error.empty() ? error : this->Internals->Path + ": " + error;
  return error.empty();
}

//------------------------------------------------------------------------------
void vtkTerrainOutputFile::AddInput(const std::string& name)
{
  if (!name.empty())
  {
    this->Internals->Inputs.push_back(name);
  }
}

//------------------------------------------------------------------------------
std::string vtkTerrainOutputFile::FindInput(const std::string& path) const
{
  const std::vector<std::string>& inputs = this->Internals->Inputs;
  const auto found = std::find_if(inputs.begin(), inputs.end(),
    [&path](const std::string& input) { return terrain::IsPartOfInput(path, input); });
  return found == inputs.end() ? std::string() : *found;
}

//------------------------------------------------------------------------------
bool vtkTerrainOutputFile::Open(const std::string& path)
{
  this->Internals->File.Discard();
  this->Internals->Path = path;
  const std::string input = this->FindInput(path);
  return this->Finish(
    input.empty() ? this->Internals->File.Open(path) : "the input '" + input + "' is read from it");
}

//------------------------------------------------------------------------------
std::string vtkTerrainOutputFile::GetPartialFileName() const
{
  return this->Internals->File.IsOpen() ? this->Internals->File.GetPartialPath() : std::string();
}

//------------------------------------------------------------------------------
bool vtkTerrainOutputFile::Write(const void* bytes, std::size_t size)
{
  return this->Finish(this->Internals->File.IsOpen() ? this->Internals->File.Write(bytes, size)
                                                     : "the file is not open");
}

//------------------------------------------------------------------------------
bool vtkTerrainOutputFile::Commit()
{
  const bool replaces = this->Internals->File.ReplacesFile();
  const std::string target = this->Internals->File.GetTarget();
  const bool done = this->Finish(
    this->Internals->File.IsOpen() ? this->Internals->File.Commit() : "the file is not open");
  for (const char* suffix : { ".aux.xml", ".ovr", ".msk" })
  {
    const std::string companion = target + suffix;
    std::error_code error;
    if (done && replaces && this->FindInput(companion).empty())
    {
      std::filesystem::remove(companion, error);
    }
  }
  return done;
}

//------------------------------------------------------------------------------
void vtkTerrainOutputFile::Discard()
{
  this->Internals->File.Discard();
}

//------------------------------------------------------------------------------
void vtkTerrainOutputFile::RemovePartialFiles()
{
  terrain::RemovePartialFiles();
}

//------------------------------------------------------------------------------
std::string vtkTerrainOutputFile::WhyNotInput(const std::string& path)
{
  return terrain::WhyNotInput(path);
}

//------------------------------------------------------------------------------
void vtkTerrainOutputFile::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Path: " << this->Internals->Path << "\n"
     << indent << "PartialFileName: " << this->GetPartialFileName() << "\n"
     << indent << "Inputs: " << this->Internals->Inputs.size() << "\n"
     << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
