// SPDX-License-Identifier: Apache-2.0
#include "initial_gaps.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <optional>

#include "brunt/contact/search/search.hpp"
#include "brunt/core/error.hpp"
#include "brunt/geometry/box.hpp"
#include "brunt/geometry/closest_point.hpp"
#include "brunt/mesh/topology.hpp"
#include "brunt/scene/build.hpp"
#include "brunt/scene/select.hpp"

namespace brunt::app {
namespace {

constexpr double touching = 1e-4;  // of the longest edge: rounding in mesh files, facets of a curved fit
constexpr double infinity = std::numeric_limits<double>::infinity();

using FaceCorners = std::vector<Vec3>;

/// What of one block takes part in comparisons.
struct Solid {
  std::vector<LocalIndex> surface_nodes;
  std::vector<FaceCorners> faces;
  geometry::Box box;
};

std::vector<Solid> solids_of(const mesh::Mesh& mesh) {
  std::vector<Solid> solids(mesh.blocks.size());
  for (const mesh::Side& side : mesh::exterior_sides(mesh)) {
    const mesh::Block& block = mesh.blocks[static_cast<std::size_t>(side.block)];
    Solid& solid = solids[static_cast<std::size_t>(side.block)];
    FaceCorners corners;
    for (const LocalIndex node : mesh::face_nodes(block.shape, block.element(side.element), side.face)) {
      if (node == no_index) continue;
      corners.push_back(mesh.coordinates[static_cast<std::size_t>(node)]);
      solid.surface_nodes.push_back(node);
      geometry::extend(solid.box, corners.back());
    }
    if (corners.size() >= 3) solid.faces.push_back(std::move(corners));
  }
  for (Solid& solid : solids) {
    std::ranges::sort(solid.surface_nodes);
    solid.surface_nodes.erase(std::unique(solid.surface_nodes.begin(), solid.surface_nodes.end()),
                              solid.surface_nodes.end());
  }
  return solids;
}

double distance(const Vec3& x, const FaceCorners& face) {
  const auto closest = geometry::closest_point(x, face);
  return closest ? (x - closest->point).norm() : infinity;
}

/// Is x in the closed tetrahedron?
bool in_tetrahedron(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto volume = [](const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
    return (q - p).cross(r - p).dot(s - p);
  };
  const double slack = -1e-9 * volume(a, b, c, d);
  return volume(x, b, c, d) >= slack && volume(a, x, c, d) >= slack && volume(a, b, x, d) >= slack &&
         volume(a, b, c, x) >= slack;
}

/// Is x in the closed element? A hexahedron is six tetrahedra around its diagonal 0-6.
bool in_element(const Vec3& x, const mesh::Mesh& mesh, const mesh::Block& block, LocalIndex e) {
  const LocalIndex* nodes = block.element(e);
  const auto corner = [&](int c) -> const Vec3& { return mesh.coordinates[static_cast<std::size_t>(nodes[c])]; };
  if (block.shape == mesh::Shape::tet4) return in_tetrahedron(x, corner(0), corner(1), corner(2), corner(3));
  constexpr int ring[7] = {1, 2, 3, 7, 4, 5, 1};
  for (int k = 0; k < 6; ++k)
    if (in_tetrahedron(x, corner(0), corner(ring[k]), corner(ring[k + 1]), corner(6))) return true;
  return false;
}

/// Surface nodes of one block against the solid of another.
class Comparison {
 public:
  Comparison(const mesh::Mesh& mesh, const Solid& nodes, const Solid& solid, const mesh::Block& block)
      : mesh_(mesh), solid_(solid), block_(block) {
    double longest = 0;
    for (const FaceCorners& face : solid.faces) longest = std::max(longest, geometry::longest_edge(face));
    const geometry::Box reach = geometry::grown(solid.box, longest);
    for (const LocalIndex node : nodes.surface_nodes)
      if (const Vec3& x = mesh.coordinates[static_cast<std::size_t>(node)]; geometry::contains(reach, x)) {
        node_.push_back(node);
        point_.push_back(x);
      }
    measure_near();
    find_inside();
  }

  [[nodiscard]] std::size_t size() const { return node_.size(); }
  [[nodiscard]] LocalIndex node(std::size_t i) const { return node_[i]; }
  [[nodiscard]] bool touches(std::size_t i) const { return touches_[i] != 0; }
  [[nodiscard]] bool overlaps(std::size_t i) const { return inside_[i] != 0 && touches_[i] == 0; }
  /// To the nearest face within its longest edge, else infinite; for nodes inside the solid always right.
  [[nodiscard]] double distance_of(std::size_t i) const {
    if (near_[i] < infinity || inside_[i] == 0) return near_[i];
    double least = infinity;
    for (const FaceCorners& face : solid_.faces) least = std::min(least, distance(point_[i], face));
    return least;
  }

 private:
  void measure_near() {
    near_.assign(node_.size(), infinity);
    touches_.assign(node_.size(), 0);
    std::vector<geometry::Box> boxes;
    for (const FaceCorners& face : solid_.faces)
      boxes.push_back(geometry::grown(geometry::bounding_box(face), geometry::longest_edge(face)));
    contact::SearchScratch scratch;
    Ragged<LocalIndex> pairs;
    contact::find_pairs(boxes, point_, scratch, pairs);
    for (std::size_t i = 0; i < point_.size(); ++i)
      for (const LocalIndex f : pairs.row(static_cast<LocalIndex>(i))) {
        const FaceCorners& face = solid_.faces[static_cast<std::size_t>(f)];
        const double far = distance(point_[i], face);
        near_[i] = std::min(near_[i], far);
        if (far <= touching * geometry::longest_edge(face)) touches_[i] = 1;
      }
  }

  void find_inside() {
    inside_.assign(node_.size(), 0);
    std::vector<geometry::Box> boxes;
    for (LocalIndex e = 0; e < block_.count(); ++e) {
      geometry::Box box;
      for (int c = 0; c < mesh::nodes_per_element(block_.shape); ++c)
        geometry::extend(box, mesh_.coordinates[static_cast<std::size_t>(block_.element(e)[c])]);
      boxes.push_back(box);
    }
    contact::SearchScratch scratch;
    Ragged<LocalIndex> pairs;
    contact::find_pairs(boxes, point_, scratch, pairs);
    for (std::size_t i = 0; i < point_.size(); ++i)
      for (const LocalIndex e : pairs.row(static_cast<LocalIndex>(i)))
        if (!inside_[i] && in_element(point_[i], mesh_, block_, e)) inside_[i] = 1;
  }

  const mesh::Mesh& mesh_;
  const Solid& solid_;
  const mesh::Block& block_;
  std::vector<LocalIndex> node_;
  std::vector<Vec3> point_;
  std::vector<double> near_;
  std::vector<char> touches_, inside_;
};

/// The connected body of each node.
std::vector<std::int32_t> body_of_nodes(const mesh::Mesh& mesh) {
  const std::vector<std::int32_t> body = mesh::bodies(mesh);
  std::vector<std::int32_t> of_node(mesh.coordinates.size(), no_index);
  std::size_t element = 0;
  for (const mesh::Block& block : mesh.blocks)
    for (LocalIndex e = 0; e < block.count(); ++e, ++element)
      for (int c = 0; c < mesh::nodes_per_element(block.shape); ++c)
        of_node[static_cast<std::size_t>(block.element(e)[c])] = body[element];
  return of_node;
}

}  // namespace

InitialGaps initial_gaps(const scene::Input& input, const mesh::Mesh& mesh) {
  InitialGaps gaps;
  if (input.contact.empty() || mesh.blocks.size() < 2) return gaps;
  const std::vector<std::size_t> part_of = scene::parts_of_blocks(input, mesh);
  const std::vector<Solid> solids = solids_of(mesh);
  const std::vector<std::int32_t> body = body_of_nodes(mesh);
  constexpr std::size_t most_examined = 1000;  // a pair of parts; each costs a look at all faces where it is deep
  for (std::size_t a = 0; a < solids.size(); ++a)
    for (std::size_t b = 0; b < solids.size(); ++b) {
      const std::size_t part = part_of[a], other = part_of[b];
      const auto rule = scene::overlap_rule(input, input.parts[part].name, input.parts[other].name);
      if (a == b || !rule) continue;
      const bool allowed = *rule == scene::ContactEntry::InitialOverlap::warn;
      const std::int32_t other_body = body[static_cast<std::size_t>(mesh.blocks[b].element(0)[0])];
      const Comparison compared(mesh, solids[a], solids[b], mesh.blocks[b]);
      std::size_t examined = 0;
      for (std::size_t i = 0; i < compared.size(); ++i) {
        const auto node = static_cast<std::size_t>(compared.node(i));
        if (body[node] == other_body) continue;
        if (compared.overlaps(i)) {
          const double depth = examined++ < most_examined ? compared.distance_of(i) : 0.0;
          gaps.overlaps.push_back({mesh.node_id[node], part, other, depth, allowed});
          continue;
        }
        const double gap = compared.touches(i) ? 0.0 : compared.distance_of(i);
        if (gap < infinity && (gaps.smallest < 0 || gap < gaps.smallest)) {
          gaps.smallest = gap;
          gaps.part = part;
          gaps.other = other;
        }
      }
    }
  std::ranges::sort(gaps.overlaps, [](const InitialOverlap& p, const InitialOverlap& q) {
    return p.depth != q.depth ? p.depth > q.depth : p.node < q.node;
  });
  return gaps;
}

std::vector<std::string> overlap_lines(const scene::Input& input, const InitialGaps& gaps) {
  struct Pair {
    const InitialOverlap* deepest;
    std::size_t nodes;
  };
  std::vector<Pair> pairs;
  for (const InitialOverlap& overlap : gaps.overlaps) {
    const auto same = [&](const Pair& pair) {
      return std::minmax(pair.deepest->part, pair.deepest->other) == std::minmax(overlap.part, overlap.other);
    };
    if (const auto known = std::ranges::find_if(pairs, same); known != pairs.end())
      ++known->nodes;
    else
      pairs.push_back({&overlap, 1});
  }
  std::vector<std::string> lines;
  for (const Pair& pair : pairs) {
    const InitialOverlap& deepest = *pair.deepest;
    lines.push_back(fmt::format("{}: contact: node {} of part '{}' lies {:.4g} inside part '{}' at the start{}",
                                input.file, deepest.node, input.parts[deepest.part].name, deepest.depth,
                                input.parts[deepest.other].name,
                                pair.nodes > 1 ? fmt::format(", the deepest of {} nodes of the two parts that overlap "
                                                             "(brunt check lists them)",
                                                             pair.nodes)
                                               : ""));
  }
  return lines;
}

std::vector<std::string> overlap_list(const scene::Input& input, const InitialGaps& gaps) {
  std::vector<std::string> lines;
  for (const InitialOverlap& overlap : gaps.overlaps)
    lines.push_back(fmt::format("node {:>8} of {:<16} {:.4g} inside {}", overlap.node, input.parts[overlap.part].name,
                                overlap.depth, input.parts[overlap.other].name));
  return lines;
}

void judge_overlaps(const scene::Input& input, const InitialGaps& gaps, std::vector<std::string>& warnings) {
  std::vector<std::string> lines = overlap_lines(input, gaps);
  if (lines.empty()) return;
  if (std::ranges::all_of(gaps.overlaps, &InitialOverlap::only_a_warning)) {
    warnings.insert(warnings.end(), lines.begin(), lines.end());
    return;
  }
  lines.push_back(input.file + ": contact: move the parts apart, or accept the overlap with initial_overlap: warn");
  throw InputError(std::move(lines));
}

}  // namespace brunt::app
