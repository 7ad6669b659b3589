// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMTerrainHeightsDomain
 * @brief   the arrays that may be heights, of which the reader's own is the default
 *
 * A filter that adds an array, such as Calculator, makes it the active one. The default here is the
 * active array of the first source of the pipeline, as long as the data still have it; without it,
 * that of vtkSMArrayListDomain.
 */
#ifndef vtkSMTerrainHeightsDomain_h
#define vtkSMTerrainHeightsDomain_h

#include "vtkSMArrayListDomain.h"
#include "vtkTerrainParaViewViewsModule.h" // For export macro

#include <string> // For a name

class VTKTERRAINPARAVIEWVIEWS_EXPORT vtkSMTerrainHeightsDomain : public vtkSMArrayListDomain
{
public:
  static vtkSMTerrainHeightsDomain* New();
  vtkTypeMacro(vtkSMTerrainHeightsDomain, vtkSMArrayListDomain)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Sets a property of five strings, those of SetInputArrayToProcess, to the default.
  int SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues) override;

  vtkSMTerrainHeightsDomain(const vtkSMTerrainHeightsDomain&) = delete;
  void operator=(const vtkSMTerrainHeightsDomain&) = delete;

protected:
  vtkSMTerrainHeightsDomain() = default;
  ~vtkSMTerrainHeightsDomain() override = default;

private:
  /// Active point scalars of the source that the input comes from; empty if there are none.
  std::string FindArrayOfSource();
};

#endif
