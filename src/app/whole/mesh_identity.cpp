// SPDX-License-Identifier: Apache-2.0
#include "mesh_identity.hpp"

#include <bit>
#include <concepts>
#include <cstdint>

#include "model/hash.hpp"

namespace brunt::app {
namespace {

/// A hash of values in their order.
class Digest {
 public:
  void add(double value) { mix(std::bit_cast<std::uint64_t>(value)); }
  void add(std::integral auto value) { mix(static_cast<std::uint64_t>(value)); }
  void add(const std::string& text) { mix(model::hash_text(text)); }
  void add(const Vec3& x) {
    for (int c = 0; c < 3; ++c) add(x[c]);
  }
  void add(const mesh::Side& side) {
    add(side.block);
    add(side.element);
    add(side.face);
  }
  template <class Value>
  void add(const std::vector<Value>& values) {
    add(values.size());
    for (const Value& value : values) add(value);
  }
  /// Sets that the scene selects are left out.
  template <class Sets>
  void add_named(const Sets& sets) {
    for (const auto& [name, members] : sets) {
      if (name.starts_with('@')) continue;
      add(name);
      add(members);
    }
  }
  [[nodiscard]] std::string digits() const { return model::hash_digits(hash_); }

 private:
  void mix(std::uint64_t value) { hash_ = model::mix_bits(hash_ ^ model::mix_bits(value)) + 1; }

  std::uint64_t hash_ = 0;
};

}  // namespace

std::string mesh_digits(const mesh::CanonicalMesh& whole) {
  Digest digest;
  digest.add(whole.origin);
  digest.add(whole.mesh.coordinates);
  digest.add(whole.mesh.node_id);
  digest.add(whole.input_node);
  for (const mesh::Block& block : whole.mesh.blocks) {
    digest.add(block.name);
    digest.add(block.id);
    digest.add(static_cast<int>(block.shape));
    digest.add(block.nodes);
  }
  digest.add(whole.input_element);
  digest.add_named(whole.mesh.node_sets);
  digest.add_named(whole.mesh.side_sets);
  return digest.digits();
}

}  // namespace brunt::app
