// SPDX-License-Identifier: Apache-2.0
// Contact and rigid walls of a run, on all ranks: candidate lists, rows, impulses, corrected velocities. Only the
// history carries data between steps on which results depend; it is saved in checkpoints and hashed.
#pragma once
#include <span>
#include <vector>

#include "comm/communicator.hpp"
#include "contact/anchors/ties.hpp"
#include "contact/contact_ledger.hpp"
#include "contact/data/history.hpp"
#include "contact/driven.hpp"
#include "contact/joined/join_surface.hpp"
#include "contact/lists/list_motion.hpp"
#include "contact/lists/lists.hpp"
#include "contact/node_views.hpp"
#include "contact/settings.hpp"
#include "contact/step_data.hpp"
#include "contact/surface/surface.hpp"
#include "contact/surface_nodes.hpp"
#include "contact/unmet.hpp"
#include "mesh/local_mesh.hpp"

namespace brunt::contact {

struct Contact {
  comm::Communicator ranks;
  const ContactSettings settings;
  DerivedSettings derived;
  Surface surface;
  std::vector<BodyFigures> bodies_at_start;  ///< determine the slave for the whole run
  std::vector<Wall> walls_at_start;
  SurfaceNodes surface_nodes;
  ContactLists lists{};
  ListState list_state{};
  StepData step{};
  History history{};  ///< of the last step, on this rank
  TiedParts tied{};
  std::vector<DrivenMeeting> driven{};  ///< found on this rank
  Unmet unmet{};                        ///< rows of the last step that cannot be satisfied
  ContactLedger ledger{};
  bool elements_are_gone = false;  ///< on any rank: nodes may then lie behind faces from the start, see births.hpp
  bool births_due = false;         ///< the surface has changed since rows were last determined
};

/// excluded: one flag for each of mesh.faces (faces in a symmetry plane). inverse_mass: of the mesh's local nodes.
/// walls: at the start. Collective.
Contact make_contact(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, std::span<const char> excluded,
                     std::span<const double> inverse_mass, std::span<const ConstrainedNode> constrained,
                     std::span<const Wall> walls, ContactSettings settings);

/// Carriers of the contact nodes in a step.
inline Carriers carriers_of(const Contact& contact, const StepInput& input) {
  return {contact.step.nodes.carried, input.bodies, input.coupled};
}

/// After a removal of elements: recomputes the surface of the remaining bodies and all data that follow from it. The
/// choice of slaves and the lengths in tolerances keep their initial values. History, sums and ties are kept, except
/// ties whose face or slave elements were removed. The result depends on the start and the remaining elements only.
/// Collective.
void update_surface(Contact& contact, const mesh::LocalMesh& mesh, const Remains& remains,
                    std::span<const double> inverse_mass, std::span<const ConstrainedNode> constrained);

/// Rebuilds the lists if their admissible motion is used up. Called once in each step, before `correct`. velocities: of
/// all ranks; in most steps their bounds prove that the lists are valid (see ListMotion). Collective.
void search(Contact& contact, const StepInput& input, const VelocitySpan& velocities);

/// Replaces v* by v = v* + W G^T impulses on every local node, with the same bits on every copy. Collective.
void correct(Contact& contact, const StepInput& input);

/// Adds the impulse [momentum] of the last step on each node owned here to `impulse` (one entry for each local node of
/// the mesh), including constrained components: the step records these as reactions of fixed and prescribed nodes.
void add_impulses(const Contact& contact, std::span<Vec3> impulse);

/// Energy taken by the second half of the last step's impulses, p . v_{n+1/2} / 2, on this rank. The sums contain
/// complete steps; a ledger at t_n subtracts this value.
void add_second_half(const Contact& contact, WorkSums& half);

/// Of the last step, by local node of the mesh, for slaves owned here, zero elsewhere: impulse divided by dt and by the
/// area around the node [stress], on walls if ContactSettings::wall_pressures is set; smallest gap [length].
std::vector<double> pressures(const Contact& contact, double dt);
std::vector<double> gaps(const Contact& contact);

/// The history's records of this rank.
HistoryTables history_tables(const Contact& contact);
/// Restores records that may be on any rank, each on one; each is sent to the rank that creates its rows. Collective.
void restore_history(const HistoryTables& tables, Contact& contact);

ContactTotals collect(const Contact& contact);              ///< collective
RubbingRow most_given_by_friction(const Contact& contact);  ///< in the last step, on this rank, but for ties
TiedNodes tied_nodes(const Contact& contact);               ///< of all ranks; collective

}  // namespace brunt::contact
