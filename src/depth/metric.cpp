// SPDX-License-Identifier: Apache-2.0
#include "depth/metric.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "depth/extreme_points.hpp"

namespace brunt::depth {
namespace {

constexpr std::size_t lanes = 8;

}  // namespace

double point_factor(const Mat3& gyration, const Vec3& y) {
  Mat3 cross;
  cross << 0, -y[2], y[1],  //
      y[2], 0, -y[0],       //
      -y[1], y[0], 0;
  const Mat3 arm = cross * gyration.inverse() * cross.transpose();
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(0.5 * (arm + arm.transpose()), Eigen::EigenvaluesOnly);
  return 1 + std::max(0.0, solver.eigenvalues()[2]);
}

MetricShape metric_shape(std::span<const Vec3> points, const rigid::MassProperties& mass) {
  MetricShape shape;
  shape.centroid = mass.centre;
  shape.gyration = mass.inertia / mass.mass;
  shape.turn_length = std::sqrt(0.5 * shape.gyration.trace());
  double factor = 1;
  for (const Vec3& point : extreme_points(points)) {
    const Vec3 y = point - mass.centre;
    shape.extremes.push_back(y);
    shape.radius = std::max(shape.radius, y.norm());
    factor = std::max(factor, point_factor(shape.gyration, y));
  }
  shape.ratio = std::sqrt(factor);
  const std::size_t count = shape.extremes.size(), padded = (count + lanes - 1) / lanes * lanes;
  for (int c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < padded; ++i) shape.components[c].push_back(shape.extremes[std::min(i, count - 1)][c]);
  return shape;
}

Farthest farthest(const MetricShape& shape, const RigidMotion& motion) {
  return farthest(shape, rotation_less_identity(motion.turn), motion.shift);
}

Farthest farthest(const MetricShape& shape, const Mat3& D, const Vec3& T) {
  const double *x = shape.components[0].data(), *y = shape.components[1].data(), *z = shape.components[2].data();
  alignas(64) double most[lanes], block[lanes];
  std::fill_n(most, lanes, -1.0);
  std::fill_n(block, lanes, 0.0);
  for (std::size_t i = 0; i < shape.components[0].size(); i += lanes)
    for (std::size_t k = 0; k < lanes; ++k) {
      const double u = x[i + k], v = y[i + k], w = z[i + k];
      const double dx = T[0] + (D(0, 0) * u + D(0, 1) * v + D(0, 2) * w);
      const double dy = T[1] + (D(1, 0) * u + D(1, 1) * v + D(1, 2) * w);
      const double dz = T[2] + (D(2, 0) * u + D(2, 1) * v + D(2, 2) * w);
      const double square = dx * dx + dy * dy + dz * dz;
      block[k] = square > most[k] ? static_cast<double>(i) : block[k];
      most[k] = square > most[k] ? square : most[k];
    }
  Farthest best{-1, 0};
  for (std::size_t k = 0; k < lanes; ++k) {
    const std::size_t vertex = std::min(static_cast<std::size_t>(block[k]) + k, shape.extremes.size() - 1);
    if (most[k] > best.distance || (most[k] == best.distance && vertex < best.vertex)) best = {most[k], vertex};
  }
  best.distance = std::sqrt(best.distance);
  return best;
}

double length_of(const MetricShape& shape, Metric metric, const RigidMotion& motion) {
  switch (metric) {
    case Metric::translation:
      return motion.shift.norm();
    case Metric::displacement:
      return farthest(shape, motion).distance;
    case Metric::object_norm: {
      const Vec3 v = motion.turn.vec();
      return std::sqrt(motion.shift.squaredNorm() + 4 * v.dot(shape.gyration * v));
    }
  }
  return 0;
}

}  // namespace brunt::depth
