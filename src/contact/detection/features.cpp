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

/// Where the node lies relative to a face and its neighbours, numbered as on the page.
enum class Zone : std::int8_t {
  over_face = 1,   ///< outside; the closest point is the projection on the face
  over_rim = 2,    ///< outside, beside the face by at most the rim; no neighbour is in front of the node
  in_cone = 3,     ///< the same, but within the normal cone of a convex edge or vertex
  under_face = 4,  ///< behind; the closest point is the projection on the face
  under_rim = 5,   ///< behind, beside the face by at most the rim
  in_pit = 6,      ///< behind, farther beside the face, but behind all faces of a concave edge or vertex
  elsewhere = 7
};

double distance_to_face(const Encounter& e) {
  return std::sqrt(e.height * e.height + e.beside * e.beside);
}

/// The encounters of one slave with the faces of one body.
class Neighbourhood {
 public:
  Neighbourhood(const FacesInMotion& scene, Criterion criterion, std::span<const Encounter> encounters)
      : scene_(scene), tolerances_(scene.tolerances), criterion_(criterion), encounters_(encounters) {}

  [[nodiscard]] Meeting meeting(const Encounter& e) const {
    if (e.meeting != Meeting::inside && e.meeting != Meeting::above) return e.meeting;
    switch (zone_of(e)) {
      case Zone::over_face:
      case Zone::over_rim:
        return Meeting::above;
      case Zone::under_face:
        return meeting_behind(e);
      case Zone::under_rim:
      case Zone::in_pit: {
        const Meeting behind = meeting_behind(e);
        return behind == Meeting::inside && has_projection_on_smooth_neighbour(e) ? Meeting::deferred : behind;
      }
      case Zone::in_cone:
      case Zone::elsewhere:
        break;
    }
    return Meeting::none;
  }

 private:
  /// The feature of the body that is nearest to the node.
  struct Nearest {
    const Encounter* face = nullptr;  ///< one of the faces that share the feature; null: there is none
    double distance = 0;              ///< signed, > 0 outside of the body [length]
  };

  [[nodiscard]] Zone zone_of(const Encounter& e) const {
    const bool outside = e.height > 0;
    if (e.region == Region::face) return outside ? Zone::over_face : Zone::under_face;
    const bool at_rim = e.beside <= rim_of(e);
    if (!outside) return at_rim ? Zone::under_rim : (is_in_pit(e) ? Zone::in_pit : Zone::elsewhere);
    if (!at_rim) return Zone::elsewhere;
    return has_neighbour_in_front(e) ? Zone::in_cone : Zone::over_rim;
  }

  /// Accuracy of positions beside and behind a face [length]; in a thin body the thickness limits it.
  [[nodiscard]] double rim_of(const Encounter& e) const {
    return tolerances_.rim * std::min(e.size, scene_.face(e).element_depth);
  }
  /// Whether the node is within reach of the face. Candidates come from boxes along the axes, which contain more. A
  /// face without area (height NaN) is never near.
  [[nodiscard]] bool is_near(const Encounter& e) const {
    return distance_to_face(e) <= tolerances_.reach(e.size, scene_.face(e).element_depth) + e.approach.clearance;
  }
  [[nodiscard]] bool any_is_admissible() const {
    return std::ranges::any_of(encounters_, [&](const Encounter& e) { return is_near(e) && is_admissible(e); });
  }
  /// A lateral face does not decide about an admissible one.
  [[nodiscard]] static bool competes(const Encounter& other, const Encounter& e) {
    return is_admissible(other) || !is_admissible(e);
  }
  [[nodiscard]] bool in_one_direction(const Encounter& one, const Encounter& other) const {
    return same_direction(one.normal, other.normal, tolerances_.same_direction);
  }

  /// Whether the predicate is true of all other near faces that share the feature with e's closest point.
  template <class Predicate>
  [[nodiscard]] bool all_around(const Encounter& e, Predicate&& predicate) const {
    const std::array<LocalIndex, 2> nodes = nodes_of_feature(scene_.face(e), e.region);
    return std::ranges::all_of(encounters_, [&](const Encounter& other) {
      if (&other == &e || !is_near(other)) return true;
      const MasterFace& face = scene_.face(other);
      return !has_node(face, nodes[0]) || !has_node(face, nodes[1]) || predicate(other);
    });
  }

  /// Whether another face of a convex edge or vertex also has the node in front: the node is in the cone of the
  /// feature.
  [[nodiscard]] bool has_neighbour_in_front(const Encounter& e) const {
    return !all_around(e, [&](const Encounter& other) {
      return !(other.height > 0) || !competes(other, e) || in_one_direction(other, e) || concave(scene_, e, other);
    });
  }

  /// Whether near faces surround the feature without a gap. The missing face could have the node in front.
  [[nodiscard]] bool is_surrounded(const Encounter& e) const {
    const std::array<LocalIndex, 2> feature = nodes_of_feature(scene_.face(e), e.region);
    const auto has_neighbour_at = [&](const Encounter& one, LocalIndex end) {
      return std::ranges::any_of(encounters_, [&](const Encounter& other) {
        return &other != &one && is_near(other) && has_node(scene_.face(other), feature[0]) &&
               has_node(scene_.face(other), end);
      });
    };
    if (feature[0] != feature[1]) return has_neighbour_at(e, feature[1]);
    return std::ranges::all_of(encounters_, [&](const Encounter& one) {
      const MasterFace& face = scene_.face(one);
      if (!has_node(face, feature[0]) || !is_near(one)) return true;
      const auto count = static_cast<std::size_t>(face.corner_count);
      const auto corner = static_cast<std::size_t>(std::ranges::find(face.nodes, feature[0]) - face.nodes.begin());
      return has_neighbour_at(one, face.nodes[(corner + 1) % count]) &&
             has_neighbour_at(one, face.nodes[(corner + count - 1) % count]);
    });
  }

  /// Zone 6: the node is behind all faces of the feature, and the closest point of each is its projection or is on the
  /// feature.
  [[nodiscard]] bool is_in_pit(const Encounter& e) const {
    const auto is_behind = [&](const Encounter& other) {
      const auto have_one_point = [&] { return (other.point - e.point).norm() <= tolerances_.touching * e.size; };
      return other.height <= 0 && (other.region == Region::face || have_one_point());
    };
    return all_around(e, is_behind) && is_surrounded(e);
  }

  /// Whether the node, beside e, has its projection on a face that continues e smoothly: the gap is measured there, and
  /// not from the plane of e.
  [[nodiscard]] bool has_projection_on_smooth_neighbour(const Encounter& e) const {
    return std::ranges::any_of(encounters_, [&](const Encounter& other) {
      return other.region == Region::face && is_near(other) && in_one_direction(other, e) &&
             (other.point - e.point).norm() <= tolerances_.rim * std::min(e.size, other.size);
    });
  }

  /// Angle of the face at the closest point [rad]: 2 pi within the face, pi at an edge.
  [[nodiscard]] double angle_at_point(const Encounter& e) const {
    if (e.region == Region::face) return 2 * std::numbers::pi;
    if (e.region < Region::vertex0) return std::numbers::pi;
    const MasterFace& face = scene_.face(e);
    const auto count = static_cast<std::size_t>(face.corner_count);
    const auto corner = static_cast<std::size_t>(static_cast<int>(e.region) - static_cast<int>(Region::vertex0));
    const auto at = [&](std::size_t i) -> const Vec3& { return scene_.corner(face, i % count).position; };
    const Vec3 next = at(corner + 1) - at(corner), last = at(corner + count - 1) - at(corner);
    return std::atan2(next.cross(last).norm(), next.dot(last));
  }

  /// The nearest feature of the faces that count, its distance with the sign of the angle-weighted normal.
  template <class Counts>
  [[nodiscard]] Nearest nearest(const Counts& counts) const {
    Nearest nearest;
    for (const Encounter& e : encounters_) {
      if (!is_near(e)) continue;
      const double distance = distance_to_face(e);
      if ((nearest.face == nullptr || distance < nearest.distance) && counts(e)) nearest = {&e, distance};
    }
    if (nearest.face == nullptr) return nearest;
    double weighted_height = 0;
    for (const Encounter& e : encounters_) {
      if (!is_near(e) || (e.point - nearest.face->point).norm() > tolerances_.rounding * e.size) continue;
      weighted_height += angle_at_point(e) * e.height;
    }
    if (weighted_height <= 0) nearest.distance = -nearest.distance;
    return nearest;
  }

  /// The nearest feature that may refute a penetration through e. A shallow one is refuted only by faces that compete
  /// with it. A deep one is refuted also by a lateral face that clearly has the node in front, and by all lateral faces
  /// if no face is admissible.
  [[nodiscard]] Nearest nearest_that_counts(const Encounter& e, bool deep) const {
    const bool all_count = deep && !any_is_admissible();
    return nearest([&](const Encounter& other) {
      if (!deep) return competes(other, e);
      const auto is_clear = [&] {
        return other.height > 0 && distance_to_face(other) > tolerances_.touching * other.size;
      };
      return is_admissible(other) || all_count || is_clear();
    });
  }

  /// Whether the surface falls away from e towards `other`, as around a convex edge. For a shallow penetration e's
  /// closest point must also not be in front of the other face: a dent between warped faces may resemble a convex edge.
  [[nodiscard]] bool falls_away(const Encounter& e, const Encounter& other, bool deep) const {
    const Vec3 apart = other.point - e.point;
    return apart.dot(e.normal) < tolerances_.competing * e.height &&
           (deep || -apart.dot(other.normal) <= tolerances_.touching * e.size);
  }

  /// Zones 4 to 6: whether the node has entered through this face.
  [[nodiscard]] Meeting meeting_behind(const Encounter& e) const {
    const double rim = rim_of(e);
    const bool deep = -e.height > rim;
    if (!deep && std::ranges::none_of(encounters_, [](const Encounter& other) { return other.height > 0; }))
      return Meeting::inside;  // the usual case
    const Nearest found = nearest_that_counts(e, deep);
    if (found.face == nullptr || found.face == &e || !falls_away(e, *found.face, deep)) return Meeting::inside;
    const bool is_outside = found.distance > 0;
    const bool entered_there = criterion_ == Criterion::automatic && deep && -e.height > rim - found.distance;
    if (!is_outside && !entered_there) return Meeting::inside;
    return in_one_direction(*found.face, e) ? Meeting::deferred : Meeting::none;
  }

  const FacesInMotion& scene_;
  const Tolerances& tolerances_;
  Criterion criterion_;
  std::span<const Encounter> encounters_;
};

}  // namespace

void resolve_features(const FacesInMotion& scene, Criterion criterion, std::span<Encounter> encounters) {
  const Neighbourhood neighbourhood(scene, criterion, encounters);
  // heights and closest points decide, which do not change: the order of the faces has no influence
  for (Encounter& e : encounters) e.meeting = neighbourhood.meeting(e);
}

}  // namespace brunt::contact
