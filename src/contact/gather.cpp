// SPDX-License-Identifier: Apache-2.0
#include "gather.hpp"

#include <array>

#include "geometry/closest_point.hpp"
#include "memory.hpp"

namespace brunt::contact {
namespace {

void measure_facets(const GatherPlan& plan, VectorView position, std::span<Vec3> own_area) {
  for (const GatherPlan::Facet& facet : plan.facets) {
    const auto count = static_cast<std::size_t>(facet.corner_count);
    std::array<Vec3, 4> corners;
    for (std::size_t i = 0; i < count; ++i) corners[i] = position[facet.model_nodes[i]];
    nth(own_area, facet.face) = geometry::area_vector({corners.data(), count}) / static_cast<double>(count);
  }
}

}  // namespace

GatherPlan plan_gather(const Surface& surface, const ContactLists& lists) {
  GatherPlan plan;
  const auto model_node = [&](LocalIndex node) { return nth(surface.model_node, node); };
  for (std::size_t i = 0; i < lists.nodes.surface_node.size(); ++i)
    if (const LocalIndex here = lists.nodes.surface_node[i]; here != no_index)
      plan.nodes.push_back({static_cast<LocalIndex>(i), model_node(here)});
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    if (lists.facet_needed[f] == 0) continue;
    const SurfaceFace& face = surface.faces[f];
    GatherPlan::Facet facet{static_cast<LocalIndex>(f), face.corner_count, {}};
    for (std::size_t i = 0; i < static_cast<std::size_t>(face.corner_count); ++i)
      facet.model_nodes[i] = model_node(face.nodes[i]);
    plan.facets.push_back(facet);
  }
  return plan;
}

void gather(const StepInput& input, const GatherPlan& plan, ContactLists& lists, StepData& step) {
  const VectorView predicted = input.predicted();
  for (std::size_t k = 0; k < plan.nodes.size(); ++k) {
    if (k + far_ahead < plan.nodes.size()) {
      const LocalIndex later = plan.nodes[k + far_ahead].model_node;
      input.position.fetch(later);
      input.old_velocity.fetch(later);
      predicted.fetch(later);
    }
    const auto [contact_node, node] = plan.nodes[k];
    nth(step.nodes.motion, contact_node) = {input.position[node], input.old_velocity[node], predicted[node]};
  }
  const std::span<double> motion = as_doubles(step.nodes.motion), own_area = as_doubles(step.own_area),
                          facet_area = as_doubles(step.facet_area);
  lists.exchange.begin_share(motion, node_motion_width);
  if (lists.any_facets) {
    measure_facets(plan, input.position, step.own_area);
    lists.facets.begin(own_area, facet_area, 3);
  }
  lists.exchange.end_share(motion, node_motion_width);
  if (lists.any_facets) lists.facets.end(own_area, facet_area, 3);
}

void scatter(Contact& contact, MutableVectorView velocity) {
  for (const auto& [contact_node, node] : contact.list_state.gather.nodes)
    velocity.set(node, nth(contact.step.nodes.velocity, contact_node));
  share_velocity(contact.surface, velocity, contact.surface_nodes.copies);
}

}  // namespace brunt::contact
