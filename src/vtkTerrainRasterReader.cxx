// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainRasterReader.h"
#include "vtkTerrainRasterReaderInternals.h"

#include "data/Setting.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <initializer_list>
#include <new>
#include <numeric>
#include <sstream>
#include <vector>

#include <unistd.h>

namespace
{
/// The scalars' name where the file has none.
constexpr const char* DefaultName = "Elevation";

/// The window that four numbers mean, or an error.
terrain::RasterWindow ResolveWindow(const terrain::RasterFile& file, const int window[4])
{
  terrain::RasterWindow resolved{ window[0], window[1], window[2], window[3] };
  resolved.Width = window[2] == 0 ? file.GetWidth() - resolved.X : resolved.Width;
  resolved.Height = window[3] == 0 ? file.GetHeight() - resolved.Y : resolved.Height;
  if (resolved.X < 0 || resolved.Y < 0 || resolved.Width < 1 || resolved.Height < 1 ||
    resolved.X + resolved.Width > file.GetWidth() ||
    resolved.Y + resolved.Height > file.GetHeight())
  {
    std::ostringstream text;
    text << "the window of " << resolved.Width << " x " << resolved.Height << " pixels at ("
         << resolved.X << ", " << resolved.Y << ") is not within its " << file.GetWidth() << " x "
         << file.GetHeight() << " pixels";
    throw terrain::RasterError(text.str());
  }
  return resolved;
}

/// Samples of the window under the two limits; as many as there are pixels if none applies.
void ReduceSize(terrain::RasterRequest& request, int maximumSize, vtkIdType maximumNumber)
{
  const auto width = static_cast<double>(request.Window.Width);
  const auto height = static_cast<double>(request.Window.Height);
  double reduction = 1.0;
  if (maximumSize > 0)
  {
    reduction = std::max(reduction, std::max(width, height) / maximumSize);
  }
  if (maximumNumber > 0)
  {
    reduction = std::max(reduction, std::sqrt(width * height / static_cast<double>(maximumNumber)));
    // A single row or column: the other side alone can shrink.
    const double shorter = std::min(width, height);
    if (reduction > shorter)
    {
      reduction = std::max(width, height) / static_cast<double>(maximumNumber);
    }
  }
  const auto shrink = [reduction](double size)
  { return std::max<std::int64_t>(static_cast<std::int64_t>(size / reduction + 1e-9), 1); };
  request.Width = shrink(width);
  request.Height = shrink(height);
}

int ScalarTypeOf(const terrain::RasterFile& file)
{
  if (file.IsSignedByte())
  {
    return VTK_SIGNED_CHAR;
  }
  switch (file.GetType())
  {
    case GDT_Byte:
      return VTK_UNSIGNED_CHAR;
    case GDT_UInt16:
      return VTK_UNSIGNED_SHORT;
    case GDT_Int16:
      return VTK_SHORT;
    case GDT_UInt32:
      return VTK_UNSIGNED_INT;
    case GDT_Int32:
      return VTK_INT;
    case GDT_Float32:
      return VTK_FLOAT;
    default:
      return VTK_DOUBLE;
  }
}

/// Scale and offset from file values to metres, and the scalars' type under them.
void ResolveHeights(vtkTerrainRasterPlan& plan)
{
  terrain::RasterRequest& request = plan.Request;
  plan.File.GetScaleAndOffset(request.Scale, request.Offset);
  plan.VerticalUnit = plan.File.GetVerticalUnit();
  plan.VerticalScale = plan.File.GetMetresPerVerticalUnit();
  request.Scale *= plan.VerticalScale;
  request.Offset *= plan.VerticalScale;
  plan.ScalarType = ScalarTypeOf(plan.File);
  const bool scaled = request.Scale != 1.0 || request.Offset != 0.0;
  if (scaled && plan.File.IsInteger())
  {
    const bool wide = plan.ScalarType == VTK_INT || plan.ScalarType == VTK_UNSIGNED_INT;
    plan.ScalarType = wide ? VTK_DOUBLE : VTK_FLOAT;
  }
  plan.Name = plan.File.GetBandDescription();
  plan.Name = plan.Name.empty() ? DefaultName : plan.Name;
}

/// Position of the south-western sample, and spacing.
void PlaceSamples(vtkTerrainRasterPlan& plan)
{
  const terrain::RasterRequest& request = plan.Request;
  const terrain::RasterWindow& window = request.Window;
  std::array<double, 6> transform = plan.Layout.GeoTransform;
  if (!plan.Layout.HasGeoTransform)
  {
    transform = { -0.5, 1.0, 0.0, static_cast<double>(plan.File.GetHeight()) - 0.5, 0.0, -1.0 };
  }
  const std::int64_t west = request.EastFirst ? window.X + window.Width : window.X;
  const std::int64_t south = request.NorthFirst ? window.Y + window.Height : window.Y;
  const double corner[2] = { transform[0] + transform[1] * static_cast<double>(west),
    transform[3] + transform[5] * static_cast<double>(south) };
  const double cell[2] = { std::fabs(transform[1]), std::fabs(transform[5]) };
  const double reduction[2] = { static_cast<double>(window.Width) /
      static_cast<double>(request.Width),
    static_cast<double>(window.Height) / static_cast<double>(request.Height) };
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    plan.Spacing[axis] = cell[axis] * plan.Layout.Scale[a] * reduction[axis];
    plan.Origin[axis] =
      (corner[axis] - plan.Layout.Origin[a]) * plan.Layout.Scale[a] + 0.5 * plan.Spacing[axis];
  }
}

/// Band of the time that is asked for: the last one that has begun, the first without a time.
int BandAtTime(vtkInformation* info, int numberOfBands)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const double time =
    info->Has(Pipeline::UPDATE_TIME_STEP()) ? info->Get(Pipeline::UPDATE_TIME_STEP()) : 1.0;
  return static_cast<int>(std::clamp(std::floor(time), 1.0, std::max(1.0, 1.0 * numberOfBands)));
}

/// Throws if the raster's size is not the one that the pipeline was told.
void CheckWholeExtent(vtkInformation* info, const vtkTerrainRasterPlan& plan)
{
  int whole[6];
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  if (whole[1] + 1 != plan.Request.Width || whole[3] + 1 != plan.Request.Height)
  {
    throw terrain::RasterError("it has " + std::to_string(plan.Request.Width) + " x " +
      std::to_string(plan.Request.Height) + " samples where the first of its series has " +
      std::to_string(whole[1] + 1) + " x " + std::to_string(whole[3] + 1));
  }
}

terrain::RasterFindings ReadSamples(const vtkTerrainRasterPlan& plan, void* samples)
{
  const auto read = [&plan, samples](auto type)
  {
    using Sample = decltype(type);
    return terrain::ReadRasterPiece(plan.File, plan.Request, static_cast<Sample*>(samples));
  };
  switch (plan.ScalarType)
  {
    case VTK_SIGNED_CHAR:
      return read(static_cast<signed char>(0));
    case VTK_UNSIGNED_CHAR:
      return read(static_cast<unsigned char>(0));
    case VTK_SHORT:
      return read(static_cast<short>(0));
    case VTK_UNSIGNED_SHORT:
      return read(static_cast<unsigned short>(0));
    case VTK_INT:
      return read(0);
    case VTK_UNSIGNED_INT:
      return read(0U);
    case VTK_FLOAT:
      return read(0.0F);
    default:
      return read(0.0);
  }
}

/// Throws std::bad_alloc for more than the machine's memory, which the system might still promise.
void CheckMemory(const int extent[6], int scalarType)
{
  const double bytes = (static_cast<double>(extent[1]) - extent[0] + 1.0) *
    (static_cast<double>(extent[3]) - extent[2] + 1.0) *
    static_cast<double>(vtkDataArray::GetDataTypeSize(scalarType));
  if (bytes >
    static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE)))
  {
    throw std::bad_alloc();
  }
}

void AddText(vtkFieldData* fields, const char* name, const std::string& text)
{
  if (!text.empty())
  {
    vtkNew<vtkStringArray> array;
    array->SetName(name);
    array->InsertNextValue(text);
    fields->AddArray(array);
  }
}

void AddNumbers(vtkFieldData* fields, const char* name, std::initializer_list<double> numbers)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(numbers.size()));
  array->InsertNextTuple(numbers.begin());
  fields->AddArray(array);
}

bool LooksLikeDegrees(const terrain::RasterLayout& layout, double width, double height)
{
  const std::array<double, 6>& t = layout.GeoTransform;
  const auto within = [](double a, double b, double limit)
  { return std::max(std::fabs(a), std::fabs(b)) <= limit; };
  return layout.HasGeoTransform && layout.CRS.empty() && std::fabs(t[1]) < 0.5 &&
    within(t[0], t[0] + width * t[1], 360.0) && within(t[3], t[3] + height * t[5], 90.01);
}
}

vtkStandardNewMacro(vtkTerrainRasterReader);

//------------------------------------------------------------------------------
vtkTerrainRasterReader::vtkTerrainRasterReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkTerrainRasterReader::~vtkTerrainRasterReader() = default;

//------------------------------------------------------------------------------
void vtkTerrainRasterReader::SetFileName(const char* fileName)
{
  this->SetFileName(std::string(fileName ? fileName : ""));
}

//------------------------------------------------------------------------------
void vtkTerrainRasterReader::SetFileName(const std::string& fileName)
{
  terrain::Setting::Set(this, this->FileName, fileName);
}

//------------------------------------------------------------------------------
const char* vtkTerrainRasterReader::GetFileName() const
{
  return this->FileName.c_str();
}

//------------------------------------------------------------------------------
void vtkTerrainRasterReader::SetCoordinateSystem(const std::string& definition)
{
  terrain::Setting::Set(this, this->CoordinateSystem, definition);
}

//------------------------------------------------------------------------------
const char* vtkTerrainRasterReader::GetErrorMessage() const
{
  return this->ErrorMessage.c_str();
}

//------------------------------------------------------------------------------
const char* vtkTerrainRasterReader::GetWarningMessage() const
{
  return this->WarningMessage.c_str();
}

//------------------------------------------------------------------------------
void vtkTerrainRasterReader::AddGDAL(const std::string& fileName)
{
  terrain::AddGDAL(fileName);
}

//------------------------------------------------------------------------------
std::string vtkTerrainRasterReader::GetGDALFile()
{
  return terrain::GetGDALFile();
}

//------------------------------------------------------------------------------
int vtkTerrainRasterReader::CanReadFile(const char* fileName)
{
  try
  {
    terrain::RasterFile file(fileName);
    file.SelectBand(0);
    return 2;
  }
  catch (const terrain::RasterError&)
  {
    return 0;
  }
}

//------------------------------------------------------------------------------
const char* vtkTerrainRasterReader::GetFileExtensions() const
{
  return ".tif .tiff .vrt .hgt .dem .asc .img .dt0 .dt1 .dt2 .bil .flt .adf .grd .nc .png .jp2 "
         ".xyz";
}

//------------------------------------------------------------------------------
const char* vtkTerrainRasterReader::GetDescriptiveName() const
{
  return "Elevation raster (GDAL)";
}

//------------------------------------------------------------------------------
int vtkTerrainRasterReader::Fail(const std::string& reason)
{
  this->ErrorMessage = "cannot read heights from '" + this->FileName + "': " + reason;
  this->SetErrorCode(vtkErrorCode::FileFormatError);
  // the pipeline leaves the output of the update before this one
  if (vtkDataObject* output = this->GetOutputDataObject(0))
  {
    output->Initialize();
  }
  vtkErrorMacro(<< this->ErrorMessage);
  return 0;
}

//------------------------------------------------------------------------------
void vtkTerrainRasterReader::Warn(const std::string& text)
{
  this->WarningMessage = "'" + this->FileName + "': " + text;
  vtkWarningMacro(<< this->WarningMessage);
}

//------------------------------------------------------------------------------
void vtkTerrainRasterReader::Plan(vtkTerrainRasterPlan& plan, int band) const
{
  plan.File.SelectBand(band);
  if (!this->CoordinateSystem.empty())
  {
    plan.File.SetCoordinateSystem(this->CoordinateSystem);
  }
  plan.Layout = plan.File.GetLayout();
  plan.Request.Window = ResolveWindow(plan.File, this->Window);
  plan.Request.NorthFirst = plan.Layout.NorthFirst;
  plan.Request.EastFirst = plan.Layout.EastFirst;
  ReduceSize(plan.Request, this->MaximumSize, this->MaximumNumberOfSamples);
  ResolveHeights(plan);
  plan.Name = this->BandsAsTimeSteps ? DefaultName : plan.Name; // bands are described as times
  this->ChooseLevel(plan);
  PlaceSamples(plan);
  this->PlaceLevel(plan);
}

//------------------------------------------------------------------------------
// Time k is band k.
void vtkTerrainRasterReader::DeclareTimeSteps(int numberOfBands, vtkInformation* info) const
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (!this->BandsAsTimeSteps)
  {
    info->Remove(Pipeline::TIME_STEPS());
    info->Remove(Pipeline::TIME_RANGE());
    return;
  }
  std::vector<double> steps(static_cast<std::size_t>(numberOfBands));
  std::iota(steps.begin(), steps.end(), 1.0);
  const double range[2] = { 1.0, static_cast<double>(numberOfBands) };
  info->Set(Pipeline::TIME_STEPS(), steps.data(), numberOfBands);
  info->Set(Pipeline::TIME_RANGE(), range, 2);
}

//------------------------------------------------------------------------------
int vtkTerrainRasterReader::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputs), vtkInformationVector* outputs)
{
  this->ErrorMessage.clear();
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    vtkTerrainRasterPlan plan(this->FileName.c_str());
    this->Plan(plan, this->BandsAsTimeSteps ? 1 : this->Band);
    this->Level = plan.Level;
    vtkInformation* info = outputs->GetInformationObject(0);
    this->DeclareTimeSteps(plan.File.GetNumberOfBands(), info);
    const int extent[6] = { 0, static_cast<int>(plan.Request.Width) - 1, 0,
      static_cast<int>(plan.Request.Height) - 1, 0, 0 };
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
    info->Set(vtkDataObject::ORIGIN(), plan.Origin[0], plan.Origin[1], 0.0);
    info->Set(vtkDataObject::SPACING(), plan.Spacing[0], plan.Spacing[1], 1.0);
    info->Set(CAN_PRODUCE_SUB_EXTENT(), 1);
    vtkDataObject::SetPointDataActiveScalarInfo(info, plan.ScalarType, 1);
    return 1;
  }
  catch (const std::exception& error)
  {
    return this->Fail(error.what());
  }
}

//------------------------------------------------------------------------------
int vtkTerrainRasterReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputs), vtkInformationVector* outputs)
{
  this->ErrorMessage.clear();
  this->WarningMessage.clear();
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(info);
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  try
  {
    vtkTerrainRasterPlan plan(this->FileName.c_str());
    int band = this->Band;
    if (this->BandsAsTimeSteps)
    {
      band = BandAtTime(info, plan.File.GetNumberOfBands());
      image->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), band);
    }
    this->Plan(plan, band);
    std::copy(extent, extent + 4, plan.Request.Extent);
    CheckWholeExtent(info, plan);
    CheckMemory(extent, plan.ScalarType);
    // What the pipeline knows of is the first band, and in a series the first file.
    image->SetExtent(extent);
    image->AllocateScalars(plan.ScalarType, 1);
    image->SetOrigin(plan.Origin[0], plan.Origin[1], 0.0);
    image->SetSpacing(plan.Spacing[0], plan.Spacing[1], 1.0);
    image->GetPointData()->GetScalars()->SetName(plan.Name.c_str());
    plan.Level > 0 ? this->ReadTiles(plan, image) : this->Read(plan, image);
    this->AddFieldData(plan, image);
  }
  catch (const std::bad_alloc&)
  {
    image->Initialize();
    return this->Fail("there is not enough memory for its samples; limit their number");
  }
  catch (const std::exception& error)
  {
    image->Initialize();
    return this->Fail(error.what());
  }
  if (this->GetAbortExecute())
  {
    image->Initialize();
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkTerrainRasterReader::Read(vtkTerrainRasterPlan& plan, vtkImageData* image)
{
  terrain::RasterRequest& request = plan.Request;
  if (request.Extent[1] < request.Extent[0] || request.Extent[3] < request.Extent[2])
  {
    return;
  }
  request.NoData = plan.File.GetDeclaredNoData();
  if (this->UseNoDataValue)
  {
    request.NoData.push_back(this->NoDataValue);
    request.UseOverviews = false;
  }
  else if (request.NoData.empty() && this->DetectNoData)
  {
    bool occur = false;
    request.UndeclaredNoData = plan.File.GetUndeclaredNoData(occur);
    request.UseOverviews = !occur;
  }
  double reported = 0.0;
  request.Progress = [this, &reported](double done)
  {
    if (done - reported >= 0.01 || done >= 1.0)
    {
      reported = done;
      this->UpdateProgress(done);
    }
    return !this->GetAbortExecute();
  };
  request.HiddenMark = vtkDataSetAttributes::HIDDENPOINT;
  request.Hidden = [image]()
  {
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfValues(image->GetNumberOfPoints());
    ghosts->FillValue(0);
    image->GetPointData()->AddArray(ghosts);
    return ghosts->GetPointer(0);
  };
  void* samples = image->GetPointData()->GetScalars()->GetVoidPointer(0);
  const terrain::RasterFindings findings = ReadSamples(plan, samples);
  if (findings.Undeclared > 0)
  {
    std::ostringstream text;
    text << findings.Undeclared << " samples of " << findings.UndeclaredValue
         << " are taken for no data, which the file does not declare";
    this->Warn(text.str());
  }
  else if (LooksLikeDegrees(plan.Layout, static_cast<double>(plan.File.GetWidth()),
             static_cast<double>(plan.File.GetHeight())))
  {
    this->Warn("it has no CRS and its coordinates look like degrees; they are taken for metres");
  }
}

//------------------------------------------------------------------------------
void vtkTerrainRasterReader::AddFieldData(
  const vtkTerrainRasterPlan& plan, vtkImageData* image) const
{
  vtkFieldData* fields = image->GetFieldData();
  const terrain::RasterWindow& window = plan.Request.Window;
  AddText(fields, "FileName", this->FileName);
  AddText(fields, "CRS", plan.Layout.CRS);
  AddText(fields, "VerticalUnit", plan.VerticalUnit);
  AddNumbers(fields, "VerticalScale", { plan.VerticalScale });
  AddNumbers(fields, "RasterSize",
    { static_cast<double>(plan.File.GetWidth()), static_cast<double>(plan.File.GetHeight()) });
  AddNumbers(fields, "RasterWindow",
    { static_cast<double>(window.X), static_cast<double>(window.Y),
      static_cast<double>(window.Width), static_cast<double>(window.Height) });
  if (plan.Layout.HasGeoTransform)
  {
    const std::array<double, 6>& t = plan.Layout.GeoTransform;
    AddNumbers(fields, "GeoTransform", { t[0], t[1], t[2], t[3], t[4], t[5] });
    AddNumbers(fields, "LayoutOrigin", { plan.Layout.Origin[0], plan.Layout.Origin[1] });
    AddNumbers(fields, "LayoutScale", { plan.Layout.Scale[0], plan.Layout.Scale[1] });
  }
}

//------------------------------------------------------------------------------
void vtkTerrainRasterReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n"
     << indent << "CoordinateSystem: " << this->CoordinateSystem << "\n"
     << indent << "Band: " << this->Band << "\n"
     << indent << "BandsAsTimeSteps: " << this->BandsAsTimeSteps << "\n"
     << indent << "Window: " << this->Window[0] << " " << this->Window[1] << " " << this->Window[2]
     << " " << this->Window[3] << "\n"
     << indent << "MaximumSize: " << this->MaximumSize << "\n"
     << indent << "MaximumNumberOfSamples: " << this->MaximumNumberOfSamples << "\n"
     << indent << "NoDataValue: " << this->NoDataValue << "\n"
     << indent << "UseNoDataValue: " << this->UseNoDataValue << "\n"
     << indent << "DetectNoData: " << this->DetectNoData << "\n"
     << indent << "UseLevels: " << this->UseLevels << "\n"
     << indent << "UseCache: " << this->UseCache << "\n"
     << indent << "MemoryBudget: " << this->MemoryBudget << "\n"
     << indent << "Level: " << this->Level << "\n"
     << indent << "ErrorMessage: " << this->ErrorMessage << "\n"
     << indent << "WarningMessage: " << this->WarningMessage << "\n";
}
