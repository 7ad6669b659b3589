// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where a vertical line meets the terrain, if what lies below a point of the line depends on how
 * high the point is: on a round earth the verticals of places differ.
 *
 * Whoever searches tells at each step how far the terrain lies above the point that was asked for
 * (its rise; NaN where there is none). The point moves by the rise, which is a contraction where
 * slope times angle between the verticals is below 1. Steep or exaggerated terrain far away is not
 * so: there the points that were below and above the terrain are a bracket, which is halved.
 */
#ifndef terrain_VerticalSearch_h
#define terrain_VerticalSearch_h

#include <cmath>
#include <limits>

namespace terrain
{
class VerticalSearch
{
public:
  VerticalSearch() = default;
  /// Begins at z. Where there is no terrain, it begins anew at trials heights up to z + range, and
  /// goes back half way from a step that leads to none; with 0 trials it ends there.
  explicit VerticalSearch(double z, double range = 0.0, int trials = 0)
    : Z(z)
    , Start(z)
    , Range(range)
    , Trials(trials)
  {
  }

  /// The point to ask for.
  double GetZ() const
  {
    return this->Z;
  }

  /// True once the point has been found; false before, and if there is none: the line may leave the
  /// terrain sideways while it is still below it.
  bool IsFound() const
  {
    return this->Found;
  }

  /// Takes the rise at GetZ(). True if the point has moved by more than the tolerance, that is, if
  /// there is more to ask for.
  bool Take(double rise, double tolerance)
  {
    if (this->Found || this->Steps == MostSteps)
    {
      return false;
    }
    ++this->Steps;
    if (std::isnan(rise))
    {
      return this->Trials > 0 &&
        (this->Seen ? this->MoveTo(0.5 * (this->Z + this->LastSeen), tolerance) : this->Try());
    }
    this->Seen = true;
    this->LastSeen = this->Z;
    (rise > 0.0 ? this->Below : this->Above) = this->Z;
    const bool isBracketed = this->Above - this->Below < Infinity;
    const double next = this->Z + rise;
    const bool halves =
      isBracketed && (this->Steps > PlainSteps || !(next >= this->Below && next <= this->Above));
    this->Found = !this->MoveTo(halves ? 0.5 * (this->Below + this->Above) : next, tolerance);
    return !this->Found;
  }

  /// Steps after which a search ends, found or not. They suffice: a bracket as high as the earth's
  /// radius becomes shorter than a tenth of a millimetre.
  static constexpr int MostSteps = 48;

private:
  bool MoveTo(double z, double tolerance)
  {
    const bool moves = std::abs(z - this->Z) > tolerance;
    this->Z = z;
    return moves;
  }

  bool Try()
  {
    if (this->Tried == this->Trials)
    {
      return false;
    }
    ++this->Tried;
    this->Z = this->Start + this->Range * this->Tried / this->Trials;
    return true;
  }

  static constexpr double Infinity = std::numeric_limits<double>::infinity();
  static constexpr int PlainSteps = 8;

  double Z = 0.0;
  double Start = 0.0;
  double Range = 0.0;
  double Below = -Infinity;
  double Above = Infinity;
  double LastSeen = 0.0;
  int Trials = 0;
  int Tried = 0;
  int Steps = 0;
  bool Seen = false;
  bool Found = false;
};
}

#endif
