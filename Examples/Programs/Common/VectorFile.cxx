// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VectorFile.h"

#include "Failure.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTerrainGeoid.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainOutputFile.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <set>
#include <sstream>
#include <vector>

namespace
{
/// Geometries of a file, three coordinates a point.
struct Vectors
{
  std::vector<double> Coordinates;
  vtkNew<vtkCellArray> Vertices;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkCellArray> Areas;
  /// Of rings, the number of the polygon that each belongs to.
  vtkNew<vtkIntArray> PolygonOfRing;
  int PolygonCount = 0;
  Polygons Kind = Polygons::Outlines;
  /// Name of the only layer that is read; empty for all that are not repeated.
  std::string Layer{};
  /// Name of the field whose texts are kept, one for each point; empty for none.
  std::string Field{};
  std::vector<std::string> Texts{};
  bool HasField = false;
  std::set<std::string> Fields{};

  void Add(OGRGeometryH geometry);
  void AddFeature(OGRFeatureH feature);

private:
  void AddPoints(OGRGeometryH geometry, vtkCellArray* cells);
  void AddRings(OGRGeometryH polygon);
};

void Vectors::AddPoints(OGRGeometryH geometry, vtkCellArray* cells)
{
  const int count = OGR_G_GetPointCount(geometry);
  if (count < 1)
  {
    return;
  }
  cells->InsertNextCell(count);
  for (int i = 0; i < count; ++i)
  {
    cells->InsertCellPoint(static_cast<vtkIdType>(this->Coordinates.size() / 3));
    for (const double coordinate :
      { OGR_G_GetX(geometry, i), OGR_G_GetY(geometry, i), OGR_G_GetZ(geometry, i) })
    {
      this->Coordinates.push_back(coordinate);
    }
  }
}

void Vectors::AddRings(OGRGeometryH polygon)
{
  // long sides are no straight lines in another CRS
  constexpr double kSides = 64.0;
  OGREnvelope extent;
  OGR_G_GetEnvelope(polygon, &extent);
  OGR_G_CloseRings(polygon);
  const double side = std::max(extent.MaxX - extent.MinX, extent.MaxY - extent.MinY) / kSides;
  if (side > 0.0 && std::isfinite(side))
  {
    OGR_G_Segmentize(polygon, side);
  }
  for (int i = 0; i < OGR_G_GetGeometryCount(polygon); ++i)
  {
    const vtkIdType before = this->Lines->GetNumberOfCells();
    this->AddPoints(OGR_G_GetGeometryRef(polygon, i), this->Lines);
    if (this->Lines->GetNumberOfCells() > before)
    {
      this->PolygonOfRing->InsertNextValue(this->PolygonCount);
    }
  }
  ++this->PolygonCount;
}

void Vectors::Add(OGRGeometryH geometry)
{
  const int parts = OGR_G_GetGeometryCount(geometry);
  const bool isPolygon = wkbFlatten(OGR_G_GetGeometryType(geometry)) == wkbPolygon;
  if (isPolygon && this->Kind == Polygons::Rings)
  {
    this->AddRings(geometry);
    return;
  }
  if (isPolygon && parts > 0 && this->Kind == Polygons::Areas)
  {
    this->AddPoints(OGR_G_GetGeometryRef(geometry, 0), this->Areas);
    return;
  }
  for (int i = 0; i < parts; ++i)
  {
    this->Add(OGR_G_GetGeometryRef(geometry, i));
  }
  if (parts > 0 || this->Kind == Polygons::Rings)
  {
    return;
  }
  switch (wkbFlatten(OGR_G_GetGeometryType(geometry)))
  {
    case wkbPoint:
      this->AddPoints(geometry, this->Vertices);
      break;
    case wkbLineString:
    case wkbLinearRing:
      this->AddPoints(geometry, this->Lines);
      break;
    default:
      break; // empty collections, and surfaces of solids
  }
}

void Vectors::AddFeature(OGRFeatureH feature)
{
  OGRGeometryH curved = OGR_F_GetGeometryRef(feature);
  if (!curved)
  {
    return;
  }
  const std::size_t first = this->Coordinates.size() / 3;
  OGRGeometryH geometry = OGR_G_GetLinearGeometry(curved, 0.0, nullptr);
  this->Add(geometry);
  OGR_G_DestroyGeometry(geometry);
  if (this->Field.empty())
  {
    return;
  }
  for (int k = 0; k < OGR_F_GetFieldCount(feature); ++k)
  {
    this->Fields.insert(OGR_Fld_GetNameRef(OGR_F_GetFieldDefnRef(feature, k)));
  }
  const int field = OGR_F_GetFieldIndex(feature, this->Field.c_str());
  const bool isHeight = field < 0 && this->Field == "height";
  const bool isThere = field >= 0 && OGR_F_IsFieldSetAndNotNull(feature, field) != 0;
  this->HasField = this->HasField || isHeight || isThere;
  const std::string text = isThere ? OGR_F_GetFieldAsString(feature, field) : "";
  for (std::size_t point = first; point < this->Coordinates.size() / 3; ++point)
  {
    std::ostringstream height;
    height << this->Coordinates[3 * point + 2];
    this->Texts.push_back(isHeight ? height.str() : text);
  }
}

/// WKT of the layer's CRS; empty if it has none.
std::string CoordinateSystemOf(OGRLayerH layer)
{
  char* text = nullptr;
  OGRSpatialReferenceH reference = OGR_L_GetSpatialRef(layer);
  const char* const options[] = { "FORMAT=WKT2_2019", nullptr };
  if (reference)
  {
    OSRExportToWktEx(reference, &text, options);
  }
  std::string definition = text ? text : "";
  CPLFree(text);
  return definition;
}

/// Adds the geometries of a layer, brought into the scene. Returns why not, else nothing.
std::string AddLayer(OGRLayerH layer, vtkTerrainGeoreference* scene, Vectors& vectors)
{
  const std::size_t first = vectors.Coordinates.size();
  OGR_L_ResetReading(layer);
  while (OGRFeatureH feature = OGR_L_GetNextFeature(layer))
  {
    vectors.AddFeature(feature);
    OGR_F_Destroy(feature);
  }
  if (vectors.Coordinates.size() == first)
  {
    return {};
  }
  const vtkNew<vtkTerrainGeoreference> file;
  file->SetCoordinateSystem(CoordinateSystemOf(layer));
  file->SetFrame(scene->IsOnOtherWorld() ? vtkTerrainGeoreference::FrameType::Globe
                                         : vtkTerrainGeoreference::FrameType::Geocentric);
  file->SetSceneHeights(scene->GetSceneHeights());
  file->GetGeoid()->SetModel(scene->GetGeoid()->GetModel());
  double* points = vectors.Coordinates.data() + first;
  const auto count = static_cast<vtkIdType>((vectors.Coordinates.size() - first) / 3);
  if (!file->FileToPlaces(points, points, count))
  {
    return file->GetWhyNot();
  }
  return scene->PlacesToScene(points, points, count) ? std::string() : scene->GetWhyNot();
}

/// True if the features of a layer are the points of the features of another one.
bool IsRepeated(GDALDatasetH file, OGRLayerH layer)
{
  const char* driver = GDALGetDriverShortName(GDALGetDatasetDriver(file));
  const char* name = OGR_L_GetName(layer);
  return std::strcmp(driver, "GPX") == 0 &&
    (std::strcmp(name, "track_points") == 0 || std::strcmp(name, "route_points") == 0);
}

/// Fills in the geometries of a file. Throws a Failure.
void ReadFile(const std::string& path, vtkTerrainGeoreference* scene, Vectors& vectors)
{
  const std::string whyNot = vtkTerrainOutputFile::WhyNotInput(path);
  if (!whyNot.empty())
  {
    throw Failure(path, whyNot);
  }
  GDALAllRegister();
  CPLSetThreadLocalConfigOption("GPX_ELE_AS_25D", "YES"); // heights of GPX as coordinates
  CPLErrorReset();
  CPLPushErrorHandler(CPLQuietErrorHandler);
  const std::unique_ptr<void, void (*)(void*)> file(
    GDALOpenEx(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, nullptr, nullptr, nullptr),
    [](void* open)
    {
      if (open)
      {
        GDALClose(open);
      }
    });
  std::string why = file ? "" : "it cannot be read as points, lines and polygons";
  const int layers = file ? GDALDatasetGetLayerCount(file.get()) : 0;
  for (int i = 0; i < layers && why.empty(); ++i)
  {
    OGRLayerH layer = GDALDatasetGetLayer(file.get(), i);
    const bool isWanted = vectors.Layer.empty() ? !IsRepeated(file.get(), layer)
                                                : vectors.Layer == OGR_L_GetName(layer);
    if (isWanted)
    {
      why = AddLayer(layer, scene, vectors);
    }
  }
  CPLPopErrorHandler();
  if (why.empty() && vectors.Coordinates.empty() && vectors.Layer.empty())
  {
    why = vectors.Kind == Polygons::Rings ? "there are no polygons in it"
                                          : "there are no points and lines in it";
  }
  if (!why.empty())
  {
    throw Failure(path, why);
  }
}

vtkSmartPointer<vtkPolyData> ToPolyData(const Vectors& vectors)
{
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(vectors.Coordinates.size() / 3));
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(i, vectors.Coordinates.data() + 3 * i);
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetVerts(vectors.Vertices);
  result->SetLines(vectors.Lines);
  result->SetPolys(vectors.Areas);
  if (!vectors.Field.empty())
  {
    const vtkNew<vtkStringArray> texts;
    texts->SetName("Field");
    for (const std::string& text : vectors.Texts)
    {
      texts->InsertNextValue(text);
    }
    result->GetPointData()->AddArray(texts);
  }
  if (vectors.Kind == Polygons::Rings)
  {
    vectors.PolygonOfRing->SetName(kPolygonOfRing);
    result->GetCellData()->AddArray(vectors.PolygonOfRing);
  }
  return result;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadVectors(
  const std::string& path, vtkTerrainGeoreference* scene, Polygons polygons)
{
  return ReadVectorsWithField(path, scene, "", polygons);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadVectorsWithField(const std::string& path,
  vtkTerrainGeoreference* scene, const std::string& field, Polygons polygons)
{
  Vectors vectors;
  vectors.Kind = polygons;
  vectors.Field = field;
  ReadFile(path, scene, vectors);
  if (!field.empty() && !vectors.HasField)
  {
    std::string why = "no feature of it has '" + field + "'; there are height";
    for (const std::string& known : vectors.Fields)
    {
      why += ", " + known;
    }
    throw Failure(path, why);
  }
  return ToPolyData(vectors);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadTrackPoints(const std::string& path, vtkTerrainGeoreference* scene)
{
  Vectors vectors;
  vectors.Layer = "track_points"; // as GDAL calls it in GPX
  vectors.Field = "time";
  ReadFile(path, scene, vectors);
  return ToPolyData(vectors);
}
