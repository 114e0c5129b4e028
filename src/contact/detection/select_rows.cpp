// SPDX-License-Identifier: Apache-2.0
#include "contact/detection/select_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/data/tolerances.hpp"

namespace brunt::contact {
namespace {

struct Selection {
  std::span<const MasterFace> faces;
  std::span<const NodeMotion> motion;
  const NodeMotion& slave;
  double dt;
  Criterion criterion;
  const Tolerances& tolerances;
  bool smooth = false;  ///< all normals are surely alike

  [[nodiscard]] const MasterFace& face(const Encounter& e) const { return faces[static_cast<std::size_t>(e.face)]; }
  [[nodiscard]] bool same_body(const Encounter& a, const Encounter& b) const { return face(a).body == face(b).body; }
  [[nodiscard]] bool same_direction(const Encounter& a, const Encounter& b) const {
    return smooth || contact::same_direction(a.normal, b.normal, tolerances.same_direction);
  }
  [[nodiscard]] bool concave(const Encounter& a, const Encounter& b) const {
    return contact::concave(faces, motion, a, b, tolerances);
  }
};

/// Selected encounters come first; returns their number. In a valley both slopes are selected, even one that the
/// slave's surface opposes only slightly; around a convex edge such a face is a side along which bodies lie flush.
std::size_t remove_unopposed(const Selection& selection, std::span<Encounter> encounters) {
  const auto less = [](const Encounter& a, const Encounter& b) {
    return (a.meeting == Meeting::none ? -1 : a.opposition) < (b.meeting == Meeting::none ? -1 : b.opposition);
  };
  const auto found = std::ranges::max_element(encounters, less);
  if (found == encounters.end() || found->meeting == Meeting::none || !is_admissible(*found)) return 0;
  const Encounter best = *found;  // a copy: the others are moved
  const auto end = std::remove_if(encounters.begin(), encounters.end(), [&](const Encounter& e) {
    if (e.meeting == Meeting::none || !is_admissible(e)) return true;
    return e.opposition < selection.tolerances.competing * best.opposition &&
           !(selection.same_body(e, best) && selection.concave(e, best));
  });
  return static_cast<std::size_t>(end - encounters.begin());
}

/// |gap|, for a node beside the face to its rim.
double gap_distance(const Encounter& e) {
  return e.meeting == Meeting::hit ? std::abs(e.gap) : std::sqrt(e.gap * e.gap + e.beside * e.beside);
}

/// Who of a slave's encounters goes before whom; their order is set with it.
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
    return selection_.face(a).key < selection_.face(b).key;
  }

 private:
  [[nodiscard]] bool by_time(const Encounter& e) const {
    return e.meeting == Meeting::hit && criterion_ != Criterion::nearest;
  }
  [[nodiscard]] int rank(const Encounter& e) const {
    if (criterion_ == Criterion::nearest || criterion_ == Criterion::strength) return 0;
    return criterion_ == Criterion::velocity ? (by_time(e) ? 0 : 1) : static_cast<int>(e.meeting);
  }
  const Selection& selection_;
  Criterion criterion_;
};

/// The row's gap along another normal: a node inside is carried along, one that hits arrives at the same time.
void turn(const Selection& selection, const Vec3& normal, Encounter& e) {
  if (e.meeting == Meeting::hit) {
    Vec3 relative = selection.slave.predicted;
    const MasterFace& master = selection.face(e);
    for (std::size_t i = 0; i < static_cast<std::size_t>(master.corner_count); ++i)
      relative -= e.weights[i] * selection.motion[static_cast<std::size_t>(master.nodes[i])].predicted;
    e.gap = std::max(0.0, -e.time * selection.dt * normal.dot(relative));
  } else {
    e.gap *= e.normal.dot(normal);
  }
  e.normal = normal;
}

/// Contribution to the normal of a face that is met at the same place as the best one, behind a convex edge or corner.
/// It is that of the best face if both are equally deep, and zero if the face is five times as deep, or deeper by the
/// rim tolerance. The normal thus rotates without a jump when a node slides along the inside. (A node at the surface of
/// the best face counts as outside of it, and the other face has no influence; otherwise nodes of a fine mesh would
/// penetrate near the rim of a coarse one, whose rim tolerance is large.) A node that comes into contact there touches
/// all of these faces.
double share_at_convex_edge(const Selection& selection, const Encounter& e, const Encounter& best) {
  if (e.meeting != Meeting::inside) return 1;
  const Tolerances& tolerances = selection.tolerances;
  const double place = selection.tolerances.rim * std::min(e.size, best.size);
  const double zone = std::min(place, tolerances.drift * std::min(e.size, best.size) + 4 * std::abs(best.gap));
  const double deeper = (std::abs(e.gap) - std::abs(best.gap)) / zone;
  return std::clamp((1 - std::abs(deeper)) / (1 - tolerances.slight), 0.0, 1.0);
}

/// Faces met at the same place by one node act along their mean normal if they meet in a convex edge or corner, since
/// rounding would decide which of them is met first. On slightly curved surfaces the normal rotates from one face's to
/// the other's within the rim tolerance of their common edge, so that a node may slide over it without a jump.
void merge_corner(const Selection& selection, std::span<Encounter> encounters) {
  Encounter& best = encounters.front();
  Vec3 sum = best.normal;
  for (const Encounter& e : encounters.subspan(1)) {
    if (!selection.same_body(e, best)) continue;
    const double place = selection.tolerances.rim * std::min(e.size, best.size);
    const double apart2 = (e.point - best.point).squaredNorm();
    if (apart2 > place * place) continue;
    if (selection.same_direction(e, best))
      sum += (1 - std::sqrt(apart2) / place) * e.normal;
    else if (e.meeting == best.meeting && !selection.concave(e, best))
      sum += share_at_convex_edge(selection, e, best) * e.normal;
  }
  const double length = sum.norm();
  if (length > selection.tolerances.slight)
    turn(selection, sum / length, best);  // else they face each other: a blade without thickness
}

/// A row of its own beside those kept?
bool asks_for_a_row(const Selection& selection, std::span<const Encounter> kept, const Encounter& e) {
  return std::ranges::all_of(kept, [&](const Encounter& k) {
    return !selection.same_direction(k, e) && (!selection.same_body(k, e) || selection.concave(k, e));
  });
}

}  // namespace

std::size_t select_rows(std::span<const MasterFace> faces, std::span<const NodeMotion> motion, const NodeMotion& slave,
                        double dt, Criterion criterion, const Tolerances& tolerances, std::span<Encounter> encounters) {
  Selection selection{faces, motion, slave, dt, criterion, tolerances};
  encounters = encounters.first(remove_unopposed(selection, encounters));
  if (encounters.size() < 2) return encounters.size();
  selection.smooth = one_direction(encounters, tolerances.same_direction);
  const Ranking before(selection, encounters);
  if (const auto best = std::ranges::min_element(encounters, before); best != encounters.begin())
    std::swap(encounters.front(), *best);
  merge_corner(selection, encounters);
  if (selection.smooth) return 1;  // nearly always: one surface
  const std::span<Encounter> others = encounters.subspan(1);
  const auto asks = [&](const Encounter& e) { return asks_for_a_row(selection, encounters.first(1), e); };
  if (std::ranges::none_of(others, asks)) return 1;
  std::sort(others.begin(), others.end(), before);
  std::size_t kept = 1;
  for (std::size_t i = 1; i < encounters.size() && kept < most_rows_of_a_node; ++i)
    if (asks_for_a_row(selection, encounters.first(kept), encounters[i])) std::swap(encounters[kept++], encounters[i]);
  return kept;
}

}  // namespace brunt::contact
