// SPDX-License-Identifier: Apache-2.0
// state.h5 and state.xdmf: the mesh once, and fields by time in the global order of the input. state.xdmf opens in
// ParaView (reader Xdmf3ReaderS) as a time series. Both remain readable if the run is killed after a record.
//
// Layout of state.h5 (indices are positions in the input, 0-based; doubles and 64-bit integers, little endian):
//   /                         attributes format, nodes, elements, blocks, and unit_QUANTITY where units have names
//   /mesh/coordinates         [nodes][3] undeformed [length]
//   /mesh/node_id             [nodes] the input's own numbers
//   /mesh/connectivity        [elements][nodes of an element] where all blocks have one shape, else one stream of
//                             XDMF Mixed cells: type (4 triangle, 5 quadrilateral, 6 tetrahedron, 9 hexahedron), nodes,
//                             type, nodes, ...
//   /mesh/element_block       [elements] index of the block
//   /mesh/block_B             attributes name, part, id, shape (hex8, ...), nodes_per_element, first, count (of
//                             its elements)
//   /record_R/node/FIELD      [nodes] or [nodes][components]
//   /record_R/element/FIELD   [elements] or [elements][components]
//   /record_R                 attributes step, time [time]: written last, a record without them is incomplete
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "comm/rendezvous.hpp"
#include "io/hdf5.hpp"
#include "mesh/local_mesh.hpp"

namespace brunt::io {

struct StateBlock {
  std::string name;
  GlobalIndex id = 0;  ///< the input's block id
  mesh::Shape shape = mesh::Shape::hex8;
  std::vector<GlobalIndex> element;  ///< of this rank: position in the input; a block's elements are contiguous there
  std::vector<LocalIndex> nodes;     ///< nodes_per_element a row: positions of nodes in the input, as of a whole mesh
  std::string part{};                ///< of the scene; empty: not known
};

/// The part of the mesh on one rank. Every node and element is given by exactly one rank; every rank lists all blocks.
struct StateMesh {
  GlobalIndex global_nodes = 0, global_elements = 0;
  std::vector<GlobalIndex> node;     ///< position in the input
  std::vector<GlobalIndex> node_id;  ///< the input's own number
  std::vector<double> coordinates;   ///< 3 a node, with the origin put back [length]
  std::vector<StateBlock> blocks;
};

/// Nodes owned by `rank`, ascending in local index, and all its elements block by block.
[[nodiscard]] StateMesh state_mesh(const mesh::LocalMesh& mesh, Rank rank);

enum class Place { node, element };

/// A field of a record. Symmetric tensors: xx, yy, zz, xy, yz, zx.
struct StateField {
  std::string name;  ///< letters, digits, `_`
  Place place = Place::node;
  int components = 1;
  /// `components` a row; rows in the order of StateMesh::node, or of the elements of block 0, block 1, ...
  std::vector<double> values;
};

/// A complete record of a state file.
struct StateRecord {
  std::string group;  ///< /record_000007
  GlobalIndex step = 0;
  double time = 0;
  struct Table {
    std::string name;
    Place place = Place::node;
    int components = 1;
    bool operator==(const Table&) const = default;
  };
  std::vector<Table> tables;
};

/// Complete records in order. Collective; throws InputError.
[[nodiscard]] std::vector<StateRecord> state_records(const Hdf5File& file);

class StateFile {
 public:
  /// Creates folder/state.h5, or continues it with `restart_step`: records of later steps are removed. It is an
  /// InputError if the file is not a state file of this mesh (numbers of nodes, elements, blocks); a missing file is
  /// created. Collective, as are all members; throws MachineError. Parts of the mesh are
  /// freed as they are written.
  StateFile(const comm::Communicator& ranks, std::string folder, StateMesh mesh,
            std::optional<GlobalIndex> restart_step = std::nullopt);

  /// Stores the unit of a quantity (time, length, ...) as an attribute unit_QUANTITY of the file.
  void name_unit(const std::string& quantity, const std::string& unit);
  void write(GlobalIndex step, double time, std::span<const StateField> fields);

 private:
  void start(StateMesh& mesh);
  void resume(const StateMesh& mesh, GlobalIndex restart_step);
  void write_mesh(StateMesh& mesh);
  void write_connectivity(StateMesh& mesh);
  void write_xdmf() const;

  comm::Communicator ranks_;
  std::string folder_;
  GlobalIndex global_nodes_, global_elements_;
  std::string topology_;  // the XDMF description of the cells
  comm::BlockRedistribution nodes_, elements_;
  std::unique_ptr<Hdf5File> file_;
  std::vector<StateRecord> records_;
};

}  // namespace brunt::io
