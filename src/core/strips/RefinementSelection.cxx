// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/strips/RefinementSelection.h"

#include "core/strips/RefinementCounts.h"
#include "core/strips/RefinementSites.h"
#include "core/strips/RefinementVertex.h"

#include <algorithm>
#include <type_traits>

namespace terrain
{
namespace
{
/// Steps to the corners of a diamond, by quarter turns in the order of corners: of even depths
/// counter-clockwise from the south-west, of odd ones clockwise from the west.
struct CornerSteps
{
  std::array<std::int32_t, 4> Columns;
  std::array<std::int32_t, 4> Rows;
};
constexpr std::array<CornerSteps, 2> kCornerSteps{ {
  { { { -1, 1, 1, -1 } }, { { -1, -1, 1, 1 } } },
  { { { -1, 0, 1, 0 } }, { { 0, 1, 0, -1 } } },
} };

/// Bit in a record's drawn ones of the half at the edge from the corner at `turn` to the next one.
std::uint32_t DrawnBit(bool isOdd, std::uint32_t turn)
{
  return isOdd ? 3 - turn : (turn + 1) & 3;
}

/// Links of the halves of a vertex, two for each triangle, by what is known of the triangles: of
/// those that are there, `drawn` says which halves are drawn.
void SetDrawn(
  bool isOdd, std::uint32_t turn, std::uint32_t drawn, std::array<std::uint32_t, 2>* links)
{
  for (std::uint32_t k = 0; k < 4; ++k)
  {
    std::uint32_t& link = links[k >> 1][k & 1];
    const bool isDrawn = ((drawn >> DrawnBit(isOdd, (turn + k) & 3)) & 1) != 0;
    link = link == UnsplitLink::Outside ? link : (isDrawn ? UnsplitLink::Drawn : UnsplitLink::Hole);
  }
}
}

void RefinementSelection::MakeMesh(const RefinementFrame& frame, const SquareSites& square,
  bool morphing, std::vector<StripVertex>& vertices)
{
  this->Morphing = morphing;
  this->Counts = nullptr;
  this->Vertices.Begin(vertices);
  this->Select(frame, square);
  this->Vertices.Finish(vertices);
}

void RefinementSelection::Count(
  const RefinementFrame& frame, const SquareSites& square, ToleranceCounts& counts)
{
  this->Counts = &counts;
  this->Morphing = false;
  std::vector<StripVertex> none;
  this->Vertices.Begin(none);
  this->Select(frame, square);
}

void RefinementSelection::Select(const RefinementFrame& frame, const SquareSites& square)
{
  this->Frame = &frame;
  this->BeginSquare(square);
  const auto depths = static_cast<int>(frame.Deepest - &frame.Depths[0]) + 1;
  // Vertices of two depths above the next one, and of one.
  std::array<std::uint32_t, 2> above{ { 1, 3 } };
  std::array<std::uint32_t, 2> before{ { Centre, Centre + 1 } };
  for (int depth = 1; depth < depths && above[0] < above[1]; ++depth)
  {
    const std::uint32_t first = this->Nodes.Count();
    const DepthTable* table = &frame.Depths[depth];
    if (!frame.FirstDetail)
    {
      this->SelectDepth<VertexSite, false>(depth, above[0], above[1]);
    }
    else if (table < frame.FirstDetail)
    {
      this->SelectDepth<DetailVertexSite, false>(depth, above[0], above[1]);
    }
    else
    {
      this->SelectDepth<DetailVertexSite, true>(depth, above[0], above[1]);
    }
    above = before;
    before = { { first, this->Nodes.Count() } };
  }
}

/// The square's corners and its centre. The middles of its sides, which have one parent, are found
/// from its south-east and north-west corner as others are from vertices.
void RefinementSelection::BeginSquare(const SquareSites& square)
{
  const RefinementFrame& frame = *this->Frame;
  this->TriangleCount = 4;
  this->Nodes.Clear();
  this->Masks.Clear();
  this->Links.Clear();
  this->Grounds.Clear();
  this->Border.clear();
  this->Merged.clear();
  this->Reserve();
  constexpr std::uint32_t outside = UnsplitLink::Outside;
  constexpr std::uint32_t first = 2 * Centre;
  constexpr std::array<std::array<TriangleHalves, 2>, 4> links{ {
    { { { { UnsplitLink::Drawn, UnsplitLink::Drawn } },
      { { UnsplitLink::Hole, UnsplitLink::Hole } } } },
    { { { { first, outside } }, { { UnsplitLink::Drawn, outside } } } },
    { { { { first + 1, outside } }, { { UnsplitLink::Drawn, outside } } } },
    { { { { outside, outside } }, { { UnsplitLink::Drawn, UnsplitLink::Drawn } } } },
  } };
  constexpr std::array<Node, 5> nodes{ { { {}, 0, 0, 0 }, { { { 0, 3, 0, 0 } }, 1, 0, 0 },
    { { { 3, 0, 0, 0 } }, 0, 1, 2 }, { {}, 1, 1, 0 }, { { { 0, 1, 3, 2 } }, 1, 1, 0 } } };
  for (std::uint32_t corner = 0; corner < Centre; ++corner)
  {
    this->Nodes[corner] = nodes[corner];
    this->Masks[corner] = 0xff;
    this->Links[2 * corner] = links[corner][0];
    this->Links[2 * corner + 1] = links[corner][1];
    this->Grounds[corner] = { frame.Detail.Corners[corner], 0.0f };
    this->Vertices[corner] = square.Corners[corner];
    if (frame.SharesSamples)
    {
      this->Border.try_emplace(square.Samples[corner], corner);
    }
  }
  this->Nodes[Centre] = nodes[Centre];
  this->Masks[Centre] = static_cast<std::uint8_t>((1u << frame.PlaneCount) - 1u);
  this->Links[first] = { { UnsplitLink::Drawn, UnsplitLink::Drawn } };
  this->Links[first + 1] = { { UnsplitLink::Drawn, UnsplitLink::Drawn } };
  if (frame.HasHoles)
  {
    SetDrawn(false, 0, square.Centre.Record.Drawn(), &this->Links[first]);
  }
  this->Grounds[Centre] = { frame.Detail.Centre, 0.0f };
  // The centre is where it is, whatever its hypotenuse.
  Found<VertexSite> centre{ square.Centre, { 0, 1, 1, 0 }, 0.0f };
  const bool morphing = this->Morphing;
  this->Morphing = false;
  this->Vertices[Centre] =
    this->MakeVertex<VertexSite, false>(centre, Centre, this->Vertices[0], this->Vertices[3]);
  this->Morphing = morphing;
  this->SetCount(Centre + 1);
}

/// Makes room for what a batch of vertices finds.
void RefinementSelection::Reserve()
{
  this->Vertices.Reserve();
  this->Nodes.Reserve();
  this->Masks.Reserve();
  this->Links.Reserve();
  this->Grounds.Reserve();
}

/// Looks at the vertices of a depth that are found from the vertices of number first to last - 1.
template <typename Site, bool IsBelow>
void RefinementSelection::SelectDepth(int depth, std::uint32_t first, std::uint32_t last)
{
  std::array<Found<Site>, MostFound> found;
  for (; first < last; first += Batch)
  {
    if (this->Counts && this->Counts->AreEnough())
    {
      return;
    }
    this->Reserve();
    const std::uint32_t candidates = this->FindCandidates(first, std::min(first + Batch, last));
    this->Locate<IsBelow>(depth, candidates);
    const std::uint32_t count = this->Test<Site, IsBelow>(depth, candidates, found.data());
    this->Take<Site, IsBelow>(depth, found.data(), count);
  }
}

/// The vertices that have both parents, found from vertices first to last - 1.
std::uint32_t RefinementSelection::FindCandidates(std::uint32_t first, std::uint32_t last)
{
  Place* const places = this->Places.data();
  std::uint32_t count = 0;
  for (std::uint32_t v = first; v < last; ++v)
  {
    const TriangleHalves* const halves = &this->Links[2 * v];
    const std::array<std::uint32_t, 4> links{ { halves[0][0], halves[0][1], halves[1][0],
      halves[1][1] } };
    for (std::uint32_t k = 0; k < 4; ++k)
    {
      const std::uint32_t a = links[k];
      const std::uint32_t b = links[(k + 3) & 3];
      places[count].From = 4 * v + k;
      // One parent may be missing beside a hole or outside.
      count += int(a != UnsplitLink::Drawn) & int(b != UnsplitLink::Drawn) &
        int((a | b) > UnsplitLink::Last);
    }
  }
  return count;
}

/// Finds the places of candidates. Their records are fetched: they lie all over the hierarchy, and
/// no test should wait for one.
template <bool IsBelow>
void RefinementSelection::Locate(int depth, std::uint32_t count)
{
  const DepthTable& table = this->Frame->Depths[depth];
  const CornerSteps& steps = kCornerSteps[depth & 1];
  for (std::uint32_t i = 0; i < count; ++i)
  {
    Place& place = this->Places[i];
    const Node& node = this->Nodes[place.From >> 2];
    const std::uint32_t turn = (node.Turn + place.From) & 3;
    place.Column = 2 * node.Column + static_cast<std::uint32_t>(steps.Columns[turn]);
    place.Row = 2 * node.Row + static_cast<std::uint32_t>(steps.Rows[turn]);
    if constexpr (IsBelow)
    {
      __builtin_prefetch(
        &table.Detail.Record(place.Column << table.Shift, place.Row << table.Shift));
    }
    else
    {
      place.Index = table.Columns[place.Column].Term + table.Rows[place.Row].Term;
      __builtin_prefetch(&this->Frame->Records[place.Index]);
    }
  }
}

/// The candidates whose error is too large to leave them out; returns their number.
template <typename Site, bool IsBelow>
std::uint32_t RefinementSelection::Test(int depth, std::uint32_t count, Found<Site>* found)
{
  const RefinementFrame& frame = *this->Frame;
  const DepthTable& table = frame.Depths[depth];
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    Found<Site>& site = found[i];
    site.At = this->Places[i];
    site.Depth = &table;
    if constexpr (std::is_same_v<Site, DetailVertexSite>)
    {
      site.Position = PositionOf(site);
    }
    bool isNeeded = false;
    if constexpr (IsBelow)
    {
      isNeeded = this->TestBelow(site);
    }
    else
    {
      site.Column = &table.Columns[site.At.Column];
      site.Row = &table.Rows[site.At.Row];
      site.Index = site.At.Index;
      isNeeded = IsSampleNeeded<Site>(frame, site);
    }
    this->Kept[kept] = i;
    kept += isNeeded ? 1 : 0;
  }
  return kept;
}

/// The same of a vertex below the samples: of both of its triangles, one must be drawn.
TERRAIN_INLINE bool RefinementSelection::TestBelow(Found<DetailVertexSite>& site) const
{
  const RefinementFrame& frame = *this->Frame;
  const std::uint32_t v = site.At.From >> 2;
  const std::uint32_t k = site.At.From & 3;
  const std::uint32_t a = this->LinkOf(v, k);
  const std::uint32_t b = this->LinkOf(v, (k + 3) & 3);
  const Ground& left = this->Grounds[this->Nodes[v].Corners[k]];
  const Ground& right = this->Grounds[v];
  float height = 0.5f * (left.Height + right.Height);
  site.Twist = 0.0f;
  if (!site.Depth->IsOdd)
  {
    const bool isRising = ((this->Nodes[v].Turn + k) & 1) == 0;
    if (site.Depth == frame.FirstDetail)
    {
      const float twist = 0.25f *
        ((left.Height + right.Height) -
          (this->Grounds[a >> 1].Height + this->Grounds[b >> 1].Height));
      site.Twist = isRising ? twist : -twist;
    }
    else
    {
      site.Twist = 0.25f * right.Twist;
    }
    height = isRising ? height - site.Twist : height + site.Twist;
  }
  const bool isDrawn =
    this->Links[a][0] == UnsplitLink::Drawn || this->Links[b][1] == UnsplitLink::Drawn;
  return (int(IsDetailNeeded(frame, height, site)) & int(isDrawn)) != 0;
}

/// True if a vertex found by the links a and b is not culled. Keeps the planes that those which are
/// found from it are tested against, as those of vertex `number`.
template <typename Site>
TERRAIN_INLINE bool RefinementSelection::IsSeen(const DepthTable& table, const Found<Site>& site,
  std::uint32_t a, std::uint32_t b, std::uint32_t number)
{
  std::uint32_t mask = this->Masks[a >> 1] & this->Masks[b >> 1];
  if ((mask & table.PlaneMask) != 0 && IsCulled<Site>(*this->Frame, site, mask))
  {
    return false;
  }
  this->Masks[number] = static_cast<std::uint8_t>(mask);
  return true;
}

/// Takes the vertices that are not culled.
template <typename Site, bool IsBelow>
void RefinementSelection::Take(int depth, Found<Site>* found, std::uint32_t count)
{
  const RefinementFrame& frame = *this->Frame;
  const DepthTable& table = frame.Depths[depth];
  const bool culls = frame.PlaneCount != 0;
  const bool hasHoles = !IsBelow && frame.HasHoles;
  // In registers, which members that are appended to would not be.
  Node* const nodes = &this->Nodes[0];
  TriangleHalves* const links = &this->Links[0];
  std::uint32_t number = this->Nodes.Count();
  std::int64_t triangleCount = this->TriangleCount;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    Found<Site>& site = found[this->Kept[i]];
    const std::uint32_t v = site.At.From >> 2;
    const std::uint32_t k = site.At.From & 3;
    const std::uint32_t a = links[2 * v + (k >> 1)][k & 1];
    const std::uint32_t b = links[2 * v + (((k + 3) & 3) >> 1)][(k + 3) & 1];
    if (culls && !this->IsSeen<Site>(table, site, a, b, number))
    {
      continue;
    }
    const std::uint32_t corner = nodes[v].Corners[k];
    const std::uint32_t turn = (nodes[v].Turn + k) & 3;
    nodes[number] = { { { corner, a >> 1, v, b >> 1 } }, site.At.Column, site.At.Row, turn };
    const std::uint32_t first = links[a][0];
    const std::uint32_t second = links[b][1];
    const int triangles = int(first != UnsplitLink::Outside) + int(second != UnsplitLink::Outside);
    triangleCount += triangles;
    TriangleHalves* const own = links + std::size_t{ 2 } * number;
    own[0] = { { first, first } };
    own[1] = { { second, second } };
    if (hasHoles)
    {
      SetDrawn(table.IsOdd, turn, site.Record.Drawn(), own);
    }
    // Parents that are missing are not linked.
    links[std::max(a, UnsplitLink::Last)][0] = 2 * number;
    links[std::max(b, UnsplitLink::Last)][1] = 2 * number + 1;
    if constexpr (std::is_same_v<Site, DetailVertexSite>)
    {
      this->Grounds[number] = { site.BaseHeight, site.Twist };
    }
    if (this->Counts)
    {
      this->Counts->Add(site.ErrorReach / GapOf(site), triangles);
    }
    else
    {
      this->Vertices[number] =
        this->MakeVertex<Site, IsBelow>(site, number, this->Vertices[corner], this->Vertices[v]);
    }
    ++number;
  }
  this->TriangleCount = triangleCount;
  this->SetCount(number);
}

/// Completes the numbers of what is known of vertices.
void RefinementSelection::SetCount(std::uint32_t count)
{
  this->Nodes.SetCount(count);
  this->Masks.SetCount(count);
  this->Links.SetCount(2 * count);
  this->Grounds.SetCount(count);
  this->Vertices.SetCount(count);
}

/// The mesh's vertex, whose hypotenuse ends at `left` and `right`.
template <typename Site, bool IsBelow>
TERRAIN_INLINE StripVertex RefinementSelection::MakeVertex(
  Found<Site>& site, std::uint32_t number, const StripVertex& left, const StripVertex& right)
{
  const RefinementFrame& frame = *this->Frame;
  if constexpr (IsBelow)
  {
    StripVertex vertex = VertexBelowSamples(frame, site);
    if (this->Morphing)
    {
      Displace<Site>(site, left, right, vertex);
    }
    return vertex;
  }
  else
  {
    StripVertex vertex = VertexOnSample(frame, site);
    if (this->Morphing && !site.Record.IsRough())
    {
      Displace<Site>(site, left, right, vertex);
    }
    if (frame.SharesSamples &&
      (site.Column->Sample == frame.LastColumn || site.Row->Sample == frame.LastRow))
    {
      site.Position = PositionOf(site);
      this->MergeVertex(site, number, vertex);
    }
    return vertex;
  }
}

/// On the last row and column several vertices of the hierarchy share a sample, and are one.
TERRAIN_NO_INLINE void RefinementSelection::MergeVertex(
  const VertexSite& site, std::uint32_t number, StripVertex& vertex)
{
  if (IsBeyond(*this->Frame, site))
  {
    // No drawn triangle uses it.
    this->Merged.push_back({ { number, 0 } });
    return;
  }
  const auto [entry, isNew] =
    this->Border.try_emplace(site.Column->Sample | (site.Row->Sample << 16), number);
  if (!isNew)
  {
    this->Merged.push_back({ { number, entry->second } });
    vertex = this->Vertices[entry->second];
  }
}

void RefinementSelection::MergeSamples(
  std::vector<StripVertex>& vertices, std::vector<std::uint32_t>& strip)
{
  if (this->Merged.empty())
  {
    return;
  }
  this->Indices.resize(vertices.size());
  std::uint32_t count = 0;
  auto merged = this->Merged.begin();
  for (std::uint32_t number = 0; number < vertices.size(); ++number)
  {
    if (merged != this->Merged.end() && (*merged)[0] == number)
    {
      this->Indices[number] = this->Indices[(*merged)[1]];
      ++merged;
      continue;
    }
    vertices[count] = vertices[number];
    this->Indices[number] = count++;
  }
  vertices.resize(count);
  for (std::uint32_t& index : strip)
  {
    index = this->Indices[index];
  }
}
}
