// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainPanelReader.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <array>
#include <cstddef>
#include <utility>

vtkStandardNewMacro(vtkTerrainPanelReader);

namespace
{
/// Options of the programs and properties that do the same; longer ones before those in them.
constexpr std::array<std::pair<const char*, const char*>, 7> kWords{ {
  { "--nodata none", "Detect No Data off" },
  { "--nodata", "No Data Value" },
  { "--crs", "Coordinate System" },
  { "--height-unit", "Height Unit" },
  { "--part", "Part" },
  { "--band", "Band" },
  { "--flip", "Flip" },
} };
}

//------------------------------------------------------------------------------
vtkTerrainPanelReader::vtkTerrainPanelReader()
{
  const vtkNew<vtkCallbackCommand> tell;
  tell->SetCallback(
    [](vtkObject*, unsigned long event, void*, void* data)
    {
      const std::string text = InWordsOfThePanel(data ? static_cast<const char*>(data) : "");
      vtkOutputWindow* window = vtkOutputWindow::GetInstance();
      event == vtkCommand::ErrorEvent ? window->DisplayErrorText(text.c_str())
                                      : window->DisplayWarningText(text.c_str());
    });
  this->AddObserver(vtkCommand::WarningEvent, tell);
  this->AddObserver(vtkCommand::ErrorEvent, tell);
}

//------------------------------------------------------------------------------
void vtkTerrainPanelReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
std::string vtkTerrainPanelReader::InWordsOfThePanel(std::string text)
{
  for (const auto& [option, property] : kWords)
  {
    const std::string wanted = option;
    for (std::size_t at = text.find(wanted); at != std::string::npos; at = text.find(wanted, at))
    {
      text.replace(at, wanted.size(), property);
    }
  }
  return text;
}
