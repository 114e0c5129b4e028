// SPDX-License-Identifier: Apache-2.0
#include "support/simulation.hpp"

#include <algorithm>
#include <limits>

#include "app/state/contact_setup.hpp"
#include "app/state/removal.hpp"
#include "mesh/canonical.hpp"
#include "partition/distribute.hpp"
#include "scene/build/build.hpp"
#include "scene/build/select.hpp"
#include "scene/read/read.hpp"
#include "support/tolerances.hpp"
#include "time/erosion.hpp"
#include "time/initialise.hpp"
#include "time/removal.hpp"

namespace brunt::test {
namespace {

std::unique_ptr<contact::Contact> make_contact(const Simulation& simulation, const contact::Rebuild& rebuild) {
  const model::Model& model = simulation.model;
  if (!model.touching.contact.pairs.any_acts() && model.touching.walls.empty()) return nullptr;
  contact::ContactSettings settings;
  settings.specification = model.touching.contact;
  settings.specification.rebuild = rebuild;
  settings.blocks = app::block_properties(model);
  settings.rigid = app::rigid_bodies(model);
  settings.erodes = model.loses_elements();
  settings.detection.recovery_gives = std::ranges::any_of(
      simulation.input.contact, [](const auto& entry) { return entry.initial_overlap == contact::OverlapRule::warn; });
  std::vector<double> inverse_mass;
  for (const model::NodeLine& node : simulation.state.nodes) inverse_mass.push_back(1.0 / node.mass);
  return std::make_unique<contact::Contact>(
      contact::make_contact(simulation.links.ranks, model.mesh, model.touching.in_symmetry_plane, inverse_mass,
                            model.supports.nodes, time::walls_at(model, simulation.state, 0.0), settings));
}

/// With what every scene needs. Mortar contact is of implicit scenes; which scheme it has is up to the test.
std::string completed(const std::string& scene) {
  const bool implicit = scene.find("method: mortar") != std::string::npos;
  return std::string("units: none\nmesh: {file: of_the_test}\nrun: {end: 1}\n") +
         (implicit ? "solver: {scheme: static}\n" : "") + scene;
}

}  // namespace

Simulation::Simulation(mesh::Mesh mesh, const std::string& scene)
    : input(scene::read_scene(completed(scene), "scene of the test")),
      links{comm::Communicator::world(), {}, {}, {}, {}, {}, {}, {}},
      control{input.run.cfl, 1.02, input.run.step.value_or(std::numeric_limits<double>::infinity())} {
  mesh::CanonicalMesh whole = mesh::canonical_order(std::move(mesh));
  scene::select(input, whole);
  std::size_t elements = 0;
  for (const mesh::Block& block : whole.mesh.blocks) elements += static_cast<std::size_t>(block.count());
  const std::vector<std::size_t> part_of = scene::parts_of_blocks(input, whole.mesh);
  model = scene::build_model(input, part_of, partition::distribute(links.ranks, whole, std::vector<Rank>(elements, 0)));
  model.touching.contact.tolerances = &tolerances();
  links = time::link_ranks(links.ranks, model);
  time::initialise(model, state, scratch, links, scene::initial_velocities(input, model),
                   scene::initial_rates(input, model));
  contact = make_contact(*this, {});
}

void Simulation::rebuild_lists(const contact::Rebuild& when) {
  contact = make_contact(*this, when);
}

void Simulation::bound_by_mesh() {
  assembled.baseline = force::sized_baseline(model);
  control.assembled = &assembled;
}

void Simulation::step(std::optional<double> dt) {
  report = time::evaluate(model, state, scratch, links, control);
  if (dt) {
    report.dt = *dt;
    report.dt_mean = 0.5 * (state.dt + *dt);
  }
  const auto gone = [](GlobalIndex count) { return count > 0; };
  bool changed =
      time::removal_is_due(model, state) && std::ranges::any_of(time::remove_elements(links.ranks, model, state), gone);
  std::vector<time::ErosionCount> counts;
  if (time::erode(links.ranks, model, state, scratch, counts)) changed = true;
  if (changed && contact) {
    app::expose(input, model, state, links, *contact);
    contact->births_due = true;
  }
  time::advance(model, state, scratch, links, contact.get(), report);
}

time::Ledger Simulation::ledger() const {
  return time::ledger(model, state, scratch, links, contact.get(), report);
}

void Simulation::displace(std::span<const Vec3> u, double dt) {
  for (LocalIndex i = 0; i < nodes(); ++i) {
    const auto local = static_cast<std::size_t>(i);
    const Vec3& move = u[static_cast<std::size_t>(model.mesh.input_node[local])];
    for (int c = 0; c < 3; ++c) {
      state.displacement[local][c] += move[c];
      state.nodes[local].v[c] = move[c] / dt;
    }
  }
  time::update_positions(model, state);
  state.dt = dt;
  report = time::evaluate(model, state, scratch, links, control);
}

LocalIndex Simulation::node(GlobalIndex input_node) const {
  return static_cast<LocalIndex>(std::ranges::find(model.mesh.input_node, input_node) - model.mesh.input_node.begin());
}

Vec3 Simulation::displacement(LocalIndex i) const {
  const Quad& u = state.displacement[static_cast<std::size_t>(i)];
  return {u[0], u[1], u[2]};
}
Vec3 Simulation::position(LocalIndex i) const {
  return Eigen::Map<const Vec3>(state.nodes[static_cast<std::size_t>(i)].x);
}
Vec3 Simulation::velocity(LocalIndex i) const {
  return Eigen::Map<const Vec3>(state.nodes[static_cast<std::size_t>(i)].v);
}
Vec3 Simulation::force(LocalIndex i) const {
  Quad f = scratch.force[static_cast<std::size_t>(i)];
  if (model.loaded()) f += scratch.load[static_cast<std::size_t>(i)];
  return {f[0], f[1], f[2]};
}

double Simulation::history(std::size_t block, const std::string& field, LocalIndex element, int component) const {
  const model::ElementBlock& of = model.blocks[block];
  const int place = (element / pack_width * of.history_size + of.find(field)->first + component) * pack_width;
  return state.history[block][static_cast<std::size_t>(place + element % pack_width)];
}

Vec3 Simulation::angular_momentum() const {
  Vec3 sum = Vec3::Zero();
  for (LocalIndex i = 0; i < nodes(); ++i) sum += mass(i) * position(i).cross(velocity(i));
  return sum;
}

}  // namespace brunt::test
