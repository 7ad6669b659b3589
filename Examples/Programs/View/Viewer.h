// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The window: a terrain, what stands around it, and what keys do.
 */
#ifndef terrain_view_Viewer_h
#define terrain_view_Viewer_h

#include "BlockWalls.h"
#include "Clipboard.h"
#include "FileDialog.h"
#include "LightOptions.h"
#include "Measure.h"
#include "Palettes.h"
#include "Readout.h"
#include "RecordedFlight.h"
#include "TerrainStyle.h"
#include "TypedPath.h"
#include "ViewOptions.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkOrientationMarkerWidget.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkSmartPointer.h"
#include "vtkTerrainActor.h"
#include "vtkTerrainCoarseMesh.h"
#include "vtkTerrainOutputFile.h"
#include "vtkTerrainPicker.h"
#include "vtkTextActor.h"

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace terrain
{
class TileSource;
}

class Viewer
{
public:
  /// Of heights that have a surface, read from the file `name`, which no picture replaces.
  Viewer(vtkImageData* heights, const std::string& name, int width, int height);

  /// Adds the walls of the terrain's block along the edge of the data of its heights, or of all of
  /// it in layers; warns in place of that if tiles are drawn, whose surface they would not meet.
  void AddWalls(vtkImageData* heights, bool areTilesDrawn, const std::vector<Stratum>& strata);

  /// Adds the heights of another site of the same CRS, which look as the first do.
  void AddSite(vtkImageData* heights, const std::shared_ptr<terrain::TileSource>& tiles);

  /// Lowest and highest height of all sites.
  std::array<double, 2> GetHeightRange() const;

  /// Colours by the palette that the keys choose.
  void UsePalette();

  /// Names another file that is read, which no picture replaces.
  void KeepFile(const std::string& name)
  {
    this->Picture->AddInput(name);
  }

  vtkTerrainActor* GetTerrain()
  {
    return this->Terrain;
  }

  /// Sun, shadows and sky. Throws a Failure.
  void SetLight(const LightOptions& options);

  /// Looks from where the options say, if they do. Throws a Failure.
  void Look(const ViewOptions& options);

  /// Values of options as the window shows them, by their names; none: it is not given.
  using SceneValues = std::map<std::string, std::vector<std::string>>;
  /// What makes the text of a scene that lies at a path, with such values.
  void SetSceneWriter(std::function<std::string(const std::string&, const SceneValues&)> writer)
  {
    this->WriteScene = std::move(writer);
  }

  /// Names the file of the scenes that are saved; empty for a free name each time. Files that are
  /// read, it never replaces.
  void SetSceneFile(const std::string& name, const std::vector<std::string>& inputs)
  {
    this->SceneFile = name;
    this->SceneInputs = inputs;
  }

  /// Saves the scene for the next time, as what a path names; tells nobody but of failures.
  void SaveSession(const std::string& path) const;

  /// What says in one sentence why a file that is opened cannot be shown; empty if it can.
  void SetOpener(std::function<std::string(const std::string&)> whyNot)
  {
    this->WhyNotShown = std::move(whyNot);
  }

  /// The file that is to be shown next; empty for none.
  const std::string& GetNext() const
  {
    return this->Next;
  }

  /// Shows the window until it is closed, or another file is opened.
  void Run();

  /// What the keys do, one a line.
  static const char* GetHelp();

private:
  void AddTexts();
  void AddScalarBar();
  void AddMarker();
  void AddLights();
  void AddMesh(vtkImageData* heights);
  void Connect();

  void MapKeys();
  void TypeKey(char key);
  void SwitchProjection();
  void SetTechnique(int technique);
  void Exaggerate(double factor);
  void ShowAll();
  void ShowNext();
  /// Makes the other sites look as the first.
  void MatchSites();
  std::string DescribeShown() const;
  void PrintPosition();
  void SavePicture();
  void SaveScene();
  /// The first of NAME.EXTENSION, NAME-2.EXTENSION, ... that does not exist.
  static std::string FreeName(const std::string& name, const std::string& extension);
  /// Writes a file that is none of those that are read, and tells of it as `what` it is.
  void SaveText(const std::string& name, const std::string& text, const std::string& what);
  /// Longitude, latitude, true height of a point as it is drawn, or its coordinates, with commas;
  /// empty if its place is not known.
  std::string DescribePoint(const std::array<double, 3>& drawn, bool asPlace) const;
  void DescribeCamera(SceneValues& values) const;
  void DescribeColors(SceneValues& values) const;
  SceneValues DescribeScene() const;
  /// A point at its true height as it is drawn, or back.
  std::array<double, 3> ToDrawn(const std::array<double, 3>& point, bool isBack) const;
  /// The point of the terrain, z as drawn, of a place's text.
  std::array<double, 3> FindPoint(const std::string& option, const std::string& text) const;
  void CopyPlace();
  /// Asks for a file: by a dialog, or where there is none by a path that is typed.
  void AskForFile();
  void OpenFile(const std::string& name);
  void PollDialog();
  /// Takes a key while a path is typed.
  void TypePath(char key);
  void FilesDropped(vtkObject* caller, unsigned long event, void* files);
  void MeasureChanged();
  void Close();

  FlightView GetView() const;
  void SetView(const FlightView& view);
  void AddToFlight();
  void DropFromFlight();
  /// Notes what is missing if there are no two views.
  bool HasFlight();
  /// Plays the flight, or stops it.
  void SwitchFlight();
  void FlyOn();
  /// The flight as a table that `terrain-render --flight` reads.
  std::string DescribeFlight() const;
  void SaveFlight();

  /// Brings texts, bar and mesh up to date with the terrain, and draws.
  void Refresh();
  void PointerMoved();
  void TimePassed(vtkObject* caller, unsigned long event, void* timer);
  /// Shows the position under the pointer, if it has moved.
  void TellPosition();

  /// A terrain beside the first, and what its places are.
  struct Site
  {
    vtkSmartPointer<vtkTerrainActor> Terrain;
    std::unique_ptr<Readout> Places;
  };

  Readout Places;
  std::vector<Site> Sites;
  /// What ShowAll frames: 0 all, 1 the first terrain, 2 and on the others.
  std::size_t Shown = 0;
  Palette Colors = Palette::Relief;
  /// What each key does.
  std::map<char, std::function<void()>> Keys;
  bool PointerHasMoved = false;
  /// True if the options have said from where to look.
  bool HasView = false;
  /// True if the keys have chosen the colours.
  bool HasPalette = false;
  /// What was done last, behind the status.
  std::string Note;
  std::string Next;
  std::string SceneFile;
  std::vector<std::string> SceneInputs;
  std::function<std::string(const std::string&, const SceneValues&)> WriteScene;
  std::function<std::string(const std::string&)> WhyNotShown;
  Clipboard Board;
  FileDialog Dialog;
  TypedPath Typing;
  RecordedFlight Flight;
  int FlightTimer = 0;
  vtkNew<vtkTerrainActor> Terrain;
  vtkNew<vtkTerrainPicker> Picker;
  vtkNew<TerrainStyle> Style;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkOrientationMarkerWidget> Marker;
  vtkNew<vtkLight> Sun;
  vtkNew<vtkLight> EyeLight;
  vtkNew<vtkScalarBarActor> ScalarBar;
  vtkNew<vtkTextActor> Status;
  vtkNew<vtkTextActor> Position;
  vtkNew<vtkTextActor> Help;
  vtkNew<vtkTextActor> Measured;
  vtkNew<vtkTerrainCoarseMesh> Mesh;
  vtkNew<vtkPolyDataMapper> MeshMapper;
  vtkNew<vtkActor> MeshActor;
  vtkSmartPointer<vtkActor> Walls;
  vtkNew<vtkTerrainOutputFile> Picture;
  std::unique_ptr<Measure> Measuring; // after all that it is about
};

#endif
