// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "raster/HeldFiles.h"

#include "raster/GDALTable.h"

#include <atomic>
#include <utility>

namespace terrain
{
//------------------------------------------------------------------------------
HeldFile::HeldFile(std::string source, std::int64_t samples)
  : Source(std::move(source))
  , Samples(samples)
{
  static std::atomic<int> count{ 0 };
  this->Path = "/vsimem/vtkterrain/" + std::to_string(++count) + "/" +
    std::string(CPLGetFilename(this->Source.c_str()));
}

//------------------------------------------------------------------------------
HeldFile::~HeldFile()
{
  VSIUnlink(this->Path.c_str());
}
}
