// SPDX-License-Identifier: Apache-2.0
#include <ccd/ccd.h>

#include <limits>

#include "convex_peers.hpp"

namespace brunt::bench {
namespace {

struct Placed {
  const std::vector<Vec3>* points;
  Placement placement;
  Vec3 centre;
};

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* found) {
  const auto& body = *static_cast<const Placed*>(object);
  const Vec3 wanted = body.placement.rotation.transpose() * Vec3(direction->v[0], direction->v[1], direction->v[2]);
  const Vec3* best = body.points->data();
  double height = wanted.dot(*best);
  for (const Vec3& x : *body.points)
    if (const double here = wanted.dot(x); here > height) {
      height = here;
      best = &x;
    }
  const Vec3 x = body.placement(*best);
  ccdVec3Set(found, x[0], x[1], x[2]);
}

void centre(const void* object, ccd_vec3_t* found) {
  const auto& body = *static_cast<const Placed*>(object);
  const Vec3 x = body.placement(body.centre);
  ccdVec3Set(found, x[0], x[1], x[2]);
}

Vec3 middle(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& x : points) sum += x;
  return sum / static_cast<double>(points.size());
}

using Penetration = int (*)(const void*, const void*, const ccd_t*, ccd_real_t*, ccd_vec3_t*, ccd_vec3_t*);

ConvexDepths depths_by(const ConvexScene& scene, double tolerance, Penetration penetration) {
  ccd_t settings;
  CCD_INIT(&settings);
  settings.support1 = settings.support2 = support;
  settings.center1 = settings.center2 = centre;
  settings.max_iterations = 1000;  // without a limit some pairs never end
  settings.epa_tolerance = settings.mpr_tolerance = tolerance;
  std::vector<Vec3> centres;
  for (const TriangleSurface& body : scene.bodies) centres.push_back(middle(body.points));
  return [&scene, settings, centres, penetration](std::span<double> depths) {
    for (std::size_t k = 0; k < depths.size(); ++k) {
      const ConvexScene::Pair& pair = scene.pairs[k];
      const Placed a{&scene.bodies[pair.a].points, pair.a_in_b, centres[pair.a]};
      const Placed b{&scene.bodies[pair.b].points, {}, centres[pair.b]};
      ccd_real_t depth = 0;
      ccd_vec3_t direction, position;
      const int code = penetration(&a, &b, &settings, &depth, &direction, &position);
      depths[k] = code == 0 ? depth : std::numeric_limits<double>::quiet_NaN();
    }
  };
}

}  // namespace

ConvexDepths ccd_epa(const ConvexScene& scene, double tolerance) {
  return depths_by(scene, tolerance, ccdGJKPenetration);
}

ConvexDepths ccd_mpr(const ConvexScene& scene, double tolerance) {
  return depths_by(scene, tolerance, ccdMPRPenetration);
}

}  // namespace brunt::bench
