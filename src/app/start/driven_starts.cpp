// SPDX-License-Identifier: Apache-2.0
#include "driven_starts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "time/driven_start.hpp"

namespace brunt::app {
namespace {

constexpr double none = -std::numeric_limits<double>::infinity();

/// Of each entry of `prescribed`, where the two differ most.
struct Starts {
  std::vector<double> difference, given, start;

  explicit Starts(std::size_t count) : difference(count, 0.0), given(count, none), start(count, none) {}

  /// scale: of initial speeds of this kind.
  void add(const model::Model& model, std::size_t entry, double initial, double scale) {
    const double begins = time::driven_start(model.supports.drives[entry], initial);
    const double gap = std::abs(begins - initial);
    if (!(gap > time::same_speed * std::max(std::abs(begins), scale)) || gap < difference[entry]) return;
    if (gap == difference[entry] && !(initial > given[entry])) return;  // whatever the order of the nodes
    difference[entry] = gap;
    given[entry] = initial;
    start[entry] = begins;
  }

  void share(const comm::Communicator& ranks) {
    std::vector<double> most = difference;
    ranks.max(most);
    for (std::size_t k = 0; k < most.size(); ++k)
      if (difference[k] != most[k]) given[k] = start[k] = none;
    difference = most;
    ranks.max(given);
    ranks.max(start);
  }
};

}  // namespace

std::vector<std::string> driven_starts(const Prepared& run, std::span<const Vec3> velocity) {
  const model::Model& model = run.model;
  if (model.supports.drives.empty()) return {};
  Starts starts(model.supports.drives.size());
  double fastest = 0;
  for (const Vec3& v : velocity) fastest = std::max(fastest, v.norm());
  fastest = run.links.ranks.max(fastest);
  for (std::size_t k = 0; k < model.supports.nodes.size(); ++k)
    for (int c = 0; c < 3; ++c)
      if (const std::int32_t drive = nth(model.supports.drive[k], c); drive >= 0)
        starts.add(model, static_cast<std::size_t>(drive), nth(velocity, model.supports.nodes[k].node)[c], fastest);
  for (const model::RigidBody& body : model.bodies) {
    const Vec3 centre = body.start.velocity + body.start.spin.cross(body.body.mass.centre);
    for (std::size_t dof = 0; dof < body.drive.size(); ++dof)
      if (body.drive[dof])
        starts.add(model, static_cast<std::size_t>(*body.drive[dof]),
                   (dof < 3 ? centre : body.start.spin)[static_cast<int>(dof % 3)],
                   dof < 3 ? fastest : body.start.spin.norm());
  }
  for (const model::BodyJoint& joint : model.joints) {
    if (!joint.is_support()) continue;
    const model::StartMotion& start = nth(model.bodies, joint.body[0]).start;
    const Vec3 point = start.velocity + start.spin.cross(joint.point);
    for (std::size_t c = 0; c < 3; ++c)
      if (joint.drive[c])
        starts.add(model, static_cast<std::size_t>(*joint.drive[c]), point[static_cast<int>(c)], fastest);
  }
  starts.share(run.links.ranks);
  std::vector<std::string> lines;
  constexpr std::array directions{"x", "y", "z", "rx", "ry", "rz"};
  for (std::size_t k = 0; k < model.supports.drives.size(); ++k) {
    if (!(starts.difference[k] > 0)) continue;
    const scene::Prescribed& entry = run.input.prescribed[k];
    lines.push_back(fmt::format(
        "{}: '{}' starts with the velocity of its prescribed motion in {} at t = 0, {:g}, not with {:g} of initial",
        run.input.at(fmt::format("prescribed.{}", k)), entry.where, nth(directions, entry.dof), starts.start[k],
        starts.given[k]));
  }
  return lines;
}

}  // namespace brunt::app
