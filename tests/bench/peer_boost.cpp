// SPDX-License-Identifier: Apache-2.0
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include "search_peers.hpp"

namespace brunt::bench {

void search_boost(const SearchScene& scene, std::vector<BoxNode>& pairs) {
  namespace index = boost::geometry::index;
  using Point = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
  using Box = boost::geometry::model::box<Point>;
  using Entry = std::pair<Point, LocalIndex>;
  std::vector<Entry> entries;
  entries.reserve(scene.nodes.size());
  for (const Vec3& x : scene.nodes)
    entries.emplace_back(Point(x[0], x[1], x[2]), static_cast<LocalIndex>(entries.size()));
  const index::rtree<Entry, index::linear<16>> tree(entries.begin(), entries.end());
  LocalIndex b = 0;
  for (const geometry::Box& box : scene.boxes) {
    const Box query(Point(box.low[0], box.low[1], box.low[2]), Point(box.high[0], box.high[1], box.high[2]));
    tree.query(index::intersects(query), boost::make_function_output_iterator([&](const Entry& entry) {
                 pairs.push_back({b, entry.second});
               }));
    ++b;
  }
}

}  // namespace brunt::bench
