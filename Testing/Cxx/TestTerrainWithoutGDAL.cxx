// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A process in which GDAL cannot be loaded.
#include "vtkTerrainCoarseMesh.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainRasterReader.h"
#include "vtkTerrainSource.h"
#include "vtkTerrainTesting.h"

#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTestErrorObserver.h"

#include <cstdlib>
#include <fstream>
#include <string>

namespace
{
class TestTerrainWithoutGDAL : public testing::Test
{
public:
  static void SetUpTestSuite()
  {
    setenv("VTKTERRAIN_GDAL", "/nowhere/libgdal.so", 1);
  }

  static void ExpectReason(const std::string& message)
  {
    EXPECT_NE(message.find("VTKTERRAIN_GDAL"), std::string::npos) << message;
    EXPECT_NE(message.find("/nowhere/libgdal.so"), std::string::npos) << message;
  }
};
}

TEST_F(TestTerrainWithoutGDAL, ReaderTellsWhatIsMissing)
{
  const std::string path = vtkTerrainTesting::OutputPath("without-gdal.asc");
  std::ofstream(path) << "ncols 2\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize 1\n1 2\n3 4\n";
  vtkNew<vtkTerrainRasterReader> reader;
  vtkNew<vtkTest::ErrorObserver> observer;
  reader->AddObserver("ErrorEvent", observer);
  reader->GetExecutive()->AddObserver("ErrorEvent", observer);
  reader->SetFileName(path);
  reader->Update();
  ExpectReason(reader->GetErrorMessage());
  EXPECT_EQ(reader->CanReadFile(path.c_str()), 0);
  EXPECT_EQ(vtkTerrainRasterReader::GetGDALFile(), "");
}

TEST_F(TestTerrainWithoutGDAL, CoordinateSystemsTellWhatIsMissing)
{
  vtkNew<vtkTerrainGeoreference> place;
  place->SetCoordinateSystem("EPSG:32645");
  place->SetExtent(478000.0, 502000.0, 3088000.0, 3108000.0);
  ExpectReason(place->GetWhyNot());
  double point[3] = { 86.9, 27.95, 100.0 };
  EXPECT_FALSE(place->PlacesToScene(point, point, 1));
}

TEST_F(TestTerrainWithoutGDAL, HeightsInMemoryNeedNone)
{
  vtkNew<vtkTerrainSource> source;
  source->SetDimensions(33, 33);
  vtkNew<vtkTerrainCoarseMesh> mesh;
  mesh->SetInputConnection(source->GetOutputPort());
  mesh->Update();
  EXPECT_GT(vtkPolyData::SafeDownCast(mesh->GetOutput())->GetNumberOfPoints(), 4);
}
