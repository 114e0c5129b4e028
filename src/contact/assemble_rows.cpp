// SPDX-License-Identifier: Apache-2.0
#include "assemble_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/anchors/friction.hpp"
#include "contact/data/tolerances.hpp"
#include "contact/surface/passes.hpp"
#include "slave.hpp"

namespace brunt::contact {
namespace {

/// For a node of several blocks, the largest friction coefficient applies.
FrictionLaw friction_of(const Contact& contact, const Row& row, std::span<const Wall> walls) {
  if (row.is_wall()) return nth(walls, row.key.master).friction;
  const PairTable& pairs = contact.settings.specification.pairs;
  const auto law_of = [&](std::int32_t slave) { return pairs.at(slave, row.master_block).friction; };
  if (row.is_edge()) return law_of(row.slave_block);
  FrictionLaw roughest;
  for (const std::int32_t block : blocks_of_slave(contact, row))
    if (const FrictionLaw law = law_of(block); law.fixed > roughest.fixed) roughest = law;
  return roughest;
}

bool has_coincident_node(const Row& row, std::span<const NodeMotion> motion_of, const DetectionSettings& settings) {
  const auto motion = [&](LocalIndex node) { return nth(motion_of, node); };
  return std::any_of(row.nodes.begin() + 1, row.nodes.begin() + row.node_count,
                     [&](LocalIndex node) { return are_coincident(motion(row.nodes[0]), motion(node), settings); });
}

GlobalIndex lowest_gid_of_master(const Contact& contact, const Row& row) {
  GlobalIndex lowest = std::numeric_limits<GlobalIndex>::max();
  for (std::size_t i = 1; i < static_cast<std::size_t>(row.node_count); ++i)
    lowest = std::min(lowest, nth(contact.lists.nodes.gid, row.nodes[i]));
  return lowest;
}

/// Of rows that can be: they go on from the impulses of the last step.
double where_remembered(double softness, const EnforcementSettings& settings) {
  const bool remembers_impulses = settings.warm_start && !settings.averaged;
  return remembers_impulses ? softness : 0.0;
}

void make_soft(Row& row, double softness, double dt) {
  row.softness = softness;
  if (row.gap < 0) row.gap_share = (row.required - row.wall_rate) * dt / -row.gap;
}

/// The row of a node with a coincident node holds in both passes, since that node may have none (see detect_faces).
void assign_passes(const Contact& contact, double dt, std::span<Row> rows) {
  const DerivedSettings& derived = contact.derived;
  const double softness = where_remembered(derived.enforcement.softness, derived.enforcement);
  for (Row& row : rows) {
    if (row.is_wall() || row.is_edge() || row.is_mortar() || row.cone != Cone::compression)
      continue;  // ties hold in both
    row.pass = pass_of(row, contact.surface.node(surface_slave(contact, row)), lowest_gid_of_master(contact, row),
                       contact.settings.specification, contact.surface.bodies);
    if (row.slave_body != row.master_body && has_coincident_node(row, contact.step.nodes.motion, derived.detection))
      row.pass = Pass::both;
    if (row.pass != Pass::both && softness > 0) make_soft(row, softness, dt);
  }
}

/// Between bodies with six degrees of freedom each nearly all rows are redundant, and incompatible by the small
/// difference of their gaps and drifts from a rigid motion: the impulses of rigid rows would grow against each other
/// without limit.
void soften_rows_of_bodies(const StepInput& input, const Carriers& carriers, const ContactNodes& nodes, double softness,
                           std::span<Row> rows) {
  if (carriers.bodies.empty() || softness == 0) return;
  for (Row& row : rows) {
    if (row.softness > 0 || row.cone != Cone::compression) continue;
    const std::span<const LocalIndex> points = row.points();
    const auto moves = [&](LocalIndex point) { return nth(nodes.mobility, point).inverse_mass > 0; };
    const auto is_carried = [&](LocalIndex point) { return carriers.of(point) != nullptr; };
    if (std::ranges::any_of(points, moves) || !std::ranges::any_of(points, is_carried)) continue;
    make_soft(row, softness, input.dt);
  }
}

AnchorScene anchor_scene(const Contact& contact, std::span<const Wall> walls) {
  return {contact.lists.faces, contact.list_state.faces_by_key, contact.step.nodes.motion, walls,
          contact.derived.detection.tolerances};
}

/// Friction across a gap has a moment; rows of nodes keep it (FRICTION.md).
void lay_arms_of_friction(const Contact& contact, std::span<Row> rows, TiltStore& store) {
  const double least = contact.derived.detection.tolerances->fine_rounding * contact.surface.mean_edge;
  store.start(rows);
  tilt_mortar_rows(rows, contact.history.mortar, {contact.step.nodes.motion, least}, store);
}

void assign_friction(const Contact& contact, const StepInput& input, std::span<Row> rows) {
  for (Row& row : rows) {
    if (row.holds) continue;
    const FrictionLaw law = friction_of(contact, row, input.walls);
    if (!law.any()) continue;
    row.friction = friction_coefficient(law, row, contact.step.nodes.motion);
    if (law.lag > 0) let_friction_lag(row, contact.history.limits, law.lag, input.dt);
  }
  const Tolerances& tolerances = *contact.derived.detection.tolerances;
  aim_at_anchors(rows, anchor_scene(contact, input.walls), contact.history.anchors,
                 {tolerances.recovery, tolerances.recovery_limit * contact.surface.mean_edge}, input.dt);
  if (contact.derived.mortar)
    aim_at_slips(rows, contact.history.mortar,
                 {tolerances.recovery, tolerances.recovery_limit * contact.surface.mean_edge}, input.dt);
}

/// Rows of edges and walls have none: an edge has no area, and a wall's candidates no facets.
void assign_slabs(const Contact& contact, std::span<Row> rows) {
  for (Row& row : rows) {
    if (row.is_wall() || row.is_edge() || row.is_mortar()) continue;
    const std::vector<double>& impedance = contact.settings.blocks.impedance;
    const double one = nth(impedance, blocks_of_slave(contact, row).front()), two = nth(impedance, row.master_block);
    row.slab = one * two / (one + two) * area_of_slave(contact, row);
  }
}

/// What rows with friction move within the step against their targets, across their normals.
void measure_slid(const Contact& contact, double dt, std::vector<Vec3>& slid) {
  const StepData& step = contact.step;
  const EnforcementScratch& solved = step.scratch.enforcement;
  slid.assign(step.rows.size(), Vec3::Zero());
  for (std::size_t q = 0; q < step.rows.size(); ++q) {
    const Row& row = step.rows[q];
    if (!(row.friction > 0) || step.impulses[q].isZero(0)) continue;
    Vec3 rate = relative_velocity(row, step.nodes.velocity) - row.drift;
    if (row.softness > 0) rate += solved.compliance[q] * step.impulses[q] - solved.borne[q];
    slid[q] = dt * (rate - row.normal.dot(rate) * row.normal);
  }
}

}  // namespace

void assemble_rows(Contact& contact, const StepInput& input) {
  const DerivedSettings& derived = contact.derived;
  if (derived.may_jam) hold_unmet_rows(contact, input);
  if (derived.two_passes) assign_passes(contact, input.dt, contact.step.rows);
  soften_rows_of_bodies(input, carriers_of(contact, input), contact.step.nodes,
                        where_remembered(derived.enforcement.softness_of_bodies, derived.enforcement),
                        contact.step.rows);
  if (derived.friction) {
    assign_friction(contact, input, contact.step.rows);
    if (derived.mortar) lay_arms_of_friction(contact, contact.step.rows, contact.step.scratch.tilts);
  }
  if (derived.enforcement.method == Method::printed) assign_slabs(contact, contact.step.rows);
}

void remember(Contact& contact, const StepInput& input) {
  const StepData& step = contact.step;
  StepScratch& scratch = contact.step.scratch;
  if (contact.derived.enforcement.warm_start || contact.derived.sheets) {
    const bool may_jam = contact.derived.may_jam;
    if (may_jam) keep_met_impulses(contact);
    // what rows give back in one step is no start for the next one
    const std::vector<Vec3>& forces = contact.derived.elastic_impact && scratch.impact.returned ? scratch.impact.first
                                      : may_jam                                                 ? contact.unmet.start
                                                                                                : step.impulses;
    write_pairs(step.rows, forces, input.dt, scratch.detection.sides, scratch.next_pairs, contact.unmet.held);
    std::swap(contact.history.pairs, scratch.next_pairs);
  }
  if (!contact.derived.friction) return;
  measure_slid(contact, input.dt, scratch.slid);
  write_anchors(step.rows, step.impulses, scratch.slid, anchor_scene(contact, input.walls), contact.history.anchors,
                scratch.next_anchors);
  std::swap(contact.history.anchors, scratch.next_anchors);
  if (contact.derived.mortar)
    keep_slips(step.rows, step.impulses, scratch.slid, input.dt, *contact.derived.detection.tolerances,
               contact.history.mortar);
  write_limits(step.rows, step.impulses, input.dt, contact.history.limits);
}

}  // namespace brunt::contact
