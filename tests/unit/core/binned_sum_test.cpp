// SPDX-License-Identifier: Apache-2.0
// Binned sums: the same bits in any order and in any parts, as accurate as adding in extended precision.
#include "core/binned_sum.hpp"

#include <catch2/catch.hpp>
#include <numeric>
#include <random>
#include <vector>

using namespace brunt;

namespace {

std::vector<double> random_terms(std::mt19937& random, std::size_t count, int decades) {
  std::uniform_real_distribution<double> mantissa(-1, 1), exponent(-decades, 0);
  std::vector<double> terms(count);
  for (double& term : terms) term = mantissa(random) * std::pow(10.0, exponent(random));
  return terms;
}

double largest(const std::vector<double>& terms) {
  double bound = 0;
  for (const double term : terms) bound = std::max(bound, std::abs(term));
  return bound;
}

double binned(const std::vector<double>& terms, double bound, std::size_t parts) {
  const BinGrid grid = BinGrid::for_bound(bound);
  std::vector<double> slices(2 * parts, 0.0);
  for (std::size_t i = 0; i < terms.size(); ++i) binned_add(grid, terms[i], &slices[2 * (i % parts)]);
  double total[2] = {0, 0};
  for (std::size_t part = 0; part < parts; ++part) {
    total[0] += slices[2 * part];
    total[1] += slices[2 * part + 1];
  }
  return binned_value(total);
}

}  // namespace

TEST_CASE("the order and the parts of a binned sum change no bit, and little is lost") {
  std::mt19937 random(5);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> terms = random_terms(random, 1 + static_cast<std::size_t>(trial) * 7, trial % 12);
    const double bound = largest(terms), sum = binned(terms, bound, 1);
    long double reference = 0;
    for (const double term : terms) reference += static_cast<long double>(term);
    const auto count = static_cast<double>(terms.size());
    CHECK(std::abs(static_cast<double>(sum - reference)) <=
          std::abs(sum) * 0x1p-52 + bound * count * (0x1p-62 + 0x1p-70));  // 2^-62: the reference's own rounding
    for (const std::size_t parts : {2, 3, 7}) {
      std::shuffle(terms.begin(), terms.end(), random);
      CHECK(binned(terms, bound, parts) == sum);
    }
  }
}

TEST_CASE("the longest allowed sum of equal and of opposite terms is exact") {
  const double term = 1 - 0x1p-53;
  const BinGrid grid = BinGrid::for_bound(1.0);
  double same[2] = {0, 0}, opposite[2] = {0, 0};
  for (int i = 0; i < (1 << binned_terms_log2); ++i) {
    binned_add(grid, term, same);
    binned_add(grid, i % 2 == 0 ? term : -term, opposite);
  }
  CHECK(binned_value(same) == binned_terms * term);
  CHECK(opposite[0] == 0.0);
  CHECK(opposite[1] == 0.0);
}

TEST_CASE("a bound of zero and tiny or huge bounds are harmless") {
  for (const double bound : {0.0, 1e-280, 1e250}) {
    const BinGrid grid = BinGrid::for_bound(bound);
    double slices[2] = {0, 0};
    binned_add(grid, bound, slices);
    binned_add(grid, bound, slices);
    CHECK(binned_value(slices) == Approx(2 * bound).epsilon(1e-12));
  }
}
