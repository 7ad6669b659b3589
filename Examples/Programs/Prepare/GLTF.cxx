// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GLTF.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtk_jsoncpp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <ostream>
#include <utility>
#include <vector>

namespace
{
// Numbers of the specification, sections 3.6.2 and 5.
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kVertices = 34962;
constexpr int kIndices = 34963;

// Tuples, or triangles, that are in memory at a time.
constexpr vtkIdType kAtOnce = 1 << 16;

/// Writes a part of the file.
using Writer = std::function<void(std::ostream&)>;

template <typename T>
void WriteNumbers(std::ostream& file, const std::vector<T>& numbers)
{
  file.write(reinterpret_cast<const char*>(numbers.data()),
    static_cast<std::streamsize>(numbers.size() * sizeof(T)));
}

/// The JSON that says what lies where in the binary part, and what writes that.
class Buffers
{
public:
  /// Index of a new view of bytes; target 0: none.
  int AddView(std::size_t size, int target, Writer writer)
  {
    Json::Value view;
    view["buffer"] = 0;
    view["byteOffset"] = static_cast<Json::UInt64>(this->Size);
    view["byteLength"] = static_cast<Json::UInt64>(size);
    if (target != 0)
    {
      view["target"] = target;
    }
    const std::size_t padded = (size + 3) / 4 * 4;
    this->Writers.emplace_back(
      [writer = std::move(writer), padding = padded - size](std::ostream& file)
      {
        writer(file);
        file.write("\0\0\0", static_cast<std::streamsize>(padding));
      });
    this->Size += padded;
    this->Views.append(view);
    return static_cast<int>(this->Views.size()) - 1;
  }

  /// Index of an accessor of so many tuples of a type, in a new view.
  int AddAccessor(int component, std::size_t count, int size, int target, Writer writer)
  {
    static const std::array<const char*, 4> types{ { "", "SCALAR", "VEC2", "VEC3" } };
    Json::Value accessor;
    accessor["bufferView"] = this->AddView(4 * count * size, target, std::move(writer));
    accessor["componentType"] = component;
    accessor["count"] = static_cast<Json::UInt64>(count);
    accessor["type"] = types[size];
    this->Accessors.append(accessor);
    return static_cast<int>(this->Accessors.size()) - 1;
  }

  std::size_t Size = 0;
  std::vector<Writer> Writers;
  Json::Value Views{ Json::arrayValue };
  Json::Value Accessors{ Json::arrayValue };
};

/// How numbers of an array become those of the file: scale * number + offset, by component.
struct Conversion
{
  std::array<double, 3> Scale{ { 1.0, 1.0, 1.0 } };
  std::array<double, 3> Offset{ { 0.0, 0.0, 0.0 } };
};

/// Calls visit(floats) with all tuples of an array, some at a time.
template <typename Visit>
void VisitFloats(vtkDataArray* array, const Conversion& conversion, Visit&& visit)
{
  const int components = array->GetNumberOfComponents();
  std::vector<float> values;
  for (vtkIdType first = 0; first < array->GetNumberOfTuples(); first += kAtOnce)
  {
    values.clear();
    const vtkIdType end = std::min(first + kAtOnce, array->GetNumberOfTuples());
    for (vtkIdType k = first; k < end; ++k)
    {
      for (int c = 0; c < components; ++c)
      {
        values.push_back(static_cast<float>(
          conversion.Scale[c] * array->GetComponent(k, c) + conversion.Offset[c]));
      }
    }
    visit(values);
  }
}

/// Index of the accessor of an array.
int AddFloats(vtkDataArray* array, const Conversion& conversion, Buffers& buffers)
{
  return buffers.AddAccessor(kFloat, static_cast<std::size_t>(array->GetNumberOfTuples()),
    array->GetNumberOfComponents(), kVertices,
    [array, conversion](std::ostream& file)
    {
      VisitFloats(array, conversion,
        [&file](const std::vector<float>& values) { WriteNumbers(file, values); });
    });
}

/// Adds the least and largest number of each component to an accessor, of 3 components.
void AddRange(vtkDataArray* array, const Conversion& conversion, Json::Value& accessor)
{
  std::array<float, 3> low;
  std::array<float, 3> high;
  low.fill(std::numeric_limits<float>::max());
  high.fill(std::numeric_limits<float>::lowest());
  VisitFloats(array, conversion,
    [&](const std::vector<float>& values)
    {
      for (std::size_t k = 0; k < values.size(); ++k)
      {
        low[k % 3] = std::min(low[k % 3], values[k]);
        high[k % 3] = std::max(high[k % 3], values[k]);
      }
    });
  for (std::size_t c = 0; c < 3; ++c)
  {
    accessor["min"].append(low[c]);
    accessor["max"].append(high[c]);
  }
}

/// Index of the accessor of the triangles' vertices.
int AddIndices(vtkPolyData* mesh, Buffers& buffers)
{
  const auto write = [mesh](std::ostream& file)
  {
    std::vector<std::uint32_t> indices;
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    const auto triangles = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
    for (triangles->GoToFirstCell(); !triangles->IsDoneWithTraversal(); triangles->GoToNextCell())
    {
      triangles->GetCurrentCell(count, corners);
      for (int k = 0; k < 3; ++k)
      {
        indices.push_back(static_cast<std::uint32_t>(corners[k]));
      }
      if (indices.size() >= static_cast<std::size_t>(3 * kAtOnce))
      {
        WriteNumbers(file, indices);
        indices.clear();
      }
    }
    WriteNumbers(file, indices);
  };
  const auto count = 3 * static_cast<std::size_t>(mesh->GetNumberOfPolys());
  return buffers.AddAccessor(kUnsignedInt, count, 1, kIndices, write);
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
  image["bufferView"] = buffers.AddView(texture.size(), 0,
    [&texture](std::ostream& file)
    { file.write(texture.data(), static_cast<std::streamsize>(texture.size())); });
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

void WriteNumber(std::ostream& file, std::size_t number)
{
  WriteNumbers(file, std::vector<std::uint32_t>{ static_cast<std::uint32_t>(number) });
}

/// The triangles, positions converted, as a primitive.
Json::Value AddPrimitive(
  vtkPolyData* mesh, const Conversion& conversion, bool hasTexture, Buffers& buffers)
{
  Json::Value primitive;
  Json::Value& attributes = primitive["attributes"];
  vtkDataArray* points = mesh->GetPoints()->GetData();
  const int positions = AddFloats(points, conversion, buffers);
  attributes["POSITION"] = positions;
  AddRange(points, conversion, buffers.Accessors[positions]);
  if (vtkDataArray* normals = mesh->GetPointData()->GetNormals())
  {
    attributes["NORMAL"] = AddFloats(normals, {}, buffers);
  }
  vtkDataArray* coordinates = mesh->GetPointData()->GetTCoords();
  if (coordinates && hasTexture)
  {
    const Conversion fromTop{ { { 1.0, -1.0, 1.0 } }, { { 0.0, 1.0, 0.0 } } };
    attributes["TEXCOORD_0"] = AddFloats(coordinates, fromTop, buffers);
  }
  primitive["indices"] = AddIndices(mesh, buffers);
  primitive["material"] = 0;
  return primitive;
}

/// Header, JSON and buffers; false, and nothing, if that is too much for the format.
bool WriteChunks(const Json::Value& root, const Buffers& buffers, std::ostream& file)
{
  Json::StreamWriterBuilder writer;
  writer["indentation"] = "";
  writer["precision"] = 17;
  std::string json = Json::writeString(writer, root);
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::size_t size = 12 + 8 + json.size() + 8 + buffers.Size;
  if (size > std::numeric_limits<std::uint32_t>::max())
  {
    return false;
  }
  file << "glTF";
  WriteNumber(file, 2);
  WriteNumber(file, size);
  WriteNumber(file, json.size());
  file << "JSON" << json;
  WriteNumber(file, buffers.Size);
  file.write("BIN\0", 4);
  for (const Writer& part : buffers.Writers)
  {
    part(file);
  }
  return true;
}
}

bool WriteGLB(vtkPolyData* mesh, const std::array<double, 3>& origin, const std::string& texture,
  std::ostream& file)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  std::array<double, 3> middle{};
  Conversion fromMiddle;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    middle[axis] = std::floor(0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]));
    fromMiddle.Offset[axis] = -middle[axis];
    middle[axis] += origin[axis];
  }
  Buffers buffers;
  Json::Value root;
  root["asset"]["version"] = "2.0";
  root["asset"]["generator"] = "terrain-prepare";
  root["scene"] = 0;
  root["scenes"][0]["nodes"].append(0);
  root["nodes"][0]["mesh"] = 0;
  root["nodes"][0]["matrix"] = NodeMatrix(middle);
  root["meshes"][0]["primitives"].append(AddPrimitive(mesh, fromMiddle, !texture.empty(), buffers));
  root["materials"].append(MakeMaterial(!texture.empty()));
  if (!texture.empty())
  {
    AddTexture(texture, buffers, root);
  }
  root["bufferViews"] = buffers.Views;
  root["accessors"] = buffers.Accessors;
  root["buffers"][0]["byteLength"] = static_cast<Json::UInt64>(buffers.Size);
  return WriteChunks(root, buffers, file);
}
