// SPDX-License-Identifier: Apache-2.0
#include "rebuild_lists.hpp"

#include <algorithm>

#include "contact/anchors/anchors.hpp"
#include "contact/data/tolerances.hpp"
#include "core/error.hpp"
#include "core/sorted.hpp"
#include "gather.hpp"
#include "memory.hpp"
#include "mortar_step.hpp"
#include "tied_parts.hpp"

namespace brunt::contact {
namespace {

bool motion_is_used_up(Contact& contact, const StepInput& input, const VelocitySpan& velocities) {
  const Surface& surface = contact.surface;
  ListState& state = contact.list_state;
  const std::size_t nodes = surface.model_node.size();
  const std::span<const Wall> walls = input.walls;
  state.motion.advance(velocities, state.last_dt, input.dt);
  for (std::size_t w = 0; w < walls.size(); ++w)
    state.motion.advance_one(nodes + w, walls[w].point, walls[w].velocity, input.dt);
  if (state.motion.bound() < state.motion_allowed) return false;

  const VectorView predicted = input.predicted();
  ListMotion::Sum sum(state.motion, input.dt);
  for (std::size_t i = 0; i < nodes; ++i) {
    if (i + far_ahead < nodes) input.position.fetch(surface.model_node[i + far_ahead]);
    const LocalIndex node = surface.model_node[i];
    sum.add(i, input.position[node], predicted[node]);
  }
  for (std::size_t w = 0; w < walls.size(); ++w) sum.add(nodes + w, walls[w].point, walls[w].velocity);
  MotionSpan found = sum.span();
  contact.ranks.max(found);
  state.motion.correct(found);
  return !(found[0] < state.motion_allowed);
}

/// For reasons other than motion.
bool must_rebuild(const Contact& contact) {
  if (!contact.list_state.exist) return true;
  const Rebuild& rebuild = contact.settings.specification.rebuild;
  const auto step = static_cast<std::uint64_t>(contact.ledger.statistics.steps);
  switch (rebuild.when) {
    case Rebuild::When::every:
      return step % static_cast<std::uint64_t>(rebuild.steps) == 0;
    case Rebuild::When::random:
      return ((step + rebuild.seed) * 0x9E3779B97F4A7C15ULL >> 40) % 4 == 0;
    case Rebuild::When::motion_used_up:
      break;
  }
  return false;
}

/// Notes where nodes and walls are, and returns the speed of the fastest of this rank.
double start_motion(const Surface& surface, const StepInput& input, ListMotion& motion) {
  const VectorView predicted = input.predicted();
  double fastest = 0;
  motion.start();
  for (const LocalIndex node : surface.model_node) {
    motion.put(input.position[node]);
    const double speed = predicted[node].norm();
    if (!(speed <= fastest)) fastest = speed;
  }
  for (const Wall& wall : input.walls) {
    motion.put(wall.point);
    fastest = std::max(fastest, wall.velocity.norm());
  }
  return fastest;
}

ContactLists lists_of(Contact& contact, std::span<const Wall> walls, FacetPairs facets) {
  const DerivedSettings& derived = contact.derived;
  const Tolerances& tolerances = *derived.detection.tolerances;
  ListState& state = contact.list_state;
  std::vector<GlobalIndex> kept, tied = contact.tied.mortar.nodes.values;
  if (derived.mortar) kept = nodes_of_kept_rows(contact.history.mortar);
  sort_unique(tied);
  const ListSettings reach{.tolerances = &tolerances,
                           .wall_capture = tolerances.capture * derived.detection.wall_size,
                           .motion = state.motion_allowed,
                           .faces = derived.bodies,
                           .two_passes = derived.two_passes,
                           .facets = facets,
                           .keeps = derived.mortar || derived.tied,
                           .kept = kept,
                           .tied = tied,
                           .tied_rows = contact.tied.mortar.rows.size(),
                           .wall_facets = contact.settings.wall_pressures,
                           .thickness = contact.settings.blocks.thickness,
                           .search = contact.settings.search};
  return build_lists(contact.ranks, contact.surface, contact.settings.specification, derived.roles,
                     state.motion.starts().first(contact.surface.gid.size()), walls, contact.surface_nodes.held, reach,
                     state.scratch);
}

/// Of contact nodes, from a value of each surface node: the owner's. Collective.
template <class T>
std::vector<T> of_contact_nodes(ContactLists& lists, std::span<const T> of_surface, const T& none) {
  std::vector<T> values(lists.nodes.gid.size(), none);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (const LocalIndex here = lists.nodes.surface_node[i]; here != no_index) values[i] = nth(of_surface, here);
  lists.exchange.share(as_doubles(values), static_cast<int>(sizeof(T) / sizeof(double)));
  return values;
}

void find_carried(const Contact& contact, ContactLists& lists, ContactNodes& nodes) {
  nodes.carried.clear();
  const std::vector<double> carrier = of_contact_nodes<double>(lists, contact.surface_nodes.carrier, 0.0);
  for (std::size_t i = 0; i < carrier.size(); ++i)
    if (carrier[i] > 0)
      nodes.carried.push_back({static_cast<LocalIndex>(i), static_cast<LocalIndex>(carrier[i]) - 1,
                               lists.nodes.home[i].rank == contact.ranks.rank()});
}

void size_nodes(const Contact& contact, ContactLists& lists, ContactNodes& nodes) {
  nodes.motion.assign(lists.nodes.gid.size(), {});
  nodes.velocity.assign(lists.nodes.gid.size(), Vec3::Zero());
  nodes.mobility = of_contact_nodes<Mobility>(lists, contact.surface_nodes.mobility, {});
  static_assert(sizeof(Mobility) == 10 * sizeof(double));
  if (contact.settings.rigid.count > 0) find_carried(contact, lists, nodes);
  if (contact.derived.elastic_impact)
    nodes.transit = of_contact_nodes<double>(lists, contact.surface_nodes.transit, 0.0);
  if (!contact.derived.detection.accepted.empty())
    nodes.reference = of_contact_nodes<Vec3>(lists, contact.surface_nodes.reference, Vec3::Zero());
}

/// Ties with integrated weights have more points than rows of detection.
RowRoom room_of(std::size_t most_rows, bool tilts, const TiedParts& tied) {
  RowRoom room{.rows = most_rows};
  for (LocalIndex r = 0; r < tied.mortar.nodes.rows(); ++r)
    room.points_of_a_row = std::max(room.points_of_a_row, tied.mortar.nodes.row(r).size());
  const std::size_t wide = tied.mortar.nodes.values.size();
  room.entries = most_nodes_of_a_row * most_rows + wide;
  room.arms = most_nodes_of_a_row * tied.ties.size() + wide;
  if (tilts) room.tilts = most_nodes_of_a_row * most_rows;
  return room;
}

/// All that grows with the rows that these lists can give.
void reserve_rows(const DerivedSettings& derived, const ContactLists& lists, const TiedParts& tied, std::size_t bodies,
                  StepData& step, History& history) {
  StepScratch& scratch = step.scratch;
  scratch.detection.reserve(lists.faces.size(), step.facet_area.size(), lists.most_faces_of_a_slave);
  scratch.holds.reserve(lists.nodes.gid.size());
  const std::size_t most_rows = lists.most_rows + tied.ties.size();
  const RowRoom room = room_of(most_rows, derived.friction && derived.mortar, tied);
  step.rows.reserve(most_rows);
  scratch.row_sort.reserve(most_rows);
  step.impulses.reserve(most_rows);
  scratch.enforcement.reserve(room, lists.nodes.gid.size());
  if (derived.two_passes) scratch.enforcement.reserve_passes(room);
  if (bodies > 0) scratch.enforcement.reserve_bodies(most_rows, lists.nodes.gid.size(), bodies);
  if (derived.elastic_impact) {
    scratch.impact.reserve(most_rows, lists.nodes.gid.size(), bodies);
    history.impacts.reserve(most_rows);
  }
  if (!derived.remembers) return;
  const std::size_t sides = derived.sheets ? lists.candidates.faces.values.size() : 0;
  scratch.detection.sides.reserve(sides);
  history.pairs.reserve(most_rows + sides);
  scratch.next_pairs.reserve(most_rows + sides);
  history.anchors.reserve(most_rows);
  scratch.next_anchors.reserve(most_rows);
  scratch.slid.reserve(most_rows);
  scratch.tilts.values.reserve(room.tilts);
  history.limits.reserve(most_rows);
}

}  // namespace

void rebuild(Contact& contact, const StepInput& input, FacetPairs facets) {
  const DerivedSettings& derived = contact.derived;
  const Surface& surface = contact.surface;
  ListState& state = contact.list_state;
  ContactLists& lists = contact.lists;
  StepData& step = contact.step;
  const double fastest = start_motion(surface, input, state.motion);
  state.motion_allowed =
      std::max(contact.settings.motion_share * surface.mean_element_depth, 4 * input.dt * contact.ranks.max(fastest));
  lists = lists_of(contact, input.walls, facets);
  state.exist = true;
  ++contact.ledger.statistics.searches;

  size_nodes(contact, lists, step.nodes);
  if (derived.mortar) place_kept_rows(contact);
  if (derived.tied) place_mortar_ties(contact);
  if (derived.two_passes) {
    const std::span<const Vec3> starts = state.motion.starts().first(surface.gid.size());
    const std::vector<Vec3> positions = of_contact_nodes<Vec3>(lists, starts, Vec3::Zero());
    list_coincident_nodes(lists.faces, positions, state.motion_allowed, derived.detection, lists.candidates);
  }
  state.gather = plan_gather(surface, lists);
  step.own_area.assign(surface.faces.size(), Vec3::Zero());
  step.facet_area.assign(static_cast<std::size_t>(lists.facet_count), Vec3::Zero());
  reserve_rows(derived, lists, contact.tied, contact.settings.rigid.count, step, contact.history);
  if (derived.may_jam) contact.unmet.reserve(lists.most_rows + contact.tied.ties.size(), contact.settings.rigid.count);
  if (derived.friction || derived.may_be_driven || derived.tied) state.faces_by_key = order_by_key(lists.faces);
  if (derived.tied) {
    const std::span<const Vec3> starts = state.motion.starts().first(surface.gid.size());
    demand_ties_hold(contact, of_contact_nodes<Vec3>(lists, starts, Vec3::Zero()));
  }
}

void search(Contact& contact, const StepInput& input, const VelocitySpan& velocities) {
  demand(input.walls.size() == contact.ledger.sums.wall_impulse.size(), "the number of walls is that of the contact");
  ListState& state = contact.list_state;
  state.are_new = must_rebuild(contact) || motion_is_used_up(contact, input, velocities);
  if (state.are_new) rebuild(contact, input, contact.derived.mortar ? FacetPairs::mortar : FacetPairs::none);
  state.last_dt = input.dt;
}

}  // namespace brunt::contact
