// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/Globe.h"

#include "core/grid/Constants.h"
#include "data/GlobeData.h"
#include "render/Driver.h"
#include "render/Uniforms.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace terrain
{
namespace
{
/// Parts of the radius above which an eye is far: the anchor is then what it looks at.
constexpr double kFar = 0.05;

/// The point of an ellipsoid that a ray meets first, or passes nearest to.
glm::dvec3 LookedAt(const Ellipsoid& body, const glm::dvec3& eye, const glm::dvec3& direction)
{
  const glm::dvec3 scale(1.0 / body.Equatorial, 1.0 / body.Equatorial, 1.0 / body.Polar);
  const glm::dvec3 o = scale * eye;
  const glm::dvec3 d = scale * direction;
  const double a = glm::dot(d, d);
  const double b = glm::dot(o, d);
  const double root = b * b - a * (glm::dot(o, o) - 1.0);
  const double t = (-b - std::sqrt(std::max(root, 0.0))) / a;
  const glm::dvec3 point = eye + std::max(t, 0.0) * direction;
  glm::dvec3 place = body.ToPlace(point);
  place.z = 0.0;
  return body.ToPosition(place);
}
}

//------------------------------------------------------------------------------
std::string Globe::SetImage(vtkImageData* image)
{
  const vtkMTimeType time = image ? image->GetMTime() : 0;
  if (this->Image == image && this->ImageTime == time)
  {
    return this->WhyNot;
  }
  this->Image = image;
  this->ImageTime = time;
  this->WhyNot.clear();
  this->Curves.clear();
  this->Grid = GlobeData::Get(image);
  if (!this->Grid)
  {
    return {};
  }
  ++this->NumberOfScans;
  this->WhyNot = this->Grid->WhyNot();
  if (this->WhyNot.empty() &&
    static_cast<int>(this->Grid->Latitudes.size()) != image->GetDimensions()[1])
  {
    this->WhyNot = "the latitudes of the globe's heights are not those of their rows";
  }
  if (this->WhyNot.empty())
  {
    this->Curves = GlobeCurves(*this->Grid);
  }
  return this->WhyNot;
}

//------------------------------------------------------------------------------
void Globe::SetHeights(const HeightCodes& codes, double exaggeration)
{
  const GridGeometry drawn = DrawnOnGlobe(exaggeration);
  this->Base = drawn.RiseToModel(codes.Offset);
  this->Scale = drawn.RiseToModel(codes.Scale);
  this->TrueScale = codes.Scale;
  this->MaximumCode = codes.MaximumCode;
  this->Range = { this->Base, this->Base + this->Scale * codes.MaximumCode };
}

//------------------------------------------------------------------------------
BoxGC Globe::GetBounds() const
{
  // a little more than the surface: for rounding, and as the proxy that rays enter by
  const double margin = 1e-5 * this->Grid->Body.Equatorial +
    1e-3 * std::max(std::abs(this->Range.Lowest), std::abs(this->Range.Highest));
  const BoxGC box = this->Grid->BoxOf(this->Range);
  return { box[0] - margin, box[1] + margin };
}

//------------------------------------------------------------------------------
BoxGC Globe::GetAnchoredBounds() const
{
  const BoxGC box = this->GetBounds();
  BoxGC anchored{ glm::dvec3(kInfinity), glm::dvec3(-kInfinity) };
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 point(box[corner & 1].x, box[(corner >> 1) & 1].y, box[corner >> 2].z);
    const glm::dvec3 there = this->Anchor.ToAxes(point - this->Anchor.Position);
    anchored = { glm::min(anchored[0], there), glm::max(anchored[1], there) };
  }
  return anchored;
}

//------------------------------------------------------------------------------
glm::dmat4 Globe::ModelFromAnchor() const
{
  const GlobeAnchor& anchor = this->Anchor;
  return { { anchor.Cosine, anchor.Sine, 0.0, 0.0 }, { -anchor.Sine, anchor.Cosine, 0.0, 0.0 },
    { 0.0, 0.0, 1.0, 0.0 }, glm::dvec4(anchor.Position, 1.0) };
}

//------------------------------------------------------------------------------
bool Globe::Update(vtkRenderer* renderer, vtkActor* actor)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const glm::dmat4 modelFromWorld = glm::inverse(ToGlm(actor->GetMatrix()));
  const double* position = camera->GetPosition();
  const double* direction = camera->GetDirectionOfProjection();
  const glm::dvec3 eye(modelFromWorld * glm::dvec4(position[0], position[1], position[2], 1.0));
  const glm::dvec3 forward(
    modelFromWorld * glm::dvec4(direction[0], direction[1], direction[2], 0.0));
  const bool far = camera->GetParallelProjection() ||
    glm::length(eye) > (1.0 + kFar) * this->Grid->Body.Equatorial;
  this->Anchor =
    GlobeAnchor(*this->Grid, this->Range, far ? LookedAt(this->Grid->Body, eye, forward) : eye);
  return this->Upload(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow()));
}

//------------------------------------------------------------------------------
bool Globe::Upload(vtkOpenGLRenderWindow* window)
{
  std::vector<glm::vec4> texels;
  texels.reserve(this->Anchor.Columns.size() + 2 * this->Anchor.Rows.size());
  for (const glm::dvec2& column : this->Anchor.Columns)
  {
    texels.emplace_back(column, 0.0, 0.0);
  }
  texels.insert(texels.end(), this->Anchor.Rows.begin(), this->Anchor.Rows.end());
  texels.insert(texels.end(), this->Curves.begin(), this->Curves.end());
  this->Texture->SetContext(window);
  this->Texture->ResetFormatAndType();
  this->Texture->SetInternalFormat(GL_RGBA32F);
  this->Texture->SetFormat(GL_RGBA);
  return this->Buffer->Upload(
           &texels[0].x, 4 * texels.size(), vtkOpenGLBufferObject::TextureBuffer) &&
    this->Texture->CreateTextureBuffer(
      static_cast<unsigned int>(texels.size()), 4, VTK_FLOAT, this->Buffer);
}

//------------------------------------------------------------------------------
void Globe::Activate()
{
  if (this->Texture->GetHandle())
  {
    this->Texture->Activate();
  }
}

//------------------------------------------------------------------------------
void Globe::Deactivate()
{
  if (this->Texture->GetHandle())
  {
    this->Texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
void Globe::SetUniforms(Uniforms& uniforms)
{
  const GlobeAnchor& anchor = this->Anchor;
  const GlobeGrid& grid = *this->Grid;
  const auto shell = [](const GlobeShell& s, double w)
  { return glm::vec4(glm::dvec4(s.PerRadius, s.PerAxis, s.Anchor, w)); };
  const double code =
    std::clamp((anchor.Height - this->Base) / this->Scale, 0.0, this->MaximumCode);
  const double anchorCode = static_cast<double>(static_cast<float>(code));
  uniforms.Set("terrainGlobeLines", this->Texture->GetTextureUnit());
  uniforms.Set("terrainGlobeScene",
    glm::vec4(glm::dvec4(anchor.Radius, anchor.Position.z, anchor.Height, anchor.Curvature)));
  uniforms.Set("terrainGlobeOuter", shell(anchor.Outer, anchor.Spread));
  uniforms.Set("terrainGlobeInner", shell(anchor.Inner, 0.0));
  const double cell = std::floor(anchor.Column);
  uniforms.Set("terrainGlobeColumn",
    glm::vec4(glm::dvec4(1.0 / grid.Step, kTurn / grid.Step, anchor.Column - cell, 0.0)));
  uniforms.Set("terrainGlobeGrid", glm::ivec2(static_cast<int>(cell), TopOfGlobe(grid)));
  uniforms.Set("terrainGlobeJoined", grid.IsJoined() ? 1 : 0);
  uniforms.Set("terrainGradientScale", glm::vec2(static_cast<float>(this->TrueScale)));
  uniforms.Set("terrainGlobeHeights",
    glm::vec4(glm::dvec4(
      this->Scale, this->Base + this->Scale * anchorCode - anchor.Height, anchorCode, 0.0)));
}

//------------------------------------------------------------------------------
void Globe::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Buffer->ReleaseGraphicsResources();
}
}
