// SPDX-License-Identifier: Apache-2.0
#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>

#include "search_peers.hpp"

namespace brunt::bench {
namespace {

btVector3 vector(const Vec3& x) {
  return {static_cast<btScalar>(x[0]), static_cast<btScalar>(x[1]), static_cast<btScalar>(x[2])};
}

struct Collector : btDbvt::ICollide {
  std::vector<BoxNode>* pairs = nullptr;
  LocalIndex box = 0;
  void Process(const btDbvtNode* leaf) override { pairs->push_back({box, leaf->dataAsInt}); }
};

}  // namespace

void search_bullet(const SearchScene& scene, std::vector<BoxNode>& pairs) {
  std::vector<LocalIndex> order(scene.nodes.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(1));  // in mesh order the tree degenerates
  btDbvt tree;
  for (const LocalIndex n : order) {
    const btVector3 x = vector(scene.nodes[static_cast<std::size_t>(n)]);
    tree.insert(btDbvtVolume::FromMM(x, x), nullptr)->dataAsInt = n;
  }
  Collector collector;
  collector.pairs = &pairs;
  for (const geometry::Box& box : scene.boxes) {
    tree.collideTV(tree.m_root, btDbvtVolume::FromMM(vector(box.low), vector(box.high)), collector);
    ++collector.box;
  }
}

}  // namespace brunt::bench
