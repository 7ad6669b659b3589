// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Texts as coordinate systems, and as the options about places; any numbers as extents, origins,
// units and spacings: one sentence, or places on a world, finite in both coordinates or in none.
#include "FuzzImage.h"

#include "Arguments.h"
#include "PlaceOptions.h"

#include "vtkTerrainGeoreference.h"
#include "vtkTerrainViewpoint.h"

#include <CLI/CLI.hpp>

#include <array>
#include <string>
#include <vector>

namespace
{
using FrameType = vtkTerrainGeoreference::FrameType;
using HeightType = vtkTerrainGeoreference::HeightType;

/// Options of a command line; those without any where it is refused.
PlaceOptions OptionsOf(FuzzInput& input)
{
  PlaceOptions options;
  PlaceArguments arguments;
  CLI::App app("", "fuzz");
  arguments.Declare(app, options);
  std::vector<std::string> words;
  for (const char* name : { "--origin=", "--utm-zone=", "--cell=", "--look-from=", "--look-at=" })
  {
    const std::string text = input.Text();
    if (!text.empty())
    {
      words.push_back(name + text.substr(0, text.find('\0')));
    }
  }
  try
  {
    app.parse(words);
    arguments.Interpret(options);
  }
  catch (const CLI::ParseError& error)
  {
    Require(*error.what() != '\0');
    return {};
  }
  return options;
}

/// Of a definition; of a single letter one that has been read before, which takes no time.
vtkSmartPointer<vtkTerrainGeoreference> GeoreferenceOf(const std::string& system)
{
  static const std::array<const char*, 8> kSystems{ { "", "EPSG:4326", "EPSG:32633", "EPSG:3857",
    "EPSG:2154", "EPSG:4807", "+proj=longlat +R=1737400", "LOCAL_CS[\"x\",UNIT[\"m\",1]]" } };
  static std::array<vtkSmartPointer<vtkTerrainGeoreference>, kSystems.size()> known;
  auto georeference = vtkSmartPointer<vtkTerrainGeoreference>::New();
  if (system.size() == 1)
  {
    const std::size_t k = static_cast<unsigned char>(system[0]) % kSystems.size();
    if (!known[k])
    {
      known[k] = georeference;
      georeference->SetCoordinateSystem(kSystems[k]);
    }
    known[k]->SetAutomaticOrigin();
    return known[k];
  }
  const bool isFile = system.find('/') != std::string::npos;
  georeference->SetCoordinateSystem(isFile && system.find('[') == std::string::npos ? "" : system);
  return georeference;
}

void CheckOptions(const PlaceOptions& options)
{
  Require(options.Zone >= -1 && options.Zone <= 60);
  Require(options.Cell == 0.0 || (options.Cell >= 1e-3 && options.Cell <= 1e6));
  for (const double number : options.Origin.value_or(std::array<double, 3>{}))
  {
    Require(std::isfinite(number));
  }
}

void CheckPlaces(const std::vector<double>& places, bool isDone)
{
  for (std::size_t k = 0; isDone && k < places.size(); k += 3)
  {
    Require(std::isfinite(places[k]) == std::isfinite(places[k + 1]));
    Require(!std::isfinite(places[k + 1]) || std::abs(places[k + 1]) <= 90.0 + 1e-9);
  }
}

void CheckPoints(vtkTerrainGeoreference* georeference, std::vector<double> points)
{
  const auto count = static_cast<vtkIdType>(points.size() / 3);
  std::vector<double> places(points.size());
  std::vector<double> scene(points.size());
  CheckPlaces(places, georeference->FileToPlaces(points.data(), places.data(), count));
  georeference->FileToScene(points.data(), scene.data(), count);
  georeference->SceneToFile(scene.data(), scene.data(), count);
  CheckPlaces(places, georeference->SceneToPlaces(points.data(), places.data(), count));
  georeference->PlacesToScene(points.data(), scene.data(), count);
  georeference->PlacesToFile(points.data(), scene.data(), count);
  double axes[3][3];
  georeference->GetAxes(points.data(), axes[0], axes[1], axes[2]);
  Require(!georeference->GetReadout(points.data()).empty());
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  FuzzInput input(data, size);
  const vtkSmartPointer<vtkTerrainGeoreference> georeference = GeoreferenceOf(input.Text());
  const PlaceOptions options = OptionsOf(input);
  CheckOptions(options);
  georeference->SetFrame(options.Frame.value_or(static_cast<FrameType>(input.Number(6))));
  georeference->SetZone(
    options.Zone >= 0 ? options.Zone : input.Take<std::int8_t>(), options.Northern);
  const double reach = input.Number(2) != 0 ? 100.0 : 1e6;
  if (options.Origin)
  {
    georeference->SetOrigin((*options.Origin)[0], (*options.Origin)[1], (*options.Origin)[2]);
  }
  else if (input.Number(2) != 0)
  {
    const double x = HostileNumber(input, 200.0);
    const double y = HostileNumber(input, 100.0);
    georeference->SetOrigin(x, y, HostileNumber(input, 1e4));
  }
  georeference->SetVerticalExaggeration(HostileNumber(input, 10.0));
  georeference->SetHeightUnit(HostileNumber(input, 2.0));
  const double x = HostileNumber(input, reach);
  const double y = HostileNumber(input, reach);
  const vtkSmartPointer<vtkImageData> heights = HostileHeights(input, x, y, 0.01 * reach);
  georeference->SetFromHeights(heights);
  vtkTerrainGeoreference::SuggestFrame(heights);
  std::vector<double> points{ x, y, 0.0 };
  while (input.Left() > 0 && points.size() < 30)
  {
    points.push_back(HostileNumber(input, points.size() % 3 == 2 ? 1e4 : reach));
  }
  points.resize(points.size() / 3 * 3);
  CheckPoints(georeference, points);
  double sideways = 0.0;
  double drop = 0.0;
  georeference->GetFlatError(sideways, drop);
  georeference->GetSceneCoordinateSystem();
  const std::string why = georeference->GetWhyNot();
  Require(why.empty() || !georeference->HasPlaces());
  Require(why.find('\n') == std::string::npos);
  return 0;
}
