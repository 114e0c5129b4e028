// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "contact/mortar_rows/mortar_rows.hpp"
#include "contact/mortar_rows/placed_row.hpp"
#include "geometry/closest_point.hpp"

namespace brunt::contact {
namespace {

bool is_stale(const MortarHead& head, const Vec3& apart) {
  return head.age >= kept_numbers.steps ||
         !((apart - Vec3(head.apart.data())).norm() <= kept_numbers.motion * head.size);
}

/// Slaves and their kept rows, both in ascending gid: calls visit(s, first row, end). Rows of nodes that are no slaves
/// any more are left out.
template <class Visit>
void for_each_slave(const MortarScene& scene, const MortarHistory& history, const Visit& visit) {
  std::size_t r = 0;
  for (std::size_t s = 0; s < scene.candidates.slave.size(); ++s) {
    const GlobalIndex gid = nth(scene.gid, scene.candidates.slave[s]);
    while (r < history.heads.size() && history.heads[r].key.slave < gid) ++r;
    const std::size_t first = r;
    while (r < history.heads.size() && history.heads[r].key.slave == gid) ++r;
    visit(s, first, r);
  }
}

std::span<const LocalIndex> places_of(const MortarHistory& history, std::span<const LocalIndex> places,
                                      std::size_t row) {
  const auto first = static_cast<std::size_t>(history.terms.offsets[row]);
  return places.subspan(first, static_cast<std::size_t>(history.terms.offsets[row + 1]) - first);
}

/// Of each slave whether its weights are integrated in this step; returns whether any are.
bool choose(const MortarScene& scene, const MortarHistory& history, std::span<const LocalIndex> places,
            MortarScratch& scratch) {
  bool any = false;
  std::size_t seen = 0;
  scratch.renew.assign(scene.candidates.slave.size(), 0);
  for_each_slave(scene, history, [&](std::size_t s, std::size_t first, std::size_t end) {
    seen += end - first;
    bool renew = false;
    for (std::size_t r = first; r < end && !renew; ++r)
      renew = is_stale(history.heads[r], sum_of_places(history.terms.row(static_cast<LocalIndex>(r)),
                                                       places_of(history, places, r), scene.motion));
    if (first == end)
      renew = std::ranges::any_of(scene.candidates.around.row(static_cast<LocalIndex>(s)),
                                  [&](LocalIndex facet) { return scratch.covers.is_near(scene, facet); });
    scratch.renew[s] = renew ? 1 : 0;
    any = any || renew;
  });
  return any || seen < history.heads.size();
}

/// Of a row, with what was born [length].
double gap_of(const MortarHistory& history, std::span<const LocalIndex> places, std::size_t r, const MortarScene& scene,
              MortarScratch& scratch) {
  const KeptRow kept = kept_row(history, places, r);
  scratch.weights.resize(kept.nodes);
  std::ranges::transform(kept.terms.first(kept.nodes), scratch.weights.begin(), &MortarTerm::weight);
  return place_row(kept, scene, scratch.facet_normal, scratch.weights).gap + kept.head.born;
}

/// What a renewal adds to the depth of a row is born with it: it is not pushed out, but never deeper again. A row that
/// was not there has all its depth so.
void keep_gaps(const MortarScene& scene, std::span<const LocalIndex> places, MortarHistory& history,
               const MortarHistory& before, MortarScratch& scratch) {
  std::size_t old = 0;
  for (std::size_t r = 0; r < history.heads.size(); ++r) {
    MortarHead& head = history.heads[r];
    if (head.age > 0) continue;
    while (old < before.heads.size() && before.heads[old].key < head.key) ++old;
    const bool known = old < before.heads.size() && before.heads[old].key == head.key;
    const double was = known ? scratch.kept_gap[old] : 0;
    head.born = std::max(0.0, std::min(0.0, was) - gap_of(history, places, r, scene, scratch));
  }
}

}  // namespace

void renew_weights(const MortarScene& scene, MortarHistory& history, std::vector<LocalIndex>& places,
                   MortarScratch& scratch) {
  scratch.covers.start(scene.candidates.facets.size());
  scratch.facet_normal.clear();
  for (const MortarFacet& facet : scene.candidates.facets)
    scratch.facet_normal.push_back(geometry::area_vector(CornersNow(facet, scene.motion).span()).normalized());
  for (MortarHead& head : history.heads) ++head.age;
  if (!choose(scene, history, places, scratch)) return;
  scratch.next.clear();
  scratch.next_places.clear();
  scratch.kept_gap.assign(history.heads.size(), 0.0);
  for_each_slave(scene, history, [&](std::size_t s, std::size_t first, std::size_t end) {
    if (scratch.renew[s] != 0) {
      for (std::size_t r = first; r < end; ++r) scratch.kept_gap[r] = gap_of(history, places, r, scene, scratch);
      scratch.integration.append(scene, s, scratch.covers, std::span(history.heads).subspan(first, end - first),
                                 scratch.next, scratch.next_places);
      return;
    }
    for (std::size_t r = first; r < end; ++r) {
      scratch.next.append(history.heads[r], std::as_const(history.terms).row(static_cast<LocalIndex>(r)));
      const std::span<const LocalIndex> kept = places_of(history, places, r);
      scratch.next_places.insert(scratch.next_places.end(), kept.begin(), kept.end());
    }
  });
  std::swap(history, scratch.next);
  std::swap(places, scratch.next_places);
  keep_gaps(scene, places, history, scratch.next, scratch);
}

}  // namespace brunt::contact
