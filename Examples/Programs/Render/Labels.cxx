// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Labels.h"

#include "Annotations.h"

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

#include <cmath>
#include <memory>
#include <sstream>

namespace
{
/// Point array of vtkTerrainReproject in round scenes.
const char* const kHeightOfPlace = "PlaceHeight";

vtkSmartPointer<vtkTerrainViewpoint> ViewpointOf(const PlacedHeights& heights)
{
  auto viewpoint = vtkSmartPointer<vtkTerrainViewpoint>::New();
  viewpoint->SetGeoreference(heights.Georeference);
  viewpoint->SetHeights(heights.Image);
  viewpoint->SetExaggeration(heights.Exaggeration);
  return viewpoint;
}

std::string MetresText(double height)
{
  return GroupedNumber(std::round(height), 1.0) + " m";
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

/// Labels of a file, their points in the file's own coordinates until they are on the ground.
struct LabelFile
{
  const std::string& Path;
  const PlacedHeights& Heights;
  std::vector<Label> Labels;
  int Beside = 0;
  int Nameless = 0;

  void AddLayer(OGRLayerH layer);
  void AddFeature(OGRFeatureH feature, vtkTerrainGeoreference* file, vtkTerrainViewpoint* ground);
};

void LabelFile::AddFeature(
  OGRFeatureH feature, vtkTerrainGeoreference* file, vtkTerrainViewpoint* ground)
{
  OGRGeometryH geometry = OGR_F_GetGeometryRef(feature);
  const std::string name = NameOfFeature(feature);
  if (!geometry || OGR_G_IsEmpty(geometry) != 0 || name.empty())
  {
    this->Nameless += geometry && name.empty() ? 1 : 0;
    return;
  }
  OGREnvelope box;
  OGR_G_GetEnvelope(geometry, &box);
  std::array<double, 3> place = { 0.5 * (box.MinX + box.MaxX), 0.5 * (box.MinY + box.MaxY), 0.0 };
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
  const vtkSmartPointer<vtkTerrainViewpoint> ground = ViewpointOf(this->Heights);
  OGR_L_ResetReading(layer);
  while (OGRFeatureH feature = OGR_L_GetNextFeature(layer))
  {
    const std::unique_ptr<void, void (*)(void*)> owner(feature, OGR_F_Destroy);
    this->AddFeature(feature, file, ground);
  }
}

std::string WhyNoLabels(const LabelFile& file, bool isOpen)
{
  return !isOpen           ? "it cannot be read as points with names"
    : !file.Labels.empty() ? std::string()
    : file.Beside > 0      ? "none of its places lies on the terrain"
    : file.Nameless > 0    ? "none of its points has a name: name a field `name`"
                           : "there are no points in it: the first line of a table must name the "
                             "columns lon, lat and name";
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
  LabelFile file{ path, heights, {} };
  for (int k = 0; open && k < GDALDatasetGetLayerCount(open.get()); ++k)
  {
    file.AddLayer(GDALDatasetGetLayer(open.get(), k));
  }
  CPLPopErrorHandler();
  const std::string why = WhyNoLabels(file, open != nullptr);
  if (!why.empty())
  {
    throw Failure(path, why);
  }
  if (file.Beside > 0)
  {
    Warn(path + ": " + std::to_string(file.Beside) + " of its places lie beside the terrain");
  }
  return file.Labels;
}

//------------------------------------------------------------------------------
std::vector<Label> FindPeakLabels(int count, const PlacedHeights& heights)
{
  const vtkNew<vtkImageData> image;
  image->ShallowCopy(heights.Image);
  if (image->GetPointData()->GetArray(kHeightOfPlace))
  {
    image->GetPointData()->SetActiveScalars(kHeightOfPlace);
  }
  const vtkNew<vtkTerrainPeaks> peaks;
  peaks->SetInputData(image);
  peaks->SetNumberOfPeaks(count);
  peaks->Update();
  ThrowOnError("--peaks");
  const vtkSmartPointer<vtkTerrainViewpoint> ground = ViewpointOf(heights);
  vtkPolyData* found = peaks->GetOutput();
  vtkDataArray* of = found->GetPointData()->GetArray("Height");
  std::vector<Label> labels;
  for (vtkIdType k = 0; k < found->GetNumberOfPoints(); ++k)
  {
    Label label;
    label.Text = MetresText(of->GetComponent(k, 0) + image->GetOrigin()[2]);
    found->GetPoint(k, label.Point.data());
    label.Point[2] = ground->GetGround(label.Point[0], label.Point[1]);
    labels.push_back(label);
  }
  return labels;
}
