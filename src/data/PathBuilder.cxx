// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "data/PathBuilder.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

namespace terrain
{
//------------------------------------------------------------------------------
PathBuilder::PathBuilder(vtkPolyData* input, vtkPolyData* output)
  : Input(input)
  , Output(output)
{
  this->Points->SetDataTypeToDouble();
  output->GetPointData()->InterpolateAllocate(input->GetPointData());
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> PathBuilder::IdsOf(vtkCellArray* cells, vtkIdType cell)
{
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  cells->GetCellAtId(cell, count, ids);
  return { ids, ids + count };
}

//------------------------------------------------------------------------------
vtkIdType PathBuilder::AddPoint(const glm::dvec3& position, vtkIdType from, vtkIdType to, double t)
{
  const vtkIdType id = this->Points->InsertNextPoint(position.x, position.y, position.z);
  this->Output->GetPointData()->InterpolateEdge(this->Input->GetPointData(), id, from, to, t);
  return id;
}

//------------------------------------------------------------------------------
void PathBuilder::AddVertex(const glm::dvec3& position, vtkIdType id, vtkIdType cell)
{
  const vtkIdType made = this->AddPoint(position, id, id, 0.0);
  this->Vertices->InsertNextCell(1, &made);
  this->VertexSources.push_back(cell);
}

//------------------------------------------------------------------------------
void PathBuilder::EndLine(vtkIdType cell)
{
  if (this->Line.size() > 1)
  {
    this->Lines->InsertNextCell(static_cast<vtkIdType>(this->Line.size()), this->Line.data());
    this->LineSources.push_back(cell);
  }
  this->Line.clear();
}

//------------------------------------------------------------------------------
void PathBuilder::Finish()
{
  this->Output->SetPoints(this->Points);
  this->Output->SetVerts(this->Vertices);
  this->Output->SetLines(this->Lines);
  vtkCellData* to = this->Output->GetCellData();
  vtkCellData* from = this->Input->GetCellData();
  to->CopyAllocate(from);
  std::vector<vtkIdType> sources = this->VertexSources;
  sources.insert(sources.end(), this->LineSources.begin(), this->LineSources.end());
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    to->CopyData(from, sources[i], static_cast<vtkIdType>(i));
  }
}
}
