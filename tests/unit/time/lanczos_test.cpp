// SPDX-License-Identifier: Apache-2.0
#include "time/lanczos.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "mesh/primitives.hpp"
#include "support/dense_mesh.hpp"
#include "support/simulation.hpp"
#include "time/assembled_step.hpp"

using namespace brunt;

TEST_CASE("largest eigenvalue of random tridiagonal matrices, as of a dense solver", "[oracle]") {
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> entry(0, 0.5);
  for (const int n : {1, 2, 7, 40}) {
    std::vector<double> diagonal, beside;
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
    for (int k = 0; k < n; ++k) {
      diagonal.push_back(0.5 + entry(engine));
      dense(k, k) = diagonal.back();
    }
    for (int k = 0; k + 1 < n; ++k) {
      beside.push_back(0.5 * entry(engine));
      dense(k, k + 1) = dense(k + 1, k) = beside.back();
    }
    const double exact = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense).eigenvalues().maxCoeff();
    CHECK(time::largest_of_tridiagonal(diagonal, beside) == Approx(exact).epsilon(1e-11));
  }
}

TEST_CASE(
    "Lanczos: from below, and within the share that is added for every random start, also where one small "
    "element is stiffest",
    "[oracle]") {
  std::mt19937 engine(2);
  std::uniform_real_distribution<double> move(-0.1, 0.1);
  for (const double corner : {0.0, 0.15, 0.4}) {
    mesh::Mesh box = mesh::box("a", {10, 10, 10}, {10, 10, 10});
    for (Vec3& x : box.coordinates) x += Vec3(move(engine), move(engine), move(engine));
    box.coordinates[665] += Vec3(corner, corner, corner);  // a node within
    test::Simulation run(std::move(box),
                         "materials: {m: {model: elastic, density: 1, young: 100, poisson: 0.3}}\n"
                         "parts: {a: {material: m}}\n");
    force::LinearElements linear = force::sized_linear(run.model);
    const double rate = force::internal_forces(run.model, run.state, run.scratch, {{}, linear}).rate;
    force::include_damping(linear, 1 / rate);
    const double scale = 8 * rate * rate;
    const auto found = [&](int products) {
      return time::largest_eigenvalue(run.model, run.state, run.links, linear, scale, products);
    };
    const double exact = found(400);
    CHECK(found(500) == Approx(exact).epsilon(1e-10));
    const auto until = [&](double enough) {
      return time::largest_eigenvalue(run.model, run.state, run.links, linear, scale, 400, enough);
    };
    CHECK(until(0.5 * exact) == 0.5 * exact);
    CHECK(until(1.1 * exact) == exact);
    const int products = time::lanczos_products(3.0 * static_cast<double>(run.model.mesh.global_nodes));
    double least = 1;
    for (int draw = 0; draw < 40; ++draw) {
      run.state.step = draw;
      const double now = found(products);
      CHECK(now <= exact * (1 + 1e-10));
      least = std::min(least, now / exact);
    }
    CAPTURE(corner, products, least);
    CHECK(least >= 1 - time::lanczos_share);
  }
}
