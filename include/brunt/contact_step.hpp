// SPDX-License-Identifier: Apache-2.0
// Contact in an explicit step of another program: positions, velocities and masses in, impulses out (the rate
// constraint of Heinstein et al. 2000, equation 22, with Coulomb friction), with the same bits on any number of ranks.
#pragma once
#include <mpi.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace brunt::api {

/// The piece of a mesh on this rank. A node of several ranks is on each of them, with the same number, position and
/// mass; an element is on one. A node that no element of this rank has is left as it is here. Elements of different
/// parts share no nodes.
struct ContactMesh {
  std::vector<std::int64_t> node_number;     ///< of each node of this rank, each once, in any order
  std::vector<double> position;              ///< x, y, z of each node at the start [length]
  std::vector<std::int64_t> element_number;  ///< of each element of this rank, unique over all ranks
  std::vector<std::int32_t> corner;          ///< eight a hexahedron, nodes of this rank, in the order of Exodus HEX8; a
                                             ///< tetrahedron names its four in the first places and has -1 in the fifth
  std::vector<std::int32_t> part;            ///< of each element: from 0
  std::vector<double> mass;                  ///< of each node, the whole of a shared one on every copy; infinite: held
};

struct ContactSettings {
  double friction = 0;            ///< coefficient of Coulomb's law
  bool self = true;               ///< parts may meet themselves
  double tolerance = 1e-3;        ///< of the rate constraint, relative to its largest violation
  std::int32_t iterations = 200;  ///< at most
};

/// What a step did, the same on every rank.
struct ContactReport {
  std::int64_t active = 0;  ///< constraints with an impulse
  std::int64_t iterations = 0;
  double residual = 0;     ///< above the tolerance: the iteration ended at its limit
  double penetration = 0;  ///< the largest so far [length]
};

/// Contact between all parts of a mesh. It remembers what friction needs from step to step.
class ContactStep {
 public:
  /// Throws std::invalid_argument for arrays that do not fit together. Collective.
  ContactStep(MPI_Comm ranks, const ContactMesh& mesh, const ContactSettings& settings = {});
  ~ContactStep();
  ContactStep(ContactStep&&) noexcept;
  ContactStep& operator=(ContactStep&&) noexcept;

  /// One step from t_n to t_{n+1} = t_n + dt, central differences: position is x_n, velocity_before v at n - 1/2,
  /// velocity on entry what it would be at n + 1/2 without contact; it is corrected, so that x_{n+1} = x_n + dt
  /// velocity. Arrays hold x, y, z of each node of this rank, in the order of ContactMesh. impulse: of contact on each
  /// node [momentum], on every copy of a shared node the whole; may be empty. Collective.
  ContactReport correct(std::span<const double> position, std::span<const double> velocity_before,
                        std::span<double> velocity, double dt, std::span<double> impulse = {});

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace brunt::api
