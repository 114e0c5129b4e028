// SPDX-License-Identifier: Apache-2.0
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>

#include <cmath>
#include <limits>
#include <memory>

#include "convex_peers.hpp"

namespace brunt::bench {
namespace {

using Convex = fcl::Convex<double>;
using Mesh = fcl::BVHModel<fcl::OBBRSS<double>>;

fcl::Transform3d transform(const Placement& placement) {
  fcl::Transform3d result = fcl::Transform3d::Identity();
  result.linear() = placement.rotation;
  result.translation() = placement.translation;
  return result;
}

std::shared_ptr<Convex> convex(const TriangleSurface& body) {
  auto points = std::make_shared<std::vector<fcl::Vector3d>>(body.points.begin(), body.points.end());
  auto faces = std::make_shared<std::vector<int>>();
  for (const auto& t : body.triangles) {
    faces->push_back(3);
    for (const LocalIndex corner : t) faces->push_back(static_cast<int>(corner));
  }
  return std::make_shared<Convex>(points, static_cast<int>(body.triangles.size()), faces);
}

std::shared_ptr<Mesh> mesh(const TriangleSurface& body) {
  std::vector<fcl::Vector3d> points(body.points.begin(), body.points.end());
  std::vector<fcl::Triangle> triangles;
  for (const auto& t : body.triangles)
    triangles.emplace_back(static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]),
                           static_cast<std::size_t>(t[2]));
  auto model = std::make_shared<Mesh>();
  model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(points.size()));
  model->addSubModel(points, triangles);
  model->endModel();
  return model;
}

}  // namespace

ConvexDepths fcl_convex(const ConvexScene& scene, bool libccd, double tolerance) {
  std::vector<std::shared_ptr<Convex>> shapes;
  for (const TriangleSurface& body : scene.bodies) shapes.push_back(convex(body));
  return [&scene, shapes, libccd, tolerance](std::span<double> depths) {
    fcl::CollisionRequest<double> request(1, true);
    request.gjk_solver_type = libccd ? fcl::GST_LIBCCD : fcl::GST_INDEP;
    request.gjk_tolerance = tolerance;
    for (std::size_t k = 0; k < depths.size(); ++k) {
      const ConvexScene::Pair& pair = scene.pairs[k];
      fcl::CollisionResult<double> result;
      fcl::collide(shapes[pair.a].get(), transform(pair.a_in_b), shapes[pair.b].get(),
                   fcl::Transform3d(fcl::Transform3d::Identity()), request, result);
      depths[k] = result.isCollision() ? std::abs(result.getContact(0).penetration_depth)
                                       : std::numeric_limits<double>::quiet_NaN();
    }
  };
}

MeshCollisions fcl_meshes(const MeshScene& scene) {
  const std::shared_ptr<Mesh> a = mesh(scene.a), b = mesh(scene.b);
  return [&scene, a, b](std::span<char> collides) {
    const fcl::CollisionRequest<double> request(1, false);
    for (std::size_t k = 0; k < collides.size(); ++k) {
      fcl::CollisionResult<double> result;
      fcl::collide(a.get(), transform(scene.placements[k]), b.get(), fcl::Transform3d(fcl::Transform3d::Identity()),
                   request, result);
      collides[k] = result.isCollision() ? 1 : 0;
    }
  };
}

}  // namespace brunt::bench
