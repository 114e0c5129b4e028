// SPDX-License-Identifier: Apache-2.0
// Who owns a solver need not know what it is made of.
#pragma once
#include <memory>

namespace brunt::implicit {

struct Solver;
struct DeleteSolver {
  void operator()(Solver* solver) const;
};
using SolverOwner = std::unique_ptr<Solver, DeleteSolver>;

}  // namespace brunt::implicit
