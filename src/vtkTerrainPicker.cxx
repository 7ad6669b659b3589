// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainPicker.h"

#include "data/ImageHeights.h"
#include "data/ImageRayCaster.h"
#include "vtkOpenGLTerrainMapper.h"

#include "core/rays/SurfacePath.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <list>

vtkStandardNewMacro(vtkTerrainPicker);

namespace
{
/// Heights as an actor shows them.
struct ShownTerrain
{
  vtkImageData* Heights = nullptr;
  double Exaggeration = 1.0;
  /// In model coordinates: what is drawn of the heights.
  glm::dvec2 Lowest{ 0.0 };
  glm::dvec2 Highest{ 0.0 };
  vtkNew<vtkMatrix4x4> ModelToWorld;
  vtkNew<vtkMatrix4x4> WorldToModel;

  terrain::GridGeometry Geometry() const
  {
    terrain::GridGeometry geometry = terrain::ImageHeights::Geometry(this->Heights);
    geometry.Exaggeration = this->Exaggeration;
    return geometry;
  }
};

/// Heights and exaggeration of a mapper; Heights stay null if it draws no terrain.
void readMapper(vtkMapper* mapper, ShownTerrain& shown)
{
  auto* terrainMapper = vtkOpenGLTerrainMapper::SafeDownCast(mapper);
  vtkImageData* heights = terrainMapper ? terrainMapper->GetHeights() : nullptr;
  if (terrain::ImageHeights::WhyNotHeights(heights).empty())
  {
    shown.Heights = heights;
    shown.Exaggeration = terrainMapper->GetVerticalExaggeration();
    const double* bounds = terrainMapper->GetBounds();
    shown.Lowest = { bounds[0], bounds[2] };
    shown.Highest = { bounds[1], bounds[3] };
  }
}

/// What an actor shows, up to date; Heights stay null if that is no terrain.
void readActor(vtkActor* actor, ShownTerrain& shown)
{
  if (!actor || !actor->GetMapper())
  {
    return;
  }
  actor->GetMapper()->GetBounds(); // brings the heights up to date
  readMapper(actor->GetMapper(), shown);
  shown.ModelToWorld->DeepCopy(actor->GetMatrix());
  vtkMatrix4x4::Invert(shown.ModelToWorld, shown.WorldToModel);
}

glm::dvec3 transform(vtkMatrix4x4* matrix, const glm::dvec3& point)
{
  const double in[4] = { point.x, point.y, point.z, 1.0 };
  std::array<double, 4> out{};
  matrix->MultiplyPoint(in, out.data());
  return glm::dvec3(out[0], out[1], out[2]) / out[3];
}

bool isFinite(const glm::dvec3& point)
{
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

/// Linear between a and b; neither counts where its weight is 0, for it may be NaN.
double mix(double a, double b, double t)
{
  if (t <= 0.0)
  {
    return a;
  }
  return t >= 1.0 ? b : (1.0 - t) * a + t * b;
}

/// Narrows a ray to the columns and rows that are drawn; its end lies before its begin if it passes
/// beside them.
void clipToShown(const ShownTerrain& shown, terrain::ReferenceRay& ray)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    const double low = shown.Lowest[axis] - ray.Origin[axis];
    const double high = shown.Highest[axis] - ray.Origin[axis];
    const double pace = ray.Direction[axis];
    if (pace != 0.0)
    {
      ray.Begin = std::max(ray.Begin, std::min(low / pace, high / pace));
      ray.End = std::min(ray.End, std::max(low / pace, high / pace));
    }
    else if (low > 0.0 || high < 0.0)
    {
      ray.End = -1.0;
    }
  }
}

/// Collects a profile.
class ProfileLines
{
public:
  ProfileLines(const ShownTerrain& shown, const glm::dvec3& from, const glm::dvec3& to)
    : Shown(shown)
    , Geometry(shown.Geometry())
    , From(from)
    , To(to)
  {
    this->Points->SetDataTypeToDouble();
    this->Distances->SetName("Distance");
    this->Heights->SetName("Height");
  }

  /// Adds a stretch of the way over one cell.
  void Add(const terrain::SurfacePiece& piece)
  {
    if (!piece.HasSurface)
    {
      this->EndLine();
      return;
    }
    if (this->Line.empty())
    {
      this->AddPoint(piece, piece.Begin);
    }
    const double top = -piece.Linear / (2.0 * piece.Quadratic);
    if (top > piece.Begin && top < piece.End)
    {
      this->AddPoint(piece, top);
    }
    this->AddPoint(piece, piece.End);
  }

  void Finish(vtkPolyData* profile)
  {
    this->EndLine();
    profile->SetPoints(this->Points);
    profile->SetLines(this->Lines);
    profile->GetPointData()->AddArray(this->Distances);
    profile->GetPointData()->SetScalars(this->Heights);
  }

private:
  void AddPoint(const terrain::SurfacePiece& piece, double t)
  {
    const glm::dvec3 along = this->From + t * (this->To - this->From);
    const double height = piece.HeightAt(t);
    const glm::dvec3 point = transform(this->Shown.ModelToWorld,
      { along.x, along.y, this->Geometry.Origin.z + this->Geometry.Exaggeration * height });
    this->Line.push_back(this->Points->InsertNextPoint(point.x, point.y, point.z));
    this->Distances->InsertNextValue(t * glm::length(glm::dvec2(this->To - this->From)));
    this->Heights->InsertNextValue(height);
  }

  void EndLine()
  {
    if (!this->Line.empty())
    {
      this->Lines->InsertNextCell(static_cast<vtkIdType>(this->Line.size()), this->Line.data());
      this->Line.clear();
    }
  }

  const ShownTerrain& Shown;
  terrain::GridGeometry Geometry;
  glm::dvec3 From;
  glm::dvec3 To;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkDoubleArray> Distances;
  vtkNew<vtkDoubleArray> Heights;
  std::vector<vtkIdType> Line;
};
}

//------------------------------------------------------------------------------
class vtkTerrainPicker::vtkInternals
{
public:
  /// The caster over an image, scanned if need be; counts scans. Casters of images that are gone
  /// are dropped.
  const terrain::ImageRayCaster& CasterOf(vtkImageData* image, int& scans)
  {
    this->Casters.remove_if(
      [](const terrain::ImageRayCaster& caster) { return caster.GetImage() == nullptr; });
    auto found = std::find_if(this->Casters.begin(), this->Casters.end(),
      [image](const terrain::ImageRayCaster& caster) { return caster.GetImage() == image; });
    if (found == this->Casters.end())
    {
      this->Casters.emplace_back();
      found = std::prev(this->Casters.end());
    }
    scans += found->SetImage(image) ? 1 : 0;
    return *found;
  }

private:
  std::list<terrain::ImageRayCaster> Casters;
};

//------------------------------------------------------------------------------
vtkTerrainPicker::vtkTerrainPicker()
  : GridPosition{ vtkMath::Nan(), vtkMath::Nan() }
  , Internals(new vtkInternals)
{
}

//------------------------------------------------------------------------------
vtkTerrainPicker::~vtkTerrainPicker() = default;

//------------------------------------------------------------------------------
void vtkTerrainPicker::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TerrainPicked: " << this->TerrainPicked << "\n";
  os << indent << "GridPosition: " << this->GridPosition[0] << ", " << this->GridPosition[1]
     << "\n";
  os << indent << "NumberOfScans: " << this->NumberOfScans << "\n";
}

//------------------------------------------------------------------------------
void vtkTerrainPicker::ResetPickInfo()
{
  this->Superclass::ResetPickInfo();
  this->TerrainPicked = false;
  this->GridPosition[0] = vtkMath::Nan();
  this->GridPosition[1] = vtkMath::Nan();
}

//------------------------------------------------------------------------------
double vtkTerrainPicker::IntersectActorWithLine(const double p1[3], const double p2[3], double t1,
  double t2, double tol, vtkProp3D* prop, vtkMapper* mapper)
{
  ShownTerrain shown;
  readMapper(mapper, shown);
  if (!shown.Heights)
  {
    return this->Superclass::IntersectActorWithLine(p1, p2, t1, t2, tol, prop, mapper);
  }
  terrain::ReferenceRay ray;
  ray.Origin = { p1[0], p1[1], p1[2] };
  ray.Direction = glm::dvec3(p2[0], p2[1], p2[2]) - ray.Origin;
  ray.Begin = t1;
  ray.End = t2;
  clipToShown(shown, ray);
  const terrain::ReferenceHit hit =
    this->Internals->CasterOf(shown.Heights, this->NumberOfScans).Cast(ray, shown.Exaggeration);
  if (!hit.Found)
  {
    return VTK_DOUBLE_MAX;
  }
  if (hit.Distance < this->GlobalTMin)
  {
    this->ResetPickInfo();
    this->TerrainPicked = true;
    this->Mapper = mapper;
    this->DataSet = shown.Heights;
    this->Texture =
      vtkActor::SafeDownCast(prop) ? vtkActor::SafeDownCast(prop)->GetTexture() : nullptr;
    const glm::dvec2 position = glm::dvec2(hit.CellX, hit.CellY) + hit.Fraction;
    this->GridPosition[0] = position.x;
    this->GridPosition[1] = position.y;
    const int* extent = shown.Heights->GetExtent();
    const double structured[3] = { extent[0] + position.x, extent[2] + position.y,
      static_cast<double>(extent[4]) };
    this->SetImageDataPickInfo(structured, extent);
    const glm::dvec3 point = shown.Geometry().ToModel(position, this->GetHeight());
    for (int axis = 0; axis < 3; ++axis)
    {
      this->MapperPosition[axis] = point[axis];
      this->MapperNormal[axis] = hit.Normal[axis];
    }
  }
  return hit.Distance;
}

//------------------------------------------------------------------------------
double vtkTerrainPicker::GetHeight() const
{
  return this->TerrainPicked ? this->Interpolate(this->DataSet->GetPointData()->GetScalars(), 0)
                             : vtkMath::Nan();
}

//------------------------------------------------------------------------------
double vtkTerrainPicker::GetValue(const std::string& arrayName, int component) const
{
  if (!this->TerrainPicked)
  {
    return vtkMath::Nan();
  }
  if (vtkDataArray* array = this->DataSet->GetPointData()->GetArray(arrayName.c_str()))
  {
    return this->Interpolate(array, component);
  }
  vtkDataArray* array = this->DataSet->GetCellData()->GetArray(arrayName.c_str());
  const bool valid = array && component >= 0 && component < array->GetNumberOfComponents() &&
    this->CellId < array->GetNumberOfTuples();
  return valid ? array->GetComponent(this->CellId, component) : vtkMath::Nan();
}

//------------------------------------------------------------------------------
double vtkTerrainPicker::Interpolate(vtkDataArray* array, int component) const
{
  auto* image = static_cast<vtkImageData*>(this->DataSet);
  if (component < 0 || component >= array->GetNumberOfComponents() ||
    array->GetNumberOfTuples() < image->GetNumberOfPoints())
  {
    return vtkMath::Nan();
  }
  const vtkIdType columns = image->GetDimensions()[0];
  const int* extent = image->GetExtent();
  const vtkIdType first = this->CellIJK[0] - extent[0] + columns * (this->CellIJK[1] - extent[2]);
  const double u = this->PCoords[0];
  const double v = this->PCoords[1];
  const auto value = [&](vtkIdType id) { return array->GetComponent(id, component); };
  const double south = mix(value(first), value(first + 1), u);
  const double north = mix(value(first + columns), value(first + columns + 1), u);
  return mix(south, north, v);
}

//------------------------------------------------------------------------------
bool vtkTerrainPicker::HasLineOfSight(vtkActor* terrain, const double from[3], const double to[3])
{
  double obstacle[3];
  return this->HasLineOfSight(terrain, from, to, obstacle);
}

//------------------------------------------------------------------------------
bool vtkTerrainPicker::HasLineOfSight(
  vtkActor* terrain, const double from[3], const double to[3], double obstacle[3])
{
  ShownTerrain shown;
  readActor(terrain, shown);
  terrain::ReferenceRay ray;
  ray.Origin = transform(shown.WorldToModel, { from[0], from[1], from[2] });
  ray.Direction = transform(shown.WorldToModel, { to[0], to[1], to[2] }) - ray.Origin;
  if (!shown.Heights || !isFinite(ray.Origin) || !isFinite(ray.Direction))
  {
    return false;
  }
  const glm::dvec2 spacing = shown.Geometry().Spacing;
  const double cells = glm::length(ray.Direction) / std::min(spacing.x, spacing.y);
  if (cells <= 2.0 * SightMargin)
  {
    return true;
  }
  ray.Begin = SightMargin / cells;
  ray.End = 1.0 - ray.Begin;
  clipToShown(shown, ray);
  const terrain::ReferenceHit hit =
    this->Internals->CasterOf(shown.Heights, this->NumberOfScans).Cast(ray, shown.Exaggeration);
  if (hit.Found)
  {
    const glm::dvec3 point =
      transform(shown.ModelToWorld, ray.Origin + hit.Distance * ray.Direction);
    std::copy(&point.x, &point.x + 3, obstacle);
  }
  return !hit.Found;
}

//------------------------------------------------------------------------------
bool vtkTerrainPicker::GetProfile(
  vtkActor* terrain, const double from[3], const double to[3], vtkPolyData* profile)
{
  profile->Initialize();
  ShownTerrain shown;
  readActor(terrain, shown);
  const glm::dvec3 start = transform(shown.WorldToModel, { from[0], from[1], from[2] });
  const glm::dvec3 end = transform(shown.WorldToModel, { to[0], to[1], to[2] });
  if (!shown.Heights || !isFinite(start) || !isFinite(end))
  {
    return false;
  }
  ProfileLines lines(shown, start, end);
  const terrain::GridGeometry geometry = shown.Geometry();
  terrain::ImageHeights::Dispatch(shown.Heights,
    [&](const auto& view)
    {
      terrain::WalkSurface(view, glm::dvec2(geometry.ToGrid(start)),
        glm::dvec2(geometry.ToGrid(end)),
        [&lines](const terrain::SurfacePiece& piece) { lines.Add(piece); });
    });
  lines.Finish(profile);
  return true;
}
