// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Vertices and lines made of those of another poly data. Private to the module.
 */
#ifndef vtkTerrain_data_PathBuilder_h
#define vtkTerrain_data_PathBuilder_h

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/glm.hpp>

#include <vector>

namespace terrain
{
/// Points (in double precision), vertices and lines while they are made of an input's. Point data
/// are interpolated between two points of the input; cell data are copied.
class PathBuilder
{
public:
  /// The output is filled by Finish(). It must not be the input.
  PathBuilder(vtkPolyData* input, vtkPolyData* output);

  /// A point of the input.
  glm::dvec3 GetPoint(vtkIdType id) const
  {
    glm::dvec3 point;
    this->Input->GetPoint(id, &point.x);
    return point;
  }

  /// Calls onVertex(id, cell) for each vertex of the input, then onLine(ids, cell) for each line
  /// and polygon. The ids of a polygon end with the first one again.
  template <typename OnVertex, typename OnLine>
  void ForEachCell(const OnVertex& onVertex, const OnLine& onLine) const
  {
    vtkCellArray* const kinds[3] = { this->Input->GetVerts(), this->Input->GetLines(),
      this->Input->GetPolys() };
    vtkIdType source = 0;
    for (int kind = 0; kind < 3; ++kind)
    {
      for (vtkIdType cell = 0; cell < kinds[kind]->GetNumberOfCells(); ++cell, ++source)
      {
        std::vector<vtkIdType> ids = IdsOf(kinds[kind], cell);
        if (kind == 2 && !ids.empty())
        {
          ids.push_back(ids.front());
        }
        if (kind > 0)
        {
          onLine(ids, source);
          continue;
        }
        for (const vtkIdType id : ids)
        {
          onVertex(id, source);
        }
      }
    }
  }

  /// A vertex with the data of a point and of a cell of the input.
  void AddVertex(const glm::dvec3& position, vtkIdType id, vtkIdType cell);

  /// The next point of the line that is being made, at t (0 to 1) from one point of the input to
  /// another.
  void AddToLine(const glm::dvec3& position, vtkIdType from, vtkIdType to, double t)
  {
    this->Line.push_back(this->AddPoint(position, from, to, t));
  }

  bool HasLine() const
  {
    return !this->Line.empty();
  }

  /// Ends the line that is being made, with the data of a cell of the input. A single point is no
  /// line.
  void EndLine(vtkIdType cell);

  /// Hands all to the output.
  void Finish();

private:
  static std::vector<vtkIdType> IdsOf(vtkCellArray* cells, vtkIdType cell);
  vtkIdType AddPoint(const glm::dvec3& position, vtkIdType from, vtkIdType to, double t);

  vtkPolyData* Input;
  vtkPolyData* Output;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Vertices;
  vtkNew<vtkCellArray> Lines;
  /// Cells of the input that the output's vertices and lines come from.
  std::vector<vtkIdType> VertexSources;
  std::vector<vtkIdType> LineSources;
  /// Points of the line that is being made.
  std::vector<vtkIdType> Line;
};
}

#endif
