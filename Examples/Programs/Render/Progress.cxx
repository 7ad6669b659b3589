// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Progress.h"

#include "vtkCommand.h"

#include <algorithm>
#include <iostream>

#include <unistd.h>

namespace
{
constexpr int kBarWidth = 40;
}

//------------------------------------------------------------------------------
ProgressBar::ProgressBar()
  : Visible(isatty(STDERR_FILENO) == 1)
{
}

//------------------------------------------------------------------------------
ProgressBar::~ProgressBar()
{
  for (const Stage& stage : this->Stages)
  {
    if (stage.Algorithm)
    {
      stage.Algorithm->RemoveObserver(stage.Observer);
    }
  }
  if (this->DrawnPercent >= 0)
  {
    std::cerr << "\r\033[K" << std::flush;
  }
}

//------------------------------------------------------------------------------
void ProgressBar::Watch(vtkAlgorithm* algorithm, double share, const std::string& name)
{
  if (!this->Visible)
  {
    return;
  }
  Stage stage;
  stage.Algorithm = algorithm;
  stage.Observer =
    algorithm->AddObserver(vtkCommand::ProgressEvent, this, &ProgressBar::OnProgress);
  stage.Begin = this->Stages.empty() ? 0.0 : this->Stages.back().Begin + this->Stages.back().Share;
  stage.Share = share;
  stage.Name = name;
  this->Stages.push_back(stage);
}

//------------------------------------------------------------------------------
void ProgressBar::OnProgress(vtkObject* caller, unsigned long, void*)
{
  for (const Stage& stage : this->Stages)
  {
    if (stage.Algorithm == caller)
    {
      this->Show(stage.Begin + stage.Share * stage.Algorithm->GetProgress(), stage.Name);
    }
  }
}

//------------------------------------------------------------------------------
void ProgressBar::Show(double fraction, const std::string& name)
{
  const int percent = static_cast<int>(100.0 * std::clamp(fraction, 0.0, 1.0));
  if (!this->Visible || percent <= this->DrawnPercent)
  {
    return;
  }
  this->DrawnPercent = percent;
  const int filled = percent * kBarWidth / 100;
  std::cerr << "\r\033[K[" << std::string(filled, '#') << std::string(kBarWidth - filled, ' ')
            << "] " << percent << " % " << name << std::flush;
}
