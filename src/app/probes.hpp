// SPDX-License-Identifier: Apache-2.0
// The values that the user watches at nodes, sets, walls and contacts: columns of history.csv.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "brunt/contact/contact.hpp"
#include "brunt/io/history.hpp"
#include "brunt/scene/units.hpp"
#include "prepare.hpp"

namespace brunt::app {

class Probes {
 public:
  Probes(const Prepared& run, const scene::UnitSystem& units);

  [[nodiscard]] const std::vector<io::HistoryColumn>& columns() const { return columns_; }

  /// Reads what belongs to t_n (motion of nodes and sets), before the step moves on. Collective.
  void read_motion(const Prepared& run);
  /// Reads impulses up to t_{n+1/2}, after the step, and returns all values in the order of the columns: forces are
  /// means since the last row, with the impulse beside them. Collective.
  std::vector<double> values(Prepared& run, const contact::ContactTotals& totals);

 private:
  Vec3 impulse(const Prepared& run, const contact::ContactTotals& totals, std::size_t probe) const;

  std::vector<io::HistoryColumn> columns_;
  std::vector<Vec3> motion_;
};

}  // namespace brunt::app
