// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/globe/GlobeReference.h"

#include "core/grid/Constants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace terrain
{
namespace
{
/// Parts of a piece whose ends are looked at for a change of sign.
constexpr int kParts = 12;

/// Where a value with one minimum in an interval is least, by thirds.
template <typename Function>
double LeastAt(double low, double high, Function&& value)
{
  for (int step = 0; step < 60; ++step)
  {
    const double third = (high - low) / 3.0;
    if (value(low + third) < value(high - third))
    {
      high -= third;
    }
    else
    {
      low += third;
    }
  }
  return 0.5 * (low + high);
}

template <typename Function>
double Bisect(double low, double high, bool lowIsNegative, Function&& value)
{
  for (int step = 0; step < 60; ++step)
  {
    const double middle = 0.5 * (low + high);
    ((value(middle) < 0.0) == lowIsNegative ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// First root in [begin, end], NaN if none; nearest: least |value| where looked.
template <typename Function>
double FirstRoot(double begin, double end, double& nearest, Function&& value)
{
  std::array<double, kParts + 1> at{};
  std::array<double, kParts + 1> f{};
  for (int i = 0; i <= kParts; ++i)
  {
    const auto k = static_cast<std::size_t>(i);
    at[k] = begin + (end - begin) * i / kParts;
    f[k] = value(at[k]);
    nearest = std::min(nearest, std::abs(f[k]));
  }
  for (std::size_t i = 0; i < kParts; ++i)
  {
    const bool negative = f[i] < 0.0;
    if (f[i] == 0.0)
    {
      return at[i];
    }
    // a dip towards the surface between two looks
    const std::size_t next = std::min<std::size_t>(i + 2, kParts);
    const std::size_t last = i == 0 ? 0 : i - 1;
    const bool dips =
      std::abs(f[i]) <= std::abs(f[last]) && std::abs(f[i + 1]) <= std::abs(f[next]);
    if (dips && negative == (f[i + 1] < 0.0))
    {
      const double least =
        LeastAt(at[i], at[i + 1], [&](double t) { return negative ? -value(t) : value(t); });
      const double there = value(least);
      nearest = std::min(nearest, std::abs(there));
      if (negative != (there < 0.0))
      {
        return Bisect(at[i], least, negative, value);
      }
    }
    if (negative != (f[i + 1] < 0.0))
    {
      return Bisect(at[i], at[i + 1], negative, value);
    }
  }
  return f[kParts] == 0.0 ? at[kParts] : kNaN;
}

void AddRoots(double a, double halfB, double c, std::vector<double>& roots)
{
  if (a == 0.0)
  {
    roots.push_back(-c / (2.0 * halfB));
    return;
  }
  double discriminant = halfB * halfB - a * c;
  if (discriminant >= -1e-9 * halfB * halfB) // one cut too many does no harm
  {
    discriminant = std::max(discriminant, 0.0);
    const double q = -halfB - std::copysign(std::sqrt(discriminant), halfB);
    roots.push_back(q / a);
    roots.push_back(c / q);
  }
}
}

GlobeReference::GlobeReference(
  GlobeGrid grid, std::function<double(int, int)> heights, const GlobeRange& range)
  : Grid(std::move(grid))
  , Heights(std::move(heights))
  , Range(range)
{
}

bool GlobeReference::IsNear(const GlobeReferenceRay& ray, double begin, double end) const
{
  const glm::dvec3 from = ray.Origin + begin * ray.Direction;
  const glm::dvec3 to = ray.Origin + end * ray.Direction;
  const double nearest = std::clamp(
    -glm::dot(ray.Origin, ray.Direction) / glm::dot(ray.Direction, ray.Direction), begin, end);
  return std::max(glm::length(from), glm::length(to)) >
    this->Grid.Body.Polar + this->Range.Lowest - 1.0 &&
    glm::length(ray.Origin + nearest * ray.Direction) <
    this->Grid.Body.Equatorial + this->Range.Highest + 1.0;
}

std::vector<double> GlobeReference::Cuts(const GlobeReferenceRay& ray) const
{
  const glm::dvec3& o = ray.Origin;
  const glm::dvec3& d = ray.Direction;
  std::vector<double> cuts;
  for (int i = 0; i < this->Grid.Columns; ++i)
  {
    // the plane of a meridian holds the axis
    const double longitude = this->Grid.West + i * this->Grid.Step;
    const double c = std::cos(longitude);
    const double s = std::sin(longitude);
    cuts.push_back((o.x * s - o.y * c) / (d.y * c - d.x * s));
  }
  for (const double latitude : this->Grid.Latitudes)
  {
    // the normals of a parallel are a cone, (z - apex) cos = r sin, both sides squared
    const double s = std::sin(latitude);
    const double c = std::cos(latitude);
    const double apex = -this->Grid.Body.E2() * this->Grid.Body.PrimeVertical(s) * s;
    const double z = o.z - apex;
    AddRoots(d.z * d.z * c * c - (d.x * d.x + d.y * d.y) * s * s,
      z * d.z * c * c - (o.x * d.x + o.y * d.y) * s * s,
      z * z * c * c - (o.x * o.x + o.y * o.y) * s * s, cuts);
  }
  // the axis, where longitudes jump
  cuts.push_back(-(o.x * d.x + o.y * d.y) / (d.x * d.x + d.y * d.y));
  std::vector<double> inside{ ray.Begin, ray.End };
  std::copy_if(cuts.begin(), cuts.end(), std::back_inserter(inside),
    [&ray](double t) { return t > ray.Begin && t < ray.End; });
  std::sort(inside.begin(), inside.end());
  return inside;
}

double GlobeReference::Above(
  const glm::dvec3& position, glm::ivec2& cell, glm::dvec2& fraction, bool given) const
{
  const glm::dvec3 place = this->Grid.Body.ToPlace(position);
  double east = place.x - this->Grid.West;
  const std::vector<double>& latitudes = this->Grid.Latitudes;
  if (!given)
  {
    east -= kTurn * std::floor(east / kTurn);
    cell.x = static_cast<int>(std::floor(east / this->Grid.Step));
    // the last row holds its northern parallel, a pole perhaps
    cell.y = static_cast<int>(
      std::upper_bound(latitudes.begin(), latitudes.end() - 1, place.y) - latitudes.begin() - 1);
    cell.y = place.y > latitudes.back() ? this->Grid.Cells().y : cell.y;
  }
  if (glm::any(glm::lessThan(cell, glm::ivec2(0))) ||
    glm::any(glm::greaterThanEqual(cell, this->Grid.Cells())))
  {
    return kNaN;
  }
  const double middle = (cell.x + 0.5) * this->Grid.Step;
  east -= kTurn * std::round((east - middle) / kTurn);
  const auto row = static_cast<std::size_t>(cell.y);
  fraction = glm::clamp(glm::dvec2(east / this->Grid.Step - cell.x,
                          (place.y - latitudes[row]) / (latitudes[row + 1] - latitudes[row])),
    0.0, 1.0);
  const double south = this->Heights(cell.x, cell.y) * (1.0 - fraction.x) +
    this->Heights(cell.x + 1, cell.y) * fraction.x;
  const double north = this->Heights(cell.x, cell.y + 1) * (1.0 - fraction.x) +
    this->Heights(cell.x + 1, cell.y + 1) * fraction.x;
  return place.z - (south * (1.0 - fraction.y) + north * fraction.y);
}

GlobeReferenceHit GlobeReference::Cast(const GlobeReferenceRay& ray) const
{
  GlobeReferenceHit hit;
  hit.Nearest = kInfinity;
  const std::vector<double> cuts = this->Cuts(ray);
  for (std::size_t i = 0; i + 1 < cuts.size() && !hit.Found; ++i)
  {
    const glm::dvec3 middle = ray.Origin + 0.5 * (cuts[i] + cuts[i + 1]) * ray.Direction;
    if (!this->IsNear(ray, cuts[i], cuts[i + 1]) ||
      std::isnan(this->Above(middle, hit.Cell, hit.Fraction, false)))
    {
      continue;
    }
    double nearest = kInfinity;
    hit.T = FirstRoot(cuts[i], cuts[i + 1], nearest,
      [this, &ray, &hit](double t)
      { return this->Above(ray.Origin + t * ray.Direction, hit.Cell, hit.Fraction, true); });
    hit.Found = !std::isnan(hit.T);
    hit.Nearest = std::min(hit.Nearest, nearest);
    if (hit.Found)
    {
      this->Above(ray.Origin + hit.T * ray.Direction, hit.Cell, hit.Fraction, true);
    }
  }
  return hit;
}
}
