// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Terrain drawn from tiles, against the same terrain from one texture.
#include "core/surface/LevelSamples.h"
#include "core/surface/MemoryTiles.h"

#include "vtkOpenGLTerrainMapper.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainSource.h"
#include "vtkTerrainTesting.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace
{
constexpr int kWidth = 700;
constexpr int kHeight = 611;
constexpr int kTileLevel = 5;  // tiles of 32 x 32 cells: 440 of level 0
constexpr int kImageLevel = 3; // of the image beside them

vtkSmartPointer<vtkImageData> MakeLandscape()
{
  const vtkNew<vtkTerrainSource> source;
  source->SetDimensions(kWidth, kHeight);
  source->Update();
  return source->GetOutput();
}

// Tiles that can be made to take their time.
class TestTiles : public terrain::TileSource
{
public:
  explicit TestTiles(vtkImageData* image)
  {
    terrain::HeightfieldView<float> view;
    view.Samples = static_cast<const float*>(image->GetScalarPointer());
    view.Width = kWidth;
    view.Height = kHeight;
    this->Whole = terrain::MakeMemoryTiles(view, kTileLevel, terrain::SerialFor);
  }
  terrain::TileLayout GetLayout() const override
  {
    return this->Whole->GetLayout();
  }
  terrain::HeightCodes GetCodes() const override
  {
    return this->Whole->GetCodes();
  }
  bool AreBoundsTrue() const override
  {
    return true;
  }
  terrain::PyramidNode<float> GetBounds(const terrain::TileKey& key) const override
  {
    return this->Whole->GetBounds(key);
  }
  std::string Read(const terrain::TileKey& key, terrain::Tile& tile) const override
  {
    while (this->Stalls && key.Level < this->GetLayout().LevelCount() - 1)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ++this->Reads;
    return this->Whole->Read(key, tile);
  }

  std::atomic<bool> Stalls{ false };
  mutable std::atomic<int> Reads{ 0 };

private:
  std::unique_ptr<terrain::TileSource> Whole;
};

// A level of the tiles where the image of level 0 lies.
vtkSmartPointer<vtkImageData> MakeLevel(vtkImageData* image, const terrain::TileSource& tiles)
{
  auto level = vtkSmartPointer<vtkImageData>::New();
  const glm::i64vec2 size = tiles.GetLayout().Samples(kImageLevel);
  level->SetDimensions(static_cast<int>(size.x), static_cast<int>(size.y), 1);
  level->SetOrigin(image->GetOrigin());
  const double* spacing = image->GetSpacing();
  const double cells = 1 << kImageLevel;
  level->SetSpacing(cells * spacing[0], cells * spacing[1], 1.0);
  level->AllocateScalars(VTK_FLOAT, 1);
  auto* heights = static_cast<float*>(level->GetScalarPointer());
  const terrain::HeightCodes codes = tiles.GetCodes();
  terrain::ReadLevel(
    tiles, kImageLevel, { 0, 0 }, size, terrain::SerialFor, [](double) { return true; },
    [&](std::int64_t x, std::int64_t y, std::int64_t count, const float* row)
    {
      for (std::int64_t k = 0; k < count; ++k)
      {
        heights[x + k + size.x * y] =
          static_cast<float>(codes.ToHeight(static_cast<double>(row[k])));
      }
    });
  return level;
}

struct Look
{
  std::array<double, 3> Eye;
  std::array<double, 3> Focus;
};

// From outside of all of it to a man's height, in shares of the landscape's sides and its relief.
const std::array<Look, 4> kLooks{ { { { 0.5, -1.6, 6.0 }, { 0.5, 0.5, 0.5 } },
  { { 0.1, -0.1, 1.5 }, { 0.6, 0.7, 0.0 } }, { { 0.4, 0.3, 0.9 }, { 0.7, 0.9, 0.3 } },
  { { 0.5, 0.45, 0.55 }, { 0.5, 0.9, 0.5 } } } };

// A window with one terrain.
struct Drawing
{
  vtkTerrainTesting::Scene Scene = vtkTerrainTesting::MakeScene(300, 200);
  vtkSmartPointer<vtkImageData> Whole = MakeLandscape();
  std::shared_ptr<TestTiles> Tiles = std::make_shared<TestTiles>(this->Whole);
  vtkNew<vtkTerrainActor> Actor;

  explicit Drawing(bool tiled)
  {
    const vtkSmartPointer<vtkImageData> level = MakeLevel(this->Whole, *this->Tiles);
    this->Actor->SetInputData(tiled ? level : this->Whole);
    this->Actor->SetLevelOfDetail(false);
    this->Mapper()->SetPixelTolerance(0.5);
    if (tiled)
    {
      this->Mapper()->SetTileSource(this->Tiles);
    }
    this->Scene.Renderer->AddActor(this->Actor);
    this->Scene.Renderer->SetBackground(1.0, 0.0, 1.0);
  }
  vtkOpenGLTerrainMapper* Mapper()
  {
    return this->Actor->GetTerrainMapper();
  }
  vtkSmartPointer<vtkImageData> Draw(const Look& look)
  {
    const double* bounds = this->Whole->GetBounds();
    double heights[2];
    this->Whole->GetPointData()->GetScalars()->GetRange(heights);
    const auto place = [&](const std::array<double, 3>& share)
    {
      return std::array<double, 3>{ bounds[0] + share[0] * (bounds[1] - bounds[0]),
        bounds[2] + share[1] * (bounds[3] - bounds[2]),
        heights[0] + share[2] * (heights[1] - heights[0]) };
    };
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->SetPosition(place(look.Eye).data());
    camera->SetFocalPoint(place(look.Focus).data());
    camera->SetViewUp(0.0, 0.0, 1.0);
    const double length = this->Whole->GetLength();
    camera->SetClippingRange(1e-3 * length, 5.0 * length);
    return vtkTerrainTesting::Render(this->Scene.Window);
  }
  int Background(vtkImageData* picture) const
  {
    return vtkTerrainTesting::CountPixels(
      picture, [](const unsigned char* p) { return p[0] == 255 && p[1] == 0 && p[2] == 255; });
  }
};

void Keep(vtkImageData* picture, const std::string& name)
{
  vtkTerrainTesting::WritePicture(
    picture, vtkTerrainTesting::OutputPath(vtkTerrainTesting::WindowName() + name + ".png"));
}
}

TEST(TerrainTiles, ShowTheSurfaceOfOneTexture)
{
  Drawing one(false);
  Drawing tiled(true);
  for (std::size_t k = 0; k < kLooks.size(); ++k)
  {
    SCOPED_TRACE(k);
    const auto expected = one.Draw(kLooks[k]);
    const std::vector<float> depths = vtkTerrainTesting::ReadDepth(one.Scene.Window);
    const auto picture = tiled.Draw(kLooks[k]);
    const std::vector<float> found = vtkTerrainTesting::ReadDepth(tiled.Scene.Window);
    EXPECT_TRUE(tiled.Mapper()->GetComplete());
    EXPECT_GT(tiled.Mapper()->GetNumberOfTiles(), 10);
    int wrong = 0;
    int missed = 0;
    for (std::size_t i = 0; i < depths.size(); ++i)
    {
      missed += (depths[i] < 1.0F) != (found[i] < 1.0F) ? 1 : 0;
      wrong += std::fabs(depths[i] - found[i]) > 2e-3F * (1.0F - depths[i]) + 1e-6F ? 1 : 0;
    }
    EXPECT_LE(missed, 20); // at silhouettes
    EXPECT_LE(wrong, static_cast<int>(depths.size() / 200));
    EXPECT_LE(vtkTerrainTesting::CountDifferentPixels(expected, picture, 24),
      static_cast<vtkIdType>(depths.size() / 50));
    Keep(expected, "TilesWhole" + std::to_string(k));
    Keep(picture, "Tiles" + std::to_string(k));
  }
  EXPECT_LT(one.Background(one.Draw(kLooks[1])), 50000);
}

// A beam ends before any of its rays meets the surface, also at steps between tiles.
TEST(TerrainTiles, BeamsLeaveOutNothing)
{
  Drawing single(true);
  Drawing beams(true);
  single.Mapper()->SetUseBeams(false);
  for (std::size_t k = 0; k < kLooks.size(); ++k)
  {
    SCOPED_TRACE(k);
    single.Draw(kLooks[k]);
    const std::vector<float> depths = vtkTerrainTesting::ReadDepth(single.Scene.Window);
    beams.Draw(kLooks[k]);
    const std::vector<float> found = vtkTerrainTesting::ReadDepth(beams.Scene.Window);
    int missed = 0;
    int wrong = 0;
    for (std::size_t i = 0; i < depths.size(); ++i)
    {
      missed += (depths[i] < 1.0F) != (found[i] < 1.0F) ? 1 : 0;
      wrong += std::fabs(depths[i] - found[i]) > 2e-3F * (1.0F - depths[i]) + 1e-6F ? 1 : 0;
    }
    // Where a node is within the tolerance, its box is met; which one depends on the start.
    EXPECT_LE(missed, 2);
    EXPECT_LE(wrong, 4);
  }
}

// The first frame shows the coarsest tile; the last one is that of who waits, to the bit.
TEST(TerrainTiles, ComeWhileTheyAreDrawn)
{
  Drawing waiting(true);
  Drawing going(true);
  going.Mapper()->SetWaitForTiles(false);
  going.Tiles->Stalls = true;
  const auto expected = waiting.Draw(kLooks[2]);
  const int reads = going.Tiles->Reads;
  const auto first = going.Draw(kLooks[2]);
  EXPECT_FALSE(going.Mapper()->GetComplete());
  EXPECT_EQ(going.Tiles->Reads, reads + 1);
  EXPECT_LE(going.Background(first), waiting.Background(expected) + 3000);
  EXPECT_GT(vtkTerrainTesting::CountDifferentPixels(expected, first, 8), 1000);
  Keep(first, "TilesFirst");
  going.Tiles->Stalls = false;
  vtkSmartPointer<vtkImageData> last;
  int frames = 0;
  for (; frames < 1000 && !going.Mapper()->GetComplete(); ++frames)
  {
    last = going.Draw(kLooks[2]);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  EXPECT_TRUE(going.Mapper()->GetComplete());
  EXPECT_EQ(vtkTerrainTesting::CountDifferentPixels(expected, last), 0);
}

// Views before it do not change a picture.
TEST(TerrainTiles, AreTheSameWhateverWasSeenBefore)
{
  Drawing straight(true);
  Drawing wandering(true);
  const auto expected = straight.Draw(kLooks[1]);
  for (const std::size_t k : { 3U, 0U, 2U, 1U, 3U })
  {
    wandering.Draw(kLooks[k]);
  }
  EXPECT_EQ(vtkTerrainTesting::CountDifferentPixels(expected, wandering.Draw(kLooks[1])), 0);
}

TEST(TerrainTiles, TooSmallABudgetCoarsens)
{
  Drawing one(false);
  Drawing tiled(true);
  for (const vtkIdType budget : { vtkIdType{ 0 }, vtkIdType{ 60000 }, VTK_ID_MAX })
  {
    tiled.Mapper()->SetCardMemoryBudget(budget);
    tiled.Mapper()->SetHostMemoryBudget(budget);
    const auto picture = tiled.Draw(kLooks[1]);
    EXPECT_TRUE(tiled.Mapper()->GetComplete());
    EXPECT_LE(tiled.Background(picture), one.Background(one.Draw(kLooks[1])) + 3000);
    EXPECT_LE(tiled.Mapper()->GetNumberOfTiles(), budget == VTK_ID_MAX ? 600 : 5);
  }
}

// Other techniques draw the image, and tiles of something else are refused.
TEST(TerrainTiles, ElseTheImageIsDrawn)
{
  Drawing tiled(true);
  tiled.Actor->SetTechnique(vtkTerrainActor::Techniques::Mesh);
  const auto mesh = tiled.Draw(kLooks[0]);
  EXPECT_LT(tiled.Background(mesh), 55000);
  EXPECT_TRUE(tiled.Mapper()->GetComplete());
  const glm::i64vec2 tiles = tiled.Tiles->GetLayout().Tiles(kImageLevel);
  EXPECT_EQ(tiled.Tiles->Reads, tiles.x * tiles.y); // of the image
}

// Other heights are drawn as by an actor that never had tiles, even of the same size.
TEST(TerrainTiles, GoWithTheirHeights)
{
  const vtkNew<vtkTerrainSource> other;
  other->SetDimensions(
    (kWidth - 1) / (1 << kImageLevel) + 1, (kHeight - 1) / (1 << kImageLevel) + 1);
  other->Update();
  for (const bool connects : { false, true })
  {
    SCOPED_TRACE(connects);
    Drawing tiled(true);
    tiled.Draw(kLooks[0]);
    EXPECT_GT(tiled.Mapper()->GetNumberOfTiles(), 0);
    Drawing one(false);
    for (Drawing* drawing : { &tiled, &one })
    {
      if (connects)
      {
        drawing->Actor->SetInputConnection(other->GetOutputPort());
      }
      else
      {
        drawing->Actor->SetInputData(other->GetOutput());
      }
    }
    const auto expected = one.Draw(kLooks[0]);
    EXPECT_LT(one.Background(expected), 300 * 200 - 500);
    EXPECT_EQ(vtkTerrainTesting::CountDifferentPixels(tiled.Draw(kLooks[0]), expected), 0);
    EXPECT_EQ(tiled.Mapper()->GetNumberOfTiles(), 0);
  }
}
