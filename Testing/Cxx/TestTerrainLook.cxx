// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Settings of how a terrain looks: none is forgotten when it is printed, copied, or passed on.
#include "vtkOpenGLTerrainMapper.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainLook.h"
#include "vtkTerrainStrips.h"
#include "vtkTestErrorObserver.h"

#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace
{
vtkSmartPointer<vtkImageData> Picture()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  return image;
}

/// Gives every setting of a look, or of a mapper that passes it on, a value that is not its
/// default.
template <typename Settings>
void SetAll(Settings* look, vtkImageData* drape)
{
  const double bounds[4] = { 1.0, 2.0, 3.0, 5.0 };
  look->SetTechnique(vtkTerrainLook::Techniques::Strips);
  look->SetVerticalExaggeration(2.5);
  look->SetDetailCells(8);
  look->SetDetailScale(0.5);
  look->SetSteps(7);
  look->SetLongSteps(8);
  look->SetSecantSteps(9);
  look->SetStepLength(0.75);
  look->SetSurface(vtkTerrainLook::Surfaces::Columns);
  look->SetPixelTolerance(1.25);
  look->SetShowCrossings(true);
  look->SetMaximumShownCrossings(32);
  look->SetComputeMode(vtkTerrainLook::ComputeModes::On);
  look->SetUseBeams(false);
  look->SetColorSource(vtkTerrainLook::ColorSources::Aspect);
  look->SetDrape(drape, bounds);
  look->SetContours(true);
  look->SetContourInterval(20.0);
  look->SetContourWidth(3.0);
  look->SetContourIndex(5);
  look->SetContourColor(0.1, 0.2, 0.3, 0.4);
  look->SetHillshade(true);
  look->SetHillshadeAzimuth(100.0);
  look->SetHillshadeAltitude(30.0);
  look->SetBlock(true);
  look->SetBlockBase(-10.0);
  look->SetMaximumLayers(2);
  look->SetSampleShading(true);
  look->SetSunShadows(true);
  look->SetSunAngle(0.5);
  look->SetSkyLight(0.25);
}

/// The lines that a look prints of itself, without those of its superclass.
std::vector<std::string> LinesOf(vtkTerrainLook* look)
{
  std::ostringstream text;
  look->PrintSelf(text, vtkIndent());
  std::istringstream all(text.str());
  std::vector<std::string> lines;
  for (std::string line; std::getline(all, line);)
  {
    if (!lines.empty() || line.rfind("Technique: ", 0) == 0)
    {
      lines.push_back(line);
    }
  }
  return lines;
}

TEST(TerrainLook, SetsAndCopiesEverySetting)
{
  const auto drape = Picture();
  vtkNew<vtkTerrainLook> plain;
  vtkNew<vtkTerrainLook> look;
  SetAll(look.Get(), drape);
  const std::vector<std::string> defaults = LinesOf(plain);
  const std::vector<std::string> changed = LinesOf(look);
  ASSERT_EQ(defaults.size(), 32U); // a new setting is to be set above, too
  ASSERT_EQ(changed.size(), defaults.size());
  for (std::size_t k = 0; k < defaults.size(); ++k)
  {
    EXPECT_NE(changed[k], defaults[k]);
  }
  const vtkMTimeType before = plain->GetMTime();
  plain->DeepCopy(look);
  EXPECT_EQ(LinesOf(plain), changed);
  EXPECT_GT(plain->GetMTime(), before);
  EXPECT_EQ(plain->GetDrape(), drape); // shared
  plain->DeepCopy(nullptr);
  plain->DeepCopy(plain);
  EXPECT_EQ(LinesOf(plain), changed);
}

TEST(TerrainLook, IsWhatAMapperPassesOn)
{
  const auto drape = Picture();
  vtkNew<vtkTerrainLook> look;
  SetAll(look.Get(), drape);
  vtkNew<vtkOpenGLTerrainMapper> mapper;
  SetAll(mapper.Get(), drape);
  EXPECT_EQ(LinesOf(mapper->GetLook()), LinesOf(look));
  EXPECT_EQ(mapper->GetContourWidth(), 3.0);
  EXPECT_EQ(mapper->GetTechnique(), vtkTerrainLook::Techniques::Strips);
}

TEST(TerrainLook, IsCopiedByActors)
{
  const auto drape = Picture();
  vtkNew<vtkTerrainActor> from;
  vtkNew<vtkTerrainActor> to;
  SetAll(from->GetTerrainMapper(), drape);
  from->GetStrips()->SetTolerance(3.0);
  from->GetStrips()->SetTriangleBudget(4000);
  from->SetLevelOfDetail(false);
  to->CopyLook(from);
  EXPECT_EQ(
    LinesOf(to->GetTerrainMapper()->GetLook()), LinesOf(from->GetTerrainMapper()->GetLook()));
  EXPECT_EQ(to->GetStrips()->GetTolerance(), 3.0);
  EXPECT_EQ(to->GetStrips()->GetTriangleBudget(), 4000);
  EXPECT_FALSE(to->GetLevelOfDetail());
}

// A change asks for another picture, and not for other buffers: GetMTime() is the same whoever
// asks.
TEST(TerrainLook, ChangesThePictureAlone)
{
  vtkNew<vtkTerrainActor> actor;
  vtkOpenGLTerrainMapper* mapper = actor->GetTerrainMapper();
  struct Counter
  {
    int Events = 0;
    void Count()
    {
      ++this->Events;
    }
  } counter;
  mapper->AddObserver(vtkCommand::ModifiedEvent, &counter, &Counter::Count);
  const vtkMTimeType time = mapper->GetMTime();
  const vtkMTimeType redraw = actor->GetRedrawMTime();
  mapper->SetContours(true);
  EXPECT_EQ(mapper->GetMTime(), time);
  EXPECT_GT(actor->GetRedrawMTime(), redraw);
  EXPECT_EQ(counter.Events, 1);
  mapper->SetContours(true);
  EXPECT_EQ(counter.Events, 1);
  const int first[2] = { 0, 0 };
  const int last[2] = { 2, 2 };
  const vtkMTimeType before = actor->GetRedrawMTime();
  mapper->SetExtract(first, last);
  EXPECT_GT(actor->GetRedrawMTime(), before);
  EXPECT_EQ(mapper->GetMTime(), time);
}

TEST(TerrainLook, RefusesWhatIsNone)
{
  vtkNew<vtkTerrainLook> look;
  vtkNew<vtkTest::ErrorObserver> errors;
  look->AddObserver(vtkCommand::ErrorEvent, errors);
  const std::vector<std::string> defaults = LinesOf(look);
  const auto refuses = [&](auto set)
  {
    set();
    EXPECT_TRUE(errors->GetError());
    errors->Clear();
    EXPECT_EQ(LinesOf(look), defaults);
  };
  for (const double number : { 0.0, -1.0, std::nan(""), HUGE_VAL })
  {
    refuses([&] { look->SetVerticalExaggeration(number); });
  }
  refuses([&] { look->SetDetailCells(3); });
  refuses([&] { look->SetMaximumLayers(0); });
  refuses([&] { look->SetMaximumShownCrossings(0); });
  refuses([&] { look->SetContourInterval(0.0); });
  refuses([&] { look->SetContourWidth(-1.0); });
  refuses([&] { look->SetContourIndex(-1); });
  refuses([&] { look->SetHillshadeAzimuth(HUGE_VAL); });
  refuses([&] { look->SetHillshadeAltitude(std::nan("")); });
  refuses([&] { look->SetBlockBase(std::nan("")); });
  const double wrongBounds[][4] = { { 1.0, 1.0, 0.0, 1.0 }, { 0.0, 1.0, -HUGE_VAL, 1.0 },
    { -1e308, 1e308, 0.0, 1.0 }, { 0.0, 1.0, std::nan(""), 1.0 } };
  for (const auto& bounds : wrongBounds)
  {
    refuses([&] { look->SetDrape(Picture(), bounds); });
  }
  look->SetSteps(-1);
  look->SetPixelTolerance(-2.0);
  look->SetStepLength(-2.0);
  EXPECT_FALSE(errors->GetError()); // clamped
  EXPECT_EQ(LinesOf(look), defaults);
}
}
