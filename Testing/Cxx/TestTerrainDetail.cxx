// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Detail heights in the mapper, against their sum with the heights made as an image: the same
// surface from two small images, for every technique that casts rays.
#include "vtkTerrainTesting.h"

#include "vtkOpenGLTerrainMapper.h"
#include "vtkTerrainCoarseMesh.h"
#include "vtkTerrainDepthPass.h"
#include "vtkTerrainDetailSource.h"
#include "vtkTerrainSource.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkTestErrorObserver.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <vector>

namespace
{
using Techniques = vtkOpenGLTerrainMapper::Techniques;

constexpr int BaseSamples = 33;
constexpr double BaseSpacing = 40.0;
constexpr int Cells = 8;
constexpr double Scale = 1.5;

vtkSmartPointer<vtkImageData> MakeBase()
{
  vtkNew<vtkTerrainSource> source;
  source->SetDimensions(BaseSamples, BaseSamples);
  source->SetSpacing(BaseSpacing);
  source->SetRelief(300.0);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkImageData> MakeDetail(int size)
{
  vtkNew<vtkTerrainDetailSource> source;
  source->SetSize(size);
  source->SetRelief(12.0);
  source->Update();
  return source->GetOutput();
}

/// Bilinear height at a position in samples; samples repeat.
double Bilinear(vtkImageData* image, double x, double y)
{
  const int* size = image->GetDimensions();
  const auto at = [&](int i, int j)
  { return image->GetScalarComponentAsDouble(i % size[0], j % size[1], 0, 0); };
  const int i = static_cast<int>(x);
  const int j = static_cast<int>(y);
  const double u = x - i;
  const double v = y - j;
  return (at(i, j) * (1 - u) + at(i + 1, j) * u) * (1 - v) +
    (at(i, j + 1) * (1 - u) + at(i + 1, j + 1) * u) * v;
}

vtkSmartPointer<vtkImageData> MakeSum(vtkImageData* base, vtkImageData* detail)
{
  const int samples = (BaseSamples - 1) * Cells + 1;
  vtkNew<vtkFloatArray> heights;
  for (int j = 0; j < samples; ++j)
  {
    for (int i = 0; i < samples; ++i)
    {
      heights->InsertNextValue(static_cast<float>(
        Bilinear(base, double(i) / Cells, double(j) / Cells) + Scale * Bilinear(detail, i, j)));
    }
  }
  auto sum = vtkSmartPointer<vtkImageData>::New();
  sum->SetDimensions(samples, samples, 1);
  sum->SetSpacing(BaseSpacing / Cells, BaseSpacing / Cells, 1.0);
  sum->GetPointData()->SetScalars(heights);
  return sum;
}

/// One terrain in a window of its own, under one light from the side.
struct Drawing
{
  explicit Drawing(vtkImageData* heights, vtkImageData* detail = nullptr)
  {
    this->Mesh->SetInputData(heights);
    this->Mesh->SetCellsPerQuad(detail ? 4 : 4 * Cells);
    this->Mapper->SetInputConnection(this->Mesh->GetOutputPort());
    this->Mapper->SetHeightsData(heights);
    if (detail)
    {
      this->Mapper->SetDetailData(detail);
      this->Mapper->SetDetailCells(Cells);
      this->Mapper->SetDetailScale(Scale);
    }
    this->Actor->SetMapper(this->Mapper);
    this->Scene.Renderer->AddActor(this->Actor);
    this->Scene.Renderer->AutomaticLightCreationOff();
    this->Scene.Renderer->AddLight(this->Light);
    this->Light->SetPosition(-1000.0, 400.0, 700.0);
    this->Light->SetFocalPoint(640.0, 640.0, 100.0);
  }

  void Look(const glm::dvec3& eye, const glm::dvec3& at)
  {
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetPosition(eye.x, eye.y, eye.z);
    camera->SetFocalPoint(at.x, at.y, at.z);
    this->Scene.Renderer->ResetCameraClippingRange();
  }

  std::vector<float> Distances()
  {
    this->Scene.Renderer->SetPass(this->Pass);
    this->Scene.Window->Render();
    this->Scene.Renderer->SetPass(nullptr);
    vtkImageData* image = this->Pass->GetDistances();
    const auto* begin = static_cast<float*>(image->GetScalarPointer());
    return { begin, begin + image->GetNumberOfPoints() };
  }

  vtkTerrainTesting::Scene Scene = vtkTerrainTesting::MakeScene(120, 90);
  vtkNew<vtkTerrainCoarseMesh> Mesh;
  vtkNew<vtkOpenGLTerrainMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkLight> Light;
  vtkNew<vtkTerrainDepthPass> Pass;
};

/// Part of the pixels whose distances differ by more than a tolerance, relative.
double Differs(const std::vector<float>& a, const std::vector<float>& b, double tolerance)
{
  std::size_t different = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
  {
    different += std::isnan(a[k]) != std::isnan(b[k]) ||
      (!std::isnan(a[k]) && std::abs(a[k] - b[k]) > tolerance * b[k]);
  }
  return a.size() == b.size() ? double(different) / a.size() : 1.0;
}

const glm::dvec3 Views[][2] = {
  { { 640.0, -700.0, 800.0 }, { 640.0, 640.0, 100.0 } }, // from outside
  { { 640.0, 640.0, 1500.0 }, { 640.0, 641.0, 0.0 } },   // straight down
  { { 300.0, 300.0, 260.0 }, { 900.0, 900.0, 150.0 } },  // from within the box
  { { 640.0, -300.0, -400.0 }, { 640.0, 640.0, 100.0 } } // from below
};

class TerrainDetail : public testing::TestWithParam<Techniques>
{
};

TEST_P(TerrainDetail, IsTheSumOfTheHeights)
{
  const auto base = MakeBase();
  for (const int size : { 64, 48, 5 })
  {
    SCOPED_TRACE(size);
    const auto detail = MakeDetail(size);
    Drawing parts(base, detail);
    Drawing whole(MakeSum(base, detail));
    parts.Mapper->SetTechnique(this->GetParam());
    whole.Mapper->SetTechnique(Techniques::Pyramid); // whose tests are its own
    // the searches may miss what is thinner than a step
    const double allowed = this->GetParam() == Techniques::Pyramid ? 0.0 : 0.004;
    for (const auto& view : Views)
    {
      SCOPED_TRACE(&view - &Views[0]);
      parts.Look(view[0], view[1]);
      whole.Look(view[0], view[1]);
      EXPECT_LE(Differs(parts.Distances(), whole.Distances(), 1e-4), allowed);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Techniques, TerrainDetail,
  testing::Values(Techniques::Pyramid, Techniques::Equidistant),
  [](const auto& technique)
  { return technique.param == Techniques::Pyramid ? "Pyramid" : "Equidistant"; });

/// Heights with noise from sample to sample, which pixels far away cannot show.
vtkSmartPointer<vtkImageData> MakeRough(vtkImageData* heights)
{
  auto rough = vtkSmartPointer<vtkImageData>::New();
  rough->DeepCopy(heights);
  vtkDataArray* values = rough->GetPointData()->GetScalars();
  std::minstd_rand random(1);
  for (vtkIdType k = 0; k < values->GetNumberOfTuples(); ++k)
  {
    values->SetComponent(k, 0, values->GetComponent(k, 0) + static_cast<double>(random() % 40u));
  }
  return rough;
}

/// Mean difference of two pictures' channels, in levels of 255.
double MeanDifference(vtkImageData* a, vtkImageData* b)
{
  const auto* first = static_cast<unsigned char*>(a->GetScalarPointer());
  const auto* second = static_cast<unsigned char*>(b->GetScalarPointer());
  const vtkIdType count = 3 * a->GetNumberOfPoints();
  double sum = 0.0;
  for (vtkIdType k = 0; k < count; ++k)
  {
    sum += std::abs(first[k] - second[k]);
  }
  return sum / static_cast<double>(count);
}

/// Pixels of the two pictures of a view that differ by more than a tolerance.
vtkIdType DifferentPixels(Drawing& parts, Drawing& whole, const glm::dvec3& eye,
  const glm::dvec3& at, double viewAngle, int tolerance)
{
  for (Drawing* drawing : { &parts, &whole })
  {
    drawing->Scene.Renderer->GetActiveCamera()->SetViewAngle(viewAngle);
    drawing->Look(eye, at);
  }
  return vtkTerrainTesting::CountDifferentPixels(vtkTerrainTesting::Render(parts.Scene.Window),
    vtkTerrainTesting::Render(whole.Scene.Window), tolerance);
}

// Lights see the sum, too: over rays, and over a mesh that has none of the detail. A plane has no
// creases between patches, which the lights of heights with detail pass over.
TEST(TerrainDetailLight, IsThatOfTheSum)
{
  const auto base = MakeBase();
  for (vtkIdType k = 0; k < base->GetNumberOfPoints(); ++k)
  {
    const vtkIdType height = 3 * (k % 33) + 2 * (k / 33);
    base->GetPointData()->GetScalars()->SetComponent(k, 0, static_cast<double>(height));
  }
  const auto detail = MakeDetail(64);
  Drawing parts(base, detail);
  Drawing whole(MakeSum(base, detail));
  const glm::dvec3 middle(640.0, 640.0, 100.0);
  EXPECT_LE(DifferentPixels(parts, whole, { 500.0, 100.0, 600.0 }, middle, 12.0, 3), 10);

  // straight down from afar, the heights of the mesh hardly matter
  parts.Mesh->PushUpOff();
  parts.Mesh->SetCellsPerQuad(1);
  parts.Mapper->SetTechnique(Techniques::Mesh);
  EXPECT_LE(DifferentPixels(parts, whole, { 640.0, 640.0, 90000.0 }, { 640.0, 641.0, 0.0 }, 0.2, 8),
    120 * 90 / 100);
}

/// Directions to three lights around the vertical, which show a normal up to 60 degrees from it as
/// a colour.
const glm::dmat3 ToLights(glm::normalize(glm::dvec3(0.5, 0.0, 1.0)),
  glm::normalize(glm::dvec3(-0.3, 0.4, 1.0)), glm::normalize(glm::dvec3(-0.3, -0.4, 1.0)));

/// Lights a drawing in red, green and blue from these directions only, without highlights.
void LightNormals(Drawing& drawing)
{
  drawing.Light->SwitchOff();
  for (int k = 0; k < 3; ++k)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetColor(k == 0, k == 1, k == 2);
    light->SetPosition(&glm::dvec3(ToLights[k])[0]);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    drawing.Scene.Renderer->AddLight(light);
  }
  drawing.Actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
}

/// Slopes of an image of heights at a position in samples: central differences over a sample.
glm::dvec2 Differences(vtkImageData* image, double x, double y)
{
  return { Bilinear(image, x + 0.5, y) - Bilinear(image, x - 0.5, y),
    Bilinear(image, x, y + 0.5) - Bilinear(image, x, y - 0.5) };
}

// Where pixels are smaller than cells, normals are those of differences of the reference heights,
// over a cell of the base and over a cell of the detail. Straight down, pixels are positions.
TEST(TerrainDetailLight, IsThatOfDifferences)
{
  const auto base = MakeBase();
  const auto detail = MakeDetail(64);
  Drawing drawing(base, detail);
  LightNormals(drawing);
  drawing.Look({ 640.0, 640.0, 1500.0 }, { 640.0, 640.0, 0.0 });
  vtkCamera* camera = drawing.Scene.Renderer->GetActiveCamera();
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->ParallelProjectionOn();
  const double pixel = 2.0; // metres; a cell of the detail is 5 wide
  camera->SetParallelScale(45.0 * pixel);
  drawing.Scene.Renderer->ResetCameraClippingRange();
  const auto picture = vtkTerrainTesting::Render(drawing.Scene.Window);
  int off = 0;
  double worst = 0.0;
  for (int y = 0; y < 90; ++y)
  {
    for (int x = 0; x < 120; ++x)
    {
      const auto* color = static_cast<unsigned char*>(picture->GetScalarPointer(x, y, 0));
      const glm::dvec3 seen = glm::normalize(
        glm::inverse(glm::transpose(ToLights)) * glm::dvec3(color[0], color[1], color[2]));
      const glm::dvec2 at = (glm::dvec2(640.0) + pixel * glm::dvec2(x - 59.5, y - 44.5)) /
        BaseSpacing; // in samples of the base
      const glm::dvec2 slope = (Differences(base, at.x, at.y) +
                                 Cells * Scale * Differences(detail, Cells * at.x, Cells * at.y)) /
        BaseSpacing;
      const glm::dvec3 expected = glm::normalize(glm::dvec3(-slope, 1.0));
      const double angle = glm::degrees(std::acos(std::min(glm::dot(seen, expected), 1.0)));
      off += angle > 1.0 ? 1 : 0;
      worst = std::max(worst, angle);
    }
  }
  std::cout << off << " of " << 120 * 90 << " pixels are off by more than 1 degree, the worst by "
            << worst << "\n";
  EXPECT_LE(off, 120 * 90 / 100);
}

TEST(TerrainDetailLight, LooksAsBefore)
{
  Drawing drawing(MakeBase(), MakeDetail(64));
  drawing.Look(Views[0][0], Views[0][1]);
  const auto picture = vtkTerrainTesting::Render(drawing.Scene.Window);
  EXPECT_TRUE(vtkTerrainTesting::MatchesBaseline(picture, "TerrainDetail"));
  EXPECT_NEAR(vtkTerrainTesting::DrawnShare(picture), 0.597, 0.005);
}

// Slopes far away are means over what a pixel covers: a slow zoom changes the light of no pixel by
// much, where single samples would make it flicker.
TEST(TerrainDetailLight, DoesNotShimmer)
{
  vtkNew<vtkTerrainSource> source;
  source->SetDimensions(1025, 1025);
  source->SetRoughness(1.0);
  source->Update();
  const auto heights = MakeRough(source->GetOutput());
  Drawing drawing(heights);
  vtkSmartPointer<vtkImageData> last;
  double change = 0.0;
  const int frames = 12;
  for (int frame = 0; frame < frames; ++frame)
  {
    drawing.Look(
      { 20480.0, 20480.0, 150000.0 * std::pow(0.998, frame) }, { 20480.0, 20481.0, 0.0 });
    const auto picture = vtkTerrainTesting::Render(drawing.Scene.Window);
    change += last ? MeanDifference(picture, last) / (frames - 1) : 0.0;
    last = picture;
  }
  EXPECT_LT(change, 0.7); // levels of 255; 6.5 with single samples
}

TEST(TerrainDetailChange, UploadsOnlyWhatChanged)
{
  const auto base = MakeBase();
  const auto detail = MakeDetail(64);
  Drawing drawing(base, detail);
  drawing.Look(Views[0][0], Views[0][1]);
  drawing.Scene.Window->Render();
  const std::vector<float> before = drawing.Distances();
  const int uploads = drawing.Mapper->GetNumberOfHeightUploads();
  double bounds[6];
  drawing.Mapper->GetBounds(bounds);
  drawing.Mapper->SetDetailScale(10.0 * Scale);
  double higher[6];
  drawing.Mapper->GetBounds(higher);
  EXPECT_NEAR(higher[5] - bounds[5], 9.0 * Scale * 6.0, 1e-3);
  EXPECT_NEAR(higher[4] - bounds[4], -9.0 * Scale * 6.0, 1e-3);
  EXPECT_GT(Differs(drawing.Distances(), before, 1e-4), 0.1);
  drawing.Mapper->SetDetailCells(4);
  drawing.Distances();
  EXPECT_EQ(drawing.Mapper->GetNumberOfHeightUploads(), uploads);
  drawing.Mapper->SetDetailData(nullptr);
  Drawing bare(base);
  bare.Look(Views[0][0], Views[0][1]);
  drawing.Look(Views[0][0], Views[0][1]);
  EXPECT_EQ(Differs(drawing.Distances(), bare.Distances(), 1e-6), 0.0);
}

// Base and detail are on the graphics card, not their product.
TEST(TerrainDetailMemory, IsThatOfTheParts)
{
  const auto base = MakeBase();
  Drawing drawing(base, MakeDetail(64));
  drawing.Mapper->SetDetailCells(vtkOpenGLTerrainMapper::MostDetailCells);
  drawing.Look(Views[0][0], Views[0][1]);
  drawing.Scene.Window->Render();
  EXPECT_LT(drawing.Mapper->GetTextureMemorySize(), 4 * (1.71 * 33 * 33 + 2.1 * 64 * 64));
}

TEST(TerrainDetailErrors, AreToldInOneSentence)
{
  vtkNew<vtkOpenGLTerrainMapper> mapper;
  vtkNew<vtkTest::ErrorObserver> errors;
  mapper->GetLook()->AddObserver(vtkCommand::ErrorEvent, errors);
  for (const int cells : { 0, -2, 3, 24, 2048 })
  {
    mapper->SetDetailCells(cells);
    EXPECT_TRUE(errors->GetError());
    errors->Clear();
  }
  EXPECT_EQ(mapper->GetDetailCells(), 16);
  mapper->SetDetailScale(-1.0);
  EXPECT_EQ(mapper->GetDetailScale(), 0.0);

  const auto holed = MakeDetail(8);
  holed->SetScalarComponentFromDouble(3, 3, 0, 0, std::nan(""));
  Drawing drawing(MakeBase(), holed);
  drawing.Mapper->AddObserver(vtkCommand::ErrorEvent, errors);
  drawing.Scene.Window->Render();
  EXPECT_NE(errors->GetErrorMessage().find("every sample needs a height"), std::string::npos);
}

// One period fits itself: no step at the border is larger than those within.
TEST(TerrainDetailSource, Tiles)
{
  for (const int size : { 1, 2, 7, 64, 100 })
  {
    const auto detail = MakeDetail(size);
    double within = 0.0;
    double across = 0.0;
    for (int j = 0; j < size; ++j)
    {
      for (int i = 0; i < size; ++i)
      {
        const double east = std::abs(Bilinear(detail, i + 1, j) - Bilinear(detail, i, j));
        const double north = std::abs(Bilinear(detail, i, j + 1) - Bilinear(detail, i, j));
        (i + 1 < size ? within : across) = std::max(i + 1 < size ? within : across, east);
        (j + 1 < size ? within : across) = std::max(j + 1 < size ? within : across, north);
      }
    }
    EXPECT_LE(across, 1.5 * within + 1e-6);
    double range[2];
    detail->GetScalarRange(range);
    EXPECT_NEAR(range[1] - range[0], size < 16 ? 0.0 : 12.0, 1e-4);
  }
}
}
