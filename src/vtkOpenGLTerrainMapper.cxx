// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parts/OpenGLTerrainMapperInternals.h"

#include "data/ImageHeights.h"
#include "render/Driver.h"
#include "render/Uniforms.h"

#include "vtkActor.h"
#include "vtkAlgorithmOutput.h"
#include "vtkCommand.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"

vtkStandardNewMacro(vtkOpenGLTerrainMapper);

//------------------------------------------------------------------------------
vtkOpenGLTerrainMapper::vtkOpenGLTerrainMapper()
  : Look(vtkSmartPointer<vtkTerrainLook>::New())
  , Internals(new vtkInternals(this))
{
  this->SetNumberOfInputPorts(3);
  this->ScalarVisibility = 0;
  this->RemoveMesh();
  this->Look->AddObserver(
    vtkCommand::ModifiedEvent, this, &vtkOpenGLTerrainMapper::PictureModified);
}

//------------------------------------------------------------------------------
vtkOpenGLTerrainMapper::~vtkOpenGLTerrainMapper() = default;

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Look:\n";
  this->Look->PrintSelf(os, indent.GetNextIndent());
  os << indent << "WaitForTiles: " << this->WaitForTiles << "\n";
  os << indent << "HastyTolerance: " << this->HastyTolerance << "\n";
  os << indent << "HostMemoryBudget: " << this->HostMemoryBudget << "\n";
  os << indent << "CardMemoryBudget: " << this->CardMemoryBudget << "\n";
}

//------------------------------------------------------------------------------
#define vtkTerrainLookMacro(Name, Type)                                                            \
  void vtkOpenGLTerrainMapper::Set##Name(Type value)                                               \
  {                                                                                                \
    this->Look->Set##Name(value);                                                                  \
  }                                                                                                \
  Type vtkOpenGLTerrainMapper::Get##Name() const                                                   \
  {                                                                                                \
    return this->Look->Get##Name();                                                                \
  }
vtkTerrainLookMacro(Technique, vtkTerrainLook::Techniques);
vtkTerrainLookMacro(VerticalExaggeration, double);
vtkTerrainLookMacro(DetailCells, int);
vtkTerrainLookMacro(DetailScale, double);
vtkTerrainLookMacro(Steps, int);
vtkTerrainLookMacro(LongSteps, int);
vtkTerrainLookMacro(SecantSteps, int);
vtkTerrainLookMacro(StepLength, double);
vtkTerrainLookMacro(Surface, vtkTerrainLook::Surfaces);
vtkTerrainLookMacro(PixelTolerance, double);
vtkTerrainLookMacro(ShowCrossings, bool);
vtkTerrainLookMacro(MaximumShownCrossings, int);
vtkTerrainLookMacro(ComputeMode, vtkTerrainLook::ComputeModes);
vtkTerrainLookMacro(UseBeams, bool);
vtkTerrainLookMacro(ColorSource, vtkTerrainLook::ColorSources);
vtkTerrainLookMacro(Drape, vtkImageData*);
vtkTerrainLookMacro(Contours, bool);
vtkTerrainLookMacro(ContourInterval, double);
vtkTerrainLookMacro(ContourWidth, double);
vtkTerrainLookMacro(ContourIndex, int);
vtkTerrainLookMacro(Hillshade, bool);
vtkTerrainLookMacro(HillshadeAzimuth, double);
vtkTerrainLookMacro(HillshadeAltitude, double);
vtkTerrainLookMacro(Block, bool);
vtkTerrainLookMacro(BlockBase, double);
vtkTerrainLookMacro(MaximumLayers, int);
vtkTerrainLookMacro(SampleShading, bool);
vtkTerrainLookMacro(SunShadows, bool);
vtkTerrainLookMacro(SunAngle, double);
vtkTerrainLookMacro(SkyLight, double);

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::PictureModified()
{
  this->PictureTime.Modified();
  this->InvokeEvent(vtkCommand::ModifiedEvent);
}

vtkMTimeType vtkOpenGLTerrainMapper::GetLookTime()
{
  return this->PictureTime.GetMTime();
}

//------------------------------------------------------------------------------
int vtkOpenGLTerrainMapper::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetHeightsData(vtkImageData* heights)
{
  this->SetInputDataInternal(1, heights);
}

//------------------------------------------------------------------------------
vtkImageData* vtkOpenGLTerrainMapper::GetHeights()
{
  return this->GetNumberOfInputConnections(1) > 0
    ? vtkImageData::SafeDownCast(this->GetInputDataObject(1, 0))
    : nullptr;
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetDetailData(vtkImageData* detail)
{
  this->SetInputDataInternal(2, detail);
}

//------------------------------------------------------------------------------
vtkImageData* vtkOpenGLTerrainMapper::GetDetail()
{
  return this->GetNumberOfInputConnections(2) > 0
    ? vtkImageData::SafeDownCast(this->GetInputDataObject(2, 0))
    : nullptr;
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::HeightsModified(
  int firstColumn, int lastColumn, int firstRow, int lastRow)
{
  if (vtkImageData* image = this->GetHeights())
  {
    this->Internals->Scene.Surface.SetImagePart(image,
      terrain::ImageHeights::SamplesOf(image, { firstColumn, lastColumn }, { firstRow, lastRow }));
    this->PictureModified();
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::RemoveMesh()
{
  this->SetInputDataInternal(0, this->Internals->Scene.Proxy.GetBox());
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::GetHeightRange(double range[2])
{
  range[0] = 0.0;
  range[1] = -1.0;
  if (this->UpdateSurface() && this->Internals->Scene.Surface.GetCodes().HasData)
  {
    const terrain::HeightCodes& codes = this->Internals->Scene.Surface.GetCodes();
    range[0] = codes.ToHeight(0.0);
    range[1] = codes.ToHeight(codes.MaximumCode);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkOpenGLTerrainMapper::ReadCrossings()
{
  return this->Internals->Scene.Prepass.ReadCrossings();
}

//------------------------------------------------------------------------------
#define vtkTerrainCountMacro(Name, Type, Count)                                                    \
  Type vtkOpenGLTerrainMapper::Get##Name() const                                                   \
  {                                                                                                \
    return this->Internals->Count;                                                                 \
  }
vtkTerrainCountMacro(NumberOfHeightUploads, int, Scene.Surface.GetNumberOfUploads());
vtkTerrainCountMacro(NumberOfUploadedTexels, vtkIdType, Scene.Surface.GetNumberOfUploadedTexels());
vtkTerrainCountMacro(TextureMemorySize, vtkIdType, Scene.Surface.GetMemorySize());
vtkTerrainCountMacro(NumberOfTiles, int, Scene.GetNumberOfTiles());
vtkTerrainCountMacro(Complete, bool, Scene.IsComplete());
vtkTerrainCountMacro(NumberOfShadowBoundsBuilds, int, Scene.ShadowBounds.GetNumberOfBuilds());
vtkTerrainCountMacro(NumberOfShaderBuilds, int, ShaderBuilds);
vtkTerrainCountMacro(NumberOfBufferBuilds, int, BufferBuilds);

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Scene.ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
double* vtkOpenGLTerrainMapper::GetBounds()
{
  if (!this->GetInput())
  {
    vtkMath::UninitializeBounds(this->Bounds);
    return this->Bounds;
  }
  if (!this->Static)
  {
    this->GetInputAlgorithm()->Update();
  }
  this->ComputeBounds();
  return this->Bounds;
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ComputeBounds()
{
  const bool hasHeights = this->UpdateSurface(); // and the box, which may be the mesh
  this->Superclass::ComputeBounds();
  if (hasHeights && this->Internals->Scene.Surface.HasSurface())
  {
    this->Internals->Scene.GetBounds(this->Bounds);
  }
}

//------------------------------------------------------------------------------
bool vtkOpenGLTerrainMapper::HasTranslucentPolygonalGeometry()
{
  return terrain::Paint::IsTranslucent(this, this->GetHeights(), this->Look) ||
    this->Superclass::HasTranslucentPolygonalGeometry();
}

//------------------------------------------------------------------------------
// What the program that draws is built for now.
terrain::Features vtkOpenGLTerrainMapper::FindFeatures(vtkRenderer* ren, vtkActor* act)
{
  terrain::Features features;
  float factor = 0.0f;
  float offset = 0.0f;
  if (this->LastBoundBO) // else VTK does not draw yet
  {
    this->GetCoincidentParameters(ren, act, factor, offset);
  }
  features.ShiftsDepth = factor != 0.0f || offset != 0.0f;
  if (this->Internals->Scene.IsFound(act))
  {
    features.Textured = terrain::Scene::IsTextured(act);
    this->Internals->Scene.AddFeatures(features);
  }
  return features;
}

//------------------------------------------------------------------------------
// Update: the surface and its box are those of the inputs.
bool vtkOpenGLTerrainMapper::UpdateSurface()
{
  for (int port = 1; port <= 2 && !this->Static && this->GetNumberOfInputConnections(1) > 0; ++port)
  {
    if (this->GetNumberOfInputConnections(port) > 0)
    {
      this->GetInputAlgorithm(port, 0)->Update();
    }
  }
  terrain::Scene& scene = this->Internals->Scene;
  scene.WaitsForTiles = this->WaitForTiles;
  scene.LeastTolerance = this->HastyTolerance;
  scene.Surface.Tiles.SetSource(this->Tiles, static_cast<std::size_t>(this->HostMemoryBudget),
    static_cast<std::size_t>(this->CardMemoryBudget));
  return scene.Update(this->GetHeights(), this->GetDetail());
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::RenderPiece(vtkRenderer* ren, vtkActor* act)
{
  const terrain::Scene& scene = this->Internals->Scene;
  const bool casts = scene.GetTechnique().CastsRays();
  if (!this->UpdateSurface() && casts)
  {
    vtkErrorMacro("Cannot draw the terrain: " << scene.Why);
  }
  else if (!casts || scene.Surface.HasSurface())
  {
    this->Superclass::RenderPiece(ren, act);
  }
}

//------------------------------------------------------------------------------
// Prepare: the textures of the surface, how the view sees it, and the proxy.
void vtkOpenGLTerrainMapper::RenderPieceStart(vtkRenderer* ren, vtkActor* act)
{
  terrain::Scene& scene = this->Internals->Scene;
  if (scene.IsFound(act))
  {
    this->ReportWords(scene.Prepare(ren, act));
    const std::string message = scene.Surface.Tiles.TakeMessage();
    if (!message.empty())
    {
      vtkWarningMacro(<< message);
    }
  }
  if (scene.IsFound(act))
  {
    this->ReportWords(scene.PrepareBeams(ren, act, this->FindFeatures(ren, act)));
  }
  if (scene.CastsRays(act))
  {
    this->CurrentInput = scene.Proxy.GetBox();
  }
  if (scene.IsFound(act) && terrain::Scene::IsTextured(act))
  {
    this->CurrentInput = scene.Proxy.WithTextureCoordinates(this->CurrentInput);
  }
  this->Superclass::RenderPieceStart(ren, act);
  if (scene.CastsRays(act))
  {
    this->PointPicking = false; // rays find the points, too
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ReportWords(const std::string& words)
{
  if (!words.empty())
  {
    vtkErrorMacro(<< words);
  }
}

//------------------------------------------------------------------------------
// Draw: the near sides of the box where rays enter it, or its far sides around the eye: each ray is
// cast once. Culling of the surface itself is the shader's.
void vtkOpenGLTerrainMapper::RenderPieceDraw(vtkRenderer* ren, vtkActor* act)
{
  if (!this->Internals->Scene.CastsRays(act))
  {
    this->Superclass::RenderPieceDraw(ren, act);
    return;
  }
  const terrain::View& view = this->Internals->Scene.View;
  vtkOpenGLState* state = static_cast<vtkOpenGLRenderWindow*>(ren->GetRenderWindow())->GetState();
  vtkOpenGLState::ScopedglEnableDisable restoreCull(state, GL_CULL_FACE);
  state->vtkglEnable(GL_CULL_FACE);
  state->vtkglCullFace(view.IsEyeInBox() == view.KeepsOrientation() ? GL_FRONT : GL_BACK);
  // the far sides count beyond the far plane, too
  const terrain::ScopedCapability clamp(GL_DEPTH_CLAMP, view.IsEyeInBox());
  const terrain::ScopedSampleShading samples(this->GetSampleShading());
  this->DrawLayers(ren, act);
  state->vtkglCullFace(GL_BACK);
}

//------------------------------------------------------------------------------
// From the last layer to the first, so that blending has the order that it needs.
void vtkOpenGLTerrainMapper::DrawLayers(vtkRenderer* ren, vtkActor* act)
{
  terrain::Scene& scene = this->Internals->Scene;
  const bool several =
    scene.GetTechnique().IsExact() && !ren->GetSelector() && act->HasTranslucentPolygonalGeometry();
  for (int layer = (several ? this->GetMaximumLayers() : 1) - 1; layer >= 0; --layer)
  {
    this->ReportWords(scene.BeginLayer(layer, ren, act, this->FindFeatures(ren, act)));
    this->Superclass::RenderPieceDraw(ren, act);
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::RenderPieceFinish(vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::RenderPieceFinish(ren, act);
  if (this->Internals->Scene.IsFound(act))
  {
    this->Internals->Scene.Finish();
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::BuildBufferObjects(vtkRenderer* ren, vtkActor* act)
{
  ++this->Internals->BufferBuilds;
  this->Superclass::BuildBufferObjects(ren, act);
}

//------------------------------------------------------------------------------
bool vtkOpenGLTerrainMapper::GetNeedToRebuildShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  const bool rebuild = this->Superclass::GetNeedToRebuildShaders(cellBO, ren, act);
  const terrain::Features features = this->FindFeatures(ren, act);
  terrain::Features& builtFor = this->Internals->BuiltFor[&cellBO];
  const bool isOther = builtFor != features;
  builtFor = features;
  return rebuild || isOther;
}

//------------------------------------------------------------------------------
// Complete: VTK's code, the terrain's, and what a vtkShaderProperty replaces in both.
void vtkOpenGLTerrainMapper::BuildShaders(ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::BuildShaders(shaders, ren, act);
  this->ReportWords(this->Internals->Program.End(shaders));
  this->ReportWords(this->Internals->Program.Guard.Check(shaders, ren->GetRenderWindow()));
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ReplaceShaderValues(ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& internals = *this->Internals;
  ++internals.ShaderBuilds;
  internals.Program.Begin(this->FindFeatures(ren, act), shaders);
  this->Superclass::ReplaceShaderValues(shaders, ren, act);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ReplaceShaderPositionVC(
  ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  this->Internals->Program.PlaceVertices(shaders);
  this->Superclass::ReplaceShaderPositionVC(shaders, ren, act);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ReplaceShaderDepth(ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  this->Internals->Program.FindSurface(shaders);
  this->Superclass::ReplaceShaderDepth(shaders, ren, act);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ReplaceShaderColor(ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  this->Internals->Program.PaintColors(shaders);
  this->Superclass::ReplaceShaderColor(shaders, ren, act);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ReplaceShaderLight(ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  this->Internals->Program.CastShadows(shaders);
  this->Superclass::ReplaceShaderLight(shaders, ren, act);
  this->Internals->Program.AddSkyLight(shaders, act->GetProperty()->GetInterpolation() == VTK_PBR);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ReplaceShaderTCoord(ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::ReplaceShaderTCoord(shaders, ren, act);
  this->Internals->Program.FollowTextures(
    shaders, act->GetTexture() && !act->GetTexture()->GetCubeMap());
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ReplaceShaderCoincidentOffset(
  ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  if (this->Internals->Scene.IsFound(act))
  {
    this->Internals->Program.ShiftDepth(shaders);
    return;
  }
  this->Superclass::ReplaceShaderCoincidentOffset(shaders, ren, act);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ReplaceShaderNormal(ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  if (this->Internals->Scene.IsFound(act))
  {
    this->Internals->Program.ReplaceNormal(shaders,
      act->GetProperty()->GetInterpolation() == VTK_PBR &&
        act->GetProperty()->GetCoatStrength() > 0.0);
    return;
  }
  this->Superclass::ReplaceShaderNormal(shaders, ren, act);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ReplaceShaderClip(ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  if (this->Internals->Scene.IsFound(act))
  {
    this->Internals->Program.ClipMesh(shaders);
    return;
  }
  this->Superclass::ReplaceShaderClip(shaders, ren, act);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ReplaceShaderPicking(
  ShaderMap shaders, vtkRenderer* ren, vtkActor* act)
{
  const int pass = this->LastSelectionState;
  const bool high =
    pass == vtkHardwareSelector::CELL_ID_HIGH24 || pass == vtkHardwareSelector::POINT_ID_HIGH24;
  const bool cells =
    pass == vtkHardwareSelector::CELL_ID_LOW24 || pass == vtkHardwareSelector::CELL_ID_HIGH24;
  const bool points =
    pass == vtkHardwareSelector::POINT_ID_LOW24 || pass == vtkHardwareSelector::POINT_ID_HIGH24;
  if (this->Internals->Scene.CastsRays(act) && (cells || points))
  {
    this->Internals->Program.ReplaceIds(shaders, cells, high);
  }
  this->Superclass::ReplaceShaderPicking(shaders, ren, act);
}

//------------------------------------------------------------------------------
// The edges of a proxy are not the surface's.
bool vtkOpenGLTerrainMapper::DrawingEdges(vtkRenderer* ren, vtkActor* act)
{
  return !this->Internals->Scene.CastsRays(act) && this->Superclass::DrawingEdges(ren, act);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::UpdateMaximumPointCellIds(vtkRenderer* ren, vtkActor* act)
{
  if (!this->Internals->Scene.CastsRays(act))
  {
    this->Superclass::UpdateMaximumPointCellIds(ren, act);
    return;
  }
  const int* size = this->GetHeights()->GetDimensions();
  ren->GetSelector()->UpdateMaximumPointId(vtkIdType{ size[0] } * size[1] - 1);
  ren->GetSelector()->UpdateMaximumCellId(vtkIdType{ size[0] - 1 } * (size[1] - 1) - 1);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ProcessSelectorPixelBuffers(
  vtkHardwareSelector* selector, std::vector<unsigned int>& offsets, vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!actor || !this->Internals->Scene.CastsRays(actor))
  {
    this->Superclass::ProcessSelectorPixelBuffers(selector, offsets, prop);
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetCameraShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::SetCameraShaderParameters(cellBO, ren, act);
  terrain::ProgramUniforms uniforms(cellBO.Program);
  this->Internals->Scene.ExaggerateVertices(uniforms, ren, act, this->VBOs);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::SetMapperShaderParameters(cellBO, ren, act);
  if (this->Internals->Scene.IsFound(act))
  {
    terrain::ProgramUniforms uniforms(cellBO.Program);
    this->Internals->Scene.SetUniforms(uniforms, act);
  }
}
