// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A test field with repeated detail as the GPU would hold it.
 */
#ifndef UnitTestDetail_h
#define UnitTestDetail_h

#include "UnitTestFields.h"

#include "core/surface/DetailHeights.h"

namespace terrain
{
/// One period of random heights in -relief / 2 .. relief / 2.
inline TestField RandomDetail(glm::ivec2 period, double relief, int salt)
{
  std::minstd_rand random(static_cast<unsigned>(17 + salt));
  random.discard(9);
  return { "detail", period.x, period.y,
    [&](int, int) { return relief * (static_cast<double>(random() % 4096u) / 4096.0 - 0.5); } };
}

/// Base and detail as texels, with the pyramid of their sum.
template <typename Texel>
struct CodedSum
{
  CodedField<Texel> Base;
  CodedField<float> Detail;
  DetailNodes Nodes;
  DetailedPyramid<Texel> Pyramid;
  /// Of the sum.
  HeightCodes Codes;
  CodedPyramid<WithDetail<Texel>> Coded;

  CodedSum(const TestField& base, const TestField& detail, int level, double scale)
    : Base(base)
    , Detail(detail)
  {
    const glm::ivec2 period(detail.Width, detail.Height);
    this->Nodes.Build(this->Detail.Texels.data(), period,
      static_cast<float>(this->Detail.Codes.MaximumCode), SerialFor);

    this->Codes = this->Base.Codes;
    this->Codes.Offset += scale * this->Detail.Codes.Offset;
    this->Codes.MaximumCode += scale * this->Detail.Codes.MaximumCode;
    auto& heights = this->Coded.heights;
    heights.base = this->Base.Coded.heights;
    heights.detail = this->Detail.Texels.data();
    heights.period = period;
    heights.level = level;
    heights.scale = static_cast<float>(scale);
    heights.size = (heights.base.size - 1) * (1 << level) + 1;
    heights.maximumCode = static_cast<float>(this->Codes.MaximumCode);
    this->Pyramid = { &heights, &this->Base.Pyramid, &this->Nodes };
    this->Coded.pyramid = &this->Pyramid;
  }
  CodedSum(const CodedSum&) = delete;
  CodedSum& operator=(const CodedSum&) = delete;
};
}

#endif
