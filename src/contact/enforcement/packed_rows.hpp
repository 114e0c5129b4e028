// SPDX-License-Identifier: Apache-2.0
// The rows of a step side by side, one a lane: an iteration of the rate constraint judges and moves pack_width of them
// at once. Each lane has the bits that its row would have alone, so it does not matter which rows share a batch.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/data/row_matrix.hpp"
#include "core/aligned.hpp"
#include "core/fixed_sum.hpp"
#include "core/simd.hpp"

namespace brunt::contact {

using PackedVector = std::array<Pack, 3>;

/// What does not change while a step is solved; see RowLaw. Lanes behind the last row do not move.
struct RowBatch {
  PackedVector normal, drift, borne;
  Pack required, friction, lagging, noise, compliance;
  Pack slope;     ///< bound of the impulse on a node, over the row's impulse along its normal
  Pack diagonal;  ///< H [1/mass]
  PackMask moves, pushes, slips, holds, soft;
  LocalIndex first = 0, entries = 0;  ///< in PackedRows::points, of all lanes
  LocalIndex first_tilt = 0;          ///< in PackedRows::tilts, of batches with any
  bool any_soft = false, any_turns = false, any_tilts = false;
};

struct BatchIterate {
  PackedVector impulse, previous, missing;
};

/// What the rows of this rank tell of an iterate: maxima and sums as in Judgement (rate_constraint.cpp).
struct RowsSeen {
  double residual = 0, energy = 0, impulse = 0, rise = 0, speed = 0;
  std::int64_t change_h_change = 0, change_a_change = 0, a_change_a_change = 0;
};

class PackedRows {
 public:
  void reserve(std::size_t rows, std::size_t points_of_a_row, bool tilts, std::size_t nodes);
  /// Lays the rows out; a row each of EnforcementScratch::diagonal, compliance and borne. The impulses before are the
  /// present ones, and the missing rates are zero.
  void lay(const RowMatrix& rows, std::span<const double> diagonal, std::span<const double> compliance,
           std::span<const Vec3> borne, std::span<const Vec3> impulses);
  void take_velocities(std::span<const Vec3> velocity);
  /// Finds the missing rates. unit: of the sums; none for the first iterate, which has no change.
  RowsSeen judge(const RowMatrix& rows, const FixedUnit* unit);
  /// p <- admitted(p + length missing / H), also into `impulses`.
  void advance(double length, std::span<Vec3> impulses);
  /// Impulses of zero, as those before.
  void reset();

 private:
  void lay_tilts(const RowMatrix& rows, std::size_t b);
  [[nodiscard]] PackedVector velocity_at(std::size_t entry) const;
  [[nodiscard]] PackedVector tilted(const RowBatch& batch) const;
  [[nodiscard]] PackedVector relative(const RowMatrix& rows, std::size_t b) const;

  AlignedVector<RowBatch> batches_;
  AlignedVector<BatchIterate> iterates_;
  std::vector<LocalIndex> points_;     ///< of each batch: [entry][lane]; weight 0 where a row has fewer entries
  AlignedVector<Pack> weights_;        ///< [entry]
  AlignedVector<PackedVector> tilts_;  ///< [entry] of batches with tilts, 0 where a row has none
  AlignedVector<Quad> velocity_;       ///< of the contact nodes
};

}  // namespace brunt::contact
