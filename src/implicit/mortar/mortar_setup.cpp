// SPDX-License-Identifier: Apache-2.0
// Set-up of mortar interfaces from the scene: the slave side, capture distances, ties.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "contact/mortar/active_set.hpp"
#include "core/cells.hpp"
#include "core/error.hpp"
#include "implicit/mortar/interface_forces.hpp"
#include "implicit/mortar/mortar.hpp"
#include "implicit/mortar/round_seat.hpp"
#include "implicit/mortar/thickness.hpp"
#include "material/law.hpp"
#include "mortar_pairs.hpp"
#include "self_sides.hpp"

namespace brunt::implicit {
namespace {

using contact::FacetNodes;
using contact::MortarPair;

/// Rows touch initially if their gap is below this share of a facet's edge: above the rounding of mesh files in single
/// precision, and negligible for contact.
constexpr double touching = 1e-6;

/// Meshes whose mean edges differ by less count as equal: the first is then the slave.
constexpr double clearly = 1 - 1e-6;

/// Stiffness of sticking rows over that of a layer of one facet, E / edge: at a traction of E the elastic slip is a
/// tenth of an edge. Lower values allow creep before sliding, higher ones need more iterations.
constexpr double sticking = 10;

struct EdgeLengths {
  double mean = 0, largest = 0;  ///< [length]
};
EdgeLengths edges_of(const std::vector<FacetNodes>& facets, std::span<const Vec3> x) {
  EdgeLengths edges;
  double count = 0;
  for (const FacetNodes& facet : facets) {
    const std::size_t n = cells::corner_count(facet);
    for (std::size_t k = 0; k < n; ++k) {
      const double length = (nth(x, facet[k]) - nth(x, facet[(k + 1) % n])).norm();
      edges.mean += length;
      edges.largest = std::max(edges.largest, length);
      ++count;
    }
  }
  edges.mean /= std::max(count, 1.0);
  return edges;
}

/// Infinite for rigid parts: the other side is the softer one.
double young_of(const model::ElementBlock& block) {
  if (material::is_rigid(block.law)) return std::numeric_limits<double>::infinity();
  const material::ElasticModuli moduli = material::initial_moduli(block.law);
  return moduli.mu * (3 * moduli.lambda + 2 * moduli.mu) / (moduli.lambda + moduli.mu);
}

/// Whether supports leave any node a free direction.
bool can_move(const WholeSurfaces& whole, const std::vector<FacetNodes>& facets) {
  return std::ranges::any_of(facets, [&](const FacetNodes& facet) {
    return std::ranges::any_of(
        facet, [&](LocalIndex node) { return node != no_index && nth(whole.free, node) != Mat3::Zero(); });
  });
}

/// The multipliers of a fully constrained slave would act only on the master's nodes, with more rows than these have
/// degrees of freedom. The side that can move is therefore the slave, otherwise the finer side: where they touch or
/// overlap at the start, or as a whole if they do not.
bool master_is_better(const WholeSurfaces& whole, const contact::MortarSurfaces& surfaces) {
  const bool slave_moves = can_move(whole, surfaces.slave), master_moves = can_move(whole, surfaces.master);
  if (slave_moves != master_moves) return master_moves;
  const double slave = edges_of(surfaces.slave, whole.reference).mean,
               master = edges_of(surfaces.master, whole.reference).mean;
  const SeatEdges at_seat = edges_at_seat(surfaces, whole.reference, touching * slave);
  if (at_seat.area > 0) return at_seat.master < clearly * at_seat.slave;
  return master < clearly * slave;
}

/// A rigid part is the master: as a slave it could not satisfy the rows of all its nodes.
bool is_swapped(const model::Model& model, const WholeSurfaces& whole, const MortarPair& asked,
                const contact::MortarSurfaces& surfaces) {
  const auto rigid = [&](std::int32_t b) { return material::is_rigid(nth(model.blocks, b).law); };
  if (rigid(asked.slave) != rigid(asked.master)) return rigid(asked.slave);
  return master_is_better(whole, surfaces);
}

/// Candidate facets, and the capture distance.
void lay_sides(const model::Model& model, const WholeSurfaces& whole, const MortarPair& asked, WholeInterface& of) {
  Interface& face = of.face;
  face.pair = asked;
  face.surfaces.multiplier = asked.multiplier;
  if (asked.slave == asked.master) {
    lay_self(whole, of);
    lay_rows(whole, false, face.surfaces);
    return;
  }
  of.slave = side_of(whole, asked.slave);
  of.master = side_of(whole, asked.master);
  contact::MortarSurfaces& surfaces = face.surfaces;
  surfaces.slave = of.slave.facets;
  surfaces.master = of.master.facets;
  surfaces.capture =
      std::max(edges_of(surfaces.slave, whole.reference).largest, edges_of(surfaces.master, whole.reference).largest);
  surfaces.slave_wall = thickness_behind(surfaces.slave, whole.reference, surfaces.capture);
  surfaces.master_wall = thickness_behind(surfaces.master, whole.reference, surfaces.capture);
  if (asked.choose_slave && is_swapped(model, whole, asked, surfaces)) {
    std::swap(face.pair.slave, face.pair.master);
    std::swap(of.slave, of.master);
    std::swap(surfaces.slave, surfaces.master);
    std::swap(surfaces.slave_wall, surfaces.master_wall);
  }
  surfaces.fading = asked.edges;
  lay_rows(whole, asked.edges, surfaces);
}

/// The tied rows in the reference configuration.
void lay_tie(const WholeSurfaces& whole, Interface& face) {
  search(face, whole.reference);
  contact::mortar_rows(face.surfaces, face.topology, face.search.candidates, whole.reference,
                       *contact::make_mortar_scratch(), face.iterate.rows);
  face.start.tie = contact::tie_start(face.surfaces, face.search.candidates, whole.reference, face.iterate.rows);
  contact::find_places_below(face.surfaces, face.topology, face.search.candidates, whole.reference, face.start.tie);
}

/// Whether both sides are fully constrained, so that no multiplier can act.
void refuse_held(const model::Model& model, const WholeSurfaces& whole, const Interface& face) {
  const auto& part = [&](std::int32_t b) -> const std::string& { return nth(model.blocks, b).part; };
  if (face.surfaces.slave.empty() || face.surfaces.master.empty())
    throw InputError(
        fmt::format("{}: invalid pair: {} has no face that could touch {}; expected parts with exterior faces",
                    face.pair.entry, part(face.surfaces.slave.empty() ? face.pair.slave : face.pair.master),
                    part(face.surfaces.slave.empty() ? face.pair.master : face.pair.slave)));
  if (!can_move(whole, face.surfaces.slave) && !can_move(whole, face.surfaces.master))
    throw InputError(fmt::format(
        "{}: invalid pair: all surface nodes of {} and {} are constrained; expected a pair of which one part can move",
        face.pair.entry, part(face.pair.slave), part(face.pair.master)));
}

/// Collective.
void note_redundant(const comm::Communicator& ranks, const Interface& face, std::vector<std::string>& notes) {
  GlobalIndex covered = 0, redundant = 0;
  for (std::size_t row = 0; row < face.count(); ++row) {
    if (face.start.tie.covered[row] == 0) continue;
    ++covered;
    if (!face.start.tied[row].isIdentity()) ++redundant;
  }
  covered = ranks.sum(covered);
  redundant = ranks.sum(redundant);
  if (redundant > 0)
    notes.push_back(
        fmt::format("{}: {} of {} tied nodes have no multiplier in directions that supports constrain on both sides, "
                    "or in which other multipliers are redundant",
                    face.pair.entry, redundant, covered));
}

WholeInterface make_interface(const model::Model& model, const WholeSurfaces& whole, const MortarPair& asked) {
  WholeInterface of;
  lay_sides(model, whole, asked, of);
  Interface& face = of.face;
  refuse_held(model, whole, face);
  face.topology = contact::make_topology(face.surfaces, whole.reference);
  const auto block = [&](std::int32_t b) -> const model::ElementBlock& { return nth(model.blocks, b); };
  const double young = std::min(young_of(block(face.pair.slave)), young_of(block(face.pair.master)));
  face.stiffness = contact::layer_stiffness(young, face.topology);
  face.friction = {asked.friction, sticking * face.stiffness};
  if (asked.tied) lay_tie(whole, face);
  return of;
}

/// Chords lose or gain a part of the interference of round parts. Heavy fits press everywhere and feel the mean
/// overlap; light ones stand on the nodes that lie deepest, and feel that overlap.
void warn_of_chords(const model::Model& model, const WholeSurfaces& whole, const Interface& face,
                    std::vector<std::string>& warnings) {
  constexpr double too_much = 0.1;  // of the interference, and so of the pressure
  if (face.pair.tied || face.self) return;
  const RoundSeat seat = round_seat(face.surfaces, whole.reference, face.surfaces.capture);
  const double least = touching * face.topology.edge;
  if (!seat.conform || seat.of_surfaces <= least || seat.deepest <= least) return;
  const double mean = std::max(0.0, seat.of_facets) / seat.of_surfaces - 1;
  const double most = std::max(mean, seat.deepest / seat.of_surfaces - 1);
  if (std::max(std::abs(mean), std::abs(most)) < too_much) return;
  const auto part = [&](std::int32_t b) { return nth(model.blocks, b).part; };
  const auto text = [](double share) {
    return fmt::format("{:.0f} % too {}", 100 * std::abs(share), share < 0 ? "low" : "high");
  };
  warnings.push_back(fmt::format(
      "{}: where parts '{}' and '{}' overlap at the start, their facets lie {:.3g} in each other on average and {:.3g} "
      "at most, and the round surfaces through their nodes {:.3g}: facets are chords. Pressures are from {} (where "
      "all is pressed) to {} (where only nodes are). Use as many facets around on both sides, at the same angles, or "
      "smaller ones",
      face.pair.entry, part(face.pair.slave), part(face.pair.master), seat.of_facets, seat.deepest, seat.of_surfaces,
      text(mean), text(most)));
}

/// The positions of the multipliers in the system, and those of this rank.
void number_multipliers(const Unknowns& unknowns, MortarContact& contact) {
  GlobalIndex next = unknowns.total;
  for (Interface& face : contact.interfaces) {
    face.numbering.first = next;
    for (std::size_t row = 0; row < face.count(); ++row)
      for (int k = 0; k < face.multipliers(); ++k) {
        contact.own_rows.push_back(face.multiplier(row, k));
        contact.own.push_back(static_cast<LocalIndex>(face.multiplier(row, k) - unknowns.total));
      }
    next += static_cast<GlobalIndex>(face.numbering.rows_of_all) * face.multipliers();
  }
}

}  // namespace

MortarContact make_mortar(const comm::Communicator& ranks, const model::Model& model, const Unknowns& unknowns) {
  MortarContact contact;
  if (model.touching.mortar.empty()) return contact;
  const WholeSurfaces whole = tell_surfaces(ranks, model);
  std::vector<WholeInterface> interfaces;
  for (const MortarPair& pair : model.touching.mortar) {
    WholeInterface whole_pair = make_interface(model, whole, pair);
    whole_pair.face.of_pair = static_cast<std::size_t>(&pair - model.touching.mortar.data());
    warn_of_chords(model, whole, whole_pair.face, contact.warnings);
    std::ranges::move(split_at_edges(whole, std::move(whole_pair)), std::back_inserter(interfaces));
  }
  share_out(ranks, model, unknowns, whole, std::move(interfaces), contact);
  number_multipliers(unknowns, contact);
  choose_roles(ranks, contact);
  find_contact(ranks, contact, Iterate::first_of_step);
  for (Interface& face : contact.interfaces)
    for (std::size_t row = 0; row < face.count() && !face.pair.tied; ++row)
      face.start.touches[row] =
          face.iterate.rows.covered[row] > 0 && std::abs(face.mean_gap(row)) <= touching * face.topology.edge;
  leave_out_redundant(ranks, contact.nodes.free, contact);
  for (const Interface& face : contact.interfaces)
    if (face.pair.tied) note_redundant(ranks, face, contact.notes);
  keep_contact(contact);
  choose_roles(ranks, contact);
  contact.impulses.assign(contact.interfaces.size() * static_cast<std::size_t>(interface_force_width), 0.0);
  contact.forces_before = contact.impulses;
  return contact;
}

}  // namespace brunt::implicit
