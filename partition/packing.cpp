// SPDX-License-Identifier: Apache-2.0
#include "partition/packing.hpp"

#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>

#include "core/error.hpp"

namespace brunt::partition {

namespace {

// Counter, Writer and Reader have the same functions, so that one list of fields (`fields` below) defines the layout
// for all of them.

/// Number of bytes of a Writer's output.
class Counter {
 public:
  std::size_t bytes = 0;

  template <class T>
  void plain(const T* /*first*/, std::size_t count) {
    bytes += count * sizeof(T);
  }
  std::size_t size(std::size_t count) {
    bytes += sizeof(std::uint64_t);
    return count;
  }
};

class Writer {
 public:
  std::vector<std::byte> bytes;

  template <class T>
  void plain(const T* first, std::size_t count) {
    const auto* begin = reinterpret_cast<const std::byte*>(first);
    bytes.insert(bytes.end(), begin, begin + count * sizeof(T));
  }
  std::size_t size(std::size_t count) {
    const std::uint64_t written = count;
    plain(&written, 1);
    return count;
  }
};

class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <class T>
  void plain(T* first, std::size_t count) {
    demand(count <= rest_.size() / sizeof(T), "a packed piece of mesh is complete");
    if (count > 0) std::memcpy(first, rest_.data(), count * sizeof(T));
    rest_ = rest_.subspan(count * sizeof(T));
  }
  std::size_t size(std::size_t /*count*/) {
    std::uint64_t count = 0;
    plain(&count, 1);
    return count;
  }
  [[nodiscard]] bool is_at_end() const { return rest_.empty(); }

 private:
  std::span<const std::byte> rest_;
};

template <class Stream, class T>
void field(Stream& stream, T& value) requires std::is_arithmetic_v<T> || std::is_enum_v<T> {
  stream.plain(&value, 1);
}

template <class Stream>
void field(Stream& stream, std::string& text) {
  text.resize(stream.size(text.size()));
  stream.plain(text.data(), text.size());
}

template <class Stream>
void field(Stream& stream, std::vector<Vec3>& points) {
  points.resize(stream.size(points.size()));
  if (!points.empty()) stream.plain(points.data()->data(), points.size() * 3);
}

template <class Stream>
void field(Stream& stream, mesh::LocalBlock& block);

template <class Stream, class T>
void field(Stream& stream, std::vector<T>& values) {
  values.resize(stream.size(values.size()));
  if constexpr (std::is_trivially_copyable_v<T>)
    stream.plain(values.data(), values.size());
  else
    for (T& value : values) field(stream, value);
}

template <class Stream>
void field(Stream& stream, mesh::LocalBlock& block) {
  field(stream, block.shape);
  field(stream, block.gid);
  field(stream, block.input);
  field(stream, block.nodes);
}

template <class Stream, class T>
void write_map(Stream& stream, std::map<std::string, T>& map) {
  stream.size(map.size());
  for (auto& [name, value] : map) {
    std::string key = name;
    field(stream, key);
    field(stream, value);
  }
}

template <class T>
void field(Counter& stream, std::map<std::string, T>& map) {
  write_map(stream, map);
}

template <class T>
void field(Writer& stream, std::map<std::string, T>& map) {
  write_map(stream, map);
}

template <class T>
void field(Reader& stream, std::map<std::string, T>& map) {
  for (std::size_t left = stream.size(0); left > 0; --left) {
    std::string name;
    field(stream, name);
    field(stream, map[name]);
  }
}

template <class Stream>
void fields(Stream& stream, mesh::LocalMesh& piece) {
  field(stream, piece.global_nodes);
  field(stream, piece.global_elements);
  stream.plain(piece.origin.data(), 3);
  field(stream, piece.coordinates);
  field(stream, piece.node_gid);
  field(stream, piece.input_node);
  field(stream, piece.node_id);
  field(stream, piece.owner);
  field(stream, piece.shared);
  field(stream, piece.sharers.offsets);
  field(stream, piece.sharers.values);
  field(stream, piece.block_name);
  field(stream, piece.block_id);
  field(stream, piece.blocks);
  field(stream, piece.faces);
  field(stream, piece.node_sets);
  field(stream, piece.side_sets);
}

}  // namespace

std::vector<std::byte> pack(mesh::LocalMesh piece) {
  Counter counter;
  fields(counter, piece);
  Writer writer;
  writer.bytes.reserve(counter.bytes);
  fields(writer, piece);
  return std::move(writer.bytes);
}

mesh::LocalMesh unpack(std::span<const std::byte> bytes) {
  Reader reader(bytes);
  mesh::LocalMesh piece;
  fields(reader, piece);
  demand(reader.is_at_end(), "a packed piece of mesh ends where its bytes do");
  return piece;
}

}  // namespace brunt::partition
