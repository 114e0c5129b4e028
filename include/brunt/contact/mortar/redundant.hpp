// SPDX-License-Identifier: Apache-2.0
// Constraint equations that others imply: their multipliers have no unique value, and the system would be singular.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "brunt/contact/mortar/interface.hpp"

namespace brunt::contact {

/// The rows of one interface as equations sum_K w_AK d . x_K = given, d in the directions that a row holds.
struct Equations {
  const NodeBlocks<double>* weights = nullptr;  ///< [length^2]
  std::span<const double> covered;              ///< a row each [length^2]
  std::span<const LocalIndex> slaves;           ///< the slave node of each row
  std::vector<Mat3> held;               ///< a row each: projector on the directions that it holds; zero: no equation
  std::vector<std::uint8_t> preferred;  ///< rows that are kept before others; or empty
};

/// Takes out of Equations::held what the rows before, preferred ones first, imply over the free directions of all
/// nodes: by elimination, in the order of interfaces and rows. A slave node that is free along a direction and has rows
/// of one interface alone is an unknown of its own equation, which is never implied; the others are looked through.
/// free: projector on the free directions of each node.
void leave_out_implied(std::span<Equations> interfaces, std::span<const Mat3> free);

}  // namespace brunt::contact
