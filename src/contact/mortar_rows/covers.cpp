// SPDX-License-Identifier: Apache-2.0
#include "contact/mortar_rows/covers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/data/tolerances.hpp"
#include "geometry/box.hpp"
#include "geometry/closest_point.hpp"

namespace brunt::contact {
namespace {

/// Largest mean distance of a segment's faces [length].
double capture_of(const MortarScene& scene, const MortarFacet& facet, std::span<const Vec3> corners) {
  return scene.tolerances.max_penetration(geometry::longest_edge(corners), facet.element_depth);
}

geometry::Box box_of(std::span<const Vec3> corners) {
  return geometry::bounding_box(corners);
}

bool look_against(const Vec3& normal, const Vec3& other, const Tolerances& tolerances) {
  return normal.dot(other) <= -std::cos(tolerances.blunt_angle * std::numbers::pi / 180);
}

}  // namespace

void FacetCovers::start(std::size_t facets) {
  near_.assign(facets, Nearness::unknown);
  first_.assign(facets, no_index);
  end_.assign(facets, no_index);
  covers_.clear();
  segments_.clear();
}

FacetCovers::Nearness FacetCovers::nearness_of(const MortarScene& scene, LocalIndex facet) const {
  const MortarFacet& slave = nth(scene.candidates.facets, facet);
  const CornersNow corners(slave, scene.motion);
  const geometry::Box box = geometry::grown(box_of(corners.span()), capture_of(scene, slave, corners.span()));
  SlavePlane plane;
  Nearness nearness = Nearness::far;
  for (const LocalIndex face : scene.candidates.masters.row(facet)) {
    const CornersNow master(nth(scene.faces, face), scene.motion);
    if (!geometry::overlaps(box, box_of(master.span()))) continue;
    if (nearness == Nearness::far && !make_slave_plane(corners.span(), plane)) break;
    nearness = Nearness::near;
    const Vec3 normal = geometry::area_vector(master.span()).normalized();
    if (look_against(normal, plane.normal, scene.tolerances) && may_share_segment(plane, master.span()))
      return Nearness::may_begin;
  }
  return nearness;
}

FacetCovers::Nearness FacetCovers::look(const MortarScene& scene, LocalIndex facet) {
  Nearness& known = nth(near_, facet);
  if (known == Nearness::unknown) known = nearness_of(scene, facet);
  return known;
}

bool FacetCovers::may_begin(const MortarScene& scene, LocalIndex facet) {
  return look(scene, facet) == Nearness::may_begin;
}

std::span<const Cover> FacetCovers::of(const MortarScene& scene, LocalIndex facet) {
  if (nth(first_, facet) == no_index) find(scene, facet);
  const auto first = static_cast<std::size_t>(nth(first_, facet));
  return std::span(covers_).subspan(first, static_cast<std::size_t>(nth(end_, facet)) - first);
}

std::span<const CoverSegment> FacetCovers::segments(const Cover& cover) const {
  return std::span(segments_).subspan(static_cast<std::size_t>(cover.first),
                                      static_cast<std::size_t>(cover.end - cover.first));
}

void FacetCovers::find(const MortarScene& scene, LocalIndex facet) {
  nth(first_, facet) = static_cast<LocalIndex>(covers_.size());
  const MortarFacet& slave = nth(scene.candidates.facets, facet);
  const CornersNow corners(slave, scene.motion);
  SlavePlane plane;
  if (look(scene, facet) != Nearness::far && make_slave_plane(corners.span(), plane)) {
    const double capture = capture_of(scene, slave, corners.span());
    const std::size_t before = covers_.size();
    for (const LocalIndex face : scene.candidates.masters.row(facet)) {
      const std::int32_t body = nth(scene.faces, face).body;
      if (covers_.size() > before && covers_.back().body != body) close_cover(plane);
      add_segment(scene, plane, capture, face);
    }
    if (covers_.size() > before) close_cover(plane);
  }
  nth(end_, facet) = static_cast<LocalIndex>(covers_.size());
}

/// To the cover of its body, which it begins if there is none.
void FacetCovers::add_segment(const MortarScene& scene, const SlavePlane& plane, double capture, LocalIndex face) {
  const MasterFace& master = nth(scene.faces, face);
  const CornersNow corners(master, scene.motion);
  CoverSegment segment{.face = face, .integrals = {}};
  if (!integrate_segment(plane, corners.span(), capture, segment.integrals)) return;
  const Vec3 normal = geometry::area_vector(corners.span()).normalized();
  if (covers_.empty() || covers_.back().end != no_index) {
    covers_.push_back({.body = master.body,
                       .block = master.block,
                       .functions = {},
                       .first = static_cast<LocalIndex>(segments_.size()),
                       .end = no_index});
    first_normal_ = normal;
    integrals_.clear();
  }
  Cover& cover = covers_.back();
  if (!look_against(normal, plane.normal, scene.tolerances) || !look_against(normal, -first_normal_, scene.tolerances))
    cover.smooth = false;
  cover.block = std::min(cover.block, master.block);
  segments_.push_back(segment);
  integrals_.push_back(segment.integrals);
}

void FacetCovers::close_cover(const SlavePlane& plane) {
  Cover& cover = covers_.back();
  if (cover.end != no_index) return;
  cover.end = static_cast<LocalIndex>(segments_.size());
  cover.functions = multiplier_functions(plane, integrals_, Multiplier::dual);
}

}  // namespace brunt::contact
