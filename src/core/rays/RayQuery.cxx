// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/rays/RayQuery.h"

#include "core/grid/HeightSampling.h"
#include "core/rays/QueryCells.h"
#include "core/rays/QueryWalk.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace terrain
{
namespace
{
/// Where a ray meets the surface of a cell.
struct CellHit
{
  double Distance = kInfinity;
  glm::i64vec2 Cell{ -1, -1 };
  glm::dvec2 Fraction{ 0.0 };
  CellStretches::Meeting Meeting;
  CellStretches Stretches;
};

CellStretches StretchesOf(const CellSegment& segment, SurfaceKind kind)
{
  return kind == SurfaceKind::Columns ? CellStretches::OfColumns(segment)
                                      : CellStretches::OfPatch(segment);
}

/// Finds the first hit of a ray.
class FirstFinder
{
public:
  FirstFinder(const Surface& surface, const QueryPath& path, CellHit& hit)
    : Queried(surface)
    , Path(path)
    , Hit(hit)
  {
  }

  /// Where between two distances a ray may meet heights within bounds; false if nowhere.
  bool Meets(const HeightBounds& bounds, double& begin, double end) const
  {
    const HeightBounds ray = this->Path.HeightsBetween(begin, end);
    if (ray.Low > bounds.High + this->Path.Slack || ray.High < bounds.Low - this->Path.Slack)
    {
      return false;
    }
    if (this->Path.Bend == 0.0 && this->Path.Direction.z != 0.0)
    {
      const bool falls = this->Path.Direction.z < 0.0;
      const double bound = falls ? bounds.High + this->Path.Slack : bounds.Low - this->Path.Slack;
      begin = std::clamp(bound / this->Path.Direction.z, begin, end);
    }
    return true;
  }

  /// True if the search ends in this cell.
  bool VisitCell(const glm::i64vec2& cell, const CellSegment& segment, double begin, double end)
  {
    const double side = begin == this->SideDistance ? this->Side : 0.0;
    this->SideDistance = kNaN;
    if (!HasSurface(segment.Corners))
    {
      return false;
    }
    const CellStretches stretches = StretchesOf(segment, this->Queried.Kind);
    const CellStretches::Meeting meeting = stretches.First(side);
    if (meeting.Stretch < 0)
    {
      this->Side = stretches.Stretches[static_cast<std::size_t>(stretches.Count) - 1].E;
      this->SideDistance = end;
      return false;
    }
    const double distance = begin + meeting.U * (end - begin);
    if (distance < this->Hit.Distance)
    {
      this->Hit = { distance, cell, segment.PositionAt(meeting.U), meeting, stretches };
    }
    return true;
  }

private:
  const Surface& Queried;
  const QueryPath& Path;
  CellHit& Hit;
  /// Height above the surface at a distance: where the last cell ended.
  double Side = 0.0;
  double SideDistance = kNaN;
};

/// Finds where the surface is highest above a ray.
class SummitFinder
{
public:
  SummitFinder(const Surface& surface, const QueryPath& path, SurfaceSummit& summit)
    : Queried(surface)
    , Path(path)
    , Summit(summit)
  {
  }

  bool Meets(const HeightBounds& bounds, double& begin, double end) const
  {
    return bounds.High - this->Path.HeightsBetween(begin, end).Low + this->Path.Slack >
      this->Summit.Height;
  }

  bool VisitCell(const glm::i64vec2&, const CellSegment& segment, double begin, double end)
  {
    if (HasSurface(segment.Corners))
    {
      const Highest here = StretchesOf(segment, this->Queried.Kind).Summit();
      if (here.Value > this->Summit.Height)
      {
        this->Summit = { here.Value, begin + here.Parameter * (end - begin) };
      }
    }
    return false;
  }

private:
  const Surface& Queried;
  const QueryPath& Path;
  SurfaceSummit& Summit;
};

/// Walks a part of a ray over the grid; where it runs along a line between cells, on both sides.
template <typename Finder, typename Result>
void WalkBothSides(
  const Surface& surface, const GridQuery& ray, double begin, double end, Result& result)
{
  if (!ClipToGrid(ray, surface.Heights->CellCount(), begin, end))
  {
    return;
  }
  const std::array<int, 2> sides{ RunsAlongLine(ray, 0) ? 2 : 1, RunsAlongLine(ray, 1) ? 2 : 1 };
  for (int side = 0; side < sides[0] * sides[1]; ++side)
  {
    const QueryPath path(
      *surface.Heights, ray, begin, end, { side % sides[0] == 1, side / sides[0] == 1 });
    Finder finder(surface, path, result);
    WalkCells(*surface.Heights, path, finder);
  }
}

/// The first hit on a part of a ray; Cell.x < 0 if there is none.
CellHit FindFirst(const Surface& surface, const GridQuery& ray, const KeptPart& part)
{
  CellHit hit;
  double begin = part.Begin;
  double end = part.End;
  if (ClipToHeights(ray, surface.Heights->Bounds(), begin, end))
  {
    WalkBothSides<FirstFinder>(surface, ray, begin, end, hit);
  }
  return hit;
}

/// The cell that a ray goes on in from a distance, and the position in it; false if there is none
/// with a surface.
bool FindCellAhead(const Surface& surface, const GridQuery& ray, double distance,
  glm::i64vec2& cell, glm::dvec2& fraction)
{
  const glm::dvec2 position(ray.At(distance));
  const glm::i64vec2 last = surface.Heights->CellCount() - std::int64_t{ 1 };
  for (int axis = 0; axis < 2; ++axis)
  {
    const double at = position[axis];
    const double line = std::round(at);
    const bool onLine = std::abs(at - line) <= kSamplingSlack;
    const double ahead = onLine ? (ray.Direction[axis] < 0.0 ? line - 1.0 : line) : std::floor(at);
    if (at < -kSamplingSlack || at > static_cast<double>(last[axis] + 1) + kSamplingSlack)
    {
      return false;
    }
    cell[axis] = std::clamp<std::int64_t>(static_cast<std::int64_t>(ahead), 0, last[axis]);
    fraction[axis] = std::clamp(at - static_cast<double>(cell[axis]), 0.0, 1.0);
  }
  return HasSurface(surface.Heights->CellHeights(cell));
}

/// Height of the surface in a cell.
double SurfaceHeightIn(const Surface& surface, const glm::i64vec2& cell, const glm::dvec2& fraction)
{
  const glm::dvec4 corners = surface.Heights->CellHeights(cell);
  return surface.Kind == SurfaceKind::Columns
    ? corners[(fraction.x >= 0.5 ? 1 : 0) + (fraction.y >= 0.5 ? 2 : 0)]
    : PatchHeight(corners, fraction);
}

/// The wall of a block at which a part of a ray begins, if it begins below the surface.
bool FindWall(const Surface& surface, const GridQuery& ray, const KeptPart& part, SurfaceHit& hit)
{
  if (!surface.Block || part.Wall < 0 ||
    !FindCellAhead(surface, ray, part.Begin, hit.Cell, hit.Fraction))
  {
    return false;
  }
  const double height = ray.At(part.Begin).z;
  if (!(height <= SurfaceHeightIn(surface, hit.Cell, hit.Fraction)))
  {
    return false;
  }
  hit.Found = true;
  hit.Distance = part.Begin;
  hit.Height = height;
  hit.Wall = part.Wall;
  hit.Normal = -glm::normalize(
    surface.Frame.NormalToModel(glm::dvec3(surface.Planes[static_cast<std::size_t>(part.Wall)])));
  return true;
}

/// Normal and height of a hit of the surface itself.
SurfaceHit CompleteHit(const Surface& surface, const GridQuery& ray, const CellHit& found)
{
  SurfaceHit hit;
  hit.Found = true;
  hit.Distance = found.Distance;
  hit.Cell = found.Cell;
  hit.Fraction = glm::clamp(found.Fraction, glm::dvec2(0.0), glm::dvec2(1.0));
  const glm::dvec4 corners = surface.Heights->CellHeights(found.Cell);
  glm::dvec3 direction = ray.Direction;
  direction.z += 2.0 * ray.Bend * found.Distance;
  if (surface.Kind == SurfaceKind::Bilinear)
  {
    const glm::dvec2 slopes = PatchSlopes(corners, hit.Fraction);
    hit.Height = PatchHeight(corners, hit.Fraction);
    hit.Normal = glm::normalize(surface.Frame.NormalToModel(glm::dvec3(-slopes, 1.0)));
    hit.FromAbove = direction.z <= glm::dot(slopes, glm::dvec2(direction));
    return hit;
  }
  hit.Height = ray.At(found.Distance).z;
  hit.FromAbove = direction.z <= 0.0;
  if (found.Meeting.Wall)
  {
    const auto after = static_cast<std::size_t>(found.Meeting.Stretch);
    const int axis = found.Stretches.WallAxes[after - 1];
    // the ray comes from above the lower column, or out of the higher one
    hit.FromAbove = found.Stretches.Stretches[after - 1].E > 0.0;
    const double along = direction[axis] < 0.0 ? -1.0 : 1.0;
    hit.Normal = glm::dvec3(0.0);
    hit.Normal[axis] = hit.FromAbove ? -along : along;
  }
  return hit;
}

/// Calls visit for the stretches of a piece of a way over the columns of one cell.
void VisitColumns(const SurfaceHeights& heights, const glm::dvec2& from, const glm::dvec2& way,
  const SurfacePiece& piece, const std::function<void(const SurfacePiece&)>& visit)
{
  const glm::dvec2 middle = from + 0.5 * (piece.Begin + piece.End) * way;
  const glm::i64vec2 cell = glm::clamp(
    glm::i64vec2(glm::floor(middle)), glm::i64vec2(0), heights.CellCount() - std::int64_t{ 1 });
  const glm::dvec4 corners = heights.CellHeights(cell);
  std::array<double, 4> stops{ piece.Begin, piece.End, piece.End, piece.End };
  for (int axis = 0; axis < 2; ++axis)
  {
    const double wall = (static_cast<double>(cell[axis]) + 0.5 - from[axis]) / way[axis];
    if (wall > piece.Begin && wall < piece.End)
    {
      stops[static_cast<std::size_t>(axis) + 1] = wall;
    }
  }
  std::sort(stops.begin(), stops.end());
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (stops[i] < stops[i + 1] || (i == 0 && stops[0] == stops[3]))
    {
      const glm::dvec2 at =
        from + 0.5 * (stops[i] + stops[i + 1]) * way - glm::dvec2(cell) - glm::dvec2(0.5);
      SurfacePiece column;
      column.Begin = stops[i];
      column.End = stops[i + 1];
      column.HasSurface = true;
      column.Constant = corners[(at.x >= 0.0 ? 1 : 0) + (at.y >= 0.0 ? 2 : 0)];
      visit(column);
    }
  }
}

/// The heights as core/rays/SurfacePath.h and core/grid/HeightSampling.h read them.
struct SamplesOf
{
  const SurfaceHeights& Heights;
  std::int64_t Width;
  std::int64_t Height;

  explicit SamplesOf(const SurfaceHeights& heights)
    : Heights(heights)
    , Width(heights.CellCount().x + 1)
    , Height(heights.CellCount().y + 1)
  {
  }
  double At(std::int64_t i, std::int64_t j) const
  {
    return this->Heights.SampleHeight({ i, j });
  }
  bool IsCellValid(std::int64_t i, std::int64_t j) const
  {
    return HasSurface(this->Heights.CellHeights({ i, j }));
  }
};
}

//------------------------------------------------------------------------------
RayQuery::RayQuery(Surface surface)
  : Queried(std::move(surface))
{
}

//------------------------------------------------------------------------------
SurfaceHit RayQuery::First(const QueryRay& ray) const
{
  const GridQuery query(this->Queried.Frame, ray);
  if (!this->Queried.HasCells() || !query.IsUsable())
  {
    return {};
  }
  for (const KeptPart& part : CutByPlanes(query, this->Queried.Planes))
  {
    SurfaceHit wall;
    if (FindWall(this->Queried, query, part, wall))
    {
      return wall;
    }
    const CellHit found = FindFirst(this->Queried, query, part);
    if (found.Cell.x >= 0)
    {
      return CompleteHit(this->Queried, query, found);
    }
  }
  return {};
}

//------------------------------------------------------------------------------
bool RayQuery::Any(const QueryRay& ray) const
{
  return this->First(ray).Found;
}

//------------------------------------------------------------------------------
SurfaceSummit RayQuery::Highest(const QueryRay& ray) const
{
  SurfaceSummit summit;
  const GridQuery query(this->Queried.Frame, ray);
  if (this->Queried.HasCells() && query.IsUsable())
  {
    WalkBothSides<SummitFinder>(this->Queried, query, query.Begin, query.End, summit);
  }
  return summit;
}

//------------------------------------------------------------------------------
bool RayQuery::Along(const glm::dvec3& from, const glm::dvec3& to,
  const std::function<void(const SurfacePiece&)>& visit) const
{
  const glm::dvec2 begin(this->Queried.Frame.ToGrid(from));
  const glm::dvec2 end(this->Queried.Frame.ToGrid(to));
  if (!std::isfinite(begin.x + begin.y + end.x + end.y))
  {
    return false;
  }
  if (this->Queried.HasCells())
  {
    const SurfaceHeights& heights = *this->Queried.Heights;
    WalkSurface(SamplesOf(heights), begin, end,
      [&](const SurfacePiece& piece)
      {
        if (piece.HasSurface && this->Queried.Kind == SurfaceKind::Columns)
        {
          VisitColumns(heights, begin, end - begin, piece, visit);
        }
        else
        {
          visit(piece);
        }
      });
  }
  else
  {
    visit(SurfacePiece{});
  }
  return true;
}

//------------------------------------------------------------------------------
double RayQuery::HeightAt(double x, double y) const
{
  const glm::dvec3 position = this->Queried.Frame.ToGrid({ x, y, 0.0 });
  if (!this->Queried.HasCells())
  {
    return kNaN;
  }
  const SamplesOf samples(*this->Queried.Heights);
  const double height = SampleBilinear(samples, position.x, position.y);
  return std::isnan(height) || this->Queried.Kind == SurfaceKind::Bilinear
    ? height
    : samples.At(std::clamp<std::int64_t>(std::llround(position.x), 0, samples.Width - 1),
        std::clamp<std::int64_t>(std::llround(position.y), 0, samples.Height - 1));
}
}
