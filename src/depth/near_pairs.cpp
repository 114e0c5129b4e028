// SPDX-License-Identifier: Apache-2.0
#include "brunt/depth/near_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace brunt::depth {
namespace {

constexpr double same_point = 1e-9;  // of A's size

}  // namespace

void NearPairs::find(const Encounter& encounter, const RigidMotion& motion, double band) {
  const Placement now = encounter.placement(motion);
  geometry::near_pairs(encounter.a.tree, encounter.b.tree, now, band, pairs);
  const Vec3 centre = now(encounter.a.shape.centroid);
  const Mat3 into = encounter.start.rotation.transpose();
  const double grid = same_point * encounter.a.shape.radius;
  struct Key {
    std::array<double, 6> at;
    std::size_t pair;
  };
  std::vector<Key> keys;
  keys.reserve(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!(pairs[i].distance > 0)) continue;
    Key key{{}, i};
    for (std::size_t c = 0; c < 3; ++c) {
      key.at[c] = std::round(pairs[i].on_a[static_cast<int>(c)] / grid);
      key.at[c + 3] = std::round(pairs[i].on_b[static_cast<int>(c)] / grid);
    }
    keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end(),
            [](const Key& x, const Key& y) { return x.at != y.at ? x.at < y.at : x.pair < y.pair; });
  conditions.clear();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i > 0 && keys[i].at == keys[i - 1].at) continue;
    const geometry::NearPair& pair = pairs[keys[i].pair];
    conditions.push_back(
        {into * ((pair.on_a - pair.on_b) / pair.distance), into * (pair.on_a - centre), pair.distance});
  }
}

}  // namespace brunt::depth
