// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainImageWarp.h"

#include "core/files/OutputFile.h"
#include "core/grid/HeightSampling.h"
#include "data/ImageHeights.h"
#include "data/Setting.h"
#include "raster/GDALTable.h"
#include "vtkTerrainGeoreference.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace terrain
{
namespace
{
using Frame = vtkTerrainGeoreference::FrameType;

// Points along each side of the picture by which it is found in the scene.
constexpr int kOutlinePoints = 65;
// Pixels of the picture by which an interpolated transformation may be wrong.
constexpr double kApproximation = 0.05;

using Dataset = std::unique_ptr<void, void (*)(void*)>;

Dataset Own(GDALDatasetH dataset)
{
  return { dataset,
    [](void* open)
    {
      if (open)
      {
        GDALClose(open);
      }
    } };
}

/// GDAL's messages of this thread are kept, not printed.
class Messages
{
public:
  Messages()
  {
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
  }
  ~Messages()
  {
    CPLPopErrorHandler();
  }
  Messages(const Messages&) = delete;
  void operator=(const Messages&) = delete;

  static std::string Last()
  {
    return CPLGetLastErrorMsg();
  }
};

/// The picture as three bands of 8 bits, and alpha if there is any; a view of the file.
Dataset AsColors(GDALDatasetH file)
{
  const int bands = GDALGetRasterCount(file);
  GDALRasterBandH first = GDALGetRasterBand(file, 1);
  const bool hasAlpha =
    GDALGetRasterColorInterpretation(GDALGetRasterBand(file, bands)) == GCI_AlphaBand;
  std::vector<std::string> arguments{ "-of", "VRT" };
  if (bands == 1 && GDALGetRasterColorTable(first))
  {
    arguments.insert(arguments.end(), { "-expand", "rgba" });
  }
  else
  {
    const int colors = hasAlpha ? bands - 1 : bands;
    for (int i = 1; i <= 3; ++i)
    {
      arguments.insert(arguments.end(), { "-b", std::to_string(colors >= 3 ? i : 1) });
    }
    if (hasAlpha)
    {
      arguments.insert(arguments.end(), { "-b", std::to_string(bands) });
    }
    if (GDALGetRasterDataType(first) != GDT_Byte)
    {
      arguments.insert(arguments.end(), { "-ot", "Byte", "-scale_1", "-scale_2", "-scale_3" });
    }
  }
  char** list = nullptr;
  for (const std::string& argument : arguments)
  {
    list = CSLAddString(list, argument.c_str());
  }
  GDALTranslateOptions* options = GDALTranslateOptionsNew(list, nullptr);
  CSLDestroy(list);
  int failed = 0;
  Dataset colors = Own(GDALTranslate("", file, options, &failed));
  GDALTranslateOptionsFree(options);
  return colors;
}
}

/// A picture on its way into a scene.
class ImageWarp
{
public:
  Dataset File{ Own(nullptr) };
  Dataset Colors{ Own(nullptr) };
  std::array<double, 6> ToFile{};
  std::array<double, 6> FromFile{};
  vtkNew<vtkTerrainGeoreference> Picture;
  vtkTerrainGeoreference* Scene = nullptr;
  vtkSmartPointer<vtkImageData> Heights;
  double MiddleHeight = 0.0;
  double Spacing = 0.0;
  /// South-west corner of the first pixel, in the scene.
  double Corner[2] = { 0.0, 0.0 };
  int Size[2] = { 0, 0 };

  std::string Open(const std::string& name, const std::string& system);
  std::string Place(int maximumSize);
  bool PixelsToScene(std::vector<double>& points);
  bool SceneToPixels(std::vector<double>& points);
  std::array<double, 4> FindOverlap();
  GDALWarpOptions* MakeOptions(GDALDatasetH target);
  std::string Warp(unsigned char* rgba);
  static int Transform(
    void* self, int dstToSrc, int count, double* x, double* y, double* z, int* success);
};

/// Opens the file, and finds its CRS and its affine transform. Returns one sentence on failure.
std::string ImageWarp::Open(const std::string& name, const std::string& system)
{
  if (!WhyNoGDAL().empty())
  {
    return WhyNoGDAL();
  }
  const std::string whyNot = WhyNotInput(name);
  if (!whyNot.empty())
  {
    return "'" + name + "': " + whyNot;
  }
  GDALAllRegister();
  const Messages messages;
  this->Colors = Own(nullptr);
  this->File =
    Own(GDALOpenEx(name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
  if (!this->File || GDALGetRasterCount(this->File.get()) < 1)
  {
    const std::string reason = Messages::Last();
    return "'" + name + "' is no picture that can be read" +
      (reason.empty() ? "" : " (" + reason + ")");
  }
  const char* own = GDALGetProjectionRef(this->File.get());
  const std::string definition = own && *own ? own : system;
  if (definition.empty())
  {
    return "'" + name + "' has no coordinate system";
  }
  if (GDALGetGeoTransform(this->File.get(), this->ToFile.data()) != CE_None ||
    !GDALInvGeoTransform(this->ToFile.data(), this->FromFile.data()))
  {
    return "'" + name + "' has no georeference";
  }
  const double width = GDALGetRasterXSize(this->File.get());
  const double height = GDALGetRasterYSize(this->File.get());
  double extent[4] = { HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL };
  for (int i = 0; i < 4; ++i)
  {
    double x = 0.0;
    double y = 0.0;
    GDALApplyGeoTransform(
      this->ToFile.data(), i % 2 == 0 ? 0.0 : width, i < 2 ? 0.0 : height, &x, &y);
    extent[0] = std::min(extent[0], x);
    extent[1] = std::max(extent[1], x);
    extent[2] = std::min(extent[2], y);
    extent[3] = std::max(extent[3], y);
  }
  this->Picture->SetCoordinateSystem(definition);
  this->Picture->SetExtent(extent[0], extent[1], extent[2], extent[3]);
  this->Picture->SetFrame(Frame::Geocentric);
  const std::string why = this->Picture->GetWhyNot();
  if (!why.empty())
  {
    return "'" + name + "': " + why;
  }
  this->Colors = AsColors(this->File.get());
  return this->Colors ? "" : "'" + name + "' cannot be read as colours (" + Messages::Last() + ")";
}

/// Pixels of the picture (x, y, height of the scene) to the scene, in place.
bool ImageWarp::PixelsToScene(std::vector<double>& points)
{
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    GDALApplyGeoTransform(
      this->ToFile.data(), points[i], points[i + 1], &points[i], &points[i + 1]);
  }
  const auto count = static_cast<vtkIdType>(points.size() / 3);
  return this->Picture->FileToPlaces(points.data(), points.data(), count) &&
    this->Scene->PlacesToScene(points.data(), points.data(), count);
}

bool ImageWarp::SceneToPixels(std::vector<double>& points)
{
  const auto count = static_cast<vtkIdType>(points.size() / 3);
  if (!this->Scene->SceneToPlaces(points.data(), points.data(), count) ||
    !this->Picture->PlacesToFile(points.data(), points.data(), count))
  {
    return false;
  }
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    GDALApplyGeoTransform(
      this->FromFile.data(), points[i], points[i + 1], &points[i], &points[i + 1]);
  }
  return true;
}

/// The overlap with the heights: west, east, south, north. Without one, west >= east or
/// south >= north.
std::array<double, 4> ImageWarp::FindOverlap()
{
  // In a round scene what lies high, or is exaggerated, stands elsewhere than its foot.
  constexpr double lowest = -11000.0;
  constexpr double highest = 9000.0;
  const double width = GDALGetRasterXSize(this->File.get());
  const double height = GDALGetRasterYSize(this->File.get());
  std::vector<double> points;
  for (int j = 0; j < kOutlinePoints; ++j)
  {
    for (int i = 0; i < kOutlinePoints; ++i)
    {
      const double x = width * i / (kOutlinePoints - 1);
      const double y = height * j / (kOutlinePoints - 1);
      points.insert(points.end(), { x, y, lowest, x, y, highest });
    }
  }
  this->PixelsToScene(points);
  double bounds[6];
  this->Heights->GetBounds(bounds);
  double own[4] = { HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL };
  for (std::size_t i = 0; i < points.size(); i += 3)
  {
    if (std::isfinite(points[i]))
    {
      own[0] = std::min(own[0], points[i]);
      own[1] = std::max(own[1], points[i]);
      own[2] = std::min(own[2], points[i + 1]);
      own[3] = std::max(own[3], points[i + 1]);
    }
  }
  return { std::max(bounds[0], own[0]), std::min(bounds[1], own[1]), std::max(bounds[2], own[2]),
    std::min(bounds[3], own[3]) };
}

/// Finds the overlap with the heights and the grid of the output. Returns one sentence on failure.
std::string ImageWarp::Place(int maximumSize)
{
  const std::array<double, 4> bounds = this->FindOverlap();
  if (!(bounds[0] < bounds[1] && bounds[2] < bounds[3]))
  {
    return "the picture does not meet the terrain";
  }
  double range[2];
  this->Heights->GetPointData()->GetScalars()->GetFiniteRange(range);
  this->MiddleHeight = 0.5 * (range[0] + range[1]);
  // A pixel in the middle of the overlap; its size in the scene from the inverse.
  const double x = 0.5 * (bounds[0] + bounds[1]);
  const double y = 0.5 * (bounds[2] + bounds[3]);
  const double step = 0.001 * std::min(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  std::vector<double> cross{ x, y, 0.0, x + step, y, 0.0, x, y + step, 0.0 };
  this->SceneToPixels(cross);
  const double area = std::abs(
    (cross[3] - cross[0]) * (cross[7] - cross[1]) - (cross[4] - cross[1]) * (cross[6] - cross[0]));
  if (!(area > 0.0) || !std::isfinite(area))
  {
    return "the picture has no image in the middle of the terrain";
  }
  this->Spacing = std::max(
    step / std::sqrt(area), std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]) / maximumSize);
  const double lengths[2] = { bounds[1] - bounds[0], bounds[3] - bounds[2] };
  this->Corner[0] = bounds[0];
  this->Corner[1] = bounds[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    this->Size[axis] =
      std::clamp(static_cast<int>(std::ceil(lengths[axis] / this->Spacing - 1e-6)), 1, maximumSize);
  }
  return {};
}

/// GDAL's transformer: pixels of the output to and from pixels of the picture.
int ImageWarp::Transform(
  void* self, int dstToSrc, int count, double* x, double* y, double*, int* success)
{
  auto& internals = *static_cast<ImageWarp*>(self);
  std::vector<double> points(3 * static_cast<std::size_t>(count), 0.0);
  for (int i = 0; i < count; ++i)
  {
    double* point = points.data() + 3 * static_cast<std::ptrdiff_t>(i);
    point[0] = dstToSrc ? internals.Corner[0] + x[i] * internals.Spacing : x[i];
    point[1] = dstToSrc ? internals.Corner[1] + y[i] * internals.Spacing : y[i];
  }
  if (dstToSrc)
  {
    if (internals.Scene->GetFrame() == Frame::Local)
    {
      // Beyond the surface, the last height before its border: pixels there only blend into it.
      const GridGeometry geometry = ImageHeights::Geometry(internals.Heights);
      double last = internals.MiddleHeight;
      ImageHeights::Dispatch(internals.Heights,
        [&](const auto& heights)
        {
          for (std::size_t i = 0; i < points.size(); i += 3)
          {
            const glm::dvec3 grid = geometry.ToGrid({ points[i], points[i + 1], 0.0 });
            const double z = SampleBilinear(heights, grid.x, grid.y);
            last = std::isnan(z) ? last : z + geometry.Origin.z;
            points[i + 2] = last;
          }
        });
    }
    internals.SceneToPixels(points);
  }
  else
  {
    internals.PixelsToScene(points);
  }
  bool all = true;
  for (int i = 0; i < count; ++i)
  {
    const double* point = points.data() + 3 * static_cast<std::ptrdiff_t>(i);
    success[i] = std::isfinite(point[0]) && std::isfinite(point[1]) ? 1 : 0;
    all = all && success[i];
    x[i] = success[i] ? (dstToSrc ? point[0] : (point[0] - internals.Corner[0]) / internals.Spacing)
                      : HUGE_VAL;
    y[i] = success[i] ? (dstToSrc ? point[1] : (point[1] - internals.Corner[1]) / internals.Spacing)
                      : HUGE_VAL;
  }
  return all ? 1 : 0;
}

/// What is warped into RGBA, without a transformer; to be destroyed by GDALDestroyWarpOptions().
GDALWarpOptions* ImageWarp::MakeOptions(GDALDatasetH target)
{
  const bool hasAlpha = GDALGetRasterCount(this->Colors.get()) == 4;
  GDALWarpOptions* options = GDALCreateWarpOptions();
  options->hSrcDS = this->Colors.get();
  options->hDstDS = target;
  options->eResampleAlg = GRA_Bilinear;
  options->nBandCount = 3;
  options->panSrcBands = static_cast<int*>(CPLMalloc(3 * sizeof(int)));
  options->panDstBands = static_cast<int*>(CPLMalloc(3 * sizeof(int)));
  for (int i = 0; i < 3; ++i)
  {
    options->panSrcBands[i] = options->panDstBands[i] = i + 1;
  }
  options->nSrcAlphaBand = hasAlpha ? 4 : 0;
  options->nDstAlphaBand = 4;
  int hasNoData = 0;
  const double noData =
    GDALGetRasterNoDataValue(GDALGetRasterBand(this->Colors.get(), 1), &hasNoData);
  if (hasNoData)
  {
    options->padfSrcNoDataReal = static_cast<double*>(CPLMalloc(3 * sizeof(double)));
    std::fill_n(options->padfSrcNoDataReal, 3, noData);
    options->papszWarpOptions =
      CSLSetNameValue(options->papszWarpOptions, "UNIFIED_SRC_NODATA", "YES");
  }
  options->papszWarpOptions = CSLSetNameValue(options->papszWarpOptions, "INIT_DEST", "0");
  return options;
}

/// Warps the picture into Size[0] x Size[1] pixels of RGBA, southern row first.
std::string ImageWarp::Warp(unsigned char* rgba)
{
  const Messages messages;
  const Dataset target = Own(
    GDALCreate(GDALGetDriverByName("MEM"), "", this->Size[0], this->Size[1], 4, GDT_Byte, nullptr));
  if (!target)
  {
    return "the picture needs more memory than there is (" + Messages::Last() + ")";
  }
  GDALWarpOptions* options = this->MakeOptions(target.get());
  void* approximate = nullptr;
  options->pfnTransformer = ImageWarp::Transform;
  options->pTransformerArg = this;
  if (this->Scene->GetFrame() != Frame::Local)
  {
    approximate = GDALCreateApproxTransformer(ImageWarp::Transform, this, kApproximation);
    options->pfnTransformer = GDALApproxTransform;
    options->pTransformerArg = approximate;
  }
  GDALWarpOperationH operation = GDALCreateWarpOperation(options);
  CPLErr result = CE_Failure;
  if (operation)
  {
    result = GDALChunkAndWarpImage(operation, 0, 0, this->Size[0], this->Size[1]);
    GDALDestroyWarpOperation(operation);
  }
  GDALDestroyWarpOptions(options);
  if (approximate)
  {
    GDALDestroyApproxTransformer(approximate);
  }
  if (result == CE_None)
  {
    result = GDALDatasetRasterIOEx(target.get(), GF_Read, 0, 0, this->Size[0], this->Size[1], rgba,
      this->Size[0], this->Size[1], GDT_Byte, 4, nullptr, 4,
      4 * static_cast<GSpacing>(this->Size[0]), 1, nullptr);
  }
  return result == CE_None ? "" : "the picture cannot be warped (" + Messages::Last() + ")";
}

}

class vtkTerrainImageWarp::vtkInternals : public terrain::ImageWarp
{
};

vtkStandardNewMacro(vtkTerrainImageWarp);

vtkTerrainImageWarp::vtkTerrainImageWarp()
  : Internals(std::make_unique<vtkInternals>())
{
}

vtkTerrainImageWarp::~vtkTerrainImageWarp() = default;

void vtkTerrainImageWarp::SetFileName(const std::string& fileName)
{
  terrain::Setting::Set(this, this->FileName, fileName);
}

void vtkTerrainImageWarp::SetGeoreference(vtkTerrainGeoreference* georeference)
{
  terrain::Setting::Set(this, this->Georeference, georeference);
}

vtkTerrainGeoreference* vtkTerrainImageWarp::GetGeoreference() const
{
  return this->Georeference;
}

void vtkTerrainImageWarp::SetCoordinateSystem(const std::string& definition)
{
  terrain::Setting::Set(this, this->CoordinateSystem, definition);
}

vtkMTimeType vtkTerrainImageWarp::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Georeference ? std::max(time, this->Georeference->GetMTime()) : time;
}

int vtkTerrainImageWarp::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkTerrainImageWarp::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  // The size of the output depends on the heights and on a scene that they may define.
  if (vtkAlgorithmOutput* connection = this->GetInputConnection(0, 0))
  {
    connection->GetProducer()->Update(connection->GetIndex());
  }
  vtkInternals& internals = *this->Internals;
  internals.Heights = vtkImageData::GetData(inputs[0]);
  internals.Scene = this->Georeference;
  this->ErrorMessage = terrain::ImageHeights::WhyNotHeights(internals.Heights);
  if (this->ErrorMessage.empty())
  {
    this->ErrorMessage = !this->Georeference ? "there is no georeference of the heights"
                                             : this->Georeference->GetWhyNot();
  }
  if (this->ErrorMessage.empty() && !this->Georeference->IsOnEarth())
  {
    this->ErrorMessage = "a picture cannot be placed: the heights have no coordinate system";
  }
  if (this->ErrorMessage.empty())
  {
    this->ErrorMessage = internals.Open(this->FileName, this->CoordinateSystem);
  }
  if (this->ErrorMessage.empty())
  {
    const std::string why = internals.Place(this->MaximumSize);
    this->ErrorMessage = why.empty() ? "" : "'" + this->FileName + "': " + why;
  }
  vtkInformation* info = outputs->GetInformationObject(0);
  if (!this->ErrorMessage.empty())
  {
    const int empty[6] = { 0, -1, 0, -1, 0, -1 };
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), empty, 6);
    vtkErrorMacro(<< this->ErrorMessage);
    return 0;
  }
  const double s = internals.Spacing;
  const int extent[6] = { 0, internals.Size[0] - 1, 0, internals.Size[1] - 1, 0, 0 };
  const double origin[3] = { internals.Corner[0] + 0.5 * s, internals.Corner[1] + 0.5 * s, 0.0 };
  const double spacing[3] = { s, s, 1.0 };
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_UNSIGNED_CHAR, 4);
  return 1;
}

int vtkTerrainImageWarp::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  vtkInformation* info = inputs[0]->GetInformationObject(0);
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
  return 1;
}

int vtkTerrainImageWarp::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(outputs);
  if (!this->ErrorMessage.empty())
  {
    output->Initialize();
    return 0;
  }
  // The whole picture, whatever part was asked for.
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  output->SetExtent(extent);
  output->SetOrigin(info->Get(vtkDataObject::ORIGIN()));
  output->SetSpacing(info->Get(vtkDataObject::SPACING()));
  output->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  output->GetPointData()->GetScalars()->SetName("Colors");
  this->ErrorMessage =
    this->Internals->Warp(static_cast<unsigned char*>(output->GetScalarPointer()));
  if (!this->ErrorMessage.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< "'" << this->FileName << "': " << this->ErrorMessage);
    return 0;
  }
  return 1;
}

void vtkTerrainImageWarp::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "CoordinateSystem: " << this->CoordinateSystem << "\n";
  os << indent << "MaximumSize: " << this->MaximumSize << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
  os << indent << "Georeference: " << this->Georeference.Get() << "\n";
}
