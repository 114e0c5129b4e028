// SPDX-License-Identifier: Apache-2.0
// The largest difference of two tables of equal extent.
#pragma once
#include <string>

#include "io/hdf5.hpp"
#include "io/results/compare.hpp"

namespace brunt::io {

struct LargestDifference {
  double difference = 0;
  double magnitude = 0;  ///< largest finite |a|, |b|
  GlobalIndex row = 0;   ///< the first one with the largest difference
  int component = 0;
};

/// |a - b|: 0 where equal (infinities too), infinite where one is NaN.
double difference_of(double a, double b);

/// Same table `name` of two files. Collective.
LargestDifference largest_difference(const Hdf5File& a, const std::string& name_a, const Hdf5File& b,
                                     const std::string& name_b);

/// Takes a record's result into the field's: keeps the first largest difference, and the largest magnitude.
class FieldTally {
 public:
  explicit FieldTally(std::string field) { result_.field = std::move(field); }
  /// True if this is the largest so far and the caller should name the place.
  bool take(double difference, double magnitude, double time);
  void name_place(std::string where) { result_.where = std::move(where); }
  /// natural_scale: what the field is compared with at least.
  [[nodiscard]] FieldDifference finish(double natural_scale = 0) const;

 private:
  FieldDifference result_;
  double magnitude_ = 0;
};

}  // namespace brunt::io
