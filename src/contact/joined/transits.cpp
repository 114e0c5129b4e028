// SPDX-License-Identifier: Apache-2.0
#include "contact/joined/transits.hpp"

#include <algorithm>

#include "comm/rendezvous.hpp"

namespace brunt::contact {
namespace {

struct NodeTransit {
  LocalIndex node = 0;  ///< surface node on its owner
  double transit = 0;
};

}  // namespace

std::vector<double> transits(const comm::Communicator& ranks, const Surface& surface, std::span<const double> sound) {
  std::vector<std::vector<NodeTransit>> to_owners(static_cast<std::size_t>(ranks.size()));
  for (const SurfaceFace& face : surface.faces)
    for (std::size_t i = 0; i < static_cast<std::size_t>(face.corner_count); ++i) {
      const Place& home = nth(surface.home, face.nodes[i]);
      nth(to_owners, home.rank).push_back({home.index, 0.5 * face.element_depth / nth(sound, face.block)});
    }
  std::vector<double> longest(surface.gid.size(), 0.0);
  for (const NodeTransit& found : comm::exchange(ranks, to_owners).values)
    nth(longest, found.node) = std::max(nth(longest, found.node), found.transit);
  return longest;
}

}  // namespace brunt::contact
