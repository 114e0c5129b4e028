// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <optional>

#include "app/program/commands.hpp"
#include "app/program/failure.hpp"
#include "app/start/restart.hpp"
#include "app/whole/same_scene.hpp"
#include "app/whole/weights.hpp"
#include "app/whole/whole_scene.hpp"
#include "io/results/checkpoint.hpp"
#include "io/results/partition_file.hpp"
#include "partition/dual_graph.hpp"
#include "partition/measured.hpp"
#include "partition/quality.hpp"
#include "partition/split.hpp"

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

/// What a rank's work costs, over the mean of the ranks. Work of elements and of contact are balanced each: between
/// them the ranks wait for each other.
double imbalance(const std::vector<double>& seconds) {
  const double total = std::accumulate(seconds.begin(), seconds.end(), 0.0);
  return total > 0 ? *std::ranges::max_element(seconds) * static_cast<double>(seconds.size()) / total : 1.0;
}

template <class Weight>
std::vector<double> of_parts(const std::vector<Weight>& weights, const std::vector<Rank>& part, int parts) {
  std::vector<double> sums(static_cast<std::size_t>(parts), 0.0);
  for (std::size_t e = 0; e < part.size(); ++e) nth(sums, part[e]) += static_cast<double>(weights[e]);
  return sums;
}

void print(const io::MeasuredWork& measured, const partition::Weights& weights, const std::vector<Rank>& part,
           int parts) {
  const auto line = [](const char* what, double before, double after) {
    fmt::print("imbalance of {:<13}{:.3f} as measured, {:.3f} expected of this partition\n", what, before, after);
  };
  line("element time", imbalance(measured.element_seconds), imbalance(of_parts(weights.cost, part, parts)));
  line("contact time", imbalance(measured.contact_seconds), imbalance(of_parts(weights.contact_faces, part, parts)));
}

partition::Measured view(const io::MeasuredWork& work) {
  return {work.element_seconds, work.contact_seconds, work.rank, work.pairs};
}

/// Of a checkpoint of this scene.
io::MeasuredWork measured_work(const std::string& checkpoint, const SceneIdentity& scene, std::size_t elements) {
  const io::CheckpointHeader header = io::read_checkpoint_header(comm::Communicator::self(), checkpoint);
  refuse_other_scene(checkpoint, {header.fingerprint, header.scene}, scene);
  io::MeasuredWork work = io::read_measured_work(checkpoint);
  if (work.rank.size() != elements)
    throw InputError(fmt::format("{}: invalid checkpoint of {} elements; expected {} as in the scene", checkpoint,
                                 work.rank.size(), elements));
  return work;
}

/// Nothing is overwritten.
void demand_new(const std::string& path) {
  if (std::filesystem::exists(path))
    throw InputError(path + ": invalid folder: it exists; expected the name of a new folder");
}

}  // namespace

int partition(const comm::Communicator& ranks, const PartitionOptions& options) {
  SceneIdentity scene;
  const scene::Input input = read_input(ranks, options.scene, options.overrides, &scene.fingerprint, &scene.values);
  const std::string checkpoint = options.from.empty() ? "" : checkpoint_of(ranks, options.from);
  on_root(ranks, [&] {
    if (!options.write.empty()) demand_new(options.write);
    std::vector<std::string> warnings;
    const mesh::CanonicalMesh whole = whole_mesh(input, warnings);
    scene.fingerprint = with_mesh(scene.fingerprint, whole);
    const Ragged<LocalIndex> graph = partition::dual_graph(whole.mesh);
    const partition::Weights usual = weigh(input, whole);
    std::optional<io::MeasuredWork> measured;
    if (!checkpoint.empty()) measured = measured_work(checkpoint, scene, usual.cost.size());
    const partition::Weights weights = measured ? partition::weigh(usual, view(*measured)) : usual;
    const std::vector<Rank> part = partition::split(graph, weights, options.parts);
    print(partition::quality(whole.mesh, graph, usual, part, options.parts));
    if (measured) print(*measured, weights, part, options.parts);
    if (!options.write.empty())
      io::write_partition(options.write, {options.parts, scene.fingerprint, scene.values, part});
  });
  return 0;
}

}  // namespace brunt::app
