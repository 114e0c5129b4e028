// SPDX-License-Identifier: Apache-2.0
// One block of elements and its nodes, without scene, ranks and time: what the force room needs.
#pragma once
// g++ 12 takes the undefined lanes of its own AVX-512 intrinsics for a fault (GCC bug 105593); Eigen brings them in
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <Eigen/Dense>
#include <algorithm>
#include <random>

#include "core/cells.hpp"
#include "force/mass.hpp"
#include "force/tangent.hpp"
#include "force/trial.hpp"
#include "mesh/primitives.hpp"

namespace brunt::test {

struct ElementBlockBench {
  model::Model model;
  model::State state;
  model::Scratch scratch;

  /// A box of `cells` of edge 1, each a hexahedron or six tetrahedra.
  ElementBlockBench(element::ElementKind kind, const material::Law& law, const std::array<int, 3>& cells,
                    element::HourglassKind hourglass = element::HourglassKind::stiffness) {
    const mesh::Mesh box = mesh::box("block", Vec3(cells[0], cells[1], cells[2]), cells);
    model::ElementBlock& block = model.blocks.emplace_back();
    block.part = "block";
    block.kind = kind;
    block.law = law;
    block.hourglass.kind = hourglass;
    block.shape = kind == element::ElementKind::tet4 ? cells::Shape::tet4 : cells::Shape::hex8;
    number(box.blocks[0], block);
    for (std::size_t i = 0; i < box.coordinates.size(); ++i) {
      const Vec3& X = box.coordinates[i];
      model.mesh.node_gid.push_back(static_cast<GlobalIndex>(i));
      model.reference.push_back(Quad{X[0], X[1], X[2], 0});
    }
    int size = 0;
    for (const element::HistoryField& field : force::history_fields(block)) {
      block.history.push_back({field.name, size, field.components});
      size += field.components;
    }
    block.history_size = size;
    state.history.emplace_back(static_cast<std::size_t>(block.batches() * size * pack_width));
    state.nodes.resize(box.coordinates.size());
    scratch.force.resize(box.coordinates.size());
    force::lump_mass(model, state, scratch);
    place([](const Vec3& X) { return X; }, 0);
  }

  [[nodiscard]] const model::ElementBlock& block() const { return model.blocks[0]; }
  [[nodiscard]] Eigen::Index unknowns() const { return static_cast<Eigen::Index>(3 * state.nodes.size()); }
  [[nodiscard]] Vec3 reference(std::size_t node) const {
    return {model.reference[node][0], model.reference[node][1], model.reference[node][2]};
  }

  /// Moves each node from where it is to where(X), within one step.
  template <class Where>
  void place(const Where& where, double dt) {
    state.dt = dt;
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
      const Vec3 x = where(reference(i));
      for (int c = 0; c < 3; ++c) {
        model::NodeLine& node = state.nodes[i];
        node.v[c] = dt > 0 ? (x[c] - node.x[c]) / dt : 0;
        node.x[c] = x[c];
      }
    }
  }
  /// Adds to the positions, and to the increments of the step.
  void shift(const Eigen::VectorXd& by) {
    for (std::size_t i = 0; i < state.nodes.size(); ++i)
      for (int c = 0; c < 3; ++c) {
        const double d = by[static_cast<Eigen::Index>(3 * i) + c];
        state.nodes[i].x[c] += d;
        state.nodes[i].v[c] += d / state.dt;
      }
  }
  [[nodiscard]] force::Motion motion(bool viscous) const {
    return {.nodes = state.nodes, .dt = state.dt, .viscous = viscous};
  }

  /// Internal forces of the step under way; the committed histories of the state stay.
  Eigen::VectorXd internal_force(force::History& trial, bool viscous = false) {
    force::trial_forces(model, motion(viscous), state.history, trial, scratch);
    Eigen::VectorXd f(unknowns());
    for (std::size_t i = 0; i < state.nodes.size(); ++i)
      for (int c = 0; c < 3; ++c) f[static_cast<Eigen::Index>(3 * i) + c] = -scratch.force[i][c];
    return f;
  }
  [[nodiscard]] std::vector<double> matrices(bool viscous = false) const {
    std::vector<LocalIndex> all(static_cast<std::size_t>(block().count));
    for (std::size_t e = 0; e < all.size(); ++e) all[e] = static_cast<LocalIndex>(e);
    const auto size = static_cast<std::size_t>(9 * block().corners() * block().corners());
    std::vector<double> K(all.size() * size);
    force::element_tangents(model, 0, all, motion(viscous), state.history, K);
    return K;
  }
  /// All of them, assembled.
  [[nodiscard]] Eigen::MatrixXd tangent(bool viscous = false) const {
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(unknowns(), unknowns());
    const std::vector<double> of_elements = matrices(viscous);
    const double* entry = of_elements.data();
    for (LocalIndex e = 0; e < block().count; ++e)
      for (int row = 0; row < 3 * block().corners(); ++row)
        for (int column = 0; column < 3 * block().corners(); ++column)
          K(3 * block().corner_node(e, row / 3) + row % 3, 3 * block().corner_node(e, column / 3) + column % 3) +=
              *entry++;
    return K;
  }

 private:
  static void number(const mesh::Block& hexahedra, model::ElementBlock& block) {
    std::vector<std::array<LocalIndex, 8>> elements;
    // around the diagonal from corner 0 to corner 6
    constexpr int around[7] = {1, 2, 3, 7, 4, 5, 1};
    for (LocalIndex e = 0; e < hexahedra.count(); ++e) {
      const LocalIndex* corner = hexahedra.element(e);
      if (block.shape == cells::Shape::hex8) {
        std::copy_n(corner, 8, elements.emplace_back().begin());
        continue;
      }
      for (int k = 0; k < 6; ++k) elements.push_back({corner[0], corner[around[k]], corner[around[k + 1]], corner[6]});
    }
    block.count = static_cast<LocalIndex>(elements.size());
    for (LocalIndex batch = 0; batch < block.batches(); ++batch) {
      for (int c = 0; c < block.corners(); ++c)
        for (int lane = 0; lane < pack_width; ++lane) {
          const LocalIndex e = std::min(batch * pack_width + lane, block.count - 1);
          block.node.push_back(elements[static_cast<std::size_t>(e)][static_cast<std::size_t>(c)]);
        }
      block.border.close_row();
    }
  }
};

}  // namespace brunt::test
