// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkTerrainActor that opens files.
#include "vtkTerrainActor.h"

#include "vtkTerrainGeoreference.h"
#include "vtkTerrainHierarchy.h"
#include "vtkTerrainRasterReader.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkNew.h"

//------------------------------------------------------------------------------
bool vtkTerrainActor::SetFileName(const std::string& path)
{
  const bool isOpen =
    vtkTerrainHierarchy::IsPreparedFile(path) ? this->OpenPrepared(path) : this->OpenRaster(path);
  if (!isOpen)
  {
    vtkErrorMacro("Cannot draw the heights: " << this->ErrorMessage);
  }
  return isOpen;
}

//------------------------------------------------------------------------------
bool vtkTerrainActor::OpenPrepared(const std::string& path)
{
  const vtkNew<vtkTerrainHierarchy> hierarchy;
  const bool isOpen = hierarchy->OpenFile(path);
  this->ErrorMessage = isOpen ? "" : hierarchy->GetErrorMessage();
  if (isOpen)
  {
    const vtkNew<vtkTerrainRasterReader> reader;
    reader->SetFileName(path);
    this->SetInputConnection(nullptr);
    this->SetHierarchy(hierarchy);
    this->PreparedReader = reader;
  }
  return isOpen;
}

//------------------------------------------------------------------------------
bool vtkTerrainActor::OpenRaster(const std::string& path)
{
  constexpr int largestTexture = 16384;
  constexpr int besideTiles = 4096; // samples a side of the image that the other techniques draw
  const vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(path);
  reader->UseLevelsOn();
  reader->SetMaximumSize(largestTexture);
  // Its errors are told once, by SetFileName.
  const vtkNew<vtkCallbackCommand> silence;
  silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  const unsigned long silenced = reader->AddObserver(vtkCommand::ErrorEvent, silence);
  reader->UpdateInformation();
  this->ErrorMessage = reader->GetErrorMessage();
  if (!this->ErrorMessage.empty())
  {
    return false;
  }
  if (reader->GetLevel() > 0)
  {
    reader->SetMaximumSize(besideTiles);
    reader->WarnOfLevelsOff();
  }
  reader->Update();
  reader->RemoveObserver(silenced);
  this->ErrorMessage = reader->GetErrorMessage();
  if (!this->ErrorMessage.empty())
  {
    return false;
  }
  this->SetHierarchy(nullptr);
  this->SetInputConnection(reader->GetOutputPort());
  this->TerrainMapper->SetTileSource(reader->GetTileSource());
  return true;
}

//------------------------------------------------------------------------------
// Reads a prepared file as an image where the technique needs one, and lets go of it where not.
void vtkTerrainActor::UpdateInput()
{
  if (!this->PreparedReader)
  {
    return;
  }
  vtkAlgorithmOutput* heights =
    this->DrawsStrips() ? nullptr : this->PreparedReader->GetOutputPort();
  if ((this->TerrainMapper->GetNumberOfInputConnections(1) > 0) != (heights != nullptr))
  {
    const vtkSmartPointer<vtkTerrainRasterReader> reader = this->PreparedReader;
    this->SetInputConnection(heights);
    this->PreparedReader = reader;
  }
}

//------------------------------------------------------------------------------
// Other worlds have none.
bool vtkTerrainActor::HasSea()
{
  vtkImageData* heights = this->GetHeights();
  if (!heights)
  {
    return true;
  }
  const vtkNew<vtkTerrainGeoreference> ground;
  ground->SetFromHeights(heights);
  ground->SetFrame(vtkTerrainGeoreference::FrameType::Grid);
  return !ground->IsOnOtherWorld();
}
