// SPDX-License-Identifier: Apache-2.0
// Contact that remembers: the same bits on any number of ranks, whenever lists are made, and over a restart.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <numbers>

#include "contact/contact.hpp"
#include "tests/support/mass_points.hpp"

using namespace brunt;
using contact::ContactSettings;
using contact::HistoryTables;
using contact::Rebuild;
using support::MassPoints;

namespace {

constexpr double dt = 0.01;

Rank by_stripes(GlobalIndex gid, int ranks) {
  return static_cast<Rank>((gid / 3 * 7 + gid % 2) % ranks);
}

/// Turns the nodes from `first` on by 45 degrees around an axis through a point.
void turn(mesh::Mesh& mesh, std::size_t first, const Vec3& axis, const Vec3& point) {
  const Eigen::AngleAxisd rotation(0.25 * std::numbers::pi, axis);
  for (std::size_t n = first; n < mesh.coordinates.size(); ++n)
    mesh.coordinates[n] = point + rotation * (mesh.coordinates[n] - point);
}

/// A fine plate that is pressed onto a coarse one again and again, askew, and slides; a wall below; a bar that lies
/// with one of its edges on that of another, across it.
MassPoints pressed_plates(const comm::Communicator& ranks) {
  mesh::Mesh mesh;
  support::append_box(mesh, {0, 0, 0}, {4, 4, 1}, {4, 4, 1});
  support::append_box(mesh, {0.3, 0.2, 1.01}, {3.1, 3.3, 0.5}, {7, 8, 1});
  std::size_t first = mesh.coordinates.size();
  support::append_box(mesh, {10, 1, 1}, {3, 0.5, 0.5}, {1, 1, 1});
  turn(mesh, first, Vec3::UnitX(), {10, 1.25, 1.25});
  first = mesh.coordinates.size();
  support::append_box(mesh, {11, 0, 1.01 + std::sqrt(0.5)}, {0.5, 3, 0.5}, {1, 1, 1});
  turn(mesh, first, Vec3::UnitY(), {11.25, 0, 1.26 + std::sqrt(0.5)});
  MassPoints points(
      ranks, mesh, [&](GlobalIndex gid) { return by_stripes(gid, ranks.size()); },
      [](const Vec3& x) { return 1 + 0.3 * std::sin(3 * x.x() + 5 * x.y() + x.z()); },
      [](const Vec3& x) { return x.z() > (x.x() < 9 ? 1 : 1.61) ? Vec3(0.3, -0.2, -1) : Vec3(0, 0, -0.5); });
  points.walls = {{.point = Vec3(0, 0, -0.03), .normal = Vec3::UnitZ()}};
  return points;
}

void press(MassPoints& points, contact::Contact& contact, int steps) {
  for (int step = 0; step < steps; ++step) {
    for (std::size_t n = 0; n < points.v.size(); ++n) points.v[n].z() -= 0.1 * (points.mesh.coordinates[n].z() + 0.2);
    points.step(contact, dt);
  }
}

std::vector<double> run(const comm::Communicator& ranks, const Rebuild& rebuild) {
  MassPoints points = pressed_plates(ranks);
  ContactSettings settings;
  settings.specification.enforcement.warm_start = true;
  settings.specification.rebuild = rebuild;
  contact::Contact contact = points.make_contact(settings);
  press(points, contact, 30);
  std::vector<double> all = points.all_velocities();
  CHECK(points.copies_agree(all));
  return all;
}

/// The tables of all ranks together, as each rank sees them.
HistoryTables gathered(const comm::Communicator& ranks, const HistoryTables& mine) {
  HistoryTables all = mine;
  const auto append = [&](auto& whole, const auto& part) {
    using Value = typename std::decay_t<decltype(part)>::value_type;
    whole.clear();
    std::vector<std::byte> bytes;
    for (Rank r = 0; r < ranks.size(); ++r) {
      const auto raw = std::as_bytes(std::span(part));
      bytes.assign(raw.begin(), raw.end());
      ranks.broadcast(bytes, r);
      const auto* first = reinterpret_cast<const Value*>(bytes.data());
      whole.insert(whole.end(), first, first + bytes.size() / sizeof(Value));
    }
  };
  for (std::size_t t = 0; t < all.size(); ++t) {
    append(all[t].keys, mine[t].keys);
    append(all[t].values, mine[t].values);
  }
  return all;
}

}  // namespace

TEST_CASE("a warm start has the same bits on any number of ranks and whenever lists are made") {
  const std::vector<double> expected = run(comm::Communicator::self(), {});
  const comm::Communicator world = comm::Communicator::world();
  CHECK(run(world, {}) == expected);
  CHECK(run(world, {.when = Rebuild::When::every, .steps = 1}) == expected);
  CHECK(run(world, {.when = Rebuild::When::every, .steps = 7}) == expected);
  CHECK(run(world, {.when = Rebuild::When::random}) == expected);
}

TEST_CASE("a warm start needs fewer iterations and ends at the same tolerance") {
  const comm::Communicator world = comm::Communicator::world();
  GlobalIndex iterations[2]{};
  for (const bool warm : {false, true}) {
    MassPoints points = pressed_plates(world);
    ContactSettings settings;
    settings.specification.enforcement.warm_start = warm;
    settings.specification.enforcement.max_iterations = 1000;
    contact::Contact contact = points.make_contact(settings);
    CHECK(contact.derived.remembers == warm);
    press(points, contact, 30);
    CHECK(contact.ledger.statistics.largest_residual <= settings.specification.enforcement.tolerance);
    iterations[warm ? 1 : 0] = contact.ledger.statistics.iterations;
    if (!warm) CHECK(contact.history.pairs.empty());
  }
  CAPTURE(iterations[0], iterations[1]);
  CHECK(10 * iterations[1] < 9 * iterations[0]);  // 472 of 573 when this was written
}

TEST_CASE("the history goes home: on all ranks, on one, and the run goes on to the same bits") {
  const comm::Communicator world = comm::Communicator::world(), self = comm::Communicator::self();
  ContactSettings settings;
  settings.specification.enforcement.warm_start = true;
  MassPoints points = pressed_plates(world);
  contact::Contact contact = points.make_contact(settings);
  press(points, contact, 20);
  const HistoryTables kept = contact::history_tables(contact), whole = gathered(world, kept);
  CHECK(whole[0].rows() == world.sum(kept[0].rows()));
  bool face = false, wall = false, edge = false;
  for (std::size_t k = 0; k < whole[0].keys.size(); k += 4) {
    const bool is_edge = whole[0].keys[k + 1] != no_index;
    edge = edge || is_edge;
    wall = wall || whole[0].keys[k + 2] < 0;
    face = face || (!is_edge && whole[0].keys[k + 2] >= 0);
  }
  CHECK((face && wall && edge));  // all kinds of rows have acted

  // another contact gets what lies on the wrong ranks: the root has it all
  MassPoints again = pressed_plates(world);
  again.x = points.x;
  again.v = points.v;
  again.walls = points.walls;
  contact::Contact resumed = again.make_contact(settings);
  HistoryTables given = world.is_root() ? whole : kept;
  if (!world.is_root())
    for (RecordTable& table : given) {
      table.keys.clear();
      table.values.clear();
    }
  contact::restore_history(given, resumed);
  for (std::size_t t = 0; t < kept.size(); ++t) {
    CHECK(contact::history_tables(resumed)[t].keys == kept[t].keys);
    CHECK(contact::history_tables(resumed)[t].values == kept[t].values);
  }
  press(points, contact, 10);
  press(again, resumed, 10);
  const std::vector<double> expected = points.all_velocities();
  CHECK(again.all_velocities() == expected);

  // and a contact that forgets goes elsewhere: the restart proves something
  MassPoints amnesiac = pressed_plates(self);
  contact::Contact fresh = amnesiac.make_contact(settings);
  press(amnesiac, fresh, 20);
  contact::restore_history(contact::HistoryTables{{{.name = "", .key_width = 4},
                                                   {.name = "", .key_width = 5},
                                                   {.name = "", .key_width = 4},
                                                   {.name = "", .key_width = 4}}},
                           fresh);
  press(amnesiac, fresh, 10);
  CHECK(amnesiac.all_velocities() != expected);
}
