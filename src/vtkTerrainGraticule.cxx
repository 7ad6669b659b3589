// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainGraticule.h"

#include "core/grid/RoundNumbers.h"
#include "core/place/GridReference.h"
#include "core/place/SceneFrame.h"
#include "data/GlobeData.h"
#include "data/ImageHeights.h"
#include "data/Setting.h"
#include "vtkTerrainDrape.h"
#include "vtkTerrainGeoreference.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace
{
// Points along each side, and inside, by which the extent in the grid is found.
constexpr int kSearchPoints = 33;
// Points of a line before it is draped: its curvature in the scene.
constexpr int kLinePoints = 129;
// Degrees by which lines are rounded.
constexpr double kRounding = 1e-9;
// Most lines of one axis.
constexpr double kMostLines = 10000.0;

std::string LabelOf(double value, int axis, double step, bool geographic)
{
  if (geographic)
  {
    return axis == 0 ? terrain::AngleLabel(std::remainder(value, 360.0), step, 'E', 'W')
                     : terrain::AngleLabel(value, step, 'N', 'S');
  }
  return terrain::LengthLabel(value) + (axis == 0 ? " E" : " N");
}

/// Brings points at longitudes and latitudes onto the globe of heights.
void BendToGlobe(vtkPolyData* data, vtkImageData* heights)
{
  const std::unique_ptr<terrain::GlobeGrid> grid = terrain::GlobeData::Get(heights);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double* place = data->GetPoint(i);
    const glm::dvec3 point =
      grid->Body.ToPosition({ place[0] * terrain::kDegree, place[1] * terrain::kDegree, place[2] });
    points->SetPoint(i, point.x, point.y, point.z);
  }
  data->SetPoints(points);
}

/// Heights of a globe as flat ones, in degrees.
vtkSmartPointer<vtkImageData> AsFlat(vtkImageData* heights)
{
  auto flat = vtkSmartPointer<vtkImageData>::New();
  flat->ShallowCopy(heights);
  const vtkNew<vtkFieldData> none;
  flat->SetFieldData(none);
  return flat;
}
}

/// The grid that the lines belong to, and where the heights lie in it.
struct vtkTerrainGraticule::Frame
{
  bool IsGeographic = true;
  terrain::SceneFrame Zone;
  /// x and y of the grid: degrees or metres.
  double Low[2] = { HUGE_VAL, HUGE_VAL };
  double High[2] = { -HUGE_VAL, -HUGE_VAL };
  /// Longitude about which longitudes are continuous.
  double MiddleLongitude = 0.0;
  /// The scene of lines is longitude and latitude, until they are drawn.
  bool IsGlobe = false;

  void FromPlace(const double place[3], double grid[2]) const
  {
    if (this->IsGeographic)
    {
      grid[0] = this->MiddleLongitude + std::remainder(place[0] - this->MiddleLongitude, 360.0);
      grid[1] = place[1];
      return;
    }
    const glm::dvec3 metres = this->Zone.ToScene({ place[0], place[1], 0.0 });
    grid[0] = metres.x;
    grid[1] = metres.y;
  }

  void ToPlace(const double grid[2], double place[3]) const
  {
    const glm::dvec3 there = this->IsGeographic ? glm::dvec3(grid[0], grid[1], 0.0)
                                                : this->Zone.ToPlace({ grid[0], grid[1], 0.0 });
    place[0] = there.x;
    place[1] = there.y;
    place[2] = 0.0;
  }
};

vtkStandardNewMacro(vtkTerrainGraticule);

vtkTerrainGraticule::vtkTerrainGraticule()
{
  this->SetNumberOfOutputPorts(2);
}

vtkTerrainGraticule::~vtkTerrainGraticule() = default;

void vtkTerrainGraticule::SetGeoreference(vtkTerrainGeoreference* georeference)
{
  terrain::Setting::Set(this, this->Georeference, georeference);
}

vtkTerrainGeoreference* vtkTerrainGraticule::GetGeoreference() const
{
  return this->Georeference;
}

void vtkTerrainGraticule::SetGrid(GridType grid)
{
  terrain::Setting::Set(this, this->Grid, grid);
}

vtkMTimeType vtkTerrainGraticule::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Georeference ? std::max(time, this->Georeference->GetMTime()) : time;
}

int vtkTerrainGraticule::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

bool vtkTerrainGraticule::FindExtent(vtkImageData* heights, Frame& frame)
{
  double bounds[6];
  heights->GetBounds(bounds);
  double range[2];
  heights->GetPointData()->GetScalars()->GetFiniteRange(range);
  if (terrain::GlobeData::Has(heights))
  {
    // at longitudes and latitudes themselves
    frame.MiddleLongitude = 0.5 * (bounds[0] + bounds[1]);
    frame.IsGeographic = true;
    frame.Low[0] = bounds[0];
    frame.High[0] = bounds[1];
    frame.Low[1] = bounds[2];
    frame.High[1] = bounds[3];
    frame.Low[1] = std::max(frame.Low[1], -90.0);
    frame.High[1] = std::min(frame.High[1], 90.0);
    frame.IsGlobe = true;
    return this->Grid == GridType::Geographic;
  }
  const double z =
    this->Georeference->GetFrame() == vtkTerrainGeoreference::FrameType::Local ? range[0] : 0.0;
  double middle[3] = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]), z };
  if (!this->Georeference->SceneToPlaces(middle, middle, 1) || !std::isfinite(middle[0]))
  {
    return false;
  }
  frame.MiddleLongitude = middle[0];
  frame.IsGeographic = this->Grid == GridType::Geographic;
  const terrain::GridPosition zone = terrain::ToGridPosition({ middle[0], middle[1], middle[2] });
  frame.Zone = terrain::SceneFrame::OfZone(zone.Zone, zone.Northern);
  for (int j = 0; j < kSearchPoints; ++j)
  {
    for (int i = 0; i < kSearchPoints; ++i)
    {
      double place[3] = { bounds[0] + (bounds[1] - bounds[0]) * i / (kSearchPoints - 1),
        bounds[2] + (bounds[3] - bounds[2]) * j / (kSearchPoints - 1), z };
      this->Georeference->SceneToPlaces(place, place, 1);
      double grid[2];
      frame.FromPlace(place, grid);
      for (int axis = 0; axis < 2 && std::isfinite(grid[0] + grid[1]); ++axis)
      {
        frame.Low[axis] = std::min(frame.Low[axis], grid[axis]);
        frame.High[axis] = std::max(frame.High[axis], grid[axis]);
      }
    }
  }
  return frame.Low[0] <= frame.High[0];
}

vtkSmartPointer<vtkPolyData> vtkTerrainGraticule::MakeLines(const Frame& frame)
{
  const double longer =
    std::max(frame.High[0] - frame.Low[0], frame.High[1] - frame.Low[1]) / this->NumberOfLines;
  this->StepInUse = this->Step > 0.0
    ? this->Step
    : (frame.IsGeographic ? terrain::RoundAngleDown(longer) : terrain::RoundDown(longer));
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkDoubleArray> values;
  values->SetName("Value");
  vtkNew<vtkIntArray> axes;
  axes->SetName("Axis");
  for (int axis = 0; axis < 2 && this->StepInUse > 0.0; ++axis)
  {
    const double first = std::ceil(frame.Low[axis] / this->StepInUse - 1e-9);
    const double last = std::floor(frame.High[axis] / this->StepInUse + 1e-9);
    const double count = std::min(last - first, kMostLines);
    for (double k = 0.0; k <= count; k += 1.0)
    {
      double grid[2];
      grid[axis] = (first + k) * this->StepInUse;
      cells->InsertNextCell(kLinePoints);
      values->InsertNextValue(grid[axis]);
      axes->InsertNextValue(axis);
      const int along = 1 - axis;
      for (int i = 0; i < kLinePoints; ++i)
      {
        const double t = static_cast<double>(i) / (kLinePoints - 1);
        grid[along] = (1.0 - t) * frame.Low[along] + t * frame.High[along];
        double point[3];
        frame.ToPlace(grid, point);
        if (!frame.IsGlobe)
        {
          this->Georeference->PlacesToScene(point, point, 1);
        }
        cells->InsertCellPoint(points->InsertNextPoint(point));
      }
    }
  }
  lines->SetPoints(points);
  lines->SetLines(cells);
  lines->GetCellData()->AddArray(values);
  lines->GetCellData()->AddArray(axes);
  return lines;
}

/// Where along a line of an axis its labels stand, in coordinates of the grid: at its southern or
/// western end. On a globe, which is seen from any side, half a step beside the crossings nearest
/// to the equator, or to every quarter turn.
std::vector<double> vtkTerrainGraticule::LabelPlaces(
  const Frame& frame, int axis, double value) const
{
  const int along = 1 - axis;
  const double low = frame.Low[along];
  const double high = frame.High[along];
  if (!frame.IsGlobe)
  {
    return { low };
  }
  const double half = 0.5 * this->StepInUse;
  if (axis == 0)
  {
    const bool isFirst = value > frame.Low[0] + 360.0 - kRounding; // gone round
    return isFirst ? std::vector<double>{} : std::vector<double>{ std::clamp(half, low, high) };
  }
  constexpr double kQuarter = 90.0;
  std::vector<double> places;
  for (double place = kQuarter * std::floor(low / kQuarter) + half; place < high; place += kQuarter)
  {
    if (place >= low)
    {
      places.push_back(place);
    }
  }
  const bool isPole = std::abs(value) > 90.0 - kRounding;
  return places.empty() || isPole ? std::vector<double>{ 0.5 * (low + high) } : places;
}

void vtkTerrainGraticule::Label(vtkPolyData* lines, const Frame& frame, vtkPolyData* labels) const
{
  // the point of each line that is nearest to each place, by axis, value and place
  std::map<std::tuple<int, double, std::size_t>, std::pair<double, vtkIdType>> nearest;
  vtkDataArray* values = lines->GetCellData()->GetArray("Value");
  vtkDataArray* axes = lines->GetCellData()->GetArray("Axis");
  for (vtkIdType cell = 0; values && cell < lines->GetNumberOfLines(); ++cell)
  {
    const int axis = static_cast<int>(axes->GetComponent(cell, 0));
    const double value = values->GetComponent(cell, 0);
    const std::vector<double> places = this->LabelPlaces(frame, axis, value);
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    lines->GetLines()->GetCellAtId(cell, count, ids);
    for (std::size_t place = 0; place < places.size(); ++place)
    {
      auto& found = nearest.try_emplace({ axis, value, place }, HUGE_VAL, -1).first->second;
      // in the order of lines: without a globe, the first point of the first part
      for (vtkIdType k = 0; k < (frame.IsGlobe ? count : 1); ++k)
      {
        const double apart =
          frame.IsGlobe ? std::abs(lines->GetPoint(ids[k])[1 - axis] - places[place]) : 0.0;
        found = apart < found.first ? std::pair(apart, ids[k]) : found;
      }
    }
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkStringArray> texts;
  texts->SetName("Label");
  for (const auto& [line, found] : nearest)
  {
    const vtkIdType id = points->InsertNextPoint(lines->GetPoint(found.second));
    vertices->InsertNextCell(1, &id);
    texts->InsertNextValue(LabelOf(
      std::get<1>(line), std::get<0>(line), this->StepInUse, this->Grid == GridType::Geographic));
  }
  labels->SetPoints(points);
  labels->SetVerts(vertices);
  labels->GetPointData()->AddArray(texts);
}

int vtkTerrainGraticule::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* heights = vtkImageData::GetData(inputs[0]);
  std::string why = terrain::ImageHeights::WhyNotHeights(heights);
  if (why.empty())
  {
    why = this->Georeference ? this->Georeference->GetWhyNot() : "there is no georeference";
  }
  if (why.empty() && !this->Georeference->HasPlaces())
  {
    why = "a graticule needs heights whose coordinate system is known";
  }
  if (why.empty() && this->Grid != GridType::Geographic && !this->Georeference->IsOnEarth())
  {
    why = "other worlds have no UTM: a graticule there is of degrees";
  }
  Frame frame;
  if (why.empty() && !this->FindExtent(heights, frame))
  {
    why = frame.IsGlobe ? "a globe has a graticule of degrees only: SetGrid() to Geographic"
                        : "the heights lie nowhere on earth";
  }
  if (!why.empty())
  {
    vtkErrorMacro(<< why);
    return 0;
  }
  vtkNew<vtkTerrainDrape> drape;
  drape->SetInputData(this->MakeLines(frame));
  drape->SetHeightsData(frame.IsGlobe ? AsFlat(heights).Get() : heights);
  drape->SetGeoreference(this->Georeference);
  drape->SetOffset(this->Offset);
  drape->SetExaggeration(this->Exaggeration);
  drape->Update();
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  output->ShallowCopy(drape->GetOutput());
  vtkPolyData* labels = vtkPolyData::GetData(outputs, 1);
  this->Label(output, frame, labels);
  if (frame.IsGlobe)
  {
    BendToGlobe(output, heights);
    BendToGlobe(labels, heights);
  }
  return 1;
}

void vtkTerrainGraticule::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Georeference: " << this->Georeference.Get() << "\n";
  os << indent << "Grid: " << (this->Grid == GridType::Geographic ? "geographic" : "UTM") << "\n";
  os << indent << "Step: " << this->Step << "\n";
  os << indent << "StepInUse: " << this->StepInUse << "\n";
  os << indent << "NumberOfLines: " << this->NumberOfLines << "\n";
  os << indent << "Offset: " << this->Offset << "\n";
  os << indent << "Exaggeration: " << this->Exaggeration << "\n";
}
