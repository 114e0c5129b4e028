// SPDX-License-Identifier: Apache-2.0
// Random impacts that miss a criterion today, with our figures: tests/hard leaves them out, tests/regression holds
// them. The list is what `hard "random impacts: the list of those that miss a criterion"` prints.
#include <algorithm>
#include <array>

#include "support/impacts.hpp"

namespace brunt::test {

double figure_of(const ImpactFigures& figures, Criterion criterion) {
  switch (criterion) {
    case Criterion::depth:
      return std::max(figures.held_middle, figures.not_reported);
    case Criterion::reports:
      return figures.not_there;
    case Criterion::energy:
      return figures.returned;
    case Criterion::given:
      return figures.given;
    case Criterion::edges:
      return std::max(figures.edges, figures.others);
  }
  return 0;
}

std::span<const MissedImpact> missed_impacts() {
  using enum Criterion;
  static constexpr auto missed = std::to_array<MissedImpact>({
      {depth, "one", 102, 0.02742},    {depth, "one", 132, 0.1122},     {depth, "one", 216, 0.02609},
      {depth, "one", 223, 0.01136},    {depth, "two", 67, 0.0143},      {depth, "two", 216, 0.02514},
      {depth, "auto", 67, 0.0143},     {depth, "auto", 100, 0.05104},   {depth, "auto", 198, 0.01124},
      {depth, "auto", 216, 0.02514},   {reports, "one", 41, 0.1042},    {reports, "one", 82, 0.04705},
      {reports, "one", 102, 0.05191},  {reports, "one", 132, 0.2062},   {reports, "one", 169, 0.1402},
      {reports, "one", 203, 0.09311},  {reports, "one", 223, 0.2566},   {energy, "one", 41, 0.002227},
      {energy, "one", 70, 0.003847},   {energy, "one", 130, 0.002151},  {energy, "one", 132, 0.00197},
      {energy, "one", 137, 0.001414},  {energy, "one", 165, 0.002097},  {energy, "one", 179, 0.001064},
      {energy, "one", 181, 0.001854},  {energy, "one", 281, 0.001179},  {energy, "two", 70, 0.003847},
      {energy, "two", 130, 0.002151},  {energy, "two", 137, 0.001411},  {energy, "two", 165, 0.001416},
      {energy, "two", 181, 0.001851},  {energy, "auto", 70, 0.003847},  {energy, "auto", 130, 0.002151},
      {energy, "auto", 137, 0.001411}, {energy, "auto", 165, 0.001416}, {energy, "auto", 181, 0.001851},
      {given, "one", 70, 0.0001334},   {given, "two", 70, 0.0001334},   {given, "auto", 70, 0.0001334},
      {edges, "two", 43, 0.05773},     {edges, "two", 59, 0.05528},     {edges, "two", 70, 0.09831},
      {edges, "two", 87, 0.1059},      {edges, "two", 92, 0.09084},     {edges, "two", 97, 0.08812},
      {edges, "two", 128, 0.1434},     {edges, "two", 130, 0.08305},    {edges, "two", 189, 0.2491},
      {edges, "two", 230, 0.1188},     {edges, "two", 238, 0.05789},    {edges, "two", 249, 0.05302},
      {edges, "auto", 43, 0.05773},    {edges, "auto", 59, 0.05528},    {edges, "auto", 70, 0.09831},
      {edges, "auto", 87, 0.1059},     {edges, "auto", 92, 0.09084},    {edges, "auto", 97, 0.08811},
      {edges, "auto", 128, 0.1434},    {edges, "auto", 130, 0.08305},   {edges, "auto", 189, 0.2491},
      {edges, "auto", 230, 0.1188},    {edges, "auto", 238, 0.05789},   {edges, "auto", 249, 0.05302},
  });
  return missed;
}

bool is_missed(Criterion criterion, const std::string& passes, unsigned seed) {
  return std::ranges::any_of(missed_impacts(), [&](const MissedImpact& missed) {
    return missed.criterion == criterion && missed.passes == passes && missed.seed == seed;
  });
}

}  // namespace brunt::test
