// SPDX-License-Identifier: Apache-2.0
#include "edge_scene.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace brunt::contact {

bool between_normals(const EdgeScene& scene, const ContactEdge& edge, const Vec3& direction, double beyond) {
  const Vec3 one = scene.normal(edge, 0), other = scene.normal(edge, 1);
  Vec3 turn = one.cross(other);
  const double sine = turn.norm();
  if (sine < scene.tolerances().facet_curvature) return false;  // flattened: no edge any more
  turn /= sine;
  return one.cross(direction).dot(turn) > -beyond && direction.cross(other).dot(turn) > -beyond &&
         direction.dot(one + other) > 0;
}

Vec3 relative_displacement(const EdgeScene& scene, const ContactEdge& slave, const ContactEdge& master, double s,
                           double t) {
  const auto predicted = [&](const ContactEdge& edge, std::size_t i) { return scene.at(edge.nodes[i]).predicted; };
  return scene.dt * ((1 - s) * predicted(slave, 0) + s * predicted(slave, 1) - (1 - t) * predicted(master, 0) -
                     t * predicted(master, 1));
}

bool is_slow(const EdgeScene& scene, const ContactEdge& slave, const ContactEdge& master, double size) {
  double fastest = 0;
  for (const LocalIndex own : slave.nodes)
    for (const LocalIndex other : master.nodes)
      fastest = std::max(fastest, (scene.at(own).predicted - scene.at(other).predicted).squaredNorm());
  return scene.dt * std::sqrt(fastest) <= scene.tolerances().slow * size;
}

}  // namespace brunt::contact
