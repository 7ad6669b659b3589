// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Measure.h"

#include "Readout.h"

#include "vtkAxis.h"
#include "vtkBlockItem.h"
#include "vtkBrush.h"
#include "vtkCellArray.h"
#include "vtkChartXY.h"
#include "vtkCommand.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkContourLineInterpolator.h"
#include "vtkContourWidget.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkOrientedGlyphContourRepresentation.h"
#include "vtkPen.h"
#include "vtkPlot.h"
#include "vtkPointData.h"
#include "vtkPointPlacer.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkTable.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainPicker.h"
#include "vtkTerrainViewpoint.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

/// Puts points where the ray of a pixel meets the terrain.
class Measure::Placer : public vtkPointPlacer
{
public:
  static Placer* New();
  vtkTypeMacro(Placer, vtkPointPlacer)

  vtkTerrainPicker* Picker = nullptr;

  int ComputeWorldPosition(
    vtkRenderer* renderer, double display[2], double world[3], double orientation[9]) override
  {
    if (!this->Picker->Pick(display[0] + 0.5, display[1] + 0.5, 0.0, renderer) ||
      !this->Picker->IsTerrainPicked())
    {
      return 0;
    }
    std::copy_n(this->Picker->GetPickPosition(), 3, world);
    constexpr std::array<double, 9> kUpright = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
    std::copy(kUpright.begin(), kUpright.end(), orientation);
    return 1;
  }
  int ComputeWorldPosition(vtkRenderer* renderer, double display[2], double*, double world[3],
    double orientation[9]) override
  {
    return this->ComputeWorldPosition(renderer, display, world, orientation);
  }
  int ValidateWorldPosition(double*) override
  {
    return 1;
  }
  int ValidateWorldPosition(double*, double*) override
  {
    return 1;
  }
};

/// Lays the line between two points onto the ground.
class Measure::Ground : public vtkContourLineInterpolator
{
public:
  static Ground* New();
  vtkTypeMacro(Ground, vtkContourLineInterpolator)

  vtkTerrainPicker* Picker = nullptr;
  vtkTerrainActor* Terrain = nullptr;

  int InterpolateLine(vtkRenderer*, vtkContourRepresentation* line, int first, int second) override
  {
    std::array<double, 3> from{};
    std::array<double, 3> to{};
    line->GetNthNodeWorldPosition(first, from.data());
    line->GetNthNodeWorldPosition(second, to.data());
    const vtkNew<vtkPolyData> profile;
    this->Picker->GetProfile(this->Terrain, from.data(), to.data(), profile);
    for (vtkIdType k = 1; k + 1 < profile->GetNumberOfPoints(); ++k)
    {
      line->AddIntermediatePointWorldPosition(first, profile->GetPoint(k));
    }
    return 1;
  }
};

vtkStandardNewMacro(Measure::Placer);
vtkStandardNewMacro(Measure::Ground);

namespace
{
/// Shares of the window: left, low, width, height of the plot of the profile.
constexpr std::array<double, 4> kPlot = { 0.30, 0.02, 0.52, 0.26 };

std::string Metres(double metres)
{
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), metres < 1e4 ? "%.1f m" : "%.3f km",
    metres < 1e4 ? metres : metres / 1e3);
  return text.data();
}

std::string SquareMetres(double area)
{
  std::array<char, 48> text{};
  std::snprintf(
    text.data(), text.size(), area < 1e6 ? "%.0f m2" : "%.4f km2", area < 1e6 ? area : area / 1e6);
  return text.data();
}

void SetUpAxis(vtkAxis* axis, const char* title)
{
  axis->SetTitle(title);
  axis->GetTitleProperties()->SetFontSize(12);
  axis->GetTitleProperties()->BoldOff();
  axis->GetLabelProperties()->SetFontSize(11);
}
}

//------------------------------------------------------------------------------
Measure::Measure(vtkTerrainPicker* picker, vtkRenderWindowInteractor* interactor,
  vtkRenderer* renderer, vtkTerrainActor* terrain, const Readout& places,
  std::function<void()> changed)
  : Terrain(terrain)
  , Places(places)
  , Changed(std::move(changed))
  , Picker(picker)
{
  const vtkNew<Placer> placer;
  placer->Picker = this->Picker;
  const vtkNew<Ground> ground;
  ground->Picker = this->Picker;
  ground->Terrain = terrain;
  this->Line->SetRenderer(renderer); // it asks for the camera at once
  this->Line->SetPointPlacer(placer);
  this->Line->SetLineInterpolator(ground);
  this->Line->AlwaysOnTopOn();
  this->Line->GetLinesProperty()->SetColor(0.9, 0.1, 0.1);
  this->Line->GetLinesProperty()->SetLineWidth(2.5F);
  this->Line->GetProperty()->SetColor(0.6, 0.0, 0.0);
  this->Widget->KeyPressActivationOff(); // which would take the key i
  this->Widget->SetInteractor(interactor);
  this->Widget->SetDefaultRenderer(renderer);
  this->Widget->SetRepresentation(this->Line);
  for (const auto event :
    { vtkCommand::InteractionEvent, vtkCommand::EndInteractionEvent, vtkCommand::PlacePointEvent })
  {
    this->Widget->AddObserver(event, this, &Measure::PointsChanged);
  }
  this->Chart->SetAutoSize(false);
  this->Chart->SetShowLegend(false);
  SetUpAxis(this->Chart->GetAxis(vtkAxis::BOTTOM), "Distance in metres");
  SetUpAxis(this->Chart->GetAxis(vtkAxis::LEFT), "Height");
  this->Panel->GetBrush()->SetColorF(1.0, 1.0, 1.0, 0.8);
  this->Panel->GetPen()->SetLineType(vtkPen::NO_PEN);
  this->Plot->GetScene()->AddItem(this->Panel);
  this->Plot->GetScene()->AddItem(this->Chart);
  this->Plot->PickableOff();
  this->Plot->VisibilityOff();
  renderer->AddViewProp(this->Plot);
}

//------------------------------------------------------------------------------
Measure::~Measure()
{
  this->Widget->SetInteractor(nullptr);
}

//------------------------------------------------------------------------------
bool Measure::IsOn() const
{
  return this->Widget->GetEnabled() != 0;
}

//------------------------------------------------------------------------------
void Measure::Switch()
{
  this->Told.clear();
  this->Plot->VisibilityOff();
  if (this->IsOn())
  {
    this->Widget->EnabledOff();
    return;
  }
  this->Line->ClearAllNodes();
  this->Line->ClosedLoopOff();
  this->Widget->SetWidgetState(vtkContourWidget::Start);
  this->Widget->EnabledOn();
}

//------------------------------------------------------------------------------
std::string Measure::Describe() const
{
  return this->Told;
}

//------------------------------------------------------------------------------
void Measure::Refresh()
{
  if (!this->IsOn())
  {
    return;
  }
  const vtkNew<vtkTerrainViewpoint> ground;
  ground->SetHeights(this->Terrain->GetHeights());
  ground->SetExaggeration(this->Terrain->GetVerticalExaggeration());
  for (int k = 0; k < this->Line->GetNumberOfNodes(); ++k)
  {
    std::array<double, 3> point{};
    this->Line->GetNthNodeWorldPosition(k, point.data());
    const double height = ground->GetGround(point[0], point[1]);
    point[2] = std::isfinite(height) ? height : point[2];
    this->Line->SetNthNodeWorldPosition(k, point.data());
  }
  this->PointsChanged();
}

//------------------------------------------------------------------------------
double Measure::DistanceOf(const double from[3], const double to[3]) const
{
  const double flat = std::hypot(to[0] - from[0], to[1] - from[1]);
  std::array<std::array<double, 3>, 2> ends{};
  if (!this->Places.ToPlace(from, ends[0].data()) || !this->Places.ToPlace(to, ends[1].data()))
  {
    return flat;
  }
  const vtkSmartPointer<vtkTerrainViewpoint> earth = this->Places.MakeViewpoint();
  earth->GetGeoreference()->PlacesToScene(ends[0].data(), ends[0].data(), 2);
  const double distance = earth->GetDistance(ends[0].data(), ends[1].data());
  return std::isfinite(distance) ? distance : flat;
}

//------------------------------------------------------------------------------
double Measure::AreaOf(double& border) const
{
  const vtkNew<vtkPoints> corners;
  corners->SetDataTypeToDouble();
  const vtkSmartPointer<vtkTerrainViewpoint> earth = this->Places.MakeViewpoint();
  double area = 0.0;
  border = 0.0;
  const int count = this->Line->GetNumberOfNodes();
  bool hasPlaces = true;
  for (int k = 0; k < count; ++k)
  {
    std::array<double, 3> here{};
    std::array<double, 3> next{};
    std::array<double, 3> place{};
    this->Line->GetNthNodeWorldPosition(k, here.data());
    this->Line->GetNthNodeWorldPosition((k + 1) % count, next.data());
    area += 0.5 * (here[0] * next[1] - next[0] * here[1]);
    border += std::hypot(next[0] - here[0], next[1] - here[1]);
    hasPlaces = hasPlaces && this->Places.ToPlace(here.data(), place.data()) &&
      earth->GetGeoreference()->PlacesToScene(place.data(), place.data(), 1);
    corners->InsertNextPoint(place.data());
  }
  double perimeter = 0.0;
  const double onEarth = hasPlaces ? earth->GetArea(corners, &perimeter) : NAN;
  border = std::isfinite(onEarth) ? perimeter : border;
  return std::abs(std::isfinite(onEarth) ? onEarth : area);
}

//------------------------------------------------------------------------------
void Measure::PointsChanged()
{
  const bool isArea = this->Line->GetClosedLoop() != 0;
  const int count = this->Line->GetNumberOfNodes();
  std::vector<double> distances;
  std::vector<double> heights;
  double way = 0.0;
  double overGround = 0.0;
  for (int k = 0; k + 1 < count + (isArea ? 1 : 0); ++k)
  {
    std::array<double, 3> from{};
    std::array<double, 3> to{};
    this->Line->GetNthNodeWorldPosition(k, from.data());
    this->Line->GetNthNodeWorldPosition((k + 1) % count, to.data());
    const vtkNew<vtkPolyData> profile;
    this->Picker->GetProfile(this->Terrain, from.data(), to.data(), profile);
    vtkDataArray* along = profile->GetPointData()->GetArray("Distance");
    vtkDataArray* height = profile->GetPointData()->GetArray("Height");
    const double length = this->DistanceOf(from.data(), to.data());
    const double flat = std::hypot(to[0] - from[0], to[1] - from[1]);
    const double scale = flat > 0.0 ? length / flat : 1.0;
    for (vtkIdType p = 0; p < profile->GetNumberOfPoints(); ++p)
    {
      const double at = way + scale * along->GetComponent(p, 0);
      overGround += p == 0 || distances.empty()
        ? 0.0
        : std::hypot(at - distances.back(), height->GetComponent(p, 0) - heights.back());
      distances.push_back(at);
      heights.push_back(height->GetComponent(p, 0));
    }
    way += length;
  }
  this->Told.clear();
  if (way > 0.0 && !heights.empty())
  {
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), "  heights %.1f to %.1f", *low, *high);
    this->Told =
      "distance " + Metres(way) + "  over the ground " + Metres(overGround) + text.data();
    if (isArea)
    {
      double border = 0.0;
      const double area = this->AreaOf(border);
      this->Told += "\narea " + SquareMetres(area) + "  border " + Metres(border);
    }
  }
  this->ShowProfile(distances, heights);
  this->Changed();
}

//------------------------------------------------------------------------------
void Measure::ShowProfile(const std::vector<double>& distances, const std::vector<double>& heights)
{
  this->Chart->ClearPlots();
  this->Plot->SetVisibility(distances.size() > 1);
  if (distances.size() < 2)
  {
    return;
  }
  const vtkNew<vtkTable> table;
  for (const auto& [name, values] : { std::pair("Distance", &distances), { "Height", &heights } })
  {
    const vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    for (const double value : *values)
    {
      array->InsertNextValue(value);
    }
    table->AddColumn(array);
  }
  vtkPlot* plot = this->Chart->AddPlot(vtkChart::LINE);
  plot->SetInputData(table, 0, 1);
  plot->GetPen()->SetColorF(0.6, 0.0, 0.0);
  plot->SetWidth(1.5F);
  const int* size = this->Widget->GetDefaultRenderer()->GetSize();
  std::array<float, 4> place{};
  for (std::size_t k = 0; k < place.size(); ++k)
  {
    place[k] = static_cast<float>(kPlot[k] * size[k % 2]);
  }
  this->Panel->SetDimensions(place[0], place[1], place[2], place[3]);
  this->Chart->SetSize(vtkRectf(place[0], place[1], place[2], place[3]));
  this->Chart->RecalculateBounds();
}
