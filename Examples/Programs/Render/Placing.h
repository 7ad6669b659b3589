// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From heights as a file has them to a scene in metres whose places on earth are known.
 */
#ifndef terrain_render_Placing_h
#define terrain_render_Placing_h

#include "ColorSource.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainViewpoint.h"

#include <string>
#include <vector>

class ProgressBar;
class Statistics;
struct Options;

/// Heights in the coordinates of the scene, and where on earth those are.
struct PlacedHeights
{
  vtkSmartPointer<vtkImageData> Image;
  /// Further heights of the same globe, of which the finest are seen: a terrain each.
  std::vector<vtkSmartPointer<vtkImageData>> Finer;
  /// Their files.
  std::vector<std::string> FinerNames;
  /// Heights of the other sites of a folder.
  std::vector<vtkSmartPointer<vtkImageData>> Sites;
  vtkSmartPointer<vtkTerrainGeoreference> Georeference;
  /// Empty if the scene has places on earth, else one sentence that says why not.
  std::string WhyNoPlaces;
  /// What the terrain still has to be exaggerated by: 1 where its heights are exaggerated already.
  double Exaggeration = 1.0;
  /// What the colours show.
  ColorSource Colors;
  /// Drawn height over true height, with whatever was exaggerated already.
  double Factor = 1.0;

  bool IsGlobe() const
  {
    return this->Georeference->GetFrame() == vtkTerrainGeoreference::FrameType::Globe;
  }
};

/**
 * Brings heights that were read into the frame that the options ask for. Without such options the
 * file's own grid is kept where it is in metres and true to scale in its middle (within 1 %), and
 * where nothing is known of it; heights in degrees that reach over more than 60 of them, or lie on
 * another planet, are laid on the globe; other heights in degrees, Web Mercator and the like are
 * resampled in the frame Plane. That has no use for large parts of the earth, where the ground
 * falls by more than 200 km below the middle's horizon (1,600 km off): those keep the layout of
 * the reader, and a warning says so.
 *
 * Throws a Failure: what is asked for cannot be had, or an option needs places that there are not.
 */
PlacedHeights PlaceHeights(
  vtkImageData* read, const Options& options, ProgressBar& progress, Statistics& statistics);

/// What brings places into the scene, on the ground of all its heights, the finest first.
vtkSmartPointer<vtkTerrainViewpoint> MakeViewpoint(const PlacedHeights& heights);

/// Brings other heights of the same CRS into the scene of the first. Throws a Failure.
vtkSmartPointer<vtkImageData> PlaceBeside(
  const PlacedHeights& first, vtkImageData* read, const Options& options, ProgressBar& progress);

#endif
