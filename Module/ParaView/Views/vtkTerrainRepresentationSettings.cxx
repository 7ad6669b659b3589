// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// What the properties of the panel set.
#include "vtkTerrainRepresentation.h"

#include "vtkImageData.h"
#include "vtkOpenGLTerrainMapper.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainStrips.h"
#include "vtkTexture.h"

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetExtract(
  int firstColumn, int lastColumn, int firstRow, int lastRow)
{
  this->Extract = { firstColumn, lastColumn, firstRow, lastRow };
  this->HasOtherParts = true;
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetClip(bool clip)
{
  this->Clip = clip;
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetClipOrigin(double x, double y, double z)
{
  this->ClipPlane->SetOrigin(x, y, z);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetClipNormal(double x, double y, double z)
{
  this->ClipPlane->SetNormal(x, y, z);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetDrape(const char* fileName)
{
  this->Drape = fileName ? fileName : "";
  this->HasOtherParts = true;
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetTechnique(int technique)
{
  this->Actor->SetTechnique(static_cast<vtkTerrainActor::Techniques>(technique));
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetStripsTolerance(double pixels)
{
  this->Actor->GetStrips()->SetTolerance(pixels);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetSteps(int steps, int longSteps, int secantSteps)
{
  this->Actor->GetTerrainMapper()->SetSteps(steps);
  this->Actor->GetTerrainMapper()->SetLongSteps(longSteps);
  this->Actor->GetTerrainMapper()->SetSecantSteps(secantSteps);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetStepLength(double cells)
{
  this->Actor->GetTerrainMapper()->SetStepLength(cells);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetMaximumLayers(int layers)
{
  this->Actor->GetTerrainMapper()->SetMaximumLayers(layers);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetVerticalExaggeration(double exaggeration)
{
  this->Actor->SetVerticalExaggeration(exaggeration);
  this->MarkModified(); // the bounds are passed with the data
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetColorSource(int source)
{
  this->Actor->GetTerrainMapper()->SetColorSource(
    static_cast<vtkOpenGLTerrainMapper::ColorSources>(source));
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetLevelOfDetail(bool use)
{
  this->Actor->SetLevelOfDetail(use);
}

//------------------------------------------------------------------------------
#define vtkTerrainMapperMacro(Name, Type)                                                          \
  void vtkTerrainRepresentation::Set##Name(Type value)                                             \
  {                                                                                                \
    this->Actor->GetTerrainMapper()->Set##Name(value);                                             \
  }
vtkTerrainMapperMacro(Contours, bool);
vtkTerrainMapperMacro(ContourInterval, double);
vtkTerrainMapperMacro(ContourWidth, double);
vtkTerrainMapperMacro(Hillshade, bool);
vtkTerrainMapperMacro(HillshadeAzimuth, double);
vtkTerrainMapperMacro(HillshadeAltitude, double);
vtkTerrainMapperMacro(SunShadows, bool);
vtkTerrainMapperMacro(SunAngle, double);
vtkTerrainMapperMacro(SkyLight, double);
vtkTerrainMapperMacro(Block, bool);
vtkTerrainMapperMacro(BlockBase, double);

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetLookupTable(vtkScalarsToColors* colors)
{
  this->LookupTable = colors;
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetOpacity(double opacity)
{
  this->Actor->GetProperty()->SetOpacity(opacity);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetAmbientColor(double red, double green, double blue)
{
  this->Actor->GetProperty()->SetAmbientColor(red, green, blue);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetDiffuseColor(double red, double green, double blue)
{
  this->Actor->GetProperty()->SetDiffuseColor(red, green, blue);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetSpecular(double specular)
{
  this->Actor->GetProperty()->SetSpecular(specular);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetSpecularPower(double power)
{
  this->Actor->GetProperty()->SetSpecularPower(power);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetTexture(vtkTexture* texture)
{
  this->Actor->SetTexture(texture);
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetPosition(double x, double y, double z)
{
  this->Actor->SetPosition(x, y, z);
  this->MarkModified();
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetScale(double x, double y, double z)
{
  this->Actor->SetScale(x, y, z);
  this->MarkModified();
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetOrientation(double x, double y, double z)
{
  this->Actor->SetOrientation(x, y, z);
  this->MarkModified();
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetOrigin(double x, double y, double z)
{
  this->Actor->SetOrigin(x, y, z);
  this->MarkModified();
}

//------------------------------------------------------------------------------
void vtkTerrainRepresentation::SetPickable(int pickable)
{
  this->Actor->SetPickable(pickable);
}
