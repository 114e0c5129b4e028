// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include "commands.hpp"
#include "failure.hpp"
#include "partition/dual_graph.hpp"
#include "partition/quality.hpp"
#include "partition/split.hpp"
#include "prepare.hpp"
#include "weights.hpp"

namespace brunt::app {
namespace {

void print(const partition::Quality& q) {
  fmt::print("parts                     {}{}\n", q.parts,
             q.empty_parts ? fmt::format(" ({} empty)", q.empty_parts) : "");
  fmt::print("elements                  {}\n", q.elements);
  fmt::print("contact faces             {}\n", q.contact_faces);
  fmt::print("imbalance of elements     {:.3f}   (largest over mean; 1 is perfect)\n", q.element_imbalance);
  fmt::print("imbalance of faces        {:.3f}\n", q.contact_imbalance);
  fmt::print("element faces cut         {}\n", q.edge_cut);
  fmt::print("shared nodes              {}\n", q.shared_nodes);
  fmt::print("corner forces sent        {}   (by all parts in a step)\n", q.corner_forces);
  fmt::print("neighbours                {} at most, {:.2f} in the mean\n", q.neighbours_max, q.neighbours_mean);
}

}  // namespace

int partition(const comm::Communicator& ranks, const PartitionOptions& options) {
  const scene::Input input = read_input(ranks, options.scene, options.overrides);
  on_root(ranks, [&] {
    std::vector<std::string> warnings;
    const mesh::CanonicalMesh whole = whole_mesh(input, warnings);
    const Ragged<LocalIndex> graph = partition::dual_graph(whole.mesh);
    const partition::Weights weights = weigh(input, whole);
    const std::vector<Rank> part = partition::split(graph, weights, options.parts);
    print(partition::quality(whole.mesh, graph, weights, part, options.parts));
  });
  return 0;
}

}  // namespace brunt::app
