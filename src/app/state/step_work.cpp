// SPDX-License-Identifier: Apache-2.0
#include "step_work.hpp"

#include "comm/message_time.hpp"

namespace brunt::app {
namespace {

double own_seconds() {
  return comm::processor_seconds() - comm::message_seconds();
}

/// By local node of the mesh.
std::vector<double> pairs_of_nodes(const model::Model& model, const contact::Contact& contact) {
  std::vector<double> pairs(static_cast<std::size_t>(model.nodes()), 0.0);
  const contact::ContactLists& lists = contact.lists;
  const auto add = [&](LocalIndex contact_node, double count) {
    const LocalIndex surface_node = nth(lists.nodes.surface_node, contact_node);
    if (surface_node == no_index) return;
    const LocalIndex node = nth(contact.surface.model_node, surface_node);
    nth(pairs, node) += count;
  };
  for (std::size_t i = 0; i < lists.candidates.slave.size(); ++i)
    add(lists.candidates.slave[i], static_cast<double>(lists.candidates.faces.row(static_cast<LocalIndex>(i)).size()));
  for (std::size_t i = 0; i < lists.edges.slaves.size(); ++i)
    add(lists.edges.slaves[i].nodes[0], static_cast<double>(lists.edges.near.row(static_cast<LocalIndex>(i)).size()));
  for (const contact::WallCandidate& candidate : lists.wall_candidates) add(candidate.node, 1);
  return pairs;
}

}  // namespace

WorkSample::WorkSample(double& seconds, bool on) : seconds_(on ? &seconds : nullptr) {
  if (!on) return;
  comm::time_messages(true);
  start_ = own_seconds();
}

WorkSample::~WorkSample() {
  if (!seconds_) return;
  *seconds_ += own_seconds() - start_;
  comm::time_messages(false);
}

std::vector<std::vector<double>> pairs_of_elements(const model::Model& model, const contact::Contact* contact) {
  std::vector<std::vector<double>> pairs;
  for (const model::ElementBlock& block : model.blocks) pairs.emplace_back(static_cast<std::size_t>(block.count), 0.0);
  if (!contact) return pairs;
  std::vector<double> of_node = pairs_of_nodes(model, *contact);
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const model::ElementBlock& block = model.blocks[b];
    for (LocalIndex e = 0; e < block.count; ++e)
      for (int c = 0; c < block.corners(); ++c) {
        double& left = nth(of_node, block.corner_node(e, c));
        nth(pairs[b], e) += left;
        left = 0;
      }
  }
  return pairs;
}

}  // namespace brunt::app
