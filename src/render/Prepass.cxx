// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/Prepass.h"

#include "core/rays/Sighting.h"
#include "render/SurfaceTextures.h"
#include "render/Technique.h"
#include "render/Uniforms.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>

namespace terrain
{
namespace
{
/// Level of the pyramid in which rays begin at the start of a beam, which lies near the surface.
constexpr int kBeamLevel = 2;

/// Those of a program's features that concern how heights are read, and no more.
Features OfHeights(const Features& program)
{
  Features features;
  features.Way = Features::Ways::Pyramid;
  features.IntegerHeights = program.IntegerHeights;
  features.BuffersPyramid = program.BuffersPyramid;
  features.Gathers = program.Gathers;
  features.Tiles = program.Tiles;
  features.Detail = program.Detail;
  return features;
}
}

//------------------------------------------------------------------------------
std::string Prepass::ComputeBeams(const PrepassFrame& frame)
{
  Features features = OfHeights(frame.Features);
  features.BeamPixels = kBeamPixels;
  return this->BeamStarts.Fill(
    frame.Window, features, [&] { return Technique::BeamSource(features); },
    (frame.Size + kBeamPixels - 1) / kBeamPixels, 1, frame.SetUniforms);
}

//------------------------------------------------------------------------------
std::string Prepass::ComputeSightings(const PrepassFrame& frame)
{
  Features features = OfHeights(frame.Features);
  features.Way = frame.Features.Way;
  features.Globe = frame.Features.Globe;
  features.Columns = frame.Features.Columns;
  features.Within = frame.Features.Within;
  features.Block = frame.Features.Block;
  features.ClipPlanes = frame.Features.ClipPlanes;
  features.BeamPixels = frame.Features.BeamPixels;
  return this->Sightings.Fill(
    frame.Window, features, [&] { return Technique::SightingSource(features); }, frame.Size, 4,
    frame.SetUniforms);
}

//------------------------------------------------------------------------------
std::string Prepass::ComputeLights(const PrepassFrame& frame)
{
  Features features = OfHeights(frame.Features);
  features.Columns = frame.Features.Columns;
  features.ClipPlanes = frame.Features.ClipPlanes;
  features.ShadowMask = frame.Features.ShadowMask;
  features.BoundsShadows = frame.Features.BoundsShadows;
  features.ReadsSightings = true;
  return this->LightShares.Fill(
    frame.Window, features, [&] { return Technique::LightSource(features); }, frame.Size, 4,
    frame.SetUniforms);
}

//------------------------------------------------------------------------------
void Prepass::ForgetLayer()
{
  this->LightShares.Finish();
  this->Sightings.Finish();
  this->Sightings.Forget();
}

//------------------------------------------------------------------------------
void Prepass::Finish()
{
  this->BeamStarts.Finish();
  this->Sightings.Finish();
  this->LightShares.Finish();
}

//------------------------------------------------------------------------------
void Prepass::AddFeatures(Features& features) const
{
  features.BeamPixels = this->BeamStarts.IsFilled() ? kBeamPixels : 0;
  features.ReadsSightings = this->Sightings.IsFilled();
  features.ReadsLights = this->LightShares.IsFilled();
}

//------------------------------------------------------------------------------
void Prepass::SetUniforms(Uniforms& uniforms, const SurfaceTextures& surface)
{
  if (uniforms.Uses("terrainBeamStarts"))
  {
    uniforms.Set("terrainBeamStarts", this->BeamStarts.GetTextureUnit());
    // with detail, beams stop farther off, counted in its cells: half of its levels higher
    uniforms.Set("terrainPyramidStart",
      std::min(surface.GetPyramidTop(), kBeamLevel) + surface.GetDetailLevel() / 2);
  }
  if (uniforms.Uses("terrainLightShares"))
  {
    uniforms.Set("terrainLightShares", this->LightShares.GetTextureUnit());
  }
  if (uniforms.Uses("terrainSightings"))
  {
    uniforms.Set("terrainSightings", this->Sightings.GetTextureUnit());
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Prepass::ReadCrossings()
{
  const glm::ivec2 size = this->Sightings.GetSize();
  const std::vector<glm::vec4> texels = this->Sightings.Read();
  if (texels.empty())
  {
    return nullptr;
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size.x, size.y, 1);
  image->AllocateScalars(VTK_INT, 1);
  auto* crossings = static_cast<int*>(image->GetScalarPointer());
  for (const glm::vec4& texel : texels)
  {
    *crossings++ = UnpackCrossings(texel);
  }
  return image;
}

//------------------------------------------------------------------------------
void Prepass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->BeamStarts.ReleaseGraphicsResources(window);
  this->Sightings.ReleaseGraphicsResources(window);
  this->LightShares.ReleaseGraphicsResources(window);
}
}
