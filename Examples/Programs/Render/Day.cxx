// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Day.h"

#include "Canvas.h"
#include "Messages.h"
#include "Options.h"
#include "Outputs.h"
#include "Placing.h"
#include "Progress.h"
#include "View.h"

#include "vtkImageData.h"
#include "vtkRenderer.h"

#include <cstddef>
#include <string>
#include <vector>

//------------------------------------------------------------------------------
void DrawSuns(
  Canvas& canvas, vtkRenderer* renderer, const PlacedHeights& heights, const Options& options)
{
  const std::vector<std::string> suns = options.Light.GetSuns();
  ProgressBar progress;
  for (std::size_t k = 0; k < suns.size(); ++k)
  {
    const std::string name = PictureName(options.Output, k + 1, suns.size());
    const PendingFile picture(name);
    SetSun(renderer, heights, options, suns[k]);
    const vtkSmartPointer<vtkImageData> drawn = canvas.Draw();
    ThrowOnError("cannot draw");
    WritePicture(drawn, options.Dots, picture);
    ThrowOnError(options.Output);
    picture.Commit();
    TellName(name);
    progress.Show(static_cast<double>(k + 1) / static_cast<double>(suns.size()), "drawing");
  }
}
