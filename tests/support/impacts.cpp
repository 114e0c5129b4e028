// SPDX-License-Identifier: Apache-2.0
#include "support/impacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "support/given_back.hpp"
#include "support/simulation.hpp"
#include "support/tetrahedra.hpp"
#include "support/true_depth.hpp"

namespace brunt::test {
namespace {

constexpr double side = 0.1;

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  template <class T>
  T one_of(std::initializer_list<T> list) {
    return list.begin()[random_() % list.size()];
  }

 private:
  std::mt19937 random_;
};

mesh::Mesh body(const std::string& name, const std::string& kind, int n) {
  if (kind == "tube") return mesh::tube(name, 0.3 * side, 0.5 * side, side, {2, 5 * n, n});
  if (kind == "cylinder") return mesh::cylinder(name, 0.5 * side, side, {std::max(2, n - 1), n});
  mesh::Mesh cube = mesh::box(name, {side, side, side}, {n, n, n});
  return kind == "tet" ? in_tetrahedra(std::move(cube)) : cube;
}

double reach(const mesh::Mesh& mesh, const Vec3& direction) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Vec3& x : mesh.coordinates) most = std::max(most, x.dot(direction));
  return most;
}

Vec3 middle_of(const mesh::Mesh& mesh) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& x : mesh.coordinates) sum += x;
  return sum / static_cast<double>(mesh.coordinates.size());
}

/// What one step saw: rows and depths, both at the positions before it.
struct Look {
  double reported = 0, not_there = 0;  ///< [length]; shares of an edge
  std::array<bool, 2> holds{};         ///< there are rows of nodes of that body
};

Look look_at_rows(const contact::Contact& contact, const std::array<Solid, 2>& solids, double edge) {
  Look look;
  for (const contact::Row& row : contact.step.rows) {
    if (!row.is_edge()) look.holds[static_cast<std::size_t>(row.slave_body)] = true;
    if (row.gap >= 0) continue;
    look.reported = std::max(look.reported, -row.gap);
    Vec3 slave = Vec3::Zero(), master = Vec3::Zero();
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.node_count); ++i) {
      const Vec3 part = row.weights[i] * contact.step.nodes.motion[static_cast<std::size_t>(row.nodes[i])].position;
      (i < (row.is_edge() ? 2U : 1U) ? slave : master) += part;
    }
    Depth really = solids[static_cast<std::size_t>(row.master_body)].depth(slave);
    if (row.is_edge()) {
      const Depth other = solids[static_cast<std::size_t>(row.slave_body)].depth(-master);
      if (other.depth > really.depth) really = other;
    }
    // along the normal of a row it may be twice as far out as along the shortest way, where faces meet at 60 degrees
    look.not_there = std::max(look.not_there, (-row.gap - 2 * really.depth) / edge);
  }
  return look;
}

/// Of one body's nodes in the other, over the run.
struct Sunk {
  double deepest = 0, in_middle = 0, beyond_rows = 0, at = 0;
  bool held = false;

  void look(const Depth& now, double reported, double time) {
    if (now.depth / now.edge > deepest) deepest = now.depth / now.edge, at = time;
    if (now.in_face > 0.1) in_middle = std::max(in_middle, now.depth / now.edge);
    beyond_rows = std::max(beyond_rows, (now.depth - reported) / now.edge);
  }
};

}  // namespace

Impact random_impact(unsigned seed, const std::string& passes) {
  Dice dice(seed);
  const auto kind = [&] { return dice.one_of<std::string>({"cube", "cube", "tube", "cylinder", "tet"}); };
  const std::string first = kind(), second = kind();
  const int n = dice.one_of({2, 3, 4}), m = dice.one_of({2, 3, 4});
  const bool steel = dice.one_of({true, false});
  Vec3 towards(1, dice.one_of({0.0, 0.3, 1.0}), dice.one_of({0.0, 0.0, 1.0}));
  towards.normalize();
  mesh::Mesh one = body("one", first, n), two = body("two", second, m);
  mesh::place(one, 1, {dice.one_of({0.0, 1.0, -1.0}), dice.one_of({0.0, 1.0}), 1}, dice.one_of({0.0, 1.0, 10.0, 45.0}),
              Vec3::Zero());
  mesh::place(two, 1, {dice.one_of({0.0, 1.0, -1.0}), dice.one_of({0.0, 1.0}), 1}, dice.one_of({0.5, 5.0, 20.0, 45.0}),
              Vec3::Zero());
  Vec3 aside(dice.one_of({0.0, 0.003, 0.03}), dice.one_of({0.0, 0.02, 0.045}), dice.one_of({0.0, 0.003, -0.05}));
  aside += middle_of(one) - middle_of(two);
  aside -= aside.dot(towards) * towards;
  constexpr double gap = 1e-3;
  mesh::place(two, 1, {0, 0, 1}, 0, aside + (reach(one, towards) + reach(two, -towards) + gap) * towards);

  const double speed = steel ? dice.one_of({10.0, 50.0, 100.0, 200.0}) : dice.one_of({3.0, 10.0});
  const Vec3 v = -speed * towards;
  const auto element = [](const std::string& shape) { return shape == "tet" ? "tet4" : "hex8"; };
  mesh::append(one, std::move(two));
  std::string scene = fmt::format(
      "materials: {{m: {{{}}}}}\n"
      "parts: {{one: {{material: m, element: {}}}, two: {{material: m, element: {}}}}}\n"
      "initial: [{{part: two, velocity: [{:.17g}, {:.17g}, {:.17g}]}}]\n"
      "contact: [{{between: all, self: false, passes: {}}}]\n",
      steel ? "model: elastic, density: 7800, young: 2.0e11, poisson: 0.3"
            : "model: neo_hookean, density: 1000, young: 1.0e6, poisson: 0.45",
      element(first), element(second), v.x(), v.y(), v.z(), passes);
  const double blow = steel ? 1.5e-4 : 3e-3;
  return {std::move(one), std::move(scene), side / std::max(n, m), blow + gap / speed};
}

ImpactFigures run_impact(unsigned seed, const std::string& passes) {
  Impact now = random_impact(seed, passes);
  std::array<Solid, 2> solids{Solid(now.mesh, 0), Solid(now.mesh, 1)};
  Simulation scene(std::move(now.mesh), now.scene);
  std::vector<LocalIndex> local;
  for (GlobalIndex node = 0; node < scene.nodes(); ++node) local.push_back(scene.node(node));

  ImpactFigures figures;
  std::array<Sunk, 2> sunk;
  GivenBack contact;
  double energy = 0;
  Vec3 momentum = Vec3::Zero();
  while (scene.state.time < now.end) {
    for (Solid& solid : solids)
      solid.move([&](LocalIndex node) { return scene.position(local[static_cast<std::size_t>(node)]); });
    scene.step();
    const Look look = look_at_rows(*scene.contact, solids, now.edge);
    for (std::size_t b = 0; b < 2; ++b) {
      sunk[b].held = sunk[b].held || look.holds[b];
      sunk[b].look(deepest_node(solids[b], solids[1 - b]), look.reported, scene.state.time);
      const Depth on_edge = deepest_on_edges(solids[b], solids[1 - b]);
      figures.edges = std::max(figures.edges, on_edge.depth / on_edge.edge);
    }
    figures.reported = std::max(figures.reported, look.reported / now.edge);
    figures.not_there = std::max(figures.not_there, look.not_there);
    figures.contact_steps += scene.contact->step.rows.empty() ? 0 : 1;

    const time::Ledger ledger = scene.ledger();
    if (energy == 0) energy = ledger.total(), momentum = ledger.momentum;
    contact.look(lost_in_contact(scene) / energy);
    figures.given = std::max(figures.given, -ledger.contact / energy);
    figures.error = std::max(figures.error, std::abs(ledger.total() - energy) / energy);
    figures.momentum = std::max(figures.momentum, (ledger.momentum - momentum).norm() / momentum.norm());
  }
  figures.returned = contact.given;
  const bool none_held = !sunk[0].held && !sunk[1].held;
  for (const Sunk& s : sunk)
    if (s.held || none_held) {
      if (s.deepest > figures.held) figures.held = s.deepest, figures.held_at = s.at;
      figures.held_middle = std::max(figures.held_middle, s.in_middle);
      figures.not_reported = std::max(figures.not_reported, s.beyond_rows);
    } else {
      figures.others = std::max(figures.others, s.deepest);
    }
  return figures;
}

}  // namespace brunt::test
