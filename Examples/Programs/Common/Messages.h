// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * VTK's error messages, caught so that the program can end with the first of them.
 */
#ifndef terrain_common_Messages_h
#define terrain_common_Messages_h

#include <string>

/// Takes VTK's messages over for the rest of the program: errors are kept, warnings are printed on
/// stderr as one line each. `program` begins them; it must live as long as the program.
void CatchMessages(const char* program);

/// Prints a warning of the program itself on stderr, as one line; the same text only once.
void Warn(const std::string& text);

/// Prints a line of the program itself on stderr.
void Tell(const std::string& text);

/// Throws a Failure about `what` if VTK reported an error since the last call; the reason is the
/// text of the first one, without the place in the source; it stands alone if it names `what`.
void ThrowOnError(const std::string& what);

#endif
