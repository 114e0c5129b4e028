// SPDX-License-Identifier: Apache-2.0
// What a user may choose of contact.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

namespace brunt::contact {

/// The formulations of Heinstein et al. 2000; equations are theirs.
enum class Method : std::int8_t {
  rate,         ///< the rate constraint (22), iterated to a tolerance, see enforcement/conjugate.hpp
  row_sum,      ///< the same by (26) with row sums for H: slower, monotone
  printed,      ///< the same by (26) with H (29) as printed, which over-corrects (see enforcement/printed.hpp)
  kinematic,    ///< the partitioned kinematic predictor and one corrector (24), (25)
  gap_penalty,  ///< (16): a spring across penetrations; shortens the stable step
  penalty,      ///< (20): a spring and a damper
  reference     ///< the exact solution of (22) by PETSc: for comparisons, not bitwise the same on all ranks
};

/// By the exact law of complementarity: rows of both passes at once contradict each other in nothing.
constexpr bool holds_rates(Method method) {
  return method == Method::rate || method == Method::row_sum || method == Method::reference;
}

/// In how many passes two sides meet: nodes of the one on faces of the other, or both ways (see passes.hpp).
enum class Passes : std::int8_t {
  automatic,  ///< two within a body and between bodies of equal meshes, where no side is named the slave; else one, in
              ///< which nodes on the master's rims are held as well
  one,
  two,      ///< held by one system of rows
  averaged  ///< two, each solved by itself, and the mean of their impulses acts; then so do all of a scene's
};

/// As scenes name them.
constexpr std::array<std::pair<std::string_view, Method>, 7> method_names{{{"rate", Method::rate},
                                                                           {"row_sum", Method::row_sum},
                                                                           {"printed", Method::printed},
                                                                           {"kinematic", Method::kinematic},
                                                                           {"gap_penalty", Method::gap_penalty},
                                                                           {"penalty", Method::penalty},
                                                                           {"reference", Method::reference}}};
constexpr std::string_view name_of(Method method) {
  for (const auto& [name, named] : method_names)
    if (named == method) return name;
  return {};
}

/// Of two blocks: do they hold together?
enum class Tied : std::int8_t {
  no,
  yes,   ///< nodes at faces at the start do, others make contact as usual
  alone  ///< those do, and nothing else acts between the two
};

/// What becomes of nodes of two parts that lie inside each other at the start.
enum class OverlapRule : std::int8_t {
  error,   ///< the scene is refused
  warn,    ///< they are reported, and recovered slowly
  move,    ///< nodes are moved out before the run
  offset,  ///< they are kept as zero gap
  place    ///< whole parts are moved apart before the run
};

/// What decides among faces that compete for a node at a convex place (Heinstein et al. 2000, section 4.5, Fig. 8).
enum class Criterion : std::int8_t {
  automatic,  ///< nodes in contact by the smallest |gap|, nodes coming into contact by the earliest time
  nearest,    ///< the smallest |gap| for all
  strength,   ///< the greatest |gap| times the cosine between the slave's and the master's normal
  velocity    ///< the earliest time for all nodes whose path crosses a face, |gap| for the rest
};

/// When lists are rebuilt; no result depends on it.
struct Rebuild {
  enum class When : std::int8_t { motion_used_up, every, random } when = When::motion_used_up;
  int steps = 1;           ///< for `every`, besides when the motion is used up
  std::uint64_t seed = 1;  ///< for `random`, in about one step of four
  friend bool operator==(const Rebuild&, const Rebuild&) = default;
};

struct EnforcementSettings {
  Method method = Method::rate;
  double tolerance = 1e-3;  ///< of the residual, relative to the largest violation by the predicted velocities
  /// First impacts of meshes askew take 13 to 75 in two passes, a pile of cubes 100 in its worst step; most end long
  /// before.
  int max_iterations = 200;
  /// Of rate and row_sum between bodies: start from the impulses of the last step, else from zero. A cold start leaves
  /// a residual of the size of the tolerance in every step, which jumps with the number of iterations: it stirs turned
  /// cubes at rest on each other up to 1e-8 of m g h. A warm one leaves a share of what has changed since the last
  /// step, which is nothing at rest (1e-20), and takes a fifth of the iterations there.
  bool warm_start = true;
  /// Of rows of one of two passes: see enforcement/softness.hpp. Only where impulses are remembered (rate and row_sum
  /// with warm_start, no pair averaged). 0: rigid, which passes even pressure on exactly, in the same time as 0.05,
  /// whose error is 1 to 2.4 % (table in cases/README.md, "Softness of contact").
  double softness = 0;
  /// The same of rows between rigid bodies, which are redundant: a stack of six takes 5 times the iterations with 0.
  double softness_of_bodies = 0.05;
  bool averaged = false;   ///< of two passes: see Passes::averaged; penalty, kinematic and printed methods always
  double partition = 1;    ///< beta of (24): share of the gap that a pass closes
  double stiffness = 0.1;  ///< of penalties, in units of 1 / (H dt^2); at most 2
  double damping = 0.1;    ///< of the rate's penalty, in units of 1 / H; at most 1
};

/// Coulomb friction; the coefficient falls from `fixed` at rest to `kinetic` with exp(-decay |slip rate|). With a lag
/// the limit tau of friction follows its law's value late, dtau/dt = (coefficient times pressure - tau) / lag: the
/// regularised law of Prakash and Clifton (1993) in the form of Cochard and Rice, J. Geophys. Res. 105 (2000) 25891.
/// Coulomb's law at once makes elastic bodies that slide shiver by themselves from coefficients of 0.3 to 0.5 on
/// (Martins et al., 1995); a lag longer than the periods of that shiver takes it away, a shorter one feeds it.
struct FrictionLaw {
  double fixed = 0, kinetic = 0;
  double decay = 0;  ///< [time/length]
  double lag = 0;    ///< [time]

  [[nodiscard]] double coefficient(double slip_rate) const {
    return kinetic + (fixed - kinetic) * std::exp(-decay * slip_rate);
  }
  [[nodiscard]] bool any() const { return fixed > 0 || kinetic > 0; }
};

}  // namespace brunt::contact
