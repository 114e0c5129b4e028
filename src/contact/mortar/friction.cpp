// SPDX-License-Identifier: Apache-2.0
#include "contact/mortar/friction.hpp"

#include "add_block.hpp"

namespace brunt::contact {
namespace {

/// If 1 + from . to is smaller, the vectors are opposite, and the smallest rotation is not unique.
constexpr double opposite = 1e-8;

/// By the smallest rotation from one unit vector to another: R v = v - ((from + to) . v)/(1 + from . to) (from + to) +
/// 2 (from . v) to; v itself if they are opposite.
Vec3 turned(const Vec3& v, const Vec3& from, const Vec3& to) {
  const double c = 1 + from.dot(to);
  if (c < opposite) return v;
  return v - (from + to).dot(v) / c * (from + to) + 2 * from.dot(v) * to;
}

/// Its derivative by `to`.
Mat3 turned_slope(const Vec3& v, const Vec3& from, const Vec3& to) {
  const double c = 1 + from.dot(to), q = (from + to).dot(v);
  if (c < opposite) return Mat3::Zero();
  return (from + to) * (q / (c * c) * from - v / c).transpose() + (2 * from.dot(v) - q / c) * Mat3::Identity();
}

Mat3 across(const Vec3& normal) {
  return Mat3::Identity() - normal * normal.transpose();
}

/// History of one row from the last step.
class RowFriction {
 public:
  RowFriction(const MortarRows& rows, std::span<const Vec3> x, const FrictionHistory& history, std::size_t row)
      : normal_(rows.normals[row]), covered_(rows.covered[row]) {
    const auto index = static_cast<LocalIndex>(row);
    known_ = covered_ > 0 && history.weights.nodes.rows() > 0 && history.covered[row] > 0;
    if (!known_) return;
    covered_before_ = history.covered[row];
    gap_ = rows.gap_vectors[row] / covered_;
    change_ = gap_ - weighted_sum(history.weights, index, x) / covered_before_;
    traction_ = history.tractions[row];
    old_normal_ = history.normals[row];
  }

  [[nodiscard]] Vec3 slip() const { return -(change_ - normal_.dot(change_) * normal_); }
  [[nodiscard]] Vec3 trial(double stiffness) const {
    return turned(traction_, old_normal_, normal_) - stiffness * slip();
  }
  /// Adds left times the derivatives of the trial traction to the last row of `out`.
  void add_trial_slopes(const Mat3& left, double stiffness, const MortarSlopes& slopes, const FrictionHistory& history,
                        LocalIndex row, NodeBlocks<Mat3>& out) const {
    if (!known_) return;
    const Mat3 by_change = stiffness * left * across(normal_);
    add_row(out, by_change / covered_, slopes.gap_vectors, row);
    const Vec3 by_covered = -(by_change * gap_) / covered_;
    const std::span<const LocalIndex> around = slopes.covered.nodes.row(row);
    for (std::size_t k = 0; k < around.size(); ++k)
      add_block(out, around[k], Mat3(by_covered * slopes.covered.row(row)[k].transpose()));
    const std::span<const LocalIndex> nodes = history.weights.nodes.row(row);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      add_block(out, nodes[k], Mat3(-history.weights.row(row)[k] / covered_before_ * by_change));
    const Mat3 by_normal = turned_slope(traction_, old_normal_, normal_) -
                           stiffness * (normal_.dot(change_) * Mat3::Identity() + normal_ * change_.transpose());
    add_row(out, left * by_normal, slopes.normals, row);
  }

 private:
  Vec3 normal_, old_normal_ = Vec3::Zero(), traction_ = Vec3::Zero();
  Vec3 gap_ = Vec3::Zero();     ///< mean over the currently covered part
  Vec3 change_ = Vec3::Zero();  ///< sum_K (w_AK / covered - the same of the last step) x_K
  double covered_, covered_before_ = 0;
  bool known_ = false;
};

FrictionState state_of(const Vec3& trial, double limit) {
  return trial.norm() <= limit ? FrictionState::stick : FrictionState::slip;
}

}  // namespace

void slips(const MortarRows& rows, std::span<const Vec3> x, const FrictionHistory& history, std::vector<Vec3>& out) {
  out.clear();
  for (std::size_t row = 0; row < rows.gaps.size(); ++row) out.push_back(RowFriction(rows, x, history, row).slip());
}

void friction_tractions(const MortarRows& rows, std::span<const Vec3> x, std::span<const double> z,
                        const MortarFriction& law, const FrictionHistory& history, std::vector<Vec3>& tractions,
                        std::vector<FrictionState>& states) {
  normal_tractions(rows, z, tractions);
  states.assign(z.size(), FrictionState::open);
  for (std::size_t row = 0; row < z.size(); ++row) {
    if (!(z[row] > 0)) continue;
    const Vec3 trial = RowFriction(rows, x, history, row).trial(law.stiffness);
    const double limit = law.coefficient * z[row];
    states[row] = state_of(trial, limit);
    tractions[row] += states[row] == FrictionState::stick ? trial : Vec3(limit * trial.normalized());
  }
}

void friction_traction_slopes(const MortarRows& rows, const MortarSlopes& slopes, std::span<const Vec3> x,
                              std::span<const double> z, const MortarFriction& law, const FrictionHistory& history,
                              TractionSlopes& out, std::span<const std::uint8_t> assumed) {
  out.by_position.clear();
  out.by_pressure = rows.normals;
  for (std::size_t row = 0; row < z.size(); ++row) {
    const auto index = static_cast<LocalIndex>(row);
    if (z[row] != 0) add_row(out.by_position, z[row] * Mat3::Identity(), slopes.normals, index);
    const bool sticks = !(z[row] > 0) && !assumed.empty() && assumed[row] != 0;
    if (z[row] > 0 || sticks) {
      const RowFriction friction(rows, x, history, row);
      const Vec3 trial = friction.trial(law.stiffness);
      const double limit = law.coefficient * z[row], size = trial.norm();
      Mat3 left = Mat3::Identity();
      if (!sticks && state_of(trial, limit) == FrictionState::slip) {
        left = limit / size * across(trial / size);
        out.by_pressure[row] += law.coefficient / size * trial;
      }
      friction.add_trial_slopes(left, law.stiffness, slopes, history, index, out.by_position);
    }
    out.by_position.nodes.close_row();
  }
}

void keep_friction(const MortarRows& rows, std::span<const Vec3> tractions, FrictionHistory& history) {
  history.weights = rows.weights;
  history.covered = rows.covered;
  history.normals = rows.normals;
  history.tractions.clear();
  for (std::size_t row = 0; row < tractions.size(); ++row)
    history.tractions.emplace_back(across(rows.normals[row]) * tractions[row]);
}

}  // namespace brunt::contact
