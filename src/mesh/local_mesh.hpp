// SPDX-License-Identifier: Apache-2.0
// The piece of the mesh on one rank: its elements, all their nodes, and their exterior faces. All arrays ascend by
// canonical global index, so that every rank processes them in the same order.
#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

#include "core/cells.hpp"
#include "core/ragged.hpp"
#include "mesh/mesh.hpp"

namespace brunt::mesh {

struct LocalBlock {
  Shape shape = Shape::hex8;
  std::vector<GlobalIndex> gid;    ///< canonical element index, ascending; blocks have disjoint ranges in block order
  std::vector<GlobalIndex> input;  ///< position in the input's global order (block by block as given), 0-based
  std::vector<LocalIndex> nodes;   ///< local, nodes_per_element a row
};

/// A face on the outside of the mesh (no other element has its nodes).
struct ExteriorFace {
  GlobalIndex key = 0;              ///< cells::key_of its element and local face: stable for the whole run
  std::array<LocalIndex, 4> nodes;  ///< local, counter-clockwise seen from outside; the last is no_index for a triangle
  std::int32_t block = 0;
  std::int32_t body = 0;  ///< connected component of the whole mesh, numbered by its first element
};

/// Name of the side set of all interior faces that may become exposed when elements are removed, from both sides;
/// missing if there are none.
constexpr const char* inner_faces = "@inner";

struct LocalMesh {
  GlobalIndex global_nodes = 0, global_elements = 0;
  Vec3 origin = Vec3::Zero();     ///< subtracted from all coordinates at load (a rounded value), added again on output
  std::vector<Vec3> coordinates;  ///< X - origin
  std::vector<GlobalIndex> node_gid;    ///< canonical, ascending
  std::vector<GlobalIndex> input_node;  ///< position in the input's global order, 0-based
  std::vector<GlobalIndex> node_id;     ///< the input's own number, for messages and probes
  std::vector<Rank> owner;              ///< owning rank of each node: that of its element with the lowest gid
  std::vector<LocalIndex> shared;       ///< nodes that other ranks also hold, ascending
  Ragged<Rank> sharers;                 ///< those ranks, a row for each of `shared`
  std::vector<std::string> block_name;
  std::vector<GlobalIndex> block_id;
  std::vector<LocalBlock> blocks;                            ///< all blocks of the model on every rank, some empty here
  std::vector<ExteriorFace> faces;                           ///< of this rank's elements, ascending by key
  std::map<std::string, std::vector<LocalIndex>> node_sets;  ///< every set on every rank, some empty here
  std::map<std::string, std::vector<ExteriorFace>> side_sets;  ///< may contain interior faces
};

}  // namespace brunt::mesh
