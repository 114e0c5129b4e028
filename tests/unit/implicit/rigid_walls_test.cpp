// SPDX-License-Identifier: Apache-2.0
#include "implicit/walls/rigid_walls.hpp"

#include <catch2/catch.hpp>

using namespace brunt;
using namespace brunt::implicit;

namespace {

/// Three nodes; the last belongs to the second part.
struct Nodes {
  model::Model model;
  model::State state;
  Unknowns unknowns;

  Nodes() {
    const double at[3][3] = {{0, 0, 0}, {0, 0, 1}, {2, 0, 0}};
    for (LocalIndex i = 0; i < 3; ++i) {
      const double* x = at[i];
      model.reference.push_back(Quad{x[0], x[1], x[2], 0});
      state.displacement.push_back(Quad{0, 0, 0, 0});
      state.nodes.emplace_back();
      unknowns.node.push_back(i);
    }
    model.mesh.node_gid = {0, 1, 2};
    model.blocks.resize(2);
    model.blocks[0].node = {0, 1};
    model.blocks[1].node = {2};
  }
  void add_wall(const Vec3& point, const Vec3& normal, std::vector<std::int32_t> blocks = {}, bool bilateral = false) {
    model.touching.walls.push_back({{"w", point, normal, bilateral, {}}, {}, false, std::move(blocks)});
    state.wall_position.push_back(0);
  }
};

}  // namespace

TEST_CASE("walls act on nodes of their parts; what touches at t_n is pressed at first", "[oracle]") {
  Nodes nodes;
  nodes.add_wall({0, 0, 0}, {0, 0, 1});
  nodes.add_wall({3, 0, 0}, {-1, 0, 0}, {1}, true);
  nodes.add_wall({2, 0, 0}, {-1, 0, 0}, {1}, true);
  WallContact walls = make_walls(nodes.model, nodes.unknowns, 1.0);
  begin_walls(nodes.model, nodes.state, nodes.unknowns, 0, 1, walls);
  REQUIRE(walls.nodes.size() == 3);
  CHECK(walls.nodes[0].count == 1);
  CHECK(walls.nodes[2].count == 3);
  CHECK(walls.nodes[0].solved.active[0]);
  CHECK_FALSE(walls.nodes[1].solved.active[0]);
  CHECK(walls.nodes[2].solved.active[0]);
  CHECK_FALSE(walls.nodes[2].solved.active[1]);
  CHECK(walls.nodes[2].solved.active[2]);
  CHECK(walls.holds == std::vector<std::uint8_t>{0, 0, 0, 0, 1});

  const Vec3 left(0, 0, 5);  // the node needs a push of 5
  WallQuestion question;
  question.left = left;
  question.stiffness = 1;
  const WallAction* action = meet_walls(nodes.model, Vec3::Zero(), 0, question, walls);
  REQUIRE(action != nullptr);
  CHECK(action->pressure[0] == 5);
  CHECK(forces_of(nodes.model, walls, 0).normal == Vec3(0, 0, 5));
}

TEST_CASE("a wall in motion is at its place at the end of the step", "[oracle]") {
  Nodes nodes;
  nodes.add_wall({0, 0, -1}, {0, 0, 1});
  nodes.model.touching.walls[0].moves = true;
  nodes.model.touching.walls[0].motion = {{0, 0}, {2, 4}};  // velocity 2 t
  nodes.state.wall_position[0] = 0.25;
  WallContact walls = make_walls(nodes.model, nodes.unknowns, 1.0);
  begin_walls(nodes.model, nodes.state, nodes.unknowns, 0.5, 1.0, walls);
  CHECK(walls.place[0] == Approx(-1 + 0.25 + 0.75).epsilon(1e-14));
}

TEST_CASE("of many walls the three nearest are looked at", "[oracle]") {
  Nodes nodes;
  for (int w = 0; w < 6; ++w) nodes.add_wall({0, 0, -1.0 * ((w * 5) % 6)}, {0, 0, 1});
  WallContact walls = make_walls(nodes.model, nodes.unknowns, 1.0);
  begin_walls(nodes.model, nodes.state, nodes.unknowns, 0, 1, walls);
  CHECK(walls.nodes[0].looked_at == 3);
  for (const std::int32_t kept : walls.nodes[0].kept)
    CHECK(nodes.model.touching.walls[static_cast<std::size_t>(walls.wall[static_cast<std::size_t>(kept)])].point[2] >=
          -2);
}
