// SPDX-License-Identifier: Apache-2.0
#include "tests/depth/cases.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "tests/depth/box_unions.hpp"
#include "tests/support/depth_bodies.hpp"

namespace brunt::test {
namespace {

using Boxes = std::vector<geometry::Box>;

Shape shape_of(const Boxes& boxes) {
  return {surface_of_boxes(boxes), corners_of(boxes)};
}
Shape brick(const Vec3& half) {
  return shape_of({box_between(-half, half)});
}
Shape l_prism() {
  return shape_of({box_between({0, 0, -.6}, {2, .6, .6}), box_between({0, .6, -.6}, {.6, 2, .6})});
}
Shape l_prism_pieces() {  // pieces may overlap
  Shape shape = l_prism();
  shape.pieces = corners_of({box_between({0, 0, -.6}, {2, .6, .6}), box_between({0, 0, -.6}, {.6, 2, .6})});
  return shape;
}

Mat3 about(int axis, double degrees) {
  return turned_by(degrees * pi / 180 * Vec3::Unit(axis));
}

/// Block with the hole cut by `hole`, and pieces around it.
Shape plate_with_hole() {
  const double r = .25;
  return {surface_of_boxes({box_between({-4, -4, -.3}, {4, 4, .3})}, {box_between({-r, -r, -.3}, {r, r, .3})}),
          corners_of({box_between({-4, -4, -.3}, {-r, 4, .3}), box_between({r, -4, -.3}, {4, 4, .3}),
                      box_between({-4, -4, -.3}, {4, -r, .3}), box_between({-4, r, -.3}, {4, 4, .3})})};
}

Shape block_with_cross() {
  const double w = .25, l = 1.1;
  Boxes pieces{box_between({-2, l, -1}, {2, 2, 1}), box_between({-2, -2, -1}, {2, -l, 1}),
               box_between({l, -2, -1}, {2, 2, 1}), box_between({-2, -2, -1}, {-l, 2, 1})};
  for (const double x : {-1., 1.})
    for (const double y : {-1., 1.}) {
      const Vec3 p(x * w, y * w, -1), q(x * 2, y * 2, 1);
      pieces.push_back(box_between(p.cwiseMin(q), p.cwiseMax(q)));
    }
  return {surface_of_boxes({box_between({-2, -2, -1}, {2, 2, 1})},
                           {box_between({-l, -w, -1}, {l, w, 1}), box_between({-w, -l, -1}, {w, l, 1})}),
          corners_of(pieces)};
}

void add_small_boxes(std::vector<DepthCase>& cases) {
  const Shape cube = brick({1, 1, 1});
  for (const double d : {1.9, 1.5, 1.0, .5})
    cases.push_back(
        {"A1 cubes " + std::to_string(d), cube, cube, {Mat3::Identity(), {d, .13, .07}}, {2 - d, 2 - d, 0}, {}});
  const double turned_depth = 1 + std::sqrt(2.0) - 2.2;
  cases.push_back(
      {"A1 cubes, one turned", cube, cube, {about(2, 45), {2.2, 0, 0}}, {turned_depth, turned_depth, 0}, {}});
  cases.push_back({"A1 slender box on end",
                   brick({.5, .5, 5}),
                   brick({50, 50, 50}),
                   {Mat3::Identity(), {0, 0, 50 + 5 - 4.4}},
                   {4.4, 4.4, 3.680},
                   {}});
  const Mat3 R = turned(1, .3, .2, .1);
  const Vec3 half(.5, .3, .2);
  const double reach = R.row(2).cwiseAbs().dot(half);
  for (const auto& [d, rms] : {std::pair{.2, .106592229}, std::pair{.05, .029161862}, std::pair{.005, .003003623781}})
    cases.push_back({"A2 corner " + std::to_string(d),
                     brick(half),
                     brick({20, 20, 20}),
                     {R, {0, 0, 20 + reach - d}},
                     {d, d, rms},
                     {}});
  for (const auto& [d, rms] : {std::pair{.2, .108108221}, std::pair{.05, .027024835}, std::pair{.005, .002702175}})
    cases.push_back({"A3 beam " + std::to_string(d),
                     brick({5, .5, .25}),
                     shape_of({box_between({4.5, -3, -4}, {7, 3, 0})}),
                     {Mat3::Identity(), {0, 0, .25 - d}},
                     {d, d, rms},
                     {}});
}

}  // namespace

Mat3 turned(double w, double x, double y, double z) {
  return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
}

Mat3 turned_by(const Vec3& v) {
  const double angle = v.norm();
  return angle > 0 ? Eigen::AngleAxisd(angle, v / angle).toRotationMatrix() : Mat3(Mat3::Identity());
}

std::vector<DepthCase> closed_forms() {
  std::vector<DepthCase> cases;
  add_small_boxes(cases);
  cases.push_back({"A4 peg",
                   brick({.2, .2, 1}),
                   plate_with_hole(),
                   {about(1, 20), Vec3::Zero()},
                   {1.00678, .195512726, .112879325},
                   {.9866, .1916, .1103}});
  const Boxes cross{box_between({-1, -.2, -1.5}, {1, .2, 1.5}), box_between({-.2, -1, -1.5}, {.2, 1, 1.5})};
  cases.push_back({"A5 cross",
                   shape_of(cross),
                   block_with_cross(),
                   {about(2, 15), Vec3::Zero()},
                   {2.5, .215312620, .130530134},
                   {2.45, .2110, .1279}});
  cases.push_back({"A6 box in L",
                   brick({.5, .5, .4}),
                   l_prism_pieces(),
                   {Mat3::Identity(), {.9, .95, 0}},
                   {.25, .25, .25},
                   {.245, .245, .245}});
  return cases;
}

std::vector<DepthCase> interlocked_boxes() {
  std::vector<DepthCase> cases;
  const Shape l = l_prism_pieces();
  const Vec3 centroid = volume_centroid(l.surface);
  const Mat3 half_turn = about(2, 180) * turned_by({.1, -.15, .2});
  cases.push_back({"B1 two L",
                   l,
                   l,
                   {half_turn, Vec3(1.688235, 1.688235, .2) - half_turn * centroid},
                   {.366332, .366332, .26304},
                   {.3590, .3576, .2553}});
  cases.push_back({"B2 box in L",
                   brick({.5, .5, .4}),
                   l,
                   {turned_by(12 * pi / 180 * Vec3(1, 1, 1).normalized()), {.95, 1.0, .05}},
                   {.321099, .279448, .19726},
                   {.3147, .2739, .1959}});
  const Shape u = shape_of({box_between({-1, -.3, -1}, {1, .3, -.5}), box_between({-1, -.3, -1}, {-.6, .3, 1}),
                            box_between({.6, -.3, -1}, {1, .3, 1})});
  Mat3 F;
  F << 0, 1, 0, 1, 0, 0, 0, 0, -1;
  cases.push_back({"B3 two U", u, u, {F, {0, 0, -1.2}}, {.2, .2, .2}, {.196, .1945, .1848}});
  cases.push_back({"B4 two U, turned",
                   u,
                   u,
                   {turned_by({.2, .3, .25}) * F, {.1, .05, -1.2}},
                   {.407732, .407631, .323653},
                   {.3996, .3995, .3056}});
  const Shape ring = shape_of({box_between({-1, -1, -.2}, {1, -.5, .2}), box_between({-1, .5, -.2}, {1, 1, .2}),
                               box_between({-1, -1, -.2}, {-.5, 1, .2}), box_between({.5, -1, -.2}, {1, 1, .2})});
  F << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  cases.push_back({"B5 two rings", ring, ring, {F, {1.2, 0, 0}}, {.2, .2, .2}, {.196, .1938, .1797}});
  cases.push_back({"B6 two rings, turned",
                   ring,
                   ring,
                   {turned_by({.5, .1, .1}) * F, {1.15, .03, .05}},
                   {.196271, .196271, .179940},
                   {.1923, .1919, .1558}});
  const Shape jack = shape_of({box_between({-1, -.3, -.3}, {1, .3, .3}), box_between({-.3, -1, -.3}, {.3, 1, .3}),
                               box_between({-.3, -.3, -1}, {.3, .3, 1})});
  cases.push_back({"B7 two jacks",
                   jack,
                   jack,
                   {turned_by(35 * pi / 180 * Vec3(1, 2, 3).normalized()), {.7, .5, .3}},
                   {.629725, .629534, .458761},
                   {.6171, .6148, .4433}});
  return cases;
}

std::vector<DepthCase> mesh_pairs() {
  struct Line {
    int pair;
    double q[4], t[3], depth[3];
  };
  const Line lines[] = {{0, {1, 2, 0, -5}, {.40, .95, .20}, {.7664, .14437, .06540}},
                        {0, {-5, 1, -3, -5}, {1.20, -.75, -.15}, {.5705, .15596, .10924}},
                        {0, {4, -3, 2, -3}, {-2.15, 1.60, .30}, {.7260, .24747, .15725}},
                        {0, {1, 1, -4, 1}, {.60, -.20, .15}, {1.0687, .43881, .19790}},
                        {0, {2, 3, 5, 1}, {-.60, -1.40, 0}, {.7565, .56586, .51948}},
                        {1, {-5, -5, -2, 5}, {.85, .60, .70}, {.8144, .66399, .62162}},
                        {1, {5, -1, -2, 4}, {.55, -.15, -.40}, {1.0050, .99973, .77526}},
                        {1, {-5, -1, 1, -3}, {.20, .20, -.25}, {1.1876, 1.17502, 1.00166}},
                        {1, {2, -5, 4, -3}, {-.20, -1.00, 1.15}, {.6593, .56898, .41340}},
                        {2, {-2, 3, 3, 4}, {-.30, -2.15, 0}, {1.3486, 1.32085, 1.10982}},
                        {2, {-2, 5, 0, 3}, {-1.00, -1.35, .55}, {1.1582, 1.15800, .75520}},
                        {2, {4, 3, -3, 0}, {1.25, 1.80, -.30}, {1.1008, 1.10036, .87667}},
                        {2, {2, -2, 4, 3}, {.65, -2.40, -.05}, {.8824, .87601, .77174}}};
  const Shape moving[] = {{l_shape(), {}}, {pawn(), {}}, {mallet(), {}}};
  const Shape fixed[] = {{knot(), {}}, {hub(), {}}, {bumpy_sphere(), {}}};
  const char* names[] = {"L/knot", "pawn/hub", "mallet/bumpy"};
  std::vector<DepthCase> cases;
  for (const Line& line : lines)
    cases.push_back({names[line.pair],
                     moving[line.pair],
                     fixed[line.pair],
                     {turned(line.q[0], line.q[1], line.q[2], line.q[3]), Vec3(line.t[0], line.t[1], line.t[2])},
                     {line.depth[0], line.depth[1], line.depth[2]},
                     {}});
  return cases;
}

}  // namespace brunt::test
