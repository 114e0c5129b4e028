// SPDX-License-Identifier: Apache-2.0
#include "mesh/duplicate_elements.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <unordered_map>

#include "core/cells.hpp"
#include "core/excerpt.hpp"

namespace brunt::mesh {
namespace {

using Corners = std::array<LocalIndex, cells::most_corners>;  ///< distinct, ascending, then no_index

struct Element {
  LocalIndex block = 0, element = 0;
};

Corners corners_of(const Block& block, LocalIndex e) {
  Corners corners;
  corners.fill(std::numeric_limits<LocalIndex>::max());
  std::copy_n(block.element(e), nodes_per_element(block.shape), corners.begin());
  std::ranges::sort(corners);
  std::fill(std::unique(corners.begin(), corners.end()), corners.end(), std::numeric_limits<LocalIndex>::max());
  std::ranges::replace(corners, std::numeric_limits<LocalIndex>::max(), no_index);
  return corners;
}

/// Mixes the bits of the corners (splitmix64, Vigna 2015); equal corners have equal codes.
std::uint64_t code_of(const Corners& corners) {
  std::uint64_t code = 0;
  for (const LocalIndex n : corners) {
    code += static_cast<std::uint64_t>(n) + 0x9E3779B97F4A7C15U;
    code = (code ^ (code >> 30U)) * 0xBF58476D1CE4E5B9U;
    code = (code ^ (code >> 27U)) * 0x94D049BB133111EBU;
    code ^= code >> 31U;
  }
  return code;
}

std::string shown(const Block& block) {
  return block.name.empty() ? fmt::format("block {}", block.id) : "block " + excerpt(block.name);
}

GlobalIndex id_of(const Block& block, LocalIndex e) {
  return nth(block.element_id, e);
}

struct Box {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  void add(const Vec3& x) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  [[nodiscard]] double size() const { return (high - low).norm(); }
  [[nodiscard]] bool holds(const Vec3& x, double margin) const {
    return (x.array() >= low.array() - margin).all() && (x.array() <= high.array() + margin).all();
  }
};

constexpr double same_place = 1e-6;  ///< of an element's size, see the header

/// Elements of one piece in the box of another, found by their centres in a grid of half the smallest element's size.
class PlaceFinder {
 public:
  PlaceFinder(const Mesh& mesh, const std::vector<int>& piece) : mesh_(mesh), piece_(piece) {
    std::map<int, Box> boxes;
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
      for (const LocalIndex n : mesh.blocks[b].nodes) boxes[piece[b]].add(at(n));
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
      for (LocalIndex e = 0; e < mesh.blocks[b].count(); ++e) {
        const Box box = box_of({static_cast<LocalIndex>(b), e});
        const Vec3 centre = 0.5 * (box.low + box.high);
        const bool near = std::ranges::any_of(
            boxes, [&](const auto& other) { return other.first != piece[b] && other.second.holds(centre, 0); });
        if (!near) continue;
        elements_.push_back({static_cast<LocalIndex>(b), e});
        cell_ = std::min(cell_, 0.5 * box.size());
      }
  }

  /// Calls visit(a, b) for each pair of different pieces that lies corner on corner; b is the later one.
  template <class Visit>
  void each_pair(Visit visit) {
    std::unordered_multimap<std::uint64_t, Element> grid;
    for (const Element& element : elements_) {
      const Box box = box_of(element);
      const Vec3 centre = 0.5 * (box.low + box.high);
      const double margin = same_place * box.size();
      std::array<std::uint64_t, 8> cells{};
      for (unsigned corner = 0; corner < 8; ++corner)
        cells[corner] =
            cell_of(centre + margin * Vec3(corner & 1U ? 1 : -1, corner & 2U ? 1 : -1, corner & 4U ? 1 : -1));
      std::ranges::sort(cells);
      const auto repeated = std::unique(cells.begin(), cells.end());
      for (auto cell = cells.begin(); cell != repeated; ++cell) {
        const auto [first, last] = grid.equal_range(*cell);
        for (auto other = first; other != last; ++other)
          if (in_same_place(other->second, element, margin)) visit(other->second, element);
      }
      grid.emplace(cell_of(centre), element);
    }
  }

 private:
  [[nodiscard]] const Vec3& at(LocalIndex n) const { return nth(mesh_.coordinates, n); }
  [[nodiscard]] const Block& block(const Element& element) const { return nth(mesh_.blocks, element.block); }
  [[nodiscard]] Box box_of(const Element& element) const {
    Box box;
    const Block& of = block(element);
    for (int k = 0; k < nodes_per_element(of.shape); ++k) box.add(at(of.element(element.element)[k]));
    return box;
  }
  [[nodiscard]] std::uint64_t cell_of(const Vec3& x) const {
    Corners cell;
    cell.fill(0);
    for (int i = 0; i < 3; ++i) {
      const auto index = static_cast<std::int64_t>(std::floor(x[i] / cell_));
      nth(cell, 2 * i) = static_cast<LocalIndex>(index & 0xFFFFFF);
      nth(cell, 2 * i + 1) = static_cast<LocalIndex>((index >> 24) & 0xFFFFFF);
    }
    return code_of(cell);
  }
  [[nodiscard]] bool in_same_place(const Element& a, const Element& b, double margin) const {
    if (nth(piece_, a.block) == nth(piece_, b.block)) return false;
    const Corners of_a = corners_of(block(a), a.element), of_b = corners_of(block(b), b.element);
    for (std::size_t k = 0; k < of_a.size(); ++k) {
      if ((of_a[k] == no_index) != (of_b[k] == no_index)) return false;
      if (of_a[k] == no_index) break;
      if (std::ranges::none_of(of_b,
                               [&](LocalIndex n) { return n != no_index && (at(n) - at(of_a[k])).norm() <= margin; }))
        return false;
    }
    return true;
  }

  const Mesh& mesh_;
  const std::vector<int>& piece_;
  std::vector<Element> elements_;
  double cell_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::vector<std::string> duplicate_elements(const Mesh& mesh) {
  std::vector<std::pair<std::uint64_t, Element>> coded;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    for (LocalIndex e = 0; e < mesh.blocks[b].count(); ++e)
      coded.emplace_back(code_of(corners_of(mesh.blocks[b], e)), Element{static_cast<LocalIndex>(b), e});
  std::ranges::stable_sort(coded, {}, [](const auto& entry) { return entry.first; });
  std::vector<std::pair<Element, Element>> duplicates;
  const auto block = [&](const Element& e) -> const Block& { return nth(mesh.blocks, e.block); };
  for (std::size_t first = 0, i = 1; i < coded.size(); ++i) {
    if (coded[i].first != coded[first].first) first = i;
    for (std::size_t j = first; j < i; ++j) {
      const Element &a = coded[j].second, &b = coded[i].second;
      if (corners_of(block(a), a.element) != corners_of(block(b), b.element)) continue;
      duplicates.emplace_back(a, b);
      break;
    }
  }
  std::ranges::sort(duplicates, {},
                    [](const auto& duplicate) { return std::pair(duplicate.second.block, duplicate.second.element); });
  std::vector<std::string> lines;
  for (const auto& [a, b] : duplicates)
    lines.push_back(
        fmt::format("invalid element {} ({}): it has the nodes of element {} ({}), so its mass would be counted twice; "
                    "expected each element once",
                    id_of(block(b), b.element), shown(block(b)), id_of(block(a), a.element), shown(block(a))));
  return lines;
}

std::vector<std::string> coincident_elements(const Mesh& mesh, const std::vector<int>& piece) {
  struct Found {
    LocalIndex count = 0;
    Element a, b;
  };
  std::map<std::pair<LocalIndex, LocalIndex>, Found> found;
  if (std::ranges::adjacent_find(piece, std::ranges::not_equal_to{}) == piece.end()) return {};  // one piece alone
  PlaceFinder(mesh, piece).each_pair([&](const Element& a, const Element& b) {
    Found& pair = found[{a.block, b.block}];
    if (pair.count++ == 0) pair = {1, a, b};
  });
  std::vector<std::string> lines;
  for (const auto& [blocks, pair] : found) {
    const Block &one = nth(mesh.blocks, blocks.first), &other = nth(mesh.blocks, blocks.second);
    lines.push_back(fmt::format(
        "invalid {} and {}: {} element{} of one coincide{} with elements of the other (elements {} and {}{}), so "
        "mass would be counted twice; expected each body once, and independent bodies apart (at)",
        shown(one), shown(other), pair.count, pair.count == 1 ? "" : "s", pair.count == 1 ? "s" : "",
        id_of(one, pair.a.element), id_of(other, pair.b.element), pair.count == 1 ? "" : " for one"));
  }
  return lines;
}

}  // namespace brunt::mesh
