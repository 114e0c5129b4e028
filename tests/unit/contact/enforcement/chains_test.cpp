// SPDX-License-Identifier: Apache-2.0
// Factors of compliance in chains of bodies, against every side found by brute force.
#include "contact/enforcement/chains.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

using namespace brunt;
using namespace brunt::contact;

namespace {

using Pairs = std::vector<std::pair<int, int>>;  ///< a body twice: with the ground

struct Side {
  double least = std::numeric_limits<double>::infinity();
  bool free = true;
  std::vector<char> has;
};

/// What is connected with a body when a pair is taken away.
Side side_of(int body, std::size_t without, const Pairs& pairs, const std::vector<double>& answer) {
  Side side{.has = std::vector<char>(answer.size(), 0)};
  side.has[static_cast<std::size_t>(body)] = 1;
  for (std::size_t round = 0; round < answer.size(); ++round)
    for (std::size_t e = 0; e < pairs.size(); ++e) {
      if (e == without) continue;
      const auto a = static_cast<std::size_t>(pairs[e].first), b = static_cast<std::size_t>(pairs[e].second);
      if (side.has[a] != 0 || side.has[b] != 0) side.has[a] = side.has[b] = 1;
    }
  for (std::size_t b = 0; b < answer.size(); ++b)
    if (side.has[b] != 0) side.least = std::min(side.least, answer[b]);
  for (std::size_t e = 0; e < pairs.size(); ++e)
    if (e != without && pairs[e].first == pairs[e].second && side.has[static_cast<std::size_t>(pairs[e].first)] != 0)
      side.free = false;
  return side;
}

/// Before chain_share and the bound.
double sides_of(std::size_t e, const Pairs& pairs, const std::vector<double>& answer) {
  const auto [a, b] = pairs[e];
  const double of_a = answer[static_cast<std::size_t>(a)], of_b = answer[static_cast<std::size_t>(b)];
  const Side one = side_of(a, e, pairs, answer), other = side_of(b, e, pairs, answer);
  if (a == b) return one.least / of_a;
  const double both = of_a + of_b;
  if (one.has[static_cast<std::size_t>(b)] != 0) return 2 * one.least / both;  // no bridge
  if (one.free && other.free) return (one.least + other.least) / both;
  if (one.free) return 2 * one.least / both;
  if (other.free) return 2 * other.least / both;
  return 2 * std::min(one.least, other.least) / both;
}

double factor_of(std::size_t e, const Pairs& pairs, const std::vector<double>& answer) {
  return std::min(1.0, chain_share * sides_of(e, pairs, answer));
}

ChainScratch chains_of(const Pairs& pairs, const std::vector<double>& answer) {
  ChainScratch chains;
  const auto bodies = static_cast<double>(answer.size());
  for (const auto& [a, b] : pairs) chains.own_pairs.push_back(std::min(a, b) * bodies + std::max(a, b));
  chains.answer = answer;
  chains.renewed = true;
  OneRankExchange exchange;
  find_chains(answer.size(), exchange, chains);
  return chains;
}

void compare_random_graphs(unsigned variants) {
  for (unsigned seed = 1; seed <= variants; ++seed) {
    std::mt19937 random(seed);
    const int bodies = 1 + static_cast<int>(random() % 12);
    Pairs pairs;
    for (int a = 0; a < bodies; ++a)
      for (int b = a; b < bodies; ++b)
        if (random() % 100 < (a == b ? 25 : 200 / static_cast<unsigned>(bodies))) pairs.emplace_back(a, b);
    std::vector<double> answer(static_cast<std::size_t>(bodies), 0.0);
    for (const auto& [a, b] : pairs)
      for (const int body : {a, b})
        answer[static_cast<std::size_t>(body)] = std::pow(10.0, static_cast<double>(random() % 1000) / 250 - 2);
    const ChainScratch chains = chains_of(pairs, answer);
    CAPTURE(seed, bodies, pairs.size());
    REQUIRE(chains.pairs.size() == pairs.size());
    for (std::size_t e = 0; e < pairs.size(); ++e) {
      CHECK(chains.factor[e] == Approx(factor_of(e, pairs, answer)));
      CHECK(chains.factor[e] <= 1 + 1e-12);
      CHECK(chains.chain[static_cast<std::size_t>(pairs[e].first)] ==
            chains.chain[static_cast<std::size_t>(pairs[e].second)]);
    }
  }
}

}  // namespace

TEST_CASE("chains: a light body between heavy ones, and on top of one") {
  constexpr double light = 1, heavy = 1e-4;
  // ram (0) on pin (1) on the ground
  const ChainScratch squeezed = chains_of({{0, 1}, {1, 1}}, {heavy, light});
  CHECK(squeezed.factor[0] == Approx(chain_share * 2 * heavy / (heavy + light)));
  CHECK(squeezed.factor[1] == Approx(chain_share * heavy / light));
  // pin (1) on ram (0) on the ground: pairs (0, 0), (0, 1)
  const ChainScratch on_top = chains_of({{0, 0}, {0, 1}}, {heavy, light});
  CHECK(on_top.factor[0] == 1);
  CHECK(on_top.factor[1] == 1);
  // two pins carry a ram
  const ChainScratch table = chains_of({{0, 1}, {0, 2}, {1, 1}, {2, 2}}, {heavy, light, light});
  for (const std::size_t e : {0u, 1u}) CHECK(table.factor[e] == Approx(chain_share * 2 * heavy / (heavy + light)));
}

TEST_CASE("chains: equal bodies have the factor 1") {
  for (const double factor : chains_of({{0, 0}, {0, 1}, {1, 2}, {1, 3}, {2, 3}, {3, 3}}, {2, 2, 2, 2}).factor)
    CHECK(factor == 1);
}

TEST_CASE("chains: factors of random graphs are those of their sides") {
  compare_random_graphs(60);
}

TEST_CASE("the same for three thousand graphs", "[.][long]") {
  compare_random_graphs(3000);
}
