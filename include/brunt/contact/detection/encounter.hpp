// SPDX-License-Identifier: Apache-2.0
// One slave node and one face: are they in contact, do they come into contact within the step, or are they only near
// each other? (Heinstein et al. 2000, section 4.5: a node in contact is judged by its closest point, a node coming
// into contact by its velocity.)
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "brunt/contact/data/constraint.hpp"
#include "brunt/contact/data/standard_tolerances.hpp"
#include "brunt/geometry/box.hpp"
#include "brunt/geometry/closest_point.hpp"

namespace brunt::contact {

/// A face that may be a master, with contact nodes as corners: the skin of a solid, or a sheet that is met from both
/// sides at half its thickness from the middle, where its nodes are.
struct MasterFace {
  GlobalIndex key = 0;
  std::array<LocalIndex, 4> nodes{};  ///< contact nodes, counter-clockwise seen from outside
  std::int32_t corner_count = 4;
  std::int32_t body = 0, block = 0;
  /// Of its element behind it, or the width of the face if that is less, at the start [length].
  double element_depth = std::numeric_limits<double>::infinity();
  std::uint8_t seams = 0;  ///< bit i: beyond side i another face goes on, see SurfaceFace
  bool two_sided = false;
  double half_thickness = 0;  ///< [length]
};

/// From where a node comes to a face.
struct Approach {
  double side = 1;       ///< of a two-sided face: +1 along its normal, -1 against it
  double clearance = 0;  ///< half thicknesses of face and slave: the gap is measured from there [length]
};

/// What of a master face is the same for all slaves near it.
struct FaceReach {
  geometry::Box box;  ///< swept over the step and grown by the settings' reach and the half thickness
  double size = 0;    ///< longest edge [length]
};

/// How a node meets a face.
enum class Meeting : std::int8_t {
  inside,  ///< at or behind it: in contact
  hit,     ///< its path crosses the moving face inwards within the step
  above,   ///< outside of it, projecting on it: the step's impulses may bring it there
  none
};

struct Encounter {
  Meeting meeting = Meeting::none;
  LocalIndex face = no_index;
  geometry::Region region = geometry::Region::face;  ///< of the closest point, at the start of the step
  Approach approach{};
  double height = std::numeric_limits<double>::quiet_NaN();  ///< over the plane at the closest point, less the
                                                             ///< clearance, at the start [length]
  double beside = 0;                ///< distance of the node's foot on that plane from the point
  double gap = 0;                   ///< that the row closes [length]
  double time = 0;                  ///< of a hit, as a share of the step
  double size = 0;                  ///< longest edge of the face [length]
  double order = 0;                 ///< what ranks it among the slave's, the least first: see `select_rows`
  bool slow = false;                ///< moves little against the face within the step
  double opposition = 0;            ///< cosine of the reversed normal to the slave's normal cone; 0 of a side
  Vec3 normal = Vec3::Zero();       ///< of the row, unit, out of the face on the node's side
  Vec3 point = Vec3::Zero();        ///< on the face (on its middle), where they meet
  std::array<double, 4> weights{};  ///< of the face's corners there
};

/// Does the slave's normal cone admit the face? Else it is a side, along which the node slides.
inline bool is_admissible(const Encounter& e) {
  return e.opposition > 0;
}

/// The faces and nodes that detection looks at.
struct FacesInMotion {
  std::span<const MasterFace> faces;
  std::span<const FaceReach> reach;    ///< of each face
  std::span<const NodeMotion> motion;  ///< of contact nodes
  double dt = 0;
};

/// The closest point at the start of the step; `opposition` is left to the caller. A node that neither touches nor is
/// above the face has Meeting::none, with region and height filled all the same (NaN where the face has no area): they
/// decide whether a node behind a neighbour is inside.
Encounter encounter(const FacesInMotion& scene, const Tolerances& tolerances, const NodeMotion& slave, LocalIndex face,
                    const Approach& approach = {});

/// The same for many pairs, a pack at a time, of slave[k] with met[k], whose face and approach are set. What comes of a
/// pair does not depend on the others.
void encounter_all(const FacesInMotion& scene, const Tolerances& tolerances, std::span<const NodeMotion* const> slave,
                   std::span<Encounter> met);

/// Corners of the face on which a point of this region lies: the two of an edge, one (twice) of a vertex.
std::array<LocalIndex, 2> nodes_of_feature(const MasterFace& face, geometry::Region region);

bool has_node(const MasterFace& face, LocalIndex node);

/// How many corners two faces have in common.
std::ptrdiff_t shared_nodes(const MasterFace& one, const MasterFace& other);

/// Does the node's path pass through the face, seen from its side, within the step? Then it is Meeting::hit.
void find_hit(const FacesInMotion& scene, const NodeMotion& slave, Encounter& met);

/// Do two unit normals differ by at most so many degrees?
inline bool same_direction(const Vec3& one, const Vec3& other, double degrees) {
  const double cosine = one.dot(other), angle = degrees * std::numbers::pi / 180, half_square = 0.5 * angle * angle;
  // the series of the cosine brackets it: that settles nearly all
  if (cosine < 1 - half_square - 1e-14) return false;
  if (cosine > 1 - half_square * (1 - half_square / 6) + 1e-14) return true;
  return cosine >= std::cos(angle);
}

/// Are all normals surely within so many degrees of each other, as those of one smooth surface are? False may still
/// turn out to be true: it saves looking at pairs, nothing more. A face without a normal makes it false.
bool one_direction(std::span<const Encounter> encounters, double degrees);

/// Is each of two faces of one body in front of the other, as on the slopes of a valley or a pit?
bool concave(std::span<const MasterFace> faces, std::span<const NodeMotion> motion, const Encounter& a,
             const Encounter& b, const Tolerances& tolerances);

/// Looks along the path of a node that is outside of faces: those that it passes through become Meeting::hit. Nodes
/// that move slowly above a face are left to their closest point, and faces that are not admissible are passed over
/// (sides of flush bodies, along which nodes slide). encounters: of one slave with the faces of one body, after
/// resolve_features.
void detect_path_hits(const FacesInMotion& scene, const Tolerances& tolerances, const NodeMotion& slave,
                      std::span<Encounter> encounters);

}  // namespace brunt::contact
