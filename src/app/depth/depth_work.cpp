// SPDX-License-Identifier: Apache-2.0
#include "depth_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "app/whole/whole_scene.hpp"
#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "core/letter_case.hpp"
#include "core/sorted.hpp"
#include "depth/encounter.hpp"
#include "depth/samples.hpp"
#include "depth_poses.hpp"

namespace brunt::app {
namespace {

constexpr double farthest_place = 1e100;  // [length]: squares of distances stay finite

bool is_scene(const std::string& path) {
  const std::string extension = lower_case(std::filesystem::path(path).extension().string());
  return extension == ".yaml" || extension == ".yml";
}

depth::Body body_of(const NamedSurface& named, const std::vector<std::vector<Vec3>>& pieces = {}) {
  try {
    return depth::make_body(named.surface, {.pieces = pieces});
  } catch (const std::invalid_argument& error) {
    throw InputError(
        fmt::format("{}: invalid body: {}; expected a thickness above 1e-6 of its length", named.name, error.what()));
  }
}

/// Bounds are proven only if pieces lie in their body, so at least their corners are checked. where: of pieces.
depth::Body body_with(const NamedSurface& named, const std::vector<std::vector<Vec3>>& pieces,
                      const std::string& where) {
  constexpr double rounding = 1e-9;  // of the body's radius: corners on the surface, written with ten digits
  const auto fault = [&](std::size_t k, const char* what) {
    return InputError(
        fmt::format("{}: invalid piece {}: {}; expected convex pieces inside {}", where, k + 1, what, named.name));
  };
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    try {
      (void)depth::convex_piece(pieces[k]);
    } catch (const std::invalid_argument&) {
      throw fault(k, "it lies in a plane");
    }
  }
  depth::Body body = body_of(named, pieces);
  for (std::size_t k = 0; k < pieces.size(); ++k)
    for (const Vec3& x : pieces[k])
      if (geometry::point_depth(body.tree, x).depth < -rounding * body.shape.radius)
        throw fault(k, "a corner lies outside the body");
  return body;
}

DepthWork work_of_files(const comm::Communicator& ranks, const DepthOptions& options) {
  if (!options.overrides.empty())
    throw InputError(fmt::format("invalid --set '{}': surfaces have no values; expected a scene (.yaml)",
                                 excerpt(options.overrides.front())));
  DepthWork work;
  std::vector<std::string> faults;
  for (const std::string& path : {options.a, options.b}) {
    try {
      work.surfaces.push_back(read_closed_surface(ranks, path, options.merge));
    } catch (const InputError& error) {
      faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    }
  }
  if (!faults.empty()) throw InputError(faults);
  if (!options.pieces.empty()) work.pieces = read_pieces(options.pieces);
  work.bodies.push_back(body_with(work.surfaces[0], work.pieces.a, options.pieces + ": a"));
  work.bodies.push_back(body_with(work.surfaces[1], work.pieces.b, options.pieces + ": b"));
  const std::vector<Placement> poses =
      options.poses.empty() ? std::vector<Placement>{pose_of(options.at, options.turn)} : read_poses(options.poses);
  for (const Placement& pose : poses) {
    if (!(pose.translation.cwiseAbs().maxCoeff() < farthest_place))
      throw InputError(fmt::format("out of range: position of pose {} of A; expected |x|, |y|, |z| < {:g}",
                                   work.poses.size(), farthest_place));
    work.poses.push_back({0, 1, pose});
  }
  if (options.samples > 0)
    work.samples = depth::sample_contacts(work.bodies[0], work.bodies[1], static_cast<std::size_t>(options.samples));
  return work;
}

/// Parts that share points are connected there, and touch by design.
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

DepthWork work_of_scene(const comm::Communicator& ranks, const DepthOptions& options) {
  if (!options.at.empty() || !options.turn.empty() || !options.poses.empty() || !options.pieces.empty() ||
      options.merge >= 0)
    throw InputError(options.a +
                     ": invalid options: a scene places its own parts; expected no --at, --turn, --poses, "
                     "--pieces or --merge");
  DepthWork work;
  work.surfaces = surfaces_of_scene(ranks, read_input(ranks, options.a, options.overrides));
  for (const NamedSurface& named : work.surfaces) work.bodies.push_back(body_of(named));
  const Placement here;
  for (std::size_t a = 0; a < work.bodies.size(); ++a)
    for (std::size_t b = a + 1; b < work.bodies.size(); ++b) {
      const depth::Encounter pair{work.bodies[a], work.bodies[b], here};
      if (!pair.bodies_collide(here) || share_points(work.surfaces[a].surface, work.surfaces[b].surface)) continue;
      work.poses.push_back({a, b, here});
    }
  return work;
}

}  // namespace

std::vector<depth::Metric> metrics_of(const DepthOptions& options) {
  std::vector<depth::Metric> metrics;
  for (const std::string& name : options.metrics) metrics.push_back(metric_named(name));
  sort_unique(metrics);  // translations first: their answers start the others
  return metrics;
}

DepthWork depth_work(const comm::Communicator& ranks, const DepthOptions& options) {
  if (!options.along.empty() && (options.metrics.size() != 1 || options.metrics[0] != "translation"))
    throw InputError("invalid --along: expected --metric translation as the only metric");
  if (options.b.empty() != is_scene(options.a))
    throw InputError(options.b.empty() ? options.a + ": missing second surface; expected A and B, or a scene (.yaml)"
                                       : options.a + ": invalid second file with a scene; expected the scene only");
  const std::vector<Vec3> along = axes_named(options.along);
  DepthWork work = options.b.empty() ? work_of_scene(ranks, options) : work_of_files(ranks, options);
  work.along = along;
  return work;
}

std::string fingerprint_of(const DepthOptions& options, const DepthWork& work) {
  std::uint64_t hash = 1469598103934665603ULL;  // FNV-1a
  const auto add = [&](const void* from, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
      hash = (hash ^ static_cast<const unsigned char*>(from)[i]) * 1099511628211ULL;
  };
  for (const NamedSurface& named : work.surfaces) {
    for (const Vec3& x : named.surface.points) add(x.data(), 3 * sizeof(double));
    for (const auto& triangle : named.surface.triangles) add(triangle.data(), sizeof triangle);
  }
  for (const std::vector<std::vector<Vec3>>* of_body : {&work.pieces.a, &work.pieces.b})
    for (const std::vector<Vec3>& piece : *of_body)
      for (const Vec3& x : piece) add(x.data(), 3 * sizeof(double));
  for (const DepthWork::Pose& pose : work.poses) {
    add(pose.start.rotation.data(), 9 * sizeof(double));
    add(pose.start.translation.data(), 3 * sizeof(double));
  }
  std::string metrics;
  for (const depth::Metric metric : metrics_of(options)) metrics += std::string(name_of(metric)) + " ";
  return fmt::format(
      "bodies and poses {:016x}\nmetrics {}\nclearance {}\nalong {}\ncareful {}\nsequence {}\ncertify {} {}\nsamples "
      "{}\n",
      hash, metrics, options.clearance, options.along, options.careful, options.sequence, options.certify,
      options.boxes, options.samples);
}

}  // namespace brunt::app
