// SPDX-License-Identifier: Apache-2.0
// Stresses of shells in the axes of the scene.
#pragma once
#include <array>

#include "app/state/prepared.hpp"

namespace brunt::app {

enum class ShellHeight {
  bottom,  ///< the lowest point through the thickness
  middle,  ///< the point in the middle, or the mean of the two around it
  top      ///< the highest point
};

/// Cauchy stress xx, yy, zz, xy, yz, zx of an element of a block of shells [stress]: the mean over its points at this
/// height in its plane. Points keep their stress in axes of their own (element/shell_layers.hpp), which are turned
/// here.
std::array<double, 6> shell_stress(const Prepared& run, const model::ElementBlock& block, std::size_t b, LocalIndex e,
                                   ShellHeight height);

}  // namespace brunt::app
