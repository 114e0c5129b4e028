// SPDX-License-Identifier: Apache-2.0
// The elements of one part on this rank, in canonical order, in batches of pack_width elements (one for each lane).
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/aligned.hpp"
#include "core/cells.hpp"
#include "core/ragged.hpp"
#include "core/simd.hpp"
#include "element/options.hpp"
#include "material/law.hpp"
#include "model/erosion.hpp"

namespace brunt::model {

/// A corner on a node that other ranks also hold: its force is stored separately in `slot` and sent to them.
struct BorderCorner {
  std::int8_t lane = 0, corner = 0;
  LocalIndex slot = 0;
};

struct HistoryRange {
  std::string name;
  int first = 0, components = 0;  ///< position in the history of an element
};

struct ElementBlock {
  std::string part;
  std::string material;
  element::ElementKind kind = element::ElementKind::hex8;
  material::Law law;
  element::Hourglass hourglass;
  element::BulkViscosity bulk;
  std::optional<Erosion> erosion;
  element::ShellSection section;  ///< of shells

  LocalIndex count = 0;  ///< elements here; the last batch is padded with copies of the last element
  cells::Shape shape = cells::Shape::hex8;
  std::vector<GlobalIndex> gid;       ///< ascending
  std::vector<GlobalIndex> input;     ///< position in the input's order
  AlignedVector<LocalIndex> node;     ///< [batch][corner][lane], local
  Ragged<BorderCorner> border;        ///< a row for each batch
  std::vector<HistoryRange> history;  ///< history variables of each element
  int history_size = 0;               ///< doubles an element

  [[nodiscard]] LocalIndex batches() const { return (count + pack_width - 1) / pack_width; }
  [[nodiscard]] int corners() const { return cells::of(shape).corners; }  ///< of each element
  /// Its elements have rotations at their corners, and moments there.
  [[nodiscard]] bool turns() const { return element::is_shell(kind) && !material::is_rigid(law); }
  [[nodiscard]] int corner_components() const { return turns() ? 6 : 3; }  ///< of forces, then moments, at a corner
  [[nodiscard]] LocalIndex corner_node(LocalIndex e, int c) const {
    const std::ptrdiff_t row = std::ptrdiff_t{e / pack_width} * corners() + c;
    return nth(node, row * pack_width + e % pack_width);
  }
  [[nodiscard]] const HistoryRange* find(const std::string& name) const {
    for (const HistoryRange& range : history)
      if (range.name == name) return &range;
    return nullptr;
  }
};

}  // namespace brunt::model
