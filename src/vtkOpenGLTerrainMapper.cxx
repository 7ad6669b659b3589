// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenGLTerrainMapper.h"

#include "render/Driver.h"
#include "render/Uniforms.h"
#include "vtkTerrainMapperInternals.h"

#include "core/surface/DetailHeights.h"

#include "vtkActor.h"
#include "vtkAlgorithmOutput.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPoints.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>

vtkStandardNewMacro(vtkOpenGLTerrainMapper);

namespace
{
glm::dmat4 toGlm(vtkMatrix4x4* matrix)
{
  glm::dmat4 result;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      result[column][row] = matrix->GetElement(row, column);
    }
  }
  return result;
}

/// A matrix of the camera's, which VTK keeps transposed, for OpenGL.
glm::dmat4 cameraMatrix(vtkMatrix4x4* matrix)
{
  return glm::transpose(toGlm(matrix));
}

/// Matrix from the coordinates of a vertex buffer, which VTK may shift and scale, to model
/// coordinates.
glm::dmat4 modelFromBuffer(vtkOpenGLVertexBufferObject* vertices)
{
  glm::dmat4 matrix(1.0);
  if (vertices && vertices->GetCoordShiftAndScaleEnabled())
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      matrix[axis][axis] = 1.0 / vertices->GetScale()[axis];
      matrix[3][axis] = vertices->GetShift()[axis];
    }
  }
  return matrix;
}

/// World to view coordinates, and these to display coordinates.
struct ViewMatrices
{
  glm::dmat4 ViewFromWorld;
  glm::dmat4 DisplayFromView;

  explicit ViewMatrices(vtkRenderer* ren)
  {
    vtkMatrix4x4* worldToView = nullptr;
    vtkMatrix4x4* viewToDisplay = nullptr;
    vtkMatrix4x4* worldToDisplay = nullptr;
    vtkMatrix3x3* normals = nullptr;
    static_cast<vtkOpenGLCamera*>(ren->GetActiveCamera())
      ->GetKeyMatrices(ren, worldToView, normals, viewToDisplay, worldToDisplay);
    this->ViewFromWorld = cameraMatrix(worldToView);
    this->DisplayFromView = cameraMatrix(viewToDisplay);
  }
};

/// Matrix from grid to model coordinates; z of grid coordinates are height codes.
glm::dmat4 gridToModel(
  const terrain::GridGeometry& geometry, const terrain::HeightCodes& codes, double exaggeration)
{
  glm::dmat4 matrix(1.0);
  matrix[0][0] = geometry.Spacing.x;
  matrix[1][1] = geometry.Spacing.y;
  matrix[2][2] = exaggeration * codes.Scale;
  matrix[3] = glm::dvec4(
    geometry.Origin.x, geometry.Origin.y, geometry.Origin.z + exaggeration * codes.Offset, 1.0);
  return matrix;
}
}

//------------------------------------------------------------------------------
vtkOpenGLTerrainMapper::vtkOpenGLTerrainMapper()
  : Internals(new vtkInternals)
{
  this->SetNumberOfInputPorts(3);
  this->ScalarVisibility = 0;
  this->RemoveMesh();
}

//------------------------------------------------------------------------------
vtkOpenGLTerrainMapper::~vtkOpenGLTerrainMapper() = default;

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Technique: " << static_cast<int>(this->Technique) << "\n";
  os << indent << "VerticalExaggeration: " << this->VerticalExaggeration << "\n";
  os << indent << "Steps: " << this->Steps << "\n";
  os << indent << "LongSteps: " << this->LongSteps << "\n";
  os << indent << "SecantSteps: " << this->SecantSteps << "\n";
  os << indent << "StepLength: " << this->StepLength << "\n";
  os << indent << "Surface: " << static_cast<int>(this->Surface) << "\n";
  os << indent << "PixelTolerance: " << this->PixelTolerance << "\n";
  os << indent << "ComputeMode: " << static_cast<int>(this->ComputeMode) << "\n";
  os << indent << "UseBeams: " << this->UseBeams << "\n";
  os << indent << "DetailCells: " << this->DetailCells << "\n";
  os << indent << "DetailScale: " << this->DetailScale << "\n";
  const terrain::Coloring& coloring = this->Internals->Coloring;
  os << indent << "ShowCrossings: " << coloring.ShowCrossings << "\n";
  os << indent << "MaximumShownCrossings: " << coloring.MaximumShownCrossings << "\n";
  os << indent << "ColorSource: " << static_cast<int>(coloring.Source) << "\n";
  os << indent << "Drape: " << coloring.Drape << "\n";
  os << indent << "Contours: " << coloring.Contours << "\n";
  os << indent << "ContourInterval: " << coloring.ContourInterval << "\n";
  os << indent << "ContourWidth: " << coloring.ContourWidth << "\n";
  os << indent << "Hillshade: " << coloring.Hillshade << "\n";
  os << indent << "HillshadeAzimuth: " << coloring.HillshadeAzimuth << "\n";
  os << indent << "HillshadeAltitude: " << coloring.HillshadeAltitude << "\n";
  os << indent << "Block: " << this->Internals->Cutting.Block << "\n";
  os << indent << "BlockBase: " << this->Internals->Cutting.BlockBase << "\n";
  os << indent << "MaximumLayers: " << this->Internals->MaximumLayers << "\n";
  os << indent << "SampleShading: " << this->Internals->SampleShading << "\n";
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
void vtkOpenGLTerrainMapper::SetTechnique(Techniques technique)
{
  if (this->Technique != technique)
  {
    this->Technique = technique;
    this->UniformModified(); // the shader is rebuilt for its defines
  }
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
void vtkOpenGLTerrainMapper::HeightsModified(
  int firstColumn, int lastColumn, int firstRow, int lastRow)
{
  vtkImageData* image = this->GetHeights();
  if (image)
  {
    const int* extent = image->GetExtent();
    this->Internals->Heights.SetImagePart(image,
      { { firstColumn - extent[0], firstRow - extent[2] },
        { lastColumn - extent[0] + 1, lastRow - extent[2] + 1 } });
    this->UniformModified();
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::RemoveMesh()
{
  this->SetInputDataInternal(0, this->Internals->Box);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::GetHeightRange(double range[2])
{
  range[0] = 0.0;
  range[1] = -1.0;
  if (this->UpdateHeights() && this->Internals->Heights.GetCodes().HasData)
  {
    const terrain::HeightCodes& codes = this->Internals->Heights.GetCodes();
    range[0] = codes.ToHeight(0.0);
    range[1] = codes.ToHeight(codes.MaximumCode);
  }
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
void vtkOpenGLTerrainMapper::SetDetailCells(int cells)
{
  if (cells < 1 || cells > MostDetailCells || (cells & (cells - 1)) != 0)
  {
    vtkErrorMacro("The detail cells along a cell of the heights must be a power of two from 1 to "
      << MostDetailCells << ", not " << cells);
    return;
  }
  if (this->DetailCells != cells)
  {
    this->DetailCells = cells;
    this->UniformModified();
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::SetVerticalExaggeration(double exaggeration)
{
  if (!(exaggeration > 0.0) || !std::isfinite(exaggeration))
  {
    vtkErrorMacro("The vertical exaggeration must be above 0, not " << exaggeration);
    return;
  }
  if (this->VerticalExaggeration != exaggeration)
  {
    this->VerticalExaggeration = exaggeration;
    this->UniformModified();
  }
}

#define vtkTerrainSetUniformMacro(Name, Type, Minimum)                                             \
  void vtkOpenGLTerrainMapper::Set##Name(Type value)                                               \
  {                                                                                                \
    const Type valid = std::max<Type>(value, Minimum);                                             \
    if (this->Name != valid)                                                                       \
    {                                                                                              \
      this->Name = valid;                                                                          \
      this->UniformModified();                                                                     \
    }                                                                                              \
  }

vtkTerrainSetUniformMacro(Steps, int, 0);
vtkTerrainSetUniformMacro(LongSteps, int, 0);
vtkTerrainSetUniformMacro(SecantSteps, int, 0);
vtkTerrainSetUniformMacro(StepLength, double, 0.0);
vtkTerrainSetUniformMacro(DetailScale, double, 0.0);
vtkTerrainSetUniformMacro(
  Surface, vtkOpenGLTerrainMapper::Surfaces, vtkOpenGLTerrainMapper::Surfaces::Bilinear);
vtkTerrainSetUniformMacro(PixelTolerance, double, 0.0);
vtkTerrainSetUniformMacro(
  ComputeMode, vtkOpenGLTerrainMapper::ComputeModes, ComputeModes::Automatic);
vtkTerrainSetUniformMacro(UseBeams, bool, false);

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::UniformModified()
{
  this->UniformTime.Modified();
  this->InvokeEvent(vtkCommand::ModifiedEvent);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkOpenGLTerrainMapper::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->IgnoresUniformTime ? time : std::max(time, this->UniformTime.GetMTime());
}

//------------------------------------------------------------------------------
int vtkOpenGLTerrainMapper::GetNumberOfHeightUploads() const
{
  return this->Internals->Heights.GetNumberOfUploads();
}

//------------------------------------------------------------------------------
vtkIdType vtkOpenGLTerrainMapper::GetNumberOfUploadedTexels() const
{
  return this->Internals->Heights.GetNumberOfUploadedTexels();
}

//------------------------------------------------------------------------------
int vtkOpenGLTerrainMapper::GetNumberOfShaderBuilds() const
{
  return this->Internals->ShaderBuilds;
}

//------------------------------------------------------------------------------
int vtkOpenGLTerrainMapper::GetNumberOfBufferBuilds() const
{
  return this->Internals->BufferBuilds;
}

//------------------------------------------------------------------------------
vtkIdType vtkOpenGLTerrainMapper::GetTextureMemorySize() const
{
  return this->Internals->Heights.GetMemorySize();
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Heights.ReleaseGraphicsResources(window);
  this->Internals->Coloring.ReleaseGraphicsResources(window);
  this->Internals->BeamStarts.ReleaseGraphicsResources(window);
  this->Internals->Sightings.ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
bool vtkOpenGLTerrainMapper::UpdateHeights()
{
  vtkInternals& internals = *this->Internals;
  if (this->GetNumberOfInputConnections(1) == 0)
  {
    internals.Why = "no heights are given";
    return false;
  }
  if (!this->Static)
  {
    this->GetInputAlgorithm(1, 0)->Update();
    if (this->GetNumberOfInputConnections(2) > 0)
    {
      this->GetInputAlgorithm(2, 0)->Update();
    }
  }
  internals.Why = internals.Heights.SetImage(this->GetHeights());
  if (internals.Why.empty())
  {
    internals.Why = internals.Heights.SetDetail(
      this->GetDetail(), terrain::LevelOfCells(this->DetailCells), this->DetailScale);
  }
  this->UpdateBox();
  return internals.Why.empty();
}

//------------------------------------------------------------------------------
bool vtkOpenGLTerrainMapper::CastsRays(vtkActor* act) const
{
  return this->Technique != Techniques::Mesh && this->Internals->Why.empty() &&
    act->GetProperty()->GetRepresentation() == VTK_SURFACE;
}

//------------------------------------------------------------------------------
bool vtkOpenGLTerrainMapper::UsesSurface(vtkActor* act) const
{
  return this->Internals->Why.empty() && this->Internals->Heights.HasSurface() &&
    act->GetProperty()->GetRepresentation() == VTK_SURFACE;
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
  const bool hasHeights = this->UpdateHeights(); // and the box, which may be the mesh
  this->Superclass::ComputeBounds();
  if (!hasHeights || !this->Internals->Heights.HasSurface())
  {
    return;
  }
  terrain::GridGeometry geometry = this->Internals->Heights.GetGeometry();
  geometry.Exaggeration = this->VerticalExaggeration;
  const terrain::HeightCodes& codes = this->Internals->Heights.GetCodes();
  const terrain::Cutting& cutting = this->Internals->Cutting;
  const terrain::SampleRectangle drawn = this->DrawnRectangle();
  const glm::dvec3 low = geometry.ToModel(drawn.First, cutting.Lowest(codes.ToHeight(0.0)));
  const glm::dvec3 high = geometry.ToModel(drawn.Last, codes.ToHeight(codes.MaximumCode));
  vtkBoundingBox box;
  box.AddPoint(low.x, low.y, low.z);
  box.AddPoint(high.x, high.y, high.z);
  box.GetBounds(this->Bounds);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::RenderPiece(vtkRenderer* ren, vtkActor* act)
{
  if (!this->UpdateHeights() && this->Technique != Techniques::Mesh)
  {
    vtkErrorMacro("Cannot draw the terrain: " << this->Internals->Why);
    return;
  }
  if (this->Technique != Techniques::Mesh && !this->Internals->Heights.HasSurface())
  {
    return;
  }
  this->Superclass::RenderPiece(ren, act);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::RenderPieceStart(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& internals = *this->Internals;
  if (this->UsesSurface(act))
  {
    auto* window = static_cast<vtkOpenGLRenderWindow*>(ren->GetRenderWindow());
    internals.Why = internals.Heights.Upload(window, this->CastsRays(act));
    if (!internals.Why.empty())
    {
      vtkErrorMacro("Cannot draw the terrain: " << internals.Why);
    }
    else
    {
      internals.Heights.Activate();
      this->UpdateView(ren, act);
      this->UpdateColors(ren);
      this->ComputeBeams(ren, act);
    }
  }
  this->UpdateProxy(act);
  this->Superclass::RenderPieceStart(ren, act);
  if (this->CastsRays(act))
  {
    this->PointPicking = false; // rays find the points, too
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::UpdateView(vtkRenderer* ren, vtkActor* act)
{
  vtkInternals& internals = *this->Internals;
  const ViewMatrices matrices(ren);
  const glm::dmat4 viewFromModel = matrices.ViewFromWorld * toGlm(act->GetMatrix());
  const glm::dmat4 viewFromGrid = viewFromModel *
    gridToModel(
      internals.Heights.GetGeometry(), internals.Heights.GetCodes(), this->VerticalExaggeration);

  std::array<int, 4> viewport{};
  static_cast<vtkOpenGLRenderWindow*>(ren->GetRenderWindow())
    ->GetState()
    ->vtkglGetIntegerv(GL_VIEWPORT, viewport.data());
  internals.Viewport = { viewport[0], viewport[1], viewport[2], viewport[3] };
  const glm::dvec4 pixels(internals.Viewport);
  internals.Rays = terrain::MakePixelRays(viewFromGrid, matrices.DisplayFromView, pixels);
  internals.ViewToGrid = glm::inverse(viewFromGrid);
  internals.ViewToModel = glm::inverse(viewFromModel);
  internals.KeepsOrientation = glm::determinant(glm::dmat3(viewFromGrid)) > 0.0;

  const auto nearBounds = terrain::NearBoundsGC(internals.Rays, pixels);
  internals.EyeInBox = glm::all(glm::lessThanEqual(nearBounds[0], internals.BoxMaximumGC)) &&
    glm::all(glm::greaterThanEqual(nearBounds[1], internals.BoxMinimumGC));
}

//------------------------------------------------------------------------------
// Vertices are exaggerated by their matrices, in double precision: the heights that are drawn may
// be far larger than those in the buffer.
void vtkOpenGLTerrainMapper::SetCameraShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::SetCameraShaderParameters(cellBO, ren, act);
  if (!this->Internals->Why.empty() || this->VerticalExaggeration == 1.0)
  {
    return;
  }
  const double factor = this->VerticalExaggeration;
  glm::dmat4 exaggeration(1.0);
  exaggeration[2][2] = factor;
  exaggeration[3][2] = (1.0 - factor) * this->Internals->Heights.GetGeometry().Origin.z;
  const ViewMatrices matrices(ren);
  const glm::dmat4 viewFromBuffer = matrices.ViewFromWorld * toGlm(act->GetMatrix()) *
    exaggeration * modelFromBuffer(this->VBOs->GetVBO("vertexMC"));
  terrain::ProgramUniforms uniforms(cellBO.Program);
  uniforms.Set("MCVCMatrix", glm::mat4(viewFromBuffer));
  uniforms.Set("MCDCMatrix", glm::mat4(matrices.DisplayFromView * viewFromBuffer));
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::RenderPieceDraw(vtkRenderer* ren, vtkActor* act)
{
  if (!this->CastsRays(act))
  {
    this->Superclass::RenderPieceDraw(ren, act);
    return;
  }
  // The near sides of the hull where rays enter it, or the far sides of the box around the eye:
  // each ray is cast once. Culling of the surface itself is the shader's.
  vtkOpenGLState* state = static_cast<vtkOpenGLRenderWindow*>(ren->GetRenderWindow())->GetState();
  vtkOpenGLState::ScopedglEnableDisable restoreCull(state, GL_CULL_FACE);
  const bool cullFront = this->Internals->EyeInBox == this->Internals->KeepsOrientation;
  state->vtkglEnable(GL_CULL_FACE);
  state->vtkglCullFace(cullFront ? GL_FRONT : GL_BACK);
  if (this->Internals->EyeInBox)
  {
    glEnable(GL_DEPTH_CLAMP); // the far sides count beyond the far plane, too
  }
  this->DrawLayers(ren, act);
  if (this->Internals->EyeInBox)
  {
    glDisable(GL_DEPTH_CLAMP);
  }
  state->vtkglCullFace(GL_BACK);
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::RenderPieceFinish(vtkRenderer* ren, vtkActor* act)
{
  this->Superclass::RenderPieceFinish(ren, act);
  if (this->UsesSurface(act))
  {
    this->Internals->Heights.Deactivate();
    this->Internals->BeamStarts.Finish();
    this->Internals->Sightings.Finish();
    this->Internals->Coloring.Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkOpenGLTerrainMapper::BuildBufferObjects(vtkRenderer* ren, vtkActor* act)
{
  ++this->Internals->BufferBuilds;
  this->Superclass::BuildBufferObjects(ren, act);
}

//------------------------------------------------------------------------------
bool vtkOpenGLTerrainMapper::GetNeedToRebuildBufferObjects(vtkRenderer* ren, vtkActor* act)
{
  this->IgnoresUniformTime = true;
  const bool rebuild = this->Superclass::GetNeedToRebuildBufferObjects(ren, act);
  this->IgnoresUniformTime = false;
  return rebuild;
}

//------------------------------------------------------------------------------
bool vtkOpenGLTerrainMapper::GetNeedToRebuildShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* ren, vtkActor* act)
{
  this->IgnoresUniformTime = true;
  bool rebuild = this->Superclass::GetNeedToRebuildShaders(cellBO, ren, act);
  this->IgnoresUniformTime = false;

  std::string& builtWith = this->Internals->ShaderBuiltWith[&cellBO];
  const std::string defines =
    this->ShaderDefines(act) + (this->ShiftsDepth(ren, act) ? "shifted" : "");
  if (builtWith != defines)
  {
    builtWith = defines;
    rebuild = true;
  }
  return rebuild;
}
