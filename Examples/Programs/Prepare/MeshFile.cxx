// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFile.h"

#include "GLTF.h"
#include "PlainMesh.h"

#include <vtkNew.h>
#include <vtkOBJWriter.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtksys/SystemTools.hxx>

#include <fstream>
#include <iterator>

namespace
{
/// The suffix in lower case, ".glb"; empty if there is none.
std::string SuffixOf(const std::string& path)
{
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(path));
}

bool ReadBytes(const std::string& path, std::string& bytes)
{
  std::ifstream file(path, std::ios::binary);
  bytes.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  return file.good() || file.eof();
}

bool IsPicture(const std::string& bytes)
{
  return bytes.compare(0, 4, "\x89PNG") == 0 || bytes.compare(0, 3, "\xff\xd8\xff") == 0;
}

bool WriteBytes(const std::string& partial, const std::string& bytes)
{
  std::ofstream file(partial, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  return file.good();
}

bool WriteTexturedGLB(vtkPolyData* mesh, const std::string& partial, const MeshLook& look)
{
  std::string texture;
  if (!look.Texture.empty() && !ReadBytes(look.Texture, texture))
  {
    return false;
  }
  std::ofstream file(partial, std::ios::binary);
  const bool fits = WriteGLB(mesh, look.Origin, texture, file);
  file.close();
  return fits && file.good();
}

template <typename Writer>
bool WriteBy(vtkPolyData* mesh, const std::string& partial)
{
  vtkNew<Writer> writer;
  writer->SetInputData(mesh);
  writer->SetFileName(partial.c_str());
  return writer->Write() != 0 && writer->GetErrorCode() == 0;
}
}

std::string WhyNotMeshFile(const std::string& path, const MeshLook& look)
{
  const std::string suffix = SuffixOf(path);
  if (suffix != ".glb" && suffix != ".stl" && suffix != ".ply" && suffix != ".obj" &&
    suffix != ".vtp")
  {
    return "'" + path + "' must end in .glb, .stl, .ply, .obj or .vtp";
  }
  std::string bytes;
  if (!look.Texture.empty() && suffix != ".glb")
  {
    return "'" + path + "' holds no texture: write a .glb";
  }
  if (!look.Texture.empty() && (!ReadBytes(look.Texture, bytes) || !IsPicture(bytes)))
  {
    return "'" + look.Texture + "' is no PNG or JPEG file";
  }
  return {};
}

bool IsSinglePrecision(const std::string& path)
{
  const std::string suffix = SuffixOf(path);
  return suffix == ".glb" || suffix == ".stl";
}

bool HasTextureCoordinates(const std::string& path, const MeshLook& look)
{
  const std::string suffix = SuffixOf(path);
  return suffix == ".glb" ? !look.Texture.empty() : suffix != ".stl";
}

std::string WriteMeshFile(
  vtkPolyData* mesh, const std::string& path, const std::string& partial, const MeshLook& look)
{
  const std::string suffix = SuffixOf(path);
  const bool done = suffix == ".glb" ? WriteTexturedGLB(mesh, partial, look)
    : suffix == ".vtp"               ? WriteBy<vtkXMLPolyDataWriter>(mesh, partial)
    : suffix == ".ply"               ? WriteBytes(partial, MakePLY(mesh))
    : suffix == ".obj"               ? WriteBy<vtkOBJWriter>(mesh, partial)
                                     : WriteBytes(partial, MakeSTL(mesh));
  return done
    ? std::string()
    : "'" + path + "' cannot be written: is the disk full, or the mesh larger than 4 GiB?";
}
