// SPDX-License-Identifier: Apache-2.0
// E1: bodies whose masses differ by a million, by density and by size. The light one must not sink in, and elasticity
// lets it leave at twice the speed of the heavy one at most.
#include <catch2/catch.hpp>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using test::Simulation;

namespace {

struct Meeting {
  double deepest = 0;            ///< node of the small body below the other's face at any time [length]
  double rows = 0;               ///< the same as contact tells it
  double fastest = 0, last = 0;  ///< greatest and last speed of the small body's centre of mass [velocity]
  double gained = 0;             ///< greatest energy that contact has given, of the start's
  double momentum = 0;           ///< largest error of it, of the heavy body's
  GlobalIndex most = 0, active_last = 0;
};

struct Bodies {
  double heavy_side, heavy_density;
  int heavy_elements;
  double light_side, light_density;
  int light_elements;
  double young;
  Vec3 at;       ///< lower corner of the light body; the heavy one's upper face is z = 0, a corner of it x = y = 0
  double speed;  ///< of the body that moves
  bool heavy_moves;
};

Meeting meet(const Bodies& b, double time) {
  const auto box = [](const std::string& part, double side, int n) {
    return mesh::box(part, {side, side, side}, {n, n, n});
  };
  mesh::Mesh mesh = box("heavy", b.heavy_side, b.heavy_elements), light = box("light", b.light_side, b.light_elements);
  mesh::place(mesh, 1, {0, 0, 1}, 0, {0, 0, -b.heavy_side});
  mesh::place(light, 1, {0, 0, 1}, 0, b.at);
  const auto first = static_cast<GlobalIndex>(mesh.coordinates.size());
  mesh::append(mesh, std::move(light));
  const auto number = [](double value) { return std::to_string(value); };
  const std::string law = ", young: " + number(b.young) + ", poisson: 0.3}";
  Simulation scene(std::move(mesh), "materials: {h: {model: elastic, density: " + number(b.heavy_density) + law +
                                        ", l: {model: elastic, density: " + number(b.light_density) + law +
                                        "}\nparts: {heavy: {material: h}, light: {material: l}}\n" +
                                        "initial: [{part: " +
                                        (b.heavy_moves ? "heavy, velocity: [0, 0, " : "light, velocity: [0, 0, -") +
                                        number(b.speed) + "]}]\ncontact: [{between: all}]\n");
  Meeting result;
  double start = 0, momentum = 0;
  while (scene.state.time < time) {
    scene.step();
    Vec3 sum = Vec3::Zero();
    double mass = 0, lowest = 1e300, highest = -1e300;
    for (GlobalIndex n = first; n < scene.nodes(); ++n) {
      const LocalIndex i = scene.node(n);
      sum += scene.mass(i) * scene.velocity(i);
      mass += scene.mass(i);
      lowest = std::min(lowest, scene.position(i).z());
    }
    for (GlobalIndex n = 0; n < first; ++n) {  // the face under the light body: its nodes within two elements of it
      const Vec3 x = scene.model.mesh.coordinates[static_cast<std::size_t>(scene.node(n))];
      const Vec3 middle = b.at + Vec3(0.5, 0.5, 0) * b.light_side;
      if (x.z() < -1e-9 || (x - middle).head<2>().norm() > b.light_side + 1e-9 + b.heavy_side / b.heavy_elements)
        continue;
      highest = std::max(highest, scene.position(scene.node(n)).z());
    }
    result.deepest = std::max(result.deepest, highest - lowest);
    result.last = std::abs(sum.z()) / mass;
    result.fastest = std::max(result.fastest, result.last);
    const contact::ContactTotals totals = contact::collect(*scene.contact);
    result.rows = totals.penetration;
    result.most = std::max(result.most, totals.active);
    result.active_last = totals.active;
    const time::Ledger ledger = scene.ledger();
    if (scene.state.step == 1) {
      start = ledger.total();
      momentum = ledger.momentum.z();
    }
    result.gained = std::max(result.gained, -(ledger.contact + ledger.friction) / start);
    result.momentum = std::max(result.momentum, std::abs(ledger.momentum.z() - momentum) / ledger.momentum_scale);
  }
  return result;
}

void judge(const Bodies& b, const Meeting& m) {
  CAPTURE(b.at.transpose(), b.heavy_moves, m.deepest, m.rows, m.fastest, m.last, m.gained, m.most);
  CHECK(m.most > 0);
  CHECK(m.active_last == 0);  // they have parted
  CHECK(m.deepest <= 1e-2 * b.light_side);
  CHECK(m.rows <= 1e-2 * b.light_side);
  CHECK(m.fastest <= (b.heavy_moves ? 2.01 : 1.01) * b.speed);
  CHECK(m.last >= (b.heavy_moves ? 1.0 : 0.1) * b.speed);
  CHECK(m.gained <= 1e-3);
  CHECK(m.momentum <= 1e-10);
}

}  // namespace

TEST_CASE("equal cubes of densities 1 and 1e6 meet at 1 m/s", "[law]") {
  for (const bool heavy_moves : {true, false})
    for (const Vec3& at : {Vec3(0, 0, 1e-4), Vec3(0.13, -0.21, 1e-4)}) {
      const Bodies bodies{1, 1e6, 3, 1, 1, 3, 1e10, at, 1, heavy_moves};
      judge(bodies, meet(bodies, 5e-4));
    }
}

// 1.4007 m/s: from a height of 0.1 m
TEST_CASE("a steel cube of 1 m meets one of 1 cm at the speed of a fall of 0.1 m", "[law]") {
  for (const bool heavy_moves : {true, false})
    for (const Vec3& at : {Vec3(0.37, 0.41, 1e-5), Vec3(0.245, 0.245, 1e-5), Vec3(0.3, 0.245, 1e-5)}) {
      const Bodies bodies{1, 7800, 4, 0.01, 7800, 2, 2e11, at, std::sqrt(2 * 9.81 * 0.1), heavy_moves};
      judge(bodies, meet(bodies, 1e-4));
    }
}
