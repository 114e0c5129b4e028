// SPDX-License-Identifier: Apache-2.0
// The rows of a step as seen by enforcement: a sparse matrix G in compressed storage, three numerical rows (a relative
// velocity) for each row over contact points, and the law of each row. Rows have any number of points and weights of
// any sign; the kind of contact is not known here. `compress` appends the rows of detection, other sources (mortar,
// joint limits) use `begin_row`, `add` and `close_row`.
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/data/constraint.hpp"
#include "core/error.hpp"
#include "core/ragged.hpp"
#include "core/types.hpp"

namespace brunt::contact {

/// Tangential behaviour of a row.
enum class Across : std::int8_t {
  slips,  ///< no tangential impulse
  rubs,   ///< Coulomb friction
  holds   ///< any tangential impulse
};

/// Required rates and admissible impulses of a row: normal . r >= required (equality for a free cone) and, unless it
/// slips, r = drift across the normal as long as its impulse is admissible.
struct RowLaw {
  Vec3 normal = Vec3::Zero();  ///< unit
  double required = 0;         ///< least rate along the normal [velocity]
  Vec3 drift = Vec3::Zero();   ///< rate across the normal [velocity]
  double friction = 0;         ///< Coulomb coefficient, where it rubs
  double lagging = 0;          ///< additional admissible tangential impulse for the previous pressure [momentum]
  double noise = 0;            ///< bound of the error of the required rate due to rounding [velocity]
  double softness = 0;         ///< s of enforcement/softness.hpp; 0: rigid
  double share = 1;            ///< upper bound of the factor between the row's impulse and that on a point
  Cone cone = Cone::compression;
  Across across = Across::slips;
  bool turns = false;  ///< it has moment arms
  bool tilts = false;  ///< it has tilts, and no arms
};

/// Further quantities for single methods.
struct RowFigures {
  double gap = 0;          ///< at x_n [length]
  double gap_share = 0;    ///< share of the penetration that `required` recovers
  double drift_share = 0;  ///< share of the slip that `drift` recovers
  double wall_rate = 0;    ///< of a moving wall itself, along the normal [velocity]; part of `required`
  double slab = 0;         ///< eq. (29) of Heinstein et al. 2000 [mass/time]; 0: not known
  Pass pass = Pass::both;
};

/// Part of a row in one body (see enforcement/carried.hpp) [1/mass^(1/2)].
struct BodyShare {
  LocalIndex body = 0;
  LocalIndex group = 0;  ///< of the body's rows, those that have it to do with the same
  double weight = 0;     ///< sqrt of the largest eigenvalue of g W g^T, g the row's block; of rows that slip `along`
  double along = 0;      ///< sqrt(n . g W g^T n)
};

struct RowMatrix {
  std::vector<LocalIndex> offsets{0};  ///< of the entries: rows + 1
  std::vector<LocalIndex>
      points;  ///< contact nodes, one for each entry; the first one of a row represents its size and speed
  std::vector<double> weights;        ///< an entry each, |weight| + size of its arm or tilt <= largest_weight
  std::vector<LocalIndex> first_arm;  ///< a row each: the arm or tilt of its first entry, where it has some
  std::vector<Arm> arms;              ///< an entry each of the rows that turn
  std::vector<Vec3> tilt_of;          ///< an entry each of the rows that tilt, see Row::tilts
  std::vector<RowLaw> laws;
  std::vector<RowFigures> figures;
  Ragged<BodyShare> on_bodies;  ///< a row each; no rows at all where there are no bodies
  static constexpr double largest_weight =
      4;  ///< sums over weights are binned on a grid for this bound: scale rows to it

  [[nodiscard]] std::size_t size() const { return laws.size(); }
  [[nodiscard]] std::size_t entries() const { return points.size(); }
  [[nodiscard]] std::size_t begin(std::size_t q) const { return static_cast<std::size_t>(offsets[q]); }
  [[nodiscard]] std::size_t end(std::size_t q) const { return static_cast<std::size_t>(offsets[q + 1]); }
  [[nodiscard]] std::size_t point(std::size_t entry) const { return static_cast<std::size_t>(points[entry]); }
  [[nodiscard]] std::size_t leader(std::size_t q) const { return point(begin(q)); }
  [[nodiscard]] bool has_bodies() const { return on_bodies.rows() > 0; }
  [[nodiscard]] std::span<const BodyShare> bodies_of(std::size_t q) const {
    return has_bodies() ? on_bodies.row(static_cast<LocalIndex>(q)) : std::span<const BodyShare>{};
  }
  /// Of an entry of a row that turns.
  [[nodiscard]] const Arm& arm(std::size_t q, std::size_t entry) const {
    return arms[static_cast<std::size_t>(first_arm[q]) + entry - begin(q)];
  }
  /// Of an entry of a row that tilts.
  [[nodiscard]] const Vec3& tilt(std::size_t q, std::size_t entry) const {
    return tilt_of[static_cast<std::size_t>(first_arm[q]) + entry - begin(q)];
  }

  void clear();
  /// Reserves memory, so that a step allocates nothing. arms, tilts: number of entries of rows that have them.
  void reserve(std::size_t rows, std::size_t entries, std::size_t arms, std::size_t tilts);
  void add(LocalIndex point, double weight) {
    points.push_back(point);
    weights.push_back(weight);
  }
  void add(LocalIndex point, double weight, const Arm& arm) {
    add(point, weight);
    arms.push_back(arm);
  }
  void add(LocalIndex point, double weight, const Vec3& tilt) {
    add(point, weight);
    tilt_of.push_back(tilt);
  }
  /// Ends the row of the entries added since the last call, all with an arm, all with a tilt or all with neither.
  void close_row(const RowLaw& law, const RowFigures& of_row);
  /// Row q of another matrix.
  void append(const RowMatrix& other, std::size_t q);
};

/// The law of a row of detection.
RowLaw law_of(const Row& row);

/// The matrix of these rows, in their order.
const RowMatrix& compress(std::span<const Row> rows, RowMatrix& matrix);

/// Contribution of arms to the relative velocity.
template <std::invocable<LocalIndex> VelocityOf>
[[gnu::noinline]] void add_turned(const RowMatrix& rows, std::size_t q, const VelocityOf& velocity_of, Vec3& relative) {
  for (std::size_t k = rows.begin(q); k < rows.end(q); ++k)
    relative += rows.arm(q, k).turn * velocity_of(rows.points[k]);
}

/// Contribution of tilts to the relative velocity.
template <std::invocable<LocalIndex> VelocityOf>
[[gnu::noinline]] void add_tilted(const RowMatrix& rows, std::size_t q, const VelocityOf& velocity_of, Vec3& relative) {
  Vec3 tilted = Vec3::Zero();
  for (std::size_t k = rows.begin(q); k < rows.end(q); ++k)
    tilted += rows.laws[q].normal.dot(velocity_of(rows.points[k])) * rows.tilt(q, k);
  relative += tilted;
}

/// The relative velocity of row q; velocity_of(point): of a contact node.
template <std::invocable<LocalIndex> VelocityOf>
[[gnu::always_inline]] inline Vec3 relative_velocity(const RowMatrix& rows, std::size_t q,
                                                     const VelocityOf& velocity_of) {
  Vec3 relative = Vec3::Zero();
  const std::size_t end = rows.end(q);
  for (std::size_t k = rows.begin(q); k < end; ++k) relative += rows.weights[k] * velocity_of(rows.points[k]);
  if (rows.laws[q].turns) [[unlikely]]
    add_turned(rows, q, velocity_of, relative);
  if (rows.laws[q].tilts) add_tilted(rows, q, velocity_of, relative);
  return relative;
}

/// The part of the impulse of row q that acts on an entry's point [momentum].
inline Vec3 impulse_on_point(const RowMatrix& rows, std::size_t q, std::size_t entry, const Vec3& impulse) {
  Vec3 share = rows.weights[entry] * impulse;
  if (rows.laws[q].turns) share += rows.arm(q, entry).turn.transpose() * impulse;
  if (rows.laws[q].tilts) share += rows.tilt(q, entry).dot(impulse) * rows.laws[q].normal;
  return share;
}

/// The largest admissible tangential impulse [momentum] for this normal impulse, if the row has friction.
inline double friction_limit(const RowLaw& law, double along) {
  return law.friction * std::abs(along) + law.lagging;
}

/// Return of an impulse to the admissible set: no tension (unless the cone is free), and a tangential part within the
/// friction limit of the normal part. The normal part is determined first and independently: Coulomb's law, not the
/// projection onto the cone, which would separate sliding bodies.
inline Vec3 admitted(const RowLaw& law, const Vec3& impulse) {
  const double along = law.normal.dot(impulse);
  const double push = law.cone == Cone::compression && along < 0 ? 0.0 : along;
  const bool holds_pull = law.cone == Cone::free;
  if (law.across == Across::slips || (push == 0 && !holds_pull)) return push * law.normal;
  const Vec3 across = impulse - along * law.normal;
  if (law.across == Across::holds) return push * law.normal + across;
  const double limit = friction_limit(law, push), size = across.norm();
  return push * law.normal + (size > limit ? Vec3(limit / size * across) : across);
}

/// The rate that the law requires beyond this relative velocity: required - n . v along the normal and, unless it
/// slips, drift - v across it [velocity].
inline Vec3 missing_rate(const RowLaw& law, const Vec3& relative) {
  const double along = law.normal.dot(relative);
  Vec3 missing = (law.required - along) * law.normal;
  if (law.across != Across::slips) missing += law.drift - (relative - along * law.normal);
  return missing;
}

}  // namespace brunt::contact
