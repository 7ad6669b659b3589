// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/GreedyTile.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace terrain
{
namespace
{
/// Twice the signed area of a, b, c: > 0 if they are counter-clockwise.
std::int64_t Orientation(const glm::ivec2& a, const glm::ivec2& b, const glm::ivec2& c)
{
  return static_cast<std::int64_t>(b.x - a.x) * (c.y - a.y) -
    static_cast<std::int64_t>(b.y - a.y) * (c.x - a.x);
}

/// > 0 if d lies inside of the circle through a, b, c, which are counter-clockwise; 0 if on it.
std::int64_t InCircle(
  const glm::ivec2& a, const glm::ivec2& b, const glm::ivec2& c, const glm::ivec2& d)
{
  const std::int64_t ax = a.x - d.x;
  const std::int64_t ay = a.y - d.y;
  const std::int64_t bx = b.x - d.x;
  const std::int64_t by = b.y - d.y;
  const std::int64_t cx = c.x - d.x;
  const std::int64_t cy = c.y - d.y;
  return (ax * ax + ay * ay) * (bx * cy - cx * by) - (bx * bx + by * by) * (ax * cy - cx * ay) +
    (cx * cx + cy * cy) * (ax * by - bx * ay);
}
}

//--------------------------------------------------------------------------------------------------
ErrorQueue::ErrorQueue(double tolerance)
  : Tolerance(tolerance)
{
}

int ErrorQueue::BucketOf(double error) const
{
  // exponent and upper bits of the fraction of a double in [1, infinity]
  const double ratio = std::max(error / this->Tolerance, 1.0);
  std::uint64_t bits = 0;
  std::memcpy(&bits, &ratio, sizeof(bits));
  constexpr std::uint64_t bitsOfOne = std::uint64_t{ 0x3ff } << 52;
  return static_cast<int>(std::min<std::uint64_t>((bits - bitsOfOne) >> 48, BucketCount - 1));
}

void ErrorQueue::Push(int triangle, double error)
{
  const int bucket = this->BucketOf(error);
  this->Buckets[bucket].push_back(triangle);
  this->Highest = std::max(this->Highest, bucket);
}

int ErrorQueue::Pop()
{
  while (this->Highest >= 0 && this->Buckets[this->Highest].empty())
  {
    --this->Highest;
  }
  if (this->Highest < 0)
  {
    return -1;
  }
  const int triangle = this->Buckets[this->Highest].back();
  this->Buckets[this->Highest].pop_back();
  return triangle;
}

//--------------------------------------------------------------------------------------------------
GreedyTile::GreedyTile(int width, int height, const std::vector<double>& heights)
  : Width(width)
  , Heights(heights)
  , Vertices{ { 0, 0 }, { width - 1, 0 }, { width - 1, height - 1 }, { 0, height - 1 } }
{
  this->NewTriangle();
  this->NewTriangle();
  this->SetTriangle(0, 0, 1, 2, -1, -1, 3);
  this->SetTriangle(1, 0, 2, 3, 2, -1, -1);
}

double GreedyTile::Height(int vertex) const
{
  const glm::ivec2& p = this->Vertices[vertex];
  return this->Heights[p.x + static_cast<std::size_t>(this->Width) * p.y];
}

int GreedyTile::NewTriangle()
{
  const int triangle = static_cast<int>(this->Origins.size() / 3);
  this->Origins.resize(this->Origins.size() + 3, -1);
  this->Twins.resize(this->Twins.size() + 3, -1);
  return triangle;
}

void GreedyTile::Link(int edge, int twin)
{
  this->Twins[edge] = twin;
  if (twin >= 0)
  {
    this->Twins[twin] = edge;
  }
}

void GreedyTile::SetTriangle(int triangle, int a, int b, int c, int twinAB, int twinBC, int twinCA)
{
  const int edge = 3 * triangle;
  this->Origins[edge] = a;
  this->Origins[edge + 1] = b;
  this->Origins[edge + 2] = c;
  this->Link(edge, twinAB);
  this->Link(edge + 1, twinBC);
  this->Link(edge + 2, twinCA);
  this->Changed.push_back(triangle);
}

int GreedyTile::Locate(const glm::ivec2& position) const
{
  int triangle = this->Last;
  int entered = -1;
  for (;;)
  {
    int leave = -1;
    for (int edge = 3 * triangle; edge < 3 * triangle + 3; ++edge)
    {
      // a Delaunay triangulation is never walked in circles
      if (edge != entered &&
        Orientation(this->Vertices[this->Origins[edge]], this->Vertices[this->Origins[Next(edge)]],
          position) < 0)
      {
        leave = edge;
        break;
      }
    }
    if (leave < 0)
    {
      return triangle;
    }
    entered = this->Twins[leave];
    triangle = entered / 3;
  }
}

void GreedyTile::Insert(const glm::ivec2& position)
{
  this->InsertInto(this->Locate(position), position);
}

void GreedyTile::InsertInto(int triangle, const glm::ivec2& position)
{
  int on = -1;
  for (int edge = 3 * triangle; edge < 3 * triangle + 3; ++edge)
  {
    const glm::ivec2& origin = this->Vertices[this->Origins[edge]];
    if (origin == position)
    {
      return;
    }
    if (Orientation(origin, this->Vertices[this->Origins[Next(edge)]], position) == 0)
    {
      on = edge;
    }
  }
  const int vertex = static_cast<int>(this->Vertices.size());
  this->Vertices.push_back(position);
  this->Changed.clear();
  if (on >= 0)
  {
    this->SplitEdge(on, vertex);
  }
  else
  {
    this->SplitTriangle(triangle, vertex);
  }
  this->Legalize(vertex);
  this->Last = triangle;
}

void GreedyTile::SplitTriangle(int triangle, int vertex)
{
  const int edge = 3 * triangle;
  const std::array<int, 3> corners{ this->Origins[edge], this->Origins[edge + 1],
    this->Origins[edge + 2] };
  const std::array<int, 3> twins{ this->Twins[edge], this->Twins[edge + 1], this->Twins[edge + 2] };
  const int second = this->NewTriangle();
  const int third = this->NewTriangle();
  this->SetTriangle(triangle, corners[0], corners[1], vertex, twins[0], -1, -1);
  this->SetTriangle(second, corners[1], corners[2], vertex, twins[1], -1, 3 * triangle + 1);
  this->SetTriangle(
    third, corners[2], corners[0], vertex, twins[2], 3 * triangle + 2, 3 * second + 1);
  this->Pending.insert(this->Pending.end(), { 3 * triangle, 3 * second, 3 * third });
}

void GreedyTile::SplitEdge(int edge, int vertex)
{
  // a is opposite the edge b -> c; the twin c -> b, if any, has d opposite.
  const int triangle = edge / 3;
  const int b = this->Origins[edge];
  const int c = this->Origins[Next(edge)];
  const int a = this->Origins[Previous(edge)];
  const int twinCA = this->Twins[Next(edge)];
  const int twinAB = this->Twins[Previous(edge)];
  const int twin = this->Twins[edge];
  const int second = this->NewTriangle();
  if (twin < 0)
  {
    this->SetTriangle(triangle, a, b, vertex, twinAB, -1, -1);
    this->SetTriangle(second, c, a, vertex, twinCA, 3 * triangle + 2, -1);
    this->Pending.insert(this->Pending.end(), { 3 * triangle, 3 * second });
    return;
  }
  const int other = twin / 3;
  const int d = this->Origins[Previous(twin)];
  const int twinBD = this->Twins[Next(twin)];
  const int twinDC = this->Twins[Previous(twin)];
  const int fourth = this->NewTriangle();
  this->SetTriangle(triangle, a, b, vertex, twinAB, -1, -1);
  this->SetTriangle(second, c, a, vertex, twinCA, 3 * triangle + 2, -1);
  this->SetTriangle(other, b, d, vertex, twinBD, -1, 3 * triangle + 1);
  this->SetTriangle(fourth, d, c, vertex, twinDC, 3 * second + 2, 3 * other + 1);
  this->Pending.insert(this->Pending.end(), { 3 * triangle, 3 * second, 3 * other, 3 * fourth });
}

std::int64_t GreedyTile::Preference(int edge) const
{
  const int twin = this->Twins[edge];
  return twin < 0
    ? -1
    : InCircle(this->Vertices[this->Origins[edge]], this->Vertices[this->Origins[Next(edge)]],
        this->Vertices[this->Origins[Previous(edge)]],
        this->Vertices[this->Origins[Previous(twin)]]);
}

void GreedyTile::Flip(int edge)
{
  // From (a, b, v) and (b, a, d) to (a, d, v) and (d, b, v); v is the new vertex.
  const int twin = this->Twins[edge];
  const int a = this->Origins[edge];
  const int b = this->Origins[Next(edge)];
  const int v = this->Origins[Previous(edge)];
  const int d = this->Origins[Previous(twin)];
  const int twinBV = this->Twins[Next(edge)];
  const int twinVA = this->Twins[Previous(edge)];
  const int twinAD = this->Twins[Next(twin)];
  const int twinDB = this->Twins[Previous(twin)];
  const int first = edge / 3;
  const int second = twin / 3;
  this->SetTriangle(first, a, d, v, twinAD, -1, twinVA);
  this->SetTriangle(second, d, b, v, twinDB, twinBV, 3 * first + 1);
  this->Pending.insert(this->Pending.end(), { 3 * first, 3 * second });
}

void GreedyTile::Legalize(int vertex)
{
  while (!this->Pending.empty())
  {
    const int edge = this->Pending.back();
    this->Pending.pop_back();
    // what was flipped since may have other corners
    if (this->Origins[Previous(edge)] == vertex && this->Preference(edge) > 0)
    {
      this->Flip(edge);
    }
  }
}

bool GreedyTile::FlipIfBetter(int triangle)
{
  for (int edge = 3 * triangle; edge < 3 * triangle + 3; ++edge)
  {
    if (this->Preference(edge) != 0)
    {
      continue;
    }
    const int twin = this->Twins[edge];
    const int v = this->Origins[Previous(edge)];
    const int d = this->Origins[Previous(twin)];
    const double error =
      std::max(this->Candidates[triangle].Error, this->Candidates[twin / 3].Error);
    if (this->FindWorst({ this->Origins[edge], d, v }).Error < error &&
      this->FindWorst({ d, this->Origins[Next(edge)], v }).Error < error)
    {
      this->Changed.clear();
      this->Flip(edge);
      this->Pending.clear();
      return true;
    }
  }
  return false;
}

void GreedyTile::ScanRow(int y, int begin, int end, const Plane& plane, Candidate& worst) const
{
  const double base = plane.Height + plane.Y * (y - plane.Origin.y) - plane.X * plane.Origin.x;
  const double* row = this->Heights.data() + static_cast<std::size_t>(this->Width) * y;
  double column = begin; // counted: conversions are slow
  double largest = worst.Error;
  int sample = worst.Sample;
  for (int x = begin; x <= end; ++x)
  {
    const double error = std::abs(row[x] - (base + plane.X * column));
    // without branches, which would be anyone's guess; false for NaN
    sample = error > largest ? x + this->Width * y : sample;
    largest = std::max(largest, error);
    column += 1.0;
  }
  worst = { sample, largest };
}

GreedyTile::Candidate GreedyTile::FindWorst(std::array<int, 3> corners) const
{
  std::sort(corners.begin(), corners.end(),
    [this](int a, int b) { return this->Vertices[a].y < this->Vertices[b].y; });
  const glm::ivec2 a = this->Vertices[corners[0]];
  const glm::ivec2 b = this->Vertices[corners[1]];
  const glm::ivec2 c = this->Vertices[corners[2]];
  Candidate worst;
  if (std::abs(Orientation(a, b, c)) == 1)
  {
    return worst; // no sample but its corners (Pick)
  }

  const double za = this->Height(corners[0]);
  const double zb = this->Height(corners[1]);
  const double zc = this->Height(corners[2]);
  const glm::dvec2 ab = b - a;
  const glm::dvec2 ac = c - a;
  const double area = ab.x * ac.y - ab.y * ac.x;
  const Plane plane{ a, za, ((zb - za) * ac.y - (zc - za) * ab.y) / area,
    ((zc - za) * ab.x - (zb - za) * ac.x) / area };

  // x along a-c, and along a-b and then b-c; whole numbers are hit exactly but for 1e-9
  constexpr double kRounding = 1e-6;
  const double slopeAC = ac.x / ac.y;
  const bool isMiddleRight = area >= 0.0;
  const auto scan = [&](int first, int last, const glm::ivec2& from, double slope)
  {
    for (int y = first; y <= last; ++y)
    {
      const double xAC = a.x + slopeAC * (y - a.y);
      const double xOther = from.x + slope * (y - from.y);
      const double left = isMiddleRight ? xAC : xOther;
      const double right = isMiddleRight ? xOther : xAC;
      const int begin = static_cast<int>(left + (1.0 - kRounding));
      const int end = static_cast<int>(right + kRounding);
      this->ScanRow(y, begin, end, plane, worst);
    }
  };
  if (b.y > a.y)
  {
    scan(a.y, b.y - 1, a, ab.x / ab.y);
  }
  if (c.y > b.y)
  {
    scan(b.y, c.y, b, static_cast<double>(c.x - b.x) / (c.y - b.y));
  }
  else
  {
    // the upper side is level
    this->ScanRow(c.y, std::min(b.x, c.x), std::max(b.x, c.x), plane, worst);
  }
  return worst;
}

void GreedyTile::Refine(double tolerance)
{
  ErrorQueue queue(tolerance);
  this->Candidates.resize(this->Origins.size() / 3);
  const auto update = [&](int triangle)
  {
    Candidate& candidate = this->Candidates[triangle];
    const std::size_t first = std::size_t{ 3 } * triangle;
    candidate =
      this->FindWorst({ this->Origins[first], this->Origins[first + 1], this->Origins[first + 2] });
    if (candidate.Error > tolerance)
    {
      queue.Push(triangle, candidate.Error);
    }
    else
    {
      candidate.Sample = -1;
    }
  };
  for (int triangle = 0; triangle < static_cast<int>(this->Candidates.size()); ++triangle)
  {
    update(triangle);
  }
  for (int triangle = queue.Pop(); triangle >= 0; triangle = queue.Pop())
  {
    const Candidate& candidate = this->Candidates[triangle];
    if (candidate.Sample < 0 || !queue.IsTop(candidate.Error))
    {
      continue; // it was changed since, and what it is now waits elsewhere or is good
    }
    if (!this->FlipIfBetter(triangle))
    {
      const int sample = this->Candidates[triangle].Sample;
      this->InsertInto(triangle, { sample % this->Width, sample / this->Width });
    }
    this->Candidates.resize(this->Origins.size() / 3);
    std::sort(this->Changed.begin(), this->Changed.end());
    this->Changed.erase(
      std::unique(this->Changed.begin(), this->Changed.end()), this->Changed.end());
    for (const int changed : this->Changed)
    {
      update(changed);
    }
  }
}
}
