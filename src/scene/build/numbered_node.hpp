// SPDX-License-Identifier: Apache-2.0
// A node by its number in a mesh file.
#pragma once
#include <string>
#include <string_view>

#include "mesh/mesh.hpp"

namespace brunt::scene {

struct NumberedNode {
  LocalIndex node = no_index;
  std::string fault{};  ///< "what is wrong; expected ..."; empty: found
};

/// `text`: a number, or the prefix of a mesh file and a number in that file. Without a prefix a number may be that of a
/// mesh file, or that of the whole mesh, in which later meshes follow the numbers of earlier ones; a number with two
/// meanings is a fault.
[[nodiscard]] NumberedNode node_numbered(const mesh::Mesh& mesh, std::string_view text);

}  // namespace brunt::scene
