// SPDX-License-Identifier: Apache-2.0
// Identification and order of the rows of a step.
#pragma once
#include <array>
#include <compare>
#include <cstdint>
#include <utility>

#include "core/types.hpp"

namespace brunt::contact {

/// Two bodies, the lower one first.
using BodyPair = std::pair<std::int32_t, std::int32_t>;

enum class RowKind : std::int8_t {
  face,       ///< a node on a face
  edge,       ///< an edge on an edge
  wall,       ///< a node on a rigid wall
  tie,        ///< a node that is tied to a face
  mortar,     ///< the facets around a node on those of a body
  mortar_tie  ///< the same, tied
};

struct RowKey {
  RowKind kind = RowKind::face;
  GlobalIndex slave = 0;         ///< gid of the node; of an edge its first end
  GlobalIndex slave_second = 0;  ///< of an edge: its other end
  GlobalIndex master = 0;  ///< key of the face, number of the wall; gid of an edge's first end; of facets the body
  GlobalIndex master_second = 0;  ///< of an edge: its other end; of facets the number among those of node and body
};

/// The key of an anchor. For a node it contains the master's body, not the face: the anchor is found again when the
/// node has moved to the next face. For an edge it contains the other edge.
struct AnchorKey {
  RowKind kind = RowKind::face;
  GlobalIndex slave = 0;
  GlobalIndex master = 0;  ///< body, number of the wall; of an edge its first end
  GlobalIndex slave_second = 0, master_second = 0;
};

/// The form of keys in checkpoints and in the state hash, which also defines their order: absent second ends are -1 (of
/// mortar rows -2, of those of ties -3), wall w is -1 - w. Kinds with equal keys (a tie is a node on a face) have the
/// same form.
using SavedKey = std::array<GlobalIndex, 4>;
constexpr GlobalIndex saved_mortar = -2, saved_mortar_tie = -3;
inline SavedKey saved(const RowKey& key) {
  if (key.kind == RowKind::mortar) return {key.slave, saved_mortar, key.master, key.master_second};
  if (key.kind == RowKind::mortar_tie) return {key.slave, saved_mortar_tie, key.master, key.master_second};
  if (key.kind == RowKind::edge) return {key.slave, key.slave_second, key.master, key.master_second};
  return {key.slave, -1, key.kind == RowKind::wall ? -1 - key.master : key.master, -1};
}
inline SavedKey saved(const AnchorKey& key) {
  if (key.kind == RowKind::edge) return {key.slave, key.master, key.slave_second, key.master_second};
  return {key.slave, key.kind == RowKind::wall ? -1 - key.master : key.master, -1, -1};
}
inline RowKey row_key_from(const SavedKey& key) {
  const auto [slave, slave_second, master, master_second] = key;
  if (slave_second >= 0) return {RowKind::edge, slave, slave_second, master, master_second};
  if (slave_second == saved_mortar)
    return {.kind = RowKind::mortar, .slave = slave, .master = master, .master_second = master_second};
  if (slave_second == saved_mortar_tie)
    return {.kind = RowKind::mortar_tie, .slave = slave, .master = master, .master_second = master_second};
  if (master < 0) return {.kind = RowKind::wall, .slave = slave, .master = -1 - master};
  return {.slave = slave, .master = master};
}
/// The slave node, or both ends of the slave edge, with which keys begin. Rows of one slave are of all kinds.
inline std::array<GlobalIndex, 2> slave_of(const RowKey& key) {
  return {key.slave, key.kind == RowKind::edge ? key.slave_second : -1};
}
inline AnchorKey anchor_key_from(const SavedKey& key) {
  const auto [slave, master, slave_second, master_second] = key;
  if (slave_second >= 0) return {RowKind::edge, slave, master, slave_second, master_second};
  if (master < 0) return {.kind = RowKind::wall, .slave = slave, .master = -1 - master};
  return {.slave = slave, .master = master};
}

inline bool operator==(const RowKey& a, const RowKey& b) {
  return saved(a) == saved(b);
}
inline auto operator<=>(const RowKey& a, const RowKey& b) {
  return saved(a) <=> saved(b);
}
inline bool operator==(const AnchorKey& a, const AnchorKey& b) {
  return saved(a) == saved(b);
}
inline auto operator<=>(const AnchorKey& a, const AnchorKey& b) {
  return saved(a) <=> saved(b);
}

}  // namespace brunt::contact
