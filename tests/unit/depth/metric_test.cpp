// SPDX-License-Identifier: Apache-2.0
// Metrics of rigid motions against their definitions: the maximum over vertices, the integral over the volume.
#include "depth/metric.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "rigid/surface_moments.hpp"
#include "tests/support/random_motion.hpp"

using namespace brunt;
using namespace brunt::depth;
using test::Random;

namespace {

/// The L of table D: two triangulated caps and six sides.
TriangleSurface l_prism() {
  TriangleSurface s;
  const std::array<std::array<double, 2>, 6> corners{{{0, 0}, {2, 0}, {2, .6}, {.6, .6}, {.6, 2}, {0, 2}}};
  for (const double z : {0.0, 0.5})
    for (const auto& c : corners) s.points.emplace_back(c[0], c[1], z);
  for (LocalIndex i = 1; i < 5; ++i) {
    s.triangles.push_back({0, i + 1, i});
    s.triangles.push_back({6, 6 + i, 7 + i});
  }
  for (LocalIndex i = 0; i < 6; ++i) {
    const LocalIndex j = (i + 1) % 6;
    s.triangles.push_back({i, j, 6 + j});
    s.triangles.push_back({i, 6 + j, 6 + i});
  }
  return s;
}

MetricShape shape_of(const TriangleSurface& s) {
  return metric_shape(s.points, rigid::surface_properties(s, 1));
}

RigidMotion random_motion(Random& random) {
  const Vec3 w = random.uniform(0, 3.14) * random.direction();
  return {rotation_of(w), random.uniform(0, 3) * random.direction()};
}

double most(const TriangleSurface& s, const Placement& a, const Placement& b) {
  double distance = 0;
  for (const Vec3& x : s.points) distance = std::max(distance, (a(x) - b(x)).norm());
  return distance;
}

/// Exact: |d|^2 is quadratic, and its mean over a tetrahedron is (sum of squares + square of sum)/20 of the corners.
double mean_square(const TriangleSurface& s, const Placement& a, const Placement& b) {
  double volume = 0, integral = 0;
  const Vec3 zero = a(Vec3::Zero()) - b(Vec3::Zero());
  for (const auto& t : s.triangles) {
    std::array<Vec3, 3> x, d;
    Vec3 sum = zero;
    double squares = zero.squaredNorm();
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] = s.points[static_cast<std::size_t>(t[k])];
      d[k] = a(x[k]) - b(x[k]);
      sum += d[k];
      squares += d[k].squaredNorm();
    }
    const double part = x[0].dot(x[1].cross(x[2])) / 6;
    volume += part;
    integral += part * (squares + sum.squaredNorm()) / 20;
  }
  return integral / volume;
}

}  // namespace

TEST_CASE("the metrics are the greatest and the root mean square displacement: 10^5 random motions") {
  const TriangleSurface s = l_prism();
  const MetricShape shape = shape_of(s);
  Random random(1);
  const Vec3 centroid = shape.centroid;
  double error_most = 0, error_mean = 0, error_screw = 0;
  int out_of_order = 0;
  for (int i = 0; i < 100000; ++i) {
    const RigidMotion m = random_motion(random);
    const Placement to = moved({}, m, centroid);
    const double most_now = length_of(shape, Metric::displacement, m), mean = length_of(shape, Metric::object_norm, m);
    error_most = std::max(error_most, std::abs(most_now / most(s, {}, to) - 1));
    error_mean = std::max(error_mean, std::abs(mean / std::sqrt(mean_square(s, {}, to)) - 1));
    const Screw screw = screw_of(m);
    double arm = 0;
    for (const Vec3& y : shape.extremes) arm = std::max(arm, screw.axis.cross(y - screw.point).norm());
    error_screw =
        std::max(error_screw, std::abs(most_now / std::hypot(screw.slide, 2 * std::sin(0.5 * screw.angle) * arm) - 1));
    out_of_order += !(mean <= most_now && most_now <= shape.ratio * mean);
  }
  CHECK(error_most < 1e-12);
  CHECK(error_mean < 1e-12);
  CHECK(error_screw < 1e-9);  // the axis is far away where the angle is small
  CHECK(out_of_order == 0);
}

TEST_CASE("pure translations, rotations about the centroid, and the constant c of table D") {
  const MetricShape shape = shape_of(l_prism());
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const RigidMotion shift{Eigen::Quaterniond::Identity(), random.vector()};
    for (const Metric metric : {Metric::translation, Metric::displacement, Metric::object_norm})
      CHECK(length_of(shape, metric, shift) == Approx(shift.shift.norm()).epsilon(1e-14));
    const Vec3 u = random.direction();
    const double phi = random.uniform(0, 3.14);
    const double sigma = 4 * std::pow(std::sin(0.5 * phi), 2) * u.dot(shape.gyration * u);
    CHECK(length_of(shape, Metric::object_norm, {rotation_of(phi * u), Vec3::Zero()}) ==
          Approx(std::sqrt(sigma)).epsilon(1e-13));
  }
  CHECK(shape.ratio == Approx(2.664).margin(5e-4));
  CHECK(shape.gyration(0, 0) == Approx(.347950).margin(5e-7));
  CHECK(shape.gyration(2, 2) == Approx(.654233).margin(5e-7));
  CHECK(shape.gyration(0, 1) == Approx(.169550).margin(5e-7));
  CHECK((shape.centroid - Vec3(.711765, .711765, .25)).norm() < 1e-6);
}

TEST_CASE("metrics are symmetric, obey the triangle inequality and do not see frames") {
  const TriangleSurface s = l_prism();
  const MetricShape shape = shape_of(s);
  Random random(3);
  for (int i = 0; i < 3000; ++i) {
    const Placement a = random.placement(), b = random.placement(), c = random.placement();
    const Placement frame = random.placement(), body = random.placement();
    TriangleSurface other = s;  // body frame moved
    for (Vec3& x : other.points) x = body(x);
    const auto in = [&](const Placement& p) {
      return Placement{p.rotation * body.rotation.transpose(), p(body.back(Vec3::Zero()))};
    };
    const auto world = [&](const Placement& p) { return Placement{frame.rotation * p.rotation, frame(p.translation)}; };
    const MetricShape turned = i % 100 ? shape : shape_of(other);
    for (const Metric metric : {Metric::displacement, Metric::object_norm}) {
      const auto between = [&](const Placement& p, const Placement& q) {
        return length_of(shape, metric, motion_between(p, q, shape.centroid));
      };
      const double ab = between(a, b);
      CHECK(std::abs(ab - between(b, a)) < 1e-12);
      CHECK(between(a, c) <= ab + between(b, c) + 1e-12);
      CHECK(std::abs(ab - between(world(a), world(b))) < 1e-12);
      if (i % 100 == 0)
        CHECK(std::abs(ab - length_of(turned, metric, motion_between(in(a), in(b), turned.centroid))) < 1e-12);
    }
  }
}

TEST_CASE("a point's factor bounds its displacement, and some motion attains it") {
  const MetricShape shape = shape_of(l_prism());
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    const Vec3 y = random.vector();
    const double factor = point_factor(shape.gyration, y);
    double attained = 0;
    for (int k = 0; k < 3000; ++k) {
      RigidMotion m;
      m.turn = rotation_of(1e-4 * random.direction());
      const Vec3 turned = rotation_less_identity(m.turn) * y;
      const double sigma = std::pow(length_of(shape, Metric::object_norm, m), 2);
      // the best translation beside it: T along the displacement
      const double best = 1 + turned.squaredNorm() / sigma;
      attained = std::max(attained, best);
      m.shift = turned * (sigma / turned.squaredNorm());
      const double both = std::pow(length_of(shape, Metric::object_norm, m), 2);
      CHECK((m.shift + turned).squaredNorm() <= factor * both * (1 + 1e-12));
    }
    CHECK(attained <= factor * (1 + 1e-6));
    CHECK(attained > 0.98 * factor);
  }
}
