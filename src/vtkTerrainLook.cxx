// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainLook.h"

#include "data/Setting.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

vtkStandardNewMacro(vtkTerrainLook);

namespace
{
template <typename Value>
void PrintSetting(ostream& os, vtkIndent indent, const char* name, const Value& value)
{
  os << indent << name << ": ";
  if constexpr (std::is_enum_v<Value>)
  {
    os << static_cast<int>(value) << "\n";
  }
  else
  {
    os << value << "\n";
  }
}

void PrintSetting(
  ostream& os, vtkIndent indent, const char* name, const std::array<double, 4>& values)
{
  os << indent << name << ": " << values[0] << " " << values[1] << " " << values[2] << " "
     << values[3] << "\n";
}
}

//------------------------------------------------------------------------------
void vtkTerrainLook::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
#define vtkTerrainPrintMacro(Name) PrintSetting(os, indent, #Name, this->Values.Name)
  vtkTerrainPrintMacro(Technique);
  vtkTerrainPrintMacro(VerticalExaggeration);
  vtkTerrainPrintMacro(DetailCells);
  vtkTerrainPrintMacro(DetailScale);
  vtkTerrainPrintMacro(Steps);
  vtkTerrainPrintMacro(LongSteps);
  vtkTerrainPrintMacro(SecantSteps);
  vtkTerrainPrintMacro(StepLength);
  vtkTerrainPrintMacro(Surface);
  vtkTerrainPrintMacro(PixelTolerance);
  vtkTerrainPrintMacro(ShowCrossings);
  vtkTerrainPrintMacro(MaximumShownCrossings);
  vtkTerrainPrintMacro(ComputeMode);
  vtkTerrainPrintMacro(UseBeams);
  vtkTerrainPrintMacro(ColorSource);
  vtkTerrainPrintMacro(Drape);
  vtkTerrainPrintMacro(DrapeBounds);
  vtkTerrainPrintMacro(Contours);
  vtkTerrainPrintMacro(ContourInterval);
  vtkTerrainPrintMacro(ContourWidth);
  vtkTerrainPrintMacro(ContourIndex);
  vtkTerrainPrintMacro(ContourColor);
  vtkTerrainPrintMacro(Hillshade);
  vtkTerrainPrintMacro(HillshadeAzimuth);
  vtkTerrainPrintMacro(HillshadeAltitude);
  vtkTerrainPrintMacro(Block);
  vtkTerrainPrintMacro(BlockBase);
  vtkTerrainPrintMacro(MaximumLayers);
  vtkTerrainPrintMacro(SampleShading);
  vtkTerrainPrintMacro(SunShadows);
  vtkTerrainPrintMacro(SunAngle);
  vtkTerrainPrintMacro(SkyLight);
#undef vtkTerrainPrintMacro
}

//------------------------------------------------------------------------------
void vtkTerrainLook::DeepCopy(vtkTerrainLook* other)
{
  if (other && other != this)
  {
    this->Values = other->Values;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
#define vtkTerrainSettingMacro(Name, Type, Valid, Condition, Demand)                               \
  void vtkTerrainLook::Set##Name(Type value)                                                       \
  {                                                                                                \
    if (!(Condition))                                                                              \
    {                                                                                              \
      vtkErrorMacro(#Name " must be " Demand);                                                     \
      return;                                                                                      \
    }                                                                                              \
    terrain::Setting::Set(this, this->Values.Name, Valid);                                         \
  }                                                                                                \
  Type vtkTerrainLook::Get##Name() const                                                           \
  {                                                                                                \
    return this->Values.Name;                                                                      \
  }
/// Any value; those below a least one count as that; a condition must hold.
#define vtkTerrainAnyMacro(Name, Type) vtkTerrainSettingMacro(Name, Type, value, true, "")
#define vtkTerrainLeastMacro(Name, Type, Least)                                                    \
  vtkTerrainSettingMacro(Name, Type, std::max<Type>(value, Least), true, "")
#define vtkTerrainDemandMacro(Name, Type, Condition, Demand)                                       \
  vtkTerrainSettingMacro(Name, Type, value, Condition, Demand)

vtkTerrainAnyMacro(Technique, vtkTerrainLook::Techniques);
vtkTerrainDemandMacro(
  VerticalExaggeration, double, value > 0.0 && std::isfinite(value), "above 0, not " << value);
vtkTerrainDemandMacro(DetailCells, int,
  value >= 1 && value <= MostDetailCells && (value & (value - 1)) == 0,
  "a power of two from 1 to " << MostDetailCells << ", not " << value);
vtkTerrainLeastMacro(DetailScale, double, 0.0);
vtkTerrainLeastMacro(Steps, int, 0);
vtkTerrainLeastMacro(LongSteps, int, 0);
vtkTerrainLeastMacro(SecantSteps, int, 0);
vtkTerrainLeastMacro(StepLength, double, 0.0);
vtkTerrainAnyMacro(Surface, vtkTerrainLook::Surfaces);
vtkTerrainLeastMacro(PixelTolerance, double, 0.0);
vtkTerrainAnyMacro(ShowCrossings, bool);
vtkTerrainDemandMacro(MaximumShownCrossings, int, value > 0, "above 0, not " << value);
vtkTerrainAnyMacro(ComputeMode, vtkTerrainLook::ComputeModes);
vtkTerrainAnyMacro(UseBeams, bool);
vtkTerrainAnyMacro(ColorSource, vtkTerrainLook::ColorSources);
vtkTerrainAnyMacro(Contours, bool);
vtkTerrainDemandMacro(ContourInterval, double, value > 0.0, "above 0, not " << value);
vtkTerrainDemandMacro(ContourWidth, double, value >= 0.0, "0 or more, not " << value);
vtkTerrainDemandMacro(ContourIndex, int, value >= 0, "0 or more, not " << value);
vtkTerrainAnyMacro(Hillshade, bool);
vtkTerrainDemandMacro(HillshadeAzimuth, double, std::isfinite(value), "a number");
vtkTerrainDemandMacro(HillshadeAltitude, double, std::isfinite(value), "a number");
vtkTerrainAnyMacro(Block, bool);
vtkTerrainDemandMacro(BlockBase, double, std::isfinite(value), "a number");
vtkTerrainDemandMacro(MaximumLayers, int, value >= 1, "1 or more, not " << value);
vtkTerrainAnyMacro(SampleShading, bool);
vtkTerrainAnyMacro(SunShadows, bool);
vtkTerrainDemandMacro(
  SunAngle, double, value >= 0.0 && value <= 90.0, "0 to 90 degrees, not " << value);
vtkTerrainDemandMacro(
  SkyLight, double, value >= 0.0 && std::isfinite(value), "0 or more, not " << value);

//------------------------------------------------------------------------------
void vtkTerrainLook::SetContourColor(double red, double green, double blue, double opacity)
{
  terrain::Setting::Set(
    this, this->Values.ContourColor, std::array<double, 4>{ red, green, blue, opacity });
}

//------------------------------------------------------------------------------
void vtkTerrainLook::GetContourColor(double rgba[4]) const
{
  std::copy(this->Values.ContourColor.begin(), this->Values.ContourColor.end(), rgba);
}

//------------------------------------------------------------------------------
void vtkTerrainLook::SetDrape(vtkImageData* picture, const double bounds[4])
{
  const auto isInOrder = [](double low, double high)
  { return low < high && std::isfinite(high - low); };
  if (picture && !(isInOrder(bounds[0], bounds[1]) && isInOrder(bounds[2], bounds[3])))
  {
    vtkErrorMacro("A drape must lie between finite bounds west < east and south < north");
    return;
  }
  this->Values.Drape = picture;
  if (picture)
  {
    std::copy(bounds, bounds + 4, this->Values.DrapeBounds.begin());
  }
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkTerrainLook::SetDrape(vtkImageData* picture)
{
  double bounds[4] = { 0.0, 1.0, 0.0, 1.0 };
  for (std::size_t axis = 0; picture && axis < 2; ++axis)
  {
    const int* extent = picture->GetExtent() + 2 * axis;
    const double origin = picture->GetOrigin()[axis];
    const double spacing = picture->GetSpacing()[axis];
    bounds[2 * axis] = origin + (extent[0] - 0.5) * spacing;
    bounds[2 * axis + 1] = origin + (extent[1] + 0.5) * spacing;
  }
  this->SetDrape(picture, bounds);
}

//------------------------------------------------------------------------------
vtkImageData* vtkTerrainLook::GetDrape() const
{
  return this->Values.Drape;
}

//------------------------------------------------------------------------------
void vtkTerrainLook::GetDrapeBounds(double bounds[4]) const
{
  std::copy(this->Values.DrapeBounds.begin(), this->Values.DrapeBounds.end(), bounds);
}
