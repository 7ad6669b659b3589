// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerrainEGLRenderWindow.h"

#include "windows/GLContext.h"

#include "vtkObjectFactory.h"

#include <cerrno>
#include <cstdlib>
#include <limits>

namespace
{
constexpr const char* kDeviceVariable = "VTK_DEFAULT_EGL_DEVICE_INDEX";
constexpr int kAnyDevice = -1;
// An index that no device has: for a variable that holds no number.
constexpr int kNoDevice = std::numeric_limits<int>::max();

int DefaultDevice()
{
  const char* text = std::getenv(kDeviceVariable);
  if (!text || !*text)
  {
    return kAnyDevice;
  }
  char* end = nullptr;
  errno = 0;
  const long value = std::strtol(text, &end, 10);
  const bool isNumber = !*end && errno == 0 && value < kNoDevice;
  return isNumber ? static_cast<int>(value < 0 ? kAnyDevice : value) : kNoDevice;
}
}

vtkStandardNewMacro(vtkTerrainEGLRenderWindow);

//------------------------------------------------------------------------------
vtkTerrainEGLRenderWindow::vtkTerrainEGLRenderWindow()
{
  this->DeviceIndex = DefaultDevice();
}

//------------------------------------------------------------------------------
vtkTerrainEGLRenderWindow::~vtkTerrainEGLRenderWindow()
{
  this->Close();
}

//------------------------------------------------------------------------------
void vtkTerrainEGLRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DeviceIndex: " << this->DeviceIndex << "\n";
}

//------------------------------------------------------------------------------
void vtkTerrainEGLRenderWindow::SetDeviceIndex(int index)
{
  if (index != this->DeviceIndex)
  {
    this->Close();
    this->Superclass::SetDeviceIndex(index);
  }
}

//------------------------------------------------------------------------------
int vtkTerrainEGLRenderWindow::GetNumberOfDevices()
{
  return terrain::GetNumberOfEGLDevices();
}

//------------------------------------------------------------------------------
std::unique_ptr<terrain::GLContext> vtkTerrainEGLRenderWindow::CreateContext(std::string& whyNot)
{
  if (this->DeviceIndex == kNoDevice)
  {
    whyNot = std::string(kDeviceVariable) + " is no device's number";
    return nullptr;
  }
  return terrain::MakeEGLContext(this->DeviceIndex, whyNot);
}
