// SPDX-License-Identifier: Apache-2.0
#include "implicit_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/joined/join_surface.hpp"
#include "depth_watch.hpp"
#include "geometry/box.hpp"
#include "implicit/driven_apart.hpp"
#include "implicit/solver.hpp"

namespace brunt::app {
namespace {

using geometry::Box;

/// A look every half of the thinnest element finds what passes an element at a quarter of its depth at least. What
/// comes deeper by more than the scene's guard admits within a step was not held.
constexpr double between_looks = 0.5;
/// Steps that move bodies past each other by more than 32 elements are halved without a look.
constexpr double most_looks = 64;

/// x_n, the present positions, and what lies between, of the mesh's local nodes.
struct Way {
  std::vector<Vec3> from, to;

  [[nodiscard]] std::vector<Vec3> at(double share) const {
    std::vector<Vec3> between(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) between[i] = (1 - share) * from[i] + share * to[i];
    return between;
  }
};

Way way_of(const Prepared& run) {
  Way way;
  for (std::size_t i = 0; i < run.state.nodes.size(); ++i) {
    const auto& reference = run.model.reference[i];
    const auto& moved = run.state.displacement[i];
    const auto& now = run.state.nodes[i].x;
    way.from.emplace_back(reference[0] + moved[0], reference[1] + moved[1], reference[2] + moved[2]);
    way.to.emplace_back(now[0], now[1], now[2]);
  }
  return way;
}

/// Boxes around what the surface nodes of each part have, of all ranks. Collective.
template <class Of>
std::vector<Box> boxes_of_parts(const Prepared& run, const Of& of) {
  const contact::Surface& surface = run.watched->surface;
  std::vector<double> most(6 * run.model.blocks.size(), -std::numeric_limits<double>::infinity());
  for (std::size_t node = 0; node < surface.gid.size(); ++node) {
    if (surface.model_node[node] == no_index) continue;
    for (const Vec3& x : of(static_cast<std::size_t>(surface.model_node[node])))
      for (const std::int32_t block : surface.blocks.row(static_cast<LocalIndex>(node)))
        for (int c = 0; c < 3; ++c) {
          double* const at = &most[6 * static_cast<std::size_t>(block) + static_cast<std::size_t>(c)];
          at[0] = std::max(at[0], -x[c]);
          at[3] = std::max(at[3], x[c]);
        }
  }
  run.links.ranks.max(most);
  std::vector<Box> boxes;
  for (std::size_t b = 0; b < run.model.blocks.size(); ++b)
    boxes.push_back({-Vec3(&most[6 * b]), Vec3(&most[6 * b + 3])});
  return boxes;
}

/// How far two parts, or two points of one, may move relative to each other.
double apart(const Box& one, const Box& other) {
  return (one.high - other.low).cwiseAbs().cwiseMax((other.high - one.low).cwiseAbs()).norm();
}

struct Looks {
  double count = 0;  ///< on the way, that at its end included
  std::int32_t one = 0, other = 0;
};

/// Collective.
Looks looks_on(const Prepared& run, const Way& way) {
  const std::vector<Box> swept = boxes_of_parts(run, [&](std::size_t i) {
    return std::array<Vec3, 2>{way.from[i], way.to[i]};
  });
  const std::vector<Box> moved =
      boxes_of_parts(run, [&](std::size_t i) { return std::array<Vec3, 1>{Vec3(way.to[i] - way.from[i])}; });
  const WatchedBodies& watched = *run.watched;
  Looks looks;
  for (std::size_t a = 0; a < swept.size(); ++a)
    for (std::size_t b = a; b < swept.size(); ++b) {
      const auto one = static_cast<std::int32_t>(a), other = static_cast<std::int32_t>(b);
      if (watched.pairs.at(one, other).rule == contact::PairRule::apart || !geometry::overlaps(swept[a], swept[b]))
        continue;
      const double thinnest = std::min(watched.thinnest[a], watched.thinnest[b]);
      const double count = std::max(1.0, std::ceil(apart(moved[a], moved[b]) / (between_looks * thinnest)));
      if (count > looks.count) looks = {count, one, other};
    }
  return looks;
}

contact::DeepNodes look_at(const Prepared& run, const std::vector<Vec3>& places) {
  const contact::WatchedSurface watched = watched_surface(run);
  const contact::VectorView position{places.empty() ? nullptr : places.front().data(), 3};
  return contact::find_deep_nodes(watched, position, elements_within_reach(run, watched, position),
                                  least_depth(run.input.guards));
}

/// The rigid body that comes deeper into a wall by too much; empty if there is none. Collective.
std::string body_that_sinks(const Prepared& run) {
  const std::vector<double> deeper = shares_behind_walls(run, true);
  const auto sinks = std::ranges::find_if(deeper, [&](double share) { return share > run.input.guards.depth_step; });
  if (sinks == deeper.end()) return {};
  return fmt::format("rigid part '{}' comes deeper into a rigid wall by more than {:g} of an element",
                     nth(run.model.bodies, sinks - deeper.begin()).part, run.input.guards.depth_step);
}

/// Collective.
double most_deeper_of(const Prepared& run, const std::vector<double>& before, const std::vector<double>& after) {
  double most = 0;
  for (std::size_t k = 0; k < after.size(); ++k) most = std::max(most, after[k] - before[k]);
  return run.links.ranks.max(most);
}

}  // namespace

std::vector<double> shares_behind_walls(const Prepared& run, bool since_last) {
  const implicit::Solver& solver = *run.implicit;
  std::vector<double> shares(run.model.bodies.size(), 0.0);
  for (const implicit::WallNode& node : solver.walls.nodes) {
    if (!node.springs || !implicit::yields_to_walls(run.model, solver, node)) continue;
    double& most = nth(shares, solver.bodies.place[node.own].body);
    most = std::max(most, node.behind - (since_last ? node.behind_before : 0));
  }
  run.links.ranks.max(shares);
  for (std::size_t b = 0; b < shares.size(); ++b)
    shares[b] /= nth(run.watched->thinnest, run.model.bodies[b].blocks.front());
  return shares;
}

void watch_implicit(Prepared& run) {
  const auto meets = [](const contact::MortarPair& pair) { return !pair.tied; };
  const bool at_walls = !run.model.touching.walls.empty() && !run.model.bodies.empty();
  if (!run.implicit || (!at_walls && std::ranges::none_of(run.model.touching.mortar, meets))) return;
  const std::size_t blocks = run.model.blocks.size();
  auto watched = std::make_unique<WatchedBodies>();
  const std::vector<char> excluded(run.model.mesh.faces.size(), 0);
  const std::vector<double> inverse_mass(run.model.mesh.coordinates.size(), 1.0);
  watched->surface = contact::join_surface(run.links.ranks, run.model.mesh, excluded, inverse_mass);
  watched->pairs = contact::PairTable(blocks, {});
  for (const contact::MortarPair& pair : run.model.touching.mortar)
    if (meets(pair)) watched->pairs.set(pair.slave, pair.master, {.rule = contact::PairRule::automatic});
  std::vector<double> thinnest(blocks, -std::numeric_limits<double>::infinity());
  for (const contact::SurfaceFace& face : watched->surface.faces)
    nth(thinnest, face.block) = std::max(nth(thinnest, face.block), -face.element_depth);
  run.links.ranks.max(thinnest);
  for (const double depth : thinnest) watched->thinnest.push_back(-depth);
  run.watched = std::move(watched);
}

std::string objection_to_step(Prepared& run) {
  if (!run.watched) return {};
  WatchedBodies& watched = *run.watched;
  if (std::string sinks = body_that_sinks(run); !sinks.empty()) return sinks;
  if (run.model.touching.mortar.empty()) return {};  // walls alone
  const Way way = way_of(run);
  const Looks looks = looks_on(run, way);
  if (looks.count == 0) {
    watched.time = -1;
    return {};
  }
  const auto part = [&](std::int32_t block) { return nth(run.model.blocks, block).part; };
  if (looks.count > most_looks)
    return fmt::format("parts '{}' and '{}' move past each other by more than {:g} of their elements", part(looks.one),
                       part(looks.other), between_looks * most_looks);
  if (watched.time != run.state.time) watched.shares = look_at(run, way.from).shares;
  contact::DeepNodes now;
  for (double look = 1; look <= looks.count; ++look) {
    now = look_at(run, way.at(look / looks.count));
    watched.time = -1;
    if (most_deeper_of(run, watched.shares, now.shares) > run.input.guards.depth_step)
      return fmt::format("something comes deeper by more than {:g} of an element; the deepest of all: {}",
                         run.input.guards.depth_step, text_of(run, now.worst));
  }
  watched.shares = std::move(now.shares);
  watched.time = run.implicit->trial.time;
  return {};
}

}  // namespace brunt::app
