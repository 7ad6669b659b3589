// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Colours of marks by a field of their features, as the command line asks for them.
 */
#ifndef terrain_render_FieldOptions_h
#define terrain_render_FieldOptions_h

#include "vtkSmartPointer.h"

#include <string>
#include <utility>

class vtkTerrainColors;
namespace CLI
{
class App;
}

struct FieldOptions
{
  /// Of marks of a kind: their word begins the names of the options ("track").
  explicit FieldOptions(std::string word)
    : Word(std::move(word))
  {
  }

  std::string Word;
  /// Field of the features whose values are the colours; empty for one colour.
  std::string ColorBy;
  /// A scheme or a file (vtkTerrainColors), or a colour where there is no field; empty for the
  /// usual ones.
  std::string Colors;

  /// Adds the options to a group of a command line; more: what else the field may be.
  void DeclareField(
    CLI::App& app, const std::string& option, const std::string& more, const std::string& group);

  /// Throws a CLI::ValidationError if colours and field do not go together.
  void CheckField() const;

  /// "--track-color-by".
  std::string GetFieldOption() const;
  /// The file that Colors names; empty for none.
  std::string GetFileName() const;
  vtkSmartPointer<vtkTerrainColors> MakeColors() const;
};

#endif
