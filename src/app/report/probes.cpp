// SPDX-License-Identifier: Apache-2.0
#include "probes.hpp"

#include <algorithm>

#include "body_probes.hpp"
#include "comm/exact_sum.hpp"
#include "implicit/static_forces.hpp"
#include "implicit_probes.hpp"
#include "joint_probes.hpp"
#include "rotation_probes.hpp"
#include "scene/build/select.hpp"

namespace brunt::app {
namespace {

using scene::Probe;

bool is_moment(const Probe& probe) {
  return probe.field == "moment" || probe.field == "reaction_moment";
}

bool is_force(const Probe& probe) {
  return probe.kind == Probe::Kind::wall || probe.kind == Probe::Kind::contact || probe.field == "reaction" ||
         probe.field == "force" || is_moment(probe);
}

/// One number of a joint at t_n.
bool is_joint_place(const Probe& probe) {
  return probe.field == "angle" || probe.field == "gap";
}

/// Sums over the elements of a part.
bool is_sum(const Probe& probe) {
  return probe.field == "mass" || probe.field == "center" || probe.field == "momentum" ||
         probe.field == "angular_momentum" || probe.field == "energy";
}

/// Of two units; none where the system has no names.
std::string product(const std::string& one, const std::string& other) {
  return one.empty() ? "" : one + '.' + other;
}

/// Calls visit(node) for the nodes of the probe that this rank owns.
template <class Visit>
void for_owned(const Prepared& run, std::size_t probe, Visit&& visit) {
  const auto& nodes = run.model.mesh.node_sets.at(scene::selection_name("probe", probe));
  for (const LocalIndex node : nodes)
    if (std::ranges::binary_search(run.model.owned, node)) visit(static_cast<std::size_t>(node));
}

/// Mean over the nodes, each with its mass as weight: the motion of their centre of mass.
Vec3 mean_motion(const Prepared& run, std::size_t index) {
  const Probe& probe = run.input.probes[index];
  std::array<comm::ExactAccumulator, 4> sums;
  for_owned(run, index, [&](std::size_t i) {
    const model::NodeLine& node = run.state.nodes[i];
    for (std::size_t c = 0; c < 3; ++c) {
      const auto k = static_cast<int>(c);
      const double value = probe.field == "velocity"       ? node.v[c]
                           : probe.field == "displacement" ? run.state.displacement[i][k]
                                                           : node.x[c] + run.model.mesh.origin[k];
      sums[c].add(node.mass * value);
    }
    sums[3].add(node.mass);
  });
  std::array<double, 4> value{};
  comm::exact_sum(run.links.ranks, sums, value);
  return Vec3(value[0], value[1], value[2]) / value[3];
}

/// Exact sum of of_node(node) over the nodes of the probe.
template <class OfNode>
Vec3 sum_over_nodes(const Prepared& run, std::size_t index, const OfNode& of_node) {
  std::array<comm::ExactAccumulator, 3> sums;
  if (run.model.supports.any)
    for_owned(run, index, [&](std::size_t i) {
      const Vec3 value = of_node(i);
      for (std::size_t c = 0; c < 3; ++c) sums[c].add(value[static_cast<int>(c)]);
    });
  std::array<double, 3> value{};
  comm::exact_sum(run.links.ranks, sums, value);
  return {value[0], value[1], value[2]};
}

Vec3 reaction_impulse(const Prepared& run, std::size_t index) {
  return sum_over_nodes(run, index, [&](std::size_t i) { return Vec3(&run.state.reaction_impulse[3 * i]); });
}

std::size_t wall_of(const Prepared& run, const std::string& name) {
  return static_cast<std::size_t>(std::ranges::find(run.model.touching.walls, name, &model::RigidWall::name) -
                                  run.model.touching.walls.begin());
}

/// Of any probe of a force except contact, at t_n.
Vec3 static_force(Prepared& run, std::size_t index, const std::optional<std::size_t>& body) {
  const Probe& probe = run.input.probes[index];
  if (probe.kind == Probe::Kind::wall) return Vec3(&run.implicit->walls.force[3 * wall_of(run, probe.where)]);
  if (body) return static_body_force(run, *body, probe.field);
  return sum_over_nodes(run, index,
                        [&](std::size_t i) { return implicit::support_force(run.model, *run.implicit, i); });
}

/// Nothing where no two bodies of the scene may touch.
contact::TrackedTotals tracked_totals(const Prepared& run, const contact::ContactTotals& totals, const Probe& probe) {
  if (run.implicit) return watched_contact(run, probe.where, probe.other);
  const auto tracked = std::ranges::find(run.tracked, std::array{probe.where, probe.other});
  if (tracked == run.tracked.end()) return {};
  return nth(totals.tracked, tracked - run.tracked.begin());
}

/// Impulses on the two sides cancel then: sizes alone are told.
bool is_with_itself(const Probe& probe) {
  return probe.where == probe.other;
}

std::vector<std::string> force_components(const Probe& probe) {
  std::vector<std::string> components;
  if (!is_with_itself(probe)) components = {"x", "y", "z"};
  if (probe.kind != Probe::Kind::contact) return components;
  if (!is_with_itself(probe))
    components.insert(components.end(), {"normal_x", "normal_y", "normal_z", "friction_x", "friction_y", "friction_z"});
  components.insert(components.end(), {"normal", "friction"});
  return components;
}

}  // namespace

Probes::Probes(const Prepared& run, const scene::UnitSystem& units)
    : motion_(run.input.probes.size(), Vec3::Zero()),
      moment_(motion_.size(), Vec3::Zero()),
      part_(motion_.size()),
      section_(motion_.size()),
      body_(motion_.size()) {
  for (std::size_t k = 0; k < motion_.size(); ++k) {
    const Probe& probe = run.input.probes[k];
    if (is_sum(probe)) part_[k] = nodes_of_part(run, probe.where);
    if (probe.kind == Probe::Kind::part) body_[k] = body_of_part(run.model, probe.where);
    if (probe.kind == Probe::Kind::section) section_[k] = find_section(run, k);
    keeps_velocity_ = keeps_velocity_ || probe.field == "energy";
    add_columns(probe, units);
  }
}

void Probes::add_columns(const Probe& probe, const scene::UnitSystem& units) {
  const auto vector = [&](const std::string& prefix, const std::string& unit) {
    for (const char* component : {"x", "y", "z"}) columns_.push_back({prefix + probe.name + '.' + component, unit});
  };
  if (probe.field == "mass") {
    columns_.push_back({probe.name + ".mass", units.mass});
  } else if (probe.field == "energy") {
    for (const char* term : {".kinetic", ".internal", ".hourglass", ".bulk"})
      columns_.push_back({probe.name + term, units.energy});
  } else if (is_joint_place(probe)) {
    const bool angle = probe.field == "angle";
    columns_.push_back({probe.name + '.' + probe.field, !angle ? units.length : units.length.empty() ? "" : "rad"});
  } else if (probe.kind == Probe::Kind::section) {
    vector("", units.force);
    vector("moment_", product(units.force, units.length));
  } else if (is_force(probe)) {
    const bool moment = is_moment(probe);
    for (const std::string& component : force_components(probe)) {
      columns_.push_back({probe.name + '.' + component, moment ? product(units.force, units.length) : units.force});
      columns_.push_back(
          {"impulse_" + probe.name + '.' + component, moment ? product(units.momentum, units.length) : units.momentum});
    }
  } else {
    vector("", probe.field == "velocity"           ? units.velocity
               : probe.field == "rotation"         ? (units.length.empty() ? "" : "rad")
               : probe.field == "angular_velocity" ? (units.time.empty() ? "" : "rad/" + units.time)
               : probe.field == "momentum"         ? units.momentum
               : probe.field == "angular_momentum" ? product(units.momentum, units.length)
                                                   : units.length);
  }
}

void Probes::read_motion(const Prepared& run) {
  for (std::size_t k = 0; k < motion_.size(); ++k) {
    const Probe& probe = run.input.probes[k];
    if (probe.kind == Probe::Kind::section) {
      const auto [force, moment] = section_force(run, section_[k]);
      motion_[k] = force;
      moment_[k] = moment;
    } else if (is_joint_place(probe)) {
      motion_[k][0] = joint_place(run, joint_of(run.model, probe.where), probe.field);
    } else if (probe.field == "center") {
      motion_[k] = body_[k] ? body_part_center(run, *body_[k]) : part_center(run, part_[k]);
    } else if (!is_force(probe) && !is_sum(probe)) {
      motion_[k] = body_[k]                       ? body_motion(run, *body_[k], probe.field)
                   : is_rotation_of_nodes(run, k) ? mean_rotation(run, k)
                                                  : mean_motion(run, k);
    }
  }
  if (!keeps_velocity_) return;
  before_.resize(run.state.nodes.size());
  for (std::size_t i = 0; i < before_.size(); ++i) before_[i] = Eigen::Map<const Vec3>(run.state.nodes[i].v);
}

std::vector<double> Probes::values(Prepared& run, const contact::ContactTotals& totals, double dt_mean) {
  std::vector<double> row;
  const auto add = [&](const Vec3& value) { row.insert(row.end(), value.begin(), value.end()); };
  for (std::size_t k = 0; k < motion_.size(); ++k) {
    const Probe& probe = run.input.probes[k];
    if (is_force(probe)) {
      add_force(run, totals, k, row);
    } else if (is_joint_place(probe)) {
      row.push_back(motion_[k][0]);
    } else if (probe.field == "mass") {
      row.push_back(body_[k] ? run.model.bodies[*body_[k]].own.mass : part_mass(run, part_[k]));
    } else if (probe.field == "energy") {
      PartEnergy energy = body_[k] ? body_part_energy(run, *body_[k]) : part_energy(run, part_[k], before_, dt_mean);
      if (shows_static_states(run)) energy.kinetic = 0;
      row.insert(row.end(), {energy.kinetic, energy.internal, energy.hourglass, energy.bulk});
    } else if (shows_static_states(run) && (probe.field == "momentum" || probe.field == "angular_momentum")) {
      add(Vec3::Zero());
    } else if (probe.field == "momentum") {
      add(body_[k] ? body_part_momentum(run, *body_[k]) : part_momentum(run, part_[k]));
    } else if (probe.field == "angular_momentum") {
      const Vec3 about = probe.about.value_or(Vec3::Zero());
      add(body_[k] ? body_part_angular_momentum(run, *body_[k], about) : part_angular_momentum(run, part_[k], about));
    } else {
      add(motion_[k]);
      if (probe.kind == Probe::Kind::section) add(moment_[k]);
    }
  }
  return row;
}

void Probes::add_force(Prepared& run, const contact::ContactTotals& totals, std::size_t probe,
                       std::vector<double>& row) const {
  const Probe& watched = run.input.probes[probe];
  double* memory = &run.force_memory[4 * probe];
  const double passed = run.state.time - memory[3];
  memory[3] = run.state.time;
  const bool at_time = shows_static_states(run);
  const auto add = [&](double total, double last, double now) {
    row.insert(row.end(), {at_time ? now : passed > 0 ? (total - last) / passed : 0.0, total});
  };
  const auto add_vector = [&](const Vec3& total, const Vec3& last, const Vec3& now) {
    for (int c = 0; c < 3; ++c) add(total[c], last[c], now[c]);
  };
  Eigen::Map<Vec3> last(memory);
  if (watched.kind != Probe::Kind::contact) {
    const Vec3 total = watched.kind == Probe::Kind::wall ? totals.wall_impulse[wall_of(run, watched.where)]
                       : watched.kind == Probe::Kind::joint
                           ? joint_impulse(run, joint_of(run.model, watched.where), watched.field)
                       : body_[probe]       ? body_impulse(run, *body_[probe], watched.field)
                       : is_moment(watched) ? rotation_reaction(run, probe)
                                            : reaction_impulse(run, probe);
    add_vector(total, last, at_time ? static_force(run, probe, body_[probe]) : Vec3(Vec3::Zero()));
    last = total;
    return;
  }
  const contact::TrackedTotals total = tracked_totals(run, totals, watched);
  double* parts = &run.contact_memory[contact_memory_width * probe];
  Eigen::Map<Vec3> last_friction(parts);
  const contact::TrackedTotals now =
      at_time ? watched_contact_now(run, watched.where, watched.other) : contact::TrackedTotals();
  if (!is_with_itself(watched)) {
    add_vector(total.impulse, last, now.impulse);
    add_vector(total.impulse - total.friction, last - last_friction, now.impulse - now.friction);
    add_vector(total.friction, last_friction, now.friction);
  }
  add(total.normal_size, parts[3], now.normal_size);
  add(total.friction_size, parts[4], now.friction_size);
  last = total.impulse;
  last_friction = total.friction;
  parts[3] = total.normal_size;
  parts[4] = total.friction_size;
}

}  // namespace brunt::app
