// SPDX-License-Identifier: Apache-2.0
#include "brunt/search.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "comm/native.hpp"
#include "contact/lists/ghosting.hpp"
#include "contact/search/methods.hpp"

namespace brunt::api {
namespace {

contact::SearchMethod method_of(SearchMethod method) {
  switch (method) {
    case SearchMethod::binary:
      return contact::SearchMethod::binary;
    case SearchMethod::bucket:
      return contact::SearchMethod::bucket;
    case SearchMethod::blocks:
      break;
  }
  return contact::SearchMethod::blocks;
}

/// A box and its number over all ranks.
struct NumberedBox {
  GlobalIndex number = 0;
  contact::PlainBox capture;
  friend bool operator<(const NumberedBox& a, const NumberedBox& b) { return a.number < b.number; }
};

std::vector<NumberedBox> numbered(const comm::Communicator& ranks, std::span<const double> boxes) {
  std::vector<NumberedBox> all(boxes.size() / 6);
  const GlobalIndex first = ranks.sum_before(static_cast<GlobalIndex>(all.size()));
  for (std::size_t k = 0; k < all.size(); ++k) {
    const double* const sides = &boxes[6 * k];
    all[k] = {first + static_cast<GlobalIndex>(k), contact::PlainBox({Vec3(sides), Vec3(sides + 3)})};
  }
  return all;
}

}  // namespace

PointsInBoxes find_points_in_boxes(MPI_Comm on, std::span<const double> points, std::span<const double> boxes,
                                   SearchMethod method) {
  const comm::Communicator ranks = comm::NativeAccess::on(on);
  if (ranks.any(points.size() % 3 != 0 || boxes.size() % 6 != 0))
    throw std::invalid_argument("points have three coordinates each, boxes six");
  std::vector<Vec3> places;
  std::vector<geometry::Box> wanted, sides;
  for (std::size_t p = 0; p < points.size(); p += 3) {
    places.emplace_back(&points[p]);
    wanted.push_back({places.back(), places.back()});
  }
  std::vector<NumberedBox> near = numbered(ranks, boxes);
  for (const NumberedBox& box : near) sides.push_back(box.capture.box());
  const std::vector<NumberedBox> others =
      contact::ghost(ranks, std::span<const NumberedBox>(near), wanted, contact::finest_cell(ranks, sides));
  near.insert(near.end(), others.begin(), others.end());
  std::sort(near.begin(), near.end());
  sides.clear();
  for (const NumberedBox& box : near) sides.push_back(box.capture.box());
  contact::MethodScratch scratch;
  Ragged<LocalIndex> pairs;
  contact::find_pairs_by(method_of(method), sides, places, scratch, pairs);
  PointsInBoxes found{.first = {0}, .box = {}};
  for (LocalIndex p = 0; p < pairs.rows(); ++p) {
    for (const LocalIndex box : std::as_const(pairs).row(p)) found.box.push_back(nth(near, box).number);
    found.first.push_back(static_cast<std::int64_t>(found.box.size()));
  }
  return found;
}

}  // namespace brunt::api
