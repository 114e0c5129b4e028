// SPDX-License-Identifier: Apache-2.0
#include "gathered_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/cells.hpp"
#include "mesh/check.hpp"

namespace brunt::api {
namespace {

struct Node {
  GlobalIndex number = 0;
  std::array<double, 3> position{};
  double mass = 0;
};
struct Element {
  GlobalIndex number = 0;
  std::int32_t part = 0;
  Rank rank = 0;
  cells::Shape shape = cells::Shape::hex8;
  std::array<GlobalIndex, cells::most_corners> corner{};  ///< numbers of nodes, of a tetrahedron the first four
};

/// Numbers of ContactMesh::corner for each element, whatever its shape.
constexpr std::size_t places = cells::most_corners;

cells::Shape shape_at(const ContactMesh& given, std::size_t element) {
  constexpr std::size_t fifth = 4;
  return given.corner[places * element + fifth] < 0 ? cells::Shape::tet4 : cells::Shape::hex8;
}

std::size_t corners_of(cells::Shape shape) {
  return static_cast<std::size_t>(cells::of(shape).corners);
}

std::string fault_of(const ContactMesh& given) {
  const std::size_t nodes = given.node_number.size(), elements = given.element_number.size();
  if (given.position.size() != 3 * nodes || given.mass.size() != nodes)
    return "position has three numbers and mass one for each of node_number";
  if (given.corner.size() != places * elements || given.part.size() != elements)
    return "corner has eight numbers and part one for each of element_number";
  if (!std::ranges::all_of(given.mass, [](double mass) { return mass > 0; })) return "masses are positive";
  if (!std::ranges::all_of(given.part, [](std::int32_t part) { return part >= 0; })) return "parts count from 0";
  for (std::size_t k = 0; k < given.corner.size(); ++k) {
    if (k % places >= corners_of(shape_at(given, k / places))) continue;
    if (given.corner[k] < 0 || static_cast<std::size_t>(given.corner[k]) >= nodes)
      return "corners are positions in node_number, from 0";
  }
  std::vector<std::int64_t> sorted = given.node_number;
  std::ranges::sort(sorted);
  if (std::ranges::adjacent_find(sorted) != sorted.end()) return "a rank has each node once";
  return {};
}

/// The text of the lowest rank that has one, on all.
void throw_if_any(const comm::Communicator& ranks, std::string text) {
  const GlobalIndex first = -ranks.max(text.empty() ? -ranks.size() : -static_cast<GlobalIndex>(ranks.rank()));
  if (first == ranks.size()) return;
  ranks.broadcast(text, static_cast<Rank>(first));
  throw std::invalid_argument(text);
}

template <class T>
std::vector<T> to_root(const comm::Communicator& ranks, const std::vector<T>& mine) {
  std::vector<T> all;
  for (const std::vector<std::byte>& bytes : ranks.gather(std::as_bytes(std::span(mine)))) {
    const std::size_t before = all.size();
    all.resize(before + bytes.size() / sizeof(T));
    if (!bytes.empty()) std::memcpy(&all[before], bytes.data(), bytes.size());
  }
  return all;
}

std::vector<Node> nodes_of(const ContactMesh& given) {
  std::vector<Node> mine;
  for (std::size_t n = 0; n < given.node_number.size(); ++n)
    mine.push_back({given.node_number[n],
                    {given.position[3 * n], given.position[3 * n + 1], given.position[3 * n + 2]},
                    given.mass[n]});
  return mine;
}

/// By number.
std::vector<Node> unique_nodes(std::vector<Node> all) {
  std::ranges::stable_sort(all, {}, &Node::number);
  for (std::size_t n = 1; n < all.size(); ++n)
    if (all[n].number == all[n - 1].number &&
        (all[n].position != all[n - 1].position || all[n].mass != all[n - 1].mass))
      throw std::invalid_argument("node " + std::to_string(all[n].number) +
                                  " has two positions or masses; expected one on all ranks");
  const auto same = [](const Node& a, const Node& b) { return a.number == b.number; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

std::vector<Element> elements_of(const ContactMesh& given, Rank rank) {
  std::vector<Element> mine;
  for (std::size_t e = 0; e < given.element_number.size(); ++e) {
    Element element{given.element_number[e], given.part[e], rank, shape_at(given, e), {}};
    for (std::size_t c = 0; c < corners_of(element.shape); ++c)
      element.corner[c] = nth(given.node_number, given.corner[places * e + c]);
    mine.push_back(element);
  }
  return mine;
}

/// By number.
std::vector<Element> unique_elements(std::vector<Element> all) {
  std::ranges::sort(all, {}, &Element::number);
  for (std::size_t e = 1; e < all.size(); ++e)
    if (all[e].number == all[e - 1].number)
      throw std::invalid_argument("element " + std::to_string(all[e].number) +
                                  " occurs twice; expected it on one rank");
  return all;
}

/// Throws std::invalid_argument where elements of two parts share a node.
void demand_parts_apart(const std::vector<Element>& elements) {
  std::map<GlobalIndex, std::int32_t> part_of;
  for (const Element& element : elements)
    for (std::size_t c = 0; c < corners_of(element.shape); ++c)
      if (const auto [known, is_new] = part_of.try_emplace(element.corner[c], element.part);
          !is_new && known->second != element.part)
        throw std::invalid_argument("node " + std::to_string(element.corner[c]) +
                                    " is one of two parts; expected parts without common nodes");
}

/// Root only; throws std::invalid_argument.
GatheredMesh joined(const std::vector<Node>& nodes, const std::vector<Element>& elements) {
  demand_parts_apart(elements);
  mesh::Mesh whole;
  for (const Node& node : nodes) {
    whole.coordinates.emplace_back(node.position.data());
    whole.node_id.push_back(node.number);
  }
  std::map<std::pair<std::int32_t, cells::Shape>, std::vector<const Element*>> blocks;  // by part, tetrahedra last
  for (const Element& element : elements) blocks[{element.part, element.shape}].push_back(&element);
  std::vector<Rank> rank_of_input;
  for (const auto& [kind, members] : blocks) {
    mesh::Block block;
    block.shape = kind.second;
    block.name = "part " + std::to_string(kind.first) + (kind.second == cells::Shape::tet4 ? " (tetrahedra)" : "");
    block.id = static_cast<GlobalIndex>(whole.blocks.size()) + 1;
    for (const Element* element : members) {
      block.element_id.push_back(element->number);
      rank_of_input.push_back(element->rank);
      for (int c = 0; c < mesh::nodes_per_element(block.shape); ++c) {
        const auto node = std::ranges::lower_bound(nodes, nth(element->corner, c), {}, &Node::number);
        block.nodes.push_back(static_cast<LocalIndex>(node - nodes.begin()));
      }
    }
    whole.blocks.push_back(std::move(block));
  }
  if (const mesh::CheckReport report = mesh::check(whole); !report.faults.empty())
    throw std::invalid_argument(report.faults.front());
  GatheredMesh gathered{mesh::canonical_order(std::move(whole)), {}};
  for (const std::vector<GlobalIndex>& block : gathered.mesh.input_element)
    for (const GlobalIndex input : block) gathered.rank_of_element.push_back(nth(rank_of_input, input));
  return gathered;
}

}  // namespace

GatheredMesh gather(const comm::Communicator& ranks, const ContactMesh& given) {
  throw_if_any(ranks, fault_of(given));
  GatheredMesh gathered;
  const std::vector<Node> nodes = to_root(ranks, nodes_of(given));
  const std::vector<Element> elements = to_root(ranks, elements_of(given, ranks.rank()));
  std::string fault;
  try {
    if (ranks.is_root()) gathered = joined(unique_nodes(nodes), unique_elements(elements));
  } catch (const std::invalid_argument& error) {
    fault = error.what();
  }
  throw_if_any(ranks, fault);
  return gathered;
}

std::vector<std::size_t> places_of(std::span<const std::int64_t> numbers, std::span<const GlobalIndex> wanted) {
  std::vector<std::size_t> order(numbers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t place) { return numbers[place]; });
  std::vector<std::size_t> places;
  for (const GlobalIndex number : wanted)
    places.push_back(*std::ranges::lower_bound(order, number, {}, [&](std::size_t place) { return numbers[place]; }));
  return places;
}

}  // namespace brunt::api
