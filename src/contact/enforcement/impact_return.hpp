// SPDX-License-Identifier: Apache-2.0
// Return at opening for coupled rows (src/contact/enforcement/IMPACT.md; the law of one row: impact_law.hpp).
//
// p_0 is the solution of the rate constraint. Where rows open that have energy to return, p_1 is a second solution in
// which they require the rates that return it. The step takes
//   p_0 + theta (p_1 - p_0),   theta in [0, 1] the largest share of each island
// that does at most sum w B more work on its bodies than p_0: neither along the normals nor in all. From the sum is
// taken what p_0 gives by rows that open, and what other rows owe (B < 0). The work is quadratic in theta. Cones and
// required rates are convex, so every share is admissible; islands without a row that opens keep p_0. A second solution
// that ends early is not taken.
#pragma once
#include <span>
#include <vector>

#include "contact/enforcement/enforce.hpp"
#include "contact/enforcement/impact_law.hpp"
#include "contact/enforcement/island_sums.hpp"
#include "contact/enforcement/islands.hpp"
#include "contact/enforcement/system.hpp"

namespace brunt::contact {

/// Of a row in a step.
struct ImpactRow {
  ImpactState state{};
  double transit = 0;  ///< longest time in which a wave crosses a half element of its nodes [time]; 0: it takes no part
  ImpactStep step{};
  double offered = 0;  ///< w B of a row that opens [energy]
};

/// Sized when lists are rebuilt; empty without Impact::elastic.
struct ImpactScratch {
  std::vector<ImpactRow> rows;
  std::vector<double> flow;         ///< of contact nodes
  std::vector<Vec3> start;          ///< impulses that the first solution began with [momentum], a row each
  std::vector<Vec3> first;          ///< p_0 [momentum], a row each
  std::vector<Vec3> velocity;       ///< of the contact nodes by p_0
  std::vector<double> required;     ///< of the rate constraint [velocity], a row each
  std::vector<ImpactState> states;  ///< a row each
  std::vector<char> takes_part;     ///< in an island, a flag a row
  std::vector<double> terms;        ///< of the work, a row each
  std::vector<double> share;        ///< theta, an island each
  Islands islands;
  IslandSums sums;
  bool returned = false;  ///< p_0 is not the solution of the step

  void reserve(std::size_t most_rows, std::size_t nodes, std::size_t bodies);
};

/// Figures of row q by the rate constraint, without `flow`. transit: of contact nodes; dt: length of the step.
ImpactStep impact_step(const System& system, std::size_t q, std::span<const double> transit, double dt,
                       const Vec3& impulse, std::span<const Vec3> velocity);

/// The largest transit of the row's nodes [time].
double transit_of(const RowMatrix& rows, std::size_t q, std::span<const double> transit);

/// Rows that open return their energy. impact.rows: complete but for `offered`. rows: those of the system. In, the
/// solution of the rate constraint that began with impact.start; out, that of the step. It finds islands in steps in
/// which rows return energy, with messages of their own. Collective.
void return_at_opening(const System& system, RowMatrix& rows, const EnforcementSettings& settings, double dt,
                       Exchange& exchange, std::span<Vec3> impulses, std::span<Vec3> velocity,
                       EnforcementScratch& scratch, ImpactScratch& impact, EnforcementResult& result);

/// The state of each row after the step, in impact.states. impulses: of the step, with the velocities that they lead
/// to.
void follow_impacts(const System& system, double dt, std::span<const Vec3> impulses, std::span<const Vec3> velocity,
                    ImpactScratch& impact);

}  // namespace brunt::contact
