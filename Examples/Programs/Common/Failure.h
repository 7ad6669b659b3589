// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What ends a program with status 1.
 */
#ifndef terrain_common_Failure_h
#define terrain_common_Failure_h

#include <stdexcept>
#include <string>

/// One sentence that names a file, or what else failed, and the reason.
class Failure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
  Failure(const std::string& what, const std::string& reason)
    : std::runtime_error(what + ": " + reason)
  {
  }
};

#endif
