// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "render/Features.h"

#include "core/rays/HeightSearch.h"
#include "core/rays/PyramidBeam.h"
#include "core/rays/ShadowBounds.h"
#include "core/surface/Columns.h"
#include "core/surface/HeightSlopes.h"

#include <array>
#include <bitset>
#include <iomanip>
#include <locale>
#include <sstream>

namespace terrain
{
namespace
{
template <typename Value>
std::string Define(const char* name, Value value)
{
  std::ostringstream line;
  line.imbue(std::locale::classic());
  line << "#define " << name << " (" << std::scientific << std::setprecision(9) << value << ")\n";
  return line.str();
}

std::string DefineIf(const char* name, bool is)
{
  return is ? std::string("#define ") + name + "\n" : std::string();
}

/// A number that #if may compare; nothing for 0.
std::string DefineNumber(const char* name, int number)
{
  return number != 0 ? std::string("#define ") + name + " " + std::to_string(number) + "\n"
                     : std::string();
}
}

//------------------------------------------------------------------------------
bool Features::operator==(const Features& other) const
{
  return MembersOf(*this) == MembersOf(other);
}

//------------------------------------------------------------------------------
int Features::Shadows() const
{
  return static_cast<int>(
    std::bitset<kMostShadows>(static_cast<unsigned>(this->ShadowMask)).count());
}

//------------------------------------------------------------------------------
std::string Features::Defines() const
{
  static constexpr std::array<const char*, 6> ways{ "TERRAIN_NONE", "TERRAIN_MESH",
    "TERRAIN_LINEAR", "TERRAIN_EXPONENTIAL", "TERRAIN_EQUIDISTANT", "TERRAIN_PYRAMID" };
  std::string lines = "#extension GL_ARB_gpu_shader_fp64 : enable\n";
  if (this->Gathers)
  {
    lines += "#extension GL_ARB_texture_gather : enable\n"
             "#ifdef GL_ARB_texture_gather\n"
             "#define TERRAIN_GATHER\n"
             "#endif\n";
  }
  return lines + DefineIf(ways[static_cast<std::size_t>(this->Way)], true) +
    DefineIf("TERRAIN_CAST", this->CastsRays()) +
    DefineIf("TERRAIN_HEIGHTS_INTEGER", this->IntegerHeights) +
    DefineIf("TERRAIN_PYRAMID_BUFFER", this->BuffersPyramid) +
    DefineIf("TERRAIN_GLOBE", this->Globe) + DefineIf("TERRAIN_TILES", this->Tiles) +
    DefineIf("TERRAIN_DETAIL", this->Detail) + DefineIf("TERRAIN_COLUMNS", this->Columns) +
    DefineIf("TERRAIN_WITHIN", this->Within) + DefineIf("TERRAIN_BLOCK", this->Block) +
    DefineIf("TERRAIN_BELOW_BOX", this->BelowBox) +
    DefineIf("TERRAIN_READ_SIGHTINGS", this->ReadsSightings) +
    DefineIf("TERRAIN_DEPTH_OFFSET", this->ShiftsDepth) +
    DefineIf("TERRAIN_TEXTURED", this->Textured) + DefineIf("TERRAIN_PAINT", this->Paints) +
    DefineNumber("TERRAIN_CLIP_PLANES", this->ClipPlanes) +
    DefineNumber("TERRAIN_BEAM_PIXELS", this->BeamPixels) +
    DefineNumber("TERRAIN_DRAPE", this->DrapeComponents) +
    DefineNumber("TERRAIN_SHADOWS", this->Shadows()) +
    DefineIf("TERRAIN_READ_LIGHTS", this->ReadsLights) + DefineIf("TERRAIN_SKY", this->Sky) +
    DefineIf("TERRAIN_SHADOW_BOUNDS", this->BoundsShadows);
}

//------------------------------------------------------------------------------
std::string Features::Constants()
{
  static constexpr std::array<const char*, 7> kinds{ "terrainOfMaterial", "terrainOfHeight",
    "terrainOfSlope", "terrainOfAspect", "terrainOfValues", "terrainOfColors",
    "terrainOfCrossings" };
  std::string lines = Define("terrainBeamSteps", kBeamSteps) +
    Define("terrainBeamMargin", kBeamMargin) + Define("terrainBeamReach", kBeamReach) +
    Define("terrainColumnReach", kColumnReach) + Define("terrainJustBelow", kJustBelow) +
    Define("terrainFirstSlopeLevel", 1.0 * kFirstSlopeLevel) +
    Define("terrainShadowMargin", kShadowMargin) + Define("terrainShareSteps", 1.0 * kShareSteps) +
    Define("terrainNotANumber", kNotANumber) + Define("terrainColorMapSize", kColorMapSize) +
    DefineNumber("TERRAIN_GROUP_SIZE", kGroupSize);
  for (std::size_t kind = 0; kind < kinds.size(); ++kind)
  {
    lines += Define(kinds[kind], kind);
  }
  return lines;
}
}
