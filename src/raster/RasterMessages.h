// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What GDAL says, kept instead of printed. Private to the module.
 */
#ifndef vtkTerrain_raster_RasterMessages_h
#define vtkTerrain_raster_RasterMessages_h

#include <cpl_error.h>

#include <string>
#include <vector>

namespace terrain
{
/// Collects the failures and warnings that GDAL reports on this thread while it lives.
class GDALMessages
{
public:
  GDALMessages();
  ~GDALMessages();
  GDALMessages(const GDALMessages&) = delete;
  void operator=(const GDALMessages&) = delete;

  /// The first failure reported so far, as one line; empty if there was none.
  const std::string& GetFailure() const
  {
    return this->Failure;
  }
  /// The warnings reported so far, one line each, each once.
  const std::vector<std::string>& GetWarnings() const
  {
    return this->Warnings;
  }

private:
  static void CPL_STDCALL Collect(CPLErr kind, CPLErrorNum number, const char* text);
  std::string Failure;
  std::vector<std::string> Warnings;
};
}
#endif
