// SPDX-License-Identifier: Apache-2.0
#include "chains.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/sorted.hpp"

namespace brunt::contact {
namespace {

std::size_t index(LocalIndex i) {
  return static_cast<std::size_t>(i);
}

/// Depth-first traversal of the pairs; places are those in its order. The bodies below one have the places from its own
/// to its end, so that what remains of a chain lies before and behind them.
class Traversal {
 public:
  Traversal(std::size_t bodies, ChainScratch& chains) : bodies_(bodies), chains_(chains) {
    const std::size_t pairs = chains.pairs.size();
    chains.graph.assign(10 * bodies + 2 + 4 * pairs, no_index);
    chains.along.assign(3 * bodies, std::numeric_limits<double>::infinity());
    std::size_t taken = 0;
    const auto take = [&](std::size_t count) {
      taken += count;
      return std::span(chains.graph).subspan(taken - count, count);
    };
    first_ = take(bodies + 1);
    grounds_ = take(bodies + 1);
    next_ = take(bodies);
    place_ = take(bodies);
    low_ = take(bodies);
    end_ = take(bodies);
    order_ = take(bodies);
    above_ = take(bodies);
    by_ = take(bodies);
    stack_ = take(bodies);
    other_ = take(2 * pairs);
    pair_ = take(2 * pairs);
    before_ = std::span(chains.along).first(bodies);
    behind_ = std::span(chains.along).subspan(bodies, bodies);
    below_ = std::span(chains.along).last(bodies);
    list_neighbours();
  }
  void go() {
    chains_.factor.assign(chains_.pairs.size(), 1.0);
    for (std::size_t b = 0; b < bodies_; ++b) {
      if (place_[b] != no_index || !(chains_.answer[b] > 0)) continue;
      const LocalIndex start = count_;
      visit(static_cast<LocalIndex>(b));
      finish_chain(start);
    }
  }

 private:
  [[nodiscard]] std::size_t lower(std::size_t pair) const {
    return static_cast<std::size_t>(chains_.pairs[pair] / static_cast<double>(bodies_));
  }
  [[nodiscard]] std::size_t higher(std::size_t pair) const {
    return static_cast<std::size_t>(chains_.pairs[pair] -
                                    static_cast<double>(lower(pair)) * static_cast<double>(bodies_));
  }
  void list_neighbours() {
    std::ranges::fill(first_, 0);
    for (std::size_t e = 0; e < chains_.pairs.size(); ++e) {
      if (lower(e) == higher(e)) continue;
      ++first_[lower(e) + 1];
      ++first_[higher(e) + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    std::ranges::copy(first_.first(bodies_), next_.begin());
    for (std::size_t e = 0; e < chains_.pairs.size(); ++e) {
      if (lower(e) == higher(e)) continue;
      for (const auto& [from, to] : {std::pair(lower(e), higher(e)), std::pair(higher(e), lower(e))}) {
        const std::size_t k = index(next_[from]++);
        other_[k] = static_cast<LocalIndex>(to);
        pair_[k] = static_cast<LocalIndex>(e);
      }
    }
    std::ranges::copy(first_.first(bodies_), next_.begin());
  }
  void enter(LocalIndex body, std::size_t& depth) {
    const std::size_t b = index(body);
    place_[b] = low_[b] = count_;
    below_[b] = chains_.answer[b];
    order_[index(count_++)] = body;
    stack_[depth++] = body;
  }
  void visit(LocalIndex root) {
    std::size_t depth = 0;
    enter(root, depth);
    while (depth > 0) {
      const std::size_t b = index(stack_[depth - 1]);
      if (next_[b] == first_[b + 1]) {
        --depth;
        leave(b);
        continue;
      }
      const std::size_t k = index(next_[b]++);
      if (pair_[k] == by_[b]) continue;
      const std::size_t to = index(other_[k]);
      if (place_[to] != no_index) {
        low_[b] = std::min(low_[b], place_[to]);
        continue;
      }
      by_[to] = pair_[k];
      above_[to] = static_cast<LocalIndex>(b);
      enter(other_[k], depth);
    }
  }
  void leave(std::size_t b) {
    end_[b] = count_;
    if (above_[b] == no_index) return;
    const std::size_t above = index(above_[b]);
    low_[above] = std::min(low_[above], low_[b]);
    below_[above] = std::min(below_[above], below_[b]);
  }
  void finish_chain(LocalIndex start) {
    const std::size_t from = index(start), to = index(count_);
    for (std::size_t i = from; i < to; ++i) {
      const std::size_t b = index(order_[i]);
      chains_.chain[b] = order_[from];
      before_[i] = std::min(i > from ? before_[i - 1] : chains_.answer[b], chains_.answer[b]);
      grounds_[i + 1] = (i > from ? grounds_[i] : 0) + (is_on_ground(b) ? 1 : 0);
    }
    for (std::size_t i = to; i-- > from;) {
      const double own = chains_.answer[index(order_[i])];
      behind_[i] = std::min(i + 1 < to ? behind_[i + 1] : own, own);
    }
    for (std::size_t i = from; i < to; ++i) give_factors(index(order_[i]), to);
  }
  [[nodiscard]] bool is_on_ground(std::size_t b) const { return ground_of(b) != no_index; }
  [[nodiscard]] LocalIndex ground_of(std::size_t b) const {
    const double key = static_cast<double>(b) * static_cast<double>(bodies_) + static_cast<double>(b);
    const auto found = std::ranges::lower_bound(chains_.pairs, key);
    return found != chains_.pairs.end() && *found == key ? static_cast<LocalIndex>(found - chains_.pairs.begin())
                                                         : no_index;
  }
  /// Of the pairs of body b, whose chain ends before place `to`.
  void give_factors(std::size_t b, std::size_t to) {
    const double least = before_[to - 1], own = chains_.answer[b];
    if (const LocalIndex ground = ground_of(b); ground != no_index)
      chains_.factor[index(ground)] = std::min(1.0, chain_share * least / own);
    for (std::size_t k = index(first_[b]); k < index(first_[b + 1]); ++k) {
      const std::size_t to_body = index(other_[k]);
      const bool is_bridge = by_[to_body] == pair_[k] && low_[to_body] > place_[b];
      if (by_[b] == pair_[k]) continue;  // given from the body above
      const double sides = is_bridge ? sides_of_bridge(to_body, to) : 2 * least;
      chains_.factor[index(pair_[k])] = std::min(1.0, chain_share * sides / (own + chains_.answer[to_body]));
    }
  }
  /// h_1 + h_2, or what stands for it, of the pair that leads down to a body.
  [[nodiscard]] double sides_of_bridge(std::size_t down, std::size_t to) const {
    const std::size_t begin = index(place_[down]), end = index(end_[down]);
    const double inner = below_[down],
                 outer = std::min(before_[begin - 1], end < to ? behind_[end] : before_[begin - 1]);
    const LocalIndex inside = grounds_[end] - grounds_[begin], outside = grounds_[to] - inside;
    if (inside == 0 && outside == 0) return inner + outer;
    if (inside == 0) return 2 * inner;
    if (outside == 0) return 2 * outer;
    return 2 * std::min(inner, outer);
  }

  std::size_t bodies_;
  ChainScratch& chains_;
  LocalIndex count_ = 0;                               ///< of bodies visited
  std::span<LocalIndex> first_, other_, pair_, next_;  ///< neighbours of each body, the pairs that lead to them
  std::span<LocalIndex> place_, low_, end_, order_;    ///< in the order of the traversal
  std::span<LocalIndex> above_, by_, stack_;
  std::span<LocalIndex> grounds_;              ///< bodies on the ground in the chain before a place
  std::span<double> before_, behind_, below_;  ///< least answers: up to a place, from it on; of a body and those below
};

}  // namespace

bool is_between_bodies(const System& system, std::size_t q) {
  const RowMatrix& rows = system.rows;
  if (rows.laws[q].softness == 0 || rows.bodies_of(q).empty()) return false;
  for (std::size_t k = rows.begin(q); k < rows.end(q); ++k)
    if (system.mobility[rows.point(k)].inverse_mass > 0) return false;
  return true;
}

double pair_of(const System& system, std::size_t q) {
  const auto bodies = static_cast<double>(system.carriers.bodies.size());
  double lower = -1, higher = -1;
  for (const BodyShare& share : system.rows.bodies_of(q)) {
    if (share.along == 0) continue;
    const auto body = static_cast<double>(share.body);
    lower = lower < 0 ? body : std::min(lower, body);
    higher = std::max(higher, body);
  }
  return lower < 0 ? -1 : lower * bodies + higher;
}

void note_pairs(const System& system, ChainScratch& chains) {
  chains.own_pairs.clear();
  chains.answer.assign(system.carriers.bodies.size(), 0.0);
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    if (!is_between_bodies(system, q)) continue;
    const double pair = pair_of(system, q);
    if (pair < 0) continue;
    if (chains.own_pairs.empty() || chains.own_pairs.back() != pair) chains.own_pairs.push_back(pair);
    for (const BodyShare& share : system.rows.bodies_of(q))
      keep_max(nth(chains.answer, share.body), share.along * share.along);
  }
  sort_unique(chains.own_pairs);
  chains.renewed = chains.own_pairs != chains.last_own_pairs;
}

void find_chains(std::size_t bodies, Exchange& exchange, ChainScratch& chains) {
  if (chains.renewed) {
    chains.pairs = chains.own_pairs;
    exchange.unite(chains.pairs);
    chains.last_own_pairs = chains.own_pairs;
    chains.renewed = false;
  }
  chains.chain.assign(bodies, no_index);
  Traversal(bodies, chains).go();
}

void ChainScratch::reserve(std::size_t rows, std::size_t bodies) {
  for (std::vector<double>* of_pairs : {&own_pairs, &last_own_pairs, &pairs, &factor}) of_pairs->reserve(rows);
  answer.reserve(bodies);
  kept.reserve(2 * bodies);
  bounds.reserve(3 * bodies);
  chain.reserve(bodies);
  sums.reserve(2 * bodies);
  graph.reserve(10 * bodies + 2 + 4 * rows);
  along.reserve(3 * bodies);
}

}  // namespace brunt::contact
