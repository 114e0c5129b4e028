// SPDX-License-Identifier: Apache-2.0
#include "depth/starts.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace brunt::depth {
namespace {

constexpr double equal_moments = 1e-3;  // relative: axes with such moments are not unique
constexpr double parallel = 0.05;       // sine: a vector nearer to an axis does not complete it
constexpr int bisections = 3;
constexpr std::size_t fast_turned = 1, norm_turned = 3, careful_turned = 6;  // translations marched again, A turned by
constexpr std::array<double, 4> turned_angles{-.5 * std::numbers::pi, -.5, .5, .5 * std::numbers::pi};  // [rad]
constexpr double same_direction = 0.9;  // cosine: of directions nearer to each other one is marched turned
constexpr int short_march = 32;         // steps; longer ones query the depth of A, which costs as much as a step

/// Unit vectors through the grid points of the surface of the cube [-grid, grid]^3.
std::vector<Vec3> cube_directions(int grid) {
  std::vector<Vec3> directions;
  for (int i = -grid; i <= grid; ++i)
    for (int j = -grid; j <= grid; ++j)
      for (int k = -grid; k <= grid; ++k)
        if (std::max({std::abs(i), std::abs(j), std::abs(k)}) == grid) directions.push_back(Vec3(i, j, k).normalized());
  return directions;
}

/// One family of motions that grow with a parameter: t u after the turn `first`, or the rotation by t about u.
struct Ray {
  Vec3 u = Vec3::Zero();
  bool turns = false;
  Turn first = Turn::Identity();
  [[nodiscard]] RigidMotion at(double t) const {
    if (turns) return {rotation_of(t * u), Vec3::Zero()};
    return {first, t * u};
  }
};

struct Marcher {
  Encounter& encounter;
  const StartOptions& options;
  double shortest;
  std::vector<Start> found;

  [[nodiscard]] double length(const RigidMotion& motion) const {
    return length_of(encounter.a.shape, options.metric, motion);
  }

  /// Number of steps whose ends certainly collide: from the depth of A's largest ball in B.
  [[nodiscard]] double sure_steps(const RigidMotion& here, double step) const {
    if (encounter.a.balls.empty()) return 0;
    const InnerBall& ball = encounter.a.balls.front();
    const double depth = ball.depth + point_depth(encounter.b.tree, encounter.placement(here)(ball.centre)).depth;
    return std::max(0.0, std::floor((1 - 1e-9) * depth / step));  // reduced by rounding
  }

  /// Up to the first exit, if it is within reach.
  void march(const Ray& ray, double step, double end) {
    double t = step;
    if (options.nothing_below > 0 && length(ray.at(0)) == 0) {
      const double slope = length(ray.at(1e-3)) / 1e-3;  // upper bound of the growth of lengths
      t = step * std::max(1.0, std::floor(options.nothing_below / (slope * step)));  // the same positions for any bound
    }
    for (int steps = 1; t < end + step; t += step, ++steps) {
      const RigidMotion motion = ray.at(t);
      if (length(ray.at(t - step)) > options.reach * shortest) return;  // bisection could find none within reach
      if (encounter.collides(motion)) {
        if (steps > short_march && !ray.turns) t += step * sure_steps(motion, step);
        continue;
      }
      double inside = t - step, outside = t;
      for (int i = 0; i < bisections; ++i) {
        const double middle = 0.5 * (inside + outside);
        (encounter.collides(ray.at(middle)) ? inside : outside) = middle;
      }
      found.push_back({ray.at(outside), length(ray.at(outside))});
      shortest = std::min(shortest, found.back().length);
      return;
    }
  }
};

bool shorter(const Start& x, const Start& y) {
  return x.length < y.length;
}

}  // namespace

Mat3 unique_axes(const Body& body, const Mat3& into, std::span<const Vec3> others) {
  const Vec3& m = body.moments;
  const bool low = m[1] - m[0] > equal_moments * m[2], high = m[2] - m[1] > equal_moments * m[2];
  const Mat3 axes = into * body.axes;
  if (low && high) return axes;
  Mat3 result = into;
  int have = 0;
  const auto offer = [&](Vec3 v) {
    const double before = v.norm();
    for (int k = 0; k < have; ++k) v -= result.col(k).dot(v) * result.col(k);
    if (have >= 2 || !(v.norm() > parallel * before)) return;
    result.col(have++) = v.normalized();
  };
  if (low != high) offer(low ? axes.col(0) : axes.col(2));
  for (const Vec3& other : others) offer(other);
  for (int k = 0; k < 3; ++k) offer(into.col(k));
  result.col(2) = result.col(0).cross(result.col(1));
  return result;
}

namespace {

/// The shortest translations again, of A turned: where A or B is symmetric, no walk would begin to turn it.
void march_turned(Marcher& marcher, const Mat3& axes, double step, double end) {
  const StartOptions& options = marcher.options;
  std::vector<Start> straight = marcher.found;
  std::erase_if(straight, [](const Start& start) { return start.motion.turn.vec().squaredNorm() > 0; });
  std::stable_sort(straight.begin(), straight.end(), shorter);
  const std::size_t most =
      options.careful ? careful_turned : (options.metric == Metric::object_norm ? norm_turned : fast_turned);
  std::vector<Vec3> directions;
  for (const Start& start : straight) {
    const Vec3 u = start.motion.shift.normalized();
    if (directions.size() == most) break;
    if (std::none_of(directions.begin(), directions.end(), [&](const Vec3& v) { return u.dot(v) > same_direction; }))
      directions.push_back(u);
  }
  for (const Vec3& u : directions)
    for (int c = 0; c < 3; ++c)
      for (const double angle : turned_angles) marcher.march({u, false, rotation_of(angle * axes.col(c))}, step, end);
}

}  // namespace

std::vector<Start> find_starts(Encounter& encounter, const StartOptions& options) {
  const Body &a = encounter.a, &b = encounter.b;
  const Mat3 into = encounter.start.rotation.transpose();  // from B's axes to A's at q_0
  const Vec3 between = into * (encounter.start(a.shape.centroid) - b.shape.centroid);
  const Vec3 link = between.norm() > 1e-6 * a.shape.radius ? between : Vec3(Vec3::Zero());
  // the axis that is unique in a body of revolution, of least or greatest moment
  const auto main_axis = [](const Body& body) {
    return Vec3(body.moments[1] - body.moments[0] > body.moments[2] - body.moments[1] ? body.axes.col(0)
                                                                                      : body.axes.col(2));
  };
  const Vec3 axis_a = main_axis(a), axis_b = into * main_axis(b);
  const std::array<Vec3, 3> for_a{link, axis_a.cross(axis_b), axis_b}, for_b{link, axis_a.cross(axis_b), axis_a};
  const Mat3 axes_a = unique_axes(a, Mat3::Identity(), for_a), axes_b = unique_axes(b, into, for_b);
  const bool shifts = options.metric == Metric::translation;  // then the bodies may change places
  Marcher marcher{encounter, options, options.known, {}};
  const double step = options.march * (shifts ? std::min(a.shape.radius, b.shape.radius) : a.shape.radius);
  const double end = between.norm() + a.shape.radius + b.shape.radius;
  const auto translate = [&](const Vec3& direction) {
    const Vec3 u = options.basis * (options.basis.transpose() * direction);
    if (u.norm() > parallel) marcher.march({u.normalized(), false}, step, end);
  };
  if (link.norm() > 0) translate(link.normalized());
  for (const Vec3& direction : cube_directions(options.grid)) translate(axes_b * direction);
  for (const Vec3& direction : cube_directions(shifts && options.careful ? options.grid : 1))
    translate(axes_a * direction);
  if (!shifts) {
    const auto rotate = [&](const Vec3& axis) { marcher.march({axis, true}, options.march, std::numbers::pi); };
    for (const Vec3& direction : cube_directions(1))
      if (options.careful || direction.cwiseAbs().minCoeff() > 0 || direction.cwiseAbs().maxCoeff() == 1)
        rotate(axes_a * direction);
    for (int i = 0; options.careful && i < 3; ++i)
      for (const double sign : {1.0, -1.0}) rotate(sign * axes_b.col(i));
    march_turned(marcher, axes_a, step, end);
  }
  // the set does not depend on the order of the marches
  std::erase_if(marcher.found, [&](const Start& start) { return start.length > options.reach * marcher.shortest; });
  std::stable_sort(marcher.found.begin(), marcher.found.end(), shorter);
  return marcher.found;
}

Start freed(Encounter& encounter, Metric metric, const RigidMotion& motion) {
  for (const double s : {1.0, 1 + 1e-6, 1.0001, 1.001, 1.01, 1.05, 1.2, 1.5, 2.0, 3.0}) {
    const RigidMotion out = s > 1 ? along_screw(motion, s) : motion;
    if (!encounter.collides(out)) return {out, length_of(encounter.a.shape, metric, out)};
  }
  return {motion, -1};
}

}  // namespace brunt::depth
