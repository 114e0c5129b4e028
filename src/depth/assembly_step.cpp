// SPDX-License-Identifier: Apache-2.0
#include "assembly_step.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/cross_matrix.hpp"

namespace brunt::depth {
namespace {

constexpr double feasible = 1e-12;        // of the trust region: smaller violations of a condition count as none
constexpr double least_curvature = 1e-9;  // of the object norm in rotations, relative: it vanishes at phi = pi
constexpr int most_rounds = 500;          // of added conditions: random stacks of ten boxes need at most 40

}  // namespace

AssemblyStep::AssemblyStep(const Standing& standing, const Pose& pose) : standing_(standing) {
  const std::size_t n = standing.assembly().members.size();
  double mass = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const Member& member = standing.member(k);
    Place& place = places_.emplace_back();
    place.first = count_;
    place.along.setZero();
    for (int c = 0; c < 3; ++c)
      if (!member.basis.col(c).isZero(0)) place.along.col(place.shifts++) = member.basis.col(c);
    place.turns = member.turns;
    place.rho = std::sqrt(0.5 * member.gyration.trace());
    count_ += place.shifts + (member.turns ? 3 : 0);
    if (member.moves()) mass += member.mass;
  }
  const auto unknowns = static_cast<std::size_t>(count_);
  G_.assign(unknowns * unknowns, 0.0);
  g_.assign(unknowns, 0.0);
  const auto entry = [&](int i, int j) -> double& {
    return G_[static_cast<std::size_t>(i) * unknowns + static_cast<std::size_t>(j)];
  };
  for (std::size_t k = 0; k < n; ++k) {
    const Member& member = standing.member(k);
    if (!member.moves()) continue;
    const Place& place = places_[k];
    const RigidMotion& motion = pose.motions[k];
    const double share = member.mass / mass;
    const Vec3 v = motion.turn.vec();
    constant_ += share * (motion.shift.squaredNorm() + 4 * v.dot(member.gyration * v));
    for (int c = 0; c < place.shifts; ++c) {
      entry(place.first + c, place.first + c) = share;
      nth(g_, place.first + c) = share * place.along.col(c).dot(motion.shift);
    }
    if (!place.turns) continue;
    const int at = place.first + place.shifts;
    const Mat3 M = (0.5 / place.rho) * (motion.turn.w() * Mat3::Identity() - cross_matrix(v));
    const Mat3 JM = member.gyration * M;
    const Mat3 block = share * (4 * M.transpose() * JM + least_curvature * Mat3::Identity());
    const Vec3 slope = share * (4 * JM.transpose() * v);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) entry(at + i, at + j) = 0.5 * (block(i, j) + block(j, i));
      nth(g_, at + i) = slope[i];
    }
  }
}

SmallMotion AssemblyStep::motion_of(const std::vector<double>& x) const {
  SmallMotion motion;
  for (const Place& place : places_) {
    Vec3 tau = Vec3::Zero(), omega = Vec3::Zero();
    const double* own = x.data() + place.first;
    for (int c = 0; c < place.shifts; ++c) tau += own[c] * place.along.col(c);
    if (place.turns) omega = Vec3(own[place.shifts], own[place.shifts + 1], own[place.shifts + 2]) / place.rho;
    motion.tau.push_back(tau);
    motion.omega.push_back(omega);
  }
  for (const double value : x) motion.size = std::max(motion.size, std::abs(value));
  return motion;
}

SparseRow AssemblyStep::row_of(const AssemblyCondition& condition) const {
  SparseRow row;
  row.bound = condition.bound;
  const MemberPair& pair = standing_.assembly().pairs[condition.pair];
  const auto lay = [&](std::size_t k, const Vec3& normal, const Vec3& arm) {
    const Place& place = places_[k];
    for (int c = 0; c < place.shifts; ++c) row.add(place.first + c, place.along.col(c).dot(normal));
    const Vec3 moment = arm.cross(normal) / place.rho;
    for (int c = 0; place.turns && c < 3; ++c) row.add(place.first + place.shifts + c, moment[c]);
  };
  lay(pair.a, condition.normal, condition.arm_a);
  lay(pair.b, -condition.normal, condition.arm_b);
  return row;
}

double approach(const Standing& standing, const AssemblyCondition& condition, const SmallMotion& motion) {
  const MemberPair& pair = standing.assembly().pairs[condition.pair];
  return condition.normal.dot(motion.tau[pair.a] + motion.omega[pair.a].cross(condition.arm_a) - motion.tau[pair.b] -
                              motion.omega[pair.b].cross(condition.arm_b));
}

std::optional<SmallMotion> AssemblyStep::solve(std::span<const AssemblyCondition> conditions, double trust,
                                               double& predicted) {
  SparseProgram program(G_, g_);
  std::vector<SparseRow> rows;
  const double tolerance = feasible * trust;
  std::vector<char> bounded(2 * static_cast<std::size_t>(count_), 0);
  SmallMotion motion = motion_of(program.x());
  for (int round = 0; round < most_rounds; ++round) {
    const std::size_t before = rows.size();
    for (int i = 0; i < count_; ++i)
      for (const double sign : {1.0, -1.0}) {
        char& there = bounded[2 * static_cast<std::size_t>(i) + (sign > 0 ? 0 : 1)];
        if (there || sign * nth(program.x(), i) >= -trust - tolerance) continue;
        there = 1;
        SparseRow& row = rows.emplace_back();
        row.add(i, sign);
        row.bound = -trust;
      }
    std::map<std::size_t, std::pair<double, const AssemblyCondition*>> worst;  // of each pair
    for (const AssemblyCondition& condition : conditions) {
      const double lack = condition.bound - approach(standing_, condition, motion);
      if (!(lack > 4 * tolerance)) continue;
      auto& entry = worst.try_emplace(condition.pair, 0.0, nullptr).first->second;
      if (lack > entry.first) entry = {lack, &condition};
    }
    for (const auto& [pair, entry] : worst) rows.push_back(row_of(*entry.second));
    if (rows.size() == before) {
      const double square = constant_ + 2 * program.value();
      predicted = std::sqrt(std::max(0.0, square));
      return motion;
    }
    if (program.solve(rows, tolerance) != Outcome::solved) return std::nullopt;
    motion = motion_of(program.x());
  }
  return std::nullopt;
}

}  // namespace brunt::depth
