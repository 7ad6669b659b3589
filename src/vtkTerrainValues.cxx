// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainValues.h"

#include "data/GlobeData.h"
#include "data/ImageHeights.h"
#include "data/Setting.h"
#include "place/PlacedRaster.h"
#include "raster/RasterMessages.h"
#include "vtkTerrainGeoreference.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace terrain
{
namespace
{
const char* const kValues = "Values";

bool AreIntegers(GDALDataType type)
{
  return type == GDT_Byte || type == GDT_UInt16 || type == GDT_Int16 || type == GDT_UInt32 ||
    type == GDT_Int32;
}

/// True if the numbers of a band stand for classes, by what the file says.
bool HoldsClasses(GDALRasterBandH band)
{
  if (!AreIntegers(GDALGetRasterDataType(band)))
  {
    return false;
  }
  GDALRasterAttributeTableH table = GDALGetDefaultRAT(band);
  char** names = GDALGetRasterCategoryNames(band);
  return GDALGetRasterColorTable(band) || (names && *names) ||
    (table && GDALRATGetTableType(table) == GRTT_THEMATIC && GDALRATGetRowCount(table) > 0);
}

/// Number of the band that tells how opaque others are, the last one; 0 for none.
int FindAlpha(GDALDatasetH file, int number)
{
  const int last = GDALGetRasterCount(file);
  const bool isAlpha = last > 1 && last != number &&
    GDALGetRasterColorInterpretation(GDALGetRasterBand(file, last)) == GCI_AlphaBand;
  return isAlpha ? last : 0;
}

/// True if a mask of the file, which is no band of it, tells where a band has values.
bool HasMask(GDALRasterBandH band)
{
  return (GDALGetMaskFlags(band) & GMF_PER_DATASET) != 0;
}

/// Classes that the colour table of a band shows as transparent become none.
void HideTransparent(GDALRasterBandH band, float* values, std::ptrdiff_t count)
{
  GDALColorTableH table = GDALGetRasterColorTable(band);
  const int entries = table ? GDALGetColorEntryCount(table) : 0;
  std::vector<bool> isHidden(static_cast<std::size_t>(entries));
  for (int entry = 0; entry < entries; ++entry)
  {
    GDALColorEntry color{};
    isHidden[static_cast<std::size_t>(entry)] =
      GDALGetColorEntryAsRGB(table, entry, &color) && color.c4 == 0;
  }
  std::replace_if(
    values, values + count,
    [&](float value)
    {
      return value >= 0.0F && value < static_cast<float>(entries) &&
        isHidden[static_cast<std::size_t>(value)];
    },
    std::numeric_limits<float>::quiet_NaN());
}

/// One band of a raster, warped onto samples or cells of heights.
class ValueWarp : public PlacedRaster
{
public:
  GDALRasterBandH Band = nullptr;
  int Size[2] = { 0, 0 };

  std::string OpenBand(const std::string& name, const std::string& system, int number);
  void LayOut(bool onCells);
  double CountPixelsOfACell();
  std::string WarpValues(int number, bool areClasses, float* values);

private:
  GDALWarpOptions* MakeOptions(GDALDatasetH target, int number, bool areClasses);
};

std::string ValueWarp::OpenBand(const std::string& name, const std::string& system, int number)
{
  std::string why = this->Open(name, system);
  if (!why.empty())
  {
    return why;
  }
  const int bands = GDALGetRasterCount(this->File.get());
  if (number < 1 || number > bands)
  {
    return "'" + name + "' has " + std::to_string(bands) + " bands, and no band " +
      std::to_string(number);
  }
  this->Band = GDALGetRasterBand(this->File.get(), number);
  return {};
}

/// Sets the grid: a pixel round each sample, or each cell.
void ValueWarp::LayOut(bool onCells)
{
  const GridGeometry geometry = ImageHeights::Geometry(this->Heights);
  const std::array<double, 2> origin = { geometry.Origin.x, geometry.Origin.y };
  const std::array<double, 2> spacing = { geometry.Spacing.x, geometry.Spacing.y };
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    this->Spacing[axis] = spacing[axis];
    this->Corner[axis] = origin[axis] - (onCells ? 0.0 : 0.5 * spacing[axis]);
    this->Size[axis] = this->Heights->GetDimensions()[axis] - (onCells ? 1 : 0);
  }
  std::array<double, 2> range{};
  this->Heights->GetPointData()->GetScalars()->GetFiniteRange(range.data());
  this->MiddleHeight = 0.5 * (range[0] + range[1]);
}

/// Pixels of the raster in a cell in the middle of the heights; 0 where it has no image.
double ValueWarp::CountPixelsOfACell()
{
  const double x = this->Corner[0] + 0.5 * this->Size[0] * this->Spacing[0];
  const double y = this->Corner[1] + 0.5 * this->Size[1] * this->Spacing[1];
  std::vector<double> cross{ x, y, 0.0, x + this->Spacing[0], y, 0.0, x, y + this->Spacing[1],
    0.0 };
  this->SceneToPixels(cross);
  const double area = std::abs(
    (cross[3] - cross[0]) * (cross[7] - cross[1]) - (cross[4] - cross[1]) * (cross[6] - cross[0]));
  return std::isfinite(area) ? area : 0.0;
}

GDALWarpOptions* ValueWarp::MakeOptions(GDALDatasetH target, int number, bool areClasses)
{
  constexpr double kMany = 2.0;
  GDALWarpOptions* options = GDALCreateWarpOptions();
  options->hSrcDS = this->File.get();
  options->hDstDS = target;
  const GDALResampleAlg ofClasses =
    this->CountPixelsOfACell() > kMany ? GRA_Mode : GRA_NearestNeighbour;
  options->eResampleAlg = areClasses ? ofClasses : GRA_Bilinear;
  options->nBandCount = 1;
  options->panSrcBands = static_cast<int*>(CPLMalloc(sizeof(int)));
  options->panDstBands = static_cast<int*>(CPLMalloc(sizeof(int)));
  *options->panSrcBands = number;
  *options->panDstBands = 1;
  // What is transparent has no values; the second band tells where any have come to.
  options->nSrcAlphaBand = FindAlpha(this->File.get(), number);
  options->nDstAlphaBand = 2;
  int hasNoData = 0;
  const double noData = GDALGetRasterNoDataValue(this->Band, &hasNoData);
  const bool isMasked = options->nSrcAlphaBand == 0 && HasMask(this->Band);
  if (!isMasked) // GDAL takes the mask where no value stands for no data
  {
    options->padfSrcNoDataReal = static_cast<double*>(CPLMalloc(sizeof(double)));
    *options->padfSrcNoDataReal = hasNoData ? noData : std::numeric_limits<double>::quiet_NaN();
  }
  options->papszWarpOptions = CSLSetNameValue(options->papszWarpOptions, "INIT_DEST", "0");
  return options;
}

/// Fills in Size[0] x Size[1] values, southern row first.
std::string ValueWarp::WarpValues(int number, bool areClasses, float* values)
{
  const GDALMessages messages;
  const Dataset target = Own(GDALCreate(
    GDALGetDriverByName("MEM"), "", this->Size[0], this->Size[1], 2, GDT_Float32, nullptr));
  if (!target)
  {
    return "its values need more memory than there is (" + messages.GetFailure() + ")";
  }
  std::string why =
    this->Warp(this->MakeOptions(target.get(), number, areClasses), this->Size[0], this->Size[1]);
  if (!why.empty())
  {
    return why;
  }
  const std::ptrdiff_t count = std::ptrdiff_t{ this->Size[0] } * this->Size[1];
  std::vector<float> opacities(static_cast<std::size_t>(count));
  const auto read = [&](int band, float* into)
  {
    return GDALRasterIO(GDALGetRasterBand(target.get(), band), GF_Read, 0, 0, this->Size[0],
             this->Size[1], into, this->Size[0], this->Size[1], GDT_Float32, 0, 0) == CE_None;
  };
  if (!read(1, values) || !read(2, opacities.data()))
  {
    return "it cannot be warped (" + messages.GetFailure() + ")";
  }
  if (areClasses)
  {
    HideTransparent(this->Band, values, count);
  }
  int isScaled = 0;
  int isShifted = 0;
  const double scale = GDALGetRasterScale(this->Band, &isScaled);
  const double offset = GDALGetRasterOffset(this->Band, &isShifted);
  std::transform(values, values + count, opacities.begin(), values,
    [&](float value, float opacity)
    {
      return opacity > 0.0F
        ? static_cast<float>((isScaled ? scale : 1.0) * value + (isShifted ? offset : 0.0))
        : std::numeric_limits<float>::quiet_NaN();
    });
  const bool isEmpty =
    std::none_of(values, values + count, [](float value) { return std::isfinite(value); });
  return isEmpty ? "it has no values on the terrain" : "";
}
}
}

vtkStandardNewMacro(vtkTerrainValues);

vtkTerrainValues::vtkTerrainValues() = default;
vtkTerrainValues::~vtkTerrainValues() = default;

void vtkTerrainValues::SetFileName(const std::string& fileName)
{
  terrain::Setting::Set(this, this->FileName, fileName);
}

void vtkTerrainValues::SetGeoreference(vtkTerrainGeoreference* georeference)
{
  terrain::Setting::Set(this, this->Georeference, georeference);
}

vtkTerrainGeoreference* vtkTerrainValues::GetGeoreference() const
{
  return this->Georeference;
}

void vtkTerrainValues::SetCoordinateSystem(const std::string& definition)
{
  terrain::Setting::Set(this, this->CoordinateSystem, definition);
}

void vtkTerrainValues::SetKind(KindType kind)
{
  terrain::Setting::Set(this, this->Kind, kind);
}

vtkMTimeType vtkTerrainValues::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Georeference ? std::max(time, this->Georeference->GetMTime()) : time;
}

int vtkTerrainValues::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkTerrainValues::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  vtkInformation* info = inputs[0]->GetInformationObject(0);
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
  return 1;
}

std::string vtkTerrainValues::AddValues(vtkImageData* image)
{
  std::string why = terrain::ImageHeights::WhyNotHeights(image);
  if (!why.empty())
  {
    return why;
  }
  if (image->GetDimensions()[0] < 2 || image->GetDimensions()[1] < 2)
  {
    return "the heights have no cells";
  }
  why = !this->Georeference ? "there is no georeference of the heights"
                            : this->Georeference->GetWhyNot();
  if (!why.empty())
  {
    return why;
  }
  terrain::ValueWarp warp;
  warp.Heights = image;
  warp.Scene = this->Georeference;
  warp.Globe = terrain::GlobeData::Get(image);
  why = warp.OpenBand(this->FileName, this->CoordinateSystem, this->Band);
  if (!why.empty())
  {
    return why;
  }
  this->Classes = this->Kind == KindType::Classes ||
    (this->Kind == KindType::Automatic && terrain::HoldsClasses(warp.Band));
  const std::string name = terrain::GDALGetDescription(warp.Band);
  this->Title =
    name.empty() ? vtksys::SystemTools::GetFilenameWithoutLastExtension(this->FileName) : name;
  this->Unit = terrain::GDALGetRasterUnitType(warp.Band);
  warp.LayOut(this->Classes);
  vtkNew<vtkFloatArray> values;
  values->SetName(terrain::kValues);
  values->SetNumberOfTuples(vtkIdType{ warp.Size[0] } * warp.Size[1]);
  why = warp.WarpValues(this->Band, this->Classes, values->GetPointer(0));
  if (!why.empty())
  {
    return "'" + this->FileName + "': " + why;
  }
  terrain::ImageHeights::ArrangeRows(image, values->GetPointer(0), warp.Size[0], warp.Size[1]);
  vtkDataSetAttributes* data = image->GetPointData();
  (this->Classes ? image->GetCellData() : data)->AddArray(values);
  return {};
}

int vtkTerrainValues::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->ShallowCopy(vtkImageData::GetData(inputs[0]));
  this->ErrorMessage = this->AddValues(output);
  if (!this->ErrorMessage.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< this->ErrorMessage);
    return 0;
  }
  return 1;
}

void vtkTerrainValues::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "Band: " << this->Band << "\n";
  os << indent << "CoordinateSystem: " << this->CoordinateSystem << "\n";
  os << indent << "Kind: " << static_cast<int>(this->Kind) << "\n";
  os << indent << "Classes: " << this->Classes << "\n";
  os << indent << "Title: " << this->Title << "\n";
  os << indent << "Unit: " << this->Unit << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
  os << indent << "Georeference: " << this->Georeference.Get() << "\n";
}
