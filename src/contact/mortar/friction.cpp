// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/mortar/friction.hpp"

#include "add_block.hpp"
#include "turn.hpp"

namespace brunt::contact {

namespace {

Mat3 across(const Vec3& normal) {
  return Mat3::Identity() - normal * normal.transpose();
}

/// What one row takes from the last step.
class RowFriction {
 public:
  RowFriction(const MortarRows& rows, const MortarTopology& topology, std::span<const Vec3> x,
              const FrictionHistory& history, std::size_t row)
      : normal_(rows.normals[row]), kappa_(topology.kappa[row]) {
    const auto index = static_cast<LocalIndex>(row);
    known_ = history.weights.nodes.rows() > 0 && !history.weights.nodes.row(index).empty();
    if (!known_) return;
    change_ = rows.gap_vectors[row] - weighted_sum(history.weights, index, x);
    traction_ = history.tractions[row];
    old_normal_ = history.normals[row];
  }

  [[nodiscard]] Vec3 slip() const { return -kappa_ * (change_ - normal_.dot(change_) * normal_); }
  [[nodiscard]] Vec3 trial(double stiffness) const {
    return turned(traction_, old_normal_, normal_) - stiffness * slip();
  }
  /// Adds left times the slopes of the trial traction to the last row of `out`.
  void add_trial_slopes(const Mat3& left, double stiffness, const MortarSlopes& slopes, const FrictionHistory& history,
                        LocalIndex row, NodeBlocks<Mat3>& out) const {
    if (!known_) return;
    const Mat3 by_change = stiffness * kappa_ * left * across(normal_);
    add_row(out, by_change, slopes.gap_vectors, row);
    const std::span<const LocalIndex> nodes = history.weights.nodes.row(row);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      add_block(out, nodes[k], Mat3(-history.weights.row(row)[k] * by_change));
    const Mat3 by_normal =
        turned_slope(traction_, old_normal_, normal_) -
        stiffness * kappa_ * (normal_.dot(change_) * Mat3::Identity() + normal_ * change_.transpose());
    add_row(out, left * by_normal, slopes.normals, row);
  }

 private:
  Vec3 normal_, old_normal_ = Vec3::Zero(), traction_ = Vec3::Zero();
  Vec3 change_ = Vec3::Zero();  ///< sum_K (w_AK - w_AK of the last step) x_K
  double kappa_;
  bool known_ = false;
};

FrictionState state_of(const Vec3& trial, double limit) {
  return trial.norm() <= limit ? FrictionState::stick : FrictionState::slip;
}

}  // namespace

void slips(const MortarRows& rows, const MortarTopology& topology, std::span<const Vec3> x,
           const FrictionHistory& history, std::vector<Vec3>& out) {
  out.clear();
  for (std::size_t row = 0; row < rows.gaps.size(); ++row)
    out.push_back(RowFriction(rows, topology, x, history, row).slip());
}

void friction_tractions(const MortarRows& rows, const MortarTopology& topology, std::span<const Vec3> x,
                        std::span<const double> z, const MortarFriction& law, const FrictionHistory& history,
                        std::vector<Vec3>& tractions, std::vector<FrictionState>& states) {
  normal_tractions(rows, z, tractions);
  states.assign(z.size(), FrictionState::open);
  for (std::size_t row = 0; row < z.size(); ++row) {
    if (!(z[row] > 0)) continue;
    const Vec3 trial = RowFriction(rows, topology, x, history, row).trial(law.stiffness);
    const double limit = law.coefficient * z[row];
    states[row] = state_of(trial, limit);
    tractions[row] += states[row] == FrictionState::stick ? trial : Vec3(limit * trial.normalized());
  }
}

void friction_traction_slopes(const MortarRows& rows, const MortarSlopes& slopes, const MortarTopology& topology,
                              std::span<const Vec3> x, std::span<const double> z, const MortarFriction& law,
                              const FrictionHistory& history, TractionSlopes& out) {
  out.by_position.clear();
  out.by_pressure = rows.normals;
  for (std::size_t row = 0; row < z.size(); ++row) {
    const auto index = static_cast<LocalIndex>(row);
    if (z[row] != 0) add_row(out.by_position, z[row] * Mat3::Identity(), slopes.normals, index);
    if (z[row] > 0) {
      const RowFriction friction(rows, topology, x, history, row);
      const Vec3 trial = friction.trial(law.stiffness);
      const double limit = law.coefficient * z[row], size = trial.norm();
      Mat3 left = Mat3::Identity();
      if (state_of(trial, limit) == FrictionState::slip) {
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
  history.normals = rows.normals;
  history.tractions.clear();
  for (std::size_t row = 0; row < tractions.size(); ++row)
    history.tractions.emplace_back(across(rows.normals[row]) * tractions[row]);
}

}  // namespace brunt::contact
