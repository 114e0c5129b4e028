// SPDX-License-Identifier: Apache-2.0
#include "depth_folder.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "core/error.hpp"
#include "io/csv.hpp"
#include "io/json_text.hpp"
#include "io/surface/surface_file.hpp"
#include "io/text_file.hpp"

namespace brunt::app {
namespace {

namespace fs = std::filesystem;

TriangleSurface placed(const TriangleSurface& surface, const Placement& placement) {
  TriangleSurface moved = surface;
  for (Vec3& x : moved.points) x = placement(x);
  return moved;
}

}  // namespace

DepthFolder::DepthFolder(const DepthOptions& options, const std::string& fingerprint) : folder_(options.out) {
  if (folder_.empty()) return;
  const fs::path csv = fs::path(folder_) / "depth.csv", finished = fs::path(folder_) / "depth.json",
                 asked = fs::path(folder_) / "depth.asked";
  if (options.force)
    for (const fs::path& path : {csv, finished, asked}) fs::remove(path);
  if (fs::exists(finished))
    throw InputError(
        folder_ +
        ": invalid result folder: it contains results; expected another folder (--out), or --force to replace them");
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error)
    throw InputError(
        fmt::format("--out {}: invalid folder ({}); expected a folder that can be created", folder_, error.message()));
  if (fs::exists(csv)) {
    if (!fs::exists(asked) || io::read_text(asked.string()) != fingerprint)
      throw InputError(folder_ +
                       ": invalid result folder: it contains unfinished results of another query; expected another "
                       "folder (--out), or --force to replace them");
    keep_whole_rows(csv.string());
  } else {
    io::replace_text(asked.string(), fingerprint);
    io::replace_text(csv.string(), csv_header());
  }
  rows_.open(csv, std::ios::app | std::ios::binary);
  if (!rows_) throw MachineError(csv.string() + ": cannot write the file");
}

void DepthFolder::add(const DepthRow& row) {
  if (folder_.empty()) return;
  rows_ << csv_row(row) << std::flush;
  if (!rows_) throw MachineError(folder_ + "/depth.csv: cannot write the file");
}

void DepthFolder::write_surfaces(const DepthWork& work, const std::vector<DepthRow>& rows) const {
  if (folder_.empty()) return;
  for (const DepthRow& row : rows) {
    if (!row.answer.overlap || !row.answer.found) continue;
    const DepthWork::Pose& pose = nth(work.poses, row.pose);
    const std::string stem = fmt::format("{}/pose{}_{}", folder_, row.pose, name_of(row.metric));
    io::write_ply(stem + "_before.ply", placed(work.surfaces[pose.a].surface, pose.start));
    io::write_ply(stem + "_after.ply", placed(work.surfaces[pose.a].surface, row.answer.placement));
    io::write_ply(stem + "_other.ply", work.surfaces[pose.b].surface);
  }
}

void DepthFolder::finish(const nlohmann::ordered_json& all) const {
  if (folder_.empty()) return;
  io::replace_text(folder_ + "/depth.json", io::json_text(all, 1) + "\n");
}

/// Removes an incomplete last row of a killed run.
void DepthFolder::keep_whole_rows(const std::string& path) {
  std::string text = io::read_text(path);
  const io::CsvRecords whole = io::csv_records(text);
  for (std::size_t k = 1; k < whole.records.size(); ++k)
    earlier_.push_back(row_of_record(whole.records[k], fmt::format("{}: row {}", path, k)));
  text.resize(whole.end);
  if (text.empty()) text = csv_header();
  io::replace_text(path, text);
}

}  // namespace brunt::app
