// SPDX-License-Identifier: Apache-2.0
#include "contact/mortar/colouring.hpp"

#include <algorithm>
#include <array>

#include "core/ragged.hpp"

namespace brunt::contact {
namespace {

/// Mean edges that differ by less count as equal.
constexpr double clearly = 1 - 1e-6;

FacetRole opposite(FacetRole role) {
  return role == FacetRole::slave ? FacetRole::master : FacetRole::slave;
}

/// For each facet those that face it, ascending.
Ragged<LocalIndex> neighbours_of(const std::vector<FacingPair>& pairs, std::size_t facets) {
  std::vector<FacingPair> both = pairs;
  for (const FacingPair& pair : pairs) both.push_back({pair.master, pair.slave});
  std::ranges::sort(both, [](const FacingPair& a, const FacingPair& b) { return a < b; });
  Ragged<LocalIndex> neighbours;
  auto pair = both.begin();
  for (LocalIndex facet = 0; facet < static_cast<LocalIndex>(facets); ++facet) {
    for (; pair != both.end() && pair->slave == facet; ++pair) neighbours.values.push_back(pair->master);
    neighbours.close_row();
  }
  return neighbours;
}

class Colouring {
 public:
  Colouring(const std::vector<FacingPair>& pairs, std::span<const double> edge)
      : neighbours_(neighbours_of(pairs, edge.size())),
        edge_(edge),
        up_(edge.size(), 0.0),
        role_(edge.size(), FacetRole::none) {
    for (const FacingPair& pair : pairs) {
      nth(up_, pair.slave) += pair.up;
      nth(up_, pair.master) -= pair.up;
    }
  }

  void keep_pressed(const std::vector<FacingPair>& pairs) {
    std::vector<LocalIndex> front;
    for (const FacingPair& pair : pairs)
      if (pair.pressed != 0) give(pair.slave, FacetRole::slave, front);
    for (const FacingPair& pair : pairs)
      if (pair.pressed != 0) give(pair.master, FacetRole::master, front);
    spread(std::move(front));
  }

  void choose_rest() {
    for (LocalIndex facet = 0; facet < neighbours_.rows(); ++facet) {
      if (at(facet) != FacetRole::none || neighbours_.row(facet).empty()) continue;
      std::vector<LocalIndex> front;
      give(facet, FacetRole::slave, front);
      const std::vector<LocalIndex> component = spread(std::move(front));
      if (master_is_better(component))
        for (const LocalIndex of : component) at(of) = opposite(at(of));
    }
  }

  [[nodiscard]] std::vector<FacetRole> roles() && { return std::move(role_); }

 private:
  FacetRole& at(LocalIndex facet) { return nth(role_, facet); }
  void give(LocalIndex facet, FacetRole role, std::vector<LocalIndex>& front) {
    if (at(facet) != FacetRole::none) return;
    at(facet) = role;
    front.push_back(facet);
  }
  /// Returns the facets reached, nearest first, those of the front included.
  std::vector<LocalIndex> spread(std::vector<LocalIndex> front) {
    for (std::size_t next = 0; next < front.size(); ++next)
      for (const LocalIndex other : neighbours_.row(front[next])) give(other, opposite(at(front[next])), front);
    return front;
  }
  [[nodiscard]] bool master_is_better(const std::vector<LocalIndex>& component) {
    std::array<double, 2> edges{}, count{};
    double up = 0;
    for (const LocalIndex facet : component) {
      const std::size_t side = at(facet) == FacetRole::slave ? 0 : 1;
      edges[side] += nth(edge_, facet);
      ++count[side];
      up += side == 0 ? nth(up_, facet) : -nth(up_, facet);
    }
    if (edges[1] * count[0] < clearly * edges[0] * count[1]) return true;
    return up < 0 && !(edges[0] * count[1] < clearly * edges[1] * count[0]);
  }

  Ragged<LocalIndex> neighbours_;
  std::span<const double> edge_;
  std::vector<double> up_;  ///< of each facet, over its pairs
  std::vector<FacetRole> role_;
};

}  // namespace

std::vector<FacetRole> roles_of_facets(std::vector<FacingPair> pairs, std::span<const double> edge) {
  std::ranges::sort(pairs, [](const FacingPair& a, const FacingPair& b) { return a < b; });
  Colouring colouring(pairs, edge);
  colouring.keep_pressed(pairs);
  colouring.choose_rest();
  return std::move(colouring).roles();
}

FacingPair undecided(std::span<const FacingPair> pairs, std::span<const FacetRole> roles) {
  FacingPair first;
  for (const FacingPair& pair : pairs) {
    const bool same = nth(roles, pair.slave) == nth(roles, pair.master);
    if (same && (first.slave == no_index || pair < first)) first = pair;
  }
  return first;
}

}  // namespace brunt::contact
