// SPDX-License-Identifier: Apache-2.0
// Contact and rigid walls of one step, on all ranks: lists that last, rows, impulses, corrected velocities. All that it
// keeps from step to step and that results depend on is its history, which goes to checkpoints and the state hash.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "brunt/comm/communicator.hpp"
#include "brunt/comm/exact_sum.hpp"
#include "brunt/contact/data/history.hpp"
#include "brunt/contact/detection/detection.hpp"
#include "brunt/contact/driven.hpp"
#include "brunt/contact/enforcement/enforce.hpp"
#include "brunt/contact/friction.hpp"
#include "brunt/contact/list_motion.hpp"
#include "brunt/contact/lists.hpp"
#include "brunt/contact/passes.hpp"
#include "brunt/contact/surface/surface.hpp"
#include "brunt/contact/ties.hpp"
#include "brunt/mesh/local_mesh.hpp"

namespace brunt::contact {

/// Vectors of the model's local nodes, wherever they lie: node i starts at data[i * stride].
struct VectorView {
  const double* data = nullptr;
  std::ptrdiff_t stride = 3;
  [[nodiscard]] Vec3 operator[](LocalIndex node) const { return Vec3(data + node * stride); }
  void fetch(LocalIndex node) const { __builtin_prefetch(data + node * stride); }  ///< to the cache, for later
};
struct MutableVectorView {
  double* data = nullptr;
  std::ptrdiff_t stride = 3;
  [[nodiscard]] Vec3 operator[](LocalIndex node) const { return Vec3(data + node * stride); }
  void set(LocalIndex node, const Vec3& value) const { Eigen::Map<Vec3>(data + node * stride) = value; }
};

/// Nodes that something holds, with what is left of their freedom.
struct ConstrainedNode {
  LocalIndex node = 0;  ///< local node of the mesh
  Mat3 projector = Mat3::Identity();
};

/// When lists are rebuilt; no result depends on it.
struct Rebuild {
  enum class When : std::int8_t { motion_used_up, every, random } when = When::motion_used_up;
  int steps = 1;           ///< for `every`, besides when the motion is used up
  std::uint64_t seed = 1;  ///< for `random`, in about one step of four
};

struct ContactSettings {
  PairTable pairs;     ///< of blocks; no blocks: no contact between bodies, walls only
  bool bodies = true;  ///< search for contact between bodies
  DetectionSettings detection;
  std::vector<FrictionLaw> friction;  ///< of pairs of blocks, [a * blocks + b]; empty: none
  std::vector<Tied> tied{};           ///< of pairs of blocks, the same places; empty: none
  std::vector<double> impedance;      ///< density times speed of sound of each block, for Method::printed
  std::vector<double> sound{};        ///< speed of sound of each block [velocity]; empty: see DetectionSettings::sound
  EnforcementSettings enforcement;
  double motion_share = 0.3;  ///< of Surface::mean_depth: how far nodes may move before lists are rebuilt
  /// By block: of two-sided sheets, met at half of it from their faces [length]; 0 or missing: the skin of a solid.
  std::vector<double> thickness{};
  Rebuild rebuild;
  std::vector<std::array<std::int32_t, 2>> tracked;  ///< pairs of blocks whose impulse is summed
};

/// Energy taken from the bodies [energy].
struct WorkSums {
  comm::ExactAccumulator contact;   ///< by contact between them, along the normals
  comm::ExactAccumulator friction;  ///< across the normals, on walls too
  comm::ExactAccumulator walls;     ///< by walls, along their normals
  comm::ExactAccumulator ties;      ///< of `friction`, what ties took: they may give it back
};

/// Sums over the run, on this rank, exact: sums are reduced only when wanted (see `collect`).
struct ContactSums {
  WorkSums work;
  std::vector<std::array<comm::ExactAccumulator, 3>> wall_impulse;     ///< by each wall on the bodies [momentum]
  std::vector<std::array<comm::ExactAccumulator, 3>> tracked_impulse;  ///< on the first block of each tracked pair
  /// Angular momentum that contact between bodies has given: zero where nodes and face points that push on each other
  /// coincide, or where the push is along the line between them.
  std::array<comm::ExactAccumulator, 3> spin;
  comm::ExactAccumulator push;  ///< sizes of the impulses between bodies [momentum]
  double penetration = 0;       ///< largest so far [length]
};

/// The same after reduction over all ranks.
struct ContactTotals {
  double contact_work = 0, friction_work = 0, wall_work = 0, tie_work = 0;  ///< that of ties is in friction_work too
  std::vector<Vec3> wall_impulse, tracked_impulse;
  Vec3 spin = Vec3::Zero();           ///< given by contact between bodies [angular momentum]
  double push = 0;                    ///< sum of the sizes of the impulses between bodies [momentum]
  double stored = 0;                  ///< of contact_work, what soft rows hold after the last step and return [energy]
  GlobalIndex pairs = 0, active = 0;  ///< candidate pairs now; rows with an impulse in the last step
  GlobalIndex touching = 0;           ///< of these, rows between bodies that are no ties
  double penetration = 0;             ///< largest of the run [length]
};

struct ContactStatistics {  ///< the same on every rank
  GlobalIndex steps = 0, searches = 0, solved_steps = 0, iterations = 0;
  GlobalIndex idle_steps = 0;  ///< in which no candidate was looked at: too far from each other
  int most_iterations = 0;
  double largest_residual = 0;
  GlobalIndex steps_at_limit = 0;  ///< that ended at max_iterations, with a residual above the tolerance
  EnforcementResult last;
};

/// How many nodes of block a are tied to faces of block b, [a * blocks + b], and how many look at such a face within
/// reach but lie beside it, and are not; empty where no pair is tied.
struct TiedNodes {
  std::vector<GlobalIndex> tied, beside;
};

/// A row with friction.
struct RubbingRow {
  double work = 0;                       ///< taken by friction in the last step; < 0: given [energy]
  GlobalIndex slave_gid = no_index;      ///< no_index: there is none
  Vec3 position = Vec3::Zero();          ///< of the slave, less the mesh's origin
  std::int32_t master_block = no_index;  ///< no_index for a wall
};

class Contact {
 public:
  /// excluded: one flag for each of mesh.faces (faces in a symmetry plane). inverse_mass: of the mesh's local nodes.
  /// walls: at the start (a bilateral wall holds the nodes that lie in its plane within 1e-6 of the mean face edge).
  /// Collective.
  Contact(const comm::Communicator& ranks, const mesh::LocalMesh& mesh, std::span<const char> excluded,
          std::span<const double> inverse_mass, std::span<const ConstrainedNode> constrained,
          std::span<const Wall> walls, ContactSettings settings);

  /// Makes the lists anew where the motion they allow is used up. Once a step, before `correct`. predicted: v*.
  /// velocities: of all ranks; their bounds tell for most steps that the lists hold (see ListMotion). Collective.
  void search(VectorView position, VectorView predicted, std::span<const Wall> walls, double dt,
              const VelocitySpan& velocities);

  /// Replaces v* by v = v* + W G^T impulses on every local node, the same bits on every copy. walls: at t_n.
  /// mobility: what W has of the inverse masses, 1 / (1 + alpha dt / 2) under mass damping. Collective.
  void correct(VectorView position, VectorView old_velocity, MutableVectorView velocity, std::span<const Wall> walls,
               double dt, double mobility = 1);

  /// Impulse [momentum] of the last step on each node owned here is added to `impulse` (a row a local node of the
  /// mesh), held components included: what the step books as reaction of fixed and prescribed nodes.
  void add_impulses(std::span<Vec3> impulse) const;

  /// Energy that the second half of the last step's impulses took, p . v_{n+1/2} / 2: the sums hold whole steps, a
  /// ledger at t_n takes this off. Of this rank.
  void add_second_half(WorkSums& half) const;

  /// Of the last step, by local node of the mesh, for slaves owned here, zero elsewhere: impulse over dt and the area
  /// around the node [stress]; smallest gap [length].
  [[nodiscard]] std::vector<double> pressures(double dt) const;
  [[nodiscard]] std::vector<double> gaps() const;

  /// Does anything of a step depend on the one before? Else there is no history to save. The same on every rank.
  [[nodiscard]] bool remembers() const { return settings_.enforcement.warm_start || rubs_ || has_sheets(); }
  [[nodiscard]] HistoryTables history_tables() const;  ///< the records of this rank
  /// Takes over records that lie anywhere, each on one rank; each goes to where its rows are made. Collective.
  void restore_history(const HistoryTables& tables);
  [[nodiscard]] const History& history() const { return history_; }  ///< of the last step, on this rank

  [[nodiscard]] ContactTotals collect() const;              ///< collective
  [[nodiscard]] RubbingRow most_given_by_friction() const;  ///< in the last step, on this rank, but for ties
  [[nodiscard]] TiedNodes tied_nodes() const;               ///< of all ranks; collective
  [[nodiscard]] const ContactStatistics& statistics() const { return statistics_; }
  [[nodiscard]] ContactSums& sums() { return sums_; }
  /// May supports drive nodes through others? Where they hold any node of the surface; the same on every rank.
  [[nodiscard]] bool may_be_driven() const { return may_be_driven_; }
  [[nodiscard]] std::span<const DrivenMeeting> driven() const { return driven_; }  ///< found on this rank
  [[nodiscard]] double clock() const { return clock_; }  ///< sum of the steps since this was made [time]
  [[nodiscard]] const Surface& surface() const { return surface_; }
  [[nodiscard]] std::span<const Row> rows() const { return rows_; }           ///< of the last step, on this rank
  [[nodiscard]] std::span<const Vec3> impulses() const { return impulses_; }  ///< of those rows

 private:
  [[nodiscard]] bool must_rebuild() const;
  bool motion_is_used_up(VectorView position, VectorView predicted, std::span<const Wall> walls, double dt,
                         const VelocitySpan& velocities);
  void rebuild(VectorView position, VectorView predicted, std::span<const Wall> walls, double dt);
  void share_reference();
  void list_possible_twins();
  void plan_gather();
  void look_at_start(const std::vector<Vec3>& reference, std::span<const Wall> walls);
  void forget_start();
  void make_ties(const std::vector<Vec3>& reference, std::span<const Wall> walls);
  [[nodiscard]] std::size_t place_of_pair(std::int32_t slave_block, std::int32_t master_block) const;
  [[nodiscard]] bool nothing_else_acts(const Row& row) const;
  [[nodiscard]] bool are_tied(std::int32_t slave_block, std::int32_t master_block) const;
  [[nodiscard]] std::int32_t tied_block(LocalIndex slave, std::int32_t master_block) const;
  [[nodiscard]] TieScene tie_scene(double dt) const;
  void demand_ties_hold() const;
  void lay_ties(double dt);
  void drop_tied_rows();
  void keep_overlaps(const std::vector<Vec3>& reference, std::span<const Wall> walls);
  void gather(VectorView position, VectorView old_velocity, MutableVectorView velocity);
  void measure_facets(VectorView position);
  [[nodiscard]] bool nothing_can_meet() const;
  void measure_clearance(std::span<const Wall> walls, double dt);
  void detect(std::span<const Wall> walls, double dt);
  void detect_crossing_edges(double dt);
  [[nodiscard]] bool has_sheets() const {
    return std::ranges::any_of(settings_.thickness, [](double thickness) { return thickness > 0; });
  }
  [[nodiscard]] double area_of_slave(const Row& row) const;
  [[nodiscard]] bool has_twin(const Row& row) const;
  void lay_passes(double dt);
  void lay_slabs();
  void lay_friction(std::span<const Wall> walls, double dt);
  [[nodiscard]] AnchorScene anchor_scene(std::span<const Wall> walls) const;
  [[nodiscard]] FrictionLaw friction_of(const Row& row, std::span<const Wall> walls) const;
  void remember(std::span<const Wall> walls, double dt);
  void scatter(MutableVectorView velocity);
  void book();
  [[nodiscard]] comm::ExactAccumulator stored_in_soft_rows() const;
  static void book_work(const Row& row, const Vec3& impulse, const Vec3& relative, WorkSums& sums);
  [[nodiscard]] bool is_driven(const Row& row) const;
  [[nodiscard]] double size_of_master(const Row& row) const;
  [[nodiscard]] DrivenMeeting meeting_of(const Row& row, std::int32_t slave_block, std::int32_t master_block) const;
  void watch_driven(double dt);
  [[nodiscard]] bool is_slave_in(const Row& row, std::int32_t block) const;
  [[nodiscard]] std::size_t surface_node_count() const;           ///< local nodes up to the last one on the surface
  [[nodiscard]] std::size_t model_node_of(const Row& row) const;  ///< the slave

  comm::Communicator ranks_;
  ContactSettings settings_;
  Surface surface_;
  Roles roles_;
  std::vector<Mobility> surface_mobility_;
  std::vector<Vec3> surface_reference_;  // at the start; empty where no overlaps of the start are accepted
  std::vector<char> held_;               // wall by wall, a flag a surface node
  comm::Halo surface_copies_;
  std::vector<LocalIndex> foreign_;  // surface nodes owned elsewhere
  std::vector<LocalIndex> lent_;     // surface nodes owned here, once for each copy elsewhere
  bool any_copies_ = false;          // on any rank
  std::vector<double> surface_velocity_, foreign_velocity_;

  ContactLists lists_;
  ListScratch list_scratch_;
  bool have_lists_ = false;
  bool lists_are_new_ = false;  // of this step
  double motion_ = 0;           // allowed
  double clearance_ = 0;        // between candidates of any rank when the lists were made: see detection/clearance.hpp
  ListMotion list_motion_;      // of surface nodes, then of walls
  double last_dt_ = 0;          // of the step before

  struct NodeHere {
    LocalIndex contact_node, model_node;
  };
  std::vector<NodeHere> nodes_here_;  // contact nodes that this rank's mesh has
  struct FacetHere {
    LocalIndex face, corner_count;
    std::array<LocalIndex, 4> model_nodes;
  };
  std::vector<FacetHere> facets_here_;  // surface faces whose area vector some rank needs
  std::vector<NodeMotion> motion_of_;   // contact nodes
  std::vector<Mobility> mobility_;
  std::vector<Vec3> velocity_;
  std::vector<Vec3> reference_;              // of contact nodes, likewise
  std::vector<Vec3> own_area_, facet_area_;  // area vectors of faces, a corner's share of them
  std::vector<Vec3> node_normal_;            // of each contact node's first row with a face
  DetectionScratch detection_;
  std::vector<Row> rows_;
  RowSortScratch row_sort_;
  std::vector<Vec3> impulses_;
  EnforcementScratch scratch_;
  History history_;
  std::vector<HistoryRecord> next_pairs_;
  std::vector<AnchorRecord> next_anchors_;
  std::vector<Tie> ties_;                  // of slaves owned here
  std::vector<Lever> levers_;              // one a tie, of the last step
  std::vector<GlobalIndex> nodes_beside_;  // see TiedNodes, of this rank
  bool rubs_ = false;                      // friction somewhere
  bool two_passes_ = false;                // of some pair
  std::vector<LocalIndex> faces_by_key_;   // of the lists
  bool may_be_driven_ = false;
  std::vector<DrivenMeeting> driven_;
  double clock_ = 0;

  ContactSums sums_;
  ContactStatistics statistics_;
};

}  // namespace brunt::contact
