// SPDX-License-Identifier: Apache-2.0
// Linearly dependent constraint equations: their multipliers are not unique, and the system would be singular.
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <unordered_map>
#include <vector>

#include "contact/mortar/interface.hpp"

namespace brunt::contact {

/// The rows of one interface as equations sum_K d . (w_AK 1 + lever_AK) dx_K = given, with d in the constrained
/// directions of a row.
struct Equations {
  const NodeBlocks<double>* weights = nullptr;  ///< [length^2]
  const NodeBlocks<Mat3>* levers = nullptr;     ///< of ties over a gap; or none [length^2]
  std::span<const double> covered;              ///< one entry for each row [length^2]
  std::span<const LocalIndex> slaves;           ///< the slave node of each row
  std::vector<Mat3> held;               ///< for each row: projector onto its constrained directions; zero: no equation
  std::vector<std::uint8_t> preferred;  ///< rows that are retained before others; or empty: all have equal rank
};

/// A scalar equation: coefficients by 3 number of the node + axis.
using Line = std::map<GlobalIndex, double>;

/// The equation of one row along a direction.
struct RowLine {
  std::size_t row = 0;
  Vec3 direction = Vec3::Zero();  ///< unit
  Line line;
};

/// The nodes of the equations and their data.
struct EquationNodes {
  std::span<const GlobalIndex> number;   ///< canonical
  std::span<const Mat3> free;            ///< projector onto the free directions
  std::span<const std::uint8_t> shared;  ///< equations of several interfaces contain the node; used for slave nodes
};

/// Equations that may be redundant, by rows. A slave node that is free along a direction and has rows of one interface
/// only is an unknown of its own equation, which is therefore never redundant.
std::vector<RowLine> lines_to_look_at(const Equations& equations, const EquationNodes& nodes);

/// Scalar equations in echelon form: a redundant equation is reduced to zero by the previous ones.
class Echelon {
 public:
  /// Returns false if the equation is redundant.
  bool add(Line line);

 private:
  void eliminate(Line& line) const;

  std::vector<Line> lines_;
  std::vector<GlobalIndex> pivots_;                        ///< of each line
  std::unordered_map<GlobalIndex, std::size_t> of_pivot_;  ///< the line of a pivot
};

}  // namespace brunt::contact
