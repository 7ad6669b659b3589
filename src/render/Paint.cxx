// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/Paint.h"

#include "core/grid/Heightfield.h"
#include "data/ImageHeights.h"
#include "data/SMPParallelFor.h"
#include "render/Driver.h"
#include "render/Uniforms.h"

#include "vtkAbstractMapper.h"
#include "vtkDataSetAttributes.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <vector>

namespace terrain
{
namespace
{
using ColorSources = vtkTerrainLook::ColorSources;

/// Text that changes with an object's state and with some numbers.
template <typename... Numbers>
std::string StateOf(vtkObject* object, Numbers... numbers)
{
  std::ostringstream state;
  state << static_cast<const void*>(object) << ' ' << object->GetMTime();
  ((state << ' ' << numbers), ...);
  return state.str();
}

/// The array that the mapper's scalar mode selects in the heights' image, or null.
vtkDataArray* FindArray(vtkMapper* mapper, vtkImageData* heights, bool& cells)
{
  int association = 0;
  vtkAbstractArray* array = vtkAbstractMapper::GetAbstractScalars(heights, mapper->GetScalarMode(),
    mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), association);
  cells = association == 1;
  return association == 2 ? nullptr : vtkDataArray::SafeDownCast(array);
}

/// The mapper's color mode for an array. Heights in unsigned chars are no colours, whatever VTK's
/// default takes those for.
int ColorModeOf(vtkMapper* mapper, vtkDataArray* array, vtkImageData* heights)
{
  const int mode = mapper->GetColorMode();
  const bool isHeight =
    array == heights->GetPointData()->GetScalars() && array->GetNumberOfComponents() == 1;
  return isHeight && mode == VTK_COLOR_MODE_DEFAULT ? VTK_COLOR_MODE_MAP_SCALARS : mode;
}

/// True if the array's tuples become colours one by one, which are then mixed: it holds colours, or
/// the table knows values only that are equal to its own.
bool IsDirect(vtkMapper* mapper, vtkDataArray* array, vtkImageData* heights)
{
  vtkScalarsToColors* table = mapper->GetLookupTable();
  const int mode = ColorModeOf(mapper, array, heights);
  const bool vectors = mapper->GetArrayComponent() < 0 && array->GetNumberOfComponents() > 1 &&
    table->GetVectorMode() == vtkScalarsToColors::RGBCOLORS;
  return vectors || table->GetIndexedLookup() || mode == VTK_COLOR_MODE_DIRECT_SCALARS ||
    (mode == VTK_COLOR_MODE_DEFAULT && vtkUnsignedCharArray::SafeDownCast(array));
}

/// Component of an array that the table maps; -1 for the magnitude.
int MappedComponent(vtkMapper* mapper, vtkDataArray* array)
{
  vtkScalarsToColors* table = mapper->GetLookupTable();
  const int last = array->GetNumberOfComponents() - 1;
  if (mapper->GetArrayComponent() < 0 && table->GetVectorMode() == vtkScalarsToColors::MAGNITUDE)
  {
    return last > 0 ? -1 : 0;
  }
  const int own = mapper->GetArrayComponent();
  return std::clamp(own < 0 ? table->GetVectorComponent() : own, 0, last);
}

double ValueOf(vtkDataArray* array, vtkIdType tuple, int component)
{
  if (component >= 0)
  {
    return array->GetComponent(tuple, component);
  }
  double sum = 0.0;
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    sum += array->GetComponent(tuple, c) * array->GetComponent(tuple, c);
  }
  return std::sqrt(sum);
}

/// Whether a point of an image has a height.
bool IsSeen(vtkImageData* heights, vtkIdType point)
{
  vtkUnsignedCharArray* ghosts = heights->GetPointGhostArray();
  return (!ghosts || (ghosts->GetValue(point) & vtkDataSetAttributes::HIDDENPOINT) == 0) &&
    IsHeight(heights->GetPointData()->GetScalars()->GetComponent(point, 0));
}

/// A value that the others lie about: the median of some where there is terrain; 0 if none is
/// finite. Differences from it fit floats, whatever a few wild ones are.
double TypicalValue(vtkDataArray* array, int component, vtkImageData* heights, int width)
{
  constexpr vtkIdType enough = 4096;
  const vtkIdType count = array->GetNumberOfTuples();
  const vtkIdType step = (count / enough) | 1;
  const int columns = heights->GetDimensions()[0];
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(count / step + 1));
  for (vtkIdType k = 0; k < count; k += step)
  {
    const double value = ValueOf(array, k, component);
    if (std::isfinite(value) && IsSeen(heights, k / width * columns + k % width))
    {
      values.push_back(value);
    }
  }
  if (values.empty())
  {
    return 0.0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

glm::vec4 ColorOf(vtkScalarsToColors* table, double value)
{
  unsigned char color[4];
  table->MapScalarsThroughTable2(&value, color, VTK_DOUBLE, 1, 1, VTK_RGBA);
  return glm::vec4(color[0], color[1], color[2], color[3]) / 255.0f;
}

void SetClampedToEdge(vtkTextureObject* texture)
{
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
}

/// Multiplies the colours of an image with alpha, of 2 or 4 components, by it: only so may texels
/// be mixed.
std::vector<unsigned char> Premultiplied(
  const unsigned char* texels, vtkIdType count, int components)
{
  std::vector<unsigned char> result(texels, texels + count * components);
  for (vtkIdType i = 0; i < count; ++i)
  {
    unsigned char* texel = result.data() + i * components;
    const int alpha = texel[components - 1];
    for (int c = 0; c < components - 1; ++c)
    {
      texel[c] = static_cast<unsigned char>((texel[c] * alpha + 127) / 255);
    }
  }
  return result;
}
}

//------------------------------------------------------------------------------
std::string Paint::Update(vtkMapper* mapper, vtkImageData* heights, const vtkTerrainLook* look,
  vtkOpenGLRenderWindow* window)
{
  this->Mapper = mapper;
  this->Heights = heights;
  this->Look = look;
  this->Window = window;
  for (Made* made : this->Textures())
  {
    made->Used = false;
  }
  const std::string words = this->UpdateScalars();
  const std::string more = this->UpdateDrape();
  this->Painted = this->Painted || this->Kind != PaintKinds::Material || this->DrapeTexture.Used ||
    look->GetHillshade() || look->GetContours();
  if (this->Painted)
  {
    this->FillIn();
  }
  return words.empty() ? more : words;
}

//------------------------------------------------------------------------------
void Paint::FillIn()
{
  const int* heights = this->Heights->GetDimensions();
  // like the arrays of these samples: some drivers build programs for sizes that are powers of two
  // (those of cells may then cost one more)
  const auto size = [](int samples) { return (samples & (samples - 1)) == 0 ? 2U : 3U; };
  const auto fill = [&](
                      Made& made, unsigned int width, unsigned int height, int components, int type)
  {
    const bool there = !made.From.empty() && made.Texture->GetContext() == this->Window;
    if (!there && this->StartsToMake(made, "nothing"))
    {
      std::array<float, 9> nothing{};
      made.Texture->Create2DFromRaw(width, height, components, type, nothing.data());
    }
    made.Used = true;
  };
  fill(this->ColorMap, 2, 1, 4, VTK_UNSIGNED_CHAR);
  fill(this->Values, size(heights[0]), size(heights[1]), 1, VTK_FLOAT);
  fill(this->Colors, size(heights[0]), size(heights[1]), 4, VTK_UNSIGNED_CHAR);
}

//------------------------------------------------------------------------------
bool Paint::StartsToMake(Made& made, const std::string& from)
{
  made.Used = true;
  if (made.From == from && made.Texture->GetContext() == this->Window)
  {
    return false;
  }
  made.From = from;
  made.Texture->ReleaseGraphicsResources(made.Texture->GetContext());
  made.Texture->ResetFormatAndType();
  made.Texture->SetContext(this->Window);
  made.Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  made.Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  SetClampedToEdge(made.Texture);
  return true;
}

//------------------------------------------------------------------------------
std::string Paint::UpdateScalars()
{
  vtkMapper* mapper = this->Mapper;
  const ColorSources source = this->Look->GetColorSource();
  this->Kind = this->Look->GetShowCrossings() ? PaintKinds::Crossings : PaintKinds::Material;
  if (!mapper->GetScalarVisibility() || this->Look->GetShowCrossings())
  {
    return {};
  }
  bool cells = false;
  vtkDataArray* array =
    source == ColorSources::Array ? FindArray(mapper, this->Heights, cells) : nullptr;
  if (array && array->GetLookupTable())
  {
    mapper->SetLookupTable(array->GetLookupTable()); // as VTK's mappers do
  }
  const bool heights = array && array == this->Heights->GetPointData()->GetScalars() &&
    !IsDirect(mapper, array, this->Heights);
  if (heights || source == ColorSources::Height)
  {
    this->Kind = PaintKinds::Height;
  }
  else if (source != ColorSources::Array)
  {
    this->Kind = source == ColorSources::Slope ? PaintKinds::Slope : PaintKinds::Aspect;
  }
  else
  {
    return this->UpdateArray(array, cells);
  }
  this->UpdateColorMap();
  return {};
}

//------------------------------------------------------------------------------
std::string Paint::UpdateArray(vtkDataArray* array, bool cells)
{
  if (!array)
  {
    return "The heights' image has no array to colour by of the name or kind that is asked for";
  }
  const int* size = this->Heights->GetDimensions();
  const int width = cells ? size[0] - 1 : size[0];
  const int height = cells ? size[1] - 1 : size[1];
  if (array->GetNumberOfTuples() != vtkIdType{ width } * height)
  {
    return "The array to colour by has " + std::to_string(array->GetNumberOfTuples()) +
      " tuples, not " + std::to_string(width) + " x " + std::to_string(height);
  }
  this->OfCells = cells;
  if (IsDirect(this->Mapper, array, this->Heights))
  {
    this->Kind = PaintKinds::Colors;
    this->UpdateColors(array, width, height);
    return {};
  }
  this->Kind = PaintKinds::Values;
  this->UpdateValues(array, MappedComponent(this->Mapper, array), width, height);
  this->UpdateColorMap();
  return {};
}

//------------------------------------------------------------------------------
void Paint::UpdateValues(vtkDataArray* array, int component, int width, int height)
{
  if (!this->StartsToMake(this->Values, StateOf(array, component, width, height)))
  {
    return;
  }
  this->ValueOffset = TypicalValue(array, component, this->Heights, width);
  std::vector<float> values(static_cast<std::size_t>(width) * height);
  SMPParallelFor(array->GetNumberOfTuples(),
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t i = begin; i < end; ++i)
      {
        const double value = ValueOf(array, i, component) - this->ValueOffset;
        values[i] = std::isfinite(value) ? static_cast<float>(value) : kNotANumber;
      }
    });
  ImageHeights::ArrangeRows(this->Heights, values.data(), width, height);
  this->Values.Texture->SetInternalFormat(GL_R32F);
  this->Values.Texture->SetFormat(GL_RED);
  this->Values.Texture->Create2DFromRaw(static_cast<unsigned int>(width),
    static_cast<unsigned int>(height), 1, VTK_FLOAT, values.data());
  ++this->NumberOfUploads;
}

//------------------------------------------------------------------------------
void Paint::UpdateColors(vtkDataArray* array, int width, int height)
{
  vtkMapper* mapper = this->Mapper;
  vtkScalarsToColors* table = mapper->GetLookupTable();
  const int mode = ColorModeOf(mapper, array, this->Heights);
  table->Build();
  if (!this->StartsToMake(
        this->Colors, StateOf(array, mode, mapper->GetArrayComponent(), table->GetMTime())))
  {
    return;
  }
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::Take(
    table->MapScalars(array, mode, mapper->GetArrayComponent(), VTK_RGBA));
  if (ImageHeights::AreRowsFromNorth(this->Heights))
  {
    const auto mapped = colors; // may be the array itself
    colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
    colors->DeepCopy(mapped);
    ImageHeights::ArrangeRows(
      this->Heights, colors->GetPointer(0), std::ptrdiff_t{ 4 } * width, height);
  }
  this->Colors.Texture->Create2DFromRaw(static_cast<unsigned int>(width),
    static_cast<unsigned int>(height), 4, VTK_UNSIGNED_CHAR, colors->GetPointer(0));
  ++this->NumberOfUploads;
}

//------------------------------------------------------------------------------
void Paint::UpdateColorMap()
{
  vtkMapper* mapper = this->Mapper;
  vtkScalarsToColors* table = mapper->GetLookupTable();
  if (!mapper->GetUseLookupTableScalarRange())
  {
    table->SetRange(mapper->GetScalarRange());
  }
  table->Build();
  if (!this->StartsToMake(this->ColorMap, StateOf(table)))
  {
    return;
  }
  double range[2] = { table->GetRange()[0], table->GetRange()[1] };
  this->Logarithm = table->UsingLogScale() != 0 && range[0] > 0.0 && range[1] > 0.0;
  const double below = range[0] - 1.0 - std::abs(range[0]);
  const double above = range[1] + 1.0 + std::abs(range[1]);
  this->SpecialColors = { ColorOf(table, this->Logarithm ? 0.5 * range[0] : below),
    ColorOf(table, above), ColorOf(table, vtkMath::Nan()) };
  if (this->Logarithm)
  {
    range[0] = std::log(range[0]);
    range[1] = std::log(range[1]);
  }
  const double width = range[1] > range[0] ? range[1] - range[0] : 1.0;
  this->ColorScale = { 1.0 / width, -range[0] / width };
  std::vector<double> values(kColorMapSize);
  for (int i = 0; i < kColorMapSize; ++i)
  {
    const double value = range[0] + (range[1] - range[0]) * (i + 0.5) / kColorMapSize;
    values[i] = this->Logarithm ? std::exp(value) : value;
  }
  std::vector<unsigned char> colors(std::size_t{ 4 } * kColorMapSize);
  table->MapScalarsThroughTable2(
    values.data(), colors.data(), VTK_DOUBLE, kColorMapSize, 1, VTK_RGBA);
  this->ColorMap.Texture->Create2DFromRaw(kColorMapSize, 1, 4, VTK_UNSIGNED_CHAR, colors.data());
}

//------------------------------------------------------------------------------
std::string Paint::UpdateDrape()
{
  vtkImageData* drape = this->Look->GetDrape();
  if (!drape || drape->GetNumberOfPoints() == 0 || this->Look->GetShowCrossings())
  {
    return {};
  }
  auto* texels = vtkUnsignedCharArray::SafeDownCast(drape->GetPointData()->GetScalars());
  const int* size = drape->GetDimensions();
  const int limit = vtkTextureObject::GetMaximumTextureSize(this->Window);
  if (!texels || texels->GetNumberOfComponents() > 4 || size[2] != 1)
  {
    return "The drape must be an image of W x H x 1 points with 1 to 4 unsigned chars";
  }
  if (limit > 0 && std::max(size[0], size[1]) > limit)
  {
    return "The drape has more than " + std::to_string(limit) + " pixels a side";
  }
  if (!this->StartsToMake(this->DrapeTexture, StateOf(drape)))
  {
    return {};
  }
  this->DrapeComponents = texels->GetNumberOfComponents();
  std::vector<unsigned char> copy;
  if (this->DrapeComponents % 2 == 0)
  {
    copy = Premultiplied(texels->GetPointer(0), texels->GetNumberOfTuples(), this->DrapeComponents);
  }
  vtkTextureObject* texture = this->DrapeTexture.Texture;
  texture->SetMinificationFilter(vtkTextureObject::LinearMipmapLinear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  texture->SetMaxLevel(16);
  texture->SetMaximumAnisotropicFiltering(Driver::Current().Anisotropy);
  texture->Create2DFromRaw(static_cast<unsigned int>(size[0]), static_cast<unsigned int>(size[1]),
    this->DrapeComponents, VTK_UNSIGNED_CHAR, copy.empty() ? texels->GetPointer(0) : copy.data());
  texture->Activate();
  glGenerateMipmap(GL_TEXTURE_2D);
  texture->Deactivate();
  ++this->NumberOfUploads;
  return {};
}

//------------------------------------------------------------------------------
bool Paint::IsTranslucent(vtkMapper* mapper, vtkImageData* heights, const vtkTerrainLook* look)
{
  if (!mapper->GetScalarVisibility() || !heights)
  {
    return false;
  }
  bool cells = false;
  vtkDataArray* array = look->GetColorSource() == ColorSources::Array
    ? FindArray(mapper, heights, cells)
    : heights->GetPointData()->GetScalars();
  vtkScalarsToColors* table = mapper->GetLookupTable();
  table->Build();
  return array &&
    table->IsOpaque(array, ColorModeOf(mapper, array, heights), mapper->GetArrayComponent()) == 0;
}

//------------------------------------------------------------------------------
void Paint::Activate()
{
  for (Made* made : this->Textures())
  {
    if (made->Used)
    {
      made->Texture->Activate();
    }
  }
}

//------------------------------------------------------------------------------
void Paint::Deactivate()
{
  for (Made* made : this->Textures())
  {
    if (made->Used)
    {
      made->Texture->Deactivate();
    }
  }
}

//------------------------------------------------------------------------------
void Paint::ReleaseGraphicsResources(vtkWindow* window)
{
  for (Made* made : this->Textures())
  {
    made->Texture->ReleaseGraphicsResources(window);
    made->From.clear();
  }
}

//------------------------------------------------------------------------------
glm::dvec2 Paint::ValueScale(const HeightCodes& codes) const
{
  if (this->Kind == PaintKinds::Height)
  {
    return { codes.Scale, codes.Offset };
  }
  return { 1.0, this->Kind == PaintKinds::Values ? this->ValueOffset : 0.0 };
}

//------------------------------------------------------------------------------
void Paint::SetColorUniforms(Uniforms& uniforms, const HeightCodes& codes) const
{
  const int texels = this->OfCells ? 1 : 4;
  const glm::ivec2 needed(
    this->Kind == PaintKinds::Values ? texels : 0, this->Kind == PaintKinds::Colors ? texels : 0);
  // Both scales in one, made in double: values may lie far from 0.
  const glm::dvec2 value = this->ValueScale(codes);
  const glm::dvec2 color = this->Logarithm
    ? this->ColorScale
    : glm::dvec2(this->ColorScale.x * value.x, this->ColorScale.x * value.y + this->ColorScale.y);
  uniforms.Set("terrainColorKind", static_cast<int>(this->Kind));
  uniforms.Set("terrainArrayTexels", needed);
  uniforms.SetArray("terrainSpecialColors", 3, this->SpecialColors.data());
  uniforms.Set("terrainValueScale", glm::vec2(value));
  uniforms.Set("terrainColorScale", glm::vec2(color));
  uniforms.Set("terrainColorLogarithm", this->Logarithm ? 1 : 0);
}

//------------------------------------------------------------------------------
void Paint::SetLineUniforms(Uniforms& uniforms, const HeightCodes& codes,
  const GridGeometry& geometry, const vtkTerrainLook* look) const
{
  const bool shown = !look->GetShowCrossings();
  const double azimuth = vtkMath::RadiansFromDegrees(look->GetHillshadeAzimuth());
  const double altitude = vtkMath::RadiansFromDegrees(look->GetHillshadeAltitude());
  const glm::vec3 sun(std::sin(azimuth) * std::cos(altitude),
    std::cos(azimuth) * std::cos(altitude), std::sin(altitude));
  uniforms.SetArray("terrainSunDirection", 1, &sun);
  uniforms.Set("terrainShadeRelief", static_cast<float>(geometry.Exaggeration));
  uniforms.Set("terrainShadeStrength", look->GetHillshade() && shown ? 1.0f : 0.0f);

  const double interval = look->GetContourInterval();
  // of the number of a line only what is left of whole groups counts
  const double group = std::max(look->GetContourIndex(), 1);
  const double number = codes.Offset / interval;
  std::array<double, 4> color{};
  look->GetContourColor(color.data());
  color[3] = look->GetContours() && shown ? color[3] : 0.0;
  uniforms.Set("terrainContourScale",
    glm::vec2(codes.Scale / interval, number - group * std::floor(number / group)));
  uniforms.Set("terrainContourIndex", static_cast<float>(look->GetContourIndex()));
  uniforms.Set("terrainContourWidth", static_cast<float>(look->GetContourWidth()));
  uniforms.Set("terrainContourColor", glm::vec4(color[0], color[1], color[2], color[3]));
}

//------------------------------------------------------------------------------
void Paint::SetUniforms(Uniforms& uniforms, const HeightCodes& codes, const GridGeometry& geometry,
  const vtkTerrainLook* look) const
{
  auto setTexture = [&](const char* name, const Made& made)
  {
    if (made.Used && uniforms.Uses(name))
    {
      uniforms.Set(name, made.Texture->GetTextureUnit());
    }
  };
  setTexture("terrainColorMap", this->ColorMap);
  setTexture("terrainValues", this->Values);
  setTexture("terrainColors", this->Colors);
  setTexture("terrainDrape", this->DrapeTexture);
  if (!uniforms.Uses("terrainColorKind"))
  {
    return;
  }
  this->SetColorUniforms(uniforms, codes);
  this->SetLineUniforms(uniforms, codes, geometry, look);
  uniforms.Set("terrainGradientScale", glm::vec2(codes.Scale / geometry.Spacing));
  uniforms.Set(
    "terrainMaximumShownCrossings", static_cast<float>(look->GetMaximumShownCrossings()));
  if (uniforms.Uses("terrainDrapeScale"))
  {
    std::array<double, 4> bounds{};
    look->GetDrapeBounds(bounds.data());
    const glm::dvec2 size(bounds[1] - bounds[0], bounds[3] - bounds[2]);
    const glm::dvec2 corner(bounds[0], bounds[2]);
    uniforms.Set("terrainDrapeScale",
      glm::vec4(
        glm::dvec4(geometry.Spacing / size, (glm::dvec2(geometry.Origin) - corner) / size)));
  }
}
}
