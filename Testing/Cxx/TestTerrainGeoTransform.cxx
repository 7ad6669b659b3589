// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainGeoTransform.h"
#include "vtkTerrainGeoreference.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTestErrorObserver.h"
#include "vtkTransformFilter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
void Define(vtkTerrainGeoreference* reference)
{
  reference->SetCoordinateSystem("EPSG:32645");
  reference->SetExtent(470000.0, 500000.0, 3080000.0, 3110000.0);
}
}

TEST(TerrainGeoTransform, FilterPlacesATrack)
{
  vtkNew<vtkTerrainGeoreference> reference;
  Define(reference);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetNumberOfComponents(3);
  for (int i = 0; i < 1000; ++i)
  {
    points->InsertNextPoint(86.8 + 1e-4 * i, 27.9 + 1e-4 * i, 5000.0 + i);
    // A millidegree north, and two metres up.
    const double vector[3] = { 0.0, 1e-3, 2.0 };
    vectors->InsertNextTuple(vector);
  }
  vtkNew<vtkPolyData> track;
  track->SetPoints(points);
  track->GetPointData()->SetVectors(vectors);
  vtkNew<vtkTerrainGeoTransform> transform;
  transform->SetGeoreference(reference);
  vtkNew<vtkTransformFilter> filter;
  filter->SetInputData(track);
  filter->SetTransform(transform);
  for (const bool withVectors : { true, false })
  {
    if (!withVectors)
    {
      track->GetPointData()->SetVectors(nullptr);
    }
    filter->Update();
    vtkPointSet* scene = filter->GetOutput();
    ASSERT_EQ(scene->GetNumberOfPoints(), 1000);
    for (vtkIdType i = 0; i < 1000; i += 37)
    {
      double expected[3];
      reference->PlacesToScene(points->GetPoint(i), expected, 1);
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_NEAR(scene->GetPoint(i)[axis], expected[axis], 1e-9);
      }
      if (withVectors)
      {
        const double* vector = scene->GetPointData()->GetVectors()->GetTuple3(i);
        EXPECT_NEAR(vector[1], 110.8, 0.2);
        EXPECT_NEAR(vector[2], 2.0, 1e-6);
      }
    }
  }
  // The scene follows its settings.
  double before[3];
  filter->GetOutput()->GetPoint(0, before);
  reference->SetOrigin(86.8, 27.9, 0.0);
  filter->Update();
  EXPECT_NEAR(filter->GetOutput()->GetPoint(0)[0], 0.0, 1e-6);
  EXPECT_GT(std::abs(before[0]), 1.0);
}

TEST(TerrainGeoTransform, InverseIsTheWayBack)
{
  vtkNew<vtkTerrainGeoreference> reference;
  Define(reference);
  for (const auto source :
    { vtkTerrainGeoTransform::SourceType::Places, vtkTerrainGeoTransform::SourceType::File })
  {
    vtkNew<vtkTerrainGeoTransform> transform;
    transform->SetGeoreference(reference);
    transform->SetSource(source);
    const bool places = source == vtkTerrainGeoTransform::SourceType::Places;
    const double start[3] = { places ? 86.9 : 480000.0, places ? 27.9 : 3100000.0, 4000.0 };
    double there[3];
    double back[3];
    transform->TransformPoint(start, there);
    transform->GetInverse()->TransformPoint(there, back);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(back[axis], start[axis], places ? 1e-10 : 1e-4);
    }
    // Derivatives of both ways are inverse to each other.
    double forward[3][3];
    double backward[3][3];
    transform->InternalTransformDerivative(start, there, forward);
    transform->GetInverse()->Update();
    transform->GetInverse()->InternalTransformDerivative(there, back, backward);
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        double product = 0.0;
        for (int k = 0; k < 3; ++k)
        {
          product += forward[i][k] * backward[k][j];
        }
        EXPECT_NEAR(product, i == j ? 1.0 : 0.0, 1e-4);
      }
    }
    vtkAbstractTransform* made = transform->MakeTransform();
    made->DeepCopy(transform);
    made->TransformPoint(start, back);
    EXPECT_EQ(back[0], there[0]);
    made->Delete();
  }
}

TEST(TerrainGeoTransform, FloatsAndNowhere)
{
  vtkNew<vtkTerrainGeoreference> reference;
  Define(reference);
  vtkNew<vtkTerrainGeoTransform> transform;
  transform->SetGeoreference(reference);
  const float place[3] = { 86.75f, 27.875f, 4000.0f };
  float scene[3];
  float back[3];
  transform->TransformPoint(place, scene);
  transform->GetInverse()->TransformPoint(scene, back);
  EXPECT_NEAR(back[0], place[0], 1e-5f);
  const double nowhere[3] = { 0.0, 100.0, 0.0 };
  double image[3];
  transform->TransformPoint(nowhere, image);
  EXPECT_TRUE(std::isnan(image[0]));
}

TEST(TerrainGeoTransform, SaysWhyNot)
{
  vtkNew<vtkTerrainGeoTransform> transform;
  vtkNew<vtkTest::ErrorObserver> observer;
  transform->AddObserver(vtkCommand::ErrorEvent, observer);
  double point[3] = { 86.0, 27.0, 0.0 };
  transform->TransformPoint(point, point);
  EXPECT_TRUE(std::isnan(point[0]));
  EXPECT_NE(observer->GetErrorMessage().find("no georeference"), std::string::npos);
  observer->Clear();
  vtkNew<vtkTerrainGeoreference> reference;
  transform->SetGeoreference(reference);
  transform->Update();
  EXPECT_NE(observer->GetErrorMessage().find("no coordinate system"), std::string::npos);
}
