// SPDX-License-Identifier: Apache-2.0
// Rigid bodies in a step: forces on them, their motion, and that of their nodes.
//
// Every rank moves all bodies, with the same bits, since the force and the moment on a body are exact sums over the
// ranks. Between steps, nodes of bodies have the velocity (x_{n+1} - x_n)/dt, as elements need it. Within a step
// (between `predict_bodies` and `move_bodies`) they have that of the body at x_n, from which work is computed.
#pragma once
#include "contact/data/carriers.hpp"
#include "contact/enforcement/carried.hpp"
#include "contact/lists/list_motion.hpp"
#include "model/model.hpp"
#include "time/links.hpp"
#include "time/motion.hpp"

namespace brunt::time {

/// Completes the data of the bodies over the ranks: their initial motion, planes of symmetry, supports, and the nodes
/// on which forces may act. Collective.
void link_bodies(const comm::Communicator& ranks, model::Model& model);

/// Mass, centre and inertia of all bodies, and the arms of their nodes. joined: by node, the mass of deformable
/// elements. Collective.
void weigh_bodies(const comm::Communicator& ranks, model::Model& model, std::span<const Quad> joined,
                  std::span<const model::RotationLine> rotations);

/// Initial velocities of bodies and their nodes, without the components that supports constrain.
void start_bodies(const model::Model& model, model::State& state);

/// Forces and moments at t_n to scratch.bodies: deformable elements, pressure and dead loads summed over the nodes,
/// gravity at the centres. One reduction for all bodies together; none if no element or load acts on their nodes.
/// Collective.
void sum_body_forces(const model::Model& model, const model::State& state, model::Scratch& scratch, Links& links);

/// Removes gravity from the loads of the nodes of bodies, since it acts on a body as a whole.
void clear_body_loads(const model::Model& model, model::Scratch& scratch);

/// Momenta and velocities after the step without contact, and those of the bodies' nodes, with scratch.before. The
/// range of the velocities of these nodes is added to `velocities`.
void predict_bodies(const model::Model& model, model::State& state, model::Scratch& scratch, const Interval& step,
                    contact::VelocitySpan& velocities);

/// The mobilities of bodies: they contain mass damping, and are zero along directions that supports constrain. Bodies
/// that joints connect answer together.
void carriers_of_bodies(const model::Model& model, const model::Scratch& scratch, double drag,
                        std::vector<contact::Carrier>& carriers, std::vector<contact::CoupledBodies>& coupled);

/// W of one body at x_n, without its joints.
rigid::Mat6 mobility_of(const model::RigidBody& body, const model::BodyStep& now, double drag);

/// Gives a body an impulse, of which W lets `change` through; the rest acts on its supports.
void push_body(const model::RigidBody& body, const rigid::Vec6& impulse, const rigid::Vec6& change, double drag,
               model::BodyStep& now);

/// Advances a body by the velocities after the step; the turn that supports force is told.
rigid::Gyroscopic advance_body(const model::RigidBody& body, const model::BodyStep& now, double dt,
                               rigid::BodyState& moving);

/// Adds the effect of contact on the bodies (one answer for each), and on their nodes where their work is recorded.
void push_bodies(const model::Model& model, std::span<const contact::BodyAnswer> answers, const Interval& step,
                 model::State& state, model::Scratch& scratch);

/// After contact: work and impulses.
void book_bodies(const model::Model& model, model::State& state, model::Scratch& scratch, const Interval& step);

/// Advances the bodies and their nodes to t_{n+1}.
void move_bodies(const model::Model& model, model::State& state, model::Scratch& scratch, double dt);

/// Calls visit(place in body.nodes, node).
template <class Visit>
void for_nodes(const model::RigidBody& body, Visit&& visit) {
  for (std::size_t k = 0; k < body.nodes.size(); ++k) visit(k, static_cast<std::size_t>(body.nodes[k]));
}

}  // namespace brunt::time
