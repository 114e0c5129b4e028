// SPDX-License-Identifier: Apache-2.0
// Piecewise linear yield stress as a function of equivalent plastic strain, and the plastic strain of a return to it.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

namespace brunt::material {

/// Straight pieces of a hardening table; beyond the last point the curve is flat.
class YieldCurve {
 public:
  /// `table`: (equivalent plastic strain, yield stress) pairs, strains increasing from 0, stresses positive.
  /// `shear_modulus` > 0: a piece may soften by less than three times this value, otherwise no return exists. Throws
  /// InputError with one line for each fault.
  YieldCurve(const std::vector<std::array<double, 2>>& table, double shear_modulus);

  [[nodiscard]] double initial() const { return pieces_.front().yield; }
  /// The smallest yield stress anywhere on the curve.
  [[nodiscard]] double smallest() const;
  /// Yield stress at `plastic_strain` >= 0.
  [[nodiscard]] double at(double plastic_strain) const;
  /// d yield / d strain there; at a point of the table that of the following piece.
  [[nodiscard]] double slope_at(double plastic_strain) const { return pieces_[piece_of(plastic_strain)].slope; }
  [[nodiscard]] double three_shear() const { return three_shear_; }

  /// The increment d >= 0 that solves 3 G d + Y(p + d) - Y(p) = excess, with p the plastic strain before the step and
  /// excess >= 0 the trial equivalent stress above yield. Exact: one division in the piece where the return ends.
  [[nodiscard]] double plastic_increment(double plastic_strain, double excess) const {
    return plastic_increment(plastic_strain, excess, three_shear_);
  }
  /// The same with another value of 3 G, which must exceed three times the softening of every piece.
  [[nodiscard]] double plastic_increment(double plastic_strain, double excess, double three_shear) const;

 private:
  struct Piece {
    double strain, yield, slope;  ///< at its start; d yield / d strain along it
  };
  [[nodiscard]] std::size_t piece_of(double plastic_strain) const;

  std::vector<Piece> pieces_;
  double three_shear_;
};

}  // namespace brunt::material
