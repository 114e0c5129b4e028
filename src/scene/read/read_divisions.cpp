// SPDX-License-Identifier: Apache-2.0
// Numbers of elements, their growth, or their sizes at places.
#include <fmt/format.h>

#include "core/error.hpp"
#include "given_body.hpp"
#include "mesh/mesh.hpp"

namespace brunt::scene {
namespace {

constexpr std::string_view pairs = "sizes [[place, size], ...] instead of a number of elements";

void read_sizes(const Key& key, const Extent& extent, mesh::Division& division) {
  const std::vector<Key> entries = items(key, pairs);
  if (entries.empty()) {
    wrong(key, pairs);
    return;
  }
  if (extent.even_only)
    return fault(key, fmt::format("invalid sizes: the elements {} are uniform; expected their number", extent.what));
  std::vector<mesh::SizeAt> sizes;
  for (const Key& entry : entries) {
    const std::vector<Key> pair = items(entry, "a pair [place, size]", 2);
    mesh::SizeAt one;
    if (pair.size() != 2 || !read(pair[0], one.place, any_number) || !read(pair[1], one.size, positive)) return;
    if (!sizes.empty() && one.place <= sizes.back().place)
      return fault(pair[0],
                   fmt::format("invalid place {}: not larger than the place before it, {}; expected increasing places",
                               one.place, sizes.back().place));
    if (extent.high > extent.low && (one.place < extent.low || one.place > extent.high))
      return fault(pair[0], fmt::format("out of range: place {} is outside the body; expected a place from {} to {} {}",
                                        one.place, extent.low, extent.high, extent.what));
    sizes.push_back(one);
  }
  if (extent.high <= extent.low) return;  // its lengths are already faults
  try {
    division = mesh::by_sizes(sizes, extent.low, extent.high);
  } catch (const InputError& error) {
    fault(key, error.faults().front());
  }
}

/// "three integers >= 1 [through the wall, around, along]".
std::string expected_elements(std::span<const Extent> extents) {
  std::string directions;
  for (const Extent& extent : extents) directions += fmt::format("{}{}", directions.empty() ? "" : ", ", extent.what);
  return fmt::format("{} integers >= 1 [{}]", extents.size() == 2 ? "two" : "three", directions);
}

}  // namespace

std::vector<Extent> extents_of(const GivenBody& body) {
  const auto& [inner, outer] = body.tube;
  if (body.kind == "box")
    return {{0, body.size[0], "along x"}, {0, body.size[1], "along y"}, {0, body.size[2], "along z"}};
  if (body.kind == "cylinder") return {{0, body.radius, "across the radius"}, {0, body.length, "along the axis"}};
  if (body.kind == "tube")
    return {{body.inner_radius.value_or(0), body.inner_radius ? body.outer_radius : 0, "through the wall"},
            {0, 0, "around", true},
            {0, body.length, "along the axis"}};
  if (body.kind == "torus")
    return {{0, 0, "around the ring", true}, {0, 0, "around the tube", true}, {inner, outer, "through the wall"}};
  const auto& [width, depth] = body.plate_size;
  if (body.shell) return {{-width / 2, width / 2, "along x"}, {-depth / 2, depth / 2, "along y"}};
  return {{-width / 2, width / 2, "along x"}, {-depth / 2, depth / 2, "along y"}, {0, body.thickness, "along z"}};
}

void read_elements(const Key& key, GivenBody& body) {
  const std::vector<Extent> extents = extents_of(body);
  const std::vector<Key> entries = items(key, expected_elements(extents), extents.size());
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (is_list(entries[i]))
      read_sizes(entries[i], extents[i], body.elements[i]);
    else
      read(entries[i], body.elements[i].cells, at_least_one);
}

void read_bias(const Key& key, GivenBody& body) {
  const std::vector<Extent> extents = extents_of(body);
  std::string names;
  for (const Extent& extent : extents) names += fmt::format("{}{}", names.empty() ? "" : ", ", extent.what);
  const std::string expected = fmt::format(
      "{} numbers > 0 [{}], each the size of the last element divided by that of the first", extents.size(), names);
  const std::vector<Key> entries = items(key, expected, extents.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    double bias = 1;
    if (!read(entries[i], bias, positive) || bias == 1) continue;
    if (extents[i].even_only)
      fault(entries[i], fmt::format("invalid bias: the elements {} are uniform; expected 1", extents[i].what));
    else if (!body.elements[i].sizes.empty())
      fault(entries[i], fmt::format("invalid bias: the elements {} already have sizes; expected 1", extents[i].what));
    else if (bias > 1e6 || bias < 1e-6)
      fault(entries[i], fmt::format("out of range: {}; expected a number from 1e-6 to 1e6", bias));
    else
      body.elements[i].bias = bias;
  }
}

void judge_countable(const Key& map, double nodes, double elements) {
  constexpr double most = std::numeric_limits<LocalIndex>::max();
  constexpr int corners = mesh::nodes_per_element(mesh::Shape::hex8);  // of all elements in one array
  if (nodes <= most && corners * elements <= most) return;
  fault(at(map, "elements"),
        fmt::format("out of range: {:.3g} elements in one body; expected at most {:.3g}", elements, most / corners));
}

}  // namespace brunt::scene
