// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
// Prepared files with damage in any place, also under checksums that fit: refused, or refined to
// meshes whose parts are there.
#include "FuzzFile.h"
#include "FuzzStrips.h"

#include "core/grid/Checksum.h"
#include "core/strips/HierarchyFile.h"

#include <array>

namespace
{
// Where HierarchyFile.cxx keeps its checksums, and what they are of; a file of at most a block.
constexpr std::size_t kFileBytes = 136;
constexpr std::size_t kTableChecksum = 144;
constexpr std::size_t kHeaderChecksum = 152;
constexpr std::size_t kHeaderSize = 160;
constexpr std::size_t kPlacing = 2048;
constexpr std::size_t kPlacingChecksum = kPlacing + 32;

std::string Prepare(std::int64_t width, std::int64_t height)
{
  terrain::HierarchyPlacing placing;
  placing.CoordinateSystem = "LOCAL_CS[\"fuzz\"]";
  placing.HasLayout = true;
  placing.LayoutOrigin = { 500000.0, 4000000.0 };
  return ContentWrittenBy(
    [&](const std::string& path)
    {
      return terrain::WriteHierarchyFile(
        path, width, height, {}, placing, RowsOfWidth(width), terrain::SerialFor, {});
    });
}

std::uint64_t SumOf(const std::string& content, std::size_t begin, std::size_t size)
{
  const auto* bytes = reinterpret_cast<const unsigned char*>(content.data());
  return terrain::Checksum(bytes + begin, size);
}

void FitChecksums(std::string& content)
{
  const std::size_t table = content.size() - sizeof(std::uint64_t);
  if (content.size() < terrain::kHierarchyHeaderBytes + sizeof(std::uint64_t))
  {
    return;
  }
  const std::size_t records = terrain::kHierarchyHeaderBytes;
  PutValue(content, table, SumOf(content, records, table - records));
  PutValue(content, kTableChecksum, SumOf(content, table, sizeof(std::uint64_t)));
  PutValue(content, kPlacingChecksum, SumOf(content, kPlacing, kPlacingChecksum - kPlacing));
  PutValue(content, kFileBytes, static_cast<std::int64_t>(content.size()));
  PutValue(content, kHeaderChecksum, std::uint64_t{ 0 });
  PutValue(content, kHeaderChecksum, SumOf(content, 0, kHeaderSize));
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const std::array<std::string, 3> prepared{ Prepare(34, 18), Prepare(33, 33),
    Prepare(5, 60) };
  FuzzInput input(data, size);
  std::string content = prepared[input.Number(3)];
  const bool verify = input.Number(2) != 0;
  const bool fits = input.Number(4) != 0;
  const FuzzRefinement refinement(input);
  const bool isSound = input.Left() < 4;
  Damage(content, input);
  if (fits)
  {
    FitChecksums(content);
  }
  const FuzzFile file(content);
  terrain::HierarchyFile hierarchy;
  const std::string why = hierarchy.Open(file.Path(), verify);
  Require(!isSound || why.empty()); // or the places above are not those of the format
  if (why.empty())
  {
    refinement.Check(hierarchy.View());
    hierarchy.Verify();
    Require(!hierarchy.IsDamaged());
  }
  return 0;
}
