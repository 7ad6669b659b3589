// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainMinMaxPyramid.h"

#include "core/surface/MinMaxPyramid.h"
#include "data/ImageHeights.h"
#include "data/SMPParallelFor.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkUnsignedCharArray.h"

#include <atomic>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkTerrainMinMaxPyramid);

namespace
{
/// An empty array of cell data in the type of the heights.
vtkSmartPointer<vtkDataArray> MakeArray(
  vtkImageData* heights, vtkImageData* level, const char* name)
{
  vtkSmartPointer<vtkDataArray> array;
  array.TakeReference(
    vtkDataArray::CreateDataArray(heights->GetPointData()->GetScalars()->GetDataType()));
  array->SetName(name);
  array->SetNumberOfTuples(level->GetNumberOfCells());
  return array;
}

/// The image of a level, without data.
vtkNew<vtkImageData> MakeLevel(vtkImageData* heights, int level)
{
  const terrain::GridGeometry geometry = terrain::ImageHeights::Geometry(heights);
  const int* dims = heights->GetDimensions();
  const int size = 1 << level;
  vtkNew<vtkImageData> image;
  image->SetDimensions((dims[0] - 2 + size) / size + 1, (dims[1] - 2 + size) / size + 1, 1);
  image->SetOrigin(geometry.Origin.x, geometry.Origin.y, geometry.Origin.z);
  image->SetSpacing(size * geometry.Spacing.x, size * geometry.Spacing.y, heights->GetSpacing()[2]);
  return image;
}

/// Writes the cells of a level; row(j, nodes) gives those of a row.
template <typename T, typename Row>
void FillLevel(vtkImageData* heights, vtkImageData* level, Row&& row)
{
  const vtkSmartPointer<vtkDataArray> maximum = MakeArray(heights, level, "Maximum");
  const vtkSmartPointer<vtkDataArray> minimum = MakeArray(heights, level, "Minimum");
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(level->GetNumberOfCells());
  auto* const maxima = static_cast<T*>(maximum->GetVoidPointer(0));
  auto* const minima = static_cast<T*>(minimum->GetVoidPointer(0));
  unsigned char* const hidden = ghosts->GetPointer(0);
  const std::int64_t width = level->GetDimensions()[0] - 1;
  std::atomic<bool> anyHidden{ false };
  terrain::SMPParallelFor(level->GetDimensions()[1] - 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      std::vector<terrain::PyramidNode<T>> nodes(static_cast<std::size_t>(width));
      for (std::int64_t j = begin; j < end; ++j)
      {
        row(j, nodes);
        for (std::int64_t i = 0; i < width; ++i)
        {
          const terrain::PyramidNode<T>& node = nodes[static_cast<std::size_t>(i)];
          maxima[i + width * j] = node.Maximum;
          minima[i + width * j] = node.Minimum;
          hidden[i + width * j] = node.IsEmpty() ? vtkDataSetAttributes::HIDDENCELL : 0;
          anyHidden = anyHidden || node.IsEmpty();
        }
      }
    });
  level->GetCellData()->SetScalars(maximum);
  level->GetCellData()->AddArray(minimum);
  if (anyHidden)
  {
    level->GetCellData()->AddArray(ghosts);
  }
}

template <typename T>
void FillPyramid(
  vtkImageData* heights, const terrain::HeightfieldView<T>& view, vtkMultiBlockDataSet* output)
{
  using Nodes = std::vector<terrain::PyramidNode<T>>;
  terrain::MinMaxPyramid<T> pyramid;
  pyramid.Build(view, terrain::SMPParallelFor);
  const int top = pyramid.LevelCount();
  output->SetNumberOfBlocks(top == 0 ? 0 : static_cast<unsigned int>(top) + 1);
  for (int k = 0; top > 0 && k <= top; ++k)
  {
    const vtkNew<vtkImageData> level = MakeLevel(heights, k);
    FillLevel<T>(heights, level,
      [&](std::int64_t j, Nodes& nodes)
      {
        if (k == 0)
        {
          terrain::MinMaxPyramid<T>::CellExtremes(view, 0, view.Width - 1, j, nodes.data());
          return;
        }
        for (std::size_t i = 0; i < nodes.size(); ++i)
        {
          nodes[i] = pyramid.At({ static_cast<int>(i), static_cast<int>(j) }, k);
        }
      });
    const auto block = static_cast<unsigned int>(k);
    output->SetBlock(block, level);
    output->GetMetaData(block)->Set(
      vtkCompositeDataSet::NAME(), ("Level " + std::to_string(k)).c_str());
  }
}
}

//------------------------------------------------------------------------------
void vtkTerrainMinMaxPyramid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
int vtkTerrainMinMaxPyramid::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkTerrainMinMaxPyramid::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* heights = vtkImageData::GetData(inputs[0]);
  vtkMultiBlockDataSet* output = vtkMultiBlockDataSet::GetData(outputs);
  const std::string why = terrain::ImageHeights::WhyNotHeights(heights);
  if (!why.empty())
  {
    vtkErrorMacro(<< why);
    return 0;
  }
  terrain::ImageHeights::Dispatch(
    heights, [&](const auto& view) { FillPyramid(heights, view, output); });
  return 1;
}
