// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What the options of scenes are: the same in every program that reads scenes.
 */
#ifndef terrain_common_SceneNames_h
#define terrain_common_SceneNames_h

#include "SceneFile.h"

/// Of the scenes of terrain-render.
inline SceneNames NamesOfRenderScenes()
{
  SceneNames names;
  names.Files = { "heights", "drape", "track", "polygons", "labels", "output", "depth", "stats" };
  names.FilesOrWords = { "colors", "track-colors", "polygon-colors", "color-by", "detail",
    "flight" };
  names.Others = { "help", "version", "describe" };
  names.Rivals = { { "camera", "look-from" }, { "camera", "look-at" } };
  return names;
}

#endif
