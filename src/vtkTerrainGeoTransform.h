// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainGeoTransform
 * @brief   places points, tracks and vector layers in the scene
 *
 * From longitude, latitude (degrees, WGS84) and height (metres), or from the coordinates of a file,
 * to the scene of a vtkTerrainGeoreference; Inverse() turns it round. For vtkTransformFilter and
 * everything else that takes a vtkAbstractTransform.
 *
 * A float holds a longitude to a metre at best: give points of type double, or let the filter make
 * doubles (vtkTransformFilter::SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION)).
 *
 * Derivatives, which turn normals and vectors, are central differences over 2 m (2e-5 degrees).
 * Points without image become NaN; if the georeference cannot be used at all (GetWhyNot), every
 * point does, and an error says why.
 *
 * Whole arrays of points run on the threads of vtkSMPTools.
 *
 * @sa vtkTerrainGeoreference vtkTerrainDrape
 */
#ifndef vtkTerrainGeoTransform_h
#define vtkTerrainGeoTransform_h

#include "vtkSmartPointer.h"  // For members
#include "vtkTerrainModule.h" // For export macro
#include "vtkWarpTransform.h"

class vtkTerrainGeoreference;

class VTKTERRAIN_EXPORT vtkTerrainGeoTransform : public vtkWarpTransform
{
public:
  static vtkTerrainGeoTransform* New();
  vtkTypeMacro(vtkTerrainGeoTransform, vtkWarpTransform)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// What the scene is; none by default.
  void SetGeoreference(vtkTerrainGeoreference* georeference);
  vtkTerrainGeoreference* GetGeoreference() const;
  ///@}

  /// What points are brought into the scene.
  enum class SourceType
  {
    /// Longitude, latitude, height.
    Places,
    /// x, y, height in the file's coordinate reference system.
    File
  };
  ///@{
  /// Default Places.
  void SetSource(SourceType source);
  SourceType GetSource() const
  {
    return this->Source;
  }
  ///@}

  /// Whole arrays at once.
  void TransformPoints(vtkPoints* in, vtkPoints* out) override;

  vtkAbstractTransform* MakeTransform() override;
  vtkMTimeType GetMTime() override;

  vtkTerrainGeoTransform(const vtkTerrainGeoTransform&) = delete;
  void operator=(const vtkTerrainGeoTransform&) = delete;

protected:
  vtkTerrainGeoTransform();
  ~vtkTerrainGeoTransform() override;

  void InternalUpdate() override;
  void InternalDeepCopy(vtkAbstractTransform* transform) override;

  void ForwardTransformPoint(const float in[3], float out[3]) override;
  void ForwardTransformPoint(const double in[3], double out[3]) override;
  void ForwardTransformDerivative(const float in[3], float out[3], float derivative[3][3]) override;
  void ForwardTransformDerivative(
    const double in[3], double out[3], double derivative[3][3]) override;
  void InverseTransformPoint(const float in[3], float out[3]) override;
  void InverseTransformPoint(const double in[3], double out[3]) override;
  void InverseTransformDerivative(const float in[3], float out[3], float derivative[3][3]) override;
  void InverseTransformDerivative(
    const double in[3], double out[3], double derivative[3][3]) override;

private:
  void Bring(const double* in, double* out, vtkIdType count, bool toScene);

  vtkSmartPointer<vtkTerrainGeoreference> Georeference;
  SourceType Source = SourceType::Places;
};

#endif
