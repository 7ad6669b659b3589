// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshOptions.h"

#include "HeightOptions.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTerrainMesh.h>
#include <vtkTerrainOutputFile.h>
#include <vtkTerrainRasterReader.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <string>

namespace
{
void ThrowUnlessEmpty(const std::string& error)
{
  if (!error.empty())
  {
    throw std::runtime_error(error);
  }
}

/// Millimetres of a print a metre of the terrain.
double PrintScale(vtkImageData* heights, double width)
{
  double bounds[6];
  heights->GetBounds(bounds);
  return width / std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], 1e-300 });
}

/// Depth of the block's floor below the lowest height, in metres before exaggeration; 0: no block.
double BlockDepth(vtkTerrainMesh* filter, vtkImageData* heights, const MeshOptions& options)
{
  return options.PrintWidth > 0.0
    ? filter->GetHeightOfLength(options.PrintBase / PrintScale(heights, options.PrintWidth))
    : options.Block;
}

/// The mesh in millimetres, its corner at the origin of the printer's table.
void ScaleForPrint(vtkPolyData* mesh, double scale)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  vtkPoints* points = mesh->GetPoints();
  for (vtkIdType k = 0; k < points->GetNumberOfPoints(); ++k)
  {
    double point[3];
    points->GetPoint(k, point);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      point[axis] = (point[axis] - bounds[2 * axis]) * scale;
    }
    points->SetPoint(k, point);
  }
  points->Modified();
}

/// Moves heights to where a file of 32 bits holds their mesh best; returns where their origin lay.
std::array<double, 3> MoveForFile(
  vtkImageData* heights, const std::string& path, vtkImageData* moved)
{
  moved->ShallowCopy(heights);
  std::array<double, 3> origin{ { 0.0, 0.0, 0.0 } };
  if (IsSinglePrecision(path))
  {
    double middle[3];
    heights->GetCenter(middle);
    origin = { { std::floor(middle[0]), std::floor(middle[1]), 0.0 } };
    double place[3];
    heights->GetOrigin(place);
    moved->SetOrigin(place[0] - origin[0], place[1] - origin[1], place[2]);
  }
  return origin;
}

void Build(vtkTerrainMesh* filter, vtkImageData* heights, const MeshOptions& options)
{
  filter->SetInputData(heights);
  filter->SetMaximumError(options.Error);
  filter->SetExaggeration(options.Exaggeration);
  if (IsSinglePrecision(options.Path))
  {
    filter->HoldInSinglePrecisionOn();
    filter->SetOutputPointsPrecision(vtkAlgorithm::DEFAULT_PRECISION);
  }
  filter->SetComputeTextureCoordinates(HasTextureCoordinates(options.Path, options.Look));
  // printers want closed bodies, whose parts share their points
  filter->SetComputeNormals(options.PrintWidth <= 0.0);
  filter->Update();
  if (filter->GetOutput()->GetNumberOfCells() == 0)
  {
    throw std::runtime_error("no cell of the raster has heights at all four corners");
  }
  const double depth = BlockDepth(filter, heights, options);
  if (depth > 0.0)
  {
    // the mesh is built once without a block to know its lowest height
    filter->SetBlockBase(filter->GetLowestHeight() - depth);
    filter->BlockOn();
    filter->Update();
  }
  if (options.PrintWidth > 0.0)
  {
    ScaleForPrint(filter->GetOutput(), PrintScale(heights, options.PrintWidth));
  }
}
}

void AddMeshOptions(CLI::App& app, MeshOptions& options)
{
  auto* mesh = app.add_option("--mesh", options.Path,
    "Write a triangle mesh in place of OUT: .glb (glTF), .stl, .ply, .obj or .vtp");
  // not CLI::Range, which lets "nan" pass
  const auto isWithin = [](double least)
  {
    return CLI::Validator(
      [least](const std::string& text)
      {
        double number = 0.0;
        const bool isNumber = CLI::detail::lexical_cast(text, number);
        return isNumber && number >= least && number <= 1e12
          ? std::string()
          : "'" + text + "' is no number " + (least > 0.0 ? "above 0" : "of 0 or more");
      },
      "NUMBER");
  };
  const auto positive = isWithin(1e-12);
  app
    .add_option("--error", options.Error,
      "Largest vertical distance of a sample to the mesh, in metres; default 1")
    ->check(isWithin(0.0))
    ->needs(mesh);
  app
    .add_option("--exaggeration", options.Exaggeration, "Exaggerates the mesh's heights; default 1")
    ->check(positive)
    ->needs(mesh);
  auto* block = app
                  .add_option("--block", options.Block,
                    "Closes the mesh by walls and a floor, METRES below the lowest height")
                  ->check(positive)
                  ->needs(mesh);
  app
    .add_option("--texture", options.Look.Texture,
      "PNG or JPEG over the terrain, one pixel a sample or as many more as you like (.glb)")
    ->needs(mesh);
  auto* print = app
                  .add_option("--print", options.PrintWidth,
                    "Longer side in millimetres: a closed block for a 3D printer")
                  ->check(positive)
                  ->needs(mesh)
                  ->excludes(block);
  app
    .add_option("--print-base", options.PrintBase,
      "Thickness below the lowest height in millimetres; default 2")
    ->check(positive)
    ->needs(print);
}

void PrepareMesh(
  const std::string& heights, const MeshOptions& options, const HeightOptions& input, bool quiet)
{
  vtkNew<vtkTerrainOutputFile> file;
  file->AddInput(heights);
  file->AddInput(options.Look.Texture);
  file->AddInput(input.CoordinateSystem);
  if (!file->Open(options.Path))
  {
    throw std::runtime_error(file->GetErrorMessage());
  }
  vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(heights);
  input.Apply(reader);
  reader->UpdateInformation();
  ThrowUnlessEmpty(reader->GetErrorMessage());
  ThrowUnlessEmpty(HeightOptions::WhyNotOneSite(reader));
  reader->Update();
  ThrowUnlessEmpty(reader->GetErrorMessage());
  MeshLook look = options.Look;
  const vtkNew<vtkImageData> heightsOfMesh;
  look.Origin = MoveForFile(reader->GetOutput(), options.Path, heightsOfMesh);
  vtkNew<vtkTerrainMesh> filter;
  Build(filter, heightsOfMesh, options);
  ThrowUnlessEmpty(
    WriteMeshFile(filter->GetOutput(), options.Path, file->GetPartialFileName(), look));
  if (!file->Commit())
  {
    throw std::runtime_error(file->GetErrorMessage());
  }
  if (!quiet)
  {
    const std::string warning = reader->GetWarningMessage();
    if (!warning.empty())
    {
      std::cerr << "terrain-prepare: " << warning << "\n";
    }
    std::cout << options.Path << ": " << filter->GetOutput()->GetNumberOfCells()
              << " triangles, no sample farther than " << filter->GetMeshError() << " m\n";
  }
}
