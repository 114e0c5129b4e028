// SPDX-License-Identifier: Apache-2.0
// `brunt depth`: how far two bodies overlap and the smallest motion that separates them, pose by pose. Poses are dealt
// to the ranks as they become free.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>

#include "brunt/comm/deal_out.hpp"
#include "brunt/core/error.hpp"
#include "brunt/io/surface_file.hpp"
#include "brunt/io/text_file.hpp"
#include "commands.hpp"
#include "depth_bodies.hpp"
#include "depth_poses.hpp"
#include "depth_report.hpp"
#include "failure.hpp"
#include "prepare.hpp"

namespace brunt::app {
namespace {

namespace fs = std::filesystem;

/// Poses of a sequence that start from each other; the first of a chain starts anew, so that chains may be dealt out.
constexpr GlobalIndex chain_length = 32;

/// All that is asked: bodies, and who is to be moved out of whom.
struct Work {
  std::vector<NamedSurface> surfaces;
  std::vector<depth::Body> bodies;
  struct Pose {
    std::size_t a, b;
    Placement start;
  };
  std::vector<Pose> poses;
};

std::vector<depth::Metric> metrics_of(const DepthOptions& options) {
  std::vector<depth::Metric> metrics;
  for (const std::string& name : options.metrics) metrics.push_back(metric_named(name));
  std::ranges::sort(metrics);  // translations first: their answers start the others
  metrics.erase(std::ranges::unique(metrics).begin(), metrics.end());
  return metrics;
}

bool is_scene(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension == ".yaml" || extension == ".yml";
}

Work work_of_files(const comm::Communicator& ranks, const DepthOptions& options) {
  Work work;
  std::vector<std::string> faults;
  for (const std::string& path : {options.a, options.b}) {
    try {
      work.surfaces.push_back(read_closed_surface(ranks, path, options.merge));
    } catch (const InputError& error) {
      faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    }
  }
  if (!faults.empty()) throw InputError(faults);
  const ConvexPieces pieces = options.pieces.empty() ? ConvexPieces{} : read_pieces(options.pieces);
  work.bodies.push_back(depth::make_body(work.surfaces[0].surface, {.pieces = pieces.a}));
  work.bodies.push_back(depth::make_body(work.surfaces[1].surface, {.pieces = pieces.b}));
  const std::vector<Placement> poses =
      options.poses.empty() ? std::vector<Placement>{pose_of(options.at, options.turn)} : read_poses(options.poses);
  for (const Placement& pose : poses) work.poses.push_back({0, 1, pose});
  return work;
}

/// Parts that share points are one body where they do, and touch there by design.
bool share_points(const TriangleSurface& a, const TriangleSurface& b) {
  const auto sorted = [](const TriangleSurface& s) {
    std::vector<std::array<double, 3>> points;
    for (const Vec3& x : s.points) points.push_back({x[0], x[1], x[2]});
    std::ranges::sort(points);
    return points;
  };
  const auto one = sorted(a), other = sorted(b);
  auto i = one.begin(), j = other.begin();
  while (i != one.end() && j != other.end()) {
    if (*i == *j) return true;
    *i < *j ? ++i : ++j;
  }
  return false;
}

Work work_of_scene(const comm::Communicator& ranks, const DepthOptions& options) {
  if (!options.at.empty() || !options.turn.empty() || !options.poses.empty() || !options.pieces.empty())
    throw InputError(options.a + ": a scene places its parts itself; expected no --at, --turn, --poses or --pieces");
  Work work;
  work.surfaces = surfaces_of_scene(ranks, read_input(ranks, options.a, options.overrides));
  for (const NamedSurface& named : work.surfaces) work.bodies.push_back(depth::make_body(named.surface));
  const Placement here;
  for (std::size_t a = 0; a < work.bodies.size(); ++a)
    for (std::size_t b = a + 1; b < work.bodies.size(); ++b) {
      const depth::Encounter pair{work.bodies[a], work.bodies[b], here};
      if (!pair.bodies_collide(here) || share_points(work.surfaces[a].surface, work.surfaces[b].surface)) continue;
      work.poses.push_back({a, b, here});
    }
  return work;
}

/// The answers of one pose. before: those of the pose before, or none.
std::vector<DepthRow> answers_of(const Work& work, std::size_t k, const std::vector<depth::Metric>& metrics,
                                 const DepthOptions& options, const std::vector<DepthRow>& before) {
  using Clock = std::chrono::steady_clock;
  const Work::Pose& pose = work.poses[k];
  const depth::Body &a = work.bodies[pose.a], &b = work.bodies[pose.b];
  std::vector<DepthRow> rows;
  std::vector<Placement> tries;
  for (const DepthRow& row : before) tries.push_back(row.answer.placement);
  for (const depth::Metric metric : metrics) {
    depth::Query query;
    query.a_in_b = pose.start;
    query.metric = metric;
    query.careful = options.careful;
    query.tries = tries;
    if (options.clearance > 0) query.clearance = options.clearance / a.shape.radius;
    if (metric == depth::Metric::translation) query.along = axes_named(options.along);
    const Clock::time_point start = Clock::now();
    DepthRow row;
    row.answer = depth::penetration_depth(a, b, query);
    row.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    row.pose = static_cast<std::int64_t>(k);
    row.a = work.surfaces[pose.a].name;
    row.b = work.surfaces[pose.b].name;
    row.metric = metric;
    row.centroid = a.shape.centroid;
    row.start = pose.start;
    if (row.answer.overlap && row.answer.found) tries.push_back(row.answer.placement);
    rows.push_back(std::move(row));
  }
  return rows;
}

TriangleSurface placed(const TriangleSurface& surface, const Placement& placement) {
  TriangleSurface moved = surface;
  for (Vec3& x : moved.points) x = placement(x);
  return moved;
}

/// The folder of results, on the root. depth.csv grows row by row; an unfinished one is gone on with.
class ResultFolder {
 public:
  ResultFolder(const DepthOptions& options, std::string fingerprint) : folder_(options.out) {
    if (folder_.empty()) return;
    const fs::path csv = fs::path(folder_) / "depth.csv", finished = fs::path(folder_) / "depth.json",
                   asked = fs::path(folder_) / "depth.asked";
    if (options.force)
      for (const fs::path& path : {csv, finished, asked}) fs::remove(path);
    if (fs::exists(finished))
      throw InputError(folder_ +
                       ": holds results of an earlier run; choose another folder with --out or replace them "
                       "with --force");
    fs::create_directories(folder_);
    if (fs::exists(csv)) {
      if (!fs::exists(asked) || io::read_text(asked.string()) != fingerprint)
        throw InputError(folder_ +
                         ": holds unfinished results of another question; choose another folder with --out or "
                         "replace them with --force");
      keep_whole_rows(csv.string());
    } else {
      io::replace_text(asked.string(), fingerprint);
      io::replace_text(csv.string(), csv_header());
    }
    rows_.open(csv, std::ios::app | std::ios::binary);
    if (!rows_) throw MachineError(csv.string() + ": cannot be written");
  }

  [[nodiscard]] GlobalIndex kept() const { return kept_; }  ///< rows of an unfinished run
  [[nodiscard]] bool exists() const { return !folder_.empty(); }
  void add(const DepthRow& row) {
    if (folder_.empty()) return;
    rows_ << csv_row(row) << std::flush;
    if (!rows_) throw MachineError(folder_ + "/depth.csv: cannot be written");
  }
  void write_surfaces(const Work& work, const std::vector<DepthRow>& rows) const {
    if (folder_.empty()) return;
    for (const DepthRow& row : rows) {
      if (!row.answer.overlap || !row.answer.found) continue;
      const Work::Pose& pose = work.poses[static_cast<std::size_t>(row.pose)];
      const std::string stem = fmt::format("{}/pose{}_{}", folder_, row.pose, name_of(row.metric));
      io::write_ply(stem + "_before.ply", placed(work.surfaces[pose.a].surface, pose.start));
      io::write_ply(stem + "_after.ply", placed(work.surfaces[pose.a].surface, row.answer.placement));
      io::write_ply(stem + "_other.ply", work.surfaces[pose.b].surface);
    }
  }
  void finish(const nlohmann::ordered_json& all) const {
    if (folder_.empty()) return;
    io::replace_text(folder_ + "/depth.json", all.dump(1) + "\n");
  }

 private:
  /// A row that a killed run left unfinished is dropped.
  void keep_whole_rows(const std::string& path) {
    std::string text = io::read_text(path);
    text.resize(text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1);
    if (text.empty()) text = csv_header();
    kept_ = std::ranges::count(text, '\n') - 1;
    io::replace_text(path, text);
  }

  std::string folder_;
  std::ofstream rows_;
  GlobalIndex kept_ = 0;
};

/// What the rows of a run depend on, but for its number of ranks.
std::string fingerprint_of(const DepthOptions& options, const Work& work) {
  std::uint64_t hash = 1469598103934665603ULL;  // FNV-1a
  const auto add = [&](const void* from, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
      hash = (hash ^ static_cast<const unsigned char*>(from)[i]) * 1099511628211ULL;
  };
  for (const NamedSurface& named : work.surfaces) {
    for (const Vec3& x : named.surface.points) add(x.data(), 3 * sizeof(double));
    for (const auto& triangle : named.surface.triangles) add(triangle.data(), sizeof triangle);
  }
  for (const Work::Pose& pose : work.poses) {
    add(pose.start.rotation.data(), 9 * sizeof(double));
    add(pose.start.translation.data(), 3 * sizeof(double));
  }
  std::string metrics;
  for (const depth::Metric metric : metrics_of(options)) metrics += std::string(name_of(metric)) + " ";
  return fmt::format(
      "bodies and poses {:016x}\nmetrics {}\nclearance {}\nalong {}\ncareful {}\nsequence {}\ncertify {} {}\n", hash,
      metrics, options.clearance, options.along, options.careful, options.sequence, options.certify, options.boxes);
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
      "{} poses, {} answers of bodies that overlap, the deepest {:.6g}; a query took {:.3g} ms in the median, "
      "{:.3g} ms at most\n",
      poses, overlapping, deepest, 1e3 * times[times.size() / 2], 1e3 * times.back());
}

}  // namespace

int depth_command(const comm::Communicator& ranks, const DepthOptions& options) {
  const std::vector<depth::Metric> metrics = metrics_of(options);
  if (!options.along.empty() && (metrics.size() != 1 || metrics[0] != depth::Metric::translation))
    throw InputError("--along holds for translations; expected --metric translation with it");
  if (options.b.empty() != is_scene(options.a))
    throw InputError(options.b.empty() ? options.a + ": one surface; expected two, A and B, or a scene (.yaml)"
                                       : options.a + ": a scene stands alone; expected no second file");
  const Work work = options.b.empty() ? work_of_scene(ranks, options) : work_of_files(ranks, options);
  std::unique_ptr<ResultFolder> folder;
  on_root(ranks, [&] {
    for (const NamedSurface& named : work.surfaces)
      for (const std::string& note : named.notes) fmt::print(stderr, "{}\n", note);
    folder = std::make_unique<ResultFolder>(options, fingerprint_of(options, work));
  });
  const auto count = static_cast<GlobalIndex>(work.poses.size());
  const GlobalIndex a_task = options.sequence ? chain_length : 1, tasks = (count + a_task - 1) / a_task;
  const auto rows_a_task = a_task * static_cast<GlobalIndex>(metrics.size());
  const GlobalIndex done = ranks.max(folder ? folder->kept() / rows_a_task : 0);
  GlobalIndex to_skip = folder ? folder->kept() - done * rows_a_task : 0;
  std::vector<DepthRow> all;
  auto json = nlohmann::ordered_json::array();
  const auto work_on = [&](GlobalIndex task) {
    std::vector<DepthRow> rows, before;
    for (GlobalIndex k = (task + done) * a_task; k < std::min(count, (task + done + 1) * a_task); ++k) {
      std::vector<DepthRow> now = answers_of(work, static_cast<std::size_t>(k), metrics, options, before);
      rows.insert(rows.end(), now.begin(), now.end());
      if (options.sequence) before = std::move(now);
    }
    return packed(rows);
  };
  comm::deal_out(ranks, tasks - done, work_on, [&](GlobalIndex /*task*/, std::span<const std::byte> bytes) {
    for (DepthRow& row : unpacked(bytes)) {
      if (to_skip > 0) {
        --to_skip;
      } else {
        folder->add(row);
      }
      if (!options.json && count <= 10) fmt::print("{}", described(row));
      json.push_back(as_json(row));
      all.push_back(std::move(row));
    }
  });
  if (!ranks.is_root()) return 0;
  if (options.json) fmt::print("{}\n", json.dump(1));
  if (!options.json && count == 0) fmt::print("{}: no two parts overlap\n", options.a);
  if (!options.json && count > 10) print_summary(all, work.poses.size());
  if (count <= 10) folder->write_surfaces(work, all);
  nlohmann::ordered_json result;
  result["rows_of_an_earlier_run"] = folder->kept();
  result["answers"] = std::move(json);
  folder->finish(result);
  return 0;
}

}  // namespace brunt::app
