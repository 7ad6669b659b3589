// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainPeaks.h"

#include "core/surface/Peaks.h"
#include "data/GlobeData.h"
#include "data/ImageHeights.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <limits>
#include <memory>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkTerrainPeaks);

namespace
{
std::vector<double> AllHeights(vtkImageData* image)
{
  std::vector<double> heights;
  terrain::ImageHeights::Dispatch(image,
    [&heights](const auto& view)
    {
      heights.reserve(static_cast<std::size_t>(view.Width * view.Height));
      for (std::int64_t j = 0; j < view.Height; ++j)
      {
        for (std::int64_t i = 0; i < view.Width; ++i)
        {
          heights.push_back(view.At(i, j));
        }
      }
    });
  return heights;
}
}

//------------------------------------------------------------------------------
int vtkTerrainPeaks::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkTerrainPeaks::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* image = vtkImageData::GetData(inputVector[0]);
  std::string whyNot = terrain::ImageHeights::WhyNotHeights(image);
  if (whyNot.empty() && image->GetNumberOfPoints() > std::numeric_limits<std::uint32_t>::max() - 1)
  {
    whyNot = "there are more than 2^32 - 2 samples";
  }
  if (!whyNot.empty())
  {
    vtkErrorMacro("No peaks: " << whyNot << ".");
    return 0;
  }
  const std::vector<terrain::Peak> peaks =
    terrain::FindPeaks(AllHeights(image), static_cast<std::size_t>(image->GetDimensions()[0]));
  const terrain::GridGeometry geometry = terrain::ImageHeights::Geometry(image, this->Exaggeration);
  const std::unique_ptr<terrain::GlobeGrid> globe = terrain::GlobeData::Get(image);
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const vtkNew<vtkCellArray> vertices;
  const vtkNew<vtkDoubleArray> heights;
  heights->SetName("Height");
  const vtkNew<vtkDoubleArray> prominences;
  prominences->SetName("Prominence");
  for (const terrain::Peak& peak : peaks)
  {
    if (points->GetNumberOfPoints() >= this->NumberOfPeaks ||
      peak.Prominence < this->MinimumProminence)
    {
      break;
    }
    const glm::dvec2 at(static_cast<double>(peak.Column), static_cast<double>(peak.Row));
    const glm::dvec3 flat = geometry.ToModel(at, peak.Height);
    const glm::dvec3 point = globe ? globe->Body.ToPosition({ globe->West + at.x * globe->Step,
                                       globe->Latitudes[peak.Row], flat.z })
                                   : flat;
    const vtkIdType id = points->InsertNextPoint(point.x, point.y, point.z);
    vertices->InsertNextCell(1, &id);
    heights->InsertNextValue(peak.Height);
    prominences->InsertNextValue(peak.Prominence);
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->GetPointData()->AddArray(heights);
  output->GetPointData()->AddArray(prominences);
  return 1;
}

//------------------------------------------------------------------------------
void vtkTerrainPeaks::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfPeaks: " << this->NumberOfPeaks << "\n";
  os << indent << "MinimumProminence: " << this->MinimumProminence << "\n";
  os << indent << "Exaggeration: " << this->Exaggeration << "\n";
}
