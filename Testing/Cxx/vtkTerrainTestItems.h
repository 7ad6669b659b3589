// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Numbers that a shader is given, with those that its twin makes of them.
 */
#ifndef vtkTerrainTestItems_h
#define vtkTerrainTestItems_h

#include "vtkTerrainTesting.h"

#include "vtkRenderWindow.h"
#include "vtkShaderProgram.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace vtkTerrainTesting
{
constexpr int NumberOfItems = 2000;

/// Random numbers of a range.
class Numbers
{
public:
  float operator()(double low, double high)
  {
    return static_cast<float>(std::uniform_real_distribution<double>(low, high)(this->Generator));
  }

private:
  std::mt19937 Generator{ 7 };
};

/// Inputs of 4 numbers each, and how many of the results differ.
struct Items
{
  std::vector<glm::vec4> Inputs[2];
  std::vector<glm::vec4> Expected;

  void Add(const glm::vec4& first, const glm::vec4& second, const glm::vec4& expected)
  {
    this->Inputs[0].push_back(first);
    this->Inputs[1].push_back(second);
    this->Expected.push_back(expected);
  }

  /// Runs a shader over the items, and counts the results off by more than a tolerance, relative
  /// above 1.
  int CountDifferent(vtkRenderWindow* window, const std::string& declarations,
    const std::string& body, float tolerance,
    const std::function<void(vtkShaderProgram*)>& setUniforms) const
  {
    std::vector<std::vector<float>> inputs;
    for (const std::vector<glm::vec4>& input : this->Inputs)
    {
      inputs.emplace_back(&input[0][0], &input[0][0] + 4 * input.size());
    }
    const std::vector<float> results = RunShader(window, declarations, body, inputs, setUniforms);
    EXPECT_EQ(results.size(), 4 * this->Expected.size());
    int different = results.empty() ? NumberOfItems : 0;
    for (std::size_t k = 0; k < results.size(); ++k)
    {
      const float expected = this->Expected[k / 4][static_cast<int>(k % 4)];
      const float allowed = tolerance * std::max(std::abs(expected), 1.0f);
      different += std::abs(results[k] - expected) <= allowed ? 0 : 1;
    }
    return different;
  }
};
}

#endif
