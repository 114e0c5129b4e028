// SPDX-License-Identifier: Apache-2.0
#include "partition/split.hpp"

#include <metis.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "comm/rendezvous.hpp"
#include "core/error.hpp"
#include "mesh/topology.hpp"
#include "partition/dual_graph.hpp"
#include "partition/level.hpp"

namespace brunt::partition {

namespace {

constexpr idx_t seed = 20231;
// Imbalance allowed to METIS, per mille above the mean. METIS uses all of it, and with 4 or less a quarter more faces
// are cut; since all ranks wait for the slowest part, the rest is balanced afterwards.
constexpr idx_t tolerance = 8;
constexpr double levelled = 5e-4;  // allowed imbalance over the mean after balancing
constexpr double smoothed = 8e-3;  // over the mean: as METIS, while borders are smoothed
// With few elements in each part METIS produces empty or unbalanced parts; intervals of the canonical order are then
// used.
constexpr LocalIndex fewest_elements_a_part = 8;

// METIS partitions clusters of neighbours along the canonical order if a part has more elements than this number of
// clusters: its time and memory decrease by the size of the clusters. The clusters increase the number of cut faces by
// about a fifth, which smoothing recovers.
constexpr LocalIndex clusters_a_part = 8192;
constexpr LocalIndex largest_cluster = 16;

struct MetisGraph {
  std::vector<idx_t> offsets{0};
  std::vector<idx_t> neighbours;
  std::vector<idx_t> faces;    // of each edge; empty: one
  std::vector<idx_t> weights;  // constraints of vertex 0, of vertex 1, ...
  idx_t constraints = 1;
};

/// Elements in each cluster.
LocalIndex cluster_size(LocalIndex elements, int parts) {
  return std::clamp<LocalIndex>(elements / parts / clusters_a_part, 1, largest_cluster);
}

/// Row c: neighbouring clusters of cluster c, which has the elements from c * size on; repeated for each face between
/// them.
void add_neighbours(const Ragged<LocalIndex>& graph, LocalIndex size, LocalIndex c, std::vector<LocalIndex>& row) {
  const LocalIndex first = c * size, last = std::min(first + size, graph.rows());
  for (LocalIndex e = first; e < last; ++e)
    for (const LocalIndex n : graph.row(e))
      if (n / size != c || size == 1) row.push_back(n / size);
}

/// Costs as integers whose sum does not overflow in METIS.
std::vector<idx_t> integer_costs(const std::vector<double>& cost) {
  const double total = std::accumulate(cost.begin(), cost.end(), 0.0);
  const double largest = *std::ranges::max_element(cost);
  const double scale = std::min(100.0 / largest, static_cast<double>(1 << 29) / total);
  std::vector<idx_t> integers;
  integers.reserve(cost.size());
  for (const double c : cost) integers.push_back(std::max<idx_t>(1, static_cast<idx_t>(std::lround(c * scale))));
  return integers;
}

/// A cluster without shared faces is connected to its neighbour in canonical order: METIS requires that no vertex is
/// isolated.
using Ties = std::map<LocalIndex, std::vector<LocalIndex>>;

Ties ties_of(const std::vector<LocalIndex>& lone, LocalIndex clusters) {
  Ties tied;
  for (const LocalIndex c : lone) {
    const LocalIndex beside = c > 0 ? c - 1 : 1;
    std::vector<LocalIndex>& own = tied[c];
    if (beside >= clusters || std::ranges::find(own, beside) != own.end()) continue;
    own.push_back(beside);
    tied[beside].push_back(c);
  }
  return tied;
}

void add_edges(const Ragged<LocalIndex>& graph, LocalIndex size, MetisGraph& out) {
  const LocalIndex clusters = (graph.rows() + size - 1) / size;
  std::vector<LocalIndex> row, lone;
  for (LocalIndex c = 0; c < clusters; ++c) {
    row.clear();
    add_neighbours(graph, size, c, row);
    if (row.empty()) lone.push_back(c);
  }
  const Ties tied = ties_of(lone, clusters);
  out.offsets.reserve(static_cast<std::size_t>(clusters) + 1);
  for (LocalIndex c = 0; c < clusters; ++c) {
    row.clear();
    add_neighbours(graph, size, c, row);
    if (const auto ties = tied.find(c); ties != tied.end())
      row.insert(row.end(), ties->second.begin(), ties->second.end());
    if (size > 1) std::ranges::sort(row);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const bool again = size > 1 && i > 0 && row[i] == row[i - 1];
      if (!again) out.neighbours.push_back(row[i]);
      if (size > 1 && !again) out.faces.push_back(0);
      if (size > 1) ++out.faces.back();
    }
    out.offsets.push_back(static_cast<idx_t>(out.neighbours.size()));
  }
}

template <class T>
std::vector<T> sums_of_clusters(const std::vector<T>& values, LocalIndex size) {
  const auto n = static_cast<std::size_t>(size);
  std::vector<T> sums((values.size() + n - 1) / n, T{});
  for (std::size_t e = 0; e < values.size(); ++e) sums[e / n] += values[e];
  return sums;
}

MetisGraph metis_graph(const Ragged<LocalIndex>& graph, const Weights& weights, LocalIndex size) {
  MetisGraph out;
  add_edges(graph, size, out);
  // a constraint that sums to zero would make METIS divide by zero
  const bool has_contact = std::ranges::any_of(weights.contact_faces, [](std::int32_t faces) { return faces > 0; });
  out.constraints = has_contact ? 2 : 1;
  const std::vector<idx_t> cost = integer_costs(sums_of_clusters(weights.cost, size));
  const std::vector<std::int32_t> faces = sums_of_clusters(weights.contact_faces, size);
  out.weights.reserve(cost.size() * static_cast<std::size_t>(out.constraints));
  for (std::size_t c = 0; c < cost.size(); ++c) {
    out.weights.push_back(cost[c]);
    if (has_contact) out.weights.push_back(faces[c]);
  }
  return out;
}

/// Empty if METIS fails.
std::vector<idx_t> metis_parts(MetisGraph graph, idx_t parts) {
  std::array<idx_t, METIS_NOPTIONS> options{};
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_SEED] = seed;
  options[METIS_OPTION_UFACTOR] = tolerance;
  options[METIS_OPTION_NUMBERING] = 0;
  auto elements = static_cast<idx_t>(graph.offsets.size() - 1);
  idx_t cut = 0;
  std::vector<idx_t> part(graph.offsets.size() - 1);
  const int status = METIS_PartGraphKway(
      &elements, &graph.constraints, graph.offsets.data(), graph.neighbours.data(), graph.weights.data(), nullptr,
      graph.faces.empty() ? nullptr : graph.faces.data(), &parts, nullptr, nullptr, options.data(), &cut, part.data());
  if (status != METIS_OK) part.clear();
  return part;
}

bool every_part_has_elements(const std::vector<idx_t>& part, int parts) {
  std::vector<bool> used(static_cast<std::size_t>(parts), false);
  for (const idx_t p : part) nth(used, p) = true;
  return std::ranges::find(used, false) == used.end();
}

/// Equal intervals of the canonical order.
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
    const LocalIndex element = nth(first, side.block) + side.element;
    ++nth(weights.contact_faces, element);
  }
  return weights;
}

std::vector<Rank> split(const Ragged<LocalIndex>& graph, const Weights& weights, int parts) {
  demand(parts >= 1, "a mesh is split into at least one part");
  const LocalIndex elements = graph.rows();
  if (parts == 1 || elements / parts < fewest_elements_a_part) return contiguous(elements, parts);
  const LocalIndex size = cluster_size(elements, parts);
  const std::vector<idx_t> part = metis_parts(metis_graph(graph, weights, size), parts);
  if (!every_part_has_elements(part, parts)) return contiguous(elements, parts);
  std::vector<Rank> levelled_part;
  levelled_part.reserve(static_cast<std::size_t>(elements));
  for (LocalIndex e = 0; e < elements; ++e) levelled_part.push_back(static_cast<Rank>(nth(part, e / size)));
  if (size > 1) smooth(graph, weights, parts, smoothed, levelled_part);
  level(graph, weights, parts, levelled, levelled_part);
  return levelled_part;
}

std::vector<Rank> split(const mesh::Mesh& mesh, int parts) {
  return split(dual_graph(mesh), weigh(mesh, mesh::exterior_sides(mesh)), parts);
}

}  // namespace brunt::partition
