// SPDX-License-Identifier: Apache-2.0
// The search of a scene's choice.
#pragma once
#include <span>

#include "contact/data/options.hpp"
#include "contact/search/binary_sort.hpp"
#include "contact/search/bucket_sort.hpp"
#include "contact/search/search.hpp"

namespace brunt::contact {

/// What each method works in, kept from search to search.
struct MethodScratch {
  SearchScratch blocks;
  BinarySort binary;
  BucketSort buckets;
};

/// As find_pairs (search.hpp); the pairs do not depend on the method.
void find_pairs_by(SearchMethod method, std::span<const geometry::Box> boxes, std::span<const Vec3> points,
                   MethodScratch& scratch, Ragged<LocalIndex>& pairs);

}  // namespace brunt::contact
