// SPDX-License-Identifier: Apache-2.0
#include "contact_setup.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "scene/build/build.hpp"
#include "time/step.hpp"

namespace brunt::app {
namespace {

/// The contacts that probes watch.
void track_contacts(Prepared& run, contact::ContactSettings& settings) {
  const auto block_of = [&](const std::string& part) {
    const auto found = std::ranges::find(run.model.blocks, part, &model::ElementBlock::part);
    return static_cast<std::int32_t>(found - run.model.blocks.begin());
  };
  for (const scene::Probe& probe : run.input.probes)
    if (probe.kind == scene::Probe::Kind::contact) {
      run.tracked.push_back({probe.where, probe.other});
      contact::TrackedContact tracked{block_of(probe.where)};
      if (!probe.other.empty()) tracked.other = block_of(probe.other);
      settings.tracked.push_back(tracked);
    }
}

/// How many nodes each tied pair has, among the notes of the start; none at all is a fault of the scene.
void report_ties(Prepared& run) {
  const auto [nodes, beside] = contact::tied_nodes(*run.contact);
  const contact::PairTable& pairs = run.model.touching.contact.pairs;
  const auto n = static_cast<std::int32_t>(run.model.blocks.size());
  if (nodes.empty()) return;
  std::vector<std::string> faults;
  const auto part_of = [&](std::int32_t block) -> const std::string& { return nth(run.model.blocks, block).part; };
  for (std::int32_t a = 0; a < n; ++a)
    for (std::int32_t b = a; b < n; ++b) {
      if (pairs.at(a, b).tied == contact::Tied::no) continue;
      const std::string &one = part_of(a), &other = part_of(b);
      const std::size_t ab = pairs.place(a, b), ba = pairs.place(b, a);
      const GlobalIndex there = nodes[ab], back = a == b ? 0 : nodes[ba];
      if (there + back == 0)
        faults.push_back(
            fmt::format("{}: invalid tie of {} and {}: no slave node is near a face of the other part; expected parts "
                        "that meet within a quarter of the face's edge and half of its element",
                        run.input.at(scene::contact_key(run.input, one, other) + ".tied"), one, other));
      const auto tell = [&](GlobalIndex tied, GlobalIndex left, const std::string& slave, const std::string& master) {
        if (tied + left == 0) return;
        std::string line = fmt::format("tied: {} nodes of {} to {}", tied, slave, master);
        if (left > 0) line += fmt::format("; {} nearby are not tied, since they lie beside its faces", left);
        run.overlaps.report.notes.push_back(std::move(line));
      };
      tell(there, beside[ab], one, other);
      if (a != b) tell(back, beside[ba], other, one);
    }
  if (!faults.empty()) throw InputError(std::move(faults));
}

/// Calls visit(accumulator) for each sum in a fixed order.
template <class Visit>
void for_each_sum(contact::ContactSums& sums, Visit&& visit) {
  for (comm::ExactAccumulator* sum :
       {&sums.work.contact, &sums.work.friction, &sums.work.walls, &sums.work.ties, &sums.work.driven})
    visit(*sum);
  for (comm::ExactAccumulator& component : sums.spin) visit(component);
  visit(sums.push);
  for (auto& vector : sums.wall_impulse)
    for (comm::ExactAccumulator& component : vector) visit(component);
  for (contact::TrackedSums& tracked : sums.tracked) {
    for (auto* vector : {&tracked.impulse, &tracked.friction})
      for (comm::ExactAccumulator& component : *vector) visit(component);
    visit(tracked.normal_size);
    visit(tracked.friction_size);
  }
}

/// Shortest side of the box that has the body's mass and inertia; infinite where its inertia is given [length].
double thickness_of(const model::RigidBody& body) {
  if (body.given.inertia) return std::numeric_limits<double>::infinity();
  Eigen::SelfAdjointEigenSolver<Mat3> solver;
  solver.computeDirect(body.own.inertia, Eigen::EigenvaluesOnly);
  const Vec3 inertia = solver.eigenvalues();  // ascending; about its shortest side a box has the largest one
  return std::sqrt(6 * std::max(0.0, inertia[0] + inertia[1] - inertia[2]) / body.own.mass);
}

/// Shortest side of each body at the start: of the box around it, or of the one above [length]. Collective.
std::vector<double> extents_of_bodies(const comm::Communicator& ranks, const model::Model& model) {
  std::vector<double> far(6 * model.bodies.size(), -std::numeric_limits<double>::infinity()), extents;
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    for (const LocalIndex node : model.bodies[b].nodes)
      for (std::size_t c = 0; c < 3; ++c) {
        const double x = nth(model.reference, node)[static_cast<int>(c)];
        far[6 * b + c] = std::max(far[6 * b + c], x);
        far[6 * b + 3 + c] = std::max(far[6 * b + 3 + c], -x);
      }
  ranks.max(far);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const double* const side = &far[6 * b];
    extents.push_back(
        std::min({side[0] + side[3], side[1] + side[4], side[2] + side[5], thickness_of(model.bodies[b])}));
  }
  return extents;
}

}  // namespace

double speed_of_sound(const model::ElementBlock& block) {
  if (material::is_rigid(block.law)) return std::numeric_limits<double>::infinity();
  const material::ElasticModuli moduli = material::initial_moduli(block.law);
  return std::sqrt((moduli.lambda + 2 * moduli.mu) / moduli.density);
}

contact::BlockProperties block_properties(const model::Model& model) {
  contact::BlockProperties blocks;
  for (const model::ElementBlock& block : model.blocks) {
    blocks.sound.push_back(speed_of_sound(block));
    blocks.impedance.push_back(blocks.sound.back() * material::initial_moduli(block.law).density);
  }
  return blocks;
}

contact::RigidBodies rigid_bodies(const model::Model& model) {
  contact::RigidBodies bodies{.count = model.bodies.size()};
  bodies.squeezed =
      !model.supports.drives.empty() || std::ranges::any_of(model.touching.walls, &model::RigidWall::moves);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    bodies.supported = bodies.supported || model.bodies[b].support.any();
    for (const LocalIndex node : model.bodies[b].nodes) bodies.nodes.push_back({node, static_cast<LocalIndex>(b)});
  }
  return bodies;
}

std::vector<double> inverse_masses(const model::State& state) {
  std::vector<double> inverse;
  for (const model::NodeLine& node : state.nodes) inverse.push_back(1.0 / node.mass);
  return inverse;
}

void make_contact(Prepared& run) {
  const model::Model& model = run.model;
  if (!model.touching.contact.pairs.any_acts() && model.touching.walls.empty()) return;
  contact::ContactSettings settings;
  settings.specification = model.touching.contact;
  settings.search = run.input.search;
  settings.blocks = block_properties(model);
  settings.detection.accepted = run.overlaps.accepted;
  settings.detection.recovery_gives = run.overlaps.recovered;
  settings.wall_pressures =
      std::ranges::find(run.input.output.fields, "contact_pressure") != run.input.output.fields.end();
  track_contacts(run, settings);

  const std::vector<contact::Wall> walls = time::walls_at(model, run.state, 0.0);
  settings.rigid = rigid_bodies(model);
  settings.rigid.extent = extents_of_bodies(run.links.ranks, model);
  settings.erodes = model.loses_elements();
  run.contact = std::make_unique<contact::Contact>(
      contact::make_contact(run.links.ranks, model.mesh, model.touching.in_symmetry_plane, inverse_masses(run.state),
                            model.supports.nodes, walls, settings));
  report_ties(run);
}

bool bounded_by_mesh(const scene::Input& input) {
  return input.run.step_bound == scene::StepBound::assembled && !input.implicit;
}

time::StepControl step_control(Prepared& run) {
  constexpr double growth = 1.02;
  const double factor = run.contact ? contact::step_factor(run.model.touching.contact.enforcement) : 1.0;
  // before the run only static states are sought, whose elements may change by much in a step
  const bool assembled = bounded_by_mesh(run.input) && run.state.relaxation.under_way == 0;
  return {run.input.run.cfl * factor, growth, run.input.run.step.value_or(std::numeric_limits<double>::infinity()),
          assembled ? &run.assembled : nullptr};
}

std::vector<double> save_sums(const comm::Communicator& ranks, contact::Contact& contact) {
  std::vector<GlobalIndex> limbs;
  for_each_sum(contact.ledger.sums, [&](comm::ExactAccumulator& sum) {
    const std::span<std::int64_t> raw = sum.raw();
    limbs.insert(limbs.end(), raw.begin(), raw.end());
  });
  ranks.sum(limbs);
  // carried over once more, the limbs depend on the sum alone and not on how the ranks had it split
  std::vector<double> saved;
  for (std::size_t first = 0; first < limbs.size(); first += comm::ExactAccumulator::limbs + 1) {
    comm::ExactAccumulator whole;
    const std::span<std::int64_t> raw = whole.raw();
    std::copy_n(limbs.begin() + static_cast<std::ptrdiff_t>(first), raw.size(), raw.begin());
    for (const std::int64_t limb : whole.raw()) saved.push_back(static_cast<double>(limb));
  }
  saved.push_back(ranks.max(contact.ledger.sums.penetration));
  return saved;
}

void restore_sums(const comm::Communicator& ranks, const std::vector<double>& saved, contact::Contact& contact) {
  std::size_t next = 0;
  for_each_sum(contact.ledger.sums, [&](comm::ExactAccumulator& sum) {
    sum.clear();
    for (std::int64_t& limb : sum.raw()) {
      demand(next < saved.size(), "the sums of contact in a checkpoint are complete");
      limb = ranks.is_root() ? static_cast<std::int64_t>(saved[next]) : 0;
      ++next;
    }
  });
  demand(next + 1 == saved.size(), "the sums of contact in a checkpoint are of this scene");
  contact.ledger.sums.penetration = saved[next];
}

}  // namespace brunt::app
