// SPDX-License-Identifier: Apache-2.0
// One slave node and one face: in contact, coming into contact within the step, or only close to each other. (Heinstein
// et al. 2000, section 4.5: a node in contact is judged by its closest point, a node coming into contact by its
// velocity.)
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "contact/data/constraint.hpp"
#include "contact/data/standard_tolerances.hpp"
#include "geometry/box.hpp"
#include "geometry/closest_point.hpp"

namespace brunt::contact {

/// A possible master face, with contact nodes as corners: the surface of a solid, or a sheet with two contact surfaces
/// at half its thickness from the middle, where its nodes are.
struct MasterFace {
  GlobalIndex key = 0;
  std::array<LocalIndex, 4> nodes{};  ///< contact nodes, counter-clockwise seen from outside
  std::int32_t corner_count = 4;
  std::int32_t body = 0, block = 0;
  /// Depth of the element behind it, or the width of the face if that is less, at the start [length].
  double element_depth = std::numeric_limits<double>::infinity();
  std::uint8_t seams = 0;  ///< bit i: another face continues beyond edge i, see SurfaceFace
  bool two_sided = false;
  double half_thickness = 0;  ///< [length]
};

/// The side and clearance of a node relative to a face.
struct Approach {
  double side = 1;       ///< of a two-sided face: +1 along its normal, -1 against it
  double clearance = 0;  ///< half thicknesses of face and slave: the gap is measured from there [length]
};

/// Properties of a master face that are equal for all slaves near it.
struct FaceReach {
  geometry::Box box;  ///< swept over the step and grown by the settings' reach and the half thickness
  double size = 0;    ///< longest edge [length]
};

/// Relation between a node and a face.
enum class Meeting : std::int8_t {
  inside,    ///< at or behind the face, within reach: in contact
  hit,       ///< outside; its path crosses the moving face inwards within the step
  above,     ///< outside, over the face or its rim: impulses of the step may bring it into contact
  deferred,  ///< behind the face, but a neighbour in nearly the same direction has the penetration: the face only turns
             ///< the normal of the neighbour's row (see select_rows)
  none
};

/// A slave node and a master face. Positions are those at the start of the step.
struct Encounter {
  Meeting meeting = Meeting::none;
  LocalIndex face = no_index;
  geometry::Region region = geometry::Region::face;  ///< the feature of the face that has the closest point
  Approach approach{};
  double height = std::numeric_limits<double>::quiet_NaN();  ///< over the tangent plane at the closest point, less the
                                                             ///< clearance [length]
  double beside = 0;           ///< distance of the node's projection on that plane from the closest point [length]
  double gap = 0;              ///< to be closed by the row [length]
  double time = 0;             ///< of a hit, as a share of the step
  double size = 0;             ///< longest edge of the face [length]
  double order = 0;            ///< its rank among those of the slave, smallest first: see `select_rows`
  bool slow = false;           ///< moves little relative to the face within the step
  double opposition = 0;       ///< cosine between the reversed normal and the slave's normal cone; 0 for a lateral face
  Vec3 normal = Vec3::Zero();  ///< of the row, unit, out of the face on the node's side
  Vec3 point = Vec3::Zero();   ///< contact point on the face (in the middle surface)
  std::array<double, 4> weights{};  ///< shape functions of the face's corners there
};

/// Whether the slave's normal cone admits the face. Otherwise it is a lateral face, along which the node slides.
inline bool is_admissible(const Encounter& e) {
  return e.opposition > 0;
}

/// The master faces in one step.
struct FacesInMotion {
  std::span<const MasterFace> faces;
  std::span<const FaceReach> reach;    ///< of each face
  std::span<const NodeMotion> motion;  ///< of the contact nodes
  double dt = 0;                       ///< [time]
  const Tolerances& tolerances;

  [[nodiscard]] const MasterFace& face(LocalIndex index) const { return nth(faces, index); }
  [[nodiscard]] const MasterFace& face(const Encounter& e) const { return face(e.face); }
  [[nodiscard]] const NodeMotion& node(LocalIndex index) const { return nth(motion, index); }
  [[nodiscard]] const NodeMotion& corner(const MasterFace& face, std::size_t i) const { return node(face.nodes[i]); }
};

/// The closest point at the start of the step; the caller sets `opposition`. A node that neither touches nor is above
/// the face has Meeting::none; region and height are nevertheless set (NaN if the face has no area), since they
/// determine whether a node behind a neighbouring face is inside.
Encounter encounter(const FacesInMotion& scene, const NodeMotion& slave, LocalIndex face,
                    const Approach& approach = {});

/// The same for many pairs, one pack at a time, of slave[k] with met[k], whose face and approach are set. The result
/// for a pair does not depend on the others.
void encounter_all(const FacesInMotion& scene, std::span<const NodeMotion* const> slave, std::span<Encounter> met);

/// Velocity of the slave relative to the point of the face with these weights; which: old_velocity or predicted.
template <Vec3 NodeMotion::*which>
Vec3 relative_velocity(const FacesInMotion& scene, const NodeMotion& slave, const MasterFace& face,
                       const std::array<double, 4>& weights) {
  Vec3 relative = slave.*which;
  for (std::size_t i = 0; i < static_cast<std::size_t>(face.corner_count); ++i)
    relative -= weights[i] * scene.corner(face, i).*which;
  return relative;
}

/// Corners of the face that define a region: the two of an edge, one (twice) of a vertex.
std::array<LocalIndex, 2> nodes_of_feature(const MasterFace& face, geometry::Region region);

bool has_node(const MasterFace& face, LocalIndex node);

/// Number of common corners of two faces.
std::ptrdiff_t shared_nodes(const MasterFace& one, const MasterFace& other);

/// Whether the node's path passes through the face, from its side, within the step. It is then Meeting::hit.
void find_hit(const FacesInMotion& scene, const NodeMotion& slave, Encounter& met);

/// Whether two unit normals differ by at most this angle in degrees.
inline bool same_direction(const Vec3& one, const Vec3& other, double degrees) {
  const double cosine = one.dot(other), angle = degrees * std::numbers::pi / 180, half_square = 0.5 * angle * angle;
  // Bounds from the series of the cosine settle nearly all cases.
  if (cosine < 1 - half_square - 1e-14) return false;
  if (cosine > 1 - half_square * (1 - half_square / 6) + 1e-14) return true;
  return cosine >= std::cos(angle);
}

/// Whether all normals are certainly within this angle of each other, as on one smooth surface. A false result may
/// still be true: the function only avoids examining pairs. A face without a normal makes it false.
bool one_direction(std::span<const Encounter> encounters, double degrees);

/// Whether each of two faces of one body is in front of the other, as in a valley or a pit.
bool concave(const FacesInMotion& scene, const Encounter& a, const Encounter& b);

/// Examines the path of a node outside of faces: those through which it passes become Meeting::hit. Nodes that move
/// slowly above a face are judged by their closest point, and lateral faces are ignored. encounters: of one slave with
/// the faces of one body, after resolve_features.
void detect_path_hits(const FacesInMotion& scene, const NodeMotion& slave, std::span<Encounter> encounters);

}  // namespace brunt::contact
