// SPDX-License-Identifier: Apache-2.0
#include "contact/detection/select_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/data/tolerances.hpp"

namespace brunt::contact {
namespace {

struct Selection {
  const FacesInMotion& scene;
  const NodeMotion& slave;
  Criterion criterion;
  bool smooth = false;  ///< all normals certainly have one direction

  [[nodiscard]] const Tolerances& tolerances() const { return scene.tolerances; }
  [[nodiscard]] bool same_body(const Encounter& a, const Encounter& b) const {
    return scene.face(a).body == scene.face(b).body;
  }
  [[nodiscard]] bool same_direction(const Encounter& a, const Encounter& b) const {
    return smooth || contact::same_direction(a.normal, b.normal, tolerances().same_direction);
  }
  [[nodiscard]] bool concave(const Encounter& a, const Encounter& b) const { return contact::concave(scene, a, b); }
};

/// Order of the meetings: in contact, coming into contact, neither.
int rank_of(Meeting meeting) {
  if (meeting == Meeting::inside) return 0;
  return meeting == Meeting::hit ? 1 : 2;
}

/// Moves the opposed encounters to the front and returns their number. In a valley both slopes count, even one that the
/// slave's surface opposes only slightly; around a convex edge such a face is a lateral face of flush bodies.
std::size_t remove_unopposed(const Selection& selection, std::span<Encounter> encounters) {
  const auto less = [](const Encounter& a, const Encounter& b) {
    return (a.meeting == Meeting::none ? -1 : a.opposition) < (b.meeting == Meeting::none ? -1 : b.opposition);
  };
  const auto found = std::ranges::max_element(encounters, less);
  if (found == encounters.end() || found->meeting == Meeting::none || !is_admissible(*found)) return 0;
  const Encounter best = *found;  // a copy, since the encounters are moved
  const auto end = std::remove_if(encounters.begin(), encounters.end(), [&](const Encounter& e) {
    if (e.meeting == Meeting::none || !is_admissible(e)) return true;
    return e.opposition < selection.tolerances().competing * best.opposition &&
           !(selection.same_body(e, best) && selection.concave(e, best));
  });
  return static_cast<std::size_t>(end - encounters.begin());
}

/// Distance to be closed [length]: for a node beside the face, that to the rim.
double gap_distance(const Encounter& e) {
  return e.meeting == Meeting::hit ? std::abs(e.gap) : std::sqrt(e.gap * e.gap + e.beside * e.beside);
}

/// The order in which the encounters of a slave compete. The constructor sets their `order`.
class Ranking {
 public:
  Ranking(const Selection& selection, std::span<Encounter> encounters)
      : selection_(selection), criterion_(selection.criterion) {
    for (Encounter& e : encounters)
      e.order =
          criterion_ == Criterion::strength ? -std::abs(e.gap) * e.opposition : (by_time(e) ? e.time : gap_distance(e));
  }
  [[nodiscard]] bool operator()(const Encounter& a, const Encounter& b) const {
    if (rank(a) != rank(b)) return rank(a) < rank(b);
    if (a.order != b.order) return a.order < b.order;
    if (a.opposition != b.opposition) return a.opposition > b.opposition;
    return selection_.scene.face(a).key < selection_.scene.face(b).key;
  }

 private:
  [[nodiscard]] bool by_time(const Encounter& e) const {
    return e.meeting == Meeting::hit && criterion_ != Criterion::nearest;
  }
  [[nodiscard]] int rank(const Encounter& e) const {
    if (criterion_ == Criterion::nearest || criterion_ == Criterion::strength) return 0;
    return criterion_ == Criterion::velocity ? (by_time(e) ? 0 : 1) : rank_of(e.meeting);
  }
  const Selection& selection_;
  Criterion criterion_;
};

/// Turns the row to another normal: the gap of a node inside is projected, and one that hits arrives at the same time.
void turn(const Selection& selection, const Vec3& normal, Encounter& e) {
  if (e.meeting == Meeting::hit) {
    const FacesInMotion& scene = selection.scene;
    const Vec3 relative = relative_velocity<&NodeMotion::predicted>(scene, selection.slave, scene.face(e), e.weights);
    e.gap = std::max(0.0, -e.time * scene.dt * normal.dot(relative));
  } else {
    e.gap *= e.normal.dot(normal);
  }
  e.normal = normal;
}

/// Distance within which two contact points are one [length].
double one_point(const Selection& selection, const Encounter& a, const Encounter& b) {
  return selection.tolerances().rim * std::min(a.size, b.size);
}

/// Weight of the normal of a face that is met at the same point as the best one, across a convex edge or corner. It is
/// that of the best face if both are equally deep, and zero if the face is five times as deep, or deeper by the rim
/// tolerance. The normal thus rotates without a jump when a node slides along the inside. (A node at the surface of the
/// best face counts as outside of it, and the other face has no influence; otherwise nodes of a fine mesh would
/// penetrate near the rim of a coarse one, whose rim tolerance is large.) A node that comes into contact at the edge
/// touches all of its faces.
double share_at_convex_edge(const Selection& selection, const Encounter& e, const Encounter& best) {
  if (e.meeting != Meeting::inside) return 1;
  const Tolerances& tolerances = selection.tolerances();
  const double width =
      std::min(one_point(selection, e, best), tolerances.drift * std::min(e.size, best.size) + 4 * std::abs(best.gap));
  const double deeper = (std::abs(e.gap) - std::abs(best.gap)) / width;
  return std::clamp((1 - std::abs(deeper)) / (1 - tolerances.slight), 0.0, 1.0);
}

/// Faces met at the same point by one node act along their mean normal if they share a convex edge or corner, since
/// rounding would decide which of them is met first. On slightly curved surfaces the normal rotates from one face's to
/// the other's within the rim tolerance of their common edge, so that a node may slide over it without a jump.
void merge_normals(const Selection& selection, std::span<Encounter> encounters) {
  Encounter& best = encounters.front();
  Vec3 sum = best.normal;
  for (const Encounter& e : encounters.subspan(1)) {
    if (!selection.same_body(e, best)) continue;
    const double width = one_point(selection, e, best);
    const double apart2 = (e.point - best.point).squaredNorm();
    if (apart2 > width * width) continue;
    if (selection.same_direction(e, best))
      sum += (1 - std::sqrt(apart2) / width) * e.normal;
    else if (rank_of(e.meeting) == rank_of(best.meeting) && !selection.concave(e, best))
      sum += share_at_convex_edge(selection, e, best) * e.normal;
  }
  const double length = sum.norm();
  if (length > selection.tolerances().slight)
    turn(selection, sum / length, best);  // else the faces look away from each other: a blade without thickness
}

/// Whether the face needs a row besides those kept: in another direction, and of another body or at a concave place.
bool needs_a_row(const Selection& selection, std::span<const Encounter> kept, const Encounter& e) {
  return std::ranges::all_of(kept, [&](const Encounter& k) {
    return !selection.same_direction(k, e) && (!selection.same_body(k, e) || selection.concave(k, e));
  });
}

}  // namespace

std::size_t select_rows(const FacesInMotion& scene, const NodeMotion& slave, Criterion criterion,
                        std::span<Encounter> encounters) {
  Selection selection{scene, slave, criterion};
  encounters = encounters.first(remove_unopposed(selection, encounters));
  if (encounters.size() < 2) return encounters.size();
  selection.smooth = one_direction(encounters, scene.tolerances.same_direction);
  const Ranking before(selection, encounters);
  if (const auto best = std::ranges::min_element(encounters, before); best != encounters.begin())
    std::swap(encounters.front(), *best);
  merge_normals(selection, encounters);
  if (selection.smooth) return 1;  // the usual case
  const std::span<Encounter> others = encounters.subspan(1);
  const auto needs = [&](const Encounter& e) { return needs_a_row(selection, encounters.first(1), e); };
  if (std::ranges::none_of(others, needs)) return 1;
  std::sort(others.begin(), others.end(), before);
  std::size_t kept = 1;
  for (std::size_t i = 1; i < encounters.size() && kept < most_rows_of_a_node; ++i)
    if (needs_a_row(selection, encounters.first(kept), encounters[i])) std::swap(encounters[kept++], encounters[i]);
  return kept;
}

}  // namespace brunt::contact
