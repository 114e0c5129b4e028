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
      {depth, "one", 60, 0.0151},     {depth, "one", 102, 0.0275},    {depth, "one", 216, 0.0261},
      {depth, "two", 43, 0.0101},     {depth, "two", 67, 0.0116},     {depth, "two", 97, 0.0203},
      {depth, "two", 114, 0.0104},    {depth, "two", 216, 0.0251},    {depth, "auto", 43, 0.0101},
      {depth, "auto", 67, 0.0116},    {depth, "auto", 97, 0.018},     {depth, "auto", 100, 0.0511},
      {depth, "auto", 114, 0.0104},   {depth, "auto", 184, 0.035},    {depth, "auto", 198, 0.0112},
      {depth, "auto", 216, 0.0251},   {depth, "auto", 241, 0.0103},   {reports, "one", 41, 0.105},
      {reports, "one", 60, 0.105},    {reports, "one", 82, 0.0471},   {reports, "one", 102, 0.0519},
      {reports, "one", 132, 0.0427},  {reports, "one", 138, 0.0265},  {reports, "one", 169, 0.141},
      {reports, "one", 223, 0.28},    {reports, "two", 97, 0.0305},   {reports, "two", 165, 0.0205},
      {reports, "auto", 97, 0.0309},  {reports, "auto", 165, 0.0205}, {energy, "one", 41, 0.00223},
      {energy, "one", 70, 0.00385},   {energy, "one", 130, 0.00216},  {energy, "one", 137, 0.00142},
      {energy, "one", 165, 0.0021},   {energy, "one", 179, 0.00107},  {energy, "one", 181, 0.00186},
      {energy, "one", 281, 0.00117},  {energy, "two", 31, 0.00111},   {energy, "two", 70, 0.00385},
      {energy, "two", 130, 0.00216},  {energy, "two", 137, 0.00143},  {energy, "two", 165, 0.00134},
      {energy, "two", 181, 0.00188},  {energy, "auto", 31, 0.00111},  {energy, "auto", 70, 0.00385},
      {energy, "auto", 130, 0.00216}, {energy, "auto", 137, 0.00143}, {energy, "auto", 165, 0.00134},
      {energy, "auto", 181, 0.00188},
  });
  return missed;
}

bool is_missed(Criterion criterion, const std::string& passes, unsigned seed) {
  return std::ranges::any_of(missed_impacts(), [&](const MissedImpact& missed) {
    return missed.criterion == criterion && missed.passes == passes && missed.seed == seed;
  });
}

}  // namespace brunt::test
