// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GLTF.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtk_jsoncpp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace
{
// Numbers of the specification, sections 3.6.2 and 5.
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kVertices = 34962;
constexpr int kIndices = 34963;

/// The binary part, and the JSON that says what lies where.
class Buffers
{
public:
  /// Index of a new view of bytes; target 0: none.
  int AddView(const void* bytes, std::size_t size, int target)
  {
    this->Bytes.resize((this->Bytes.size() + 3) / 4 * 4, '\0');
    Json::Value view;
    view["buffer"] = 0;
    view["byteOffset"] = static_cast<Json::UInt64>(this->Bytes.size());
    view["byteLength"] = static_cast<Json::UInt64>(size);
    if (target != 0)
    {
      view["target"] = target;
    }
    this->Bytes.append(static_cast<const char*>(bytes), size);
    this->Views.append(view);
    return static_cast<int>(this->Views.size()) - 1;
  }

  /// Index of an accessor of floats, with its range where that is asked for.
  int AddFloats(const std::vector<float>& values, int components, bool range)
  {
    static const std::array<const char*, 4> types{ { "", "SCALAR", "VEC2", "VEC3" } };
    Json::Value accessor;
    accessor["bufferView"] = this->AddView(values.data(), values.size() * sizeof(float), kVertices);
    accessor["componentType"] = kFloat;
    accessor["count"] = static_cast<Json::UInt64>(values.size() / components);
    accessor["type"] = types[components];
    for (int c = 0; range && c < components; ++c)
    {
      float low = std::numeric_limits<float>::max();
      float high = std::numeric_limits<float>::lowest();
      for (std::size_t k = c; k < values.size(); k += components)
      {
        low = std::min(low, values[k]);
        high = std::max(high, values[k]);
      }
      accessor["min"].append(low);
      accessor["max"].append(high);
    }
    this->Accessors.append(accessor);
    return static_cast<int>(this->Accessors.size()) - 1;
  }

  int AddIndices(vtkPolyData* mesh)
  {
    std::vector<std::uint32_t> indices;
    indices.reserve(3 * static_cast<std::size_t>(mesh->GetNumberOfPolys()));
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    vtkCellArray* triangles = mesh->GetPolys();
    for (triangles->InitTraversal(); triangles->GetNextCell(count, corners) != 0;)
    {
      indices.insert(indices.end(),
        { static_cast<std::uint32_t>(corners[0]), static_cast<std::uint32_t>(corners[1]),
          static_cast<std::uint32_t>(corners[2]) });
    }
    Json::Value accessor;
    accessor["bufferView"] =
      this->AddView(indices.data(), indices.size() * sizeof(std::uint32_t), kIndices);
    accessor["componentType"] = kUnsignedInt;
    accessor["count"] = static_cast<Json::UInt64>(indices.size());
    accessor["type"] = "SCALAR";
    this->Accessors.append(accessor);
    return static_cast<int>(this->Accessors.size()) - 1;
  }

  std::string Bytes;
  Json::Value Views{ Json::arrayValue };
  Json::Value Accessors{ Json::arrayValue };
};

/// Tuples of an array minus an offset, as floats.
std::vector<float> Relative(vtkDataArray* array, const std::array<double, 3>& offset)
{
  const int components = array->GetNumberOfComponents();
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(array->GetNumberOfValues()));
  for (vtkIdType k = 0; k < array->GetNumberOfTuples(); ++k)
  {
    for (int c = 0; c < components; ++c)
    {
      values.push_back(static_cast<float>(array->GetComponent(k, c) - offset[c]));
    }
  }
  return values;
}

/// From z up to y up, after the offset: (x, y, z) becomes (x, z, -y). Columns of the matrix follow
/// each other.
Json::Value NodeMatrix(const std::array<double, 3>& offset)
{
  const std::array<double, 16> matrix{ { 1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, offset[0], offset[2],
    -offset[1], 1 } };
  Json::Value json(Json::arrayValue);
  for (const double entry : matrix)
  {
    json.append(entry);
  }
  return json;
}

/// A material that shows both sides, with the texture if there is one.
Json::Value MakeMaterial(bool hasTexture)
{
  Json::Value material;
  material["doubleSided"] = true;
  material["pbrMetallicRoughness"]["metallicFactor"] = 0.0;
  material["pbrMetallicRoughness"]["roughnessFactor"] = 1.0;
  if (hasTexture)
  {
    material["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 0;
  }
  return material;
}

void AddTexture(const std::string& texture, Buffers& buffers, Json::Value& root)
{
  Json::Value image;
  image["bufferView"] = buffers.AddView(texture.data(), texture.size(), 0);
  image["mimeType"] = texture.compare(0, 4, "\x89PNG") == 0 ? "image/png" : "image/jpeg";
  root["images"].append(image);
  Json::Value sampler;
  sampler["wrapS"] = 33071; // clamped to the edge
  sampler["wrapT"] = 33071;
  root["samplers"].append(sampler);
  Json::Value entry;
  entry["source"] = 0;
  entry["sampler"] = 0;
  root["textures"].append(entry);
}

void AppendNumber(std::string& bytes, std::uint32_t number)
{
  for (int k = 0; k < 4; ++k)
  {
    bytes.push_back(static_cast<char>((number >> (8 * k)) & 0xffU)); // little endian
  }
}

void AppendChunk(std::string& bytes, const char* type, std::string content, char padding)
{
  content.resize((content.size() + 3) / 4 * 4, padding);
  AppendNumber(bytes, static_cast<std::uint32_t>(content.size()));
  bytes.append(type, 4);
  bytes += content;
}
}

std::string MakeGLB(vtkPolyData* mesh, const std::string& texture)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  std::array<double, 3> middle{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    middle[axis] = std::floor(0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]));
  }
  Buffers buffers;
  Json::Value primitive;
  primitive["attributes"]["POSITION"] =
    buffers.AddFloats(Relative(mesh->GetPoints()->GetData(), middle), 3, true);
  if (vtkDataArray* normals = mesh->GetPointData()->GetNormals())
  {
    primitive["attributes"]["NORMAL"] = buffers.AddFloats(Relative(normals, {}), 3, false);
  }
  vtkDataArray* coordinates = mesh->GetPointData()->GetTCoords();
  if (coordinates && !texture.empty())
  {
    std::vector<float> values = Relative(coordinates, {});
    for (std::size_t k = 1; k < values.size(); k += 2)
    {
      values[k] = 1.0F - values[k]; // pictures begin at the top
    }
    primitive["attributes"]["TEXCOORD_0"] = buffers.AddFloats(values, 2, false);
  }
  primitive["indices"] = buffers.AddIndices(mesh);
  primitive["material"] = 0;

  Json::Value root;
  root["asset"]["version"] = "2.0";
  root["asset"]["generator"] = "terrain-prepare";
  root["scene"] = 0;
  root["scenes"][0]["nodes"].append(0);
  root["nodes"][0]["mesh"] = 0;
  root["nodes"][0]["matrix"] = NodeMatrix(middle);
  root["meshes"][0]["primitives"].append(primitive);
  root["materials"].append(MakeMaterial(!texture.empty()));
  if (!texture.empty())
  {
    AddTexture(texture, buffers, root);
  }
  root["bufferViews"] = buffers.Views;
  root["accessors"] = buffers.Accessors;
  root["buffers"][0]["byteLength"] = static_cast<Json::UInt64>(buffers.Bytes.size());

  Json::StreamWriterBuilder writer;
  writer["indentation"] = "";
  writer["precision"] = 17;
  std::string chunks;
  AppendChunk(chunks, "JSON", Json::writeString(writer, root), ' ');
  AppendChunk(chunks, "BIN\0", std::move(buffers.Bytes), '\0');
  std::string file = "glTF";
  AppendNumber(file, 2);
  AppendNumber(file, static_cast<std::uint32_t>(12 + chunks.size()));
  return file + chunks;
}
