// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMTerrainRepresentationProxy
 * @brief   puts back what a terrain refuses
 *
 * Numbers outside of a property's range, and a picture's file that is not there where the data are,
 * would be refused where the terrain is drawn, while the panel went on showing them. Here they are
 * set back to what was last taken, before anything is sent, with one error that says what is
 * allowed.
 */
#ifndef vtkSMTerrainRepresentationProxy_h
#define vtkSMTerrainRepresentationProxy_h

#include "vtkSMRepresentationProxy.h"
#include "vtkTerrainParaViewViewsModule.h" // For export macro

#include <map>    // For members
#include <string> // For members
#include <vector> // For members

class vtkSMDoubleRangeDomain;
class vtkSMDoubleVectorProperty;

class VTKTERRAINPARAVIEWVIEWS_EXPORT vtkSMTerrainRepresentationProxy
  : public vtkSMRepresentationProxy
{
public:
  static vtkSMTerrainRepresentationProxy* New();
  vtkTypeMacro(vtkSMTerrainRepresentationProxy, vtkSMRepresentationProxy)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void UpdateVTKObjects() override;

  vtkSMTerrainRepresentationProxy(const vtkSMTerrainRepresentationProxy&) = delete;
  void operator=(const vtkSMTerrainRepresentationProxy&) = delete;

protected:
  vtkSMTerrainRepresentationProxy() = default;
  ~vtkSMTerrainRepresentationProxy() override = default;

private:
  void PutBack(
    const char* name, vtkSMDoubleVectorProperty* property, vtkSMDoubleRangeDomain* range);
  void PutBackDrape();
  bool IsThere(const std::string& fileName);

  /// Of each property with a range: what was last taken.
  std::map<std::string, std::vector<double>> Taken;
  /// The picture's file that was last taken.
  std::string TakenDrape;
};

#endif
