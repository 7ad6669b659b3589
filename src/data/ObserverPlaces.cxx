// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "data/ObserverPlaces.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace terrain
{
namespace
{
class PlaceFinder
{
public:
  PlaceFinder(vtkPointSet* observers, const GridGeometry& frame, double spacing)
    : Observers(observers)
    , Frame(frame)
    , Step(spacing > 0.0 ? spacing / frame.Spacing : glm::dvec2(1.0))
  {
  }

  ObserverPlaces Find()
  {
    const std::vector<bool> areCorners = this->FindCorners();
    for (vtkIdType i = 0; i < this->Observers->GetNumberOfPoints(); ++i)
    {
      const glm::dvec2 place = this->ToGrid(i);
      // what is not finite stays, to be refused
      if (!areCorners[static_cast<std::size_t>(i)] || !std::isfinite(place.x + place.y))
      {
        this->Found.Fixed.push_back(place);
      }
    }
    if (auto* poly = vtkPolyData::SafeDownCast(this->Observers))
    {
      this->ForEach(poly->GetLines(), [this](const auto& corners) { this->AddLine(corners); });
      this->ForEach(poly->GetPolys(), [this](const auto& corners) { this->AddArea(corners); });
    }
    return this->Found;
  }

private:
  /// For each point whether it is a corner of polygons, and of no line or vertex.
  std::vector<bool> FindCorners() const
  {
    std::vector<bool> corners(static_cast<std::size_t>(this->Observers->GetNumberOfPoints()));
    const auto mark = [&corners](vtkCellArray* cells, bool value)
    {
      auto cell = vtk::TakeSmartPointer(cells->NewIterator());
      for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
      {
        vtkIdType count = 0;
        const vtkIdType* ids = nullptr;
        cell->GetCurrentCell(count, ids);
        for (vtkIdType k = 0; k < count; ++k)
        {
          corners[static_cast<std::size_t>(ids[k])] = value;
        }
      }
    };
    if (auto* poly = vtkPolyData::SafeDownCast(this->Observers))
    {
      mark(poly->GetPolys(), true);
      mark(poly->GetLines(), false);
      mark(poly->GetVerts(), false);
    }
    return corners;
  }

  glm::dvec2 ToGrid(vtkIdType point) const
  {
    double p[3];
    this->Observers->GetPoint(point, p);
    const glm::dvec3 place = this->Frame.ToGrid({ p[0], p[1], p[2] });
    return { place.x, place.y };
  }

  template <typename Visit>
  void ForEach(vtkCellArray* cells, const Visit& visit)
  {
    auto cell = vtk::TakeSmartPointer(cells->NewIterator());
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      cell->GetCurrentCell(count, ids);
      std::vector<glm::dvec2> corners;
      corners.reserve(static_cast<std::size_t>(count));
      bool finite = count > 0;
      for (vtkIdType k = 0; k < count; ++k)
      {
        corners.push_back(this->ToGrid(ids[k]));
        finite = finite && std::isfinite(corners.back().x + corners.back().y);
      }
      if (finite) // if not, the point itself is refused
      {
        visit(corners);
      }
    }
  }

  bool HasRoomFor(double count)
  {
    const auto size = static_cast<double>(this->Found.Fixed.size() + this->Found.Optional.size());
    this->Found.TooMany = this->Found.TooMany || size + count > ObserverPlaces::Most;
    return !this->Found.TooMany;
  }

  void AddLine(const std::vector<glm::dvec2>& corners)
  {
    for (std::size_t k = 1; k < corners.size(); ++k)
    {
      const glm::dvec2 way = corners[k] - corners[k - 1];
      const glm::dvec2 steps = glm::abs(way) / this->Step;
      const double parts = std::ceil(std::max(steps.x, steps.y));
      if (!this->HasRoomFor(parts))
      {
        return;
      }
      for (double part = 1.0; part < parts; part += 1.0)
      {
        this->Found.Fixed.push_back(corners[k - 1] + way * (part / parts));
      }
    }
  }

  void AddArea(const std::vector<glm::dvec2>& corners)
  {
    glm::dvec2 low(corners.front());
    glm::dvec2 high(corners.front());
    for (const glm::dvec2& corner : corners)
    {
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
    constexpr double kFarthest = 0x1p52; // where doubles cannot be counted up by one
    const glm::dvec2 reach = glm::max(glm::abs(low), glm::abs(high)) / this->Step;
    if (std::max(reach.x, reach.y) > kFarthest) // away from any heights, where none can stand
    {
      return;
    }
    const glm::dvec2 first = glm::ceil(low / this->Step);
    const glm::dvec2 last = glm::floor(high / this->Step);
    const glm::dvec2 size = glm::max(last - first + 1.0, glm::dvec2(0.0));
    if (size.x < 1.0 || size.y < 1.0 || !this->HasRoomFor(size.x * size.y))
    {
      return;
    }
    std::vector<double> crossings;
    for (double row = first.y; row <= last.y; row += 1.0)
    {
      const double y = row * this->Step.y;
      crossings.clear();
      for (std::size_t k = 0; k < corners.size(); ++k)
      {
        const glm::dvec2& a = corners[k];
        const glm::dvec2& b = corners[(k + 1) % corners.size()];
        if ((a.y <= y) != (b.y <= y))
        {
          crossings.push_back(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
        }
      }
      std::sort(crossings.begin(), crossings.end());
      for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
      {
        for (double x = std::ceil(crossings[k] / this->Step.x) * this->Step.x;
             x <= crossings[k + 1]; x += this->Step.x)
        {
          this->Found.Optional.emplace_back(x, y);
        }
      }
    }
  }

  vtkPointSet* Observers;
  const GridGeometry& Frame;
  glm::dvec2 Step; ///< in cells
  ObserverPlaces Found;
};
}

//------------------------------------------------------------------------------
ObserverPlaces FindObserverPlaces(vtkPointSet* observers, const GridGeometry& frame, double spacing)
{
  return PlaceFinder(observers, frame, spacing).Find();
}
}
