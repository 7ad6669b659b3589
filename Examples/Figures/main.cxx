// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Draws frames.png and heights.png of docs/georeferencing.md: terrain-figures FOLDER
//
// Curves of frames.png are what vtkTerrainGeoreference computes; heights.png is a sketch.
#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace
{
using Frame = vtkTerrainGeoreference::FrameType;
using Point = std::array<double, 2>;
using Color = std::array<double, 3>;

constexpr int kWidth = 1200;
constexpr Color kInk = { 0.13, 0.15, 0.20 };
constexpr Color kBlue = { 0.10, 0.38, 0.70 };
constexpr Color kRed = { 0.78, 0.18, 0.12 };
constexpr Color kGreen = { 0.22, 0.50, 0.24 };
constexpr Color kGround = { 0.86, 0.82, 0.72 };
constexpr Color kGrey = { 0.55, 0.57, 0.60 };

/// A picture in pixels, x to the right and y up.
class Sheet
{
public:
  explicit Sheet(int height)
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(kWidth, height);
    this->Renderer->SetBackground(1.0, 1.0, 1.0);
    this->Window->AddRenderer(this->Renderer);
  }

  void Line(const std::vector<Point>& points, const Color& color, double width = 2.0)
  {
    this->Shape(points, color, width, false);
  }
  void Fill(const std::vector<Point>& points, const Color& color)
  {
    this->Shape(points, color, 1.0, true);
  }
  /// A line with a head at its end, or at both.
  void Arrow(const Point& from, const Point& to, const Color& color, bool both = false)
  {
    this->Line({ from, to }, color);
    this->Head(from, to, color);
    if (both)
    {
      this->Head(to, from, color);
    }
  }
  /// Text whose middle left (-1), middle (0) or middle right (1) is at a point.
  void Text(
    const std::string& text, const Point& at, const Color& color, int anchor = -1, int size = 20)
  {
    const vtkNew<vtkTextActor> actor;
    actor->SetInput(text.c_str());
    actor->SetPosition(at[0], at[1]);
    vtkTextProperty* property = actor->GetTextProperty();
    property->SetFontSize(size);
    property->SetColor(color[0], color[1], color[2]);
    property->SetJustification(anchor + 1);
    property->SetVerticalJustificationToCentered();
    this->Renderer->AddViewProp(actor);
  }
  void Save(const std::string& path)
  {
    this->Window->Render();
    const vtkNew<vtkWindowToImageFilter> picture;
    picture->SetInput(this->Window);
    const vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(picture->GetOutputPort());
    writer->SetFileName(path.c_str());
    writer->Write();
  }

private:
  void Head(const Point& from, const Point& to, const Color& color)
  {
    constexpr double kLength = 12.0;
    constexpr double kHalfWidth = 5.0;
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
    const Point along = { (to[0] - from[0]) / length, (to[1] - from[1]) / length };
    const Point foot = { to[0] - kLength * along[0], to[1] - kLength * along[1] };
    this->Fill({ to, { foot[0] - kHalfWidth * along[1], foot[1] + kHalfWidth * along[0] },
                 { foot[0] + kHalfWidth * along[1], foot[1] - kHalfWidth * along[0] } },
      color);
  }
  void Shape(const std::vector<Point>& points, const Color& color, double width, bool filled)
  {
    const vtkNew<vtkPoints> made;
    const vtkNew<vtkCellArray> cells;
    cells->InsertNextCell(static_cast<int>(points.size()));
    for (const Point& point : points)
    {
      cells->InsertCellPoint(made->InsertNextPoint(point[0], point[1], 0.0));
    }
    const vtkNew<vtkPolyData> shape;
    shape->SetPoints(made);
    if (filled)
    {
      shape->SetPolys(cells);
    }
    else
    {
      shape->SetLines(cells);
    }
    const vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(shape);
    const vtkNew<vtkActor2D> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(color[0], color[1], color[2]);
    actor->GetProperty()->SetLineWidth(static_cast<float>(width));
    this->Renderer->AddViewProp(actor);
  }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
};

/// Fills between a curve and a level, in narrow columns.
void FillBelow(Sheet& sheet, const std::function<double(double)>& curve, double bottom, double from,
  double to, const Color& color)
{
  constexpr double kStep = 4.0;
  for (double x = from; x < to; x += kStep)
  {
    const double end = std::min(x + kStep, to);
    sheet.Fill({ { x, bottom }, { end, bottom }, { end, curve(end) }, { x, curve(x) } }, color);
  }
}

/// The ground along the equator, degrees from the origin, in a frame: x and z in kilometres.
Point Place(vtkTerrainGeoreference* frame, double degrees)
{
  double point[3] = { 33.0 + degrees, 0.0, 0.0 };
  frame->PlacesToScene(point, point, 1);
  double origin[3] = { 33.0, 0.0, 0.0 };
  frame->PlacesToScene(origin, origin, 1);
  return { 1e-3 * (point[0] - origin[0]), 1e-3 * point[2] };
}

/// One meridian section for each frame: where the ground goes, and a line every five degrees.
void DrawFrames(const std::string& path)
{
  constexpr int kHeight = 580;
  constexpr double kMost = 30.0;
  constexpr double kPixels = 0.135; // a kilometre
  Sheet sheet(kHeight);
  struct Row
  {
    Frame TheFrame;
    const char* Name;
    const char* Note;
    double Level;
    Color Ink;
  };
  const std::array<Row, 3> rows = { { { Frame::Local, "Local",
                                        "the ground falls away; x, y, z in "
                                        "metres of space",
                                        500.0, kBlue },
    { Frame::Plane, "Plane", "flat: x, y as in Local at sea level, z = height", 290.0, kRed },
    { Frame::Zone, "Zone", "flat: easting, northing of UTM, true lengths near its meridian", 140.0,
      kGreen } } };
  const double middle = kWidth / 2.0;
  for (const Row& row : rows)
  {
    const vtkNew<vtkTerrainGeoreference> frame;
    frame->SetCoordinateSystem("EPSG:4326");
    frame->SetFrame(row.TheFrame);
    frame->SetOrigin(33.0, 0.0, 0.0);
    frame->SetZone(36, true); // 30 E to 36 E
    std::vector<Point> ground;
    for (double degrees = -kMost; degrees <= kMost; degrees += 0.5)
    {
      const Point at = Place(frame, degrees);
      ground.push_back({ middle + kPixels * at[0], row.Level + kPixels * at[1] });
    }
    sheet.Line({ { 60.0, row.Level }, { kWidth - 60.0, row.Level } }, kGrey, 1.0);
    sheet.Line(ground, row.Ink, 4.0);
    for (int degrees = -30; degrees <= 30; degrees += 10)
    {
      const Point at = Place(frame, degrees);
      const Point here = { middle + kPixels * at[0], row.Level + kPixels * at[1] };
      sheet.Line({ { here[0], here[1] - 7.0 }, { here[0], here[1] + 7.0 } }, row.Ink, 2.0);
      sheet.Text(std::to_string(std::abs(degrees)) + "\xC2\xB0" +
          (degrees < 0 ? "W" : (degrees > 0 ? "E" : "")),
        { here[0], here[1] - 22.0 }, kInk, 0, 16);
    }
    sheet.Text(std::string(row.Name) + ": " + row.Note, { middle, row.Level + 40.0 }, row.Ink, 0);
  }
  const double bar = kPixels * 1000.0;
  sheet.Line({ { 60.0, 40.0 }, { 60.0 + bar, 40.0 } }, kInk, 4.0);
  sheet.Text("1000 km, along and up", { 75.0 + bar, 40.0 }, kInk, -1, 16);
  sheet.Text(
    "The ground along the equator, degrees from the origin", { kWidth - 60.0, 40.0 }, kInk, 1, 16);
  sheet.Save(path);
}

/// Ellipsoid, geoid and terrain at a coast, not to scale.
void DrawHeights(const std::string& path)
{
  constexpr int kHeight = 620;
  Sheet sheet(kHeight);
  const auto ellipsoid = [](double x) { return 230.0 - 6e-5 * (x - 600.0) * (x - 600.0); };
  const auto geoid = [&](double x)
  { return ellipsoid(x) - 70.0 + 38.0 * std::sin(0.0042 * (x - 250.0)); };
  const auto terrain = [&](double x)
  {
    const double inland = std::max(0.0, x - 380.0);
    return geoid(x) -
      60.0 * std::exp(-inland / 30.0) * std::min(1.0, (420.0 - std::min(x, 420.0)) / 200.0) +
      330.0 * (1.0 - std::exp(-inland / 260.0)) * (0.75 + 0.25 * std::sin(0.021 * inland)) +
      14.0 * std::sin(0.09 * inland) * std::min(1.0, inland / 120.0);
  };
  const double left = 40.0;
  const double right = kWidth - 170.0;
  FillBelow(sheet, terrain, 40.0, left, right, kGround);
  FillBelow(sheet, [&](double x) { return std::max(geoid(x), terrain(x)); }, 40.0, left, 380.0,
    { 0.80, 0.88, 0.95 });
  FillBelow(sheet, terrain, 40.0, left, right, kGround);
  const auto curve = [&](const std::function<double(double)>& of, double step = 3.0)
  {
    std::vector<Point> points;
    for (double x = left; x <= right; x += step)
    {
      points.push_back({ x, of(x) });
    }
    return points;
  };
  sheet.Line(curve(terrain), kInk, 3.0);
  sheet.Line(curve(ellipsoid), kRed, 3.0);
  sheet.Line(curve(geoid), kBlue, 3.0);
  sheet.Text("terrain", { right + 12.0, terrain(right) }, kInk);
  sheet.Text("ellipsoid", { right + 12.0, ellipsoid(right) }, kRed);
  sheet.Text("geoid", { right + 12.0, geoid(right) }, kBlue);
  sheet.Text("sea", { 120.0, geoid(120.0) - 22.0 }, kBlue, 0);
  const double x = 738.0;
  sheet.Arrow({ x, ellipsoid(x) }, { x, terrain(x) }, kRed, true);
  sheet.Text("h", { x - 14.0, 0.5 * (ellipsoid(x) + terrain(x)) }, kRed, 1, 26);
  sheet.Arrow({ x + 20.0, geoid(x + 20.0) }, { x + 20.0, terrain(x + 20.0) }, kBlue, true);
  sheet.Text("H", { x + 34.0, 0.6 * terrain(x + 20.0) + 0.4 * geoid(x + 20.0) }, kBlue, -1, 26);
  const double y = 620.0;
  sheet.Arrow({ y, geoid(y) }, { y, ellipsoid(y) }, kGreen, true);
  sheet.Text("N", { y + 14.0, 0.5 * (geoid(y) + ellipsoid(y)) }, kGreen, -1, 26);
  sheet.Text("h = H + N", { 90.0, 570.0 }, kInk, -1, 30);
  sheet.Text("h above the ellipsoid (GPS): --vertical ellipsoid", { 90.0, 525.0 }, kRed);
  sheet.Text("H above the geoid, sea level (maps): --vertical geoid", { 90.0, 492.0 }, kBlue);
  sheet.Text("N of the geoid above the ellipsoid, here below 0", { 90.0, 459.0 }, kGreen);
  sheet.Save(path);
}
}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    return EXIT_FAILURE;
  }
  DrawFrames(std::string(argv[1]) + "/frames.png");
  DrawHeights(std::string(argv[1]) + "/heights.png");
  return EXIT_SUCCESS;
}
