// SPDX-License-Identifier: Apache-2.0
#include "contact/detection/features.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "contact/data/tolerances.hpp"

namespace brunt::contact {
namespace {

using geometry::Region;

double distance_to_face(const Encounter& e) {
  return std::sqrt(e.height * e.height + e.beside * e.beside);
}

/// The encounters of one slave with the faces of one body.
class Neighbourhood {
 public:
  Neighbourhood(const FacesInMotion& scene, const Tolerances& tolerances, Criterion criterion,
                std::span<const Encounter> encounters)
      : scene_(scene), tolerances_(tolerances), criterion_(criterion), encounters_(encounters) {}

  [[nodiscard]] Meeting meeting(const Encounter& e) const {
    if (e.meeting != Meeting::inside && e.meeting != Meeting::above) return e.meeting;
    const bool at_rim = e.beside <= rim_of(e);
    if (e.height > 0)
      return e.region == Region::face || (at_rim && !has_neighbour_in_front(e)) ? Meeting::above : Meeting::none;
    if (e.region == Region::face) return meeting_behind(e);
    if (!at_rim && !lies_in_a_pit(e)) return Meeting::none;
    const Meeting meeting = meeting_behind(e);
    return meeting == Meeting::inside && has_foot_on_smooth_neighbour(e) ? Meeting::above : meeting;
  }

 private:
  struct Nearest {
    const Encounter* face = nullptr;  ///< one of those that share the feature; null: there is none
    double distance = 0;              ///< > 0 outside of the body [length]
  };

  [[nodiscard]] const MasterFace& face_of(const Encounter& e) const {
    return scene_.faces[static_cast<std::size_t>(e.face)];
  }
  /// How far beside a face or behind it a place is as good as exact [length]: on a thin body its thickness decides.
  [[nodiscard]] double rim_of(const Encounter& e) const {
    return tolerances_.rim * std::min(e.size, face_of(e).element_depth);
  }
  /// The boxes that list faces reach farther along some directions of space than along others: what is beyond the reach
  /// has no say. Nor has a face without area.
  [[nodiscard]] bool is_near(const Encounter& e) const {
    return distance_to_face(e) <= tolerances_.reach(e.size, face_of(e).element_depth) + e.approach.clearance;
  }
  [[nodiscard]] bool any_is_admissible() const {
    return std::ranges::any_of(encounters_, [&](const Encounter& e) { return is_near(e) && is_admissible(e); });
  }
  /// A side has no say against an admissible face.
  [[nodiscard]] static bool competes(const Encounter& other, const Encounter& e) {
    return is_admissible(other) || !is_admissible(e);
  }
  [[nodiscard]] bool in_one_direction(const Encounter& one, const Encounter& other) const {
    return same_direction(one.normal, other.normal, tolerances_.same_direction);
  }

  /// Calls visit(encounter) for the other faces around the feature on which e has its point, until one says no. Did all
  /// say yes?
  template <class Visit>
  [[nodiscard]] bool all_around(const Encounter& e, Visit&& visit) const {
    const std::array<LocalIndex, 2> nodes = nodes_of_feature(face_of(e), e.region);
    return std::ranges::all_of(encounters_, [&](const Encounter& other) {
      if (&other == &e || !is_near(other)) return true;
      return !has_node(face_of(other), nodes[0]) || !has_node(face_of(other), nodes[1]) || visit(other);
    });
  }

  /// Is the node in the cone of a convex edge or vertex, of which this face is but one?
  [[nodiscard]] bool has_neighbour_in_front(const Encounter& e) const {
    return !all_around(e, [&](const Encounter& other) {
      return !(other.height > 0) || !competes(other, e) || in_one_direction(other, e) ||
             concave(scene_.faces, scene_.motion, e, other, tolerances_);
    });
  }

  /// Is there a near face beyond each side that starts at the feature? What is missing may have the node in front.
  [[nodiscard]] bool is_seen_all_around(const Encounter& e) const {
    const std::array<LocalIndex, 2> feature = nodes_of_feature(face_of(e), e.region);
    const auto is_joined = [&](const Encounter& one, LocalIndex end) {
      return std::ranges::any_of(encounters_, [&](const Encounter& other) {
        return &other != &one && is_near(other) && has_node(face_of(other), feature[0]) &&
               has_node(face_of(other), end);
      });
    };
    if (feature[0] != feature[1]) return is_joined(e, feature[1]);
    return std::ranges::all_of(encounters_, [&](const Encounter& one) {
      const MasterFace& face = face_of(one);
      if (!has_node(face, feature[0]) || !is_near(one)) return true;
      const auto count = static_cast<std::size_t>(face.corner_count);
      const auto corner = static_cast<std::size_t>(std::ranges::find(face.nodes, feature[0]) - face.nodes.begin());
      return is_joined(one, face.nodes[(corner + 1) % count]) &&
             is_joined(one, face.nodes[(corner + count - 1) % count]);
    });
  }

  /// A concave edge or vertex: the node is behind all faces around it, and over them or nearest to them there.
  [[nodiscard]] bool lies_in_a_pit(const Encounter& e) const {
    const auto is_behind = [&](const Encounter& other) {
      const auto in_one_place = [&] { return (other.point - e.point).norm() <= tolerances_.touching * e.size; };
      return other.height <= 0 && (other.region == Region::face || in_one_place());
    };
    return all_around(e, is_behind) && is_seen_all_around(e);
  }

  /// Beside e, but on a face that goes on from it smoothly? Then the foot there tells the gap, not the plane of e.
  [[nodiscard]] bool has_foot_on_smooth_neighbour(const Encounter& e) const {
    return std::ranges::any_of(encounters_, [&](const Encounter& other) {
      return other.region == Region::face && is_near(other) && in_one_direction(other, e) &&
             (other.point - e.point).norm() <= tolerances_.rim * std::min(e.size, other.size);
    });
  }

  /// Of the faces around the encounter's point [rad]: the whole angle within a face, half of it at an edge.
  [[nodiscard]] double angle_at_point(const Encounter& e) const {
    if (e.region == Region::face) return 2 * std::numbers::pi;
    if (e.region < Region::vertex0) return std::numbers::pi;
    const MasterFace& face = face_of(e);
    const auto count = static_cast<std::size_t>(face.corner_count);
    const auto corner = static_cast<std::size_t>(static_cast<int>(e.region) - static_cast<int>(Region::vertex0));
    const auto at = [&](std::size_t i) -> const Vec3& {
      return scene_.motion[static_cast<std::size_t>(face.nodes[i % count])].position;
    };
    const Vec3 next = at(corner + 1) - at(corner), last = at(corner + count - 1) - at(corner);
    return std::atan2(next.cross(last).norm(), next.dot(last));
  }

  /// The nearest feature of the faces that count, with the sign of its angle-weighted normal.
  template <class Counts>
  [[nodiscard]] Nearest nearest(const Counts& counts) const {
    Nearest nearest;
    for (const Encounter& e : encounters_) {
      if (!is_near(e)) continue;
      const double distance = distance_to_face(e);
      if ((nearest.face == nullptr || distance < nearest.distance) && counts(e)) nearest = {&e, distance};
    }
    if (nearest.face == nullptr) return nearest;
    double height = 0;
    for (const Encounter& e : encounters_) {
      if (!is_near(e) || (e.point - nearest.face->point).norm() > tolerances_.rounding * e.size) continue;
      height += angle_at_point(e) * e.height;
    }
    if (height <= 0) nearest.distance = -nearest.distance;
    return nearest;
  }

  /// Does the surface fall away from e to where the node is nearest to `other`, as it does around a convex edge? Where
  /// the penetration is no deeper than the rim, a dent between warped faces may look like one.
  [[nodiscard]] bool falls_away(const Encounter& e, const Encounter& other, bool deep) const {
    const Vec3 apart = other.point - e.point;
    return apart.dot(e.normal) < tolerances_.competing * e.height &&
           (deep || -apart.dot(other.normal) <= tolerances_.touching * e.size);
  }

  [[nodiscard]] Meeting meeting_behind(const Encounter& e) const {
    const double rim = rim_of(e);
    const bool deep = -e.height > rim;
    if (!deep && std::ranges::none_of(encounters_, [](const Encounter& other) { return other.height > 0; }))
      return Meeting::inside;  // nearly always
    const bool sides_count = deep && !any_is_admissible();
    const Nearest found = nearest([&](const Encounter& other) {
      const auto is_clear = [&] {
        return other.height > 0 && distance_to_face(other) > tolerances_.touching * other.size;
      };
      if (deep) return is_admissible(other) || sides_count || is_clear();
      return competes(other, e);
    });
    if (found.face == nullptr || found.face == &e || !falls_away(e, *found.face, deep)) return Meeting::inside;
    const bool came_in_there = criterion_ == Criterion::automatic && deep && -e.height > rim - found.distance;
    if (!(found.distance > 0) && !came_in_there) return Meeting::inside;
    return in_one_direction(*found.face, e) ? Meeting::above : Meeting::none;
  }

  const FacesInMotion& scene_;
  const Tolerances& tolerances_;
  Criterion criterion_;
  std::span<const Encounter> encounters_;
};

}  // namespace

void resolve_features(const FacesInMotion& scene, const Tolerances& tolerances, Criterion criterion,
                      std::span<Encounter> encounters) {
  const Neighbourhood neighbourhood(scene, tolerances, criterion, encounters);
  // decided by heights and places, which stay, so that the order of the faces means nothing
  for (Encounter& e : encounters) e.meeting = neighbourhood.meeting(e);
}

}  // namespace brunt::contact
