// SPDX-License-Identifier: Apache-2.0
// Multipliers that are redundant beside what supports, walls and other multipliers hold.
#include <algorithm>

#include "brunt/contact/mortar/redundant.hpp"
#include "brunt/implicit/mortar.hpp"

namespace brunt::implicit {
namespace {

contact::Equations equations_of(const Interface& face) {
  contact::Equations equations;
  equations.weights = face.pair.tied ? &face.tie.weights : &face.rows.weights;
  equations.covered = face.pair.tied ? face.tie.covered : face.rows.covered;
  equations.slaves = face.surfaces.rows;
  if (face.pair.tied) {
    equations.held = face.tied;
    return equations;
  }
  // of rows that say the same those that have pressed go on pressing: else they would take turns
  equations.preferred.resize(face.count());
  equations.held.assign(face.count(), Mat3::Zero());
  for (std::size_t row = 0; row < face.count(); ++row) {
    const Vec3& normal = face.rows.normals[row];
    if (face.active[row] != 0) equations.held[row] = normal * normal.transpose();
    equations.preferred[row] = face.z[row] > 0 ? 1 : 0;
  }
  return equations;
}

/// Projector on the directions that two projectors have in common.
Mat3 common(const Mat3& one, const Mat3& other) {
  return contact::held_by_all(2 * Mat3::Identity() - one - other);
}

}  // namespace

std::vector<Mat3> carried_by_ties(const MortarContact& contact) {
  const ContactNodes& nodes = contact.nodes;
  std::vector<Mat3> carried(nodes.gid.size(), Mat3::Zero());
  std::vector<Mat3> movable = nodes.movable;
  std::vector<std::uint8_t> carries(nodes.gid.size(), 0);  // a node on which others rely stays on its walls
  for (const Interface& face : contact.interfaces)
    for (std::size_t row = 0; face.pair.tied && row < face.count(); ++row) {
      const auto node = static_cast<std::size_t>(face.surfaces.rows[row]);
      const Mat3 by_walls = nodes.free[node] - movable[node];
      if (face.tie.covered[row] == 0 || carries[node] != 0 || by_walls.isZero()) continue;
      const contact::MasterPlace& below = face.tie.below[row];
      const Mat3 both = common(by_walls, contact::held_by_all(contact::freedom_of(below, movable)));
      if (both.isZero()) continue;
      carried[node] += both;
      movable[node] += both;
      for (std::size_t c = 0; c < below.nodes.size(); ++c)
        if (contact::has_share(below.weights[c])) carries[static_cast<std::size_t>(below.nodes[c])] = 1;
    }
  return carried;
}

void leave_out_redundant(MortarContact& contact) {
  const ContactNodes& nodes = contact.nodes;
  std::vector<contact::Equations> all;
  std::vector<Interface*> faces;  // of these
  for (Interface& face : contact.interfaces) {
    if (face.pair.tied) {
      face.tied = contact::tied_directions(face.surfaces, face.tie, nodes.movable);
      face.given_apart.resize(face.count());
      for (std::size_t row = 0; row < face.count(); ++row)
        face.given_apart[row] = face.tie.covered[row] > 0 ? Mat3(Mat3::Identity() - face.tied[row]) : Mat3::Zero();
    } else if (face.multipliers() == 0) {
      continue;  // a penalty has no equations
    }
    all.push_back(equations_of(face));
    faces.push_back(&face);
  }
  contact::leave_out_implied(all, nodes.movable);
  for (std::size_t k = 0; k < faces.size(); ++k) {
    if (faces[k]->pair.tied)
      faces[k]->tied = std::move(all[k].held);
    else
      for (std::size_t row = 0; row < faces[k]->count(); ++row)
        if (all[k].held[row].isZero()) faces[k]->active[row] = 0;
  }
}

}  // namespace brunt::implicit
