// SPDX-License-Identifier: Apache-2.0
#include "rigid/joint_group.hpp"

#include <algorithm>
#include <cmath>

#include "core/union_find.hpp"

namespace brunt::rigid {

std::array<Pose, 2> sides_of(const JointPlace& place, std::span<const Pose> pose) {
  std::array<Pose, 2> both;
  for (std::size_t side = 0; side < 2; ++side)
    if (place.body[side] != no_index) both[side] = nth(pose, place.body[side]);
  return both;
}

std::vector<JointGroup> group_bodies(std::span<const Joint> joints, std::span<const std::array<LocalIndex, 2>> body,
                                     LocalIndex bodies) {
  UnionFind joined;
  joined.reset(static_cast<std::size_t>(bodies));
  std::vector<char> has_joint(static_cast<std::size_t>(bodies), 0);
  for (const std::array<LocalIndex, 2>& pair : body) {
    for (const LocalIndex one : pair)
      if (one != no_index) nth(has_joint, one) = 1;
    if (pair[0] != no_index && pair[1] != no_index)
      joined.join(static_cast<std::size_t>(pair[0]), static_cast<std::size_t>(pair[1]));
  }
  std::vector<JointGroup> groups;
  std::vector<std::size_t> group_of(has_joint.size(), has_joint.size()), place(has_joint.size(), 0);
  for (std::size_t b = 0; b < has_joint.size(); ++b) {
    if (has_joint[b] == 0) continue;
    std::size_t& group = group_of[joined.first(b)];
    if (group == has_joint.size()) {
      group = groups.size();
      groups.emplace_back();
    }
    place[b] = groups[group].bodies.size();
    groups[group].bodies.push_back(static_cast<LocalIndex>(b));
  }
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const LocalIndex any = body[j][0] != no_index ? body[j][0] : body[j][1];
    JointGroup& group = groups[group_of[joined.first(static_cast<std::size_t>(any))]];
    JointPlace of_joint{.joint = joints[j], .number = static_cast<LocalIndex>(j), .first_row = group.rows};
    for (std::size_t side = 0; side < 2; ++side)
      if (body[j][side] != no_index) of_joint.body[side] = static_cast<LocalIndex>(nth(place, body[j][side]));
    group.joints.push_back(of_joint);
    group.rows += static_cast<LocalIndex>(rows_of(joints[j]));
  }
  return groups;
}

void JointSystem::form(const JointGroup& group, std::span<const Pose> pose, std::span<const Mat6> mobility) {
  const auto width = static_cast<Eigen::Index>(6 * pose.size());
  slope_.setZero(group.rows, width);
  mobility_.setZero(width, width);
  for (std::size_t b = 0; b < pose.size(); ++b) {
    const auto at = static_cast<Eigen::Index>(6 * b);
    mobility_.block<6, 6>(at, at) = mobility[b];
  }
  std::array<JointRow, most_joint_rows> rows;
  std::vector<char> is_axis(static_cast<std::size_t>(group.rows), 0);
  for (const JointPlace& place : group.joints) {
    const std::size_t count = joint_rows(place.joint, sides_of(place, pose), rows);
    for (std::size_t k = 0; k < count; ++k)
      nth(is_axis, place.first_row + static_cast<LocalIndex>(k)) = rows[k].shift[0].isZero(0);
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t side = 0; side < 2; ++side) {
        if (place.body[side] == no_index) continue;
        const Eigen::Index row = place.first_row + static_cast<Eigen::Index>(k), column = 6 * place.body[side];
        slope_.block<1, 3>(row, column) = rows[k].shift[side].transpose();
        slope_.block<1, 3>(row, column + 3) = rows[k].turn[side].transpose();
      }
  }
  scaled_ = slope_ * mobility_ * slope_.transpose();
  constexpr double nothing = 1e-14;     // of the largest of its kind: rounding of what supports hold
  std::array<double, 2> largest{0, 0};  // of points, of axes, which have other units
  for (Eigen::Index row = 0; row < group.rows; ++row)
    nth(largest, nth(is_axis, row)) = std::max(nth(largest, nth(is_axis, row)), scaled_(row, row));
  scale_.setZero(group.rows);
  for (Eigen::Index row = 0; row < group.rows; ++row)
    if (scaled_(row, row) > nothing * nth(largest, nth(is_axis, row))) scale_[row] = 1 / std::sqrt(scaled_(row, row));
  scaled_ = scale_.asDiagonal() * scaled_ * scale_.asDiagonal();
  constexpr double redundant = 1e-10;  // of the largest pivot: rounding of rows that others determine is 1e-15
  solver_.setThreshold(redundant);
  solver_.compute(scaled_);
}

Eigen::VectorXd JointSystem::gaps(const JointGroup& group, std::span<const Pose> pose) {
  Eigen::VectorXd gaps(group.rows);
  std::array<JointRow, most_joint_rows> rows;
  for (const JointPlace& place : group.joints) {
    const std::size_t count = joint_rows(place.joint, sides_of(place, pose), rows);
    for (std::size_t k = 0; k < count; ++k) gaps[place.first_row + static_cast<Eigen::Index>(k)] = rows[k].gap;
  }
  return gaps;
}

Eigen::VectorXd JointSystem::impulses(const Eigen::VectorXd& change) const {
  return scale_.asDiagonal() * solver_.solve(scale_.asDiagonal() * change);
}

Eigen::MatrixXd JointSystem::coupled_mobility() const {
  const Eigen::MatrixXd answers = scale_.asDiagonal() * slope_ * mobility_;
  const Eigen::MatrixXd coupled = mobility_ - answers.transpose() * solver_.solve(answers);
  return 0.5 * (coupled + coupled.transpose());
}

}  // namespace brunt::rigid
