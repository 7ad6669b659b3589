// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Whether a terrain that is asked for its parts shows itself alone, for those who ask its surface
 * directly, or a mesh in its place. Private to the module.
 */
#ifndef vtkTerrain_render_SurfaceScope_h
#define vtkTerrain_render_SurfaceScope_h

namespace terrain
{
/// While one lives, terrains show themselves alone on this thread.
class SurfaceScope
{
public:
  SurfaceScope()
  {
    ++SurfaceScope::Depth();
  }
  ~SurfaceScope()
  {
    --SurfaceScope::Depth();
  }
  SurfaceScope(const SurfaceScope&) = delete;
  SurfaceScope& operator=(const SurfaceScope&) = delete;

  static bool IsOpen()
  {
    return SurfaceScope::Depth() > 0;
  }

private:
  static int& Depth()
  {
    static thread_local int depth = 0;
    return depth;
  }
};
}
#endif
