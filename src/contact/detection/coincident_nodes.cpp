// SPDX-License-Identifier: Apache-2.0
#include "contact/detection/coincident_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/data/tolerances.hpp"
#include "contact/detection/detection.hpp"

namespace brunt::contact {
namespace {

std::span<const LocalIndex> corners_of(const MasterFace& face) {
  return {face.nodes.data(), static_cast<std::size_t>(face.corner_count)};
}

Vec3 area_of(const FacesInMotion& scene, const MasterFace& face) {
  std::array<Vec3, 4> corners;
  const auto count = static_cast<std::size_t>(face.corner_count);
  for (std::size_t i = 0; i < count; ++i) corners[i] = scene.corner(face, i).position;
  return geometry::area_vector({corners.data(), count});
}

/// Cosine between the normal and the reversed normal of a facet [-1, 1].
double facing(const NodeOnSurface& node, LocalIndex facet, const Vec3& normal) {
  const double cosine = -nth(node.facet_normal, facet).dot(normal);
  return node.two_sided ? std::abs(cosine) : cosine;
}

constexpr std::size_t most = 32;  // faces around a node that are examined

enum class Shape : char { flat, rim, corner };

/// The unit normals of the faces around a node.
struct Around {
  std::array<Vec3, most> normals;
  std::size_t count = 0;

  void add(const Vec3& normal) {
    if (count < most) normals[count++] = normal;
  }
  [[nodiscard]] bool are_sharp(const Tolerances& tolerances) const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < count; ++i) sum += normals[i];
    return sum.norm() < tolerances.aligned * static_cast<double>(count);
  }
  /// Whether three of the normals are linearly independent.
  [[nodiscard]] bool span_a_corner(const Tolerances& tolerances) const {
    const double across = std::sqrt(1 - tolerances.aligned * tolerances.aligned);  // sine of the same angle
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < i; ++k) {
        if (normals[i].dot(normals[k]) >= tolerances.aligned) continue;
        const Vec3 rim = normals[i].cross(normals[k]);
        for (std::size_t l = 0; l < count; ++l)
          if (std::abs(rim.dot(normals[l])) > across * rim.norm()) return true;
      }
    return false;
  }
  [[nodiscard]] Shape shape(const Tolerances& tolerances) const {
    if (!are_sharp(tolerances)) return Shape::flat;
    return span_a_corner(tolerances) ? Shape::corner : Shape::rim;
  }
};

Shape shape_of(const NodeOnSurface& node, const Tolerances& tolerances) {
  Around around;
  for (const LocalIndex facet : node.facets) around.add(nth(node.facet_normal, facet));
  return around.shape(tolerances);
}

/// Whether both surfaces are flat at the node and lie on each other, as at nearly all coincident nodes: every face lies
/// on the first facet, and every facet on the first face. Sufficient for the general test of rows_to_spare_at, and
/// fast.
bool surfaces_coincide(const FacesInMotion& scene, const NodeOnSurface& node, std::span<const LocalIndex> near,
                       LocalIndex other) {
  const Tolerances& tolerances = scene.tolerances;
  const double clearly = tolerances.aligned * tolerances.aligned;
  const auto faces_each_other = [&](LocalIndex facet, const Vec3& area) {
    const double along = -nth(node.facet_normal, facet).dot(area);
    return (along > 0 || node.two_sided) && along * along > clearly * area.squaredNorm();
  };
  auto facets = node.facets;  // all for the first face, then the first facet only
  for (const LocalIndex f : near) {
    const MasterFace& face = scene.face(f);
    if (!has_node(face, other)) continue;
    const Vec3 area = area_of(scene, face);
    if (!std::ranges::all_of(facets, [&](LocalIndex facet) { return faces_each_other(facet, area); })) return false;
    facets = facets.first(std::min<std::size_t>(1, facets.size()));
  }
  return !node.facets.empty();
}

/// The general case: each pair of a facet and a face either lies on each other or does not face each other; otherwise
/// the shapes of the two surfaces decide.
RowsToSpare rows_to_spare_at(const FacesInMotion& scene, const NodeOnSurface& node, std::span<const LocalIndex> near,
                             LocalIndex other) {
  const Tolerances& tolerances = scene.tolerances;
  std::array<double, most> facing_of_facet{};
  const std::size_t facets = std::min(most, node.facets.size());
  Around around;
  Vec3 corners = Vec3::Zero();  // sum of the vectors from the node to the corners of the faces
  bool fit = true;
  for (const LocalIndex f : near) {
    const MasterFace& face = scene.face(f);
    if (!has_node(face, other)) continue;
    const Vec3 normal = area_of(scene, face).normalized();
    around.add(normal);
    for (const LocalIndex corner : corners_of(face)) corners += scene.node(corner).position - node.motion.position;
    double facing_of_face = 0;
    for (std::size_t i = 0; i < facets; ++i) {
      const double cosine = facing(node, node.facets[i], normal);
      facing_of_face = std::max(facing_of_face, cosine);
      facing_of_facet[i] = std::max(facing_of_facet[i], cosine);
    }
    fit = fit && (facing_of_face <= tolerances.facing || facing_of_face >= tolerances.aligned);
  }
  fit = fit && std::none_of(facing_of_facet.begin(), facing_of_facet.end(),
                            [&](double cosine) { return cosine > tolerances.facing && cosine < tolerances.aligned; });
  if (fit) return {.second = true};
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < around.count; ++i) sum += around.normals[i];
  if (corners.dot(sum) >= 0) return {};  // the faces form a pit
  const Shape there = around.shape(tolerances), here = shape_of(node, tolerances);
  if (there > here) return {.first = true, .second = true};
  return {.second = there == Shape::corner};
}

}  // namespace

RowsToSpare rows_to_spare(const FacesInMotion& scene, const NodeOnSurface& node, std::span<const LocalIndex> near,
                          std::span<const CoincidentCandidate> possible, double distance) {
  if (node.facets.empty()) return {};  // a mass point has no face that the other node could meet
  const std::int32_t body = scene.face(near.front()).body;
  for (const CoincidentCandidate& other : possible) {
    const Vec3& there = scene.node(other.node).position;
    if (other.body != body || (there - node.motion.position).squaredNorm() >= distance * distance) continue;
    if (surfaces_coincide(scene, node, near, other.node)) return {.second = true};
    return rows_to_spare_at(scene, node, near, other.node);
  }
  return {};
}

void list_coincident_nodes(std::span<const MasterFace> faces, std::span<const Vec3> positions, double motion,
                           const DetectionSettings& settings, Candidates& candidates) {
  candidates.coincident.clear();
  if (candidates.pass.empty()) return;
  const double within = (settings.coincidence_distance + 2 * motion) *
                        (1 + settings.tolerances->rounding);  // distances of later steps have other rounding errors
  const auto place = [&](LocalIndex node) -> const Vec3& { return nth(positions, node); };
  for (LocalIndex s = 0; s < candidates.faces.rows(); ++s) {
    const std::span<const LocalIndex> near = std::as_const(candidates.faces).row(s);
    const PairPass* pass = candidates.pass.data() + (near.data() - candidates.faces.values.data());
    const auto known = [&, first = candidates.coincident.values.size()](LocalIndex node) {
      return std::ranges::any_of(std::span(candidates.coincident.values).subspan(first),
                                 [&](const CoincidentCandidate& other) { return other.node == node; });
    };
    for (std::size_t i = 0; i < near.size(); ++i) {
      if (pass[i] == PairPass::only) continue;
      const MasterFace& face = nth(faces, near[i]);
      for (std::size_t c = 0; c < static_cast<std::size_t>(face.corner_count); ++c) {
        const LocalIndex node = face.nodes[c];
        if ((place(node) - place(nth(candidates.slave, s))).norm() < within && !known(node))
          candidates.coincident.values.push_back({node, face.body});
      }
    }
    candidates.coincident.close_row();
  }
}

}  // namespace brunt::contact
