// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// terrain-prepare --mesh: files that VTK's readers take, with the raster's surface in them.
#include "TerrainRenderFixture.h"

#include <vtkFeatureEdges.h>
#include <vtkGLTFReader.h>
#include <vtkMassProperties.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace
{
class TerrainPrepareMesh : public TerrainRenderFixture
{
protected:
  RunResult Prepare(std::vector<std::string> arguments) const
  {
    arguments.insert(arguments.begin(), TERRAIN_PREPARE_PROGRAM);
    return this->RunCommand(arguments);
  }
  void ExpectPrepareRefused(
    std::vector<std::string> arguments, int status, const std::string& mention) const
  {
    const std::vector<std::string> before = this->ListFiles();
    ExpectRefused(this->Prepare(std::move(arguments)), status, mention);
    EXPECT_EQ(this->ListFiles(), before);
  }

  template <typename Reader>
  vtkSmartPointer<vtkPolyData> Read(const std::string& name) const
  {
    vtkNew<Reader> reader;
    reader->SetFileName(this->Path(name).c_str());
    reader->Update();
    return reader->GetOutput();
  }

  std::string Bytes(const std::string& name) const
  {
    std::ifstream file(this->Path(name), std::ios::binary);
    return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  }
};

vtkIdType CountOpenEdges(vtkPolyData* mesh)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(mesh);
  edges->FeatureEdgesOff();
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells();
}
}

TEST_F(TerrainPrepareMesh, WritesTheSameSurfaceInEveryFormat)
{
  const std::string hill = this->WriteHill();
  for (const char* name : { "hill.vtp", "hill.ply", "hill.obj", "hill.stl" })
  {
    const RunResult result = this->Prepare({ hill, "--mesh", name, "--error", "0.5" });
    ASSERT_EQ(result.Status, 0) << result.Errors;
    EXPECT_NE(result.Output.find("no sample farther than 0.4"), std::string::npos) << result.Output;
  }
  const vtkSmartPointer<vtkPolyData> xml = this->Read<vtkXMLPolyDataReader>("hill.vtp");
  const vtkSmartPointer<vtkPolyData> ply = this->Read<vtkPLYReader>("hill.ply");
  const vtkSmartPointer<vtkPolyData> obj = this->Read<vtkOBJReader>("hill.obj");
  const vtkSmartPointer<vtkPolyData> stl = this->Read<vtkSTLReader>("hill.stl");
  EXPECT_GT(xml->GetNumberOfPolys(), 100);
  EXPECT_LT(xml->GetNumberOfPolys(), 64 * 48 * 2);
  for (vtkPolyData* other : { ply.Get(), obj.Get(), stl.Get() })
  {
    EXPECT_EQ(other->GetNumberOfPolys(), xml->GetNumberOfPolys());
    for (int k = 0; k < 6; ++k)
    {
      const double origin = other == stl && k < 4 ? std::floor(xml->GetBounds()[k / 2 * 2]) : 0.0;
      EXPECT_NEAR(other->GetBounds()[k], xml->GetBounds()[k] - origin, 1e-5) << k;
    }
  }
  EXPECT_TRUE(ply->GetPointData()->GetNormals());
  EXPECT_TRUE(obj->GetPointData()->GetTCoords());
  EXPECT_TRUE(xml->GetPointData()->GetNormals());
}

// Coordinates of a projected raster digit by digit: a reader's floats would hide what is lost.
TEST_F(TerrainPrepareMesh, KeepsLargeCoordinates)
{
  const std::string hill = this->WriteText("utm.asc",
    "ncols 3\nnrows 2\nxllcorner 478512.25\nyllcorner 5101234.125\ncellsize 2\n1 2 3\n4 5 6.5\n");
  ASSERT_EQ(this->Prepare({ hill, "--mesh", "utm.obj", "--error", "0" }).Status, 0);
  const std::string text = this->Bytes("utm.obj");
  EXPECT_NE(text.find("\nv 478517.25 5101235.125 6.5\n"), std::string::npos) << text;
  ASSERT_EQ(this->Prepare({ hill, "--mesh", "utm.stl", "--error", "0" }).Status, 0);
  const vtkSmartPointer<vtkPolyData> stl = this->Read<vtkSTLReader>("utm.stl");
  const double* bounds = stl->GetBounds();
  EXPECT_EQ(bounds[0], 0.25);
  EXPECT_EQ(bounds[2], 0.125);
  EXPECT_EQ(bounds[5], 6.5);
}

// Numbers of 32 bits are about the mesh's middle: far from the origin it has no more triangles.
TEST_F(TerrainPrepareMesh, SpendsNothingOnLargeCoordinates)
{
  std::string waves;
  for (int k = 0; k < 40 * 40; ++k)
  {
    waves += std::to_string(300.0 + 40.0 * std::sin(0.3 * (k % 40)) * std::cos(0.2 * (k / 40)));
    waves += k % 40 == 39 ? "\n" : " ";
  }
  std::vector<std::string> outputs;
  for (const char* corner :
    { "xllcorner 0\nyllcorner 0\n", "xllcorner 478512\nyllcorner 8101234\n" })
  {
    const std::string grid = this->WriteText(
      "waves.asc", std::string("ncols 40\nnrows 40\n") + corner + "cellsize 10\n" + waves);
    const RunResult result = this->Prepare({ grid, "--mesh", "waves.glb", "--error", "0.5" });
    ASSERT_EQ(result.Status, 0) << result.Errors;
    outputs.push_back(result.Output);
  }
  EXPECT_EQ(outputs[0], outputs[1]);
}

// glTF: y is up, and the place is in the node's matrix.
TEST_F(TerrainPrepareMesh, WritesGLTFWithAPlaceAndATexture)
{
  const std::string hill = this->WriteHill();
  ASSERT_EQ(this->Run({ hill, "--size", "32x24", "--output", "photo.png" }).Status, 0);
  ASSERT_EQ(this->Prepare({ hill, "--mesh", "hill.vtp", "--error", "0.5" }).Status, 0);
  const RunResult result =
    this->Prepare({ hill, "--mesh", "hill.glb", "--error", "0.5", "--texture", "photo.png" });
  ASSERT_EQ(result.Status, 0) << result.Errors;

  const std::string bytes = this->Bytes("hill.glb");
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_NE(bytes.find("image/png"), std::string::npos);
  EXPECT_NE(bytes.find("\x89PNG"), std::string::npos);
  EXPECT_EQ(bytes.size() % 4, 0U);

  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName(this->Path("hill.glb").c_str());
  reader->Update();
  double bounds[6];
  vtkMultiBlockDataSet::SafeDownCast(reader->GetOutput())->GetBounds(bounds);
  const vtkSmartPointer<vtkPolyData> mesh = this->Read<vtkXMLPolyDataReader>("hill.vtp");
  const double* own = mesh->GetBounds();
  const double tolerance =
    1e-6 * (std::abs(own[0]) + std::abs(own[2])) + 1e-3; // floats of the reader
  EXPECT_NEAR(bounds[0], own[0], tolerance);
  EXPECT_NEAR(bounds[1], own[1], tolerance);
  EXPECT_NEAR(bounds[2], own[4], tolerance);
  EXPECT_NEAR(bounds[3], own[5], tolerance);
  EXPECT_NEAR(bounds[4], -own[3], tolerance);
  EXPECT_NEAR(bounds[5], -own[2], tolerance);
}

TEST_F(TerrainPrepareMesh, WritesAPrintInMillimetres)
{
  const std::string hill = this->WriteHill();
  const RunResult result = this->Prepare(
    { hill, "--mesh", "print.stl", "--error", "0.5", "--print", "120", "--print-base", "3" });
  ASSERT_EQ(result.Status, 0) << result.Errors;
  const vtkSmartPointer<vtkPolyData> print = this->Read<vtkSTLReader>("print.stl");
  const double* bounds = print->GetBounds();
  EXPECT_NEAR(bounds[0], 0.0, 1e-5);
  EXPECT_NEAR(bounds[2], 0.0, 1e-5);
  EXPECT_NEAR(bounds[4], 0.0, 1e-5);
  EXPECT_NEAR(std::max(bounds[1], bounds[3]), 120.0, 1e-4);
  EXPECT_EQ(CountOpenEdges(print), 0);
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(print);
  mass->Update();
  // at least the base, at most the box
  EXPECT_GT(mass->GetVolume(), 3.0 * bounds[1] * bounds[3]);
  EXPECT_LT(mass->GetVolume(), bounds[1] * bounds[3] * bounds[5]);
}

TEST_F(TerrainPrepareMesh, ClosesABlockUnderExaggeration)
{
  const std::string hill = this->WriteHill();
  ASSERT_EQ(this->Prepare({ hill, "--mesh", "open.vtp", "--exaggeration", "2" }).Status, 0);
  ASSERT_EQ(
    this->Prepare({ hill, "--mesh", "block.vtp", "--exaggeration", "2", "--block", "50" }).Status,
    0);
  const vtkSmartPointer<vtkPolyData> open = this->Read<vtkXMLPolyDataReader>("open.vtp");
  const vtkSmartPointer<vtkPolyData> block = this->Read<vtkXMLPolyDataReader>("block.vtp");
  EXPECT_NEAR(block->GetBounds()[4], open->GetBounds()[4] - 100.0, 1e-6);
  EXPECT_NEAR(block->GetBounds()[5], open->GetBounds()[5], 1e-6);
}

TEST_F(TerrainPrepareMesh, RefusesInOneSentence)
{
  const std::string hill = this->WriteHill();
  this->WriteText("photo.txt", "no picture");
  this->ExpectPrepareRefused({ hill, "--mesh", "hill.xyz" }, 2, ".glb");
  this->ExpectPrepareRefused({ hill, "--mesh", "hill" }, 2, ".glb");
  this->ExpectPrepareRefused({ hill, "out.hierarchy", "--mesh", "hill.stl" }, 2, "not both");
  this->ExpectPrepareRefused({ hill, "--error", "1" }, 2, "--mesh");
  this->ExpectPrepareRefused({ hill, "--mesh", "hill.stl", "--error", "-1" }, 2, "--error");
  this->ExpectPrepareRefused({ hill, "--mesh", "hill.stl", "--error", "nan" }, 2, "--error");
  this->ExpectPrepareRefused({ hill, "--mesh", "hill.stl", "--print", "-nan" }, 2, "--print");
  this->ExpectPrepareRefused({ hill, "out.hierarchy", "--nodata", "nan" }, 2, "--nodata");
  this->ExpectPrepareRefused({ "--mesh=", hill }, 2, "--mesh");
  this->ExpectPrepareRefused({ "", "out.hierarchy" }, 2, "HEIGHTS");
  this->ExpectPrepareRefused({ hill, "--mesh", "hill.stl", "--texture", "photo.txt" }, 2, ".glb");
  this->ExpectPrepareRefused(
    { hill, "--mesh", "hill.glb", "--texture", "photo.txt" }, 2, "photo.txt");
  this->ExpectPrepareRefused({ "missing.tif", "--mesh", "hill.stl" }, 1, "missing.tif");
  this->ExpectPrepareRefused({ hill, "--mesh", "none/hill.stl" }, 1, "none/hill.stl");
}

TEST_F(TerrainPrepareMesh, NeverReplacesItsRaster)
{
  this->WriteHill("hill.vtp"); // GDAL looks at the content, not at the name
  const std::string before = this->Bytes("hill.vtp");
  const RunResult result = this->Prepare({ this->Path("hill.vtp"), "--mesh", "hill.vtp" });
  EXPECT_EQ(result.Status, 2);
  EXPECT_EQ(this->Bytes("hill.vtp"), before);
}

TEST_F(TerrainPrepareMesh, NeverReplacesWhatElseItReads)
{
  const std::string hill = this->WriteHill();
  ASSERT_EQ(this->Run({ hill, "--size", "32x24", "--output", "photo.png" }).Status, 0);
  std::filesystem::create_hard_link(this->Path("photo.png"), this->Path("photo.glb"));
  const std::string photo = this->Bytes("photo.png");
  const std::string crs = "+proj=utm +zone=32 +datum=WGS84\n";
  this->WriteText("utm.stl", crs);
  this->ExpectPrepareRefused(
    { hill, "--mesh", "photo.glb", "--texture", "photo.png" }, 2, "--texture");
  this->ExpectPrepareRefused({ hill, "--crs", "utm.stl", "--mesh", "utm.stl" }, 2, "--crs");
  this->ExpectPrepareRefused({ hill, "utm.stl", "--crs", "utm.stl" }, 2, "--crs");
  EXPECT_EQ(this->Bytes("photo.glb"), photo);
  EXPECT_EQ(this->Bytes("utm.stl"), crs);
}
