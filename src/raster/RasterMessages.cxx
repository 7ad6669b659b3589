// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/RasterMessages.h"
#include "raster/GDALTable.h"

#include <algorithm>

namespace terrain
{
namespace
{
std::string OneLine(const char* text)
{
  std::string line(text ? text : "");
  std::replace(line.begin(), line.end(), '\n', ' ');
  while (!line.empty() && (line.back() == ' ' || line.back() == '.'))
  {
    line.pop_back();
  }
  return line;
}
}

//------------------------------------------------------------------------------
GDALMessages::GDALMessages()
{
  CPLPushErrorHandlerEx(&GDALMessages::Collect, this);
  CPLErrorReset();
}

//------------------------------------------------------------------------------
GDALMessages::~GDALMessages()
{
  CPLPopErrorHandler();
  CPLErrorReset();
}

//------------------------------------------------------------------------------
void CPL_STDCALL GDALMessages::Collect(CPLErr kind, CPLErrorNum /*number*/, const char* text)
{
  auto* self = static_cast<GDALMessages*>(CPLGetErrorHandlerUserData());
  if (!self)
  {
    return;
  }
  if ((kind == CE_Failure || kind == CE_Fatal) && self->Failure.empty())
  {
    self->Failure = OneLine(text);
  }
  const std::string line = kind == CE_Warning ? OneLine(text) : std::string();
  if (!line.empty() &&
    std::find(self->Warnings.begin(), self->Warnings.end(), line) == self->Warnings.end())
  {
    self->Warnings.push_back(line);
  }
}
}
