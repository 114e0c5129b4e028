// SPDX-License-Identifier: Apache-2.0
// The piece of the mesh that one rank holds: its elements, all nodes they touch, their exterior faces.
// All arrays ascend in canonical global index, so that every rank walks them in the same order.
#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

#include "brunt/core/ragged.hpp"
#include "brunt/mesh/mesh.hpp"

namespace brunt::mesh {

struct LocalBlock {
  Shape shape = Shape::hex8;
  std::vector<GlobalIndex> gid;    ///< canonical element index, ascending; blocks have disjoint ranges in block order
  std::vector<GlobalIndex> input;  ///< position in the input's global order (block by block as given), 0-based
  std::vector<LocalIndex> nodes;   ///< local, nodes_per_element a row
};

/// A face on the outside of the mesh (no other element has its nodes).
struct ExteriorFace {
  GlobalIndex key = 0;              ///< element gid * 8 + local face: stable for the whole run
  std::array<LocalIndex, 4> nodes;  ///< local, counter-clockwise seen from outside; the last is no_index for a triangle
  std::int32_t block = 0;
  std::int32_t body = 0;  ///< connected component of the whole mesh, numbered by its first element
};

/// Name of the side set of all faces between elements that may be exposed when elements are removed, from both sides;
/// missing where none ever is.
constexpr const char* inner_faces = "@inner";

struct LocalMesh {
  GlobalIndex global_nodes = 0, global_elements = 0;
  Vec3 origin = Vec3::Zero();           ///< taken off all coordinates at load (a rounded value), put back on output
  std::vector<Vec3> coordinates;        ///< X - origin
  std::vector<GlobalIndex> node_gid;    ///< canonical, ascending
  std::vector<GlobalIndex> input_node;  ///< position in the input's global order, 0-based
  std::vector<GlobalIndex> node_id;     ///< the input's own number, for messages and probes
  std::vector<Rank> owner;              ///< one rank a node: that of the lowest element gid touching it
  std::vector<LocalIndex> shared;       ///< nodes other ranks hold too, ascending
  Ragged<Rank> sharers;                 ///< those ranks, a row for each of `shared`
  std::vector<std::string> block_name;
  std::vector<GlobalIndex> block_id;
  std::vector<LocalBlock> blocks;                            ///< all blocks of the model on every rank, some empty here
  std::vector<ExteriorFace> faces;                           ///< of this rank's elements, ascending by key
  std::map<std::string, std::vector<LocalIndex>> node_sets;  ///< every set on every rank, some empty here
  std::map<std::string, std::vector<ExteriorFace>> side_sets;  ///< may name interior faces too
};

}  // namespace brunt::mesh
