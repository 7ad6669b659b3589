// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainHorizon.h"

#include "core/place/ClearSky.h"
#include "core/place/SunPosition.h"
#include "core/rays/Horizon.h"
#include "core/rays/SkyView.h"
#include "data/FieldData.h"
#include "data/ImageHeights.h"
#include "data/SMPParallelFor.h"
#include "data/Setting.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTerrainGeoreference.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkTerrainHorizon);

namespace
{
/// Rows that share a width of cells.
struct RowBand
{
  terrain::RowRange Rows;
  double Spacing = 1.0; ///< east, metres
};

/// Latitude of a row of heights in degrees, and whether heights are laid out from degrees at all.
class Latitudes
{
public:
  explicit Latitudes(vtkImageData* heights)
    : Layout(terrain::FieldData::GetLayout(heights))
    , First(terrain::ImageHeights::Geometry(heights).Origin.y)
    , Spacing(heights->GetSpacing()[1])
  {
    vtkNew<vtkTerrainGeoreference> georeference;
    georeference->SetFromHeights(heights);
    this->InDegrees = georeference->IsGeographic();
  }
  bool AreKnown() const
  {
    return this->InDegrees;
  }
  double At(double row) const
  {
    const double y = this->First + row * this->Spacing;
    return std::clamp(this->Layout.Origin[1] + y / this->Layout.Scale[1], -89.9, 89.9);
  }
  /// Width of a degree of longitude over that where the heights are laid out true.
  double Width(double row) const
  {
    return CircleRadius(this->At(row)) / CircleRadius(this->Layout.Origin[1]);
  }

private:
  /// Of the circle of latitude, over the equator's; that of WGS84 is good for all planets here.
  static double CircleRadius(double latitude)
  {
    constexpr double eccentricity2 = 0.00669438;
    const double phi = latitude * terrain::kDegree;
    return std::max(
      std::cos(phi) / std::sqrt(1.0 - eccentricity2 * std::pow(std::sin(phi), 2.0)), 1e-6);
  }

  terrain::FieldData::Layout Layout;
  double First;
  double Spacing;
  bool InDegrees = false;
};

std::vector<RowBand> MakeBands(vtkImageData* heights)
{
  const std::int64_t count = heights->GetDimensions()[1];
  const double spacing = heights->GetSpacing()[0];
  const Latitudes latitudes(heights);
  if (!latitudes.AreKnown())
  {
    return { { { 0, count }, spacing } };
  }
  std::vector<RowBand> bands;
  for (std::int64_t first = 0; first < count;)
  {
    const double low = latitudes.Width(static_cast<double>(first));
    std::int64_t end = first + 1;
    const auto isNear = [&](std::int64_t row)
    {
      const double width = latitudes.Width(static_cast<double>(row));
      return std::abs(width - low) <= 2.0 * vtkTerrainHorizon::SpacingError * width;
    };
    while (end < count && isNear(end))
    {
      ++end;
    }
    const double middle = 0.5 * static_cast<double>(first + end - 1);
    bands.push_back({ { first, end }, spacing * latitudes.Width(middle) });
    first = end;
  }
  return bands;
}

vtkSmartPointer<vtkFloatArray> MakeArray(vtkImageData* image, const char* name, int components)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  image->GetPointData()->AddArray(array);
  return array;
}
}

//------------------------------------------------------------------------------
/// Heights that are ready, until they change.
struct vtkTerrainHorizon::vtkInternals
{
  vtkWeakPointer<vtkImageData> Image;
  vtkMTimeType Time = 0;
  std::unique_ptr<terrain::HorizonGrid> Grid;
  std::vector<RowBand> Bands;

  void Prepare(vtkImageData* heights)
  {
    if (this->Image == heights && this->Time == heights->GetMTime())
    {
      return;
    }
    terrain::ImageHeights::Dispatch(heights,
      [&](const auto& view)
      { this->Grid = std::make_unique<terrain::HorizonGrid>(view, terrain::SMPParallelFor); });
    this->Bands = MakeBands(heights);
    this->Image = heights;
    this->Time = heights->GetMTime();
  }
};

//------------------------------------------------------------------------------
vtkTerrainHorizon::vtkTerrainHorizon()
  : Internals(std::make_unique<vtkInternals>())
{
}

vtkTerrainHorizon::~vtkTerrainHorizon() = default;

//------------------------------------------------------------------------------
void vtkTerrainHorizon::SetDate(const std::string& date)
{
  terrain::Setting::Set(this, this->Date, date);
}

//------------------------------------------------------------------------------
std::string vtkTerrainHorizon::WhyNot(vtkImageData* heights) const
{
  std::string whyNot = terrain::ImageHeights::WhyNotHeights(heights);
  if (!whyNot.empty())
  {
    return whyNot;
  }
  if (this->NumberOfDirections < 1 || this->NumberOfDirections > MaximumDirections)
  {
    return "a horizon has 1 to " + std::to_string(MaximumDirections) + " directions, not " +
      std::to_string(this->NumberOfDirections);
  }
  return {};
}

//------------------------------------------------------------------------------
std::string vtkTerrainHorizon::ComputeHorizon(
  vtkImageData* heights, double azimuth, vtkFloatArray* degrees)
{
  std::string whyNot = this->WhyNot(heights);
  if (whyNot.empty() && !std::isfinite(azimuth))
  {
    whyNot = "an azimuth must be a number of degrees";
  }
  if (!whyNot.empty())
  {
    return whyNot;
  }
  this->Internals->Prepare(heights);
  degrees->SetNumberOfComponents(1);
  degrees->SetNumberOfTuples(heights->GetNumberOfPoints());
  terrain::HorizonOptions options;
  options.Spacing.y = heights->GetSpacing()[1];
  options.EyeHeight = this->EyeHeight;
  options.Drop = this->Curvature ? (1.0 - this->Refraction) / (2.0 * this->PlanetRadius) : 0.0;
  const std::int64_t width = heights->GetDimensions()[0];
  for (const RowBand& band : this->Internals->Bands)
  {
    options.Spacing.x = band.Spacing;
    this->Internals->Grid->Cast(azimuth, options, band.Rows,
      degrees->GetPointer(band.Rows.First * width), terrain::SMPParallelFor);
  }
  terrain::ImageHeights::ArrangeRows(
    heights, degrees->GetPointer(0), width, heights->GetDimensions()[1]);
  return {};
}

//------------------------------------------------------------------------------
std::string vtkTerrainHorizon::AddHorizons(vtkImageData* heights, vtkImageData* output)
{
  const int count = this->NumberOfDirections;
  const vtkIdType points = heights->GetNumberOfPoints();
  vtkSmartPointer<vtkFloatArray> horizon;
  if (this->OutputHorizon)
  {
    horizon = MakeArray(output, "Horizon", count);
  }
  std::vector<double> sky(this->OutputSkyView ? static_cast<std::size_t>(points) : 0, 0.0);
  vtkNew<vtkFloatArray> degrees;
  for (int k = 0; k < count && !this->GetAbortExecute(); ++k)
  {
    std::string whyNot = this->ComputeHorizon(heights, 360.0 * k / count, degrees);
    if (!whyNot.empty())
    {
      return whyNot;
    }
    terrain::SMPParallelFor(points,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t i = begin; i < end; ++i)
        {
          const float angle = degrees->GetValue(i);
          if (horizon)
          {
            horizon->SetValue(i * count + k, angle);
          }
          if (!sky.empty())
          {
            sky[static_cast<std::size_t>(i)] +=
              std::isnan(angle) ? terrain::kNaN : terrain::SkyViewPart(angle) / count;
          }
        }
      });
    this->UpdateProgress((k + 1.0) / count);
  }
  if (this->OutputSkyView)
  {
    std::copy(sky.begin(), sky.end(), MakeArray(output, "SkyView", 1)->GetPointer(0));
  }
  return {};
}

namespace
{
/// Where the middle of heights is, and which way its east, north and up point in the grid.
struct Middle
{
  double Place[3];
  double East[3];
  double North[3];
  double Up[3];

  /// Empty, or why there is no such place.
  std::string Find(vtkImageData* heights)
  {
    vtkNew<vtkTerrainGeoreference> georeference;
    georeference->SetFromHeights(heights);
    if (!georeference->IsGeographic())
    {
      georeference->SetFrame(vtkTerrainGeoreference::FrameType::Grid);
    }
    const std::string whyNot = georeference->GetWhyNot();
    if (!whyNot.empty() || !georeference->IsOnEarth())
    {
      return "the sun needs to know where the heights are: give them a CRS";
    }
    const terrain::FieldData::Layout layout = terrain::FieldData::GetLayout(heights);
    double bounds[6];
    heights->GetBounds(bounds);
    const double file[3] = { layout.Origin[0] + 0.5 * (bounds[0] + bounds[1]) / layout.Scale[0],
      layout.Origin[1] + 0.5 * (bounds[2] + bounds[3]) / layout.Scale[1], 0.0 };
    if (!georeference->FileToPlaces(file, this->Place, 1) ||
      !georeference->GetAxes(this->Place, this->East, this->North, this->Up))
    {
      return "the middle of the heights is not on earth";
    }
    return {};
  }

  /// The sun as the grid has it; its azimuth is from grid north.
  terrain::SunAngles SunAt(const terrain::UtcTime& time) const
  {
    const glm::dvec3 sun = terrain::SunDirection(
      terrain::SunPosition({ this->Place[0], this->Place[1], this->Place[2] }, time));
    glm::dvec3 grid;
    for (int i = 0; i < 3; ++i)
    {
      grid[i] = sun.x * this->East[i] + sun.y * this->North[i] + sun.z * this->Up[i];
    }
    return { std::atan2(grid.x, grid.y) / terrain::kDegree,
      std::asin(std::clamp(grid.z, -1.0, 1.0)) / terrain::kDegree };
  }
};

/// The arrays of the sun and what has been added to them so far.
struct SunArrays
{
  vtkSmartPointer<vtkFloatArray> Hours;
  vtkSmartPointer<vtkFloatArray> First;
  vtkSmartPointer<vtkFloatArray> Last;
  vtkSmartPointer<vtkFloatArray> Irradiation;

  explicit SunArrays(vtkImageData* image)
    : Hours(MakeArray(image, "SunHours", 1))
    , First(MakeArray(image, "FirstSun", 1))
    , Last(MakeArray(image, "LastSun", 1))
    , Irradiation(MakeArray(image, "DirectIrradiation", 1))
  {
    this->Hours->FillValue(0.0f);
    this->Irradiation->FillValue(0.0f);
    this->First->FillValue(std::numeric_limits<float>::quiet_NaN());
    this->Last->FillValue(std::numeric_limits<float>::quiet_NaN());
  }
};

/// Unit normals of the plane through a sample and its neighbours, as far as they have heights.
template <typename View>
glm::dvec3 NormalAt(const View& view, std::int64_t i, std::int64_t j, const glm::dvec2& spacing)
{
  const double here = view.At(i, j);
  const auto slope = [&](std::int64_t di, std::int64_t dj, double distance)
  {
    const bool ahead = i + di < view.Width && j + dj < view.Height;
    const bool behind = i >= di && j >= dj;
    const double next = ahead ? view.At(i + di, j + dj) : terrain::kNaN;
    const double last = behind ? view.At(i - di, j - dj) : terrain::kNaN;
    const double a = std::isnan(last) ? here : last;
    const double b = std::isnan(next) ? here : next;
    const int cells = (std::isnan(last) ? 0 : 1) + (std::isnan(next) ? 0 : 1);
    return cells > 0 ? (b - a) / (cells * distance) : 0.0;
  };
  return glm::normalize(glm::dvec3(-slope(1, 0, spacing.x), -slope(0, 1, spacing.y), 1.0));
}

int DayOfYear(const terrain::UtcTime& time)
{
  constexpr int before[] = { 0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334 };
  const bool leap = time.Year % 4 == 0; // of 1950 to 2050
  return before[time.Month - 1] + time.Day + (leap && time.Month > 2 ? 1 : 0);
}

/// One look at the sun.
struct SunLook
{
  terrain::SunAngles Sun;
  double Time = 0.0;  ///< hours since the date began
  double Hours = 0.0; ///< that it stands for
  int Day = 1;        ///< of the year
  double Turbidity = 3.0;
};

/// Adds what sample (i, j), point k, gets of the sun; limit: its horizon there.
template <typename View>
void AddLight(const View& view, const glm::i64vec2& sample, vtkIdType k, const glm::dvec2& spacing,
  const SunLook& look, float limit, const SunArrays& arrays)
{
  if (std::isnan(limit))
  {
    arrays.Hours->SetValue(k, limit);
    arrays.Irradiation->SetValue(k, limit);
  }
  if (!(limit < look.Sun.Elevation))
  {
    return;
  }
  const glm::dvec3 normal = NormalAt(view, sample.x, sample.y, spacing);
  const double facing = std::max(glm::dot(normal, terrain::SunDirection(look.Sun)), 0.0);
  const double direct = terrain::ClearSkyDirect(
    look.Sun.Elevation, view.At(sample.x, sample.y), look.Turbidity, look.Day);
  arrays.Hours->SetValue(k, arrays.Hours->GetValue(k) + static_cast<float>(look.Hours));
  arrays.Irradiation->SetValue(
    k, arrays.Irradiation->GetValue(k) + static_cast<float>(look.Hours * direct * facing));
  const auto now = static_cast<float>(look.Time);
  arrays.First->SetValue(
    k, std::isnan(arrays.First->GetValue(k)) ? now : arrays.First->GetValue(k));
  arrays.Last->SetValue(k, now);
}

/// The same for all samples.
void AddLights(vtkImageData* heights, const std::vector<RowBand>& bands, const SunLook& look,
  vtkFloatArray* horizon, const SunArrays& arrays)
{
  terrain::ImageHeights::Dispatch(heights,
    [&](const auto& view)
    {
      for (const RowBand& band : bands)
      {
        const glm::dvec2 spacing(band.Spacing, heights->GetSpacing()[1]);
        terrain::SMPParallelFor(band.Rows.End - band.Rows.First,
          [&](std::int64_t begin, std::int64_t end)
          {
            for (std::int64_t j = band.Rows.First + begin; j < band.Rows.First + end; ++j)
            {
              vtkIdType k = terrain::ImageHeights::PointOfSample(heights, 0, j);
              for (std::int64_t i = 0; i < view.Width; ++i, ++k)
              {
                AddLight(view, { i, j }, k, spacing, look, horizon->GetValue(k), arrays);
              }
            }
          });
      }
    });
}
}

//------------------------------------------------------------------------------
std::string vtkTerrainHorizon::AddSun(vtkImageData* heights, vtkImageData* output)
{
  terrain::UtcTime time;
  std::string whyNot;
  Middle middle;
  if (!terrain::TimeFromText(this->Date + "T00:00", time, whyNot))
  {
    return "a date is written 2024-06-21, from 1950 to 2050, not \"" + this->Date + "\"";
  }
  whyNot = middle.Find(heights);
  if (!whyNot.empty())
  {
    return whyNot;
  }
  const SunArrays arrays(output);
  const double midnight = -middle.Place[0] / 15.0;
  const int steps = static_cast<int>(std::ceil(24.0 * 60.0 / this->TimeStep));
  SunLook look;
  look.Hours = 24.0 / steps;
  look.Day = DayOfYear(time);
  look.Turbidity = this->Turbidity;
  vtkNew<vtkFloatArray> horizon;
  for (int step = 0; step < steps && whyNot.empty() && !this->GetAbortExecute(); ++step)
  {
    look.Time = time.Hours = midnight + (step + 0.5) * look.Hours;
    look.Sun = middle.SunAt(time);
    if (look.Sun.Elevation > 0.0)
    {
      whyNot = this->ComputeHorizon(heights, look.Sun.Azimuth, horizon);
      AddLights(heights, this->Internals->Bands, look, horizon, arrays);
    }
    this->UpdateProgress((step + 1.0) / steps);
  }
  return whyNot;
}

//------------------------------------------------------------------------------
int vtkTerrainHorizon::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  // Any part may stand before any other.
  vtkInformation* info = inputs[0]->GetInformationObject(0);
  int whole[6];
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), whole, 6);
  return 1;
}

//------------------------------------------------------------------------------
int vtkTerrainHorizon::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* heights = vtkImageData::GetData(inputs[0]);
  vtkImageData* output = vtkImageData::GetData(outputs);
  this->ErrorMessage = this->WhyNot(heights);
  if (this->ErrorMessage.empty())
  {
    output->ShallowCopy(heights);
    if (this->OutputHorizon || this->OutputSkyView)
    {
      this->ErrorMessage = this->AddHorizons(heights, output);
    }
    if (this->ErrorMessage.empty() && !this->Date.empty())
    {
      this->ErrorMessage = this->AddSun(heights, output);
    }
  }
  if (!this->ErrorMessage.empty())
  {
    output->Initialize();
    vtkErrorMacro("No horizons: " << this->ErrorMessage << ".");
    return 0;
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkTerrainHorizon::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfDirections: " << this->NumberOfDirections << "\n";
  os << indent << "EyeHeight: " << this->EyeHeight << "\n";
  os << indent << "Curvature: " << (this->Curvature ? "on" : "off") << "\n";
  os << indent << "Refraction: " << this->Refraction << "\n";
  os << indent << "PlanetRadius: " << this->PlanetRadius << "\n";
  os << indent << "OutputHorizon: " << (this->OutputHorizon ? "on" : "off") << "\n";
  os << indent << "OutputSkyView: " << (this->OutputSkyView ? "on" : "off") << "\n";
  os << indent << "Date: " << this->Date << "\n";
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  os << indent << "Turbidity: " << this->Turbidity << "\n";
}
