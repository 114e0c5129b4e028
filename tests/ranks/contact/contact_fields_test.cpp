// SPDX-License-Identifier: Apache-2.0
// Gaps and pressures on nodes, for pictures: an even load reads as one pressure, whatever the meshes.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "contact/contact.hpp"
#include "tests/support/mass_points.hpp"

using namespace brunt;
using contact::ContactSettings;
using support::MassPoints;

namespace {

/// A plate of 4 x 3 elements 0.2 over one of 2 x 2, `height` of its nodes by place.
MassPoints plates(const comm::Communicator& ranks, const std::function<double(const Vec3&)>& height) {
  mesh::Mesh mesh;
  support::append_box(mesh, {-1, -1, -1}, {6, 6, 1}, {2, 2, 1});
  support::append_box(mesh, {0, 0, 0}, {4, 3, 1}, {4, 3, 1});
  for (std::size_t n = 18; n < mesh.coordinates.size(); ++n) mesh.coordinates[n].z() += height(mesh.coordinates[n]);
  MassPoints points(
      ranks, mesh, [&](GlobalIndex gid) { return static_cast<Rank>(gid * 5 % 3 % ranks.size()); },
      [](const Vec3&) { return 1.0; }, [](const Vec3&) { return Vec3::Zero(); });
  points.mesh.blocks.resize(2);
  return points;
}

ContactSettings between(contact::Passes passes) {
  ContactSettings settings;
  settings.specification.pairs = contact::PairTable(2, {});
  settings.specification.pairs.set(0, 1, {contact::PairRule::automatic, passes});
  settings.specification.enforcement.tolerance = 1e-12;
  settings.specification.enforcement.max_iterations = 1000;
  settings.specification.enforcement.softness = 0;  // so that one step stops the nodes
  return settings;
}

}  // namespace

TEST_CASE("fields: gaps of the nodes that are near a face, zero elsewhere") {
  const auto height = [](const Vec3& x) { return 0.01 + 0.02 * x.x() + 0.03 * x.y(); };
  MassPoints points = plates(comm::Communicator::world(), height);
  contact::Contact contact = points.make_contact(between(contact::Passes::one));
  points.step(contact, 1e-6);
  const std::vector<double> gap = contact::gaps(contact);
  GlobalIndex near = 0;
  for (std::size_t n = 0; n < gap.size(); ++n) {
    const bool bottom = points.mesh.node_gid[n] >= 18 && points.mesh.node_gid[n] < 18 + 20;
    if (!bottom || points.mesh.owner[n] != points.ranks.rank()) {
      CHECK(gap[n] == 0);
      continue;
    }
    CHECK(gap[n] == Approx(points.mesh.coordinates[n].z()).epsilon(1e-12));
    ++near;
  }
  CHECK(points.ranks.sum(near) == 20);
}

TEST_CASE("fields: nodes stopped by a fixed plate carry their momentum over their area") {
  for (const contact::Passes passes : {contact::Passes::one, contact::Passes::two}) {
    MassPoints points = plates(comm::Communicator::world(), [](const Vec3&) { return 0.0; });
    const auto area_of = [](const Vec3& x) {
      return (x.x() == 0 || x.x() == 4 ? 0.5 : 1.0) * (x.y() == 0 || x.y() == 3 ? 0.5 : 1.0);
    };
    for (std::size_t n = 0; n < points.x.size(); ++n) {
      const Vec3& x = points.mesh.coordinates[n];
      if (points.mesh.node_gid[n] < 18) {
        points.constrained.push_back({static_cast<LocalIndex>(n), Mat3::Zero()});
      } else if (x.z() == 0) {
        points.v[n].z() = -2;
        points.inverse_mass[n] = 1 / area_of(x);
      }
    }
    contact::Contact contact = points.make_contact(between(passes));
    constexpr double dt = 1e-3;
    points.step(contact, dt);
    const std::vector<double> pressure = contact::pressures(contact, dt);
    GlobalIndex loaded = 0;
    for (const double p : pressure) {
      if (p == 0) continue;
      CHECK(p == Approx(2 / dt).epsilon(1e-9));
      ++loaded;
    }
    CHECK(points.ranks.sum(loaded) == 20);
    for (const double p : contact::pressures(contact, 0)) CHECK(p == 0);
  }
}
