// SPDX-License-Identifier: Apache-2.0
#include "contact/enforcement/reference.hpp"

#include <petsctao.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace brunt::contact {
namespace {

constexpr double relative_accuracy = 1e-11;
constexpr PetscInt most_iterations = 10000;

void check(PetscErrorCode code) {
  demand(code == 0, "PETSc could not solve the reference problem");
}

/// The unknowns are y = sqrt(H) lambda, so that the diagonal of the operator is of the size of 1.
struct Problem {
  const System& system;
  Exchange& exchange;
  std::span<Vec3> impulses, velocity;
  EnforcementScratch& scratch;
  std::vector<double> predicted_rate;  // n . G v*
  std::vector<char> acts;              // rows that a multiplication sees

  [[nodiscard]] double root(std::size_t q) const { return std::sqrt(scratch.diagonal[q]); }
  [[nodiscard]] double rate(std::size_t q) const {
    return system.rows.laws[q].normal.dot(relative_velocity(system.rows, q, velocity));
  }
  /// Impulses of the unknowns, and the velocities that they give.
  void apply(const double* y) {
    double largest = 0;
    for (std::size_t q = 0; q < impulses.size(); ++q) {
      const double along = acts[q] != 0 ? y[q] / root(q) : 0.0;
      impulses[q] = along * system.rows.laws[q].normal;
      keep_max(largest, std::abs(along));
    }
    exchange.max({&largest, 1});
    demand_finite(largest);
    apply_impulses(system, impulses, largest, exchange, velocity, scratch);
  }
};

/// 1/2 y.Ay - b.y and its gradient: minus what the rows still ask for.
PetscErrorCode objective(Tao /*tao*/, Vec y, PetscReal* value, Vec gradient, void* context) {
  auto& problem = *static_cast<Problem*>(context);
  const double* unknown = nullptr;
  double* slope = nullptr;
  PetscCall(VecGetArrayRead(y, &unknown));
  PetscCall(VecGetArray(gradient, &slope));
  problem.apply(unknown);
  double half_work = 0;
  for (std::size_t q = 0; q < problem.impulses.size(); ++q) {
    const double rate = problem.rate(q), required = problem.system.rows.laws[q].required;
    slope[q] = problem.acts[q] != 0 ? (rate - required) / problem.root(q) : 0.0;
    if (problem.acts[q] != 0)
      half_work += unknown[q] / problem.root(q) * (0.5 * (rate + problem.predicted_rate[q]) - required);
  }
  PetscCall(VecRestoreArray(gradient, &slope));
  PetscCall(VecRestoreArrayRead(y, &unknown));
  PetscCallMPI(MPI_Allreduce(&half_work, value, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD));
  return 0;
}

PetscErrorCode multiply(Mat matrix, Vec y, Vec product) {
  void* context = nullptr;
  PetscCall(MatShellGetContext(matrix, &context));
  auto& problem = *static_cast<Problem*>(context);
  const double* unknown = nullptr;
  double* result = nullptr;
  PetscCall(VecGetArrayRead(y, &unknown));
  PetscCall(VecGetArray(product, &result));
  problem.apply(unknown);
  for (std::size_t q = 0; q < problem.impulses.size(); ++q)
    result[q] = problem.acts[q] != 0 ? (problem.rate(q) - problem.predicted_rate[q]) / problem.root(q) : unknown[q];
  PetscCall(VecRestoreArray(product, &result));
  PetscCall(VecRestoreArrayRead(y, &unknown));
  return 0;
}

Vec vector_of(const Problem& problem) {
  Vec vector = nullptr;
  check(VecCreateMPI(PETSC_COMM_WORLD, static_cast<PetscInt>(problem.impulses.size()), PETSC_DETERMINE, &vector));
  return vector;
}

template <class Fill>
void fill(Vec vector, std::size_t rows, Fill&& of_row) {
  double* values = nullptr;
  check(VecGetArray(vector, &values));
  for (std::size_t q = 0; q < rows; ++q) values[q] = of_row(q);
  check(VecRestoreArray(vector, &values));
}

void solve_with_bounds(Problem& problem, Vec solution, double accuracy) {
  Vec lower = vector_of(problem), upper = vector_of(problem);
  fill(lower, problem.impulses.size(),
       [&](std::size_t q) { return problem.system.rows.laws[q].cone == Cone::free ? PETSC_NINFINITY : 0.0; });
  check(VecSet(upper, PETSC_INFINITY));
  Tao tao = nullptr;
  check(TaoCreate(PETSC_COMM_WORLD, &tao));
  check(TaoSetType(tao, TAOBLMVM));
  check(TaoSetSolution(tao, solution));
  check(TaoSetVariableBounds(tao, lower, upper));
  check(TaoSetObjectiveAndGradient(tao, nullptr, objective, &problem));
  check(TaoSetTolerances(tao, accuracy, 0, 0));
  check(TaoSetMaximumIterations(tao, most_iterations));
  check(TaoSolve(tao));
  check(TaoDestroy(&tao));
  check(VecDestroy(&lower));
  check(VecDestroy(&upper));
}

/// With equality in the rows that `acts` names; the others do not push.
void solve_closed(Problem& problem, Vec solution) {
  Vec right = vector_of(problem);
  fill(right, problem.impulses.size(), [&](std::size_t q) {
    return problem.acts[q] != 0 ? (problem.system.rows.laws[q].required - problem.predicted_rate[q]) / problem.root(q)
                                : 0.0;
  });
  Mat matrix = nullptr;
  const auto rows = static_cast<PetscInt>(problem.impulses.size());
  check(MatCreateShell(PETSC_COMM_WORLD, rows, rows, PETSC_DETERMINE, PETSC_DETERMINE, &problem, &matrix));
  check(MatShellSetOperation(matrix, MATOP_MULT, reinterpret_cast<void (*)()>(multiply)));
  KSP solver = nullptr;
  check(KSPCreate(PETSC_COMM_WORLD, &solver));
  check(KSPSetType(solver, KSPCG));
  PC none = nullptr;
  check(KSPGetPC(solver, &none));
  check(PCSetType(none, PCNONE));
  check(KSPSetOperators(solver, matrix, matrix));
  check(KSPSetTolerances(solver, relative_accuracy, PETSC_DEFAULT, PETSC_DEFAULT, most_iterations));
  check(KSPSetInitialGuessNonzero(solver, PETSC_TRUE));
  check(KSPSolve(solver, right, solution));
  check(KSPDestroy(&solver));
  check(MatDestroy(&matrix));
  check(VecDestroy(&right));
}

void apply_solution(Problem& problem, Vec solution) {
  const double* values = nullptr;
  check(VecGetArrayRead(solution, &values));
  problem.apply(values);
  check(VecRestoreArrayRead(solution, &values));
}

/// The rows that push go on to equality, with the others at zero; stays only if no row ends up pulling.
void finish(Problem& problem, Vec solution) {
  Vec better = vector_of(problem);
  check(VecCopy(solution, better));
  const std::vector<char> all = problem.acts;
  for (std::size_t q = 0; q < problem.impulses.size(); ++q)
    problem.acts[q] = all[q] != 0 && !problem.impulses[q].isZero(0) ? 1 : 0;
  solve_closed(problem, better);
  apply_solution(problem, better);
  double pull = 0;
  for (std::size_t q = 0; q < problem.impulses.size(); ++q)
    if (problem.system.rows.laws[q].cone == Cone::compression)
      pull = std::max(pull, -problem.system.rows.laws[q].normal.dot(problem.impulses[q]));
  problem.exchange.max({&pull, 1});
  if (pull > 0) {
    problem.acts = all;
    apply_solution(problem, solution);
  }
  check(VecDestroy(&better));
}

double natural_residual(const Problem& problem) {
  double largest = 0;
  for (std::size_t q = 0; q < problem.impulses.size(); ++q) {
    const double h = problem.scratch.diagonal[q];
    if (!(h > 0)) continue;
    const RowLaw& law = problem.system.rows.laws[q];
    const Vec3 missing = missing_rate(law, relative_velocity(problem.system.rows, q, problem.velocity));
    const Vec3 next = admitted(law, problem.impulses[q] + missing / h);
    keep_max(largest, h * (next - problem.impulses[q]).norm());
  }
  problem.exchange.max({&largest, 1});
  return largest;
}

}  // namespace

EnforcementResult enforce_reference(const System& system, const EnforcementSettings& /*settings*/, Exchange& exchange,
                                    std::span<Vec3> impulses, std::span<Vec3> velocity, EnforcementScratch& scratch) {
  const double violation = start_from_prediction(system, exchange, velocity);
  std::fill(impulses.begin(), impulses.end(), Vec3::Zero());
  if (violation == 0) return {};
  form_row_sums(system, exchange, scratch);
  Problem problem{system, exchange, impulses, velocity, scratch, {}, {}};
  double may_open = 0;
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    demand(system.rows.laws[q].across == Across::slips, "the reference solution is for frictionless rows");
    problem.predicted_rate.push_back(problem.rate(q));
    problem.acts.push_back(scratch.diagonal[q] > 0 ? 1 : 0);
    if (system.rows.laws[q].cone == Cone::compression) may_open = 1;
  }
  exchange.max({&may_open, 1});
  Vec solution = vector_of(problem);
  check(VecSet(solution, 0));
  if (may_open > 0) {
    double largest = 1e-300;  // of all ranks: each decides by it when TAO ends
    for (const double h : scratch.diagonal) keep_max(largest, h);
    exchange.max({&largest, 1});
    solve_with_bounds(problem, solution, 1e-9 * violation / std::sqrt(largest));
    apply_solution(problem, solution);
    finish(problem, solution);
  } else {
    solve_closed(problem, solution);
    apply_solution(problem, solution);
  }
  check(VecDestroy(&solution));
  return {violation, natural_residual(problem) / violation, 1, true};
}

}  // namespace brunt::contact
