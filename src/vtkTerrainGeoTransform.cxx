// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainGeoTransform.h"

#include "data/Setting.h"
#include "vtkTerrainGeoreference.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace
{
// Half the length over which derivatives are taken.
constexpr double kStepDegrees = 1e-5;
constexpr double kStepMetres = 1.0;

template <typename From, typename To>
void CopyPoint(const From* from, To* to)
{
  for (int i = 0; i < 3; ++i)
  {
    to[i] = static_cast<To>(from[i]);
  }
}

void CopyMatrix(const double from[3][3], float to[3][3])
{
  for (int i = 0; i < 3; ++i)
  {
    CopyPoint(from[i], to[i]);
  }
}
}

vtkStandardNewMacro(vtkTerrainGeoTransform);

vtkTerrainGeoTransform::vtkTerrainGeoTransform() = default;
vtkTerrainGeoTransform::~vtkTerrainGeoTransform() = default;

void vtkTerrainGeoTransform::SetGeoreference(vtkTerrainGeoreference* georeference)
{
  terrain::Setting::Set(this, this->Georeference, georeference);
}

vtkTerrainGeoreference* vtkTerrainGeoTransform::GetGeoreference() const
{
  return this->Georeference;
}

void vtkTerrainGeoTransform::SetSource(SourceType source)
{
  terrain::Setting::Set(this, this->Source, source);
}

vtkMTimeType vtkTerrainGeoTransform::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Georeference ? std::max(time, this->Georeference->GetMTime()) : time;
}

void vtkTerrainGeoTransform::InternalUpdate()
{
  const std::string why =
    this->Georeference ? this->Georeference->GetWhyNot() : "there is no georeference";
  if (!why.empty())
  {
    vtkErrorMacro(<< why);
  }
}

void vtkTerrainGeoTransform::InternalDeepCopy(vtkAbstractTransform* transform)
{
  auto* other = vtkTerrainGeoTransform::SafeDownCast(transform);
  this->SetInverseTolerance(other->InverseTolerance);
  this->SetInverseIterations(other->InverseIterations);
  this->SetGeoreference(other->Georeference);
  this->SetSource(other->Source);
  if (this->InverseFlag != other->InverseFlag)
  {
    this->InverseFlag = other->InverseFlag;
    this->Modified();
  }
}

vtkAbstractTransform* vtkTerrainGeoTransform::MakeTransform()
{
  return vtkTerrainGeoTransform::New();
}

void vtkTerrainGeoTransform::Bring(const double* in, double* out, vtkIdType count, bool toScene)
{
  bool done = false;
  if (vtkTerrainGeoreference* reference = this->Georeference)
  {
    const bool places = this->Source == SourceType::Places;
    if (toScene)
    {
      done =
        places ? reference->PlacesToScene(in, out, count) : reference->FileToScene(in, out, count);
    }
    else
    {
      done =
        places ? reference->SceneToPlaces(in, out, count) : reference->SceneToFile(in, out, count);
    }
  }
  if (!done)
  {
    std::fill_n(out, 3 * count, std::numeric_limits<double>::quiet_NaN());
  }
}

void vtkTerrainGeoTransform::TransformPoints(vtkPoints* in, vtkPoints* out)
{
  this->Update();
  const vtkIdType count = in->GetNumberOfPoints();
  const vtkIdType first = out->GetNumberOfPoints();
  std::vector<double> points(static_cast<std::size_t>(3 * count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    in->GetPoint(i, points.data() + 3 * i);
  }
  this->Bring(points.data(), points.data(), count, this->InverseFlag == 0);
  out->SetNumberOfPoints(first + count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    out->SetPoint(first + i, points.data() + 3 * i);
  }
  out->Modified();
}

void vtkTerrainGeoTransform::ForwardTransformPoint(const double in[3], double out[3])
{
  this->Bring(in, out, 1, true);
}

void vtkTerrainGeoTransform::InverseTransformPoint(const double in[3], double out[3])
{
  this->Bring(in, out, 1, false);
}

void vtkTerrainGeoTransform::ForwardTransformDerivative(
  const double in[3], double out[3], double derivative[3][3])
{
  const bool places = this->Source == SourceType::Places;
  // The point, then its neighbours before and after along each axis.
  double points[7][3];
  for (double* point : points)
  {
    CopyPoint(in, point);
  }
  const double steps[3] = { places ? kStepDegrees : kStepMetres,
    places ? kStepDegrees : kStepMetres, kStepMetres };
  double(*before)[3] = points + 1;
  double(*after)[3] = points + 4;
  for (int axis = 0; axis < 3; ++axis)
  {
    before[axis][axis] -= steps[axis];
    after[axis][axis] += steps[axis];
  }
  this->Bring(points[0], points[0], 7, true);
  CopyPoint(points[0], out);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < 3; ++i)
    {
      derivative[i][axis] = (after[axis][i] - before[axis][i]) / (2.0 * steps[axis]);
    }
  }
}

void vtkTerrainGeoTransform::InverseTransformDerivative(
  const double in[3], double out[3], double derivative[3][3])
{
  // As the superclass wants it: the derivative of the forward transform, at the result.
  double image[3];
  this->InverseTransformPoint(in, out);
  this->ForwardTransformDerivative(out, image, derivative);
}

void vtkTerrainGeoTransform::ForwardTransformPoint(const float in[3], float out[3])
{
  double point[3];
  CopyPoint(in, point);
  this->ForwardTransformPoint(point, point);
  CopyPoint(point, out);
}

void vtkTerrainGeoTransform::InverseTransformPoint(const float in[3], float out[3])
{
  double point[3];
  CopyPoint(in, point);
  this->InverseTransformPoint(point, point);
  CopyPoint(point, out);
}

void vtkTerrainGeoTransform::ForwardTransformDerivative(
  const float in[3], float out[3], float derivative[3][3])
{
  double point[3];
  double image[3];
  double matrix[3][3];
  CopyPoint(in, point);
  this->ForwardTransformDerivative(point, image, matrix);
  CopyPoint(image, out);
  CopyMatrix(matrix, derivative);
}

void vtkTerrainGeoTransform::InverseTransformDerivative(
  const float in[3], float out[3], float derivative[3][3])
{
  double point[3];
  double image[3];
  double matrix[3][3];
  CopyPoint(in, point);
  this->InverseTransformDerivative(point, image, matrix);
  CopyPoint(image, out);
  CopyMatrix(matrix, derivative);
}

void vtkTerrainGeoTransform::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Georeference: " << this->Georeference.Get() << "\n";
  os << indent << "Source: " << (this->Source == SourceType::Places ? "places" : "file") << "\n";
}
