// SPDX-License-Identifier: Apache-2.0
#include "small_motions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/cross_matrix.hpp"

namespace brunt::depth {
namespace {

constexpr int most_steps = 16;            // of one attempt
constexpr int most_idle = 3;              // steps in a row that leave more than
constexpr double idle = 0.9;              // of the least overlap so far
constexpr double trust_share = 2;         // of the overlap: size of a step
constexpr double band_share = 1;          // of the trust region: 2 sqrt(3) times it is the reach of a corner
constexpr double most_band = 0.1;         // of A's radius: larger overlaps are no matter of small motions
constexpr double beyond = 0.02;           // of the overlap: moved further
constexpr double usual_share = 2;         // of the bound: pairs that overlap by more are left out at first
constexpr double stiffness = 1e4;         // of t: then t is some 1e-4 of the motion where the conditions can be met
constexpr double least_curvature = 1e-9;  // of the object norm in rotations, relative
constexpr double feasible = 1e-12;        // of the trust region

}  // namespace

SmallMotions::SmallMotions(Encounter& encounter, const Mat3& basis, double margin, double bound)
    : encounter_(encounter), basis_(basis), margin_(margin), usual_(usual_share * bound) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  rows_.find(encounter_, {}, 2 * margin_, margin_, infinite);
  overlap_ = std::max(0.0, rows_.deepest - margin_);
  sum_ = rows_.sum_of_regions();
}

RigidMotion SmallMotions::step(const RigidMotion& from, Freedom freedom, double trust) {
  const MetricShape& shape = encounter_.a.shape;
  const double rho = shape.turn_length;
  program_.clear();
  for (const NearCondition& condition : rows_.conditions) {
    Row<7> row;
    if (freedom != Freedom::turn) row.normal.head<3>() = basis_.transpose() * condition.normal;
    if (freedom != Freedom::shift) row.normal.segment<3>(3) = condition.arm.cross(condition.normal) / rho;
    row.normal[6] = 1;
    row.bound = condition.bound * (condition.bound > 0 ? 1 + beyond : 1);
    if (trust * row.normal.head<6>().lpNorm<1>() * std::sqrt(3.0) < -row.bound) continue;
    program_.push_back(row);
  }
  for (const int part : {0, 3})
    for (int i = 0; i < 3; ++i)
      for (const double sign : {1.0, -1.0}) {
        Row<7> row;
        row.normal.segment<3>(part) =
            sign * (part == 0 ? Vec3(basis_.transpose() * encounter_.a.axes.col(i)) : Vec3(encounter_.a.axes.col(i)));
        row.bound = -trust;
        if (row.normal.norm() > 0) program_.push_back(row);
      }
  const Vec3 v = from.turn.vec();
  const Mat3 M = (0.5 / rho) * (from.turn.w() * Mat3::Identity() - cross_matrix(v));
  const Mat3 JM = shape.gyration * M;
  QuadraticProgram<7>::Matrix G = QuadraticProgram<7>::Matrix::Identity();
  G.block<3, 3>(3, 3) = 4 * M.transpose() * JM + least_curvature * Mat3::Identity();
  G(6, 6) = stiffness;
  QuadraticProgram<7>::Vector g = QuadraticProgram<7>::Vector::Zero();
  if (freedom != Freedom::turn) g.head<3>() = basis_.transpose() * from.shift;
  if (freedom != Freedom::shift) g.segment<3>(3) = 4 * JM.transpose() * v;
  QuadraticProgram<7> program(G, g);
  if (program.solve(program_, feasible * trust) != Outcome::solved) return from;
  const Vec3 tau = basis_ * program.x().head<3>(), omega = program.x().segment<3>(3) / rho;
  return compose(from, {rotation_of(omega), tau});
}

Start SmallMotions::attempt(const RigidMotion& from, Freedom freedom, Metric metric, double most) {
  const double widest = most_band * encounter_.a.shape.radius, overlap = std::min(overlap_, most);
  RigidMotion motion = from;
  double least = std::numeric_limits<double>::infinity();
  int waits = 0;
  for (int i = 0; i < most_steps; ++i) {
    if (!encounter_.collides(motion)) return {motion, length_of(encounter_.a.shape, metric, motion)};
    const double scale = i == 0 ? overlap + margin_ : std::max(rows_.deepest, 0.1 * overlap + margin_);
    const double trust = std::min(trust_share * scale, widest);
    rows_.find(encounter_, motion, std::min(band_share * trust, widest), margin_, most);
    waits = rows_.deepest < idle * least ? 0 : waits + 1;
    if (waits >= most_idle || rows_.conditions.empty()) break;
    least = std::min(least, rows_.deepest);
    motion = step(motion, freedom, trust);
  }
  return freed(encounter_, metric, motion);
}

Start SmallMotions::find(const RigidMotion& from, Freedom freedom, Metric metric) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (usual_ > 0 && overlap_ > usual_) {
    const Start start = attempt(from, freedom, metric, usual_);
    if (start.length >= 0) return start;
  }
  return attempt(from, freedom, metric, infinite);
}

}  // namespace brunt::depth
