// SPDX-License-Identifier: Apache-2.0
// Random impacts that miss a criterion today, with our figures: tests/hard leaves them out, tests/regression holds
// them.
#include <algorithm>
#include <array>

#include "support/impacts.hpp"

namespace brunt::test {

double figure_of(const ImpactFigures& figures, Criterion criterion) {
  if (criterion == Criterion::depth) return std::max(figures.held_middle, figures.not_reported);
  return criterion == Criterion::reports ? figures.not_there : figures.returned;
}

std::span<const MissedImpact> missed_impacts() {
  using enum Criterion;
  static constexpr auto missed = std::to_array<MissedImpact>({
      {depth, "one", 102, 0.0274},    {depth, "one", 132, 0.112},     {depth, "one", 216, 0.0261},
      {depth, "one", 223, 0.0114},    {depth, "two", 67, 0.0143},     {depth, "two", 97, 0.0238},
      {depth, "two", 216, 0.0251},    {depth, "auto", 67, 0.0143},    {depth, "auto", 97, 0.0238},
      {depth, "auto", 100, 0.051},    {depth, "auto", 184, 0.0351},   {depth, "auto", 198, 0.0112},
      {depth, "auto", 216, 0.0251},   {reports, "one", 41, 0.104},    {reports, "one", 82, 0.0471},
      {reports, "one", 102, 0.0519},  {reports, "one", 132, 0.206},   {reports, "one", 138, 0.0265},
      {reports, "one", 169, 0.14},    {reports, "one", 203, 0.0931},  {reports, "one", 223, 0.257},
      {reports, "two", 97, 0.0413},   {reports, "two", 189, 0.02},    {reports, "auto", 97, 0.0412},
      {reports, "auto", 189, 0.02},   {energy, "one", 41, 0.00223},   {energy, "one", 70, 0.00385},
      {energy, "one", 130, 0.00215},  {energy, "one", 132, 0.00197},  {energy, "one", 137, 0.00141},
      {energy, "one", 165, 0.0021},   {energy, "one", 179, 0.00106},  {energy, "one", 181, 0.00185},
      {energy, "one", 281, 0.00118},  {energy, "two", 70, 0.00385},   {energy, "two", 130, 0.00215},
      {energy, "two", 137, 0.00141},  {energy, "two", 165, 0.00142},  {energy, "two", 181, 0.00185},
      {energy, "auto", 70, 0.00385},  {energy, "auto", 130, 0.00215}, {energy, "auto", 137, 0.00141},
      {energy, "auto", 165, 0.00142}, {energy, "auto", 181, 0.00185},
  });
  return missed;
}

bool is_missed(Criterion criterion, const std::string& passes, unsigned seed) {
  return std::ranges::any_of(missed_impacts(), [&](const MissedImpact& missed) {
    return missed.criterion == criterion && missed.passes == passes && missed.seed == seed;
  });
}

}  // namespace brunt::test
