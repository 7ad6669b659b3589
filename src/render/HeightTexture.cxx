// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/HeightTexture.h"

#include "data/ImageHeights.h"
#include "data/SMPParallelFor.h"
#include "render/Driver.h"
#include "render/Uniforms.h"
#include "vtkTerrainCoarseMesh.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <vector>

namespace terrain
{
namespace
{
/// Cells along a side of a surface with detail: float still tells a tenth of one.
constexpr int MostCells = 1 << 20;
}

//------------------------------------------------------------------------------
std::string HeightTexture::SetImage(vtkImageData* image)
{
  std::string why = ImageHeights::WhyNotHeights(image);
  if (!why.empty())
  {
    this->Image = nullptr;
    this->Size = { 0, 0 };
    return why;
  }
  if (this->Image != image || this->ImageTime != image->GetMTime())
  {
    this->Image = image;
    this->ImageTime = image->GetMTime();
    this->WholeTime = this->ImageTime;
    this->ScalarType = image->GetScalarType();
    this->Parts.clear();
    this->Geometry = ImageHeights::Geometry(image);
    this->Size = { image->GetDimensions()[0], image->GetDimensions()[1] };
    ImageHeights::Dispatch(image,
      [this](const auto& view)
      { this->Codes = ChooseHeightCodes(FindHeightRange(view, SMPParallelFor)); });
  }
  return {};
}

//------------------------------------------------------------------------------
std::string HeightTexture::SetDetail(vtkImageData* detail, int level, double scale)
{
  std::string why = this->Detail.SetImage(detail);
  this->Sum = { this->Codes, this->Geometry, this->Size };
  if (!this->HasDetail() || !this->HasSurface())
  {
    return why;
  }
  const HeightCodes& codes = this->Detail.GetCodes();
  const int cells = 1 << level;
  this->DetailLevel = level;
  this->DetailScale = scale * codes.Scale / this->Codes.Scale;
  this->Sum.Codes.Offset += scale * codes.Offset;
  this->Sum.Codes.MaximumCode += this->DetailScale * codes.MaximumCode;
  this->Sum.Geometry.Spacing /= cells;
  if (std::max(this->Size.x, this->Size.y) - 1 > (MostCells >> level))
  {
    return "detail: " + std::to_string(cells) + " cells along a cell of the heights are too many";
  }
  this->Sum.Size = (this->Size - 1) * cells + 1;
  return why;
}

//------------------------------------------------------------------------------
glm::dvec2 HeightTexture::GetDetailRange() const
{
  const HeightCodes& codes = this->Detail.GetCodes();
  const double factor = this->DetailScale * this->Codes.Scale / codes.Scale;
  return this->HasDetail() ? factor * glm::dvec2(codes.Offset, codes.ToHeight(codes.MaximumCode))
                           : glm::dvec2(0.0);
}

//------------------------------------------------------------------------------
double HeightTexture::GetFloorThreshold() const
{
  const double range = this->Codes.MaximumCode * this->Codes.Scale;
  const double spacing = std::min(this->Geometry.Spacing.x, this->Geometry.Spacing.y);
  return this->Codes.Offset - 0.5 * vtkTerrainCoarseMesh::FloorMargin * std::max(range, spacing);
}

//------------------------------------------------------------------------------
void HeightTexture::SetImagePart(vtkImageData* image, GridRectangle samples)
{
  if (!image || this->Image != image || this->ImageTime == 0 ||
    !ImageHeights::WhyNotHeights(image).empty() || image->GetScalarType() != this->ScalarType ||
    this->Size != glm::ivec2(image->GetDimensions()[0], image->GetDimensions()[1]))
  {
    return;
  }
  samples.First = glm::max(samples.First, glm::ivec2(0));
  samples.End = glm::min(samples.End, this->Size);
  bool fits = true;
  if (!samples.IsEmpty())
  {
    ImageHeights::Dispatch(image,
      [&](const auto& view)
      {
        fits = HoldHeights(
          this->Codes, view, samples.First.x, samples.End.x, samples.First.y, samples.End.y);
      });
    this->Parts.push_back(samples);
  }
  this->ImageTime = fits ? image->GetMTime() : 0;
}

//------------------------------------------------------------------------------
bool HeightTexture::HasSurface() const
{
  return this->Codes.HasData && this->Size.x > 1 && this->Size.y > 1;
}

//------------------------------------------------------------------------------
vtkIdType HeightTexture::GetMemorySize() const
{
  return std::visit(
           [this](const auto& store)
           {
             const std::size_t heights = store.Texels.size() * sizeof(store.Texels[0]);
             const std::size_t pyramid = this->PyramidTime ? store.Pyramid.MemorySize() : 0;
             const std::size_t all = (this->UploadTime ? heights : 0) + pyramid;
             return static_cast<vtkIdType>(all);
           },
           this->Data) +
    this->Detail.GetMemorySize() + this->Slopes.GetMemorySize();
}

//------------------------------------------------------------------------------
template <typename Texel>
HeightfieldView<Texel> HeightTexture::TexelView(const Store<Texel>& store) const
{
  HeightfieldView<Texel> view;
  view.Samples = store.Texels.data();
  view.Width = this->Size.x;
  view.Height = this->Size.y;
  view.HasNoData = this->Codes.HasNoData;
  view.NoData = std::is_floating_point_v<Texel> ? static_cast<Texel>(NoDataCode) : Texel{};
  return view;
}

//------------------------------------------------------------------------------
std::string HeightTexture::Prepare(vtkOpenGLRenderWindow* window)
{
  const int limit = vtkTextureObject::GetMaximumTextureSize(window);
  if (limit > 0 && std::max(this->Size.x, this->Size.y) > limit)
  {
    return "heights of " + std::to_string(this->Size.x) + " x " + std::to_string(this->Size.y) +
      " samples exceed the largest texture of this graphics driver, " + std::to_string(limit);
  }
  const bool integer = this->Codes.Format == HeightCodes::TexelFormat::UInt16;
  vtkTextureObject* texture = this->Texture;
  texture->ReleaseGraphicsResources(texture->GetContext());
  texture->SetContext(window);
  texture->ResetFormatAndType();
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetInternalFormat(integer ? GL_R16UI : GL_R32F);
  texture->SetFormat(integer ? GL_RED_INTEGER : GL_RED);
  if (integer)
  {
    this->Data.emplace<Store<unsigned short>>();
  }
  else
  {
    this->Data.emplace<Store<float>>();
  }
  return {};
}

//------------------------------------------------------------------------------
template <typename Texel>
bool HeightTexture::UploadHeights(Store<Texel>& store)
{
  store.Texels.resize(static_cast<std::size_t>(this->Size.x) * this->Size.y);
  ImageHeights::Dispatch(this->Image,
    [&](const auto& view)
    {
      EncodeHeights(
        view, this->Codes, 0, this->Size.x, 0, this->Size.y, store.Texels.data(), SMPParallelFor);
    });
  this->Slopes.GetSlopes().Build(this->TexelView(store), this->Codes, SMPParallelFor);
  this->NumberOfUploadedTexels += static_cast<vtkIdType>(store.Texels.size());
  return this->Texture->Create2DFromRaw(static_cast<unsigned int>(this->Size.x),
    static_cast<unsigned int>(this->Size.y), 1,
    std::is_floating_point_v<Texel> ? VTK_FLOAT : VTK_UNSIGNED_SHORT, store.Texels.data());
}

//------------------------------------------------------------------------------
template <typename Texel>
bool HeightTexture::UploadPyramid(vtkOpenGLRenderWindow* window, Store<Texel>& store)
{
  store.Pyramid.Build(this->TexelView(store), SMPParallelFor);
  this->PyramidTop = store.Pyramid.LevelCount();
  this->PyramidSize = this->PyramidTop > 0 ? store.Pyramid.LevelSize(1) : glm::ivec2(0);
  this->NumberOfUploadedTexels +=
    static_cast<vtkIdType>(store.Pyramid.MemorySize() / sizeof(PyramidNode<Texel>));
  return this->Extremes.Upload(window, store.Pyramid);
}

//------------------------------------------------------------------------------
template <typename Texel>
void HeightTexture::SendTexels(const Store<Texel>& store, const GridRectangle& part)
{
  const glm::ivec2 size = part.End - part.First;
  this->NumberOfUploadedTexels += vtkIdType{ size.x } * size.y;
  vtkTextureObject* texture = this->Texture;
  const int vtkType = std::is_floating_point_v<Texel> ? VTK_FLOAT : VTK_UNSIGNED_SHORT;
  texture->Activate();
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, this->Size.x);
  glTexSubImage2D(GL_TEXTURE_2D, 0, part.First.x, part.First.y, size.x, size.y,
    texture->GetFormat(vtkType, 1, false), static_cast<GLenum>(texture->GetDataType(vtkType)),
    store.Texels.data() + part.First.x + static_cast<std::int64_t>(this->Size.x) * part.First.y);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  texture->Deactivate();
}

//------------------------------------------------------------------------------
template <typename Texel>
void HeightTexture::UploadPart(Store<Texel>& store, const GridRectangle& samples)
{
  ImageHeights::Dispatch(this->Image,
    [&](const auto& view)
    {
      for (int row = samples.First.y; row < samples.End.y; ++row)
      {
        EncodeHeights(view, this->Codes, samples.First.x, samples.End.x, row, row + 1,
          store.Texels.data() + samples.First.x + static_cast<std::int64_t>(this->Size.x) * row,
          SerialFor);
      }
    });
  this->Slopes.GetSlopes().Update(this->TexelView(store), samples, SMPParallelFor);
  this->SendTexels(store, samples);
  if (this->PyramidTime != this->WholeTime)
  {
    return;
  }
  const std::vector<GridRectangle> nodes =
    store.Pyramid.Update(this->TexelView(store), samples, SMPParallelFor);
  for (int level = 1; level <= static_cast<int>(nodes.size()); ++level)
  {
    const GridRectangle& part = nodes[static_cast<std::size_t>(level) - 1];
    if (!part.IsEmpty())
    {
      const glm::ivec2 size = part.End - part.First;
      this->NumberOfUploadedTexels += vtkIdType{ size.x } * size.y;
      this->Extremes.UploadPart(store.Pyramid, level, part);
    }
  }
}

//------------------------------------------------------------------------------
std::string HeightTexture::Upload(vtkOpenGLRenderWindow* window, bool withPyramid)
{
  bool done = true;
  if (this->Texture->GetContext() != window || this->UploadTime != this->WholeTime)
  {
    this->UploadTime = 0;
    this->PyramidTime = 0;
    std::string why = this->Prepare(window);
    if (!why.empty())
    {
      return why;
    }
    done = std::visit([this](auto& store) { return this->UploadHeights(store); }, this->Data);
    done = done && this->Slopes.Upload(window);
    this->UploadTime = done ? this->WholeTime : 0;
    this->Parts.clear();
    ++this->NumberOfUploads;
  }
  for (const GridRectangle& part : this->Parts)
  {
    std::visit([&](auto& store) { this->UploadPart(store, part); }, this->Data);
  }
  done = done && (this->Parts.empty() || this->Slopes.Upload(window));
  this->Parts.clear();
  if (done && withPyramid && this->PyramidTime != this->WholeTime)
  {
    done = std::visit([&](auto& store) { return this->UploadPyramid(window, store); }, this->Data);
    this->PyramidTime = done ? this->WholeTime : 0;
  }
  done = done && this->Detail.Upload(window);
  return done ? std::string() : "heights could not be uploaded to the graphics driver";
}

//------------------------------------------------------------------------------
void HeightTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Extremes.ReleaseGraphicsResources(window);
  this->Detail.ReleaseGraphicsResources(window);
  this->Slopes.ReleaseGraphicsResources(window);
  this->UploadTime = 0;
  this->PyramidTime = 0;
}

//------------------------------------------------------------------------------
void HeightTexture::Activate()
{
  this->Texture->Activate();
  this->Detail.Activate();
  this->Slopes.Activate();
  if (this->PyramidTime)
  {
    this->Extremes.Activate();
  }
}

//------------------------------------------------------------------------------
void HeightTexture::Deactivate()
{
  this->Texture->Deactivate();
  this->Detail.Deactivate();
  this->Slopes.Deactivate();
  if (this->PyramidTime)
  {
    this->Extremes.Deactivate();
  }
}

//------------------------------------------------------------------------------
void HeightTexture::SetUniforms(Uniforms& uniforms)
{
  uniforms.Set("terrainHeights", this->Texture->GetTextureUnit());
  uniforms.Set("terrainSize", this->Sum.Size);
  uniforms.Set("terrainBias", static_cast<float>(this->Codes.Bias));
  uniforms.Set("terrainMaximumCode", static_cast<float>(this->Sum.Codes.MaximumCode));
  this->Slopes.SetUniforms(uniforms);
  this->Detail.SetUniforms(uniforms, this->DetailLevel, this->DetailScale);
  if (uniforms.Uses("terrainPyramid"))
  {
    this->Extremes.SetUniforms(
      uniforms, "terrainPyramid", "terrainPyramidLayout", "terrainPyramidLevels");
    uniforms.Set("terrainPyramidSize", this->PyramidSize);
    uniforms.Set(
      "terrainPyramidTop", this->PyramidTop > 0 ? this->PyramidTop + this->GetDetailLevel() : 0);
    // Rays start near the surface: from the top down, most levels would be visited in vain.
    uniforms.Set("terrainPyramidStart", std::min(this->PyramidTop, 5) + this->GetDetailLevel());
  }
}
}
