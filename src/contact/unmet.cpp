// SPDX-License-Identifier: Apache-2.0
#include "contact/unmet.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/contact.hpp"
#include "contact/data/tolerances.hpp"
#include "core/fixed_sum.hpp"

namespace brunt::contact {
namespace {

/// Sums over the growing rows on a body, by their places.
constexpr std::size_t impulse_sum = 0;  ///< three components
constexpr std::size_t moment_sum = 3;   ///< likewise
constexpr std::size_t size_sum = 6;     ///< of the growth in the norm of the body's mobility
constexpr std::size_t push_sum = 7;     ///< growth along the normals
constexpr std::size_t gain_sum = 8;     ///< this times the missing rates
constexpr std::size_t group_sum = 9;    ///< `size_sum` of each group of the body's rows (enforcement/carried.hpp)
constexpr std::size_t body_width = group_sum + body_groups;

struct Bounds {
  double growth = 0, moment = 0, size = 0, push = 0, gain = 0;  ///< of one row
};

/// Whether nothing but rigid bodies can yield along the normal.
bool is_stiff(const System& system, std::size_t q) {
  const RowMatrix& rows = system.rows;
  const RowLaw& law = rows.laws[q];
  if (law.cone != Cone::compression || law.across == Across::holds) return false;
  for (std::size_t k = rows.begin(q); k < rows.end(q); ++k) {
    const Mobility& node = system.mobility[rows.point(k)];
    if (rows.weights[k] != 0 && node.inverse_mass > 0 && node.is_free_along(law.normal)) return false;
  }
  return true;
}

/// Rate that the row still misses, beyond rounding. What a compliant row recovers of its own depth under load is not
/// required.
double missing_of(const Solved& solved, std::size_t q, const Vec3& start) {
  const RowMatrix& rows = solved.system.rows;
  const RowLaw& law = rows.laws[q];
  const double kept =
      law.softness > 0 ? rows.figures[q].gap_share * solved.scratch.compliance[q] * law.normal.dot(start) : 0.0;
  return law.required - kept - law.noise - law.normal.dot(relative_velocity(rows, q, solved.velocity));
}

/// Of an island the missing rates count as a whole: the compliance of a chain's rows differs, and where it is small
/// little is missing, but the growth is the same.
Bounds measure_growth(const Solved& solved, Unmet& unmet) {
  const RowMatrix& rows = solved.system.rows;
  unmet.growth.assign(rows.size(), Vec3::Zero());
  unmet.gain.assign(rows.size(), 0);
  Bounds bounds;
  for (std::size_t q = 0; q < rows.size(); ++q) {
    if (rows.bodies_of(q).empty() || !is_stiff(solved.system, q)) continue;
    const Vec3 growth = solved.impulses[q] - unmet.start[q];
    const double push = rows.laws[q].normal.dot(growth);
    if (!(push > 0)) continue;
    unmet.growth[q] = growth;
    unmet.gain[q] = push * missing_of(solved, q, unmet.start[q]);
    const double size = growth.norm();
    bounds.growth = std::max(bounds.growth, rows.laws[q].share * size);
    bounds.push = std::max(bounds.push, push);
    bounds.gain = std::max(bounds.gain, std::abs(unmet.gain[q]));
    for (const BodyShare& share : rows.bodies_of(q)) bounds.size = std::max(bounds.size, share.along * size);
  }
  return bounds;
}

/// The unit of each of a body's sums.
std::array<FixedUnit, body_width> units_of(const Bounds& bounds) {
  static_assert(body_groups == 8, "a unit for each group");
  const FixedUnit force(bounds.growth), moment(bounds.moment), size(bounds.size), push(bounds.push), gain(bounds.gain);
  return {force, force, force, moment, moment, moment, size, push, gain,
          size,  size,  size,  size,   size,   size,   size, size};
}

/// Whether a body's rows with the same partner as this one have a part in its growth. A single row has little of it
/// where many nodes meet.
bool takes_part(const Unmet& unmet, const BodyShare& share) {
  const std::int64_t* sums = &unmet.sums[body_width * static_cast<std::size_t>(share.body)];
  return share.along > 0 && static_cast<double>(sums[group_sum + static_cast<std::size_t>(share.group)]) >
                                unmet_numbers.balanced * static_cast<double>(sums[size_sum]);
}

/// Sums over the growing rows on each body. Collective.
void sum_on_bodies(const Solved& solved, const Bounds& bounds, Exchange& exchange, Unmet& unmet) {
  const RowMatrix& rows = solved.system.rows;
  const Carriers& carriers = solved.system.carriers;
  const std::array<FixedUnit, body_width> units = units_of(bounds);
  unmet.sums.assign(body_width * carriers.bodies.size(), 0);
  for (std::size_t q = 0; q < rows.size(); ++q) {
    const Vec3& growth = unmet.growth[q];
    if (growth.isZero(0)) continue;
    for (const BodyShare& share : rows.bodies_of(q)) {
      if (share.along == 0) continue;
      std::int64_t* sums = &unmet.sums[body_width * static_cast<std::size_t>(share.body)];
      const std::int64_t own = units[size_sum].of(share.along * growth.norm());
      sums[size_sum] += own;
      sums[group_sum + static_cast<std::size_t>(share.group)] += own;
      sums[push_sum] += units[push_sum].of(rows.laws[q].normal.dot(growth));
      sums[gain_sum] += units[gain_sum].of(unmet.gain[q]);
    }
    for (std::size_t k = rows.begin(q); k < rows.end(q); ++k) {
      const LocalIndex place = solved.scratch.carried.place[rows.point(k)];
      if (place == no_index) continue;
      const auto body = static_cast<std::size_t>(nth(carriers.points, place).body);
      const Vec3 impulse = impulse_on_point(rows, q, k, growth);
      const Vec3 arm = solved.system.motion[rows.point(k)].position - carriers.bodies[body].centre;
      const Vec3 moment = arm.cross(impulse);
      std::int64_t* sums = &unmet.sums[body_width * body];
      for (std::size_t c = 0; c < 3; ++c) {
        sums[impulse_sum + c] += units[impulse_sum + c].of(impulse[static_cast<int>(c)]);
        sums[moment_sum + c] += units[moment_sum + c].of(moment[static_cast<int>(c)]);
      }
    }
  }
  exchange.sum(unmet.sums);
}

/// Joins bodies whose rows with each other have a part in the growth on both of them. Collective.
void join_islands(const RowMatrix& rows, Exchange& exchange, Unmet& unmet) {
  const auto island_of = [&](const BodyShare& share) -> double& { return nth(unmet.island, share.body); };
  for (std::size_t b = 0; b < unmet.island.size(); ++b) unmet.island[b] = -static_cast<double>(b);
  do {
    unmet.other.assign(unmet.island.begin(), unmet.island.end());
    for (bool joined = true; joined;) {
      joined = false;
      for (std::size_t q = 0; q < rows.size(); ++q) {
        const std::span<const BodyShare> bodies = rows.bodies_of(q);
        if (unmet.growth[q].isZero(0) || bodies.size() < 2) continue;
        if (!takes_part(unmet, bodies[0]) || !takes_part(unmet, bodies[1])) continue;
        double &one = island_of(bodies[0]), &two = island_of(bodies[1]);
        joined = joined || one != two;
        one = two = std::max(one, two);
      }
    }
    exchange.max(unmet.island);
  } while (unmet.island != unmet.other);
}

/// Whether the growth moves a body.
bool moves(const Carrier& body, const std::int64_t* sums, const std::array<FixedUnit, body_width>& units) {
  Vec6 sum;
  for (std::size_t c = 0; c < 6; ++c) sum[static_cast<int>(c)] = units[c].value(sums[c]);
  const double moved = std::sqrt(std::max(0.0, sum.dot(body.mobility * sum)));
  return moved > unmet_numbers.balanced * units[size_sum].value(sums[size_sum]);
}

/// Whether the growth moves no body of each island, and the mean of the missing rates, weighted by it, exceeds `least`.
void judge_islands(Unmet& unmet, const Carriers& carriers, const Bounds& bounds, double least) {
  const std::array<FixedUnit, body_width> units = units_of(bounds);
  const std::size_t bodies = carriers.bodies.size();
  const auto island_of = [&](std::size_t b) { return static_cast<std::size_t>(-unmet.island[b]); };
  unmet.balanced.assign(bodies, 1);
  unmet.other.assign(bodies, 0.0);  // what an island's gain exceeds the least one by
  for (std::size_t b = 0; b < bodies; ++b) {
    const std::int64_t* sums = &unmet.sums[body_width * b];
    if (moves(carriers.bodies[b], sums, units)) unmet.balanced[island_of(b)] = 0;
    unmet.other[island_of(b)] += units[gain_sum].value(sums[gain_sum]) - least * units[push_sum].value(sums[push_sum]);
  }
  for (std::size_t i = 0; i < bodies; ++i)
    if (!(unmet.other[i] > 0)) unmet.balanced[i] = 0;
  for (std::size_t b = 0; b < bodies; ++b)
    unmet.any = unmet.any || (unmet.sums[body_width * b + size_sum] > 0 && unmet.balanced[island_of(b)] != 0);
}

/// Rows between rigid bodies that are deeper than a ledge. A share of the depth in a step is a speed without a bound as
/// steps become short, and where the row has a short lever about a pivot, its body turns many times faster still.
bool is_too_deep_to_recover(const Contact& contact, const Row& row, const Carriers& carriers) {
  const DetectionSettings& settings = contact.derived.detection;
  if (settings.recovery_gives || -row.gap <= settings.tolerances->ledge * settings.wall_size) return false;
  return std::ranges::all_of(row.points(), [&](LocalIndex node) {
    return carriers.of(node) != nullptr || nth(contact.step.nodes.mobility, node).inverse_mass == 0;
  });
}

}  // namespace

void Unmet::reserve(std::size_t most_rows, std::size_t bodies) {
  start.reserve(most_rows);
  growth.reserve(most_rows);
  gain.reserve(most_rows);
  rows.reserve(most_rows);
  held.reserve(most_rows);
  jammed.reserve(most_rows);
  sums.reserve(body_width * bodies);
  island.resize(bodies);
  other.reserve(bodies);
  balanced.reserve(bodies);
}

void hold_unmet_rows(Contact& contact, const StepInput& input) {
  std::vector<Row>& rows = contact.step.rows;
  std::vector<char>& held = contact.unmet.held;
  held.assign(rows.size(), 0);
  for_each_unmet(rows, contact.history.pairs,
                 [&](std::size_t q) { held[q] = rows[q].gap < 0 && rows[q].cone == Cone::compression; });
  const Carriers carriers = carriers_of(contact, input);
  for (std::size_t q = 0; q < rows.size(); ++q) {
    Row& row = rows[q];
    if (row.gap >= 0 || row.cone != Cone::compression) continue;
    if (held[q] == 0 && !is_too_deep_to_recover(contact, row, carriers)) continue;
    const double rate = row.is_wall() ? row.normal.dot(nth(input.walls, row.key.master).velocity) : 0.0;
    row.required = std::min(row.required, rate);
  }
}

void find_unmet_rows(const Solved& solved, double least, Exchange& exchange, Unmet& unmet) {
  const Carriers& carriers = solved.system.carriers;
  const RowMatrix& rows = solved.system.rows;
  unmet.rows.clear();
  unmet.any = false;
  Bounds bounds = measure_growth(solved, unmet);
  std::array<double, 4> largest{bounds.growth, bounds.size, bounds.push, bounds.gain};
  exchange.max(largest);
  if (!(largest[1] > 0)) return;
  bounds = {largest[0], largest[0] * solved.scratch.carried.longest_arm, largest[1], largest[2], largest[3]};
  sum_on_bodies(solved, bounds, exchange, unmet);
  join_islands(rows, exchange, unmet);
  judge_islands(unmet, carriers, bounds, least);
  unmet.rows.assign(rows.size(), 0);
  for (std::size_t q = 0; q < rows.size(); ++q) {
    if (unmet.growth[q].isZero(0)) continue;
    unmet.rows[q] = std::ranges::all_of(rows.bodies_of(q), [&](const BodyShare& share) {
      const auto island = static_cast<std::size_t>(-nth(unmet.island, share.body));
      return share.along == 0 || (unmet.balanced[island] != 0 && takes_part(unmet, share));
    });
  }
}

void keep_met_impulses(Contact& contact) {
  Unmet& unmet = contact.unmet;
  const std::vector<Vec3>& impulses = contact.step.impulses;
  for (std::size_t q = 0; q < impulses.size(); ++q)
    if (unmet.is(q))
      unmet.held[q] = 1;
    else
      unmet.start[q] = impulses[q];
}

}  // namespace brunt::contact
