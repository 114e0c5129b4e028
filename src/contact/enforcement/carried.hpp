// SPDX-License-Identifier: Apache-2.0
// Rows on points of bodies (contact/data/carriers.hpp). Impulses on the points are transferred to the bodies,
//   P = sum over points (p, r x p),   (dV, domega) = W P,   v = v* + dV + domega x r,
// with exact sums: they give the same bits in any order and on any number of ranks. In the row sums a body counts as
// one node of inverse mass 1, on which a row has the weight w = sqrt(largest eigenvalue of g W g^T), with g its 3x6
// block on the body. By Cauchy and Schwarz |g_q W g_p^T| <= w_q w_p, so H - G W G^T remains positive semidefinite.
//
// The row sums of a body grow with the number of its rows: if 10000 points rest on the floor and 4 carry another box,
// each of the 4 has a row sum of 10004. The rows of a body are therefore summed in groups (those with nodes, with
// immovable partners, with other bodies), with shares theta of sum 1
//   |sum_g x_g|^2 <= sum_g |x_g|^2 / theta_g   gives   H_q = w_q S_g / theta_g,  S_g = sum of w over q's group.
// theta_g = 1/2 (1/groups + S_g / sum of all S): half of it divides a body evenly, the other half favours a group that
// is nearly alone. Any grouping is valid, so a few groups by number (body modulo six) suffice.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/data/carriers.hpp"
#include "contact/data/constraint.hpp"
#include "contact/data/exchange.hpp"
#include "contact/data/row_matrix.hpp"
#include "core/binned_sum.hpp"

namespace brunt::contact {

/// Width of the binned sum of a node's impulses: two slices of four, three components and an unused one.
constexpr int impulse_width = 4 * bin_slices;

inline Vec3 sum_of_parts(std::span<const double> impulse_parts, std::size_t node) {
  const double* parts = &impulse_parts[node * impulse_width];
  return Vec3(parts[0], parts[1], parts[2]) + Vec3(parts[4], parts[5], parts[6]);
}

/// The effect of the rows on a body, with the same bits on every rank.
struct BodyAnswer {
  Vec6 impulse = Vec6::Zero();  ///< P: momentum, angular momentum about the centre
  Vec6 change = Vec6::Zero();   ///< W P: of its velocity, of its angular velocity
};

/// Groups of a body's rows: with nodes, with nothing that moves, with other bodies.
constexpr std::size_t body_groups = 8;

/// Binned sums with few enough terms to be exact.
struct BodyParts {
  /// Coarse and fine of the impulse (four each), then of the moment; or coarse and fine of each group's weights.
  std::array<double, bin_slices * body_groups> slices{};
  int terms = 0;
};

/// Part of a row in a body.
struct RowBlock {
  LocalIndex body = 0;
  Mat3 translation = Mat3::Zero(), rotation = Mat3::Zero();
};

/// Chains: bodies connected by soft rows between bodies (softness.hpp). A pair of bodies is one number, lower * bodies
/// + higher; a body with what is immovable: with itself.
struct ChainScratch {
  std::vector<double> own_pairs;       ///< of this rank's rows, ascending
  std::vector<double> last_own_pairs;  ///< of the step before
  std::vector<double> pairs;           ///< of all ranks, ascending
  std::vector<double> answer;          ///< largest n . g W g^T n of each body's soft rows, of all ranks [1/mass]
  std::vector<double> factor;          ///< of the compliance of a pair's rows
  std::vector<LocalIndex> chain;       ///< of each body
  std::vector<double> kept;            ///< share of the last impulses that a chain's rows keep
  std::vector<double> bounds;          ///< of the terms of a chain's sums
  std::vector<std::int64_t> sums;      ///< two a chain
  std::vector<LocalIndex> graph;       ///< scratch of the traversal of the pairs
  std::vector<double> along;           ///< likewise
  bool renewed = false;                ///< the pairs of this rank are not those of the step before

  void reserve(std::size_t rows, std::size_t bodies);
};

/// Arrays of what is carried, sized where lists are rebuilt.
struct CarriedScratch {
  std::vector<LocalIndex> place;   ///< of each contact node in Carriers::points; no_index: it is not carried
  std::vector<RowBlock> blocks;    ///< of one row
  std::vector<double> largest;     ///< what all ranks' maximum is taken of
  std::vector<LocalIndex> active;  ///< bodies that rows of any rank act on, ascending
  std::vector<LocalIndex> slot;    ///< of each body in there
  std::vector<BodyParts> parts;    ///< a body each
  std::vector<std::int64_t> sums;  ///< of active bodies, what all ranks' sum is taken of
  std::vector<double> share;       ///< w where the row acts, for each of RowMatrix::on_bodies
  std::vector<double> row_sum;     ///< S / theta, body_groups a body
  std::vector<BodyAnswer> answer;  ///< a body each, by the last impulses
  ChainScratch chains;
  bool any_soft = false;      ///< some rank has soft rows between bodies
  double spread = 1;          ///< most times that all rows' weights have a group's S / theta
  double longest_arm = 0;     ///< |r| of all ranks [length]
  double largest_weight = 0;  ///< w of all ranks

  void reserve(std::size_t rows, std::size_t nodes, std::size_t bodies);
};

/// Fills rows.on_bodies. Does nothing without bodies.
void lay_rows_on_bodies(const Carriers& carriers, std::span<const NodeMotion> motion, CarriedScratch& scratch,
                        RowMatrix& rows);

/// To be called first: determines the bodies on which rows of any rank act, and bounds. Collective.
void start_bodies(const Carriers& carriers, std::span<const NodeMotion> motion, const RowMatrix& rows,
                  Exchange& exchange, CarriedScratch& scratch);

/// scratch.row_sum from scratch.share. Collective.
void sum_rows_on_bodies(const RowMatrix& rows, Exchange& exchange, CarriedScratch& scratch);

/// From the impulses on the points of this rank (valid on owners): computes scratch.answer, and adds its effect to the
/// velocities of the points. largest: bound of a row's impulse on a point. Collective.
void add_answer_of_bodies(const Carriers& carriers, std::span<const NodeMotion> motion,
                          std::span<const double> impulse_parts, double largest, Exchange& exchange,
                          std::span<Vec3> velocity, CarriedScratch& scratch);

}  // namespace brunt::contact
