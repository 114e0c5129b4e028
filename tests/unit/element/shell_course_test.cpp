// SPDX-License-Identifier: Apache-2.0
// The obstacle course of shells, statically: the stiffness of the kernels by differences, assembled and solved.
// T. Belytschko, H. Stolarski, W. K. Liu, N. Carpenter, J. S. J. Ong, Comput. Methods Appl. Mech. Eng. 51 (1985) 221
// (roof of Scordelis and Lo, pinched cylinder, hemisphere); R. H. MacNeal, R. L. Harder, Finite Elem. Anal. Des. 1
// (1985) 3 (twisted beam). Deflections over those of the references; SHOW=1 in the environment prints 4 to 32 elements
// a side.
#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <functional>
#include <numbers>

#include "element/shell3.hpp"
#include "element/shell4.hpp"
#include "element/shell4_full.hpp"
#include "material/elastic.hpp"
#include "support/shell_bench.hpp"

using namespace brunt;
using material::ElasticResponse;
using test::ShellBench;
using Vector = Eigen::Vector3d;

namespace {

/// Nodes (i, j) of a grid of `across` x `along` quadrilaterals.
struct Grid {
  int across, along;
  [[nodiscard]] int node(int i, int j) const { return j * (across + 1) + i; }
  [[nodiscard]] int nodes() const { return (across + 1) * (along + 1); }
};

struct Unknowns {
  std::vector<char> held;  ///< six for each node: displacements, rotations
  Eigen::VectorXd load;

  void hold(int node, std::initializer_list<int> components) {
    for (const int c : components) held[static_cast<std::size_t>(6 * node + c)] = 1;
  }
  /// The node lies in a plane of symmetry normal to `axis`.
  void mirror(int node, int axis) { hold(node, {axis, 3 + (axis + 1) % 3, 3 + (axis + 2) % 3}); }
};

struct Obstacle {
  const char* name;
  double young, poisson, thickness, deflection;
  double narrowness = 1;                       ///< elements across over those along
  double weight = 0;                           ///< by area, along -z
  std::function<Vector(double, double)> at{};  ///< 0 to 1 across and along
  std::function<void(const Grid&, Unknowns&)> set{};
  std::function<double(const Grid&, const Eigen::VectorXd&)> measure{};
};

Obstacle roof() {
  Obstacle o{"roof", 4.32e8, 0, 0.25, 0.3024, 1, 90};
  o.at = [](double s, double t) {
    const double angle = s * 40 * std::numbers::pi / 180;
    return Vector(25 * std::sin(angle), 25 * t, 25 * std::cos(angle));
  };
  o.set = [](const Grid& g, Unknowns& u) {
    for (int j = 0; j <= g.along; ++j) u.mirror(g.node(0, j), 0);
    for (int i = 0; i <= g.across; ++i) {
      u.mirror(g.node(i, 0), 1);
      u.hold(g.node(i, g.along), {0, 2});
    }
  };
  o.measure = [](const Grid& g, const Eigen::VectorXd& u) { return -u[6 * g.node(g.across, 0) + 2]; };
  return o;
}

Obstacle cylinder() {
  Obstacle o{"cylinder", 3e6, 0.3, 3, 1.8248e-5};
  o.at = [](double s, double t) {
    const double angle = s * std::numbers::pi / 2;
    return Vector(300 * std::sin(angle), 300 * t, 300 * std::cos(angle));
  };
  o.set = [](const Grid& g, Unknowns& u) {
    for (int j = 0; j <= g.along; ++j) {
      u.mirror(g.node(0, j), 0);
      u.mirror(g.node(g.across, j), 2);
    }
    for (int i = 0; i <= g.across; ++i) {
      u.mirror(g.node(i, 0), 1);
      u.hold(g.node(i, g.along), {0, 2});
    }
    u.load[2] = -0.25;
  };
  o.measure = [](const Grid&, const Eigen::VectorXd& u) { return -u[2]; };
  return o;
}

/// With a hole of 18 degrees.
Obstacle hemisphere() {
  Obstacle o{"hemisphere", 6.825e7, 0.3, 0.04, 0.0924};
  o.at = [](double s, double t) {
    const double around = s * std::numbers::pi / 2, up = t * 72 * std::numbers::pi / 180;
    return Vector(10 * std::cos(up) * std::cos(around), 10 * std::cos(up) * std::sin(around), 10 * std::sin(up));
  };
  o.set = [](const Grid& g, Unknowns& u) {
    for (int j = 0; j <= g.along; ++j) {
      u.mirror(g.node(0, j), 1);
      u.mirror(g.node(g.across, j), 0);
    }
    u.hold(g.node(0, g.along), {2});
    u.load[0] = 1;
    u.load[6 * g.node(g.across, 0) + 1] = -1;
  };
  o.measure = [](const Grid&, const Eigen::VectorXd& u) { return u[0]; };
  return o;
}

/// Load along `axis` at the end.
Obstacle twisted_beam(int axis) {
  Obstacle o{axis == 2 ? "beam, z" : "beam, y", 29e6, 0.22, 0.32, axis == 2 ? 0.005424 : 0.001754, 0.25};
  o.at = [](double s, double t) {
    const double angle = t * std::numbers::pi / 2, y = 1.1 * (0.5 - s);
    return Vector(12 * t, y * std::cos(angle), y * std::sin(angle));
  };
  o.set = [axis](const Grid& g, Unknowns& u) {
    for (int i = 0; i <= g.across; ++i) {
      u.hold(g.node(i, 0), {0, 1, 2, 3, 4, 5});
      u.load[6 * g.node(i, g.along) + axis] = (i == 0 || i == g.across ? 0.5 : 1.0) / g.across;
    }
  };
  o.measure = [axis](const Grid& g, const Eigen::VectorXd& u) { return u[6 * g.node(g.across / 2, g.along) + axis]; };
  return o;
}

template <class Kernel>
Kernel kernel_of(const ElasticResponse& law, const element::ShellSection& section) {
  if constexpr (requires { Kernel{law, section, element::Hourglass{}}; })
    return {law, section, {element::HourglassKind::elastic, 0.05}};
  else
    return {law, section};
}

template <class Kernel>
struct Course {
  static constexpr int nodes = Kernel::nodes;
  using Corners = Eigen::Matrix<double, 3, nodes>;

  const Obstacle& obstacle;
  Grid grid;
  Unknowns unknowns;
  std::vector<Eigen::Triplet<double>> entries{};

  void add(const std::array<int, nodes>& corner) {
    Corners x;
    for (int c = 0; c < nodes; ++c) {
      const int i = corner[std::size_t(c)] % (grid.across + 1), j = corner[std::size_t(c)] / (grid.across + 1);
      x.col(c) = obstacle.at(double(i) / grid.across, double(j) / grid.along);
    }
    element::ShellSection section;
    section.thickness = obstacle.thickness;
    section.points = 2;
    const ElasticResponse law({1, obstacle.young, obstacle.poisson});
    const ShellBench<Kernel> bench(kernel_of<Kernel>(law, section), x, 1);
    const double edge = (x.col(1) - x.col(0)).norm();
    const auto K = bench.stiffness(x, 1e-7 * std::min(edge, 1.0));
    const auto at = [&](int c) {
      return 6 * corner[std::size_t(c % (3 * nodes) / 3)] + c % 3 + (c < 3 * nodes ? 0 : 3);
    };
    for (int a = 0; a < 6 * nodes; ++a)
      for (int b = 0; b < 6 * nodes; ++b)
        if (!unknowns.held[std::size_t(at(a))] && !unknowns.held[std::size_t(at(b))])
          entries.emplace_back(at(a), at(b), 0.5 * (K(a, b) + K(b, a)));
    const double area = bench.area(x);
    for (const int c : corner) unknowns.load[6 * c + 2] -= obstacle.weight * area / nodes;
  }

  double deflection() {
    for (int j = 0; j < grid.along; ++j)
      for (int i = 0; i < grid.across; ++i) {
        const int a = grid.node(i, j), b = grid.node(i + 1, j), c = grid.node(i + 1, j + 1), d = grid.node(i, j + 1);
        if constexpr (nodes == 4)
          add({a, b, c, d});
        else {
          add({a, b, c});
          add({a, c, d});
        }
      }
    const int size = 6 * grid.nodes();
    for (int c = 0; c < size; ++c)
      if (unknowns.held[std::size_t(c)]) {
        entries.emplace_back(c, c, 1);
        unknowns.load[c] = 0;
      }
    Eigen::SparseMatrix<double> K(size, size);
    K.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(K);
    const Eigen::VectorXd u = factor.solve(unknowns.load);
    return obstacle.measure(grid, u) / obstacle.deflection;
  }
};

/// Deflection over that of the reference with `along` elements a side.
template <class Kernel>
double run(const Obstacle& obstacle, int along) {
  const Grid grid{std::max(1, int(along * obstacle.narrowness)), along};
  const auto size = static_cast<std::size_t>(6 * grid.nodes());
  Unknowns unknowns{std::vector<char>(size, 0), Eigen::VectorXd::Zero(static_cast<Eigen::Index>(size))};
  obstacle.set(grid, unknowns);
  return Course<Kernel>{obstacle, grid, unknowns}.deflection();
}

/// Largest errors with 16 elements a side.
template <class Kernel>
void check(const char* name, const std::array<double, 5>& errors) {
  const Obstacle course[5] = {roof(), cylinder(), hemisphere(), twisted_beam(2), twisted_beam(1)};
  for (std::size_t k = 0; k < 5; ++k) {
    if (std::getenv("SHOW"))
      for (const int n : {4, 8, 16, 32})
        WARN(name << ", " << course[k].name << ", " << n << ": " << run<Kernel>(course[k], n));
    INFO(name << ", " << course[k].name);
    CHECK(std::abs(run<Kernel>(course[k], 16) - 1) < errors[k]);
  }
}

}  // namespace

TEST_CASE("the obstacle course of shells with 16 elements a side") {
  check<element::Shell4<ElasticResponse>>("shell4", {0.01, 0.05, 0.02, 0.01, 0.02});
  check<element::Shell4Full<ElasticResponse>>("shell4_full", {0.015, 0.08, 0.02, 0.01, 0.06});
  check<element::Shell3<ElasticResponse>>("shell3", {0.06, 0.18, 0.03, 0.02, 0.13});
}
