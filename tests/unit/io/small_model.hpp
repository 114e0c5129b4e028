// SPDX-License-Identifier: Apache-2.0
// A model of a few nodes and elements dealt out to any number of ranks, whose values are known functions of their
// place.
#pragma once
#include <cmath>
#include <vector>

#include "comm/communicator.hpp"
#include "model/registry.hpp"

namespace brunt::test {

/// Nodes 0..22: node g is owned by rank g % n and also held by rank (g + 1) % n. Blocks of 11 and 5 elements dealt out
/// likewise, each on one rank; the first block lies in batches of eight. Global values: time and step.
class SmallModel {
 public:
  static constexpr GlobalIndex nodes = 23;

  explicit SmallModel(const comm::Communicator& ranks) {
    registry.global_nodes = nodes;
    registry.block_first = {0, 11};
    registry.block_count = {11, 5};
    const GlobalIndex n = ranks.size(), r = ranks.rank();
    for (GlobalIndex g = 0; g < nodes; ++g) {
      if (g % n != r && (g + 1) % n != r) continue;
      if (g % n == r) {
        registry.owned_node_gid.push_back(g);
        registry.owned_node.push_back(static_cast<LocalIndex>(node_gid_.size()));
      }
      node_gid_.push_back(g);
    }
    registry.node_gid = node_gid_;
    for (std::size_t b = 0; b < 2; ++b)
      for (GlobalIndex e = registry.block_first[b]; e < registry.block_first[b] + registry.block_count[b]; ++e)
        if (e % n == r) element_gid_[b].push_back(e);
    registry.element_gid = {element_gid_[0], element_gid_[1]};

    velocity_.resize(node_gid_.size() * 3);
    add_rows("velocity", model::StateArray::Entity::node, -1, node_gid_.size(), 3, velocity_);
    stress_.resize((element_gid_[0].size() + 7) / 8 * 48);
    add_rows("block/bar/stress", model::StateArray::Entity::element, 0, element_gid_[0].size(), 6, stress_);
    registry.arrays.back().lanes = 8;
    registry.arrays.back().batch_stride = 48;
    registry.arrays.back().component_stride = 8;
    registry.arrays.back().lane_stride = 1;
    alive_.resize(element_gid_[1].size());
    add_rows("block/plate/alive", model::StateArray::Entity::element, 1, element_gid_[1].size(), 1, alive_);
    add_rows("clock", model::StateArray::Entity::global, -1, 1, 2, clock_);
  }
  SmallModel(const SmallModel&) = delete;
  SmallModel& operator=(const SmallModel&) = delete;

  /// The known value of component c of entity gid of array number a: awkward bits, with NaN and -0.0 among them.
  static double known(std::size_t a, GlobalIndex gid, int c) {
    if (gid == 3 && c == 0) return -0.0;
    if (gid == 4 && c == 0) return std::nan("");
    return std::sin(1.0 + static_cast<double>(a)) * std::exp(static_cast<double>(gid * 7 - 30 * c));
  }

  /// Sets every value, copies of other ranks' nodes too.
  void fill_known() const {
    each([](double& value, double expected) { value = expected; });
  }
  /// Number of values that have not the known bits.
  [[nodiscard]] int wrong_values() const {
    int wrong = 0;
    each([&](const double& value, double expected) {
      const bool same =
          std::isnan(expected) ? std::isnan(value) : value == expected && std::signbit(value) == std::signbit(expected);
      wrong += same ? 0 : 1;
    });
    return wrong;
  }

  model::Registry registry;

 private:
  void add_rows(const char* name, model::StateArray::Entity entity, int block, std::size_t count, int components,
                std::vector<double>& data) {
    model::StateArray array;
    array.name = name;
    array.entity = entity;
    array.block = block;
    array.count = static_cast<LocalIndex>(count);
    array.components = components;
    array.data = data.data();
    array.batch_stride = components;
    registry.arrays.push_back(array);
  }

  template <class Visit>
  void each(Visit visit) const {
    for (std::size_t a = 0; a < registry.arrays.size(); ++a) {
      const model::StateArray& array = registry.arrays[a];
      for (LocalIndex i = 0; i < array.count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        GlobalIndex gid = i;
        if (array.entity == model::StateArray::Entity::node) gid = node_gid_[k];
        if (array.entity == model::StateArray::Entity::element) gid = element_gid_[array.block == 0 ? 0 : 1][k];
        for (int c = 0; c < array.components; ++c) visit(array.at(i, c), known(a, gid, c));
      }
    }
  }

  std::vector<GlobalIndex> node_gid_;
  std::vector<GlobalIndex> element_gid_[2];
  std::vector<double> velocity_, stress_, alive_, clock_ = std::vector<double>(2);
};

}  // namespace brunt::test
