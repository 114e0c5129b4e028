// SPDX-License-Identifier: Apache-2.0
// Binned sums of vectors: binned_add of three components at once.
#pragma once
#include <cstring>

#include "core/binned_sum.hpp"
#include "core/simd.hpp"
#include "core/types.hpp"

namespace brunt::contact {

class ImpulseGrid {
 public:
  explicit ImpulseGrid(const BinGrid& grid) : coarse_(Quad{} + grid.anchor[0]), fine_(Quad{} + grid.anchor[1]) {}
  void add(const Vec3& impulse, double* parts) const { add(Quad{impulse[0], impulse[1], impulse[2], 0}, parts); }
  void add(const Quad& term, double* parts) const {
    const Quad coarse = (term + coarse_) - coarse_, rest = term - coarse;
    add_to(parts, coarse);
    add_to(parts + 4, (rest + fine_) - fine_);
  }

 private:
  static void add_to(double* sum, const Quad& term) {
    Quad value;
    std::memcpy(&value, sum, sizeof value);
    value += term;
    std::memcpy(sum, &value, sizeof value);
  }
  Quad coarse_, fine_;
};

}  // namespace brunt::contact
