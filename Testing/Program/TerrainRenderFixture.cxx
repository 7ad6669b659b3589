// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TerrainRenderFixture.h"

#include <gdal.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include <csignal>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace
{
constexpr std::chrono::seconds kLongestRun{ 240 };
/// Where stdout and stderr of the program go, beside the folder of the test.
const char* const kOutputSuffix = ".stdout";
const char* const kErrorsSuffix = ".stderr";

std::string ReadFile(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  return content.str();
}

/// In the child: becomes the program, or ends with 127.
[[noreturn]] void Become(
  const std::string& folder, std::vector<std::string> command, long fileLimit)
{
  const int output = open((folder + kOutputSuffix).c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  const int errors = open((folder + kErrorsSuffix).c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  dup2(output, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  if (fileLimit > 0)
  {
    // a write beyond the limit then fails as on a full disk
    std::signal(SIGXFSZ, SIG_IGN);
    const struct rlimit limit = { static_cast<rlim_t>(fileLimit), static_cast<rlim_t>(fileLimit) };
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  std::vector<char*> pointers;
  pointers.reserve(command.size() + 1);
  for (std::string& word : command)
  {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  if (chdir(folder.c_str()) == 0)
  {
    execv(pointers[0], pointers.data());
  }
  _exit(127);
}

/// The status of the child, -1 if a signal ended it or it had to be ended.
int WaitFor(pid_t child)
{
  const auto begin = std::chrono::steady_clock::now();
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0)
  {
    if (std::chrono::steady_clock::now() - begin > kLongestRun)
    {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      return -1;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}
}

//------------------------------------------------------------------------------
int Depths::CountHits() const
{
  return static_cast<int>(std::count_if(
    this->Values.begin(), this->Values.end(), [](float depth) { return std::isfinite(depth); }));
}

//------------------------------------------------------------------------------
void TerrainRenderFixture::SetUp()
{
  GDALAllRegister();
  const ::testing::TestInfo* info = ::testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(info->test_suite_name()) + "." + info->name();
  std::replace(name.begin(), name.end(), '/', '_');
  const char* outputs = std::getenv("VTKTERRAIN_TEST_OUTPUT_DIR");
  ASSERT_NE(outputs, nullptr) << "VTKTERRAIN_TEST_OUTPUT_DIR is not set";
  this->Folder = std::string(outputs) + "/" + name;
  fs::remove_all(this->Folder);
  fs::create_directories(this->Folder);
}

//------------------------------------------------------------------------------
std::string TerrainRenderFixture::WriteText(const std::string& name, const std::string& text) const
{
  std::ofstream(this->Path(name), std::ios::binary) << text;
  return this->Path(name);
}

//------------------------------------------------------------------------------
std::string TerrainRenderFixture::WriteRaster(
  const std::string& name, const RasterDescription& description) const
{
  std::string path = this->Path(name);
  GDALDatasetH dataset = GDALCreate(GDALGetDriverByName("GTiff"), path.c_str(), description.Width,
    description.Height, description.Bands, description.IsBytes ? GDT_Byte : GDT_Float32, nullptr);
  std::vector<double> transform = description.GeoTransform;
  GDALSetGeoTransform(dataset, transform.data());
  if (!description.CoordinateSystem.empty())
  {
    OGRSpatialReferenceH reference = OSRNewSpatialReference(nullptr);
    EXPECT_EQ(OSRSetFromUserInput(reference, description.CoordinateSystem.c_str()), OGRERR_NONE);
    GDALSetSpatialRef(dataset, reference);
    OSRRelease(reference);
  }
  std::vector<float> row(description.Width);
  for (int band = 1; band <= description.Bands; ++band)
  {
    GDALRasterBandH target = GDALGetRasterBand(dataset, band);
    GDALSetRasterUnitType(target, description.Unit.c_str());
    if (description.HasNoData)
    {
      GDALSetRasterNoDataValue(target, description.NoData);
    }
    for (int j = 0; j < description.Height; ++j)
    {
      for (int i = 0; i < description.Width; ++i)
      {
        row[i] = static_cast<float>(description.Sample(i, j));
      }
      EXPECT_EQ(GDALRasterIO(target, GF_Write, 0, j, description.Width, 1, row.data(),
                  description.Width, 1, GDT_Float32, 0, 0),
        CE_None);
    }
  }
  GDALClose(dataset);
  return path;
}

//------------------------------------------------------------------------------
std::string TerrainRenderFixture::WriteHill(const std::string& name) const
{
  RasterDescription hill;
  hill.Width = 65;
  hill.Height = 49;
  hill.Sample = [](int i, int j)
  { return 20.0 * std::exp(-((i - 32.0) * (i - 32.0) + (j - 24.0) * (j - 24.0)) / 150.0); };
  return this->WriteRaster(name, hill);
}

//------------------------------------------------------------------------------
std::string TerrainRenderFixture::WriteSites() const
{
  std::filesystem::create_directory(this->Path("isles"));
  RasterDescription tile;
  tile.Width = tile.Height = 48;
  tile.CoordinateSystem = "EPSG:32631";
  tile.GeoTransform = { 500000.0, 0.5, 0.0, 5000000.0, 0.0, -0.5 };
  tile.Sample = [](int i, int j) { return 0.1 * (i + j); };
  this->WriteRaster("isles/a.tif", tile);
  tile.GeoTransform[0] += kAwayOfSites;
  tile.GeoTransform[3] += kAwayOfSites;
  tile.Sample = [](int i, int j) { return 100.0 + 0.1 * (i + j); };
  this->WriteRaster("isles/b.tif", tile);
  return this->Path("isles");
}

//------------------------------------------------------------------------------
std::string TerrainRenderFixture::Program()
{
  return TERRAIN_RENDER_PROGRAM;
}

//------------------------------------------------------------------------------
RunResult TerrainRenderFixture::Run(const std::vector<std::string>& arguments, long fileLimit) const
{
  std::vector<std::string> command = { Program() };
  command.insert(command.end(), arguments.begin(), arguments.end());
  return this->RunCommand(command, fileLimit);
}

//------------------------------------------------------------------------------
RunResult TerrainRenderFixture::RunCommand(
  const std::vector<std::string>& command, long fileLimit) const
{
  const pid_t child = fork();
  if (child == 0)
  {
    Become(this->Folder, command, fileLimit);
  }
  RunResult result;
  result.Status = WaitFor(child);
  result.Output = ReadFile(this->Folder + kOutputSuffix);
  result.Errors = ReadFile(this->Folder + kErrorsSuffix);
  return result;
}

//------------------------------------------------------------------------------
RunResult TerrainRenderFixture::Draw(
  const std::string& heights, std::vector<std::string> arguments) const
{
  arguments.insert(arguments.begin(),
    { heights, "--size", "160x120", "--output", "picture.png", "--depth", "depth.tif" });
  return this->Run(arguments);
}

//------------------------------------------------------------------------------
Depths TerrainRenderFixture::ReadDepths(const std::string& name) const
{
  Depths depths;
  GDALDatasetH dataset = GDALOpen(this->Path(name).c_str(), GA_ReadOnly);
  if (!dataset)
  {
    ADD_FAILURE() << name << " cannot be read";
    return depths;
  }
  GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
  depths.Width = GDALGetRasterXSize(dataset);
  depths.Height = GDALGetRasterYSize(dataset);
  depths.IsFloat32 = GDALGetRasterDataType(band) == GDT_Float32 && GDALGetRasterCount(dataset) == 1;
  int hasNoData = 0;
  depths.NoDataIsNaN = std::isnan(GDALGetRasterNoDataValue(band, &hasNoData)) && hasNoData != 0;
  depths.Values.resize(static_cast<std::size_t>(depths.Width) * depths.Height);
  EXPECT_EQ(GDALRasterIO(band, GF_Read, 0, 0, depths.Width, depths.Height, depths.Values.data(),
              depths.Width, depths.Height, GDT_Float32, 0, 0),
    CE_None);
  GDALClose(dataset);
  return depths;
}

//------------------------------------------------------------------------------
Picture TerrainRenderFixture::ReadPicture(const std::string& name) const
{
  Picture picture;
  GDALDatasetH dataset = GDALOpen(this->Path(name).c_str(), GA_ReadOnly);
  if (!dataset)
  {
    ADD_FAILURE() << name << " cannot be read";
    return picture;
  }
  picture.Width = GDALGetRasterXSize(dataset);
  picture.Height = GDALGetRasterYSize(dataset);
  picture.Values.resize(3 * static_cast<std::size_t>(picture.Width) * picture.Height);
  EXPECT_EQ(GDALDatasetRasterIO(dataset, GF_Read, 0, 0, picture.Width, picture.Height,
              picture.Values.data(), picture.Width, picture.Height, GDT_Byte, 3, nullptr, 3,
              3 * picture.Width, 1),
    CE_None);
  GDALClose(dataset);
  return picture;
}

//------------------------------------------------------------------------------
std::vector<int> TerrainRenderFixture::ReadPictureSize(const std::string& name) const
{
  const char* const drivers[] = { "PNG", nullptr };
  GDALDatasetH dataset =
    GDALOpenEx(this->Path(name).c_str(), GDAL_OF_RASTER, drivers, nullptr, nullptr);
  if (!dataset)
  {
    return { 0, 0 };
  }
  std::vector<int> size = { GDALGetRasterXSize(dataset), GDALGetRasterYSize(dataset) };
  GDALClose(dataset);
  return size;
}

//------------------------------------------------------------------------------
std::string TerrainRenderFixture::ReadText(const std::string& name) const
{
  return ReadFile(this->Path(name));
}

//------------------------------------------------------------------------------
std::vector<std::string> TerrainRenderFixture::ListFiles() const
{
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(this->Folder))
  {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

//------------------------------------------------------------------------------
void TerrainRenderFixture::ExpectRefused(
  const RunResult& result, int status, const std::string& mention)
{
  EXPECT_EQ(result.Status, status) << result.Errors;
  EXPECT_EQ(std::count(result.Errors.begin(), result.Errors.end(), '\n'), 1) << result.Errors;
  EXPECT_NE(result.Errors.find(mention), std::string::npos) << result.Errors;
  EXPECT_EQ(result.Output, "");
}

//------------------------------------------------------------------------------
void TerrainRenderFixture::ExpectDrawn(const RunResult& result, int leastHits) const
{
  ASSERT_EQ(result.Status, 0) << result.Errors;
  EXPECT_EQ(result.Output, this->Path("picture.png") + "\n");
  EXPECT_EQ(this->ReadPictureSize("picture.png"), (std::vector<int>{ 160, 120 }));
  EXPECT_GE(this->ReadDepths().CountHits(), leastHits);
}
