// SPDX-License-Identifier: Apache-2.0
#include "parallel_report.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <vector>

#include "app/program/start_up.hpp"
#include "app/whole/weights.hpp"

namespace brunt::app {
namespace {

/// Cost of the elements of this rank, in units of a one-point hexahedron.
double element_cost(const model::Model& model) {
  double cost = 0;
  for (const model::ElementBlock& block : model.blocks)
    cost += block.count * cost_of(block.kind, block.section.points, material::is_rigid(block.law));
  return cost;
}

class Gathering {
 public:
  explicit Gathering(const comm::Communicator& ranks) : ranks_(ranks) {}
  [[nodiscard]] MeanAndMax operator()(double value) const { return mean_and_max(ranks_.gather_all(value)); }

 private:
  const comm::Communicator& ranks_;
};

nlohmann::ordered_json as_json(const MeanAndMax& figure) {
  return {{"mean", figure.mean}, {"max", figure.max}};
}

/// Of one kind of message, a step.
nlohmann::ordered_json as_json(const Gathering& over_ranks, const comm::Sent& sent, double steps) {
  const double share = steps > 0 ? 1 / steps : 0.0;
  return {{"messages", as_json(over_ranks(share * static_cast<double>(sent.messages)))},
          {"bytes", as_json(over_ranks(share * static_cast<double>(sent.bytes)))}};
}

}  // namespace

MeanAndMax mean_and_max(std::span<const double> values) {
  if (values.empty()) return {};
  return {std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size()),
          *std::ranges::max_element(values)};
}

int neighbours_of(const mesh::LocalMesh& mesh) {
  const std::set<Rank> others(mesh.sharers.values.begin(), mesh.sharers.values.end());
  return static_cast<int>(others.size());
}

nlohmann::ordered_json parallel_summary(const comm::Communicator& ranks, const model::Model& model,
                                        const RankWork& work) {
  const Gathering over_ranks(ranks);
  nlohmann::ordered_json parallel;
  parallel["neighbours"] = as_json(over_ranks(neighbours_of(model.mesh)));
  parallel["imbalance"]["elements"] = over_ranks(element_cost(model)).imbalance();
  for (const auto& [name, phase] : {std::pair{"element", Phase::element},
                                    {"search", Phase::search},
                                    {"enforcement", Phase::enforcement},
                                    {"halo", Phase::halo}})
    parallel["imbalance"][name] = over_ranks(work.timers.seconds(phase)).imbalance();
  parallel["halo"] = as_json(over_ranks, work.sent.halo, work.steps);
  parallel["exchange"] = as_json(over_ranks, work.sent.exchange, work.steps);
  parallel["collective"] = as_json(over_ranks, work.sent.collective, work.steps);
  parallel["peak_memory"] = as_json(over_ranks(peak_memory()));
  return parallel;
}

}  // namespace brunt::app
