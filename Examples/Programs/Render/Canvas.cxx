// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Canvas.h"

#include "Frames.h"
#include "Messages.h"
#include "Options.h"
#include "Outputs.h"
#include "Statistics.h"

#include "vtkActor2D.h"
#include "vtkCamera.h"
#include "vtkCoordinate.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace
{
/// Width of the border of a piece that is thrown away, in shares of the picture's height and in
/// pixels: more than half of the largest point.
constexpr double kMarginShare = 0.01;
constexpr int kMarginPixels = 8;

/// True if a prop lies in pixels of the view.
bool LiesInPixels(vtkActor2D* actor)
{
  return actor->GetPositionCoordinate()->GetCoordinateSystem() == VTK_VIEWPORT;
}

/// Shows a piece of the view of a renderer while it lives.
class PieceOfView
{
public:
  PieceOfView(vtkRenderer* renderer, const std::array<int, 2>& place,
    const std::array<int, 2>& piece, const std::array<int, 2>& whole)
    : Renderer(renderer)
    , Place(place)
    , Angle(renderer->GetActiveCamera()->GetViewAngle())
  {
    renderer->GetBackground(this->Low.data());
    renderer->GetBackground2(this->High.data());
    vtkCamera* camera = renderer->GetActiveCamera();
    const double slope = std::tan(0.5 * vtkMath::RadiansFromDegrees(this->Angle));
    camera->SetViewAngle(2.0 * vtkMath::DegreesFromRadians(std::atan(slope * piece[1] / whole[1])));
    const auto centre = [&](int axis)
    { return (2.0 * place[axis] + piece[axis] - whole[axis]) / piece[axis]; };
    camera->SetWindowCenter(centre(0), centre(1));
    if (renderer->GetGradientBackground())
    {
      const std::array<double, 3> low = this->ColorAt(place[1], whole[1]);
      const std::array<double, 3> high = this->ColorAt(place[1] + piece[1], whole[1]);
      renderer->SetBackground(low.data());
      renderer->SetBackground2(high.data());
    }
    this->Move(-1);
  }
  ~PieceOfView()
  {
    this->Move(1);
    this->Renderer->SetBackground(this->Low.data());
    this->Renderer->SetBackground2(this->High.data());
    this->Renderer->GetActiveCamera()->SetViewAngle(this->Angle);
    this->Renderer->GetActiveCamera()->SetWindowCenter(0.0, 0.0);
  }
  PieceOfView(const PieceOfView&) = delete;
  PieceOfView& operator=(const PieceOfView&) = delete;

private:
  /// Colour of the background at a row of the whole; it goes on beyond its borders.
  std::array<double, 3> ColorAt(int row, int rows) const
  {
    std::array<double, 3> color{};
    for (std::size_t k = 0; k < color.size(); ++k)
    {
      color[k] = this->Low[k] + (this->High[k] - this->Low[k]) * row / rows;
    }
    return color;
  }
  void Move(int sign) const
  {
    vtkPropCollection* props = this->Renderer->GetViewProps();
    for (int i = 0; i < props->GetNumberOfItems(); ++i)
    {
      auto* actor = vtkActor2D::SafeDownCast(props->GetItemAsObject(i));
      if (actor && LiesInPixels(actor))
      {
        actor->SetPosition(actor->GetPosition()[0] + sign * this->Place[0],
          actor->GetPosition()[1] + sign * this->Place[1]);
      }
    }
  }

  vtkRenderer* Renderer;
  std::array<int, 2> Place;
  double Angle;
  std::array<double, 3> Low{};
  std::array<double, 3> High{};
};

int MarginOf(const Options& options)
{
  return kMarginPixels + static_cast<int>(std::ceil(kMarginShare * options.Size[1]));
}

/// Where the pieces of a side begin, margins included.
std::vector<int> BeginsOf(int whole, int piece, int margin)
{
  std::vector<int> begins;
  if (whole <= piece)
  {
    return { 0 };
  }
  for (int begin = 0; begin < whole; begin += piece - 2 * margin)
  {
    begins.push_back(begin - margin);
  }
  return begins;
}
}

//------------------------------------------------------------------------------
std::array<int, 2> PieceSize(const Options& options)
{
  return { std::min(options.Size[0], options.Piece), std::min(options.Size[1], options.Piece) };
}

//------------------------------------------------------------------------------
Canvas::Canvas(vtkRenderWindow* window, vtkRenderer* renderer, const Options& options)
  : Window(window)
  , Renderer(renderer)
  , Wanted(options)
  , Piece(PieceSize(options))
  , Margin(MarginOf(options))
{
  for (const int row : BeginsOf(options.Size[1], this->Piece[1], this->Margin))
  {
    for (const int column : BeginsOf(options.Size[0], this->Piece[0], this->Margin))
    {
      this->Places.push_back({ column, row });
    }
  }
}

//------------------------------------------------------------------------------
void Canvas::CopyMiddle(vtkImageData* piece, const Place& place, vtkImageData* all) const
{
  std::array<int, 2> first{};
  std::array<int, 2> end{};
  for (int axis = 0; axis < 2; ++axis)
  {
    const bool isWhole = this->Wanted.Size[axis] <= this->Piece[axis];
    first[axis] = isWhole ? 0 : this->Margin;
    end[axis] = std::min(isWhole ? this->Piece[axis] : this->Piece[axis] - this->Margin,
      this->Wanted.Size[axis] - place[axis]);
  }
  const auto bytes = static_cast<std::size_t>(end[0] - first[0]) *
    static_cast<std::size_t>(all->GetScalarSize() * all->GetNumberOfScalarComponents());
  for (int row = first[1]; row < end[1]; ++row)
  {
    std::memcpy(all->GetScalarPointer(place[0] + first[0], place[1] + row, 0),
      piece->GetScalarPointer(first[0], row, 0), bytes);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Canvas::PutTogether(
  const std::function<vtkSmartPointer<vtkImageData>()>& draw)
{
  auto all = vtkSmartPointer<vtkImageData>::New();
  all->SetDimensions(this->Wanted.Size[0], this->Wanted.Size[1], 1);
  for (const Place& place : this->Places)
  {
    const PieceOfView view(this->Renderer, place, this->Piece, this->Wanted.Size);
    const vtkSmartPointer<vtkImageData> piece = draw();
    ThrowOnError("cannot draw");
    if (!all->GetScalarPointer())
    {
      all->AllocateScalars(piece->GetScalarType(), piece->GetNumberOfScalarComponents());
    }
    this->CopyMiddle(piece, place, all);
  }
  return all;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Canvas::Draw()
{
  const auto draw = [this]
  {
    this->Window->Render();
    return CapturePicture(this->Window, this->Wanted.Scenery.IsTransparent());
  };
  return this->IsTiled() ? this->PutTogether(draw) : draw();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Canvas::DrawFrames(Statistics& statistics)
{
  vtkSmartPointer<vtkImageData> picture;
  if (!this->IsTiled())
  {
    ::DrawFrames(this->Window, this->Renderer, this->Wanted.Frames, statistics);
    picture = CapturePicture(this->Window, this->Wanted.Scenery.IsTransparent());
  }
  for (int frame = 0; this->IsTiled() && frame < this->Wanted.Frames; ++frame)
  {
    const Stopwatch watch;
    picture = this->Draw();
    statistics.AddTime(frame == 0 ? "first_frame" : "frame_cpu", watch.GetMilliseconds());
    if (this->Wanted.Frames == 1)
    {
      statistics.AddTime("frame_cpu", watch.GetMilliseconds());
    }
  }
  TellWindow(this->Window, statistics);
  statistics.SetCount("frames", this->Wanted.Frames);
  statistics.SetCount("width", this->Wanted.Size[0]);
  statistics.SetCount("height", this->Wanted.Size[1]);
  statistics.SetCount("pieces", static_cast<std::int64_t>(this->Places.size()));
  return picture;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Canvas::DrawDepths(vtkProp* terrain, vtkProp* walls)
{
  const auto draw = [this, terrain, walls]
  { return ::DrawDepths(this->Window, this->Renderer, terrain, walls); };
  return this->IsTiled() ? this->PutTogether(draw) : draw();
}
