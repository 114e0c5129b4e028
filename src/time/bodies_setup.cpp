// SPDX-License-Identifier: Apache-2.0
// Rigid bodies at the start of a run: exchange between ranks, masses, velocities.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>

#include "comm/exact_sum.hpp"
#include "core/cells.hpp"
#include "time/bodies.hpp"
#include "time/driven_start.hpp"

namespace brunt::time {
namespace {

using rigid::MassMoments;
using rigid::MassProperties;
constexpr double infinity = std::numeric_limits<double>::infinity();

Vec3 of(const Quad& q) {
  return {q[0], q[1], q[2]};
}

/// Motion and planes of symmetry: ranks without nodes of the body have none, all others have the same.
void share_knowledge(const comm::Communicator& ranks, model::RigidBody& body) {
  std::vector<double> values(6 + body.mirrors.size(), -infinity);
  if (!body.nodes.empty()) {
    Eigen::Map<Vec3>(values.data()) = body.start.velocity;
    Eigen::Map<Vec3>(values.data() + 3) = body.start.spin;
    for (std::size_t k = 0; k < body.mirrors.size(); ++k) values[6 + k] = body.mirrors[k].touches ? 1 : 0;
  }
  ranks.max(values);
  body.start = {Vec3(values.data()), Vec3(values.data() + 3)};
  for (std::size_t k = 0; k < body.mirrors.size(); ++k) body.mirrors[k].touches = values[6 + k] > 0;
}

/// The mirror image of the body is rigidly connected to it: it slides along the plane and rotates about the normal.
void close_support(model::RigidBody& body) {
  for (const model::MirrorPlane& plane : body.mirrors) {
    if (!plane.touches) continue;
    const Vec3 tangent = plane.normal.unitOrthogonal();
    body.held_shift.push_back(plane.normal);
    body.held_turn.push_back(tangent);
    body.held_turn.push_back(plane.normal.cross(tangent));
  }
  body.support = rigid::make_support(body.held_shift, body.held_turn);
}

/// Middle of the box around the body's nodes: moments about a point near the body avoid cancellation.
Vec3 middle_of(const comm::Communicator& ranks, const model::Model& model, const model::RigidBody& body) {
  std::array<double, 6> far;
  far.fill(-infinity);
  for_nodes(body, [&](std::size_t, std::size_t i) {
    for (std::size_t c = 0; c < 3; ++c) {
      far[c] = std::max(far[c], model.reference[i][static_cast<int>(c)]);
      far[3 + c] = std::max(far[3 + c], -model.reference[i][static_cast<int>(c)]);
    }
  });
  ranks.max(far);
  return 0.5 * Vec3(far[0] - far[3], far[1] - far[4], far[2] - far[5]);
}

class MomentSums {
 public:
  void add(const MassMoments& term) {
    const auto values = term.values();
    for (std::size_t k = 0; k < values.size(); ++k) sums_[k].add(values[k]);
  }
  MassMoments total(const comm::Communicator& ranks) {
    std::array<double, MassMoments::width> values{};
    comm::exact_sum(ranks, sums_, values);
    return MassMoments::from(values);
  }

 private:
  std::array<comm::ExactAccumulator, MassMoments::width> sums_;
};

MassMoments element_moments(const model::Model& model, const model::ElementBlock& block, LocalIndex e,
                            const Vec3& from) {
  const double density = material::initial_moduli(block.law).density;
  std::array<Vec3, cells::most_corners> corner;
  for (int c = 0; c < block.corners(); ++c) nth(corner, c) = of(nth(model.reference, block.corner_node(e, c))) - from;
  if (cells::is_surface(block.shape))
    return rigid::shell_moments(std::span<const Vec3>(corner).first(static_cast<std::size_t>(block.corners())),
                                block.section.thickness, block.section.offset, density);
  return block.shape == cells::Shape::hex8
             ? rigid::hexahedron_moments(corner, density)
             : rigid::tetrahedron_moments(std::span<const Vec3, 8>(corner).first<4>(), density);
}

/// Of its parts only, from their elements or as given; positions relative to `from`.
MassProperties own_properties(const comm::Communicator& ranks, const model::Model& model, const model::RigidBody& body,
                              const Vec3& from) {
  MomentSums sums;
  for (const std::int32_t b : body.blocks) {
    const model::ElementBlock& block = nth(model.blocks, b);
    for (LocalIndex e = 0; e < block.count; ++e) sums.add(element_moments(model, block, e, from));
  }
  MassProperties own = rigid::properties_of(sums.total(ranks));
  const model::GivenMass& given = body.given;
  if (given.mass) {
    own.inertia *= *given.mass / own.mass;
    own.mass = *given.mass;
  }
  if (given.centre) {
    const Vec3 arm = *given.centre - from - own.centre;  // the parallel axis theorem
    own.inertia += own.mass * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
    own.centre = *given.centre - from;
  }
  if (given.inertia) own.inertia = *given.inertia;
  return own;
}

/// The masses of deformable elements on the body's nodes, and the rotary inertia of shells there.
MassMoments joined_moments(const comm::Communicator& ranks, const model::Model& model, const model::RigidBody& body,
                           std::span<const Quad> joined, std::span<const model::RotationLine> rotations,
                           const Vec3& from) {
  MomentSums sums;
  for_nodes(body, [&](std::size_t, std::size_t i) {
    const double mass = joined[i][0];
    if (mass == 0 || model.mesh.owner[i] != ranks.rank()) return;
    const Vec3 place = of(model.reference[i]) - from;
    const double turning = rotations.empty() ? 0.0 : rotations[i].inertia;  // as of a small sphere
    sums.add({mass, mass * place, mass * place * place.transpose() + 0.5 * turning * Mat3::Identity()});
  });
  return sums.total(ranks);
}

/// A driven reference point begins with the velocity of its curve.
void start_point(const model::Model& model, const model::BodyJoint& joint, std::size_t body, const Vec3& spin,
                 rigid::BodyState& now) {
  if (!joint.is_support() || joint.body[0] != static_cast<LocalIndex>(body)) return;
  const Vec3 initial = now.velocity + spin.cross(joint.joint.arm[0]);
  for (std::size_t c = 0; c < 3; ++c)
    if (joint.drive[c]) {
      const auto k = static_cast<int>(c);
      now.velocity[k] += driven_start(nth(model.supports.drives, *joint.drive[c]), initial[k]) - initial[k];
    }
}

}  // namespace

void link_bodies(const comm::Communicator& ranks, model::Model& model) {
  for (model::RigidBody& body : model.bodies) {
    share_knowledge(ranks, body);
    close_support(body);
    std::erase_if(body.forced, [&](LocalIndex k) {
      const LocalIndex node = nth(body.nodes, k);
      return nth(model.mesh.owner, node) != ranks.rank();
    });
    body.is_forced = ranks.any(!body.forced.empty());
  }
}

void weigh_bodies(const comm::Communicator& ranks, model::Model& model, std::span<const Quad> joined,
                  std::span<const model::RotationLine> rotations) {
  for (model::RigidBody& body : model.bodies) {
    const Vec3 from = middle_of(ranks, model, body);
    body.own = own_properties(ranks, model, body, from);
    MassProperties all = body.own;
    const MassMoments more = joined_moments(ranks, model, body, joined, rotations, from);
    if (more.mass > 0) all = rigid::properties_of(rigid::moments_of(body.own) + more);
    body.own.centre += from;
    all.centre += from;
    body.body = rigid::make_body(all);
    body.arm.clear();
    for_nodes(body, [&](std::size_t, std::size_t i) { body.arm.push_back(of(model.reference[i]) - all.centre); });
  }
}

void start_bodies(const model::Model& model, model::State& state) {
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const model::RigidBody& body = model.bodies[b];
    rigid::BodyState& now = state.bodies[b];
    const Vec3 velocity = body.start.velocity + body.start.spin.cross(body.body.mass.centre);
    now.velocity = body.support.free_shift * velocity;  // a held direction is at rest
    Vec3 spin = body.support.free_turn * body.start.spin;
    for (std::size_t dof = 0; dof < body.drive.size(); ++dof) {
      if (!body.drive[dof]) continue;
      const auto c = static_cast<int>(dof % 3);
      const model::Drive& drive = nth(model.supports.drives, *body.drive[dof]);
      (dof < 3 ? now.velocity : spin)[c] = driven_start(drive, (dof < 3 ? velocity : body.start.spin)[c]);
    }
    for (const model::BodyJoint& joint : model.joints) start_point(model, joint, b, spin, now);
    now.angular_momentum = rigid::angular_momentum_of(body.body, now, spin);
    for_nodes(body, [&](std::size_t k, std::size_t i) {
      Eigen::Map<Vec3>(state.nodes[i].v) = now.velocity + spin.cross(now.orientation * body.arm[k]);
      if (!state.rotations.empty()) Eigen::Map<Vec3>(state.rotations[i].rate) = spin;
    });
  }
}

}  // namespace brunt::time
