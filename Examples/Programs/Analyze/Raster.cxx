// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Raster.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>
#include <vtkTerrainGeoreference.h>
#include <vtkTerrainRasterReader.h>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>

#include <unistd.h>

namespace
{
constexpr int kBlock = 512; ///< samples along a side of the blocks that are written

/// Bytes that processes may still take; infinity where the system does not say.
double AvailableMemory()
{
  std::ifstream lines("/proc/meminfo");
  for (std::string line; std::getline(lines, line);)
  {
    double kilobytes = 0.0;
    if (std::sscanf(line.c_str(), "MemAvailable: %lf", &kilobytes) == 1)
    {
      return 1024.0 * kilobytes;
    }
  }
  return std::numeric_limits<double>::infinity();
}

void AddInputs(vtkTerrainOutputFile* file, const RasterOptions& options)
{
  file->AddInput(options.Heights);
  file->AddInput(options.Input.CoordinateSystem);
  for (const std::string& input : options.Inputs)
  {
    file->AddInput(input);
  }
}

std::string GetText(vtkImageData* image, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(image->GetFieldData()->GetAbstractArray(name));
  return array && array->GetNumberOfValues() > 0 ? std::string(array->GetValue(0)) : std::string();
}
}

//------------------------------------------------------------------------------
std::vector<double> GetNumbers(vtkImageData* image, const char* name)
{
  std::vector<double> numbers;
  vtkDataArray* array = image->GetFieldData()->GetArray(name);
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    numbers.push_back(array->GetVariantValue(i).ToDouble());
  }
  return numbers;
}

//------------------------------------------------------------------------------
ProgressBar::ProgressBar(bool quiet)
  : Shown(!quiet && isatty(STDERR_FILENO) != 0)
{
}

ProgressBar::~ProgressBar()
{
  if (this->Percent >= 0)
  {
    std::fprintf(stderr, "\r\033[K");
  }
}

void ProgressBar::Show(double part)
{
  const int percent = static_cast<int>(100.0 * part);
  if (this->Shown && percent != this->Percent)
  {
    this->Percent = percent;
    const std::string bar(static_cast<std::size_t>(percent) * 40 / 100, '#');
    std::fprintf(stderr, "\r[%-40s] %3d %%", bar.c_str(), percent);
  }
}

void ProgressBar::Watch(vtkAlgorithm* filter, double until)
{
  struct Watched
  {
    ProgressBar* Bar;
    double Until;
  };
  vtkNew<vtkCallbackCommand> progress;
  progress->SetClientData(new Watched{ this, until });
  progress->SetClientDataDeleteCallback([](void* data) { delete static_cast<Watched*>(data); });
  progress->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      const auto* watched = static_cast<Watched*>(data);
      watched->Bar->Show(watched->Until * static_cast<vtkAlgorithm*>(caller)->GetProgress());
    });
  filter->AddObserver(vtkCommand::ProgressEvent, progress);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ReadHeights(const RasterOptions& options, double bytes)
{
  vtkNew<vtkTerrainRasterReader> reader;
  reader->SetFileName(options.Heights);
  options.Input.Apply(reader);
  reader->UpdateInformation();
  const std::string whyNot = HeightOptions::WhyNotOneSite(reader);
  if (!whyNot.empty())
  {
    throw Failure(whyNot);
  }
  int extent[6] = { 0, -1, 0, -1, 0, 0 };
  reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  const double samples = (extent[1] + 1.0) * (extent[3] + 1.0);
  if (std::string(reader->GetErrorMessage()).empty() && samples * bytes > AvailableMemory())
  {
    std::ostringstream sentence;
    sentence.precision(3);
    sentence << options.Heights << ": " << extent[1] + 1 << " x " << extent[3] + 1
             << " samples need " << samples * bytes / 1e9 << " GB of memory here, and "
             << AvailableMemory() / 1e9 << " GB are left; make a raster of a part (gdal_translate "
             << "-srcwin), or a coarser one (gdal_translate -outsize 50% 50% -r average)";
    throw Failure(sentence.str());
  }
  reader->Update();
  const std::string error = reader->GetErrorMessage();
  if (!error.empty())
  {
    throw Failure(error);
  }
  std::istringstream warnings(options.Quiet ? std::string() : reader->GetWarningMessage());
  for (std::string warning; std::getline(warnings, warning);)
  {
    std::cerr << "terrain-analyze: warning: " << warning << "\n";
  }
  return reader->GetOutput();
}

//------------------------------------------------------------------------------
void CheckOutput(const RasterOptions& options)
{
  vtkNew<vtkTerrainOutputFile> file;
  AddInputs(file, options);
  const std::string input = file->FindInput(options.Output);
  if (!input.empty())
  {
    throw Failure(options.Output, "the input '" + input + "' is read from it");
  }
}

//------------------------------------------------------------------------------
void OpenOutput(vtkTerrainOutputFile* file, const RasterOptions& options)
{
  AddInputs(file, options);
  if (!file->Open(options.Output))
  {
    throw Failure(file->GetErrorMessage());
  }
}

//------------------------------------------------------------------------------
std::vector<double> EastSpacings(vtkImageData* heights)
{
  const auto rows = static_cast<std::size_t>(heights->GetDimensions()[1]);
  std::vector<double> spacings(rows, heights->GetSpacing()[0]);
  vtkNew<vtkTerrainGeoreference> georeference;
  georeference->SetFromHeights(heights);
  const std::vector<double> scale = GetNumbers(heights, "LayoutScale");
  const std::vector<double> origin = GetNumbers(heights, "LayoutOrigin");
  if (!georeference->IsGeographic() || scale.size() < 2 || origin.size() < 2)
  {
    return spacings;
  }
  const auto radius = [](double latitude)
  {
    constexpr double eccentricity2 = 0.00669438; // of WGS84
    const double phi = std::clamp(latitude, -89.9, 89.9) * 3.14159265358979 / 180.0;
    return std::cos(phi) / std::sqrt(1.0 - eccentricity2 * std::sin(phi) * std::sin(phi));
  };
  for (std::size_t row = 0; row < rows; ++row)
  {
    const double y = heights->GetOrigin()[1] + static_cast<double>(row) * heights->GetSpacing()[1];
    spacings[row] *= radius(origin[1] + y / scale[1]) / radius(origin[1]);
  }
  return spacings;
}

//------------------------------------------------------------------------------
ResultWriter::ResultWriter(const RasterOptions& options, vtkImageData* heights, int bands)
  : Options(options)
  , Width(heights->GetDimensions()[0])
  , Height(heights->GetDimensions()[1])
{
  OpenOutput(this->File, options);
  GDALAllRegister();
  CPLPushErrorHandler(CPLQuietErrorHandler);
  this->Dataset = GDALCreate(
    GDALGetDriverByName("MEM"), "", this->Width, this->Height, bands, GDT_Float32, nullptr);
  this->Check(this->Dataset != nullptr, "there is not enough memory");
  std::vector<double> transform = GetNumbers(heights, "GeoTransform");
  if (transform.size() == 6)
  {
    this->NorthFirst = transform[5] < 0.0;
    this->EastFirst = transform[1] < 0.0;
    GDALSetGeoTransform(this->Dataset, transform.data());
  }
  const std::string crs = GetText(heights, "CRS");
  if (!crs.empty())
  {
    OGRSpatialReferenceH srs = OSRNewSpatialReference(nullptr);
    if (OSRSetFromUserInput(srs, crs.c_str()) == OGRERR_NONE)
    {
      OSRSetAxisMappingStrategy(srs, OAMS_TRADITIONAL_GIS_ORDER);
      GDALSetSpatialRef(this->Dataset, srs);
    }
    OSRDestroySpatialReference(srs);
  }
}

ResultWriter::~ResultWriter()
{
  if (this->Dataset)
  {
    GDALClose(this->Dataset);
  }
  CPLPopErrorHandler();
}

void ResultWriter::Check(bool done, const std::string& what) const
{
  if (!done)
  {
    const std::string reason = CPLGetLastErrorMsg();
    std::string line = this->Options.Output + ": " + (reason.empty() ? what : reason);
    std::replace(line.begin(), line.end(), '\n', ' ');
    throw Failure(line);
  }
}

void ResultWriter::SetBand(int band, const std::string& description, const float* values)
{
  GDALRasterBandH to = GDALGetRasterBand(this->Dataset, band);
  GDALSetDescription(to, description.c_str());
  std::vector<float> line(static_cast<std::size_t>(this->Width));
  for (int row = 0; row < this->Height; ++row)
  {
    const int from = this->NorthFirst ? this->Height - 1 - row : row;
    const float* begin = values + static_cast<std::ptrdiff_t>(from) * this->Width;
    std::copy(begin, begin + this->Width, line.begin());
    if (this->EastFirst)
    {
      std::reverse(line.begin(), line.end());
    }
    this->HasHoles = this->HasHoles ||
      std::any_of(line.begin(), line.end(), [](float value) { return std::isnan(value); });
    this->Check(GDALRasterIO(to, GF_Write, 0, row, this->Width, 1, line.data(), this->Width, 1,
                  GDT_Float32, 0, 0) == CE_None,
      "there is not enough memory");
  }
}

void ResultWriter::DeclareNoData()
{
  for (int band = 1; band <= GDALGetRasterCount(this->Dataset); ++band)
  {
    GDALSetRasterNoDataValue(
      GDALGetRasterBand(this->Dataset, band), std::numeric_limits<double>::quiet_NaN());
  }
}

void ResultWriter::BuildOverviews()
{
  std::vector<int> factors;
  for (int factor = 2; std::max(this->Width, this->Height) > kBlock * factor / 2; factor *= 2)
  {
    factors.push_back(factor);
  }
  this->Check(factors.empty() ||
      GDALBuildOverviews(this->Dataset, "AVERAGE", static_cast<int>(factors.size()), factors.data(),
        0, nullptr, nullptr, nullptr) == CE_None,
    "there is not enough memory");
}

void ResultWriter::Write()
{
  // GDAL averages four times as fast where no value is declared to be none.
  if (this->HasHoles)
  {
    this->DeclareNoData();
  }
  this->BuildOverviews();
  this->DeclareNoData();
  const std::string partial = this->File->GetPartialFileName();
  GDALDriverH driver = GDALGetDriverByName("COG");
  this->Check(driver != nullptr, "this GDAL writes no cloud-optimized GeoTIFF");
  char** creation = nullptr;
  creation = CSLSetNameValue(creation, "COMPRESS", this->Options.Compression.c_str());
  creation = CSLSetNameValue(creation, "BIGTIFF", "IF_SAFER");
  creation = CSLSetNameValue(creation, "BLOCKSIZE", std::to_string(kBlock).c_str());
  if (this->Options.Compression != "NONE")
  {
    creation = CSLSetNameValue(creation, "PREDICTOR", "YES");
  }
  CPLErrorReset();
  GDALDatasetH written =
    GDALCreateCopy(driver, partial.c_str(), this->Dataset, FALSE, creation, nullptr, nullptr);
  CSLDestroy(creation);
  const std::string failure = CPLGetLastErrorType() >= CE_Failure ? CPLGetLastErrorMsg() : "";
  if (written)
  {
    GDALClose(written);
  }
  CPLErrorReset();
  this->Check(
    written != nullptr && failure.empty(), failure.empty() ? "it cannot be written" : failure);
  if (!this->File->Commit())
  {
    throw Failure(this->File->GetErrorMessage());
  }
}
