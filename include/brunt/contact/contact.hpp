// SPDX-License-Identifier: Apache-2.0
// Contact and rigid walls of a run, on all ranks: lists that last, rows, impulses, corrected velocities. All that it
// keeps from step to step and that results depend on is its history, which goes to checkpoints and the state hash.
#pragma once
#include <span>
#include <vector>

#include "brunt/comm/communicator.hpp"
#include "brunt/contact/contact_ledger.hpp"
#include "brunt/contact/data/history.hpp"
#include "brunt/contact/driven.hpp"
#include "brunt/contact/join_surface.hpp"
#include "brunt/contact/list_motion.hpp"
#include "brunt/contact/lists.hpp"
#include "brunt/contact/node_views.hpp"
#include "brunt/contact/settings.hpp"
#include "brunt/contact/step_data.hpp"
#include "brunt/contact/surface/surface.hpp"
#include "brunt/contact/surface_nodes.hpp"
#include "brunt/contact/ties.hpp"
#include "brunt/mesh/local_mesh.hpp"

namespace brunt::contact {

struct Contact {
  comm::Communicator ranks;
  const ContactSettings settings;
  DerivedSettings derived;
  Surface surface;
  std::vector<BodyFigures> bodies_at_start;  ///< decide for the whole run who is slave
  std::vector<Wall> walls_at_start;
  SurfaceNodes surface_nodes;
  ContactLists lists{};
  ListState list_state{};
  StepData step{};
  History history{};  ///< of the last step, on this rank
  TiedParts tied{};
  std::vector<DrivenMeeting> driven{};  ///< found on this rank
  ContactLedger ledger{};
  bool elements_are_gone = false;  ///< on any rank: then nodes may lie behind faces from the start, see births.hpp
  bool births_due = false;         ///< the surface has changed since rows were last found
};

/// excluded: one flag for each of mesh.faces (faces in a symmetry plane). inverse_mass: of the mesh's local nodes.
/// walls: at the start. Collective.
Contact make_contact(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, std::span<const char> excluded,
                     std::span<const double> inverse_mass, std::span<const ConstrainedNode> constrained,
                     std::span<const Wall> walls, ContactSettings settings);

/// Carriers of a step's contact nodes.
inline Carriers carriers_of(const Contact& contact, const StepInput& input) {
  return {contact.step.nodes.carried, input.bodies};
}

/// Elements have been removed: the surface and all that follows from it for what is left of the bodies. Who is slave
/// and the lengths that tolerances are made of stay as they were at the start; so do history, sums and ties but those
/// of which the face or the slave's elements are gone. A function of the start and of which elements live. Collective.
void update_surface(Contact& contact, const mesh::LocalMesh& mesh, const Remains& remains,
                    std::span<const double> inverse_mass, std::span<const ConstrainedNode> constrained);

/// Rebuilds the lists where the motion they allow is used up. Once a step, before `correct`. velocities: of all ranks;
/// their bounds tell for most steps that the lists hold (see ListMotion). Collective.
void search(Contact& contact, const StepInput& input, const VelocitySpan& velocities);

/// Replaces v* by v = v* + W G^T impulses on every local node, the same bits on every copy. Collective.
void correct(Contact& contact, const StepInput& input);

/// Impulse [momentum] of the last step on each node owned here is added to `impulse` (a row a local node of the mesh),
/// held components included: what the step books as reaction of fixed and prescribed nodes.
void add_impulses(const Contact& contact, std::span<Vec3> impulse);

/// Energy that the second half of the last step's impulses took, p . v_{n+1/2} / 2: the sums hold whole steps, a ledger
/// at t_n takes this off. Of this rank.
void add_second_half(const Contact& contact, WorkSums& half);

/// Of the last step, by local node of the mesh, for slaves owned here, zero elsewhere: impulse over dt and the area
/// around the node [stress], on walls where ContactSettings::wall_pressures asks for it; smallest gap [length].
std::vector<double> pressures(const Contact& contact, double dt);
std::vector<double> gaps(const Contact& contact);

/// The history's records of this rank.
HistoryTables history_tables(const Contact& contact);
/// Takes over records that lie anywhere, each on one rank; each goes to where its rows are made. Collective.
void restore_history(const HistoryTables& tables, Contact& contact);

ContactTotals collect(const Contact& contact);              ///< collective
RubbingRow most_given_by_friction(const Contact& contact);  ///< in the last step, on this rank, but for ties
TiedNodes tied_nodes(const Contact& contact);               ///< of all ranks; collective

}  // namespace brunt::contact
