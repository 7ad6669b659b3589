// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Labels.h"

#include "Annotations.h"
#include "Failure.h"
#include "Messages.h"
#include "Placing.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainOutputFile.h"
#include "vtkTerrainPeaks.h"
#include "vtkTerrainViewpoint.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>

namespace
{
/// Point array of vtkTerrainReproject in round scenes.
const char* const kHeightOfPlace = "PlaceHeight";

std::string MetresText(double height)
{
  return GroupedNumber(std::round(height), 1.0) + " m";
}

/// The first of some fields that a file has, whatever a feature has there; -1 if it has none.
int ColumnOf(OGRFeatureH feature, std::initializer_list<const char*> names)
{
  for (const char* name : names)
  {
    const int field = OGR_F_GetFieldIndex(feature, name);
    if (field >= 0)
    {
      return field;
    }
  }
  return -1;
}

/// The first of some fields that a feature has; -1 if it has none.
int FieldOf(OGRFeatureH feature, std::initializer_list<const char*> names)
{
  for (const char* name : names)
  {
    const int field = OGR_F_GetFieldIndex(feature, name);
    if (field >= 0 && OGR_F_IsFieldSetAndNotNull(feature, field) != 0)
    {
      return field;
    }
  }
  return -1;
}

std::string NameOfFeature(OGRFeatureH feature)
{
  int field = FieldOf(feature, { "name", "label", "title" });
  for (int k = 0; field < 0 && k < OGR_F_GetFieldCount(feature); ++k)
  {
    const bool isText = OGR_Fld_GetType(OGR_F_GetFieldDefnRef(feature, k)) == OFTString;
    field = isText && OGR_F_IsFieldSetAndNotNull(feature, k) != 0 ? k : -1;
  }
  return field < 0 ? std::string() : OGR_F_GetFieldAsString(feature, field);
}

/// A number of a feature's field, as text in metres; empty if it has none.
std::string HeightOfFeature(OGRFeatureH feature)
{
  const int field = FieldOf(feature, { "height", "ele", "elevation" });
  const std::string text = field < 0 ? "" : OGR_F_GetFieldAsString(feature, field);
  char* end = nullptr;
  const double height = std::strtod(text.c_str(), &end);
  return text.empty() || *end != '\0' || !std::isfinite(height) ? "" : " " + MetresText(height);
}

/// First lines of the records of a table, numbered from 1, as GDAL's CSV driver counts records: it
/// leaves empty lines out, and text in quotes may go on in the next line.
std::vector<int> RecordLines(const std::string& path)
{
  std::ifstream file(path);
  std::vector<int> lines;
  std::string line;
  bool isInQuotes = false;
  for (int number = 1; std::getline(file, line); ++number)
  {
    const bool isEmpty = line.empty() || line == "\r";
    if (!isInQuotes && !isEmpty)
    {
      lines.push_back(number);
    }
    isInQuotes ^= std::count(line.begin(), line.end(), '"') % 2 != 0;
  }
  return lines;
}

/// A finite number of a field; empty for all other text.
std::optional<double> NumberOfField(OGRFeatureH feature, int field)
{
  const std::string text = OGR_F_GetFieldAsString(feature, field);
  double number = 0.0;
  const bool isNumber = CLI::detail::lexical_cast(text, number) && std::isfinite(number);
  return isNumber ? std::optional(number) : std::nullopt;
}

/// What is wrong with a record that is left out.
struct BadRecord
{
  /// "FILE, line 3".
  std::string Where;
  std::string Why;
};

/// Labels of a file, their points in the file's own coordinates until they are on the ground.
struct LabelFile
{
  const std::string& Path;
  const PlacedHeights& Heights;
  std::vector<Label> Labels{};
  /// Of the records of a table; empty for other files.
  std::vector<int> Lines{};
  /// Number of the record that is read, from 1.
  std::size_t Record = 0;
  int Beside = 0;
  int Nameless = 0;
  std::vector<BadRecord> Bad{};

  void AddLayer(OGRLayerH layer);
  void AddFeature(OGRFeatureH feature, vtkTerrainGeoreference* file, vtkTerrainViewpoint* ground);
  std::string WhereIsRecord() const;
  std::optional<std::array<double, 3>> PlaceOfFeature(OGRFeatureH feature);
};

std::string LabelFile::WhereIsRecord() const
{
  return this->Record < this->Lines.size()
    ? this->Path + ", line " + std::to_string(this->Lines[this->Record])
    : this->Path + ", feature " + std::to_string(this->Record);
}

/// Where a feature is, in the file's coordinates; empty, and told, if it is nowhere. Columns of
/// tables are read here: GDAL takes what is no number for 0.
std::optional<std::array<double, 3>> LabelFile::PlaceOfFeature(OGRFeatureH feature)
{
  std::array<double, 3> place{};
  const int lon = ColumnOf(feature, { "lon", "lng", "long", "longitude", "x" });
  const int lat = ColumnOf(feature, { "lat", "latitude", "y" });
  if (!this->Lines.empty() && lon >= 0 && lat >= 0)
  {
    for (const auto& [axis, field] : { std::pair(0, lon), std::pair(1, lat) })
    {
      const std::optional<double> number = NumberOfField(feature, field);
      if (!number)
      {
        const std::string column = OGR_Fld_GetNameRef(OGR_F_GetFieldDefnRef(feature, field));
        this->Bad.push_back({ this->WhereIsRecord(), "its " + column + " is no number" });
        return std::nullopt;
      }
      place[static_cast<std::size_t>(axis)] = *number;
    }
    return place;
  }
  OGRGeometryH geometry = OGR_F_GetGeometryRef(feature);
  OGREnvelope box{};
  if (geometry)
  {
    OGR_G_GetEnvelope(geometry, &box);
    place = { 0.5 * (box.MinX + box.MaxX), 0.5 * (box.MinY + box.MaxY), 0.0 };
  }
  if (!geometry || OGR_G_IsEmpty(geometry) != 0 || !std::isfinite(place[0] + place[1]))
  {
    this->Bad.push_back({ this->WhereIsRecord(), "it has no coordinates" });
    return std::nullopt;
  }
  return place;
}

void LabelFile::AddFeature(
  OGRFeatureH feature, vtkTerrainGeoreference* file, vtkTerrainViewpoint* ground)
{
  ++this->Record;
  std::optional<std::array<double, 3>> found = this->PlaceOfFeature(feature);
  if (!found)
  {
    return;
  }
  const std::string name = NameOfFeature(feature);
  if (name.empty())
  {
    ++this->Nameless;
    this->Bad.push_back({ this->WhereIsRecord(), "it has no name" });
    return;
  }
  if (CPLIsUTF8(name.c_str(), -1) == 0)
  {
    throw Failure(this->WhereIsRecord(), "its name is not UTF-8: save the file in that encoding");
  }
  std::array<double, 3>& place = *found;
  if (!file->FileToPlaces(place.data(), place.data(), 1))
  {
    throw Failure(this->Path, file->GetWhyNot());
  }
  std::ostringstream text;
  text.precision(12);
  text << place[0] << ',' << place[1];
  Label label;
  label.Text = name + HeightOfFeature(feature);
  if (ground->FindPlace(text.str(), label.Point.data()).empty())
  {
    this->Labels.push_back(label);
  }
  else
  {
    ++this->Beside;
  }
}

void LabelFile::AddLayer(OGRLayerH layer)
{
  const vtkNew<vtkTerrainGeoreference> file;
  OGRSpatialReferenceH reference = OGR_L_GetSpatialRef(layer);
  char* definition = nullptr;
  const char* const options[] = { "FORMAT=WKT2_2019", nullptr };
  if (reference)
  {
    OSRExportToWktEx(reference, &definition, options);
  }
  file->SetCoordinateSystem(definition ? definition : "EPSG:4326"); // tables name none
  CPLFree(definition);
  file->SetFrame(vtkTerrainGeoreference::FrameType::Geocentric);
  const vtkSmartPointer<vtkTerrainViewpoint> ground = MakeViewpoint(this->Heights);
  OGR_L_ResetReading(layer);
  while (OGRFeatureH feature = OGR_L_GetNextFeature(layer))
  {
    const std::unique_ptr<void, void (*)(void*)> owner(feature, OGR_F_Destroy);
    this->AddFeature(feature, file, ground);
  }
}

/// True if no record has coordinates, not even columns for them.
bool LacksColumns(const LabelFile& file)
{
  return std::all_of(file.Bad.begin(), file.Bad.end(),
    [](const BadRecord& bad) { return bad.Why == "it has no coordinates"; });
}

/// Throws a Failure if there is nothing to draw.
void CheckLabels(const LabelFile& file, bool isOpen)
{
  const std::string& path = file.Path;
  if (!isOpen)
  {
    throw Failure(path, "it cannot be read as points with names");
  }
  if (!file.Labels.empty())
  {
    return;
  }
  if (file.Beside > 0)
  {
    throw Failure(path, "none of its places lies on the terrain");
  }
  if (LacksColumns(file))
  {
    throw Failure(path,
      "there are no points in it: the first line of a table must name the columns lon, lat and "
      "name");
  }
  if (file.Nameless == static_cast<int>(file.Bad.size()))
  {
    throw Failure(path, "none of its points has a name: name a field `name`");
  }
  throw Failure(file.Bad.front().Where,
    file.Bad.front().Why + ", and no other point has numbers for coordinates and a name");
}

/// One line about all that is left out for what is wrong with it.
void WarnOfBad(const LabelFile& file)
{
  if (!file.Bad.empty())
  {
    const BadRecord& first = file.Bad.front();
    const std::string others = std::to_string(file.Bad.size() - 1);
    std::string text = first.Where + ": " + first.Why + ": it is left out";
    text += file.Bad.size() > 1 ? ", with " + others + " more" : "";
    Warn(text);
  }
}
}

//------------------------------------------------------------------------------
std::vector<Label> ReadLabels(const std::string& path, const PlacedHeights& heights)
{
  const std::string whyNot = vtkTerrainOutputFile::WhyNotInput(path);
  if (!whyNot.empty())
  {
    throw Failure(path, whyNot);
  }
  GDALAllRegister();
  const char* const options[] = { "X_POSSIBLE_NAMES=lon,lng,long,longitude,x",
    "Y_POSSIBLE_NAMES=lat,latitude,y", "AUTODETECT_TYPE=NO", nullptr };
  CPLPushErrorHandler(CPLQuietErrorHandler);
  const std::unique_ptr<void, void (*)(void*)> open(
    GDALOpenEx(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, nullptr, options, nullptr),
    [](void* dataset)
    {
      if (dataset)
      {
        GDALClose(dataset);
      }
    });
  LabelFile file{ path, heights };
  if (open && EQUAL(GDALGetDriverShortName(GDALGetDatasetDriver(open.get())), "CSV"))
  {
    file.Lines = RecordLines(path);
  }
  for (int k = 0; open && k < GDALDatasetGetLayerCount(open.get()); ++k)
  {
    file.AddLayer(GDALDatasetGetLayer(open.get(), k));
  }
  CPLPopErrorHandler();
  CheckLabels(file, open != nullptr);
  WarnOfBad(file);
  if (file.Beside > 0)
  {
    Warn(path + ": " + std::to_string(file.Beside) + " of its places lie beside the terrain");
  }
  return file.Labels;
}

//------------------------------------------------------------------------------
std::vector<Label> FindPeakLabels(
  int count, const PlacedHeights& heights, std::optional<double> water)
{
  const vtkNew<vtkImageData> image;
  image->ShallowCopy(heights.Image);
  if (image->GetPointData()->GetArray(kHeightOfPlace))
  {
    image->GetPointData()->SetActiveScalars(kHeightOfPlace);
  }
  const vtkNew<vtkTerrainPeaks> peaks;
  peaks->SetInputData(image);
  peaks->SetNumberOfPeaks(water ? std::numeric_limits<int>::max() : count);
  peaks->Update();
  ThrowOnError("--peaks");
  const vtkSmartPointer<vtkTerrainViewpoint> ground = MakeViewpoint(heights);
  vtkPolyData* found = peaks->GetOutput();
  vtkDataArray* of = found->GetPointData()->GetArray("Height");
  const auto most = static_cast<std::size_t>(count);
  std::vector<Label> labels;
  for (vtkIdType k = 0; k < found->GetNumberOfPoints() && labels.size() < most; ++k)
  {
    const double height = of->GetComponent(k, 0) + image->GetOrigin()[2];
    if (water && height <= *water)
    {
      continue;
    }
    Label label;
    label.Text = MetresText(height);
    found->GetPoint(k, label.Point.data());
    if (!heights.IsGlobe())
    {
      label.Point[2] = ground->GetGround(label.Point[0], label.Point[1]);
    }
    labels.push_back(label);
  }
  return labels;
}
