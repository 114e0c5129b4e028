// SPDX-License-Identifier: Apache-2.0
#include "snapshot.hpp"

#include <cstddef>

#include "core/error.hpp"

namespace brunt::app {
namespace {

/// Calls visit(value) for every saved value of this rank, always in the same order.
template <class Visit>
void for_saved(const model::Registry& registry, Visit&& visit) {
  for (const model::StateArray& array : registry.arrays) {
    if (!array.saved) continue;
    for (LocalIndex i = 0; i < array.count; ++i)
      for (int c = 0; c < array.components; ++c) visit(array.at(i, c));
  }
}

}  // namespace

void Snapshot::take(const model::Registry& registry) {
  values_.clear();
  std::size_t count = 0;
  for_saved(registry, [&](double) { ++count; });
  values_.reserve(count);
  for_saved(registry, [&](double value) { values_.push_back(value); });
  tables_.resize(registry.tables.size());
  for (std::size_t t = 0; t < tables_.size(); ++t) tables_[t] = *registry.tables[t];
}

void Snapshot::give_back(const model::Registry& registry) const {
  std::size_t next = 0;
  for_saved(registry, [&](double& value) {
    demand(next < values_.size(), "a snapshot is restored to the arrays it was taken of");
    value = values_[next++];
  });
  demand(tables_.size() == registry.tables.size(), "a snapshot is restored to the tables it was taken of");
  for (std::size_t t = 0; t < tables_.size(); ++t) *registry.tables[t] = tables_[t];
}

}  // namespace brunt::app
