// SPDX-License-Identifier: Apache-2.0
// Rigid bodies whose points and rows lie on all ranks: the bits of one rank.
#include "contact/enforcement/carried.hpp"

#include <catch2/catch.hpp>

#include "contact/lists/halo_exchange.hpp"
#include "unit/contact/enforcement/random_rows.hpp"

using namespace brunt;
using namespace brunt::contact;

namespace {

/// A heavy box on the floor (on many points) and on deformable nodes, a spinning one on it, and one that nothing meets.
BoxProblem three_boxes(int n, double friction) {
  BoxProblem p;
  p.add_box({.centre = {0, 0, 0.5}, .mass = 5, .velocity = {0.1, 0, -1}, .spin = {0.02, -0.03, 0.01}});
  p.add_box({.centre = {0, 0, 1.5}, .mass = 0.5, .velocity = {0, -0.2, -2}, .spin = {0.1, 0.2, 0.3}});
  p.add_box({.centre = {9, 0, 9}, .velocity = {0, 0, -1}});
  p.rest_on_floor(0, n);
  p.rest_on_box(1, 0, 5);
  for (const LocalIndex point : p.add_side(0, 6, -1)) {
    const LocalIndex node = p.add_node(0.05, {0, 0, 0.1});
    p.add_row({{node, 1}, {point, -1}}, -Vec3::UnitZ());
  }
  for (Row& row : p.rows) row.friction = friction;
  return p;
}

/// Every rank has all nodes and owns some of them.
NodeLinks links_of_all(const comm::Communicator& ranks, LocalIndex nodes) {
  NodeLinks links;
  for (LocalIndex node = 0; node < nodes; ++node) {
    const Rank owner = node % ranks.size();
    if (owner != ranks.rank()) {
      links.copies.push_back(node);
      links.source.push_back({owner, node});
      continue;
    }
    for (Rank other = 0; other < ranks.size(); ++other) {
      if (other == owner) continue;
      links.copied.push_back(node);
      links.destination.push_back({other, node});
    }
  }
  return links;
}

/// Of the rows of all ranks those of this one, in pieces that leave one of four ranks without any.
template <class Of>
std::vector<Of> own_of(const comm::Communicator& ranks, const std::vector<Of>& of_rows) {
  const Rank working = ranks.size() == 4 ? 3 : ranks.size();
  std::vector<Of> own;
  for (std::size_t q = 0; q < of_rows.size(); ++q)
    if (static_cast<Rank>(q / 7) % working == ranks.rank()) own.push_back(of_rows[q]);
  return own;
}

/// The impulses that random rows start from.
std::vector<Vec3> alone_start(unsigned seed, int clusters = 3) {
  return RandomRows(seed, clusters).impulses;
}

void keep_own_rows(const comm::Communicator& ranks, BoxProblem& p) {
  p.rows = own_of(ranks, p.rows);
  for (CarriedPoint& point : p.points) point.owned = point.point % ranks.size() == ranks.rank();
}

}  // namespace

TEST_CASE("bodies over all ranks: iterations, velocities and answers have the bits of one rank") {
  const double friction = GENERATE(0.0, 0.3);
  const int n = GENERATE(4, 140);  // more than 2^14 points
  const EnforcementSettings settings{.max_iterations = n > 100 ? 20 : 200};
  BoxProblem alone = three_boxes(n, friction), shared = alone;
  const EnforcementResult one = alone.solve_boxes(settings);

  const comm::Communicator ranks = comm::Communicator::world();
  const auto nodes = static_cast<LocalIndex>(shared.motion.size());
  HaloExchange exchange(ranks, nodes, links_of_all(ranks, nodes), impulse_width + row_sum_width);
  keep_own_rows(ranks, shared);
  const EnforcementResult all = shared.solve_boxes(settings, exchange);
  CHECK(one.acted);
  CHECK(all.iterations == one.iterations);
  CHECK(all.residual == one.residual);
  CHECK(shared.velocity == alone.velocity);
  for (const LocalIndex body : {0, 1, 2}) {
    CHECK(shared.answer(body).impulse == alone.answer(body).impulse);
    CHECK(shared.answer(body).change == alone.answer(body).change);
  }
  CHECK(alone.answer(2).impulse.isZero(0));
}

TEST_CASE("the guard of a cut iteration: islands, shares and velocities have the bits of one rank") {
  const auto seed = GENERATE(range(1u, 11u));
  const int iterations = GENERATE(1, 5);
  const EnforcementSettings settings{.tolerance = 1e-12, .max_iterations = iterations};
  RandomRows alone(seed, 3), shared = alone;
  const EnforcementResult one = alone.solve_boxes(settings);

  const comm::Communicator ranks = comm::Communicator::world();
  const auto nodes = static_cast<LocalIndex>(shared.motion.size());
  HaloExchange exchange(ranks, nodes, links_of_all(ranks, nodes), impulse_width + row_sum_width);
  keep_own_rows(ranks, shared);
  shared.impulses = own_of(ranks, alone_start(seed));
  const EnforcementResult all = shared.solve_boxes(settings, exchange);
  CAPTURE(seed, iterations, one.scaled_islands);
  CHECK(all.scaled_islands == one.scaled_islands);
  CHECK(all.least_share == one.least_share);
  CHECK(shared.velocity == alone.velocity);
  CHECK(shared.impulses == own_of(ranks, alone.impulses));
}

TEST_CASE("chains of bodies over all ranks: compliances have the bits of one rank") {
  const auto seed = GENERATE(range(1u, 6u));
  RandomRows alone(seed, 2), shared = alone;
  for (RandomRows* rows : {&alone, &shared})
    for (Row& row : rows->rows)
      if (row.cone == Cone::compression) row.softness = 0.05;
  const EnforcementSettings settings{.max_iterations = 30};
  alone.solve_boxes(settings);

  const comm::Communicator ranks = comm::Communicator::world();
  const auto nodes = static_cast<LocalIndex>(shared.motion.size());
  HaloExchange exchange(ranks, nodes, links_of_all(ranks, nodes), impulse_width + row_sum_width);
  keep_own_rows(ranks, shared);
  shared.impulses = own_of(ranks, alone_start(seed, 2));
  shared.solve_boxes(settings, exchange);
  CHECK(shared.scratch.compliance == own_of(ranks, alone.scratch.compliance));
  CHECK(shared.velocity == alone.velocity);
}
