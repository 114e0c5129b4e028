// SPDX-License-Identifier: Apache-2.0
// What contact books is what the bodies lose and gain: energy, halves of it, momentum, angular momentum.
#include <Eigen/Geometry>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "contact/contact.hpp"
#include "tests/support/mass_points.hpp"

using namespace brunt;
using contact::ContactSettings;
using support::MassPoints;

namespace {

constexpr double dt = 0.005;

/// A plate comes down askew on another and slides.
MassPoints plates(const comm::Communicator& ranks) {
  mesh::Mesh mesh;
  support::append_box(mesh, {0, 0, 0}, {4, 4, 1}, {4, 4, 1});
  support::append_box(mesh, {0.3, 0.2, 1.02}, {3.1, 3.3, 0.5}, {5, 5, 1});
  MassPoints points(
      ranks, mesh, [&](GlobalIndex gid) { return static_cast<Rank>((gid / 3 * 7 + gid % 2) % ranks.size()); },
      [](const Vec3& x) { return 1 + 0.3 * std::sin(3 * x.x() + 5 * x.y() + x.z()); },
      [](const Vec3& x) { return x.z() > 1.01 ? Vec3(0.5, -0.2, -1 - 0.2 * x.x()) : Vec3(0, 0, 0.1 * x.y()); });
  points.mesh.blocks.resize(2);
  return points;
}

ContactSettings rough() {
  ContactSettings settings;
  settings.specification.pairs = contact::PairTable(2, {});
  settings.specification.pairs.set(0, 1, {.rule = contact::PairRule::automatic, .friction = {0.3, 0.3, 0}});
  settings.tracked = {{0, 1}, {1, 0}, {0}, {0, 0}};
  return settings;
}

Vec3 sum_of(const MassPoints& points, const std::function<Vec3(std::size_t)>& term) {
  Vec3 sum;
  for (int c = 0; c < 3; ++c) sum[c] = points.sum_of_owned([&](std::size_t n) { return term(n)[c]; });
  return sum;
}

/// Of both plates, or of the nodes of one block's box alone.
Vec3 momentum_of(const MassPoints& points, bool upper) {
  return sum_of(points, [&](std::size_t n) {
    return (points.mesh.coordinates[n].z() > 1.01) == upper ? Vec3(points.v[n] / points.inverse_mass[n]) : Vec3::Zero();
  });
}

Vec3 angular_momentum(const MassPoints& points) {
  return sum_of(points, [&](std::size_t n) { return Vec3(points.x[n].cross(points.v[n]) / points.inverse_mass[n]); });
}

}  // namespace

TEST_CASE("ledger: tracked impulses are the momentum of either side, and its turn is the spin that is booked") {
  MassPoints points = plates(comm::Communicator::world());
  contact::Contact contact = points.make_contact(rough());
  const Vec3 lower = momentum_of(points, false), spin = angular_momentum(points);
  for (int step = 0; step < 40; ++step) points.step(contact, dt);
  const contact::ContactTotals totals = contact::collect(contact);
  REQUIRE(totals.tracked.size() == 4);
  const Vec3 given = momentum_of(points, false) - lower;
  CHECK(given.norm() > 1);
  CHECK((totals.tracked[0].impulse - given).norm() <= 1e-12 * given.norm());
  CHECK(totals.tracked[0].impulse == -totals.tracked[1].impulse);
  CHECK(totals.tracked[2].impulse == totals.tracked[0].impulse);  // there is no other block
  CHECK(totals.tracked[2].friction == totals.tracked[0].friction);
  CHECK(totals.tracked[0].friction.norm() > 1e-3 * given.norm());
  CHECK(totals.tracked[0].friction_size <= 0.3 * totals.tracked[0].normal_size * (1 + 1e-12));
  CHECK(totals.tracked[3].normal_size == 0);  // plates do not fold
  const Vec3 turned = angular_momentum(points) - spin;
  CHECK(turned.norm() > 1e-6);  // friction acts a gap apart
  CHECK((totals.spin - turned).norm() <= 1e-11 * spin.norm());
  CHECK(totals.push >= given.norm());  // what the spin is measured by: sizes, not sums
}

TEST_CASE("ledger: work on bodies and walls is the energy they lose, in halves too") {
  MassPoints points = plates(comm::Communicator::world());
  points.walls = {{.point = Vec3(0, 0, -0.01), .normal = Vec3::UnitZ(), .friction = {0.2, 0.2, 0}}};
  for (std::size_t n = 0; n < points.x.size(); ++n)
    if (points.x[n].z() == 0) points.v[n] = Vec3(0.2, 0, -0.3);  // free mass points: what presses above stops there
  contact::Contact contact = points.make_contact(rough());
  const double start = points.kinetic();
  double before = start, booked = 0;
  for (int step = 0; step < 40; ++step) {
    const std::vector<Vec3> old = points.v;
    points.step(contact, dt);
    const contact::ContactTotals totals = contact::collect(contact);
    const double work = totals.contact_work + totals.friction_work + totals.wall_work;
    contact::WorkSums late;
    contact::add_second_half(contact, late);
    std::array sums{late.contact, late.friction, late.walls};
    std::array<double, 3> halves{};
    comm::exact_sum(points.ranks, sums, halves);
    const double second = halves[0] + halves[1] + halves[2];
    // 1/2 v- . m v+ has had the first half of the step's impulses
    const double half_way =
        points.sum_of_owned([&](std::size_t n) { return 0.5 * old[n].dot(points.v[n]) / points.inverse_mass[n]; });
    CHECK(std::abs(before - half_way - (work - booked - second)) <= 1e-12 * start);
    before = points.kinetic();
    booked = work;
  }
  const contact::ContactTotals totals = contact::collect(contact);
  CHECK(totals.friction_work > 0);
  CHECK(totals.wall_work > 0);
  CHECK(booked == Approx(start - points.kinetic()).epsilon(1e-12));
}

TEST_CASE("ledger: the impulses of the last step are what its nodes were given, held ones too") {
  MassPoints points = plates(comm::Communicator::world());
  for (std::size_t n = 0; n < points.x.size(); ++n)
    if (points.mesh.coordinates[n].z() == 1) {
      Mat3 free = Mat3::Identity();
      free(2, 2) = 0;
      points.constrained.push_back({static_cast<LocalIndex>(n), free});
      points.v[n].z() = 0;
    }
  contact::Contact contact = points.make_contact(rough());
  Vec3 total = Vec3::Zero();
  double held = 0;
  for (int step = 0; step < 20; ++step) {
    const std::vector<Vec3> old = points.v;
    points.step(contact, dt);
    std::vector<Vec3> impulse(points.x.size(), Vec3::Zero());
    contact::add_impulses(contact, impulse);
    for (std::size_t n = 0; n < impulse.size(); ++n) {
      if (points.mesh.owner[n] != points.ranks.rank()) {
        CHECK(impulse[n].isZero(0));
        continue;
      }
      Vec3 taken = impulse[n] * points.inverse_mass[n];
      if (points.mesh.coordinates[n].z() == 1) {
        held += std::abs(taken.z());
        taken.z() = 0;
      }
      CHECK((points.v[n] - old[n] - taken).norm() <= 1e-14);
    }
    total += sum_of(points, [&](std::size_t n) { return impulse[n]; });
  }
  held = comm::exact_sum(points.ranks, std::array{held});
  CHECK(held > 1);
  CHECK(total.norm() <= 1e-12 * held);
}
