// SPDX-License-Identifier: Apache-2.0
// Edges, areas and shells of a surface of triangles (see the header).
#include "geometry/triangles/closed_surface.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <tuple>

#include "core/error.hpp"
#include "core/union_find.hpp"
#include "shells.hpp"

namespace brunt::geometry {
namespace {

std::size_t at(LocalIndex i) {
  return static_cast<std::size_t>(i);
}

/// A side of a triangle. Sides of one edge are adjacent, in the order of their triangles.
struct Side {
  LocalIndex low, high;  // points
  LocalIndex triangle;
  std::int16_t corner;  // of the triangle, at which the side begins
  bool forward;         // from low to high
  [[nodiscard]] bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
  [[nodiscard]] std::array<LocalIndex, 2> points() const {
    return forward ? std::array{low, high} : std::array{high, low};
  }
};

std::vector<Side> sorted_sides(const TriangleSurface& surface) {
  std::vector<Side> sides;
  sides.reserve(3 * surface.triangles.size());
  for (LocalIndex t = 0; t < static_cast<LocalIndex>(surface.triangles.size()); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const LocalIndex from = surface.triangles[at(t)][k], to = surface.triangles[at(t)][(k + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), t, static_cast<std::int16_t>(k), from < to});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle, a.corner) < std::tie(b.low, b.high, b.triangle, b.corner);
  });
  return sides;
}

void add(EdgeFaults& faults, const Side& side) {
  ++faults.count;
  if (faults.triangle != no_index && std::tie(faults.triangle, faults.corner) < std::tie(side.triangle, side.corner))
    return;
  faults.triangle = side.triangle;
  faults.corner = side.corner;
  faults.points = side.points();
}

/// Counts the errors of edges, and joins the triangles at each edge to shells.
void check_edges(const TriangleSurface& surface, UnionFind& shells, SurfaceFaults& faults) {
  const std::vector<Side> sides = sorted_sides(surface);
  for (auto begin = sides.begin(); begin != sides.end();) {
    const auto end = std::find_if_not(begin, sides.end(), [&](const Side& side) { return side.same_edge(*begin); });
    for (auto side = begin; side != end; ++side)
      shells.join(static_cast<std::size_t>(begin->triangle), static_cast<std::size_t>(side->triangle));
    if (end - begin == 1)
      add(faults.open, *begin);
    else if (end - begin > 2)
      add(faults.non_manifold, *begin);
    else if (begin->forward == std::next(begin)->forward)
      add(faults.reversed, *begin);
    begin = end;
  }
}

void check_areas(const TriangleSurface& surface, SurfaceFaults& faults) {
  for (LocalIndex t = 0; t < static_cast<LocalIndex>(surface.triangles.size()); ++t)
    if (!has_area(surface, surface.triangles[at(t)]) && faults.no_area.count++ == 0) faults.no_area.first = t;
}

std::int64_t unused_points(const TriangleSurface& surface) {
  std::vector<char> used(surface.points.size(), 0);
  for (const auto& triangle : surface.triangles)
    for (const LocalIndex point : triangle) used[at(point)] = 1;
  return std::ranges::count(used, char{0});
}

/// Numbers the shells by their first triangles, those of the lowest number; the shell of each triangle.
std::vector<LocalIndex> number_shells(UnionFind& sets, std::size_t triangles, std::vector<Shell>& shells) {
  std::vector<LocalIndex> shell_of(triangles, no_index);
  for (LocalIndex t = 0; t < static_cast<LocalIndex>(triangles); ++t) {
    const auto first = static_cast<LocalIndex>(sets.first(at(t)));
    if (first == t) {
      shell_of[at(t)] = static_cast<LocalIndex>(shells.size());
      shells.push_back({t, 0, 0});
    }
    shell_of[at(t)] = shell_of[at(first)];
    ++shells[at(shell_of[at(t)])].triangles;
  }
  return shell_of;
}

std::string place(const Vec3& x) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", x[0], x[1], x[2]);
}

std::string plural(std::int64_t count, std::string_view one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

}  // namespace

bool has_area(const TriangleSurface& surface, const std::array<LocalIndex, 3>& triangle) {
  const Vec3 &a = surface.points[at(triangle[0])], &b = surface.points[at(triangle[1])],
             &c = surface.points[at(triangle[2])];
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return (b - a).cross(c - a).norm() > least_height_ratio * longest;
}

bool SurfaceFaults::sound() const {
  return open.count + non_manifold.count + reversed.count + no_area.count + inside_out.count + doubled.count == 0;
}

SurfaceFaults check_closed(const TriangleSurface& surface) {
  SurfaceFaults faults;
  UnionFind sets(surface.triangles.size());
  check_edges(surface, sets, faults);
  check_areas(surface, faults);
  faults.unused_points = unused_points(surface);
  const std::vector<LocalIndex> shell_of = number_shells(sets, surface.triangles.size(), faults.shells);
  const bool edges_sound = faults.open.count + faults.non_manifold.count + faults.reversed.count == 0;
  check_shells(surface, shell_of, edges_sound, faults);
  return faults;
}

std::vector<std::string> describe(const SurfaceFaults& faults, const TriangleSurface& surface,
                                  const std::string& name) {
  std::vector<std::string> lines;
  const auto edges = [&](const EdgeFaults& fault, std::string_view what, std::string_view expected) {
    if (fault.count == 0) return;
    lines.push_back(fmt::format("{}: invalid surface: {}, the first from {} to {}; expected {}", name, what,
                                place(surface.points[at(fault.points[0])]), place(surface.points[at(fault.points[1])]),
                                expected));
  };
  const auto shell = [&](const ItemFaults& fault, std::string_view what, std::string_view expected) {
    if (fault.count == 0) return;
    const Shell& first = faults.shells[at(fault.first)];
    const Vec3& x = surface.points[at(surface.triangles[at(first.first_triangle)][0])];
    lines.push_back(fmt::format("{}: invalid surface: {} of {} {}, the first at {}, of volume {:.6g}; expected {}",
                                name, fault.count, plural(std::ssize(faults.shells), "shell"), what, place(x),
                                first.volume, expected));
  };
  edges(faults.open, plural(faults.open.count, "open edge"), "a closed surface");
  edges(faults.non_manifold, plural(faults.non_manifold.count, "edge") + " of more than two triangles",
        "two triangles at each edge");
  edges(faults.reversed, plural(faults.reversed.count, "edge") + " that two triangles traverse in the same direction",
        "no reversed triangles");
  if (faults.no_area.count > 0) {
    const Vec3& x = surface.points[at(surface.triangles[at(faults.no_area.first)][0])];
    lines.push_back(fmt::format("{}: invalid surface: {} without area, the first is number {} at {}; expected none",
                                name, plural(faults.no_area.count, "triangle"), faults.no_area.first + 1, place(x)));
  }
  const bool all = faults.inside_out.count > 0 && faults.volume < 0;
  shell(faults.inside_out, "inside out",
        all ? "triangles counter-clockwise seen from outside; all of them may be reversed"
            : "triangles counter-clockwise seen from outside");
  shell(faults.doubled, "inside another one without being a cavity", "cavities of reversed triangles");
  return lines;
}

}  // namespace brunt::geometry
