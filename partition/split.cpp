// SPDX-License-Identifier: Apache-2.0
#include "partition/split.hpp"

#include <metis.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "brunt/comm/rendezvous.hpp"
#include "brunt/core/error.hpp"
#include "brunt/mesh/topology.hpp"
#include "partition/dual_graph.hpp"
#include "partition/level.hpp"

namespace brunt::partition {

namespace {

constexpr idx_t seed = 20231;
// Per mille above the mean that METIS may load a part. It takes what it is given, and with 4 or less a quarter more
// faces are cut; since all wait for the fullest part, what is left is levelled after it.
constexpr idx_t tolerance = 8;
constexpr double levelled = 5e-4;  // of the mean
// With few elements a part METIS leaves parts empty or far from balance; neighbours along the canonical order do.
constexpr LocalIndex fewest_elements_a_part = 8;

struct MetisGraph {
  std::vector<idx_t> offsets{0};
  std::vector<idx_t> neighbours;
  std::vector<idx_t> weights;  // constraints of element 0, of element 1, ...
  idx_t constraints = 1;
};

/// Costs as integers whose sum METIS can hold.
std::vector<idx_t> integer_costs(const std::vector<double>& cost) {
  const double total = std::accumulate(cost.begin(), cost.end(), 0.0);
  const double largest = *std::ranges::max_element(cost);
  const double scale = std::min(100.0 / largest, static_cast<double>(1 << 29) / total);
  std::vector<idx_t> integers;
  integers.reserve(cost.size());
  for (const double c : cost) integers.push_back(std::max<idx_t>(1, static_cast<idx_t>(std::lround(c * scale))));
  return integers;
}

/// An element that shares no face is tied to one beside it in canonical order: METIS wants no lone vertices.
std::vector<std::vector<LocalIndex>> ties_of_lone_elements(const Ragged<LocalIndex>& graph) {
  std::vector<std::vector<LocalIndex>> tied(static_cast<std::size_t>(graph.rows()));
  for (LocalIndex e = 0; e < graph.rows(); ++e) {
    if (!graph.row(e).empty()) continue;
    const LocalIndex beside = e > 0 ? e - 1 : 1;
    std::vector<LocalIndex>& own = tied[static_cast<std::size_t>(e)];
    if (beside >= graph.rows() || std::ranges::find(own, beside) != own.end()) continue;
    own.push_back(beside);
    tied[static_cast<std::size_t>(beside)].push_back(e);
  }
  return tied;
}

MetisGraph metis_graph(const Ragged<LocalIndex>& graph, const Weights& weights) {
  MetisGraph out;
  const std::vector<std::vector<LocalIndex>> tied = ties_of_lone_elements(graph);
  for (LocalIndex e = 0; e < graph.rows(); ++e) {
    const auto row = graph.row(e);
    const std::vector<LocalIndex>& ties = tied[static_cast<std::size_t>(e)];
    out.neighbours.insert(out.neighbours.end(), row.begin(), row.end());
    out.neighbours.insert(out.neighbours.end(), ties.begin(), ties.end());
    out.offsets.push_back(static_cast<idx_t>(out.neighbours.size()));
  }
  // a constraint that sums to zero would make METIS divide by zero
  const bool has_contact = std::ranges::any_of(weights.contact_faces, [](std::int32_t faces) { return faces > 0; });
  out.constraints = has_contact ? 2 : 1;
  const std::vector<idx_t> cost = integer_costs(weights.cost);
  for (std::size_t e = 0; e < cost.size(); ++e) {
    out.weights.push_back(cost[e]);
    if (has_contact) out.weights.push_back(weights.contact_faces[e]);
  }
  return out;
}

/// Empty where METIS fails.
std::vector<idx_t> metis_parts(MetisGraph& graph, idx_t parts) {
  std::array<idx_t, METIS_NOPTIONS> options{};
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_SEED] = seed;
  options[METIS_OPTION_UFACTOR] = tolerance;
  options[METIS_OPTION_NUMBERING] = 0;
  auto elements = static_cast<idx_t>(graph.offsets.size() - 1);
  idx_t cut = 0;
  std::vector<idx_t> part(graph.offsets.size() - 1);
  const int status = METIS_PartGraphKway(&elements, &graph.constraints, graph.offsets.data(), graph.neighbours.data(),
                                         graph.weights.data(), nullptr, nullptr, &parts, nullptr, nullptr,
                                         options.data(), &cut, part.data());
  if (status != METIS_OK) part.clear();
  return part;
}

bool every_part_has_elements(const std::vector<idx_t>& part, int parts) {
  std::vector<bool> used(static_cast<std::size_t>(parts), false);
  for (const idx_t p : part) used[static_cast<std::size_t>(p)] = true;
  return std::ranges::find(used, false) == used.end();
}

/// Equal pieces of the canonical order.
std::vector<Rank> contiguous(LocalIndex elements, int parts) {
  const comm::BlockLayout layout{elements, parts};
  std::vector<Rank> part;
  part.reserve(static_cast<std::size_t>(elements));
  for (LocalIndex e = 0; e < elements; ++e) part.push_back(layout.owner(e));
  return part;
}

}  // namespace

Weights weigh(const mesh::Mesh& mesh, std::span<const mesh::Side> exterior, std::span<const double> block_cost) {
  demand(block_cost.empty() || block_cost.size() == mesh.blocks.size(), "each block has a cost, or none has");
  Weights weights;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const mesh::Block& block = mesh.blocks[b];
    const double cost = !block_cost.empty() ? block_cost[b] : block.shape == mesh::Shape::hex8 ? 1.0 : 0.5;
    demand(cost > 0.0, "the cost of an element is positive");
    weights.cost.insert(weights.cost.end(), static_cast<std::size_t>(block.count()), cost);
  }
  weights.contact_faces.assign(weights.cost.size(), 0);
  const std::vector<LocalIndex> first = first_of_block(mesh);
  for (const mesh::Side& side : exterior) {
    const LocalIndex element = first[static_cast<std::size_t>(side.block)] + side.element;
    ++weights.contact_faces[static_cast<std::size_t>(element)];
  }
  return weights;
}

std::vector<Rank> split(const Ragged<LocalIndex>& graph, const Weights& weights, int parts) {
  demand(parts >= 1, "a mesh is split into one part or more");
  const LocalIndex elements = graph.rows();
  if (parts == 1 || elements / parts < fewest_elements_a_part) return contiguous(elements, parts);
  MetisGraph prepared = metis_graph(graph, weights);
  const std::vector<idx_t> part = metis_parts(prepared, parts);
  if (!every_part_has_elements(part, parts)) return contiguous(elements, parts);
  std::vector<Rank> levelled_part(part.begin(), part.end());
  level(graph, weights, parts, levelled, levelled_part);
  return levelled_part;
}

std::vector<Rank> split(const mesh::Mesh& mesh, int parts) {
  return split(dual_graph(mesh), weigh(mesh, mesh::exterior_sides(mesh)), parts);
}

}  // namespace brunt::partition
