// SPDX-License-Identifier: Apache-2.0
#include "implicit/walls/rigid_walls.hpp"

#include <algorithm>
#include <array>

#include "comm/exact_sum.hpp"
#include "implicit/data/nodal.hpp"
#include "implicit/walls/wall_spring.hpp"
#include "model/curve.hpp"

namespace brunt::implicit {
namespace {

/// Nodes touch a wall if their gap is below this share of the mean distance of nodes: above the rounding of mesh files
/// in single precision.
constexpr double touching_share = 1e-6;

/// A flag for each node: whether the wall acts on it.
std::vector<char> acts_on_nodes(const model::Model& model, const model::RigidWall& wall) {
  std::vector<char> acts(static_cast<std::size_t>(model.nodes()), 0);
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    if (!wall.blocks.empty() && !std::ranges::binary_search(wall.blocks, static_cast<std::int32_t>(b))) continue;
    for (const LocalIndex node : model.blocks[b].node) nth(acts, node) = 1;
  }
  return acts;
}

double place_of(const model::RigidWall& wall, double position) {
  return wall.normal.dot(wall.point) + position;
}

/// The walls nearest to a node at t_n, as many as can be active.
void look_at_nearest(const model::Model& model, const WallContact& walls, const Vec3& x, WallNode& node) {
  std::vector<std::pair<double, std::int32_t>> by_gap;
  for (std::int32_t k = 0; k < node.count; ++k) {
    const std::int32_t entry = node.first + k;
    const auto w = static_cast<std::size_t>(nth(walls.wall, entry));
    by_gap.emplace_back(model.touching.walls[w].normal.dot(x) - walls.place[w], k);
  }
  std::ranges::sort(by_gap);
  node.looked_at = std::min(node.count, static_cast<std::int32_t>(WallChoice::most));
  for (std::int32_t k = 0; k < node.looked_at; ++k) node.kept[k] = node.first + nth(by_gap, k).second;
  std::sort(node.kept, node.kept + node.looked_at);
}

/// Of a node at x; bilateral walls excepted [length].
double depth_behind(const model::Model& model, const WallContact& walls, const WallNode& node, const Vec3& x) {
  double depth = 0;
  for (std::int32_t k = 0; k < node.looked_at; ++k) {
    const auto entry = static_cast<std::size_t>(node.kept[k]);
    const auto w = static_cast<std::size_t>(walls.wall[entry]);
    if (walls.holds[entry] == 0) depth = std::max(depth, walls.place[w] - model.touching.walls[w].normal.dot(x));
  }
  return depth;
}

/// The active set of the first iterate, from the state of t_n only, so that a restart finds the same.
WallChoice first_choice(const model::Model& model, const WallContact& walls, const WallNode& node, const Vec3& x) {
  WallChoice choice;
  for (std::int32_t k = 0; k < node.looked_at; ++k) {
    const auto w = static_cast<std::size_t>(nth(walls.wall, node.kept[k]));
    choice.active[k] = model.touching.walls[w].normal.dot(x) - walls.place[w] <= walls.touching;
  }
  return choice;
}

}  // namespace

WallContact make_walls(const model::Model& model, const Unknowns& unknowns, double spacing) {
  WallContact walls;
  if (model.touching.walls.empty()) return walls;
  walls.touching = touching_share * spacing;
  for (const model::RigidWall& wall : model.touching.walls) walls.place.push_back(place_of(wall, 0));
  walls.impulse.assign(3 * model.touching.walls.size(), 0.0);
  walls.force = walls.impulse;
  std::vector<std::vector<char>> acts;
  for (const model::RigidWall& wall : model.touching.walls) acts.push_back(acts_on_nodes(model, wall));
  walls.node_of.assign(unknowns.node.size(), no_index);
  for (std::size_t own = 0; own < unknowns.node.size(); ++own) {
    const auto i = static_cast<std::size_t>(unknowns.node[own]);
    WallNode node;
    node.own = own;
    node.first = static_cast<std::int32_t>(walls.wall.size());
    for (std::size_t w = 0; w < model.touching.walls.size(); ++w) {
      if (acts[w][i] == 0) continue;
      const double gap = model.touching.walls[w].normal.dot(of(model.reference[i])) - walls.place[w];
      walls.wall.push_back(static_cast<std::int32_t>(w));
      walls.holds.push_back(model.touching.walls[w].bilateral && std::abs(gap) <= walls.touching ? 1 : 0);
    }
    node.count = static_cast<std::int32_t>(walls.wall.size()) - node.first;
    if (node.count == 0) continue;
    walls.node_of[own] = static_cast<LocalIndex>(walls.nodes.size());
    walls.nodes.push_back(node);
  }
  return walls;
}

void begin_walls(const model::Model& model, const model::State& state, const Unknowns& unknowns, double time_before,
                 double time, WallContact& walls) {
  for (std::size_t w = 0; w < model.touching.walls.size(); ++w)
    walls.place[w] = place_of(model.touching.walls[w], state.wall_position[w]);
  walls.first = true;
  for (WallNode& node : walls.nodes) {
    const auto i = static_cast<std::size_t>(unknowns.node[node.own]);
    const Vec3 x = of(model.reference[i]) + of(state.displacement[i]);
    look_at_nearest(model, walls, x, node);
    node.solved = first_choice(model, walls, node, x);
    node.behind = node.behind_before = depth_behind(model, walls, node, x);
    node.action = {};
    node.tied.setZero();
  }
  for (std::size_t w = 0; w < model.touching.walls.size(); ++w)
    if (model.touching.walls[w].moves)
      walls.place[w] += model::integral(model.touching.walls[w].motion, time_before, time);
}

const WallAction* meet_walls(const model::Model& model, const Vec3& x, std::size_t own, WallQuestion question,
                             WallContact& walls) {
  const LocalIndex index = walls.node_of[own];
  if (index == no_index) return nullptr;
  WallNode& node = nth(walls.nodes, index);
  std::array<WallMeeting, WallChoice::most> meetings;
  const auto count = static_cast<std::size_t>(node.looked_at);
  for (std::size_t k = 0; k < count; ++k) {
    const auto entry = static_cast<std::size_t>(node.kept[k]);
    const auto w = static_cast<std::size_t>(walls.wall[entry]);
    const model::RigidWall& wall = model.touching.walls[w];
    meetings[k] = {wall.normal, wall.normal.dot(x) - walls.place[w], wall.friction.fixed, walls.holds[entry] != 0};
  }
  node.behind = depth_behind(model, walls, node, x);
  question.meetings = {meetings.data(), count};
  question.first = walls.first;
  question.tied = node.tied;
  node.action = node.springs ? spring(question, node.solved) : act(question, node.solved);
  return &node.action;
}

const WallAction* action_of(const WallContact& walls, std::size_t own) {
  const LocalIndex index = walls.any() ? walls.node_of[own] : no_index;
  return index == no_index ? nullptr : &nth(walls.nodes, index).action;
}

void add_branches(const WallContact& walls, std::vector<std::uint8_t>& branches) {
  for (const WallNode& node : walls.nodes) {
    const WallChoice& choice = node.action.choice;
    int branch = choice.slides ? 1 : 0;
    for (const bool active : choice.active) branch = 2 * branch + (active ? 1 : 0);
    branches.push_back(static_cast<std::uint8_t>(branch));
  }
}

bool chosen_by_balance(const comm::Communicator& ranks, const WallContact& walls) {
  const bool pressed = std::ranges::any_of(walls.nodes, [](const WallNode& node) {
    return std::ranges::any_of(node.action.choice.active, std::identity{});
  });
  return !walls.any() || !ranks.any(walls.first && pressed);
}

void remember_choice(WallContact& walls) {
  walls.first = false;
  for (WallNode& node : walls.nodes) node.solved = node.action.choice;
}

WallForces forces_of(const model::Model& model, const WallContact& walls, std::size_t own) {
  WallForces forces;
  const LocalIndex index = walls.node_of[own];
  if (index == no_index) return forces;
  const WallNode& node = nth(walls.nodes, index);
  for (std::int32_t k = 0; k < node.looked_at; ++k) {
    const auto w = static_cast<std::size_t>(nth(walls.wall, node.kept[k]));
    forces.normal += node.action.pressure[k] * model.touching.walls[w].normal;
  }
  forces.friction = node.action.friction;
  return forces;
}

void keep_walls(const comm::Communicator& ranks, const model::Model& model, double dt, double of_impulse,
                WallContact& walls) {
  double deepest = 0;
  for (const WallNode& node : walls.nodes) deepest = std::max(deepest, node.behind);
  walls.penetration = std::max(walls.penetration, ranks.max(deepest));
  std::vector<comm::ExactAccumulator> sums(walls.force.size());
  for (const WallNode& node : walls.nodes) {
    double largest = 0;
    std::size_t pushes = 0;  // friction of a node at several walls is assigned to the one with the largest pressure
    for (std::int32_t k = 0; k < node.looked_at; ++k) {
      const auto w = static_cast<std::size_t>(nth(walls.wall, node.kept[k]));
      const double pressure = node.action.pressure[k];
      for (std::size_t c = 0; c < 3; ++c)
        sums[3 * w + c].add(pressure * model.touching.walls[w].normal[static_cast<int>(c)]);
      if (pressure <= largest) continue;
      largest = pressure;
      pushes = w;
    }
    for (std::size_t c = 0; c < 3; ++c) sums[3 * pushes + c].add(node.action.friction[static_cast<int>(c)]);
  }
  std::vector<double> now(walls.force.size());
  comm::exact_sum(ranks, sums, now);
  for (std::size_t k = 0; k < now.size(); ++k) {
    walls.impulse[k] += dt * (of_impulse * now[k] + (1 - of_impulse) * walls.force[k]);
    walls.force[k] = now[k];
  }
}

GlobalIndex pressed(const comm::Communicator& ranks, const WallContact& walls) {
  if (!walls.any()) return 0;
  GlobalIndex rows = 0;
  for (const WallNode& node : walls.nodes)
    for (std::int32_t k = 0; k < node.looked_at; ++k) rows += node.action.pressure[k] != 0 ? 1 : 0;
  return ranks.sum(rows);
}

}  // namespace brunt::implicit
