// SPDX-License-Identifier: Apache-2.0
// Probes: values at nodes, sets, walls and contacts as columns of history.csv.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/state/prepared.hpp"
#include "contact/contact.hpp"
#include "io/results/history.hpp"
#include "part_sums.hpp"
#include "scene/text/units.hpp"
#include "sections.hpp"

namespace brunt::app {

class Probes {
 public:
  Probes(const Prepared& run, const scene::UnitSystem& units);

  [[nodiscard]] const std::vector<io::HistoryColumn>& columns() const { return columns_; }

  /// Reads the values at t_n (motion of nodes and sets), before the step advances. Collective.
  void read_motion(const Prepared& run);
  /// Reads impulses up to t_{n+1/2}, after the step, and returns all values in the order of the columns: forces are
  /// means since the last row, with the impulse beside them. Collective.
  /// dt_mean: of that step, which energies of parts need.
  std::vector<double> values(Prepared& run, const contact::ContactTotals& totals, double dt_mean = 0);

 private:
  void add_columns(const scene::Probe& probe, const scene::UnitSystem& units);
  /// Mean force since the last row, and the impulse beside it; of contact its parts along and across the normals too.
  void add_force(Prepared& run, const contact::ContactTotals& totals, std::size_t probe,
                 std::vector<double>& row) const;

  std::vector<io::HistoryColumn> columns_;
  // of each probe, where it has them:
  std::vector<Vec3> motion_, moment_;
  std::vector<PartNodes> part_;
  std::vector<Section> section_;
  std::vector<std::optional<std::size_t>> body_;  ///< of a rigid part
  bool keeps_velocity_ = false;
  std::vector<Vec3> before_;  ///< v_{n-1/2} of all nodes, where a probe asks for energies
};

}  // namespace brunt::app
