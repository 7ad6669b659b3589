// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Fonts for texts in scripts that VTK's own ones lack.
 */
#ifndef terrain_render_Fonts_h
#define terrain_render_Fonts_h

#include <string>

class vtkTextProperty;

/// Gives a property a font of the system if VTK's own one lacks letters of a text, which is UTF-8:
/// the one that lacks the fewest. Letters that it lacks, too, are named in a warning.
void ChooseFont(vtkTextProperty* property, const std::string& text);

#endif
