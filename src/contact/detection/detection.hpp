// SPDX-License-Identifier: Apache-2.0
// From candidate pairs to constraint rows: nodes against faces (detect_faces), edges against edges (detect_edges in
// edges.hpp), nodes against walls (detect_walls). All decisions are functions of positions, predicted velocities and
// the step only: candidates that cannot touch in this step are excluded by a criterion of their own, so a longer list
// of candidates does not change any bit.
#pragma once
#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "contact/data/constraint.hpp"
#include "contact/data/held_bodies.hpp"
#include "contact/data/history.hpp"
#include "contact/data/options.hpp"
#include "contact/detection/coincident_nodes.hpp"
#include "contact/detection/encounter.hpp"
#include "contact/detection/select_rows.hpp"
#include "core/ragged.hpp"

namespace brunt::contact {

/// Of a slave node and a face: whether the face's nodes have rows on the slave's faces as well, and who comes first.
enum class PairPass : char { only, first, second };

/// Candidate pairs, slave by slave in ascending gid.
struct Candidates {
  std::vector<LocalIndex> slave;    ///< contact node
  std::vector<std::int32_t> body;   ///< of the slave
  Ragged<LocalIndex> faces;         ///< master faces, ordered by (body, key)
  Ragged<LocalIndex> slave_facets;  ///< faces of the slave's own surface around it: rows of the facet area vectors
  std::vector<double> seam_sag{};   ///< of each of slave_facets.values, see Surface; empty: there is no seam
  std::vector<double>
      half_thickness{};          ///< of a slave on a two-sided sheet, else 0 [length]; empty: there is no such sheet
  std::vector<PairPass> pass{};  ///< of each of faces.values; empty: no bodies meet in two passes
  Ragged<CoincidentCandidate> coincident{};  ///< of each slave, in the bodies that it meets in two passes; likewise
};

/// A rigid plane at t_n; bodies are on the side that the normal points to.
struct Wall {
  Vec3 point = Vec3::Zero(), normal = Vec3::UnitZ();
  Vec3 velocity = Vec3::Zero();
  bool bilateral = false;  ///< nodes that start in the plane stay in it
  FrictionLaw friction{};
  std::span<const std::int32_t> blocks{};  ///< that it acts on, ascending; empty: all
};

/// Whether the wall acts on a node of these blocks.
inline bool acts_on(const Wall& wall, std::span<const std::int32_t> blocks) {
  return wall.blocks.empty() || std::ranges::any_of(blocks, [&](std::int32_t block) {
           return std::ranges::binary_search(wall.blocks, block);
         });
}

/// An initial overlap that counts as touching: gaps of this node with faces of this body are measured from it during
/// the whole run, so no history is needed. Edges that end at the node are measured from their own initial overlap.
struct AcceptedOverlap {
  GlobalIndex slave = 0;   ///< gid of the node
  std::int32_t body = 0;   ///< of the master
  double penetration = 0;  ///< [length], > 0
  std::int32_t slave_body = no_index;
};

struct DetectionSettings {
  const Tolerances* tolerances = &standard_tolerances;
  Criterion criterion = Criterion::automatic;
  bool recovery_gives = true;  ///< recovery may do work on the bodies at any depth: where initial overlaps are to be
                               ///< recovered. Otherwise not for edges deeper than Tolerances::drift (see required_rate)
  double coincidence_distance = 0;  ///< nodes of two bodies closer than this are coincident [length]
  double wall_size = 0;             ///< [length] replaces the longest edge if the master is a wall
  std::vector<double> sound{};      ///< speed of sound of each body [velocity]; empty: recovery is as fast as steps are
  std::vector<AcceptedOverlap> accepted{};  ///< ordered by (slave, body), each pair once
  std::vector<BodyPair>
      flush{};  ///< ascending: bodies between which there is a seam, which does not apply to their own contact
  std::vector<BodyPair> fitted{};  ///< ascending: bodies of which some overlap was accepted, or moved away
};

/// A step as all of detection sees it.
struct StepView {
  std::span<const GlobalIndex> gid;    ///< of the contact nodes
  std::span<const NodeMotion> motion;  ///< of the contact nodes, before contact
  double dt = 0;                       ///< [time]
  const DetectionSettings& settings;
};

/// Number of slaves whose faces are processed together, one pack at a time: large enough to leave few lanes empty.
constexpr std::size_t slaves_at_once = 32;

/// Arrays of detection, sized where lists are rebuilt so that a step allocates nothing.
struct DetectionScratch {
  std::vector<FaceReach> reach;
  std::vector<Vec3> facet_normal;           ///< unit; zero for a facet without area
  std::vector<Encounter> encounters;        ///< of the slaves that are looked at together
  std::vector<const NodeMotion*> slave_of;  ///< of each of these
  std::vector<HistoryRecord> sides;         ///< of the nodes that meet two-sided faces, in the order of their keys

  void reserve(std::size_t faces, std::size_t facets, std::size_t most_faces_of_a_slave) {
    reach.reserve(faces);
    facet_normal.reserve(facets);
    encounters.reserve(slaves_at_once * most_faces_of_a_slave);
    slave_of.reserve(slaves_at_once * most_faces_of_a_slave);
  }
};

/// Whether seams apply to contact of these bodies.
inline bool seams_count(const DetectionSettings& settings, std::int32_t slave_body, std::int32_t master_body) {
  if (settings.flush.empty()) return false;
  return !std::ranges::binary_search(settings.flush, BodyPair(std::minmax(slave_body, master_body)));
}

/// Accepted penetration [length]; 0 if none is accepted.
double accepted_penetration(std::span<const AcceptedOverlap> accepted, GlobalIndex slave, std::int32_t body);

/// The time that replaces the step in the recovery of a penetration [time]: the step, or, if that is longer, half the
/// time of sound along `size` [length] in the slower of the two bodies, which is about the stable step of a cube of
/// that size.
double recovery_time(const Row& row, double size, double dt, const DetectionSettings& settings);

/// Smallest admissible rate of the row's gap [velocity]. An open gap may close within the step; a limited share of a
/// penetration is recovered in each step. gap: the one to be closed, which may differ from the geometric one of the
/// row [length]; size: of the face or of the shorter edge [length].
///
/// Under load, recovery does work on the bodies. This is small where the penetration has grown by drift. Edges that are
/// deeper when they are first detected (after slipping over a rim, or where their crossing passes a node of a bent
/// chain of edges) would receive energy that contact never took. They are separated no faster than they approached, and
/// keep their depth while they are pressed. Node penetrations are always recovered; otherwise the residual of each step
/// accumulates, and soft faces that bend over a rim let one node after another penetrate deeper. Between fitted bodies,
/// however, nodes are treated as edges: sliding into a fit produces the depth of the initial overlap without work, and
/// its recovery would supply energy.
///
/// In short steps (due to a small or crushed element elsewhere) recovery_time replaces the step. Otherwise the rate of
/// recovery would grow as steps shrink and supply energy at nodes that are first detected deep, behind a rim.
double required_rate(const Row& row, double gap, double size, const StepView& step);

/// Whether the nodes are coincident. Symmetric in its arguments.
inline bool are_coincident(const NodeMotion& one, const NodeMotion& other, const DetectionSettings& settings) {
  return (one.position - other.position).squaredNorm() < settings.coincidence_distance * settings.coincidence_distance;
}

/// Fills candidates.coincident, if there are two passes. positions: of the contact nodes when lists are created,
/// from which each may move by `motion` [length].
void list_coincident_nodes(std::span<const MasterFace> faces, std::span<const Vec3> positions, double motion,
                           const DetectionSettings& settings, Candidates& candidates);

/// The pairs of nodes and faces, and what else decides about them.
struct FaceInput {
  const Candidates& candidates;
  std::span<const MasterFace> faces;
  std::span<const Vec3> facet_area;           ///< along the area vectors of the slaves' own faces
  std::span<const HistoryRecord> remembered;  ///< the history: sides of two-sided faces
  std::span<const BirthRecord> births{};      ///< of nodes behind faces that have become exterior in front of them
  std::span<const HeldBodies> held{};         ///< of contact nodes: by mortar rows; empty: there are none
  std::span<const char> settled{};  ///< of each candidate face that is the first of a body: mortar rows hold them all
};

/// Appends the rows of slave nodes with faces, at most most_rows_of_a_node each. The order of the passes:
///
/// 1. Each pair of a node and a face whose swept boxes overlap becomes an encounter, unless mortar rows have all facets
///    of the node or all nodes of the faces that it meets; its side of a sheet is determined (sides.hpp). Of coincident
///    nodes of two bodies one row may constrain both: the other one has no encounters (coincident_nodes.hpp).
/// 2. The closest point decides on the meeting by position (encounter_all).
/// 3. The slave's normal cone yields the opposition; faces that it does not admit are lateral faces (cones.hpp).
/// 4. The features around the node revise the meeting (features.hpp).
/// 5. Paths through faces are hits (detect_path_hits).
/// 6. Lateral faces of seams are removed (seams.hpp).
/// 7. Lateral faces of ledges are removed (ledges.hpp).
/// 8. The remaining encounters compete, and the selected ones become rows (select_rows.hpp).
/// 9. Each row receives its required rate.
///
/// Passes 1 and 2 treat slaves_at_once slaves together, the others one slave; 4 to 7 the faces of one body at a time.
/// The scratch returns the reach of the faces, the unit normals of the facets, and the sides of two-sided faces for all
/// pairs except Meeting::none.
void detect_faces(const StepView& step, const FaceInput& input, DetectionScratch& scratch, std::vector<Row>& rows);

/// Candidates of walls: node, wall, and whether the node started in the plane of a bilateral wall (it then always has a
/// row).
struct WallCandidate {
  LocalIndex node = 0;
  std::int32_t wall = 0;
  std::int32_t body = 0;
  bool held = false;
};

void detect_walls(const StepView& step, std::span<const WallCandidate> candidates, std::span<const Wall> walls,
                  std::vector<Row>& rows);

/// Arrays of sort_rows, sized where lists are rebuilt.
struct RowSortScratch {
  struct Place {
    SavedKey key;     ///< of the row
    std::size_t row;  ///< where it stands
  };
  std::vector<Place> places, merged;
  std::vector<std::size_t> runs;  ///< beginnings of runs in order, and the end
  std::vector<Row> rows;

  void reserve(std::size_t most_rows) {
    places.reserve(most_rows);
    merged.reserve(most_rows);
    runs.reserve(most_rows + 1);
    rows.reserve(most_rows);
  }
};

/// Sorts the rows by key. They consist of a few sorted runs (faces, edges, each wall), which are merged.
void sort_rows(std::vector<Row>& rows, RowSortScratch& scratch);

}  // namespace brunt::contact
