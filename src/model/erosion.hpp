// SPDX-License-Identifier: Apache-2.0
// Criteria by which elements of a part are removed.
#pragma once
#include <optional>

namespace brunt::model {

/// An element is removed as soon as one criterion is met; criteria without a value are not evaluated.
struct Erosion {
  /// For elements with several integration points: whether the first point that meets a criterion removes the element,
  /// or the mean of the points.
  enum class Points { any, mean } points = Points::any;
  bool keeps_nodes = true;               ///< nodes without an element remain as mass points; otherwise they are dropped
  std::optional<double> damage;          ///< at least
  std::optional<double> plastic_strain;  ///< at least
  std::optional<double> pressure;        ///< [stress] > 0: at least; < 0, tension: at most
  std::optional<double> volume;          ///< over that of the reference: at most
  std::optional<double> step;            ///< [time] the element's own stable step: below

  /// Folded elements, and elements with values that are not finite, are also removed and do not stop the run.
  [[nodiscard]] bool takes_collapsed() const { return volume.has_value() || step.has_value(); }
};

}  // namespace brunt::model
