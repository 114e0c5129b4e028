// SPDX-License-Identifier: Apache-2.0
#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include "search_peers.hpp"

namespace brunt::bench {

void search_cgal(const SearchScene& scene, std::vector<BoxNode>& pairs) {
  struct Handled {
    LocalIndex index;
  };
  using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const Handled*>;
  // a handle's address is its box's identity: nodes and boxes need their own
  std::vector<Handled> node_handles(scene.nodes.size()), box_handles(scene.boxes.size());
  std::vector<Box> nodes, boxes;
  nodes.reserve(scene.nodes.size());
  boxes.reserve(scene.boxes.size());
  const auto add = [](std::vector<Box>& items, std::vector<Handled>& handles, const Vec3& low, const Vec3& high) {
    Handled& handle = handles[items.size()];
    handle.index = static_cast<LocalIndex>(items.size());
    items.emplace_back(CGAL::Bbox_3(low[0], low[1], low[2], high[0], high[1], high[2]), &handle);
  };
  for (const Vec3& x : scene.nodes) add(nodes, node_handles, x, x);
  for (const geometry::Box& box : scene.boxes) add(boxes, box_handles, box.low, box.high);
  CGAL::box_intersection_d(boxes.begin(), boxes.end(), nodes.begin(), nodes.end(),
                           [&](const Box& box, const Box& node) {
                             pairs.push_back({box.handle()->index, node.handle()->index});
                           });
}

}  // namespace brunt::bench
