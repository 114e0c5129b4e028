// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/carried.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contact/enforcement/system.hpp"
#include "core/binned_sum.hpp"
#include "core/cross_matrix.hpp"
#include "core/error.hpp"
#include "impulse_grid.hpp"

namespace brunt::contact {
namespace {

/// Numbers of a body's sum: impulse and moment, coarse and fine.
constexpr std::size_t sums_of_answer = 12;
/// Coarse and fine of each group's sum, and the number of terms of all.
constexpr std::size_t sums_of_weights = 2 * body_groups + 1;
/// A chunk of 2^14 terms on the coarse grid is a whole number below 2^52: a thousand of them fit in 63 bits.
constexpr std::int64_t most_terms = std::int64_t{1} << 24;

/// log2 of what slices on the grid of this anchor are multiples of.
int unit_of(double anchor) {
  return anchor > 0 ? std::ilogb(anchor) - 52 : 0;
}

std::int64_t in_units(double slice, int unit) {
  return static_cast<std::int64_t>(std::ldexp(slice, -unit));
}

double value_of(std::int64_t coarse, std::int64_t fine, const BinGrid& grid) {
  return std::ldexp(static_cast<double>(coarse), unit_of(grid.anchor[0])) +
         std::ldexp(static_cast<double>(fine), unit_of(grid.anchor[1]));
}

Vec3 arm_of(const CarriedPoint& point, const Carriers& carriers, std::span<const NodeMotion> motion) {
  return nth(motion, point.point).position - nth(carriers.bodies, point.body).centre;
}

/// Blocks of row q on bodies, in the order of its points. Does it have no others?
bool find_blocks(const Carriers& carriers, std::span<const NodeMotion> motion, const RowMatrix& rows, std::size_t q,
                 CarriedScratch& scratch) {
  scratch.blocks.clear();
  bool all_carried = true;
  for (std::size_t k = rows.begin(q); k < rows.end(q); ++k) {
    const LocalIndex place = scratch.place[rows.point(k)];
    if (place == no_index) {
      all_carried = false;
      continue;
    }
    const CarriedPoint& point = nth(carriers.points, place);
    auto block = std::ranges::find(scratch.blocks, point.body, &RowBlock::body);
    if (block == scratch.blocks.end()) block = scratch.blocks.insert(block, {.body = point.body});
    Mat3 part = rows.weights[k] * Mat3::Identity();
    if (rows.laws[q].turns) part += rows.arm(q, k).turn;
    if (rows.laws[q].tilts) part += rows.tilt(q, k) * rows.laws[q].normal.transpose();
    block->translation += part;
    block->rotation -= part * cross_matrix(arm_of(point, carriers, motion));
  }
  return all_carried;
}

/// What the rest of a row's points belong to: see the header.
LocalIndex group_of(const RowBlock& block, std::span<const RowBlock> blocks, bool all_carried) {
  constexpr LocalIndex with_nodes = 0, with_nothing = 1, with_bodies = 2;
  constexpr auto groups_of_bodies = static_cast<LocalIndex>(body_groups) - with_bodies;
  const auto other = std::ranges::find_if(blocks, [&](const RowBlock& one) { return one.body != block.body; });
  if (other != blocks.end()) return with_bodies + other->body % groups_of_bodies;
  return all_carried ? with_nothing : with_nodes;
}

/// Weights of a block; zero along what nothing can change (what rounding leaves of it is nothing, as elsewhere).
BodyShare share_of(const RowBlock& block, const Mat6& mobility, const RowLaw& law) {
  constexpr double nothing = Mobility::rounding * Mobility::rounding;
  constexpr double above = 1 + 1e-6;  // the closed form of eigenvalues errs by less
  Eigen::Matrix<double, 3, 6> g;
  g << block.translation, block.rotation;
  const Mat3 answer = g * mobility * g.transpose();
  const double scale = block.translation.squaredNorm() * mobility.topLeftCorner<3, 3>().trace() +
                       block.rotation.squaredNorm() * mobility.bottomRightCorner<3, 3>().trace();
  const auto root_of = [&](double square) { return square > nothing * scale ? std::sqrt(square) : 0.0; };
  BodyShare share{.body = block.body, .along = root_of(law.normal.dot(answer * law.normal))};
  share.weight = share.along;
  if (law.across == Across::slips) return share;
  Eigen::SelfAdjointEigenSolver<Mat3> solver;
  solver.computeDirect(answer, Eigen::EigenvaluesOnly);
  share.weight = root_of(above * solver.eigenvalues()[2]);
  return share;
}

/// Takes the terms of a body's impulse to its whole numbers.
void flush(const BinGrid& impulse, const BinGrid& moment, BodyParts& parts, std::int64_t* sums) {
  const std::array<int, 4> units{unit_of(impulse.anchor[0]), unit_of(impulse.anchor[1]), unit_of(moment.anchor[0]),
                                 unit_of(moment.anchor[1])};
  for (std::size_t k = 0; k < sums_of_answer; ++k) sums[k] += in_units(parts.slices[4 * (k / 3) + k % 3], units[k / 3]);
  parts = {};
}

void flush_weights(const BinGrid& grid, BodyParts& parts, std::int64_t* sums) {
  const std::array<int, bin_slices> units{unit_of(grid.anchor[0]), unit_of(grid.anchor[1])};
  for (std::size_t k = 0; k < bin_slices * body_groups; ++k)
    sums[k] += in_units(parts.slices[k], units[k % bin_slices]);
  sums[bin_slices * body_groups] += parts.terms;
  parts = {};
}

/// S / theta of each group of a body, from its sums. Returns how many times the least of them all weights are.
double divide_among_groups(const BinGrid& grid, const std::int64_t* sums, std::span<double> row_sum) {
  double all = 0, groups = 0;
  for (std::size_t g = 0; g < body_groups; ++g) {
    row_sum[g] = value_of(sums[bin_slices * g], sums[bin_slices * g + 1], grid);
    all += row_sum[g];
    groups += row_sum[g] > 0 ? 1 : 0;
  }
  if (groups < 2) return 1;
  double spread = 1;
  for (double& sum : row_sum) {
    if (sum == 0) continue;
    sum /= 0.5 * (1 / groups + sum / all);
    spread = std::max(spread, all / sum);
  }
  return spread;
}

/// W P of bodies that joints connect.
void answer_together(const CoupledBodies& group, std::span<BodyAnswer> answers) {
  const auto width = static_cast<Eigen::Index>(6 * group.bodies.size());
  Eigen::VectorXd impulse(width);
  const auto part = [](Eigen::VectorXd& of_all, std::size_t k) {
    return of_all.segment<6>(static_cast<Eigen::Index>(6 * k));
  };
  const auto answer = [&](std::size_t k) -> BodyAnswer& { return nth(answers, group.bodies[k]); };
  for (std::size_t k = 0; k < group.bodies.size(); ++k) part(impulse, k) = answer(k).impulse;
  Eigen::VectorXd change = group.mobility * impulse;
  for (std::size_t k = 0; k < group.bodies.size(); ++k) answer(k).change = part(change, k);
}

}  // namespace

void CarriedScratch::reserve(std::size_t rows, std::size_t nodes, std::size_t bodies) {
  constexpr std::size_t bounds = 4;
  place.reserve(nodes);
  blocks.reserve(most_bodies_of_a_row);
  largest.reserve(2 * bodies + bounds);
  active.reserve(bodies);
  slot.reserve(bodies);
  parts.reserve(bodies);
  sums.reserve(std::max(sums_of_answer, sums_of_weights) * bodies);
  share.reserve(most_bodies_of_a_row * rows);
  row_sum.reserve(body_groups * bodies);
  answer.reserve(bodies);
  chains.reserve(rows, bodies);
}

void lay_rows_on_bodies(const Carriers& carriers, std::span<const NodeMotion> motion, CarriedScratch& scratch,
                        RowMatrix& rows) {
  if (carriers.bodies.empty()) return;
  scratch.place.assign(motion.size(), no_index);
  for (std::size_t i = 0; i < carriers.points.size(); ++i)
    nth(scratch.place, carriers.points[i].point) = static_cast<LocalIndex>(i);
  rows.on_bodies.clear();
  for (std::size_t q = 0; q < rows.size(); ++q) {
    const bool all_carried = find_blocks(carriers, motion, rows, q, scratch);
    for (const RowBlock& block : scratch.blocks) {
      BodyShare share = share_of(block, carriers.alone(block.body), rows.laws[q]);
      share.group = group_of(block, scratch.blocks, all_carried);
      rows.on_bodies.values.push_back(share);  // also where it is nothing: a held body is told its impulse
    }
    rows.on_bodies.close_row();
  }
}

void start_bodies(const Carriers& carriers, std::span<const NodeMotion> motion, const RowMatrix& rows,
                  Exchange& exchange, CarriedScratch& scratch) {
  const std::size_t bodies = carriers.bodies.size();
  ChainScratch& chains = scratch.chains;
  scratch.largest.assign(2 * bodies + 4, 0.0);  // does a row act on the body, its answer, bounds
  const std::span<double> answers = std::span(scratch.largest).subspan(bodies, bodies),
                          bounds = std::span(scratch.largest).last(4);
  for (const BodyShare& share : rows.on_bodies.values) {
    nth(scratch.largest, share.body) = 1;
    keep_max(bounds[0], share.weight);
  }
  // of points that rows act on: which others the lists hold is a matter of when they were made
  if (bodies > 0)
    for (const LocalIndex point : rows.points)
      if (const LocalIndex place = nth(scratch.place, point); place != no_index)
        keep_max(bounds[1], arm_of(nth(carriers.points, place), carriers, motion).norm());
  std::ranges::copy(chains.answer, answers.begin());
  bounds[2] = chains.own_pairs.empty() ? 0 : 1;
  bounds[3] = chains.renewed ? 1 : 0;
  exchange.max(scratch.largest);
  scratch.largest_weight = bounds[0];
  scratch.longest_arm = bounds[1];
  std::ranges::copy(answers.first(chains.answer.size()), chains.answer.begin());
  scratch.any_soft = bounds[2] > 0;
  chains.renewed = bounds[3] > 0;
  for (const CoupledBodies& group : carriers.coupled) {
    const auto acts = [&](LocalIndex body) { return nth(scratch.largest, body) > 0; };
    if (std::ranges::any_of(group.bodies, acts))
      for (const LocalIndex body : group.bodies) nth(scratch.largest, body) = 1;
  }
  scratch.active.clear();
  scratch.slot.assign(bodies, 0);
  for (std::size_t b = 0; b < bodies; ++b) {
    scratch.slot[b] = static_cast<LocalIndex>(scratch.active.size());
    if (scratch.largest[b] > 0) scratch.active.push_back(static_cast<LocalIndex>(b));
  }
  scratch.parts.assign(bodies, {});
  scratch.row_sum.assign(body_groups * bodies, 0.0);
  scratch.answer.assign(bodies, {});
}

void sum_rows_on_bodies(const RowMatrix& rows, Exchange& exchange, CarriedScratch& scratch) {
  const BinGrid grid = BinGrid::for_bound(scratch.largest_weight);
  scratch.sums.assign(sums_of_weights * scratch.active.size(), 0);
  const auto sums_of = [&](std::size_t body) {
    return &scratch.sums[sums_of_weights * static_cast<std::size_t>(scratch.slot[body])];
  };
  for (std::size_t i = 0; i < scratch.share.size(); ++i) {
    if (scratch.share[i] == 0) continue;
    const BodyShare& share = rows.on_bodies.values[i];
    const auto body = static_cast<std::size_t>(share.body);
    BodyParts& parts = scratch.parts[body];
    binned_add(grid, scratch.share[i], &parts.slices[bin_slices * static_cast<std::size_t>(share.group)]);
    if (++parts.terms == binned_terms) flush_weights(grid, parts, sums_of(body));
  }
  for (const LocalIndex body : scratch.active) {
    const auto b = static_cast<std::size_t>(body);
    flush_weights(grid, scratch.parts[b], sums_of(b));
  }
  exchange.sum(scratch.sums);
  scratch.spread = 1;
  for (const LocalIndex body : scratch.active) {
    const auto b = static_cast<std::size_t>(body);
    const std::int64_t* sums = sums_of(b);
    demand(sums[bin_slices * body_groups] <= most_terms / static_cast<std::int64_t>(most_nodes_of_a_row),
           "the sums of a rigid body have room for all its rows");
    const double spread =
        divide_among_groups(grid, sums, std::span(scratch.row_sum).subspan(body_groups * b, body_groups));
    scratch.spread = std::max(scratch.spread, spread);
  }
}

void add_answer_of_bodies(const Carriers& carriers, std::span<const NodeMotion> motion,
                          std::span<const double> impulse_parts, double largest, Exchange& exchange,
                          std::span<Vec3> velocity, CarriedScratch& scratch) {
  // of a point that has as many rows as its own sum may have
  const BinGrid bins = BinGrid::for_bound(largest * binned_terms),
                moment_bins = BinGrid::for_bound(largest * binned_terms * scratch.longest_arm);
  const ImpulseGrid grid(bins), moment_grid(moment_bins);
  scratch.sums.assign(sums_of_answer * scratch.active.size(), 0);
  const auto sums_of = [&](std::size_t body) {
    return &scratch.sums[sums_of_answer * static_cast<std::size_t>(scratch.slot[body])];
  };
  for (const CarriedPoint& point : carriers.points) {
    if (!point.owned) continue;
    const Vec3 impulse = sum_of_parts(impulse_parts, static_cast<std::size_t>(point.point));
    if (impulse.isZero(0)) continue;
    const auto body = static_cast<std::size_t>(point.body);
    BodyParts& parts = scratch.parts[body];
    grid.add(impulse, parts.slices.data());
    moment_grid.add(arm_of(point, carriers, motion).cross(impulse), &parts.slices[8]);
    if (++parts.terms == binned_terms) flush(bins, moment_bins, parts, sums_of(body));
  }
  for (const LocalIndex body : scratch.active) {
    const auto b = static_cast<std::size_t>(body);
    flush(bins, moment_bins, scratch.parts[b], sums_of(b));
  }
  exchange.sum(scratch.sums);
  for (const LocalIndex body : scratch.active) {
    const auto b = static_cast<std::size_t>(body);
    const std::int64_t* sums = sums_of(b);
    BodyAnswer& answer = scratch.answer[b];
    for (int k = 0; k < 3; ++k) {
      answer.impulse[k] = value_of(sums[k], sums[3 + k], bins);
      answer.impulse[3 + k] = value_of(sums[6 + k], sums[9 + k], moment_bins);
    }
    answer.change = carriers.bodies[b].mobility * answer.impulse;
  }
  for (const CoupledBodies& group : carriers.coupled)
    if (nth(scratch.largest, group.bodies.front()) > 0) answer_together(group, scratch.answer);
  for (const CarriedPoint& point : carriers.points) {
    const Vec6& change = nth(scratch.answer, point.body).change;
    nth(velocity, point.point) += change.head<3>() + change.tail<3>().cross(arm_of(point, carriers, motion));
  }
}

}  // namespace brunt::contact
