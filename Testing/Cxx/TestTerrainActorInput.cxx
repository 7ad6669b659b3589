// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the actor knows of its heights before a frame, and what a frame leaves alone.
#include "vtkTerrainTesting.h"

#include "vtkTerrainActor.h"
#include "vtkTerrainHierarchy.h"
#include "vtkTerrainSource.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationExecutivePortVectorKey.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace
{
using Techniques = vtkTerrainActor::Techniques;

vtkSmartPointer<vtkImageData> MakeHills()
{
  const vtkNew<vtkTerrainSource> source;
  source->SetDimensions(65, 65);
  source->Update();
  return source->GetOutput();
}

std::string WritePrepared(vtkImageData* heights, const std::string& name)
{
  const std::string path = vtkTerrainTesting::OutputPath(name);
  const vtkNew<vtkTerrainHierarchy> hierarchy;
  EXPECT_TRUE(hierarchy->SetHeights(heights));
  EXPECT_TRUE(hierarchy->WriteFile(path)) << hierarchy->GetErrorMessage();
  return path;
}

// Counts the ModifiedEvents of an object while it lives.
class Listener
{
public:
  explicit Listener(vtkObject* told)
    : Told(told)
  {
    this->Command->SetClientData(&this->Count);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
    this->Tag = told->AddObserver(vtkCommand::ModifiedEvent, this->Command);
  }
  Listener(const Listener&) = delete;
  void operator=(const Listener&) = delete;
  ~Listener()
  {
    this->Told->RemoveObserver(this->Tag);
  }

  int Count = 0;

private:
  vtkObject* Told;
  vtkNew<vtkCallbackCommand> Command;
  unsigned long Tag = 0;
};
}

//------------------------------------------------------------------------------
// With colours of one's own nothing else asks for the heights before.
TEST(TerrainActorInput, PreparedFilesHaveASurfaceBeforeAnyFrame)
{
  const auto heights = MakeHills();
  const std::string path = WritePrepared(heights, "actor-input.any");
  const vtkNew<vtkTerrainActor> drawn;
  drawn->SetInputData(heights);
  const double error = drawn->GetUsedSurfaceError();
  EXPECT_GT(error, 0.0);

  const vtkNew<vtkLookupTable> colors;
  const vtkNew<vtkTerrainActor> first;
  first->SetLookupTable(colors);
  ASSERT_TRUE(first->SetFileName(path));
  EXPECT_NEAR(first->GetUsedSurfaceError(), error, 1e-6 * error);

  const vtkNew<vtkTerrainActor> second;
  second->SetLookupTable(colors);
  ASSERT_TRUE(second->SetFileName(path));
  vtkPolyData* surface = second->GetSurface();
  ASSERT_NE(surface, nullptr);
  EXPECT_EQ(surface->GetNumberOfPolys(), drawn->GetSurface()->GetNumberOfPolys());
}

//------------------------------------------------------------------------------
TEST(TerrainActorInput, CopiesHaveTheSurfaceError)
{
  const vtkNew<vtkTerrainActor> terrain;
  terrain->SetInputData(MakeHills());
  terrain->SetSurfaceError(12.0);
  const vtkNew<vtkTerrainActor> copy;
  copy->ShallowCopy(terrain);
  EXPECT_EQ(copy->GetSurfaceError(), 12.0);
  EXPECT_EQ(copy->GetSurface()->GetNumberOfPolys(), terrain->GetSurface()->GetNumberOfPolys());
}

// Filters that stand behind the heights, whether they have made anything or not.
int NumberOfConsumers(vtkAlgorithm* heights)
{
  return vtkExecutive::CONSUMERS()->Length(heights->GetExecutive()->GetOutputInformation(0));
}

//------------------------------------------------------------------------------
// The mesh for pickers and exporters does not even exist as a filter until somebody asks for it.
TEST(TerrainActorInput, NothingIsMadeForNobody)
{
  const vtkNew<vtkTerrainSource> source;
  source->SetDimensions(65, 65);
  const vtkNew<vtkTerrainActor> terrain;
  terrain->SetInputConnection(source->GetOutputPort());
  const int needed = NumberOfConsumers(source);
  vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(80, 60);
  scene.Renderer->AddActor(terrain);
  scene.Renderer->ResetCamera();
  for (const Techniques technique : { Techniques::Pyramid, Techniques::Mesh, Techniques::Strips })
  {
    terrain->SetTechnique(technique);
    vtkTerrainTesting::Render(scene.Window);
    EXPECT_EQ(NumberOfConsumers(source), needed) << static_cast<int>(technique);
  }
  terrain->SetVerticalExaggeration(2.0);
  vtkTerrainTesting::Render(scene.Window);
  EXPECT_TRUE(terrain->HasSurface());
  EXPECT_EQ(NumberOfConsumers(source), needed);
  EXPECT_GT(terrain->GetSurface()->GetNumberOfPoints(), 0);
  EXPECT_EQ(NumberOfConsumers(source), needed + 1);
}

//------------------------------------------------------------------------------
// A window that draws whenever something has changed would never rest.
TEST(TerrainActorInput, FramesChangeNothing)
{
  const vtkNew<vtkTerrainActor> terrain;
  terrain->SetInputData(MakeHills());
  vtkTerrainTesting::Scene scene = vtkTerrainTesting::MakeScene(80, 60);
  scene.Renderer->AddActor(terrain);
  scene.Renderer->ResetCamera();
  for (const double rate : { 1e-4, 1e9 }) // frames with time, and in haste
  {
    SCOPED_TRACE(rate);
    scene.Window->SetDesiredUpdateRate(rate);
    vtkTerrainTesting::Render(scene.Window);
    vtkTerrainTesting::Render(scene.Window);
    const Listener look(terrain->GetTerrainMapper()->GetLook());
    const Listener mapper(terrain->GetTerrainMapper());
    const Listener actor(terrain);
    const vtkMTimeType before = terrain->GetRedrawMTime();
    vtkTerrainTesting::Render(scene.Window);
    EXPECT_EQ(terrain->GetInteractionTolerance(), rate > 1.0 ? 8.0 : 0.0);
    EXPECT_EQ(look.Count, 0);
    EXPECT_EQ(mapper.Count, 0);
    EXPECT_EQ(actor.Count, 0);
    EXPECT_EQ(terrain->GetRedrawMTime(), before);
  }
}
