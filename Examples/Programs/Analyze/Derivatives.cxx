// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Derivatives.h"

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <cmath>
#include <limits>

namespace
{
constexpr double kDegrees = 57.29577951308232;
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// Nine heights, [row][column], row 0 in the south; and the distances of their middles.
struct Window
{
  std::array<std::array<double, 3>, 3> H;
  double East;
  double North;
};

using Measure = float (*)(const Window& w);

double HornEast(const Window& w)
{
  const auto column = [&](int i) { return w.H[0][i] + 2.0 * w.H[1][i] + w.H[2][i]; };
  return (column(2) - column(0)) / (8.0 * w.East);
}

double HornNorth(const Window& w)
{
  const auto row = [&](int j) { return w.H[j][0] + 2.0 * w.H[j][1] + w.H[j][2]; };
  return (row(2) - row(0)) / (8.0 * w.North);
}

float Slope(const Window& w)
{
  return static_cast<float>(kDegrees * std::atan(std::hypot(HornEast(w), HornNorth(w))));
}

float Aspect(const Window& w)
{
  const double east = HornEast(w);
  const double north = HornNorth(w);
  const double angle = kDegrees * std::atan2(-east, -north);
  const bool level = east == 0.0 && north == 0.0;
  return level ? kNone : static_cast<float>(angle < 0.0 ? angle + 360.0 : angle);
}

/// Second derivatives and slopes of Zevenbergen and Thorne.
struct Quadric
{
  double D, E, F, G, H;
  explicit Quadric(const Window& w)
    : D((0.5 * (w.H[1][0] + w.H[1][2]) - w.H[1][1]) / (w.East * w.East))
    , E((0.5 * (w.H[0][1] + w.H[2][1]) - w.H[1][1]) / (w.North * w.North))
    , F((w.H[2][2] - w.H[2][0] - w.H[0][2] + w.H[0][0]) / (4.0 * w.East * w.North))
    , G((w.H[1][2] - w.H[1][0]) / (2.0 * w.East))
    , H((w.H[2][1] - w.H[0][1]) / (2.0 * w.North))
  {
  }
  double Along(double x, double y) const
  {
    const double size = this->G * this->G + this->H * this->H;
    return size > 0.0 ? 2.0 * (this->D * x * x + this->E * y * y + this->F * x * y) / size : 0.0;
  }
};

float ProfileCurvature(const Window& w)
{
  const Quadric q(w);
  return static_cast<float>(q.Along(q.G, q.H));
}

float PlanCurvature(const Window& w)
{
  const Quadric q(w);
  return static_cast<float>(q.Along(-q.H, q.G));
}

float Ruggedness(const Window& w)
{
  double sum = 0.0;
  for (const auto& row : w.H)
  {
    for (const double h : row)
    {
      sum += (h - w.H[1][1]) * (h - w.H[1][1]);
    }
  }
  return static_cast<float>(std::sqrt(sum));
}

/// Heights as doubles, NaN for no data.
std::vector<double> CopyHeights(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  vtkUnsignedCharArray* ghosts = image->GetPointGhostArray();
  std::vector<double> heights(static_cast<std::size_t>(image->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const bool hidden = ghosts && (ghosts->GetValue(i) & vtkDataSetAttributes::HIDDENPOINT) != 0;
    heights[static_cast<std::size_t>(i)] =
      hidden ? std::numeric_limits<double>::quiet_NaN() : scalars->GetComponent(i, 0);
  }
  return heights;
}

/// One value of a measure for each sample.
std::vector<float> Apply(Measure measure, vtkImageData* image)
{
  const std::vector<double> heights = CopyHeights(image);
  const std::vector<double> east = EastSpacings(image);
  const vtkIdType width = image->GetDimensions()[0];
  const vtkIdType height = image->GetDimensions()[1];
  std::vector<float> values(heights.size(), kNone);
  vtkSMPTools::For(1, std::max<vtkIdType>(height - 1, 1),
    [&](vtkIdType begin, vtkIdType end)
    {
      Window w;
      w.North = image->GetSpacing()[1];
      for (vtkIdType j = begin; j < end; ++j)
      {
        w.East = east[static_cast<std::size_t>(j)];
        for (vtkIdType i = 1; i + 1 < width && j + 1 < height; ++i)
        {
          bool valid = true;
          for (vtkIdType k = 0; k < 9; ++k)
          {
            const double h =
              heights[static_cast<std::size_t>(i - 1 + k % 3 + width * (j - 1 + k / 3))];
            w.H[static_cast<std::size_t>(k / 3)][static_cast<std::size_t>(k % 3)] = h;
            valid = valid && !std::isnan(h);
          }
          values[static_cast<std::size_t>(i + width * j)] = valid ? measure(w) : kNone;
        }
      }
    });
  return values;
}
}

//------------------------------------------------------------------------------
void WriteDerivative(const RasterOptions& raster, const std::string& command)
{
  struct Band
  {
    const char* Description;
    Measure Value;
  };
  std::vector<Band> bands;
  if (command == "slope")
  {
    bands = { { "slope", Slope } };
  }
  else if (command == "aspect")
  {
    bands = { { "aspect", Aspect } };
  }
  else if (command == "curvature")
  {
    bands = { { "profile curvature", ProfileCurvature }, { "plan curvature", PlanCurvature } };
  }
  else
  {
    bands = { { "ruggedness", Ruggedness } };
  }
  const vtkSmartPointer<vtkImageData> heights = ReadHeights(raster, 24.0);
  ProgressBar bar(raster.Quiet);
  ResultWriter writer(raster, heights, static_cast<int>(bands.size()));
  int number = 0;
  for (const Band& band : bands)
  {
    writer.SetBand(++number, band.Description, Apply(band.Value, heights).data());
    bar.Show(0.9 * number / static_cast<double>(bands.size()));
  }
  writer.Write();
}
