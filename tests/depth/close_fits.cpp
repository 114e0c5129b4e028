// SPDX-License-Identifier: Apache-2.0
#include "tests/depth/close_fits.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/triangles/slab_tree.hpp"
#include "tests/support/depth_bodies.hpp"
#include "tests/support/random_motion.hpp"

namespace brunt::test {
namespace {

using Polygon = std::vector<std::array<double, 2>>;

/// A ring of radius r(angle, z) inside and `outer` outside, or a solid for outer = 0; `slices` around, `layers` along.
template <class Radius>
TriangleSurface ring(const Radius& radius, double outer, double low, double high, std::size_t slices,
                     std::size_t layers) {
  const auto z_at = [&](std::size_t k) {
    return low + (high - low) * static_cast<double>(k) / static_cast<double>(layers);
  };
  if (outer > 0)
    return torus_grid(slices, 2 * (layers + 1), [&](double u, double w) {
      const auto k = static_cast<std::size_t>(std::lround(w / (2 * pi) * static_cast<double>(2 * (layers + 1))));
      const bool inside = k <= layers;
      const double z = z_at(inside ? k : 2 * layers + 1 - k), r = inside ? radius(u, z) : outer;
      return Vec3(r * std::cos(u), r * std::sin(u), z);
    });
  return sphere_grid(slices, layers + 1, [&](double u, double s) {
    const auto k = static_cast<std::size_t>(std::lround(s * static_cast<double>(layers + 2)));
    if (k == 0 || k == layers + 2) return Vec3(0, 0, k == 0 ? low : high);
    const double z = z_at(k - 1);
    return Vec3(radius(u, z) * std::cos(u), radius(u, z) * std::sin(u), z);
  });
}

void shaft(CloseFit& fit, Random& random) {
  const double bore = 10, length = random.uniform(20, 40), pin = random.uniform(.8, 2.5) * length;
  const auto slices_a = static_cast<std::size_t>(12 + 4 * random.below(8)),
             slices_b = static_cast<std::size_t>(16 + 4 * random.below(8));
  const double inscribed = bore * std::cos(pi / static_cast<double>(slices_b));
  const auto round = [](double r) { return [r](double, double) { return r; }; };
  const auto layers = static_cast<std::size_t>(1 + random.below(10));
  fit.name = "shaft";
  fit.a = ring(round(inscribed - fit.clearance), 0, 0, pin, slices_a, layers);
  fit.b = ring(round(bore), 25, 0, length, slices_b, static_cast<std::size_t>(1 + random.below(6)));
  fit.fits.translation = {0, 0, random.uniform(-.6, .2) * pin};
}

/// As `prism`, of the eight points of a block with a slot, for which no fan makes a cap.
TriangleSurface slotted(const Polygon& polygon, double low, double high) {
  TriangleSurface surface;
  for (const double z : {low, high})
    for (const auto& p : polygon) surface.points.emplace_back(p[0], p[1], z);
  for (std::size_t i = 0; i < 8; ++i) add_quad(surface, i, (i + 1) % 8, 8 + (i + 1) % 8, 8 + i);
  constexpr std::array<std::array<LocalIndex, 3>, 6> cap{
      {{0, 1, 4}, {0, 4, 5}, {1, 2, 4}, {2, 3, 4}, {0, 5, 7}, {5, 6, 7}}};
  for (const auto& t : cap) {
    surface.triangles.push_back({t[0], t[2], t[1]});
    surface.triangles.push_back({8 + t[0], 8 + t[1], 8 + t[2]});
  }
  return outward(surface);
}

void key(CloseFit& fit, Random& random) {
  const double w = random.uniform(5, 10), h = random.uniform(4, 8), length = random.uniform(20, 40), c = fit.clearance;
  const double block = random.uniform(.6, 1.4) * length;
  fit.name = "key";
  fit.a = box({-w / 2, c, 0}, {w / 2, h, length});
  const double half = w / 2 + c;
  fit.b = slotted(
      {{-20, -15}, {20, -15}, {20, .7 * h}, {half, .7 * h}, {half, 0}, {-half, 0}, {-half, .7 * h}, {-20, .7 * h}}, 0,
      block);
  fit.fits.translation = {0, 0, random.uniform(-.3, .3) * length};
}

void lid(CloseFit& fit, Random& random) {
  const double r = random.uniform(15, 25), height = random.uniform(5, 12), wall = random.uniform(1.5, 3),
               c = fit.clearance;
  const auto slices = static_cast<std::size_t>(16 + 4 * random.below(8));
  const double slack = (r + c) / std::cos(pi / static_cast<double>(slices));
  fit.name = "lid";
  // a cup upside down on a pot
  fit.a = sphere_grid(slices, 4, [&](double u, double s) {
    const auto k = static_cast<std::size_t>(std::lround(s * 5));
    const std::array<std::array<double, 2>, 6> profile{
        {{0, c}, {slack, c}, {slack, -height}, {slack + wall, -height}, {slack + wall, wall + c}, {0, wall + c}}};
    return Vec3(profile[k][0] * std::cos(u), profile[k][0] * std::sin(u), profile[k][1]);
  });
  fit.b =
      revolved({{r - wall, -30}, {r, -30}, {r, 0}, {r - wall, 0}}, static_cast<std::size_t>(16 + 4 * random.below(8)));
}

/// A spur gear with straight flanks; `thin` is taken off each flank.
Polygon gear_outline(int teeth, double pitch_radius, double module, double thin, double phase) {
  Polygon outline;
  const double step = 2 * pi / teeth;
  for (int i = 0; i < teeth; ++i) {
    const double middle = phase + i * step, slope = .3 * module;
    const double at_root = module * pi / 4 + slope - thin, at_tip = module * pi / 4 - slope - thin;
    for (const auto& [radius, half] : {std::pair{pitch_radius - 1.15 * module, -at_root},
                                       {pitch_radius + .9 * module, -at_tip},
                                       {pitch_radius + .9 * module, at_tip},
                                       {pitch_radius - 1.15 * module, at_root}}) {
      const double angle = middle + half / radius;
      outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
  }
  return outline;
}

/// As `prism`, for outlines that are star-shaped about the origin.
TriangleSurface star_prism(const Polygon& outline, double low, double high) {
  const std::size_t n = outline.size();
  return sphere_grid(n, 2, [&](double u, double s) {
    const auto i = static_cast<std::size_t>(std::lround(u / (2 * pi) * static_cast<double>(n))) % n;
    const auto k = static_cast<std::size_t>(std::lround(3 * s));
    if (k == 0 || k == 3) return Vec3(0, 0, k == 0 ? low : high);
    return Vec3(outline[i][0], outline[i][1], k == 1 ? low : high);
  });
}

void gear(CloseFit& fit, Random& random) {
  const double module = random.uniform(2.5, 4);
  const int ta = 10 + random.below(10), tb = 12 + random.below(14);
  const double ra = module * ta / 2, rb = module * tb / 2, width = random.uniform(5, 15);
  fit.name = "gear";
  // a tooth of A points to -x, into a gap of B at +x
  fit.a = star_prism(gear_outline(ta, ra, module, .5 * fit.clearance, pi), -width, width);
  fit.b = star_prism(gear_outline(tb, rb, module, .5 * fit.clearance, pi / tb), -width, width);
  fit.fits.translation = {ra + rb + .25 * fit.clearance, 0, random.uniform(-.5, .5) * width};
}

void thread(CloseFit& fit, Random& random) {
  const double root = random.uniform(6, 9), deep = random.uniform(1, 2), pitch = random.uniform(2.5, 4);
  const auto ridge = [=](double u, double z) {
    const double turn = z / pitch - u / (2 * pi), share = turn - std::floor(turn);
    return root + deep * (1 - std::abs(2 * share - 1));
  };
  const double nut = random.uniform(2, 4) * pitch, c = fit.clearance;
  const auto layers = static_cast<std::size_t>(std::lround(nut / pitch * 8));
  fit.name = "thread";
  fit.a = ring(ridge, 0, -.5 * nut, 1.5 * nut, 24, 2 * layers);
  fit.b = ring([=](double u, double z) { return ridge(u, z) + 1.6 * c; }, 20, 0, nut, 24, layers);
  fit.fits.translation = {0, 0, 0};
}

bool collide(const TriangleSurface& a, const TriangleSurface& b, const Placement& pose) {
  return geometry::surfaces_cross(geometry::build_slab_tree(a), geometry::build_slab_tree(b), pose);
}

}  // namespace

CloseFit close_fit(int kind, bool straight, std::uint64_t seed) {
  using Make = void (*)(CloseFit&, Random&);
  constexpr std::array<Make, fit_kinds> kinds{shaft, key, lid, gear, thread};
  Random random(1000 * seed + static_cast<std::uint64_t>(kind));
  for (;;) {
    CloseFit fit;
    fit.clearance = random.uniform(.05, .4);
    fit.straight = straight;
    kinds[static_cast<std::size_t>(kind)](fit, random);
    if (collide(fit.a, fit.b, fit.fits)) continue;
    const Vec3 centre = volume_centroid(fit.a);
    const double size = fit.clearance + random.uniform(.1, .5);
    Vec3 shift = size * random.direction(), turn = Vec3::Zero();
    if (!straight) {
      turn = size / reach(fit.a, centre) * random.direction();
      shift *= random.uniform();
    }
    const depth::RigidMotion motion{depth::rotation_of(turn), shift};
    fit.a_in_b = depth::moved(fit.fits, motion, centre);
    for (const Vec3& x : fit.a.points) fit.push = std::max(fit.push, (fit.a_in_b(x) - fit.fits(x)).norm());
    if (collide(fit.a, fit.b, fit.a_in_b)) return fit;
  }
}

}  // namespace brunt::test
