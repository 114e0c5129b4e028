// SPDX-License-Identifier: Apache-2.0
// What a run is about: Model stays as it is for the whole run, State changes with every step, Scratch is sized once
// and holds nothing from one step to the next.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "brunt/contact/options.hpp"
#include "brunt/core/aligned.hpp"
#include "brunt/mesh/local_mesh.hpp"
#include "brunt/model/element_block.hpp"

namespace brunt::model {

/// One cache line a node, so that an element gathers a corner with one load.
struct alignas(64) NodeLine {
  double x[3];  ///< current position, reference + displacement [length]
  double mass;  ///< lumped [mass]
  double v[3];  ///< velocity at the half step [length/time]
  double late;  ///< 1: the node is finished after contact and constraints, not with the free ones
  [[nodiscard]] Quad& x_mass() { return *reinterpret_cast<Quad*>(x); }
  [[nodiscard]] Quad& v_late() { return *reinterpret_cast<Quad*>(v); }
};

/// Piecewise linear in time, constant beyond its ends; empty: 1.
using Curve = std::vector<std::array<double, 2>>;

/// A node that cannot move freely: velocity = free * v + prescribed part. `free` projects on the free directions.
struct ConstrainedNode {
  LocalIndex node = 0;
  Mat3 free = Mat3::Identity();
  std::array<std::int32_t, 3> drive{-1, -1, -1};  ///< for x, y, z: index into Model::drives where the velocity is given
};
struct Drive {
  Curve curve;
  double scale = 1;
};

struct PressureLoad {
  std::vector<mesh::ExteriorFace> faces;
  double value = 0;  ///< [stress] pushing inwards where positive
  Curve curve;
};
struct RigidWall {
  std::string name;
  Vec3 point = Vec3::Zero();  ///< less the mesh's origin
  Vec3 normal = Vec3::UnitZ();
  bool bilateral = false;
  Curve motion;  ///< velocity along the normal
  bool moves = false;
  contact::FrictionLaw friction;
};

/// Which parts may touch which; evaluated for pairs of blocks.
struct ContactRule {
  std::vector<std::int8_t> active;             ///< [block_a * blocks + block_b]
  std::vector<std::int8_t> forced_slave;       ///< 0 automatic, 1: block_a is slave of block_b, -1 the other way
  std::vector<contact::FrictionLaw> friction;  ///< the same places
  std::vector<contact::Tied> tied;             ///< likewise; empty: no pair is
  std::vector<contact::Passes> passes;         ///< likewise; empty: one
  contact::EnforcementSettings enforcement;
  int rebuild_every = 0;  ///< steps; 0: when the motion is used up; -1: also at random
  int competing = 0;      ///< what decides among competing faces: contact::Criterion
  bool any = false;
};

struct Model {
  mesh::LocalMesh mesh;
  std::vector<ElementBlock> blocks;
  AlignedVector<Quad> reference;        ///< X of each node; the fourth is unused
  std::vector<LocalIndex> owned;        ///< nodes this rank owns
  std::vector<GlobalIndex> block_size;  ///< elements of each block on all ranks
  bool any_constrained = false;         ///< on any rank

  std::vector<ConstrainedNode> constrained;  ///< ascending by node
  std::vector<Drive> drives;
  Vec3 gravity = Vec3::Zero();  ///< [length/time^2]
  Curve gravity_curve;
  double damping = 0;                       ///< alpha of the drag -alpha m v on every node [1/time]
  double damping_from = 0, damping_to = 0;  ///< it acts on forces of t_n with from <= t_n < to
  std::vector<PressureLoad> pressure;
  std::vector<RigidWall> walls;
  std::vector<char> in_symmetry_plane;  ///< a flag for each of mesh.faces: no contact face
  ContactRule contact;

  std::vector<LocalIndex> late;  ///< nodes finished after contact and constraints, ascending
  [[nodiscard]] LocalIndex nodes() const { return static_cast<LocalIndex>(mesh.node_gid.size()); }
  [[nodiscard]] bool has_gravity() const { return gravity.squaredNorm() > 0; }
  [[nodiscard]] bool damped() const { return damping > 0; }
  [[nodiscard]] bool loaded() const { return has_gravity() || damped() || !pressure.empty(); }
};

struct State {
  double time = 0;          ///< t_n
  double time_before = -1;  ///< t_{n-1}
  double dt = 0;            ///< t_n - t_{n-1}: of the step that led here; 0 before the first
  double step = 0;          ///< n, a whole number
  /// Largest 1 / (stable step) so far in the span of steps under way, and that of the whole span before it [1/time].
  double rate_now = 0, rate_before = 0;
  /// u_n, the state of the motion, and in the fourth place the work that the forces of the elements have done on the
  /// node up to v_{n-1/2}: every work is impulse . (v_before + v_after)/2.
  AlignedVector<Quad> displacement;
  AlignedVector<NodeLine> nodes;               ///< x_n = X + u_n and v_{n-1/2}
  std::vector<AlignedVector<double>> history;  ///< per block: [batch][component][lane]
  std::vector<double> load_work;               ///< gravity, pressure; empty where the scene has none
  std::vector<double> damping_work;            ///< of the drag on the mean velocity, never > 0; empty without damping
  std::vector<double> reaction_work;           ///< of fixed and prescribed nodes; empty where the scene has none
  std::vector<double> load_impulse;            ///< three a node: gravity, pressure, damping
  std::vector<double> reaction_impulse;        ///< three a node: fixed and prescribed
  std::vector<double> wall_position;           ///< travel of each wall along its normal
};

struct Scratch {
  AlignedVector<Quad> force;          ///< minus the internal force; the fourth is unused
  AlignedVector<Quad> load;           ///< gravity, pressure; empty where the scene has neither these nor damping
  AlignedVector<double> slots;        ///< unsummed corner forces of border nodes, four each
  std::vector<Vec3> before;           ///< v_{n-1/2} of the late nodes (with damping: of all), by node; or empty
  std::vector<Vec3> reaction;         ///< impulse of each constrained node in this step
  std::vector<Vec3> contact_impulse;  ///< by node; empty unless contact or walls meet constrained nodes
};

}  // namespace brunt::model
