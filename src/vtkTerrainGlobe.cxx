// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainGlobe.h"

#include "core/grid/Constants.h"
#include "core/grid/HeightCodes.h"
#include "data/GlobeData.h"
#include "data/ImageHeights.h"
#include "data/SMPParallelFor.h"
#include "place/GlobeHeights.h"

#include "vtkAlgorithmOutput.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

vtkStandardNewMacro(vtkTerrainGlobe);

namespace
{
/// The lowest height that is to be seen; hidden samples may hold any number. NaN if there is none.
double LowestSeen(vtkImageData* heights)
{
  double lowest = terrain::kNaN;
  terrain::ImageHeights::Dispatch(heights,
    [&lowest](const auto& view)
    {
      const auto range = terrain::FindHeightRange(view, terrain::SMPParallelFor);
      lowest = range.Minimum <= range.Maximum ? static_cast<double>(range.Minimum) : terrain::kNaN;
    });
  return lowest;
}

/// Origin and spacing of an image of a globe's samples, in degrees: rows at equal distances,
/// although those that close a pole are nearer.
struct Layout
{
  explicit Layout(const terrain::GlobeGrid& grid)
  {
    const std::vector<double>& latitudes = grid.Latitudes;
    const std::size_t second = latitudes.size() > 3 ? 1 : 0;
    const double along = (latitudes[second + 1] - latitudes[second]) / terrain::kDegree;
    this->Origin[0] = grid.West / terrain::kDegree;
    this->Origin[1] = latitudes[second] / terrain::kDegree - static_cast<double>(second) * along;
    this->Spacing[0] = grid.Step / terrain::kDegree;
    this->Spacing[1] = along;
  }
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Spacing[3] = { 1.0, 1.0, 1.0 };
};
}

//------------------------------------------------------------------------------
vtkTerrainGlobe::vtkTerrainGlobe()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
int vtkTerrainGlobe::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkTerrainGlobe::AddFinerData(vtkImageData* globe)
{
  this->AddInputDataInternal(1, globe);
}

//------------------------------------------------------------------------------
void vtkTerrainGlobe::AddFinerConnection(vtkAlgorithmOutput* globe)
{
  this->AddInputConnection(1, globe);
}

//------------------------------------------------------------------------------
void vtkTerrainGlobe::SetRadii(double equatorial, double polar)
{
  if (this->Radii[0] != equatorial || this->Radii[1] != polar)
  {
    this->Radii[0] = equatorial;
    this->Radii[1] = polar;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkTerrainGlobe::Suits(vtkImageData* heights)
{
  constexpr double kWide = 60.0;
  bool isEarth = true;
  const glm::dvec2 reach = terrain::GlobeReach(heights, isEarth);
  return std::max(reach.x, reach.y) > (isEarth ? kWide : 0.0);
}

//------------------------------------------------------------------------------
int vtkTerrainGlobe::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  // what is added or left out, and in which unit longitudes are, the samples and their field data
  // tell
  vtkAlgorithmOutput* connection = this->GetInputConnection(0, 0);
  connection->GetProducer()->Update(connection->GetIndex());
  const terrain::GlobePlan plan = terrain::PlanGlobe(vtkImageData::GetData(inputs[0]), this->Radii);
  vtkInformation* info = outputs->GetInformationObject(0);
  int extent[6];
  inputs[0]->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  if (plan.WhyNot.empty())
  {
    const int size[2] = { plan.Grid.Columns, static_cast<int>(plan.Grid.Latitudes.size()) };
    const int whole[6] = { 0, size[0] - 1, 0, size[1] - 1, 0, 0 };
    std::copy(whole, whole + 6, extent);
    const Layout layout(plan.Grid);
    info->Set(vtkDataObject::ORIGIN(), layout.Origin, 3);
    info->Set(vtkDataObject::SPACING(), layout.Spacing, 3);
  }
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  // rows of a globe run north, whichever way those of the input do
  info->Remove(vtkDataObject::DIRECTION());
  return 1;
}

//------------------------------------------------------------------------------
int vtkTerrainGlobe::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  for (int port = 0; port < 2; ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* info = inputs[port]->GetInformationObject(i);
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(),
        info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()), 6);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
bool vtkTerrainGlobe::Fail(vtkImageData* output, const std::string& why)
{
  output->Initialize();
  this->ErrorMessage = why;
  vtkErrorMacro("No globe: " << why << ".");
  return false;
}

//------------------------------------------------------------------------------
int vtkTerrainGlobe::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* heights = vtkImageData::GetData(inputs[0]);
  vtkImageData* output = vtkImageData::GetData(outputs);
  const terrain::GlobePlan plan = terrain::PlanGlobe(heights, this->Radii);
  this->ErrorMessage.clear();
  if (!plan.WhyNot.empty())
  {
    return this->Fail(output, plan.WhyNot);
  }
  const terrain::Ellipsoid& body = plan.Grid.Body;
  const bool radii = LowestSeen(heights) > 0.5 * body.Polar;
  if (radii && body.Flattening() > 0.0)
  {
    return this->Fail(output,
      "the heights are radii, which count from a sphere, but the ellipsoid is flattened: "
      "SetRadii() to those of a sphere");
  }
  // the origin's z counts as in every frame
  const double offset = (radii ? body.Equatorial : 0.0) - heights->GetOrigin()[2];
  const int finer = inputs[1]->GetNumberOfInformationObjects();
  if (plan.IsPlain && offset == 0.0 && finer == 0 &&
    !terrain::ImageHeights::AreRowsFromNorth(heights))
  {
    output->ShallowCopy(heights);
    output->SetExtent(0, plan.Grid.Columns - 1, 0, heights->GetDimensions()[1] - 1, 0, 0);
  }
  else
  {
    terrain::FillGlobe(heights, plan, offset, finer > 0, output);
    output->GetFieldData()->PassData(heights->GetFieldData());
  }
  const Layout layout(plan.Grid);
  output->SetOrigin(layout.Origin);
  output->SetSpacing(layout.Spacing);
  output->SetDirectionMatrix(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
  output->GetFieldData()->RemoveArray("LayoutOrigin");
  output->GetFieldData()->RemoveArray("LayoutScale");
  terrain::GlobeData::Add(output, plan.Grid);
  for (int i = 0; i < finer; ++i)
  {
    const std::string why = terrain::GiveWay(output, vtkImageData::GetData(inputs[1], i));
    if (!why.empty())
    {
      return this->Fail(output, why);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkTerrainGlobe::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Radii: " << this->Radii[0] << ", " << this->Radii[1] << "\n";
}
