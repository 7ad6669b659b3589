// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewMarks.h"

#include "Annotations.h"
#include "Failure.h"
#include "Messages.h"
#include "Options.h"
#include "Placing.h"
#include "Statistics.h"
#include "TextSize.h"
#include "VectorFile.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCoordinate.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkTerrainDrape.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainGraticule.h"
#include "vtkTerrainViewpoint.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>
#include <string>

namespace
{
using Color = std::array<double, 3>;

/// Part of their distance from the eye by which lines and labels are drawn nearer than they are.
constexpr double kNearer = 0.005;
/// In pixels of a picture 720 pixels high.
constexpr double kTrackWidth = 3.0;
constexpr double kPointSize = 11.0;
constexpr double kGraticuleWidth = 1.3;
constexpr double kLabelSize = 15.0;
constexpr Color kTrackColor = { 0.85, 0.10, 0.08 };
constexpr Color kGraticuleColor = { 0.10, 0.12, 0.20 };

double Pixels(double usual, const Options& options)
{
  return usual * std::max(0.5, PixelScale(options));
}

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
  for (int i = 0; i < all->GetNumberOfItems(); ++i)
  {
    props.emplace_back(static_cast<vtkProp*>(all->GetItemAsObject(i)));
  }
  return props;
}

/// A label of the graticule.
vtkSmartPointer<vtkTextActor> MakeLabel(
  const std::string& text, const std::array<double, 3>& point, const Options& options)
{
  auto label = vtkSmartPointer<vtkTextActor>::New();
  label->SetInput(text.c_str());
  label->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  std::array<double, 3> at = point;
  label->GetPositionCoordinate()->SetValue(at.data());
  vtkTextProperty* property = label->GetTextProperty();
  property->SetFontSize(static_cast<int>(Pixels(kLabelSize, options)));
  property->SetColor(kGraticuleColor[0], kGraticuleColor[1], kGraticuleColor[2]);
  property->SetBackgroundColor(1.0, 1.0, 1.0);
  property->SetBackgroundOpacity(0.75);
  property->SetJustificationToCentered();
  property->SetVerticalJustificationToCentered();
  return label;
}
}

//------------------------------------------------------------------------------
bool IsInFront(vtkCamera* camera, const double point[3])
{
  std::array<double, 3> way{};
  vtkMath::Subtract(point, camera->GetPosition(), way.data());
  return vtkMath::Dot(way.data(), camera->GetDirectionOfProjection()) > 0.0;
}

//------------------------------------------------------------------------------
ViewMarks::ViewMarks(vtkRenderer* renderer, const PlacedHeights& heights, const Options& options)
  : Renderer(renderer)
  , Heights(heights)
  , Wanted(options)
{
}

//------------------------------------------------------------------------------
void ViewMarks::AddLines(vtkPolyData* lines, const double color[3], double width, double pointSize)
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
}

//------------------------------------------------------------------------------
vtkIdType ViewMarks::ReadTrack(const std::string& path)
{
  const vtkNew<vtkTerrainDrape> drape;
  drape->SetInputData(ReadVectors(path, this->Heights.Georeference));
  drape->SetHeightsData(this->Heights.Image);
  drape->SetGeoreference(this->Heights.Georeference);
  drape->SetMode(this->Wanted.Place.TrackMode);
  drape->SetExaggeration(this->Heights.Exaggeration);
  drape->Update();
  ThrowOnError(path);
  vtkPolyData* lines = drape->GetOutput();
  if (lines->GetNumberOfCells() == 0)
  {
    throw Failure(path, "it does not meet the terrain");
  }
  this->AddLines(
    lines, kTrackColor.data(), Pixels(kTrackWidth, this->Wanted), Pixels(kPointSize, this->Wanted));
  return lines->GetNumberOfPoints();
}

//------------------------------------------------------------------------------
void ViewMarks::AddGraticuleLabels()
{
  auto* texts = this->GraticuleLabels
    ? vtkStringArray::SafeDownCast(this->GraticuleLabels->GetPointData()->GetAbstractArray("Label"))
    : nullptr;
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const vtkNew<vtkTerrainViewpoint> viewpoint;
  viewpoint->SetHeights(this->Heights.Image);
  viewpoint->SetExaggeration(this->Heights.Exaggeration);
  viewpoint->SetRefraction(1.0); // straight lines, as the picture has them
  for (vtkIdType i = 0; texts && i < this->GraticuleLabels->GetNumberOfPoints(); ++i)
  {
    const std::array<double, 3> point = BringNearer(this->GraticuleLabels->GetPoint(i), camera);
    if (IsInFront(camera, point.data()) &&
      viewpoint->IsVisible(camera->GetPosition(), point.data()))
    {
      this->Renderer->AddViewProp(MakeLabel(texts->GetValue(i), point, this->Wanted));
    }
  }
}

//------------------------------------------------------------------------------
void ViewMarks::ReadGraticule()
{
  const vtkNew<vtkTerrainGraticule> graticule;
  graticule->SetInputData(this->Heights.Image);
  graticule->SetGeoreference(this->Heights.Georeference);
  graticule->SetGrid(*this->Wanted.Place.Graticule);
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
    this->AddLines(
      graticule->GetOutput(), kGraticuleColor.data(), Pixels(kGraticuleWidth, this->Wanted), 1.0);
    this->GraticuleLabels = graticule->GetOutput(1);
  }
}

//------------------------------------------------------------------------------
void ViewMarks::Read(Statistics& statistics)
{
  if (this->Wanted.Place.Graticule)
  {
    this->ReadGraticule();
  }
  vtkIdType points = 0;
  for (const std::string& path : this->Wanted.Place.Tracks)
  {
    points += this->ReadTrack(path);
  }
  if (points > 0)
  {
    statistics.SetCount("track_points", points);
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
  this->AddGraticuleLabels();
  AddOverlay(this->Renderer, this->Heights, this->Wanted);
  this->OfThisView = PropsOf(this->Renderer);
  this->OfThisView.erase(this->OfThisView.begin(),
    this->OfThisView.begin() + static_cast<std::ptrdiff_t>(before.size()));
}
