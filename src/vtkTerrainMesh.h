// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTerrainMesh
 * @brief   makes a triangle mesh of a heightfield within a vertical error
 *
 * The mesh is for those who need triangles: writers of files, printers, other programs. To draw a
 * terrain, vtkTerrainActor needs no mesh.
 *
 * Input: vtkImageData of W x H x 1 points whose scalars are heights (one component, any numeric
 * type). NaN, magnitudes from 1e30 on and hidden samples (vtkGhostType) have no height.
 *
 * Output: vtkPolyData of triangles, counterclockwise seen from above, with
 *   - points: samples of the input, z = origin.z + Exaggeration * height;
 *   - point normals "Normals", float32 of 3 components, of length 1 (ComputeNormals);
 *   - texture coordinates "TextureCoordinates", float32 of 2 components
 * (ComputeTextureCoordinates): (0, 0) is the outer corner of the south-western sample's cell, that
 * is half a cell outside of the sample, as in pictures that have one pixel a sample; (1, 1) that of
 * the north-eastern;
 *   - point data: the input's arrays at the samples (PassPointArrays); a floor has its own height;
 *   - field data "MeshError", one float64: GetMeshError().
 *
 * The mesh covers exactly the cells whose four samples have heights, or those of them in Extract.
 * Neighbouring triangles share whole edges: there are no cracks. With Block the mesh is closed by
 * walls and a floor; every edge of the block then has two triangles, four where two holes meet in
 * one sample.
 *
 * Method: greedy insertion into a Delaunay triangulation (Garland and Heckbert, "Fast Polygonal
 * Approximation of Terrains and Height Fields", 1995), in tiles that share their
 * borders; see core/mesh/GreedyMesh.h for where it departs from the source.
 *
 * Error: no sample lies farther from the mesh than MaximumError, measured vertically in height
 * units, rounding of the arithmetic included, and that of the points with HoldInSinglePrecision. It
 * is checked, not only promised: after every build each triangle is compared with each sample below
 * it, and the result is GetMeshError(). Between samples nothing
 * is promised: folds of the mesh cross cells, and the bilinear surface was up to five times as far
 * there on smooth hills (range 46, error 0.05: 0.25).
 *
 * Cost: about 0.1 microseconds a sample and 2 microseconds a vertex on one core; tiles run in
 * parallel (vtkSMPTools). The result does not depend on the number of threads. Memory: 2 bytes a
 * sample, and 80 bytes a vertex beside the output, which takes 90 with all arrays.
 *
 * Limits: grids of fewer than 2 x 2 samples, or without cells, give an empty mesh. Input of another
 * shape is an error.
 *
 * @sa vtkTerrainCoarseMesh vtkTerrainStrips
 */
#ifndef vtkTerrainMesh_h
#define vtkTerrainMesh_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkTerrainModule.h" // For export macro

class VTKTERRAIN_EXPORT vtkTerrainMesh : public vtkPolyDataAlgorithm
{
public:
  static vtkTerrainMesh* New();
  vtkTypeMacro(vtkTerrainMesh, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkTerrainMesh(const vtkTerrainMesh&) = delete;
  void operator=(const vtkTerrainMesh&) = delete;

  ///@{
  /// Largest vertical distance between a sample and the mesh, in height units (not exaggerated), >=
  /// 0; default 1. With 0 only what is flat has fewer triangles than two a cell.
  vtkSetClampMacro(MaximumError, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumError, double);
  ///@}

  /// Lowest height of a vertex of the surface in the last output, in height units; 0 before
  /// the first.
  double GetLowestHeight() const
  {
    return this->LowestHeight;
  }
  /// Height units that are as long in the output as a length in model units: exaggeration taken
  /// off.
  double GetHeightOfLength(double length) const;

  ///@{
  /// Vertical exaggeration: drawn height over true height, > 0; default 1.
  vtkSetClampMacro(Exaggeration, double, 1e-30, VTK_DOUBLE_MAX);
  vtkGetMacro(Exaggeration, double);
  ///@}

  ///@{
  /// The mesh has the samples first[0] <= i <= last[0], first[1] <= j <= last[1] only, counted from
  /// the south-west. Default all of them. Normals and texture coordinates stay those of all.
  void SetExtract(const int first[2], const int last[2]);
  void ExtractAll();
  ///@}

  ///@{
  /// Whether the mesh is closed by vertical walls and a floor at BlockBase; default off.
  vtkSetMacro(Block, bool);
  vtkGetMacro(Block, bool);
  vtkBooleanMacro(Block, bool);
  ///@}

  ///@{
  /// Whether a block has walls round holes, too, as a closed body needs them; default on. Off for
  /// what rays draw: walls along the four sides.
  vtkSetMacro(WallsOfHoles, bool);
  vtkGetMacro(WallsOfHoles, bool);
  vtkBooleanMacro(WallsOfHoles, bool);
  ///@}

  ///@{
  /// Height of the floor of a block, in height units before exaggeration; default 0. It must lie
  /// below the lowest sample, else the update fails with an error.
  vtkSetMacro(BlockBase, double);
  vtkGetMacro(BlockBase, double);
  ///@}

  ///@{
  /// Whether the output has normals: those of the surface through a sample and its neighbours
  /// (central differences; one-sided beside holes and the border), exaggerated; those of walls and
  /// floor are their planes'. Default on.
  vtkSetMacro(ComputeNormals, bool);
  vtkGetMacro(ComputeNormals, bool);
  vtkBooleanMacro(ComputeNormals, bool);
  ///@}

  ///@{
  /// Whether the output has texture coordinates; default on.
  vtkSetMacro(ComputeTextureCoordinates, bool);
  vtkGetMacro(ComputeTextureCoordinates, bool);
  vtkBooleanMacro(ComputeTextureCoordinates, bool);
  ///@}

  ///@{
  /// West, east, south, north of the picture that texture coordinates are those of: (0, 0) is its
  /// south-western corner, (1, 1) its north-eastern, in the coordinates of the input. Default all
  /// 0: those of the class comment.
  vtkSetVector4Macro(TextureBounds, double);
  vtkGetVector4Macro(TextureBounds, double);
  ///@}

  ///@{
  /// Whether the output has point arrays "Slope", degrees from the horizontal, and "Aspect", the
  /// direction downhill in degrees clockwise from the grid's north, 0 to 360, NaN where it is
  /// level: of the surface of "Normals", not exaggerated. Default off.
  vtkSetMacro(ComputeSlopes, bool);
  vtkGetMacro(ComputeSlopes, bool);
  vtkBooleanMacro(ComputeSlopes, bool);
  ///@}

  ///@{
  /// Whether the output has the input's point arrays at its vertices; default off.
  vtkSetMacro(PassPointArrays, bool);
  vtkGetMacro(PassPointArrays, bool);
  vtkBooleanMacro(PassPointArrays, bool);
  ///@}

  ///@{
  /// Type of the output points: vtkAlgorithm::SINGLE_PRECISION, DOUBLE_PRECISION (default), or
  /// DEFAULT_PRECISION: double, but single with HoldInSinglePrecision where that moves points by at
  /// most a 64th of a cell, and the surface by at most a 64th of MaximumError.
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /// Whether the error holds for points that are rounded to 32 bits, as files of most formats hold
  /// them; default off, but for OutputPointsPrecision. The mesh is made a little finer for that.
  /// Where 32 bits are too few, as for coordinates of millions of metres, GetMeshError() is larger
  /// than MaximumError, and the points are better moved to the origin.
  vtkSetMacro(HoldInSinglePrecision, bool);
  vtkGetMacro(HoldInSinglePrecision, bool);
  vtkBooleanMacro(HoldInSinglePrecision, bool);
  ///@}

  /// Largest vertical distance between a sample and the last output, in height units, found by
  /// comparing them, with rounded points if the error is to hold for these; 0 before the first.
  double GetMeshError() const
  {
    return this->MeshError;
  }

protected:
  vtkTerrainMesh() = default;
  ~vtkTerrainMesh() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  double MaximumError = 1.0;
  double Exaggeration = 1.0;
  bool Block = false;
  bool WallsOfHoles = true;
  double BlockBase = 0.0;
  bool Extracts = false;
  int First[2] = { 0, 0 };
  int Last[2] = { 0, 0 };
  bool ComputeNormals = true;
  bool ComputeTextureCoordinates = true;
  double TextureBounds[4] = { 0.0, 0.0, 0.0, 0.0 };
  bool ComputeSlopes = false;
  bool PassPointArrays = false;
  int OutputPointsPrecision = DOUBLE_PRECISION;
  bool HoldInSinglePrecision = false;
  double MeshError = 0.0;
  double LowestHeight = 0.0;
};

#endif
