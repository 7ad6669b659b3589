// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Landscape evolution on a small grid: uplift against rivers, so that every valley drains.
 */
#ifndef terrain_StreamErosion_h
#define terrain_StreamErosion_h

#include <cstdint>
#include <vector>

namespace terrain
{
/// Heights under uplift, river incision, hillslope creep and a slope limit.
///
/// All lengths (heights too) are in units of the caller's choice, CellSize among them. The
/// outermost nodes are the base level: they keep their heights, and all water leaves there. The
/// same bits on every machine: only IEEE 754's +, -, *, / and square root are used.
///
/// Sources: stream power law dh/dt = U - K A^(1/2) S, solved implicitly in drainage order (Braun
/// and Willett 2013, "A very efficient O(n), implicit and parallel method to solve the stream power
/// equation", Eq. 21-22); drainage through pits by flooding from the border (Barnes, Lehman and
/// Mulla 2014, "Priority-flood", Algorithm 1).
class StreamErosion
{
public:
  /// A flat grid at height 0 without uplift; width, height >= 3, cellSize > 0.
  StreamErosion(std::int64_t width, std::int64_t height, double cellSize, std::uint32_t seed);

  std::int64_t GetWidth() const
  {
    return this->Width;
  }
  std::int64_t GetHeight() const
  {
    return this->Height;
  }

  /// Height and rate of uplift (height per time) of each node, index i + Width * j. Heights may be
  /// set before the first step only.
  std::vector<double> Heights;
  std::vector<double> Uplift;

  /// Incision per time of one unit of drained area at slope 1; default 1.
  double Erodibility = 1.0;
  /// Steepest slope that holds, rise over run; default 1.
  double SteepestSlope = 1.0;
  /// Share of the difference to the mean of the neighbours lost in a step, 0 to 0.5; default 0.1.
  double Creep = 0.1;

  /// Advances by a time step, which may be large (the solution is implicit). After it every node
  /// lies above its receiver: there are no pits. O(n log n) the first time, then O(n).
  void Step(double timeStep);

  /// Upstream area of each node after the last step, in square units of length.
  const std::vector<double>& GetDrainedAreas() const
  {
    return this->Areas;
  }

  /// The downstream neighbour of each node after the last step; border nodes are their own.
  const std::vector<std::int32_t>& GetReceivers() const
  {
    return this->Receivers;
  }

private:
  bool IsBorder(std::int64_t i, std::int64_t j) const
  {
    return i == 0 || j == 0 || i == this->Width - 1 || j == this->Height - 1;
  }
  void Flood();
  void ChooseReceivers();
  void SortDownstreamFirst();
  void AccumulateAreas();
  void Incise(double timeStep);
  void Diffuse();
  void DrainPits();

  std::int64_t Width;
  std::int64_t Height;
  double CellSize;
  std::uint32_t Seed;
  std::vector<std::int32_t> Order;       // nodes, downstream first
  std::vector<std::int32_t> Receivers;   // downstream neighbour of each node
  std::vector<std::int32_t> FirstDonors; // of each node in Donors, one more than nodes
  std::vector<std::int32_t> Donors;
  std::vector<double> Areas;
  bool Drained = false; // every node has a receiver below it
};
}

#endif
