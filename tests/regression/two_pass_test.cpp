// SPDX-License-Identifier: Apache-2.0
// What sinks in between the nodes that one pass holds, and what two passes leave of it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <set>

#include "geometry/closest_point.hpp"
#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "mesh/topology.hpp"
#include "support/given_back.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using test::GivenBack, test::run_until, test::Simulation;

namespace {

/// A face of either side of the interface, by the mesh's nodes.
struct Side {
  std::vector<std::array<GlobalIndex, 4>> faces;
  std::vector<GlobalIndex> nodes;
};

/// The faces of block b that lie in the plane z = height at the start.
Side side_of(const mesh::Mesh& mesh, std::size_t b, double height) {
  Side side;
  std::set<GlobalIndex> nodes;
  const mesh::Block& block = mesh.blocks[b];
  for (LocalIndex e = 0; e < block.count(); ++e)
    for (int f = 0; f < 6; ++f) {
      const auto corners = mesh::face_nodes(block.shape, block.element(e), f);
      if (!std::ranges::all_of(corners, [&](LocalIndex n) {
            return std::abs(mesh.coordinates[static_cast<std::size_t>(n)].z() - height) < 1e-9;
          }))
        continue;
      side.faces.push_back({corners[0], corners[1], corners[2], corners[3]});
      nodes.insert(corners.begin(), corners.end());
    }
  side.nodes.assign(nodes.begin(), nodes.end());
  return side;
}

/// Deepest node of `nodes` behind a face that it projects on, up to half an edge [length].
double deepest(const Simulation& scene, const Side& nodes, const Side& faces) {
  double depth = 0;
  for (const GlobalIndex n : nodes.nodes) {
    const Vec3 x = scene.position(scene.node(n));
    for (const auto& face : faces.faces) {
      std::array<Vec3, 4> corners;
      for (std::size_t i = 0; i < 4; ++i) corners[i] = scene.position(scene.node(face[i]));
      const auto closest = geometry::closest_point(x, corners);
      if (!closest || closest->region != geometry::Region::face) continue;
      const double behind = (closest->point - x).dot(geometry::face_normal(corners, closest->xi, closest->eta));
      if (behind < 0.7 * geometry::longest_edge(corners)) depth = std::max(depth, behind);
    }
  }
  return depth;
}

struct Sunk {
  double depth = 0;  ///< deepest node of either side at any time, in edges of the finer mesh
  double rows = 0;   ///< what the run reports as largest penetration, likewise
  double least = 0;  ///< that contact had taken at any time, of the energy that there was
  double given = 0;  ///< the same, by how much it fell from what it was at most
  double error = 0;  ///< of the ledger
};

/// A cube of rubber 1 cm wide, of upper^3 elements, flies onto another one, aside by 1 and 2 mm.
Sunk cubes(int lower, int upper, double speed, const std::string& rule, const std::string& element) {
  constexpr double aside = 0.001, density = 1000;
  mesh::Mesh mesh = mesh::box("lower", {0.01, 0.01, 0.01}, {lower, lower, lower});
  mesh::Mesh top = mesh::box("upper", {0.01, 0.01, 0.01}, {upper, upper, upper});
  mesh::place(top, 1, {0, 0, 1}, 0, {aside, 2 * aside, 0.01 + 1e-6});
  mesh::append(mesh, std::move(top));
  const Side below = side_of(mesh, 0, 0.01), above = side_of(mesh, 1, 0.01 + 1e-6);
  Simulation scene(std::move(mesh),
                   "materials: {m: {model: neo_hookean, density: " + std::to_string(density) +
                       ", young: 6.0e6, poisson: 0.45}}\nparts: {lower: {material: m, element: " + element +
                       "}, upper: {material: m, element: " + element + "}}\ninitial: [{part: upper, velocity: [0, 0, " +
                       std::to_string(-speed) + "]}]\ncontact: [{between: [lower, upper]" + rule + "}]\n");
  Sunk sunk;
  GivenBack contact;
  const double start = 0.5 * density * 1e-6 * speed * speed;
  while (scene.state.time < 1e-3) {  // the cubes part after 0.6 ms
    scene.step();
    const time::Ledger now = scene.ledger();
    sunk.depth = std::max({sunk.depth, deepest(scene, below, above), deepest(scene, above, below)});
    contact.look(lost_in_contact(scene));
    sunk.error = std::max(sunk.error, std::abs(now.total() - start) / start);
  }
  const double edge = 0.01 / std::max(lower, upper);
  sunk.depth /= edge;
  sunk.least = contact.least / start;
  sunk.given = contact.given / start;
  sunk.rows = contact::collect(*scene.contact).penetration / edge;
  return sunk;
}

}  // namespace

// ours: at 3 and at 10 m/s, depth of an edge of the finer mesh (one pass against two), and what contact gives back of
// the energy (two passes, held together; as the mean of two solutions they gave 4e-3 to 1e-2):
// - hex8_full  3^3 on 4^3   2.1 %  0.005 %  2.5e-7    9.7 %  0.030 %  1.9e-6
// -            3^3 on 3^3   3.9 %  0.004 %  2.2e-6   16.9 %  0.027 %  7.1e-6
// - hex8       3^3 on 4^3   6.9 %  0.008 %  4.5e-8   26.3 %  0.078 %  4.9e-7
// -            3^3 on 3^3  10.9 %  0.004 %  1.1e-5   37.4 %  0.034 %  7.2e-6
TEST_CASE("rubber cubes aside of each other: corners of neither sink into the other", "[regression]") {
  struct Gate {
    const char* element;
    int upper;
    double speed;
  };
  for (const Gate& gate :
       {Gate{"hex8_full", 4, 3}, Gate{"hex8_full", 4, 10}, Gate{"hex8_full", 3, 3}, Gate{"hex8_full", 3, 10},
        Gate{"hex8", 4, 3}, Gate{"hex8", 4, 10}, Gate{"hex8", 3, 3}, Gate{"hex8", 3, 10}}) {
    const Sunk one = cubes(3, gate.upper, gate.speed, ", passes: one", gate.element),
               two = cubes(3, gate.upper, gate.speed, ", passes: two", gate.element);
    CAPTURE(gate.element, gate.upper, gate.speed, one.depth, two.depth);
    CHECK(two.depth <= 0.001);              // ours: 7.8e-4
    CHECK(two.depth <= 0.004 * one.depth);  // ours: 3.1e-3
    CHECK(two.rows >= 0.3 * two.depth);     // and the run says so, but for a corner that swings out of reach
    CHECK(two.least >= 0);                  // contact took energy, at no time gave any on the whole
    CHECK(two.given <= 1.4e-5);             // ours: 1.1e-5, at any time, from what it had taken: recovery and tolerance
    CHECK(two.error < 1e-12);
  }
}

// The load moves on the rubber while it is pressed: what opens under load does the work of the press backwards.
TEST_CASE("a rubber cube pressed on another one in two passes: contact gives none of the work of the press",
          "[regression]") {
  const double upper = GENERATE(0.08, 0.1);  // within the lower one; over its rim
  constexpr double lower = 0.1;
  mesh::Mesh mesh = mesh::box("a", {lower, lower, lower}, {3, 3, 3}),
             top = mesh::box("b", {upper, upper, lower}, {3, 3, 3});
  mesh::place(top, 1, {0, 0, 1}, 0, {0.007, 0.004, lower});
  mesh::append(mesh, std::move(top));
  Simulation scene(
      std::move(mesh),
      "materials: {r: {model: neo_hookean, density: 1000, young: 1.0e6, poisson: 0.3}}\n"
      "parts: {a: {material: r}, b: {material: r}}\n"
      "sets: {foot: {box: [[-1, -1, -0.001], [1, 1, 0.001]]}, top: {box: [[-1, -1, 0.1999], [1, 1, 0.3]]}}\n"
      "fixed: [{set: foot, dofs: [x, y, z]}, {set: top, dofs: [x, y]}]\n"
      "curves: {c: [[0, 0], [0.005, -0.6], [0.03, -0.6], [0.035, 0], [1, 0]]}\n"
      "prescribed: [{set: top, dof: z, velocity: c}]\n"
      "damping: {alpha: 200, from: 0, to: 1}\n"
      "contact: [{between: all, passes: two}]\n");
  const GivenBack contact = run_until(scene, 0.1);
  const double work = scene.ledger().external;
  CAPTURE(upper, contact.now / work, contact.given / work);
  CHECK(work > 1);
  CHECK(contact.given <= 2.9e-4 * work);  // ours: 1.0e-4 and 2.2e-4; the mean of two solutions gave 6e-3 and 2e-3
  CHECK(contact::collect(*scene.contact).penetration <= 1.8e-3 * lower / 3);  // ours: 1.4e-3 and 1.8e-4
}

// Two passes of blocks askew hold more rows than their faces have freedom; soft rows are held in as many iterations on
// fine meshes as on coarse ones. ours: mean and most of impacts of 10:8, 20:16 and 40:32 elements: 16.9 and 40, 19.3
// and 40, 20.0 and 37; with softness: 0 16.7 and 76, 33.7 and 95, 40.4 and 107.
TEST_CASE("steel blocks turned against each other, soft rows: iterations do not grow with the patch", "[regression]") {
  struct Seen {
    double mean = 0;
    int most = 0;
  };
  const auto impact = [](int lower, int upper) {
    mesh::Mesh mesh = mesh::box("lower", {0.02, 0.02, 0.008}, {lower, lower, 2 * lower / 5}),
               top = mesh::box("upper", {0.016, 0.016, 0.008}, {upper, upper, upper / 2});
    mesh::place(top, 1, {0, 0, 1}, 7, {0.002, 0.001, 0.00801});
    mesh::append(mesh, std::move(top));
    Simulation scene(std::move(mesh),
                     "materials: {m: {model: elastic, density: 2700, young: 6.9e10, poisson: 0.3}}\n"
                     "parts: {lower: {material: m}, upper: {material: m}}\n"
                     "initial: [{part: upper, velocity: [10, 0, -40]}]\n"
                     "contact: [{between: [lower, upper], passes: two, softness: 0.05}]\n");
    while (scene.state.time < 6e-6) scene.step();
    const contact::ContactStatistics& seen = scene.contact->ledger.statistics;
    CHECK(seen.steps_at_limit == 0);
    return Seen{static_cast<double>(seen.iterations) / static_cast<double>(seen.solved_steps), seen.most_iterations};
  };
  const Seen coarse = impact(10, 8), fine = impact(20, 16), finer = impact(30, 24);
  CAPTURE(coarse.mean, coarse.most, fine.mean, fine.most, finer.mean, finer.most);
  CHECK(coarse.mean <= 19);
  CHECK(coarse.most <= 45);
  for (const Seen& seen : {fine, finer}) {
    CHECK(seen.mean <= 1.3 * coarse.mean);
    CHECK(seen.most <= 1.2 * coarse.most);
  }
}

// A load that comes and goes: rows give back what they stored, and nothing else. Without their part of what recovery
// takes back (see enforcement/softness.hpp) contact gave 2e-2 of what the blocks store.
TEST_CASE("two blocks pressed six times in two passes, soft rows: contact gives nothing on the whole", "[regression]") {
  mesh::Mesh mesh = mesh::box("lower", {0.02, 0.02, 0.008}, {5, 5, 2}),
             top = mesh::box("upper", {0.016, 0.016, 0.008}, {4, 4, 2});
  mesh::place(top, 1, {0, 0, 1}, 7, {0.002, 0.001, 0.008});
  mesh::append(mesh, std::move(top));
  Simulation scene(std::move(mesh),
                   "materials: {m: {model: elastic, density: 2700, young: 6.9e10, poisson: 0.3}}\n"
                   "parts: {lower: {material: m}, upper: {material: m}}\n"
                   "fixed: [{set: lower_zmin, dofs: [x, y, z]}]\n"
                   "curves: {c: [[0, 0], [5.0e-5, 1], [1.0e-4, 0.02], [1.5e-4, 1], [2.0e-4, 0.02], [2.5e-4, 1],\n"
                   "             [3.0e-4, 0.02], [3.5e-4, 1], [4.0e-4, 0.02], [4.5e-4, 1], [5.0e-4, 0.02]]}\n"
                   "pressure: [{set: upper_zmax, value: 2.0e8, curve: c}]\n"
                   "contact: [{between: [lower, upper], passes: two, softness: 0.05}]\n");
  GivenBack whole, lost;
  double stored = 0, soft = 0;
  while (scene.state.time < 5e-4) {
    scene.step();
    stored = std::max(stored, scene.ledger().internal);
    soft = std::max(soft, contact::collect(*scene.contact).stored);
    whole.look(scene.ledger().contact);
    lost.look(lost_in_contact(scene));
  }
  CAPTURE(whole.least / stored, whole.given / stored, lost.given / stored, soft / stored);
  CHECK(soft > 1e-3 * stored);  // the springs are seen
  CHECK(whole.least >= -1e-9 * stored);
  CHECK(lost.given <= 6.4e-4 * stored);  // ours: 4.9e-4
}

// ours: mean and most of three impacts, with softness: 0: conjugate residuals 8.3 and 13, 20.8 and 37, 15.1 and 30;
// Barzilai-Borwein steps took 11.5 and 22, 30.7 and 53, 24.2 and 49.
TEST_CASE("steel blocks turned against each other: iterations of two passes", "[regression]") {
  struct Gate {
    int lower, upper;
    double degrees, mean;
    int most;
  };
  const Gate gate = GENERATE(Gate{8, 8, 3, 10, 18}, Gate{8, 12, 3, 25, 45}, Gate{8, 12, 45, 19, 38});
  constexpr double side = 0.1, high = 0.05, apart = 1e-6;
  const double turn = gate.degrees * std::numbers::pi / 180, c = std::cos(turn), s = std::sin(turn);
  mesh::Mesh mesh = mesh::box("lower", {side, side, high}, {gate.lower, gate.lower, gate.lower / 2}),
             top = mesh::box("upper", {side, side, high}, {gate.upper, gate.upper, gate.upper / 2});
  mesh::place(top, 1, {0, 0, 1}, gate.degrees,
              {side / 2 * (1 - c + s), side / 2 * (1 - c - s), high + apart});  // about the middle
  mesh::append(mesh, std::move(top));
  Simulation scene(std::move(mesh),
                   "materials: {m: {model: elastic, density: 7800, young: 2.0e11, poisson: 0.3}}\n"
                   "parts: {lower: {material: m}, upper: {material: m}}\n"
                   "initial: [{part: upper, velocity: [0, 0, -20]}]\n"
                   "contact: [{between: all, passes: two, softness: 0}]\n");
  while (scene.state.time < 3e-5) scene.step();  // they part after 2e-5 s
  const contact::ContactStatistics& seen = scene.contact->ledger.statistics;
  const double mean = static_cast<double>(seen.iterations) / static_cast<double>(seen.solved_steps);
  CAPTURE(gate.lower, gate.upper, gate.degrees, mean, seen.most_iterations, seen.solved_steps);
  CHECK(seen.solved_steps >= 15);
  CHECK(seen.steps_at_limit == 0);
  CHECK(mean <= gate.mean);
  CHECK(seen.most_iterations <= gate.most);
}

// In one step of the first conjugate residuals alone wandered to 17 at the limit of 200 iterations, and gave 9 % of all
// energy: after half of them Barzilai-Borwein steps take over. That was while the shaft's facets slipped over the rims
// of the tube between nodes; now the worst step takes 11 or 12, so that half of 20 is passed.
TEST_CASE("a rubber shaft turns in a steel tube in two passes: every step is solved, and contact gives nothing",
          "[regression]") {
  mesh::Mesh mesh = mesh::tube("tube", 0.05, 0.07, 0.04, {2, 24, 3});
  mesh::Mesh shaft = mesh::cylinder("shaft", 0.0495, 0.04, {5, 4});
  mesh::place(shaft, 1, {0, 0, 1}, 0, {0, -0.00025, 0});
  mesh::append(mesh, std::move(shaft));
  Simulation scene(std::move(mesh),
                   "materials: {rubber: {model: neo_hookean, density: 1000, young: 1.0e7, poisson: 0.45},\n"
                   "            steel: {model: elastic, density: 7800, young: 2.0e11, poisson: 0.3}}\n"
                   "parts: {tube: {material: steel}, shaft: {material: rubber}}\n"
                   "fixed: [{set: tube_side, dofs: [x, y, z]}, {set: shaft_bottom, dofs: [z]}]\n"
                   "curves: {ramp: [[0, 0], [0.003, 1]]}\ngravity: {vector: [0, -2000, 0], curve: ramp}\n"
                   "initial: [{part: shaft, rotation: {axis: [0, 0, 1], rate: 200}}]\n"
                   "contact: [{between: [tube, shaft], passes: two, max_iterations: 20, softness: 0}]\n");
  const GivenBack contact = run_until(scene, 5e-3);
  const contact::ContactStatistics& seen = scene.contact->ledger.statistics;
  CAPTURE(seen.most_iterations, seen.largest_residual, contact.given / scene.ledger().kinetic);
  CHECK(seen.most_iterations > 10);  // some step is handed over
  CHECK(seen.steps_at_limit == 0);
  CHECK(seen.largest_residual <= 1e-3);
  CHECK(contact.given <= 1e-3 * scene.ledger().kinetic);  // ours: 3.3e-4
}
