// SPDX-License-Identifier: Apache-2.0
// Order along the Hilbert curve by radix sort, repeated within crowded cells.
#include "contact/search/spatial_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "hilbert_key.hpp"

namespace brunt::contact {
namespace {

using Item = std::uint64_t;

constexpr int digit_bits = 10, digit_count = 3;
static_assert(digit_bits * digit_count == 3 * key_levels);
constexpr std::size_t digit_values = std::size_t{1} << digit_bits;
constexpr std::size_t crowd = 16;        // so many may share a cell in any order
constexpr std::size_t comparison = 400;  // below, sorting by comparison is quicker than clearing histograms

std::uint32_t key_of(Item item) {
  return static_cast<std::uint32_t>(item >> 32);
}
LocalIndex index_of(Item item) {
  return static_cast<LocalIndex>(item & 0xFFFFFFFFU);
}

struct PointPlaces {
  std::span<const Vec3> points;
  [[nodiscard]] Vec3 operator()(LocalIndex i) const { return nth(points, i); }
};

struct BoxPlaces {
  std::span<const geometry::Box> boxes;
  const geometry::Box& region;
  [[nodiscard]] Vec3 operator()(LocalIndex i) const {
    const geometry::Box& box = nth(boxes, i);
    return 0.5 * box.low.cwiseMax(region.low) + 0.5 * box.high.cwiseMin(region.high);
  }
};

/// A cube of the curve's octree and the curve's orientation in it. Cells are cubes whatever the set's shape: noise
/// across a flat set is no dimension of it.
struct Cube {
  Vec3 low;
  double size = 0;
  HilbertState state;

  /// Goes down to the smallest cube of the octree that holds the box: no pass over the points for what is empty.
  void shrink_to(const geometry::Box& box) {
    while (size / 2 > 0) {
      const double half = size / 2;
      unsigned octant = 0;
      for (int a = 0; a < 3; ++a) {
        const double middle = low[a] + half;
        if (box.low[a] >= middle) octant |= 1U << a;
        if (box.low[a] < middle && !(box.high[a] < middle)) return;
      }
      for (int a = 0; a < 3; ++a)
        if ((octant >> a & 1U) != 0) low[a] += half;
      size = half;
      state.enter(octant);
    }
  }
};

template <class Places>
class Sorter {
 public:
  Sorter(const Places& places, SortScratch& scratch) : place_(places), scratch_(scratch) {}

  /// Items hold indices on entry; on return they stand in order. `within` holds them all, or has no size.
  void sort(std::size_t first, std::size_t last, Cube within) {
    const std::span<Item> items(scratch_.items.data() + first, last - first);
    const geometry::Box around = box_around(items);
    const Cube own{around.low, (around.high - around.low).maxCoeff(), {}};
    if (!(own.size > 0) || !std::isfinite(own.size)) return;  // so far apart that any order serves
    if (within.size > 0) {
      within.shrink_to(around);
    } else {
      within = own;
    }
    // cells of the octree may be too small for their coordinates' rounding
    if (!set_keys(items, within) && !set_keys(items, within = own)) return;
    if (items.size() < comparison) {
      std::sort(items.begin(), items.end());
    } else {
      radix_sort(items, {scratch_.other.data() + first, last - first});
    }
    for (std::size_t run = first; run < last;) {
      std::size_t end = run + 1;
      while (end < last && key_of(scratch_.items[end]) == key_of(scratch_.items[run])) ++end;
      if (end - run > crowd) sort(run, end, within);
      run = end;
    }
  }

 private:
  geometry::Box box_around(std::span<const Item> items) const {
    geometry::Box around;
    for (const Item item : items) {
      const Vec3 x = place_(index_of(item));
      around.low = around.low.cwiseMin(x);
      around.high = around.high.cwiseMax(x);
    }
    return around;
  }

  /// False if all keys are equal: nothing is sorted by them.
  bool set_keys(std::span<Item> items, const Cube& cube) {
    const double per_length = (1 << key_levels) / cube.size;
    std::uint32_t any = 0, all = ~std::uint32_t{0};
    for (std::size_t first = 0; first < items.size(); first += key_batch) {
      const std::size_t count = std::min(key_batch, items.size() - first);
      alignas(64) std::array<double, key_batch> x[3]{};
      for (std::size_t i = 0; i < count; ++i) {
        const Vec3 place = place_(index_of(items[first + i]));
        for (int a = 0; a < 3; ++a) x[a][i] = place[a];
      }
      alignas(64) std::array<KeyBatch, 3> cells;
      alignas(64) KeyBatch keys;
      for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t i = 0; i < key_batch; ++i) {
          constexpr double last = (1 << key_levels) - 1;
          const double cell = (x[a][i] - cube.low[static_cast<int>(a)]) * per_length;
          cells[a][i] = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::max(0.0, std::min(last, cell))));
        }
      hilbert_keys(cells, cube.state, keys);
      for (std::size_t i = 0; i < count; ++i) {
        any |= keys[i];
        all &= keys[i];
        items[first + i] = Item{keys[i]} << 32 | (items[first + i] & 0xFFFFFFFFU);
      }
    }
    return any != all;
  }

  void radix_sort(std::span<Item> items, std::span<Item> other) {
    std::vector<LocalIndex>& digits = scratch_.digits;
    digits.assign(digit_count * digit_values, 0);
    for (const Item item : items)
      for (std::size_t d = 0; d < digit_count; ++d) ++digits[d * digit_values + digit(item, d)];
    std::span<Item> from = items, to = other;
    for (std::size_t d = 0; d < digit_count; ++d) {
      LocalIndex* next = digits.data() + d * digit_values;
      if (static_cast<std::size_t>(next[digit(from[0], d)]) == from.size()) continue;  // one value: in order already
      LocalIndex start = 0;
      for (std::size_t value = 0; value < digit_values; ++value) start += std::exchange(next[value], start);
      for (const Item item : from) nth(to, next[digit(item, d)]++) = item;
      std::swap(from, to);
    }
    if (from.data() != items.data()) std::copy(from.begin(), from.end(), items.begin());
  }

  static std::size_t digit(Item item, std::size_t d) { return (item >> (32 + d * digit_bits)) & (digit_values - 1); }

  const Places& place_;
  SortScratch& scratch_;
};

template <class Places>
void order_by(const Places& places, std::vector<LocalIndex>& order, SortScratch& scratch) {
  scratch.items.resize(order.size());
  scratch.other.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) scratch.items[i] = static_cast<Item>(order[i]);
  Sorter<Places>(places, scratch).sort(0, order.size(), {});
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = index_of(scratch.items[i]);
}

}  // namespace

void order_in_space(std::span<const Vec3> points, std::vector<LocalIndex>& order, SortScratch& scratch) {
  order_by(PointPlaces{points}, order, scratch);
}

void order_in_space(std::span<const geometry::Box> boxes, const geometry::Box& region, std::vector<LocalIndex>& order,
                    SortScratch& scratch) {
  order_by(BoxPlaces{boxes, region}, order, scratch);
}

}  // namespace brunt::contact
