// SPDX-License-Identifier: Apache-2.0
// Faces of more than three corners, read from OBJ text: areas, sense and the choice of diagonals.
#include "io/surface/polygons.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <numbers>

#include "io/surface/surface_file.hpp"
#include "support/surface_samples.hpp"

using namespace brunt;

namespace {

double volume(const TriangleSurface& surface) {
  double sum = 0;
  const auto x = [&](LocalIndex i) { return surface.points[static_cast<std::size_t>(i)]; };
  for (const auto& [a, b, c] : surface.triangles) sum += x(a).dot(x(b).cross(x(c))) / 6;
  return sum;
}

double area(const TriangleSurface& surface) {
  double sum = 0;
  const auto x = [&](LocalIndex i) { return surface.points[static_cast<std::size_t>(i)]; };
  for (const auto& [a, b, c] : surface.triangles) sum += (x(b) - x(a)).cross(x(c) - x(a)).norm() / 2;
  return sum;
}

TriangleSurface read(const std::string& text) {
  return io::parse_surface(text, "a.obj", io::SurfaceFormat::obj).surface;
}

}  // namespace

TEST_CASE("Concave faces are split inside their outline") {
  const TriangleSurface surface = read(test::obj(test::l_surface()));
  CHECK(surface.triangles.size() == 20);
  CHECK(volume(surface) == Approx(3).epsilon(1e-14));
  CHECK(area(surface) == Approx(14).epsilon(1e-14));
}

TEST_CASE("A quadrilateral is split along its shorter diagonal, or the one that lies inside") {
  using Triangles = std::vector<std::array<LocalIndex, 3>>;
  const auto triangles = [](const std::string& points) { return read(points + "f 1 2 3 4\n").triangles; };
  const Triangles along_13 = {{0, 1, 3}, {1, 2, 3}}, along_02 = {{0, 1, 2}, {0, 2, 3}};
  CHECK(triangles("v 0 0 0\nv 3 0 0\nv 4 1 0\nv 1 1 0\n") == along_13);
  CHECK(triangles("v 1 0 0\nv 4 0 0\nv 3 1 0\nv 0 1 0\n") == along_02);
  CHECK(triangles("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n") == along_02);
  CHECK(triangles("v 0 0 0\nv 4 1 0\nv 1 1 0\nv 1 4 0\n") == along_02);   // concave at the third point
  CHECK(triangles("v 4 1 0\nv 1 1 0\nv 1 4 0\nv 0 0 0\n") == along_13);   // and at the second
  CHECK(triangles("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 .1 0\n") == along_13);  // a straight corner
}

TEST_CASE("Polygons with straight sides and many concave corners keep area and sense") {
  // a comb of 2 n + 2 corners in an inclined plane, with corners on its straight side
  const auto comb = [](int teeth, const Mat3& rotation) {
    test::PolygonSurface surface;
    std::vector<LocalIndex> face;
    const auto add = [&](double x, double y) {
      face.push_back(static_cast<LocalIndex>(surface.points.size()));
      surface.points.push_back(rotation * Vec3(x, y, 0) + Vec3(5, 6, 7));
    };
    for (int k = 0; k <= 2 * teeth; ++k) add(k, 0);
    for (int k = 2 * teeth; k >= 0; --k) add(k, k % 2 == 0 ? 10 : 1);
    surface.faces = {face};
    return surface;
  };
  const Mat3 turned = Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  for (const Mat3& rotation : {Mat3(Mat3::Identity()), turned})
    for (const int teeth : {1, 2, 7, 300}) {
      const TriangleSurface surface = read(test::obj(comb(teeth, rotation)));
      CHECK(surface.triangles.size() == static_cast<std::size_t>(4 * teeth));
      const Vec3 normal = rotation.col(2);
      double sum = 0, least = 1e9;
      for (const auto& [a, b, c] : surface.triangles) {
        const auto x = [&](LocalIndex i) { return surface.points[static_cast<std::size_t>(i)]; };
        const double part = normal.dot((x(b) - x(a)).cross(x(c) - x(a))) / 2;
        sum += part;
        least = std::min(least, part);
      }
      CHECK(sum == Approx(11. * teeth).epsilon(1e-12));
      CHECK(least > 0.1);
    }
}

TEST_CASE("A polygon with a bridge to its hole is split, and one of 100,000 corners too") {
  const std::string ring =
      "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 0 0 0\nv 1 1 0\nv 1 2 0\nv 2 2 0\nv 2 1 0\nv 1 1 0\nf 1 2 3 4 5 6 7 8 9 "
      "10\n";
  const TriangleSurface surface = read(ring);
  CHECK(surface.triangles.size() == 8);
  CHECK(area(surface) == Approx(8).epsilon(1e-14));
  test::PolygonSurface circle;
  circle.faces.resize(1);
  constexpr LocalIndex count = 100'000;
  for (LocalIndex k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * k / count;
    circle.points.emplace_back(std::cos(angle), std::sin(angle), 0);
    circle.faces[0].push_back(k);
  }
  CHECK(area(read(test::obj(circle))) == Approx(std::numbers::pi).epsilon(1e-8));
}
