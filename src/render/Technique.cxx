// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/Technique.h"

#include "core/rays/HeightSearch.h"
#include "render/SurfaceTextures.h"
#include "render/Uniforms.h"

#include "vtkTerrainBeam.h"
#include "vtkTerrainBeamCS.h"
#include "vtkTerrainCast.h"
#include "vtkTerrainColor.h"
#include "vtkTerrainColumns.h"
#include "vtkTerrainGlobeLines.h"
#include "vtkTerrainGlobeTrace.h"
#include "vtkTerrainGradient.h"
#include "vtkTerrainHeights.h"
#include "vtkTerrainLight.h"
#include "vtkTerrainLightCS.h"
#include "vtkTerrainOutlook.h"
#include "vtkTerrainPyramid.h"
#include "vtkTerrainRay.h"
#include "vtkTerrainSearch.h"
#include "vtkTerrainSighting.h"
#include "vtkTerrainSightingCS.h"
#include "vtkTerrainSky.h"
#include "vtkTerrainSurface.h"
#include "vtkTerrainTileTrace.h"
#include "vtkTerrainTiles.h"
#include "vtkTerrainTrace.h"
#include "vtkTerrainView.h"

namespace terrain
{
namespace
{
Features::Ways WayOf(vtkTerrainLook::Techniques technique)
{
  switch (technique)
  {
    case vtkTerrainLook::Techniques::Linear:
      return Features::Ways::Linear;
    case vtkTerrainLook::Techniques::Exponential:
      return Features::Ways::Exponential;
    case vtkTerrainLook::Techniques::Equidistant:
      return Features::Ways::Equidistant;
    case vtkTerrainLook::Techniques::Pyramid:
      return Features::Ways::Pyramid;
    default:
      return Features::Ways::Mesh; // strips, too
  }
}

SearchKind KindOf(Features::Ways way)
{
  switch (way)
  {
    case Features::Ways::Linear:
      return SearchKind::Linear;
    case Features::Ways::Exponential:
      return SearchKind::Exponential;
    default:
      return SearchKind::Equidistant;
  }
}

/// What all programs begin with, after their defines.
std::string CommonFunctions(const Features& features)
{
  return Features::Constants() + (features.Tiles ? vtkTerrainTiles : "") + vtkTerrainHeights +
    vtkTerrainColumns + vtkTerrainRay + vtkTerrainView +
    (features.Globe ? vtkTerrainGlobeLines : "");
}

std::string PyramidFunctions(const Features& features)
{
  return std::string(vtkTerrainPyramid) + (features.Tiles ? vtkTerrainTileTrace : "") +
    (features.Globe ? vtkTerrainGlobeTrace : "");
}

std::string CastFunctions(const Features& features)
{
  return PyramidFunctions(features) +
    (features.Way == Features::Ways::Pyramid ? "" : vtkTerrainSearch) + vtkTerrainTrace +
    vtkTerrainSighting + vtkTerrainCast;
}
}

//------------------------------------------------------------------------------
Technique::Technique(vtkTerrainLook::Techniques technique)
  : Way(WayOf(technique))
{
}

//------------------------------------------------------------------------------
std::string Technique::FragmentFunctions(const Features& features)
{
  std::string functions = CommonFunctions(features);
  if (features.CastsRays())
  {
    functions += features.ReadsSightings ? vtkTerrainSighting : CastFunctions(features);
  }
  functions += std::string(vtkTerrainGradient) + vtkTerrainSurface + vtkTerrainColor;
  const bool looks = features.ShadowMask != 0 && !features.ReadsLights;
  const bool hasPyramid = features.CastsRays() && !features.ReadsSightings;
  functions += looks && !hasPyramid ? PyramidFunctions(features) : "";
  functions += looks && !features.Globe ? vtkTerrainOutlook : "";
  functions += features.ShadowMask != 0 ? vtkTerrainLight : "";
  return functions + (features.Sky ? vtkTerrainSky : "");
}

//------------------------------------------------------------------------------
std::string Technique::BeamSource(const Features& features)
{
  return features.Defines() + CommonFunctions(features) + vtkTerrainPyramid + vtkTerrainBeam +
    vtkTerrainBeamCS;
}

//------------------------------------------------------------------------------
std::string Technique::SightingSource(const Features& features)
{
  return features.Defines() + CommonFunctions(features) + CastFunctions(features) +
    vtkTerrainSightingCS;
}

//------------------------------------------------------------------------------
std::string Technique::LightSource(const Features& features)
{
  return features.Defines() + CommonFunctions(features) + PyramidFunctions(features) +
    vtkTerrainSighting + vtkTerrainGradient + vtkTerrainSurface + vtkTerrainOutlook +
    vtkTerrainLight + vtkTerrainLightCS;
}

//------------------------------------------------------------------------------
void Technique::SetSearchUniforms(Uniforms& uniforms, const vtkTerrainLook* look,
  const SurfaceTextures& surface, const GridGeometry& geometry) const
{
  if (!uniforms.Uses("terrainSecantSteps"))
  {
    return;
  }
  const HeightCodes& codes = surface.GetCodes();
  SearchScene scene;
  scene.Width = surface.GetSize().x;
  scene.Height = surface.GetSize().y;
  scene.MaximumCode = codes.MaximumCode;
  scene.CodesPerCell = geometry.HeightOfCellSide() / codes.Scale;

  const SearchKind kind = KindOf(this->Way);
  SearchParameters search = ChooseSearchParameters(scene, kind);
  search.Steps = look->GetSteps() > 0 ? look->GetSteps() : search.Steps;
  search.LongSteps = look->GetLongSteps() > 0 ? look->GetLongSteps() : search.LongSteps;
  search.SecantSteps = look->GetSecantSteps() > 0 ? look->GetSecantSteps() : search.SecantSteps;
  search.StepLength =
    look->GetStepLength() > 0.0 ? static_cast<float>(look->GetStepLength()) : search.StepLength;
  search = BoundSearchParameters(search, kind);
  uniforms.Set("terrainSteps", search.Steps);
  uniforms.Set("terrainLongSteps", search.LongSteps);
  uniforms.Set("terrainSecantSteps", search.SecantSteps);
  uniforms.Set("terrainStepLength", search.StepLength);
  uniforms.Set("terrainStepRelief", search.StepRelief);
  uniforms.Set("terrainStepLevel", search.StepLevel());
}
}
