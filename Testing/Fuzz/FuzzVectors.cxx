// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Texts as files of points, lines and polygons, read by GDAL, and as tables of flights: one
// sentence, or cells of points that are there, tracks on the ground, times that rise.
#include "FuzzFile.h"

#include "Failure.h"
#include "FlightFile.h"
#include "Messages.h"
#include "Placing.h"
#include "VectorFile.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>

// GDAL's driver of JML keeps the parsers of expat of files that it refuses (GDAL 3.6).
extern "C" const char* __lsan_default_suppressions()
{
  return "leak:libexpat\n";
}

// Stand in for the program's own, which print.
void Warn(const std::string& text)
{
  Require(!text.empty());
}
void ThrowOnError(const std::string&)
{
}

namespace
{
/// A hill of 9 x 9 samples around 9 degrees east, 45 degrees north.
PlacedHeights MakeHeights()
{
  vtkObject::GlobalWarningDisplayOff();
  PlacedHeights heights;
  heights.Image = vtkSmartPointer<vtkImageData>::New();
  heights.Image->SetDimensions(9, 9, 1);
  heights.Image->SetOrigin(-4000.0, -4000.0, 0.0);
  heights.Image->SetSpacing(1000.0, 1000.0, 1.0);
  const vtkNew<vtkFloatArray> values;
  for (int k = 0; k < 81; ++k)
  {
    values->InsertNextValue(static_cast<float>(10 * (k % 9) * (8 - k % 9) + k / 9));
  }
  heights.Image->GetPointData()->SetScalars(values);
  heights.Georeference = vtkSmartPointer<vtkTerrainGeoreference>::New();
  heights.Georeference->SetCoordinateSystem("EPSG:4326");
  heights.Georeference->SetExtent(8.95, 9.05, 44.95, 45.05);
  heights.Georeference->SetFrame(vtkTerrainGeoreference::FrameType::Plane);
  heights.Georeference->SetOrigin(9.0, 45.0, 0.0);
  Require(heights.Georeference->GetWhyNot().empty());
  return heights;
}

void CheckCells(vtkCellArray* cells, vtkIdType points)
{
  const vtkNew<vtkIdList> ids;
  for (cells->InitTraversal(); cells->GetNextCell(ids) != 0;)
  {
    Require(ids->GetNumberOfIds() > 0);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      Require(ids->GetId(k) >= 0 && ids->GetId(k) < points);
    }
  }
}

void CheckVectors(
  const std::string& path, vtkTerrainGeoreference* scene, const std::string& field, Polygons kind)
{
  try
  {
    const vtkSmartPointer<vtkPolyData> read = ReadVectorsWithField(path, scene, field, kind);
    const vtkIdType points = read->GetNumberOfPoints();
    Require(points > 0);
    CheckCells(read->GetVerts(), points);
    CheckCells(read->GetLines(), points);
    CheckCells(read->GetPolys(), points);
    vtkAbstractArray* texts = read->GetPointData()->GetAbstractArray("Field");
    Require(field.empty() || (texts && texts->GetNumberOfTuples() == points));
    vtkDataArray* polygons = read->GetCellData()->GetArray(kPolygonOfRing);
    Require(kind != Polygons::Rings ||
      (polygons && polygons->GetNumberOfTuples() == read->GetNumberOfCells()));
  }
  catch (const Failure& failure)
  {
    Require(*failure.what() != '\0');
  }
}

void CheckTrack(const std::string& path, const PlacedHeights& heights)
{
  try
  {
    const FlightTrack track = ReadFlightTrack(path, heights, true);
    Require(track.Points.size() >= 2);
    Require(track.Times.empty() || track.Times.size() == track.Points.size());
    for (std::size_t k = 0; k < track.Points.size(); ++k)
    {
      const Place3& point = track.Points[k];
      Require(std::isfinite(point[0] + point[1] + point[2]));
      Require(track.Times.empty() || k == 0 || track.Times[k] >= track.Times[k - 1]);
    }
  }
  catch (const Failure&)
  {
  }
}

void CheckTable(const std::string& path, const PlacedHeights& heights)
{
  try
  {
    const std::vector<FlightKey> keys = ReadFlightTable(path, heights);
    Require(keys.size() >= 2);
    for (std::size_t k = 0; k < keys.size(); ++k)
    {
      const FlightView& view = keys[k].View;
      Require(std::isfinite(keys[k].Time) && (k == 0 || keys[k].Time > keys[k - 1].Time));
      Require(std::isfinite(view.Eye[0] + view.Eye[1] + view.Eye[2]));
    }
  }
  catch (const Failure&)
  {
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const PlacedHeights heights = MakeHeights();
  FuzzInput input(data, size);
  const auto what = input.Take<std::uint8_t>();
  const FuzzFile file({ input.Rest(), input.Rest() + input.Left() });
  if (what % 2 == 1)
  {
    CheckTable(file.Path(), heights);
    return 0;
  }
  const std::string field = what % 4 == 0 ? "name" : what % 8 == 2 ? "height" : "";
  CheckVectors(file.Path(), heights.Georeference, field, static_cast<Polygons>(what / 16 % 3));
  CheckTrack(file.Path(), heights);
  return 0;
}
