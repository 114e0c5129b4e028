// SPDX-License-Identifier: Apache-2.0
#include "joint_starts.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "time/joints_start.hpp"

namespace brunt::app {

void check_joints(Prepared& run) {
  if (run.model.joints.empty()) return;
  std::vector<std::string> faults;
  for (const time::OpenedJoint& opened : time::joints_opened(run.model, run.state)) {
    const model::BodyJoint& joint = run.model.joints[opened.joint];
    const std::string& part = nth(run.model.bodies, joint.body[joint.body[0] == no_index]).part;
    faults.push_back(
        joint.is_support()
            ? fmt::format("{}: invalid motion: initial velocities move the supported reference point of "
                          "'{}' at {:g}; expected a part that turns about this point, or is at rest",
                          run.input.at(fmt::format("parts.{}.rigid.reference", part)), excerpt(part), opened.rate)
            : fmt::format("{}: invalid motion: initial velocities open joint '{}' at {:g}, where its parts "
                          "move at {:g}; expected velocities of both that agree there",
                          run.input.at(fmt::format("joints.{}", opened.joint)), excerpt(joint.name), opened.rate,
                          opened.speed));
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  if (const LocalIndex redundant = time::redundant_rows(run.model, run.state); redundant > 0)
    run.overlaps.report.notes.push_back(
        fmt::format("joints: {} of their conditions {} determined by the others at the start, as in closed chains of "
                    "hinges; their forces are shared evenly",
                    redundant, redundant == 1 ? "is" : "are"));
}

}  // namespace brunt::app
