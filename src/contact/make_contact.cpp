// SPDX-License-Identifier: Apache-2.0
// The parts of contact before the first step.
#include <algorithm>
#include <limits>
#include <utility>

#include "contact/contact.hpp"
#include "contact/data/tolerances.hpp"
#include "contact/joined/join_surface.hpp"
#include "contact/joined/transits.hpp"
#include "contact/surface/passes.hpp"
#include "initial_state.hpp"
#include "mortar_step.hpp"
#include "move_history.hpp"
#include "tied_parts.hpp"

namespace brunt::contact {
namespace {

/// Of each body, the slowest of its blocks.
std::vector<double> sound_of(std::span<const BodyFigures> bodies, std::span<const double> sound) {
  std::vector<double> slowest;
  if (sound.empty()) return slowest;
  for (const BodyFigures& body : bodies) {
    slowest.push_back(std::numeric_limits<double>::infinity());
    for (const std::int32_t block : body.blocks) slowest.back() = std::min(slowest.back(), nth(sound, block));
  }
  return slowest;
}

DetectionSettings derived_detection(const ContactSettings& settings, const Surface& surface) {
  DetectionSettings detection = settings.detection;
  detection.tolerances = settings.specification.tolerances;
  detection.wall_size = surface.mean_edge;
  detection.criterion = settings.specification.criterion;
  detection.sound = sound_of(surface.bodies, settings.blocks.sound);
  detection.flush = surface.flush;
  detection.coincidence_distance = detection.tolerances->coincidence * surface.mean_element_depth;
  return detection;
}

/// Walls alone are solved at once, other methods start from nothing: no history is kept for them.
EnforcementSettings derived_enforcement(const Specification& specification) {
  EnforcementSettings enforcement = specification.enforcement;
  const Method method = enforcement.method;
  enforcement.warm_start =
      enforcement.warm_start && specification.pairs.any_acts() && (method == Method::rate || method == Method::row_sum);
  enforcement.averaged = specification.pairs.averages();
  return enforcement;
}

/// Collective.
DerivedSettings derive(const ContactSettings& settings, const Surface& surface, std::span<const Mobility> mobility,
                       std::span<const Wall> walls, const comm::Communicator& ranks) {
  const Specification& specification = settings.specification;
  DerivedSettings derived{.detection = derived_detection(settings, surface),
                          .enforcement = derived_enforcement(specification),
                          .roles = roles_of(surface.bodies, specification)};
  derived.bodies = specification.pairs.any_acts();
  derived.tied = specification.pairs.any_tied();
  derived.friction = specification.pairs.any_friction() ||
                     std::ranges::any_of(walls, [](const Wall& wall) { return wall.friction.any(); });
  derived.two_passes = derived.bodies && any_two_passes(specification, surface.bodies);
  derived.mortar = specification.pairs.any(
      [](const PairSpecification& pair) { return pair.rule != PairRule::apart && pair.passes == Passes::mortar; });
  derived.sheets = std::ranges::any_of(settings.blocks.thickness, [](double thickness) { return thickness > 0; });
  derived.may_jam = settings.rigid.count > 0 && settings.rigid.squeezed;
  derived.may_be_driven =
      settings.rigid.supported || derived.may_jam ||
      ranks.any(std::ranges::any_of(mobility, [](const Mobility& node) { return !node.is_free(); }));
  derived.elastic_impact = specification.enforcement.impact == Impact::elastic;
  derived.remembers = derived.enforcement.warm_start || derived.friction || derived.sheets || derived.mortar ||
                      settings.erodes || derived.elastic_impact;
  return derived;
}

/// Collective.
SurfaceNodes surface_nodes(const comm::Communicator& ranks, const Surface& surface, const mesh::LocalMesh& mesh,
                           std::span<const double> inverse_mass, std::span<const ConstrainedNode> constrained,
                           std::span<const Wall> walls, std::span<const BodyNode> on_bodies, bool wants_reference,
                           const Tolerances& tolerances) {
  std::vector<double> carrier = surface_carriers(surface, on_bodies);
  SurfaceNodes nodes{.mobility = surface_mobility(surface, inverse_mass, constrained, carrier),
                     .carrier = std::move(carrier),
                     .held = held_by_walls(surface, mesh.coordinates, walls, tolerances),
                     .copies = link_copies(ranks, surface)};
  if (wants_reference)
    for (const LocalIndex node : surface.model_node) nodes.reference.push_back(nth(mesh.coordinates, node));
  return nodes;
}

/// What was said of the bodies at the start, with the blocks that have come to their outside.
std::vector<BodyFigures> with_blocks(std::vector<BodyFigures> bodies, std::span<const BodyFigures> now) {
  for (std::size_t b = 0; b < std::min(bodies.size(), now.size()); ++b) {
    std::vector<std::int32_t>& blocks = bodies[b].blocks;
    blocks.insert(blocks.end(), now[b].blocks.begin(), now[b].blocks.end());
    std::ranges::sort(blocks);
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  }
  return bodies;
}

/// The nodes of a rigid master do not enter the slave between its nodes: they have no motion of their own, and a slave
/// that rests on a flat face with its nodes lies on it. One pass suffices however fine they are. Collective.
void spare_rigid_masters(const comm::Communicator& ranks, std::span<const double> carrier, Surface& surface) {
  std::vector<double> deforms(surface.bodies.size(), 0.0);
  for (std::size_t i = 0; i < surface.gid.size(); ++i)
    if (surface.body[i] != no_index && !(i < carrier.size() && carrier[i] > 0)) nth(deforms, surface.body[i]) = 1;
  ranks.max(deforms);
  for (std::size_t body = 0; body < deforms.size(); ++body)
    if (deforms[body] == 0) surface.bodies[body].shortest_edge = std::numeric_limits<double>::infinity();
}

}  // namespace

Contact make_contact(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, std::span<const char> excluded,
                     std::span<const double> inverse_mass, std::span<const ConstrainedNode> constrained,
                     std::span<const Wall> walls, ContactSettings settings) {
  Surface surface = join_surface(ranks, mesh, excluded, inverse_mass, *settings.specification.tolerances);
  SurfaceNodes nodes = surface_nodes(ranks, surface, mesh, inverse_mass, constrained, walls, settings.rigid.nodes,
                                     !settings.detection.accepted.empty(), *settings.specification.tolerances);
  if (settings.rigid.count > 0) spare_rigid_masters(ranks, nodes.carrier, surface);
  if (settings.specification.enforcement.impact == Impact::elastic)
    nodes.transit = transits(ranks, surface, settings.blocks.sound);
  std::vector<BodyFigures> bodies = surface.bodies;
  DerivedSettings derived = derive(settings, surface, nodes.mobility, walls, ranks);
  Contact contact{.ranks = ranks,
                  .settings = std::move(settings),
                  .derived = std::move(derived),
                  .surface = std::move(surface),
                  .bodies_at_start = std::move(bodies),
                  .walls_at_start{walls.begin(), walls.end()},
                  .surface_nodes = std::move(nodes)};
  contact.ledger.sums.wall_impulse.resize(walls.size());
  contact.ledger.sums.tracked.resize(contact.settings.tracked.size());
  keep_overlaps(contact, mesh.coordinates, walls);
  make_ties(contact, mesh.coordinates, walls);
  return contact;
}

void update_surface(Contact& contact, const mesh::LocalMesh& mesh, const Remains& remains,
                    std::span<const double> inverse_mass, std::span<const ConstrainedNode> constrained) {
  const std::vector<Wall>& walls = contact.walls_at_start;
  Surface surface =
      join_surface(contact.ranks, mesh, remains, inverse_mass, *contact.settings.specification.tolerances);
  surface.bodies = with_blocks(contact.bodies_at_start, surface.bodies);
  surface.mean_edge = contact.surface.mean_edge;
  surface.mean_element_depth = contact.surface.mean_element_depth;
  const Surface before = std::exchange(contact.surface, std::move(surface));
  contact.surface_nodes = surface_nodes(contact.ranks, contact.surface, mesh, inverse_mass, constrained, walls,
                                        contact.settings.rigid.nodes, !contact.settings.detection.accepted.empty(),
                                        *contact.settings.specification.tolerances);
  if (contact.derived.elastic_impact)
    contact.surface_nodes.transit = transits(contact.ranks, contact.surface, contact.settings.blocks.sound);
  std::vector<AcceptedOverlap> accepted = std::move(contact.derived.detection.accepted);
  std::vector<BodyPair> fitted = std::move(contact.derived.detection.fitted);
  contact.derived = derive(contact.settings, contact.surface, contact.surface_nodes.mobility, walls, contact.ranks);
  contact.derived.detection.accepted = std::move(accepted);
  contact.derived.detection.fitted = std::move(fitted);
  release_ties(contact, remains.outside.faces);
  if (contact.derived.mortar) forget_changed_rows(before, contact);
  renew_ties(contact, mesh.coordinates, remains.outside.faces);
  if (contact.derived.remembers) move_history(contact);
  contact.list_state.exist = false;
  contact.elements_are_gone =
      contact.ranks.any(std::ranges::any_of(remains.alive, [](const std::vector<double>& block) {
        return !std::ranges::all_of(block, [](double alive) { return alive > 0; });
      }));
}

}  // namespace brunt::contact
