// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/SurfaceTextures.h"

#include "data/ImageHeights.h"
#include "data/SMPParallelFor.h"
#include "render/Driver.h"
#include "render/Uniforms.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace terrain
{
namespace
{
/// Cells along a side of a surface with detail: float still tells a tenth of one.
constexpr int kMostCells = 1 << 20;
}

//------------------------------------------------------------------------------
std::string SurfaceTextures::SetImage(vtkImageData* image)
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
std::string SurfaceTextures::SetDetail(vtkImageData* detail, int level, double scale)
{
  std::string why = this->Detail.SetImage(detail);
  this->Sum = { this->Codes, this->Geometry, this->Size };
  if (this->HasTiles())
  {
    return this->SetTiledSum();
  }
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
  if (std::max(this->Size.x, this->Size.y) - 1 > (kMostCells >> level))
  {
    return "detail: " + std::to_string(cells) + " cells along a cell of the heights are too many";
  }
  this->Sum.Size = (this->Size - 1) * cells + 1;
  return why;
}

//------------------------------------------------------------------------------
// The surface is level 0 of the tiles.
std::string SurfaceTextures::SetTiledSum()
{
  const TileSource& source = this->Tiles.GetSource();
  const TileLayout layout = source.GetLayout();
  this->ImageLevel = 0;
  while (this->ImageLevel < layout.LevelCount() - 1 &&
    layout.Samples(this->ImageLevel) != glm::i64vec2(this->Size))
  {
    ++this->ImageLevel;
  }
  if (layout.LevelCount() < 2 || layout.Samples(this->ImageLevel) != glm::i64vec2(this->Size))
  {
    return "the tiles are not those of the heights";
  }
  if (std::max(layout.Width, layout.Height) - 1 > kMostCells)
  {
    return "its tiles have more than " + std::to_string(kMostCells) + " cells along a side";
  }
  this->Sum.Codes = source.GetCodes();
  this->Sum.Size = glm::ivec2(static_cast<int>(layout.Width), static_cast<int>(layout.Height));
  this->Sum.Geometry.Spacing /= std::ldexp(1.0, this->ImageLevel);
  return {};
}

//------------------------------------------------------------------------------
void SurfaceTextures::SetImagePart(vtkImageData* image, GridRectangle samples)
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
bool SurfaceTextures::HasSurface() const
{
  return this->Codes.HasData && this->Size.x > 1 && this->Size.y > 1;
}

//------------------------------------------------------------------------------
vtkIdType SurfaceTextures::GetMemorySize() const
{
  const std::size_t heights = static_cast<std::size_t>(this->Size.x) * this->Size.y *
    (this->Codes.Format == HeightCodes::TexelFormat::UInt16 ? sizeof(unsigned short)
                                                            : sizeof(float));
  const std::size_t nodes =
    std::visit([](const auto& pyramid) { return pyramid.MemorySize(); }, this->Pyramid);
  return static_cast<vtkIdType>(
           (this->UploadTime ? heights : 0) + (this->PyramidTime ? nodes : 0)) +
    this->Detail.GetMemorySize() + this->Slopes.GetMemorySize() +
    static_cast<vtkIdType>(this->HasTiles() ? this->Tiles.GetMemorySize() : 0);
}

//------------------------------------------------------------------------------
template <typename Texel>
SurfaceTextures::Texels<Texel> SurfaceTextures::Encode(const GridRectangle& samples) const
{
  const auto width = static_cast<std::int64_t>(this->Size.x);
  Texels<Texel> texels(new Texel[static_cast<std::size_t>(width) * this->Size.y]);
  ImageHeights::Dispatch(this->Image,
    [&](const auto& view)
    {
      if (samples.First.x == 0 && samples.End == this->Size)
      {
        EncodeHeights(view, this->Codes, 0, this->Size.x, samples.First.y, samples.End.y,
          texels.get() + width * samples.First.y, SMPParallelFor);
        return;
      }
      for (int row = samples.First.y; row < samples.End.y; ++row)
      {
        EncodeHeights(view, this->Codes, samples.First.x, samples.End.x, row, row + 1,
          texels.get() + samples.First.x + width * row, SerialFor);
      }
    });
  return texels;
}

//------------------------------------------------------------------------------
template <typename Texel>
HeightfieldView<Texel> SurfaceTextures::TexelView(const Texels<Texel>& texels) const
{
  HeightfieldView<Texel> view;
  view.Samples = texels.get();
  view.Width = this->Size.x;
  view.Height = this->Size.y;
  view.HasNoData = this->Codes.HasNoData;
  view.NoData = std::is_floating_point_v<Texel> ? static_cast<Texel>(kNoDataCode) : Texel{};
  return view;
}

//------------------------------------------------------------------------------
std::string SurfaceTextures::Prepare(vtkOpenGLRenderWindow* window)
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
    this->Pyramid.emplace<MinMaxPyramid<unsigned short>>();
  }
  else
  {
    this->Pyramid.emplace<MinMaxPyramid<float>>();
  }
  return {};
}

//------------------------------------------------------------------------------
template <typename Texel>
bool SurfaceTextures::UploadWhole(
  vtkOpenGLRenderWindow* window, MinMaxPyramid<Texel>& pyramid, bool heights, bool withPyramid)
{
  const Texels<Texel> texels = this->Encode<Texel>({ { 0, 0 }, this->Size });
  bool done = true;
  if (heights)
  {
    this->Slopes.GetSlopes().Build(this->TexelView(texels), this->Codes, SMPParallelFor);
    this->NumberOfUploadedTexels += vtkIdType{ this->Size.x } * this->Size.y;
    done = this->Texture->Create2DFromRaw(static_cast<unsigned int>(this->Size.x),
             static_cast<unsigned int>(this->Size.y), 1,
             std::is_floating_point_v<Texel> ? VTK_FLOAT : VTK_UNSIGNED_SHORT, texels.get()) &&
      this->Slopes.Upload(window);
  }
  if (done && withPyramid)
  {
    pyramid.Build(this->TexelView(texels), SMPParallelFor);
    this->PyramidTop = pyramid.LevelCount();
    this->PyramidSize = this->PyramidTop > 0 ? pyramid.LevelSize(1) : glm::ivec2(0);
    this->NumberOfUploadedTexels +=
      static_cast<vtkIdType>(pyramid.MemorySize() / sizeof(PyramidNode<Texel>));
    done = this->Extremes.Upload(window, pyramid);
  }
  return done;
}

//------------------------------------------------------------------------------
template <typename Texel>
void SurfaceTextures::SendTexels(const Texels<Texel>& texels, const GridRectangle& part)
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
    texels.get() + part.First.x + static_cast<std::int64_t>(this->Size.x) * part.First.y);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  texture->Deactivate();
}

//------------------------------------------------------------------------------
template <typename Texel>
void SurfaceTextures::UploadPart(MinMaxPyramid<Texel>& pyramid, const GridRectangle& samples)
{
  // with what slopes and pyramid read beside the samples
  const GridRectangle read{ glm::max(samples.First - kSlopesReach, glm::ivec2(0)),
    glm::min(samples.End + kSlopesReach, this->Size) };
  const Texels<Texel> texels = this->Encode<Texel>(read);
  this->Slopes.GetSlopes().Update(this->TexelView(texels), samples, SMPParallelFor);
  this->SendTexels(texels, samples);
  if (this->PyramidTime != this->WholeTime)
  {
    return;
  }
  const std::vector<GridRectangle> nodes =
    pyramid.Update(this->TexelView(texels), samples, SMPParallelFor);
  for (int level = 1; level <= static_cast<int>(nodes.size()); ++level)
  {
    const GridRectangle& part = nodes[static_cast<std::size_t>(level) - 1];
    if (!part.IsEmpty())
    {
      const glm::ivec2 size = part.End - part.First;
      this->NumberOfUploadedTexels += vtkIdType{ size.x } * size.y;
      this->Extremes.UploadPart(pyramid, level, part);
    }
  }
}

//------------------------------------------------------------------------------
ShadowBounds SurfaceTextures::MakeShadowBounds(const ShadowRays& rays, bool complete) const
{
  int level = 1;
  while (level < this->PyramidTop &&
    (std::max(this->Size.x, this->Size.y) - 2) >> level >= kMostBoundNodes)
  {
    ++level;
  }
  return std::visit(
    [&](const auto& pyramid)
    {
      return terrain::MakeShadowBounds(pyramid, level, this->Codes.Bias, rays,
        this->Codes.MaximumCode, complete && !this->Codes.HasNoData, SMPParallelFor);
    },
    this->Pyramid);
}

//------------------------------------------------------------------------------
std::string SurfaceTextures::Upload(vtkOpenGLRenderWindow* window, bool withPyramid)
{
  if (this->HasTiles())
  {
    return {}; // they come when the view is known
  }
  const bool heights = this->Texture->GetContext() != window || this->UploadTime != this->WholeTime;
  if (heights)
  {
    this->UploadTime = 0;
    this->PyramidTime = 0;
    std::string why = this->Prepare(window);
    if (!why.empty())
    {
      return why;
    }
    this->Parts.clear();
    ++this->NumberOfUploads;
  }
  for (const GridRectangle& part : this->Parts)
  {
    std::visit([&](auto& pyramid) { this->UploadPart(pyramid, part); }, this->Pyramid);
  }
  while (glGetError() != GL_NO_ERROR) // of others: an upload is judged by its own
  {
  }
  bool done = this->Parts.empty() || this->Slopes.Upload(window);
  this->Parts.clear();
  const bool nodes = withPyramid && this->PyramidTime != this->WholeTime;
  if (done && (heights || nodes))
  {
    done =
      std::visit([&](auto& pyramid) { return this->UploadWhole(window, pyramid, heights, nodes); },
        this->Pyramid);
    this->UploadTime = done ? this->WholeTime : 0;
    this->PyramidTime = done && nodes ? this->WholeTime : 0;
  }
  done = done && this->Detail.Upload(window);
  return done ? std::string() : "heights could not be uploaded to the graphics driver";
}

//------------------------------------------------------------------------------
void SurfaceTextures::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Extremes.ReleaseGraphicsResources(window);
  this->Detail.ReleaseGraphicsResources(window);
  this->Slopes.ReleaseGraphicsResources(window);
  this->Colors.ReleaseGraphicsResources(window);
  this->Tiles.ReleaseGraphicsResources(window);
  this->UploadTime = 0;
  this->PyramidTime = 0;
}

//------------------------------------------------------------------------------
void SurfaceTextures::Activate()
{
  this->Colors.Activate();
  if (this->HasTiles())
  {
    this->Tiles.Activate();
    return;
  }
  this->Texture->Activate();
  this->Detail.Activate();
  this->Slopes.Activate();
  if (this->PyramidTime)
  {
    this->Extremes.Activate();
  }
}

//------------------------------------------------------------------------------
void SurfaceTextures::Deactivate()
{
  this->Colors.Deactivate();
  if (this->HasTiles())
  {
    this->Tiles.Deactivate();
    return;
  }
  this->Texture->Deactivate();
  this->Detail.Deactivate();
  this->Slopes.Deactivate();
  if (this->PyramidTime)
  {
    this->Extremes.Deactivate();
  }
}

//------------------------------------------------------------------------------
void SurfaceTextures::AddFeatures(Features& features) const
{
  features.Tiles = this->HasTiles();
  features.IntegerHeights = this->Sum.Codes.Format == HeightCodes::TexelFormat::UInt16;
  features.BuffersPyramid = !features.Tiles && this->Extremes.IsBuffer();
  features.Detail = this->HasDetail();
  features.Paints = this->Colors.Paints();
  features.DrapeComponents = this->Colors.GetDrapeComponents();
}

//------------------------------------------------------------------------------
void SurfaceTextures::SetUniforms(
  Uniforms& uniforms, const GridGeometry& geometry, const vtkTerrainLook* look)
{
  uniforms.Set("terrainSize", this->Sum.Size);
  uniforms.Set("terrainRowsFromNorth", ImageHeights::AreRowsFromNorth(this->Image) ? 1 : 0);
  uniforms.Set("terrainBias", static_cast<float>(this->Codes.Bias));
  uniforms.Set("terrainMaximumCode", static_cast<float>(this->Sum.Codes.MaximumCode));
  if (this->HasTiles())
  {
    this->Tiles.SetUniforms(uniforms);
    uniforms.Set("terrainArrayLevel", this->ImageLevel);
    this->Colors.SetUniforms(uniforms, this->Sum.Codes, geometry, look);
    return;
  }
  uniforms.Set("terrainHeights", this->Texture->GetTextureUnit());
  this->Slopes.SetUniforms(uniforms);
  this->Colors.SetUniforms(uniforms, this->Sum.Codes, geometry, look);
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
