// SPDX-License-Identifier: Apache-2.0
// An answer of `brunt depth` with nothing left at its default.
#pragma once
#include "app/depth/depth_row.hpp"

namespace brunt::support {

inline app::DepthRow depth_row() {
  app::DepthRow row;
  row.pose = 7;
  row.a = "bar, 5\" long.stl";
  row.b = "plate.obj";
  row.metric = depth::Metric::object_norm;
  row.centroid = {.1, .2, .3};
  row.start.rotation = depth::rotation_of(Vec3(.3, -.2, .1)).toRotationMatrix();
  row.start.translation = {1, 2, 1. / 3};
  row.least_turn = 1e-5;
  row.seconds = .0125;
  depth::Answer& answer = row.answer;
  answer.overlap = true;
  answer.depth = 1. / 7;
  answer.bound = .1;
  answer.overlaps = .13;
  answer.motion = {depth::Turn(depth::rotation_of(Vec3(.05, .02, -.01))), Vec3(.1, 0, -.05)};
  answer.placement = depth::moved(row.start, answer.motion, row.centroid);
  answer.contacts = {{Vec3(1, 2, 3), Vec3::UnitX(), 1e-7}, {Vec3(3, 2, 1), -Vec3::UnitZ(), 0}};
  answer.walks = 3;
  answer.steps = 40;
  answer.queries = 123456789012;
  return row;
}

}  // namespace brunt::support
