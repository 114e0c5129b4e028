// SPDX-License-Identifier: Apache-2.0
// The owner of a solver needs no complete definition of it.
#pragma once
#include <memory>

namespace brunt::implicit {

struct Solver;
struct DeleteSolver {
  void operator()(Solver* solver) const;
};
using SolverOwner = std::unique_ptr<Solver, DeleteSolver>;

}  // namespace brunt::implicit
