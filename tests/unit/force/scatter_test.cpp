// SPDX-License-Identifier: Apache-2.0
// Forces of elements on nodes: the sum of corner forces in the order of the elements, to the bit, whatever batch an
// element is in and whatever else is in it.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <vector>

#include "support/element_block.hpp"

using namespace brunt;
using element::ElementKind;
using test::ElementBlockBench;

namespace {

Vec3 pose(const Vec3& X) {
  return {X[0] + 0.03 * X[1] * X[2], X[1] + 0.02 * X[0] * X[0] - 0.01 * X[2], 1.02 * X[2] - 0.01 * X[0] * X[1]};
}

AlignedVector<Quad> forces_of(ElementBlockBench& bench) {
  bench.place(pose, 0.25);
  force::History trial = bench.state.history;
  force::trial_forces(bench.model, bench.motion(true), bench.state.history, trial, bench.scratch);
  return bench.scratch.force;
}

/// The same nodes and only element e, in every lane of one batch.
ElementBlockBench alone(ElementKind kind, const material::Law& law, const std::array<int, 3>& cells, LocalIndex e) {
  ElementBlockBench bench(kind, law, cells);
  model::ElementBlock& block = bench.model.blocks[0];
  AlignedVector<LocalIndex> node;
  for (int c = 0; c < block.corners(); ++c)
    for (int lane = 0; lane < pack_width; ++lane) node.push_back(block.corner_node(e, c));
  block.node = node;
  block.count = 1;
  block.border = {};
  block.border.close_row();
  bench.state.history[0].assign(static_cast<std::size_t>(block.history_size * pack_width), 0);
  force::lump_mass(bench.model, bench.state, bench.scratch);
  return bench;
}

}  // namespace

TEST_CASE("scatter: the force on a node is the sum of its elements' corner forces in their order, to the bit") {
  const std::array<int, 3> cells{3, 2, 2};
  const material::Law law = material::Elastic{1, 100, 0.3};
  for (const ElementKind kind :
       {ElementKind::hex8, ElementKind::hex8_full, ElementKind::hex8_bbar, ElementKind::tet4}) {
    CAPTURE(element::name_of(kind));
    ElementBlockBench whole(kind, law, cells);
    const AlignedVector<Quad> together = forces_of(whole);
    AlignedVector<Quad> sum(together.size(), Quad{});
    for (LocalIndex e = 0; e < whole.block().count; ++e) {
      ElementBlockBench one = alone(kind, law, cells, e);
      const AlignedVector<Quad> own = forces_of(one);
      for (int c = 0; c < whole.block().corners(); ++c) {
        const auto node = static_cast<std::size_t>(whole.block().corner_node(e, c));
        sum[node] += own[node];
      }
    }
    CHECK(std::memcmp(sum.data(), together.data(), sum.size() * sizeof(Quad)) == 0);
    double largest = 0;
    for (const Quad& f : together) largest = std::max(largest, std::abs(f[0]));
    CHECK(largest > 0.01);
  }
}

TEST_CASE("scatter: internal forces have neither resultant nor moment, whatever the deformation") {
  for (const ElementKind kind :
       {ElementKind::hex8, ElementKind::hex8_full, ElementKind::hex8_bbar, ElementKind::tet4}) {
    CAPTURE(element::name_of(kind));
    ElementBlockBench bench(kind, material::Elastic{1, 100, 0.3}, {3, 2, 2});
    const AlignedVector<Quad> force = forces_of(bench);
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    double size = 0;
    for (std::size_t i = 0; i < force.size(); ++i) {
      const Vec3 f(force[i][0], force[i][1], force[i][2]);
      sum += f;
      moment += Eigen::Map<const Vec3>(bench.state.nodes[i].x).cross(f);
      size += f.norm();
    }
    CHECK(sum.norm() <= 1e-13 * size);
    CHECK(moment.norm() <= 1e-12 * size);
  }
}
