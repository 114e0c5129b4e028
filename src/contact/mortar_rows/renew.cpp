// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

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

struct Chosen {
  bool any = false;    ///< slaves are integrated in this step
  bool stray = false;  ///< kept rows have no slave any more
};

/// Finds scratch.renew and scratch.apart.
Chosen choose(const MortarScene& scene, const MortarHistory& history, std::span<const LocalIndex> places,
              MortarScratch& scratch) {
  Chosen chosen;
  std::size_t seen = 0;
  scratch.renew.assign(scene.candidates.slave.size(), 0);
  scratch.apart.resize(history.heads.size());
  for_each_slave(scene, history, [&](std::size_t s, std::size_t first, std::size_t end) {
    seen += end - first;
    bool renew = false;
    for (std::size_t r = first; r < end; ++r) {
      scratch.apart[r] = sum_of_places(std::as_const(history.terms).row(static_cast<LocalIndex>(r)),
                                       places_of(history, places, r), scene.motion);
      renew = renew || is_stale(history.heads[r], scratch.apart[r]);
    }
    if (first == end)
      renew = std::ranges::any_of(scene.candidates.around.row(static_cast<LocalIndex>(s)),
                                  [&](LocalIndex facet) { return scratch.covers.may_begin(scene, facet); });
    scratch.renew[s] = renew ? 1 : 0;
    chosen.any = chosen.any || renew;
  });
  chosen.stray = seen < history.heads.size();
  return chosen;
}

/// Of a row, with what was born [length].
double gap_of(const MortarHistory& history, std::span<const LocalIndex> places, std::size_t r, const MortarScene& scene,
              const Vec3& apart, MortarScratch& scratch) {
  const KeptRow kept = kept_row(history, places, r);
  scratch.weights.resize(kept.nodes);
  std::ranges::transform(kept.terms.first(kept.nodes), scratch.weights.begin(), &MortarTerm::weight);
  return place_row(kept, scene, scratch.facet_normal, apart, scratch.weights).gap + kept.head.born;
}

/// The rows of the slaves that are chosen; returns how many they had before.
std::size_t integrate_chosen(const MortarScene& scene, const MortarHistory& history, std::span<const LocalIndex> places,
                             MortarScratch& scratch) {
  std::size_t had = 0;
  scratch.fresh.clear();
  scratch.fresh_places.clear();
  scratch.kept_gap.assign(history.heads.size(), 0.0);
  for_each_slave(scene, history, [&](std::size_t s, std::size_t first, std::size_t end) {
    if (scratch.renew[s] == 0) return;
    had += end - first;
    for (std::size_t r = first; r < end; ++r)
      scratch.kept_gap[r] = gap_of(history, places, r, scene, scratch.apart[r], scratch);
    scratch.integration.append(scene, s, scratch.covers, std::span(history.heads).subspan(first, end - first),
                               scratch.fresh, scratch.fresh_places);
  });
  return had;
}

/// Appends rows [first, end) of a history and the places of their terms.
void append_rows(const MortarHistory& from, std::span<const LocalIndex> places, std::size_t first, std::size_t end,
                 MortarScratch& scratch) {
  for (std::size_t r = first; r < end; ++r)
    scratch.next.append(from.heads[r], from.terms.row(static_cast<LocalIndex>(r)));
  const auto begin = places.begin();
  scratch.next_places.insert(scratch.next_places.end(), begin + from.terms.offsets[first],
                             begin + from.terms.offsets[end]);
}

/// scratch.next: of each slave the fresh rows, or else those that it has.
void merge_fresh(const MortarScene& scene, const MortarHistory& history, std::span<const LocalIndex> places,
                 MortarScratch& scratch) {
  const MortarHistory& fresh = scratch.fresh;
  std::size_t next = 0;
  scratch.next.clear();
  scratch.next_places.clear();
  for_each_slave(scene, history, [&](std::size_t s, std::size_t first, std::size_t end) {
    if (scratch.renew[s] == 0) return append_rows(history, places, first, end, scratch);
    const GlobalIndex gid = nth(scene.gid, scene.candidates.slave[s]);
    const std::size_t begin = next;
    while (next < fresh.heads.size() && fresh.heads[next].key.slave == gid) ++next;
    append_rows(fresh, scratch.fresh_places, begin, next, scratch);
  });
}

/// What a renewal adds to the depth of a row is born with it: it is not pushed out, but never deeper again. A row that
/// was not there has all its depth so.
void keep_gaps(const MortarScene& scene, std::span<const LocalIndex> places, MortarHistory& history,
               const MortarHistory& before, MortarScratch& scratch) {
  std::size_t old = 0;
  scratch.apart.resize(history.heads.size());
  for (std::size_t r = 0; r < history.heads.size(); ++r) {
    MortarHead& head = history.heads[r];
    scratch.apart[r] = sum_of_places(std::as_const(history.terms).row(static_cast<LocalIndex>(r)),
                                     places_of(history, places, r), scene.motion);
    if (head.age > 0) continue;
    while (old < before.heads.size() && before.heads[old].key < head.key) ++old;
    const bool known = old < before.heads.size() && before.heads[old].key == head.key;
    const double was = known ? scratch.kept_gap[old] : 0;
    head.born = std::max(0.0, std::min(0.0, was) - gap_of(history, places, r, scene, scratch.apart[r], scratch));
  }
}

}  // namespace

bool renew_weights(const MortarScene& scene, MortarHistory& history, std::vector<LocalIndex>& places,
                   MortarScratch& scratch) {
  scratch.covers.start(scene.candidates.facets.size());
  scratch.facet_normal.clear();
  for (const MortarFacet& facet : scene.candidates.facets)
    scratch.facet_normal.push_back(geometry::area_vector(CornersNow(facet, scene.motion).span()).normalized());
  for (MortarHead& head : history.heads) ++head.age;
  const Chosen chosen = choose(scene, history, places, scratch);
  if (!chosen.any && !chosen.stray) return false;
  const std::size_t had = integrate_chosen(scene, history, places, scratch);
  if (had == 0 && scratch.fresh.heads.empty() && !chosen.stray) return false;
  merge_fresh(scene, history, places, scratch);
  std::swap(history, scratch.next);
  std::swap(places, scratch.next_places);
  keep_gaps(scene, places, history, scratch.next, scratch);
  return true;
}

}  // namespace brunt::contact
