// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelPlacer.h"

#include "Fonts.h"
#include "MarkColors.h"
#include "Options.h"
#include "TextSize.h"

#include "vtkActor2D.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCoordinate.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkPropCollection.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"

#include <algorithm>
#include <cmath>

namespace
{
/// Dots per inch that VTK's text actors count on in a window of its own.
constexpr int kTextDots = 72;
/// Heights of a text above its point, in heights of a text.
constexpr std::array<double, 5> kLifts = { 1.0, 2.2, 3.6, 5.2, 7.0 };

/// The rectangle of a text whose anchor lies at the origin.
PixelBox BoxOfText(vtkTextActor* text)
{
  std::array<int, 4> box{};
  if (text->GetInput() && *text->GetInput())
  {
    vtkTextRenderer::GetInstance()->GetBoundingBox(
      text->GetTextProperty(), text->GetInput(), box.data(), kTextDots);
  }
  return { static_cast<double>(box[0]), box[1] + 1.0, static_cast<double>(box[2]), box[3] + 1.0 };
}

PixelBox BoxOf(vtkActor2D* actor)
{
  PixelBox box;
  if (auto* text = vtkTextActor::SafeDownCast(actor))
  {
    box = BoxOfText(text);
  }
  else if (auto* mapper = vtkPolyDataMapper2D::SafeDownCast(actor->GetMapper()))
  {
    mapper->Update();
    const double* bounds = mapper->GetInput()->GetBounds();
    box = { bounds[0], bounds[1], bounds[2], bounds[3] };
  }
  const double* at = actor->GetPosition();
  return { box.Left + at[0], box.Right + at[0], box.Low + at[1], box.High + at[1] };
}

/// A line in pixels, and a dot at its lower end.
vtkSmartPointer<vtkActor2D> MakeLeader(double x, double low, double high, double width)
{
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkCellArray> cells;
  const auto add = [&](double left, double right, double bottom, double top)
  {
    const vtkIdType first = points->InsertNextPoint(left, bottom, 0.0);
    points->InsertNextPoint(right, bottom, 0.0);
    points->InsertNextPoint(right, top, 0.0);
    points->InsertNextPoint(left, top, 0.0);
    cells->InsertNextCell({ first, first + 1, first + 2, first + 3 });
  };
  add(x - 0.5 * width, x + 0.5 * width, low, high);
  add(x - 1.5 * width, x + 1.5 * width, low - 1.5 * width, low + 1.5 * width);
  const vtkNew<vtkPolyData> shape;
  shape->SetPoints(points);
  shape->SetPolys(cells);
  const vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(shape);
  auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(kDarkMark[0], kDarkMark[1], kDarkMark[2]);
  return actor;
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
LabelPlacer::LabelPlacer(vtkRenderer* renderer, const Options& options)
  : Renderer(renderer)
  , Wanted(options)
{
}

//------------------------------------------------------------------------------
void LabelPlacer::ReserveProps()
{
  vtkPropCollection* props = this->Renderer->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
  {
    if (auto* actor = vtkActor2D::SafeDownCast(props->GetItemAsObject(i)))
    {
      this->Taken.push_back(BoxOf(actor));
    }
  }
}

//------------------------------------------------------------------------------
std::optional<std::array<double, 2>> LabelPlacer::ToPixels(const double point[3]) const
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  if (!IsInFront(camera, point))
  {
    return std::nullopt;
  }
  const double width = this->Wanted.Size[0];
  const double height = this->Wanted.Size[1];
  std::array<double, 4> at = { point[0], point[1], point[2], 1.0 };
  camera->GetCompositeProjectionTransformMatrix(width / height, -1.0, 1.0)
    ->MultiplyPoint(at.data(), at.data());
  const double x = 0.5 * width * (at[0] / at[3] + 1.0);
  const double y = 0.5 * height * (at[1] / at[3] + 1.0);
  const bool isInside = x >= 0.0 && x < width && y >= 0.0 && y < height;
  return isInside ? std::optional(std::array<double, 2>{ x, y }) : std::nullopt;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTextActor> LabelPlacer::MakeText(
  const std::string& text, const TextStyle& style) const
{
  constexpr int kSmallest = 8;
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetInput(text.c_str());
  vtkTextProperty* property = actor->GetTextProperty();
  property->SetFontSize(
    std::max(kSmallest, static_cast<int>(TextPixels(style.Size, this->Wanted))));
  property->SetBold(style.IsBold);
  property->SetOrientation(style.Turn);
  ChooseFont(property, text);
  const bool isLight = style.Backing == 0.0 && IsDarkBehind(this->Renderer, true);
  const auto& [r, g, b] = isLight ? kLightMark : kDarkMark;
  property->SetColor(r, g, b);
  property->SetBackgroundColor(1.0, 1.0, 1.0);
  property->SetBackgroundOpacity(style.Backing);
  property->SetJustificationToCentered();
  property->SetVerticalJustificationToBottom();
  return actor;
}

//------------------------------------------------------------------------------
std::optional<PixelBox> LabelPlacer::Place(
  const std::string& text, double x, double low, const TextStyle& style)
{
  const vtkSmartPointer<vtkTextActor> actor = this->MakeText(text, style);
  actor->SetPosition(std::round(x), std::round(low));
  const PixelBox box = BoxOf(actor);
  const double margin = std::max(2.0, 3.0 * PixelScale(this->Wanted));
  const bool isInside = box.Left >= 0.0 && box.Right <= this->Wanted.Size[0] && box.Low >= 0.0 &&
    box.High <= this->Wanted.Size[1];
  const bool isFree = std::none_of(this->Taken.begin(), this->Taken.end(),
    [&](const PixelBox& taken) { return box.Meets(taken, margin); });
  if (!isInside || !isFree)
  {
    return std::nullopt;
  }
  this->Taken.push_back(box);
  this->Renderer->AddViewProp(actor);
  return box;
}

//------------------------------------------------------------------------------
std::array<double, 2> LabelPlacer::SizeOf(const std::string& text, const TextStyle& style) const
{
  const PixelBox box = BoxOfText(this->MakeText(text, style));
  return { box.Right - box.Left, box.High - box.Low };
}

//------------------------------------------------------------------------------
std::optional<PixelBox> LabelPlacer::PlaceCentred(
  const std::string& text, double x, double y, const TextStyle& style)
{
  const vtkSmartPointer<vtkTextActor> actor = this->MakeText(text, style);
  const PixelBox box = BoxOfText(actor);
  return this->Place(text, x - 0.5 * (box.Left + box.Right), y - 0.5 * (box.Low + box.High), style);
}

//------------------------------------------------------------------------------
std::optional<PixelBox> LabelPlacer::PlaceAbove(
  const std::string& text, double x, double y, const TextStyle& style)
{
  const double height = TextPixels(style.Size, this->Wanted);
  const double width = std::max(1.0, 1.5 * PixelScale(this->Wanted));
  for (const std::array<double, 2>& anchor : this->Anchors)
  {
    if (std::hypot(anchor[0] - x, anchor[1] - y) < height)
    {
      return std::nullopt; // it has its label
    }
  }
  for (const double lift : kLifts)
  {
    const double low = y + lift * height;
    const PixelBox leader = { x - width, x + width, y, low };
    const bool isFree = std::none_of(this->Taken.begin(), this->Taken.end(),
      [&](const PixelBox& taken) { return leader.Meets(taken, 0.0); });
    const std::optional<PixelBox> box = isFree ? this->Place(text, x, low, style) : std::nullopt;
    if (box)
    {
      this->Renderer->AddViewProp(MakeLeader(x, y, box->Low, width));
      this->Anchors.push_back({ x, y });
      this->Taken.push_back(leader);
      return box;
    }
  }
  return std::nullopt;
}
