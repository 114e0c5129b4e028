// SPDX-License-Identifier: Apache-2.0
#include "depth_bodies.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "app/program/failure.hpp"
#include "app/whole/outer_surface.hpp"
#include "app/whole/whole_scene.hpp"
#include "core/error.hpp"
#include "core/excerpt.hpp"
#include "core/utf8.hpp"
#include "geometry/triangles/closed_surface.hpp"
#include "geometry/triangles/flip_slivers.hpp"
#include "geometry/triangles/merge_points.hpp"
#include "geometry/triangles/slab_tree.hpp"
#include "io/surface/surface_file.hpp"
#include "io/text_file.hpp"
#include "scene/build/build.hpp"
#include "scene/build/select.hpp"

namespace brunt::app {
namespace {

template <class T>
void share(const comm::Communicator& ranks, std::vector<T>& values) {
  std::vector<std::byte> bytes(values.size() * sizeof(T));
  if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  ranks.broadcast(bytes);
  values.resize(bytes.size() / sizeof(T));
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
}

void share(const comm::Communicator& ranks, TriangleSurface& surface) {
  std::vector<std::array<double, 3>> points;
  for (const Vec3& x : surface.points) points.push_back({x[0], x[1], x[2]});
  share(ranks, points);
  share(ranks, surface.triangles);
  surface.points.clear();
  for (const std::array<double, 3>& x : points) surface.points.emplace_back(x.data());
}

/// A surface that intersects itself has no unique interior there, and its mass is counted twice.
void note_crossings(NamedSurface& named) {
  const geometry::SelfCrossings crossings = geometry::self_crossings(geometry::build_slab_tree(named.surface));
  if (crossings.count == 0) return;
  named.notes.push_back(
      fmt::format("warning: {}: {} pairs of triangles intersect or touch each other, the first {} and {}: mass is "
                  "counted twice where the surface overlaps itself, and bounds are not proven there",
                  named.name, crossings.count, crossings.first_a + 1, crossings.first_b + 1));
}

NamedSurface closed_surface_of(const std::string& path, double merge) {
  NamedSurface named{.name = as_utf8(path), .surface = {}, .notes = {}};
  const io::SurfaceFile file = io::read_surface(path);
  const double tolerance = merge >= 0 ? merge : geometry::default_tolerance(file.surface, file.single_precision);
  geometry::MergedSurface merged = geometry::merge_points(file.surface, tolerance);
  if (merged.merged_points > 0)
    named.notes.push_back(fmt::format("{}: {} points merged with others within {:.3g}, the largest distance {:.3g}{}",
                                      path, merged.merged_points, tolerance, merged.largest_distance,
                                      merged.dropped_triangles > 0
                                          ? fmt::format("; {} triangles without area removed", merged.dropped_triangles)
                                          : ""));
  if (const std::int64_t flips = geometry::flip_slivers(merged.surface, tolerance); flips > 0)
    named.notes.push_back(
        fmt::format("{}: {} triangle{} without area, or no higher than {:.3g}, joined with neighbours", path, flips,
                    flips == 1 ? "" : "s", tolerance));
  const geometry::SurfaceFaults faults = geometry::check_closed(merged.surface);
  if (!faults.sound()) throw InputError(geometry::describe(faults, merged.surface, path));
  named.surface = std::move(merged.surface);
  note_crossings(named);
  return named;
}

std::vector<std::vector<Vec3>> pieces_of(const YAML::Node& node, const std::string& where) {
  std::vector<std::vector<Vec3>> pieces;
  if (!node) return pieces;
  const auto fault = [&](const std::string& what) {
    return InputError(where + ": " + what + "; expected a list of pieces, each a list of 4 or more points [x, y, z]");
  };
  if (!node.IsSequence()) throw fault("invalid list of pieces");
  for (std::size_t k = 0; k < node.size(); ++k) {
    if (!node[k].IsSequence() || node[k].size() < 4) throw fault(fmt::format("invalid piece {}", k + 1));
    std::vector<Vec3>& piece = pieces.emplace_back();
    for (const YAML::Node& point : node[k]) {
      if (!point.IsSequence() || point.size() != 3) throw fault(fmt::format("invalid point in piece {}", k + 1));
      for (int c = 0; c < 3; ++c) {
        double value = 0;
        if (!YAML::convert<double>::decode(point[c], value) || !std::isfinite(value))
          throw fault(fmt::format("invalid number in piece {}", k + 1));
        if (c == 0) piece.emplace_back(Vec3::Zero());
        piece.back()[c] = value;
      }
    }
  }
  return pieces;
}

}  // namespace

depth::Metric metric_named(const std::string& name) {
  if (name == "translation") return depth::Metric::translation;
  return name == "object_norm" ? depth::Metric::object_norm : depth::Metric::displacement;
}

const char* name_of(depth::Metric metric) {
  if (metric == depth::Metric::translation) return "translation";
  return metric == depth::Metric::object_norm ? "object_norm" : "displacement";
}

NamedSurface read_closed_surface(const comm::Communicator& ranks, const std::string& path, double merge) {
  NamedSurface named{.name = as_utf8(path), .surface = {}, .notes = {}};
  on_root(ranks, [&] { named = closed_surface_of(path, merge); });
  share(ranks, named.surface);
  return named;
}

std::vector<NamedSurface> surfaces_of_scene(const comm::Communicator& ranks, const scene::Input& input) {
  std::vector<NamedSurface> surfaces;
  on_root(ranks, [&] {
    std::vector<std::string> warnings;
    const mesh::CanonicalMesh whole = whole_mesh(input, warnings);
    const std::vector<std::size_t> part_of = scene::parts_of_blocks(input, whole.mesh);
    for (std::size_t b = 0; b < whole.mesh.blocks.size(); ++b) {
      NamedSurface named{.name = input.parts[part_of[b]].name, .surface = {}, .notes = {}};
      named.surface = outer_surface(whole.mesh, b);
      const geometry::SurfaceFaults faults = geometry::check_closed(named.surface);
      if (!faults.sound()) throw InputError(geometry::describe(faults, named.surface, "part '" + named.name + "'"));
      note_crossings(named);
      surfaces.push_back(std::move(named));
    }
  });
  const auto count = static_cast<std::size_t>(ranks.max(static_cast<GlobalIndex>(surfaces.size())));
  surfaces.resize(count);
  for (NamedSurface& named : surfaces) {
    ranks.broadcast(named.name);
    share(ranks, named.surface);
  }
  return surfaces;
}

ConvexPieces read_pieces(const std::string& path) {
  YAML::Node tree;
  try {
    tree = YAML::Load(io::plain_text(io::read_text(path), path));
  } catch (const YAML::Exception& error) {
    throw InputError(fmt::format("{}:{}: invalid YAML: {}; expected {{a: [pieces], b: [pieces]}}", path,
                                 error.mark.line + 1, error.msg));
  }
  if (!tree.IsMap()) throw InputError(path + ": invalid pieces; expected {a: [pieces], b: [pieces]}");
  for (const auto& entry : tree)
    if (const auto key = entry.first.as<std::string>(""); key != "a" && key != "b")
      throw InputError(fmt::format("{}: unknown key '{}'; expected a or b", path, excerpt(key)));
  return {pieces_of(tree["a"], path + ": a"), pieces_of(tree["b"], path + ": b")};
}

}  // namespace brunt::app
