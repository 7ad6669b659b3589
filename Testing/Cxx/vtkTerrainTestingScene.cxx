// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainTestingScene.h"

#include "vtkTerrainCoarseMesh.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRendererCollection.h"
#include "vtkReverseSense.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vtkTerrainTesting
{
namespace
{
using Techniques = vtkOpenGLTerrainMapper::Techniques;

constexpr int Width = 200;
constexpr int Height = 150;
constexpr int Columns = 41;
constexpr int Rows = 33;
constexpr int Agreement = 8;

//------------------------------------------------------------------------------
double HeightAt(vtkImageData* heights, int i, int j)
{
  return heights->GetScalarComponentAsDouble(i, j, 0, 0);
}

//------------------------------------------------------------------------------
/// Between a and b; what has no weight may be NaN.
double Mixed(double a, double b, double t)
{
  return t == 0.0 ? a : t == 1.0 ? b : (1.0 - t) * a + t * b;
}

//------------------------------------------------------------------------------
/// An array of points at node (x, y) of the fine mesh, bilinearly; NaN where a corner that counts
/// is.
double FineValue(vtkImageData* image, vtkDataArray* array, int component, int x, int y, int parts)
{
  const int* size = image->GetDimensions();
  const int i = std::min(x / parts, size[0] - 2);
  const int j = std::min(y / parts, size[1] - 2);
  const double u = static_cast<double>(x) / parts - i;
  const double v = static_cast<double>(y) / parts - j;
  auto at = [&](int di, int dj)
  { return array->GetComponent(i + di + vtkIdType{ size[0] } * (j + dj), component); };
  return Mixed(Mixed(at(0, 0), at(1, 0), u), Mixed(at(0, 1), at(1, 1), u), v);
}

//------------------------------------------------------------------------------
/// Height of the bilinear surface at a position in cells, NaN where there is none.
double SurfaceAt(vtkImageData* heights, double x, double y)
{
  const int* size = heights->GetDimensions();
  const int i = std::clamp(static_cast<int>(x), 0, size[0] - 2);
  const int j = std::clamp(static_cast<int>(y), 0, size[1] - 2);
  return Mixed(Mixed(HeightAt(heights, i, j), HeightAt(heights, i + 1, j), x - i),
    Mixed(HeightAt(heights, i, j + 1), HeightAt(heights, i + 1, j + 1), x - i), y - j);
}

//------------------------------------------------------------------------------
/// Slope along an axis at a position in cells, in height units a cell: MakeLitMesh().
double SlopeAt(vtkImageData* heights, const std::array<double, 2>& position, std::size_t axis)
{
  const double size = heights->GetDimensions()[axis];
  std::array<double, 2> height{};
  std::array<double, 2> at{};
  for (std::size_t end = 0; end < 2; ++end)
  {
    std::array<double, 2> there = position;
    there[axis] = std::clamp(there[axis] + (end == 0 ? -0.5 : 0.5), 0.0, size - 1.0);
    height[end] = SurfaceAt(heights, there[0], there[1]);
    if (std::isnan(height[end]))
    {
      there = position;
      height[end] = SurfaceAt(heights, there[0], there[1]);
    }
    at[end] = there[axis];
  }
  return at[1] > at[0] ? (height[1] - height[0]) / (at[1] - at[0]) : 0.0;
}

//------------------------------------------------------------------------------
/// Adds the arrays of the image's points to the fine mesh.
void AddPointArrays(vtkPolyData* mesh, vtkImageData* image, int width, int height, int parts)
{
  for (int a = 0; a < image->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = image->GetPointData()->GetArray(a);
    const auto fine = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
    fine->SetName(array->GetName());
    fine->SetNumberOfComponents(array->GetNumberOfComponents());
    fine->SetNumberOfTuples(vtkIdType{ width } * height);
    for (vtkIdType i = 0; i < fine->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        const auto x = static_cast<int>(i % width);
        const auto y = static_cast<int>(i / width);
        fine->SetComponent(i, c, FineValue(image, array, c, x, y, parts));
      }
    }
    mesh->GetPointData()->AddArray(fine);
  }
  mesh->GetPointData()->SetActiveScalars(image->GetPointData()->GetScalars()->GetName());
}

//------------------------------------------------------------------------------
/// Slope and aspect, in degrees, in the middle of square (x, y) of the fine mesh.
std::array<double, 2> SlopeAndAspect(vtkImageData* heights, int x, int y, int parts)
{
  const int i = x / parts;
  const int j = y / parts;
  const double u = (x % parts + 0.5) / parts;
  const double v = (y % parts + 0.5) / parts;
  const double southWest = HeightAt(heights, i, j);
  const double southEast = HeightAt(heights, i + 1, j);
  const double northWest = HeightAt(heights, i, j + 1);
  const double northEast = HeightAt(heights, i + 1, j + 1);
  const double east =
    Mixed(southEast - southWest, northEast - northWest, v) / heights->GetSpacing()[0];
  const double north =
    Mixed(northWest - southWest, northEast - southEast, u) / heights->GetSpacing()[1];
  const double aspect = vtkMath::DegreesFromRadians(std::atan2(-east, -north));
  return { vtkMath::DegreesFromRadians(std::atan(std::hypot(east, north))),
    aspect < 0.0 ? aspect + 360.0 : aspect };
}

//------------------------------------------------------------------------------
bool CellIsValid(vtkImageData* heights, int i, int j)
{
  return std::isfinite(HeightAt(heights, i, j) + HeightAt(heights, i + 1, j) +
    HeightAt(heights, i, j + 1) + HeightAt(heights, i + 1, j + 1));
}

//------------------------------------------------------------------------------
/// True for pixels within one of a jump of depth in a z-buffer: where depth changes far more from a
/// pixel to the next than on either side of them.
std::vector<bool> Silhouettes(const std::vector<float>& depth)
{
  auto jumps = [&](int index, int step)
  {
    const double before = std::abs(depth[index] - depth[index - step]);
    const double jump = std::abs(depth[index + step] - depth[index]);
    const double after = std::abs(depth[index + 2 * step] - depth[index + step]);
    return jump > 2.0 * (before + after) + 1e-4;
  };
  std::vector<bool> band(depth.size(), false);
  for (int y = 1; y < Height - 2; ++y)
  {
    for (int x = 1; x < Width - 2; ++x)
    {
      const int index = x + Width * y;
      for (int step : { 1, Width })
      {
        for (int around = 0; jumps(index, step) && around < 9; ++around)
        {
          const int beside = around % 3 - 1 + Width * (around / 3 - 1);
          band[index + beside] = true;
          band[index + step + beside] = true;
        }
      }
    }
  }
  return band;
}

//------------------------------------------------------------------------------
TerrainScene MakeTerrainScene(
  const SceneFunction& function, Techniques technique, vtkImageData* heights)
{
  TerrainScene scene(technique);
  const TerrainProp terrain =
    scene.AddTerrain(heights ? heights : static_cast<vtkImageData*>(MakeHills().Get()));
  scene.Look({ 200.0, 900.0, 420.0 }, { 200.0, 190.0, 80.0 });
  if (function)
  {
    function(scene, terrain);
  }
  return scene;
}

//------------------------------------------------------------------------------
/// The silhouettes of a scene with all its terrains opaque and without passes.
std::vector<bool> SilhouettesOf(TerrainScene& scene)
{
  vtkRendererCollection* renderers = scene.Window->GetRenderers();
  for (int i = 0; i < renderers->GetNumberOfItems(); ++i)
  {
    static_cast<vtkRenderer*>(renderers->GetItemAsObject(i))->SetPass(nullptr);
  }
  for (TerrainProp& terrain : scene.Terrains)
  {
    terrain.Actor->ForceOpaqueOn();
    terrain.Actor->GetProperty()->SetOpacity(1.0);
  }
  scene.Window->Render();
  return Silhouettes(ReadDepth(scene.Window));
}

//------------------------------------------------------------------------------
/// Largest difference of a component.
int PixelDifference(vtkImageData* a, vtkImageData* b, int x, int y)
{
  int largest = 0;
  for (int c = 0; c < 3; ++c)
  {
    const double difference =
      a->GetScalarComponentAsDouble(x, y, 0, c) - b->GetScalarComponentAsDouble(x, y, 0, c);
    largest = std::max(largest, std::abs(static_cast<int>(difference)));
  }
  return largest;
}

//------------------------------------------------------------------------------
/// Has the terrains of a scene drawn by stock mappers.
void UseStockMappers(TerrainScene& scene)
{
  for (TerrainProp& terrain : scene.Terrains)
  {
    vtkOpenGLTerrainMapper* ours = terrain.Mapper;
    vtkNew<vtkPolyDataMapper> stock;
    const auto mesh = MakeLitMesh(ours->GetHeights(), ours->GetVerticalExaggeration());
    terrain.Actor->ComputeMatrix();
    if (terrain.Actor->GetMatrix()->Determinant() < 0.0)
    {
      // VTK takes the side of a mirrored triangle that is seen for the other one
      vtkNew<vtkReverseSense> reverse;
      reverse->SetInputData(mesh);
      reverse->Update();
      mesh->SetPolys(reverse->GetOutput()->GetPolys());
    }
    stock->SetInputData(mesh);
    stock->ScalarVisibilityOff();
    stock->SetClippingPlanes(ours->GetClippingPlanes());
    double factor = 0.0;
    double units = 0.0;
    ours->GetRelativeCoincidentTopologyPolygonOffsetParameters(factor, units);
    stock->SetRelativeCoincidentTopologyPolygonOffsetParameters(factor, units);
    terrain.Actor->SetMapper(stock);
  }
}

//------------------------------------------------------------------------------
/// True if nearly all pixels have the colour of the one in the middle: nothing is shown.
bool IsBlank(vtkImageData* picture)
{
  const auto* pixels = static_cast<unsigned char*>(picture->GetScalarPointer());
  const auto* middle =
    static_cast<unsigned char*>(picture->GetScalarPointer(Width / 2, Height / 2, 0));
  int same = 0;
  for (int i = 0; i < Width * Height; ++i)
  {
    same += std::equal(middle, middle + 3, pixels + 3 * i) ? 1 : 0;
  }
  return same > 0.95 * Width * Height;
}

//------------------------------------------------------------------------------
/// Compares a picture with that of a scene; largest mean difference: of 255.
testing::AssertionResult Judge(
  vtkImageData* rays, TerrainScene& scene, const Demands& demands, double largestMean = 255.0)
{
  const auto mesh = Render(scene.Window);
  const std::vector<bool> band = SilhouettesOf(scene);
  static const auto bare = DrawScene(nullptr, Techniques::Mesh);
  const vtkIdType effect = CountDifferentPixels(mesh, bare, 2);
  int compared = 0;
  int different = 0;
  double sum = 0.0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const int difference = band[x + Width * y] ? 0 : PixelDifference(rays, mesh, x, y);
      compared += band[x + Width * y] ? 0 : 1;
      different += difference > Agreement ? 1 : 0;
      sum += difference;
    }
  }
  const double mean = sum / std::max(compared, 1);
  const bool same = different <= (1.0 - demands.Share) * compared && mean <= largestMean;
  if (same && !IsBlank(mesh) && compared > Width * Height / 2 &&
    effect >= demands.Effect * Width * Height)
  {
    return testing::AssertionSuccess();
  }
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string name = WindowName() + "-" + test->test_suite_name() + "-" + test->name();
  WritePicture(rays, OutputPath(name + "-rays.png"));
  WritePicture(mesh, OutputPath(name + "-mesh.png"));
  return testing::AssertionFailure()
    << different << " of " << compared << " pixels away from silhouettes differ, by " << mean
    << " in the mean, and the scene "
    << "changes " << effect << " pixels" << (IsBlank(mesh) ? "; the mesh shows nothing" : "")
    << "; the pictures are " << OutputPath(name + "-*.png");
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeHills(bool withHole)
{
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("heights");
  heights->SetNumberOfValues(vtkIdType{ Columns } * Rows);
  for (int j = 0; j < Rows; ++j)
  {
    for (int i = 0; i < Columns; ++i)
    {
      const bool hole = withHole && std::abs(i - 22) < 4 && std::abs(j - 18) < 4;
      heights->SetValue(i + Columns * j,
        hole ? std::numeric_limits<double>::quiet_NaN()
             : 100.0 + 30.0 * std::sin(0.4 * i) * std::cos(0.35 * j) + 8.0 * std::sin(0.9 * i + j));
    }
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Columns, Rows, 1);
  image->SetSpacing(10.0, 12.0, 1.0);
  image->GetPointData()->SetScalars(heights);
  return image;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeFineMesh(vtkImageData* heights, int parts)
{
  const int* size = heights->GetDimensions();
  const double* origin = heights->GetOrigin();
  const double* spacing = heights->GetSpacing();
  const int width = parts * (size[0] - 1) + 1;
  const int height = parts * (size[1] - 1) + 1;
  vtkDataArray* scalars = heights->GetPointData()->GetScalars();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> positions;
  positions->SetName("TextureCoordinates");
  positions->SetNumberOfComponents(2);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      positions->InsertNextTuple2(x / (width - 1.0), y / (height - 1.0));
      const double z = FineValue(heights, scalars, 0, x, y, parts);
      points->InsertNextPoint(origin[0] + spacing[0] * x / parts,
        origin[1] + spacing[1] * y / parts, origin[2] + (std::isfinite(z) ? z : 0.0));
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkCellData* cellData = heights->GetCellData();
  mesh->GetCellData()->CopyAllocate(cellData);
  vtkNew<vtkDoubleArray> slopes;
  slopes->SetName("Slope");
  vtkNew<vtkDoubleArray> aspects;
  aspects->SetName("Aspect");
  vtkNew<vtkCellArray> triangles;
  for (int y = 0; y < height - 1; ++y)
  {
    for (int x = 0; x < width - 1; ++x)
    {
      if (CellIsValid(heights, x / parts, y / parts))
      {
        const vtkIdType corner = x + vtkIdType{ width } * y;
        triangles->InsertNextCell({ corner, corner + 1, corner + width + 1 });
        triangles->InsertNextCell({ corner, corner + width + 1, corner + width });
        const std::array<double, 2> fall = SlopeAndAspect(heights, x, y, parts);
        for (vtkIdType cell = triangles->GetNumberOfCells() - 2;
             cell < triangles->GetNumberOfCells(); ++cell)
        {
          slopes->InsertNextValue(fall[0]);
          aspects->InsertNextValue(fall[1]);
          mesh->GetCellData()->CopyData(
            cellData, x / parts + vtkIdType{ size[0] - 1 } * (y / parts), cell);
        }
      }
    }
  }
  mesh->SetPoints(points);
  mesh->SetPolys(triangles);
  mesh->GetPointData()->SetTCoords(positions);
  AddPointArrays(mesh, heights, width, height, parts);
  mesh->GetCellData()->AddArray(slopes);
  mesh->GetCellData()->AddArray(aspects);
  return mesh;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeLitMesh(vtkImageData* heights, double exaggeration)
{
  constexpr int parts = 6; // half a cell is a number of them: slopes change at points
  const auto mesh = MakeFineMesh(heights, parts);
  const int width = parts * (heights->GetDimensions()[0] - 1) + 1;
  const double* spacing = heights->GetSpacing();
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (vtkIdType k = 0; k < mesh->GetNumberOfPoints(); ++k)
  {
    std::array<double, 3> point{};
    mesh->GetPoint(k, point.data());
    point[2] = heights->GetOrigin()[2] + exaggeration * (point[2] - heights->GetOrigin()[2]);
    mesh->GetPoints()->SetPoint(k, point.data());
    const std::array<double, 2> position{ static_cast<double>(k % width) / parts,
      static_cast<double>(k / width) / parts };
    std::array<double, 3> normal{ -exaggeration * SlopeAt(heights, position, 0) / spacing[0],
      -exaggeration * SlopeAt(heights, position, 1) / spacing[1], 1.0 };
    vtkMath::Normalize(normal.data());
    normals->InsertNextTuple(normal.data());
  }
  mesh->GetPointData()->SetNormals(normals);
  return mesh;
}

//------------------------------------------------------------------------------
TerrainScene::TerrainScene(Techniques technique)
  : Technique(technique)
{
  const Scene scene = MakeScene(Width, Height);
  this->Window = scene.Window;
  this->Renderer = scene.Renderer;
  this->Renderer->SetBackground(0.2, 0.3, 0.5);
}

//------------------------------------------------------------------------------
TerrainProp TerrainScene::AddTerrain(vtkImageData* heights)
{
  TerrainProp terrain;
  terrain.Mapper = vtkSmartPointer<vtkOpenGLTerrainMapper>::New();
  terrain.Actor = vtkSmartPointer<vtkActor>::New();
  terrain.Mapper->SetHeightsData(heights);
  terrain.Mapper->SetTechnique(this->Technique);
  if (this->Technique == Techniques::Mesh)
  {
    terrain.Mapper->SetInputData(MakeFineMesh(heights));
  }
  else
  {
    vtkNew<vtkTerrainCoarseMesh> mesh;
    mesh->SetInputData(heights);
    mesh->SetCellsPerQuad(8);
    terrain.Mapper->SetInputConnection(mesh->GetOutputPort());
  }
  terrain.Actor->SetMapper(terrain.Mapper);
  terrain.Actor->GetProperty()->SetColor(0.8, 0.7, 0.5);
  terrain.Actor->GetProperty()->SetAmbient(0.2);
  terrain.Actor->GetProperty()->SetDiffuse(0.8);
  this->Renderer->AddActor(terrain.Actor);
  this->Terrains.push_back(terrain);
  return terrain;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> TerrainScene::AddSphere(double x, double y, double z, double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(x, y, z);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(48);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.3, 0.2);
  this->Renderer->AddActor(actor);
  return actor;
}

//------------------------------------------------------------------------------
void TerrainScene::Look(const std::array<double, 3>& eye, const std::array<double, 3>& focus)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(focus.data());
  camera->SetViewUp(0.0, 0.0, 1.0);
  this->Renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> DrawScene(
  const SceneFunction& function, Techniques technique, vtkImageData* heights)
{
  return Render(MakeTerrainScene(function, technique, heights).Window);
}

//------------------------------------------------------------------------------
testing::AssertionResult DrawsAsTheMesh(const SceneFunction& function, const Demands& demands)
{
  TerrainScene scene = MakeTerrainScene(function, Techniques::Mesh, demands.Heights);
  const auto rays = DrawScene(function, demands.Technique, demands.Heights);
  testing::AssertionResult asTheMesh = Judge(rays, scene, demands);
  if (!asTheMesh || demands.StockMean == 0.0)
  {
    return asTheMesh;
  }
  const testing::AssertionResult asStock = DrawsAsStock(function, demands);
  return asStock ? asTheMesh : testing::AssertionFailure() << "Stock: " << asStock.message();
}

//------------------------------------------------------------------------------
testing::AssertionResult DrawsAsStock(const SceneFunction& function, const Demands& demands)
{
  TerrainScene scene = MakeTerrainScene(function, Techniques::Mesh, demands.Heights);
  UseStockMappers(scene);
  const auto rays = DrawScene(function, demands.Technique, demands.Heights);
  return Judge(rays, scene, demands, demands.StockMean);
}

//------------------------------------------------------------------------------
testing::AssertionResult DrawsAsThePlainMesh(
  const PropFunction& terrain, const PropFunction& mesh, const Demands& demands)
{
  auto settle = [&](TerrainScene&, const TerrainProp& prop)
  {
    prop.Actor->GetProperty()->LightingOff();
    terrain(prop.Mapper, prop.Actor);
  };
  auto replace = [&](TerrainScene&, const TerrainProp& prop)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(MakeFineMesh(prop.Mapper->GetHeights(), demands.Parts));
    mapper->ScalarVisibilityOff();
    prop.Actor->SetMapper(mapper);
    prop.Actor->GetProperty()->LightingOff();
    mesh(mapper, prop.Actor);
  };
  TerrainScene scene = MakeTerrainScene(replace, Techniques::Mesh, demands.Heights);
  return Judge(DrawScene(settle, demands.Technique, demands.Heights), scene, demands);
}
}
