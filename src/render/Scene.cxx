// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/Scene.h"

#include "core/surface/DetailHeights.h"
#include "render/Driver.h"
#include "render/Uniforms.h"
#include "vtkTerrainLook.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

namespace terrain
{
//------------------------------------------------------------------------------
bool Scene::IsFound(vtkActor* actor) const
{
  // Lines and points of a mesh that is drawn itself have the colours of the surface below them.
  return this->Why.empty() && this->Surface.HasSurface() &&
    (actor->GetProperty()->GetRepresentation() == VTK_SURFACE || !this->GetTechnique().CastsRays());
}

//------------------------------------------------------------------------------
bool Scene::CastsRays(vtkActor* actor) const
{
  return this->GetTechnique().CastsRays() && this->Why.empty() &&
    actor->GetProperty()->GetRepresentation() == VTK_SURFACE;
}

//------------------------------------------------------------------------------
bool Scene::CastsShadows(vtkActor* actor) const
{
  return this->Look->GetSunShadows() && this->IsFound(actor) && actor->GetProperty()->GetLighting();
}

//------------------------------------------------------------------------------
bool Scene::HasSkyLight(vtkActor* actor) const
{
  return this->Look->GetSkyLight() > 0.0 && this->IsFound(actor) &&
    actor->GetProperty()->GetLighting();
}

//------------------------------------------------------------------------------
GridGeometry Scene::Geometry() const
{
  GridGeometry geometry = this->Surface.GetGeometry();
  geometry.Exaggeration = this->Look->GetVerticalExaggeration();
  return geometry;
}

//------------------------------------------------------------------------------
SampleRectangle Scene::Drawn() const
{
  return this->Cutting.Drawn(
    this->Surface.GetSize(), this->Surface.HasDetail() ? this->Look->GetDetailCells() : 1);
}

//------------------------------------------------------------------------------
bool Scene::Update(vtkImageData* heights, vtkImageData* detail)
{
  this->Cutting.Block = this->Look->GetBlock();
  this->Cutting.BlockBase = this->Look->GetBlockBase();
  this->Why = this->Surface.SetImage(heights);
  this->Surface.SetUseTiles(this->GetTechnique().IsExact() && !detail &&
    this->Look->GetSurface() != vtkTerrainLook::Surfaces::Columns);
  if (this->Why.empty())
  {
    this->Why = this->Surface.SetDetail(
      detail, LevelOfCells(this->Look->GetDetailCells()), this->Look->GetDetailScale());
  }
  if (this->Why.empty())
  {
    this->Why = this->UpdateGlobe(heights, detail);
  }
  if (!this->Why.empty())
  {
    this->Proxy.Clear();
    return false;
  }
  const HeightCodes& codes = this->Surface.GetCodes();
  if (this->Globe.IsRound())
  {
    this->Globe.SetHeights(codes, this->Look->GetVerticalExaggeration());
    this->Proxy.Update(this->Globe.GetBounds());
    return true;
  }
  this->Proxy.Update(this->Surface.GetGeometry(), codes, this->Surface.GetSize(),
    this->Cutting.Lowest(codes.ToHeight(0.0)));
  return true;
}

//------------------------------------------------------------------------------
std::string Scene::UpdateGlobe(vtkImageData* heights, vtkImageData* detail)
{
  std::string why = this->Globe.SetImage(heights);
  if (!this->Globe.IsRound() || !why.empty())
  {
    return why;
  }
  const bool plain = this->GetTechnique().IsExact() && !detail && !this->Surface.HasTiles() &&
    !this->Cutting.Extracts && !this->Cutting.Block && this->Look->GetSkyLight() <= 0.0 &&
    this->Look->GetSurface() != vtkTerrainLook::Surfaces::Columns;
  return plain ? std::string()
               : "a globe is drawn with the technique Pyramid from heights in memory, without "
                 "detail, columns, block, extract and the light of the sky: leave these out, or "
                 "choose a flat frame";
}

//------------------------------------------------------------------------------
void Scene::GetBounds(double bounds[6]) const
{
  if (this->Globe.IsRound())
  {
    const BoxGC box = this->Globe.GetBounds();
    vtkBoundingBox(box[0].x, box[1].x, box[0].y, box[1].y, box[0].z, box[1].z).GetBounds(bounds);
    return;
  }
  const GridGeometry geometry = this->Geometry();
  const HeightCodes& codes = this->Surface.GetCodes();
  const SampleRectangle drawn = this->Drawn();
  const glm::dvec3 low = geometry.ToModel(drawn.First, this->Cutting.Lowest(codes.ToHeight(0.0)));
  const glm::dvec3 high = geometry.ToModel(drawn.Last, codes.ToHeight(codes.MaximumCode));
  vtkBoundingBox box;
  box.AddPoint(low.x, low.y, low.z);
  box.AddPoint(high.x, high.y, high.z);
  box.GetBounds(bounds);
}

//------------------------------------------------------------------------------
std::string Scene::Prepare(vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  this->Why = this->Surface.Upload(window, this->CastsRays(actor) || this->CastsShadows(actor));
  if (!this->Why.empty())
  {
    return "Cannot draw the terrain: " + this->Why;
  }
  std::string words =
    this->Surface.Colors.Update(this->Mapper, this->Surface.GetImage(), this->Look, window);
  const HeightCodes& codes = this->Surface.GetCodes();
  if (this->Globe.IsRound() && !this->Globe.Update(renderer, actor))
  {
    this->Why = "the lines of the globe's grid could not be sent to the graphics card";
    return "Cannot draw the terrain: " + this->Why;
  }
  this->View.Update(renderer, actor,
    this->Globe.IsRound() ? this->Globe.ModelFromAnchor() : ModelFromGrid(this->Geometry(), codes),
    this->Globe.IsRound() ? this->Globe.GetAnchoredBounds() : this->Proxy.GetBounds());
  this->View.SetClippingPlanes(this->Mapper, actor,
    this->Cutting.PlanesGC(this->Drawn(), codes.ToCode(this->Cutting.BlockBase)));
  this->Lights.Clear();
  const bool lit = !renderer->GetSelector(); // else colours are numbers of what is seen
  if (lit && this->CastsShadows(actor))
  {
    const std::string lights =
      this->Lights.Update(renderer, this->View, this->Look->GetSunAngle(), this->Globe.IsRound());
    words = words.empty() ? lights : words;
  }
  this->BoundsShadows = this->UploadShadowBounds(window);
  this->SkyShines = lit && this->HasSkyLight(actor);
  if (this->SkyShines &&
    !this->Sky.Upload(window, this->Surface.GetImage(), this->Look->GetVerticalExaggeration()))
  {
    this->Why = "the light of the sky takes more memory than there is";
    return "Cannot draw the terrain: " + this->Why;
  }
  if (this->Surface.HasTiles())
  {
    this->Why = this->Surface.Tiles.Update(
      window, this->View.GetTileView(this->GetPixelTolerance()), this->WaitsForTiles);
    if (!this->Why.empty())
    {
      return "Cannot draw the terrain: " + this->Why;
    }
  }
  this->Surface.Activate();
  this->Sky.Activate();
  this->ShadowBounds.Activate();
  this->Globe.Activate();
  const int planes = this->Mapper->GetNumberOfClippingPlanes();
  return !words.empty() || planes <= View::MostMapperPlanes
    ? words
    : "At most " + std::to_string(View::MostMapperPlanes) +
      " clipping planes cut the terrain, not " + std::to_string(planes);
}

//------------------------------------------------------------------------------
// Bounds are no more than a help: where they fail, rays go all their way.
bool Scene::UploadShadowBounds(vtkOpenGLRenderWindow* window)
{
  if (!this->Lights.HasSteadySun() || this->Surface.HasTiles() || this->Surface.HasDetail() ||
    this->Surface.GetPyramidTop() < 1)
  {
    return false;
  }
  const bool complete = this->Mapper->GetNumberOfClippingPlanes() == 0 && !this->Cutting.Cuts();
  const ShadowRays& rays = this->Lights.GetSteadyRays();
  return this->ShadowBounds.Upload(window,
    { rays, complete, this->Surface.GetPyramidTime(), this->Surface.GetCodes().Scale },
    [&] { return this->Surface.MakeShadowBounds(rays, complete); });
}

//------------------------------------------------------------------------------
// All tiles in full would be needed for none.
double Scene::GetPixelTolerance() const
{
  constexpr double kOfTiles = 0.5;
  const double tolerance = std::max(this->Look->GetPixelTolerance(), this->LeastTolerance);
  return this->Surface.HasTiles() && tolerance <= 0.0 ? kOfTiles : tolerance;
}

//------------------------------------------------------------------------------
PrepassFrame Scene::MakeFrame(vtkRenderer* renderer, vtkActor* actor, const Features& features)
{
  PrepassFrame frame;
  frame.Window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  frame.Size = this->View.GetSize();
  frame.Features = features;
  frame.SetUniforms = [this, actor](Uniforms& uniforms) { this->SetUniforms(uniforms, actor); };
  return frame;
}

//------------------------------------------------------------------------------
std::string Scene::PrepareBeams(vtkRenderer* renderer, vtkActor* actor, const Features& features)
{
  const bool uses = this->Look->GetUseBeams() && features.CastsRays() && !features.Columns &&
    !features.Globe && !features.Block && // walls may lie before the start
    ComputeProgram::IsSupported();
  return uses ? this->Prepass.ComputeBeams(this->MakeFrame(renderer, actor, features))
              : std::string();
}

//------------------------------------------------------------------------------
std::string Scene::BeginLayer(
  int layer, vtkRenderer* renderer, vtkActor* actor, const Features& features)
{
  this->Layer = layer;
  this->Prepass.ForgetLayer();
  const vtkTerrainLook::ComputeModes mode = this->Look->GetComputeMode();
  const bool uses = features.CastsRays() && mode != vtkTerrainLook::ComputeModes::Off &&
    (mode == vtkTerrainLook::ComputeModes::On || Driver::Current().ComputesSightings) &&
    !this->Look->GetSampleShading() && // sightings are one a pixel
    ComputeProgram::IsSupported();
  if (!uses)
  {
    return {};
  }
  const PrepassFrame frame = this->MakeFrame(renderer, actor, features);
  const std::string words = this->Prepass.ComputeSightings(frame);
  // a globe's are looked for by each pixel
  return words.empty() && features.ShadowMask != 0 && !features.Globe
    ? this->Prepass.ComputeLights(frame)
    : words;
}

//------------------------------------------------------------------------------
void Scene::Finish()
{
  this->Surface.Deactivate();
  this->Sky.Deactivate();
  this->ShadowBounds.Deactivate();
  this->Globe.Deactivate();
  this->Prepass.Finish();
}

//------------------------------------------------------------------------------
bool Scene::IsTextured(vtkActor* actor)
{
  return actor->GetTexture() || !actor->GetProperty()->GetAllTextures().empty();
}

//------------------------------------------------------------------------------
void Scene::AddFeatures(Features& features) const
{
  const Technique technique = this->GetTechnique();
  features.Way = technique.GetWay();
  features.Gathers = Driver::Current().Gathers;
  features.Block = this->Look->GetBlock();
  // planes that cut the surface are a tenth of a frame on processors that run both sides of a
  // branch
  const bool cuts = this->Mapper->GetNumberOfClippingPlanes() > 0 || this->Cutting.Cuts();
  features.ClipPlanes = cuts ? kMaximumClipPlanes : 0;
  this->Surface.AddFeatures(features);
  if (technique.CastsRays())
  {
    features.BelowBox = !this->View.IsEyeInBox();
    features.PassesUniforms = Driver::Current().PassesUniforms; // a box has few vertices
    this->Prepass.AddFeatures(features);
  }
  features.ShadowMask = this->Lights.GetMask();
  features.Sky = this->SkyShines;
  features.BoundsShadows = this->BoundsShadows;
  if (technique.IsExact())
  {
    features.Columns = this->Look->GetSurface() == vtkTerrainLook::Surfaces::Columns;
    features.Globe = this->Globe.IsRound();
    features.Within = this->GetPixelTolerance() > 0.0 && !features.Globe; // exact is near enough
  }
}

//------------------------------------------------------------------------------
void Scene::SetUniforms(Uniforms& uniforms, vtkActor* actor)
{
  const GridGeometry geometry = this->Geometry();
  this->Surface.SetUniforms(uniforms, geometry, this->Look);
  this->View.SetUniforms(uniforms);
  this->Lights.SetUniforms(uniforms);
  this->Sky.SetUniforms(uniforms);
  this->ShadowBounds.SetUniforms(uniforms);
  uniforms.Set("terrainSkyLight", static_cast<float>(this->Look->GetSkyLight()));
  if (this->Globe.IsRound())
  {
    this->Globe.SetUniforms(uniforms);
  }
  this->View.SetTolerance(uniforms, this->GetPixelTolerance());
  this->GetTechnique().SetSearchUniforms(uniforms, this->Look, this->Surface, geometry);
  this->Prepass.SetUniforms(uniforms, this->Surface);
  vtkProperty* property = actor->GetProperty();
  uniforms.Set("terrainLayer", this->Layer);
  // the planet below a globe's heights is not to be seen through
  const bool isOpaque = this->Globe.IsRound() || property->GetBackfaceCulling();
  uniforms.Set("terrainCulled", glm::ivec2(property->GetFrontfaceCulling(), isOpaque ? 1 : 0));
  uniforms.Set("terrainFlat", property->GetInterpolation() == VTK_FLAT ? 1 : 0);
}

//------------------------------------------------------------------------------
// In double precision: the heights that are drawn may be far larger than those in the buffer.
void Scene::ExaggerateVertices(Uniforms& uniforms, vtkRenderer* renderer, vtkActor* actor,
  vtkOpenGLVertexBufferObjectGroup* buffers) const
{
  if (this->Why.empty() && !this->Globe.IsRound() && this->Look->GetVerticalExaggeration() != 1.0)
  {
    const CameraMatrices camera(renderer);
    const glm::dmat4 viewFromBuffer = camera.ViewFromWorld * ToGlm(actor->GetMatrix()) *
      this->Geometry().TrueToDrawn() * ModelFromBuffer(buffers);
    uniforms.Set("MCVCMatrix", glm::mat4(viewFromBuffer));
    uniforms.Set("MCDCMatrix", glm::mat4(camera.DisplayFromView * viewFromBuffer));
  }
}

//------------------------------------------------------------------------------
void Scene::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Surface.ReleaseGraphicsResources(window);
  this->Sky.ReleaseGraphicsResources(window);
  this->ShadowBounds.ReleaseGraphicsResources(window);
  this->Globe.ReleaseGraphicsResources(window);
  this->Prepass.ReleaseGraphicsResources(window);
}
}
