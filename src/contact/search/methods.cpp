// SPDX-License-Identifier: Apache-2.0
#include "contact/search/methods.hpp"

namespace brunt::contact {

void find_pairs_by(SearchMethod method, std::span<const geometry::Box> boxes, std::span<const Vec3> points,
                   MethodScratch& scratch, Ragged<LocalIndex>& pairs) {
  switch (method) {
    case SearchMethod::binary:
      sort_along_axes(points, scratch.binary);
      return find_pairs_by_bisection(scratch.binary, boxes, points, pairs);
    case SearchMethod::bucket:
      sort_into_buckets(points, bucket_grid(points, boxes, most_buckets(points.size())), scratch.buckets);
      return find_pairs_in_buckets(scratch.buckets, boxes, points, pairs);
    case SearchMethod::automatic:
    case SearchMethod::blocks:
      return find_pairs(boxes, points, scratch.blocks, pairs);
  }
}

}  // namespace brunt::contact
