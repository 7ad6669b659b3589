// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainScaleBar
 * @brief   a scale bar in round units, and a north arrow
 *
 * Output 0: the bar, four quadrilaterals of equal length along x from the origin, height Thickness
 * in y; cell array "Fill" (unsigned char, 1 0 1 0). Its length is the largest of 1, 2, 5 times a
 * power of ten metres that MaximumLength holds; GetLabel names it. Output 1: the arrow, two
 * triangles from the origin (its foot's middle) to ArrowLength along the direction of North; cell
 * array "Fill" (1 for the western half, 0 for the eastern).
 *
 * Both lie in z = 0, in scene metres times UnitsPerMetre: 1 for bars in the scene, pixels per metre
 * for bars in an overlay.
 *
 * @sa vtkTerrainGraticule
 */
#ifndef vtkTerrainScaleBar_h
#define vtkTerrainScaleBar_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkTerrainModule.h" // For export macro

#include <string>

class VTKTERRAIN_EXPORT vtkTerrainScaleBar : public vtkPolyDataAlgorithm
{
public:
  static vtkTerrainScaleBar* New();
  vtkTypeMacro(vtkTerrainScaleBar, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Longest bar in metres, > 0; default 1000.
  vtkSetClampMacro(MaximumLength, double, 1e-6, 1e9);
  vtkGetMacro(MaximumLength, double);
  ///@}

  ///@{
  /// Output units a metre, > 0; default 1.
  vtkSetClampMacro(UnitsPerMetre, double, 1e-12, 1e12);
  vtkGetMacro(UnitsPerMetre, double);
  ///@}

  ///@{
  /// Height of the bar and length of the arrow, in output units, >= 0; defaults 20 and 100.
  vtkSetClampMacro(Thickness, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Thickness, double);
  vtkSetClampMacro(ArrowLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ArrowLength, double);
  ///@}

  ///@{
  /// Where north is, in the output's x and y; any length but 0. Default (0, 1).
  /// vtkTerrainGeoreference::GetAxes gives it for a place of the scene.
  vtkSetVector2Macro(North, double);
  vtkGetVector2Macro(North, double);
  ///@}

  /// Length of the bar in metres.
  double GetLength() const;
  /// "500 m", "2 km".
  std::string GetLabel() const;

  vtkTerrainScaleBar(const vtkTerrainScaleBar&) = delete;
  void operator=(const vtkTerrainScaleBar&) = delete;

protected:
  vtkTerrainScaleBar();
  ~vtkTerrainScaleBar() override = default;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double MaximumLength = 1000.0;
  double UnitsPerMetre = 1.0;
  double Thickness = 20.0;
  double ArrowLength = 100.0;
  double North[2] = { 0.0, 1.0 };
};

#endif
