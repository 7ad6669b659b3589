// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainGeoid.h"

#include "core/files/OutputFile.h"
#include "core/place/GeoidGrid.h"

#include "vtkObjectFactory.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <mutex>
#include <vector>

namespace
{
// Files up to this many bytes are held in memory.
constexpr std::streamoff kHeldInMemory = std::streamoff(64) << 20;

/// Names of the grids of a model, the finest first; the model itself if it is no family.
std::vector<std::string> Candidates(const std::string& model)
{
  if (model == "egm84")
  {
    return { "egm84-15", "egm84-30" };
  }
  if (model == "egm96")
  {
    return { "egm96-5", "egm96-15" };
  }
  if (model == "egm2008")
  {
    return { "egm2008-1", "egm2008-2_5", "egm2008-5" };
  }
  return { model };
}

std::string DefaultDirectory()
{
  char directory[terrain::kGeoidTextSize];
  terrain::GeoidGrid::GetDefaultDirectory(directory);
  return directory;
}

/// Size in bytes, -1 if the file cannot be opened.
std::streamoff FileSize(const std::string& path)
{
  if (!terrain::WhyNotInput(path).empty())
  {
    return -1;
  }
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  return file ? static_cast<std::streamoff>(file.tellg()) : -1;
}
}

class vtkTerrainGeoid::vtkInternals
{
public:
  std::mutex Mutex;
  bool IsLoaded = false;
  bool IsThreadSafe = false;
  std::string WhyNot;
  std::string FileName;
  std::unique_ptr<terrain::GeoidGrid> Geoid;
};

vtkStandardNewMacro(vtkTerrainGeoid);

vtkTerrainGeoid::vtkTerrainGeoid()
  : Internals(std::make_unique<vtkInternals>())
{
}

vtkTerrainGeoid::~vtkTerrainGeoid() = default;

void vtkTerrainGeoid::SetModel(const std::string& model)
{
  if (this->Model != model)
  {
    this->Model = model;
    this->Internals->IsLoaded = false;
    this->Modified();
  }
}

void vtkTerrainGeoid::SetDirectory(const std::string& directory)
{
  if (this->Directory != directory)
  {
    this->Directory = directory;
    this->Internals->IsLoaded = false;
    this->Modified();
  }
}

void vtkTerrainGeoid::Load()
{
  vtkInternals& internals = *this->Internals;
  const std::lock_guard<std::mutex> lock(internals.Mutex);
  if (internals.IsLoaded)
  {
    return;
  }
  internals.IsLoaded = true;
  internals.Geoid.reset();
  internals.FileName.clear();
  internals.WhyNot.clear();
  const std::string directory = this->Directory.empty() ? DefaultDirectory() : this->Directory;
  const std::vector<std::string> names = Candidates(this->Model);
  for (const std::string& name : names)
  {
    std::string path = directory;
    path.append("/").append(name).append(".pgm");
    const std::streamoff size = FileSize(path);
    if (size < 0)
    {
      continue;
    }
    char message[terrain::kGeoidTextSize];
    internals.IsThreadSafe = size <= kHeldInMemory;
    internals.Geoid =
      terrain::GeoidGrid::Open(name.c_str(), directory.c_str(), internals.IsThreadSafe, message);
    if (internals.Geoid)
    {
      internals.FileName = path;
    }
    else
    {
      internals.WhyNot = "the geoid data " + path + " cannot be read: " + message;
    }
    return;
  }
  internals.WhyNot =
    "heights above sea level and above the ellipsoid need geoid data: " + names.front() +
    ".pgm is not in " + directory + "; get it with 'geographiclib-get-geoids " + names.front() +
    "', or name its folder in GEOGRAPHICLIB_GEOID_PATH";
}

std::string vtkTerrainGeoid::GetWhyNot()
{
  this->Load();
  return this->Internals->WhyNot;
}

std::string vtkTerrainGeoid::GetFileName()
{
  this->Load();
  return this->Internals->FileName;
}

double vtkTerrainGeoid::GetHeight(double longitude, double latitude)
{
  const double place[3] = { longitude, latitude, 0.0 };
  double height = 0.0;
  this->GetHeights(place, &height, 1);
  return height;
}

void vtkTerrainGeoid::GetHeights(const double* places, double* heights, vtkIdType count)
{
  this->Load();
  vtkInternals& internals = *this->Internals;
  std::unique_lock<std::mutex> lock(internals.Mutex, std::defer_lock);
  if (!internals.IsThreadSafe)
  {
    lock.lock();
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double longitude = places[3 * i];
    const double latitude = places[3 * i + 1];
    heights[i] = std::numeric_limits<double>::quiet_NaN();
    if (internals.Geoid && std::abs(latitude) <= 90.0 && std::isfinite(longitude))
    {
      heights[i] = internals.Geoid->GetHeight(latitude, longitude);
    }
  }
}

void vtkTerrainGeoid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Model: " << this->Model << "\n";
  os << indent << "Directory: " << this->Directory << "\n";
  os << indent << "FileName: " << this->GetFileName() << "\n";
}
