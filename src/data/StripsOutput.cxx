// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "data/StripsOutput.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <vector>

namespace terrain
{
namespace
{
using MeshSource = StripsSource;

/// Rounding of heights with detail, which are sums of floats, relative to the largest.
constexpr double kHeightSlack = 1.0e-5;

/// Colour of a depth: neighbouring depths differ clearly, hues repeat after twelve.
void DepthColor(int depth, unsigned char* color)
{
  double rgb[3];
  const double hue = std::fmod(0.137 + 0.4166666667 * depth, 1.0);
  vtkMath::HSVToRGB(
    hue, (depth & 1) != 0 ? 0.55 : 0.85, (depth & 1) != 0 ? 1.0 : 0.8, rgb, rgb + 1, rgb + 2);
  for (int i = 0; i < 3; ++i)
  {
    color[i] = static_cast<unsigned char>(std::lround(255.0 * rgb[i]));
  }
}

void AddPoints(
  const StripMesh& mesh, const GridGeometry& geometry, double part, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.Vertices.size()));
  auto* positions = static_cast<double*>(points->GetVoidPointer(0));
  for (const StripVertex& vertex : mesh.Vertices)
  {
    const glm::dvec3 position = geometry.ToModel({ part * vertex.Column, part * vertex.Row },
      static_cast<double>(vertex.Height) + vertex.Displacement);
    positions = std::copy_n(&position.x, 3, positions);
  }
  output->SetPoints(points);
}

/// Cells of the output: one strip, or its triangles that are not degenerate.
void AddCells(const StripMesh& mesh, bool triangles, vtkPolyData* output)
{
  vtkNew<vtkCellArray> cells;
  const std::vector<std::uint32_t>& strip = mesh.Strip;
  if (!triangles && strip.size() >= 3)
  {
    cells->AllocateExact(1, static_cast<vtkIdType>(strip.size()));
    cells->InsertNextCell(static_cast<int>(strip.size()));
    for (const std::uint32_t index : strip)
    {
      cells->InsertCellPoint(index);
    }
  }
  if (triangles)
  {
    cells->AllocateExact(mesh.Triangles, 3 * mesh.Triangles);
    for (std::size_t i = 2; i < strip.size(); ++i)
    {
      vtkIdType corners[3] = { strip[i - 2], strip[i - 1], strip[i] };
      if (corners[0] != corners[1] && corners[1] != corners[2] && corners[0] != corners[2])
      {
        if ((i & 1) != 0)
        {
          std::swap(corners[0], corners[1]);
        }
        cells->InsertNextCell(3, corners);
      }
    }
    output->SetPolys(cells);
    return;
  }
  output->SetStrips(cells);
}

/// Slopes of the base at a vertex, in height units over model units; between samples those at the
/// cell's corners, bilinear.
glm::dvec2 BaseSlopes(const StripVertex& vertex, const MeshSource& source)
{
  const HierarchyView& hierarchy = source.Hierarchy;
  const auto slopes = [](const HierarchyGradient& gradient)
  { return glm::dvec2(gradient.X(), gradient.Y()); };
  if (vertex.Record < StripVertex::NoRecord)
  {
    return slopes(hierarchy.Gradients[vertex.Record]);
  }
  if (vertex.Record != StripVertex::BelowSamples)
  {
    return slopes(hierarchy.Summary.CornerGradients[vertex.Record - StripVertex::NoRecord]);
  }
  const glm::i64vec2 last(hierarchy.Layout->Width() - 1, hierarchy.Layout->Height() - 1);
  const glm::dvec2 position = source.Part() * glm::dvec2(vertex.Column, vertex.Row);
  const glm::i64vec2 low = glm::min(glm::i64vec2(position), last - std::int64_t(1));
  const glm::dvec2 t = position - glm::dvec2(low);
  const auto at = [&](int i, int j) { return slopes(hierarchy.GradientAt(low.x + i, low.y + j)); };
  return glm::mix(glm::mix(at(0, 0), at(1, 0), t.x), glm::mix(at(0, 1), at(1, 1), t.x), t.y);
}

/// Slopes of the detail at a vertex, in base height units over model units: central differences.
glm::dvec2 DetailSlopes(const StripVertex& vertex, const MeshSource& source)
{
  const glm::ivec2 period = source.Detail->Period();
  const float* heights = source.Detail->Heights();
  const int i = static_cast<int>(vertex.Column % static_cast<std::uint32_t>(period.x));
  const int j = static_cast<int>(vertex.Row % static_cast<std::uint32_t>(period.y));
  const auto at = [&](int x, int y) -> double
  {
    return heights[(x + period.x) % period.x +
      static_cast<std::ptrdiff_t>(period.x) * ((y + period.y) % period.y)];
  };
  return glm::dvec2(at(i + 1, j) - at(i - 1, j), at(i, j + 1) - at(i, j - 1)) /
    (2.0 * source.Part() * source.Hierarchy.Geometry.Spacing);
}

void AddNormals(const StripMesh& mesh, const MeshSource& source, const GridGeometry& geometry,
  double detailScale, vtkPolyData* output)
{
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(static_cast<vtkIdType>(mesh.Vertices.size()));
  float* out = normals->GetPointer(0);
  for (const StripVertex& vertex : mesh.Vertices)
  {
    glm::dvec2 slopes = BaseSlopes(vertex, source);
    if (source.Detail)
    {
      slopes += detailScale * DetailSlopes(vertex, source);
    }
    const glm::dvec3 normal =
      glm::normalize(geometry.NormalToModel({ -slopes * geometry.Spacing, 1.0 }));
    for (int i = 0; i < 3; ++i)
    {
      *out++ = static_cast<float>(normal[i]);
    }
  }
  output->GetPointData()->SetNormals(normals);
}

void AddTextureCoordinates(const StripMesh& mesh, const MeshSource& source, vtkPolyData* output)
{
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TextureCoordinates");
  coordinates->SetNumberOfComponents(2);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(mesh.Vertices.size()));
  float* out = coordinates->GetPointer(0);
  const HierarchyLayout& layout = *source.Hierarchy.Layout;
  const double cells = 1.0 / source.Part();
  const double width = cells * std::max<double>(1.0, static_cast<double>(layout.Width() - 1));
  const double height = cells * std::max<double>(1.0, static_cast<double>(layout.Height() - 1));
  for (const StripVertex& vertex : mesh.Vertices)
  {
    *out++ = static_cast<float>(vertex.Column / width);
    *out++ = static_cast<float>(vertex.Row / height);
  }
  output->GetPointData()->SetTCoords(coordinates);
}

/// Depth of a vertex in the hierarchy; the corners of the square have the root's.
int DepthOf(const StripVertex& vertex, const MeshSource& source)
{
  const HierarchyLayout& layout = *source.Hierarchy.Layout;
  if (vertex.Record < StripVertex::NoRecord)
  {
    return layout.DepthOf(vertex.Record);
  }
  if (vertex.Record != StripVertex::BelowSamples)
  {
    return 0;
  }
  int shift = 0;
  while ((((vertex.Column | vertex.Row) >> shift) & 1u) == 0)
  {
    ++shift;
  }
  const bool isCentre = ((vertex.Column & vertex.Row) >> shift & 1u) != 0;
  return 2 * (layout.Pairs() + source.Level() - 1 - shift) + (isCentre ? 0 : 1);
}

void AddDepthColors(const StripMesh& mesh, const MeshSource& source, vtkPolyData* output)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Depth");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(static_cast<vtkIdType>(mesh.Vertices.size()));
  unsigned char* out = colors->GetPointer(0);
  for (const StripVertex& vertex : mesh.Vertices)
  {
    DepthColor(DepthOf(vertex, source), out);
    out += 3;
  }
  output->GetPointData()->SetScalars(colors);
}

void AddHeights(const StripMesh& mesh, vtkPolyData* output)
{
  vtkNew<vtkFloatArray> heights;
  heights->SetName("Height");
  heights->SetNumberOfTuples(static_cast<vtkIdType>(mesh.Vertices.size()));
  float* out = heights->GetPointer(0);
  for (const StripVertex& vertex : mesh.Vertices)
  {
    *out++ = static_cast<float>(static_cast<double>(vertex.Height) + vertex.Displacement);
  }
  output->GetPointData()->SetScalars(heights);
}
}

//------------------------------------------------------------------------------
bool AreHeightsKnown(const StripMesh& mesh, const StripsSource& source, double detailScale)
{
  const HierarchySummary& summary = source.Hierarchy.Summary;
  double lowest = summary.MinimumHeight;
  double highest = summary.MaximumHeight;
  if (source.Detail)
  {
    lowest += detailScale * source.Detail->Minimum();
    highest += detailScale * source.Detail->Maximum();
  }
  const double slack = kHeightSlack * std::max(std::abs(lowest), std::abs(highest));
  return std::all_of(mesh.Strip.begin(), mesh.Strip.end(),
    [&](std::uint32_t index)
    {
      const float height = mesh.Vertices[index].Height;
      return height >= lowest - slack && height <= highest + slack;
    });
}

//------------------------------------------------------------------------------
void FillStrips(const StripMesh& mesh, const StripsSource& source, const StripsOptions& options,
  vtkPolyData* output)
{
  GridGeometry geometry = source.Hierarchy.Geometry;
  geometry.Exaggeration = options.Exaggeration;
  AddPoints(mesh, geometry, source.Part(), output);
  AddCells(mesh, options.TriangleOutput, output);
  if (options.Normals)
  {
    AddNormals(mesh, source, geometry, options.DetailScale, output);
  }
  if (options.TextureCoordinates)
  {
    AddTextureCoordinates(mesh, source, output);
  }
  if (options.HeightScalars)
  {
    AddHeights(mesh, output);
  }
  if (options.DepthColors)
  {
    AddDepthColors(mesh, source, output);
  }
}
}
