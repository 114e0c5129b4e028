// SPDX-License-Identifier: Apache-2.0
// Two hexahedra in a row and a tetrahedron on top, dealt out to any number of ranks against the input's order.
#pragma once
#include <vector>

#include "comm/communicator.hpp"
#include "io/results/state_file.hpp"

namespace brunt::test {

class SmallMesh {
 public:
  static constexpr GlobalIndex nodes = 13, elements = 3;

  /// x fastest: nodes 0..11 are the grid 3 x 2 x 2 of unit cubes, node 12 the tip of the tetrahedron.
  explicit SmallMesh(const comm::Communicator& ranks) {
    mesh.global_nodes = nodes;
    mesh.global_elements = elements;
    const GlobalIndex n = ranks.size(), r = ranks.rank();
    for (GlobalIndex g = nodes - 1; g >= 0; --g) {
      if (g % n != r) continue;
      mesh.node.push_back(g);
      mesh.node_id.push_back(100 + g);
      const std::vector<GlobalIndex> place =
          g < 12 ? std::vector<GlobalIndex>{g % 3, g / 3 % 2, g / 6} : std::vector<GlobalIndex>{0, 0, 2};
      mesh.coordinates.insert(mesh.coordinates.end(), place.begin(), place.end());
    }
    mesh.blocks = {{"bar", 7, mesh::Shape::hex8, {}, {}}, {"tip", 9, mesh::Shape::tet4, {}, {}}};
    for (const GlobalIndex e : {1, 0}) {
      if (e % n != r) continue;
      mesh.blocks[0].element.push_back(e);
      for (const GlobalIndex corner : {0, 1, 4, 3, 6, 7, 10, 9})
        mesh.blocks[0].nodes.push_back(static_cast<LocalIndex>(corner + e));
    }
    if (2 % n == r) {
      mesh.blocks[1].element = {2};
      mesh.blocks[1].nodes = {6, 7, 9, 12};
    }
  }

  static double displacement(int step, GlobalIndex node, int c) {
    return 0.001 * step * static_cast<double>((node * 3 + c) % 7);
  }
  static double stress(int step, GlobalIndex element, int c) {
    return 1e6 * step + static_cast<double>(element * 6 + c);
  }

  [[nodiscard]] std::vector<io::StateField> fields(int step) const {
    std::vector<io::StateField> result{{"displacement", io::Place::node, 3, {}},
                                       {"stress", io::Place::element, 6, {}},
                                       {"alive", io::Place::element, 1, {}}};
    for (const GlobalIndex node : mesh.node)
      for (int c = 0; c < 3; ++c) result[0].values.push_back(displacement(step, node, c));
    for (const io::StateBlock& block : mesh.blocks)
      for (const GlobalIndex element : block.element) {
        for (int c = 0; c < 6; ++c) result[1].values.push_back(stress(step, element, c));
        result[2].values.push_back(1);
      }
    return result;
  }

  io::StateMesh mesh;
};

}  // namespace brunt::test
