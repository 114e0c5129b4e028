// SPDX-License-Identifier: Apache-2.0
// PETSc's Newton iteration with our functions for all computations and decisions.
#include "comm/newton.hpp"

#include <petscsnes.h>

#include <algorithm>
#include <exception>
#include <vector>

#include "comm/native.hpp"
#include "core/error.hpp"
#include "petsc_errors.hpp"

namespace brunt::comm {
namespace {

struct Drive {
  const NewtonProblem& problem;
  const PetscErrors& petsc;
  SNES snes = nullptr;
  NewtonResult result{};
  bool stopped = false;         // for the reason in `result`
  std::exception_ptr thrown{};  // by a function of the caller: stored until the C functions have returned

  void stop(NewtonReason reason) {
    result.reason = reason;
    stopped = true;
  }
};

/// No exception may pass through C functions: they return an error code instead, without a message to other ranks.
template <class Call>
PetscErrorCode guarded(Drive& drive, Call&& call) {
  try {
    call();
    return 0;
  } catch (...) {
    drive.thrown = std::current_exception();
    return PETSC_ERR_LIB;
  }
}

class Read {
 public:
  Read(const PetscErrors& petsc, Vec vector) : vector_(vector) {
    PetscInt size = 0;
    petsc.check(VecGetLocalSize(vector, &size));
    petsc.check(VecGetArrayRead(vector, &first_));
    values_ = {first_, static_cast<std::size_t>(size)};
  }
  ~Read() { VecRestoreArrayRead(vector_, &first_); }
  Read(const Read&) = delete;
  Read& operator=(const Read&) = delete;
  operator std::span<const double>() const { return values_; }

 private:
  Vec vector_;
  const double* first_ = nullptr;
  std::span<const double> values_;
};

class Write {
 public:
  Write(const PetscErrors& petsc, Vec vector) : vector_(vector) {
    PetscInt size = 0;
    petsc.check(VecGetLocalSize(vector, &size));
    petsc.check(VecGetArray(vector, &first_));
    values_ = {first_, static_cast<std::size_t>(size)};
  }
  ~Write() { VecRestoreArray(vector_, &first_); }
  Write(const Write&) = delete;
  Write& operator=(const Write&) = delete;
  operator std::span<double>() const { return values_; }
  [[nodiscard]] std::span<double> get() const { return values_; }

 private:
  Vec vector_;
  double* first_ = nullptr;
  std::span<double> values_;
};

PetscErrorCode residual_at_start(SNES snes, Vec x, Vec residual, void* context) {
  auto& drive = *static_cast<Drive*>(context);
  return guarded(drive, [&] {
    const Read at(drive.petsc, x);
    const Write to(drive.petsc, residual);
    if (drive.problem.residual(at, to)) return;
    drive.stop(NewtonReason::inadmissible);
    drive.petsc.check(SNESSetFunctionDomainError(snes));
  });
}

PetscErrorCode judge(SNES snes, PetscInt iteration, PetscReal /*x*/, PetscReal /*step*/, PetscReal /*residual*/,
                     SNESConvergedReason* reason, void* context) {
  auto& drive = *static_cast<Drive*>(context);
  return guarded(drive, [&] {
    Vec x = nullptr, residual = nullptr;
    drive.petsc.check(SNESGetSolution(snes, &x));
    drive.petsc.check(SNESGetFunction(snes, &residual, nullptr, nullptr));
    drive.result.iterations = static_cast<int>(iteration);
    const Read at(drive.petsc, x), there(drive.petsc, residual);
    const NewtonVerdict verdict = drive.problem.judge(static_cast<int>(iteration), at, there);
    *reason = SNES_CONVERGED_ITERATING;
    if (verdict == NewtonVerdict::go_on) return;
    const bool good = verdict == NewtonVerdict::converged;
    drive.stop(good ? NewtonReason::converged : NewtonReason::gave_up);
    *reason = good ? SNES_CONVERGED_FNORM_ABS : SNES_DIVERGED_FUNCTION_COUNT;
  });
}

/// The tangent is computed in `correct`.
PetscErrorCode no_tangent(SNES /*snes*/, Vec /*x*/, Mat /*tangent*/, Mat /*same*/, void* /*context*/) {
  return 0;
}

PetscErrorCode correct(PC solver, Vec residual, Vec correction) {
  void* context = nullptr;
  if (const PetscErrorCode code = PCShellGetContext(solver, &context); code != 0) return code;
  auto& drive = *static_cast<Drive*>(context);
  return guarded(drive, [&] {
    Vec x = nullptr;
    drive.petsc.check(SNESGetSolution(drive.snes, &x));
    const Read at(drive.petsc, x), there(drive.petsc, residual);
    const Write to(drive.petsc, correction);
    if (drive.problem.solve(at, there, to)) return;
    drive.stop(NewtonReason::singular);
    std::ranges::fill(to.get(), 0.0);  // `advance` ends the iteration before it is used
  });
}

/// Takes the step length chosen by the line search; if there is none, x and its residual remain unchanged.
void advance_with(Drive& drive, Vec x_vector, Vec residual_vector, Vec correction_vector) {
  const Write x(drive.petsc, x_vector), residual(drive.petsc, residual_vector);
  const Read correction(drive.petsc, correction_vector);
  const std::span<const double> c = correction;
  std::vector<double> point(c.size()), there(c.size());
  double tried = 0;  // the step length of `point` and `there`
  bool admissible = false;
  const auto evaluate = [&](double share) {
    for (std::size_t i = 0; i < c.size(); ++i) point[i] = x.get()[i] - share * c[i];
    tried = share;
    admissible = drive.problem.residual(point, there);
    return admissible;
  };
  double share = 1;
  if (drive.problem.step_length) {
    NewtonStep step{drive.result.iterations, x.get(), residual.get(), c, {}};
    step.residual_at = [&](double trial, std::span<double> into) {
      const bool good = evaluate(trial);
      if (good) std::ranges::copy(there, into.begin());
      return good;
    };
    share = drive.problem.step_length(step);
    if (!(share > 0)) return drive.stop(NewtonReason::no_step);
  }
  if (tried != share) evaluate(share);
  if (!admissible) return drive.stop(NewtonReason::inadmissible);
  std::ranges::copy(point, x.get().begin());
  std::ranges::copy(there, residual.get().begin());
}

PetscErrorCode advance(SNESLineSearch search, void* context) {
  auto& drive = *static_cast<Drive*>(context);
  return guarded(drive, [&] {
    Vec x = nullptr, residual = nullptr, correction = nullptr;
    drive.petsc.check(SNESLineSearchGetVecs(search, &x, &residual, &correction, nullptr, nullptr));
    if (!drive.stopped) advance_with(drive, x, residual, correction);
    if (drive.stopped) drive.petsc.check(SNESSetConvergedReason(drive.snes, SNES_DIVERGED_LINE_SEARCH));
    drive.petsc.check(SNESLineSearchSetNorms(search, 1, 1, 1));  // PETSc requires only finite values here
  });
}

struct Objects {
  Vec x = nullptr, residual = nullptr;
  Mat tangent = nullptr;
  SNES snes = nullptr;
  ~Objects() {
    SNESDestroy(&snes);
    MatDestroy(&tangent);
    VecDestroy(&residual);
    VecDestroy(&x);
  }
};

void set_up(const Communicator& ranks, std::span<double> x, Drive& drive, Objects& objects) {
  const PetscErrors& petsc = drive.petsc;
  const MPI_Comm comm = native(ranks);
  const auto size = static_cast<PetscInt>(x.size());
  petsc.check(VecCreateMPIWithArray(comm, 1, size, PETSC_DETERMINE, x.data(), &objects.x));
  petsc.check(VecCreateMPI(comm, size, PETSC_DETERMINE, &objects.residual));
  petsc.check(MatCreateShell(comm, size, size, PETSC_DETERMINE, PETSC_DETERMINE, nullptr, &objects.tangent));
  petsc.check(SNESCreate(comm, &objects.snes));
  drive.snes = objects.snes;
  petsc.check(SNESSetType(objects.snes, SNESNEWTONLS));
  petsc.check(SNESSetFunction(objects.snes, objects.residual, residual_at_start, &drive));
  petsc.check(SNESSetJacobian(objects.snes, objects.tangent, objects.tangent, no_tangent, &drive));
  petsc.check(SNESSetConvergenceTest(objects.snes, judge, &drive, nullptr));
  petsc.check(SNESSetTolerances(objects.snes, 0, 0, 0, PETSC_MAX_INT, PETSC_MAX_INT));  // only `judge` decides
  SNESLineSearch search = nullptr;
  petsc.check(SNESGetLineSearch(objects.snes, &search));
  petsc.check(SNESLineSearchSetType(search, SNESLINESEARCHSHELL));
  petsc.check(SNESLineSearchShellSetUserFunc(search, advance, &drive));
  KSP solver = nullptr;
  PC shell = nullptr;
  petsc.check(SNESGetKSP(objects.snes, &solver));
  petsc.check(KSPSetType(solver, KSPPREONLY));
  petsc.check(KSPGetPC(solver, &shell));
  petsc.check(PCSetType(shell, PCSHELL));
  petsc.check(PCShellSetContext(shell, &drive));
  petsc.check(PCShellSetApply(shell, correct));
}

}  // namespace

NewtonResult newton(const Communicator& ranks, std::span<double> x, const NewtonProblem& problem) {
  demand(problem.residual && problem.solve && problem.judge, "Newton's iteration has a residual, a solver and a judge");
  const PetscErrors petsc;
  Objects objects;
  Drive drive{problem, petsc};
  try {
    set_up(ranks, x, drive, objects);
    const PetscErrorCode code = SNESSolve(objects.snes, nullptr, objects.x);
    if (drive.thrown) std::rethrow_exception(drive.thrown);
    petsc.check(code);
  } catch (const PetscFailure& failure) {
    throw MachineError(failure.what());
  }
  if (!drive.stopped) drive.stop(NewtonReason::inadmissible);  // PETSc stops by itself if a residual is not finite
  return drive.result;
}

}  // namespace brunt::comm
