// SPDX-License-Identifier: Apache-2.0
// Numbers of elements, their growth, or their sizes at places.
#include <fmt/format.h>

#include "core/error.hpp"
#include "read_bodies.hpp"

namespace brunt::scene {
namespace {

constexpr std::string_view pairs = "sizes [[place, size], ...] instead of a number of elements";

bool read_sizes(const Key& key, const Extent& extent, mesh::Division& division) {
  const std::vector<Key> entries = items(key, pairs);
  if (entries.empty()) return key.tree->children.empty() && wrong(key, pairs);
  if (extent.even_only) {
    fault(key, fmt::format("invalid sizes: the elements {} are uniform; expected their number", extent.what));
    return false;
  }
  std::vector<mesh::SizeAt> sizes;
  for (const Key& entry : entries) {
    const std::vector<Key> pair = items(entry, "a pair [place, size]", 2);
    mesh::SizeAt one;
    if (pair.size() != 2 || !read(pair[0], one.place, any_number) || !read(pair[1], one.size, positive)) return false;
    if (!sizes.empty() && one.place <= sizes.back().place) {
      fault(pair[0],
            fmt::format("invalid place {}: not larger than the place before it, {}; expected increasing places",
                        one.place, sizes.back().place));
      return false;
    }
    if (extent.high > extent.low && (one.place < extent.low || one.place > extent.high)) {
      fault(pair[0], fmt::format("out of range: place {} is outside the body; expected a place from {} to {} {}",
                                 one.place, extent.low, extent.high, extent.what));
      return false;
    }
    sizes.push_back(one);
  }
  if (extent.high <= extent.low) return false;  // its lengths are already faults
  try {
    division = mesh::by_sizes(sizes, extent.low, extent.high);
  } catch (const InputError& error) {
    fault(key, error.faults().front());
    return false;
  }
  return true;
}

void read_bias(Section& body, std::span<const Extent> extents, std::span<mesh::Division> divisions) {
  if (!body.has("bias")) return;
  std::string names;
  for (const Extent& extent : extents) names += fmt::format("{}{}", names.empty() ? "" : ", ", extent.what);
  const std::string expected = fmt::format(
      "{} numbers > 0 [{}], each the size of the last element divided by that of the first", extents.size(), names);
  const std::vector<Key> entries = items(body.at("bias"), expected, extents.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    double bias = 1;
    if (!read(entries[i], bias, positive) || bias == 1) continue;
    if (extents[i].even_only)
      fault(entries[i], fmt::format("invalid bias: the elements {} are uniform; expected 1", extents[i].what));
    else if (!divisions[i].sizes.empty())
      fault(entries[i], fmt::format("invalid bias: the elements {} already have sizes; expected 1", extents[i].what));
    else if (bias > 1e6 || bias < 1e-6)
      fault(entries[i], fmt::format("out of range: {}; expected a number from 1e-6 to 1e6", bias));
    else
      divisions[i].bias = bias;
  }
}

}  // namespace

bool read_divisions(Section& body, std::span<const Extent> extents, std::span<mesh::Division> divisions,
                    std::string_view expected) {
  const std::vector<Key> entries = items(body.at("elements"), expected, extents.size());
  bool good = !entries.empty();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Key& entry = entries[i];
    const bool is_list = entry.tree != nullptr && entry.tree->kind == Tree::Kind::list;
    good =
        (is_list ? read_sizes(entry, extents[i], divisions[i]) : read(entry, divisions[i].cells, at_least_one)) && good;
  }
  read_bias(body, extents, divisions);
  return good;
}

void demand_countable(Section& body, double nodes, double elements) {
  constexpr double most = std::numeric_limits<LocalIndex>::max();
  constexpr int corners = mesh::nodes_per_element(mesh::Shape::hex8);  // of all elements in one array
  if (nodes <= most && corners * elements <= most) return;
  fault(body.at("elements"),
        fmt::format("out of range: {:.3g} elements in one body; expected at most {:.3g}", elements, most / corners));
}

}  // namespace brunt::scene
