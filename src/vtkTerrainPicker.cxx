// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainPicker.h"

#include "data/GlobeSurface.h"
#include "data/ImageHeights.h"
#include "data/ImageSurface.h"
#include "parts/AssemblyPart.h"
#include "render/SurfaceScope.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkTerrainActor.h"

#include "core/rays/RayQuery.h"
#include "core/surface/Cutting.h"

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
/// A terrain as an actor shows it.
struct ShownTerrain
{
  /// Null if the actor shows no terrain.
  vtkImageData* Heights = nullptr;
  /// Cells of the surface along a cell of the heights.
  int CellsPerCell = 1;
  terrain::Surface Surface;
  vtkNew<vtkMatrix4x4> ModelToWorld;
  vtkNew<vtkMatrix4x4> WorldToModel;
};

/// The surfaces of all images of heights that were asked for, as long as the images are there.
class KnownSurfaces
{
public:
  /// The surface of an image, scanned if need be; counts scans.
  terrain::ImageSurface& Of(vtkImageData* image, int& scans)
  {
    this->Surfaces.remove_if(
      [](const terrain::ImageSurface& surface) { return surface.GetImage() == nullptr; });
    auto found = std::find_if(this->Surfaces.begin(), this->Surfaces.end(),
      [image](const terrain::ImageSurface& surface) { return surface.GetImage() == image; });
    if (found == this->Surfaces.end())
    {
      this->Surfaces.emplace_back();
      found = std::prev(this->Surfaces.end());
    }
    scans += found->SetImage(image) ? 1 : 0;
    return *found;
  }

private:
  std::list<terrain::ImageSurface> Surfaces;
};

/// What a mapper cuts away of its surface: all but the drawn rectangle and the block below it, and
/// what clipping planes cut off.
void ReadPlanes(vtkOpenGLTerrainMapper* mapper, vtkMatrix4x4* modelToWorld, ShownTerrain& shown)
{
  terrain::Surface& surface = shown.Surface;
  const double* bounds = mapper->GetBounds();
  terrain::GridGeometry heights = surface.Frame;
  heights.Spacing *= static_cast<double>(shown.CellsPerCell);
  terrain::Cutting cutting;
  cutting.Extracts = true;
  cutting.First = glm::ivec2(glm::round(glm::dvec2(heights.ToGrid({ bounds[0], bounds[2], 0.0 }))));
  cutting.Last = glm::ivec2(glm::round(glm::dvec2(heights.ToGrid({ bounds[1], bounds[3], 0.0 }))));
  cutting.Block = surface.Block;
  const glm::ivec2 size(surface.Heights->CellCount() + std::int64_t{ 1 });
  surface.Planes =
    cutting.PlanesGC(cutting.Drawn(size, shown.CellsPerCell), mapper->GetBlockBase());
  for (int i = 0; i < mapper->GetNumberOfClippingPlanes(); ++i)
  {
    double plane[4];
    mapper->GetClippingPlaneInDataCoords(modelToWorld, i, plane);
    surface.Planes.push_back(surface.Frame.PlaneToGrid({ plane[0], plane[1], plane[2], plane[3] }));
  }
}

/// The terrain of a mapper and of its actor's matrix.
void ReadMapper(vtkMapper* anyMapper, vtkMatrix4x4* modelToWorld, KnownSurfaces& known, int& scans,
  ShownTerrain& shown)
{
  auto* mapper = vtkOpenGLTerrainMapper::SafeDownCast(anyMapper);
  vtkImageData* heights = mapper ? mapper->GetHeights() : nullptr;
  if (!terrain::ImageHeights::WhyNotHeights(heights).empty())
  {
    return;
  }
  shown.Heights = heights;
  const auto technique = mapper->GetTechnique();
  const bool rays = technique != vtkTerrainLook::Techniques::Mesh &&
    technique != vtkTerrainLook::Techniques::Strips;
  const bool all = mapper->GetTechnique() == vtkOpenGLTerrainMapper::Techniques::Pyramid;
  vtkImageData* detail = rays ? mapper->GetDetail() : nullptr;
  terrain::ImageSurface& surface = known.Of(heights, scans);
  surface.SetDetail(detail);
  shown.CellsPerCell = detail ? mapper->GetDetailCells() : 1;
  shown.Surface = surface.GetDetailedSurface(
    mapper->GetVerticalExaggeration(), shown.CellsPerCell, mapper->GetDetailScale());
  shown.Surface.Kind = all && mapper->GetSurface() == vtkOpenGLTerrainMapper::Surfaces::Columns
    ? terrain::SurfaceKind::Columns
    : terrain::SurfaceKind::Bilinear;
  shown.Surface.Block = all && mapper->GetBlock();
  if (shown.Surface.HasCells())
  {
    ReadPlanes(mapper, modelToWorld, shown);
  }
  shown.ModelToWorld->DeepCopy(modelToWorld);
  vtkMatrix4x4::Invert(shown.ModelToWorld, shown.WorldToModel);
}

/// The terrain of an actor, up to date.
void ReadActor(vtkActor* actor, KnownSurfaces& known, int& scans, ShownTerrain& shown)
{
  if (actor && actor->GetMapper())
  {
    actor->GetMapper()->GetBounds(); // brings the heights up to date
    ReadMapper(actor->GetMapper(), actor->GetMatrix(), known, scans, shown);
  }
}

glm::dvec3 Transformed(vtkMatrix4x4* matrix, const glm::dvec3& point)
{
  const double in[4] = { point.x, point.y, point.z, 1.0 };
  std::array<double, 4> out{};
  matrix->MultiplyPoint(in, out.data());
  return glm::dvec3(out[0], out[1], out[2]) / out[3];
}

bool IsFinite(const glm::dvec3& point)
{
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

/// Linear between a and b; neither counts where its weight is 0, for it may be NaN.
double Mix(double a, double b, double t)
{
  if (t <= 0.0)
  {
    return a;
  }
  return t >= 1.0 ? b : (1.0 - t) * a + t * b;
}

/// Collects a profile.
class ProfileLines
{
public:
  ProfileLines(const ShownTerrain& shown, const glm::dvec3& from, const glm::dvec3& to)
    : Shown(shown)
    , Geometry(shown.Surface.Frame)
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
    const double begin = piece.HeightAt(piece.Begin);
    const bool jumps = std::abs(begin - this->EndHeight) > 1e-9 * (1.0 + std::abs(begin));
    if (this->Line.empty() || jumps)
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
    const glm::dvec3 point = Transformed(this->Shown.ModelToWorld,
      { along.x, along.y, this->Geometry.ToModel({ 0.0, 0.0 }, height).z });
    this->EndHeight = height;
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
  /// Of the last point.
  double EndHeight = 0.0;
};
}

//------------------------------------------------------------------------------
class vtkTerrainPicker::vtkInternals
{
public:
  KnownSurfaces Surfaces;
  /// Of the last image on a globe that was asked for.
  terrain::GlobeSurface Globe;

  /// The surface of a mapper's heights on a globe, null if they lie on none; counts scans.
  const terrain::GlobeSurface* GlobeOf(vtkMapper* anyMapper, int& scans)
  {
    auto* mapper = vtkOpenGLTerrainMapper::SafeDownCast(anyMapper);
    vtkImageData* heights = mapper ? mapper->GetHeights() : nullptr;
    const bool isOther = this->Globe.GetImage() != heights;
    if (!this->Globe.SetImage(heights))
    {
      return nullptr;
    }
    scans += isOther ? 1 : 0;
    return &this->Globe;
  }
};

//------------------------------------------------------------------------------
vtkTerrainPicker::vtkTerrainPicker()
  : GridPosition{ vtkMath::Nan(), vtkMath::Nan() }
  , Height(vtkMath::Nan())
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
  os << indent << "Height: " << this->Height << "\n";
  os << indent << "NumberOfScans: " << this->NumberOfScans << "\n";
}

//------------------------------------------------------------------------------
void vtkTerrainPicker::ResetPickInfo()
{
  this->Superclass::ResetPickInfo();
  this->TerrainPicked = false;
  this->Height = vtkMath::Nan();
  this->GridPosition[0] = vtkMath::Nan();
  this->GridPosition[1] = vtkMath::Nan();
}

//------------------------------------------------------------------------------
int vtkTerrainPicker::Pick3DInternal(vtkRenderer* renderer, double p1World[4], double p2World[4])
{
  const terrain::SurfaceScope scope; // rays ask the terrain itself
  return this->Superclass::Pick3DInternal(renderer, p1World, p2World);
}

//------------------------------------------------------------------------------
double vtkTerrainPicker::IntersectActorWithLine(const double p1[3], const double p2[3], double t1,
  double t2, double tol, vtkProp3D* prop, vtkMapper* mapper)
{
  if (auto* part = terrain::AssemblyPart::SafeDownCast(prop))
  {
    vtkTerrainActor* drawn = part->GetTerrain();
    return this->IntersectActorWithLine(p1, p2, t1, t2, tol, drawn, drawn->GetTerrainMapper());
  }
  if (const auto* globe = this->Internals->GlobeOf(mapper, this->NumberOfScans))
  {
    return this->PickGlobe(*globe, p1, p2, prop, mapper);
  }
  ShownTerrain shown;
  ReadMapper(mapper, prop->GetMatrix(), this->Internals->Surfaces, this->NumberOfScans, shown);
  if (!shown.Heights)
  {
    return this->Superclass::IntersectActorWithLine(p1, p2, t1, t2, tol, prop, mapper);
  }
  // All of the line: the surface knows the clipping planes, which show the inside of a block.
  terrain::QueryRay ray;
  ray.Origin = { p1[0], p1[1], p1[2] };
  ray.Direction = glm::dvec3(p2[0], p2[1], p2[2]) - ray.Origin;
  ray.End = 1.0;
  const terrain::SurfaceHit hit = terrain::RayQuery(shown.Surface).First(ray);
  if (!hit.Found)
  {
    return VTK_DOUBLE_MAX;
  }
  if (hit.Distance < this->GlobalTMin)
  {
    const glm::dvec2 positionGC = glm::dvec2(hit.Cell) + hit.Fraction;
    const glm::dvec2 position = positionGC / static_cast<double>(shown.CellsPerCell);
    const glm::dvec3 point = shown.Surface.Frame.ToModel(positionGC, hit.Height);
    this->SetPick(prop, mapper, shown.Heights, &position.x, hit.Height, &point.x, &hit.Normal[0]);
  }
  return hit.Distance;
}

//------------------------------------------------------------------------------
void vtkTerrainPicker::SetPick(vtkProp3D* prop, vtkMapper* mapper, vtkImageData* heights,
  const double position[2], double height, const double point[3], const double normal[3])
{
  this->ResetPickInfo();
  this->TerrainPicked = true;
  this->Mapper = mapper;
  this->DataSet = heights;
  this->Texture =
    vtkActor::SafeDownCast(prop) ? vtkActor::SafeDownCast(prop)->GetTexture() : nullptr;
  this->Height = height;
  std::copy(position, position + 2, this->GridPosition);
  const int* extent = heights->GetExtent();
  const double structured[3] = { extent[0] + position[0],
    terrain::ImageHeights::AreRowsFromNorth(heights) ? extent[3] - position[1]
                                                     : extent[2] + position[1],
    static_cast<double>(extent[4]) };
  this->SetImageDataPickInfo(structured, extent);
  std::copy(point, point + 3, this->MapperPosition);
  std::copy(normal, normal + 3, this->MapperNormal);
}

//------------------------------------------------------------------------------
double vtkTerrainPicker::PickGlobe(const terrain::GlobeSurface& globe, const double p1[3],
  const double p2[3], vtkProp3D* prop, vtkMapper* mapper)
{
  const double exaggeration =
    static_cast<vtkOpenGLTerrainMapper*>(mapper)->GetVerticalExaggeration();
  const glm::dvec3 origin(p1[0], p1[1], p1[2]);
  const auto hit =
    globe.TraceSeen(origin, glm::dvec3(p2[0], p2[1], p2[2]) - origin, 0.0, 1.0, exaggeration);
  if (!hit.Found)
  {
    return VTK_DOUBLE_MAX;
  }
  if (hit.T < this->GlobalTMin)
  {
    glm::dvec3 normal;
    const glm::dvec3 point = globe.PositionAt(hit.Cell, hit.Fraction, exaggeration, normal);
    const glm::dvec2 position = glm::dvec2(hit.Cell) + hit.Fraction;
    this->SetPick(prop, mapper, globe.GetImage(), &position.x,
      terrain::DrawnOnGlobe(exaggeration).RiseToHeights(globe.GetGrid().Body.ToPlace(point).z),
      &point.x, &normal.x);
  }
  return hit.T;
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
  const double south = Mix(value(first), value(first + 1), u);
  const double north = Mix(value(first + columns), value(first + columns + 1), u);
  return Mix(south, north, v);
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
  const auto* globe =
    terrain ? this->Internals->GlobeOf(terrain->GetMapper(), this->NumberOfScans) : nullptr;
  if (globe)
  {
    return this->SeesOnGlobe(*globe, terrain, from, to, obstacle);
  }
  ShownTerrain shown;
  ReadActor(terrain, this->Internals->Surfaces, this->NumberOfScans, shown);
  terrain::QueryRay ray;
  ray.Origin = Transformed(shown.WorldToModel, { from[0], from[1], from[2] });
  ray.Direction = Transformed(shown.WorldToModel, { to[0], to[1], to[2] }) - ray.Origin;
  if (!shown.Heights || !IsFinite(ray.Origin) || !IsFinite(ray.Direction))
  {
    return false;
  }
  const glm::dvec2 spacing = shown.Surface.Frame.Spacing * static_cast<double>(shown.CellsPerCell);
  const double cells = glm::length(ray.Direction) / std::min(spacing.x, spacing.y);
  if (cells <= 2.0 * SightMargin)
  {
    return true;
  }
  ray.Begin = SightMargin / cells;
  ray.End = 1.0 - ray.Begin;
  const terrain::SurfaceHit hit = terrain::RayQuery(shown.Surface).First(ray);
  if (hit.Found)
  {
    const glm::dvec3 point =
      Transformed(shown.ModelToWorld, ray.Origin + hit.Distance * ray.Direction);
    std::copy(&point.x, &point.x + 3, obstacle);
  }
  return !hit.Found;
}

//------------------------------------------------------------------------------
// As on a plane: the margins are in cells at the equator.
bool vtkTerrainPicker::SeesOnGlobe(const terrain::GlobeSurface& globe, vtkActor* terrain,
  const double from[3], const double to[3], double obstacle[3])
{
  vtkNew<vtkMatrix4x4> toModel;
  vtkMatrix4x4::Invert(terrain->GetMatrix(), toModel);
  const glm::dvec3 origin = Transformed(toModel, { from[0], from[1], from[2] });
  const glm::dvec3 direction = Transformed(toModel, { to[0], to[1], to[2] }) - origin;
  const double length = glm::length(direction);
  const double margin =
    SightMargin * globe.GetGrid().Step * globe.GetGrid().Body.Equatorial / length;
  if (!IsFinite(origin) || !IsFinite(direction) || !(2.0 * margin < 1.0))
  {
    return IsFinite(origin) && IsFinite(direction);
  }
  const auto hit = globe.Trace(origin, direction, margin, 1.0 - margin,
    static_cast<vtkOpenGLTerrainMapper*>(terrain->GetMapper())->GetVerticalExaggeration());
  if (hit.Found)
  {
    const glm::dvec3 point = Transformed(terrain->GetMatrix(), origin + hit.T * direction);
    std::copy(&point.x, &point.x + 3, obstacle);
  }
  return !hit.Found;
}

//------------------------------------------------------------------------------
bool vtkTerrainPicker::GetProfile(
  vtkActor* terrain, const double from[3], const double to[3], vtkPolyData* profile)
{
  profile->Initialize();
  if (terrain && this->Internals->GlobeOf(terrain->GetMapper(), this->NumberOfScans))
  {
    vtkErrorMacro("A line between two points runs below a globe: take the profile of "
                  "vtkTerrainViewpoint, along a geodesic");
    return false;
  }
  ShownTerrain shown;
  ReadActor(terrain, this->Internals->Surfaces, this->NumberOfScans, shown);
  const glm::dvec3 start = Transformed(shown.WorldToModel, { from[0], from[1], from[2] });
  const glm::dvec3 end = Transformed(shown.WorldToModel, { to[0], to[1], to[2] });
  if (!shown.Heights || !IsFinite(start) || !IsFinite(end))
  {
    return false;
  }
  ProfileLines lines(shown, start, end);
  terrain::RayQuery(shown.Surface)
    .Along(start, end, [&lines](const terrain::SurfacePiece& piece) { lines.Add(piece); });
  lines.Finish(profile);
  return true;
}
