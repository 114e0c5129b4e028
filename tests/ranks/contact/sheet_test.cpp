// SPDX-License-Identifier: Apache-2.0
// A two-sided sheet between bodies: held from both sides at half its thickness, pushed back to where they came from,
// the same bits on any number of ranks, whenever lists are made, and over a restart.
#include <catch2/catch.hpp>

#include "contact/contact.hpp"
#include "tests/support/mass_points.hpp"

using namespace brunt;
using contact::Rebuild;
using support::MassPoints;

namespace {

constexpr double dt = 0.01, thickness = 0.1, push = 0.05;

/// A square sheet in the plane z = 0 of 4 x 4 faces, and a small box above it, or on either side, a node over a node;
/// they are `apart` from its surface. Whatever lies below the sheet's upper faces is left out: these are the sheet.
MassPoints pinched_sheet(const comm::Communicator& ranks, double apart, bool from_below = true) {
  mesh::Mesh mesh;
  support::append_box(mesh, {0, 0, -1}, {4, 4, 1}, {4, 4, 1});
  const double height = 0.5 * thickness + apart;
  support::append_box(mesh, {1.3, 1.6, height}, {0.5, 0.5, 0.5}, {1, 1, 1});
  if (from_below) support::append_box(mesh, {1.3, 1.6, -height - 0.5}, {0.5, 0.5, 0.5}, {1, 1, 1});
  MassPoints points(
      ranks, mesh, [&](GlobalIndex gid) { return static_cast<Rank>(gid * 5 % 7 % ranks.size()); },
      [](const Vec3&) { return 1.0; }, [](const Vec3&) { return Vec3(0, 0, 0); });
  std::erase_if(points.mesh.faces, [](const mesh::ExteriorFace& face) { return face.block == 0 && face.key % 8 != 5; });
  return points;
}

contact::ContactSettings settings_with(const Rebuild& rebuild = {}) {
  contact::ContactSettings settings;
  settings.blocks.thickness = {thickness};
  settings.specification.enforcement.tolerance = 1e-10;
  settings.specification.enforcement.max_iterations = 500;
  settings.specification.rebuild = rebuild;
  return settings;
}

/// One of the four nodes of a box that face the sheet.
bool is_pressed(const MassPoints& points, std::size_t n) {
  return points.mesh.node_gid[n] >= 50 && std::abs(points.mesh.coordinates[n].z()) < 0.3;
}
/// +1 for nodes of the upper box, -1 for those of the lower.
double box_side(const MassPoints& points, std::size_t n) {
  return points.mesh.node_gid[n] < 58 ? 1 : -1;
}

void press(MassPoints& points, contact::Contact& contact, int steps) {
  for (int step = 0; step < steps; ++step) {
    for (std::size_t n = 0; n < points.v.size(); ++n)
      if (is_pressed(points, n)) points.v[n].z() -= push * box_side(points, n);
    points.step(contact, dt);
  }
}

/// Impulses of the last step on the slaves of each box [momentum], and how many rows act: edges of the boxes that lie
/// over each other with the sheet between them have open rows.
struct Pinch {
  double above = 0, below = 0;
  GlobalIndex rows = 0;
};
Pinch pinch_of(const MassPoints& points, const contact::Contact& contact) {
  std::vector<double> above, below;
  GlobalIndex rows = 0;
  for (std::size_t q = 0; q < contact.step.rows.size(); ++q) {
    const contact::Row& row = contact.step.rows[q];
    const double impulse = contact.step.impulses[q].z();
    (row.key.slave < 58 ? above : below).push_back(impulse);
    rows += impulse != 0 ? 1 : 0;
  }
  return {comm::exact_sum(points.ranks, above), comm::exact_sum(points.ranks, below), points.ranks.sum(rows)};
}

/// Largest distance of a pressed node from where the sheet's surface should hold it, with the sheet in its plane.
double largest_miss(const MassPoints& points) {
  double miss = 0;
  for (std::size_t n = 0; n < points.x.size(); ++n) {
    if (!is_pressed(points, n)) continue;
    miss = std::max(miss, std::abs(box_side(points, n) * points.x[n].z() - 0.5 * thickness));
  }
  return points.ranks.max(miss);
}

}  // namespace

TEST_CASE("E4: a sheet pinched between two bodies: equal forces, both at half its thickness, no change of sides") {
  const comm::Communicator world = comm::Communicator::world();
  MassPoints points = pinched_sheet(world, 0.02);
  contact::Contact contact = points.make_contact(settings_with());
  CHECK(contact.derived.remembers);
  press(points, contact, 100);
  for (int step = 0; step < 20; ++step) {
    press(points, contact, 1);
    const Pinch pinch = pinch_of(points, contact);
    CHECK(pinch.rows == 8);
    CHECK(pinch.above == Approx(4 * push).epsilon(1e-6));  // all that presses on a box
    CHECK(pinch.below == Approx(-4 * push).epsilon(1e-6));
  }
  CHECK(largest_miss(points) < 1e-8);
  for (const contact::HistoryRecord& record : contact.history.pairs)
    CHECK(record.side == (record.key.slave < 58 ? 1 : -1));
}

namespace {

/// A box is pressed onto a sheet that is held, which is then moved up at once by more than its thickness, so that the
/// box is below its middle. It goes on, with another contact if told so. Velocities of all nodes at the end; miss: see
/// largest_miss.
enum class Restart { none, whole, forgetful };
std::vector<double> overrun(const comm::Communicator& ranks, const Rebuild& rebuild, Restart restart, double* miss) {
  MassPoints points = pinched_sheet(ranks, 0.001, false);
  const auto is_sheet = [&](std::size_t n) { return points.mesh.node_gid[n] < 50; };
  for (std::size_t n = 0; n < points.x.size(); ++n)
    if (is_sheet(n)) points.constrained.push_back({static_cast<LocalIndex>(n), Mat3::Zero()});
  contact::Contact before = points.make_contact(settings_with(rebuild));
  press(points, before, 20);
  for (std::size_t n = 0; n < points.x.size(); ++n)
    if (is_sheet(n)) points.x[n].z() += 1.2 * thickness;
  contact::Contact after = points.make_contact(settings_with(rebuild));
  if (restart == Restart::whole) contact::restore_history(contact::history_tables(before), after);
  contact::Contact& contact = restart == Restart::none ? before : after;
  press(points, contact, 400);
  for (std::size_t n = 0; n < points.x.size(); ++n) points.x[n].z() -= 1.2 * thickness;
  if (miss) *miss = largest_miss(points);
  std::vector<double> all = points.all_velocities();
  CHECK(points.copies_agree(all));
  return all;
}

}  // namespace

TEST_CASE("nodes beyond the middle of a sheet go back to their side, on any ranks, lists, and over a restart") {
  const comm::Communicator world = comm::Communicator::world(), self = comm::Communicator::self();
  double miss = 0;
  const std::vector<double> expected = overrun(self, {}, Restart::none, &miss);
  CHECK(miss < 1e-2 * thickness);
  CHECK(overrun(world, {}, Restart::none, nullptr) == expected);
  CHECK(overrun(world, {.when = Rebuild::When::every, .steps = 1}, Restart::none, nullptr) == expected);
  CHECK(overrun(world, {.when = Rebuild::When::random}, Restart::none, nullptr) == expected);
  CHECK(overrun(world, {}, Restart::whole, nullptr) == expected);
  overrun(world, {}, Restart::forgetful, &miss);
  CHECK(miss >
        0.5 * thickness);  // without its history it holds the nodes on the wrong side: the above proves something
}
