// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMTerrainRepresentationProxy.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVFileInformation.h"
#include "vtkSMDoubleRangeDomain.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMSessionProxyManager.h"
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
// Names that GDAL alone understands, of files in archives or on servers, are left to it.
bool vtkSMTerrainRepresentationProxy::IsThere(const std::string& fileName)
{
  const bool isOfGDAL = fileName.compare(0, 4, "/vsi") == 0 || fileName.find(':') < fileName.size();
  const auto files = vtkSmartPointer<vtkSMProxy>::Take(
    this->GetSessionProxyManager()->NewProxy("misc", "FileInformationHelper"));
  if (isOfGDAL || !files)
  {
    return true;
  }
  vtkSMPropertyHelper(files, "Path").Set(fileName.c_str());
  files->UpdateVTKObjects();
  const vtkNew<vtkPVFileInformation> found;
  files->GatherInformation(found);
  return found->GetType() != vtkPVFileInformation::INVALID;
}

//------------------------------------------------------------------------------
void vtkSMTerrainRepresentationProxy::PutBackDrape()
{
  vtkSMPropertyHelper drape(this, "Drape");
  const std::string wanted = drape.GetAsString() ? drape.GetAsString() : "";
  if (wanted == this->TakenDrape)
  {
    return;
  }
  if (wanted.empty() || this->IsThere(wanted))
  {
    this->TakenDrape = wanted;
    return;
  }
  drape.Set(this->TakenDrape.c_str());
  vtkErrorMacro(<< "Drape: there is no file '" << wanted << "' where the data are read: it stays '"
                << this->TakenDrape << "'.");
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
  this->PutBackDrape();
  this->Superclass::UpdateVTKObjects();
}
