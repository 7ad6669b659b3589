// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// terrain-prepare HEIGHTS OUT: prepares a raster of heights for view-dependent refinement; with
// --mesh it writes triangles for other programs.
//
// Reads the raster from north to south in bands of rows, so it never is in memory as a whole.
// Exit status 0; 2 for a wrong command line; 1 otherwise, with one line on stderr that names the
// file and the reason, and no output left behind.
#include "EmptyValues.h"
#include "Ending.h"
#include "HeightOptions.h"
#include "MeshOptions.h"
#include "NotNumbers.h"

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTerrainHierarchy.h>
#include <vtkTerrainOutputFile.h>
#include <vtkTerrainRasterReader.h>
#include <vtkUnsignedCharArray.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

namespace
{
/// A bar on stderr, if that is a terminal and the work is not quiet.
class ProgressBar
{
public:
  explicit ProgressBar(bool quiet)
    : Shown(!quiet && isatty(STDERR_FILENO) != 0)
  {
  }
  ~ProgressBar()
  {
    if (this->Percent >= 0)
    {
      std::fprintf(stderr, "\r%*s\r", 60, "");
    }
  }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void Show(double part)
  {
    const int percent = static_cast<int>(100.0 * part);
    if (this->Shown && percent != this->Percent)
    {
      this->Percent = percent;
      const std::string bar(static_cast<std::size_t>(percent) * 40 / 100, '#');
      std::fprintf(stderr, "\rpreparing [%-40s] %3d %%", bar.c_str(), percent);
    }
  }

private:
  bool Shown;
  int Percent = -1;
};

/// Reads bands of rows through the pipeline of the reader.
class RowReader
{
public:
  RowReader(const std::string& path, const HeightOptions& options)
  {
    this->Reader->SetFileName(path);
    options.Apply(this->Reader);
  }

  /// Empty, or why the raster cannot be read.
  std::string Open()
  {
    this->Reader->UpdateInformation();
    std::string error = this->Reader->GetErrorMessage();
    if (error.empty())
    {
      error = HeightOptions::WhyNotOneSite(this->Reader);
    }
    if (!error.empty())
    {
      return error;
    }
    vtkInformation* info = this->Reader->GetOutputInformation(0);
    info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), this->Extent);
    info->Get(vtkDataObject::ORIGIN(), this->Origin);
    info->Get(vtkDataObject::SPACING(), this->Spacing);
    for (int axis = 0; axis < 2; ++axis)
    {
      this->Origin[axis] += this->Extent[std::size_t{ 2 } * axis] * this->Spacing[axis];
    }
    return error;
  }

  int Width() const
  {
    return this->Extent[1] - this->Extent[0] + 1;
  }
  int Height() const
  {
    return this->Extent[3] - this->Extent[2] + 1;
  }

  /// Rows [first, first + count), from the south, as floats with NaN for no data.
  std::string Read(vtkIdType first, vtkIdType count, float* heights)
  {
    int part[6];
    std::copy_n(this->Extent, 6, part);
    part[2] = this->Extent[2] + static_cast<int>(first);
    part[3] = part[2] + static_cast<int>(count) - 1;
    this->Reader->UpdateExtent(part);
    std::string error = this->Reader->GetErrorMessage();
    vtkImageData* image = this->Reader->GetOutput();
    vtkDataArray* scalars = image->GetPointData()->GetScalars();
    if (!error.empty() || !scalars)
    {
      return error.empty() ? "the rows cannot be read" : error;
    }
    const int* extent = image->GetExtent();
    vtkUnsignedCharArray* ghosts = image->GetPointGhostArray();
    const vtkIdType width = this->Width();
    const vtkIdType stride = extent[1] - extent[0] + 1;
    for (vtkIdType y = 0; y < count; ++y)
    {
      for (vtkIdType x = 0; x < width; ++x)
      {
        const vtkIdType id = (part[2] + y - extent[2]) * stride + this->Extent[0] + x - extent[0];
        const bool hidden =
          ghosts && (ghosts->GetValue(id) & vtkDataSetAttributes::HIDDENPOINT) != 0;
        heights[y * width + x] = hidden ? std::numeric_limits<float>::quiet_NaN()
                                        : static_cast<float>(scalars->GetComponent(id, 0));
      }
    }
    return error;
  }

  const double* GetOrigin() const
  {
    return this->Origin;
  }
  const double* GetSpacing() const
  {
    return this->Spacing;
  }
  /// The rows read last. Their field data tell where they lie on earth.
  vtkImageData* Image()
  {
    return this->Reader->GetOutput();
  }
  std::string Warning() const
  {
    return this->Reader->GetWarningMessage();
  }

private:
  vtkNew<vtkTerrainRasterReader> Reader;
  int Extent[6] = { 0, -1, 0, -1, 0, 0 };
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Spacing[3] = { 1.0, 1.0, 1.0 };
};

int Fail(const std::string& message)
{
  std::cerr << "terrain-prepare: " << message << "\n";
  return 1;
}

/// Opens a hierarchy file and checks all of it.
int Check(const std::string& path)
{
  vtkNew<vtkTerrainHierarchy> hierarchy;
  if (!hierarchy->OpenFile(path, true))
  {
    return Fail(hierarchy->GetErrorMessage());
  }
  int dimensions[2];
  double bounds[6];
  hierarchy->GetDimensions(dimensions);
  hierarchy->GetBounds(bounds);
  std::cout << path << ": " << dimensions[0] << " x " << dimensions[1] << " samples, heights "
            << bounds[4] << " to " << bounds[5] << ", complete\n";
  return 0;
}

int Prepare(
  const std::string& heights, const std::string& out, const HeightOptions& input, bool quiet)
{
  RowReader reader(heights, input);
  std::string error = reader.Open();
  if (!error.empty())
  {
    return Fail(error);
  }
  // A first row tells where the raster lies on earth before the file is laid out.
  std::vector<float> row(static_cast<std::size_t>(reader.Width()));
  error = reader.Read(reader.Height() - 1, 1, row.data());
  if (!error.empty())
  {
    return Fail(error);
  }
  vtkNew<vtkImageData> placed;
  placed->GetFieldData()->DeepCopy(reader.Image()->GetFieldData());
  vtkNew<vtkTerrainHierarchy> hierarchy;
  bool done = false;
  {
    ProgressBar bar(quiet);
    done = hierarchy->PrepareFile(
      out, reader.Width(), reader.Height(), reader.GetOrigin(), reader.GetSpacing(), placed,
      [&](vtkIdType first, vtkIdType count, float* rows)
      { return reader.Read(first, count, rows); },
      [&](double part)
      {
        bar.Show(part);
        return true;
      });
  }
  if (!done)
  {
    return Fail(hierarchy->GetErrorMessage());
  }
  std::istringstream warnings(quiet ? std::string() : reader.Warning());
  for (std::string line; std::getline(warnings, line);)
  {
    std::cerr << "terrain-prepare: warning: " << line << "\n";
  }
  return 0;
}

/// The output must be no file that is read, which would be lost.
void CheckOutput(const std::string& heights, const HeightOptions& input, const MeshOptions& mesh,
  const std::string& out)
{
  const bool isMesh = !mesh.Path.empty();
  const std::string& output = isMesh ? mesh.Path : out;
  const std::vector<std::pair<const char*, std::string>> inputs = { { "HEIGHTS", heights },
    { "--crs", input.CoordinateSystem }, { "--texture", mesh.Look.Texture } };
  for (const auto& [name, path] : inputs)
  {
    vtkNew<vtkTerrainOutputFile> file;
    file->AddInput(path);
    if (!file->FindInput(output).empty())
    {
      throw CLI::ValidationError(
        isMesh ? "--mesh" : "OUT", "'" + output + "' is a file that " + name + " is read from");
    }
  }
}

/// The program; what it throws is a fault of its own.
int Run(int argc, char** argv)
{
  CLI::App app("Prepares a raster of heights for view-dependent refinement.", "terrain-prepare");
  std::string heights;
  std::string out;
  bool check = false;
  bool quiet = false;
  app
    .add_option("HEIGHTS", heights,
      "Any raster that GDAL opens, or a folder or an archive (.zip, .tar, .tgz) of them; with "
      "--check "
      "a prepared file")
    ->required()
    ->check(CLI::Validator(HeightOptions::WhyNotFile, ""));
  app.add_option("OUT", out, "The prepared file");
  app.add_flag("--check", check, "Check all of a prepared file, write nothing");
  app.add_flag("--quiet", quiet, "No progress bar, no warnings");
  HeightOptions input;
  input.Declare(app);
  MeshOptions mesh;
  AddMeshOptions(app, mesh);
  try
  {
    RefuseEmptyValues(argc, argv);
    app.parse(argc, argv);
    RefuseNotANumber(app);
    const bool writes = !out.empty() || !mesh.Path.empty();
    if (check == writes || (!out.empty() && !mesh.Path.empty()))
    {
      throw CLI::ValidationError(check ? "--check takes one file"
          : writes                     ? "OUT or --mesh, not both"
                                       : "OUT is required");
    }
    const std::string why = mesh.Path.empty() ? "" : WhyNotMeshFile(mesh.Path, mesh.Look);
    if (!why.empty())
    {
      throw CLI::ValidationError("--mesh", why);
    }
    CheckOutput(heights, input, mesh, out);
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() == 0)
    {
      return app.exit(error);
    }
    Fail(error.what());
    return 2;
  }
  EndOnSignals("terrain-prepare: stopped on request\n");
  vtkObject::GlobalWarningDisplayOff();
  if (!mesh.Path.empty())
  {
    PrepareMesh(heights, mesh, input, quiet);
    return 0;
  }
  return check ? Check(heights) : Prepare(heights, out, input, quiet);
}
}

int main(int argc, char** argv)
{
  try
  {
    return Run(argc, argv);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "terrain-prepare: %s\n", error.what());
    return 1;
  }
}
