// SPDX-License-Identifier: Apache-2.0
// Pointed noses are round bodies (a half ball, a quarter of a disk) moved to an outline; blunt ones are layers.
#include "nose.hpp"

#include <cmath>
#include <map>
#include <numbers>

#include "ball.hpp"

namespace brunt::mesh {
namespace {

/// Moves a point (across, up) of a quarter disk: the arc becomes the outline, the lower edge stays. Inner arcs are the
/// more elliptic the nearer they are to the centre, so that elements at the axis meet at right angles below a tip. The
/// outline's share grows linearly, which leaves shells below a cone 0.59 as thick as even ones.
class Drawn {
 public:
  Drawn(const Outline& outline, double radius, double inner) : outline_(outline), radius_(radius), inner_(inner) {}

  [[nodiscard]] std::array<double, 2> operator()(double across, double up) const {
    if (up == 0) return {across, 0};
    const double share = std::hypot(across, up) / radius_, height = outline_.height();
    if (across == 0) return {0, share * height};
    const double angle = std::atan2(up, across);
    const auto [r, z] = outline_.at(angle / (std::numbers::pi / 2));
    return {share * ((1 - share) * radius_ * std::cos(angle) + share * (r - inner_)),
            share * ((1 - share) * height * std::sin(angle) + share * z)};
  }

 private:
  const Outline& outline_;
  double radius_, inner_;
};

LocalIndex add_node(RoundBody& body, const Vec3& x, unsigned mark) {
  body.cells.coordinates.push_back(x);
  body.mark.push_back(static_cast<Marks>(mark));
  return static_cast<LocalIndex>(body.cells.coordinates.size()) - 1;
}

double end_height(const RoundBody& body) {
  return nth(body.cells.coordinates, body.end)[2];
}

/// Cells of the quarter of a disk between the axes, points and quadrilaterals as of a section: core, then rings.
struct Quarter {
  Section section;
  std::vector<int> foot;     ///< of each point: its place on the lower edge, or -1
  std::vector<char> on_arc;  ///< of each point
};

Quarter quarter_disk(const RoundedCore& core) {
  const int k = core.half_cells(), row = k + 1, around = 2 * k;
  Quarter quarter;
  const auto add = [&](const Vec3& x, int foot, bool on_arc) {
    quarter.section.points.push_back({x[0], x[1]});
    quarter.foot.push_back(foot);
    quarter.on_arc.push_back(on_arc ? 1 : 0);
  };
  const std::vector<double> lines(static_cast<std::size_t>(row));
  quarter.section.quads = rectangle(lines, lines).quads;
  const bool no_rings = core.shells() == 0;
  for (int j = 0; j <= k; ++j)
    for (int i = 0; i <= k; ++i) {
      const bool on_arc = no_rings && std::max(i, j) == k;
      add(on_arc ? core.outside({i, j, 0}, 0) : core.inside({i, j, 0}), j == 0 ? i : -1, on_arc);
    }
  const auto corner = [k](int c) { return c <= k ? std::array{k, c, 0} : std::array{2 * k - c, k, 0}; };
  for (int ring = 1; ring <= core.shells(); ++ring)
    for (int c = 0; c <= around; ++c) add(core.outside(corner(c), ring), c == 0 ? k + ring : -1, ring == core.shells());
  const auto node = [&](int ring, int c) -> LocalIndex {
    return ring == 0 ? corner(c)[0] + row * corner(c)[1] : row * row + (ring - 1) * (around + 1) + c;
  };
  for (int ring = 0; ring < core.shells(); ++ring)
    for (int c = 0; c < around; ++c)
      quarter.section.quads.push_back({node(ring, c), node(ring + 1, c), node(ring + 1, c + 1), node(ring, c + 1)});
  return quarter;
}

}  // namespace

void add_blunt_nose(RoundBody& body, const Section& section, const Outline& outline, double inner, int layers) {
  const double foot = end_height(body), radius = outline.at(0)[0];
  const auto layer = static_cast<LocalIndex>(section.points.size());
  const LocalIndex end = body.end;
  for (int k = 1; k <= layers; ++k) {
    const auto [narrow, height] = outline.at(k == layers ? 1.0 : static_cast<double>(k) / layers);
    for (LocalIndex n = 0; n < layer; ++n) {
      const auto& [x, y] = nth(section.points, n);
      const double from_axis = std::hypot(x, y), share = (narrow - inner) / (radius - inner);
      const double factor = inner == 0 ? share : (inner + (from_axis - inner) * share) / from_axis;
      const unsigned at_end = nth(body.mark, end + n);
      unsigned mark = (at_end & on_side) != 0 ? on_nose : Marks{0};
      if ((at_end & on_inner) != 0) mark |= on_inner;
      if (k == layers) mark |= on_nose | on_top;
      add_node(body, {factor * x, factor * y, foot + height}, mark);
    }
    for (const auto& quad : section.quads)
      for (const int level : {k - 1, k})
        for (const LocalIndex n : quad) body.cells.nodes.push_back(end + level * layer + n);
  }
  for (LocalIndex n = end; n < end + layer; ++n)
    if (Marks& mark = nth(body.mark, n); (mark & on_side) != 0) mark |= on_nose;
}

void add_pointed_nose(RoundBody& body, const Section& section, const RoundedCore& core, const Half& half,
                      const Outline& outline) {
  const double foot = end_height(body);
  std::map<std::array<double, 2>, LocalIndex> on_end;
  for (std::size_t n = 0; n < section.points.size(); ++n)
    on_end[section.points[n]] = body.end + static_cast<LocalIndex>(n);
  const Ball dome = ball(core, {half[0], half[1], 1});
  const Drawn drawn(outline, core.radius(), 0);
  std::vector<LocalIndex> number;
  for (const Vec3& x : dome.cells.coordinates) {
    const bool on_surface = static_cast<LocalIndex>(number.size()) >= dome.inner;
    if (x[2] == 0) {
      number.push_back(on_end.at({x[0], x[1]}));
      if (on_surface) nth(body.mark, number.back()) |= on_nose;
      continue;
    }
    const double across = std::hypot(x[0], x[1]);
    const auto [r, z] = drawn(across, x[2]);
    const double factor = across == 0 ? 0 : r / across;
    number.push_back(add_node(body, {factor * x[0], factor * x[1], foot + z}, on_surface ? on_nose : Marks{0}));
  }
  for (const LocalIndex n : dome.cells.nodes) body.cells.nodes.push_back(nth(number, n));
}

void add_pointed_nose(RoundBody& body, const Rays& rays, const Outline& outline) {
  const double foot = end_height(body), inner = rays.radius.front(), radius = rays.radius.back() - inner;
  std::vector<double> from_inner;
  for (const double r : rays.radius) from_inner.push_back(r - inner);
  const auto cells = static_cast<int>(from_inner.size()) - 1;
  const Quarter quarter = quarter_disk({from_inner, cells, 1.0});
  const Drawn drawn(outline, radius, inner);
  const auto count = static_cast<int>(rays.cosines.size());
  std::vector<LocalIndex> number;  // of each point on each ray
  for (std::size_t q = 0; q < quarter.section.points.size(); ++q) {
    const auto [a, b] = quarter.section.points[q];
    const auto [across, up] = drawn(a, b);
    const unsigned mark = (quarter.on_arc[q] != 0 ? on_nose : Marks{0}) | (a == 0 && inner > 0 ? on_inner : Marks{0});
    for (int c = 0; c < count; ++c) {
      if (quarter.foot[q] >= 0) {
        number.push_back(body.end + rays.point(c, quarter.foot[q]));
        nth(body.mark, number.back()) |= static_cast<Marks>(mark);
      } else if (a == 0 && rays.solid() && c > 0) {
        number.push_back(number.back());
      } else {
        const auto [cosine, sine] = nth(rays.cosines, c);
        const double r = a == 0 ? inner : inner + across;
        number.push_back(add_node(body, {r * cosine, r * sine, foot + up}, mark));
      }
    }
  }
  for (int c = 0; c < rays.cells(); ++c)
    for (const auto& quad : quarter.section.quads)
      for (const int ray : {(c + 1) % count, c})  // the quadrilateral's normal points against the rays' order
        for (const LocalIndex q : quad) body.cells.nodes.push_back(nth(number, q * count + ray));
}

}  // namespace brunt::mesh
