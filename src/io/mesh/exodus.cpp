// SPDX-License-Identifier: Apache-2.0
// Exodus II through its library, with the checks that the library leaves out.
#include "io/mesh/exodus.hpp"

#include <exodusII.h>
#include <fmt/core.h>
#include <netcdf.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>

#include "core/cells.hpp"
#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "core/letter_case.hpp"
#include "core/utf8.hpp"
#include "left_out.hpp"
#include "netcdf_layout.hpp"
#include "set_words.hpp"
#include "sound_mesh.hpp"

namespace brunt::io {
namespace {

using mesh::Block;
using mesh::Mesh;
using mesh::Shape;
using Integers = std::vector<std::int64_t>;

class ExodusFile {
 public:
  explicit ExodusFile(const std::string& path) : path_(path) {
    std::error_code unreadable;
    const auto size = std::filesystem::file_size(path, unreadable);
    if (unreadable) fail("cannot read the file (" + unreadable.message() + "); expected a readable file");
    const std::string fault = netcdf_layout_fault(path);
    if (!fault.empty()) fail(fault);
    most_ = std::min<std::int64_t>(static_cast<std::int64_t>(size),
                                   std::numeric_limits<LocalIndex>::max() / cells::most_corners);
    ex_opts(0);  // the library's own messages would go to the terminal
    int our_word = 8, file_word = 0;
    float version = 0;
    id_ = ex_open(path.c_str(), EX_READ | EX_ALL_INT64_API, &our_word, &file_word, &version);
    if (id_ < 0) fail("cannot read the file: not an Exodus II file that the library can open; expected Exodus II");
    ex_set_max_name_length(id_, name_length);
  }
  ~ExodusFile() {
    if (id_ >= 0) ex_close(id_);
  }
  ExodusFile(const ExodusFile&) = delete;
  ExodusFile& operator=(const ExodusFile&) = delete;

  [[nodiscard]] int id() const { return id_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  [[noreturn]] void fail(const std::string& what) const { throw InputError(path_ + ": " + what); }
  void succeed(int status, const std::string& what) const {
    if (status < 0) fail("cannot read the " + what + "; expected an undamaged file");
  }
  /// Before anything is allocated: a damaged header may claim any number.
  std::size_t plausible(std::int64_t count, const std::string& what) const {
    if (count < 0 || count > most_)
      fail(fmt::format("out of range: {} {} in the header; expected no more than the file can hold", count, what));
    return static_cast<std::size_t>(count);
  }
  Integers ids(ex_entity_type type, std::int64_t count, const std::string& what) const {
    Integers values(plausible(count, what));
    if (count > 0) succeed(ex_get_ids(id_, type, values.data()), what + " ids");
    return values;
  }
  std::string name(ex_entity_type type, std::int64_t id) const {
    std::vector<char> text(name_length + 2, '\0');
    if (ex_get_name(id_, type, id, text.data()) < 0) return {};
    return as_utf8(std::string(text.data()));
  }

 private:
  static constexpr int name_length = 256;
  std::string path_;
  std::int64_t most_ = 0;
  int id_ = -1;
};

/// A kind of elements in a file, by the first letters of its name and its number of nodes, and its shape in the mesh.
struct Kind {
  std::string_view start;
  int nodes, faces;
  Shape shape;
};
constexpr std::array<Kind, 8> kinds{{{"HEX", 8, 6, Shape::hex8},
                                     {"TET", 4, 4, Shape::tet4},
                                     {"WEDGE", 6, 5, Shape::hex8},
                                     {"PYRAMID", 5, 5, Shape::hex8},
                                     {"SHELL", 4, 2, Shape::quad4},
                                     {"QUAD", 4, 2, Shape::quad4},
                                     {"SHELL", 3, 2, Shape::tri3},
                                     {"TRI", 3, 2, Shape::tri3}}};

/// Null if it is none of them.
const Kind* kind_of(const std::string& written, std::int64_t nodes) {
  const std::string type = upper_case(written);
  const auto* const found = std::ranges::find_if(
      kinds, [&](const Kind& kind) { return type.starts_with(kind.start) && nodes == kind.nodes; });
  return found == kinds.end() ? nullptr : found;
}

/// One block and, for side sets, the kind of its elements in the file; `foreign` holds a block of elements that are not
/// read.
struct BlockRead {
  Block block;
  const Kind* kind = nullptr;
  std::optional<ForeignBlock> foreign{};
};

/// Where the file's elements are: a block of the mesh (no_index: a foreign one), how many, of what kind.
struct FileBlock {
  LocalIndex block = no_index;
  std::int64_t count = 0;
  const Kind* kind = nullptr;
};

LocalIndex zero_based(std::int64_t number) {
  constexpr std::int64_t most = std::numeric_limits<LocalIndex>::max();
  return number < 1 || number > most ? no_index : static_cast<LocalIndex>(number - 1);
}

BlockRead read_block(const ExodusFile& file, std::int64_t id) {
  ex_block header{};
  header.id = id;
  header.type = EX_ELEM_BLOCK;
  file.succeed(ex_get_block_param(file.id(), &header), fmt::format("element block {}", id));
  BlockRead read;
  read.block.name = file.name(EX_ELEM_BLOCK, id);
  read.block.id = id;
  const std::size_t count = file.plausible(header.num_entry, fmt::format("elements in block {}", id));
  if (count == 0) {  // as decomposed meshes have them; of any type, often NULL
    read.foreign = {.name = read.block.name, .id = id, .type = header.topology, .passed = true};
    return read;
  }
  const Kind* const kind = kind_of(header.topology, header.num_nodes_per_entry);
  if (kind == nullptr) {
    const std::string shown = read.block.name.empty() ? "" : " (" + excerpt(read.block.name) + ")";
    read.foreign = {.name = read.block.name,
                    .id = id,
                    .type = header.topology,
                    .count = static_cast<GlobalIndex>(count),
                    .fault = fmt::format(
                        "{}: invalid block {}{}: elements {} with {} nodes; expected HEX8, TET4, WEDGE6, PYRAMID5, "
                        "SHELL4 or SHELL3",
                        file.path(), id, shown, excerpt(header.topology), header.num_nodes_per_entry)};
    return read;
  }
  read.block.shape = kind->shape;
  read.kind = kind;
  Integers corners(count * static_cast<std::size_t>(kind->nodes));
  file.plausible(static_cast<std::int64_t>(corners.size()), fmt::format("element corners in block {}", id));
  file.succeed(ex_get_conn(file.id(), EX_ELEM_BLOCK, id, corners.data(), nullptr, nullptr),
               fmt::format("elements of block {}", id));
  const auto order = hex_corners(kind->nodes);
  const auto ours = static_cast<std::size_t>(mesh::nodes_per_element(kind->shape));
  read.block.nodes.reserve(count * ours);
  for (std::size_t e = 0; e < count; ++e)
    for (std::size_t k = 0; k < ours; ++k)
      read.block.nodes.push_back(
          zero_based(corners[e * static_cast<std::size_t>(kind->nodes) + static_cast<std::size_t>(order[k])]));
  return read;
}

/// ex_get_coord of the library's 6.02 takes the number 0 of a variable for none, and leaves that coordinate unread.
void read_first_variable(const ExodusFile& file, const char* name, std::vector<double>& values) {
  int variable = -1, dimensions = 0;
  if (nc_inq_varid(file.id(), name, &variable) != NC_NOERR || variable != 0) return;
  const std::size_t begin = 0, count = values.size();
  const bool read = nc_inq_varndims(file.id(), variable, &dimensions) == NC_NOERR && dimensions == 1 &&
                    nc_get_vara_double(file.id(), variable, &begin, &count, values.data()) == NC_NOERR;
  file.succeed(read ? 0 : -1, "coordinates");
}

void read_nodes(const ExodusFile& file, const ex_init_params& sizes, Mesh& mesh) {
  const std::size_t count = file.plausible(sizes.num_nodes, "nodes");
  std::vector<double> x(count), y(count), z(count);
  file.succeed(ex_get_coord(file.id(), x.data(), y.data(), z.data()), "coordinates");
  read_first_variable(file, "coordx", x);
  read_first_variable(file, "coordy", y);
  read_first_variable(file, "coordz", z);
  mesh.coordinates.reserve(count);
  for (std::size_t n = 0; n < count; ++n) mesh.coordinates.emplace_back(x[n], y[n], z[n]);
  mesh.node_id.resize(count);
  file.succeed(ex_get_id_map(file.id(), EX_NODE_MAP, mesh.node_id.data()), "node numbers");
}

std::vector<FileBlock> read_blocks(const ExodusFile& file, const ex_init_params& sizes, FileContent& content) {
  std::vector<FileBlock> blocks;
  std::int64_t total = 0;
  for (const std::int64_t id : file.ids(EX_ELEM_BLOCK, sizes.num_elem_blk, "element blocks")) {
    BlockRead read = read_block(file, id);
    if (read.foreign) {
      blocks.push_back({no_index, read.foreign->count, nullptr});
      content.foreign.push_back(std::move(*read.foreign));
    } else {
      blocks.push_back({static_cast<LocalIndex>(content.mesh.blocks.size()), read.block.count(), read.kind});
      content.mesh.blocks.push_back(std::move(read.block));
    }
    total += blocks.back().count;
  }
  if (total != sizes.num_elem)
    file.fail(fmt::format("invalid number of elements: {} in the blocks; expected {} as in the header", total,
                          sizes.num_elem));
  Integers numbers(static_cast<std::size_t>(total));
  file.succeed(ex_get_id_map(file.id(), EX_ELEM_MAP, numbers.data()), "element numbers");
  auto next = numbers.begin();
  for (const FileBlock& of : blocks) {
    if (of.block != no_index) nth(content.mesh.blocks, of.block).element_id.assign(next, next + of.count);
    next += of.count;
  }
  return blocks;
}

std::vector<std::string> words_of(const ExodusFile& file, ex_entity_type type, const Integers& ids,
                                  std::string_view kind, std::vector<std::string>& notes) {
  std::vector<FileSet> sets;
  for (const std::int64_t id : ids) sets.push_back({id, file.name(type, id)});
  return set_words(kind, sets, notes);
}

std::size_t set_size(const ExodusFile& file, ex_entity_type type, std::int64_t id, const std::string& what) {
  std::int64_t count = 0, factors = 0;
  file.succeed(ex_get_set_param(file.id(), type, id, &count, &factors), what);
  return file.plausible(count, "entries in " + what);
}

void read_node_sets(const ExodusFile& file, const ex_init_params& sizes, Mesh& mesh) {
  const Integers ids = file.ids(EX_NODE_SET, sizes.num_node_sets, "node sets");
  const std::vector<std::string> words = words_of(file, EX_NODE_SET, ids, "node set", mesh.notes);
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const std::int64_t id = ids[k];
    const std::string what = fmt::format("node set {}", id);
    Integers nodes(set_size(file, EX_NODE_SET, id, what));
    if (!nodes.empty()) file.succeed(ex_get_set(file.id(), EX_NODE_SET, id, nodes.data(), nullptr), what);
    auto& set = mesh.node_sets[words[k]];
    for (const std::int64_t n : nodes) set.push_back(zero_based(n));
  }
}

/// Side numbers of hexahedra, tetrahedra, pyramids and shells (1 the top, 2 the bottom) run as ours; a wedge has no
/// side where its hexahedron's third is.
int our_face(std::int64_t side, const Kind& kind) {
  if (side < 1 || side > kind.faces) return -1;
  const int face = static_cast<int>(side - 1);
  const bool is_wedge = kind.nodes == 6;
  return is_wedge && face >= 2 ? face + 1 : face;
}

/// After their two sides, shells number their edges: the corners of this edge, or -1.
cells::Edge our_edge(std::int64_t side, const Kind& kind) {
  const auto edges = cells::of(kind.shape).edges;
  const std::int64_t edge = side - kind.faces - 1;
  const bool is_edge = cells::is_surface(kind.shape) && edge >= 0 && edge < static_cast<std::int64_t>(edges.size());
  return is_edge ? nth(edges, edge) : cells::Edge{-1, -1};
}

/// Edges of shells in a side set: their nodes are a node set of its name, unless there is one.
void keep_edges(const std::string& name, const std::set<LocalIndex>& nodes, Mesh& mesh) {
  if (nodes.empty()) return;
  const bool fresh = mesh.node_sets.try_emplace(name, nodes.begin(), nodes.end()).second;
  mesh.notes.push_back(fmt::format("side set {}: {}", excerpt(name),
                                   fresh ? "its edges of shells are a node set"
                                         : "its edges of shells are not read, since a node set has the same name"));
  if (mesh.side_sets[name].empty()) mesh.side_sets.erase(name);
}

void read_side_sets(const ExodusFile& file, const ex_init_params& sizes, const std::vector<FileBlock>& blocks,
                    FileContent& content) {
  Integers first{0};  // element position where each block of the file starts
  for (const FileBlock& block : blocks) first.push_back(first.back() + block.count);
  const Integers ids = file.ids(EX_SIDE_SET, sizes.num_side_sets, "side sets");
  const std::vector<std::string> words = words_of(file, EX_SIDE_SET, ids, "side set", content.mesh.notes);
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const std::int64_t id = ids[k];
    const std::string what = fmt::format("side set {}", id);
    Integers elements(set_size(file, EX_SIDE_SET, id, what)), sides(elements.size());
    if (!elements.empty()) file.succeed(ex_get_set(file.id(), EX_SIDE_SET, id, elements.data(), sides.data()), what);
    const std::string& name = words[k];
    auto& set = content.mesh.side_sets[name];
    std::set<LocalIndex> edge_nodes;
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const std::int64_t element = elements[i] - 1;
      if (element < 0 || element >= first.back())
        file.fail(fmt::format("out of range: {} has element {}; expected 1 to {}", what, elements[i], first.back()));
      const auto at =
          static_cast<std::size_t>(std::upper_bound(first.begin(), first.end(), element) - first.begin() - 1);
      if (blocks[at].block == no_index) {
        ++content.foreign_sides[name];
        continue;
      }
      const auto position = static_cast<LocalIndex>(element - first[at]);
      const cells::Edge edge = our_edge(sides[i], *blocks[at].kind);
      for (const int corner : edge)
        if (corner >= 0) edge_nodes.insert(nth(content.mesh.blocks, blocks[at].block).element(position)[corner]);
      if (edge[0] < 0) set.push_back({blocks[at].block, position, our_face(sides[i], *blocks[at].kind)});
    }
    keep_edges(name, edge_nodes, content.mesh);
  }
}

}  // namespace

Mesh read_exodus(const std::string& path, const std::vector<std::string>& ignore) {
  const ExodusFile file(path);
  ex_init_params sizes{};
  file.succeed(ex_get_init_ext(file.id(), &sizes), "header");
  if (sizes.num_dim != 3) file.fail(fmt::format("invalid number of dimensions, {}; expected 3", sizes.num_dim));
  FileContent content;
  read_nodes(file, sizes, content.mesh);
  const auto blocks = read_blocks(file, sizes, content);
  read_node_sets(file, sizes, content.mesh);
  read_side_sets(file, sizes, blocks, content);
  return leave_out(path, std::move(content), ignore);
}

}  // namespace brunt::io
