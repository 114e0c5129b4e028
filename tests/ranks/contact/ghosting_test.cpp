// SPDX-License-Identifier: Apache-2.0
// The sparse grid between ranks: every box that a rank could need arrives, none that shares no cell with its wishes.
#include "contact/lists/ghosting.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace brunt;
using geometry::Box;

namespace {

struct Scene {
  std::vector<Box> offered, wanted;
  std::vector<Rank> offered_on, wanted_on;
};

enum class Deal { by_turns, apart, first_rank_empty };

/// Extents from `smallest` to a thousand times that, some far outliers, wishes that are points or boxes.
Scene scene_of(unsigned seed, const comm::Communicator& ranks, Deal deal, bool points) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto vector = [&](double scale) {
    return Vec3(scale * unit(random), scale * unit(random), scale * unit(random));
  };
  const auto place = [&](std::size_t i) { return i % 97 == 0 ? Vec3(vector(1e9)) : Vec3(vector(10.0)); };
  const Rank count = ranks.size();
  const auto rank_of = [&](std::size_t i, bool offers) {
    if (deal == Deal::apart) return offers ? count - 1 : 0;
    const Rank first = deal == Deal::first_rank_empty && count > 1 ? 1 : 0;
    return static_cast<Rank>(first + static_cast<Rank>(i * 7 % 31) % (count - first));
  };
  Scene scene;
  for (std::size_t i = 0; i < 400; ++i) {
    const Vec3 low = place(i);
    scene.offered.push_back({low, low + vector(1e-3 * std::pow(10.0, 3 * unit(random)))});
    scene.offered_on.push_back(rank_of(i, true));
    const Vec3 start = place(i);
    scene.wanted.push_back({start, points ? start : Vec3(start + vector(unit(random)))});
    if (i % 5 == 0) scene.wanted.back() = {scene.offered.back().high, scene.offered.back().high};  // touch in a corner
    scene.wanted_on.push_back(rank_of(i, false));
  }
  return scene;
}

template <class T>
std::vector<T> of_rank(const std::vector<T>& all, const std::vector<Rank>& on, Rank rank) {
  std::vector<T> own;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (on[i] == rank) own.push_back(all[i]);
  return own;
}

/// Two boxes that share a cell are nearer than its edge, at most twice the larger one's extent.
bool may_share_a_cell(const Box& a, const Box& b, double finest) {
  const double extent = std::max((a.high - a.low).maxCoeff(), (b.high - b.low).maxCoeff());
  return geometry::overlaps(geometry::grown(a, std::max(finest, 2 * extent)), b);
}

}  // namespace

TEST_CASE("what may touch meets in a cell, on any deal of boxes and wishes to ranks; little else does") {
  const auto ranks = comm::Communicator::world();
  constexpr double finest = 2e-3;
  for (unsigned seed = 0; seed < 12; ++seed)
    for (const Deal deal : {Deal::by_turns, Deal::apart, Deal::first_rank_empty}) {
      const Scene scene = scene_of(seed, ranks, deal, seed % 2 == 0);
      const std::vector<Box> own = of_rank(scene.offered, scene.offered_on, ranks.rank());
      const auto leaving =
          contact::meet_in_cells(ranks, own, of_rank(scene.wanted, scene.wanted_on, ranks.rank()), finest);
      REQUIRE(leaving.size() == static_cast<std::size_t>(ranks.size()));
      CHECK(leaving[static_cast<std::size_t>(ranks.rank())].empty());
      int missing = 0, needless = 0;
      for (Rank r = 0; r < ranks.size(); ++r) {
        if (r == ranks.rank()) continue;
        const std::vector<Box> wanted = of_rank(scene.wanted, scene.wanted_on, r);
        const std::vector<LocalIndex>& sent = leaving[static_cast<std::size_t>(r)];
        for (std::size_t b = 0; b < own.size(); ++b) {
          const bool is_sent = std::binary_search(sent.begin(), sent.end(), static_cast<LocalIndex>(b));
          const auto touches = [&](const Box& wish) { return geometry::overlaps(own[b], wish); };
          const auto near = [&](const Box& wish) { return may_share_a_cell(own[b], wish, finest); };
          if (!is_sent && std::ranges::any_of(wanted, touches)) ++missing;
          if (is_sent && std::ranges::none_of(wanted, near)) ++needless;
        }
      }
      CHECK(missing == 0);
      CHECK(needless == 0);
    }
}

TEST_CASE("a box without end reaches every rank, one that is no number none") {
  const auto ranks = comm::Communicator::world();
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<Box> offered;
  if (ranks.is_root())
    offered = {{Vec3::Constant(-infinity), Vec3::Constant(infinity)}, {Vec3::Constant(std::nan("")), Vec3::Zero()}};
  const std::vector<Box> wanted{{Vec3::Zero(), Vec3::Zero()}};
  const auto leaving = contact::meet_in_cells(ranks, offered, wanted, 1.0);
  for (Rank r = 0; r < ranks.size(); ++r) {
    const bool expected = ranks.is_root() && r != 0;
    CHECK(leaving[static_cast<std::size_t>(r)] == (expected ? std::vector<LocalIndex>{0} : std::vector<LocalIndex>{}));
  }
}
