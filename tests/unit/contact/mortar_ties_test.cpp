// SPDX-License-Identifier: Apache-2.0
// Ties with integrated weights: consistent nodal forces of a uniform traction, exact for linear motions, one row a node
// at a feature edge, and rows that are the gradient of what they keep.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/unit/contact/tied_plates.hpp"

using namespace brunt;
using contact::Row;
using test::TiedPlates;

namespace {

Vec3 linear(const Vec3& x) {
  Mat3 gradient;
  gradient << 0.3, -0.2, 0.5, 0.1, 0.7, -0.4, -0.6, 0.2, 0.1;
  return Vec3(1, -2, 3) + gradient * x;
}

/// A fold of 90 degrees along x = 0.5, through whole facets of both sides if they have an even number.
Vec3 folded(const Vec3& x) {
  return x.x() <= 0.5 ? x : Vec3(0.5 + x.z(), x.y(), 0.5 - x.x());
}

/// What a facet's nodes take of a uniform traction where all of it is covered [length^2].
std::vector<double> consistent_loads(int n) {
  std::vector<double> load;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      load.push_back((i == 0 || i == n ? 0.5 : 1.0) * (j == 0 || j == n ? 0.5 : 1.0) / (n * n));
  return load;
}

}  // namespace

TEST_CASE("ties: a uniform traction loads both sides consistently, linear motions ask for nothing") {
  struct Case {
    int n, m;
    double angle;
  };
  for (const auto [n, m, angle] : {Case{2, 3, 0}, Case{3, 2, 0}, Case{5, 4, 0}, Case{4, 7, 0}, Case{7, 1, 0}}) {
    CAPTURE(n, m, angle);
    TiedPlates plates(n, m, 1, angle, 0);
    CHECK(plates.ties.rows.size() == static_cast<std::size_t>((n + 1) * (n + 1)));
    const std::vector<double> force = plates.forces(), slave = consistent_loads(n), master = consistent_loads(m);
    for (std::size_t k = 0; k < slave.size(); ++k) CHECK(std::abs(force[k] - slave[k]) < 1e-14);
    for (std::size_t k = 0; k < master.size(); ++k) CHECK(std::abs(force[slave.size() + k] + master[k]) < 1e-14);
    for (const Row& row : plates.rows())
      CHECK(relative_velocity(row, [&](LocalIndex node) { return linear(plates.place(node)); }).norm() < 1e-13);
  }
}

TEST_CASE("ties: where the slave hangs over, the load is that of what is covered, in rows that are not alike") {
  struct Case {
    double over;  // of a facet, on each side
    std::size_t rows;
  };
  // of the largest share of a corner the outer ones have .98, .82, .43, .18 on an edge, its square at a corner
  for (const auto [over, rows] : {Case{0.01, 25}, Case{0.1, 25}, Case{0.4, 21}, Case{0.7, 9}}) {
    TiedPlates plates(4, 3, 1 - over / 2, 0, 0);
    CAPTURE(over);
    const std::vector<double> force = plates.forces(), master = consistent_loads(3);
    const double area = (1 - over / 2) * (1 - over / 2);
    for (std::size_t k = 0; k < master.size(); ++k) CHECK(std::abs(force[25 + k] + area * master[k]) < 1e-14);
    double total = 0;
    for (std::size_t k = 0; k < 25; ++k) total += force[k];
    CHECK(std::abs(total - area) < 1e-14);
    CHECK(plates.ties.rows.size() == rows);
    for (const Row& row : plates.rows()) {
      CHECK(relative_velocity(row, [&](LocalIndex node) { return linear(plates.place(node)); }).norm() < 1e-13);
      CHECK(largest_share(row) <= 2);
      CHECK(row.shares()[0] >= 0.1);  // of its own node
    }
  }
}

TEST_CASE("ties: at a feature edge a node has one row, and each side carries its own traction") {
  TiedPlates plates(4, 6, 1, 0, 0, folded);
  CHECK(plates.ties.rows.size() == 25);
  // tractions of 1 on the one side, none on the other: what enters rows of the first side loads nodes of that alone
  std::vector<double> force(plates.gid.size(), 0.0);
  for (std::size_t r = 0; r < plates.ties.rows.size(); ++r) {
    const auto row = static_cast<LocalIndex>(r);
    const Vec3 side = plates.rows()[r].normal;
    CHECK((std::abs(side.z()) > 0.999 || std::abs(side.x()) > 0.999));
    if (std::abs(side.z()) < 0.999) continue;
    const auto nodes = std::as_const(plates.ties.nodes).row(row);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      nth(force, nodes[k]) +=
          plates.ties.rows[r].area * plates.ties.weights[static_cast<std::size_t>(plates.ties.nodes.offsets[r]) + k];
  }
  for (LocalIndex node = 0; node < static_cast<LocalIndex>(force.size()); ++node) {
    const Vec3& x = plates.place(node);
    if (x.z() < -1e-9) CHECK(std::abs(nth(force, node)) < 1e-15);
    const int n = node < plates.slaves ? 4 : 6;
    const double edge =
        (x.x() < 1e-9 || x.x() > 0.5 - 1e-9 ? 0.5 : 1.0) * (x.y() < 1e-9 || x.y() > 1 - 1e-9 ? 0.5 : 1.0);
    if (x.z() > -1e-9) CHECK(std::abs(nth(force, node) - (node < plates.slaves ? 1 : -1) * edge / (n * n)) < 1e-14);
  }
}

TEST_CASE("ties: faces that are inclined by more than 30 degrees, or lie too far off, have none") {
  const auto tilted = [](double degrees) {
    return [degrees](const Vec3& x) {  // the slave turned about the line x = 0.5
      return x.z() > 0 ? Vec3(x.x(), x.y(), x.z() + std::tan(degrees * M_PI / 180) * (x.x() - 0.5)) : x;
    };
  };
  CHECK(TiedPlates(4, 4, 1, 0.3, 1e-3, tilted(20)).ties.rows.size() > 0);
  CHECK(TiedPlates(4, 4, 1, 0.3, 1e-3, tilted(35)).ties.rows.empty());
  CHECK(TiedPlates(4, 4, 1, 0.3, 0.24 / 4).ties.rows.size() > 0);
  CHECK(TiedPlates(4, 4, 1, 0.3, 0.26 / 4).ties.rows.empty());
  CHECK(TiedPlates(8, 4, 1, 0.3, 0.2 / 4).ties.rows.empty());  // of either side's edge
}

namespace {

/// Warped faces across gaps and overlaps, turned and bent after the start.
TiedPlates bent_plates() {
  TiedPlates plates(3, 4, 1.2, 0.4, 0.03, [](const Vec3& x) {
    return Vec3(x.x(), x.y(), x.z() + 0.02 * std::sin(3 * x.x() + (x.z() > 0 ? 1 : 2) * x.y()));
  });
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, -1).normalized());
  double i = 0;
  for (contact::NodeMotion& node : plates.motion) {
    i += 1;
    node.position =
        turn * node.position + Vec3(1, -2, 3) + 0.005 * Vec3(std::sin(3 * i), std::cos(5 * i), std::sin(7 * i));
  }
  return plates;
}

}  // namespace

TEST_CASE("ties: a common turn asks for nothing, and impulses have neither a resultant nor a moment") {
  TiedPlates plates = bent_plates();
  REQUIRE(plates.ties.rows.size() == 16);
  const Vec3 spin(0.3, -1.1, 0.6), speed(2, 1, -4), impulse(0.4, 0.9, -0.7);
  for (const Row& row : plates.rows()) {
    REQUIRE(row.arms.size() == row.points().size());
    CHECK(relative_velocity(row, [&](LocalIndex node) { return Vec3(speed + spin.cross(plates.place(node))); }).norm() <
          1e-13);
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    for (std::size_t i = 0; i < row.points().size(); ++i) {
      const Vec3 share = impulse_on_node(row, i, impulse);
      sum += share;
      moment += plates.place(row.points()[i]).cross(share);
      CHECK(share.norm() <= largest_share(row) * impulse.norm());
    }
    CHECK(sum.norm() < 1e-14);
    CHECK(moment.norm() < 1e-13);
  }
}

TEST_CASE("ties: a row asks for the rate of what it keeps, by differences, and for what has crept") {
  TiedPlates plates = bent_plates();
  constexpr double h = 1e-6;
  const auto velocity = [](LocalIndex node) {
    return Vec3(Vec3(node % 3, node % 2, 2 - node % 4) - Vec3(0.4, 0.1, 0.9));
  };
  const auto crept = [&](double step, std::size_t r) {  // drift and gap after a motion, put together
    TiedPlates moved = plates;
    for (std::size_t i = 0; i < moved.motion.size(); ++i)
      moved.motion[i].position += step * velocity(static_cast<LocalIndex>(i));
    const Row row = moved.rows()[r];
    return Vec3(row.gap * row.normal - 5 * row.drift);
  };
  for (std::size_t r = 0; r < plates.ties.rows.size(); ++r) {
    const Vec3 rate = (crept(h, r) - crept(-h, r)) / (2 * h);
    Row row = plates.rows()[r];
    // the gradient of the kept places; what has crept is turned with the facets besides
    std::vector<contact::Arm> arms(row.arms.begin(), row.arms.end());
    const Vec3 asked = relative_velocity(row, velocity), off = crept(0, r);
    CAPTURE(r, rate.transpose(), asked.transpose(), off.norm());
    CHECK((rate - asked).norm() < 40 * off.norm() + 1e-7);
    CHECK(row.required == Approx(-0.2 * row.gap));
  }
}

TEST_CASE("ties: on a plane of symmetry of both sides a row asks for nothing along its normal") {
  TiedPlates plates(3, 4, 1, 0, 0, [](const Vec3& x) {  // askew inside, so that rows of the plane have nodes beside it
    return Vec3(x.x() + (x.z() > 0 ? 0.2 : -0.1) * x.x() * (1 - x.x()) * x.y() * (1 - x.y()), x.y(), 0);
  });
  const auto hold = [&](LocalIndex first, LocalIndex end) {
    for (LocalIndex node = first; node < end; ++node)
      if (plates.place(node).x() == 0) nth(plates.mobility, node).projector(0, 0) = 0;
  };
  const auto answers = [&](std::size_t r) {  // of a node beside the plane
    const Row row = plates.rows()[r];
    double most = 0;
    for (const LocalIndex point : row.points())
      if (plates.place(point).x() > 0)
        most = std::max(most, std::abs(relative_velocity(row, [&](LocalIndex node) {
                                         return node == point ? Vec3(1, 0, 0) : Vec3(0, 0, 0);
                                       }).x()));
    return most;
  };
  hold(0, plates.slaves);
  for (const std::size_t r : {4u, 8u}) {
    REQUIRE(plates.place(static_cast<LocalIndex>(r)).x() == 0);
    CHECK(answers(r) > 1e-3);  // the master may move: it is tied to the supports
  }
  hold(plates.slaves, static_cast<LocalIndex>(plates.motion.size()));
  const Vec3 impulse(5, 6, 7);
  for (const std::size_t r : {4u, 8u}) {
    CHECK(answers(r) == 0);
    const Row row = plates.rows()[r];
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < row.points().size(); ++i) sum += impulse_on_node(row, i, impulse);
    CHECK(sum.norm() < 1e-14);
    CHECK(std::abs(impulse_on_node(row, 0, impulse).x()) < 1e-14);
    CHECK(std::abs(impulse_on_node(row, 0, impulse).y() - 6) < 1e-14);
  }
}
