// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// A prepared hierarchy whose records, summary and view are the input's.
#include "FuzzStrips.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace
{
terrain::MemoryHierarchy Prepare(std::int64_t width, std::int64_t height)
{
  terrain::MemoryHierarchy hierarchy;
  Require(terrain::BuildHierarchy(
    hierarchy, width, height, {}, RowsOfWidth(width), terrain::SerialFor, {}, false)
            .empty());
  return hierarchy;
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const std::array<terrain::MemoryHierarchy, 3> prepared{ Prepare(34, 18), Prepare(33, 33),
    Prepare(5, 60) };
  FuzzInput input(data, size);
  terrain::MemoryHierarchy hierarchy = prepared[input.Number(3)];
  hierarchy.Summary.HasHoles = input.Number(2) != 0;
  const FuzzRefinement refinement(input);
  // What is left goes over the records, from a place on that it says.
  const std::size_t bytes = hierarchy.Records.size() * sizeof(terrain::HierarchyRecord);
  const std::size_t begin = input.Number(static_cast<std::uint32_t>(bytes));
  const std::size_t count = std::min(input.Left(), bytes - begin);
  std::memcpy(reinterpret_cast<char*>(hierarchy.Records.data()) + begin, input.Rest(), count);
  refinement.Check(hierarchy.View());
  return 0;
}
