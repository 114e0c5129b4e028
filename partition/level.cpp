// SPDX-License-Identifier: Apache-2.0
#include "partition/level.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>
#include <queue>
#include <tuple>
#include <vector>

namespace brunt::partition {

namespace {

/// Gain of a move: the number of faces that it joins minus the number that it cuts.
struct Move {
  int gain = 0;
  LocalIndex element = 0;
  Rank to = 0;
  friend bool operator<(const Move& a, const Move& b) {  // the best is on top
    return std::tie(a.gain, b.element, b.to) < std::tie(b.gain, a.element, a.to);
  }
};

class Levelling {
 public:
  Levelling(const Ragged<LocalIndex>& graph, const Weights& weights, int parts, std::span<Rank> part)
      : graph_(graph), weights_(weights), part_(part), members_(static_cast<std::size_t>(parts)) {
    cost_.assign(members_.size(), 0.0);
    faces_.assign(members_.size(), 0);
    for (std::size_t e = 0; e < part.size(); ++e) {
      const auto p = static_cast<std::size_t>(part[e]);
      members_[p].push_back(static_cast<LocalIndex>(e));
      cost_[p] += weights.cost[e];
      faces_[p] += weights.contact_faces[e];
    }
    mean_cost_ = std::accumulate(cost_.begin(), cost_.end(), 0.0) / parts;
    constexpr double uneven_faces = 1.02;  // of the mean: the work of contact is a small part of a step
    const double mean_faces = std::accumulate(faces_.begin(), faces_.end(), 0.0) / parts;
    most_faces_ = std::max(*std::ranges::max_element(faces_), static_cast<GlobalIndex>(uneven_faces * mean_faces));
  }

  /// Parts that cost more than `load` times the mean, in descending order of cost.
  [[nodiscard]] std::vector<Rank> above(double load) const;
  /// Moves elements of `from` to its neighbours until its cost is the mean. Returns whether any was moved.
  bool relieve(Rank from);
  /// Each element at a border may move once, in descending order of gain, even if this cuts more faces; moves after the
  /// smallest cut are undone. No part exceeds `load` times the mean. Returns whether fewer faces are cut than before.
  bool smooth(double load);

 private:
  /// To the part where it joins most faces, among those that remain lighter than its own part after the move.
  [[nodiscard]] std::optional<Move> best_move(LocalIndex element, double most_cost = 0) const;
  /// Whether the part remains lighter than the element's own part after the move, or than most_cost.
  [[nodiscard]] bool admits(Rank to, LocalIndex element, double most_cost) const;
  void carry_out(const Move& move);

  const Ragged<LocalIndex>& graph_;
  const Weights& weights_;
  std::span<Rank> part_;
  std::vector<std::vector<LocalIndex>> members_;  ///< of each part; also elements that have left it since
  std::vector<double> cost_;
  std::vector<GlobalIndex> faces_;
  double mean_cost_ = 0;
  GlobalIndex most_faces_ = 0;
};

std::vector<Rank> Levelling::above(double load) const {
  std::vector<Rank> found;
  const auto cost = [&](Rank p) { return nth(cost_, p); };
  for (Rank p = 0; p < static_cast<Rank>(cost_.size()); ++p)
    if (cost(p) > load * mean_cost_) found.push_back(p);
  std::ranges::stable_sort(found, std::greater{}, cost);
  return found;
}

bool Levelling::admits(Rank to, LocalIndex element, double most_cost) const {
  const auto e = static_cast<std::size_t>(element), there = static_cast<std::size_t>(to);
  return cost_[there] + weights_.cost[e] < std::max(nth(cost_, part_[e]), most_cost) &&
         faces_[there] + weights_.contact_faces[e] <= most_faces_;
}

std::optional<Move> Levelling::best_move(LocalIndex element, double most_cost) const {
  const Rank own = nth(part_, element);
  const std::span<const LocalIndex> neighbours = graph_.row(element);
  const auto joined = [&](Rank p) {
    return static_cast<int>(std::ranges::count_if(neighbours, [&](LocalIndex n) { return nth(part_, n) == p; }));
  };
  std::optional<Move> best;
  for (const LocalIndex n : neighbours) {
    const Rank to = nth(part_, n);
    if (to == own || !admits(to, element, most_cost)) continue;
    const Move move{joined(to) - joined(own), element, to};
    if (!best || *best < move) best = move;
  }
  return best;
}

void Levelling::carry_out(const Move& move) {
  const auto e = static_cast<std::size_t>(move.element);
  const auto from = static_cast<std::size_t>(part_[e]), to = static_cast<std::size_t>(move.to);
  cost_[from] -= weights_.cost[e];
  cost_[to] += weights_.cost[e];
  faces_[from] -= weights_.contact_faces[e];
  faces_[to] += weights_.contact_faces[e];
  part_[e] = move.to;
  members_[to].push_back(move.element);
}

bool Levelling::smooth(double load) {
  std::priority_queue<Move> moves;
  const auto propose = [&](LocalIndex e) {
    if (const auto move = best_move(e, load * mean_cost_)) moves.push(*move);
  };
  for (std::size_t e = 0; e < part_.size(); ++e) propose(static_cast<LocalIndex>(e));
  const std::size_t patience = moves.size() / 4;
  std::vector<bool> moved(part_.size(), false);
  std::vector<Move> done;  // with the part that each came from
  int gained = 0, most = 0;
  std::size_t kept = 0;
  while (!moves.empty() && done.size() <= kept + patience) {
    const Move move = moves.top();
    moves.pop();
    if (nth(moved, move.element)) continue;
    const auto now = best_move(move.element, load * mean_cost_);
    if (!now) continue;
    if (*now < move) {
      moves.push(*now);
      continue;
    }
    done.push_back({0, move.element, nth(part_, move.element)});
    carry_out(*now);
    nth(moved, move.element) = true;
    gained += now->gain;
    if (gained > most) {
      most = gained;
      kept = done.size();
    }
    for (const LocalIndex n : graph_.row(move.element))
      if (!nth(moved, n)) propose(n);
  }
  for (; done.size() > kept; done.pop_back()) carry_out(done.back());
  return most > 0;
}

bool Levelling::relieve(Rank from) {
  std::vector<LocalIndex>& own = nth(members_, from);
  std::erase_if(own, [&](LocalIndex e) { return nth(part_, e) != from; });
  std::priority_queue<Move> moves;
  const auto propose = [&](LocalIndex e) {
    if (const auto move = best_move(e)) moves.push(*move);
  };
  std::ranges::for_each(own, propose);
  bool any = false;
  while (!moves.empty() && nth(cost_, from) > mean_cost_) {
    const Move move = moves.top();
    moves.pop();
    if (nth(part_, move.element) != from) continue;
    const auto now = best_move(move.element);
    if (!now) continue;
    if (*now < move) {  // its neighbours have moved, or that part is full
      moves.push(*now);
      continue;
    }
    carry_out(*now);
    any = true;
    for (const LocalIndex n : graph_.row(move.element))
      if (nth(part_, n) == from) propose(n);
  }
  return any;
}

}  // namespace

void smooth(const Ragged<LocalIndex>& graph, const Weights& weights, int parts, double tolerance,
            std::span<Rank> part) {
  constexpr int most_rounds = 8;
  Levelling levelling(graph, weights, parts, part);
  for (int round = 0; round < most_rounds && levelling.smooth(1 + tolerance); ++round) {
  }
}

void level(const Ragged<LocalIndex>& graph, const Weights& weights, int parts, double tolerance, std::span<Rank> part) {
  constexpr int most_rounds = 64;  // in each round load moves on by one part
  Levelling levelling(graph, weights, parts, part);
  for (int round = 0; round < most_rounds; ++round) {
    bool any = false;
    for (const Rank from : levelling.above(1 + tolerance)) any = levelling.relieve(from) || any;
    if (!any) return;
  }
}

}  // namespace brunt::partition
