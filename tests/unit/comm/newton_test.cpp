// SPDX-License-Identifier: Apache-2.0
// Newton's iteration on one rank: quadratic convergence, the ways it can end, line search, exceptions.
#include "comm/newton.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "core/error.hpp"

using namespace brunt;
using comm::Communicator;
using comm::NewtonProblem;
using comm::NewtonReason;
using comm::NewtonStep;
using comm::NewtonVerdict;

namespace {

using Values = std::span<const double>;

/// x0^2 + x1 = 3, x0 + x1^2 = 5: the root (1, 2).
struct TwoEquations {
  std::vector<double> sizes;  // of the residuals that were judged
  int most = 20;
  double enough = 0;

  NewtonProblem problem() {
    NewtonProblem made;
    made.residual = [](Values x, std::span<double> r) {
      r[0] = x[0] * x[0] + x[1] - 3;
      r[1] = x[0] + x[1] * x[1] - 5;
      return true;
    };
    made.solve = [](Values x, Values r, std::span<double> c) {
      const double a = 2 * x[0], d = 2 * x[1], determinant = a * d - 1;
      if (determinant == 0) return false;
      c[0] = (d * r[0] - r[1]) / determinant;
      c[1] = (a * r[1] - r[0]) / determinant;
      return true;
    };
    made.judge = [this](int iteration, Values, Values r) {
      CHECK(iteration == static_cast<int>(sizes.size()));
      sizes.push_back(std::max(std::abs(r[0]), std::abs(r[1])));
      if (sizes.back() <= enough) return NewtonVerdict::converged;
      return iteration == most ? NewtonVerdict::give_up : NewtonVerdict::go_on;
    };
    return made;
  }
};

/// One unknown: atan x = 0. Full steps diverge from |x| > 1.392.
NewtonProblem arc_tangent(double accuracy) {
  NewtonProblem made;
  made.residual = [](Values x, std::span<double> r) {
    r[0] = std::atan(x[0]);
    return true;
  };
  made.solve = [](Values x, Values r, std::span<double> c) {
    c[0] = r[0] * (1 + x[0] * x[0]);
    return true;
  };
  made.judge = [accuracy](int iteration, Values, Values r) {
    if (std::abs(r[0]) < accuracy) return NewtonVerdict::converged;
    return iteration == 30 ? NewtonVerdict::give_up : NewtonVerdict::go_on;
  };
  return made;
}

comm::NewtonResult run(std::vector<double>& x, const NewtonProblem& problem) {
  return comm::newton(Communicator::self(), x, problem);
}

}  // namespace

TEST_CASE("full corrections converge quadratically, and the judge alone ends the iteration") {
  TwoEquations equations{.sizes = {}};
  std::vector<double> x{2, 3};
  const comm::NewtonResult result = run(x, equations.problem());
  CHECK(result.reason == NewtonReason::converged);
  CHECK(x[0] == Approx(1).epsilon(1e-15));
  CHECK(x[1] == Approx(2).epsilon(1e-15));
  CHECK(equations.sizes.back() == 0);
  CHECK(result.iterations == static_cast<int>(equations.sizes.size()) - 1);
  CHECK(result.iterations <= 7);
  for (std::size_t k = 2; k + 1 < equations.sizes.size(); ++k)  // the last is rounding
    CHECK(equations.sizes[k + 1] <= equations.sizes[k] * equations.sizes[k] + 1e-15);
}

TEST_CASE("an iteration that starts at the root takes no correction") {
  TwoEquations equations{.sizes = {}};
  std::vector<double> x{1, 2};
  CHECK(run(x, equations.problem()).iterations == 0);
  CHECK(x == std::vector<double>{1, 2});
}

TEST_CASE("tiny and huge residuals are the judge's affair, not PETSc's") {
  for (const double scale : {1e-200, 1e120}) {
    TwoEquations equations{.sizes = {}};
    NewtonProblem problem = equations.problem();
    problem.residual = [base = problem.residual, scale](Values x, std::span<double> r) {
      base(x, r);
      for (double& value : r) value *= scale;
      return true;
    };
    problem.solve = [base = problem.solve, scale](Values x, Values r, std::span<double> c) {
      const std::vector<double> scaled{r[0] / scale, r[1] / scale};
      return base(x, scaled, c);
    };
    std::vector<double> x{2, 3};
    equations.enough = 1e-14 * scale;
    CHECK(run(x, problem).reason == NewtonReason::converged);
    CHECK(x[0] == Approx(1).epsilon(1e-13));
  }
}

TEST_CASE("giving up, a singular tangent, points that are not admissible") {
  TwoEquations equations{.sizes = {}, .most = 2};
  std::vector<double> x{2, 3};
  comm::NewtonResult result = run(x, equations.problem());
  CHECK(result.reason == NewtonReason::gave_up);
  CHECK(result.iterations == 2);

  x = {0.25, 1};  // the determinant is zero there
  equations = {.sizes = {}};
  result = run(x, equations.problem());
  CHECK(result.reason == NewtonReason::singular);
  CHECK(result.iterations == 0);
  CHECK(x == std::vector<double>{0.25, 1});

  NewtonProblem refuses = arc_tangent(1e-15);
  refuses.residual = [base = refuses.residual](Values at, std::span<double> r) { return base(at, r) && at[0] > -1; };
  std::vector<double> y{2};  // leads to -3.5
  result = run(y, refuses);
  CHECK(result.reason == NewtonReason::inadmissible);
  CHECK(result.iterations == 0);
  CHECK(y[0] == 2);
  y[0] = -2;
  CHECK(run(y, refuses).reason == NewtonReason::inadmissible);
}

TEST_CASE("a residual that is not finite at the start is not admissible") {
  NewtonProblem problem = arc_tangent(1e-15);
  problem.residual = [](Values, std::span<double> r) {
    r[0] = std::numeric_limits<double>::quiet_NaN();
    return true;
  };
  std::vector<double> x{2};
  CHECK(run(x, problem).reason == NewtonReason::inadmissible);
}

TEST_CASE("a line search saves what full corrections lose") {
  NewtonProblem problem = arc_tangent(1e-14);
  std::vector<double> x{3};
  int evaluations = 0;
  CHECK(run(x, problem).reason != NewtonReason::converged);
  problem.residual = [&evaluations, base = problem.residual](Values at, std::span<double> r) {
    ++evaluations;
    return base(at, r);
  };
  std::vector<double> shares;
  problem.step_length = [&shares](const NewtonStep& step) {
    std::vector<double> trial(1);
    double share = 1;
    while (!step.residual_at(share, trial) || std::abs(trial[0]) > std::abs(step.residual[0])) share /= 2;
    CHECK(step.iteration == static_cast<int>(shares.size()));
    shares.push_back(share);
    return share;
  };
  x[0] = 3;
  const comm::NewtonResult result = run(x, problem);
  CHECK(result.reason == NewtonReason::converged);
  CHECK(std::abs(x[0]) < 1e-14);
  CHECK(shares.front() == 0.25);
  CHECK(shares.back() == 1);
  // the start; 1, 1/2, 1/4 of the first correction; one each of the others: the last trial is not evaluated again
  int trials = 1;
  for (const double share : shares) trials += 1 + static_cast<int>(std::log2(1 / share));
  CHECK(evaluations == trials);
}

TEST_CASE("a line search may find no step, or one that it did not try") {
  NewtonProblem problem = arc_tangent(1e-14);
  std::vector<double> x{1};
  problem.step_length = [](const NewtonStep&) { return 0.0; };
  CHECK(run(x, problem).reason == NewtonReason::no_step);
  CHECK(x[0] == 1);
  problem.step_length = [](const NewtonStep& step) {
    std::vector<double> trial(1);
    step.residual_at(0.125, trial);
    return 1.0;
  };
  CHECK(run(x, problem).reason == NewtonReason::converged);
}

TEST_CASE("what functions throw comes out unchanged, and the next iteration works") {
  struct Odd {
    int value;
  };
  const auto thrown_by = [](auto&& change) {
    NewtonProblem problem = arc_tangent(1e-14);
    change(problem);
    std::vector<double> x{1};
    try {
      (void)run(x, problem);
    } catch (const Odd& odd) {
      return odd.value;
    }
    return 0;
  };
  CHECK(thrown_by([](NewtonProblem& p) { p.residual = [](Values, std::span<double>) -> bool { throw Odd{1}; }; }) == 1);
  CHECK(thrown_by(
            [](NewtonProblem& p) { p.solve = [](Values, Values, std::span<double>) -> bool { throw Odd{2}; }; }) == 2);
  CHECK(thrown_by([](NewtonProblem& p) { p.judge = [](int, Values, Values) -> NewtonVerdict { throw Odd{3}; }; }) == 3);
  CHECK(thrown_by([](NewtonProblem& p) { p.step_length = [](const NewtonStep&) -> double { throw Odd{4}; }; }) == 4);
  CHECK(thrown_by([](NewtonProblem& p) {
          p.judge = [base = p.judge](int iteration, Values x, Values r) {
            if (iteration == 2) throw Odd{5};
            return base(iteration, x, r);
          };
        }) == 5);
  std::vector<double> x{1};
  NewtonProblem guard = arc_tangent(1e-14);
  guard.solve = [](Values, Values, std::span<double>) -> bool { throw GuardError("energy grows"); };
  CHECK_THROWS_WITH(run(x, guard), "energy grows");
  CHECK(run(x, arc_tangent(1e-14)).reason == NewtonReason::converged);
}

TEST_CASE("one iteration inside another") {
  NewtonProblem outer = arc_tangent(1e-14);
  outer.solve = [](Values x, Values r, std::span<double> c) {  // divides by the root of y - 1/(1 + x^2)
    const double slope = 1 / (1 + x[0] * x[0]);
    NewtonProblem inner = arc_tangent(1e-15);
    inner.residual = [slope](Values y, std::span<double> rest) {
      rest[0] = y[0] - slope;
      return true;
    };
    inner.solve = [](Values, Values rest, std::span<double> step) {
      step[0] = rest[0];
      return true;
    };
    std::vector<double> y{0};
    if (comm::newton(Communicator::self(), y, inner).reason != NewtonReason::converged) return false;
    c[0] = r[0] / y[0];
    return true;
  };
  std::vector<double> x{1};
  CHECK(run(x, outer).reason == NewtonReason::converged);
}

TEST_CASE("Newton's iteration needs its three functions") {
  std::vector<double> x{1};
  NewtonProblem problem = arc_tangent(1);
  problem.judge = nullptr;
  CHECK_THROWS(run(x, problem));
}
