// SPDX-License-Identifier: Apache-2.0
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision_object.h>

#include <cstdint>
#include <memory>

#include "search_peers.hpp"

namespace brunt::bench {
namespace {

using Object = fcl::CollisionObject<double>;

struct Query {
  std::vector<BoxNode>& pairs;
  LocalIndex box;
  const Object* box_object;
  const Object* first_node;
};

}  // namespace

void search_fcl(const SearchScene& scene, std::vector<BoxNode>& pairs) {
  const auto point = std::make_shared<fcl::Sphere<double>>(0.0);
  std::vector<Object> nodes;
  nodes.reserve(scene.nodes.size());
  std::vector<Object*> pointers;
  for (const Vec3& x : scene.nodes) {
    nodes.emplace_back(point, fcl::Matrix3d::Identity(), x);
    pointers.push_back(&nodes.back());
  }
  fcl::DynamicAABBTreeCollisionManager<double> tree;
  tree.registerObjects(pointers);
  tree.setup();
  Query query{pairs, 0, nullptr, nodes.data()};
  for (const geometry::Box& box : scene.boxes) {
    const Vec3 sides = box.high - box.low, centre = box.low + sides / 2;
    Object object(std::make_shared<fcl::Box<double>>(sides), fcl::Matrix3d::Identity(), centre);
    query.box_object = &object;
    tree.collide(&object, &query, [](Object* a, Object* b, void* data) {
      auto& q = *static_cast<Query*>(data);
      const Object* node = a == q.box_object ? b : a;
      q.pairs.push_back({q.box, static_cast<LocalIndex>(node - q.first_node)});
      return false;
    });
    ++query.box;
  }
}

}  // namespace brunt::bench
