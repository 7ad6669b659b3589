// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMTerrainStripsCamera
 * @brief   gives a new filter Terrain Strips the camera and the size of the active view
 *
 * Unless the filter is made with a camera of its own, or no view shows anything yet.
 */
#ifndef vtkSMTerrainStripsCamera_h
#define vtkSMTerrainStripsCamera_h

#include "vtkSMProxyInitializationHelper.h"
#include "vtkTerrainParaViewViewsModule.h" // For export macro

class VTKTERRAINPARAVIEWVIEWS_EXPORT vtkSMTerrainStripsCamera
  : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMTerrainStripsCamera* New();
  vtkTypeMacro(vtkSMTerrainStripsCamera, vtkSMProxyInitializationHelper)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

  vtkSMTerrainStripsCamera(const vtkSMTerrainStripsCamera&) = delete;
  void operator=(const vtkSMTerrainStripsCamera&) = delete;

protected:
  vtkSMTerrainStripsCamera() = default;
  ~vtkSMTerrainStripsCamera() override = default;
};

#endif
