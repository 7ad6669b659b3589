// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The only definition of spaces, origins and units; everything else refers to this page.
 *
 * A heightfield is z = h(x, y) on a regular grid of W x H samples, the index of sample (i, j) being
 * i + W * j; i runs east, j runs north. It has (W-1) x (H-1) cells; cell (i, j) is the square
 * between the samples (i, j) and (i+1, j+1). The surface is the bilinear patch of each cell.
 *
 * Spaces, each a suffix of the names that live in it:
 *   GC  grid coordinates: sample (i, j) at x = i, y = j; z in height codes (below)
 *   TC  texture coordinates: sample i at (i + 0.5) / W
 *   MC  model coordinates (VTK's): x = origin.x + i * spacing.x, y likewise,
 *       z = origin.z + exaggeration * h
 *   WC, VC, DC  world, view and display coordinates, as in VTK
 *
 * Heights are stored on the GPU as codes, h = offset + scale * code: see HeightCodes.h.
 */
#ifndef terrain_Coordinates_h
#define terrain_Coordinates_h

#include <glm/glm.hpp>

#include <cmath>

namespace terrain
{
/**
 * Where a grid of samples lies in model coordinates. This is the only place that knows the vertical
 * exaggeration: a height h is drawn at Origin.z + Exaggeration * h, that is, heights are
 * exaggerated from the height 0. The true z of a point, without exaggeration, is Origin.z + h.
 */
struct GridGeometry
{
  /// Position of sample (0, 0), in model units; z is added to the exaggerated heights.
  glm::dvec3 Origin{ 0.0, 0.0, 0.0 };
  /// Distance of neighbouring samples east and north, in model units, both > 0.
  glm::dvec2 Spacing{ 1.0, 1.0 };
  /// Vertical exaggeration: drawn height over true height, > 0; default 1.
  double Exaggeration = 1.0;

  /// Model position of grid position (x, y) (in cells) and height h (in height units).
  glm::dvec3 ToModel(const glm::dvec2& positionGC, double height) const
  {
    return { this->Origin.x + positionGC.x * this->Spacing.x,
      this->Origin.y + positionGC.y * this->Spacing.y,
      this->Origin.z + this->Exaggeration * height };
  }

  /// Grid position in x and y (in cells) and height in z (in height units) of a model position.
  glm::dvec3 ToGrid(const glm::dvec3& positionMC) const
  {
    return { (positionMC.x - this->Origin.x) / this->Spacing.x,
      (positionMC.y - this->Origin.y) / this->Spacing.y,
      (positionMC.z - this->Origin.z) / this->Exaggeration };
  }

  /// Grid direction of a model direction, see ToGrid().
  glm::dvec3 DirectionToGrid(const glm::dvec3& directionMC) const
  {
    return directionMC / this->Scale();
  }

  /// The plane dot(plane, (x, y, z, 1)) = 0 of model coordinates in grid coordinates, z in heights.
  glm::dvec4 PlaneToGrid(const glm::dvec4& planeMC) const
  {
    const glm::dvec3 normal(planeMC);
    return { normal * this->Scale(), planeMC.w + glm::dot(normal, this->Origin) };
  }

  /// Model normal, of any length, of a surface whose normal in grid coordinates (z in heights) is
  /// given.
  glm::dvec3 NormalToModel(const glm::dvec3& normalGC) const
  {
    return normalGC / this->Scale();
  }

  ///@{
  /// How much higher a point is drawn that is higher by so many height units, and back.
  double RiseToModel(double rise) const
  {
    return this->Exaggeration * rise;
  }
  double RiseToHeights(double drawnRise) const
  {
    return drawnRise / this->Exaggeration;
  }
  ///@}

  /// Height units that are drawn as long as the side of a cell (the mean of its two sides).
  double HeightOfCellSide() const
  {
    return std::sqrt(this->Spacing.x * this->Spacing.y) / this->Exaggeration;
  }

  ///@{
  /// Drawn z of a true z, and true z of a drawn one.
  double ToDrawnZ(double trueZ) const
  {
    return this->Origin.z + this->Exaggeration * (trueZ - this->Origin.z);
  }
  double ToTrueZ(double drawnZ) const
  {
    return this->Origin.z + (drawnZ - this->Origin.z) / this->Exaggeration;
  }
  ///@}

  ///@{
  /// Matrices on column vectors: grid coordinates, z in heights, to model coordinates; and model
  /// coordinates with true z to those with drawn z.
  glm::dmat4 GridToModel() const
  {
    const glm::dvec3 scale = this->Scale();
    return { { scale.x, 0.0, 0.0, 0.0 }, { 0.0, scale.y, 0.0, 0.0 }, { 0.0, 0.0, scale.z, 0.0 },
      glm::dvec4(this->Origin, 1.0) };
  }
  glm::dmat4 TrueToDrawn() const
  {
    return { { 1.0, 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0, 0.0 }, { 0.0, 0.0, this->Exaggeration, 0.0 },
      { 0.0, 0.0, this->ToDrawnZ(0.0), 1.0 } };
  }
  ///@}

private:
  glm::dvec3 Scale() const
  {
    return { this->Spacing.x, this->Spacing.y, this->Exaggeration };
  }
};
}

#endif
