// SPDX-License-Identifier: Apache-2.0
// Tunnelling (case E7): shots built backwards from their meeting, and misses against independent searches.
#include "geometry/first_contact.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <vector>

#include "shots.hpp"

using brunt::Vec3;
using namespace brunt::geometry;
using namespace brunt::geometry::testing;

namespace {

constexpr double degree = 3.14159265358979323846 / 180;

struct Tally {
  int missed = 0, earlier = 0, wrong = 0;
  double worst_tau = 0, worst_place = 0;
};

double residual(const MovingPoint& p, const MovingFace& face, const FirstContact& hit) {
  const auto at = corners_at(face, hit.tau);
  return (point_at({at.data(), face.start.size()}, hit.xi, hit.eta) - ((1 - hit.tau) * p.start + hit.tau * p.end))
      .norm();
}

/// A meeting before the one that was built must be a true one as well: on the face, and inward.
void count(Tally& tally, const MovingPoint& p, const MovingFace& face, double xi, double eta, double tau) {
  const auto hit = first_contact(p, face);
  if (!hit) {
    ++tally.missed;
    return;
  }
  const Vec3 face_motion = point_at(face.end, hit->xi, hit->eta) - point_at(face.start, hit->xi, hit->eta);
  const bool approaching = (p.end - p.start - face_motion).dot(hit->normal) < 0;
  if (!approaching || residual(p, face, *hit) > 1e-5 * face_tolerance || hit->tau > tau + 1e-9) ++tally.wrong;
  if (hit->tau < tau - 1e-9) {
    ++tally.earlier;
    return;
  }
  tally.worst_tau = std::max(tally.worst_tau, std::abs(hit->tau - tau));
  tally.worst_place = std::max({tally.worst_place, std::abs(hit->xi - xi), std::abs(hit->eta - eta)});
}

Tally shoot(std::size_t corners, int shots, double warp, double turn, double shift, double angle) {
  Random random(11);
  Tally tally;
  for (int i = 0; i < shots; ++i) {
    const Quadrilateral q = random_face(random, corners, warp, turn, shift);
    double xi = between(random, -0.999, 0.999), eta = between(random, -0.999, 0.999);
    if (corners == 3) {
      xi = between(random, 0.001, 0.998);
      eta = between(random, 0, 0.999 - xi);
    }
    const double tau = between(random, 0.001, 0.999);
    const Vec3 normal = normal_at(q.face(), xi, eta, tau);
    const double steep = angle > 0 ? angle : between(random, 5 * degree, 90 * degree);
    const Vec3 relative = between(random, 0.1, 5) * inward(random, normal, steep);
    count(tally, shot(q.face(), xi, eta, tau, relative), q.face(), xi, eta, tau);
  }
  return tally;
}

}  // namespace

TEST_CASE("10^4 shots on a warped quadrilateral that turns and moves: all found, to the instant") {
  const Tally tally = shoot(4, 10000, 0.2, 0.3, 3.0, 0);
  CHECK(tally.missed == 0);
  CHECK(tally.wrong == 0);
  CHECK(tally.earlier < 500);
  CHECK(tally.worst_tau < 1e-12);
  CHECK(tally.worst_place < 1e-11);
}

TEST_CASE("10^4 shots on a triangle that turns and moves") {
  const Tally tally = shoot(3, 10000, 0.2, 0.3, 3.0, 0);
  CHECK(tally.missed == 0);
  CHECK(tally.wrong == 0);
  CHECK(tally.earlier < 500);
  CHECK(tally.worst_tau < 1e-12);
  CHECK(tally.worst_place < 1e-11);
}

TEST_CASE("10^4 shots that graze the face at one degree") {
  for (const std::size_t corners : {std::size_t{3}, std::size_t{4}}) {
    const Tally tally = shoot(corners, 10000, 0.05, 0.05, 1.0, degree);
    CHECK(tally.missed == 0);
    CHECK(tally.wrong == 0);
    CHECK(tally.worst_tau < 1e-10);
  }
}

TEST_CASE("shots on strongly warped faces that turn by a right angle in the step are found") {
  const Tally tally = shoot(4, 3000, 0.6, 1.57, 2.0, 0);
  CHECK(tally.missed == 0);
  CHECK(tally.wrong == 0);
}

namespace {

/// A plate of `cells` x `cells` quadrilaterals a side, closed by rims, outward normals; thickness across z.
std::vector<std::array<Vec3, 4>> plate(int cells, double width, double thickness) {
  std::vector<std::array<Vec3, 4>> faces;
  const auto at = [&](int i, int j, double side) {
    return Vec3(width * i / cells - width / 2, width * j / cells - width / 2, side * thickness / 2);
  };
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      faces.push_back({at(i, j, 1), at(i + 1, j, 1), at(i + 1, j + 1, 1), at(i, j + 1, 1)});
      faces.push_back({at(i, j, -1), at(i, j + 1, -1), at(i + 1, j + 1, -1), at(i + 1, j, -1)});
    }
    const int n = cells;
    faces.push_back({at(i, 0, -1), at(i + 1, 0, -1), at(i + 1, 0, 1), at(i, 0, 1)});
    faces.push_back({at(i + 1, n, -1), at(i, n, -1), at(i, n, 1), at(i + 1, n, 1)});
    faces.push_back({at(0, i + 1, -1), at(0, i, -1), at(0, i, 1), at(0, i + 1, 1)});
    faces.push_back({at(n, i, -1), at(n, i + 1, -1), at(n, i + 1, 1), at(n, i, 1)});
  }
  return faces;
}

}  // namespace

TEST_CASE("10^4 shots right through a thin moving plate enter by the side they come from") {
  Random random(5);
  const double thickness = 0.5e-3;
  const auto rest = plate(4, 0.02, thickness);
  int wrong = 0;
  double worst = 0;
  for (int i = 0; i < 10000; ++i) {
    const brunt::Mat3 placed = random_rotation(random, between(random, 0, 3)),
                      turned = random_rotation(random, 0.02) * placed;
    const Vec3 move = random_vector(random, 1e-3);
    std::vector<Quadrilateral> faces(rest.size());
    for (std::size_t f = 0; f < rest.size(); ++f)
      for (std::size_t k = 0; k < 4; ++k) {
        faces[f].start[k] = placed * rest[f][k];
        faces[f].end[k] = turned * rest[f][k] + move;
      }
    const std::size_t wide_faces[] = {0, 1, 6, 7, 12, 13};
    const std::size_t target = wide_faces[random() % 6];
    REQUIRE(std::abs(rest[target][0].z() - rest[target][2].z()) < 1e-9);
    const double xi = between(random, -0.99, 0.99), eta = between(random, -0.99, 0.99),
                 tau = between(random, 0.05, 0.4);
    const MovingFace aim = faces[target].face();
    const double steep = i % 2 == 0 ? degree : between(random, 20 * degree, 90 * degree);
    const double speed = 3 * thickness / std::sin(steep);
    const MovingPoint p = shot(aim, xi, eta, tau, speed * inward(random, normal_at(aim, xi, eta, tau), steep));
    double first = 2;
    std::size_t met = faces.size();
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const auto hit = first_contact(p, faces[f].face());
      if (hit && hit->tau < first) {
        first = hit->tau;
        met = f;
      }
    }
    const bool beside_the_plate_first = steep == degree;  // a grazing path may come in through the rim
    if (met != target && !beside_the_plate_first) ++wrong;
    if (met == target) worst = std::max(worst, std::abs(first - tau));
    if (met == faces.size() || first > tau + 1e-9) ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(worst < 1e-10);
}

TEST_CASE("10^4 shots aimed at shared edges and vertices are claimed by a face each") {
  Random random(3);
  constexpr int n = 4;
  int missed = 0;
  double worst = 0;
  for (int trial = 0; trial < 10000; ++trial) {
    const bool triangles = trial % 2 == 1;
    const brunt::Mat3 placed = random_rotation(random, 2.0), turned = random_rotation(random, 0.1) * placed;
    const Vec3 move = random_vector(random, 1);
    std::array<std::array<MovingPoint, n>, n> grid;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const Vec3 x = Vec3(i, j, 0) + random_vector(random, 0.2);
        grid[i][j] = {placed * x, turned * x + move + random_vector(random, 0.05)};
      }
    const auto node = [&](int i, int j) -> const MovingPoint& { return grid[i][j]; };
    std::vector<Quadrilateral> faces;
    const auto add = [&](std::initializer_list<const MovingPoint*> corners) {
      Quadrilateral q;
      q.count = 0;
      for (const MovingPoint* corner : corners) {
        q.start[q.count] = corner->start;
        q.end[q.count++] = corner->end;
      }
      faces.push_back(q);
    };
    for (int i = 0; i + 1 < n; ++i)
      for (int j = 0; j + 1 < n; ++j) {
        if (triangles) {
          add({&node(i, j), &node(i + 1, j), &node(i + 1, j + 1)});
          add({&node(i, j), &node(i + 1, j + 1), &node(i, j + 1)});
        } else {
          add({&node(i, j), &node(i + 1, j), &node(i + 1, j + 1), &node(i, j + 1)});
        }
      }
    const double along = trial % 4 < 2 ? 0.0 : between(random, 0, 1);  // a vertex or a place on the edge
    const double tau = between(random, 0.001, 0.999);
    const auto at = [&](const MovingPoint& p, double t) { return Vec3((1 - t) * p.start + t * p.end); };
    const Vec3 place = (1 - along) * at(node(1, 1), tau) + along * at(node(2, 1), tau);
    const Vec3 carried =
        (1 - along) * (node(1, 1).end - node(1, 1).start) + along * (node(2, 1).end - node(2, 1).start);
    const Vec3 down = placed * Vec3(between(random, -0.3, 0.3), between(random, -0.3, 0.3), -1);
    const Vec3 motion = carried + between(random, 0.1, 1) * down;
    const MovingPoint p{place - tau * motion, place + (1 - tau) * motion};
    double first = 2;
    for (const Quadrilateral& q : faces)
      if (const auto hit = first_contact(p, q.face())) first = std::min(first, hit->tau);
    if (first > tau + 1e-9) ++missed;
    if (first > tau - 1e-6) worst = std::max(worst, std::abs(first - tau));
  }
  CHECK(missed == 0);
  CHECK(worst < 1e-9);
}

namespace {

using Real = long double;
using Real3 = Eigen::Matrix<Real, 3, 1>;

/// Earliest inward passage through a triangle: coplanarity sampled densely, roots bisected. 2 if there is none.
Real sampled_triangle(const MovingPoint& p, const MovingFace& face) {
  constexpr int samples = 400;
  const auto at = [](const Vec3& a, const Vec3& b, Real t) {
    return Real3((1 - t) * a.cast<Real>() + t * b.cast<Real>());
  };
  const auto height = [&](Real t, bool& inside) {
    const Real3 c0 = at(face.start[0], face.end[0], t), e1 = at(face.start[1], face.end[1], t) - c0,
                e2 = at(face.start[2], face.end[2], t) - c0, x = at(p.start, p.end, t) - c0, n = e1.cross(e2);
    const Real u = x.cross(e2).dot(n) / n.squaredNorm(), v = e1.cross(x).dot(n) / n.squaredNorm();
    inside = u >= 0 && v >= 0 && u + v <= 1;
    return x.dot(n);
  };
  bool inside = false;
  Real before = height(0, inside);
  for (int k = 1; k <= samples; ++k) {
    const Real after = height(Real(k) / samples, inside);
    if (before > 0 && after <= 0) {
      Real low = Real(k - 1) / samples, high = Real(k) / samples;
      for (int cut = 0; cut < 60; ++cut) {
        const Real middle = (low + high) / 2;
        (height(middle, inside) > 0 ? low : high) = middle;
      }
      height(high, inside);
      if (inside) return high;
    }
    before = after;
  }
  return 2;
}

/// Earliest inward passage through a quadrilateral: Newton's method from a dense grid of places and times. 2 for none.
Real many_starts(const MovingPoint& p, const MovingFace& face) {
  using Matrix = Eigen::Matrix<Real, 3, 3>;
  std::array<Real3, 4> c0, dc;
  for (std::size_t k = 0; k < 4; ++k) {
    c0[k] = (face.start[k] - p.start).cast<Real>();
    dc[k] = (face.end[k] - p.end).cast<Real>() - c0[k];
  }
  Real earliest = 2;
  const auto state = [&](const Real3& x, Real3& d, Matrix& j) {
    std::array<Real3, 4> c;
    for (std::size_t k = 0; k < 4; ++k) c[k] = c0[k] + x[2] * dc[k];
    const Real u = x[0], v = x[1];
    d = (1 - u) * (1 - v) * c[0] + u * (1 - v) * c[1] + u * v * c[2] + (1 - u) * v * c[3];
    j.col(0) = (1 - v) * (c[1] - c[0]) + v * (c[2] - c[3]);
    j.col(1) = (1 - u) * (c[3] - c[0]) + u * (c[2] - c[1]);
    j.col(2) = (1 - u) * (1 - v) * dc[0] + u * (1 - v) * dc[1] + u * v * dc[2] + (1 - u) * v * dc[3];
  };
  for (int start = 0; start < 4 * 4 * 8; ++start) {
    Real3 x(Real(start % 4) / 3, Real(start / 4 % 4) / 3, Real(start / 16) / 7), d;
    Matrix j;
    for (int step = 0; step < 12 && x.cwiseAbs().maxCoeff() < 4; ++step) {
      state(x, d, j);
      x -= j.inverse() * d;
    }
    state(x, d, j);
    const bool zero = d.norm() < Real(1e-12) && x.minCoeff() >= 0 && x.maxCoeff() <= 1;
    if (zero && j.determinant() > 0) earliest = std::min(earliest, x[2]);
  }
  return earliest;
}

template <class Oracle>
void compare_with(std::size_t corners, int trials, Oracle&& oracle) {
  Random random(19);
  int hits = 0, misses = 0, different = 0;
  for (int i = 0; i < trials; ++i) {
    const Quadrilateral q = random_face(random, corners, 0.4, between(random, 0, 1), 1.5);
    const MovingPoint p{random_vector(random, 2), random_vector(random, 2)};
    const auto hit = first_contact(p, q.face());
    const Real expected = oracle(p, q.face());
    if (hit && std::min({std::abs(hit->tau), std::abs(1 - hit->tau)}) < 1e-6) continue;
    if (hit && hit->region != Region::face) continue;
    if (hit.has_value() != (expected <= 1) || (hit && std::abs(Real(hit->tau) - expected) > 1e-9L)) ++different;
    ++(hit ? hits : misses);
  }
  CHECK(hits > trials / 50);
  CHECK(misses > trials / 20);
  CHECK(different == 0);
}

}  // namespace

TEST_CASE("random motions: hits and misses of triangles agree with dense sampling in long double") {
  compare_with(3, 2000, sampled_triangle);
}

TEST_CASE("random motions: hits and misses of quadrilaterals agree with Newton's method from many starts") {
  compare_with(4, 1500, many_starts);
}
