// SPDX-License-Identifier: Apache-2.0
// The content of a scene file as typed data, with defaults filled in: the result of scene/read. Quantities are in the
// consistent unit system of the scene.
#pragma once
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "contact/data/mortar_pair.hpp"
#include "contact/data/specification.hpp"
#include "core/types.hpp"
#include "element/options.hpp"
#include "material/law.hpp"
#include "mesh/division.hpp"
#include "mesh/round_form.hpp"
#include "mesh/shell_bodies.hpp"
#include "model/erosion.hpp"
#include "model/implicit_solver.hpp"
#include "model/loads.hpp"
#include "model/supports.hpp"
#include "model/touching.hpp"
#include "rigid/joint.hpp"
#include "scene/guards.hpp"
#include "scene/text/places.hpp"

namespace brunt::scene {

struct Rotation {
  Vec3 axis = Vec3::UnitZ();
  double degrees = 0;
};

/// Placement of a generated or read body: scaled, then rotated about the origin of the scene, then translated.
struct Placement {
  double scale = 1;
  std::vector<Rotation> rotate;  ///< one after the other
  Vec3 at = Vec3::Zero();
};

struct MeshFile {
  std::string file;                 ///< resolved path: relative to the scene file
  std::string prefix;               ///< put before the names of its blocks and sets
  std::vector<std::string> ignore;  ///< names or numbers of the blocks to exclude, without the prefix
};
struct BoxMesh {
  std::string part;
  Vec3 size;  ///< from the corner `at`
  mesh::Divisions<3> elements;
  bool shell = false;     ///< its sides
  mesh::BoxSides open{};  ///< sides that a shell does not have
};
struct CylinderMesh {  ///< solid, butterfly section, axis z, foot centre at the origin
  std::string part;
  double radius = 0, length = 0;
  mesh::Divisions<2> elements;  ///< across the radius, along the axis
  mesh::RoundForm half;         ///< the half that is kept, and the nose
};
struct SphereMesh {  ///< solid, centre at the origin
  std::string part;
  double radius = 0;
  int elements = 0;    ///< across the radius
  double finer = 1;    ///< elements at the lowest point are smaller by this factor
  mesh::Half half{};   ///< of x, y, z: 1 keeps what is >= 0, -1 what is <= 0, 0 both
  bool shell = false;  ///< its surface
};
struct TubeMesh {  ///< axis z, foot centre at the origin
  std::string part;
  double inner_radius = 0, outer_radius = 0, length = 0;
  mesh::Divisions<3> elements;  ///< through the wall, around the whole or the sector, along
  mesh::RoundForm half;         ///< the half or the sector that is kept, and the nose
  bool shell = false;           ///< the surface in the middle of the wall
};
struct TorusMesh {  ///< hollow, axis z, centre at the origin
  std::string part;
  double radius = 0;            ///< of the ring
  std::array<double, 2> tube;   ///< inner and outer radius of its section
  mesh::Divisions<3> elements;  ///< around the ring, around the tube, through the wall
};
struct PlateMesh {  ///< in the x-y plane, centre of the lower face at the origin
  std::string part;
  std::array<double, 2> size;
  double thickness = 0;
  mesh::Divisions<3> elements;  ///< of a shell the first two
  bool shell = false;           ///< in the plane z = 0
};
struct MeshEntry {
  std::variant<MeshFile, BoxMesh, CylinderMesh, SphereMesh, TubeMesh, TorusMesh, PlateMesh> body;
  Placement placement;
  std::string key;  ///< key path for messages, "mesh.0"
};

using element::BulkViscosity;
using element::ElementKind;
using element::Hourglass;
using element::HourglassKind;

/// Mass properties that replace those of the elements of a rigid part, or the part with which it forms one body.
struct RigidGiven {
  std::optional<double> mass;
  std::optional<Vec3> centre;     ///< of mass, at the start
  std::optional<Mat3> inertia;    ///< about the centre, in the scene's axes at the start
  std::optional<Vec3> reference;  ///< the point that supports hold and drive, and that probes follow, at the start
  std::string joins;              ///< the part that names the common body; empty: the part names its own
};

struct Part {
  std::string name, block, material;   ///< block: name or number as text
  std::optional<ElementKind> element;  ///< absent: by the shape of the block's elements, see `kind_of`
  element::ShellSection section;       ///< of shells; thickness 0: none
  Hourglass hourglass;
  BulkViscosity bulk;
  std::optional<RigidGiven> rigid;
  std::optional<model::Erosion> erosion;
};

/// Whether the scene says that a part consists of shells: by its element, or by a thickness.
[[nodiscard]] inline bool is_shell(const Part& part) {
  return part.element ? element::is_shell(*part.element) : part.section.thickness > 0;
}

/// A named set that the scene defines from other selections.
struct SetEntry {
  std::string name;
  std::optional<std::string> part, node_set, side_set;
  std::optional<std::array<Vec3, 2>> box;  ///< nodes of the part (or of all) inside the closed box
};

using Curve = std::vector<std::array<double, 2>>;  ///< (time, value), linear between the points, constant outside

struct InitialMotion {
  std::string where;  ///< part or set
  Vec3 velocity = Vec3::Zero();
  Vec3 spin_axis = Vec3::UnitZ(), spin_point = Vec3::Zero();
  double spin_rate = 0;  ///< [rad/time]
};
struct Fixed {
  std::string where;
  std::array<bool, 3> dofs{};
  std::array<bool, 3> turns{};  ///< about x, y, z: of a rigid part, or of nodes of shells
};
struct Symmetry {
  Vec3 point = Vec3::Zero(),
       normal = Vec3::UnitX();  ///< unit normal; all nodes in the plane; faces in it are not contact faces
};
struct Prescribed {
  std::string where;
  int dof = 0;  ///< x, y, z; 3 and more: rotation about x, y, z, of a rigid part or of nodes of shells [rad]
  using Gives = model::Drive::Gives;
  Gives gives = Gives::velocity;
  std::string curve;  ///< of the prescribed quantity over time, multiplied by `scale`; empty: constant 1
  double scale = 1;
};
struct Pressure {
  std::string where;  ///< side set
  double value = 0;
  std::string curve;
};
struct DeadLoad : model::DeadForce {
  std::string where;  ///< set or part; of a traction a side set
  std::string curve;
};
/// Elements that are removed from the model: those of a part, or those with all their nodes in a set.
struct Removal {
  std::string where;        ///< part or set
  double at = 0;            ///< in the first step at or past this time [time]
  bool keeps_nodes = true;  ///< nodes without an element stay as mass points; false: they are dropped
};
struct Relaxation {
  double tolerance = 1e-4;
  GlobalIndex max_steps = 100000;
};
struct Gravity {
  Vec3 vector = Vec3::Zero();
  std::string curve;
};
struct RigidWall : model::PlaneWall {
  std::string motion;                ///< curve of the wall's velocity along its normal; empty: at rest
  std::vector<std::string> parts{};  ///< that it acts on; empty: all
};

/// The word for space itself among the bodies of a joint.
constexpr const char* ground_name = "ground";

/// A joint between two rigid parts, or of one and the ground.
struct Joint {
  std::string name;
  rigid::JointKind kind = rigid::JointKind::ball;
  std::array<std::string, 2> between;  ///< parts, or `ground`
  Vec3 point = Vec3::Zero();           ///< at the start
  Vec3 axis = Vec3::UnitZ();           ///< unit, of a revolute joint
};

/// Settings that apply to all contact of a scene, including rigid walls.
struct Enforcement {
  contact::EnforcementSettings settings;
  contact::Criterion competing = contact::Criterion::automatic;
  contact::Rebuild rebuild;
};

/// Default of `limit`: a part moves at most this multiple of the overlap, relative to the part that it overlaps.
/// Measured: pins that stay in their bores move by up to 1.3 overlaps, parts of cases/placed_assembly that turn by up
/// to 3; pins that leave their bores by 12 and more (tests/run/place_fits_test.py -v).
constexpr double most_overlaps = 5;

struct ContactEntry {
  std::vector<std::string> between;  ///< empty: all; else two parts
  std::vector<std::array<std::string, 2>> exclude;
  contact::FrictionLaw friction;
  enum class Slave { automatic, first, second } slave = Slave::automatic;
  contact::Passes passes = contact::Passes::automatic;
  bool self = true;  ///< with `all`: contact of parts with themselves
  bool tied = false;
  bool mortar = false;  ///< of implicit scenes: segment to segment
  contact::Multiplier multiplier = contact::Multiplier::dual;
  bool consistent = false;  ///< of mortar: forces are the gradient of the weighted gaps
  bool edges = false;       ///< of mortar: sharp edges split the surfaces and have rows of their own
  contact::MortarPair::Enforce enforce = contact::MortarPair::Enforce::lagrange;
  contact::OverlapRule initial_overlap = contact::OverlapRule::error;
  std::optional<double> limit;  ///< of `place`: largest displacement of a point of a part [length]
};

struct Probe {
  std::string name;
  enum class Kind { node, near, set, part, wall, contact, section, joint } kind = Kind::node;
  std::string where, other;   ///< node id as text; set or part; wall; joint; the two parts of a contact, the same twice
                              ///< for one with itself, `other` empty for one with all others
  std::string field;          ///< node, set: displacement, velocity, position, (set) reaction; of a part see below
  Vec3 point = Vec3::Zero();  ///< near: the place whose nearest node is taken; section: of its plane
  Vec3 normal = Vec3::Zero();      ///< section: unit normal of its plane; zero: the section is the set `where`
  std::vector<std::string> parts;  ///< section: whose elements count
  std::optional<Vec3> about;       ///< of moments and angular momenta
};

/// The model on which the stable step is based.
enum class StepBound {
  element,   ///< each element as if it were free; the fastest one determines the step
  assembled  ///< the assembled mesh, in which neighbouring elements constrain each other
};
struct Run {
  std::optional<double> end;
  std::optional<GlobalIndex> steps;
  double cfl = 0.9;
  StepBound step_bound = StepBound::assembled;
  std::optional<double> step;        ///< largest step [time]
  double min_step_ratio = 1e-4;      ///< of the first step: below it the run stops
  std::optional<double> wall_limit;  ///< [s] of wall-clock time
};
struct Output {
  std::optional<double> every;  ///< absent: first and last state only
  std::vector<std::string> fields{"displacement", "velocity"};
};

struct Input {
  std::string file;  ///< the scene file, for messages
  std::string title, units;
  std::vector<MeshEntry> mesh;
  std::vector<SetEntry> sets;
  std::map<std::string, Curve> curves;
  std::map<std::string, material::Law> materials;
  std::vector<Part> parts;
  std::vector<InitialMotion> initial;
  std::vector<Fixed> fixed;
  std::vector<Symmetry> symmetry;
  std::vector<Prescribed> prescribed;
  std::vector<Pressure> pressure;
  std::vector<DeadLoad> forces, traction;
  std::vector<Removal> remove;
  std::optional<Relaxation> relaxation;
  std::optional<Gravity> gravity;
  std::optional<model::Damping> damping;
  std::vector<RigidWall> rigid_walls;
  std::vector<Joint> joints;
  Enforcement enforcement;
  std::vector<ContactEntry> contact;
  std::vector<Probe> probes;
  Run run;
  Guards guards;
  contact::SearchMethod search = contact::SearchMethod::automatic;
  std::optional<model::ImplicitSolver> implicit;  ///< absent: explicit
  Output output;
  std::optional<double> history_every;
  std::optional<double> checkpoint_every;
  std::vector<std::string> warnings;  ///< valid input that deserves a warning
  Places places;                      ///< of all keys

  /// "FILE:LINE: key.path": the beginning of messages about faults that are found after reading.
  [[nodiscard]] std::string at(std::string_view key) const { return places.name(key, file); }
};

}  // namespace brunt::scene
