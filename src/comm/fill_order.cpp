// SPDX-License-Identifier: Apache-2.0
#include "fill_order.hpp"

#include <metis.h>

#include <algorithm>
#include <string>

#include "core/error.hpp"
#include "core/sorted.hpp"

namespace brunt::comm {
namespace {

struct Graph {
  std::vector<idx_t> begin{0}, neighbour;
};

/// Neighbours of each unknown in the pattern of A + A^T, without itself.
Graph symmetric_graph(std::span<const SolverIndex> begin, std::span<const SolverIndex> column) {
  const std::size_t n = begin.size() - 1;
  std::vector<std::vector<idx_t>> rows(n);
  for (std::size_t i = 0; i < n; ++i)
    for (auto k = static_cast<std::size_t>(begin[i]); k < static_cast<std::size_t>(begin[i + 1]); ++k) {
      const auto j = static_cast<std::size_t>(column[k]);
      if (j == i) continue;
      rows[i].push_back(static_cast<idx_t>(j));
      rows[j].push_back(static_cast<idx_t>(i));
    }
  Graph graph;
  for (std::vector<idx_t>& row : rows) {
    sort_unique(row);
    graph.neighbour.insert(graph.neighbour.end(), row.begin(), row.end());
    graph.begin.push_back(static_cast<idx_t>(graph.neighbour.size()));
  }
  return graph;
}

}  // namespace

std::vector<SolverIndex> elimination_order(std::span<const SolverIndex> begin, std::span<const SolverIndex> column) {
  Graph graph = symmetric_graph(begin, column);
  auto n = static_cast<idx_t>(begin.size() - 1);
  std::vector<idx_t> order(static_cast<std::size_t>(n)), position(order.size());
  if (graph.neighbour.empty()) {  // no fill-in, and METIS accepts no graph without edges
    std::vector<SolverIndex> as_given(order.size());
    for (std::size_t i = 0; i < as_given.size(); ++i) as_given[i] = static_cast<SolverIndex>(i);
    return as_given;
  }
  const int status =
      METIS_NodeND(&n, graph.begin.data(), graph.neighbour.data(), nullptr, nullptr, order.data(), position.data());
  if (status != METIS_OK) throw MachineError("METIS failed to order a matrix: error " + std::to_string(status));
  return {position.begin(), position.end()};
}

}  // namespace brunt::comm
