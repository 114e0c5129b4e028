// SPDX-License-Identifier: Apache-2.0
// Copies values from the rank that owns them (roots) to the ranks that need copies (leaves): a star forest (PetscSF),
// built once and used many times. It does no arithmetic, so no order of summation matters.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "comm/communicator.hpp"

namespace brunt::comm {

struct RemoteSlot {
  Rank rank = 0;
  LocalIndex index = 0;  ///< into the roots of that rank
};

class Halo {
 public:
  Halo() = default;
  /// Leaf i of this rank takes its value from `source[i]`, which may also be on this rank. Collective.
  Halo(const Communicator& ranks, LocalIndex roots, std::span<const RemoteSlot> source);

  [[nodiscard]] LocalIndex roots() const;
  [[nodiscard]] LocalIndex leaves() const;

  /// leaves[i * width .. ] = roots[source[i] * width .. ]. Collective. Other work on other arrays may be done between
  /// begin and end.
  void begin(std::span<const double> roots, std::span<double> leaves, int width) const;
  void end(std::span<const double> roots, std::span<double> leaves, int width) const;
  void forward(std::span<const double> roots, std::span<double> leaves, int width) const {
    begin(roots, leaves, width);
    end(roots, leaves, width);
  }
  /// The reverse direction: roots[source[i]] = leaves[i]. Each root may have at most one leaf.
  void backward(std::span<const double> leaves, std::span<double> roots, int width) const;

 private:
  struct Forest;
  std::shared_ptr<Forest> forest_;
};

}  // namespace brunt::comm
