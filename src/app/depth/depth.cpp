// SPDX-License-Identifier: Apache-2.0
// `brunt depth`: the penetration depth of two bodies and the smallest motion that separates them, pose by pose. Poses
// are distributed to the ranks as they become idle.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>

#include "app/program/commands.hpp"
#include "app/program/failure.hpp"
#include "comm/deal_out.hpp"
#include "comm/rendezvous.hpp"
#include "depth/samples.hpp"
#include "depth_folder.hpp"
#include "depth_message.hpp"
#include "depth_report.hpp"
#include "depth_work.hpp"
#include "io/json_text.hpp"

namespace brunt::app {
namespace {

/// Number of consecutive poses that start from each other; the first of a chain starts anew, so chains can be
/// distributed.
constexpr GlobalIndex chain_length = 32;
/// Most boxes of --certify: some seconds to a minute (2e4 to 2.5e5 boxes a second, src/depth/README.md).
constexpr std::int64_t default_boxes = 1'000'000;

/// All ranks then work on each pose together.
bool is_certified(const DepthOptions& options) {
  return options.certify > 0 || options.boxes > 0 || options.limit > 0;
}

/// Each rank evaluates a slice of the boxes; all receive the verdicts.
void judge_on_all(const comm::Communicator& ranks, const depth::Encounter& encounter, depth::Metric metric,
                  double upper, std::span<const depth::CoverBox> boxes, std::span<depth::CoverVerdict> verdicts) {
  const comm::BlockLayout layout{static_cast<GlobalIndex>(boxes.size()), ranks.size()};
  const auto first = static_cast<std::size_t>(layout.first(ranks.rank()));
  std::vector<depth::CoverVerdict> own(static_cast<std::size_t>(layout.count(ranks.rank())));
  for (std::size_t k = 0; k < own.size(); ++k) own[k] = depth::judge(encounter, metric, upper, boxes[first + k]);
  const std::vector<std::vector<depth::CoverVerdict>> to_all(static_cast<std::size_t>(ranks.size()), own);
  std::ranges::copy(comm::exchange(ranks, to_all).values, verdicts.begin());
}

/// The best end of walks from the samples nearest to the pose is one more start of its search.
void start_from_samples(const DepthWork& work, const depth::Body& a, const depth::Body& b, depth::Query& query) {
  if (work.samples.empty()) return;
  depth::Encounter encounter{a, b, depth::rounded(query.a_in_b, a.shape.radius), 0, query.apart};
  if (!encounter.collides({})) return;
  if (const auto best = depth::best_from_samples(encounter, query.metric, work.samples)) query.tries.push_back(*best);
}

/// The answers of one pose. before: those of the pose before, or none.
std::vector<DepthRow> answers_of(const comm::Communicator& ranks, const DepthWork& work, std::size_t k,
                                 const std::vector<depth::Metric>& metrics, const DepthOptions& options,
                                 const std::vector<DepthRow>& before) {
  using Clock = std::chrono::steady_clock;
  const DepthWork::Pose& pose = work.poses[k];
  const depth::Body &a = work.bodies[pose.a], &b = work.bodies[pose.b];
  std::vector<DepthRow> rows;
  std::vector<Placement> tries;  // the answers of the metrics before
  for (const depth::Metric metric : metrics) {
    depth::Query query;
    query.a_in_b = pose.start;
    query.metric = metric;
    query.careful = options.careful;
    query.tries = tries;
    for (const DepthRow& row : before)
      if (row.metric == metric && row.answer.overlap && row.answer.found) query.tries.push_back(row.answer.placement);
    if (is_certified(options)) {
      query.gap = options.certify;
      query.boxes = options.boxes > 0 ? options.boxes : default_boxes;
      query.evaluate = [&](std::span<const depth::CoverBox> boxes, double upper,
                           std::span<depth::CoverVerdict> verdicts) {
        judge_on_all(ranks, {a, b, depth::rounded(pose.start, a.shape.radius), 0, options.clearance}, metric, upper,
                     boxes, verdicts);
      };
    }
    const Clock::time_point start = Clock::now();
    const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    if (options.limit > 0) query.stop = [&] { return ranks.max(seconds()) > options.limit; };
    query.apart = options.clearance;
    if (metric == depth::Metric::translation) query.along = work.along;
    DepthRow row;
    start_from_samples(work, a, b, query);
    row.answer = depth::penetration_depth(a, b, query);
    row.seconds = seconds();
    row.pose = static_cast<std::int64_t>(k);
    row.a = work.surfaces[pose.a].name;
    row.b = work.surfaces[pose.b].name;
    row.metric = metric;
    row.centroid = a.shape.centroid;
    row.start = pose.start;
    row.least_turn = accuracy_of(options.careful) * row.answer.depth / a.shape.radius;
    if (row.answer.overlap && row.answer.found) tries.push_back(row.answer.placement);
    rows.push_back(std::move(row));
  }
  return rows;
}

void print_summary(const std::vector<DepthRow>& rows, std::size_t poses) {
  double deepest = 0;
  std::vector<double> times;
  std::size_t overlapping = 0;
  for (const DepthRow& row : rows) {
    overlapping += row.answer.overlap ? 1 : 0;
    deepest = std::max(deepest, row.answer.depth);
    times.push_back(row.seconds);
  }
  if (times.empty()) return;
  std::ranges::sort(times);
  fmt::print(
      "{} poses, {} answers for overlapping bodies, the deepest {:.6g}; time of a query: median {:.3g} ms, largest "
      "{:.3g} ms\n",
      poses, overlapping, deepest, 1e3 * times[times.size() / 2], 1e3 * times.back());
}

}  // namespace

int depth_command(const comm::Communicator& ranks, const DepthOptions& options) {
  const std::vector<depth::Metric> metrics = metrics_of(options);
  const DepthWork work = depth_work(ranks, options);
  std::unique_ptr<DepthFolder> folder;
  on_root(ranks, [&] {
    for (const NamedSurface& named : work.surfaces)
      for (const std::string& note : named.notes) fmt::print(stderr, "{}\n", note);
    if (std::ssize(work.samples) < options.samples)
      fmt::print(stderr, "warning: --samples {}: only {} placements in contact found\n", options.samples,
                 work.samples.size());
    folder = std::make_unique<DepthFolder>(options, fingerprint_of(options, work));
  });
  const auto count = static_cast<GlobalIndex>(work.poses.size());
  const GlobalIndex a_task = options.sequence ? chain_length : 1, tasks = (count + a_task - 1) / a_task;
  const auto rows_a_task = a_task * static_cast<GlobalIndex>(metrics.size());
  const GlobalIndex done = ranks.max(folder ? static_cast<GlobalIndex>(folder->earlier().size()) / rows_a_task : 0);
  std::vector<DepthRow> all;
  auto json = nlohmann::ordered_json::array();
  if (folder)
    for (const EarlierRow& earlier : folder->earlier()) {
      json.push_back(as_json(earlier));
      all.push_back(earlier.row);
    }
  GlobalIndex to_skip = static_cast<GlobalIndex>(all.size()) - done * rows_a_task;  // of a task that was cut off
  const auto work_on = [&](GlobalIndex task) {
    std::vector<DepthRow> rows, before;
    for (GlobalIndex k = (task + done) * a_task; k < std::min(count, (task + done + 1) * a_task); ++k) {
      std::vector<DepthRow> now = answers_of(ranks, work, static_cast<std::size_t>(k), metrics, options, before);
      rows.insert(rows.end(), now.begin(), now.end());
      if (options.sequence) before = std::move(now);
    }
    return packed(rows);
  };
  // with a certificate all ranks work on each pose, else each on its own
  const bool together = is_certified(options);
  const auto deal = [&](const auto& take) {
    if (!together) return comm::deal_out(ranks, tasks - done, work_on, take);
    for (GlobalIndex task = 0; task < tasks - done; ++task) take(task, work_on(task));
  };
  deal([&](GlobalIndex /*task*/, std::span<const std::byte> bytes) {
    if (!ranks.is_root()) return;
    for (DepthRow& row : unpacked(bytes)) {
      if (to_skip > 0) {
        --to_skip;
        continue;
      }
      folder->add(row);
      fmt::print(stderr, "{}", warning_of(row, options.careful));
      if (!options.json && count <= 10) fmt::print("{}", described(row));
      json.push_back(as_json(row));
      all.push_back(std::move(row));
    }
  });
  if (!ranks.is_root()) return 0;
  if (options.json) fmt::print("{}\n", io::json_text(json, 1));
  if (!options.json && count == 0) fmt::print("{}: no two parts overlap\n", options.a);
  if (!options.json && count > 10) print_summary(all, work.poses.size());
  if (count <= 10) folder->write_surfaces(work, all);
  nlohmann::ordered_json result;
  result["rows_of_an_earlier_run"] = folder->earlier().size();
  result["answers"] = std::move(json);
  folder->finish(result);
  return 0;
}

}  // namespace brunt::app
