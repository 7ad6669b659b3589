// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Heights whose rows run south (direction matrix diag(1, -1, 1)) against the same heights with rows
// that run north: everything must come out the same, and VTK itself must agree where points lie.
#include "vtkTerrainTestingScene.h"

#include "vtkTerrainCoarseMesh.h"
#include "vtkTerrainDrape.h"
#include "vtkTerrainHorizon.h"
#include "vtkTerrainMesh.h"
#include "vtkTerrainMinMaxPyramid.h"
#include "vtkTerrainPicker.h"
#include "vtkTerrainReproject.h"
#include "vtkTerrainStrips.h"
#include "vtkTerrainViewshed.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkShortArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
using vtkTerrainTesting::MakeHills;
using vtkTerrainTesting::TerrainProp;
using vtkTerrainTesting::TerrainScene;

/// The tuples of an array of points or cells, rows turned round.
vtkSmartPointer<vtkDataArray> TurnRows(vtkDataArray* array, vtkIdType columns)
{
  auto turned = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
  turned->SetName(array->GetName());
  turned->SetNumberOfComponents(array->GetNumberOfComponents());
  turned->SetNumberOfTuples(array->GetNumberOfTuples());
  const vtkIdType rows = array->GetNumberOfTuples() / columns;
  for (vtkIdType k = 0; k < rows * columns; ++k)
  {
    turned->SetTuple(k, k % columns + columns * (rows - 1 - k / columns), array);
  }
  return turned;
}

/// The same heights and arrays, with rows from the north.
vtkSmartPointer<vtkImageData> FromNorth(vtkImageData* image)
{
  auto turned = vtkSmartPointer<vtkImageData>::New();
  const int* size = image->GetDimensions();
  const double* origin = image->GetOrigin();
  turned->SetDimensions(size[0], size[1], 1);
  turned->SetSpacing(image->GetSpacing());
  turned->SetOrigin(origin[0], origin[1] + (size[1] - 1) * image->GetSpacing()[1], origin[2]);
  turned->SetDirectionMatrix(1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0);
  for (int i = 0; i < image->GetPointData()->GetNumberOfArrays(); ++i)
  {
    turned->GetPointData()->AddArray(TurnRows(image->GetPointData()->GetArray(i), size[0]));
  }
  for (int i = 0; i < image->GetCellData()->GetNumberOfArrays(); ++i)
  {
    turned->GetCellData()->AddArray(TurnRows(image->GetCellData()->GetArray(i), size[0] - 1));
  }
  turned->GetPointData()->SetActiveScalars(image->GetPointData()->GetScalars()->GetName());
  turned->GetFieldData()->ShallowCopy(image->GetFieldData());
  return turned;
}

/// Hills with a hole, of floats or, hidden by ghosts, of short; with arrays of points and cells.
vtkSmartPointer<vtkImageData> MakeField(bool integers)
{
  vtkSmartPointer<vtkImageData> hills = MakeHills(!integers);
  vtkNew<vtkDoubleArray> number;
  number->SetName("Number");
  for (vtkIdType k = 0; k < hills->GetNumberOfPoints(); ++k)
  {
    number->InsertNextValue(std::sin(0.01 * static_cast<double>(k)));
  }
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("CellColors");
  colors->SetNumberOfComponents(3);
  for (vtkIdType k = 0; k < hills->GetNumberOfCells(); ++k)
  {
    colors->InsertNextTuple3(
      static_cast<double>(k % 251), static_cast<double>(k / 7 % 256), 255.0 * (k % 3 == 0));
  }
  if (integers)
  {
    vtkNew<vtkShortArray> heights;
    heights->SetName("Heights");
    vtkDataArray* floats = hills->GetPointData()->GetScalars();
    for (vtkIdType k = 0; k < floats->GetNumberOfTuples(); ++k)
    {
      heights->InsertNextValue(static_cast<short>(std::lround(floats->GetTuple1(k))));
    }
    hills->GetPointData()->SetScalars(heights);
    hills->AllocatePointGhostArray();
    for (const vtkIdType k : { 300, 301, 341, 700 })
    {
      hills->GetPointGhostArray()->SetValue(k, vtkDataSetAttributes::HIDDENPOINT);
    }
  }
  hills->GetPointData()->AddArray(number);
  hills->GetCellData()->AddArray(colors);
  return hills;
}

/// Both data sets have the same points, cells and point arrays.
void ExpectSameMesh(vtkPolyData* a, vtkPolyData* b)
{
  ASSERT_GT(a->GetNumberOfPoints(), 4);
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
  ASSERT_EQ(a->GetPointData()->GetNumberOfArrays(), b->GetPointData()->GetNumberOfArrays());
  for (vtkIdType k = 0; k < a->GetNumberOfPoints(); ++k)
  {
    double p[3];
    double q[3];
    a->GetPoint(k, p);
    b->GetPoint(k, q);
    ASSERT_TRUE(std::equal(p, p + 3, q)) << k;
  }
  for (int i = 0; i < a->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const from = a->GetPointData()->GetArray(i);
    vtkDataArray* const other = b->GetPointData()->GetArray(i);
    for (vtkIdType k = 0; k < from->GetNumberOfTuples(); ++k)
    {
      const double value = from->GetComponent(k, 0);
      ASSERT_TRUE(value == other->GetComponent(k, 0) || std::isnan(value)) << from->GetName() << k;
    }
  }
}

template <typename Filter, typename Setup>
vtkSmartPointer<vtkDataObject> ApplyFilter(vtkImageData* heights, Setup&& setup)
{
  vtkNew<Filter> filter;
  filter->SetInputData(heights);
  setup(filter.Get());
  filter->Update();
  return filter->GetOutputDataObject(0);
}

class RowsFromNorth : public testing::TestWithParam<bool>
{
protected:
  vtkSmartPointer<vtkImageData> South = MakeField(GetParam());
  vtkSmartPointer<vtkImageData> North = FromNorth(this->South);

  template <typename Filter, typename Setup>
  void ExpectSameMeshOf(Setup&& setup)
  {
    ExpectSameMesh(vtkPolyData::SafeDownCast(ApplyFilter<Filter>(this->South, setup)),
      vtkPolyData::SafeDownCast(ApplyFilter<Filter>(this->North, setup)));
  }

  /// Both outputs have the array at the same places.
  template <typename Filter, typename Setup>
  void ExpectSameArrayOf(const char* name, Setup&& setup)
  {
    const auto south = ApplyFilter<Filter>(this->South, setup);
    const auto north = ApplyFilter<Filter>(this->North, setup);
    vtkDataArray* a = vtkImageData::SafeDownCast(south)->GetPointData()->GetArray(name);
    vtkDataArray* b = vtkImageData::SafeDownCast(north)->GetPointData()->GetArray(name);
    ASSERT_TRUE(a && b);
    const auto turned = TurnRows(b, this->South->GetDimensions()[0]);
    double range[2];
    a->GetRange(range);
    EXPECT_LT(range[0], range[1]);
    for (vtkIdType k = 0; k < a->GetNumberOfTuples(); ++k)
    {
      const double value = a->GetComponent(k, 0);
      const double other = turned->GetComponent(k, 0);
      ASSERT_TRUE(value == other || (std::isnan(value) && std::isnan(other))) << name << " " << k;
    }
  }

  /// The picture of both, drawn with settings, is the same and not empty.
  void ExpectSamePicture(const vtkTerrainTesting::SceneFunction& function)
  {
    const auto pyramid = vtkOpenGLTerrainMapper::Techniques::Pyramid;
    const auto south = vtkTerrainTesting::DrawScene(function, pyramid, this->South);
    const auto north = vtkTerrainTesting::DrawScene(function, pyramid, this->North);
    EXPECT_EQ(vtkTerrainTesting::CountDifferentPixels(south, north), 0);
    const unsigned char* first = static_cast<unsigned char*>(south->GetScalarPointer());
    EXPECT_GT(
      vtkTerrainTesting::CountPixels(south,
        [first](const unsigned char* pixel) { return !std::equal(pixel, pixel + 3, first); }),
      5000);
  }
};
}

//------------------------------------------------------------------------------
TEST_P(RowsFromNorth, LieWhereVtkSaysThatTheyLie)
{
  for (const vtkIdType k : { 0, 40, 41, 700, 1352 })
  {
    double p[3];
    this->North->GetPoint(k, p);
    double q[3];
    const vtkIdType turned = k % 41 + 41 * (32 - k / 41);
    this->South->GetPoint(turned, q);
    EXPECT_TRUE(std::equal(p, p + 3, q));
  }
}

//------------------------------------------------------------------------------
TEST_P(RowsFromNorth, GiveTheSameMeshes)
{
  this->ExpectSameMeshOf<vtkTerrainCoarseMesh>([](vtkTerrainCoarseMesh*) {});
  this->ExpectSameMeshOf<vtkTerrainMesh>([](vtkTerrainMesh* mesh) { mesh->SetMaximumError(0.5); });
  vtkNew<vtkCamera> camera;
  camera->SetPosition(200.0, -200.0, 400.0);
  camera->SetFocalPoint(200.0, 180.0, 100.0);
  this->ExpectSameMeshOf<vtkTerrainStrips>(
    [&camera](vtkTerrainStrips* strips)
    {
      strips->SetCamera(camera);
      strips->SetTolerance(0.5);
    });
}

//------------------------------------------------------------------------------
TEST_P(RowsFromNorth, CarryWhatIsLaidOnThem)
{
  vtkNew<vtkPolyData> line;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(33.0, 41.0, 0.0);
  points->InsertNextPoint(366.0, 337.0, 0.0);
  line->SetPoints(points);
  line->AllocateExact(1, 2);
  const vtkIdType ids[] = { 0, 1 };
  line->InsertNextCell(VTK_LINE, 2, ids);
  const auto drape = [&](vtkImageData* heights)
  {
    vtkNew<vtkTerrainDrape> filter;
    filter->SetInputData(line);
    filter->SetHeightsData(heights);
    filter->Update();
    return vtkSmartPointer<vtkPolyData>(vtkPolyData::SafeDownCast(filter->GetOutput()));
  };
  ExpectSameMesh(drape(this->South), drape(this->North));
}

//------------------------------------------------------------------------------
TEST_P(RowsFromNorth, AreSeenTheSame)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(100.0, 60.0, 0.0);
  vtkNew<vtkPolyData> observers;
  observers->SetPoints(points);
  this->ExpectSameArrayOf<vtkTerrainViewshed>(
    "Observers", [&](vtkTerrainViewshed* filter) { filter->SetInputData(1, observers); });
  this->ExpectSameArrayOf<vtkTerrainViewshed>("RiseToBeSeen",
    [&](vtkTerrainViewshed* filter)
    {
      filter->SetInputData(1, observers);
      filter->SetOutputRise(true);
      filter->SetDistanceRange(0.0, 250.0); // NaN beyond
    });
  this->ExpectSameArrayOf<vtkTerrainHorizon>(
    "Horizon", [](vtkTerrainHorizon* filter) { filter->SetNumberOfDirections(5); });
  this->ExpectSameArrayOf<vtkTerrainHorizon>("SkyView", [](vtkTerrainHorizon*) {});
}

//------------------------------------------------------------------------------
TEST_P(RowsFromNorth, HaveTheSameBounds)
{
  const auto pyramid = [](vtkImageData* heights)
  { return ApplyFilter<vtkTerrainMinMaxPyramid>(heights, [](vtkTerrainMinMaxPyramid*) {}); };
  const auto south = pyramid(this->South);
  const auto north = pyramid(this->North);
  auto* a = vtkMultiBlockDataSet::SafeDownCast(south);
  auto* b = vtkMultiBlockDataSet::SafeDownCast(north);
  ASSERT_GT(a->GetNumberOfBlocks(), 3u);
  for (unsigned int k = 0; k < a->GetNumberOfBlocks(); ++k)
  {
    auto* first = vtkImageData::SafeDownCast(a->GetBlock(k));
    auto* second = vtkImageData::SafeDownCast(b->GetBlock(k));
    for (vtkIdType cell = 0; cell < first->GetNumberOfCells(); ++cell)
    {
      ASSERT_EQ(first->GetCellData()->GetScalars()->GetTuple1(cell),
        second->GetCellData()->GetScalars()->GetTuple1(cell));
    }
    EXPECT_EQ(first->GetOrigin()[1], second->GetOrigin()[1]);
  }
}

//------------------------------------------------------------------------------
TEST_P(RowsFromNorth, AreDrawnTheSame)
{
  this->ExpectSamePicture([](TerrainScene&, const TerrainProp&) {});
  for (const bool cells : { false, true })
  {
    this->ExpectSamePicture(
      [cells](TerrainScene&, const TerrainProp& terrain)
      {
        terrain.Mapper->SetColorSource(vtkOpenGLTerrainMapper::ColorSources::Array);
        terrain.Mapper->SetScalarModeToUsePointFieldData();
        terrain.Mapper->SelectColorArray("Number");
        terrain.Mapper->SetScalarRange(-1.0, 1.0);
        if (cells)
        {
          terrain.Mapper->SetScalarModeToUseCellFieldData();
          terrain.Mapper->SelectColorArray("CellColors");
        }
        terrain.Mapper->ScalarVisibilityOn();
      });
  }
}

//------------------------------------------------------------------------------
// A change of a part reaches the part.
TEST_P(RowsFromNorth, ChangeWhereTheyAreChanged)
{
  const auto change = [](bool north)
  {
    return [north](TerrainScene& scene, const TerrainProp& terrain)
    {
      vtkTerrainTesting::Render(scene.Window);
      vtkImageData* heights = terrain.Mapper->GetHeights();
      const int rows[2] = { north ? 24 : 4, north ? 28 : 8 };
      for (int row = rows[0]; row <= rows[1]; ++row)
      {
        for (int column = 10; column <= 20; ++column)
        {
          heights->SetScalarComponentFromDouble(column, row, 0, 0, 100.0);
        }
      }
      heights->GetPointData()->GetScalars()->Modified();
      heights->Modified();
      terrain.Mapper->HeightsModified(10, 20, rows[0], rows[1]);
    };
  };
  const auto pyramid = vtkOpenGLTerrainMapper::Techniques::Pyramid;
  const auto before =
    vtkTerrainTesting::DrawScene([](TerrainScene&, const TerrainProp&) {}, pyramid, this->South);
  const auto south = vtkTerrainTesting::DrawScene(change(false), pyramid, this->South);
  const auto north = vtkTerrainTesting::DrawScene(change(true), pyramid, this->North);
  EXPECT_GT(vtkTerrainTesting::CountDifferentPixels(before, south), 100);
  EXPECT_EQ(vtkTerrainTesting::CountDifferentPixels(north, south), 0);
}

//------------------------------------------------------------------------------
TEST_P(RowsFromNorth, ArePickedTheSame)
{
  vtkTerrainTesting::DrawScene(
    [this](TerrainScene& scene, const TerrainProp& terrain)
    {
      const TerrainProp other = scene.AddTerrain(this->North);
      for (int x = 20; x < 200; x += 20)
      {
        vtkNew<vtkTerrainPicker> south;
        vtkNew<vtkTerrainPicker> north;
        terrain.Actor->PickableOn();
        other.Actor->PickableOff();
        south->Pick(x, 60.0, 0.0, scene.Renderer);
        terrain.Actor->PickableOff();
        other.Actor->PickableOn();
        north->Pick(x, 60.0, 0.0, scene.Renderer);
        ASSERT_TRUE(south->IsTerrainPicked() && north->IsTerrainPicked()) << x;
        for (int axis = 0; axis < 3; ++axis)
        {
          EXPECT_EQ(south->GetPickPosition()[axis], north->GetPickPosition()[axis]);
        }
        EXPECT_EQ(south->GetGridPosition()[1], north->GetGridPosition()[1]);
        EXPECT_NEAR(south->GetValue("Number", 0), north->GetValue("Number", 0), 1e-12);
        double p[3];
        double q[3];
        this->South->GetPoint(south->GetPointId(), p);
        this->North->GetPoint(north->GetPointId(), q);
        EXPECT_TRUE(std::equal(p, p + 3, q));
      }
    },
    vtkOpenGLTerrainMapper::Techniques::Pyramid, this->South);
}

namespace
{
/// Numbers of the cells or samples that the pixels of a picture show, -1 for none.
std::vector<vtkIdType> SelectIds(vtkImageData* heights, bool cells)
{
  std::vector<vtkIdType> ids;
  vtkTerrainTesting::DrawScene(
    [&](TerrainScene& scene, const TerrainProp&)
    {
      vtkTerrainTesting::Render(scene.Window);
      const int* size = scene.Window->GetSize();
      const auto width = static_cast<unsigned int>(size[0]);
      const auto height = static_cast<unsigned int>(size[1]);
      vtkNew<vtkHardwareSelector> selector;
      selector->SetRenderer(scene.Renderer);
      selector->SetArea(0, 0, width - 1, height - 1);
      selector->SetFieldAssociation(
        cells ? vtkDataObject::FIELD_ASSOCIATION_CELLS : vtkDataObject::FIELD_ASSOCIATION_POINTS);
      ASSERT_TRUE(selector->CaptureBuffers());
      for (unsigned int y = 0; y < height; y += 3)
      {
        for (unsigned int x = 0; x < width; x += 3)
        {
          const unsigned int at[2] = { x, y };
          const auto found = selector->GetPixelInformation(at);
          ids.push_back(found.Valid ? found.AttributeID : -1);
        }
      }
    },
    vtkOpenGLTerrainMapper::Techniques::Pyramid, heights);
  return ids;
}
}

//------------------------------------------------------------------------------
TEST_P(RowsFromNorth, AreSelectedByTheirOwnNumbers)
{
  for (const bool cells : { true, false })
  {
    const vtkIdType columns = cells ? 40 : 41;
    const vtkIdType rows = cells ? 32 : 33;
    const std::vector<vtkIdType> south = SelectIds(this->South, cells);
    const std::vector<vtkIdType> north = SelectIds(this->North, cells);
    ASSERT_EQ(south.size(), north.size());
    int selected = 0;
    for (std::size_t k = 0; k < south.size(); ++k)
    {
      const vtkIdType id = south[k];
      selected += id >= 0 ? 1 : 0;
      ASSERT_EQ(north[k], id < 0 ? id : id % columns + columns * (rows - 1 - id / columns));
    }
    EXPECT_GT(selected, 500) << cells;
  }
}

INSTANTIATE_TEST_SUITE_P(Types, RowsFromNorth, testing::Bool(),
  [](const auto& type) { return type.param ? "ShortsWithGhosts" : "FloatsWithHole"; });

//------------------------------------------------------------------------------
// Other directions are refused.
TEST(HeightsOfOtherDirections, AreRefused)
{
  const vtkSmartPointer<vtkImageData> image = MakeHills();
  image->SetDirectionMatrix(-1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
  vtkNew<vtkTerrainViewshed> filter;
  filter->SetInputData(image);
  vtkNew<vtkPolyData> nobody;
  filter->SetInputData(1, nobody);
  vtkObject::GlobalWarningDisplayOff();
  filter->Update();
  vtkObject::GlobalWarningDisplayOn();
  EXPECT_NE(filter->GetErrorMessage().find("direction matrix"), std::string::npos);
}
