// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainGraticule.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTestErrorObserver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
/// A tilted plain of 40 x 30 km round the origin, a height of 1000 + x / 100.
vtkSmartPointer<vtkImageData> Plain()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(401, 301, 1);
  image->SetOrigin(-20000.0, -15000.0, 0.0);
  image->SetSpacing(100.0, 100.0, 1.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (int j = 0; j < 301; ++j)
  {
    for (int i = 0; i < 401; ++i)
    {
      image->SetScalarComponentFromDouble(i, j, 0, 0, 800.0 + i);
    }
  }
  return image;
}

void Define(vtkTerrainGeoreference* reference, double longitude, double latitude)
{
  reference->SetCoordinateSystem("EPSG:4326");
  reference->SetOrigin(longitude, latitude, 0.0);
}

std::vector<std::string> Labels(vtkTerrainGraticule* graticule)
{
  auto* array = vtkStringArray::SafeDownCast(
    graticule->GetOutput(1)->GetPointData()->GetAbstractArray("Label"));
  std::vector<std::string> labels;
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    labels.push_back(array->GetValue(i));
  }
  return labels;
}
}

TEST(TerrainGraticule, LinesLieOnTheirDegrees)
{
  vtkNew<vtkTerrainGeoreference> reference;
  Define(reference, 86.9, 28.0);
  vtkNew<vtkTerrainGraticule> graticule;
  graticule->SetInputData(Plain());
  graticule->SetGeoreference(reference);
  graticule->Update();
  EXPECT_NEAR(graticule->GetStepInUse(), 5.0 / 60.0, 1e-12);
  vtkPolyData* lines = graticule->GetOutput(0);
  ASSERT_GE(lines->GetNumberOfLines(), 7);
  for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
  {
    const double value = lines->GetCellData()->GetArray("Value")->GetComponent(line, 0);
    const int axis =
      static_cast<int>(lines->GetCellData()->GetArray("Axis")->GetComponent(line, 0));
    vtkCell* cell = lines->GetCell(line);
    for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
    {
      double point[3];
      cell->GetPoints()->GetPoint(i, point);
      EXPECT_NEAR(point[2], 1000.0 + point[0] / 100.0, 1e-3);
      double place[3];
      reference->SceneToPlaces(point, place, 1);
      // A chord of 1/128 of 40 km sags by millimetres.
      EXPECT_NEAR(place[axis], value, 1e-7);
    }
  }
  const std::vector<std::string> labels = Labels(graticule);
  EXPECT_NE(std::find(labels.begin(), labels.end(), "86\u00b055'E"), labels.end());
  EXPECT_NE(std::find(labels.begin(), labels.end(), "28\u00b000'N"), labels.end());
  EXPECT_EQ(static_cast<vtkIdType>(labels.size()), lines->GetNumberOfLines());
}

TEST(TerrainGraticule, UtmGrid)
{
  vtkNew<vtkTerrainGeoreference> reference;
  Define(reference, 86.9, 28.0);
  vtkNew<vtkTerrainGraticule> graticule;
  graticule->SetInputData(Plain());
  graticule->SetGeoreference(reference);
  graticule->SetGrid(vtkTerrainGraticule::GridType::UTM);
  graticule->Update();
  EXPECT_EQ(graticule->GetStepInUse(), 10000.0);
  const std::vector<std::string> labels = Labels(graticule);
  EXPECT_NE(std::find(labels.begin(), labels.end(), "490 km E"), labels.end());
  EXPECT_NE(std::find(labels.begin(), labels.end(), "3100 km N"), labels.end());
}

TEST(TerrainGraticule, AcrossTheAntimeridian)
{
  vtkNew<vtkTerrainGeoreference> reference;
  Define(reference, 179.99, -17.0);
  vtkNew<vtkTerrainGraticule> graticule;
  graticule->SetInputData(Plain());
  graticule->SetGeoreference(reference);
  graticule->Update();
  EXPECT_LE(graticule->GetOutput(0)->GetNumberOfLines(), 20);
  const std::vector<std::string> labels = Labels(graticule);
  EXPECT_NE(std::find(labels.begin(), labels.end(), "179\u00b055'W"), labels.end());
}

// Multiples of a step that are larger than what a number tells from its neighbour.
TEST(TerrainGraticule, StepsTooSmallForTheirPlacesEnd)
{
  vtkNew<vtkTerrainGeoreference> reference;
  Define(reference, 86.9, 28.0);
  const vtkSmartPointer<vtkImageData> small = Plain();
  small->SetOrigin(0.0, 0.0, 0.0);
  small->SetSpacing(1e-11, 1e-11, 1.0);
  vtkNew<vtkTerrainGraticule> graticule;
  graticule->SetInputData(small);
  graticule->SetGeoreference(reference);
  graticule->SetGrid(vtkTerrainGraticule::GridType::UTM);
  graticule->SetStep(1e-11);
  graticule->Update();
  EXPECT_LE(graticule->GetOutput(0)->GetNumberOfLines(), 2 * 10001);
}

TEST(TerrainGraticule, RefusesWithASentence)
{
  vtkNew<vtkTerrainGraticule> graticule;
  vtkNew<vtkTest::ErrorObserver> observer;
  graticule->AddObserver(vtkCommand::ErrorEvent, observer);
  graticule->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  graticule->SetInputData(Plain());
  graticule->Update();
  EXPECT_TRUE(observer->GetError());
  observer->Clear();
  vtkNew<vtkTerrainGeoreference> reference;
  reference->SetFrame(vtkTerrainGeoreference::FrameType::Grid);
  graticule->SetGeoreference(reference);
  graticule->Update();
  EXPECT_TRUE(observer->GetError());
}
