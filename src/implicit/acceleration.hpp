// SPDX-License-Identifier: Apache-2.0
// Corrections of a tangent that lacks second derivatives, combined with former ones: Anderson's method. With c(x) the
// correction at x, the iteration x <- x - c(x) has the linear rate of the missing part. Differences of the last
// corrections over the last steps tell how c changes with x along these directions: they take the place of the missing
// part there.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "comm/communicator.hpp"

namespace brunt::implicit {

class Acceleration {
 public:
  /// Combines a correction with the former ones; measured: so many of the first unknowns of this rank determine the
  /// combination, by exact sums. Collective.
  void improve(const comm::Communicator& ranks, std::size_t measured, std::span<double> correction);
  /// The share of the last correction that was taken.
  void took(double share) { share_ = share; }
  /// Forgets former corrections: those of other branches of contact say nothing.
  void forget() { known_ = 0, last_.clear(); }

 private:
  /// Differences that are kept: the missing part acts on few shapes of a contact zone.
  static constexpr std::size_t depth = 3;
  struct Change {
    std::vector<double> correction, place;
  };
  std::array<Change, depth> change_;  ///< the newest first
  std::size_t known_ = 0;
  std::vector<double> last_, applied_;  ///< the last correction, and what came of it
  double share_ = 1;
};

}  // namespace brunt::implicit
