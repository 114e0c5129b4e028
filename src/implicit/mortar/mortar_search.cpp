// SPDX-License-Identifier: Apache-2.0
#include "mortar_shares.hpp"

namespace brunt::implicit {

void search(Interface& face, std::span<const Vec3> x) {
  PairSearch& search = face.search;
  constexpr double worn_out = 2;  // trees are rebuilt if the number of tests for each pair has grown by this factor
  search.candidates.clear();
  if (face.surfaces.slave.empty() || face.surfaces.master.empty()) {
    search.counts = {};
    search.candidates.offsets.assign(face.surfaces.slave.size() + 1, 0);
    return;
  }
  const bool anew =
      search.anew || (search.counts.pairs > 0 && search.counts.tests_per_pair() > worn_out * search.built_with);
  if (anew) {
    contact::build(search.slave, face.surfaces.slave, x);
    contact::build(search.master, face.surfaces.master, x);
  }
  const contact::Enlargement half = contact::by_distance(0.5 * face.surfaces.capture);
  contact::refit(search.slave, x, half);
  contact::refit(search.master, x, half);
  search.counts = contact::find_pairs(search.slave, search.master, search.scratch, search.pairs);
  if (anew) search.built_with = search.counts.tests_per_pair();
  search.anew = false;
  auto pair = search.pairs.begin();
  for (LocalIndex facet = 0; facet < static_cast<LocalIndex>(face.surfaces.slave.size()); ++facet) {
    for (; pair != search.pairs.end() && pair->slave == facet; ++pair)
      if (!face.self || face.self->admits(facet, pair->master)) search.candidates.values.push_back(pair->master);
    search.candidates.close_row();
  }
}

}  // namespace brunt::implicit
