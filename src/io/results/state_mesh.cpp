// SPDX-License-Identifier: Apache-2.0
// The mesh of a state file: from a rank's piece of the model, and into the file.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/results/state_file.hpp"
#include "io/results/xdmf.hpp"
#include "state_topology.hpp"

namespace brunt::io {
namespace {

/// Types of cells in XDMF's Mixed topology.
double xdmf_type(mesh::Shape shape) {
  switch (shape) {
    case mesh::Shape::tri3:
      return 4;
    case mesh::Shape::quad4:
      return 5;
    case mesh::Shape::tet4:
      return 6;
    case mesh::Shape::hex8:
      break;
  }
  return 9;
}

/// Gives the memory back, which `= {}` of a vector does not.
template <class T>
void release(std::vector<T>& values) {
  std::vector<T>().swap(values);
}

StateBlock state_block(const mesh::LocalMesh& mesh, std::size_t b) {
  const mesh::LocalBlock& local = mesh.blocks[b];
  StateBlock block{mesh.block_name[b], mesh.block_id[b], local.shape, local.input, {}, {}};
  block.nodes.reserve(local.nodes.size());
  for (const LocalIndex node : local.nodes) block.nodes.push_back(static_cast<LocalIndex>(nth(mesh.input_node, node)));
  return block;
}

// Rows of `width` integers, `rows` of them held here by index, brought into blocks and written from row `offset` of the
// table on. value(row, column): as a double, which is exact below 2^53. Columns travel one by one and wait as `Kept`,
// for less memory; they are written in slices, of which every rank has as many.
template <class Kept, class Value>
void write_integers(Hdf5File& file, const std::string& table, GlobalIndex offset,
                    const comm::BlockRedistribution& redistribution, std::size_t rows, int width, Value value) {
  const Rank rank = file.ranks().rank();
  const comm::BlockLayout& layout = redistribution.layout();
  const auto columns = static_cast<std::size_t>(width);
  std::vector<Kept> kept(static_cast<std::size_t>(layout.count(rank)) * columns);
  {
    std::vector<double> held(rows), block(static_cast<std::size_t>(layout.count(rank)));
    for (std::size_t c = 0; c < columns; ++c) {
      for (std::size_t i = 0; i < rows; ++i) held[i] = value(i, c);
      redistribution.to_blocks(held, block, 1);
      for (std::size_t i = 0; i < block.size(); ++i) kept[i * columns + c] = static_cast<Kept>(std::llround(block[i]));
    }
  }
  constexpr LocalIndex slice = 1 << 16;  // rows
  const GlobalIndex table_width = file.extent(table).width;
  std::vector<std::int64_t> integers;
  for (LocalIndex first = 0; first < layout.count(0); first += slice) {  // no rank has more rows than the first
    const LocalIndex begin = std::min(first, layout.count(rank)), end = std::min(first + slice, layout.count(rank));
    integers.assign(kept.begin() + static_cast<std::ptrdiff_t>(begin) * width,
                    kept.begin() + static_cast<std::ptrdiff_t>(end) * width);
    file.write(table, offset + (layout.first(rank) + begin) * width / table_width,
               std::span<const std::int64_t>(integers));
  }
}

// The nodes of each element, led by the type of the cell where shapes are mixed.
void write_cells(Hdf5File& file, GlobalIndex offset, const comm::BlockRedistribution& redistribution,
                 const StateBlock& block) {
  const auto nodes = static_cast<std::size_t>(mesh::nodes_per_element(block.shape));
  const double type = xdmf_type(block.shape);
  write_integers<LocalIndex>(file, "/mesh/connectivity", offset, redistribution, block.element.size(),
                             static_cast<int>(nodes + 1), [&](std::size_t i, std::size_t c) {
                               return c == 0 ? type : static_cast<double>(block.nodes[i * nodes + c - 1]);
                             });
}

std::vector<GlobalIndex> element_counts(const comm::Communicator& ranks, const StateMesh& mesh) {
  std::vector<GlobalIndex> counts;
  for (const StateBlock& block : mesh.blocks) counts.push_back(static_cast<GlobalIndex>(block.element.size()));
  ranks.sum(counts);
  return counts;
}

XdmfCells cells_of(const StateMesh& mesh, const std::vector<GlobalIndex>& counts) {
  XdmfCells result;
  if (!mesh.blocks.empty()) result.shape = mesh.blocks.front().shape;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    result.mixed = result.mixed || mesh.blocks[b].shape != result.shape;
    result.stream_length += counts[b] * (mesh::nodes_per_element(mesh.blocks[b].shape) + 1);
  }
  return result;
}

}  // namespace

StateMesh state_mesh(const mesh::LocalMesh& mesh, Rank rank) {
  StateMesh result;
  result.global_nodes = mesh.global_nodes;
  result.global_elements = mesh.global_elements;
  const auto owned = static_cast<std::size_t>(std::ranges::count(mesh.owner, rank));
  for (auto* indices : {&result.node, &result.node_id}) indices->reserve(owned);
  result.coordinates.reserve(3 * owned);
  for (std::size_t i = 0; i < mesh.node_gid.size(); ++i) {
    if (mesh.owner[i] != rank) continue;
    result.node.push_back(mesh.input_node[i]);
    result.node_id.push_back(mesh.node_id[i]);
    const Vec3 position = mesh.coordinates[i] + mesh.origin;
    result.coordinates.insert(result.coordinates.end(), position.begin(), position.end());
  }
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) result.blocks.push_back(state_block(mesh, b));
  return result;
}

std::string state_topology(const comm::Communicator& ranks, const StateMesh& mesh) {
  return xdmf_topology(cells_of(mesh, element_counts(ranks, mesh)), mesh.global_elements);
}

void StateFile::write_connectivity(StateMesh& mesh) {
  const std::vector<GlobalIndex> counts = element_counts(ranks_, mesh);
  const XdmfCells kind = cells_of(mesh, counts);
  const int one_width = mesh::nodes_per_element(kind.shape);
  file_->create_integers("/mesh/connectivity", kind.mixed ? kind.stream_length : global_elements_,
                         kind.mixed ? 1 : one_width);
  if (!kind.mixed) {  // all blocks at once
    std::size_t rows = 0, before = 0, b = 0;
    for (StateBlock& block : mesh.blocks) {
      rows += block.element.size();
      release(block.element);
    }
    const auto width = static_cast<std::size_t>(one_width);
    write_integers<LocalIndex>(*file_, "/mesh/connectivity", 0, elements_, rows, one_width,
                               [&](std::size_t i, std::size_t c) {
                                 if (i == 0) before = b = 0;
                                 while (i - before >= mesh.blocks[b].nodes.size() / width)
                                   before += mesh.blocks[b++].nodes.size() / width;
                                 return static_cast<double>(mesh.blocks[b].nodes[(i - before) * width + c]);
                               });
  }
  GlobalIndex first = 0, offset = 0;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const StateBlock& block = mesh.blocks[b];
    if (kind.mixed) {
      std::vector<GlobalIndex> in_block = block.element;
      for (GlobalIndex& element : in_block) element -= first;
      write_cells(*file_, offset, comm::BlockRedistribution(ranks_, counts[b], in_block), block);
      offset += counts[b] * (mesh::nodes_per_element(block.shape) + 1);
    }
    const std::string group = fmt::format("/mesh/block_{}", b);
    file_->create_group(group);
    file_->set_attribute(group, "name", block.name);
    if (!block.part.empty()) file_->set_attribute(group, "part", block.part);
    file_->set_attribute(group, "id", block.id);
    file_->set_attribute(group, "shape", std::string(cells::of(block.shape).name));
    file_->set_attribute(group, "nodes_per_element", GlobalIndex{mesh::nodes_per_element(block.shape)});
    file_->set_attribute(group, "first", first);
    file_->set_attribute(group, "count", counts[b]);
    first += counts[b];
  }
}

void StateFile::write_mesh(StateMesh& mesh) {
  file_->create_group("/mesh");
  file_->create_doubles("/mesh/coordinates", global_nodes_, 3);
  {
    std::vector<double> block(static_cast<std::size_t>(nodes_.layout().count(ranks_.rank())) * 3);
    nodes_.to_blocks(mesh.coordinates, block, 3);
    release(mesh.coordinates);
    file_->write("/mesh/coordinates", nodes_.layout().first(ranks_.rank()), std::span<const double>(block));
  }
  file_->create_integers("/mesh/node_id", global_nodes_, 1);
  write_integers<GlobalIndex>(*file_, "/mesh/node_id", 0, nodes_, mesh.node_id.size(), 1,
                              [&](std::size_t i, std::size_t) { return static_cast<double>(mesh.node_id[i]); });
  release(mesh.node_id);
  release(mesh.node);
  {
    std::vector<LocalIndex> of_element;
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
      of_element.insert(of_element.end(), mesh.blocks[b].element.size(), static_cast<LocalIndex>(b));
    file_->create_integers("/mesh/element_block", global_elements_, 1);
    write_integers<LocalIndex>(*file_, "/mesh/element_block", 0, elements_, of_element.size(), 1,
                               [&](std::size_t i, std::size_t) { return static_cast<double>(of_element[i]); });
  }
  write_connectivity(mesh);
}

}  // namespace brunt::io
