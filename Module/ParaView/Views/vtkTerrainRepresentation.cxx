// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainRepresentation.h"

#include "vtkAlgorithm.h"
#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkPVRenderView.h"
#include "vtkPVView.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTerrainActor.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>

vtkStandardNewMacro(vtkTerrainRepresentation);

namespace
{
/// Which of the arrays to process is which.
constexpr int ColorArray = 0;
constexpr int HeightArray = 1;

bool hasCells(vtkImageData* heights)
{
  const int* dimensions = heights->GetDimensions();
  return dimensions[0] > 1 && dimensions[1] > 1 && heights->GetPointData()->GetScalars();
}

/// Cells as samples at their centres, sharing the arrays.
vtkSmartPointer<vtkImageData> cellsAsSamples(vtkImageData* image)
{
  auto samples = vtkSmartPointer<vtkImageData>::New();
  std::array<int, 6> extent{};
  image->GetExtent(extent.data());
  const double* origin = image->GetOrigin();
  const double* spacing = image->GetSpacing();
  samples->SetExtent(extent[0], extent[1] - 1, extent[2], extent[3] - 1, extent[4], extent[4]);
  samples->SetSpacing(spacing[0], spacing[1], spacing[2]);
  samples->SetOrigin(origin[0] + spacing[0] / 2.0, origin[1] + spacing[1] / 2.0, origin[2]);
  samples->GetPointData()->ShallowCopy(image->GetCellData());
  samples->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  return samples;
}

/// Makes of a box a column as high as that of any other process, and the matrix that brings it
/// back.
///
/// ParaView orders the processes by the boxes as they are, and cuts what else is drawn along their
/// sides, each process drawing what lies in its own: what reached above or below the terrain would
/// be in none of them. The camera sees the boxes through the matrix.
void makeColumn(double bounds[6], vtkMatrix4x4* matrix)
{
  matrix->Identity();
  if (!vtkMath::AreBoundsInitialized(bounds))
  {
    return;
  }
  constexpr double end = 1e9; // in metres: beyond the earth
  matrix->SetElement(2, 2, (bounds[5] - bounds[4]) / (2.0 * end));
  matrix->SetElement(2, 3, (bounds[5] + bounds[4]) / 2.0);
  bounds[4] = -end;
  bounds[5] = end;
}

/// First and last sample, counted from the first one of the image, of the cells that are not copies
/// of another process's.
void ownSamples(vtkImageData* image, std::array<int, 2>& first, std::array<int, 2>& last)
{
  const int* dimensions = image->GetDimensions();
  first = { 0, 0 };
  last = { dimensions[0] - 1, dimensions[1] - 1 };
  vtkUnsignedCharArray* ghosts = image->GetCellGhostArray();
  if (!ghosts)
  {
    return;
  }
  const vtkIdType columns = dimensions[0] - 1;
  const auto isOwn = [ghosts](vtkIdType cell)
  { return !(ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL); };
  vtkIdType low = 0;
  vtkIdType high = ghosts->GetNumberOfValues() - 1;
  while (low < high && !isOwn(low))
  {
    ++low;
  }
  while (high > low && !isOwn(high))
  {
    --high;
  }
  first = { static_cast<int>(low % columns), static_cast<int>(low / columns) };
  last = { static_cast<int>(high % columns) + 1, static_cast<int>(high / columns) + 1 };
}
}

//------------------------------------------------------------------------------
vtkTerrainRepresentation::vtkTerrainRepresentation()
  : Heights(vtkSmartPointer<vtkImageData>::New())
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
    if (info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1)
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
  this->Heights = vtkSmartPointer<vtkImageData>::New();
  vtkImageData* input =
    inputs[0]->GetNumberOfInformationObjects() > 0 ? vtkImageData::GetData(inputs[0], 0) : nullptr;
  if (input && input->GetNumberOfPoints() > 0)
  {
    int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
    vtkDataArray* heights = this->GetInputArrayToProcess(HeightArray, inputs, association);
    if (heights && association == vtkDataObject::FIELD_ASSOCIATION_CELLS)
    {
      this->Heights = cellsAsSamples(input);
    }
    else
    {
      this->Heights->ShallowCopy(input);
    }
    if (heights && heights->GetName())
    {
      this->Heights->GetPointData()->SetActiveScalars(heights->GetName());
    }
  }
  return this->Superclass::RequestData(request, inputs, outputs);
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
    this->PassPiece(inInfo, outInfo);
  }
  else if (request == vtkPVView::REQUEST_UPDATE_LOD())
  {
    vtkPVRenderView::SetRequiresDistributedRenderingLOD(inInfo, this, true);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    this->TakePiece(inInfo);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::PassPiece(vtkInformation* inInfo, vtkInformation* outInfo)
{
  vtkPVView::SetPiece(inInfo, this, this->Heights, this->Heights->GetActualMemorySize());
  vtkPVRenderView::SetRequiresDistributedRendering(inInfo, this, true);
  double bounds[6];
  this->GetOwnBounds(bounds);
  vtkNew<vtkMatrix4x4> toWorld;
  makeColumn(bounds, toWorld);
  vtkPVRenderView::SetGeometryBounds(inInfo, this, bounds, toWorld);
  vtkPVRenderView::SetOrderedCompositingConfiguration(
    inInfo, this, vtkPVRenderView::USE_BOUNDS_FOR_REDISTRIBUTION, bounds);
  if (this->Actor->GetProperty()->GetOpacity() < 1.0)
  {
    outInfo->Set(vtkPVRenderView::NEED_ORDERED_COMPOSITING(), 1);
  }
}

//------------------------------------------------------------------------------
// Of what this process draws, in world coordinates: boxes that overlap have no order to be
// composited in.
void vtkTerrainRepresentation::GetOwnBounds(double bounds[6])
{
  vtkMath::UninitializeBounds(bounds);
  if (!hasCells(this->Heights))
  {
    return;
  }
  std::array<int, 2> first{};
  std::array<int, 2> last{};
  ownSamples(this->Heights, first, last);
  const int* extent = this->Heights->GetExtent();
  const double* origin = this->Heights->GetOrigin();
  const double* spacing = this->Heights->GetSpacing();
  double range[2];
  this->Heights->GetPointData()->GetScalars()->GetFiniteRange(range, 0);
  if (range[0] > range[1])
  {
    return;
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    const double start = origin[axis] + extent[2 * axis] * spacing[axis];
    bounds[2 * axis] = start + first[axis] * spacing[axis];
    bounds[2 * axis + 1] = start + last[axis] * spacing[axis];
    bounds[4 + axis] = origin[2] + this->Actor->GetVerticalExaggeration() * range[axis];
  }
  this->Actor->ComputeMatrix();
  vtkBoundingBox box;
  for (int corner = 0; corner < 8; ++corner)
  {
    const double point[4] = { bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)],
      bounds[4 + (corner >> 2)], 1.0 };
    double moved[4];
    this->Actor->GetMatrix()->MultiplyPoint(point, moved);
    box.AddPoint(moved);
  }
  box.GetBounds(bounds);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::TakePiece(vtkInformation* inInfo)
{
  auto* heights = vtkImageData::SafeDownCast(vtkPVRenderView::GetDeliveredPiece(inInfo, this));
  const bool draws = heights && hasCells(heights);
  this->Actor->SetVisibility(draws && this->GetVisibility());
  if (!draws)
  {
    return;
  }
  if (this->Actor->GetHeights() != heights)
  {
    this->Actor->SetInputData(heights);
    std::array<int, 2> first{};
    std::array<int, 2> last{};
    ownSamples(heights, first, last);
    this->Actor->GetTerrainMapper()->SetExtract(first.data(), last.data());
  }
  this->UpdateColors();
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::UpdateColors()
{
  vtkInformation* array = this->GetInputArrayInformation(ColorArray);
  const char* name = array && array->Has(vtkDataObject::FIELD_NAME())
    ? array->Get(vtkDataObject::FIELD_NAME())
    : nullptr;
  vtkOpenGLTerrainMapper* mapper = this->Actor->GetTerrainMapper();
  const bool usesArray = mapper->GetColorSource() == vtkOpenGLTerrainMapper::ColorSources::Array;
  const bool hasArray = name && *name;
  this->Actor->SetColorByHeight(hasArray || !usesArray);
  if (hasArray)
  {
    const bool isOfCells =
      array->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_CELLS &&
      this->Actor->GetHeights()->GetCellData()->HasArray(name);
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
  renderView->GetRenderer()->RemoveActor(this->Actor);
  renderView->UnRegisterPropForHardwareSelection(this, this->Actor);
  return this->Superclass::RemoveFromView(view);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->Actor->SetVisibility(visible && this->Actor->GetHeights());
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetTechnique(int technique)
{
  this->Actor->SetTechnique(static_cast<vtkTerrainActor::Techniques>(technique));
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetVerticalExaggeration(double exaggeration)
{
  this->Actor->SetVerticalExaggeration(exaggeration);
  this->MarkModified(); // the bounds are passed with the data
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetColorSource(int source)
{
  this->Actor->GetTerrainMapper()->SetColorSource(
    static_cast<vtkOpenGLTerrainMapper::ColorSources>(source));
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetLevelOfDetail(bool use)
{
  this->Actor->SetLevelOfDetail(use);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetContours(bool show)
{
  this->Actor->GetTerrainMapper()->SetContours(show);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetContourInterval(double heights)
{
  this->Actor->GetTerrainMapper()->SetContourInterval(heights);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetContourWidth(double pixels)
{
  this->Actor->GetTerrainMapper()->SetContourWidth(pixels);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetHillshade(bool show)
{
  this->Actor->GetTerrainMapper()->SetHillshade(show);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetHillshadeAzimuth(double degrees)
{
  this->Actor->GetTerrainMapper()->SetHillshadeAzimuth(degrees);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetHillshadeAltitude(double degrees)
{
  this->Actor->GetTerrainMapper()->SetHillshadeAltitude(degrees);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetBlock(bool show)
{
  this->Actor->GetTerrainMapper()->SetBlock(show);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetBlockBase(double height)
{
  this->Actor->GetTerrainMapper()->SetBlockBase(height);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetLookupTable(vtkScalarsToColors* colors)
{
  this->Actor->SetLookupTable(colors);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetOpacity(double opacity)
{
  this->Actor->GetProperty()->SetOpacity(opacity);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetAmbientColor(double red, double green, double blue)
{
  this->Actor->GetProperty()->SetAmbientColor(red, green, blue);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetDiffuseColor(double red, double green, double blue)
{
  this->Actor->GetProperty()->SetDiffuseColor(red, green, blue);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetSpecular(double specular)
{
  this->Actor->GetProperty()->SetSpecular(specular);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetSpecularPower(double power)
{
  this->Actor->GetProperty()->SetSpecularPower(power);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetTexture(vtkTexture* texture)
{
  this->Actor->SetTexture(texture);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetPosition(double x, double y, double z)
{
  this->Actor->SetPosition(x, y, z);
  this->MarkModified();
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetScale(double x, double y, double z)
{
  this->Actor->SetScale(x, y, z);
  this->MarkModified();
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetOrientation(double x, double y, double z)
{
  this->Actor->SetOrientation(x, y, z);
  this->MarkModified();
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetOrigin(double x, double y, double z)
{
  this->Actor->SetOrigin(x, y, z);
  this->MarkModified();
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetPickable(int pickable)
{
  this->Actor->SetPickable(pickable);
}
