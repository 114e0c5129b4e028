// SPDX-License-Identifier: Apache-2.0
// Volumes and winding numbers of shells (see the header).
#include "shells.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/box.hpp"

namespace brunt::geometry {
namespace {

/// Largest accepted deviation of a winding number from an integer: rounding gives 1e-12, a point on a surface 1/2.
constexpr double winding_margin = 0.25;
/// Number of triangles of a shell whose centres are tried before a deviating winding number is accepted.
constexpr std::size_t most_centres = 8;

std::size_t at(LocalIndex i) {
  return static_cast<std::size_t>(i);
}

struct Triangle {
  Vec3 a, b, c;
};

Triangle triangle_of(const TriangleSurface& surface, LocalIndex t) {
  const auto& [a, b, c] = surface.triangles[at(t)];
  return {surface.points[at(a)], surface.points[at(b)], surface.points[at(c)]};
}

/// Solid angle of a triangle from the origin, > 0 if its corners appear clockwise from there. Van Oosterom and
/// Strackee, IEEE Transactions on Biomedical Engineering 30 (1983).
double solid_angle(const Triangle& t) {
  const double a = t.a.norm(), b = t.b.norm(), c = t.c.norm();
  const double below = a * b * c + t.a.dot(t.b) * c + t.b.dot(t.c) * a + t.c.dot(t.a) * b;
  return 2 * std::atan2(t.a.dot(t.b.cross(t.c)), below);
}

class Shells {
 public:
  Shells(const TriangleSurface& surface, std::span<const LocalIndex> shell_of, std::size_t count)
      : surface_(surface), boxes_(count), triangles_(count) {
    for (LocalIndex t = 0; t < static_cast<LocalIndex>(shell_of.size()); ++t) {
      const std::size_t shell = at(shell_of[at(t)]);
      triangles_[shell].push_back(t);
      for (const LocalIndex point : surface.triangles[at(t)]) extend(boxes_[shell], surface.points[at(point)]);
    }
  }

  /// Relative to the shell's first point, to avoid cancellation for shells far from the origin.
  [[nodiscard]] double volume(std::size_t shell) const {
    const Vec3 origin = triangle_of(surface_, triangles_[shell].front()).a;
    double sum = 0;
    for (const LocalIndex t : triangles_[shell]) {
      const auto [a, b, c] = triangle_of(surface_, t);
      sum += (a - origin).dot((b - origin).cross(c - origin));
    }
    return sum / 6;
  }

  /// Winding number of all other shells around the shell.
  [[nodiscard]] double others_around(std::size_t shell) const {
    const auto& own = triangles_[shell];
    double number = 0;
    for (std::size_t k = 0; k < std::min(own.size(), most_centres); ++k) {
      const auto [a, b, c] = triangle_of(surface_, own[k]);
      number = others_around(shell, (a + b + c) / 3);
      if (std::abs(number - std::round(number)) < winding_margin) break;
    }
    return number;
  }

 private:
  [[nodiscard]] double others_around(std::size_t shell, const Vec3& x) const {
    double sum = 0;
    for (std::size_t other = 0; other < boxes_.size(); ++other) {
      if (other == shell || !contains(boxes_[other], x)) continue;
      for (const LocalIndex t : triangles_[other]) {
        const auto [a, b, c] = triangle_of(surface_, t);
        sum += solid_angle({a - x, b - x, c - x});
      }
    }
    return sum / (4 * std::numbers::pi);
  }

  const TriangleSurface& surface_;
  std::vector<Box> boxes_;
  std::vector<std::vector<LocalIndex>> triangles_;
};

void add(ItemFaults& faults, std::size_t item) {
  if (faults.count++ == 0) faults.first = static_cast<LocalIndex>(item);
}

}  // namespace

void check_shells(const TriangleSurface& surface, std::span<const LocalIndex> shell_of, bool edges_sound,
                  SurfaceFaults& faults) {
  const Shells shells(surface, shell_of, faults.shells.size());
  for (std::size_t s = 0; s < faults.shells.size(); ++s) {
    faults.shells[s].volume = shells.volume(s);
    faults.volume += faults.shells[s].volume;
  }
  if (!edges_sound) return;
  for (std::size_t s = 0; s < faults.shells.size(); ++s) {
    const double others = shells.others_around(s);
    if (faults.shells[s].volume < 0 && others < winding_margin) add(faults.inside_out, s);
    if (faults.shells[s].volume >= 0 && others > 1 - winding_margin) add(faults.doubled, s);
  }
}

}  // namespace brunt::geometry
