// SPDX-License-Identifier: Apache-2.0
// From candidate pairs to constraint rows. What is decided here is a function of positions, predicted velocities and
// the step alone: candidates that cannot touch in this step are ignored by a criterion of their own, so a longer list
// of candidates changes no bit.
#pragma once
#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "brunt/contact/data/constraint.hpp"
#include "brunt/contact/data/history.hpp"
#include "brunt/contact/data/options.hpp"
#include "brunt/contact/detection/coincident_nodes.hpp"
#include "brunt/contact/detection/encounter.hpp"
#include "brunt/contact/detection/select_rows.hpp"
#include "brunt/core/ragged.hpp"

namespace brunt::contact {

/// Candidate pairs, slave by slave in ascending gid.
struct Candidates {
  std::vector<LocalIndex> slave;         ///< contact node
  std::vector<std::int32_t> body;        ///< of the slave
  Ragged<LocalIndex> faces;              ///< master faces, ordered by (body, key)
  Ragged<LocalIndex> slave_facets;       ///< faces of the slave's own surface around it: rows of the facet area vectors
  std::vector<double> seam_sag{};        ///< of each of slave_facets.values, see Surface; empty: there is no seam
  std::vector<double> half_thickness{};  ///< of the slave where it lies on a two-sided sheet, else 0 [length]; empty:
                                         ///< there is no such sheet
  std::vector<char> second{};            ///< a flag for each of faces.values: this way is the second of two passes, in
                                         ///< which coincident nodes are left out; empty: there is none such
  Ragged<CoincidentCandidate>
      coincident{};  ///< of each slave, in the bodies that it meets in the second pass; likewise
};

/// A rigid plane at t_n; bodies are on the side that the normal points to.
struct Wall {
  Vec3 point = Vec3::Zero(), normal = Vec3::UnitZ();
  Vec3 velocity = Vec3::Zero();
  bool bilateral = false;  ///< nodes that start in the plane stay in it
  FrictionLaw friction{};
  std::span<const std::int32_t> blocks{};  ///< that it acts on, ascending; empty: all
};

/// Does the wall act on a node of these blocks?
inline bool acts_on(const Wall& wall, std::span<const std::int32_t> blocks) {
  return wall.blocks.empty() || std::ranges::any_of(blocks, [&](std::int32_t block) {
           return std::ranges::binary_search(wall.blocks, block);
         });
}

/// An overlap of the start that counts as touching: gaps of this node with faces of this body are measured from it, for
/// the whole run, so that nothing need be remembered. Edges of which it is an end are measured from their own overlap
/// at the start.
struct AcceptedOverlap {
  GlobalIndex slave = 0;   ///< gid of the node
  std::int32_t body = 0;   ///< of the master
  double penetration = 0;  ///< [length], > 0
  std::int32_t slave_body = no_index;
};

struct DetectionSettings {
  const Tolerances* tolerances = &standard_tolerances;
  Criterion criterion = Criterion::automatic;
  bool recovery_gives = true;  ///< recovery may do work on the bodies at any depth: where overlaps of the start are to
                               ///< part. Else edges deeper than Tolerances::drift do not (see required_rate)
  double coincidence_distance = 0;  ///< nodes of two bodies this near each other are coincident [length]
  double wall_size = 0;             ///< [length] stands for the longest edge where the master is a wall
  std::vector<double> sound{};      ///< speed of sound of each body [velocity]; empty: recovery is as fast as steps are
  std::vector<AcceptedOverlap> accepted{};  ///< ordered by (slave, body), each pair once
  std::vector<BodyPair> flush{};            ///< ascending: bodies between which there is a seam; it is none to them
  std::vector<BodyPair> fitted{};           ///< ascending: bodies of which some overlap was accepted, or moved away
};

/// Slaves whose faces are looked at together, in batches of eight: so many that hardly a lane is left empty.
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

/// Do seams count where these bodies meet?
inline bool seams_count(const DetectionSettings& settings, std::int32_t slave_body, std::int32_t master_body) {
  if (settings.flush.empty()) return false;
  return !std::ranges::binary_search(settings.flush, BodyPair(std::minmax(slave_body, master_body)));
}

/// [length]; 0 where none is accepted.
double accepted_penetration(std::span<const AcceptedOverlap> accepted, GlobalIndex slave, std::int32_t body);

/// The time that stands for the step where a penetration is recovered [time]: the step, or if that is longer half the
/// time that sound takes along `size` [length] in the slower of the two bodies, which is about the stable step of a
/// cube of that size by itself.
double recovery_time(const Row& row, double size, double dt, const DetectionSettings& settings);

/// Least rate that the row's gap asks for [velocity]: it may close within the step; a penetration is recovered, a
/// limited share of it a step. Under load recovery does work on the bodies. Where they drifted in, that is little.
/// Edges that are deeper when they are first seen (they slipped over a rim, or their crossing passed a node where the
/// loaded chain of edges is bent, up to 1e-3 in a step) would be given what contact never took: they are parted no
/// faster than they came together, and stay while they are pressed. Not so nodes: what a step leaves would add up (in
/// averaged passes a pressed cube that hangs over another crept in by a tenth of an edge), and where soft faces sag
/// over a rim each node would let the next one in deeper (pressed rubber that slid on steel fell through it). But of
/// fitted bodies nodes too: what slides into the seat comes as deep as others lay there at the start, without any work,
/// and pushed out it gave 95 % of a peg's energy in a hole.
///
/// Where steps are short (a small element elsewhere, or one that is crushed) recovery_time counts in their place. Else
/// the speed would grow as they shrink, and nodes that are first seen deep, behind a rim, would be shot out: contact
/// gave 12 % of an impact's energy.
double required_rate(const Row& row, double size, double dt, std::span<const NodeMotion> motion,
                     const DetectionSettings& settings);

/// Are the nodes so near each other that each lies where the other does? The same seen from either.
inline bool are_coincident(const NodeMotion& one, const NodeMotion& other, const DetectionSettings& settings) {
  return (one.position - other.position).squaredNorm() < settings.coincidence_distance * settings.coincidence_distance;
}

/// Fills candidates.coincident, where there are second passes. positions: of the contact nodes where lists are made,
/// from where each may move by `motion` [length].
void list_coincident_nodes(std::span<const MasterFace> faces, std::span<const Vec3> positions, double motion,
                           const DetectionSettings& settings, Candidates& candidates);

/// Appends the rows of slave nodes with faces, at most most_rows_of_a_node each: see `encounter` and `select_rows`.
/// facet_area: along the area vectors of the slaves' own faces (their unit normals are left in the scratch).
/// remembered: the history; the sides of two-sided faces are taken from there, and left in the scratch for all pairs
/// that meet (Meeting::none aside). A node with a coincident one in the other body has no row there in the second of
/// two passes: that node's own row holds both.
void detect_faces(const Candidates& candidates, std::span<const MasterFace> faces, std::span<const GlobalIndex> gid,
                  std::span<const NodeMotion> motion, std::span<const Vec3> facet_area, double dt,
                  const DetectionSettings& settings, std::span<const HistoryRecord> remembered,
                  DetectionScratch& scratch, std::vector<Row>& rows, std::span<const BirthRecord> births = {});

/// Candidates of walls: node, wall, and whether the node started in a bilateral wall's plane (it is always a row).
struct WallCandidate {
  LocalIndex node = 0;
  std::int32_t wall = 0;
  std::int32_t body = 0;
  bool held = false;
};

void detect_walls(std::span<const WallCandidate> candidates, std::span<const Wall> walls,
                  std::span<const GlobalIndex> gid, std::span<const NodeMotion> motion, double dt,
                  const DetectionSettings& settings, std::vector<Row>& rows);

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

/// The order in which rows are kept. They come in a few runs that are in order (those of faces, of edges, of each
/// wall), which are merged.
void sort_rows(std::vector<Row>& rows, RowSortScratch& scratch);

}  // namespace brunt::contact
