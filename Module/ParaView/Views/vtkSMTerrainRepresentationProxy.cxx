// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMTerrainRepresentationProxy.h"

#include "vtkObjectFactory.h"
#include "vtkSMDoubleRangeDomain.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkSMTerrainRepresentationProxy);

namespace
{
bool IsAllowed(double value, unsigned int index, vtkSMDoubleRangeDomain* range)
{
  return std::isfinite(value) &&
    !(range->GetMinimumExists(index) && value < range->GetMinimum(index)) &&
    !(range->GetMaximumExists(index) && value > range->GetMaximum(index));
}

std::string RangeText(vtkSMDoubleRangeDomain* range)
{
  std::ostringstream text;
  text << "at least " << range->GetMinimum(0);
  if (range->GetMaximumExists(0))
  {
    text << " and at most " << range->GetMaximum(0);
  }
  return text.str();
}
}

//------------------------------------------------------------------------------
void vtkSMTerrainRepresentationProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
void vtkSMTerrainRepresentationProxy::PutBack(
  const char* name, vtkSMDoubleVectorProperty* property, vtkSMDoubleRangeDomain* range)
{
  const unsigned int count = property->GetNumberOfElements();
  std::vector<double> wanted(property->GetElements(), property->GetElements() + count);
  unsigned int bad = 0;
  while (bad < count && IsAllowed(wanted[bad], bad, range))
  {
    ++bad;
  }
  std::vector<double>& taken = this->Taken[name];
  if (bad == count)
  {
    taken = wanted;
    return;
  }
  property->ResetToXMLDefaults();
  if (taken.size() == count)
  {
    property->SetElements(taken.data());
  }
  const char* label = property->GetXMLLabel();
  vtkErrorMacro(<< (label ? label : name) << " must be " << RangeText(range) << ", not "
                << wanted[bad] << ": it stays " << property->GetElement(bad) << ".");
}

//------------------------------------------------------------------------------
void vtkSMTerrainRepresentationProxy::UpdateVTKObjects()
{
  const auto all = vtkSmartPointer<vtkSMPropertyIterator>::Take(this->NewPropertyIterator());
  for (all->Begin(); !all->IsAtEnd(); all->Next())
  {
    auto* property = vtkSMDoubleVectorProperty::SafeDownCast(all->GetProperty());
    auto* range =
      property ? vtkSMDoubleRangeDomain::SafeDownCast(property->GetDomain("range")) : nullptr;
    if (range && range->GetMinimumExists(0))
    {
      this->PutBack(all->GetKey(), property, range);
    }
  }
  this->Superclass::UpdateVTKObjects();
}
