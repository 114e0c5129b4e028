// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "contact/mortar/interface.hpp"
#include "contact/mortar/normals.hpp"
#include "facet_rows.hpp"

namespace brunt::contact {

/// A contribution to an entry of a sparse matrix.
template <class Block>
struct Entry {
  LocalIndex row, node;
  Block block;
};

struct MortarScratch {
  FacetRows facet;
  FacetCoverage coverage;
  std::vector<Entry<double>> weights;
  std::vector<Entry<Mat3>> gaps, of_fixed;
  std::vector<Entry<Vec3>> covered;
  std::vector<Mat3> gap_slopes, fixed_slopes;
  std::vector<double> transposed;  ///< a patch, to be added transposed
  std::vector<LocalIndex> first_of_row, next_of_row, order;
  std::vector<LocalIndex> place_of_node;  ///< of the entry of a node in the current row
};

}  // namespace brunt::contact
