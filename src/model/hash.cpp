// SPDX-License-Identifier: Apache-2.0
// The state hash (see the header).
#include "model/hash.hpp"

#include <fmt/format.h>

#include <bit>

namespace brunt::model {
namespace {

constexpr std::uint64_t golden = 0x9E3779B97F4A7C15;  // 2^64 / golden ratio, odd: the step of SplitMix64

std::uint64_t node_terms(const Registry& registry, const StateArray& array, std::uint64_t name) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < registry.owned_node.size(); ++i)
    for (int c = 0; c < array.components; ++c)
      sum += hash_value(name, registry.owned_node_gid[i], c, array.at(registry.owned_node[i], c));
  return sum;
}

std::uint64_t element_terms(const Registry& registry, const StateArray& array, std::uint64_t name) {
  const auto gid = registry.element_gid.at(static_cast<std::size_t>(array.block));
  std::uint64_t sum = 0;
  for (LocalIndex e = 0; e < array.count; ++e)
    for (int c = 0; c < array.components; ++c) sum += hash_value(name, nth(gid, e), c, array.at(e, c));
  return sum;
}

std::uint64_t global_terms(const StateArray& array, std::uint64_t name) {
  std::uint64_t sum = 0;
  for (LocalIndex i = 0; i < array.count; ++i)
    for (int c = 0; c < array.components; ++c) sum += hash_value(name, i, c, array.at(i, c));
  return sum;
}

}  // namespace

std::uint64_t mix_bits(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
  return z ^ (z >> 31);
}

std::uint64_t hash_text(std::string_view text) {
  std::uint64_t hash = 0xCBF29CE484222325;
  for (const char letter : text) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001B3;
  return mix_bits(hash);
}

std::uint64_t hash_value(std::uint64_t array, GlobalIndex gid, int component, double value) {
  std::uint64_t hash = mix_bits(array + golden * (static_cast<std::uint64_t>(gid) + 1));
  hash = mix_bits(hash + golden * (static_cast<std::uint64_t>(component) + 1));
  return mix_bits(hash ^ mix_bits(std::bit_cast<std::uint64_t>(value) + golden));
}

std::uint64_t hash_rows(std::string_view name, GlobalIndex first, std::span<const double> values, int components) {
  const std::uint64_t array = hash_text(name);
  std::uint64_t sum = 0;
  std::size_t k = 0;
  for (GlobalIndex gid = first; k < values.size(); ++gid)
    for (int c = 0; c < components; ++c) sum += hash_value(array, gid, c, values[k++]);
  return sum;
}

std::uint64_t hash_records(const RecordTable& table) {
  const std::uint64_t name = hash_text(table.name);
  std::uint64_t sum = 0;
  auto value = table.values.begin();
  for (auto key = table.keys.begin(); key != table.keys.end(); key += table.key_width) {
    std::uint64_t place = name;
    for (int k = 0; k < table.key_width; ++k)
      place = mix_bits(place + golden * (static_cast<std::uint64_t>(key[k]) + 1));
    for (int c = 0; c < table.value_width; ++c) sum += hash_value(place, 0, c, *value++);
  }
  return sum;
}

std::uint64_t hash_of_rank(const Registry& registry, bool is_root) {
  std::uint64_t sum = 0;
  for (const StateArray& array : registry.arrays) {
    if (!array.hashed) continue;
    const std::uint64_t name = hash_text(array.name);
    switch (array.entity) {
      case StateArray::Entity::node:
        sum += node_terms(registry, array, name);
        break;
      case StateArray::Entity::element:
        sum += element_terms(registry, array, name);
        break;
      case StateArray::Entity::global:
        if (is_root) sum += global_terms(array, name);
        break;
    }
  }
  for (const RecordTable* table : registry.tables) sum += hash_records(*table);
  return sum;
}

std::string hash_digits(std::uint64_t hash) {
  return fmt::format("{:016x}", hash);
}

}  // namespace brunt::model
