// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainColors.h"

#include "data/ColorDocument.h"
#include "parts/ColorsInternals.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"

#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

vtkStandardNewMacro(vtkTerrainColors);

namespace
{
/// Part of the range that lies below 0 from which on there is a sea.
constexpr double kLeastSea = 0.1;
constexpr double kNoDataGrey = 0.82;
/// Colour files are small; whatever is larger is something else.
constexpr std::streamoff kMostBytes = 16 << 20;

bool HasSea(vtkTerrainColors::SeaMode mode, double lowest, double highest)
{
  const bool isLikely = lowest < -kLeastSea * (highest - lowest);
  return mode == vtkTerrainColors::SeaMode::Always ||
    (mode == vtkTerrainColors::SeaMode::Automatic && isLikely);
}

/// The content of a file; false if it cannot be read.
bool ReadText(const std::string& path, std::string& text)
{
  if (vtksys::SystemTools::FileIsDirectory(path))
  {
    return false;
  }
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file || file.tellg() > kMostBytes)
  {
    return false;
  }
  file.seekg(0);
  text.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  return true;
}

terrain::ColorFileResult ReadByName(const std::string& suffix, const std::string& text)
{
  if (suffix == ".cpt")
  {
    return terrain::ReadColorPaletteTable(text);
  }
  if (suffix == ".qml")
  {
    return terrain::ReadStyle(text);
  }
  if (suffix == ".xml")
  {
    return terrain::ReadColorMapDocument(text);
  }
  if (suffix == ".json")
  {
    return terrain::ReadColorMapPresets(text);
  }
  if (suffix == ".csv")
  {
    return terrain::ReadClassTable(text);
  }
  const bool isMap = suffix == ".clr" || text.find("INTERPOLATION:") != std::string::npos;
  return isMap ? terrain::ReadColorMapText(text) : terrain::ReadColorReliefText(text);
}
}

//------------------------------------------------------------------------------
vtkTerrainColors::vtkTerrainColors()
  : Internals(std::make_unique<vtkInternals>())
{
}

vtkTerrainColors::~vtkTerrainColors() = default;

//------------------------------------------------------------------------------
int vtkTerrainColors::GetNumberOfSchemes()
{
  return static_cast<int>(terrain::ColorSchemeNames().size());
}

std::string vtkTerrainColors::GetSchemeName(int index)
{
  const std::vector<std::string> names = terrain::ColorSchemeNames();
  return index >= 0 && index < static_cast<int>(names.size()) ? names[index] : std::string();
}

//------------------------------------------------------------------------------
bool vtkTerrainColors::SetScheme(const std::string& name)
{
  this->ErrorMessage.clear();
  const std::optional<terrain::ColorScheme> scheme = terrain::FindColorScheme(name);
  if (!scheme)
  {
    this->ErrorMessage = "there is no colour scheme '" + name + "'; there are";
    for (const std::string& known : terrain::ColorSchemeNames())
    {
      this->ErrorMessage += " " + known;
    }
    return false;
  }
  this->Internals->Scheme = *scheme;
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
bool vtkTerrainColors::ReadFile(const std::string& path)
{
  this->ErrorMessage.clear();
  const std::string suffix =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(path));
  std::string text;
  if (suffix != ".cpt" && suffix != ".txt" && suffix != ".clr" && suffix != ".qml" &&
    suffix != ".xml" && suffix != ".json" && suffix != ".csv")
  {
    this->ErrorMessage =
      "'" + path + "' is no colour file: .cpt, .txt, .clr, .qml, .xml, .json or .csv";
  }
  else if (!ReadText(path, text))
  {
    this->ErrorMessage = "'" + path + "' cannot be read";
  }
  else
  {
    terrain::ColorFileResult result = ReadByName(suffix, text);
    if (result.WhyNot.empty())
    {
      this->Internals->Scheme = std::move(result.Scheme);
      this->Modified();
    }
    else
    {
      this->ErrorMessage = "'" + path + "' has no colours that can be read: " + result.WhyNot;
    }
  }
  return this->ErrorMessage.empty();
}

//------------------------------------------------------------------------------
bool vtkTerrainColors::SetSchemeOrFile(const std::string& nameOrPath)
{
  const bool isFile = vtksys::SystemTools::FileExists(nameOrPath) ||
    !vtksys::SystemTools::GetFilenameLastExtension(nameOrPath).empty();
  return terrain::FindColorScheme(nameOrPath) || !isFile ? this->SetScheme(nameOrPath)
                                                         : this->ReadFile(nameOrPath);
}

//------------------------------------------------------------------------------
void vtkTerrainColors::SetSea(SeaMode sea)
{
  if (this->Sea != sea)
  {
    this->Sea = sea;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkColorTransferFunction> vtkTerrainColors::MakeTable(double lowest, double highest)
{
  terrain::ColorScheme scheme = this->Internals->Scheme;
  if (this->Reverse)
  {
    scheme = terrain::Reversed(scheme);
  }
  if (this->Range[0] < this->Range[1] && scheme.Along == terrain::ColorScheme::Axis::Values)
  {
    scheme = terrain::Stretched(scheme, this->Range[0], this->Range[1]);
  }
  else
  {
    terrain::ColorRange range;
    const bool isGiven = this->Range[0] < this->Range[1];
    range.Lowest = isGiven ? this->Range[0] : lowest;
    range.Highest = isGiven ? this->Range[1] : highest;
    range.HasSea = HasSea(this->Sea, range.Lowest, range.Highest);
    scheme = terrain::LaidOver(scheme, range);
  }

  auto table = vtkSmartPointer<vtkColorTransferFunction>::New();
  for (std::size_t k = 0; k < scheme.Stops.size(); ++k)
  {
    const terrain::ColorStop& stop = scheme.Stops[k];
    // VTK has one colour for a value: the lower one of a step ends just below it
    const bool endsBelow = k + 1 < scheme.Stops.size() && scheme.Stops[k + 1].Value == stop.Value;
    table->AddRGBPoint(
      endsBelow ? std::nextafter(stop.Value, -std::numeric_limits<double>::infinity()) : stop.Value,
      stop.Shade.r, stop.Shade.g, stop.Shade.b);
  }
  const auto set = [](const std::optional<terrain::Color>& color, auto&& use)
  {
    if (color)
    {
      use(color->r, color->g, color->b);
    }
  };
  set(scheme.None.value_or(terrain::Color(kNoDataGrey)),
    [&](double r, double g, double b) { table->SetNanColor(r, g, b); });
  set(scheme.Below,
    [&](double r, double g, double b)
    {
      table->SetBelowRangeColor(r, g, b);
      table->UseBelowRangeColorOn();
    });
  set(scheme.Above,
    [&](double r, double g, double b)
    {
      table->SetAboveRangeColor(r, g, b);
      table->UseAboveRangeColorOn();
    });
  return table;
}

//------------------------------------------------------------------------------
int vtkTerrainColors::GetNumberOfCategories() const
{
  return static_cast<int>(this->Internals->Scheme.Classes.size());
}

std::string vtkTerrainColors::GetCategoryName(int index) const
{
  return index >= 0 && index < this->GetNumberOfCategories()
    ? this->Internals->Scheme.Classes[index].Name
    : std::string();
}

double vtkTerrainColors::GetCategoryValue(int index) const
{
  return index >= 0 && index < this->GetNumberOfCategories()
    ? this->Internals->Scheme.Classes[index].Value
    : 0.0;
}

//------------------------------------------------------------------------------
void vtkTerrainColors::FillTable(vtkColorTransferFunction* table, double lowest, double highest)
{
  if (table)
  {
    table->DeepCopy(this->MakeTable(lowest, highest));
  }
}

//------------------------------------------------------------------------------
void vtkTerrainColors::GetCategoryColor(int index, double rgb[3]) const
{
  const double value = this->GetCategoryValue(index);
  const terrain::Color color = terrain::ColorOf(this->Internals->Scheme, value);
  std::copy_n(&color[0], 3, rgb);
}

bool vtkTerrainColors::IsDiscrete() const
{
  return terrain::IsDiscrete(this->Internals->Scheme);
}

vtkSmartPointer<vtkFloatArray> vtkTerrainColors::FindCategories(vtkDataArray* values) const
{
  std::vector<double> numbers(static_cast<std::size_t>(values->GetNumberOfTuples()));
  for (std::size_t k = 0; k < numbers.size(); ++k)
  {
    numbers[k] = values->GetComponent(static_cast<vtkIdType>(k), 0);
  }
  auto categories = vtkSmartPointer<vtkFloatArray>::New();
  categories->SetNumberOfValues(values->GetNumberOfTuples());
  vtkIdType at = 0;
  for (const int found : terrain::ClassesOf(this->Internals->Scheme, numbers))
  {
    categories->SetValue(
      at++, found < 0 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(found));
  }
  return categories;
}

//------------------------------------------------------------------------------
void vtkTerrainColors::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Reverse: " << (this->Reverse ? "on" : "off") << "\n";
  os << indent << "Range: " << this->Range[0] << " " << this->Range[1] << "\n";
  os << indent << "Sea: " << static_cast<int>(this->Sea) << "\n";
  os << indent << "Colours: " << this->Internals->Scheme.Stops.size() << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
