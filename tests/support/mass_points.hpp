// SPDX-License-Identifier: Apache-2.0
// Bodies whose nodes are free mass points: contact alone acts on them, so its momentum and energy stand alone.
#pragma once
#include <algorithm>
#include <functional>
#include <vector>

#include "comm/communicator.hpp"
#include "comm/exact_sum.hpp"
#include "contact/contact.hpp"
#include "tests/support/small_mesh.hpp"

namespace brunt::support {

struct MassPoints {
  comm::Communicator ranks;
  mesh::LocalMesh mesh;
  std::vector<double> inverse_mass;
  std::vector<contact::ConstrainedNode> constrained;
  std::vector<contact::Wall> walls;
  std::vector<Vec3> x, v;
  std::vector<Vec3> x_before;  ///< at the start of the last step
  double dt_before = 0;

  MassPoints(const comm::Communicator& on, const mesh::Mesh& whole, const std::function<Rank(GlobalIndex)>& rank_of,
             const std::function<double(const Vec3&)>& mass, const std::function<Vec3(const Vec3&)>& velocity)
      : ranks(on), mesh(deal_out(whole, on.rank(), rank_of)), x(mesh.coordinates) {
    for (const Vec3& place : x) {
      inverse_mass.push_back(1 / mass(place));
      v.push_back(velocity(place));
    }
  }

  [[nodiscard]] contact::Contact make_contact(contact::ContactSettings settings) const {
    const std::vector<char> excluded(mesh.faces.size(), 0);
    contact::PairTable& pairs = settings.specification.pairs;
    if (pairs.block_count() == 0) pairs = contact::PairTable(4, {contact::PairRule::automatic});
    return contact::make_contact(ranks, mesh, excluded, inverse_mass, constrained, walls, std::move(settings));
  }

  void step(contact::Contact& contact, double dt) {
    const std::vector<Vec3> old = v;
    const contact::StepInput input{.position = {reinterpret_cast<const double*>(x.data())},
                                   .old_velocity = {reinterpret_cast<const double*>(old.data())},
                                   .velocity = {reinterpret_cast<double*>(v.data())},
                                   .walls = walls,
                                   .dt = dt};
    contact::search(contact, input, velocities(old));
    contact::correct(contact, input);
    x_before = x;
    dt_before = dt;
    for (std::size_t n = 0; n < x.size(); ++n) x[n] += dt * v[n];
    for (contact::Wall& wall : walls) wall.point += dt * wall.velocity;
  }

  /// Of all ranks: those that moved the points since the last step (by whatever), and those to come.
  [[nodiscard]] contact::VelocitySpan velocities(const std::vector<Vec3>& predicted) const {
    contact::VelocitySpan span;
    span.fill(-1e300);
    const auto take = [&](const std::vector<Vec3>& of, std::size_t place) {
      for (const Vec3& one : of)
        for (std::size_t c = 0; c < 6; ++c)
          span[place + c] = std::max(span[place + c], (c < 3 ? 1 : -1) * one[static_cast<int>(c % 3)]);
    };
    std::vector<Vec3> moved_by;
    for (std::size_t n = 0; n < x_before.size(); ++n) moved_by.push_back((x[n] - x_before[n]) / dt_before);
    take(moved_by, 0);
    take(predicted, 6);
    ranks.max(span);
    return span;
  }

  [[nodiscard]] double sum_of_owned(const std::function<double(std::size_t)>& term) const {
    std::vector<double> terms;
    for (std::size_t n = 0; n < x.size(); ++n)
      if (mesh.owner[n] == ranks.rank()) terms.push_back(term(n));
    return comm::exact_sum(ranks, terms);
  }
  [[nodiscard]] Vec3 momentum() const {
    Vec3 sum;
    for (int c = 0; c < 3; ++c) sum[c] = sum_of_owned([&](std::size_t n) { return v[n][c] / inverse_mass[n]; });
    return sum;
  }
  [[nodiscard]] double kinetic() const {
    return sum_of_owned([&](std::size_t n) { return 0.5 * v[n].squaredNorm() / inverse_mass[n]; });
  }
  /// Velocities of all nodes of the model by gid, on every rank.
  [[nodiscard]] std::vector<double> all_velocities() const {
    std::vector<double> values(3 * static_cast<std::size_t>(mesh.global_nodes), -1e300);
    for (std::size_t n = 0; n < v.size(); ++n)
      for (std::size_t c = 0; c < 3; ++c)
        values[3 * static_cast<std::size_t>(mesh.node_gid[n]) + c] = v[n][static_cast<int>(c)];
    ranks.max(values);
    return values;
  }
  /// Do all copies of shared nodes agree with what `all` says?
  [[nodiscard]] bool copies_agree(const std::vector<double>& all) const {
    bool agree = true;
    for (std::size_t n = 0; n < v.size(); ++n)
      for (std::size_t c = 0; c < 3; ++c)
        agree = agree && all[3 * static_cast<std::size_t>(mesh.node_gid[n]) + c] == v[n][static_cast<int>(c)];
    return !ranks.any(!agree);
  }
};

}  // namespace brunt::support
