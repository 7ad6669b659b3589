// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainCameraStrips
 * @brief   vtkTerrainStrips with a camera of its own, whose numbers ParaView can set
 *
 * While the camera is vtkCamera's default, at (0, 0, 1) and looking at the origin, the heights are
 * refined for one that sees all of them from above. vtkSMTerrainStripsCamera gives new filters the
 * camera of the active view.
 *
 * In parallel each process refines its own piece, down to every sample of its border, where it
 * meets its neighbours without a gap.
 */
#ifndef vtkTerrainCameraStrips_h
#define vtkTerrainCameraStrips_h

#include "vtkTerrainParaViewViewsModule.h" // For export macro
#include "vtkTerrainStrips.h"

class VTKTERRAINPARAVIEWVIEWS_EXPORT vtkTerrainCameraStrips : public vtkTerrainStrips
{
public:
  static vtkTerrainCameraStrips* New();
  vtkTypeMacro(vtkTerrainCameraStrips, vtkTerrainStrips)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// As those of vtkCamera, with its defaults.
  void SetCameraPosition(double x, double y, double z);
  void SetCameraFocalPoint(double x, double y, double z);
  void SetCameraViewUp(double x, double y, double z);
  void SetCameraViewAngle(double degrees);
  ///@}

  vtkTerrainCameraStrips(const vtkTerrainCameraStrips&) = delete;
  void operator=(const vtkTerrainCameraStrips&) = delete;

protected:
  vtkTerrainCameraStrips();
  ~vtkTerrainCameraStrips() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  bool IsDefaultCamera();
};

#endif
