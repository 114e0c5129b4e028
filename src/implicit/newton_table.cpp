// SPDX-License-Identifier: Apache-2.0
#include "implicit/newton_table.hpp"

#include <cmath>

namespace brunt::implicit {

std::size_t last_judged(std::span<const double> ratios) {
  for (std::size_t k = ratios.size(); k-- > 1;)
    if (ratios[k] > least_ratio && ratios[k - 1] > least_ratio) return k;
  return 0;
}

double order_of(std::span<const double> ratios) {
  const std::size_t k = last_judged(ratios);
  return k > 0 ? std::log(ratios[k]) / std::log(ratios[k - 1]) : 0.0;
}

void add(NewtonTable& table, NewtonRecord record) {
  if (record.stood && last_judged(record.ratios) > 0) {
    ++table.judged;
    if (order_of(record.ratios) >= quadratic_order) ++table.quadratic;
  }
  table.last.push_back(std::move(record));
  if (table.last.size() > most_records) table.last.pop_front();
}

}  // namespace brunt::implicit
