// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainDepthPass
 * @brief   distances along the viewing direction as floats, whatever the depth buffer holds
 *
 * Draws the opaque props of a renderer into a buffer of 32-bit floats instead of the window: for
 * each pixel the distance from the camera's plane along the viewing direction (not along the ray)
 * to what the pixel's centre shows, in world units. Works with every mapper that is a
 * vtkOpenGLPolyDataMapper and lit; on vtkOpenGLTerrainMapper the distance is that of the hit, to
 * float precision.
 *
 * @code
 *   vtkNew<vtkTerrainDepthPass> pass;
 *   renderer->SetPass(pass);
 *   window->Render();
 *   vtkImageData* distances = pass->GetDistances();
 *   renderer->SetPass(nullptr);
 * @endcode
 *
 * @sa vtkOpenGLTerrainMapper
 */
#ifndef vtkTerrainDepthPass_h
#define vtkTerrainDepthPass_h

#include "vtkNew.h" // For members
#include "vtkOpenGLRenderPass.h"
#include "vtkTerrainModule.h" // For export macro

#include <memory> // For std::unique_ptr

class vtkImageData;

class VTKTERRAIN_EXPORT vtkTerrainDepthPass : public vtkOpenGLRenderPass
{
public:
  static vtkTerrainDepthPass* New();
  vtkTypeMacro(vtkTerrainDepthPass, vtkOpenGLRenderPass)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The distances of the last rendering: W x H x 1 float scalars, row 0 at the bottom of the
  /// viewport, NaN where nothing is drawn. Empty before the first rendering.
  vtkImageData* GetDistances();

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;

  vtkTerrainDepthPass(const vtkTerrainDepthPass&) = delete;
  void operator=(const vtkTerrainDepthPass&) = delete;

protected:
  vtkTerrainDepthPass();
  ~vtkTerrainDepthPass() override;

private:
  void Download(int width, int height);

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
