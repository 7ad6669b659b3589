// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The types that samples can have: every type of vtkTemplateMacro, for explicit instantiation.
 */
#ifndef terrain_SampleTypes_h
#define terrain_SampleTypes_h

/// Expands instantiate(T) for every sample type T.
#define TERRAIN_FOR_EACH_SAMPLE_TYPE(instantiate)                                                  \
  instantiate(char) instantiate(signed char) instantiate(unsigned char) instantiate(short)         \
    instantiate(unsigned short) instantiate(int) instantiate(unsigned int) instantiate(long)       \
      instantiate(unsigned long) instantiate(long long) instantiate(unsigned long long)            \
        instantiate(float) instantiate(double)

#endif
