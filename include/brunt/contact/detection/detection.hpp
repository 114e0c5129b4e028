// SPDX-License-Identifier: Apache-2.0
// From candidate pairs to constraint rows. What is decided here is a function of positions, predicted velocities and
// the step alone: candidates that cannot touch in this step are ignored by a criterion of their own, so a longer list
// of candidates changes no bit.
#pragma once
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "brunt/contact/constraint.hpp"
#include "brunt/core/ragged.hpp"
#include "brunt/geometry/box.hpp"

namespace brunt::contact {

/// A face that may be a master, with contact nodes as corners.
struct MasterFace {
  GlobalIndex key = 0;
  std::array<LocalIndex, 4> nodes{};  ///< contact nodes, counter-clockwise seen from outside
  std::int32_t corner_count = 4;
  std::int32_t body = 0, block = 0;
  double depth = std::numeric_limits<double>::infinity();  ///< of its element behind it, at the start [length]
};

/// Candidate pairs, slave by slave in ascending gid.
struct Candidates {
  std::vector<LocalIndex> slave;    ///< contact node
  std::vector<std::int32_t> body;   ///< of the slave
  Ragged<LocalIndex> faces;         ///< master faces, ordered by (body, key)
  Ragged<LocalIndex> slave_facets;  ///< faces of the slave's own surface around it: rows of the facet area vectors
};

/// A rigid plane at t_n; bodies are on the side that the normal points to.
struct Wall {
  Vec3 point = Vec3::Zero(), normal = Vec3::UnitZ();
  Vec3 velocity = Vec3::Zero();
  bool bilateral = false;  ///< nodes that start in the plane stay in it
};

struct DetectionSettings {
  double capture = 0.25;         ///< a node farther than this share of the longest edge from a face's swept box, or
                                 ///< deeper than this below it, has nothing to do with the face
  double element_share = 0.5;    ///< nor has one deeper than this share of the face's element: behind flat elements lie
                                 ///< other bodies that touch the far side
  double overhang = 0.02;        ///< a node beside a face by up to this share of the longest edge still meets it
  double recovery = 0.05;        ///< share of a penetration that a step may recover
  double recovery_limit = 1e-3;  ///< the same limited to this share of the longest edge
  double wall_size = 0;          ///< [length] stands for the longest edge where the master is a wall
};

/// How a node meets a face, best first.
enum class Meeting : std::int8_t { on_face, overhang, edge, none };

/// One slave node and one face that it may touch in this step.
struct Encounter {
  Meeting meeting = Meeting::none;
  LocalIndex face = no_index;
  double gap = 0, size = 0;  ///< [length]; size: longest edge
  double opposition = 0;     ///< cosine between the master's normal and the reversed normal of the most opposed facet
  Vec3 normal = Vec3::Zero();
  std::array<double, 4> weights{};
};

/// What of a master face is the same for all slaves near it.
struct FaceReach {
  geometry::Box box;  ///< swept over the step and grown by the capture
  double size = 0;    ///< longest edge [length]
};

/// Arrays of detection, sized where lists are rebuilt so that a step allocates nothing.
struct DetectionScratch {
  std::vector<FaceReach> reach;
  std::vector<Vec3> facet_normal;  ///< unit; zero for a facet without area
  std::vector<Encounter> encounters;

  void reserve(std::size_t faces, std::size_t facets, std::size_t most_faces_of_a_slave) {
    reach.reserve(faces);
    facet_normal.reserve(facets);
    encounters.reserve(most_faces_of_a_slave);
  }
};

/// Appends at most one row for each slave and master body. Among the faces that the slave's own surface opposes by at
/// least half of the best: one that contains the projection with the smallest |gap|, else one that misses it by the
/// overhang, else the nearest edge or corner of a face seen from outside (its normal is the connecting line). Ties go
/// to the lower key. facet_area: area vectors [length^2] of the slaves' own faces.
void detect_faces(const Candidates& candidates, std::span<const MasterFace> faces, std::span<const GlobalIndex> gid,
                  std::span<const NodeMotion> motion, std::span<const Vec3> facet_area, double dt,
                  const DetectionSettings& settings, DetectionScratch& scratch, std::vector<Row>& rows);

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

/// The order in which rows are kept.
void sort_rows(std::vector<Row>& rows);

}  // namespace brunt::contact
