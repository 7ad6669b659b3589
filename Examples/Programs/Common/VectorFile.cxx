// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VectorFile.h"

#include "Failure.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTerrainGeoid.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainOutputFile.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

#include <cstring>
#include <memory>
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
  Polygons Kind = Polygons::Outlines;

  void Add(OGRGeometryH geometry);

private:
  void AddPoints(OGRGeometryH geometry, vtkCellArray* cells);
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

void Vectors::Add(OGRGeometryH geometry)
{
  const int parts = OGR_G_GetGeometryCount(geometry);
  const bool isPolygon = wkbFlatten(OGR_G_GetGeometryType(geometry)) == wkbPolygon;
  if (isPolygon && parts > 0 && this->Kind == Polygons::Areas)
  {
    this->AddPoints(OGR_G_GetGeometryRef(geometry, 0), this->Areas);
    return;
  }
  for (int i = 0; i < parts; ++i)
  {
    this->Add(OGR_G_GetGeometryRef(geometry, i));
  }
  if (parts > 0)
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
    if (OGRGeometryH curved = OGR_F_GetGeometryRef(feature))
    {
      OGRGeometryH geometry = OGR_G_GetLinearGeometry(curved, 0.0, nullptr);
      vectors.Add(geometry);
      OGR_G_DestroyGeometry(geometry);
    }
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
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadVectors(
  const std::string& path, vtkTerrainGeoreference* scene, Polygons polygons)
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
  Vectors vectors;
  vectors.Kind = polygons;
  std::string why = file ? "" : "it cannot be read as points and lines";
  const int layers = file ? GDALDatasetGetLayerCount(file.get()) : 0;
  for (int i = 0; i < layers && why.empty(); ++i)
  {
    OGRLayerH layer = GDALDatasetGetLayer(file.get(), i);
    if (!IsRepeated(file.get(), layer))
    {
      why = AddLayer(layer, scene, vectors);
    }
  }
  CPLPopErrorHandler();
  if (why.empty() && vectors.Coordinates.empty())
  {
    why = "there are no points and lines in it";
  }
  if (!why.empty())
  {
    throw Failure(path, why);
  }
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
  return result;
}
