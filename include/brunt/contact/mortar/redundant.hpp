// SPDX-License-Identifier: Apache-2.0
// Constraint equations that others imply: their multipliers have no unique value, and the system would be singular.
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

#include "brunt/contact/mortar/interface.hpp"

namespace brunt::contact {

/// The rows of one interface as equations sum_K w_AK d . x_K = given, d in the directions that a row holds.
struct Equations {
  const NodeBlocks<double>* weights = nullptr;  ///< [length^2]
  std::span<const double> covered;              ///< a row each [length^2]
  std::span<const LocalIndex> slaves;           ///< the slave node of each row
  std::vector<Mat3> held;               ///< a row each: projector on the directions that it holds; zero: no equation
  std::vector<std::uint8_t> preferred;  ///< rows that are kept before others; or empty: all are
};

/// A scalar equation: coefficients by 3 number of the node + axis.
using Line = std::map<GlobalIndex, double>;

/// The equation of one row along a direction.
struct RowLine {
  std::size_t row = 0;
  Vec3 direction = Vec3::Zero();  ///< unit
  Line line;
};

/// The nodes of the equations, and what is known of them.
struct EquationNodes {
  std::span<const GlobalIndex> number;   ///< canonical
  std::span<const Mat3> free;            ///< projector on the free directions
  std::span<const std::uint8_t> shared;  ///< equations of several interfaces have the node; asked of slave nodes
};

/// What others might imply, by rows: a slave node that is free along a direction and has rows of one interface alone is
/// an unknown of its own equation, which is never implied.
std::vector<RowLine> lines_to_look_at(const Equations& equations, const EquationNodes& nodes);

/// Scalar equations in echelon form: one that those before it imply has nothing left.
class Echelon {
 public:
  /// False: implied.
  bool add(Line line);

 private:
  void eliminate(Line& line) const;

  std::vector<Line> lines_;
  std::vector<GlobalIndex> pivots_;                        ///< of each line
  std::unordered_map<GlobalIndex, std::size_t> of_pivot_;  ///< the line of a pivot
};

}  // namespace brunt::contact
