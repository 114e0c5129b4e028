// SPDX-License-Identifier: Apache-2.0
#include "joint_search.hpp"

#include <algorithm>

namespace brunt::depth {
namespace {

constexpr std::array<Metric, 3> metrics{Metric::translation, Metric::displacement, Metric::object_norm};
constexpr double careful_march = 0.08;  // step of marches: with the standard .1 narrow free regions may be missed
constexpr double small_share = 0.2;     // of A's radius: where the bound is above it, no small motion is tried
constexpr double far_above = 3;         // of the bound: regions add up to twice the bound at most
constexpr double askew_share = 2;       // of the overlap: A is turned and shifted by this to begin small motions
constexpr double margin_share = 2;      // of the clearance: small motions leave this

}  // namespace

JointSearch::JointSearch(Encounter& encounter, const Query& query, const Mat3& basis,
                         const std::array<double, 3>& bounds)
    : encounter_(encounter),
      query_(query),
      basis_(basis),
      bounds_(bounds),
      ways_(encounter, basis, margin_share * query.clearance * encounter.a.shape.radius, bounds[0]) {
  prepare(query.careful && query.warm);
}

void JointSearch::prepare(bool careful) {
  walks_ = walks();
  steps_ = steps();
  pairs_ = pairs();
  metrics_ = 0;
  add_metrics(query_.along.empty() ? index_of(query_.metric) + 1 : 1, careful);
}

void JointSearch::add_metrics(std::size_t count, bool careful) {
  for (; metrics_ < count; ++metrics_)
    searches_[metrics_].emplace(encounter_, effort_of(metrics[metrics_], careful, query_.clearance, basis_),
                                bounds_[metrics_]);
}

void JointSearch::try_placements() {
  for (const Placement& placement : query_.tries)
    asked().walk_from_placement(motion_between(encounter_.start, placement, encounter_.a.shape.centroid));
  asked().forget_work();
}

bool JointSearch::is_shallow() const {
  return bounds_[0] <= small_share * encounter_.a.shape.radius;
}

void JointSearch::find_small_motion(const RigidMotion& from, Freedom freedom) {
  const Start start = ways_.find(from, freedom, query_.metric);
  if (start.length >= 0) small_.push_back(start.motion);
  last_ = start.motion;
}

/// For the metric m: translations first, turns for the others.
void JointSearch::find_small_motions(std::size_t m) {
  if (!is_shallow()) return;
  if (m == 0) {
    if (tried_ > 0) return;
    find_small_motion({}, Freedom::shift);
    if (small_.empty() && query_.along.empty()) {
      find_small_motion({}, Freedom::both);
      find_small_motion({Turn::Identity(), last_.shift}, Freedom::shift);
    }
  } else if (tried_ < 2) {
    find_small_motion({}, Freedom::both);
    find_small_motion({}, Freedom::turn);
  }
  tried_ = std::max(tried_, m == 0 ? 1 : 2);
}

/// Where the best motion is far longer than the bound: small motions from A turned and shifted a little. Threads and
/// tilted parts come free from one side, where from q_0 the planes of both sides contradict each other.
void JointSearch::start_askew(std::size_t m) {
  Search& search = *searches_[m];
  const auto far = [&] { return search.best().length > far_above * bounds_[m]; };
  if (m == 0 || askew_ || !is_shallow() || !far()) return;
  askew_ = true;
  const double size = askew_share * ways_.overlap();
  for (int c = 0; c < 3; ++c)
    for (const double sign : {1.0, -1.0}) {
      const Vec3 way = sign * size * encounter_.a.axes.col(c);
      for (const RigidMotion& from : {RigidMotion{rotation_of(way / encounter_.a.shape.radius), Vec3::Zero()},
                                      RigidMotion{Turn::Identity(), way}}) {
        const std::size_t before = small_.size();
        find_small_motion(from, Freedom::both);
        if (small_.size() == before) continue;
        search.forget_work();
        search.walk_from(small_.back());
        if (!far()) return;
      }
    }
}

void JointSearch::search_all(bool careful, std::size_t first) {
  for (std::size_t m = first; m < metrics_; ++m) {
    Search& search = *searches_[m];
    for (const RigidMotion& motion : finished_) search.offer(motion);
    if (search.done()) continue;
    find_small_motions(m);
    std::vector<Start> starts;
    const auto add = [&](const std::vector<RigidMotion>& motions) {
      for (const RigidMotion& motion : motions)
        if (const Start start = search.admitted_start(motion); start.length > 0) starts.push_back(start);
    };
    add(small_);
    add(finished_);
    StartOptions options;
    options.metric = metrics[m];
    options.grid = effort_of(metrics[m], careful, query_.clearance, basis_).grid;
    options.careful = careful;
    if (careful) options.march = careful_march;
    options.basis = basis_;
    options.nothing_below = bounds_[m];
    options.known = search.best().length;
    for (const Start& start : starts) options.known = std::min(options.known, start.length);
    for (const Start& start : find_starts(encounter_, options)) starts.push_back(start);
    std::stable_sort(starts.begin(), starts.end(), [](const Start& x, const Start& y) { return x.length < y.length; });
    search.walk_from_all(starts);
    start_askew(m);
    if (search.found()) finished_.push_back(search.best().motion);
  }
}

void JointSearch::exchange_ends() {
  std::array<std::vector<RigidMotion>, 3> ends;
  for (std::size_t m = 0; m < metrics_; ++m) ends[m] = searches_[m]->ends();
  for (std::size_t m = 0; m < metrics_; ++m) {
    Search& search = *searches_[m];
    std::vector<Start> gained;
    for (std::size_t other = 0; other < metrics_; ++other)
      for (const RigidMotion& motion : ends[other])
        if (other != m)
          if (const Start start = search.admitted_start(motion); start.length > 0) gained.push_back(start);
    std::stable_sort(gained.begin(), gained.end(), [](const Start& x, const Start& y) { return x.length < y.length; });
    search.forget_work();
    search.walk_from_all(gained);
  }
}

void JointSearch::finish(bool careful) {
  for (std::size_t m = 0; m < metrics_; ++m) {
    Search& search = *searches_[m];
    for (const RigidMotion& motion : finished_) search.offer(motion);
    if (!search.found()) continue;
    search.finish(careful);
    finished_.push_back(search.best().motion);
  }
}

void JointSearch::run() {
  if (asked().found()) finished_.push_back(asked().best().motion);
  prepare(false);
  search_all(false, 0);
  finish(false);
  if (!query_.careful) return;
  prepare(true);
  search_all(true, 0);
  if (query_.along.empty() && !asked().done()) {
    const std::size_t first = metrics_;
    add_metrics(metrics.size(), true);
    search_all(true, first);
  }
  exchange_ends();
  finish(true);
}

void JointSearch::take(JointSearch& other) {
  if (other.asked().found()) finished_.push_back(other.asked().best().motion);
}

int JointSearch::walks() const {
  int sum = walks_;
  for (const auto& search : searches_) sum += search ? search->walks() : 0;
  return sum;
}

int JointSearch::steps() const {
  int sum = steps_;
  for (const auto& search : searches_) sum += search ? search->steps() : 0;
  return sum;
}

std::int64_t JointSearch::pairs() const {
  std::int64_t sum = pairs_;
  for (const auto& search : searches_) sum += search ? search->pairs() : 0;
  return sum;
}

}  // namespace brunt::depth
