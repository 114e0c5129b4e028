// SPDX-License-Identifier: Apache-2.0
// A whole simulation inside a test: model and state from a scene and a mesh, on one rank, stepped as a test likes.
#pragma once
// g++ 12 takes the undefined lanes of its own AVX-512 intrinsics for a fault (GCC bug 105593); Eigen brings them in
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <Eigen/Dense>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "contact/contact.hpp"
#include "mesh/mesh.hpp"
#include "model/model.hpp"
#include "scene/input.hpp"
#include "time/ledger.hpp"
#include "time/links.hpp"
#include "time/step.hpp"

namespace brunt::test {

struct Simulation {
  /// `scene`: text of a scene without `units`, `mesh` and `run`; its parts name blocks of `mesh`. Nodes and elements
  /// come in canonical order, `node` and `element` look up the input's.
  Simulation(mesh::Mesh mesh, const std::string& scene);

  /// Lists of contact made anew when this says so, from here on: no result may depend on it.
  void rebuild_lists(const contact::Rebuild& when);
  /// Forces at t_n and the step to t_{n+1}: as the program steps, or of the length given.
  void step(std::optional<double> dt = {});
  void steps(int count, std::optional<double> dt = {}) {
    for (int i = 0; i < count; ++i) step(dt);
  }
  /// At the time before the last step.
  [[nodiscard]] time::Ledger ledger() const;

  /// Steps bounded by the assembled mesh from here on, as by run.step_bound: assembled.
  void bound_by_mesh();
  /// Forces and stresses after all nodes have moved by `u` (by input node) within one step of length `dt`.
  void displace(std::span<const Vec3> u, double dt);

  [[nodiscard]] LocalIndex node(GlobalIndex input_node) const;  ///< local node of a node of the mesh given
  [[nodiscard]] Vec3 displacement(LocalIndex i) const;
  [[nodiscard]] Vec3 position(LocalIndex i) const;
  [[nodiscard]] Vec3 velocity(LocalIndex i) const;
  [[nodiscard]] Vec3 force(LocalIndex i) const;  ///< of elements and loads at t_n of the last evaluation
  [[nodiscard]] double mass(LocalIndex i) const { return state.nodes[static_cast<std::size_t>(i)].mass; }
  [[nodiscard]] LocalIndex nodes() const { return model.nodes(); }
  [[nodiscard]] double history(std::size_t block, const std::string& field, LocalIndex element, int component) const;
  [[nodiscard]] Vec3 angular_momentum() const;  ///< of x_n and v_{n-1/2}, about the coordinate origin

  scene::Input input;
  model::Model model;
  model::State state;
  model::Scratch scratch;
  time::Links links;
  std::unique_ptr<contact::Contact> contact;  ///< all pairs of blocks, where the scene has contact or walls
  time::StepReport report;                    ///< of the last step
  time::StepControl control;
  time::AssembledStep assembled;  ///< see bound_by_mesh
};

}  // namespace brunt::test
