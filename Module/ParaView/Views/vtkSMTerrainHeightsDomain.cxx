// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMTerrainHeightsDomain.h"

#include "vtkDataSetAttributes.h"
#include "vtkObjectFactory.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMInputProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

vtkStandardNewMacro(vtkSMTerrainHeightsDomain);

//------------------------------------------------------------------------------
void vtkSMTerrainHeightsDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
std::string vtkSMTerrainHeightsDomain::FindArrayOfSource()
{
  vtkSMSourceProxy* source = nullptr;
  unsigned int port = 0;
  auto* input = vtkSMInputProperty::SafeDownCast(this->GetRequiredProperty("Input"));
  while (
    input && input->GetNumberOfProxies() > 0 && vtkSMSourceProxy::SafeDownCast(input->GetProxy(0)))
  {
    source = vtkSMSourceProxy::SafeDownCast(input->GetProxy(0));
    port = input->GetOutputPortForConnection(0);
    input = vtkSMInputProperty::SafeDownCast(source->GetProperty("Input"));
  }
  vtkPVDataInformation* data = source ? source->GetDataInformation(port) : nullptr;
  vtkPVArrayInformation* scalars = data
    ? data->GetPointDataInformation()->GetAttributeInformation(vtkDataSetAttributes::SCALARS)
    : nullptr;
  return scalars && scalars->GetName() ? scalars->GetName() : "";
}

//------------------------------------------------------------------------------
int vtkSMTerrainHeightsDomain::SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues)
{
  const std::string name = this->FindArrayOfSource();
  unsigned int index = 0;
  // an empty domain has every name
  if (name.empty() || !this->IsInDomain(name.c_str(), index) || index >= this->GetNumberOfStrings())
  {
    return this->Superclass::SetDefaultValues(property, useUncheckedValues);
  }
  vtkSMPropertyHelper helper(property);
  helper.SetUseUnchecked(useUncheckedValues);
  helper.Set(3, this->GetFieldAssociation(index));
  helper.Set(4, name.c_str());
  return 1;
}
