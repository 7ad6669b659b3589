// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A terrain under one light: for tests of what lights give.
 */
#ifndef vtkTerrainTestSunlit_h
#define vtkTerrainTestSunlit_h

#include "vtkTerrainTestDrawing.h"
#include "vtkTerrainTesting.h"

#include "core/surface/Surface.h"
#include "data/ImageSurface.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <cmath>

namespace vtkTerrainTesting
{
/// Degrees clockwise from north, and above the horizon.
inline glm::dvec3 WayTo(double azimuth, double altitude)
{
  const double around = vtkMath::RadiansFromDegrees(azimuth);
  const double up = vtkMath::RadiansFromDegrees(altitude);
  return { std::cos(up) * std::sin(around), std::cos(up) * std::cos(around), std::sin(up) };
}

/// A terrain under one light, with nothing but what that light gives.
class Sunlit : public Drawing
{
public:
  explicit Sunlit(vtkImageData* heights,
    vtkOpenGLTerrainMapper::Techniques technique = vtkOpenGLTerrainMapper::Techniques::Pyramid)
    : Drawing(heights, technique)
  {
    this->Actor->GetProperty()->SetSpecular(0.0);
    this->Sun->SetLightTypeToSceneLight();
    this->Sun->SetFocalPoint(0.0, 0.0, 0.0);
    this->Renderer()->AddLight(this->Sun);
  }

  vtkRenderer* Renderer()
  {
    return this->Scene.Renderer;
  }

  /// Degrees clockwise from north, and above the horizon.
  void Shine(double azimuth, double altitude)
  {
    const glm::dvec3 way = WayTo(azimuth, altitude);
    this->Sun->SetPosition(way.x, way.y, way.z);
  }

  vtkSmartPointer<vtkImageData> Picture(bool shadows)
  {
    this->Mapper->SetSunShadows(shadows);
    return Render(this->Scene.Window);
  }

  vtkNew<vtkLight> Sun;
};

/// The surface that a drawing shows.
inline terrain::Surface SurfaceOf(Sunlit& drawing)
{
  terrain::ImageSurface image;
  image.SetImage(drawing.Heights);
  return image.GetSurface(drawing.Mapper->GetVerticalExaggeration());
}

/// Looks at all of a terrain from above its southern border.
inline void LookOver(Sunlit& drawing)
{
  const int* size = drawing.Heights->GetDimensions();
  double range[2];
  drawing.Heights->GetScalarRange(range);
  const double high = range[1] + 0.2 * size[0] * drawing.Heights->GetSpacing()[0];
  drawing.Look(0.5 * size[0], -0.2 * size[1], high, 0.5 * size[0], 0.5 * size[1], range[0]);
}
}

#endif
