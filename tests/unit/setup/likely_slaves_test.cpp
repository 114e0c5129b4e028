// SPDX-License-Identifier: Apache-2.0
// Two cubes of 4^3 elements: who is foretold to touch whom follows from their places and velocities.
#include "setup/likely_slaves.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <limits>
#include <vector>

#include "mesh/topology.hpp"
#include "unit/partition/meshes.hpp"

using namespace brunt;

namespace {

constexpr std::size_t face_of_cube = 16;  // exterior faces on one side of a cube
const Vec3 towards(-3, 0, 0);

struct Cubes {
  mesh::Mesh mesh;
  std::array<double, 2> density{1, 1};
  std::vector<Vec3> velocity;

  /// The second cube at x = 4 + gap, moved aside, with a velocity; the first rests.
  Cubes(double gap, double aside, const Vec3& speed) {
    partition::test::add_box(mesh, {4, 4, 4}, 0.0, mesh::Shape::hex8, "first");
    const std::size_t nodes = mesh.coordinates.size();
    partition::test::add_box(mesh, {4, 4, 4}, 4 + gap, mesh::Shape::hex8, "second");
    velocity.assign(mesh.coordinates.size(), Vec3::Zero());
    for (std::size_t i = nodes; i < velocity.size(); ++i) {
      mesh.coordinates[i][1] += aside;
      velocity[i] = speed;
    }
  }

  /// How many faces of each cube are foretold.
  std::array<std::size_t, 2> foretold(contact::PairRule rule = contact::PairRule::automatic,
                                      double duration = std::numeric_limits<double>::infinity(),
                                      contact::Passes passes = contact::Passes::one) const {
    contact::Specification specification{.pairs = {2, {rule}}};
    specification.pairs.set(0, 1, {rule, passes});
    const auto sides =
        setup::likely_slaves(mesh, mesh::exterior_sides(mesh), specification, {density, velocity, duration});
    const auto of_first = std::ranges::count(sides, 0, &mesh::Side::block);
    return {static_cast<std::size_t>(of_first), sides.size() - static_cast<std::size_t>(of_first)};
  }
};

using Counts = std::array<std::size_t, 2>;

}  // namespace

TEST_CASE("of cubes that nearly touch, one face of the slave and the layer of elements behind it are foretold") {
  CHECK(Cubes(0.01, 0, Vec3::Zero()).foretold() == Counts{2 * face_of_cube, 0});
}

TEST_CASE("the lighter of two cubes is the slave") {
  Cubes cubes(0.01, 0, Vec3::Zero());
  cubes.density = {2, 1};
  CHECK(cubes.foretold() == Counts{0, 2 * face_of_cube});
}

TEST_CASE("a cube that flies towards the other is foretold to hit the face that looks at it") {
  CHECK(Cubes(20, 0, towards).foretold() == Counts{face_of_cube, 0});
  CHECK(Cubes(20, 2.5, towards).foretold() == Counts{12, 0});  // y from 1.5 on, a face's size below the other
}

TEST_CASE("where nothing will touch all faces count") {
  const Counts all{6 * face_of_cube, 6 * face_of_cube};
  CHECK(Cubes(20, 0, -towards).foretold() == all);
  CHECK(Cubes(20, 50, towards).foretold() == all);
  CHECK(Cubes(20, 0, Vec3::Zero()).foretold() == all);
  CHECK(Cubes(20, 0, towards).foretold(contact::PairRule::automatic, 5.0) == all);  // 15 of 20 flown at the end
}

TEST_CASE("bodies that fly side by side do not meet") {
  Cubes cubes(0.01, 50, towards);
  std::ranges::fill(cubes.velocity, towards);
  CHECK(cubes.foretold() == Counts{6 * face_of_cube, 6 * face_of_cube});
}

TEST_CASE("without a pair that may meet nothing is foretold") {
  CHECK(Cubes(0.01, 0, towards).foretold(contact::PairRule::apart) == Counts{0, 0});
}

TEST_CASE("of two passes both are foretold, but for nodes that will lie on nodes of the other cube") {
  const auto in_two_passes = [](const Cubes& cubes) {
    return cubes.foretold(contact::PairRule::automatic, std::numeric_limits<double>::infinity(), contact::Passes::two);
  };
  CHECK(in_two_passes(Cubes(20, 0.5, towards)) == Counts{face_of_cube, face_of_cube});
  CHECK(in_two_passes(Cubes(20, 0, towards)) == Counts{face_of_cube, 0});
  CHECK(in_two_passes(Cubes(20, 0.005, towards)) == Counts{face_of_cube, 0});
  CHECK(in_two_passes(Cubes(20, 2, towards)) == Counts{16, 8});  // half of the second cube finds no twins
  CHECK(in_two_passes(Cubes(0.005, 0, Vec3::Zero())) == Counts{2 * face_of_cube, face_of_cube});  // sides have none
}
