// SPDX-License-Identifier: Apache-2.0
// Closed surfaces for tests of penetration depth: grids, boxes, and the six bodies of three pairs (with the triangle
// counts of Zhang, Kim and Manocha 2007, Table I).
#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "core/triangle_surface.hpp"

namespace brunt::test {

constexpr double pi = 3.14159265358979323846;

/// Volume by signed tetrahedra.
inline double volume(const TriangleSurface& surface) {
  double sum = 0;
  for (const auto& t : surface.triangles) {
    const auto at = [&](std::size_t i) -> const Vec3& { return surface.points[static_cast<std::size_t>(t[i])]; };
    sum += at(0).dot(at(1).cross(at(2)));
  }
  return sum / 6;
}

/// With its normals outward.
inline TriangleSurface outward(TriangleSurface surface) {
  if (volume(surface) < 0)
    for (auto& t : surface.triangles) std::swap(t[1], t[2]);
  return surface;
}

inline void add_quad(TriangleSurface& surface, std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
  const auto index = [](std::size_t i) { return static_cast<LocalIndex>(i); };
  surface.triangles.push_back({index(a), index(b), index(c)});
  surface.triangles.push_back({index(a), index(c), index(d)});
}

/// Points f(2 pi i / n, 2 pi j / m); quadrilaterals are cut from (i, j) to (i + 1, j + 1).
template <class Function>
TriangleSurface torus_grid(std::size_t n, std::size_t m, const Function& f) {
  TriangleSurface surface;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j)
      surface.points.push_back(f(2 * pi * static_cast<double>(i) / static_cast<double>(n),
                                 2 * pi * static_cast<double>(j) / static_cast<double>(m)));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j) {
      const std::size_t next_i = (i + 1) % n, next_j = (j + 1) % m;
      add_quad(surface, i * m + j, next_i * m + j, next_i * m + next_j, i * m + next_j);
    }
  return outward(surface);
}

/// Poles f(0, 0) and f(0, 1), rings f(2 pi i / n, (r + 1) / (m + 1)); quadrilaterals are cut from (r, i) to
/// (r + 1, i + 1).
template <class Function>
TriangleSurface sphere_grid(std::size_t n, std::size_t m, const Function& f) {
  TriangleSurface surface;
  for (std::size_t r = 0; r < m; ++r)
    for (std::size_t i = 0; i < n; ++i)
      surface.points.push_back(f(2 * pi * static_cast<double>(i) / static_cast<double>(n),
                                 static_cast<double>(r + 1) / static_cast<double>(m + 1)));
  const auto first = static_cast<LocalIndex>(surface.points.size()), last = first + 1;
  surface.points.push_back(f(0.0, 0.0));
  surface.points.push_back(f(0.0, 1.0));
  for (std::size_t r = 0; r + 1 < m; ++r)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t next = (i + 1) % n;
      add_quad(surface, r * n + i, (r + 1) * n + i, (r + 1) * n + next, r * n + next);
    }
  for (std::size_t i = 0; i < n; ++i) {
    const auto here = static_cast<LocalIndex>(i), next = static_cast<LocalIndex>((i + 1) % n);
    const auto below = static_cast<LocalIndex>((m - 1) * n);
    surface.triangles.push_back({first, here, next});
    surface.triangles.push_back({last, below + next, below + here});
  }
  return outward(surface);
}

/// A polygon in the plane of x and y, seen counter-clockwise, from z = low to high; its caps are fans from point 0.
inline TriangleSurface prism(const std::vector<std::array<double, 2>>& polygon, double low, double high) {
  TriangleSurface surface;
  const std::size_t n = polygon.size();
  for (const double z : {low, high})
    for (const auto& p : polygon) surface.points.emplace_back(p[0], p[1], z);
  for (std::size_t i = 0; i < n; ++i) add_quad(surface, i, (i + 1) % n, n + (i + 1) % n, n + i);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const auto a = static_cast<LocalIndex>(i), up = static_cast<LocalIndex>(n);
    surface.triangles.push_back({0, static_cast<LocalIndex>(a + 1), a});
    surface.triangles.push_back({up, static_cast<LocalIndex>(up + a), static_cast<LocalIndex>(up + a + 1)});
  }
  return outward(surface);
}

inline TriangleSurface box(const Vec3& low, const Vec3& high) {
  return prism({{low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}}, low[2], high[2]);
}

/// Revolved about z in `slices`: a closed profile of (r, z).
inline TriangleSurface revolved(const std::vector<std::array<double, 2>>& profile, std::size_t slices) {
  return torus_grid(slices, profile.size(), [&](double u, double w) {
    const auto j = static_cast<std::size_t>(std::lround(w / (2 * pi) * static_cast<double>(profile.size())));
    return Vec3(profile[j][0] * std::cos(u), profile[j][0] * std::sin(u), profile[j][1]);
  });
}

/// `more` points, each put on the side with the longest pieces so far (the first of equals), evenly spaced on it.
inline std::vector<std::array<double, 2>> divided(const std::vector<std::array<double, 2>>& polygon, int more) {
  const std::size_t n = polygon.size();
  std::vector<int> pieces(n, 1);
  const auto length = [&](std::size_t i) {
    const auto &p = polygon[i], &q = polygon[(i + 1) % n];
    return std::hypot(q[0] - p[0], q[1] - p[1]) / pieces[i];
  };
  for (int k = 0; k < more; ++k) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < n; ++i)
      if (length(i) > length(longest) * (1 + 1e-12)) longest = i;
    ++pieces[longest];
  }
  std::vector<std::array<double, 2>> result;
  for (std::size_t i = 0; i < n; ++i)
    for (int k = 0; k < pieces[i]; ++k) {
      const double s = static_cast<double>(k) / pieces[i];
      const auto &p = polygon[i], &q = polygon[(i + 1) % n];
      result.push_back({p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1])});
    }
  return result;
}

/// 20 triangles
inline TriangleSurface l_shape() {
  return prism({{0, 0}, {2, 0}, {2, .6}, {.6, .6}, {.6, 2}, {0, 2}}, 0, .5);
}

/// 2,880 triangles
inline TriangleSurface knot() {
  return torus_grid(144, 10, [](double u, double w) {
    const Vec3 centre(std::sin(u) + 2 * std::sin(2 * u), std::cos(u) - 2 * std::cos(2 * u), -std::sin(3 * u));
    const Vec3 first(std::cos(u) + 4 * std::cos(2 * u), -std::sin(u) + 4 * std::sin(2 * u), -3 * std::cos(3 * u));
    const Vec3 second(-std::sin(u) - 8 * std::sin(2 * u), -std::cos(u) + 8 * std::cos(2 * u), 9 * std::sin(3 * u));
    const Vec3 t = first.normalized(), n = (second - second.dot(t) * t).normalized(), b = t.cross(n);
    return Vec3(centre + .35 * (std::cos(w) * n + std::sin(w) * b));
  });
}

/// 304 triangles
inline TriangleSurface pawn() {
  const auto radius = [](double s) {
    if (s == 0 || s == 1) return 0.0;
    if (s < .15) return .55;
    if (s < .3) return .55 - 2 * (s - .15);
    if (s < .65) return .25 - .15 * (s - .3);
    if (s < .7) return .4;
    const double x = (s - .85) / .15;
    return .34 * std::sqrt(std::max(.05, 1 - x * x));
  };
  return sphere_grid(8, 19,
                     [&](double u, double s) { return Vec3(radius(s) * std::cos(u), radius(s) * std::sin(u), 2 * s); });
}

/// 2,442 triangles
inline TriangleSurface hub() {
  return revolved(
      divided({{.4, 0}, {2, 0}, {2, .3}, {.9, .3}, {.8, .4}, {.8, 1.2}, {1.1, 1.2}, {1.1, 1.4}, {.4, 1.4}}, 28), 33);
}

/// 1,692 triangles
inline TriangleSurface mallet() {
  return sphere_grid(18, 47, [](double u, double s) {
    if (s == 0 || s == 1) return Vec3(0, 0, 4 * s);
    if (s < .72) return Vec3(.18 * std::cos(u), .18 * std::sin(u), 4 * s);
    return Vec3(.5 * .75 * std::cos(u), 1.4 * .75 * std::sin(u), 4 * s);
  });
}

/// 2,880 triangles
inline TriangleSurface bumpy_sphere() {
  return sphere_grid(36, 40, [](double u, double s) {
    const double theta = pi * s, sine = std::sin(theta);
    const double radius = 1.5 * (1 + .18 * std::sin(6 * u) * sine * sine * sine * std::sin(5 * theta));
    return Vec3(radius * sine * std::cos(u), radius * sine * std::sin(u), radius * std::cos(theta));
  });
}

inline Vec3 volume_centroid(const TriangleSurface& surface) {
  Vec3 sum = Vec3::Zero();
  for (const auto& t : surface.triangles) {
    const auto at = [&](std::size_t i) -> const Vec3& { return surface.points[static_cast<std::size_t>(t[i])]; };
    sum += at(0).dot(at(1).cross(at(2))) / 24 * (at(0) + at(1) + at(2));
  }
  return sum / volume(surface);
}

/// The greatest distance of a point from `centre`.
inline double reach(const TriangleSurface& surface, const Vec3& centre) {
  double greatest = 0;
  for (const Vec3& p : surface.points) greatest = std::max(greatest, (p - centre).norm());
  return greatest;
}

template <class Random>
Mat3 uniform_rotation(Random& random) {
  std::normal_distribution<double> normal;
  const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
  return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
}

/// R uniform; the centroid of a at the distance share * (reach of a + reach of b) from that of b in a uniform
/// direction, the share uniform in (0, `most`).
template <class Random>
Placement random_placement(const TriangleSurface& a, const TriangleSurface& b, Random& random, double most = 1) {
  const Vec3 centre_a = volume_centroid(a), centre_b = volume_centroid(b);
  const double reaches = reach(a, centre_a) + reach(b, centre_b);
  Placement placement;
  placement.rotation = uniform_rotation(random);
  const Vec3 direction = uniform_rotation(random) * Vec3::UnitX();
  const double share = std::uniform_real_distribution<double>(0, most)(random);
  placement.translation = centre_b + share * reaches * direction - placement.rotation * centre_a;
  return placement;
}

}  // namespace brunt::test
