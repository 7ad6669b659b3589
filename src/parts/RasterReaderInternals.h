// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the files of vtkTerrainRasterReader share. Private to the module.
 */
#ifndef vtkTerrain_parts_RasterReaderInternals_h
#define vtkTerrain_parts_RasterReaderInternals_h

#include "vtkTerrainRasterReader.h"

#include "raster/ReaderPlan.h"

#include "vtkFieldData.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <sys/stat.h>

/// What is kept between updates.
class vtkTerrainRasterReader::vtkInternals
{
public:
  /// Changes with the file.
  static std::string StampOf(const std::string& name)
  {
    struct stat status = {};
    return stat(name.c_str(), &status) == 0
      ? std::to_string(status.st_mtime) + " " + std::to_string(status.st_size)
      : std::string();
  }

  /// What users have set, as lines of text.
  static void PrintSettings(const vtkTerrainRasterReader& reader, ostream& os, vtkIndent indent)
  {
    os << indent << "FileName: " << reader.FileName << "\n"
       << indent << "CoordinateSystem: " << reader.CoordinateSystem << "\n"
       << indent << "Part: " << reader.Part << "\n"
       << indent << "HeightUnit: " << reader.HeightUnit << "\n"
       << indent << "Flip: " << reader.Flip << "\n"
       << indent << "Band: " << reader.Band << "\n"
       << indent << "BandsAsTimeSteps: " << reader.BandsAsTimeSteps << "\n"
       << indent << "Window: " << reader.Window[0] << " " << reader.Window[1] << " "
       << reader.Window[2] << " " << reader.Window[3] << "\n"
       << indent << "MaximumSize: " << reader.MaximumSize << "\n"
       << indent << "MaximumNumberOfSamples: " << reader.MaximumNumberOfSamples << "\n"
       << indent << "NoDataValue: " << reader.NoDataValue << "\n"
       << indent << "UseNoDataValue: " << reader.UseNoDataValue << "\n"
       << indent << "DetectNoData: " << reader.DetectNoData << "\n"
       << indent << "NoDataAsNaN: " << reader.NoDataAsNaN << "\n"
       << indent << "UseLevels: " << reader.UseLevels << "\n"
       << indent << "UseCache: " << reader.UseCache << "\n"
       << indent << "MemoryBudget: " << reader.MemoryBudget << "\n";
  }

  /// Lines without the name of the file that they begin with.
  static std::vector<std::string> ListWarnings(const std::string& message)
  {
    std::vector<std::string> list;
    std::istringstream stream(message);
    for (std::string line; std::getline(stream, line);)
    {
      const std::size_t cut = line.find("': ");
      list.push_back(cut == std::string::npos ? line : line.substr(cut + 3));
    }
    return list;
  }

  vtkSmartPointer<vtkFieldData> Samples;
  std::shared_ptr<vtkTerrainRasterPlan> Plan;
  vtkMTimeType Time = 0;
  std::string Stamp;
  /// Fill values that were warned of.
  std::set<double> ToldFill;
  /// The last error that was told, and the settings and the state of the file that it is about.
  std::string ToldError;
};

#endif
