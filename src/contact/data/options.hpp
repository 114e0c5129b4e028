// SPDX-License-Identifier: Apache-2.0
// Choices of the user for contact.
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

/// Whether the method satisfies the exact complementarity conditions: rows of both passes can then be combined without
/// conflict.
constexpr bool holds_rates(Method method) {
  return method == Method::rate || method == Method::row_sum || method == Method::reference;
}

/// Number of passes in which two sides have contact: nodes of one side on faces of the other, or both (see passes.hpp).
enum class Passes : std::int8_t {
  automatic,  ///< two within a body, and between bodies of similar meshes without a named slave; otherwise one, in
              ///< which nodes on the master's rims are constrained as well
  one,
  two,      ///< constrained by one system of rows
  mortar,   ///< one row a slave node, of the gap averaged over the facets around it (contact/mortar_rows); two, where
            ///< nothing is covered or faces are not smooth
  averaged  ///< two, solved separately; the mean of their impulses acts; then used for all pairs of a scene
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

/// How nodes in capture boxes are found on a rank: all methods find the same pairs.
enum class SearchMethod : std::int8_t {
  automatic,  ///< blocks: the fastest on most scenes, and the only one whose work does not depend on the shape of the
              ///< scene
  blocks,     ///< blocks of points along a space-filling curve below a tree of boxes (search/search.hpp)
  binary,     ///< bisection of lists sorted along the axes: Heinstein et al. 2000, section 4.4
  bucket      ///< sort into buckets: section 4.3
};

/// Whether two blocks are tied.
enum class Tied : std::int8_t {
  no,
  yes,   ///< nodes at faces at the start are tied, others have ordinary contact
  alone  ///< those are tied, and there is no other contact between the two
};

/// Treatment of nodes of two parts that overlap initially.
enum class OverlapRule : std::int8_t {
  error,   ///< the scene is rejected
  warn,    ///< they are reported, and recovered slowly
  move,    ///< nodes are moved out before the run
  offset,  ///< they are kept as zero gap
  place    ///< whole parts are moved apart before the run
};

/// Criterion among faces that compete for a node at a convex place (Heinstein et al. 2000, section 4.5, Fig. 8).
enum class Criterion : std::int8_t {
  automatic,  ///< nodes in contact by the smallest |gap|, nodes coming into contact by the earliest time
  nearest,    ///< the smallest |gap| for all
  strength,   ///< the greatest |gap| times the cosine between the slave's and the master's normal
  velocity    ///< the earliest time for all nodes whose path crosses a face, |gap| for the rest
};

/// Time of rebuilding the lists; results do not depend on it.
struct Rebuild {
  enum class When : std::int8_t { motion_used_up, every, random } when = When::motion_used_up;
  int steps = 1;           ///< for `every`, in addition to rebuilding when the motion is used up
  std::uint64_t seed = 1;  ///< for `random`, in about one step of four
  friend bool operator==(const Rebuild&, const Rebuild&) = default;
};

/// What becomes of the energy of the layers of elements that meet (src/contact/enforcement/IMPACT.md).
enum class Impact : std::int8_t {
  plastic,  ///< contact takes it: a perfectly plastic impact of the half elements at the surfaces
  elastic   ///< each row returns it as it opens, unless adjacent elements have flowed; of rate and row_sum
};

struct EnforcementSettings {
  Method method = Method::rate;
  double tolerance = 1e-3;  ///< of the residual, relative to the largest violation by the predicted velocities
  /// Upper bound of the iterations. Table in cases/README.md ("Softness of contact"): the largest numbers occur at
  /// first impacts of non-matching meshes with two passes.
  int max_iterations = 200;
  /// For rate and row_sum between bodies: start from the impulses of the last step, otherwise from zero. A start from
  /// zero leaves a residual of the size of the tolerance in every step, which varies with the number of iterations and
  /// excites bodies at rest (up to 1e-8 of m g h for stacked cubes). A warm start leaves a share of the change since
  /// the last step, which vanishes at rest (1e-20), and needs a fifth of the iterations there.
  bool warm_start = true;
  /// For rows of one of two passes: see enforcement/softness.hpp. Only if impulses are remembered (rate and row_sum
  /// with warm_start, no averaged pair). 0: rigid, which transmits uniform pressure exactly (table in cases/README.md,
  /// "Softness of contact").
  double softness = 0;
  /// The same for rows between rigid bodies, which are redundant: without softness stacks need several times as many
  /// iterations.
  double softness_of_bodies = 0.05;
  Impact impact = Impact::plastic;
  bool averaged = false;   ///< of two passes: see Passes::averaged; penalty, kinematic and printed methods always
  double partition = 1;    ///< beta of (24): share of the gap that one pass closes
  double stiffness = 0.1;  ///< of penalties, in units of 1 / (H dt^2); at most 2
  double damping = 0.1;    ///< of the rate's penalty, in units of 1 / H; at most 1
};

/// Coulomb friction; the coefficient decreases from `fixed` at rest to `kinetic` with exp(-decay |slip rate|). With a
/// lag, the friction limit tau follows the value of the law with a delay, dtau/dt = (coefficient times pressure - tau)
/// / lag: the regularised law of Prakash and Clifton (1993) in the form of Cochard and Rice, J. Geophys. Res. 105
/// (2000) 25891. With Coulomb's law, sliding elastic bodies have self-excited oscillations for coefficients above 0.3
/// to 0.5 (Martins et al., 1995). A lag longer than the periods of these oscillations removes them; a shorter one
/// amplifies them.
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
