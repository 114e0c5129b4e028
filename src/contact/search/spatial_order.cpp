// SPDX-License-Identifier: Apache-2.0
// Morton order by radix sort, repeated within crowded cells.
#include "brunt/contact/search/spatial_order.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace brunt::contact {
namespace {

using Item = std::uint64_t;

constexpr int axis_bits = 10, digit_bits = 10, digit_count = 3;  // a key has 30 bits: three digits
constexpr std::size_t digit_values = std::size_t{1} << digit_bits;
constexpr std::size_t crowd = 16;        // so many may share a cell in any order
constexpr std::size_t comparison = 400;  // below, sorting by comparison is quicker than clearing histograms

std::uint32_t key_of(Item item) {
  return static_cast<std::uint32_t>(item >> 32);
}
LocalIndex index_of(Item item) {
  return static_cast<LocalIndex>(item & 0xFFFFFFFFU);
}

/// abc... -> a00b00c00...
std::uint32_t spread(std::uint32_t bits) {
  bits = (bits | bits << 16) & 0x030000FFU;
  bits = (bits | bits << 8) & 0x0300F00FU;
  bits = (bits | bits << 4) & 0x030C30C3U;
  return (bits | bits << 2) & 0x09249249U;
}

struct PointPlaces {
  std::span<const Vec3> points;
  [[nodiscard]] Vec3 operator()(LocalIndex i) const { return points[static_cast<std::size_t>(i)]; }
};

struct BoxPlaces {
  std::span<const geometry::Box> boxes;
  const geometry::Box& region;
  [[nodiscard]] Vec3 operator()(LocalIndex i) const {
    const geometry::Box& box = boxes[static_cast<std::size_t>(i)];
    return 0.5 * box.low.cwiseMax(region.low) + 0.5 * box.high.cwiseMin(region.high);
  }
};

/// Cubic cells, 1024 along the longest axis. A flat set keeps its two dimensions: noise across it is no dimension.
struct Cells {
  Vec3 low;
  double per_length = 0;

  [[nodiscard]] std::uint32_t key(const Vec3& x) const {
    std::uint32_t key = 0;
    for (int a = 0; a < 3; ++a) {
      constexpr double last = (1 << axis_bits) - 1;
      const double cell = std::max(0.0, std::min(last, (x[a] - low[a]) * per_length));  // a NaN ends in the last cell
      key |= spread(static_cast<std::uint32_t>(cell)) << a;
    }
    return key;
  }
};

template <class Places>
class Sorter {
 public:
  Sorter(const Places& places, SortScratch& scratch) : place_(places), scratch_(scratch) {}

  /// Items hold indices on entry; on return they stand in order.
  void sort(std::size_t first, std::size_t last) {
    const std::span<Item> items(scratch_.items.data() + first, last - first);
    if (!set_keys(items)) return;
    if (items.size() < comparison) {
      std::sort(items.begin(), items.end());
    } else {
      radix_sort(items, {scratch_.other.data() + first, last - first});
    }
    for (std::size_t run = first; run < last;) {
      std::size_t end = run + 1;
      while (end < last && key_of(scratch_.items[end]) == key_of(scratch_.items[run])) ++end;
      if (end - run > crowd) sort(run, end);
      run = end;
    }
  }

 private:
  /// False if all keys are equal: nothing is left to sort.
  bool set_keys(std::span<Item> items) {
    geometry::Box around;
    for (const Item item : items) {
      const Vec3 x = place_(index_of(item));
      around.low = around.low.cwiseMin(x);
      around.high = around.high.cwiseMax(x);
    }
    const double extent = (around.high - around.low).maxCoeff();
    if (!(extent > 0)) return false;
    const Cells cells{around.low, (1 << axis_bits) / extent};
    std::uint32_t any = 0, all = ~std::uint32_t{0};
    for (Item& item : items) {
      const std::uint32_t key = cells.key(place_(index_of(item)));
      any |= key;
      all &= key;
      item = Item{key} << 32 | (item & 0xFFFFFFFFU);
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
      for (const Item item : from) to[static_cast<std::size_t>(next[digit(item, d)]++)] = item;
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
  Sorter<Places>(places, scratch).sort(0, order.size());
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
