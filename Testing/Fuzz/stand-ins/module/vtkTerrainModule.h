// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Stands in for the header that VTK makes of the module, where its classes are built into a target.
 */
#ifndef vtkTerrainModule_h
#define vtkTerrainModule_h

#define VTKTERRAIN_EXPORT
#define VTKTERRAIN_NO_EXPORT

#endif
