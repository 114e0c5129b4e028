// SPDX-License-Identifier: Apache-2.0
// The symmetric matrix that decides about stability, from the rows of a tangent with FrictionLimit::given:
//   S = [ T^t sym(H) T + k (1 - P)   T^t B^t ]
//       [ B T                        A       ]
// H: derivatives of forces by nodes; T: onto the motions that supports and walls admit (projectors P), nodes of rigid
// bodies by the unknowns of their body; B: equations of the multipliers in action; A: of the others, which are zero.
#pragma once
#include <vector>

#include "implicit/solver.hpp"

namespace brunt::implicit {

struct SymmetricRows {
  comm::SparseRows rows;      ///< as SymmetricSystem reads them
  std::vector<double> scale;  ///< for each row: the size of the diagonal of its node or body; 0 for multipliers
  GlobalIndex expected = 0;   ///< negative eigenvalues if the state is stable, over all ranks
};

/// Collective.
SymmetricRows symmetric_rows(const Scene& scene, const Solver& solver);

/// The rank that owns each unknown of the system. Collective.
std::vector<Rank> owners_of_unknowns(const comm::Communicator& ranks, const comm::SparseRows& rows);

}  // namespace brunt::implicit
