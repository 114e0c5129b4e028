// SPDX-License-Identifier: Apache-2.0
// Arguments that do not fit together; tests/package judges what comes out.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>

#include "brunt/contact_step.hpp"
#include "brunt/penetration_depth.hpp"
#include "brunt/search.hpp"
#include "tests/support/small_mesh.hpp"

using namespace brunt;

namespace {

/// A tetrahedron of part 0.
api::ContactMesh tetrahedron() {
  return {.node_number = {7, 3, 9, 5},
          .position = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1},
          .element_number = {1},
          .corner = {0, 1, 2, 3, -1, -1, -1, -1},
          .part = {0},
          .mass = {1, 1, 1, std::numeric_limits<double>::infinity()}};
}

/// A box over another one, both of free mass points, their faces level but not aligned; the upper one moves down and
/// aside by two thirds of its gap and more.
struct Bodies {
  api::ContactMesh mesh;
  std::vector<double> position, velocity;
  double dt = 0.01;
  std::array<int, 3> lower{};  ///< elements of the lower box
  std::size_t lower_nodes = 0;

  Bodies(std::mt19937& random, std::uniform_real_distribution<double>& share) {
    mesh::Mesh whole;
    const auto count = [&] { return 1 + static_cast<int>(3 * share(random)); };
    lower = {count(), count(), count()};
    support::append_box(whole, {0, 0, -1}, {1, 1, 1}, lower);
    lower_nodes = whole.coordinates.size();
    support::append_box(whole, {share(random) - 0.4, share(random) - 0.4, 0.002 + 0.05 * share(random)}, {1, 1, 1},
                        {count(), count(), count()});
    for (std::size_t n = 0; n < whole.coordinates.size(); ++n) {
      const Vec3& x = whole.coordinates[n];
      mesh.node_number.push_back(static_cast<std::int64_t>(1000 - 3 * n));
      mesh.position.insert(mesh.position.end(), {x[0], x[1], x[2]});
      mesh.mass.push_back(n < lower_nodes ? 1.0 : 0.1 + share(random));
      const bool upper = n >= lower_nodes;
      velocity.insert(velocity.end(), {upper ? 0.5 : 0.0, 0.0, upper ? -1.0 : 0.0});
    }
    for (std::size_t b = 0; b < 2; ++b)
      for (LocalIndex e = 0; e < whole.blocks[b].count(); ++e) {
        mesh.element_number.push_back(static_cast<std::int64_t>(mesh.element_number.size()) * 7);
        mesh.part.push_back(static_cast<std::int32_t>(b));
        mesh.corner.insert(mesh.corner.end(), whole.blocks[b].element(e), whole.blocks[b].element(e) + 8);
      }
    position = mesh.position;
  }
  [[nodiscard]] Vec3 momentum() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t n = 0; n < mesh.mass.size(); ++n) sum += mesh.mass[n] * Vec3(&velocity[3 * n]);
    return sum;
  }
  [[nodiscard]] double kinetic() const {
    double sum = 0;
    for (std::size_t n = 0; n < mesh.mass.size(); ++n) sum += 0.5 * mesh.mass[n] * Vec3(&velocity[3 * n]).squaredNorm();
    return sum;
  }
  /// The least height of a node of the upper box over the face of the lower one that is below it.
  [[nodiscard]] double lowest() const {
    double least = 1e9;
    for (std::size_t n = lower_nodes; n < mesh.mass.size(); ++n) {
      const double* const x = &position[3 * n];
      if (x[0] < 0.05 || x[0] > 0.95 || x[1] < 0.05 || x[1] > 0.95) continue;
      least = std::min(least, x[2] - height_of_lower(x[0], x[1]));
    }
    return least;
  }

 private:
  /// Faces as they lay at the start, with the heights of now: nodes move aside by less than a tenth.
  [[nodiscard]] double height_of_lower(double x, double y) const {
    const auto [nx, ny, nz] = lower;
    const int i = std::min(nx - 1, static_cast<int>(x * nx)), j = std::min(ny - 1, static_cast<int>(y * ny));
    const double s = x * nx - i, t = y * ny - j;
    const auto z = [&, nx = nx, ny = ny, nz = nz](int a, int b) {
      return position[3 * static_cast<std::size_t>((nz * (ny + 1) + j + b) * (nx + 1) + i + a) + 2];
    };
    return (1 - s) * ((1 - t) * z(0, 0) + t * z(0, 1)) + s * ((1 - t) * z(1, 0) + t * z(1, 1));
  }
};

}  // namespace

TEST_CASE("a step of contact: what is wrong with a mesh is said") {
  const auto refused = [](const std::function<void(api::ContactMesh&)>& change, const std::string& says) {
    api::ContactMesh mesh = tetrahedron();
    change(mesh);
    CHECK_THROWS_WITH(api::ContactStep(MPI_COMM_WORLD, mesh), Catch::Contains(says));
  };
  CHECK_NOTHROW(api::ContactStep(MPI_COMM_WORLD, tetrahedron()));
  refused([](api::ContactMesh& m) { m.position.pop_back(); }, "position has three numbers");
  refused([](api::ContactMesh& m) { m.part.clear(); }, "corner has eight numbers and part one");
  refused([](api::ContactMesh& m) { m.mass[1] = 0; }, "masses are positive");
  refused([](api::ContactMesh& m) { m.part[0] = -1; }, "parts count from 0");
  refused([](api::ContactMesh& m) { m.corner[3] = 4; }, "corners are positions in node_number");
  refused([](api::ContactMesh& m) { m.node_number[1] = 9; }, "a rank has each node once");
  refused([](api::ContactMesh& m) { std::swap(m.corner[0], m.corner[1]); }, "element 1");  // inside out
  refused(
      [](api::ContactMesh& m) {  // a second one on the face of the first
        m.node_number.push_back(11);
        m.position.insert(m.position.end(), {1, 1, 1});
        m.mass.push_back(1);
        m.element_number.push_back(2);
        m.part.push_back(4);
        m.corner.insert(m.corner.end(), {1, 2, 3, 4, -1, -1, -1, -1});
      },
      "one of two parts");
  refused([](api::ContactMesh& m) { m.position[0] = std::numeric_limits<double>::quiet_NaN(); }, "");
}

TEST_CASE("a step of contact: a body alone keeps its velocity, and wrong arrays are refused") {
  api::ContactStep step(MPI_COMM_WORLD, tetrahedron());
  const std::vector<double> position = tetrahedron().position, before(12, 2.0);
  std::vector<double> velocity(12, 2.0), impulse(12, 1.0);
  const api::ContactReport report = step.correct(position, before, velocity, 0.01, impulse);
  CHECK(velocity == before);
  CHECK(impulse == std::vector<double>(12, 0.0));
  CHECK(report.active == 0);
  CHECK_THROWS_AS(step.correct(position, before, velocity, 0, impulse), std::invalid_argument);
  velocity[4] = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(step.correct(position, before, velocity, 0.01), std::invalid_argument);
  velocity.push_back(1);
  CHECK_THROWS_AS(step.correct(position, before, velocity, 0.01), std::invalid_argument);
  for (const api::ContactSettings& wrong : {api::ContactSettings{.friction = -1},
                                            {.friction = std::numeric_limits<double>::quiet_NaN()},
                                            {.tolerance = 0},
                                            {.iterations = 0}})
    CHECK_THROWS_AS(api::ContactStep(MPI_COMM_WORLD, tetrahedron(), wrong), std::invalid_argument);
  velocity.resize(11);
  CHECK_THROWS_AS(step.correct(position, before, velocity, 0.01), std::invalid_argument);
}

TEST_CASE("a step of contact: random bodies keep momentum, gain next to no energy and do not pass each other") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  for (int scene = 0; scene < 100; ++scene) {
    Bodies bodies(random, share);
    api::ContactSettings settings;
    settings.friction = scene % 2 == 0 ? 0 : share(random);
    settings.tolerance = 1e-6;
    api::ContactStep step(MPI_COMM_WORLD, bodies.mesh, settings);
    const Vec3 momentum = bodies.momentum();
    const double at_start = bodies.kinetic();
    double least = at_start, active = 0;
    CAPTURE(scene, settings.friction);
    for (int k = 0; k < 40; ++k) {
      const std::vector<double> before = bodies.velocity;
      std::vector<double> impulse(before.size());
      active += static_cast<double>(step.correct(bodies.position, before, bodies.velocity, bodies.dt, impulse).active);
      for (std::size_t i = 0; i < before.size(); ++i) {
        CHECK(std::abs(bodies.mesh.mass[i / 3] * (bodies.velocity[i] - before[i]) - impulse[i]) < 1e-12);
        bodies.position[i] += bodies.dt * bodies.velocity[i];
      }
      least = std::min(least, bodies.kinetic());
      CHECK(bodies.kinetic() <= least + 1e-3 * at_start);  // penetration is recovered (cases/LIMITS.md)
    }
    CHECK(active > 0);
    CHECK((bodies.momentum() - momentum).norm() < 1e-10 * momentum.norm());
    CHECK(bodies.lowest() > -0.05);
  }
}

TEST_CASE("a step of contact: whether a part meets itself, also one of hexahedra and tetrahedra") {
  // a cube, and a tetrahedron of the same part whose tip falls on it
  api::ContactMesh mesh{.node_number = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11},
                        .position = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0,   0,   1,   1,   0,   1,
                                     1, 1, 1, 0, 1, 1, 0, 0, 2, 1, 0, 2, 0.5, 1.0, 2.0, 0.5, 0.4, 1.005},
                        .element_number = {0, 1},
                        .corner = {0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 9, 11, -1, -1, -1, -1},
                        .part = {0, 0},
                        .mass = std::vector<double>(12, 1.0)};
  for (const bool self : {false, true}) {
    api::ContactStep step(MPI_COMM_WORLD, mesh, {.self = self});
    std::vector<double> velocity(36, 0.0);
    for (std::size_t n = 8; n < 12; ++n) velocity[3 * n + 2] = -1;
    const std::vector<double> before = velocity;
    CAPTURE(self);
    CHECK((step.correct(mesh.position, before, velocity, 0.01).active > 0) == self);
    CHECK((velocity == before) == !self);
  }
}

TEST_CASE("search and depth: arrays of the wrong length are refused") {
  const std::vector<double> five(5);
  CHECK_THROWS_AS(api::find_points_in_boxes(MPI_COMM_WORLD, five, {}), std::invalid_argument);
  CHECK_THROWS_AS(api::find_points_in_boxes(MPI_COMM_WORLD, {}, five), std::invalid_argument);
  CHECK(api::find_points_in_boxes(MPI_COMM_WORLD, {}, {}).first == std::vector<std::int64_t>{0});
  const std::vector<std::int32_t> triangle{0, 1, 2};
  CHECK_THROWS_AS(api::DepthBody(five, triangle), std::invalid_argument);
  const std::vector<double> corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
  CHECK_THROWS_AS(api::DepthBody(corners, triangle), std::invalid_argument);  // open
  const std::vector<std::int32_t> outside{0, 1, 3};
  const std::vector<double> points{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::vector<std::int32_t> sides{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  const api::DepthBody body(points, sides);
  api::Placement nowhere;
  nowhere.translation[1] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(api::penetration_depth(body, body, nowhere), std::invalid_argument);
  // as far apart as numbers allow: 40 points in a cube and two whose distance is none
  std::vector<double> wide{1e308, 0, 0, -1e308, 0, 0};
  for (int i = 0; i < 40; ++i) wide.insert(wide.end(), {i / 40.0, 0.5, 0.5});
  const std::vector<double> half{0, 0, 0, 0.5, 1, 1};
  CHECK(api::find_points_in_boxes(MPI_COMM_WORLD, wide, half).box.size() == 21);
  CHECK_THROWS_AS(api::DepthBody(corners, outside), std::invalid_argument);
}
