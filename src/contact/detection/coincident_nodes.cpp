// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/detection/coincident_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "brunt/contact/data/tolerances.hpp"
#include "brunt/contact/detection/detection.hpp"

namespace brunt::contact {
namespace {

std::span<const LocalIndex> corners_of(const MasterFace& face) {
  return {face.nodes.data(), static_cast<std::size_t>(face.corner_count)};
}

Vec3 area_of(const FacesInMotion& scene, const MasterFace& face) {
  std::array<Vec3, 4> corners;
  const auto count = static_cast<std::size_t>(face.corner_count);
  for (std::size_t i = 0; i < count; ++i) corners[i] = scene.motion[static_cast<std::size_t>(face.nodes[i])].position;
  return geometry::area_vector({corners.data(), count});
}

bool has_corner(const MasterFace& face, LocalIndex node) {
  return std::ranges::find(corners_of(face), node) != corners_of(face).end();
}

/// Cosine between the normal and the reversed one of a facet [-1, 1].
double facing(const NodeOnSurface& node, LocalIndex facet, const Vec3& normal) {
  const double cosine = -node.facet_normal[static_cast<std::size_t>(facet)].dot(normal);
  return node.two_sided ? std::abs(cosine) : cosine;
}

/// Faces around a node [unit normals, length].
struct Around {
  Vec3 normals = Vec3::Zero(), corners = Vec3::Zero();  ///< sums: of normals, of corners from the node
  Vec3 first = Vec3::Zero(), rim = Vec3::Zero();        ///< a normal; the direction of a rim, once another one differs
  int count = 0;
  bool end_a_rim = false;  ///< a third one is not in the plane across it: a corner, not a place on a rim

  void add(const Vec3& normal, const Tolerances& tolerances) {
    normals += normal;
    if (++count == 1) first = normal;
    const double across = std::sqrt(1 - tolerances.aligned * tolerances.aligned);  // sine of the same angle
    if (!rim.isZero(0))
      end_a_rim = end_a_rim || std::abs(rim.dot(normal)) > across;
    else if (first.dot(normal) < tolerances.aligned)
      rim = first.cross(normal).normalized();
  }
  [[nodiscard]] bool are_sharp(const Tolerances& tolerances) const {
    return normals.norm() < tolerances.aligned * count && corners.dot(normals) < 0;
  }
};

/// Is the node itself on a rim or corner? The faces around it then look in different directions.
bool is_sharp(const NodeOnSurface& node, const Tolerances& tolerances) {
  Vec3 normals = Vec3::Zero();
  for (const LocalIndex facet : node.facets) normals += node.facet_normal[static_cast<std::size_t>(facet)];
  return normals.norm() < tolerances.aligned * static_cast<double>(node.facets.size());
}

/// Are both surfaces flat there and on each other, as around nearly all coincident nodes? What is said to be so here
/// the thorough look below finds too: every face lies on the first facet, and every facet on the first face.
bool surfaces_coincide(const FacesInMotion& scene, const NodeOnSurface& node, std::span<const LocalIndex> near,
                       LocalIndex other, const Tolerances& tolerances) {
  const double clearly = tolerances.aligned * tolerances.aligned;
  const auto faces_each_other = [&](LocalIndex facet, const Vec3& area) {
    const double along = -node.facet_normal[static_cast<std::size_t>(facet)].dot(area);
    return (along > 0 || node.two_sided) && along * along > clearly * area.squaredNorm();
  };
  auto facets = node.facets;  // for the first face all, for the others the first
  for (const LocalIndex f : near) {
    const MasterFace& face = scene.faces[static_cast<std::size_t>(f)];
    if (!has_corner(face, other)) continue;
    const Vec3 area = area_of(scene, face);
    if (!std::ranges::all_of(facets, [&](LocalIndex facet) { return faces_each_other(facet, area); })) return false;
    facets = facets.first(std::min<std::size_t>(1, facets.size()));
  }
  return !node.facets.empty();
}

/// Does one row hold the node and `other`, a corner of some of the faces?
bool are_held_together(const FacesInMotion& scene, const NodeOnSurface& node, std::span<const LocalIndex> near,
                       LocalIndex other, const Tolerances& tolerances) {
  constexpr std::size_t most = 32;  // facets of a node; of more the rest is not asked
  std::array<double, most> facet_lies{};
  const std::size_t facets = std::min(most, node.facets.size());
  Around around;
  bool fit = true;
  for (const LocalIndex f : near) {
    const MasterFace& face = scene.faces[static_cast<std::size_t>(f)];
    if (!has_corner(face, other)) continue;
    const Vec3 normal = area_of(scene, face).normalized();
    around.add(normal, tolerances);
    for (const LocalIndex corner : corners_of(face))
      around.corners += scene.motion[static_cast<std::size_t>(corner)].position - node.motion.position;
    double face_lies = 0;
    for (std::size_t i = 0; i < facets; ++i) {
      const double cosine = facing(node, node.facets[i], normal);
      face_lies = std::max(face_lies, cosine);
      facet_lies[i] = std::max(facet_lies[i], cosine);
    }
    fit = fit && (face_lies <= tolerances.facing || face_lies >= tolerances.aligned);
  }
  fit = fit && std::none_of(facet_lies.begin(), facet_lies.end(),
                            [&](double cosine) { return cosine > tolerances.facing && cosine < tolerances.aligned; });
  // A sharp corner on a flat surface is held as the slave of that surface, and one row holds two corners. Where a sharp
  // node stands on a rim, the row of either alone lets the other slide off its ridge.
  return fit || (around.are_sharp(tolerances) && (around.end_a_rim || !is_sharp(node, tolerances)));
}

}  // namespace

bool is_held_by_coincident_node(const FacesInMotion& scene, const NodeOnSurface& node, std::span<const LocalIndex> near,
                                std::span<const CoincidentCandidate> possible, double distance,
                                const Tolerances& tolerances) {
  if (node.facets.empty()) return false;  // a mass point: the other node has no face of it to meet
  const std::int32_t body = scene.faces[static_cast<std::size_t>(near.front())].body;
  for (const CoincidentCandidate& other : possible) {
    const Vec3& there = scene.motion[static_cast<std::size_t>(other.node)].position;
    if (other.body == body && (there - node.motion.position).squaredNorm() < distance * distance)
      return surfaces_coincide(scene, node, near, other.node, tolerances) ||
             are_held_together(scene, node, near, other.node, tolerances);
  }
  return false;
}

void list_coincident_nodes(std::span<const MasterFace> faces, std::span<const Vec3> positions, double motion,
                           const DetectionSettings& settings, Candidates& candidates) {
  candidates.coincident.clear();
  if (candidates.second.empty()) return;
  const double within = (settings.coincidence_distance + 2 * motion) *
                        (1 + settings.tolerances->rounding);  // what is later measured is rounded otherwise
  const auto place = [&](LocalIndex node) -> const Vec3& { return positions[static_cast<std::size_t>(node)]; };
  for (LocalIndex s = 0; s < candidates.faces.rows(); ++s) {
    const std::span<const LocalIndex> near = std::as_const(candidates.faces).row(s);
    const char* second = candidates.second.data() + (near.data() - candidates.faces.values.data());
    const auto known = [&, first = candidates.coincident.values.size()](LocalIndex node) {
      return std::ranges::any_of(std::span(candidates.coincident.values).subspan(first),
                                 [&](const CoincidentCandidate& other) { return other.node == node; });
    };
    for (std::size_t i = 0; i < near.size(); ++i) {
      if (second[i] == 0) continue;
      const MasterFace& face = faces[static_cast<std::size_t>(near[i])];
      for (std::size_t c = 0; c < static_cast<std::size_t>(face.corner_count); ++c) {
        const LocalIndex node = face.nodes[c];
        if ((place(node) - place(candidates.slave[static_cast<std::size_t>(s)])).norm() < within && !known(node))
          candidates.coincident.values.push_back({node, face.body});
      }
    }
    candidates.coincident.close_row();
  }
}

}  // namespace brunt::contact
