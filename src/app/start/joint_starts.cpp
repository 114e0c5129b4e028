// SPDX-License-Identifier: Apache-2.0
#include "joint_starts.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "time/joints_start.hpp"

namespace brunt::app {
namespace {

const std::string& part_of(const Prepared& run, const model::BodyJoint& joint) {
  return nth(run.model.bodies, joint.body[joint.body[0] == no_index ? 1 : 0]).part;
}

/// "FILE:LINE: key" of a joint, or of the reference point of a part.
std::string key_of(const Prepared& run, std::size_t j) {
  const model::BodyJoint& joint = run.model.joints[j];
  return run.input.at(joint.is_support() ? fmt::format("parts.{}.rigid.reference", part_of(run, joint))
                                         : fmt::format("joints.{}", j));
}

/// Gaps are judged beside the size of the bodies about the joint.
std::vector<std::string> joints_out_of_range(const Prepared& run) {
  std::vector<std::string> faults;
  for (std::size_t j = 0; j < run.model.joints.size(); ++j)
    if (!std::isfinite(run.model.joints[j].size))
      faults.push_back(
          fmt::format("{}: out of range: the square of the distance between the point and its bodies "
                      "overflows; expected coordinates below 1e150",
                      key_of(run, j)));
  return faults;
}

std::vector<std::string> opened_joints(const Prepared& run) {
  std::vector<std::string> faults;
  for (const time::OpenedJoint& opened : time::joints_opened(run.model, run.state)) {
    const model::BodyJoint& joint = run.model.joints[opened.joint];
    faults.push_back(
        joint.is_support()
            ? fmt::format("{}: invalid motion: initial velocities move the supported reference point of '{}' at {:g}; "
                          "expected a part that turns about this point, or is at rest",
                          key_of(run, opened.joint), excerpt(part_of(run, joint)), opened.rate)
            : fmt::format("{}: invalid motion: initial velocities open joint '{}' at {:g}, where its parts move at "
                          "{:g}; expected velocities of both that agree there",
                          key_of(run, opened.joint), excerpt(joint.name), opened.rate, opened.speed));
  }
  return faults;
}

}  // namespace

void check_joints(Prepared& run) {
  if (run.model.joints.empty()) return;
  for (const auto& find : {joints_out_of_range, opened_joints})
    if (std::vector<std::string> faults = find(run); !faults.empty()) throw InputError(std::move(faults));
  if (const LocalIndex redundant = time::redundant_rows(run.model, run.state); redundant > 0)
    run.overlaps.report.notes.push_back(
        fmt::format("joints: {} of their conditions {} determined by the others at the start, as in closed chains of "
                    "hinges; their forces are shared evenly",
                    redundant, redundant == 1 ? "is" : "are"));
}

}  // namespace brunt::app
