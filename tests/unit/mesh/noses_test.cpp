// SPDX-License-Identifier: Apache-2.0
// Noses and sectors: one body, volumes that converge to the exact ones, surfaces where they belong, shapes.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "body_quality.hpp"
#include "core/error.hpp"
#include "mesh/check.hpp"
#include "mesh/round_bodies.hpp"
#include "mesh/topology.hpp"

using namespace brunt;
using namespace brunt::mesh;

namespace {

constexpr double pi = std::numbers::pi;

RoundForm with_nose(const Nose& nose, const Half& half = {}) {
  RoundForm form(half);
  form.nose = nose;
  return form;
}

RoundForm sector(double from, double to, const Nose& nose = {}) {
  RoundForm form;
  form.sector = {from, to};
  form.nose = nose;
  return form;
}

/// Least scaled Jacobian with 8 elements across the radius, of cylinders and of sectors: a few hundredths below ours.
struct Case {
  const char* name;
  Nose nose;
  double whole, sector;
};
const std::vector<Case> noses{
    {"hemisphere", {.shape = Nose::Shape::hemisphere}, 0.65, 0.8},
    {"cone of 45 degrees", {.shape = Nose::Shape::cone, .length = 2}, 0.48, 0.6},
    {"cone of 30 degrees", {.shape = Nose::Shape::cone, .length = 3.46}, 0.24, 0.48},
    {"cone with a flat tip", {.shape = Nose::Shape::cone, .length = 3, .tip_radius = 0.5}, 0.75, 0.84},
    {"ogive of crh 3", {.shape = Nose::Shape::ogive, .crh = 3}, 0.26, 0.5},
    {"ogive with a flat tip", {.shape = Nose::Shape::ogive, .crh = 2, .tip_radius = 0.4}, 0.75, 0.78},
    {"chamfer", {.shape = Nose::Shape::cone, .length = 0.2, .tip_radius = 1.8}, 0.65, 0.68}};

void require_sound(const Mesh& mesh) {
  const CheckReport report = check(mesh);
  REQUIRE(report.faults.empty());
  REQUIRE(report.warnings.empty());
  for (const std::int32_t body : bodies(mesh)) REQUIRE(body == 0);
}

/// Each exterior side is in one of these sets, and in no two.
void require_covered(const Mesh& mesh, const std::vector<std::string>& names) {
  std::vector<Side> all;
  for (const std::string& name : names) {
    const auto& sides = mesh.side_sets.at("b_" + name);
    CHECK(!sides.empty());
    all.insert(all.end(), sides.begin(), sides.end());
  }
  std::sort(all.begin(), all.end());
  CHECK(all == exterior_sides(mesh));
}

double volume_error(const Mesh& mesh, const Moments& exact) {
  return std::abs(moments(mesh).volume / exact.volume - 1);
}

}  // namespace

TEST_CASE("volume and centre of noses are those of closed forms", "[primitives]") {
  const double shank = pi * 4 * 3;
  const auto volume = [&](const Nose& nose) { return exact_tube(0, 2, 3, with_nose(nose)).volume - shank; };
  CHECK(volume(noses[0].nose) == Approx(2 * pi / 3 * 8).epsilon(1e-6));
  CHECK(volume(noses[1].nose) == Approx(pi / 3 * 4 * 2).epsilon(1e-9));
  CHECK(volume(noses[3].nose) == Approx(pi / 3 * 3 * (4 + 1 + 0.25)).epsilon(1e-9));
  const double arc = 12, off = arc - 2, length = std::sqrt(arc * arc - off * off);
  CHECK(length == Approx(2 * std::sqrt(4 * 3 - 1)));
  CHECK(volume(noses[4].nose) == Approx(pi * ((arc * arc + off * off) * length - length * length * length / 3 -
                                              off * (length * off + arc * arc * std::asin(length / arc))))
                                     .epsilon(1e-6));
  const Moments ball = exact_tube(0, 2, 3, with_nose(noses[0].nose, {1, 1, 0}));
  const double half = 2 * pi / 3 * 8;
  CHECK(ball.volume == Approx((shank + half) / 4).epsilon(1e-6));
  CHECK(ball.centre[2] == Approx((shank * 1.5 + half * 3.75) / (shank + half)).epsilon(1e-6));
  CHECK(ball.centre[0] == Approx((shank * 8 / (3 * pi) + half * 0.75) / (shank + half)).epsilon(1e-6));
  const Moments wedge = exact_tube(0, 2, 3, sector(10, 40));
  CHECK(wedge.volume == Approx(shank / 12));
  CHECK(wedge.centre.head<2>().norm() == Approx(2.0 / 3 * 2 * std::sin(pi / 12) / (pi / 12)));
  CHECK(std::atan2(wedge.centre[1], wedge.centre[0]) == Approx(25 * pi / 180));
}

TEST_CASE("cylinders with noses are one body whose volume converges", "[primitives]") {
  for (const auto& [name, nose, whole, narrow] : noses)
    for (const Half& half : {Half{}, Half{1, 0, 0}, Half{-1, 1, 0}}) {
      INFO(name << ' ' << half[0] << ' ' << half[1]);
      const RoundForm form = with_nose(nose, half);
      const Mesh coarse = cylinder("b", 2, 3, {8, 6}, form), fine = cylinder("b", 2, 3, {16, 12}, form);
      require_sound(coarse);
      CHECK(worst_shape(coarse) > whole);
      std::vector<std::string> sets{"bottom", "side", "nose"};
      if (half[0] != 0) sets.emplace_back(half[0] > 0 ? "xmin" : "xmax");
      if (half[1] != 0) sets.emplace_back("ymin");
      require_covered(coarse, sets);
      CHECK(coarse.node_sets.contains("b_top") == (nose.tip_radius > 0));
      const Moments exact = exact_tube(0, 2, 3, form);
      CHECK(volume_error(coarse, exact) < 0.012);
      CHECK(volume_error(fine, exact) < 0.35 * volume_error(coarse, exact));
      CHECK(cylinder("b", 2, 3, {8, 6}, form).blocks[0].nodes == coarse.blocks[0].nodes);
      if (half[0] != 0)
        CHECK(4 * coarse.blocks[0].count() ==
              (half[1] != 0 ? 1 : 2) * cylinder("b", 2, 3, {8, 6}, with_nose(nose)).blocks[0].count());
    }
}

TEST_CASE("nodes of a nose lie on its outline", "[primitives]") {
  for (const RoundForm& form : {with_nose(noses[0].nose), sector(0, 5, noses[0].nose)}) {
    const Mesh mesh = form.sector.cuts() ? tube("b", 0, 2, 3, {8, 1, 4}, form) : cylinder("b", 2, 3, {8, 4}, form);
    for (const LocalIndex node : mesh.node_sets.at("b_nose"))
      CHECK((mesh.coordinates[static_cast<std::size_t>(node)] - Vec3(0, 0, 3)).norm() == Approx(2).epsilon(1e-12));
  }
  const Mesh mesh = cylinder("b", 2, 3, {8, 4}, with_nose(noses[2].nose));
  for (const LocalIndex node : mesh.node_sets.at("b_nose")) {
    const Vec3& x = mesh.coordinates[static_cast<std::size_t>(node)];
    CHECK(x.head<2>().norm() / 2 + (x[2] - 3) / 3.46 == Approx(1).epsilon(1e-12));
  }
}

TEST_CASE("sectors lie between their planes, solid or not", "[primitives]") {
  for (const auto& [name, nose, whole, narrow] : noses)
    for (const double inner : {0.0, 0.1})
      for (const auto& [from, to, around] : {std::tuple{0.0, 5.0, 1}, {-100.0, -93.0, 2}, {30.0, 120.0, 12}}) {
        if (nose.tip_radius > 0 && nose.tip_radius <= inner) continue;
        INFO(name << ' ' << inner << ' ' << from << ' ' << to);
        const RoundForm form = sector(from, to, nose);
        const Mesh mesh = tube("b", inner, 2, 3, {8, around, 6}, form);
        require_sound(mesh);
        CHECK(worst_shape(mesh) > narrow);
        std::vector<std::string> sets{"bottom", "side", "nose", "from", "to"};
        if (inner > 0) sets.emplace_back("inner");
        require_covered(mesh, sets);
        CHECK(mesh.side_sets.at("b_from").size() * static_cast<std::size_t>(around) ==
              static_cast<std::size_t>(mesh.blocks[0].count()));
        for (const auto& [set, angle] : {std::pair{"b_from", from}, {"b_to", to}})
          for (const LocalIndex node : mesh.node_sets.at(set)) {
            const Vec3& x = mesh.coordinates[static_cast<std::size_t>(node)];
            CHECK(std::abs(std::cos(angle * pi / 180) * x[1] - std::sin(angle * pi / 180) * x[0]) < 1e-14);
          }
        const Moments exact = exact_tube(inner, 2, 3, form);
        const double error = volume_error(mesh, exact);
        CHECK(error < 0.01);
        CHECK(volume_error(tube("b", inner, 2, 3, {16, 2 * around, 12}, form), exact) < 0.3 * error);
      }
}

TEST_CASE("the axis nodes of a solid sector are in both of its planes", "[primitives]") {
  const Mesh mesh = tube("b", 0, 2, 3, {4, 2, 6}, sector(0, 10));
  const auto& from = mesh.node_sets.at("b_from");
  const auto& to = mesh.node_sets.at("b_to");
  for (LocalIndex n = 0; n < static_cast<LocalIndex>(mesh.coordinates.size()); ++n) {
    const bool on_axis = mesh.coordinates[static_cast<std::size_t>(n)].head<2>().norm() == 0;
    const bool both = std::ranges::count(from, n) == 1 && std::ranges::count(to, n) == 1;
    CHECK(on_axis == both);
  }
  CHECK(moments(mesh).volume == Approx(0.5 * 2 * 4 * std::sin(5 * pi / 180) * 3));
}

TEST_CASE("a cylinder of graded elements takes a nose on all its nodes", "[primitives]") {
  Divisions<2> elements{1, 4};
  elements[0] = by_sizes({{1, 0.25}, {2, 0.5}}, 0, 2);
  const Mesh mesh = cylinder("b", 2, 3, elements, with_nose(noses[0].nose, {1, 1, 0}));
  require_sound(mesh);
  require_covered(mesh, {"bottom", "side", "nose", "xmin", "ymin"});
  CHECK(worst_shape(mesh) > 0.4);
}

TEST_CASE("noses of strongly graded sectors keep their shape", "[primitives]") {
  for (const auto& [name, nose, whole, narrow] : noses)
    for (const auto& sizes : {std::vector<SizeAt>{{0.4, 0.4}, {1.2, 0.2}, {1.6, 0.1}}, {{0, 0.05}, {2, 0.3}}}) {
      INFO(name);
      Divisions<3> elements{1, 1, 6};
      elements[0] = by_sizes(sizes, 0, 2);
      const Mesh mesh = tube("b", 0, 2, 3, elements, sector(0, 5, nose));
      require_sound(mesh);
      CHECK(worst_shape(mesh) > 0.3);
    }
}

TEST_CASE("wrong noses and sectors are named", "[primitives]") {
  CHECK_THROWS_WITH(cylinder("b", 2, 3, {8, 4}, sector(0, 5)), Catch::Contains("tube with inner_radius 0"));
  CHECK_THROWS_WITH(tube("b", 0, 2, 3, {8, 8, 4}), Catch::Contains("out of range: inner_radius is"));
  CHECK_THROWS_WITH(tube("b", 0, 2, 3, {8, 8, 4}, sector(5, 0)),
                    Catch::Contains("the sector from 5 to 0 degrees; expected an angle > 0 and < 360"));
  CHECK_THROWS_WITH(cylinder("b", 2, 3, {8, 4}, with_nose({.shape = Nose::Shape::cone})),
                    Catch::Contains("out of range: length of the nose is"));
  CHECK_THROWS_WITH(cylinder("b", 2, 3, {8, 4}, with_nose({.shape = Nose::Shape::ogive, .crh = 0.4})),
                    Catch::Contains("expected at least 0.5"));
  CHECK_THROWS_WITH(cylinder("b", 2, 3, {8, 4}, with_nose({.shape = Nose::Shape::cone, .length = 1, .tip_radius = 2})),
                    Catch::Contains("tip_radius is 2; expected a number >"));
}
