// SPDX-License-Identifier: Apache-2.0
// Named selections, and functions of time.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "scene/read/sections.hpp"

namespace brunt::scene {
namespace {

void read_corners(const Key& key, SetEntry& set) {
  constexpr std::string_view expected = "two corners [[x, y, z], [x, y, z]], the lower one first";
  const std::vector<Key> corners = items(key, expected, 2);
  std::array<Vec3, 2> box{Vec3::Zero(), Vec3::Zero()};
  if (corners.size() != 2 || !read(corners[0], box[0], Vector::any) || !read(corners[1], box[1], Vector::any)) return;
  if ((box[0].array() > box[1].array()).any())
    return fault(key, fmt::format("invalid box: a lower bound exceeds the upper one; expected {}", expected));
  set.box = box;
}

void judge_set(const Key& map, SetEntry&) {
  constexpr std::string_view what =
      "invalid selection; expected one of part, node_set, side_set, or a box, alone or with part";
  const auto given = std::ranges::count_if(std::array{"part", "node_set", "side_set"},
                                           [&](const char* name) { return has(map, name); });
  const bool box = has(map, "box");
  if (given > 1 || (box && given == 1 && !has(map, "part"))) fault(map, what);
  if (given == 0 && !box) lacking(map, {"part", "node_set", "side_set", "box"}, what);
}

const Table<SetEntry> set_keys{
    "sets",
    "a map with one of part, node_set, side_set, or with a box",
    {
        {"part", value(&SetEntry::part, Named::part), "-", "All nodes of a part."},
        {"node_set", value(&SetEntry::node_set, Text{"name", "the name or number of a node set"}), "-",
         "Name of a node set of the mesh; the number of one without a name."},
        {"side_set", value(&SetEntry::side_set, Text{"name", "the name or number of a side set"}), "-",
         "Name of a side set of the mesh; the number of one without a name."},
        {"box", special("list", read_corners), "length",
         "Two corners; the nodes inside the closed box, of all bodies or of `part`."},
    },
    judge_set,
};

void read_set_map(const Key& map, Input& input) {
  for (const auto& [name, key] : entries(map, "a map of names, each a selection")) {
    SetEntry& set = input.sets.emplace_back();
    set.name = name;
    set_keys.read(key, set);
  }
}

Curve read_curve(const Key& key) {
  constexpr std::string_view expected = "a list of points [time, value], times increasing";
  Curve curve;
  const std::vector<Key> rows = items(key, expected);
  for (const Key& row : rows) {
    std::array<double, 2> point{};
    if (!read(row, point, any_number, "a point [time, value]")) break;
    if (!curve.empty() && point[0] <= curve.back()[0]) {
      fault(row,
            fmt::format("invalid time {}: not later than the time before it, {}; expected strictly increasing times",
                        point[0], curve.back()[0]));
      break;
    }
    curve.push_back(point);
  }
  if (is_list(key) && rows.empty()) wrong(key, expected);
  return curve;
}

void read_curve_map(const Key& map, Input& input) {
  for (const auto& [name, key] : entries(map, "a map of names, each a list of points [time, value]"))
    input.curves[name] = read_curve(key);
}

}  // namespace

Value<Input> sets_value() {
  return special("map", read_set_map, {&set_keys});
}
Value<Input> curves_value() {
  return special("map", read_curve_map);
}

}  // namespace brunt::scene
