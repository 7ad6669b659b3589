// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Pictures and lines on heights, placed by any numbers: no picture, or one of as many pixels as
// there may be; lines through finite places.
#include "FuzzFile.h"
#include "FuzzImage.h"

#include "data/ImageHeights.h"
#include "parts/DrapePicture.h"
#include "vtkTerrainDrape.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainImageWarp.h"
#include "vtkTerrainLook.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <string>

namespace
{
/// A picture between bounds, as an exported surface has it.
void CheckPicture(FuzzInput& input, vtkImageData* heights)
{
  const vtkNew<vtkImageData> drape;
  const int width = 1 + static_cast<int>(input.Number(4));
  drape->SetDimensions(width, 1 + static_cast<int>(input.Number(4)), 1);
  drape->AllocateScalars(VTK_UNSIGNED_CHAR, 1 + static_cast<int>(input.Number(4)));
  vtkDataArray* texels = drape->GetPointData()->GetScalars();
  for (vtkIdType k = 0; k < texels->GetNumberOfValues(); ++k)
  {
    texels->SetVariantValue(k, input.Take<std::uint8_t>());
  }
  std::array<double, 4> bounds{};
  for (double& bound : bounds)
  {
    bound = HostileNumber(input, 100.0);
  }
  const vtkNew<vtkTerrainLook> look;
  look->SetDrape(drape, bounds.data());
  if (!look->GetDrape() || !terrain::ImageHeights::WhyNotHeights(heights).empty()) // refused
  {
    return;
  }
  const std::array<double, 4> whole = terrain::FindSampleBounds(heights);
  const int* size = drape->GetDimensions();
  const double columns = (whole[1] - whole[0]) / (bounds[1] - bounds[0]) * size[0];
  const double rows = (whole[3] - whole[2]) / (bounds[3] - bounds[2]) * size[1];
  if (columns > 300.0 || rows > 300.0) // which takes long
  {
    return;
  }
  const auto picture = terrain::MakeDrapePicture(drape, bounds, heights, nullptr);
  Require(picture && picture->GetNumberOfPoints() > 0);
}

void CheckLines(FuzzInput& input, vtkImageData* heights)
{
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const vtkNew<vtkCellArray> lines;
  const vtkNew<vtkCellArray> vertices;
  const int count = static_cast<int>(input.Number(6));
  lines->InsertNextCell(count);
  for (int k = 0; k < count; ++k)
  {
    const double x = HostileNumber(input, 100.0);
    const double y = HostileNumber(input, 100.0);
    const vtkIdType point = points->InsertNextPoint(x, y, HostileNumber(input, 1000.0));
    lines->InsertCellPoint(point);
    vertices->InsertNextCell(1, &point);
  }
  const vtkNew<vtkPolyData> tracks;
  tracks->SetPoints(points);
  tracks->SetLines(lines);
  tracks->SetVerts(vertices);
  const vtkNew<vtkTerrainDrape> drape;
  drape->SetInputData(tracks);
  drape->SetHeightsData(heights);
  drape->SetMode(static_cast<vtkTerrainDrape::ModeType>(input.Number(3)));
  drape->SetOffset(HostileNumber(input, 100.0));
  drape->SetTolerance(HostileNumber(input, 100.0));
  drape->SetExaggeration(HostileNumber(input, 5.0));
  drape->Update();
  vtkPolyData* output = drape->GetOutput();
  for (vtkIdType k = 0; k < output->GetNumberOfPoints(); ++k)
  {
    double place[3];
    output->GetPoint(k, place);
    const bool isOnGround = drape->GetMode() != vtkTerrainDrape::ModeType::Absolute;
    Require(!isOnGround || std::isfinite(place[0] + place[1]));
  }
}

/// A picture in a file, of a geotransform of any numbers.
void CheckWarp(FuzzInput& input, vtkImageData* heights)
{
  const bool isInDegrees = input.Number(2) != 0;
  std::string text = "<VRTDataset rasterXSize=\"4\" rasterYSize=\"3\"><SRS>";
  text += isInDegrees ? "EPSG:4326" : "EPSG:32632";
  text += "</SRS><GeoTransform>";
  const double reach = isInDegrees ? 20.0 : 1e6;
  for (int k = 0; k < 6; ++k)
  {
    char number[40];
    std::snprintf(number, sizeof(number), k == 0 ? "%.17g" : ",%.17g",
      HostileNumber(input, k % 3 == 0 ? reach : 0.1 * reach));
    text += number;
  }
  text += "</GeoTransform><VRTRasterBand dataType=\"Byte\" band=\"1\"/></VRTDataset>";
  const FuzzFile file(text);
  const vtkNew<vtkTerrainGeoreference> georeference;
  georeference->SetCoordinateSystem("EPSG:32632");
  georeference->SetFromHeights(heights);
  georeference->SetFrame(static_cast<vtkTerrainGeoreference::FrameType>(input.Number(6)));
  const vtkNew<vtkTerrainImageWarp> warp;
  warp->SetInputData(heights);
  warp->SetGeoreference(georeference);
  warp->SetFileName(file.Path());
  warp->SetMaximumSize(64);
  warp->Update();
  const int* size = warp->GetOutput()->GetDimensions();
  Require(size[0] <= 64 && size[1] <= 64);
  Require(warp->GetErrorMessage().empty() || warp->GetOutput()->GetNumberOfPoints() == 0);
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  vtkObject::GlobalWarningDisplayOff();
  FuzzInput input(data, size);
  const std::uint32_t what = input.Number(3);
  const auto heights = what == 2 ? HostileHeights(input, 500000.0, 5000000.0, 1e4)
                                 : HostileHeights(input, 0.0, 0.0, 10.0);
  what == 0     ? CheckPicture(input, heights)
    : what == 1 ? CheckLines(input, heights)
                : CheckWarp(input, heights);
  return 0;
}
