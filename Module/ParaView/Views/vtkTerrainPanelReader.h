// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainPanelReader
 * @brief   the reader of rasters, which names the properties of ParaView's panel
 *
 * What vtkTerrainRasterReader warns of names options of the programs as remedies (--nodata none).
 * Here these are the properties that do the same (Detect No Data off).
 */
#ifndef vtkTerrainPanelReader_h
#define vtkTerrainPanelReader_h

#include "vtkTerrainParaViewViewsModule.h" // For export macro
#include "vtkTerrainRasterReader.h"

#include <string> // For texts

class VTKTERRAINPARAVIEWVIEWS_EXPORT vtkTerrainPanelReader : public vtkTerrainRasterReader
{
public:
  static vtkTerrainPanelReader* New();
  vtkTypeMacro(vtkTerrainPanelReader, vtkTerrainRasterReader)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkTerrainPanelReader(const vtkTerrainPanelReader&) = delete;
  void operator=(const vtkTerrainPanelReader&) = delete;

protected:
  vtkTerrainPanelReader();
  ~vtkTerrainPanelReader() override = default;

private:
  static std::string InWordsOfThePanel(std::string text);
};

#endif
