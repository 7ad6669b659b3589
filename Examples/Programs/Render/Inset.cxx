// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Inset.h"

#include "DataRim.h"
#include "FlatShapes.h"
#include "MarkColors.h"
#include "Options.h"
#include "TextSize.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkTexture.h"
#include "vtkTexturedActor2D.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
/// Longest side, and distance from the border, in shares of the shorter side of the picture.
constexpr double kMapSide = 0.26;
constexpr double kMapMargin = 0.03;
/// In pixels of a picture 720 pixels high.
constexpr double kMapBorder = 1.5;
constexpr double kViewFrame = 2.0;
constexpr double kEyeSize = 8.0;
constexpr std::array<double, 3> kFrameColor = { 0.85, 0.10, 0.08 };
/// How strong the shade of a slope of 1 is.
constexpr double kMapShade = 0.35;

/// Paints texels of a map from above.
class MapPainter
{
public:
  explicit MapPainter(vtkImageData* heights, vtkScalarsToColors* colors)
    : Heights(heights)
    , Colors(colors)
    , Rim(heights)
    , Width(heights->GetDimensions()[0])
    , Height(heights->GetDimensions()[1])
    , IsTurned(this->Rim.GetPoint(heights->GetNumberOfPoints() - 1, 0.0)[1] <
        this->Rim.GetPoint(0, 0.0)[1])
  {
  }

  vtkSmartPointer<vtkImageData> Paint(int columns, int rows)
  {
    auto picture = vtkSmartPointer<vtkImageData>::New();
    picture->SetDimensions(columns, rows, 1);
    picture->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    auto* texel = static_cast<unsigned char*>(picture->GetScalarPointer());
    const vtkIdType step = std::max<vtkIdType>(1, this->Width / columns);
    for (int j = 0; j < rows; ++j)
    {
      for (int i = 0; i < columns; ++i, texel += 4)
      {
        // at the middle of the texel
        constexpr vtkIdType kHalves = 2;
        this->PaintTexel(texel, (kHalves * i + 1) * (this->Width - 1) / (kHalves * columns),
          (kHalves * j + 1) * (this->Height - 1) / (kHalves * rows), step);
      }
    }
    return picture;
  }

private:
  /// The sample of a column and a row from the south.
  vtkIdType SampleAt(vtkIdType i, vtkIdType j) const
  {
    return i + this->Width * (this->IsTurned ? this->Height - 1 - j : j);
  }

  /// Rise per metre to the east or north over some samples; 0 where data are missing.
  double Slope(vtkIdType i, vtkIdType j, vtkIdType toEast, vtkIdType toNorth) const
  {
    const auto clampTo = [](vtkIdType k, vtkIdType count)
    { return std::clamp<vtkIdType>(k, 0, count - 1); };
    const vtkIdType from =
      this->SampleAt(clampTo(i - toEast, this->Width), clampTo(j - toNorth, this->Height));
    const vtkIdType to =
      this->SampleAt(clampTo(i + toEast, this->Width), clampTo(j + toNorth, this->Height));
    const double length = static_cast<double>(toEast) * this->Heights->GetSpacing()[0] +
      static_cast<double>(toNorth) * this->Heights->GetSpacing()[1];
    return this->Rim.HasHeight(from) && this->Rim.HasHeight(to)
      ? (this->Rim.GetHeight(to) - this->Rim.GetHeight(from)) / (2.0 * length)
      : 0.0;
  }

  void PaintTexel(unsigned char* texel, vtkIdType i, vtkIdType j, vtkIdType step)
  {
    const vtkIdType sample = this->SampleAt(i, j);
    texel[3] = this->Rim.HasHeight(sample) ? 255 : 0;
    const unsigned char* color =
      this->Colors->MapValue(texel[3] ? this->Rim.GetHeight(sample) : this->Colors->GetRange()[0]);
    const double rise = this->Slope(i, j, step, 0) - this->Slope(i, j, 0, step); // to south-east
    const double shade = std::clamp(1.0 + kMapShade * std::tanh(2.0 * rise), 0.0, 1.5);
    for (int k = 0; k < 3; ++k)
    {
      texel[k] = static_cast<unsigned char>(std::lround(std::min(255.0, shade * color[k])));
    }
  }

  vtkImageData* Heights;
  vtkScalarsToColors* Colors;
  DataRim Rim;
  vtkIdType Width;
  vtkIdType Height;
  bool IsTurned;
};

/// The part of a convex polygon on the side of a line where a number is not below 0.
template <typename Side>
std::vector<Pixel> Cut(const std::vector<Pixel>& polygon, Side&& side)
{
  std::vector<Pixel> kept;
  for (std::size_t k = 0; k < polygon.size(); ++k)
  {
    const Pixel& a = polygon[k];
    const Pixel& b = polygon[(k + 1) % polygon.size()];
    const double sa = side(a);
    const double sb = side(b);
    if (sa >= 0.0)
    {
      kept.push_back(a);
    }
    if ((sa < 0.0) != (sb < 0.0))
    {
      const double t = sa / (sa - sb);
      kept.push_back({ a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]) });
    }
  }
  return kept;
}

/// Where the ray of a place in the view, -1 to 1 each way, meets a level; far away above it.
std::array<double, 2> GroundAt(vtkCamera* camera, double aspect, double level, double x, double y)
{
  std::array<double, 3> eye{};
  std::array<double, 3> along{};
  std::array<double, 3> right{};
  std::array<double, 3> up{};
  camera->GetPosition(eye.data());
  camera->GetDirectionOfProjection(along.data());
  vtkMath::Cross(along.data(), camera->GetViewUp(), right.data());
  vtkMath::Normalize(right.data());
  vtkMath::Cross(right.data(), along.data(), up.data());
  const double slope = std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  for (std::size_t k = 0; k < 3; ++k)
  {
    along[k] += slope * (x * aspect * right[k] + y * up[k]);
  }
  constexpr double kFar = 1e7;
  const double fall = (eye[2] - level) * along[2];
  const double t = fall < 0.0 ? std::min(kFar, (level - eye[2]) / along[2]) : kFar;
  return { eye[0] + t * along[0], eye[1] + t * along[1] };
}
}

//------------------------------------------------------------------------------
InsetMap::InsetMap(vtkImageData* heights, vtkScalarsToColors* colors,
  const std::array<double, 6>& box, const Options& options)
  : Box(box)
  , Wanted(options)
{
  heights->GetBounds(this->Box.data());
  this->Box[4] = box[4];
  this->Box[5] = box[5];
  const double unit = std::min(options.Size[0], options.Size[1]);
  const double width = this->Box[1] - this->Box[0];
  const double height = this->Box[3] - this->Box[2];
  const double scale = kMapSide * unit / std::max(width, height);
  this->Size = { std::max(8.0, std::round(scale * width)),
    std::max(8.0, std::round(scale * height)) };
  this->Corner = { std::round(kMapMargin * unit),
    std::round(options.Size[1] - kMapMargin * unit - this->Size[1]) };
  this->Picture = MapPainter(heights, colors)
                    .Paint(static_cast<int>(this->Size[0]), static_cast<int>(this->Size[1]));
}

//------------------------------------------------------------------------------
std::array<double, 2> InsetMap::ToPixel(double x, double y) const
{
  return { this->Corner[0] + this->Size[0] * (x - this->Box[0]) / (this->Box[1] - this->Box[0]),
    this->Corner[1] + this->Size[1] * (y - this->Box[2]) / (this->Box[3] - this->Box[2]) };
}

//------------------------------------------------------------------------------
void InsetMap::AddMarks(vtkRenderer* renderer) const
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double scale = std::max(0.5, PixelScale(this->Wanted));
  const double aspect = static_cast<double>(this->Wanted.Size[0]) / this->Wanted.Size[1];
  const double level = 0.5 * (this->Box[4] + this->Box[5]);
  std::vector<Pixel> frame;
  for (const auto& [x, y] :
    { std::pair(-1.0, -1.0), std::pair(1.0, -1.0), std::pair(1.0, 1.0), std::pair(-1.0, 1.0) })
  {
    const std::array<double, 2> at = GroundAt(camera, aspect, level, x, y);
    frame.push_back(this->ToPixel(at[0], at[1]));
  }
  const Pixel low = this->Corner;
  const Pixel high = { low[0] + this->Size[0], low[1] + this->Size[1] };
  frame = Cut(frame, [&](const Pixel& p) { return p[0] - low[0]; });
  frame = Cut(frame, [&](const Pixel& p) { return high[0] - p[0]; });
  frame = Cut(frame, [&](const Pixel& p) { return p[1] - low[1]; });
  frame = Cut(frame, [&](const Pixel& p) { return high[1] - p[1]; });
  FlatShapes marks;
  marks.AddBorder(frame, kViewFrame * scale);
  const double* eye = camera->GetPosition();
  const double* ahead = camera->GetDirectionOfProjection();
  Pixel at = this->ToPixel(eye[0], eye[1]);
  at = { std::clamp(at[0], low[0], high[0]), std::clamp(at[1], low[1], high[1]) };
  const double length = std::hypot(ahead[0], ahead[1]);
  const Pixel to =
    length > 1e-6 ? Pixel{ ahead[0] / length, ahead[1] / length } : Pixel{ 0.0, 1.0 };
  const double size = kEyeSize * scale;
  marks.AddPolygon({ { at[0] + size * to[0], at[1] + size * to[1] },
    { at[0] - size * (0.7 * to[0] + 0.6 * to[1]), at[1] - size * (0.7 * to[1] - 0.6 * to[0]) },
    { at[0] - size * (0.7 * to[0] - 0.6 * to[1]), at[1] - size * (0.7 * to[1] + 0.6 * to[0]) } });
  marks.AddTo(renderer, kFrameColor);
}

//------------------------------------------------------------------------------
void InsetMap::AddTo(vtkRenderer* renderer) const
{
  const Pixel low = this->Corner;
  const Pixel high = { low[0] + this->Size[0], low[1] + this->Size[1] };
  const std::vector<Pixel> corners = { low, { high[0], low[1] }, high, { low[0], high[1] } };
  FlatShapes paper;
  paper.AddPolygon(corners);
  paper.AddTo(renderer, kLightMark);
  const vtkNew<vtkPoints> points;
  const vtkNew<vtkFloatArray> at;
  at->SetNumberOfComponents(2);
  for (std::size_t k = 0; k < corners.size(); ++k)
  {
    points->InsertNextPoint(corners[k][0], corners[k][1], 0.0);
    at->InsertNextTuple2(k == 1 || k == 2 ? 1.0 : 0.0, k > 1 ? 1.0 : 0.0);
  }
  const vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2, 3 });
  const vtkNew<vtkPolyData> shape;
  shape->SetPoints(points);
  shape->SetPolys(cells);
  shape->GetPointData()->SetTCoords(at);
  const vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(shape);
  const vtkNew<vtkTexture> texture;
  texture->SetInputData(this->Picture);
  texture->RepeatOff();
  texture->EdgeClampOn();
  texture->InterpolateOn();
  texture->SetColorModeToDirectScalars();
  const vtkNew<vtkTexturedActor2D> map;
  map->SetMapper(mapper);
  map->SetTexture(texture);
  renderer->AddViewProp(map);
  this->AddMarks(renderer);
  FlatShapes border;
  border.AddBorder(corners, kMapBorder * std::max(0.5, PixelScale(this->Wanted)));
  border.AddTo(renderer, kDarkMark);
}
