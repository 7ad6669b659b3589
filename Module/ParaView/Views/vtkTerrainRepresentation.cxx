// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainRepresentation.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkPVRenderView.h"
#include "vtkPVView.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainLooks.h"
#include "vtkTerrainPieces.h"
#include "vtkTerrainScenes.h"
#include "vtkTerrainSelectionLift.h"
#include "vtkTerrainSourceColors.h"
#include "vtkTerrainStrips.h"
#include "vtkTexture.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <memory>
#include <set>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkTerrainRepresentation);

namespace
{
/// Which of the arrays to process is which.
constexpr int kColorArray = 0;
constexpr int kHeightArray = 1;

int NumberOfProcesses()
{
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  return processes ? processes->GetNumberOfProcesses() : 1;
}

/// Makes a view have so many of some actors.
template <typename Actor>
void SetNumberOfActors(std::vector<vtkSmartPointer<Actor>>& actors, std::size_t number,
  vtkPVRenderView* view, vtkTerrainRepresentation* owner)
{
  while (actors.size() > number)
  {
    view->GetRenderer()->RemoveActor(actors.back());
    view->UnRegisterPropForHardwareSelection(owner, actors.back());
    actors.pop_back();
  }
  while (actors.size() < number)
  {
    actors.push_back(vtkSmartPointer<Actor>::New());
    view->GetRenderer()->AddActor(actors.back());
    view->RegisterPropForHardwareSelection(owner, actors.back());
  }
}
}

//------------------------------------------------------------------------------
vtkTerrainRepresentation::vtkTerrainRepresentation()
  : Pieces(vtkSmartPointer<vtkMultiBlockDataSet>::New())
  , SourceColors(std::make_unique<vtkTerrainSourceColors>())
  , Selection(std::make_unique<vtkTerrainSelectionLift>())
{
  this->Actor->SetColorByHeight(false);
  this->Actor->SetVisibility(false);
}

//------------------------------------------------------------------------------
vtkTerrainRepresentation::~vtkTerrainRepresentation() = default;

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Actor:\n";
  this->Actor->PrintSelf(os, indent.GetNextIndent());
}

//------------------------------------------------------------------------------
int vtkTerrainRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkTerrainRepresentation::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (!this->Superclass::RequestUpdateExtent(request, inputs, outputs))
  {
    return 0;
  }
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int i = 0; i < inputs[0]->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* info = inputs[0]->GetInformationObject(i);
    const bool isSurface = vtkPolyData::SafeDownCast(info->Get(vtkDataObject::DATA_OBJECT()));
    if (!isSurface && info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1)
    {
      info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(),
        std::max(1, info->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS())));
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkTerrainRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Pieces = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  if (inputs[0]->GetNumberOfInformationObjects() > 0)
  {
    vtkDataObject* data = vtkDataObject::GetData(inputs[0], 0);
    for (vtkImageData* image : vtkTerrainPieces::FindImages(data))
    {
      this->AddPiece(image);
    }
    for (vtkPolyData* surface : vtkTerrainPieces::FindSurfaces(data))
    {
      this->AddSurface(surface);
    }
  }
  this->ShareHeightRange();
  return this->Superclass::RequestData(request, inputs, outputs);
}

//------------------------------------------------------------------------------
// Colours by height must not depend on where a terrain is divided.
void vtkTerrainRepresentation::ShareHeightRange()
{
  const std::array<double, 2> own =
    vtkTerrainPieces::HeightRange(vtkTerrainPieces::FindImages(this->Pieces));
  this->HeightRange = own;
  if (NumberOfProcesses() > 1)
  {
    vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
    processes->AllReduce(&own[0], &this->HeightRange[0], 1, vtkCommunicator::MIN_OP);
    processes->AllReduce(&own[1], &this->HeightRange[1], 1, vtkCommunicator::MAX_OP);
  }
  this->ReliefColors = nullptr;
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::AddPiece(vtkImageData* image)
{
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* array = this->GetInputArrayToProcess(kHeightArray, image, association);
  vtkSmartPointer<vtkImageData> heights;
  if (array && association == vtkDataObject::FIELD_ASSOCIATION_CELLS)
  {
    heights = vtkTerrainPieces::CellsAsSamples(image);
  }
  else
  {
    heights = vtkSmartPointer<vtkImageData>::New();
    heights->ShallowCopy(image);
  }
  if (array && array->GetName())
  {
    heights->GetPointData()->SetActiveScalars(array->GetName());
  }
  this->Pieces->SetBlock(this->Pieces->GetNumberOfBlocks(), heights);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::AddSurface(vtkPolyData* surface)
{
  vtkNew<vtkPolyData> own;
  own->ShallowCopy(surface);
  own->RemoveGhostCells();
  this->Pieces->SetBlock(this->Pieces->GetNumberOfBlocks(), own);
}

//------------------------------------------------------------------------------
int vtkTerrainRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    this->PassPieces(inInfo, outInfo);
    this->LiftSelection();
    this->TellOfOtherScenes();
  }
  else if (request == vtkPVView::REQUEST_UPDATE_LOD())
  {
    vtkPVRenderView::SetRequiresDistributedRenderingLOD(inInfo, this, true);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    vtkDataObject* delivered = vtkPVRenderView::GetDeliveredPiece(inInfo, this);
    this->TakePieces(delivered);
    this->TakeSurfaces(delivered);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::PassPieces(vtkInformation* inInfo, vtkInformation* outInfo)
{
  vtkPVView::SetPiece(inInfo, this, this->Pieces, this->Pieces->GetActualMemorySize());
  vtkPVRenderView::SetRequiresDistributedRendering(inInfo, this, true);
  double bounds[6];
  this->GetOwnBounds(bounds);
  vtkNew<vtkMatrix4x4> toWorld;
  vtkTerrainPieces::MakeColumn(bounds, toWorld);
  vtkPVRenderView::SetGeometryBounds(inInfo, this, bounds, toWorld);
  vtkPVRenderView::SetOrderedCompositingConfiguration(
    inInfo, this, vtkPVRenderView::USE_BOUNDS_FOR_REDISTRIBUTION, bounds);
  if (this->Actor->GetProperty()->GetOpacity() < 1.0)
  {
    outInfo->Set(vtkPVRenderView::NEED_ORDERED_COMPOSITING(), 1);
  }
}

//------------------------------------------------------------------------------
// All that are seen where their own coordinates say: whoever moves a terrain knows where to.
std::vector<vtkImageData*> vtkTerrainRepresentation::FindPlacedImages()
{
  const auto are = [](const double* values, double value)
  { return std::all_of(values, values + 3, [value](double x) { return x == value; }); };
  vtkActor* actor = this->Actor;
  const bool isPlaced = this->GetVisibility() && are(actor->GetPosition(), 0.0) &&
    are(actor->GetOrientation(), 0.0) && are(actor->GetScale(), 1.0);
  return isPlaced ? vtkTerrainPieces::FindImages(this->Pieces) : std::vector<vtkImageData*>();
}

//------------------------------------------------------------------------------
// All terrains are compared with the first one of the view. The first process, which has a piece of
// every image, speaks for all.
void vtkTerrainRepresentation::TellOfOtherScenes()
{
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  if (!this->GetView() || (processes && processes->GetLocalProcessId() > 0))
  {
    return;
  }
  std::vector<vtkImageData*> images;
  for (int k = 0; k < this->GetView()->GetNumberOfRepresentations() && images.empty(); ++k)
  {
    auto* shown = vtkTerrainRepresentation::SafeDownCast(this->GetView()->GetRepresentation(k));
    images = shown ? shown->FindPlacedImages() : images;
  }
  for (vtkImageData* image : this->FindPlacedImages())
  {
    const std::string text =
      image == images.front() ? "" : vtkTerrainScenes::WhyApart(images.front(), image);
    if (!text.empty() && this->Told.insert(text).second)
    {
      vtkWarningMacro(<< text);
    }
  }
}

//------------------------------------------------------------------------------
// Of what this process draws, in world coordinates: boxes that overlap have no order to be
// composited in.
void vtkTerrainRepresentation::GetOwnBounds(double bounds[6])
{
  vtkBoundingBox box;
  for (vtkImageData* heights : vtkTerrainPieces::FindImages(this->Pieces))
  {
    if (vtkTerrainPieces::HasCells(heights))
    {
      vtkTerrainPieces::AddOwnBox(heights, this->Actor, box);
    }
  }
  vtkNew<vtkActor> placed;
  this->PlaceSurface(placed);
  placed->ComputeMatrix();
  for (vtkPolyData* surface : vtkTerrainPieces::FindSurfaces(this->Pieces))
  {
    vtkTerrainPieces::AddBox(surface->GetBounds(), placed->GetMatrix(), box);
  }
  vtkMath::UninitializeBounds(bounds);
  if (box.IsValid())
  {
    box.GetBounds(bounds);
  }
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::TakePieces(vtkDataObject* delivered)
{
  std::vector<vtkImageData*> pieces = vtkTerrainPieces::FindImages(delivered);
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(),
                 [](vtkImageData* heights) { return !vtkTerrainPieces::HasCells(heights); }),
    pieces.end());
  if (pieces.empty())
  {
    this->Actor->SetVisibility(false);
  }
  SetNumberOfActors(this->OtherActors, pieces.empty() ? 0 : pieces.size() - 1,
    vtkPVRenderView::SafeDownCast(this->GetView()), this);
  if (!this->ReliefColors && !pieces.empty())
  {
    // a client that draws has no heights of its own, but all of what is delivered
    const std::array<double, 2> range = this->HeightRange[0] <= this->HeightRange[1]
      ? this->HeightRange
      : vtkTerrainPieces::HeightRange(pieces);
    this->ReliefColors = vtkTerrainActor::MakeReliefColors(range[0], range[1]);
  }
  for (std::size_t k = 0; k < pieces.size(); ++k)
  {
    vtkTerrainActor* actor = k == 0 ? this->Actor.Get() : this->OtherActors[k - 1].Get();
    // each update brings other images, but other arrays only if something has changed
    const bool isOneOfSeveral = pieces.size() > 1 || NumberOfProcesses() > 1;
    std::array<int, 2> first{};
    std::array<int, 2> last{};
    const bool isSeen = vtkTerrainLooks::FindPart(pieces[k], this->Extract, first, last);
    actor->SetVisibility(isSeen && this->GetVisibility());
    if (!isSeen)
    {
      continue;
    }
    const bool isOther = this->HasOtherParts || !actor->GetHeights() ||
      !vtkTerrainPieces::AreSame(actor->GetHeights(), pieces[k]);
    const vtkSmartPointer<vtkImageData> drape = actor->GetTerrainMapper()->GetDrape();
    if (k > 0)
    {
      vtkTerrainLooks::ShareTerrain(this->Actor, actor);
      actor->GetTerrainMapper()->SetDrape(drape);
    }
    if (isOther)
    {
      vtkTerrainLooks::TakePiece(actor, pieces[k], first, last, isOneOfSeveral);
      this->DrapePiece(actor, pieces[k], isOneOfSeveral);
    }
    vtkTerrainLooks::Clip(actor->GetTerrainMapper(), this->Clip ? this->ClipPlane.Get() : nullptr);
    this->UpdateColors(actor);
  }
  this->HasOtherParts = false;
}

//------------------------------------------------------------------------------
// A picture may lie beside one of several pieces.
void vtkTerrainRepresentation::DrapePiece(
  vtkTerrainActor* actor, vtkImageData* piece, bool isOneOfSeveral)
{
  std::string error;
  actor->GetTerrainMapper()->SetDrape(
    this->Drape.empty() ? nullptr : vtkTerrainLooks::BringPicture(this->Drape, piece, error));
  if (!error.empty() && !isOneOfSeveral)
  {
    vtkErrorMacro("No drape: " << error);
  }
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::LiftSelection()
{
  vtkInformation* array = this->GetInputArrayInformation(kHeightArray);
  const bool isOfCells = array &&
    array->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  const bool hasHeights = !vtkTerrainPieces::FindImages(this->Pieces).empty();
  const char* name = array ? array->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  this->Selection->Lift(this->GetView(), this, hasHeights && !isOfCells ? name : nullptr,
    this->Actor->GetVerticalExaggeration());
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::TakeSurfaces(vtkDataObject* delivered)
{
  const std::vector<vtkPolyData*> surfaces = vtkTerrainPieces::FindSurfaces(delivered);
  SetNumberOfActors(
    this->SurfaceActors, surfaces.size(), vtkPVRenderView::SafeDownCast(this->GetView()), this);
  for (std::size_t k = 0; k < surfaces.size(); ++k)
  {
    vtkActor* actor = this->SurfaceActors[k];
    if (!actor->GetMapper())
    {
      actor->SetMapper(vtkSmartPointer<vtkPolyDataMapper>::New());
    }
    static_cast<vtkPolyDataMapper*>(actor->GetMapper())->SetInputData(surfaces[k]);
    this->PlaceSurface(actor);
    actor->SetVisibility(this->GetVisibility());
    vtkTerrainLooks::Clip(actor->GetMapper(), this->Clip ? this->ClipPlane.Get() : nullptr);
    this->UpdateColors(actor->GetMapper());
  }
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::PlaceSurface(vtkActor* actor)
{
  vtkTerrainLooks::ShareActor(this->Actor, actor);
  this->Actor->PlaceAsDrawn(actor, 0.0);
}

//------------------------------------------------------------------------------
// Null without one.
const char* vtkTerrainRepresentation::GetColorArray(bool& isOfCells)
{
  vtkInformation* array = this->GetInputArrayInformation(kColorArray);
  const char* name = array && array->Has(vtkDataObject::FIELD_NAME())
    ? array->Get(vtkDataObject::FIELD_NAME())
    : nullptr;
  isOfCells = name &&
    array->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  return name && *name ? name : nullptr;
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::UpdateColors(vtkTerrainActor* actor)
{
  // slopes, aspects and heights have no colours of another array
  bool isOfCells = false;
  const char* name = this->GetColorArray(isOfCells);
  vtkOpenGLTerrainMapper* mapper = actor->GetTerrainMapper();
  const bool usesArray = mapper->GetColorSource() == vtkOpenGLTerrainMapper::ColorSources::Array;
  actor->SetColorByHeight(name || !usesArray);
  const int source = static_cast<int>(mapper->GetColorSource());
  vtkScalarsToColors* table = this->SourceColors->GetTable(source);
  const char* heights = actor->GetHeights()->GetPointData()->GetScalars()->GetName();
  if (!table && this->LookupTable &&
    (usesArray || (name && heights && std::strcmp(name, heights) == 0)))
  {
    table = this->LookupTable;
  }
  actor->SetLookupTable(table ? table : this->ReliefColors.Get());
  this->SourceColors->ShowBar(
    vtkPVRenderView::SafeDownCast(this->GetView()), name || !usesArray ? source : 0);
  if (name)
  {
    // heights of cells are points here, and so is all else of the cells
    isOfCells = isOfCells && actor->GetHeights()->GetCellData()->HasArray(name);
    mapper->SetScalarMode(
      isOfCells ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
    mapper->SelectColorArray(name);
  }
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::UpdateColors(vtkMapper* mapper)
{
  bool isOfCells = false;
  const char* name = this->GetColorArray(isOfCells);
  mapper->SetScalarVisibility(name != nullptr);
  mapper->SetLookupTable(this->LookupTable);
  mapper->SetUseLookupTableScalarRange(true);
  mapper->SetInterpolateScalarsBeforeMapping(!isOfCells);
  if (name)
  {
    mapper->SetScalarMode(
      isOfCells ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
    mapper->SelectColorArray(name);
  }
}

//------------------------------------------------------------------------------
bool vtkTerrainRepresentation::AddToView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  renderView->GetRenderer()->AddActor(this->Actor);
  renderView->RegisterPropForHardwareSelection(this, this->Actor);
  return this->Superclass::AddToView(view);
}

//------------------------------------------------------------------------------
bool vtkTerrainRepresentation::RemoveFromView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (!renderView)
  {
    return false;
  }
  this->SourceColors->HideBar();
  SetNumberOfActors(this->OtherActors, 0, renderView, this);
  SetNumberOfActors(this->SurfaceActors, 0, renderView, this);
  renderView->GetRenderer()->RemoveActor(this->Actor);
  renderView->UnRegisterPropForHardwareSelection(this, this->Actor);
  return this->Superclass::RemoveFromView(view);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->Actor->SetVisibility(visible && this->Actor->GetHeights());
  for (vtkTerrainActor* actor : this->OtherActors)
  {
    actor->SetVisibility(visible);
  }
  for (vtkActor* actor : this->SurfaceActors)
  {
    actor->SetVisibility(visible);
  }
  if (!visible)
  {
    this->SourceColors->HideBar();
    this->Selection->Lay();
  }
}
