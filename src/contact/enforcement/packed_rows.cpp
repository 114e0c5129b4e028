// SPDX-License-Identifier: Apache-2.0
#include "packed_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brunt::contact {
namespace {

/// In the order of the terms that Vec3::dot has.
BRUNT_INLINE Pack dot(const PackedVector& a, const PackedVector& b) {
  return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}

BRUNT_INLINE PackedVector times(Pack factor, const PackedVector& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}

BRUNT_INLINE PackedVector plus(const PackedVector& a, const PackedVector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

BRUNT_INLINE PackedVector minus(const PackedVector& a, const PackedVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

BRUNT_INLINE PackedVector select(PackMask mask, const PackedVector& yes, const PackedVector& no) {
  return {brunt::select(mask, yes[0], no[0]), brunt::select(mask, yes[1], no[1]), brunt::select(mask, yes[2], no[2])};
}

/// `admitted` of row_matrix.hpp.
BRUNT_INLINE PackedVector admitted(const RowBatch& batch, const PackedVector& impulse) {
  const Pack zero{};
  const Pack along = dot(batch.normal, impulse);
  const Pack push = brunt::select(batch.pushes & (along < zero), zero, along);
  const PackedVector pressed = times(push, batch.normal);
  const PackedVector across = minus(impulse, times(along, batch.normal));
  const Pack size = pack_sqrt(dot(across, across));
  const Pack limit = batch.friction * pack_abs(push) + batch.lagging;
  const PackedVector limited = times(limit / size, across);
  const PackMask within = batch.holds | ~(size > limit);
  const PackedVector whole = plus(pressed, select(within, across, limited));
  return select(batch.slips | (batch.pushes & (push == zero)), pressed, whole);
}

/// `missing_rate` of row_matrix.hpp, and what soft rows yield.
BRUNT_INLINE PackedVector missing_rate(const RowBatch& batch, const PackedVector& relative,
                                       const PackedVector& impulse) {
  const Pack along = dot(batch.normal, relative);
  const PackedVector normal = times(batch.required - along, batch.normal);
  const PackedVector across = minus(batch.drift, minus(relative, times(along, batch.normal)));
  const PackedVector missing = select(batch.slips, normal, plus(normal, across));
  if (!batch.any_soft) return missing;
  const PackedVector yields = minus(batch.borne, times(batch.compliance, impulse));
  return select(batch.soft, plus(missing, yields), missing);
}

/// Maxima lane by lane, of what is not NaN; and whether NaN was among it.
struct PackedMaximum {
  Pack largest{};
  PackMask nan{};
  BRUNT_INLINE void keep(PackMask counts, Pack value) {
    nan |= counts & (value != value);
    largest = brunt::select(counts & (value > largest), value, largest);
  }
  [[nodiscard]] double value() const {
    if (any(nan)) return std::numeric_limits<double>::infinity();
    double most = 0;
    for (int lane = 0; lane < pack_width; ++lane) most = std::max(most, largest[lane]);
    return most;
  }
};

BRUNT_INLINE std::int64_t sum_of(const FixedUnit& unit, PackMask counts, Pack terms) {
  std::int64_t sum = 0;
  const Pack counted = brunt::select(counts, terms, Pack{});
  for (int lane = 0; lane < pack_width; ++lane) sum += unit.of(counted[lane]);
  return sum;
}

void set(PackedVector& packed, int lane, const Vec3& value) {
  for (int c = 0; c < 3; ++c) packed[static_cast<std::size_t>(c)][lane] = value[c];
}

Vec3 of_lane(const PackedVector& packed, int lane) {
  return {packed[0][lane], packed[1][lane], packed[2][lane]};
}

void set_law(const RowLaw& law, double diagonal, int lane, RowBatch& batch) {
  const auto flag = [](bool holds) { return std::int64_t{holds ? -1 : 0}; };
  set(batch.normal, lane, law.normal);
  set(batch.drift, lane, law.drift);
  batch.required[lane] = law.required;
  batch.friction[lane] = law.friction;
  batch.lagging[lane] = law.lagging;
  batch.noise[lane] = law.noise;
  batch.slope[lane] = law.across == Across::rubs ? std::hypot(1.0, law.friction) : law.share;
  batch.diagonal[lane] = diagonal;
  batch.moves[lane] = flag(diagonal > 0);
  batch.pushes[lane] = flag(law.cone == Cone::compression);
  batch.slips[lane] = flag(law.across == Across::slips);
  batch.holds[lane] = flag(law.across == Across::holds);
  batch.soft[lane] = flag(law.softness > 0);
  batch.any_soft = batch.any_soft || law.softness > 0;
  batch.any_turns = batch.any_turns || law.turns;
  batch.any_tilts = batch.any_tilts || law.tilts;
}

constexpr auto width = static_cast<std::size_t>(pack_width);

}  // namespace

void PackedRows::reserve(std::size_t rows, std::size_t points_of_a_row, bool tilts, std::size_t nodes) {
  const std::size_t batches = (rows + width - 1) / width;
  batches_.reserve(batches);
  iterates_.reserve(batches);
  points_.reserve(batches * width * points_of_a_row);
  weights_.reserve(batches * points_of_a_row);
  if (tilts) tilts_.reserve(batches * points_of_a_row);
  velocity_.reserve(nodes);
}

void PackedRows::lay(const RowMatrix& rows, std::span<const double> diagonal, std::span<const double> compliance,
                     std::span<const Vec3> borne, std::span<const Vec3> impulses) {
  const std::size_t batches = (rows.size() + width - 1) / width;
  batches_.assign(batches, RowBatch{});
  iterates_.assign(batches, BatchIterate{});
  points_.clear();
  weights_.clear();
  tilts_.clear();
  for (std::size_t b = 0; b < batches; ++b) {
    RowBatch& batch = batches_[b];
    batch.first = static_cast<LocalIndex>(weights_.size());
    const std::size_t first = b * width, lanes = std::min(width, rows.size() - first);
    std::size_t most = 0;
    for (std::size_t lane = 0; lane < lanes; ++lane)
      most = std::max(most, rows.end(first + lane) - rows.begin(first + lane));
    batch.entries = static_cast<LocalIndex>(most);
    weights_.resize(weights_.size() + most, Pack{});
    points_.resize(points_.size() + most * width, 0);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const std::size_t q = first + lane;
      const int at = static_cast<int>(lane);
      set_law(rows.laws[q], diagonal[q], at, batch);
      if (rows.laws[q].softness > 0) {
        set(batch.borne, at, borne[q]);
        batch.compliance[at] = compliance[q];
      }
      set(iterates_[b].impulse, at, impulses[q]);
      for (std::size_t k = rows.begin(q); k < rows.end(q); ++k) {
        const std::size_t entry = static_cast<std::size_t>(batch.first) + k - rows.begin(q);
        points_[entry * width + lane] = rows.points[k];
        weights_[entry][at] = rows.weights[k];
      }
    }
    iterates_[b].previous = iterates_[b].impulse;
    if (batch.any_tilts) lay_tilts(rows, b);
  }
}

void PackedRows::lay_tilts(const RowMatrix& rows, std::size_t b) {
  RowBatch& batch = batches_[b];
  batch.first_tilt = static_cast<LocalIndex>(tilts_.size());
  tilts_.resize(tilts_.size() + static_cast<std::size_t>(batch.entries), PackedVector{});
  for (std::size_t lane = 0; lane < width && b * width + lane < rows.size(); ++lane) {
    const std::size_t q = b * width + lane;
    if (!rows.laws[q].tilts) continue;
    for (std::size_t k = rows.begin(q); k < rows.end(q); ++k)
      set(tilts_[static_cast<std::size_t>(batch.first_tilt) + k - rows.begin(q)], static_cast<int>(lane),
          rows.tilt(q, k));
  }
}

void PackedRows::take_velocities(std::span<const Vec3> velocity) {
  velocity_.resize(velocity.size());
  for (std::size_t n = 0; n < velocity.size(); ++n)
    velocity_[n] = Quad{velocity[n][0], velocity[n][1], velocity[n][2], 0};
}

BRUNT_INLINE PackedVector PackedRows::velocity_at(std::size_t entry) const {
  const LocalIndex* point = &points_[entry * width];
  PackedVector v;
  components_of([&](int lane) { return nth(velocity_, point[lane]); }, v[0], v[1], v[2]);
  return v;
}

/// Of a batch with tilts.
PackedVector PackedRows::tilted(const RowBatch& batch) const {
  PackedVector sum{}, of_tilts{};
  for (LocalIndex k = 0; k < batch.entries; ++k) {
    const auto entry = static_cast<std::size_t>(batch.first + k);
    const PackedVector v = velocity_at(entry);
    sum = plus(sum, times(weights_[entry], v));
    of_tilts = plus(of_tilts, times(dot(batch.normal, v), tilts_[static_cast<std::size_t>(batch.first_tilt + k)]));
  }
  return plus(sum, of_tilts);
}

PackedVector PackedRows::relative(const RowMatrix& rows, std::size_t b) const {
  const RowBatch& batch = batches_[b];
  if (batch.any_tilts && !batch.any_turns) return tilted(batch);
  PackedVector sum{};
  for (LocalIndex k = 0; k < batch.entries; ++k) {
    const auto entry = static_cast<std::size_t>(batch.first + k);
    sum = plus(sum, times(weights_[entry], velocity_at(entry)));
  }
  if (!batch.any_turns) [[likely]]
    return sum;
  const auto velocity_of = [&](LocalIndex node) {
    const Quad& v = nth(velocity_, node);
    return Vec3(v[0], v[1], v[2]);
  };
  for (std::size_t lane = 0; lane < width && b * width + lane < rows.size(); ++lane) {
    const std::size_t q = b * width + lane;
    const RowLaw& law = rows.laws[q];
    if (!law.turns && !law.tilts) continue;
    Vec3 turned = of_lane(sum, static_cast<int>(lane));
    if (law.turns) add_turned(rows, q, velocity_of, turned);
    if (law.tilts) add_tilted(rows, q, velocity_of, turned);
    set(sum, static_cast<int>(lane), turned);
  }
  return sum;
}

RowsSeen PackedRows::judge(const RowMatrix& rows, const FixedUnit* unit) {
  RowsSeen seen;
  PackedMaximum residual, energy, largest, rise, speed;
  for (std::size_t b = 0; b < batches_.size(); ++b) {
    const RowBatch& batch = batches_[b];
    BatchIterate& now = iterates_[b];
    const PackMask moves = batch.moves;
    if (!any(moves)) continue;  // nothing in these rows can move
    const Pack h = batch.diagonal;
    const PackedVector missing = missing_rate(batch, relative(rows, b), now.impulse);
    if (unit != nullptr) {
      const PackedVector change = minus(now.impulse, now.previous), a_change = minus(now.missing, missing);
      seen.change_h_change += sum_of(*unit, moves, h * dot(change, change));
      seen.change_a_change += sum_of(*unit, moves, dot(change, a_change));
      seen.a_change_a_change += sum_of(*unit, moves, dot(a_change, a_change) / h);
    }
    now.missing = select(moves, missing, now.missing);
    const PackedVector asked{now.impulse[0] + missing[0] / h, now.impulse[1] + missing[1] / h,
                             now.impulse[2] + missing[2] / h};
    const PackedVector change = minus(admitted(batch, asked), now.impulse);
    const Pack step = pack_sqrt(dot(change, change));
    const Pack along = dot(batch.normal, missing);
    const Pack ahead =
        brunt::select(batch.pushes, brunt::select(along > 0.0, along, Pack{}), pack_sqrt(dot(missing, missing)));
    residual.keep(moves, h * step - batch.noise);
    energy.keep(moves, h * step * step);
    largest.keep(moves, batch.slope * pack_sqrt(dot(now.impulse, now.impulse)) + batch.lagging);
    rise.keep(moves, batch.slope * ahead / h);
    PackedVector leader;
    const LocalIndex* point = &points_[static_cast<std::size_t>(batch.first) * width];
    components_of([&](int lane) { return nth(velocity_, point[lane]); }, leader[0], leader[1], leader[2]);
    speed.keep(moves, pack_max(pack_max(pack_abs(leader[0]), pack_abs(leader[1])), pack_abs(leader[2])));
  }
  seen.residual = residual.value();
  seen.energy = energy.value();
  seen.impulse = largest.value();
  seen.rise = rise.value();
  seen.speed = speed.value();
  return seen;
}

void PackedRows::advance(double length, std::span<Vec3> impulses) {
  for (std::size_t b = 0; b < batches_.size(); ++b) {
    const RowBatch& batch = batches_[b];
    BatchIterate& now = iterates_[b];
    const Pack factor = length / batch.diagonal;
    now.previous = now.impulse;
    now.impulse = select(batch.moves, admitted(batch, plus(now.impulse, times(factor, now.missing))), PackedVector{});
    const std::size_t first = b * width, lanes = std::min(width, impulses.size() - first);
    for (std::size_t lane = 0; lane < lanes; ++lane)
      impulses[first + lane] = of_lane(now.impulse, static_cast<int>(lane));
  }
}

void PackedRows::reset() {
  for (BatchIterate& now : iterates_) now.impulse = now.previous = PackedVector{};
}

}  // namespace brunt::contact
