// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How the programs end when they are told to.
 */
#ifndef terrain_common_Ending_h
#define terrain_common_Ending_h

/**
 * From here on a signal that asks the program to end (SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE,
 * SIGXCPU) ends it at once, whatever it waits for: the partial files are removed, one line is
 * written on stderr, and the exit status is 1. A signal of a fault removes them, too, before it
 * does what it always does. A limit on the size of files (SIGXFSZ) is an error like a full disk.
 * Signals that whoever started the program has ignored, as nohup does, stay ignored.
 * `line` is what is written; it must live as long as the program.
 */
void EndOnSignals(const char* line);

#endif
