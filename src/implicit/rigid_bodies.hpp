// SPDX-License-Identifier: Apache-2.0
// Rigid bodies in implicit steps. A body has six unknowns: the displacement of its centre and a rotation. Its nodes
// have no equations of motion: their rows are the constraints u - d - (R - 1) arm = 0, and their residual forces are
// transferred to the rows of the body by their arms.
//
// Rotations are multiplicative: the orientation of an iterate is exp(ds) times that of the last assembled matrix.
// Unknowns and rows of rotation are scaled by the body's radius of gyration, as arcs [length] and forces. With inertia
// the arms are the means of both ends of the step (rigid/trapezoidal.hpp), otherwise those of its end.
//
// Every rank has all bodies with the same bits; the root has their rows.
#pragma once
#include <Eigen/Geometry>
#include <array>
#include <span>
#include <vector>

#include "comm/exact_sum.hpp"
#include "implicit/data/unknowns.hpp"
#include "implicit/mortar/mortar.hpp"
#include "model/model.hpp"
#include "rigid/trapezoidal.hpp"

namespace brunt::implicit {

struct Scene;
struct Solver;
struct Rule;

/// One body in the current step.
struct BodyTrial {
  // of the step
  Mat3 turn_before = Mat3::Identity();                            ///< R_n
  Vec3 given_shift = Vec3::Zero(), given_turn = Vec3::Zero();     ///< prescribed displacement [length], angles [rad]
  Vec3 given_velocity = Vec3::Zero(), given_spin = Vec3::Zero();  ///< at t_{n+1}
  Vec3 gravity = Vec3::Zero(), gravity_before = Vec3::Zero();     ///< the body's weight [force]
  // at the last assembled matrix
  Vec3 base_arc = Vec3::Zero();  ///< unknowns of rotation at that matrix [length]
  Eigen::Quaterniond base = Eigen::Quaterniond::Identity();
  // at the iterate
  Vec3 arc = Vec3::Zero();
  Vec3 displacement = Vec3::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity(), turn = orientation;  ///< R, R R_n^T
  Mat3 turn_now = Mat3::Identity();                                                     ///< R
  rigid::MomentumAfter momentum;                                                        ///< if the scheme has inertia
  model::Wrench left;           ///< residual of all nodes, without supports: minus the applied forces [force]
  Mat3 by_arms = Mat3::Zero();  ///< derivative of the residual moment by a small rotation, at constant forces
};

struct RigidBodies {
  /// An own node of a body.
  struct Place {
    LocalIndex body = no_index;
    bool forced = false;      ///< elements or loads may act on it
    Vec3 arm = Vec3::Zero();  ///< X minus the body's centre [length]
  };
  GlobalIndex first = 0;         ///< row of the system of the first body's first unknown
  bool rows_here = false;        ///< this rank has the bodies' rows
  std::size_t first_here = 0;    ///< its place in Solver::u
  std::vector<double> radius;    ///< of gyration, a body each [length]
  std::vector<double> at_walls;  ///< stiffness of walls at a node times dt^2, for each body [mass]
  std::vector<BodyTrial> trial;  ///< for each body
  std::vector<Place> place;      ///< by place in Unknowns::node; empty without bodies
  std::vector<comm::ExactAccumulator> sums;

  [[nodiscard]] bool any() const { return !trial.empty(); }
  [[nodiscard]] bool carries(std::size_t own) const { return any() && place[own].body != no_index; }
  [[nodiscard]] std::vector<GlobalIndex> own_rows() const;  ///< six for each body on the root
};
constexpr std::size_t body_unknowns = 6;

/// first: row of the system after those of nodes and multipliers; first_here: likewise of this rank's unknowns.
RigidBodies make_bodies(const comm::Communicator& ranks, const model::Model& model, const Unknowns& unknowns,
                        GlobalIndex first, std::size_t first_here);

/// Walls act on nodes of bodies by springs. After make_walls. Collective.
void soften_walls(const comm::Communicator& ranks, const model::Model& model, Solver& solver);

/// Stiffness of springs for a step of the trial's length; a spring under load keeps its own, since another one would
/// change the energy that it has stored. After begin_walls.
void fit_wall_springs(Solver& solver);

/// Prescribed motion in the step from t_n, and the first iterate: bodies continue their motion, or stay at their
/// position of t_n.
void begin_bodies(const Scene& scene, Solver& solver, bool still);

/// Bodies and their nodes (Trial::displacement) at these unknowns. Collective.
void place_bodies(const Scene& scene, Solver& solver, std::span<const double> u);

/// Resets the sums of the residuals at the bodies' nodes.
void begin_left(RigidBodies& bodies);
/// Adds the residual at an own node of a body [force].
void leave_to_body(std::size_t own, const Vec3& left, Solver& solver);
/// After all nodes: residuals of the bodies' rows, and their parts of the sums of Balance (left, given, rounding).
/// Collective.
void balance_bodies(const Scene& scene, Solver& solver, std::span<double> residual,
                    std::span<comm::ExactAccumulator, 3> sums);

/// The matrix's rows of bodies and of their nodes: moves the terms of contact in rows of bodies' nodes out of `terms`,
/// and adds the rows of this rank, sorted by row and column. With FrictionLimit::given, supports of bodies are left
/// out. After Stiffness::assemble. Collective.
void body_terms(const Scene& scene, Solver& solver, FrictionLimit limit, std::vector<ContactTerm>& terms);

/// Resets the sums of impulses.
void begin_impulses(RigidBodies& bodies);
/// Adds the impulse on an own node of a body in the accepted step [momentum].
void book_impulse(std::size_t own, const Vec3& impulse, Solver& solver);
/// Advances bodies to t_{n+1}, with the velocities of their nodes; works and impulses. Collective.
void commit_bodies(const Scene& scene, Solver& solver);

/// Data of the bodies for probes of parts between steps: model::Scratch::bodies at t_n.
void show_bodies(const model::Model& model, const model::State& state, model::Scratch& scratch);

}  // namespace brunt::implicit
