// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMTerrainStripsCamera.h"

#include "vtkObjectFactory.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"

#include <array>
#include <utility>

vtkStandardNewMacro(vtkSMTerrainStripsCamera);

namespace
{
/// Properties of the filter and of the view.
using Pair = std::pair<const char*, const char*>;
constexpr std::array<Pair, 5> kPairs{ Pair{ "CameraPosition", "CameraPosition" },
  { "CameraFocalPoint", "CameraFocalPoint" }, { "CameraViewUp", "CameraViewUp" },
  { "CameraViewAngle", "CameraViewAngle" }, { "ViewportSize", "ViewSize" } };
}

//------------------------------------------------------------------------------
void vtkSMTerrainStripsCamera::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
void vtkSMTerrainStripsCamera::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement*, vtkMTimeType initializationTimeStamp)
{
  vtkSMProxySelectionModel* views =
    proxy->GetSessionProxyManager()->GetSelectionModel("ActiveView");
  auto* view = views ? vtkSMRenderViewProxy::SafeDownCast(views->GetCurrentProxy()) : nullptr;
  if (!view || vtkSMPropertyHelper(view, "Representations").GetNumberOfElements() == 0)
  {
    return;
  }
  for (const Pair& pair : kPairs)
  {
    if (proxy->GetProperty(pair.first)->GetMTime() > initializationTimeStamp)
    {
      return; // chosen by the user
    }
  }
  view->SynchronizeCameraProperties();
  for (const Pair& pair : kPairs)
  {
    proxy->GetProperty(pair.first)->Copy(view->GetProperty(pair.second));
  }
  proxy->UpdateVTKObjects();
}
