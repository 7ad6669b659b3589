// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainRasterReader.h"
#include "parts/RasterReaderInternals.h"

#include "core/strips/HierarchyFile.h"
#include "data/FieldData.h"
#include "data/HiddenSamples.h"
#include "data/Setting.h"
#include "raster/GDALTable.h"
#include "raster/MemoryLimit.h"
#include "raster/PreparedFile.h"
#include "raster/RasterSamples.h"
#include "raster/RasterTiles.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <new>
#include <numeric>
#include <sstream>
#include <vector>

namespace
{
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
    return terrain::ReadRasterPiece(*plan.File, plan.Request, static_cast<Sample*>(samples));
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
}

vtkStandardNewMacro(vtkTerrainRasterReader);

//------------------------------------------------------------------------------
vtkTerrainRasterReader::vtkTerrainRasterReader()
  : Internals(std::make_unique<vtkInternals>())
{
  this->SetNumberOfInputPorts(0);
  // An error is one sentence, the reader's own: the pipeline's "returned failure" says no more.
  const vtkNew<vtkCallbackCommand> silence;
  silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  this->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
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
void vtkTerrainRasterReader::SetPart(const std::string& part)
{
  terrain::Setting::Set(this, this->Part, part);
}

//------------------------------------------------------------------------------
void vtkTerrainRasterReader::SetHeightUnit(const std::string& unit)
{
  terrain::Setting::Set(this, this->HeightUnit, unit);
}

//------------------------------------------------------------------------------
void vtkTerrainRasterReader::SetSamples(vtkFieldData* samples)
{
  this->Internals->Samples = samples;
  this->Modified();
}

//------------------------------------------------------------------------------
vtkFieldData* vtkTerrainRasterReader::GetSamples() const
{
  return this->Internals->Samples;
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
  if (fileName && terrain::IsHierarchyFile(fileName))
  {
    return 3;
  }
  try
  {
    terrain::RasterFile file(fileName ? fileName : "", {}, terrain::OpenRasterTiles);
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
         ".xyz .hierarchy";
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
  // whoever asks again of what has not changed, as ParaView does, was told
  std::ostringstream told;
  vtkInternals::PrintSettings(*this, told, vtkIndent());
  told << this->ErrorMessage << vtkInternals::StampOf(this->FileName);
  if (this->Internals->ToldError != told.str())
  {
    this->Internals->ToldError = told.str();
    vtkErrorMacro(<< this->ErrorMessage);
  }
  return 0;
}

//------------------------------------------------------------------------------
// Each sentence is told once until the size is asked for again.
void vtkTerrainRasterReader::Warn(const std::string& text)
{
  const std::string line = "'" + this->FileName + "': " + text;
  if (("\n" + this->WarningMessage + "\n").find("\n" + line + "\n") != std::string::npos)
  {
    return;
  }
  this->WarningMessage += (this->WarningMessage.empty() ? "" : "\n") + line;
  vtkWarningMacro(<< line);
}

//------------------------------------------------------------------------------
void vtkTerrainRasterReader::WarnOf(const vtkTerrainRasterPlan& plan)
{
  for (const std::string& warning : plan.File->GetRecord().GetWarnings())
  {
    this->Warn(warning);
  }
  const terrain::RasterSites& sites = plan.File->GetRecord().GetSites();
  if (this->WarnOfSites && !sites.Warning.empty())
  {
    this->Warn(sites.Warning);
  }
}

//------------------------------------------------------------------------------
terrain::RasterOptions vtkTerrainRasterReader::GetOptions() const
{
  return { this->CoordinateSystem, this->HeightUnit, this->Flip, this->UseNoDataValue,
    this->NoDataValue, this->DetectNoData };
}

//------------------------------------------------------------------------------
std::shared_ptr<vtkTerrainRasterPlan> vtkTerrainRasterReader::Open() const
{
  auto plan = std::make_shared<vtkTerrainRasterPlan>();
  plan->File = this->Internals->Samples
    ? std::make_unique<terrain::RasterFile>(terrain::MemoryOf(this->Internals->Samples))
    : std::make_unique<terrain::RasterFile>(this->FileName, this->Part, terrain::OpenRasterTiles);
  return plan;
}

//------------------------------------------------------------------------------
// Samples of the window under the limits or at a level, and where they lie.
void vtkTerrainRasterReader::Complete(vtkTerrainRasterPlan& plan) const
{
  terrain::CompletePlan(plan, this->Window, this->MaximumSize, this->MaximumNumberOfSamples);
  if (this->BandsAsTimeSteps)
  {
    plan.Name = terrain::kDefaultName; // the bands' descriptions are of their times
  }
  plan.ScalarType = this->NoDataAsNaN ? terrain::FloatingTypeOf(plan.ScalarType) : plan.ScalarType;
  this->ChooseLevel(plan);
  terrain::PlaceSamples(plan);
  this->PlaceLevel(plan);
}

//------------------------------------------------------------------------------
// A file that an even raster in memory stands for is kept: it takes long to make.
std::shared_ptr<vtkTerrainRasterPlan> vtkTerrainRasterReader::Plan(int band)
{
  vtkInternals& kept = *this->Internals;
  const std::string stamp = vtkInternals::StampOf(this->FileName) + " " + std::to_string(band);
  if (kept.Plan && kept.Time == this->GetMTime() && kept.Stamp == stamp)
  {
    kept.Plan->Request = terrain::RasterRequest();
    this->Complete(*kept.Plan);
    return kept.Plan;
  }
  kept.Plan = nullptr;
  std::shared_ptr<vtkTerrainRasterPlan> plan = this->Open();
  plan->File->SelectBand(band);
  plan->File->TakeIn(this->GetOptions());
  this->Complete(*plan);
  if (plan->File->IsReplaced())
  {
    kept.Plan = plan;
    kept.Time = this->GetMTime();
    kept.Stamp = stamp;
  }
  return plan;
}

//------------------------------------------------------------------------------
std::string vtkTerrainRasterReader::Describe()
{
  try
  {
    return terrain::DescribePlan(*this->Plan(this->BandsAsTimeSteps ? 1 : this->Band));
  }
  catch (const std::exception& error)
  {
    return std::string("error: ") + error.what() + "\n";
  }
}

//------------------------------------------------------------------------------
bool vtkTerrainRasterReader::GetSamplesAreHeights()
{
  if (!this->Internals->Samples)
  {
    return false;
  }
  try
  {
    const std::shared_ptr<vtkTerrainRasterPlan> plan = this->Plan(this->Band);
    const terrain::RasterHoles& holes = plan->File->GetHoles();
    return !plan->File->IsReplaced() && !plan->File->IsTurned() && !plan->File->HasMask() &&
      !plan->File->HasCoordinatesOfAnotherUnit() && !this->Flip && plan->Request.Scale == 1.0 &&
      plan->Request.Offset == 0.0 && !holes.UndeclaredOccurs && holes.Declared.empty() &&
      !plan->Layout.IsGeographic && plan->Layout.Scale[0] == 1.0;
  }
  catch (const std::exception&)
  {
    return false;
  }
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
  this->WarningMessage.clear();
  this->Internals->ToldFill.clear();
  this->NumberOfSites = this->Site = 1;
  this->SetErrorCode(vtkErrorCode::NoError);
  if (terrain::IsHierarchyFile(this->FileName))
  {
    return this->RequestPrepared(outputs->GetInformationObject(0), nullptr);
  }
  try
  {
    const std::shared_ptr<vtkTerrainRasterPlan> planned =
      this->Plan(this->BandsAsTimeSteps ? 1 : this->Band);
    const vtkTerrainRasterPlan& plan = *planned;
    this->Level = plan.Level;
    this->NumberOfSites = plan.File->GetRecord().GetSites().Count;
    this->Site = plan.File->GetRecord().GetSites().Taken;
    vtkInformation* info = outputs->GetInformationObject(0);
    this->DeclareTimeSteps(plan.File->GetNumberOfBands(), info);
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
  this->Tiles.reset();
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(info);
  if (terrain::IsHierarchyFile(this->FileName))
  {
    return this->RequestPrepared(info, image);
  }
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  try
  {
    int band = this->Band;
    if (this->BandsAsTimeSteps)
    {
      using Pipeline = vtkStreamingDemandDrivenPipeline;
      band = BandAtTime(
        info, info->Has(Pipeline::TIME_STEPS()) ? info->Length(Pipeline::TIME_STEPS()) : 1);
      image->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), band);
    }
    const std::shared_ptr<vtkTerrainRasterPlan> planned = this->Plan(band);
    vtkTerrainRasterPlan& plan = *planned;
    this->WarnOf(plan);
    std::copy(extent, extent + 4, plan.Request.Extent);
    CheckWholeExtent(info, plan);
    terrain::CheckMemory(extent, plan.ScalarType);
    // What the pipeline knows of is the first band, and in a series the first file.
    image->SetExtent(extent);
    image->AllocateScalars(plan.ScalarType, 1);
    image->SetOrigin(plan.Origin[0], plan.Origin[1], 0.0);
    image->SetSpacing(plan.Spacing[0], plan.Spacing[1], 1.0);
    image->GetPointData()->GetScalars()->SetName(plan.Name.c_str());
    plan.Level > 0 ? this->ReadTiles(plan, image) : this->Read(plan, image);
    terrain::FillHidden(image);
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
  this->Internals->ToldError.clear();
  return 1;
}

//------------------------------------------------------------------------------
// Of a file of vtkTerrainHierarchy; without an image what the pipeline asks for ahead.
int vtkTerrainRasterReader::RequestPrepared(vtkInformation* info, vtkImageData* image)
{
  info->Set(CAN_PRODUCE_SUB_EXTENT(), 1);
  const std::string why = terrain::ReadPreparedFile(this->FileName,
    { this->CoordinateSystem, this->Window[2] > 0 || this->Window[3] > 0,
      this->Band > 1 || this->BandsAsTimeSteps, this->MaximumSize, this->MaximumNumberOfSamples },
    info, image);
  return why.empty() ? 1 : this->Fail(why);
}

//------------------------------------------------------------------------------
void vtkTerrainRasterReader::Read(vtkTerrainRasterPlan& plan, vtkImageData* image)
{
  terrain::RasterRequest& request = plan.Request;
  if (request.Extent[1] < request.Extent[0] || request.Extent[3] < request.Extent[2])
  {
    return;
  }
  const terrain::RasterHoles& holes = plan.File->GetHoles();
  request.NoData = holes.Declared;
  request.UndeclaredNoData = holes.Undeclared;
  request.UseOverviews = !this->UseNoDataValue && !holes.UndeclaredOccurs;
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
  for (const auto& [value, count] : findings.Undeclared)
  {
    // Pieces count their own samples: the first one that has some speaks for all.
    if (count > 0 && this->Internals->ToldFill.insert(value).second)
    {
      this->Warn(std::to_string(count) + " samples of " + terrain::NumberText(value) +
        " are taken for no data, which the file does not declare (--nodata none if they are "
        "heights)");
    }
  }
}

//------------------------------------------------------------------------------
void vtkTerrainRasterReader::AddFieldData(vtkTerrainRasterPlan& plan, vtkImageData* image) const
{
  namespace FieldData = terrain::FieldData;
  const terrain::RasterWindow& window = plan.Request.Window;
  FieldData::AddText(image, "FileName", this->FileName);
  FieldData::AddText(image, "CRS", plan.Layout.CRS);
  FieldData::AddText(image, "VerticalUnit", plan.VerticalUnit);
  FieldData::AddTexts(image, "Record", plan.File->GetRecord().GetLines());
  FieldData::AddTexts(image, "Warnings", this->Internals->ListWarnings(this->WarningMessage));
  FieldData::AddTuple(image, "VerticalScale", { plan.VerticalScale });
  FieldData::AddTuple(image, "RasterSize",
    { static_cast<double>(plan.File->GetWidth()), static_cast<double>(plan.File->GetHeight()) });
  FieldData::AddTuple(image, "RasterWindow",
    { static_cast<double>(window.X), static_cast<double>(window.Y),
      static_cast<double>(window.Width), static_cast<double>(window.Height) });
  if (plan.Layout.HasGeoTransform)
  {
    const std::array<double, 6>& t = plan.Layout.GeoTransform;
    FieldData::AddTuple(image, "GeoTransform", { t.begin(), t.end() });
    FieldData::AddTuple(
      image, "LayoutOrigin", { plan.Layout.Origin.begin(), plan.Layout.Origin.end() });
    FieldData::AddTuple(
      image, "LayoutScale", { plan.Layout.Scale.begin(), plan.Layout.Scale.end() });
  }
}

//------------------------------------------------------------------------------
void vtkTerrainRasterReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  vtkInternals::PrintSettings(*this, os, indent);
  os << indent << "Level: " << this->Level << "\n"
     << indent << "WarnOfLevels: " << this->WarnOfLevels << "\n"
     << indent << "WarnOfSites: " << this->WarnOfSites << "\n"
     << indent << "NumberOfSites: " << this->NumberOfSites << "\n"
     << indent << "Site: " << this->Site << "\n"
     << indent << "ErrorMessage: " << this->ErrorMessage << "\n"
     << indent << "WarningMessage: " << this->WarningMessage << "\n";
}
