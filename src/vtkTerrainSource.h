// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainSource
 * @brief   a procedural mountain landscape as heights
 *
 * Output: vtkImageData of W x H x 1 points with the point scalars "Elevation", in metres, without
 * NoData; sample (0, 0), the south-western one, lies at the origin.
 *
 * The landscape is uplifted against the incision of rivers, so that its valleys drain; what is
 * finer are gullies down the slopes (terrain::ProceduralTerrain in src/core/, with the
 * sources). The longer side holds the same landscape whatever its number of samples. The same
 * parameters give the same bits on every machine, whatever the number of threads and pieces.
 *
 * Cost: about a second to raise the landscape (less below 512 samples a side; kept until a
 * parameter changes), then about 0.25 s a million samples and thread. Memory: the output.
 *
 * Limits: 1 x 1, 1 x N and N x 1 samples are legal. In short and unsigned short, heights are
 * rounded to whole metres, and those above the type's range are cut off there.
 *
 * @code{.cpp}
 * vtkNew<vtkTerrainSource> source;
 * source->SetDimensions(4096, 4096);
 * source->SetSeed(7);
 * @endcode
 *
 * @sa vtkTerrainRasterReader
 */
#ifndef vtkTerrainSource_h
#define vtkTerrainSource_h

#include "vtkImageAlgorithm.h"
#include "vtkTerrainModule.h" // For export macro

#include <memory> // For the landscape

class VTKTERRAIN_EXPORT vtkTerrainSource : public vtkImageAlgorithm
{
public:
  static vtkTerrainSource* New();
  vtkTypeMacro(vtkTerrainSource, vtkImageAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkTerrainSource(const vtkTerrainSource&) = delete;
  void operator=(const vtkTerrainSource&) = delete;

  ///@{
  /// Samples east and north, each >= 1; default 1025 x 1025.
  vtkSetVector2Macro(Dimensions, int);
  vtkGetVector2Macro(Dimensions, int);
  ///@}

  ///@{
  /// Another seed, another landscape; default 1.
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /// Distance of neighbouring samples in metres, the same east and north. 0 (the default) makes the
  /// longer side 40,960 m long, so that more samples show the same mountains in more detail.
  vtkSetClampMacro(Spacing, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /// Upper bound of the heights in metres, > 0; they begin at 0; default 2500. Over 4 % to 10 % of
  /// the longer side look like mountains.
  vtkSetClampMacro(Relief, double, 1e-3, 1e9);
  vtkGetMacro(Relief, double);
  ///@}

  ///@{
  /// Depth of the gullies on the slopes, 0 (none) to 1; default 0.5.
  vtkSetClampMacro(Roughness, double, 0.0, 1.0);
  vtkGetMacro(Roughness, double);
  ///@}

  ///@{
  /// VTK_FLOAT (the default), VTK_SHORT or VTK_UNSIGNED_SHORT.
  vtkSetMacro(OutputScalarType, int);
  vtkGetMacro(OutputScalarType, int);
  void SetOutputScalarTypeToFloat();
  void SetOutputScalarTypeToShort();
  void SetOutputScalarTypeToUnsignedShort();
  ///@}

protected:
  vtkTerrainSource();
  ~vtkTerrainSource() override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double EffectiveSpacing() const;
  void PrepareLandscape();

  int Dimensions[2] = { 1025, 1025 };
  int Seed = 1;
  double Spacing = 0.0;
  double Relief = 2500.0;
  double Roughness = 0.5;
  int OutputScalarType = VTK_FLOAT;

  struct Landscape;
  std::unique_ptr<Landscape> Raised;
};

#endif
