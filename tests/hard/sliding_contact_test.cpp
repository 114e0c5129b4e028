// SPDX-License-Identifier: Apache-2.0
// Contact that lasts: sliding over facets, settling in a groove, a body on itself.
#include <catch2/catch.hpp>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "mesh/assemble.hpp"
#include "mesh/primitives.hpp"
#include "support/mass_points.hpp"
#include "support/simulation.hpp"

using namespace brunt;
using support::MassPoints;
using test::Simulation;

namespace {

void number(mesh::Mesh& mesh) {
  for (std::size_t n = 0; n < mesh.coordinates.size(); ++n) mesh.node_id.push_back(static_cast<GlobalIndex>(n + 1));
  GlobalIndex elements = 0;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    mesh.blocks[b].id = static_cast<GlobalIndex>(b + 1);
    for (LocalIndex e = 0; e < mesh.blocks[b].count(); ++e) mesh.blocks[b].element_id.push_back(++elements);
  }
}

/// A hex8 from its section in the x-z plane (counter-clockwise seen against y), from y = low to high.
void append_prism(mesh::Mesh& mesh, const std::array<std::array<double, 2>, 4>& section, double low, double high,
                  const std::string& name) {
  mesh::Block block;
  block.name = name;
  for (const double y : {high, low})
    for (const auto& [x, z] : section) {
      block.nodes.push_back(static_cast<LocalIndex>(mesh.coordinates.size()));
      mesh.coordinates.emplace_back(x, y, z);
    }
  mesh.blocks.push_back(block);
}

const std::string soft = "materials: {m: {model: elastic, density: 1, young: 1000, poisson: 0.3}}\n";

}  // namespace

TEST_CASE("a wedge of 30 degrees falls into a groove of 60 degrees and settles at its bottom", "[oracle]") {
  const double slope = std::tan(std::numbers::pi / 6), sharp = std::tan(std::numbers::pi / 12);
  constexpr double size = 0.2;  // of the wedge: its element's longest edge
  for (const double aside : {0.0, 1e-9, 0.02, -0.05}) {
    CAPTURE(aside);
    mesh::Mesh mesh;
    append_prism(mesh, {{{0, 0}, {0, -1}, {1, -1}, {slope, 1}}}, 0, 1, "groove");
    const std::vector<LocalIndex> right = mesh.blocks[0].nodes;
    append_prism(mesh, {{{0, 0}, {-slope, 1}, {-1, -1}, {0, -1}}}, 0, 1, "groove");
    mesh::Block left = mesh.blocks[1];
    mesh.blocks.pop_back();
    for (const auto& [own, other] : {std::pair(0, 0), std::pair(3, 1)})  // the halves share the plane x = 0
      for (const int layer : {0, 4})
        left.nodes[static_cast<std::size_t>(own + layer)] = right[static_cast<std::size_t>(other + layer)];
    mesh.blocks[0].nodes.insert(mesh.blocks[0].nodes.end(), left.nodes.begin(), left.nodes.end());
    std::vector<LocalIndex> number_of(mesh.coordinates.size(), no_index);  // without the nodes left over
    std::vector<Vec3> kept;
    for (LocalIndex& node : mesh.blocks[0].nodes) {
      LocalIndex& to = number_of[static_cast<std::size_t>(node)];
      if (to == no_index) {
        to = static_cast<LocalIndex>(kept.size());
        kept.push_back(mesh.coordinates[static_cast<std::size_t>(node)]);
      }
      node = to;
    }
    mesh.coordinates = kept;
    const double z = 0.15, half = 0.5 * size;
    const auto bottom = static_cast<GlobalIndex>(mesh.coordinates.size());
    append_prism(mesh,
                 {{{aside, z}, {aside + half * sharp, z + half}, {aside, z + size}, {aside - half * sharp, z + half}}},
                 0.4, 0.6, "wedge");
    number(mesh);
    Simulation scene(std::move(mesh), soft +
                                          "parts: {groove: {material: m}, wedge: {material: m}}\n"
                                          "fixed: [{part: groove, dofs: [x, y, z]}]\n"
                                          "gravity: {vector: [0, 0, -10]}\ndamping: {alpha: 10}\n"
                                          "contact: [{between: all, tolerance: 1.0e-8, max_iterations: 1000}]\n");
    int switches = 0;
    double force = 0, square = 0, count = 0, weight = 0;  // at rest: sums over steps of what holds the wedge up
    for (GlobalIndex n = bottom; n < bottom + 8; ++n) weight += 10 * scene.mass(scene.node(n));
    std::set<GlobalIndex> faces_before;
    while (scene.state.time < 4) {
      scene.step();
      std::set<GlobalIndex> faces;
      const LocalIndex lowest = scene.node(bottom);
      const GlobalIndex gid = scene.model.mesh.node_gid[static_cast<std::size_t>(lowest)];
      for (std::size_t q = 0; q < scene.contact->step.rows.size(); ++q)
        if (scene.contact->step.rows[q].key.slave == gid && !scene.contact->step.impulses[q].isZero(0))
          faces.insert(scene.contact->step.rows[q].key.master);
      if (scene.state.time > 2) {
        double up = 0;
        for (std::size_t q = 0; q < scene.contact->step.rows.size(); ++q)
          up += scene.contact->step.impulses[q].z() / scene.report.dt_mean;
        force += up;
        square += up * up;
        ++count;
        switches += static_cast<int>(faces != faces_before);
      }
      faces_before = faces;
    }
    const Vec3 end = scene.position(scene.node(bottom));
    CHECK(std::abs(end.x()) <= 1e-3 * size);
    CHECK(std::abs(end.z()) <= 1e-3 * size);
    CHECK(switches == 0);
    CHECK(force / count == Approx(weight).epsilon(0.01));
    CHECK(std::sqrt(std::max(0.0, square / count - force / count * force / count)) <= 0.05 * weight);
  }
}

TEST_CASE("small bodies slide over a faceted valley of facets ten times their size", "[oracle]") {
  // 20 facets, bent by 3 degrees from one to the next; unit length each; the small cube is 0.1
  mesh::Mesh mesh;
  support::append_box(mesh, {0, 0, 0}, {20, 1, 1}, {20, 1, 1});
  std::vector<Vec3> top{Vec3(0, 0, 0)};
  for (int i = 0; i < 20; ++i) {
    const double angle = (-30 + 3 * (i + 0.5)) * std::numbers::pi / 180;
    top.push_back(top.back() + Vec3(std::cos(angle), 0, std::sin(angle)));
  }
  for (Vec3& x : mesh.coordinates) {
    const Vec3 crest = top[static_cast<std::size_t>(std::lround(x.x()))];
    x = Vec3(crest.x(), x.y(), crest.z() + x.z() - 1);
  }
  const double start = 5.3;  // of arc: the middle of a facet
  const Vec3 at = top[5] + (start - 5) * (top[6] - top[5]);
  support::append_box(mesh, at + Vec3(0, 0.31, 0.05), {0.1, 0.1, 0.1}, {1, 1, 1});
  const comm::Communicator self = comm::Communicator::self();
  MassPoints points(
      self, mesh, [](GlobalIndex) { return 0; }, [](const Vec3& x) { return x.y() > 0.2 && x.y() < 0.5 ? 1.0 : 1e9; },
      [](const Vec3& x) {
        return x.y() > 0.2 && x.y() < 0.5 ? 3 * Vec3(std::cos(0.35), 0, -std::sin(0.35)) : Vec3(0, 0, 0);
      });
  contact::Contact contact = points.make_contact({});
  constexpr double dt = 1e-3;
  std::map<GlobalIndex, std::vector<GlobalIndex>> ridden;  // faces in turn, by slave
  const Vec3 momentum = points.momentum();
  std::vector<double> force;  // on the cube's foot
  for (int step = 0; step < 2500; ++step) {
    points.step(contact, dt);
    force.push_back(0);
    for (std::size_t q = 0; q < contact.step.rows.size(); ++q) {
      const contact::Row& row = contact.step.rows[q];
      if (contact.step.impulses[q].isZero(0)) continue;
      if (row.key.slave < 88) force.back() += contact.step.impulses[q].dot(row.normal) / dt;
      auto& faces = ridden[row.key.slave];
      if (faces.empty() || faces.back() != row.key.master) faces.push_back(row.key.master);
    }
  }
  CHECK((points.momentum() - momentum).norm() <= 1e-13 * 24);

  // smoothed over the time that two facets take, it is that of a round valley: all four nodes turn by 3 degrees a
  // facet. (Over one facet the noise is 9 %: facets in turn are entered by one jump or by ten small ones.)
  const double speed = 3, turn = 3 * std::numbers::pi / 180;
  const auto window = static_cast<std::size_t>(std::lround(2 / (speed * dt)));
  const auto smoothed = [&](const std::vector<double>& values) {
    std::vector<double> means;
    for (std::size_t first = 0; first + window <= values.size(); ++first)
      means.push_back(std::accumulate(&values[first], &values[first] + window, 0.0) / static_cast<double>(window));
    return means;
  };
  force.erase(force.begin(), force.begin() + 300);  // until it has landed
  const std::vector<double> smooth = smoothed(force);
  const double count = static_cast<double>(smooth.size());
  const double mean = std::accumulate(smooth.begin(), smooth.end(), 0.0) / count;
  const double square = std::inner_product(smooth.begin(), smooth.end(), smooth.begin(), 0.0) / count;
  const double noise = std::sqrt(std::max(0.0, square - mean * mean));
  CAPTURE(mean, noise);
  CHECK(mean == Approx(4 * speed * speed * turn).epsilon(0.05));
  CHECK(noise <= 0.05 * mean);

  for (GlobalIndex gid = 84; gid < 88; ++gid) {  // the small cube's foot; its head is held by nothing but contact
    const std::vector<GlobalIndex>& faces = ridden[gid];
    const std::set<GlobalIndex> different(faces.begin(), faces.end());
    CAPTURE(gid, faces.size(), different.size());
    CHECK(different.size() >= 4);
    CHECK(faces.size() == different.size());  // each facet once: no going back and forth
  }
}

TEST_CASE("a C whose arms are thrown at each other closes and does not pass through itself", "[law]") {
  mesh::Mesh mesh;
  support::append_box(mesh, {0, 0, 0}, {6, 2, 5}, {6, 2, 5});
  std::vector<LocalIndex> kept;
  for (LocalIndex e = 0; e < mesh.blocks[0].count(); ++e)
    if (const int layer = e / 12; layer == 0 || layer == 4 || e % 6 < 2)
      kept.insert(kept.end(), mesh.blocks[0].element(e), mesh.blocks[0].element(e) + 8);
  mesh.blocks[0].nodes = kept;
  std::map<LocalIndex, LocalIndex> to;
  std::vector<Vec3> coordinates;
  for (LocalIndex& node : mesh.blocks[0].nodes) {
    const auto [found, is_new] = to.insert({node, static_cast<LocalIndex>(coordinates.size())});
    if (is_new) coordinates.push_back(mesh.coordinates[static_cast<std::size_t>(node)]);
    node = found->second;
  }
  for (Vec3& x : coordinates)  // the slot is narrow: 0.1 high
    x.z() = x.z() <= 1 ? x.z() : (x.z() >= 4 ? x.z() - 2.9 : 1 + (x.z() - 1) / 30);
  mesh.coordinates = coordinates;
  number(mesh);
  Simulation scene(std::move(mesh),
                   "materials: {m: {model: elastic, density: 1, young: 1000, poisson: 0.3}}\n"
                   "parts: {box0: {material: m}}\n"
                   "sets: {upper: {part: box0, box: [[2.5, -1, 1.05], [7, 3, 9]]}}\n"
                   "initial: [{set: upper, velocity: [0, 0, -2]}]\ncontact: [{between: all}]\n");
  std::vector<LocalIndex> over;
  for (LocalIndex n = 0; n < scene.nodes(); ++n) {
    const Vec3 x = scene.model.mesh.coordinates[static_cast<std::size_t>(n)];
    if (std::abs(x.z() - 1.1) < 1e-9 && x.x() > 2.5) over.push_back(n);
  }
  REQUIRE(over.size() == 12);
  double least = 1, active = 0;
  for (int step = 0; step < 600; ++step) {
    scene.step();
    active = std::max(active, static_cast<double>(contact::collect(*scene.contact).active));
    for (const LocalIndex upper : over)
      for (LocalIndex n = 0; n < scene.nodes(); ++n) {
        const Vec3 x = scene.model.mesh.coordinates[static_cast<std::size_t>(n)];
        const Vec3 above = scene.model.mesh.coordinates[static_cast<std::size_t>(upper)];
        if (x.z() == 1 && (x - above).head<2>().norm() < 1e-9)  // its opposite, and both move little sideways
          least = std::min(least, scene.position(upper).z() - scene.position(n).z());
      }
  }
  CHECK(active > 0);
  CHECK(least < 0.01);
  CHECK(least > -0.01);
}
