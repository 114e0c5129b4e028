// SPDX-License-Identifier: Apache-2.0
// Mortar contact in an implicit step. A row belongs to the owner of its slave node, who holds the slave facets around
// it and the master facets that these may meet; what a row does to nodes of other ranks is sent to their owners, who
// add it up in the order of facets and rows. A facet on the border between ranks is integrated on both sides.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "brunt/comm/halo.hpp"
#include "brunt/contact/mortar/friction.hpp"
#include "brunt/contact/mortar/interface.hpp"
#include "brunt/contact/mortar/tie.hpp"
#include "brunt/contact/search/facet_tree.hpp"
#include "brunt/implicit/block_sums.hpp"
#include "brunt/implicit/unknowns.hpp"
#include "brunt/model/model.hpp"

namespace brunt::implicit {

/// Nodes of the facets that this rank holds. Those up to `lasting` stay all along, in canonical order: nodes of its own
/// surfaces, of slave facets around its rows, of its ties. Behind them, in canonical order too, stand those of masters
/// of other ranks that are near.
struct ContactNodes {
  std::vector<GlobalIndex> gid;
  std::size_t lasting = 0;
  std::vector<comm::RemoteSlot> source;  ///< of each: its owner, and its local index there
  std::vector<LocalIndex> own;           ///< of each: its place in Unknowns::node where this rank owns it, or no_index
  std::vector<Mat3> rows;                ///< of each of this rank: multiplies its rows, supports and walls taken out
  std::vector<Mat3> free;                ///< of each: projector on the directions that supports leave free
  std::vector<Mat3> movable;             ///< likewise of those that walls leave free too, as it was last shared
  std::vector<std::uint8_t> several;     ///< of each: surfaces of several interfaces have it
  comm::Halo gather;                     ///< from all ranks' nodes to these
  std::vector<Vec3> reference;           ///< of lasting ones, at the start [length]
  std::vector<Vec3> x;                   ///< at the iterate [length]
  std::vector<Vec3> x_before;            ///< at t_n [length]
  std::vector<Vec3> x_told;              ///< of lasting ones, when masters were last told of [length]
  std::vector<Vec3> force;               ///< of contact at the iterate, on nodes that this rank owns [force]
  std::vector<Vec3> friction_force;      ///< of it, the tangential part

  [[nodiscard]] LocalIndex place_of(GlobalIndex node) const;  ///< no_index where this rank does not hold it
};

/// Facets of a master that belong to elements of this rank: it tells others of them.
struct OwnMasters {
  std::vector<GlobalIndex> key;
  std::vector<contact::FacetNodes> nodes;  ///< places in ContactNodes
  std::vector<double> wall;                ///< as MortarSurfaces::master_wall
};

/// Search and pairs of one interface.
struct PairSearch {
  contact::KdopTree slave, master;
  contact::TraversalScratch scratch;
  contact::TraversalCounts counts;
  bool anew = true;       ///< the trees are to be built
  double built_with = 0;  ///< tests per pair when the trees were built
  std::vector<contact::FacetPair> pairs;
  Ragged<LocalIndex> candidates;  ///< a slave facet each
};

struct Interface {
  contact::MortarPair pair;
  contact::MortarSurfaces surfaces;  ///< of this rank; nodes: places in ContactNodes, rows: of nodes that it owns
  contact::MortarTopology topology;
  std::vector<GlobalIndex> slave_key;  ///< of the slave facets
  OwnMasters own_masters;
  PairSearch search;
  contact::MortarScratchPointer scratch;
  std::vector<LocalIndex> place;  ///< of each row among those of all ranks
  std::size_t rows_of_all = 0;    ///< how many these are
  comm::Halo to_all;              ///< from the rows of all ranks to all rows in order: for sums and what is saved
  comm::Halo beside;              ///< from the rows of all ranks to surfaces.rows_elsewhere
  GlobalIndex first = 0;          ///< row of the whole system of the first multiplier of all
  double stiffness = 0;           ///< of a layer of one facet [force/length^3]
  contact::MortarFriction friction;
  // at the iterate
  contact::MortarRows rows;
  contact::MortarSlopes slopes;
  std::vector<double> z;  ///< pressures, a row each; of ties three multipliers [force/length^2]
  std::vector<std::uint8_t> active;
  std::vector<double> start_gaps;  ///< of these rows at the places of t_n, weighted; empty unless kept [length^3]
  std::vector<double> least_gaps;  ///< that the rows ask for, weighted; empty: zero [length^3]
  std::vector<double> least_by_start, least_by_covered;  ///< its derivatives by start_gaps, and by what is covered
  std::vector<std::uint8_t> pressed_before;              ///< at t_n
  std::vector<Vec3> tractions;
  std::vector<contact::FrictionState> states;
  // of t_n and the start
  contact::FrictionHistory history;
  contact::TieStart tie;
  std::vector<Mat3> tied;             ///< of ties, a row each: projector on the directions that its multipliers hold
  std::vector<Mat3> given_apart;      ///< likewise those along which the slave and the place under it are both held
  std::vector<std::uint8_t> touches;  ///< rows that touch at the start: in the set from the first iterate on
  bool at_start = false;              ///< that iterate: what touches is stiff there, though nothing presses yet

  [[nodiscard]] int multipliers() const {  ///< unknowns a row
    return pair.tied ? 3 : pair.enforce == contact::MortarPair::Enforce::penalty ? 0 : 1;
  }
  [[nodiscard]] bool presses() const { return !pair.tied; }
  /// Over the part of the row that lies under the master [length]; 0 where none does.
  [[nodiscard]] double mean_gap(std::size_t row) const {
    return rows.covered[row] > 0 ? rows.gaps[row] / rows.covered[row] : 0.0;
  }
  /// How far the gap is above what the row asks for, weighted [length^3].
  [[nodiscard]] double above(std::size_t row) const {
    return rows.gaps[row] - (least_gaps.empty() ? 0.0 : least_gaps[row]);
  }
  /// Gaps of t_n are kept: exact multipliers of a scheme in which contact acts as at the end of the step.
  [[nodiscard]] bool keeps(const struct MortarContact& contact) const;
  [[nodiscard]] std::size_t count() const { return surfaces.rows.size(); }  ///< rows of this rank
  /// Row of the whole system.
  [[nodiscard]] GlobalIndex multiplier(std::size_t row, int k = 0) const {
    return first + static_cast<GlobalIndex>(multipliers()) * place[row] + k;
  }
};

/// Sums of contact over all ranks.
struct ContactCounts {
  GlobalIndex segments = 0, pairs = 0, tests = 0;
  GlobalIndex active = 0;    ///< rows that push, or hold (ties)
  GlobalIndex touching = 0;  ///< of these, rows that are no ties
};

struct MortarContact {
  ContactNodes nodes;
  std::vector<Interface> interfaces;
  bool keeps_gaps = false;           ///< rows that begin a step at a negative gap keep it, but for what is recovered
  double budget = 0;                 ///< what recovery may give in this step, by its forecast [energy]
  double recovery = 0;               ///< share of `recovered` in this step, 0 to 1
  double travel = 0;                 ///< that nodes may make until masters are told of anew [length]
  bool shares_nodes = false;         ///< on some rank there are ContactNodes::several
  bool may_imply = false;            ///< without walls too rows may imply others: shared nodes, slaves at supports
  std::vector<std::string> notes{};  ///< of the start: multipliers that are left out, and why
  std::vector<double> z_before{};    ///< multipliers of all interfaces at t_n, the same on every rank: saved
  std::vector<double> traction_before{};  ///< tangential tractions at t_n of all rows with friction, three each: saved
  std::vector<double> impulses{};         ///< of interfaces on their slaves since t = 0, an InterfaceForce each: saved
  std::vector<double> forces_before{};    ///< likewise the forces at t_n: saved
  std::vector<GlobalIndex> own_rows;  ///< multipliers whose slave node this rank owns: rows of the system, ascending
  std::vector<LocalIndex> own;        ///< their places in `z_before`
  ContactCounts counts{};             ///< at the last call of `tally`
  BlockSums sums{};                   ///< of each of `nodes`: what contact adds to its rows of the matrix
  [[nodiscard]] bool any() const { return !interfaces.empty(); }
};

inline bool Interface::keeps(const MortarContact& contact) const {
  return contact.keeps_gaps && multipliers() == 1;
}

/// Interfaces of Model::mortar. Throws InputError where two surfaces cannot make one. Collective.
MortarContact make_mortar(const comm::Communicator& ranks, const model::Model& model, const Unknowns& unknowns);

/// Positions of contact's nodes at X + u, and multipliers `own_z` of this rank; masters that have come near.
/// Collective.
void gather_contact(const comm::Communicator& ranks, const model::State& state, std::span<const double> own_z,
                    MortarContact& contact);

/// Which iterate find_contact is at.
enum class Iterate : std::int8_t {
  later,
  first_of_step,  ///< the predictor: pressures are those of t_n, and recovery is chosen
  first_of_run    ///< likewise; rows that touch at the start are pressed
};

/// Pairs, rows, active sets and forces at the gathered positions. Collective.
void find_contact(const comm::Communicator& ranks, MortarContact& contact, Iterate iterate);

/// Leaves out multipliers that are redundant: of rows that nothing can satisfy or that others imply over the directions
/// that are free at the iterate. Their rows say that they are zero. movable: of each of contact's nodes that this rank
/// owns, projector on the directions that supports and walls leave free now. Call after find_contact. Collective.
void leave_out_redundant(const comm::Communicator& ranks, std::span<const Mat3> movable, MortarContact& contact);

/// Of each of contact's nodes that this rank owns: projector on directions along which walls hold it and supports or
/// walls hold the place that it is tied to. The tie carries what presses it to that place: no wall need do so, nor find
/// out whether it does. movable: as above. Collective.
std::vector<Mat3> carried_by_ties(const comm::Communicator& ranks, std::span<const Mat3> movable,
                                  MortarContact& contact);

/// What contact along the normals gives to the bodies in the step, where it acts as at the end of it [energy].
/// Collective.
double given_in_step(const MortarContact& contact);

/// What is left of each multiplier's equation, as a force: stiffness times gap where pressed, else the pressure times
/// its area. Of `own`.
void multiplier_residuals(const MortarContact& contact, std::span<double> residual);

/// A piece of the matrix: 3 x 3 (node, node), or columns and rows of multipliers.
struct ContactTerm {
  GlobalIndex row = 0, column = 0;
  double value = 0;
};
/// By row and column.
[[nodiscard]] inline bool comes_before(const ContactTerm& a, const ContactTerm& b) {
  return a.row < b.row || (a.row == b.row && a.column < b.column);
}

/// Derivatives of the residual by positions and multipliers, rows of this rank alone: by row and column, those of one
/// place in an order that does not depend on the ranks. Call after find_contact at the same positions. Collective.
void contact_terms(const comm::Communicator& ranks, MortarContact& contact, std::vector<ContactTerm>& terms);

/// The step is accepted: multipliers, histories of friction. Collective.
void keep_contact(MortarContact& contact);

/// After a restart has filled z_before and traction_before: the rest of what is kept of t_n, from the places of
/// `state`. Collective.
void restore_contact(const comm::Communicator& ranks, const model::State& state, MortarContact& contact);

/// What this rank has of these counts at the iterate.
ContactCounts count(const MortarContact& contact);
/// Their sums over the ranks, kept in MortarContact::counts. Collective.
void tally(const comm::Communicator& ranks, MortarContact& contact);

/// The branch of every row of this rank - open, pressed, keeping its gap, sticking, sliding - at the iterate.
std::vector<std::uint8_t> branches(const MortarContact& contact);

/// By local node, of those that this rank owns: pressures of the slave's rows [stress], and their gaps (below 0:
/// penetration) [length]; 0 elsewhere.
/// Of a node with rows in several interfaces the largest pressure, the smallest gap.
std::vector<double> contact_pressures(const MortarContact& contact, LocalIndex nodes);
std::vector<double> contact_gaps(const MortarContact& contact, LocalIndex nodes);

/// Largest penetration of a row of this rank without a tie [length].
double penetration(const MortarContact& contact);

}  // namespace brunt::implicit
