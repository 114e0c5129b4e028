// SPDX-License-Identifier: Apache-2.0
// What holds for every shell: rigid motions, balance, order of corners, rank, the bound of the step.
#include <catch2/catch.hpp>
#include <numbers>

#include "element/shell3.hpp"
#include "element/shell4.hpp"
#include "element/shell4_full.hpp"
#include "material/elastic.hpp"
#include "support/shell_bench.hpp"

using namespace brunt;
using element::HourglassKind;
using element::ShellSection;
using material::ElasticResponse;
using test::Matrix;
using test::ShellBench;
using Vector = Eigen::Vector3d;

namespace {

constexpr double young = 1, poisson = 0.3;
using Quad1 = element::Shell4<ElasticResponse>;
using Quad4 = element::Shell4Full<ElasticResponse>;
using Triangle = element::Shell3<ElasticResponse>;

/// h = 0.1, three points of Gauss, elastic hourglass springs.
ShellSection section(double offset = 0) {
  ShellSection s;
  s.thickness = 0.1;
  s.points = 3;
  s.offset = offset;
  return s;
}

template <class Kernel>
Kernel kernel_of(const ShellSection& section, HourglassKind kind = HourglassKind::elastic, double nu = poisson) {
  const ElasticResponse law({1, young, nu});
  if constexpr (requires { Kernel{law, section, element::Hourglass{}}; })
    return {law, section, {kind, 0.05}};
  else
    return {law, section};
}

template <int nodes>
using Field = Eigen::Matrix<double, 3, nodes>;

Matrix cross_matrix(const Vector& w) {
  return (Matrix() << 0, -w[2], w[1], w[2], 0, -w[0], -w[1], w[0], 0).finished();
}
/// The rotation with Cayley's vector w.
Matrix cayley(const Vector& w) {
  const Matrix W = 0.5 * cross_matrix(w);
  return (Matrix::Identity() - W).inverse() * (Matrix::Identity() + W);
}

/// A square or right triangle of edge 1, its corners moved by up to `skew` in the plane and `warp` normal to it.
template <int nodes>
Field<nodes> flat_element(std::mt19937& engine, double skew, double warp = 0) {
  std::uniform_real_distribution<double> any(-1, 1);
  const double corner[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  Field<nodes> x;
  for (int c = 0; c < nodes; ++c)
    x.col(c) << corner[c][0] + skew * any(engine), corner[c][1] + skew * any(engine), warp * any(engine);
  return x;
}

Matrix random_rotation(std::mt19937& engine) {
  const Matrix m = test::random_matrix(engine, 2);
  return cayley({m(0, 1), m(1, 2), m(2, 0)});
}

template <int nodes>
Field<nodes> random_field(std::mt19937& engine, double size) {
  std::uniform_real_distribution<double> any(-size, size);
  Field<nodes> u;
  for (double& entry : u.reshaped()) entry = any(engine);
  return u;
}

/// Area of which a fibre has a share, as the kernels integrate.
template <class Kernel>
double area(const Field<Kernel::nodes>& x, int fibre) {
  if constexpr (Kernel::nodes == 3) return 0.5 * Vector(x.col(1) - x.col(0)).cross(Vector(x.col(2) - x.col(0))).norm();
  const double at = Kernel::fibres == 1 ? 0 : 1 / std::sqrt(3.0);
  const double xi = fibre == 1 || fibre == 2 ? at : -at, eta = fibre > 1 ? at : -at;
  const Vector a = (1 - eta) * (x.col(1) - x.col(0)) + (1 + eta) * (x.col(2) - x.col(3));
  const Vector b = (1 - xi) * (x.col(3) - x.col(0)) + (1 + xi) * (x.col(2) - x.col(1));
  return a.cross(b).norm() / (4 * Kernel::fibres);
}

/// Random stresses; with them forces of hourglass modes and the like.
template <class Bench>
void load(Bench& bench, std::mt19937& engine, double size, bool all = true) {
  std::uniform_real_distribution<double> any(-size, size);
  const std::size_t from = Bench::KernelType::Memory::at_stress;
  const std::size_t to =
      all ? bench.history.size() : from + 5 * std::size_t(bench.kernel.section.points * Bench::KernelType::fibres);
  for (std::size_t k = from; k < to; ++k) bench.history[k] = broadcast(any(engine));
}

}  // namespace

TEMPLATE_TEST_CASE("a rigid rotation by 90 degrees in 100 steps leaves stresses in the axes of the shell", "", Quad1,
                   Triangle, Quad4) {
  constexpr int nodes = TestType::nodes;
  std::mt19937 engine(1);
  for (int sample = 0; sample < 12; ++sample) {
    Field<nodes> x = flat_element<nodes>(engine, 0.2, sample % 2 ? 0.2 : 0);
    ShellBench<TestType> bench(kernel_of<TestType>(section(sample % 3 ? 0 : 0.4)), x, 1);
    load(bench, engine, 1e-2);
    const std::vector<Pack> before = bench.history;
    const Vector axes[] = {{0, 0, 1}, {1, 0, 0}, {0.6, -0.8, 0}, {1, -2, 0.5}};
    const Vector w = 2 * std::tan(std::numbers::pi / 400) * axes[sample % 4].normalized();
    const Vector shift(0.01, 0.02, -0.03);
    for (int step = 0; step < 100; ++step) {
      const Field<nodes> next = (cayley(w) * x).colwise() + shift;
      const auto answer = bench.move(next, next - x, w.replicate<1, nodes>());
      x = next;
      CHECK(answer.rate > 0);
    }
    double largest = 0;
    for (std::size_t k = element::at_rotary_inertia + 1; k + 1 < before.size(); ++k)
      largest = std::max(largest, std::abs(bench.history[k][0] - before[k][0]));
    CHECK(largest < 1e-12);
  }
}

TEMPLATE_TEST_CASE("forces and moments of any stress have neither resultant nor moment", "", Quad1, Triangle, Quad4) {
  constexpr int nodes = TestType::nodes;
  std::mt19937 engine(2);
  for (int sample = 0; sample < 20; ++sample) {
    const Field<nodes> x = random_rotation(engine) * flat_element<nodes>(engine, 0.3, 0.3);
    ShellSection s = section(sample % 3 ? 0 : -0.3);
    s.warping = sample % 2 == 0;
    ShellBench<TestType> bench(kernel_of<TestType>(s), x, 1);
    load(bench, engine, 1);
    const auto answer = bench.rest(x);
    Vector moment = answer.moment.rowwise().sum();
    for (int c = 0; c < nodes; ++c) moment += Vector(x.col(c)).cross(Vector(answer.force.col(c)));
    CHECK(answer.force.cwiseAbs().maxCoeff() > 1e-3);
    CHECK(answer.force.rowwise().sum().norm() < 1e-13);
    CHECK(moment.norm() < 1e-13);
  }
}

TEMPLATE_TEST_CASE("forces do not depend on which corner is the first, nor on the side of the normal", "", Quad1,
                   Triangle, Quad4) {
  constexpr int nodes = TestType::nodes;
  std::mt19937 engine(3);
  for (int sample = 0; sample < 8; ++sample) {
    const Field<nodes> X = random_rotation(engine) * flat_element<nodes>(engine, 0.2, 0.2);
    Eigen::Matrix<int, nodes, 1> turned, mirrored;
    for (int c = 0; c < nodes; ++c) {
      turned[c] = (c + 1 + sample % (nodes - 1)) % nodes;
      mirrored[c] = (nodes - c) % nodes;
    }
    const auto pick = [](const Field<nodes>& u, const auto& order) { return Field<nodes>(u(Eigen::all, order)); };
    const auto kernel = kernel_of<TestType>(section());
    ShellBench<TestType> bench(kernel, X, 1), other(kernel, pick(X, turned), 1), back(kernel, pick(X, mirrored), 1);
    Field<nodes> x = X;
    for (int step = 0; step < 3; ++step) {
      const Field<nodes> v = random_field<nodes>(engine, 0.05), r = random_field<nodes>(engine, 0.1);
      x += v;
      const auto answer = bench.move(x, v, r);
      const auto shifted = other.move(pick(x, turned), pick(v, turned), pick(r, turned));
      const auto reversed = back.move(pick(x, mirrored), pick(v, mirrored), pick(r, mirrored));
      CHECK((shifted.force - pick(answer.force, turned)).norm() < 1e-14);
      CHECK((shifted.moment - pick(answer.moment, turned)).norm() < 1e-14);
      CHECK((reversed.force - pick(answer.force, mirrored)).norm() < 1e-14);
      CHECK((reversed.moment - pick(answer.moment, mirrored)).norm() < 1e-14);
      CHECK(shifted.rate == Approx(answer.rate).epsilon(1e-12));
    }
  }
}

TEMPLATE_TEST_CASE("the power of the forces is that of the stresses", "", Quad1, Triangle, Quad4) {
  constexpr int nodes = TestType::nodes;
  std::mt19937 engine(4);
  for (int sample = 0; sample < 10; ++sample) {
    const Field<nodes> x = random_rotation(engine) * flat_element<nodes>(engine, 0.2, 0.2);
    const auto kernel = kernel_of<TestType>(section(sample % 2 ? 0.2 : 0), HourglassKind::none);
    ShellBench<TestType> bench(kernel, x, 1), strained(kernel, x, 1);
    const Field<nodes> v = random_field<nodes>(engine, 1), r = random_field<nodes>(engine, 1);
    // The stress of Hooke's law after a short time tells the strain rates, without any stress power of the kernel.
    const double dt = 1e-8;
    strained.move(x + 0.5 * dt * v, v, r, dt);
    load(bench, engine, 1, false);
    const auto answer = bench.rest(x);
    const double power = answer.force.cwiseProduct(v).sum() + answer.moment.cwiseProduct(r).sum();
    double expected = 0;
    const int points = kernel.section.points, fibres = TestType::fibres;
    const element::ThicknessPoints& rule = element::thickness_points(kernel.section);
    for (int p = 0; p < fibres * points; ++p) {
      const Pack* s = &bench.history[TestType::Memory::at_stress + 5 * static_cast<std::size_t>(p)];
      const Pack* t = &strained.history[TestType::Memory::at_stress + 5 * static_cast<std::size_t>(p)];
      const auto of = [&](int c) { return t[c][0] / dt; };
      const double xx = (of(0) - poisson * of(1)) / young, yy = (of(1) - poisson * of(0)) / young;
      const double two_mu = young / (1 + poisson);
      double density = s[0][0] * xx + s[1][0] * yy + 2 * s[2][0] * of(2) / two_mu;
      density += 5.0 / 6 * 2 * (s[3][0] * of(3) + s[4][0] * of(4)) / two_mu;
      expected += rule.weight[p % points] * density * area<TestType>(x, p / points);
    }
    CHECK(power == Approx(-0.1 * expected).epsilon(1e-6));
  }
}

// Constant states on a flat quadrilateral or triangle of any form. The forces on the corners are then those of the
// resultants on the edges, shared equally by the ends of each edge, so that they balance in any mesh.
TEMPLATE_TEST_CASE("constant membrane strain and constant bending are exact on flat skewed elements", "", Quad1,
                   Triangle, Quad4) {
  constexpr int nodes = TestType::nodes;
  std::mt19937 engine(7);
  for (int sample = 0; sample < 20; ++sample) {
    const Field<nodes> x = flat_element<nodes>(engine, 0.3);
    const bool bends = sample % 2;
    Matrix e = Matrix::Zero();
    e.topLeftCorner<2, 2>() = test::random_matrix(engine, 1e-3).topLeftCorner<2, 2>();
    e = (0.5 * (e + e.transpose())).eval();
    Field<nodes> u = Field<nodes>::Zero(), r = u;
    if (bends)
      for (int c = 0; c < nodes; ++c) {
        const Vector slope = e * x.col(c);  // w = x . e x/2 gives the curvature -e: p = (r_y, -r_x) is minus the slope
        u(2, c) = 0.5 * x.col(c).dot(slope);
        r.col(c) << slope[1], -slope[0], 0;
      }
    else
      u = e * x;
    // In a step to x of vanishing size: the elements are linear in the velocities.
    const double size = 1e-9;
    ShellBench<TestType> bench(kernel_of<TestType>(section()), x, 1);
    const auto answer = bench.move(x, size * u, size * r);
    const double lambda = young * poisson / (1 - poisson * poisson), two_mu = young / (1 + poisson);
    Matrix stress = two_mu * e;
    stress.topLeftCorner<2, 2>() += lambda * e.trace() * Eigen::Matrix2d::Identity();
    const double h = 0.1;
    const Matrix resultant = bends ? Matrix(-h * h * h / 12 * stress) : Matrix(h * stress);
    Field<nodes> expected = Field<nodes>::Zero();
    for (int c = 0; c < nodes; ++c) {
      const Vector edge = x.col((c + 1) % nodes) - x.col(c), along = resultant * Vector(edge[1], -edge[0], 0);
      const Vector of_end = bends ? Vector(-along[1], along[0], 0) : along;  // moments n x F
      expected.col(c) -= 0.5 * size * of_end;
      expected.col((c + 1) % nodes) -= 0.5 * size * of_end;
    }
    const Field<nodes>&right = bends ? answer.moment : answer.force, &zero = bends ? answer.force : answer.moment;
    CHECK(expected.norm() > 1e-17);
    CHECK((right - expected).norm() < 1e-10 * expected.norm());
    CHECK(zero.norm() < 1e-10 * h * size * e.norm());  // rounding of the shears, not of the moments
  }
}

TEMPLATE_TEST_CASE("only the six rigid modes have no energy", "", Quad1, Triangle, Quad4) {
  constexpr int nodes = TestType::nodes;
  std::mt19937 engine(5);
  for (const double warp : {0.0, 0.2}) {
    const Field<nodes> x = flat_element<nodes>(engine, 0.2, warp);
    ShellBench<TestType> bench(kernel_of<TestType>(section()), x, 1);
    const Eigen::VectorXd found = test::eigenvalues(bench.reduced(bench.stiffness(x)));
    INFO(found.head(8).transpose());
    CHECK(found.head(6).cwiseAbs().maxCoeff() < 1e-7);
    CHECK(found[6] > 1e-4);
  }
}

TEMPLATE_TEST_CASE("the rate bounds the largest frequency, and is near to it where the element is not distorted", "",
                   Quad1, Triangle, Quad4) {
  constexpr int nodes = TestType::nodes;
  std::mt19937 engine(6);
  double least = 2, least_loaded = 2, most_regular = 0, most_flat = 0;
  for (int sample = 0; sample < 100; ++sample) {
    const bool warped = sample % 3 == 2;
    const double skew = 0.002 * sample;
    Field<nodes> x = flat_element<nodes>(engine, skew, warped ? 0.3 : 0);
    x.row(0) *= sample % 5 == 1 ? 4 : 1;
    ShellSection s = section(sample % 4 == 3 ? 0.5 : 0);
    s.thickness = sample % 7 == 0 ? 0.6 : 0.05;
    const double nu = sample % 2 ? 0.3 : 0.45;
    ShellBench<TestType> bench(kernel_of<TestType>(s, HourglassKind::elastic, nu), x, 1);
    const double exact = std::sqrt(test::eigenvalues(bench.reduced(bench.stiffness(x))).maxCoeff()) / 2;
    const double ratio = bench.rest(x).rate / exact;
    load(bench, engine, 0.1, false);  // initial stress
    const double loaded = std::sqrt(test::eigenvalues(bench.reduced(bench.stiffness(x))).maxCoeff()) / 2;
    least_loaded = std::min(least_loaded, bench.rest(x).rate / loaded);
    least = std::min(least, ratio);
    if (skew < 0.01 && !warped) most_regular = std::max(most_regular, ratio);
    if (skew < 0.08 && !warped && sample % 5 != 1) most_flat = std::max(most_flat, ratio);
  }
  INFO(least << " " << least_loaded << " " << most_regular << " " << most_flat);
  CHECK(least >= 1 - 1e-6);  // differences
  CHECK(least_loaded >= 1);
  CHECK(most_regular < 1.1);
  CHECK(most_flat < 1.25);
}
