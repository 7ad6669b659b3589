// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What vtkTerrainColors keeps. Private to the module.
 */
#ifndef vtkTerrain_parts_ColorsInternals_h
#define vtkTerrain_parts_ColorsInternals_h

#include "core/colors/ColorFile.h"

#include "vtkTerrainColors.h"

class vtkTerrainColors::vtkInternals
{
public:
  terrain::ColorScheme Scheme = *terrain::FindColorScheme("relief");
};

#endif
