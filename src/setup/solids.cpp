// SPDX-License-Identifier: Apache-2.0
#include "setup/solids.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <utility>

#include "contact/data/tolerances.hpp"
#include "contact/search/search.hpp"
#include "core/cells.hpp"
#include "geometry/segment_in_cell.hpp"
#include "mesh/topology.hpp"

namespace brunt::setup {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

SolidFace face_of(const mesh::Mesh& mesh, const mesh::Side& side) {
  const mesh::Block& block = nth(mesh.blocks, side.block);
  const LocalIndex* element = block.element(side.element);
  SolidFace face;
  face.element = side.element;
  face.nodes = mesh::face_nodes(block.shape, element, side.face);
  Vec3 centre = Vec3::Zero();
  for (const LocalIndex node : face.nodes) {
    if (node == no_index) continue;
    face.corners[face.corner_count++] = nth(mesh.coordinates, node);
    centre += face.corners[face.corner_count - 1];
  }
  if (face.corner_count < 3) return face;
  centre /= static_cast<double>(face.corner_count);
  face.size = geometry::longest_edge(face.points());
  const Vec3 inwards = -geometry::area_vector(face.points()).normalized();
  for (int c = 0; c < mesh::nodes_per_element(block.shape); ++c)
    face.element_depth = std::max(face.element_depth, (nth(mesh.coordinates, element[c]) - centre).dot(inwards));
  face.element_depth = std::min(face.element_depth, geometry::width(face.points()));
  return face;
}

void collect_nodes(Solid& solid) {
  std::vector<std::pair<LocalIndex, std::size_t>> uses;
  for (std::size_t f = 0; f < solid.faces.size(); ++f) {
    const SolidFace& face = solid.faces[f];
    for (std::size_t i = 0; i < face.corner_count; ++i) {
      const LocalIndex node = face.nodes[i], next = face.nodes[(i + 1) % face.corner_count];
      uses.emplace_back(node, f);
      solid.edges.push_back({std::min(node, next), std::max(node, next)});
    }
  }
  std::ranges::sort(uses);
  for (std::size_t k = 0; k < uses.size(); ++k) {
    if (k == 0 || uses[k].first != uses[k - 1].first) {
      if (k > 0) solid.outwards.close_row();
      solid.surface_nodes.push_back(uses[k].first);
    }
    solid.outwards.values.push_back(geometry::area_vector(solid.faces[uses[k].second].points()).normalized());
  }
  if (!uses.empty()) solid.outwards.close_row();
  std::ranges::sort(solid.edges);
  solid.edges.erase(std::unique(solid.edges.begin(), solid.edges.end()), solid.edges.end());
}

/// Cosine between the face's normal and the reversed normal of the most nearly opposite face of its own body.
double opposition(std::span<const Vec3> outwards, const Vec3& normal) {
  double least = 1;
  for (const Vec3& own : outwards) least = std::min(least, own.dot(normal));
  return -least;
}

}  // namespace

geometry::Box box_of_element(const mesh::Mesh& mesh, const mesh::Block& block, LocalIndex e) {
  geometry::Box box;
  for (int c = 0; c < mesh::nodes_per_element(block.shape); ++c)
    geometry::extend(box, nth(mesh.coordinates, block.element(e)[c]));
  return box;
}

bool in_element(const Vec3& x, const mesh::Mesh& mesh, const mesh::Block& block, LocalIndex e,
                const contact::Tolerances& tolerances) {
  std::array<Vec3, cells::most_corners> corners;
  const auto count = static_cast<std::size_t>(mesh::nodes_per_element(block.shape));
  for (std::size_t c = 0; c < count; ++c) corners[c] = nth(mesh.coordinates, block.element(e)[c]);
  return !geometry::part_in_cell({x, x}, {corners.data(), count}, tolerances.fine_rounding).is_empty();
}

std::vector<Solid> solids_of(const mesh::Mesh& mesh) {
  std::vector<Solid> solids(mesh.blocks.size());
  for (const mesh::Side& side : mesh::exterior_sides(mesh)) {
    const SolidFace face = face_of(mesh, side);
    if (face.corner_count < 3) continue;
    Solid& solid = nth(solids, side.block);
    for (const Vec3& corner : face.points()) geometry::extend(solid.box, corner);
    solid.faces.push_back(face);
  }
  for (Solid& solid : solids) collect_nodes(solid);
  return solids;
}

std::vector<std::int32_t> body_of_nodes(const mesh::Mesh& mesh) {
  const std::vector<std::int32_t> body = mesh::bodies(mesh);
  std::vector<std::int32_t> of_node(mesh.coordinates.size(), no_index);
  std::size_t element = 0;
  for (const mesh::Block& block : mesh.blocks)
    for (LocalIndex e = 0; e < block.count(); ++e, ++element)
      for (int c = 0; c < mesh::nodes_per_element(block.shape); ++c) nth(of_node, block.element(e)[c]) = body[element];
  return of_node;
}

NodesAround::NodesAround(const mesh::Mesh& mesh) : mesh_(mesh) {
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const mesh::Block& block = mesh.blocks[b];
    for (LocalIndex e = 0; e < block.count(); ++e)
      for (int c = 0; c < mesh::nodes_per_element(block.shape); ++c)
        uses_.push_back({block.element(e)[c], static_cast<LocalIndex>(b), e});
  }
  std::ranges::sort(uses_);
}

std::vector<LocalIndex> NodesAround::of(LocalIndex node) const {
  std::vector<LocalIndex> nodes;
  for (auto use = std::ranges::lower_bound(uses_, node, {}, &Use::node); use != uses_.end() && use->node == node;
       ++use) {
    const mesh::Block& block = nth(mesh_.blocks, use->block);
    const LocalIndex* element = block.element(use->element);
    nodes.insert(nodes.end(), element, element + mesh::nodes_per_element(block.shape));
  }
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

Comparison::Comparison(const mesh::Mesh& mesh, const Solid& nodes, const Solid& solid, const mesh::Block& block,
                       const NodesAround* around, const contact::Tolerances& tolerances)
    : nodes_(nodes), solid_(solid), block_(block), around_(around), tolerances_(tolerances) {
  double longest = 0;
  for (const SolidFace& face : solid.faces) longest = std::max(longest, face.size);
  const geometry::Box reach = geometry::grown(solid.box, longest);
  for (std::size_t i = 0; i < nodes.surface_nodes.size(); ++i)
    if (const Vec3& x = nth(mesh.coordinates, nodes.surface_nodes[i]); geometry::contains(reach, x)) {
      node_.push_back(i);
      point_.push_back(x);
    }
  if (!node_.empty()) find_inside(mesh);
  if (around_) keep_inside_only();
  near_.assign(node_.size(), infinity);
  touches_.assign(node_.size(), Touch::none);
  if (node_.empty()) return;
  measure_near();
  for (std::size_t i = 0; i < node_.size(); ++i)
    if (touches_[i] == Touch::side && inside_[i] && is_deep(i)) touches_[i] = Touch::none;
}

void Comparison::keep_inside_only() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < node_.size(); ++i) {
    if (!inside_[i]) continue;
    node_[kept] = node_[i];
    point_[kept++] = point_[i];
  }
  node_.resize(kept);
  point_.resize(kept);
  inside_.assign(kept, 1);
}

bool Comparison::is_neighbour(std::size_t i, LocalIndex element) const {
  if (!around_) return false;
  const LocalIndex* nodes = block_.element(element);
  const std::vector<LocalIndex> around = around_->of(node(i));
  return std::any_of(nodes, nodes + mesh::nodes_per_element(block_.shape),
                     [&](LocalIndex node) { return std::ranges::binary_search(around, node); });
}

void Comparison::judge(std::size_t i, std::size_t f, Nearest& nearest) const {
  const SolidFace& face = solid_.faces[f];
  const auto closest = geometry::closest_point(point_[i], face.points());
  if (!closest || is_neighbour(i, face.element)) return;
  const Vec3 offset = point_[i] - closest->point;
  const double distance = offset.norm();
  const bool nearer = !nearest.all || distance < nearest.all_distance;
  if (!nearer && nearest.opposed && distance >= nearest.opposed_distance) return;
  const Vec3 normal = geometry::face_normal(face.points(), closest->xi, closest->eta);
  const double below = -offset.dot(normal);
  const bool in_front = below < 0 && closest->region == geometry::Region::face;
  const Behind here{f, in_front || below > 0 ? below : distance, normal, closest->weights};
  if (nearer) {
    nearest.all = here;
    nearest.all_distance = distance;
  }
  if (in_front) return;
  if (!is_opposed(i, normal)) return;
  if (nearest.opposed && distance >= nearest.opposed_distance) return;
  nearest.opposed = here;
  nearest.opposed_distance = distance;
}

bool Comparison::is_opposed(std::size_t i, const Vec3& normal) const {
  return opposition(nodes_.outwards.row(static_cast<LocalIndex>(node_[i])), normal) >= tolerances_.facing;
}

Comparison::Nearest Comparison::nearest_near(std::size_t i) const {
  Nearest nearest;
  for (const LocalIndex f : near_faces_.row(static_cast<LocalIndex>(i))) judge(i, static_cast<std::size_t>(f), nearest);
  return nearest;
}

std::optional<Behind> Comparison::behind_near(std::size_t i) const {
  return nearest_near(i).chosen(solid_, tolerances_.touching);
}

bool Comparison::is_deep(std::size_t i) const {
  const std::optional<Behind> behind = nearest_near(i).opposed;
  return behind && behind->penetration > tolerances_.touching * solid_.faces[behind->face].size;
}

std::optional<Behind> Comparison::behind_any(std::size_t i) const {
  Nearest nearest;
  for (std::size_t f = 0; f < solid_.faces.size(); ++f) judge(i, f, nearest);
  return nearest.opposed ? nearest.chosen(solid_, tolerances_.touching) : nearest.all;
}

void Comparison::measure_near() {
  std::vector<geometry::Box> boxes;
  for (const SolidFace& face : solid_.faces)
    boxes.push_back(geometry::grown(geometry::bounding_box(face.points()), face.size));
  contact::SearchScratch scratch;
  contact::find_pairs(boxes, point_, scratch, near_faces_);
  for (std::size_t i = 0; i < point_.size(); ++i)
    for (const LocalIndex f : std::as_const(near_faces_).row(static_cast<LocalIndex>(i))) {
      const SolidFace& face = nth(solid_.faces, f);
      const auto closest = geometry::closest_point(point_[i], face.points());
      if (!closest || is_neighbour(i, face.element)) continue;
      const Vec3 offset = point_[i] - closest->point;
      near_[i] = std::min(near_[i], offset.norm());
      if (offset.norm() > tolerances_.touching * face.size) continue;
      const bool faces_it = is_opposed(i, geometry::face_normal(face.points(), closest->xi, closest->eta));
      touches_[i] = std::max(touches_[i], faces_it ? Touch::face : Touch::side);
    }
}

void Comparison::find_inside(const mesh::Mesh& mesh) {
  inside_.assign(node_.size(), 0);
  std::vector<geometry::Box> boxes;
  boxes.reserve(static_cast<std::size_t>(block_.count()));
  for (LocalIndex e = 0; e < block_.count(); ++e) boxes.push_back(box_of_element(mesh, block_, e));
  contact::SearchScratch scratch;
  Ragged<LocalIndex> pairs;
  contact::find_pairs(boxes, point_, scratch, pairs);
  for (std::size_t i = 0; i < point_.size(); ++i)
    for (const LocalIndex e : std::as_const(pairs).row(static_cast<LocalIndex>(i)))
      if (!inside_[i] && in_element(point_[i], mesh, block_, e, tolerances_) && !is_neighbour(i, e)) inside_[i] = 1;
}

}  // namespace brunt::setup
