// SPDX-License-Identifier: Apache-2.0
#include "contact/mortar_rows/tie_covers.hpp"

#include <algorithm>
#include <cmath>

#include "contact/data/tolerances.hpp"
#include "contact/mortar/fine_segment.hpp"
#include "geometry/closest_point.hpp"

namespace brunt::contact {
namespace {

using Matrix4 = std::array<std::array<double, 4>, 4>;

/// Segments of one body on a facet.
struct Collected {
  std::vector<LocalIndex> faces;
  std::vector<SegmentIntegrals> integrals;
  double area = 0, inclined = 0;  ///< inclined: of faces that are not in `faces` [length^2]

  void clear() {
    faces.clear();
    integrals.clear();
    area = inclined = 0;
  }
};

double reach_of(const Tolerances& tolerances, std::span<const Vec3> corners, double element_depth) {
  return tolerances.max_penetration(geometry::longest_edge(corners), element_depth);
}

void collect(const MortarScene& scene, const SlavePlane& plane, double reach, LocalIndex index, Collected& found) {
  const MasterFace& face = nth(scene.faces, index);
  const CornersNow corners(face, scene.motion);
  const double facing = -geometry::area_vector(corners.span()).normalized().dot(plane.normal);
  const double capture = std::min(reach, reach_of(scene.tolerances, corners.span(), face.element_depth));
  SegmentIntegrals integrals;
  if (!(facing >= scene.tolerances.facing) || !integrate_finely(plane, corners.span(), capture, integrals)) return;
  if (facing < tie_numbers.smooth) {
    found.inclined += integrals.area;
    return;
  }
  found.area += integrals.area;
  found.faces.push_back(index);
  found.integrals.push_back(integrals);
}

bool is_smooth(const SlavePlane& plane, const Collected& found) {
  return found.area > 0 && found.inclined <= tie_numbers.inclined * (found.area + found.inclined) &&
         found.area <= (1 + tie_numbers.folded) * plane.area();
}

/// int psi_j N_c of a segment.
Matrix4 weights_of(const MultiplierFunctions& functions, const SegmentIntegrals& segment) {
  Matrix4 weight{};
  for (std::size_t j = 0; j < static_cast<std::size_t>(functions.corners); ++j)
    for (std::size_t c = 0; c < 4; ++c) weight[j][c] = functions.master_weight(j, c, segment);
  return weight;
}

/// Of functions, relative to their areas.
double largest_weight(const MultiplierFunctions& functions) {
  double most = 0;
  for (std::size_t j = 0; j < static_cast<std::size_t>(functions.corners); ++j)
    for (std::size_t k = 0; k < static_cast<std::size_t>(functions.corners); ++k)
      if (functions.share[j] > 0) most = std::max(most, std::abs(functions.slave_weight(j, k)) / functions.share[j]);
  return most;
}

void append_cover(const MortarScene& scene, LocalIndex facet, const SlavePlane& plane, const Collected& found,
                  TieCovers& covers) {
  MultiplierFunctions functions = multiplier_functions(plane, found.integrals, Multiplier::dual);
  if (functions.form == MultiplierFunctions::Form::none) return;
  if (!(largest_weight(functions) <= kept_numbers.weight))
    functions = multiplier_functions(plane, found.integrals, Multiplier::standard);
  TieCover cover{.facet = facet,
                 .body = nth(scene.faces, found.faces.front()).body,
                 .block = nth(scene.faces, found.faces.front()).block,
                 .whole = !(functions.dual_share < 1),
                 .normal = plane.normal,
                 .share = functions.share,
                 .mass = functions.mass,
                 .first = covers.segments.size()};
  for (std::size_t j = 0; j < static_cast<std::size_t>(functions.corners); ++j)
    for (std::size_t k = 0; k < static_cast<std::size_t>(functions.corners); ++k)
      cover.own[j][k] = functions.slave_weight(j, k);
  for (std::size_t s = 0; s < found.faces.size(); ++s) {
    cover.block = std::min(cover.block, nth(scene.faces, found.faces[s]).block);
    covers.segments.push_back({found.faces[s], weights_of(functions, found.integrals[s])});
  }
  cover.end = covers.segments.size();
  covers.covers.push_back(cover);
}

void find_on_facet(const MortarScene& scene, LocalIndex facet, Collected& found, TieCovers& covers) {
  const MortarFacet& slave = nth(scene.candidates.facets, facet);
  const CornersNow corners(slave, scene.motion);
  SlavePlane plane;
  if (!make_slave_plane(corners.span(), plane)) return;
  const double reach = reach_of(scene.tolerances, corners.span(), slave.element_depth);
  const std::span<const LocalIndex> masters = scene.candidates.masters.row(facet);
  found.clear();
  for (std::size_t m = 0; m < masters.size(); ++m) {
    collect(scene, plane, reach, masters[m], found);
    if (m + 1 < masters.size() && nth(scene.faces, masters[m + 1]).body == nth(scene.faces, masters[m]).body) continue;
    if (is_smooth(plane, found)) append_cover(scene, facet, plane, found, covers);
    found.clear();
  }
}

std::size_t corner_of(const MortarFacet& facet, LocalIndex node) {
  return static_cast<std::size_t>(std::ranges::find(facet.nodes, node) - facet.nodes.begin());
}

/// Which corners keep their functions: at least one does.
std::array<bool, 4> corners_kept(const MortarScene& scene, std::span<const Vec3> sides, const TieCover& cover) {
  const MortarFacet& facet = nth(scene.candidates.facets, cover.facet);
  const double most = *std::ranges::max_element(cover.share);
  std::array<bool, 4> large{}, kept{};
  bool any = false;
  for (std::size_t j = 0; j < static_cast<std::size_t>(facet.corner_count); ++j) {
    large[j] = cover.whole || cover.share[j] >= tie_numbers.share * most;
    kept[j] = large[j] && nth(sides, facet.nodes[j]).dot(cover.normal) >= scene.tolerances.facing;
    any = any || kept[j];
  }
  return any ? kept : large;
}

/// The function of corner d to those that are kept, by what they share of it.
void give_away(std::size_t d, const std::array<bool, 4>& kept, TieCover& cover, std::span<TieSegment> segments) {
  double total = 0;
  for (std::size_t j = 0; j < 4; ++j)
    if (kept[j]) total += cover.mass[d][j];
  for (std::size_t j = 0; j < 4; ++j) {
    if (!kept[j]) continue;
    const double part = cover.mass[d][j] / total;
    cover.share[j] += part * cover.share[d];
    for (std::size_t k = 0; k < 4; ++k) cover.own[j][k] += part * cover.own[d][k];
    for (TieSegment& segment : segments)
      for (std::size_t c = 0; c < 4; ++c) segment.weight[j][c] += part * segment.weight[d][c];
  }
}

}  // namespace

TieCovers find_tie_covers(const MortarScene& scene) {
  TieCovers covers;
  Collected found;
  for (std::size_t facet = 0; facet < scene.candidates.facets.size(); ++facet) {
    covers.first.push_back(covers.covers.size());
    find_on_facet(scene, static_cast<LocalIndex>(facet), found, covers);
  }
  covers.first.push_back(covers.covers.size());
  return covers;
}

std::vector<Vec3> tied_sides(const MortarScene& scene, const TieCovers& covers) {
  struct Side {
    Vec3 normal;
    double area;
  };
  std::vector<Vec3> sides(scene.gid.size(), Vec3::Zero());
  std::vector<Side> of_node;
  for (std::size_t s = 0; s < scene.candidates.slave.size(); ++s) {
    const LocalIndex node = scene.candidates.slave[s];
    of_node.clear();
    for (const LocalIndex facet : scene.candidates.around.row(static_cast<LocalIndex>(s)))
      for (const TieCover& cover : covers.of(facet)) {
        const double area = cover.share[corner_of(nth(scene.candidates.facets, facet), node)];
        const auto same = std::ranges::find_if(
            of_node, [&](const Side& side) { return side.normal.dot(cover.normal) >= scene.tolerances.facing; });
        if (same == of_node.end())
          of_node.push_back({cover.normal, area});
        else
          same->area += area;
      }
    const auto most = std::ranges::max_element(of_node, {}, &Side::area);
    if (most != of_node.end()) nth(sides, node) = most->normal;
  }
  return sides;
}

void settle_functions(const MortarScene& scene, std::span<const Vec3> sides, TieCovers& covers) {
  for (TieCover& cover : covers.covers) {
    const std::array<bool, 4> kept = corners_kept(scene, sides, cover);
    const std::span<TieSegment> segments = std::span(covers.segments).subspan(cover.first, cover.end - cover.first);
    const auto corners = static_cast<std::size_t>(nth(scene.candidates.facets, cover.facet).corner_count);
    for (std::size_t d = 0; d < corners; ++d)
      if (!kept[d]) give_away(d, kept, cover, segments);
    for (std::size_t d = 0; d < corners; ++d)
      if (!kept[d]) cover.share[d] = 0;
  }
}

}  // namespace brunt::contact
