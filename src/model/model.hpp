// SPDX-License-Identifier: Apache-2.0
// The data of a run: Model is constant during the run, State changes with every step, Scratch is sized once and carries
// nothing from one step to the next.
#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "core/aligned.hpp"
#include "mesh/local_mesh.hpp"
#include "model/body_joint.hpp"
#include "model/element_block.hpp"
#include "model/loads.hpp"
#include "model/rigid_body.hpp"
#include "model/rotations.hpp"
#include "model/supports.hpp"
#include "model/touching.hpp"

namespace brunt::model {

/// One cache line for each node, so that an element gathers a corner with one load.
struct alignas(64) NodeLine {
  double x[3];      ///< current position, reference + displacement [length]
  double mass;      ///< lumped [mass]
  double v[3];      ///< velocity at the half step [length/time]
  double deferred;  ///< 1: the node is finished after contact and constraints, not with the free ones; or `dropped`
  static constexpr double dropped =
      2;  ///< the node was removed with its last element: it moves on, and nothing acts on it
  [[nodiscard]] bool is_dropped() const { return deferred == dropped; }
  [[nodiscard]] Quad& x_mass() { return *reinterpret_cast<Quad*>(x); }
  [[nodiscard]] Quad& v_late() { return *reinterpret_cast<Quad*>(v); }
};

/// Elements that are removed in the first step at or after a given time.
struct Removal {
  double at = 0;            ///< [time]
  bool keeps_nodes = true;  ///< nodes without an element stay as mass points, else they are dropped
  std::vector<std::vector<LocalIndex>> elements;  ///< by block, ascending
};

/// What may leave the model.
struct Losses {
  std::vector<Removal> removals;      ///< by time
  std::vector<char> erodes;           ///< by block: may it lose elements, on any rank?
  std::vector<LocalIndex> uncovered;  ///< nodes of elements that may be removed, ascending: also of other ranks' ones
};

/// A corner of an element whose force is available in Scratch::slots.
struct WatchedCorner {
  LocalIndex element = 0, node = 0, slot = 0;  ///< element: of its block
};

/// Nodes of several parts, where the energies of parts are asked for.
struct BetweenParts {
  bool booked = false;                              ///< such nodes exist, on any rank
  std::vector<LocalIndex> nodes;                    ///< ascending
  std::vector<std::vector<WatchedCorner>> corners;  ///< on those nodes: by block, ascending by element
};

struct Model {
  mesh::LocalMesh mesh;
  std::vector<ElementBlock> blocks;
  AlignedVector<Quad> reference;        ///< X of each node; the fourth is unused
  std::vector<LocalIndex> owned;        ///< nodes this rank owns
  std::vector<GlobalIndex> block_size;  ///< elements of each block on all ranks

  std::vector<RigidBody> bodies;  ///< the same on all ranks, by block
  std::vector<BodyJoint> joints;  ///< between them; supports of points behind those of the scene
  std::vector<rigid::JointGroup> joint_groups;

  Supports supports;
  Supports rotation_supports;       ///< of rotations of nodes
  std::vector<LocalIndex> turning;  ///< nodes that turn, ascending; found with their inertia
  Loads loads;
  bool relaxes = false;  ///< a phase before t = 0 finds the static state
  Touching touching;
  Losses losses;

  std::vector<LocalIndex> deferred;  ///< nodes finished after contact and constraints, ascending
  std::vector<LocalIndex> watched;   ///< nodes of which every corner force stays in Scratch::slots, ascending
  BetweenParts between_parts;
  [[nodiscard]] LocalIndex nodes() const { return static_cast<LocalIndex>(mesh.node_gid.size()); }
  [[nodiscard]] bool has_gravity() const { return loads.gravity.squaredNorm() > 0; }
  [[nodiscard]] bool damped() const { return loads.damping.alpha > 0; }
  /// Whether elements may be removed, by entries of the scene or by erosion.
  [[nodiscard]] bool any_erosion() const {
    for (const ElementBlock& block : blocks)
      if (block.erosion) return true;
    return false;
  }
  /// Whether a part of the model, on any rank, is a shell.
  [[nodiscard]] bool turns() const {
    return std::ranges::any_of(blocks, [](const ElementBlock& block) { return block.turns(); });
  }
  [[nodiscard]] bool loses_elements() const { return !losses.removals.empty() || any_erosion(); }
  /// Whether the work of loads is recorded. The search for a static state needs it even without loads.
  [[nodiscard]] bool loaded() const {
    return has_gravity() || damped() || relaxes || !loads.pressure.empty() || !loads.dead.empty();
  }
};

/// Progress of the search for the static state before t = 0 (time/relaxation): integers and energies.
struct Relaxation {
  double under_way = 0;      ///< not 0: the run has not begun; what the next step does (time/relaxation)
  double steps = 0;          ///< of the phase
  double stage = 1;          ///< loads stand at stage / relaxation_stages
  double peak = 0;           ///< largest kinetic energy since the nodes were last stopped [energy]
  double peak_step = 0;      ///< step of the phase at which it was
  double swing_start = 0;    ///< step of the phase at which they were
  double longest_swing = 0;  ///< between two stops [steps]
  double quiet_since = 0;    ///< step of the phase since when no swing was too large
  double residual = 1;       ///< unbalanced forces over loads at the last stop
};
constexpr int relaxation_values = 9;

/// Data that depend on State::alive: recomputed by time::follow_alive whenever a flag changes, never saved.
struct Living {
  std::vector<std::vector<std::uint8_t>> lanes;  ///< by block and batch, a bit a lane; empty where all elements live
  std::vector<std::vector<char>> pressed;        ///< by pressure load and face: its element lives; empty where all do
  std::vector<LocalIndex> dropped;               ///< nodes that left with their last element, ascending
};

struct State {
  double time = 0;          ///< t_n
  double time_before = -1;  ///< t_{n-1}
  double dt = 0;            ///< t_n - t_{n-1}: of the step that led here; 0 before the first
  double step = 0;          ///< n, a whole number
  /// Largest 1 / (stable step) so far in the span of steps under way, and that of the whole span before it [1/time].
  double rate_now = 0, rate_before = 0;
  /// u_n, the state of the motion. The fourth component is the work of the elements' forces on the node up to
  /// v_{n-1/2}, where all work is impulse . (v_before + v_after)/2.
  AlignedVector<Quad> displacement;
  AlignedVector<NodeLine> nodes;               ///< x_n = X + u_n and v_{n-1/2}
  std::vector<AlignedVector<double>> history;  ///< per block: [batch][component][lane]
  std::vector<double> load_work;               ///< gravity, pressure; empty where the scene has none
  std::vector<double> damping_work;            ///< of the drag on the mean velocity, never > 0; empty without damping
  std::vector<double> reaction_work;           ///< of fixed and prescribed nodes; empty where the scene has none
  std::vector<double> load_impulse;            ///< three a node: gravity, pressure, damping
  std::vector<double> reaction_impulse;        ///< three a node: fixed and prescribed
  AlignedVector<RotationLine> rotations;       ///< by node; empty without shells
  std::vector<RotationAccount> rotation_accounts;  ///< likewise
  std::vector<rigid::BodyState> bodies;            ///< of Model::bodies, the same on all ranks
  std::vector<BodyAccount> body_accounts;          ///< likewise
  std::vector<JointAccount> joint_accounts;        ///< of Model::joints, likewise
  std::vector<double> wall_position;               ///< travel of each wall along its normal
  /// By block and element: work of its forces on nodes of several parts; empty unless energies of parts are asked for.
  std::vector<std::vector<double>> interface_work;
  /// By block and element: 1; 0 once it has been removed, -1 if its nodes are dropped with it. Empty for blocks that
  /// never lose an element.
  std::vector<std::vector<double>> alive;
  /// By block and element, empty likewise: work of its forces on all its nodes up to v_{n-1/2}. Its negative is the
  /// energy of the element, which becomes eroded energy when the element is removed.
  std::vector<std::vector<double>> element_work;
  Living living;
  Relaxation relaxation;
  /// Three a node, of the phase alone: force of contact, walls and supports in the step before the nodes are stopped.
  std::vector<double> held_force;
  std::vector<Wrench> held_wrench;  ///< likewise, of each body
};

struct Scratch {
  AlignedVector<Quad> force;    ///< minus the internal force; the fourth is unused
  AlignedVector<Quad> load;     ///< gravity, pressure; empty where the scene has neither these nor damping
  AlignedVector<double> slots;  ///< unsummed corner forces of border nodes, four each
  /// By node, empty without shells: minus the internal moments, moments of loads, and rates of rotation at n - 1/2; the
  /// fourth components are unused.
  AlignedVector<Quad> moment, moment_load, rate_before;
  AlignedVector<double> moment_slots;  ///< unsummed corner moments of border nodes, as `slots`
  /// Of blocks that may lose elements, else empty: forces of their elements on the corners at t_n (of shells also
  /// moments), [batch][component][corner][lane]; their power with v_{n-1/2}, [batch][lane]; and, by element, the half
  /// of the last step's work that was done with v_{n+1/2}.
  std::vector<AlignedVector<double>> element_force, element_power;
  std::vector<std::vector<double>> last_work;
  /// Of blocks that erode, else empty: for each element at t_n, 1 / (stable step) and the volume relative to the
  /// reference, [batch][2][lane].
  std::vector<AlignedVector<double>> element_bounds;
  std::vector<Vec3> before;           ///< v_{n-1/2} of the deferred nodes (with damping: of all), by node; or empty
  std::vector<Vec3> reaction;         ///< impulse of each constrained node in this step
  std::vector<BodyStep> bodies;       ///< of Model::bodies
  std::vector<JointStep> joints;      ///< of Model::joint_groups
  std::vector<Vec3> contact_impulse;  ///< by node; empty unless contact or walls meet constrained nodes
};

}  // namespace brunt::model
