// SPDX-License-Identifier: Apache-2.0
#include "edge_scene.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace brunt::contact {

EdgeScene::EdgeScene(const StepView& of_step, const EdgeInput& of_input)
    : step(of_step),
      input(of_input),
      settings(of_step.settings),
      sine_of_one_direction(std::sin(of_step.settings.tolerances->same_direction * std::numbers::pi / 180)) {}

double sine_between(const EdgeScene& scene, const EdgePair& pair) {
  return scene.start(pair.slave).along().cross(scene.start(pair.master).along()).norm();
}

bool are_nearly_parallel(const EdgeScene& scene, const EdgePair& pair) {
  return sine_between(scene, pair) < scene.sine_of_one_direction;
}

bool between_normals(const EdgeScene& scene, const ContactEdge& edge, const Vec3& direction, double beyond) {
  const Vec3 one = scene.normal(edge, 0), other = scene.normal(edge, 1);
  Vec3 turn = one.cross(other);
  const double sine = turn.norm();
  if (sine < scene.tolerances().facet_curvature) return false;
  turn /= sine;
  return one.cross(direction).dot(turn) > -beyond && direction.cross(other).dot(turn) > -beyond &&
         direction.dot(one + other) > 0;
}

bool is_slow(const EdgeScene& scene, const EdgePair& pair) {
  double fastest = 0;
  for (const LocalIndex own : pair.slave.nodes)
    for (const LocalIndex other : pair.master.nodes)
      fastest = std::max(fastest, (scene.at(own).predicted - scene.at(other).predicted).squaredNorm());
  return scene.step.dt * std::sqrt(fastest) <= scene.tolerances().slow * pair.size;
}

double max_penetration(const EdgeScene& scene, const EdgePair& pair) {
  return scene.tolerances().max_penetration(pair.size, std::min(pair.slave.element_depth, pair.master.element_depth));
}

}  // namespace brunt::contact
