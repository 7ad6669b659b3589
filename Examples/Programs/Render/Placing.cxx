// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Placing.h"

#include "Failure.h"
#include "Messages.h"
#include "Options.h"
#include "Progress.h"
#include "Statistics.h"
#include "Terrain.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTerrainGeoid.h"
#include "vtkTerrainGeoreference.h"
#include "vtkTerrainGlobe.h"
#include "vtkTerrainReproject.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace
{
using FrameType = vtkTerrainGeoreference::FrameType;
using HeightType = vtkTerrainGeoreference::HeightType;

/// A scene as the options describe it, of the frame Grid unless they name one.
vtkSmartPointer<vtkTerrainGeoreference> DescribeScene(
  vtkImageData* image, const PlaceOptions& options)
{
  auto scene = vtkSmartPointer<vtkTerrainGeoreference>::New();
  scene->SetFromHeights(image);
  scene->SetFrame(options.Frame.value_or(FrameType::Grid));
  if (options.Origin)
  {
    scene->SetOrigin((*options.Origin)[0], (*options.Origin)[1], (*options.Origin)[2]);
  }
  scene->SetZone(options.Zone, options.Northern);
  scene->SetSceneHeights(options.Vertical);
  if (!options.Geoid.empty())
  {
    scene->GetGeoid()->SetModel(options.Geoid);
  }
  return scene;
}

constexpr const char* kDegrees = "looks like degrees";

/// True if the reader of heights has warned with a text.
bool HasWarned(vtkImageData* heights, const std::string& text)
{
  auto* told = vtkStringArray::SafeDownCast(heights->GetFieldData()->GetAbstractArray("Warnings"));
  for (vtkIdType k = 0; told && k < told->GetNumberOfValues(); ++k)
  {
    if (told->GetValue(k).find(text) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

/// Sets the frame of a scene of the frame Grid for which the options name none. Returns what there
/// is to warn of.
std::string ChooseFrame(PlacedHeights& placed, const std::string& name)
{
  const vtkNew<vtkTerrainGeoreference> ground;
  ground->SetFromHeights(placed.Image);
  const bool inDegrees = ground->IsGeographic();
  if (!ground->GetWhyNot().empty())
  {
    if (inDegrees)
    {
      throw Failure(name, ground->GetWhyNot());
    }
    return placed.Georeference->GetWhyNot();
  }
  placed.Georeference->SetFrame(vtkTerrainGeoreference::SuggestFrame(placed.Image));
  if (placed.Georeference->GetFrame() == FrameType::Plane)
  {
    return {};
  }
  if (placed.Georeference->GetWhyNot().empty())
  {
    // of degrees the reader may have told already
    const std::string warning = placed.Georeference->GetWarning();
    return warning.empty() || HasWarned(placed.Image, kDegrees) ? std::string()
      : warning.find(kDegrees) != std::string::npos
      ? warning + " (--crs EPSG:4326 for longitude and latitude)"
      : warning + " (--frame local)";
  }
  return std::string("it reaches too far for a flat scene, and is laid out as a map that is true "
                     "to scale in its middle: ") +
    (inDegrees ? "--frame globe" : "--frame local") + " shows the earth round";
}

/// Empty if the scene has places on earth, else why not.
std::string WhyNoPlaces(vtkTerrainGeoreference* scene)
{
  std::string why = scene->GetWhyNot();
  if (!why.empty() || scene->IsOnEarth())
  {
    return why;
  }
  if (scene->IsOnOtherWorld())
  {
    return "its coordinate system '" + scene->GetCoordinateSystemName() +
      "' is of another world (--graticule degrees and --scale-bar are drawn there)";
  }
  return scene->GetCoordinateSystem().empty()
    ? "it has no coordinate system (--crs names one)"
    : "its coordinate system '" + scene->GetCoordinateSystemName() + "' is tied to no place";
}

/// True for the frame Globe, named or the one that suits.
bool IsGlobe(vtkImageData* image, const Options& options)
{
  const PlaceOptions& wanted = options.Place;
  return wanted.Frame
    ? *wanted.Frame == FrameType::Globe
    : !wanted.IsMap && wanted.Cell == 0.0 && wanted.Vertical == HeightType::AsIs &&
      options.Search == vtkTerrainLook::Techniques::Pyramid && options.Detail.File.empty() &&
      vtkTerrainGlobe::Suits(image);
}

/// What a globe cannot do.
void RefuseOnGlobe(const Options& options)
{
  const PlaceOptions& wanted = options.Place;
  const auto refuse = [](bool is, const char* option, const char* instead)
  {
    if (is)
    {
      throw Failure(option, std::string("does not go with --frame globe: ") + instead);
    }
  };
  refuse(options.Search != vtkTerrainLook::Techniques::Pyramid, "--technique",
    "leave it at pyramid, or choose --frame map");
  refuse(!options.Detail.File.empty(), "--detail", "choose --frame map");
  refuse(wanted.Cell > 0.0, "--cell", "heights are drawn as they are");
  refuse(wanted.Cubic, "--cubic", "heights are drawn as they are, or choose --frame map");
  refuse(wanted.Vertical != HeightType::AsIs, "--vertical", "heights count from the ellipsoid");
  refuse(options.Surface.Block > 0.0, "--block", "choose --frame map");
  refuse(options.Marks.ContourLabels, "--contour-labels", "choose --frame map");
  refuse(!options.Marks.Outline.empty(), "--outline", "choose --frame map");
  refuse(options.Marks.HeightScale, "--height-scale", "choose --frame map");
  refuse(options.Marks.Inset, "--inset", "choose --frame map");
  refuse(options.Light.SkyLight > 0.0, "--sky-light", "choose --frame map");
  refuse(!options.Light.Sun.empty() && !options.Light.NeedsPlace(), "--sun",
    "a direction differs over a globe, give a date and time");
  refuse(wanted.ScaleBar, "--scale-bar", "scales differ over a globe, choose --frame map");
  refuse(wanted.NorthArrow, "--north-arrow", "choose --frame map");
}

vtkSmartPointer<vtkImageData> LayOnGlobe(vtkImageData* image, const std::string& name,
  const std::vector<vtkSmartPointer<vtkImageData>>& finer = {})
{
  const vtkNew<vtkTerrainGlobe> globe;
  globe->SetInputData(image);
  for (vtkImageData* other : finer)
  {
    globe->AddFinerData(other);
  }
  globe->Update();
  ThrowOnError(name);
  return globe->GetOutput();
}

vtkSmartPointer<vtkImageData> Resample(
  const PlacedHeights& placed, const Options& options, ProgressBar& progress)
{
  // more samples a side than this fit into no texture of common drivers
  constexpr double kMostSamples = 16384.0;
  const vtkNew<vtkTerrainReproject> filter;
  filter->SetInputData(placed.Image);
  filter->SetGeoreference(placed.Georeference);
  filter->SetSpacing(options.Place.Cell);
  filter->SetInterpolation(options.Place.Cubic ? vtkTerrainReproject::InterpolationType::Cubic
                                               : vtkTerrainReproject::InterpolationType::Bilinear);
  progress.Watch(filter, kPlaceShare, "placing");
  filter->UpdateInformation();
  ThrowOnError(HeightsName(options));
  vtkInformation* info = filter->GetOutputInformation(0);
  const int* extent = info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
  const double longest = std::max(extent[1], extent[3]) + 1.0;
  if (options.Place.Cell == 0.0 && longest > kMostSamples)
  {
    filter->SetSpacing(info->Get(vtkDataObject::SPACING())[0] * longest / (kMostSamples - 2.0));
  }
  filter->Update();
  ThrowOnError(HeightsName(options));
  return filter->GetOutput();
}

/// What cannot be had where the ground at a place is that of one of several rasters.
void RefuseBesideFiner(const Options& options)
{
  for (const auto& [option, isGiven] : { std::pair("--track", !options.Place.Tracks.empty()),
         std::pair("--labels", !options.Marks.Labels.empty()),
         std::pair("--peaks", options.Marks.Peaks > 0),
         std::pair("--graticule", options.Place.Graticule.has_value()) })
  {
    if (isGiven)
    {
      throw Failure(option,
        "does not go with --finer: join the rasters at one resolution (gdalbuildvrt -resolution "
        "highest)");
    }
  }
}

/// Lays the heights and those of finer cells on the globe, the finest first: all others give way.
void LayAllOnGlobe(PlacedHeights& placed, const Options& options, ProgressBar& progress)
{
  struct Raster
  {
    std::string Name;
    vtkSmartPointer<vtkImageData> Image;
    bool IsMain = false;
  };
  std::vector<Raster> rasters{ { HeightsName(options), placed.Image, true } };
  for (const std::string& path : options.Place.Finer)
  {
    Options own = options;
    own.Heights = path;
    Statistics unused;
    rasters.push_back({ path, ReadHeights(own, false, progress, unused).Image });
  }
  std::stable_sort(rasters.begin(), rasters.end(),
    [](const Raster& a, const Raster& b)
    { return a.Image->GetSpacing()[1] < b.Image->GetSpacing()[1]; });
  std::vector<vtkSmartPointer<vtkImageData>> laid;
  for (const Raster& raster : rasters)
  {
    laid.push_back(LayOnGlobe(raster.Image, raster.Name, laid));
    if (raster.IsMain)
    {
      placed.Image = laid.back();
    }
    else
    {
      placed.Finer.push_back(laid.back());
      placed.FinerNames.push_back(raster.Name);
    }
  }
}

/// Lays heights, whose scene is described, on a globe.
void PlaceOnGlobe(PlacedHeights& placed, const Options& options, ProgressBar& progress)
{
  placed.Georeference->SetFrame(FrameType::Globe);
  const auto refuse = [&placed, &options]
  {
    if (!placed.Georeference->GetWhyNot().empty())
    {
      throw Failure(HeightsName(options), placed.Georeference->GetWhyNot());
    }
  };
  if (!placed.Georeference->IsGeographic())
  {
    refuse();
  }
  RefuseOnGlobe(options);
  if (!options.Place.Finer.empty())
  {
    RefuseBesideFiner(options);
  }
  LayAllOnGlobe(placed, options, progress);
  placed.Georeference->SetFromHeights(placed.Image); // without what a globe leaves out of a raster
  refuse();
}

/// Sets the frame of heights that are drawn flat: a warning, or nothing.
std::string SetFlatFrame(PlacedHeights& placed, const Options& options)
{
  const std::string name = HeightsName(options);
  if (!options.Place.Finer.empty())
  {
    throw Failure("--finer", "rasters of several resolutions are drawn on a globe (--frame globe)");
  }
  std::string warning;
  if (!options.Place.Frame)
  {
    warning = ChooseFrame(placed, name);
  }
  else if (!placed.Georeference->GetWhyNot().empty())
  {
    throw Failure(name, placed.Georeference->GetWhyNot());
  }
  if (placed.Georeference->GetFrame() == FrameType::Local)
  {
    // heights alone, not the earth's curve
    placed.Georeference->SetVerticalExaggeration(placed.Factor);
    placed.Exaggeration = 1.0;
  }
  return warning;
}

/// Fails if an option needs places that there are not.
void RequirePlaces(const PlacedHeights& placed, const Options& options)
{
  const char* option = options.Place.FirstThatNeedsPlaces(); // a graticule, if that is the only one
  const bool isDrawnAnywhere = option && option == std::string("--graticule");
  if (option && !placed.WhyNoPlaces.empty() &&
    !(isDrawnAnywhere && placed.Georeference->HasPlaces()))
  {
    throw Failure(HeightsName(options),
      std::string(option) + " needs to know where it is, but " + placed.WhyNoPlaces);
  }
}
}

//------------------------------------------------------------------------------
PlacedHeights PlaceHeights(
  vtkImageData* read, const Options& options, ProgressBar& progress, Statistics& statistics)
{
  const Stopwatch watch;
  const std::string name = HeightsName(options);
  const PlaceOptions& wanted = options.Place;
  PlacedHeights placed;
  placed.Image = read;
  const bool isAlone = DrawsFileAlone(options);
  placed.Factor = options.Exaggeration.Choose(read, !isAlone && IsGlobe(read, options));
  placed.Exaggeration = placed.Factor;
  statistics.SetNumber("exaggeration", placed.Factor);
  if (isAlone)
  {
    placed.Georeference = vtkSmartPointer<vtkTerrainGeoreference>::New();
    placed.WhyNoPlaces = "its samples are not read";
    return placed;
  }
  placed.Georeference = DescribeScene(placed.Image, wanted);
  if (IsGlobe(placed.Image, options))
  {
    PlaceOnGlobe(placed, options, progress);
    CountSamples(placed.Image, statistics);
    statistics.AddTime("place", watch.GetMilliseconds());
    statistics.SetText("crs", placed.Georeference->GetCoordinateSystemName());
    return placed;
  }
  const std::string warning = SetFlatFrame(placed, options);
  if (placed.Georeference->GetFrame() != FrameType::Grid || wanted.Cell > 0.0 ||
    wanted.Vertical != HeightType::AsIs)
  {
    placed.Image = Resample(placed, options, progress);
    CountSamples(placed.Image, statistics);
    statistics.AddTime("place", watch.GetMilliseconds());
  }
  placed.WhyNoPlaces = WhyNoPlaces(placed.Georeference);
  RequirePlaces(placed, options);
  if (!warning.empty())
  {
    Warn(name + ": " + warning);
    statistics.AddText("warnings", warning);
  }
  statistics.SetText("crs", placed.Georeference->GetCoordinateSystemName());
  return placed;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTerrainViewpoint> MakeViewpoint(const PlacedHeights& heights)
{
  std::vector<vtkImageData*> images{ heights.Image };
  images.insert(images.end(), heights.Sites.begin(), heights.Sites.end());
  images.insert(images.end(), heights.Finer.begin(), heights.Finer.end());
  if (!heights.Finer.empty())
  {
    std::stable_sort(images.begin(), images.end(),
      [](vtkImageData* a, vtkImageData* b) { return a->GetSpacing()[1] < b->GetSpacing()[1]; });
  }
  auto viewpoint = vtkSmartPointer<vtkTerrainViewpoint>::New();
  viewpoint->SetGeoreference(heights.Georeference);
  viewpoint->SetExaggeration(heights.Exaggeration);
  viewpoint->SetHeights(images.front());
  std::for_each(images.begin() + 1, images.end(),
    [&viewpoint](vtkImageData* image) { viewpoint->AddHeights(image); });
  return viewpoint;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> PlaceBeside(
  const PlacedHeights& first, vtkImageData* read, const Options& options, ProgressBar& progress)
{
  if (first.IsGlobe())
  {
    return LayOnGlobe(read, HeightsName(options));
  }
  const PlaceOptions& wanted = options.Place;
  const bool isGrid = first.Georeference->GetFrame() == FrameType::Grid;
  if (isGrid && wanted.Cell == 0.0 && wanted.Vertical == HeightType::AsIs)
  {
    if (first.Georeference->IsGeographic())
    {
      throw Failure(
        HeightsName(options), "maps in degrees are laid out round the middle of each site");
    }
    return read;
  }
  PlacedHeights other = first;
  other.Image = read;
  return Resample(other, options, progress);
}
