// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Values of options, read from their texts. What is wrong with them ends the program with status 2.
 */
#ifndef terrain_render_Arguments_h
#define terrain_render_Arguments_h

#include <string>
#include <vector>

/// Refuses an option with CLI11's own kind of error.
[[noreturn]] void Refuse(const std::string& option, const std::string& reason);

/// The whole text as a finite number between the two bounds, both allowed.
double ParseNumber(
  const std::string& option, const std::string& text, double minimum, double maximum);

/// The whole text as an integer between the two bounds, both allowed.
int ParseInteger(const std::string& option, const std::string& text, int minimum, int maximum);

/// Numbers with commas between them, none of a magnitude above `largest`.
std::vector<double> ParseNumbers(
  const std::string& option, const std::string& text, double largest);

#endif
