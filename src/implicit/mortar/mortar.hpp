// SPDX-License-Identifier: Apache-2.0
// Mortar contact in an implicit step. A row belongs to the owner of its slave node, which has the slave facets around
// the node and the master facets that these may meet. Contributions of a row to nodes of other ranks are sent to their
// owners, which add them in the order of facets and rows. A facet on the border between ranks is integrated on both
// sides.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "comm/halo.hpp"
#include "contact/mortar/friction.hpp"
#include "contact/mortar/interface.hpp"
#include "contact/mortar/tie.hpp"
#include "contact/search/facet_tree.hpp"
#include "implicit/data/unknowns.hpp"
#include "implicit/mortar/block_sums.hpp"
#include "implicit/mortar/self_contact.hpp"
#include "model/model.hpp"

namespace brunt::implicit {

/// Nodes of the facets on this rank. Those up to `lasting` remain throughout, in canonical order: nodes of its own
/// surfaces, of slave facets around its rows, of its ties. They are followed, also in canonical order, by those of near
/// masters of other ranks.
struct ContactNodes {
  std::vector<GlobalIndex> gid;
  std::size_t lasting = 0;
  std::vector<comm::RemoteSlot> source;  ///< for each: its owner, and its local index there
  std::vector<LocalIndex> own;           ///< for each: its place in Unknowns::node if this rank owns it, or no_index
  std::vector<Mat3> rows;  ///< for each of this rank: factor of its rows, without the directions of supports and walls
  std::vector<Mat3> free;  ///< for each: projector onto the directions left free by supports
  std::vector<Mat3> movable;          ///< likewise by supports and walls, as last exchanged
  std::vector<std::uint8_t> several;  ///< for each: whether surfaces of several interfaces contain it
  comm::Halo gather;                  ///< from all ranks' nodes to these
  std::vector<Vec3> reference;        ///< of lasting ones, in the initial configuration [length]
  std::vector<Vec3> x;                ///< at the iterate [length]
  std::vector<Vec3> x_before;         ///< at t_n [length]
  std::vector<Vec3> x_told;           ///< of lasting ones, at the last exchange of masters [length]
  std::vector<Vec3> force;            ///< of contact at the iterate, on nodes that this rank owns [force]
  std::vector<Vec3> friction_force;   ///< of it, the tangential part

  [[nodiscard]] LocalIndex place_of(GlobalIndex node) const;  ///< no_index if this rank does not have it
};

/// Facets of a master that belong to elements of this rank, which sends them to others.
struct OwnMasters {
  std::vector<GlobalIndex> key;
  std::vector<contact::FacetNodes> nodes;    ///< places in ContactNodes
  std::vector<double> wall;                  ///< as MortarSurfaces::master_wall
  std::vector<contact::PatchNumbers> patch;  ///< for rows of points: of the smooth patches around its corners
};

/// Share of a row's area at which its equation is half that of a pressed row: `Interface::fades`. Its pressure is then
/// of the order of those beside it; the edge that covers it has advanced by a hundredth of a facet.
constexpr double sliver = 1e-4;

/// Share of the equation z = 0 in the rows of nodes of sharp edges: they are springs of 1/compliance times the
/// stiffness of a layer of one facet. Where surfaces are flat at an edge, a mortar row requires the same as the node's
/// row; of two equations that say the same one must yield. A node sinks in by this share of a facet's edge at a
/// pressure of Young's modulus.
constexpr double compliance = 1e-4;

/// Search and pairs of one interface.
struct PairSearch {
  contact::KdopTree slave, master;
  contact::TraversalScratch scratch;
  contact::TraversalCounts counts;
  bool anew = true;       ///< the trees must be built
  double built_with = 0;  ///< tests per pair when the trees were built
  std::vector<contact::FacetPair> pairs;
  Ragged<LocalIndex> candidates;  ///< for each slave facet
};

/// Where the rows of an interface stand among those of all ranks, and in the system.
struct RowNumbering {
  std::vector<LocalIndex> place;  ///< of each row among those of all ranks
  std::size_t rows_of_all = 0;    ///< number of rows of all ranks
  comm::Halo to_all;              ///< from the rows of all ranks to all rows in order: for sums and what is saved
  comm::Halo beside;              ///< from the rows of all ranks to surfaces.rows_elsewhere
  GlobalIndex first = 0;          ///< row, in the whole system, of the first multiplier
};

/// Of the rows of an interface at the iterate.
struct InterfaceIterate {
  contact::MortarRows rows;
  contact::MortarSlopes slopes;
  std::vector<double> z;  ///< pressures, one for each row; for ties three multipliers [force/length^2]
  std::vector<std::uint8_t> active;
  std::vector<Vec3> tractions;
  std::vector<contact::FrictionState> states;
  contact::NodeBlocks<Mat3> levers;      ///< of ties with a gap, for their forces [length^2]
  contact::NodeBlocks<Vec3> gap_levers;  ///< if consistent: of the rows, for their forces [length^2]
  contact::Patches lever_patches;        ///< likewise the derivatives of these forces
};

/// Gaps that rows may keep in a step, weighted [length^3].
struct LeastGaps {
  std::vector<double> at_start;              ///< of these rows at the positions of t_n; empty unless kept
  std::vector<double> required;              ///< by the rows; empty: zero
  std::vector<double> by_start, by_covered;  ///< derivatives of `required` by at_start and by area
};

/// Of the rows in the initial configuration.
struct InterfaceStart {
  contact::TieStart tie;
  std::vector<Mat3> tied;             ///< of ties, for each row: projector onto the directions of its multipliers
  std::vector<Mat3> given_apart;      ///< likewise those along which the slave and its projection are both constrained
  std::vector<std::uint8_t> touches;  ///< rows that touch initially: active from the first iterate on
  bool first_iterate = false;         ///< of the run: touching rows are stiff there
};

struct Interface {
  contact::MortarPair pair;
  std::size_t of_pair = 0;           ///< number in Model::touching.mortar, which may have several interfaces
  bool first_of_pair = true;         ///< of these
  bool of_points = false;            ///< rows of nodes of sharp edges on facets; otherwise of facets on facets
  contact::MortarSurfaces surfaces;  ///< of this rank; nodes: places in ContactNodes, rows: of nodes that it owns
  contact::MortarTopology topology;
  std::optional<SelfContact> self;     ///< if the slave and the master are one part
  std::vector<GlobalIndex> slave_key;  ///< of the slave facets
  OwnMasters own_masters;
  PairSearch search;
  contact::MortarScratchPointer scratch;
  RowNumbering numbering;
  double stiffness = 0;  ///< of a layer with the thickness of one facet [force/length^3]
  contact::MortarFriction friction;
  InterfaceIterate iterate;
  LeastGaps least;
  contact::FrictionHistory history;          ///< of t_n
  std::vector<std::uint8_t> pressed_before;  ///< at t_n
  InterfaceStart start;

  [[nodiscard]] int multipliers() const {  ///< unknowns of each row
    return pair.tied ? 3 : pair.enforce == contact::MortarPair::Enforce::penalty ? 0 : 1;
  }
  [[nodiscard]] bool presses() const { return !pair.tied; }
  /// Whether its equations hold exactly, so that they may contradict or repeat others.
  [[nodiscard]] bool is_exact() const { return multipliers() > 0 && !of_points; }
  /// Whether forces are the gradient of the weighted gaps.
  [[nodiscard]] bool consistent() const { return pair.consistent && !pair.tied; }
  /// Mean over the covered part of the row [length]; 0 if nothing is covered.
  [[nodiscard]] double mean_gap(std::size_t row) const {
    return iterate.rows.covered[row] > 0 ? iterate.rows.gaps[row] / iterate.rows.covered[row] : 0.0;
  }
  /// Gap minus the gap required by the row, weighted [length^3].
  [[nodiscard]] double above(std::size_t row) const {
    return iterate.rows.gaps[row] - (least.required.empty() ? 0.0 : least.required[row]);
  }
  /// Least share of the equation z = 0 in that of a pressed row.
  [[nodiscard]] double yields() const { return of_points ? compliance : 0.0; }
  /// This share, up to 1: 1 - 1e-12 at 1e-6 of the row's area, 1e-12 at 1e-2 (more than the least share). A row that
  /// begins to be covered would otherwise need any pressure, however high, to close the gap of its sliver.
  [[nodiscard]] double fades(std::size_t row) const {
    const double covered = topology.kappa[row] * iterate.rows.covered[row] / sliver, square = covered * covered;
    return yields() + (1 - yields()) / (1 + square * square * square);
  }
  /// Derivative of `fades` by the covered area [1/length^2].
  [[nodiscard]] double fades_by_covered(std::size_t row) const {
    const double share = (fades(row) - yields()) / (1 - yields());
    return share < 1 ? -6 * (1 - yields()) * share * (1 - share) / iterate.rows.covered[row] : 0.0;
  }
  /// Derivative of a pressed row's equation by its weighted gap, without sign [force/length^3].
  [[nodiscard]] double by_gap(std::size_t row) const {
    return (1 - fades(row)) * stiffness / (topology.kappa[row] * iterate.rows.covered[row]);
  }
  /// Whether gaps of t_n are kept: for exact multipliers with a scheme whose contact force acts at the end of the step.
  [[nodiscard]] bool keeps(const struct MortarContact& contact) const;
  [[nodiscard]] std::size_t count() const { return surfaces.rows.size(); }  ///< rows of this rank
  /// Row of the whole system.
  [[nodiscard]] GlobalIndex multiplier(std::size_t row, int k = 0) const {
    return numbering.first + static_cast<GlobalIndex>(multipliers()) * numbering.place[row] + k;
  }
};

/// Sums of contact over all ranks.
struct ContactCounts {
  GlobalIndex segments = 0, pairs = 0, tests = 0;
  GlobalIndex active = 0;    ///< active rows, and rows of ties
  GlobalIndex touching = 0;  ///< of these, rows without ties
};

struct MortarContact {
  ContactNodes nodes;
  std::vector<Interface> interfaces;
  /// FacetRole of the facets of parts in contact with themselves, in the step to t_n: saved.
  std::vector<double> roles_before{};
  bool keeps_gaps = false;              ///< rows with a negative gap at t_n keep it, apart from the recovered part
  bool mean_levers = false;             ///< ties over a gap act through the mean positions of the step
  double budget = 0;                    ///< largest energy supplied by recovery in this step, by its estimate [energy]
  double recovery = 0;                  ///< share of `recovered` in this step, 0 to 1
  double travel = 0;                    ///< largest displacement of nodes until the next exchange of masters [length]
  bool shares_nodes = false;            ///< on some rank there are ContactNodes::several
  bool may_imply = false;               ///< rows may be redundant even without walls: shared nodes, slaves at supports
  std::vector<std::string> notes{};     ///< of the set-up: omitted multipliers and the reasons
  std::vector<std::string> warnings{};  ///< of the set-up
  std::vector<double> z_before{};       ///< multipliers of all interfaces at t_n, the same on every rank: saved
  std::vector<double> traction_before{};  ///< tangential tractions at t_n of all rows with friction, three each: saved
  std::vector<double> impulses{};         ///< of interfaces on their slaves since t = 0, an InterfaceForce each: saved
  std::vector<double> forces_before{};    ///< likewise the forces at t_n: saved
  std::vector<GlobalIndex> own_rows;  ///< multipliers whose slave node this rank owns: rows of the system, ascending
  std::vector<LocalIndex> own;        ///< their places in `z_before`
  ContactCounts counts{};             ///< at the last call of `tally`
  BlockSums sums{};                   ///< for each of `nodes`: contributions of contact to its rows of the matrix
  [[nodiscard]] bool any() const { return !interfaces.empty(); }
  /// Positions from which the levers of ties turn in the step; none: those of the iterate alone.
  [[nodiscard]] std::span<const Vec3> levers_from() const {
    return mean_levers ? std::span<const Vec3>(nodes.x_before) : std::span<const Vec3>();
  }
};

inline bool Interface::keeps(const MortarContact& contact) const {
  return contact.keeps_gaps && multipliers() == 1;
}

/// Interfaces of Model::touching.mortar. Throws InputError if two surfaces cannot form one. Collective.
MortarContact make_mortar(const comm::Communicator& ranks, const model::Model& model, const Unknowns& unknowns);

/// Positions of the nodes of contact at X + u, and multipliers `own_z` of this rank; exchanges masters that have come
/// near. Collective.
void gather_contact(const comm::Communicator& ranks, const model::State& state, std::span<const double> own_z,
                    MortarContact& contact);

/// The kind of iterate of find_contact.
enum class Iterate : std::int8_t {
  later,
  first_of_step,  ///< the predictor: pressures are those of t_n, and recovery is chosen
  first_of_run    ///< likewise; rows that touch initially are active
};

/// Pairs, rows, active sets and forces at the gathered positions. Collective.
void find_contact(const comm::Communicator& ranks, MortarContact& contact, Iterate iterate);

/// Omits redundant multipliers: those of rows that cannot be satisfied or that are implied by others along the
/// directions that are free at the iterate. Their equations set them to zero. movable: for each node of contact that
/// this rank owns, projector onto the directions left free by supports and walls. To be called after find_contact.
/// Collective.
void leave_out_redundant(const comm::Communicator& ranks, std::span<const Mat3> movable, MortarContact& contact);

/// For each node of contact that this rank owns: projector onto directions along which walls constrain it and supports
/// or walls constrain the projection to which it is tied. The tie transmits its pressure to the projection, so the wall
/// constraint is redundant. movable: as above. Collective.
std::vector<Mat3> carried_by_ties(const comm::Communicator& ranks, std::span<const Mat3> movable,
                                  MortarContact& contact);

/// Energy supplied to the bodies by normal contact in the step, if its force acts at the end of the step [energy].
/// Collective.
double given_in_step(const MortarContact& contact);

/// Residual of each multiplier's equation, as a force: stiffness times gap if active, otherwise pressure times area.
/// For `own`.
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

/// What the matrix takes as the limit of friction of sliding rows and nodes.
enum class FrictionLimit : std::int8_t {
  follows,  ///< it follows the pressure: Newton's matrix
  given     ///< it is a given force, as dead loads are
};

/// Derivatives of the residual with respect to positions and multipliers, for rows of this rank: by row and column,
/// those of one entry in an order that does not depend on the ranks. To be called after find_contact at the same
/// positions. Collective.
void contact_terms(const comm::Communicator& ranks, MortarContact& contact, FrictionLimit limit,
                   std::vector<ContactTerm>& terms);

/// Accepts the step: multipliers, histories of friction. Collective.
void keep_contact(MortarContact& contact);

/// After a restart has filled z_before and traction_before: recomputes the other data of t_n from the positions of
/// `state`. Collective.
void restore_contact(const comm::Communicator& ranks, const model::State& state, MortarContact& contact);

/// The contribution of this rank to the counts at the iterate.
ContactCounts count(const MortarContact& contact);
/// Their sums over the ranks, kept in MortarContact::counts. Collective.
void tally(const comm::Communicator& ranks, MortarContact& contact);

/// The branch of every row of this rank - open, pressed, keeping its gap, sticking, sliding - at the iterate.
std::vector<std::uint8_t> branches(const MortarContact& contact);

/// By local node, for those that this rank owns: pressures of the slave's rows [stress], and their gaps (below 0:
/// penetration) [length]; 0 elsewhere. A node with rows in several interfaces has the largest pressure and the smallest
/// gap.
std::vector<double> contact_pressures(const MortarContact& contact, LocalIndex nodes);
std::vector<double> contact_gaps(const MortarContact& contact, LocalIndex nodes);

/// Largest penetration of a row of this rank without a tie [length].
double penetration(const MortarContact& contact);

}  // namespace brunt::implicit
