// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewMarks.h"

#include "Annotations.h"
#include "DataRim.h"
#include "Failure.h"
#include "Messages.h"
#include "Options.h"
#include "Placing.h"
#include "Statistics.h"
#include "TextSize.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOutlineSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainGraticule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>

namespace
{
using Color = std::array<double, 3>;

/// Part of their distance from the eye by which lines and labels are drawn nearer than they are.
constexpr double kNearer = 0.005;
/// In pixels of a picture 720 pixels high.
constexpr double kGraticuleWidth = 1.3;
constexpr double kOutlineWidth = 1.5;
constexpr Color kGraticuleColor = { 0.10, 0.12, 0.20 };
constexpr TextStyle kTitleStyle = { 0.05, true, 0.0 };
constexpr TextStyle kCaptionStyle = { 0.022, false, 0.6 };
constexpr TextStyle kPlaceStyle = { 0.024, false, 0.75 };
constexpr TextStyle kGraticuleStyle = { 0.021, false, 0.75 };

/// A point moved towards the eye.
std::array<double, 3> BringNearer(const double point[3], vtkCamera* camera)
{
  std::array<double, 3> nearer{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    nearer[axis] = point[axis] + kNearer * (camera->GetPosition()[axis] - point[axis]);
  }
  return nearer;
}

/// All props of a renderer.
std::vector<vtkSmartPointer<vtkProp>> PropsOf(vtkRenderer* renderer)
{
  std::vector<vtkSmartPointer<vtkProp>> props;
  vtkPropCollection* all = renderer->GetViewProps();
  props.reserve(static_cast<std::size_t>(all->GetNumberOfItems()));
  for (int i = 0; i < all->GetNumberOfItems(); ++i)
  {
    props.emplace_back(static_cast<vtkProp*>(all->GetItemAsObject(i)));
  }
  return props;
}
}

//------------------------------------------------------------------------------
ViewMarks::ViewMarks(
  vtkRenderer* renderer, const PlacedHeights& heights, const ScaledBox& box, const Options& options)
  : Renderer(renderer)
  , Heights(heights)
  , Wanted(options)
  , Sight(vtkSmartPointer<vtkTerrainViewpoint>::New())
  , Box(box)
{
  this->Sight->SetHeights(heights.Image);
  this->Sight->SetExaggeration(heights.Exaggeration);
  this->Sight->SetRefraction(1.0); // straight lines, as the picture has them
}

//------------------------------------------------------------------------------
vtkActor* ViewMarks::AddLines(
  vtkPolyData* lines, const double color[3], double width, double pointSize)
{
  Nearer nearer;
  nearer.Points = lines->GetPoints();
  nearer.Drawn = vtkSmartPointer<vtkPoints>::New();
  nearer.Drawn->SetDataType(nearer.Points->GetDataType());
  nearer.Drawn->DeepCopy(nearer.Points);
  lines->SetPoints(nearer.Drawn);
  this->Lines.push_back(nearer);
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(lines);
  mapper->ScalarVisibilityOff();
  const vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetColor(color[0], color[1], color[2]);
  property->LightingOff();
  property->SetLineWidth(static_cast<float>(width));
  property->SetPointSize(static_cast<float>(pointSize));
  property->RenderPointsAsSpheresOn();
  this->Renderer->AddActor(actor);
  return actor;
}

//------------------------------------------------------------------------------
std::optional<std::array<double, 2>> ViewMarks::Find(
  LabelPlacer& placer, const double point[3], double pixels) const
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const std::optional<std::array<double, 2>> at = placer.ToPixels(point);
  std::array<double, 3> seen = BringNearer(point, camera);
  const double away =
    std::sqrt(vtkMath::Distance2BetweenPoints(camera->GetPosition(), seen.data()));
  const double rise = 2.0 * pixels / this->Wanted.Size[1] * away *
    std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    seen[axis] += rise * camera->GetViewUp()[axis];
  }
  return at && this->Sight->IsVisible(camera->GetPosition(), seen.data()) ? at : std::nullopt;
}

//------------------------------------------------------------------------------
void ViewMarks::AddTitles(LabelPlacer& placer) const
{
  const double width = this->Wanted.Size[0];
  const double height = this->Wanted.Size[1];
  const double title = TextPixels(kTitleStyle.Size, this->Wanted);
  const double caption = TextPixels(kCaptionStyle.Size, this->Wanted);
  // text of several lines stands as near to the border as one line
  const auto place =
    [&](const std::string& option, const std::string& text, double size, const TextStyle& style)
  {
    if (text.empty())
    {
      return;
    }
    const std::array<double, 2> box = placer.SizeOf(text, style);
    const double away = std::max(1.2 * size, 0.5 * size + 0.5 * box[1]);
    const double y = option == "--title" ? height - away : away;
    if (!placer.PlaceCentred(text, 0.5 * width, y, style))
    {
      const char* much = box[0] > width ? "wider" : "higher";
      throw Failure(option,
        "'" + text + "' is " + much +
          " than the picture has room for: shorten it, or draw a larger picture (--size)");
    }
  };
  place("--title", this->Wanted.Marks.Title, title, kTitleStyle);
  place("--caption", this->Wanted.Marks.Caption, caption, kCaptionStyle);
}

//------------------------------------------------------------------------------
void ViewMarks::TellWide(const LabelPlacer& placer)
{
  std::vector<std::string> wide;
  for (const Label& label : this->Labels)
  {
    if (placer.SizeOf(label.Text, kPlaceStyle)[0] > this->Wanted.Size[0])
    {
      wide.push_back(label.Text);
    }
  }
  if (!wide.empty())
  {
    std::string text = "--labels: '" + wide.front() + "' is wider than the picture: it is left out";
    text += wide.size() > 1 ? ", with " + std::to_string(wide.size() - 1) + " more" : "";
    Warn(text);
  }
  this->HasToldWide = true;
}

//------------------------------------------------------------------------------
void ViewMarks::Tell(const std::string& text, const PixelBox& box)
{
  std::ostringstream told;
  told << text << ": " << box.Left << ' ' << box.Low << ' ' << box.Right << ' ' << box.High;
  this->Placed.push_back(told.str());
}

//------------------------------------------------------------------------------
void ViewMarks::AddLabels(LabelPlacer& placer)
{
  this->Placed.clear();
  if (!this->HasToldWide)
  {
    this->TellWide(placer);
  }
  for (const Label& label : this->Labels)
  {
    const std::optional<std::array<double, 2>> at =
      this->Find(placer, label.Point.data(), TextPixels(kPlaceStyle.Size, this->Wanted));
    const std::optional<PixelBox> box =
      at ? placer.PlaceAbove(label.Text, (*at)[0], (*at)[1], kPlaceStyle) : std::nullopt;
    if (box)
    {
      this->Tell(label.Text, *box);
    }
  }
}

//------------------------------------------------------------------------------
void ViewMarks::AddGraticuleLabels(LabelPlacer& placer) const
{
  auto* texts = this->GraticuleLabels
    ? vtkStringArray::SafeDownCast(this->GraticuleLabels->GetPointData()->GetAbstractArray("Label"))
    : nullptr;
  for (vtkIdType i = 0; texts && i < this->GraticuleLabels->GetNumberOfPoints(); ++i)
  {
    if (const auto at = this->Find(placer, this->GraticuleLabels->GetPoint(i), 0.0))
    {
      placer.PlaceCentred(texts->GetValue(i), (*at)[0], (*at)[1], kGraticuleStyle);
    }
  }
}

//------------------------------------------------------------------------------
void ViewMarks::ReadGraticule(vtkTerrainGraticule::GridType grid)
{
  const vtkNew<vtkTerrainGraticule> graticule;
  graticule->SetInputData(this->Heights.Image);
  graticule->SetGeoreference(this->Heights.Georeference);
  graticule->SetGrid(grid);
  graticule->SetExaggeration(this->Heights.Exaggeration);
  if (this->Heights.IsGlobe())
  {
    // above what VTK's depth buffer can tell from space
    constexpr double kOffset = 1500.0;
    graticule->SetOffset(kOffset);
    graticule->SetStep(15.0);
  }
  graticule->Update();
  ThrowOnError("--graticule");
  if (graticule->GetOutput()->GetNumberOfCells() > 0)
  {
    this->AddLines(graticule->GetOutput(), kGraticuleColor.data(),
      LinePixels(kGraticuleWidth, this->Wanted), 1.0);
    this->GraticuleLabels = graticule->GetOutput(1);
  }
}

//------------------------------------------------------------------------------
void ViewMarks::ShowInset(vtkScalarsToColors* colors)
{
  this->Inset.emplace(this->Heights.Image, colors, this->Box.Bounds, this->Wanted);
}

//------------------------------------------------------------------------------
void ViewMarks::ReadOutline()
{
  if (this->Wanted.Marks.Outline == "box")
  {
    const vtkNew<vtkOutlineSource> box;
    box->SetBounds(this->Box.Bounds.data());
    box->Update();
    this->AddLines(
      box->GetOutput(), kGraticuleColor.data(), LinePixels(kOutlineWidth, this->Wanted), 1.0);
    return;
  }
  const DataRim rim(this->Heights.Image);
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const vtkNew<vtkCellArray> sides;
  const auto add = [&](vtkIdType sample)
  {
    std::array<double, 3> point = rim.GetPoint(sample, 0.0);
    point[2] = this->Sight->GetGround(point[0], point[1]);
    return points->InsertNextPoint(point.data());
  };
  for (const DataRim::Side& side : rim.FindSides())
  {
    const vtkIdType from = add(side.From);
    sides->InsertNextCell({ from, add(side.To) });
  }
  const vtkNew<vtkPolyData> edge;
  edge->SetPoints(points);
  edge->SetLines(sides);
  this->AddLines(edge, kGraticuleColor.data(), LinePixels(kOutlineWidth, this->Wanted), 1.0);
}

//------------------------------------------------------------------------------
void ViewMarks::Read(Statistics& statistics)
{
  if (!this->Wanted.Marks.Outline.empty())
  {
    this->ReadOutline();
  }
  if (this->Wanted.Marks.ContourLabels)
  {
    if (this->Heights.Image->GetPointData()->GetArray("PlaceHeight"))
    {
      throw Failure("--contour-labels",
        "z is not the height in this scene, which is round: choose --frame plane or map");
    }
    this->ContourPlaces = FindContourPlaces(this->Heights.Image,
      this->Wanted.Surface.Contours * std::max(1, this->Wanted.Surface.ContourIndex));
  }
  if (const auto& grid = this->Wanted.Place.Graticule)
  {
    this->ReadGraticule(*grid);
  }
  if (!this->Wanted.Place.Tracks.empty())
  {
    this->ReadTracks(statistics);
  }
  if (!this->Wanted.Marks.Labels.empty())
  {
    this->Labels = ReadLabels(this->Wanted.Marks.Labels, this->Heights);
  }
  if (this->Wanted.Marks.Peaks > 0)
  {
    const std::vector<Label> peaks =
      FindPeakLabels(this->Wanted.Marks.Peaks, this->Heights, this->Wanted.Scenery.Water);
    this->Labels.insert(this->Labels.end(), peaks.begin(), peaks.end());
  }
}

//------------------------------------------------------------------------------
void ViewMarks::Refresh()
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  for (const Nearer& lines : this->Lines)
  {
    for (vtkIdType i = 0; i < lines.Points->GetNumberOfPoints(); ++i)
    {
      lines.Drawn->SetPoint(i, BringNearer(lines.Points->GetPoint(i), camera).data());
    }
    lines.Drawn->Modified();
  }
  for (vtkProp* prop : this->OfThisView)
  {
    this->Renderer->RemoveViewProp(prop);
  }
  const std::vector<vtkSmartPointer<vtkProp>> before = PropsOf(this->Renderer);
  AddOverlay(this->Renderer, this->Heights, this->Wanted);
  if (this->Inset)
  {
    this->Inset->AddTo(this->Renderer);
  }
  LabelPlacer placer(this->Renderer, this->Wanted);
  placer.ReserveProps();
  this->AddTitles(placer);
  if (this->Wanted.Marks.HeightScale &&
    !AddHeightScale(this->Renderer, placer, this->Box, this->Wanted))
  {
    Warn("--height-scale: no corner of the terrain is in the picture");
  }
  this->AddLabels(placer);
  this->AddContourLabels(placer);
  this->AddGraticuleLabels(placer);
  this->OfThisView = PropsOf(this->Renderer);
  this->OfThisView.erase(this->OfThisView.begin(),
    this->OfThisView.begin() + static_cast<std::ptrdiff_t>(before.size()));
}
