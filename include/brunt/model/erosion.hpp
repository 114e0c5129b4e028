// SPDX-License-Identifier: Apache-2.0
// When elements of a part are deleted by what has become of them.
#pragma once
#include <optional>

namespace brunt::model {

/// The first criterion that is met decides; what is not set is not asked.
struct Erosion {
  /// Of elements with several integration points: the first point that meets a criterion deletes the element, or the
  /// mean of the points.
  enum class Points { any, mean } points = Points::any;
  bool keeps_nodes = true;               ///< nodes without an element stay as mass points, else they are dropped
  std::optional<double> damage;          ///< at least
  std::optional<double> plastic_strain;  ///< at least
  std::optional<double> pressure;        ///< [stress] > 0: at least; < 0, tension: at most
  std::optional<double> volume;          ///< over that of the reference: at most
  std::optional<double> step;            ///< [time] the element's own stable step: below

  /// An element that has folded, or is no number, is deleted too, and does not stop the run.
  [[nodiscard]] bool takes_collapsed() const { return volume.has_value() || step.has_value(); }
};

}  // namespace brunt::model
