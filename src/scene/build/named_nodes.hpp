// SPDX-License-Identifier: Apache-2.0
// Resolves the names of a scene and of its mesh to nodes.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mesh/canonical.hpp"
#include "scene/input.hpp"

namespace brunt::scene {

/// Looks names up in the mesh as it is; all nodes that it returns are ascending, each once.
class NamedNodes {
 public:
  using Nodes = std::vector<LocalIndex>;

  NamedNodes(const Input& input, const mesh::CanonicalMesh& whole);

  /// Precedence: parts, sets of the scene, sets of the mesh; empty if the name is unknown.
  [[nodiscard]] std::optional<Nodes> of(const std::string& where) const;
  [[nodiscard]] std::optional<Nodes> of_entry(const SetEntry& set) const;
  /// A node set and a side set of the mesh have this name, and their nodes differ.
  [[nodiscard]] bool is_two_sets(const std::string& where) const;
  [[nodiscard]] Nodes of_sides(const std::vector<mesh::Side>& sides) const;

  [[nodiscard]] const std::vector<std::string>& part_of_block() const { return part_of_block_; }
  /// A node this close to a plane lies in it [length].
  [[nodiscard]] double on_plane() const { return on_plane_; }

 private:
  [[nodiscard]] Nodes of_part(const std::string& part) const;
  [[nodiscard]] std::optional<Nodes> of_mesh_set(const std::string& where) const;

  const Input& input_;
  const mesh::CanonicalMesh& whole_;
  std::vector<std::string> part_of_block_;
  double on_plane_ = 0;
};

}  // namespace brunt::scene
