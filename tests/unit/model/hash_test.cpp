// SPDX-License-Identifier: Apache-2.0
// The state hash: sees every bit and every place, and not how the state is split or stored.
#include "model/hash.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

using namespace brunt;
using model::StateArray;

namespace {

// Nodes with global ids `gid`, all owned; value(gid, c) = sin(3 gid + c).
struct NodalState {
  std::vector<GlobalIndex> gid;
  std::vector<double> values;
  model::Registry registry;

  explicit NodalState(std::vector<GlobalIndex> ids, const char* name = "velocity") : gid(std::move(ids)) {
    for (const GlobalIndex g : gid)
      for (int c = 0; c < 3; ++c) values.push_back(std::sin(static_cast<double>(3 * g + c)));
    registry.node_gid = gid;
    registry.owned_node_gid = gid;
    registry.owned_node.resize(gid.size());
    std::iota(registry.owned_node.begin(), registry.owned_node.end(), 0);
    StateArray array;
    array.name = name;
    array.count = static_cast<LocalIndex>(gid.size());
    array.components = 3;
    array.data = values.data();
    array.batch_stride = 3;
    registry.arrays.push_back(array);
  }
  NodalState(const NodalState&) = delete;
  NodalState& operator=(const NodalState&) = delete;
  [[nodiscard]] std::uint64_t hash() const { return model::hash_of_rank(registry, true); }
};

}  // namespace

TEST_CASE("state hash: parts of any split, in any local order, add up to the whole") {
  const std::uint64_t whole = NodalState({0, 1, 2, 3, 4}).hash();
  CHECK(NodalState({4, 0}).hash() + NodalState({3, 2, 1}).hash() == whole);
}

TEST_CASE("state hash: one bit, a swap of equal-sized places, or another name changes it") {
  NodalState state({0, 1, 2});
  const std::uint64_t before = state.hash();
  state.values[4] = std::nextafter(state.values[4], 2.0);
  CHECK(state.hash() != before);

  NodalState swapped_nodes({0, 1, 2});
  std::swap(swapped_nodes.values[0], swapped_nodes.values[3]);
  CHECK(swapped_nodes.hash() != before);
  NodalState swapped_components({0, 1, 2});
  std::swap(swapped_components.values[0], swapped_components.values[1]);
  CHECK(swapped_components.hash() != before);
  CHECK(NodalState({0, 1, 2}, "displacement").hash() != before);
}

TEST_CASE("state hash: the sign of zero counts") {
  CHECK(model::hash_value(1, 2, 0, 0.0) != model::hash_value(1, 2, 0, -0.0));
}

TEST_CASE("state hash: element batches hash like plain rows; arrays not hashed do not count") {
  const std::vector<GlobalIndex> gid{10, 11, 12};
  std::vector<double> rows{1, 2, 3, 4, 5, 6};                                 // element, component
  std::vector<double> batch{1, 3, 5, 0, 0, 0, 0, 0, 2, 4, 6, 0, 0, 0, 0, 0};  // component, lane
  StateArray plain;
  plain.name = "block/bar/stress";
  plain.entity = StateArray::Entity::element;
  plain.block = 0;
  plain.count = 3;
  plain.components = 2;
  plain.data = rows.data();
  plain.batch_stride = 2;
  StateArray packed = plain;
  packed.data = batch.data();
  packed.lanes = 8;
  packed.batch_stride = 16;
  packed.component_stride = 8;
  packed.lane_stride = 1;

  model::Registry registry;
  registry.element_gid = {gid};
  registry.arrays = {plain};
  const std::uint64_t hash = model::hash_of_rank(registry, true);
  CHECK(hash == model::hash_rows("block/bar/stress", 10, rows, 2));
  registry.arrays = {packed};
  CHECK(model::hash_of_rank(registry, true) == hash);
  packed.hashed = false;
  registry.arrays = {packed};
  CHECK(model::hash_of_rank(registry, true) == 0);
}

TEST_CASE("state hash: global values count once, on the root") {
  double time = 2.5;
  StateArray array;
  array.name = "time";
  array.entity = StateArray::Entity::global;
  array.count = 1;
  array.components = 1;
  array.data = &time;
  array.batch_stride = 1;
  model::Registry registry;
  registry.arrays = {array};
  CHECK(model::hash_of_rank(registry, true) != 0);
  CHECK(model::hash_of_rank(registry, false) == 0);
}

TEST_CASE("state hash: mixing spreads a single bit over about half of the result") {
  double mean = 0;
  for (int bit = 0; bit < 64; ++bit)
    mean += __builtin_popcountll(model::mix_bits(12345) ^ model::mix_bits(12345ULL ^ (1ULL << bit))) / 64.0;
  CHECK(mean == Approx(32).margin(3));  // avalanche: 32 of 64 expected, standard deviation 0.5
  CHECK(model::hash_digits(0xABC) == "0000000000000abc");
}

TEST_CASE("state hash: records count with their keys, in any order and split over any ranks") {
  RecordTable table{
      .name = "pairs", .key_width = 2, .value_width = 1, .keys = {1, 2, 2, 1, 3, -1}, .values = {5, 6, 7}};
  const std::uint64_t whole = model::hash_records(table);
  const RecordTable some{"pairs", 2, 1, {3, -1}, {7}}, others{"pairs", 2, 1, {2, 1, 1, 2}, {6, 5}};
  CHECK(model::hash_records(some) + model::hash_records(others) == whole);
  CHECK(model::hash_records(RecordTable{"pairs", 2, 1, {1, 2, 2, 1, 3, -1}, {6, 5, 7}}) != whole);
  CHECK(model::hash_records(RecordTable{"anchors", 2, 1, table.keys, table.values}) != whole);
  CHECK(model::hash_records(RecordTable{"pairs", 2, 1, {}, {}}) == 0);

  NodalState state({0, 1, 2});
  const std::uint64_t without = state.hash();
  state.registry.tables.push_back(&table);
  CHECK(state.hash() == without + whole);
}
