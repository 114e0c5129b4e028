// SPDX-License-Identifier: Apache-2.0
// The rows of one step as one system, G v >= required with v = v* + W G^T p, and the operations common to all solvers:
// missing rates, admissible impulses, the diagonal, velocities from impulses. Sums over rows are binned, so no bit
// depends on the ranks.
#pragma once
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "contact/data/carriers.hpp"
#include "contact/data/constraint.hpp"
#include "contact/data/exchange.hpp"
#include "contact/data/row_matrix.hpp"
#include "contact/enforcement/carried.hpp"
#include "contact/enforcement/packed_rows.hpp"
#include "core/binned_sum.hpp"

namespace brunt::contact {

struct System {
  const RowMatrix& rows;
  std::span<const NodeMotion> motion;  ///< of all contact nodes of this rank
  std::span<const Mobility> mobility;  ///< the same
  bool two_passes = false;             ///< rows may belong to one pass only, on some rank: see surface/passes.hpp
  double mobility_scale = 1;  ///< of all inverse masses: 1 / (1 + alpha dt / 2) with mass damping, which is part of W
  Carriers carriers{};        ///< whose blocks the rows have: see lay_rows_on_bodies
  std::span<const GlobalIndex> gid{};  ///< of all contact nodes; empty on one rank: see islands.hpp
};

/// Width of the sum of a node's rows: two slices and the number of rows.
constexpr int row_sum_width = bin_slices + 1;

/// Data of a sliding row.
struct Slide {
  Vec3 direction = Vec3::Zero();  ///< t, of its friction; zero: it has none
  double give = 0;                ///< of its friction across t, slip / limit [1/mass]
};

/// Numbers for which arrays have room.
struct RowRoom {
  std::size_t rows = 0, entries = 0;  ///< entries: points of all rows
  std::size_t arms = 0;               ///< points of those that turn
  std::size_t tilts = 0;              ///< points of those that tilt
  std::size_t points_of_a_row = most_nodes_of_a_row;
};

/// Arrays of the solvers, sized when lists are rebuilt, so that a step allocates nothing.
struct EnforcementScratch {
  std::vector<double> diagonal;           ///< H [1/mass], a row each; 0: no impulse in this row can change its rate
  std::vector<Vec3> previous;             ///< impulses of the iterate before, a row each
  std::vector<double> compliance;         ///< C of soft rows [1/mass], 0 of others; see softness.hpp
  std::vector<Vec3> borne;                ///< C times the part of the previous impulse that is kept [velocity]
  std::vector<Vec3> missing;              ///< missing rates of the rows [velocity], one for each row
  std::vector<Vec3> step, direction;      ///< of conjugate residuals [momentum], a row each
  std::vector<Vec3> step_change, change;  ///< G W G^T of them [velocity], a row each
  std::vector<double> inverse;            ///< of the diagonal, 0 for 0 [mass], a row each
  std::vector<char> chosen;               ///< active rows of conjugate residuals, one flag for each row
  std::vector<Slide> slide;               ///< of rows that slide among them
  std::vector<double> share;              ///< |G_qn P_n| (of an arm: a bound of it), an entry each
  std::vector<double> row_sum;            ///< s, a node each
  std::vector<double> row_sum_parts;      ///< row_sum_width a node
  std::vector<double> impulse_parts;      ///< impulse_width a node, see impulse_of_node
  CarriedScratch carried;                 ///< of rigid bodies
  PackedRows packed;                      ///< of iterations by row sums and by Barzilai-Borwein steps

  RowMatrix matrix;                        ///< of the rows of the step
  RowMatrix pass_rows;                     ///< of two passes, the one being solved
  std::vector<Vec3> pass_impulses;         ///< of those rows
  std::array<std::vector<Vec3>, 2> start;  ///< of all rows, where each pass starts from
  std::vector<double> asked;               ///< of all rows, the least rate asked for [velocity]

  void reserve(const RowRoom& room, std::size_t nodes);
  void reserve_passes(const RowRoom& room);                                      ///< besides, for two passes
  void reserve_bodies(std::size_t rows, std::size_t nodes, std::size_t bodies);  ///< besides, for rigid bodies
};

/// The impulse of the rows on a node after the last `apply_impulses`, on its owner [momentum].
inline Vec3 impulse_of_node(const EnforcementScratch& scratch, std::size_t node) {
  return sum_of_parts(scratch.impulse_parts, node);
}

/// Throws GuardError if the largest impulse is not finite.
void demand_finite(double largest);

/// Maximum that propagates NaN, for which all comparisons are false.
inline void keep_max(double& largest, double value) {
  if (!(value <= largest)) [[unlikely]]
    largest = std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
}

/// Of the row's nodes [velocity]; see Row.
Vec3 relative_velocity(const Row& row, std::span<const Vec3> velocity);
Vec3 relative_velocity(const RowMatrix& rows, std::size_t q, std::span<const Vec3> velocity);

/// Bound of the impulse of a row on any of its nodes, over these rows [momentum].
double largest_impulse_on_a_node(const RowMatrix& rows, std::span<const Vec3> impulses);

/// Largest max(0, required - n . v) over this rank's rows that can act (for rows with a free tangential impulse also
/// across the normal).
double violation_here(const System& system, std::span<const Vec3> velocity);

/// v = v*.
void take_prediction(const System& system, std::span<Vec3> velocity);

/// The same, and the largest violation by it. Collective.
double start_from_prediction(const System& system, Exchange& exchange, std::span<Vec3> velocity);

/// Fills scratch.diagonal with the row sums H_q = sum_n |G_qn P_n| s_n / m_n, s_n = sum_p |G_pn P_n|: H - G W G^T is
/// positive semidefinite by Gershgorin's theorem. Returns whether rows of this rank share nodes with other rows, or act
/// on bodies with joints; otherwise H equals G W G^T. If a function is given, only its rows count; others have zero.
/// Collective.
bool form_row_sums(const System& system, Exchange& exchange, EnforcementScratch& scratch,
                   bool (*counts)(const RowMatrix&, std::size_t q) = nullptr);

/// form_row_sums and apply_impulses of the initial impulses, with half of their messages.
bool start_from_impulses(const System& system, std::span<const Vec3> impulses, double largest, Exchange& exchange,
                         std::span<Vec3> velocity, EnforcementScratch& scratch);

/// Fills scratch.diagonal with the diagonal of G W G^T.
void form_diagonal(const System& system, EnforcementScratch& scratch);

/// v = v* + W G^T p on owners, then on every copy. largest: bound of the impulse on a node, the same on all ranks.
/// Collective.
void apply_impulses(const System& system, std::span<const Vec3> impulses, double largest, Exchange& exchange,
                    std::span<Vec3> velocity, EnforcementScratch& scratch);

/// Computes W G^T p only, in place of the velocity. Collective.
void velocities_of_impulses(const System& system, std::span<const Vec3> impulses, double largest, Exchange& exchange,
                            std::span<Vec3> velocity, EnforcementScratch& scratch);

}  // namespace brunt::contact
