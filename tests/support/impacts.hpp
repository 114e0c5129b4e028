// SPDX-License-Identifier: Apache-2.0
// Bodies of random shape, mesh, material, attitude and speed that run into each other, and what is seen of it.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string>

#include "mesh/mesh.hpp"

namespace brunt::test {

struct Impact {
  mesh::Mesh mesh;  ///< blocks one and two
  std::string scene;
  double edge = 0;  ///< of the finer mesh, about [length]
  double end = 0;   ///< after the blow [time]
};

/// A function of the seed alone, but for the passes: one, two or auto.
Impact random_impact(unsigned seed, const std::string& passes);

/// Lengths in mean edges of the face beside the point, energies in what there is at the start.
struct ImpactFigures {
  double reported = 0;      ///< deepest row
  double not_there = 0;     ///< most by which a row is deeper than twice what its own point really is
  double held = 0;          ///< deepest node of a side whose nodes are held by rows
  double held_middle = 0;   ///< the same, of nodes beside the middle of a face: at least a tenth of it from its border
  double not_reported = 0;  ///< most by which such a node is deeper than the deepest row of the step
  double others = 0;        ///< deepest node of a side whose nodes are not held (the master of one pass)
  double edges = 0;         ///< deepest point on an edge of either
  double given = 0;         ///< most that contact gave at any time, on the whole
  double returned = 0;      ///< most by which it gave back what it took, but for what soft rows have stored
  double error = 0;         ///< of the sum of energies
  double momentum = 0;      ///< error of the momentum
  double held_at = 0;       ///< when `held` was seen [time]
  int contact_steps = 0;    ///< with rows
};
ImpactFigures run_impact(unsigned seed, const std::string& passes);

/// Criteria of tests/hard that a run may miss.
enum class Criterion {
  depth,    ///< held nodes 1e-2 of an edge deep at most, in the middle of faces, and no more than 1e-2 unreported
  reports,  ///< rows are no deeper than twice what is there, and 0.02 of an edge
  energy,   ///< contact gives back 1e-3 of the energy at most
  given,    ///< on the whole it gives 1e-4 of the energy at most at any time
  edges     ///< points on edges, and nodes of a side that is not held, 0.05 of an edge deep at most
};
inline constexpr std::array criteria{Criterion::depth, Criterion::reports, Criterion::energy, Criterion::given,
                                     Criterion::edges};
constexpr double limit_of(Criterion criterion) {
  constexpr std::array limits{1e-2, 0.02, 1e-3, 1e-4, 0.05};
  return limits[static_cast<std::size_t>(criterion)];
}
/// One pass holds the nodes of one side alone: what that leaves of edges and of the other side is not judged.
inline bool is_judged(Criterion criterion, const std::string& passes) {
  return criterion != Criterion::edges || passes != "one";
}
/// What is judged by it.
double figure_of(const ImpactFigures& figures, Criterion criterion);

/// A run that misses a criterion today, and our figure.
struct MissedImpact {
  Criterion criterion;
  const char* passes;
  unsigned seed;
  double ours;
};
std::span<const MissedImpact> missed_impacts();
bool is_missed(Criterion criterion, const std::string& passes, unsigned seed);

}  // namespace brunt::test
