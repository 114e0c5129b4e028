// SPDX-License-Identifier: Apache-2.0
#include "brunt/penetration_depth.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "depth/penetration_depth.hpp"
#include "geometry/triangles/closed_surface.hpp"

namespace brunt::api {
namespace {

brunt::Placement internal(const Placement& placement) {
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> rotation(placement.rotation.data());
  constexpr double rounding = 1e-9;
  if (!((rotation * rotation.transpose() - Mat3::Identity()).norm() < rounding && rotation.determinant() > 0))
    throw std::invalid_argument("the rotation of a placement is proper and orthogonal");
  constexpr double farthest = 1e100;  // squares of distances are numbers of the machine
  if (!std::ranges::all_of(placement.translation, [](double x) { return std::abs(x) < farthest; }))
    throw std::invalid_argument("the translation of a placement is finite, and below 1e100");
  return {rotation, Vec3(placement.translation.data())};
}

Placement external(const brunt::Placement& placement) {
  Placement given;
  Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(given.rotation.data()) = placement.rotation;
  Eigen::Map<Vec3>(given.translation.data()) = placement.translation;
  return given;
}

depth::Metric internal(Metric metric) {
  switch (metric) {
    case Metric::translation:
      return depth::Metric::translation;
    case Metric::object_norm:
      return depth::Metric::object_norm;
    case Metric::displacement:
      break;
  }
  return depth::Metric::displacement;
}

}  // namespace

struct DepthBody::Data {
  depth::Body body;
};

DepthBody::DepthBody(std::span<const double> points, std::span<const std::int32_t> triangles) {
  if (points.size() % 3 != 0 || triangles.size() % 3 != 0)
    throw std::invalid_argument("points have three coordinates each, triangles three corners");
  if (!std::ranges::all_of(points, [](double x) { return std::isfinite(x); }))
    throw std::invalid_argument("points have finite coordinates");
  const auto count = static_cast<std::int32_t>(points.size() / 3);
  if (!std::ranges::all_of(triangles, [&](std::int32_t corner) { return 0 <= corner && corner < count; }))
    throw std::invalid_argument("corners of triangles are numbers of points, from 0");
  TriangleSurface surface;
  for (std::size_t p = 0; p < points.size(); p += 3) surface.points.emplace_back(&points[p]);
  for (std::size_t t = 0; t < triangles.size(); t += 3)
    surface.triangles.push_back({triangles[t], triangles[t + 1], triangles[t + 2]});
  if (const geometry::SurfaceFaults faults = geometry::check_closed(surface); !faults.sound())
    throw std::invalid_argument(geometry::describe(faults, surface, "surface").front());
  data_ = std::make_shared<Data>(Data{depth::make_body(surface)});
}

DepthAnswer penetration_depth(const DepthBody& a, const DepthBody& b, const Placement& a_in_b, Metric metric,
                              bool careful) {
  depth::Query query;
  query.a_in_b = internal(a_in_b);
  query.metric = internal(metric);
  query.careful = careful;
  const depth::Answer answer = depth::penetration_depth(a.data().body, b.data().body, query);
  return {answer.overlap, answer.depth, answer.bound, answer.distance, external(answer.placement)};
}

}  // namespace brunt::api
