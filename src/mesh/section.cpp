// SPDX-License-Identifier: Apache-2.0
#include "section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/assemble.hpp"

namespace brunt::mesh {
namespace {

/// Corners of a square's outline of half width k, counter-clockwise from (-k, -k), 8 k of them.
std::vector<std::array<int, 2>> outline(int k) {
  std::vector<std::array<int, 2>> corners;
  for (int i = -k; i < k; ++i) corners.push_back({i, -k});
  for (int j = -k; j < k; ++j) corners.push_back({k, j});
  for (int i = k; i > -k; --i) corners.push_back({i, k});
  for (int j = k; j > -k; --j) corners.push_back({-k, j});
  return corners;
}

/// The part of a circle that is kept, in quarters of it counter-clockwise from the x axis.
struct Arc {
  int first = 0, quarters = 4;
};

Arc arc_of(const Half& half) {
  if (half[0] != 0 && half[1] != 0) return {half[0] > 0 ? (half[1] > 0 ? 0 : 3) : (half[1] > 0 ? 1 : 2), 1};
  if (half[0] != 0) return {half[0] > 0 ? 3 : 1, 2};
  if (half[1] != 0) return {half[1] > 0 ? 0 : 2, 2};
  return {};
}

/// Cosine and sine of `steps` of which `quarter` make 90 degrees: exact on the axes, mirrored exactly between them.
std::array<double, 2> on_circle(int steps, int quarter) {
  const int turns = steps / quarter % 4, rest = steps % quarter;
  const auto angle = [&](int n) { return std::numbers::pi / 2 * n / quarter; };
  double c = std::cos(angle(rest)), s = std::sin(angle(rest));
  if (2 * rest == quarter) c = s = std::numbers::sqrt2 / 2;
  if (2 * rest > quarter) {
    c = std::sin(angle(quarter - rest));
    s = std::cos(angle(quarter - rest));
  }
  if (turns == 0) return {c, s};
  if (turns == 1) return {-s, c};
  return turns == 2 ? std::array{-c, -s} : std::array{s, -c};
}

}  // namespace

Section rectangle(const std::vector<double>& x, const std::vector<double>& y) {
  Section section;
  for (const double b : y)
    for (const double a : x) section.points.push_back({a, b});
  const auto row = static_cast<LocalIndex>(x.size()), rows = static_cast<LocalIndex>(y.size());
  for (LocalIndex j = 0; j + 1 < rows; ++j)
    for (LocalIndex i = 0; i + 1 < row; ++i) {
      const LocalIndex corner = i + row * j;
      section.quads.push_back({corner, corner + 1, corner + 1 + row, corner + row});
    }
  return section;
}

int round_from(const Division& across) {
  for (const SizeAt& one : across.sizes)
    if (one.place > 0) return cells_below(across, 0, one.place);
  return across.cells;
}

RoundedCore rounded_core(double radius, const Division& across) {
  if (across.is_even()) return {radius, across.cells};
  return {places(across, 0, radius), round_from(across)};
}

Section butterfly(const RoundedCore& core) {
  const int k = core.half_cells(), rings = core.shells(), row = 2 * k + 1;
  const std::vector<double> lines(static_cast<std::size_t>(row));
  Section section = rectangle(lines, lines);
  for (int j = -k; j <= k; ++j)
    for (int i = -k; i <= k; ++i) {
      const Vec3 x = core.inside({i, j, 0});
      const int point = i + k + row * (j + k);
      nth(section.points, point) = {x[0], x[1]};
    }
  const auto corners = outline(k);
  const auto around = static_cast<LocalIndex>(corners.size());
  const auto node = [&](int ring, LocalIndex c) {
    const auto& [i, j] = nth(corners, c % around);
    return ring == 0 ? i + k + row * (j + k) : row * row + (ring - 1) * around + c % around;
  };
  for (int ring = 1; ring <= rings; ++ring)
    for (const auto& [i, j] : corners) {
      const Vec3 x = core.outside({i, j, 0}, ring);
      section.points.push_back({x[0], x[1]});
    }
  for (int ring = 0; ring < rings; ++ring)
    for (LocalIndex c = 0; c < around; ++c)
      section.quads.push_back({node(ring, c), node(ring + 1, c), node(ring + 1, c + 1), node(ring, c + 1)});
  return section;
}

void keep_half(Section& section, std::vector<char>& tag, const Half& half) {
  const auto inside = [&](LocalIndex n) {
    const auto& x = nth(section.points, n);
    return half[0] * x[0] >= 0 && half[1] * x[1] >= 0;
  };
  std::erase_if(section.quads, [&](const auto& quad) { return !std::ranges::all_of(quad, inside); });
  std::vector<LocalIndex> place(section.points.size(), no_index);
  for (const auto& quad : section.quads)
    for (const LocalIndex n : quad) nth(place, n) = 0;
  Section kept;
  std::vector<char> tag_of_kept;
  for (std::size_t n = 0; n < place.size(); ++n) {
    if (place[n] == no_index) continue;
    place[n] = static_cast<LocalIndex>(kept.points.size());
    kept.points.push_back(section.points[n]);
    tag_of_kept.push_back(tag[n]);
  }
  for (auto& quad : section.quads)
    for (LocalIndex& n : quad) n = nth(place, n);
  section.points = std::move(kept.points);
  tag = std::move(tag_of_kept);
}

LocalIndex Rays::point(int ray, int place) const {
  const auto row = static_cast<LocalIndex>(radius.size());
  const LocalIndex number = ray % static_cast<int>(cosines.size());
  if (!solid()) return number * row + place;
  return place == 0 ? 0 : 1 + number * (row - 1) + place - 1;
}

std::vector<std::array<double, 2>> ray_directions(int around, const RoundForm& form, bool& closed) {
  std::vector<std::array<double, 2>> rays;
  if (form.sector.cuts()) {
    closed = false;
    const auto& [from, to] = form.sector;
    for (int c = 0; c <= around; ++c) rays.push_back(cosine_sine(c == around ? to : from + (to - from) * c / around));
    return rays;
  }
  const Arc arc = arc_of(form.half);
  closed = arc.quarters == 4;
  const int cells = around * arc.quarters / 4, count = closed ? cells : cells + 1;
  for (int c = 0; c < count; ++c) rays.push_back(on_circle(arc.first * around + 4 * c, around));
  return rays;
}

Section annulus(const Rays& rays) {
  Section section;
  const auto row = static_cast<int>(rays.radius.size());
  for (std::size_t c = 0; c < rays.cosines.size(); ++c)
    for (int r = rays.solid() && c > 0 ? 1 : 0; r < row; ++r) {
      const double radius = nth(rays.radius, r);
      section.points.push_back({radius * rays.cosines[c][0], radius * rays.cosines[c][1]});
    }
  for (int c = 0; c < rays.cells(); ++c)
    for (int r = 0; r + 1 < row; ++r)
      section.quads.push_back({rays.point(c, r), rays.point(c, r + 1), rays.point(c + 1, r + 1), rays.point(c + 1, r)});
  return section;
}

}  // namespace brunt::mesh
