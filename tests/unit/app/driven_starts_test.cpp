// SPDX-License-Identifier: Apache-2.0
// Entries of `prescribed` that do not start with the velocity of `initial`: where the two differ most.
#include "app/start/driven_starts.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "prepared_scene.hpp"

using namespace brunt;

namespace {

support::PreparedScene driven_box(const std::string& model, const std::string& prescribed) {
  return support::PreparedScene(fmt::format(
      "units: none\nmesh: {{box: {{part: b, size: [2, 2, 2], elements: [2, 2, 2]}}}}\nmaterials: {{m: {{{}}}}}\n"
      "parts: {{b: {{material: m}}}}\n"
      "initial: [{{part: b, velocity: [0, 0, 4], rotation: {{axis: [0, 0, 1], point: [1, 1, 1], rate: 3}}}}]\n"
      "prescribed: [{}]\nrun: {{end: 1, step: 1.0e-3}}\n",
      model, prescribed));
}

const std::string elastic_box = "model: elastic, density: 1, young: 1, poisson: 0";
const std::string rigid_box = "model: rigid, density: 1";

/// Of a scene whose nodes have the velocity of(node, how many there are).
template <class Of>
std::vector<std::string> lines_where(const support::PreparedScene& scene, Of of) {
  std::vector<Vec3> velocity;
  const std::size_t count = scene.run->state.nodes.size();
  for (std::size_t i = 0; i < count; ++i) velocity.push_back(of(i, count));
  return app::driven_starts(*scene.run, velocity);
}

}  // namespace

TEST_CASE("driven starts: the node with the largest difference speaks for its entry, of two the faster one") {
  const support::PreparedScene scene = driven_box(elastic_box, "{part: b, dof: x, velocity: 1}");
  const auto at = [&](std::size_t fast, double speed) {
    return lines_where(scene, [=](std::size_t i, std::size_t) { return Vec3(i == fast ? speed : 1.5, 0, 0); });
  };
  for (const std::size_t fast : {std::size_t{0}, std::size_t{13}, std::size_t{26}}) {
    REQUIRE(at(fast, -6).size() == 1);
    CHECK_THAT(at(fast, -6)[0],
               Catch::Contains("prescribed.0: 'b' starts with the velocity of its prescribed motion in "
                               "x at t = 0, 1, not with -6 of initial"));
    // 4 more than the prescribed one, and 4 less elsewhere: the same line, wherever the nodes are
    const auto both = lines_where(scene, [=](std::size_t i, std::size_t) { return Vec3(i == fast ? 5 : -3, 0, 0); });
    CHECK_THAT(both.at(0), Catch::Contains("not with 5 of initial"));
    const auto swapped = lines_where(scene, [=](std::size_t i, std::size_t) { return Vec3(i == fast ? -3 : 5, 0, 0); });
    CHECK(both == swapped);
  }
}

TEST_CASE("driven starts: speeds that differ by rounding, and nodes at rest, are no difference") {
  const support::PreparedScene scene =
      driven_box(elastic_box, "{part: b, dof: x, velocity: 2}, {part: b, dof: y, velocity: 3}");
  const auto line = [&](const Vec3& v) { return lines_where(scene, [&](std::size_t, std::size_t) { return v; }); };
  CHECK(line({2 * (1 + 5e-7), 3, 0}).empty());
  CHECK(line({0, 0, 0}).empty());
  CHECK(line({0, 3, 8}).empty());
  CHECK(line({2.001, 3, 0}).size() == 1);
  const std::vector<std::string> both = line({1, -3, 0});
  REQUIRE(both.size() == 2);
  CHECK_THAT(both[0], Catch::Contains("prescribed.0: ") && Catch::EndsWith("in x at t = 0, 2, not with 1 of initial"));
  CHECK_THAT(both[1], Catch::Contains("prescribed.1: ") && Catch::EndsWith("in y at t = 0, 3, not with -3 of initial"));
}

TEST_CASE("driven starts: of a rigid body the velocity of its centre, and its rotation") {
  const support::PreparedScene scene = driven_box(rigid_box,
                                                  "{part: b, dof: x, velocity: 1}, {part: b, dof: z, velocity: 5}, "
                                                  "{part: b, dof: rz, velocity: -2}, {part: b, dof: ry, velocity: 9}");
  const std::vector<std::string> lines =
      lines_where(scene, [](std::size_t, std::size_t) { return Vec3(Vec3::Zero()); });
  REQUIRE(lines.size() == 2);  // the centre is at rest along x, and nothing turns about y
  CHECK_THAT(lines[0], Catch::Contains("prescribed.1: ") && Catch::EndsWith("in z at t = 0, 5, not with 4 of initial"));
  CHECK_THAT(lines[1],
             Catch::Contains("prescribed.2: ") && Catch::EndsWith("in rz at t = 0, -2, not with 3 of initial"));
}
