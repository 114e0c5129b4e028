// SPDX-License-Identifier: Apache-2.0
// The matrix's rows of rigid bodies and of their nodes.
#include <Eigen/Geometry>
#include <algorithm>

#include "comm/rendezvous.hpp"
#include "core/cross_matrix.hpp"
#include "implicit/rigid_bodies.hpp"
#include "implicit/solver.hpp"
#include "rigid/rotation.hpp"

namespace brunt::implicit {
namespace {

/// Derivative of the residual force at a body's node by one unknown, and the node's arm.
struct Piece {
  GlobalIndex node = 0, column = 0;
  LocalIndex body = 0;
  double slope[3]{}, arm[3]{};
};

Vec3 arm_of(const BodyTrial& trial, const Vec3& arm, bool moves) {
  const Vec3 now = trial.turn_now * arm;
  return moves ? Vec3(0.5 * (trial.turn_before * arm + now)) : now;
}

Piece piece_of(const Solver& solver, std::size_t own) {
  const RigidBodies::Place& place = solver.bodies.place[own];
  Piece piece;
  piece.node = solver.unknowns.row[3 * own] / 3;
  piece.body = place.body;
  Eigen::Map<Vec3>(static_cast<double*>(piece.arm)) =
      arm_of(nth(solver.bodies.trial, place.body), place.arm, solver.trial.rule.mass > 0);
  return piece;
}

/// Blocks of elements and pressed faces in the rows of the bodies' nodes.
void take_blocks(const Solver& solver, std::vector<Piece>& pieces) {
  const NodeRows& rows = solver.stiffness.rows();
  for (std::size_t own = 0; own < solver.bodies.place.size(); ++own) {
    if (!solver.bodies.carries(own) || !solver.bodies.place[own].forced) continue;
    Piece piece = piece_of(solver, own);
    for (std::int64_t at = rows.begin[own]; at < rows.begin[own + 1]; ++at)
      for (int j = 0; j < 3; ++j) {
        piece.column = 3 * nth(rows.column, at) + j;
        for (int i = 0; i < 3; ++i) piece.slope[i] = solver.trial.rule.now * nth(rows.value, 9 * at + 3 * i + j);
        if (piece.slope[0] != 0 || piece.slope[1] != 0 || piece.slope[2] != 0) pieces.push_back(piece);
      }
  }
}

/// Walls at the bodies' nodes.
void take_walls(const Solver& solver, FrictionLimit limit, std::vector<Piece>& pieces) {
  for (const WallNode& node : solver.walls.nodes) {
    if (!node.springs || node.action.own.isZero(0)) continue;
    Piece piece = piece_of(solver, node.own);
    const Mat3 own = limit == FrictionLimit::given ? Mat3(node.action.own - node.action.by_pressure) : node.action.own;
    for (int j = 0; j < 3; ++j) {
      piece.column = 3 * piece.node + j;
      for (int i = 0; i < 3; ++i) piece.slope[i] = own(i, j);
      pieces.push_back(piece);
    }
  }
}

/// Contact's terms in those rows, in their order.
void take_terms(const Solver& solver, std::vector<ContactTerm>& terms, std::vector<Piece>& pieces) {
  std::vector<ContactTerm> others;
  for (const ContactTerm& term : terms) {
    const auto row = std::ranges::lower_bound(solver.unknowns.row, term.row);
    const auto own = static_cast<std::size_t>(row - solver.unknowns.row.begin()) / 3;
    if (row == solver.unknowns.row.end() || *row != term.row || !solver.bodies.carries(own)) {
      others.push_back(term);
      continue;
    }
    Piece piece = piece_of(solver, own);
    piece.column = term.column;
    piece.slope[term.row % 3] = term.value;
    pieces.push_back(piece);
  }
  terms = std::move(others);
}

/// u - d - (R - 1) arm = 0 of this rank's nodes, with the stiffness of supports.
void add_node_rows(const Solver& solver, std::vector<ContactTerm>& terms) {
  const double stiffness = solver.support_stiffness;
  for (std::size_t own = 0; own < solver.bodies.place.size(); ++own) {
    if (!solver.bodies.carries(own)) continue;
    const RigidBodies::Place& place = solver.bodies.place[own];
    const auto b = static_cast<std::size_t>(place.body);
    const GlobalIndex first = solver.bodies.first + static_cast<GlobalIndex>(body_unknowns * b);
    const Mat3 by_arc = 1 / solver.bodies.radius[b] * cross_matrix(solver.bodies.trial[b].turn_now * place.arm);
    for (int i = 0; i < 3; ++i) {
      const GlobalIndex row = solver.unknowns.row[3 * own + static_cast<std::size_t>(i)];
      terms.push_back({row, row, stiffness});
      terms.push_back({row, first + i, -stiffness});
      for (int j = 0; j < 3; ++j)
        if (by_arc(i, j) != 0) terms.push_back({row, first + 3 + j, stiffness * by_arc(i, j)});
    }
  }
}

/// Inertia, turned arms and supports: six rows by the body's own six unknowns.
void add_own_block(const model::RigidBody& body, const Solver& solver, FrictionLimit limit, std::size_t b,
                   std::vector<ContactTerm>& terms) {
  const BodyTrial& trial = solver.bodies.trial[b];
  const Rule& rule = solver.trial.rule;
  const double radius = solver.bodies.radius[b];
  const double stiffness = limit == FrictionLimit::given ? 0 : solver.support_stiffness;
  const Mat3 &free_shift = body.support.free_shift, &free_turn = body.support.free_turn;
  const Mat3 one = Mat3::Identity();
  const Mat3 shift = rule.mass * body.body.mass.mass * free_shift + stiffness * (one - free_shift);
  Mat3 by_turn = trial.by_arms;
  if (rule.mass > 0) by_turn += trial.momentum.slope / rule.dt;
  const Mat3 turn = free_turn * by_turn / (radius * radius) +
                    stiffness * (one - free_turn) * rigid::rotation_vector_slope(rigid::rotation_vector(trial.turn));
  const GlobalIndex first = solver.bodies.first + static_cast<GlobalIndex>(body_unknowns * b);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      if (shift(i, j) != 0) terms.push_back({first + i, first + j, shift(i, j)});
      if (turn(i, j) != 0) terms.push_back({first + 3 + i, first + 3 + j, turn(i, j)});
    }
}

/// Assembles the rows of bodies from the pieces of all ranks: those of a node are of one rank, and keep their order.
void add_body_rows(const Scene& scene, const Solver& solver, FrictionLimit limit, std::vector<Piece>& pieces,
                   std::vector<ContactTerm>& terms) {
  std::ranges::stable_sort(pieces, {}, &Piece::node);
  for (const Piece& piece : pieces) {
    const auto b = static_cast<std::size_t>(piece.body);
    const rigid::Support& support = scene.model.bodies[b].support;
    const Vec3 slope(static_cast<const double*>(piece.slope));
    const Vec3 force = support.free_shift * slope;
    const Vec3 moment =
        support.free_turn * (1 / solver.bodies.radius[b] * Vec3(static_cast<const double*>(piece.arm)).cross(slope));
    const GlobalIndex first = solver.bodies.first + static_cast<GlobalIndex>(body_unknowns * b);
    for (int i = 0; i < 3; ++i) {
      if (force[i] != 0) terms.push_back({first + i, piece.column, force[i]});
      if (moment[i] != 0) terms.push_back({first + 3 + i, piece.column, moment[i]});
    }
  }
  for (std::size_t b = 0; b < solver.bodies.trial.size(); ++b)
    add_own_block(scene.model.bodies[b], solver, limit, b, terms);
}

}  // namespace

void body_terms(const Scene& scene, Solver& solver, FrictionLimit limit, std::vector<ContactTerm>& terms) {
  for (BodyTrial& trial : solver.bodies.trial) {  // rotations are now relative to the orientation of this iterate
    trial.base = trial.orientation;
    trial.base_arc = trial.arc;
  }
  std::vector<std::vector<Piece>> to_rank(static_cast<std::size_t>(scene.links.ranks.size()));
  take_blocks(solver, to_rank.front());
  take_walls(solver, limit, to_rank.front());
  take_terms(solver, terms, to_rank.front());
  std::vector<Piece> pieces = comm::exchange(scene.links.ranks, to_rank).values;
  add_node_rows(solver, terms);
  if (solver.bodies.rows_here) add_body_rows(scene, solver, limit, pieces, terms);
  std::ranges::stable_sort(terms, comes_before);
}

}  // namespace brunt::implicit
