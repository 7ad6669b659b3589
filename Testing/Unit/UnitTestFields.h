// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Small adversarial heightfields for unit tests, and their codes and pyramid.
 */
#ifndef UnitTestFields_h
#define UnitTestFields_h

#include "core/grid/HeightCodes.h"
#include "core/grid/ParallelFor.h"
#include "core/rays/PyramidTraversal.h"
#include "core/surface/MinMaxPyramid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace terrain
{
/// Splits every range into pieces of three, and takes them from the last to the first.
inline void BackwardFor(std::int64_t count, const RangeBody& body)
{
  for (std::int64_t end = count; end > 0; end -= 3)
  {
    body(std::max<std::int64_t>(end - 3, 0), end);
  }
}

/// Samples with NaN for no data.
struct TestField
{
  std::string Name;
  int Width = 0;
  int Height = 0;
  std::vector<double> Samples;

  TestField(std::string name, int width, int height, const std::function<double(int, int)>& h)
    : Name(std::move(name))
    , Width(width)
    , Height(height)
  {
    for (int j = 0; j < height; ++j)
    {
      for (int i = 0; i < width; ++i)
      {
        this->Samples.push_back(h(i, j));
      }
    }
  }
  HeightfieldView<double> View() const
  {
    HeightfieldView<double> view;
    view.Samples = this->Samples.data();
    view.Width = this->Width;
    view.Height = this->Height;
    return view;
  }
};

/// Fields that break careless code: steep, flat, holed, narrow, tiny, far from zero.
inline std::vector<TestField> AdversarialFields()
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto random = [](int salt)
  {
    return [salt](int i, int j)
    {
      std::minstd_rand generator(static_cast<unsigned>(1 + salt + 7919 * i + 104729 * j));
      generator.discard(5);
      return static_cast<double>(generator() % 1000u);
    };
  };
  const auto hills = [](int i, int j)
  { return std::floor(300.0 + 200.0 * std::sin(0.31 * i) * std::cos(0.23 * j) + 3.0 * j); };
  std::vector<TestField> fields;
  fields.emplace_back(
    "spike", 33, 33, [](int i, int j) { return i == 16 && j == 11 ? 1000.0 : 0.0; });
  fields.emplace_back(
    "checkerboard", 16, 19, [](int i, int j) { return (i + j) % 2 ? 50.0 : 0.0; });
  fields.emplace_back("cliff", 40, 24, [](int i, int) { return i < 21 ? 0.0 : 60000.0; });
  fields.emplace_back("plane", 30, 30, [](int i, int j) { return 3.0 * i + 2.0 * j; });
  fields.emplace_back("flat", 17, 9, [](int, int) { return 5.0; });
  fields.emplace_back(
    "saddles", 18, 18, [](int i, int j) { return ((i / 2) + (j / 2)) % 2 ? 7.0 : 1.0; });
  fields.emplace_back("random", 37, 29, random(0));
  fields.emplace_back("hills", 64, 65, hills);
  fields.emplace_back("strip east", 41, 2, random(1));
  fields.emplace_back("strip north", 2, 41, random(2));
  fields.emplace_back("one cell", 2, 2, [](int i, int j) { return 3.0 * i * j; });
  fields.emplace_back("3 x 5", 3, 5, random(3));
  fields.emplace_back(
    "holes", 33, 35, [&](int i, int j) { return (i * 7 + j * 5) % 23 == 0 ? none : hills(i, j); });
  fields.emplace_back("half", 33, 35, [&](int i, int j) { return i > j ? none : hills(i, j); });
  fields.emplace_back("far from zero", 24, 24,
    [](int i, int j) { return 1e6 + 1e-2 * std::sin(0.7 * i) * std::cos(0.9 * j); });
  return fields;
}

/// A field as texels with its pyramid; the codes are what the GPU would hold.
template <typename Texel>
struct CodedField
{
  HeightCodes Codes;
  std::vector<Texel> Texels;
  HeightfieldView<Texel> TexelView;
  MinMaxPyramid<Texel> Pyramid;
  CodedPyramid<Texel> Coded;

  explicit CodedField(const TestField& field)
  {
    const HeightfieldView<double> view = field.View();
    this->Codes = ChooseHeightCodes(FindHeightRange(view, SerialFor));
    constexpr bool integer = std::is_integral_v<Texel>;
    this->Codes.Format =
      integer ? HeightCodes::TexelFormat::UInt16 : HeightCodes::TexelFormat::Float32;
    this->Codes.Bias = integer && this->Codes.HasNoData ? 1 : 0;
    this->Texels.resize(field.Samples.size());
    EncodeHeights(view, this->Codes, 0, view.Width, 0, view.Height, this->Texels.data(), SerialFor);
    this->TexelView.Samples = this->Texels.data();
    this->TexelView.Width = view.Width;
    this->TexelView.Height = view.Height;
    this->TexelView.HasNoData = this->Codes.HasNoData;
    this->TexelView.NoData = integer ? Texel{} : static_cast<Texel>(kNoDataCode);
    this->Pyramid.Build(this->TexelView, SerialFor);
    this->Coded.heights = { this->Texels.data(), { field.Width, field.Height }, this->Codes.Bias,
      static_cast<float>(this->Codes.MaximumCode) };
    this->Coded.pyramid = &this->Pyramid;
  }
  CodedField(const CodedField&) = delete;
  CodedField& operator=(const CodedField&) = delete;
};
}

#endif
