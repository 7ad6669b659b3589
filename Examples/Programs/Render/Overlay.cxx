// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Scale bar and north arrow.
#include "Annotations.h"

#include "MarkColors.h"
#include "Options.h"
#include "Placing.h"
#include "TextSize.h"

#include "vtkActor2D.h"
#include "vtkCamera.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkRenderer.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainScaleBar.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace
{
using Vector = std::array<double, 3>;

/// In shares of the picture's height, the longest bar in shares of its width.
constexpr double kMargin = 0.03;
constexpr double kThickness = 0.012;
constexpr double kArrowLength = 0.09;
constexpr double kTextSize = 0.026;
constexpr double kLongest = 0.25;
constexpr int kSmallestText = 8;

/// Metres a pixel at the focal point.
double MetresPerPixel(vtkCamera* camera, const Options& options)
{
  return 2.0 * camera->GetDistance() *
    std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2.0) / options.Size[1];
}

/// Direction of north at the focal point; that of the grid where there are no places.
Vector FindNorth(vtkCamera* camera, const PlacedHeights& heights)
{
  Vector north = { 0.0, 1.0, 0.0 };
  Vector place{};
  Vector east{};
  Vector there{};
  Vector up{};
  if (heights.WhyNoPlaces.empty() &&
    heights.Georeference->SceneToPlaces(camera->GetFocalPoint(), place.data(), 1) &&
    heights.Georeference->GetAxes(place.data(), east.data(), there.data(), up.data()))
  {
    north = there;
  }
  return north;
}

/// A direction of the scene in the picture: x to the right, y up.
std::array<double, 2> ToPicture(vtkCamera* camera, const Vector& direction)
{
  Vector right{};
  Vector up{};
  vtkMath::Cross(camera->GetDirectionOfProjection(), camera->GetViewUp(), right.data());
  vtkMath::Normalize(right.data());
  vtkMath::Cross(right.data(), camera->GetDirectionOfProjection(), up.data());
  return { vtkMath::Dot(direction.data(), right.data()),
    vtkMath::Dot(direction.data(), up.data()) };
}

/// Adds a shape whose cells are filled dark (1) and light (0), on dark backgrounds the reverse, its
/// origin at a pixel.
void AddShape(vtkRenderer* renderer, vtkAlgorithmOutput* shape, double x, double y)
{
  const vtkNew<vtkLookupTable> colors;
  colors->SetNumberOfTableValues(2);
  const bool isDark = IsDarkBehind(renderer, false);
  const auto& [r, g, b] = kDarkMark;
  colors->SetTableValue(isDark ? 1 : 0, 1.0, 1.0, 1.0);
  colors->SetTableValue(isDark ? 0 : 1, r, g, b);
  const vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputConnection(shape);
  mapper->SetLookupTable(colors);
  mapper->SetColorModeToMapScalars();
  mapper->SetScalarRange(0.0, 1.0);
  const vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(x, y);
  renderer->AddViewProp(actor);
}

void AddText(vtkRenderer* renderer, const std::string& text, double x, double y, double size)
{
  const vtkNew<vtkTextActor> actor;
  actor->SetInput(text.c_str());
  actor->SetPosition(x, y);
  vtkTextProperty* property = actor->GetTextProperty();
  property->SetFontSize(std::max(kSmallestText, static_cast<int>(size)));
  const auto& [r, g, b] = IsDarkBehind(renderer, false) ? kLightMark : kDarkMark;
  property->SetColor(r, g, b);
  property->SetJustificationToCentered();
  property->SetVerticalJustificationToBottom();
  renderer->AddViewProp(actor);
}
}

//------------------------------------------------------------------------------
void AddOverlay(vtkRenderer* renderer, const PlacedHeights& heights, const Options& options)
{
  if (!options.Place.ScaleBar && !options.Place.NorthArrow)
  {
    return;
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  const double width = options.Size[0];
  const double height = options.Size[1];
  const double metres = MetresPerPixel(camera, options);
  const std::array<double, 2> north = ToPicture(camera, FindNorth(camera, heights));
  const vtkNew<vtkTerrainScaleBar> bar;
  bar->SetMaximumLength(kLongest * width * metres);
  bar->SetUnitsPerMetre(1.0 / metres);
  bar->SetThickness(kThickness * height);
  bar->SetArrowLength(kArrowLength * height);
  bar->SetNorth(north[0], north[1]);
  const double margin = kMargin * height;
  if (options.Place.ScaleBar)
  {
    AddShape(renderer, bar->GetOutputPort(0), margin, margin);
    AddText(renderer, bar->GetLabel(), margin + 0.5 * bar->GetLength() / metres,
      margin + 1.5 * kThickness * height, TextPixels(kTextSize, options));
  }
  if (options.Place.NorthArrow)
  {
    const double x = width - margin - kArrowLength * height;
    const double y = margin + kArrowLength * height;
    AddShape(renderer, bar->GetOutputPort(1), x, y);
    const double length = std::hypot(north[0], north[1]);
    const double beyond = 1.2 * kArrowLength * height / (length > 0.0 ? length : 1.0);
    AddText(renderer, "N", x + beyond * north[0],
      y + (length > 0.0 ? beyond * north[1] : beyond) - 0.5 * TextPixels(kTextSize, options),
      TextPixels(kTextSize, options));
  }
}
