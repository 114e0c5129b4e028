// SPDX-License-Identifier: Apache-2.0
#include "depth/local_step.hpp"

#include <algorithm>
#include <cmath>

#include "core/cross_matrix.hpp"

namespace brunt::depth {
namespace {

constexpr double feasible = 1e-12;        // of the trust region: smaller violations of a row count as none
constexpr double proximal = 1e-3;         // eps
constexpr int most_cuts = 80;             // of one step
constexpr double least_curvature = 1e-9;  // of the object norm in rotations, relative: it vanishes at phi = pi

/// Whether no motion in the trust region can violate the condition.
bool out_of_reach(const NearCondition& condition, const LocalProblem& problem, double turn_length) {
  const Vec3 normal = problem.axes.transpose() * condition.normal;
  const Vec3 moment = problem.axes.transpose() * condition.arm.cross(condition.normal) / turn_length;
  return problem.trust * (normal.lpNorm<1>() + moment.lpNorm<1>()) < -condition.bound;
}

template <int N>
void lay_rows(std::span<const NearCondition> conditions, const LocalProblem& problem, double turn_length,
              std::vector<Row<N>>& rows) {
  rows.clear();
  for (const NearCondition& condition : conditions) {
    if (out_of_reach(condition, problem, turn_length)) continue;
    Row<N> row;
    row.normal.template head<3>() = condition.normal;
    row.normal.template segment<3>(3) = condition.arm.cross(condition.normal) / turn_length;
    row.bound = condition.bound;
    rows.push_back(row);
  }
  for (const int part : {0, 3})
    for (int i = 0; i < 3; ++i)
      for (const double sign : {1.0, -1.0}) {
        Row<N> row;
        row.normal.template segment<3>(part) = sign * problem.axes.col(i);
        row.bound = -problem.trust;
        rows.push_back(row);
      }
}

LocalStep step_from(const RigidMotion& motion, const Vec3& tau, const Vec3& omega, const LocalProblem& problem,
                    double rho, double predicted) {
  LocalStep step;
  step.motion = compose(motion, {rotation_of(omega), tau});
  step.predicted = predicted;
  step.tau = tau;
  step.omega = omega;
  const auto along_axes = [&](const Vec3& x) { return (problem.axes.transpose() * x).lpNorm<Eigen::Infinity>(); };
  step.size = std::max(along_axes(tau), rho * along_axes(omega));
  step.solved = true;
  return step;
}

}  // namespace

LocalStep LocalSolver::shift_only(const RigidMotion& motion, std::span<const NearCondition> conditions,
                                  const LocalProblem& problem) {
  rows3_.clear();
  for (const NearCondition& condition : conditions)
    rows3_.push_back({problem.basis.transpose() * condition.normal, condition.bound});
  for (int i = 0; i < 3; ++i)
    for (const double sign : {1.0, -1.0})
      rows3_.push_back({sign * (problem.basis.transpose() * problem.axes.col(i)), -problem.trust});
  QuadraticProgram<3> program(Mat3::Identity(), problem.basis.transpose() * motion.shift);
  if (program.solve(rows3_, feasible * problem.trust) != Outcome::solved) return {};
  const Vec3 tau = problem.basis * program.x();
  return step_from(motion, tau, Vec3::Zero(), problem, 0, (motion.shift + tau).norm());
}

LocalStep LocalSolver::in_object_norm(const MetricShape& shape, const RigidMotion& motion,
                                      std::span<const NearCondition> conditions, const LocalProblem& problem) {
  const double rho = shape.turn_length;
  lay_rows<6>(conditions, problem, rho, rows6_);
  const Vec3 v = motion.turn.vec();
  const Mat3 M = (0.5 / rho) * (motion.turn.w() * Mat3::Identity() - cross_matrix(v));
  const Mat3 JM = shape.gyration * M;
  QuadraticProgram<6>::Matrix G = QuadraticProgram<6>::Matrix::Identity();
  G.bottomRightCorner<3, 3>() = 4 * M.transpose() * JM + least_curvature * Mat3::Identity();
  QuadraticProgram<6>::Vector g;
  g.head<3>() = motion.shift;
  g.tail<3>() = 4 * JM.transpose() * v;
  QuadraticProgram<6> program(G, g);
  if (program.solve(rows6_, feasible * problem.trust) != Outcome::solved) return {};
  const Vec3 tau = program.x().head<3>(), turn = program.x().tail<3>();
  const Vec3 next = v + M * turn;
  return step_from(motion, tau, turn / rho, problem, rho,
                   std::sqrt((motion.shift + tau).squaredNorm() + 4 * next.dot(shape.gyration * next)));
}

LocalStep LocalSolver::in_displacement(const MetricShape& shape, const RigidMotion& motion,
                                       std::span<const NearCondition> conditions, const LocalProblem& problem) {
  const double rho = shape.turn_length;
  lay_rows<7>(conditions, problem, rho, rows7_);
  const Mat3 D = rotation_less_identity(motion.turn), R = Mat3::Identity() + D;
  QuadraticProgram<7>::Matrix G = proximal * QuadraticProgram<7>::Matrix::Identity();
  G(6, 6) = 1;
  QuadraticProgram<7> program(G, QuadraticProgram<7>::Vector::Zero());
  Vec3 tau = Vec3::Zero(), omega = Vec3::Zero();
  double most = 0;
  for (int cut = 0; cut < most_cuts; ++cut) {
    const Mat3 slope = D + cross_matrix(omega) * R;
    const Vec3 T = motion.shift + tau;
    const Farthest worst = farthest(shape, slope, T);
    most = worst.distance;
    if (cut > 0 && most <= program.x()[6] + problem.accuracy) break;
    const Vec3& y = shape.extremes[worst.vertex];
    const Vec3 e = (T + slope * y).normalized(), arm = R * y;
    Row<7> row;
    row.normal.head<3>() = -e;
    row.normal.segment<3>(3) = -arm.cross(e) / rho;
    row.normal[6] = 1;
    row.bound = e.dot(motion.shift + D * y);
    rows7_.push_back(row);
    if (program.solve(rows7_, feasible * problem.trust) != Outcome::solved) return {};
    tau = program.x().head<3>();
    omega = program.x().segment<3>(3) / rho;
  }
  return step_from(motion, tau, omega, problem, rho, most);
}

LocalStep LocalSolver::solve(const MetricShape& shape, const RigidMotion& motion,
                             std::span<const NearCondition> conditions, const LocalProblem& problem) {
  switch (problem.metric) {
    case Metric::translation:
      return shift_only(motion, conditions, problem);
    case Metric::displacement:
      return in_displacement(shape, motion, conditions, problem);
    case Metric::object_norm:
      return in_object_norm(shape, motion, conditions, problem);
  }
  return {};
}

}  // namespace brunt::depth
