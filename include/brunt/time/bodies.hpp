// SPDX-License-Identifier: Apache-2.0
// Rigid bodies in a step: forces on them, their motion, and that of their nodes.
//
// Every rank moves all bodies, with the same bits, since the force and the moment on a body are exact sums over the
// ranks. Between steps nodes of bodies have the velocity (x_{n+1} - x_n)/dt, the motion that elements see; within a
// step (between `predict_bodies` and `move_bodies`) that of the body at x_n, by which works are booked.
#pragma once
#include "brunt/contact/data/carriers.hpp"
#include "brunt/contact/enforcement/carried.hpp"
#include "brunt/contact/list_motion.hpp"
#include "brunt/model/model.hpp"
#include "brunt/time/links.hpp"
#include "brunt/time/motion.hpp"

namespace brunt::time {

/// Completes what each rank knows of the bodies: their motion at the start, planes of symmetry, supports, the nodes on
/// which forces may act. Collective.
void link_bodies(const comm::Communicator& ranks, model::Model& model);

/// Mass, centre and inertia of all bodies, and the arms of their nodes. joined: by node, the mass of deformable
/// elements. Collective.
void weigh_bodies(const comm::Communicator& ranks, model::Model& model, std::span<const Quad> joined);

/// Velocities of the start, less what supports hold, of bodies and their nodes.
void start_bodies(const model::Model& model, model::State& state);

/// Forces and moments at t_n into scratch.bodies: of deformable elements, pressure and dead loads summed over the
/// nodes, gravity at the centres. One reduction for all bodies together; none where no element or load acts on their
/// nodes. Collective.
void sum_body_forces(const model::Model& model, const model::State& state, model::Scratch& scratch, Links& links);

/// Gravity acts on a body as a whole: takes it off the loads of its nodes.
void clear_body_loads(const model::Model& model, model::Scratch& scratch);

/// Momenta and velocities after the step but for contact, and those of the bodies' nodes, with scratch.before. How fast
/// these nodes are is added to `velocities`.
void predict_bodies(const model::Model& model, model::State& state, model::Scratch& scratch, const Interval& step,
                    contact::VelocitySpan& velocities);

/// How bodies answer impulses: mass damping is part of it, and nothing along what supports hold.
void carriers_of_bodies(const model::Model& model, const model::Scratch& scratch, double drag,
                        std::vector<contact::Carrier>& carriers);

/// Adds what contact has given to the bodies (an answer each), and to their nodes where works on these are booked.
void push_bodies(const model::Model& model, std::span<const contact::BodyAnswer> answers, double drag,
                 model::State& state, model::Scratch& scratch);

/// After contact: works and impulses.
void book_bodies(const model::Model& model, model::State& state, const model::Scratch& scratch, const Interval& step);

/// To t_{n+1}, with their nodes.
void move_bodies(const model::Model& model, model::State& state, const model::Scratch& scratch, double dt);

/// Calls visit(place in body.nodes, node).
template <class Visit>
void for_nodes(const model::RigidBody& body, Visit&& visit) {
  for (std::size_t k = 0; k < body.nodes.size(); ++k) visit(k, static_cast<std::size_t>(body.nodes[k]));
}

}  // namespace brunt::time
