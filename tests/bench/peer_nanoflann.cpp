// SPDX-License-Identifier: Apache-2.0
#include <nanoflann.hpp>

#include "search_peers.hpp"

namespace brunt::bench {
namespace {

struct Cloud {
  const std::vector<Vec3>& points;
  [[nodiscard]] std::size_t kdtree_get_point_count() const { return points.size(); }
  [[nodiscard]] double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return points[i][static_cast<Eigen::Index>(axis)];
  }
  template <class Bounds>
  bool kdtree_get_bbox(Bounds& /*bounds*/) const {
    return false;
  }
};

}  // namespace

void search_nanoflann(const SearchScene& scene, std::vector<BoxNode>& pairs) {
  using Metric = nanoflann::L2_Simple_Adaptor<double, Cloud>;
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<Metric, Cloud, 3, LocalIndex>;
  const Cloud cloud{scene.nodes};
  Tree tree(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(16));
  tree.buildIndex();
  std::vector<std::pair<LocalIndex, double>> near;
  nanoflann::SearchParams unsorted;
  unsorted.sorted = false;
  LocalIndex b = 0;
  for (const geometry::Box& box : scene.boxes) {
    const Vec3 centre = 0.5 * (box.low + box.high);
    const double squared = 0.25 * (box.high - box.low).squaredNorm() * (1 + 1e-12);
    tree.radiusSearch(centre.data(), squared, near, unsorted);
    for (const auto& [node, distance] : near)
      if (geometry::contains(box, scene.nodes[static_cast<std::size_t>(node)])) pairs.push_back({b, node});
    ++b;
  }
}

}  // namespace brunt::bench
