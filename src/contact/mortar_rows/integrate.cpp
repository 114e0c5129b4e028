// SPDX-License-Identifier: Apache-2.0
#include "contact/mortar_rows/integrate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "contact/data/tolerances.hpp"
#include "geometry/closest_point.hpp"

namespace brunt::contact {
namespace {

/// Adds to the term of this point, which it begins if there is none.
void add_term(LocalIndex point, GlobalIndex id, MortarPart part, double weight, double reach,
              std::vector<LocalIndex>& points, std::vector<MortarTerm>& terms) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i] != point || terms[i].part != part) continue;
    terms[i].weight += weight;
    terms[i].reach += reach;
    return;
  }
  points.push_back(point);
  terms.push_back({id, weight, reach, part});
}

std::size_t corner_of(const MortarFacet& facet, LocalIndex node) {
  return static_cast<std::size_t>(std::ranges::find(facet.nodes, node) - facet.nodes.begin());
}

}  // namespace

Vec3 sum_of_places(std::span<const MortarTerm> terms, std::span<const LocalIndex> places,
                   std::span<const NodeMotion> motion) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < terms.size() && terms[i].part != MortarPart::facet; ++i)
    sum += terms[i].weight * nth(motion, places[i]).position;
  return sum;
}

void NodeIntegration::append(const MortarScene& scene, std::size_t s, FacetCovers& covers,
                             std::span<const MortarHead> before, MortarHistory& after,
                             std::vector<LocalIndex>& places) {
  collect(scene, s, covers, true);
  if (!(largest_weight() <= kept_numbers.weight)) collect(scene, s, covers, false);
  const auto groups = std::span(groups_).first(group_count_);
  std::ranges::stable_sort(groups, {}, &Group::body);
  GlobalIndex number = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (g > 0 && groups[g].body != groups[g - 1].body) number = 0;
    if (is_bent(groups[g].body) || !(groups[g].area > 0)) continue;
    close(scene, nth(scene.candidates.slave, static_cast<LocalIndex>(s)), groups[g], number++, before, after, places);
  }
}

void NodeIntegration::collect(const MortarScene& scene, std::size_t s, FacetCovers& covers, bool dual) {
  group_count_ = 0;
  bent_.clear();
  const LocalIndex node = scene.candidates.slave[s];
  for (const LocalIndex facet : scene.candidates.around.row(static_cast<LocalIndex>(s)))
    for (const Cover& cover : covers.of(scene, facet)) {
      if (!cover.smooth) bent_.push_back(cover.body);
      if (cover.functions.form != MultiplierFunctions::Form::none) add_cover(scene, node, facet, cover, covers, dual);
    }
}

NodeIntegration::Group& NodeIntegration::group_of(std::int32_t body, const Vec3& normal, double facing) {
  for (std::size_t g = 0; g < group_count_; ++g)
    if (groups_[g].body == body && groups_[g].normal.dot(normal) >= facing) return groups_[g];
  if (group_count_ == groups_.size()) groups_.emplace_back();
  Group& group = groups_[group_count_++];
  group.body = body;
  group.block = std::numeric_limits<std::int32_t>::max();
  group.normal = normal;
  group.area = group.size = 0;
  group.whole = true;
  group.points.clear();
  group.facets.clear();
  group.at_points.clear();
  group.at_facets.clear();
  return group;
}

void NodeIntegration::add_cover(const MortarScene& scene, LocalIndex node, LocalIndex facet, const Cover& cover,
                                const FacetCovers& covers, bool dual) {
  const MortarFacet& slave = nth(scene.candidates.facets, facet);
  const CornersNow corners(slave, scene.motion);
  const Vec3 normal = geometry::area_vector(corners.span()).normalized();
  Group& group = group_of(cover.body, normal, scene.tolerances.facing);
  const MultiplierFunctions& functions = cover.functions;
  const std::size_t j = corner_of(slave, node);
  const double area = functions.share[j];
  group.area += area;
  if (functions.dual_share < 1) group.whole = false;
  group.size = std::max(group.size, geometry::longest_edge(corners.span()));
  group.block = std::min(group.block, cover.block);
  for (std::size_t k = 0; k < corners.count; ++k) {
    const double weight = dual ? functions.slave_weight(j, k) : functions.mass[j][k];
    if (weight != 0 || k == j || functions.dual_share < 1)
      add_term(slave.nodes[k], nth(scene.gid, slave.nodes[k]), MortarPart::slave, weight, functions.share[k],
               group.points, group.at_points);
  }
  for (const CoverSegment& segment : covers.segments(cover)) {
    const MasterFace& master = nth(scene.faces, segment.face);
    for (std::size_t c = 0; c < static_cast<std::size_t>(master.corner_count); ++c) {
      const double weight = dual ? functions.master_weight(j, c, segment.integrals) : segment.integrals.master[j][c];
      double reach = 0;
      for (std::size_t a = 0; a < corners.count; ++a) reach += segment.integrals.master[a][c];
      add_term(master.nodes[c], nth(scene.gid, master.nodes[c]), MortarPart::master, -weight, reach, group.points,
               group.at_points);
    }
  }
  group.facets.push_back(facet);
  group.at_facets.push_back({slave.key, area, 0, MortarPart::facet});
}

bool NodeIntegration::is_bent(std::int32_t body) const {
  return std::ranges::find(bent_, body) != bent_.end();
}

/// Of all groups, relative to their areas.
double NodeIntegration::largest_weight() const {
  double most = 0;
  for (std::size_t g = 0; g < group_count_; ++g)
    for (const MortarTerm& term : groups_[g].at_points) most = std::max(most, std::abs(term.weight) / groups_[g].area);
  return most;
}

void NodeIntegration::close(const MortarScene& scene, LocalIndex node, const Group& group, GlobalIndex number,
                            std::span<const MortarHead> before, MortarHistory& after, std::vector<LocalIndex>& places) {
  MortarHead head{
      .key = {.kind = RowKind::mortar, .slave = nth(scene.gid, node), .master = group.body, .master_second = number},
      .block = group.block,
      .area = group.area,
      .size = group.size,
      .whole = group.whole ? 1.0 : 0.0};
  const auto old = std::ranges::find(before, head.key, &MortarHead::key);
  if (old != before.end()) head.slip = old->slip;
  order_.resize(group.points.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::ranges::sort(order_, {}, [&](std::size_t i) {
    const MortarTerm& term = group.at_points[i];
    const int part = term.part == MortarPart::master ? 1 : group.points[i] == node ? 0 : 2;
    return std::tuple(part, term.id);
  });
  std::array<double, 2> reach{};  // of the slave's side and of the master's
  for (const std::size_t i : order_)
    reach[static_cast<std::size_t>(group.at_points[i].part)] += group.at_points[i].reach;
  terms_.clear();
  for (const std::size_t i : order_) {
    MortarTerm term = group.at_points[i];
    term.weight /= group.area;
    term.reach /= reach[static_cast<std::size_t>(term.part)];
    terms_.push_back(term);
    places.push_back(group.points[i]);
  }
  const std::span<const LocalIndex> points = std::span(places).last(terms_.size());
  const Vec3 apart = sum_of_places(terms_, points, scene.motion);
  head.apart = {apart[0], apart[1], apart[2]};
  for (std::size_t f = 0; f < group.facets.size(); ++f) {
    terms_.push_back(group.at_facets[f]);
    terms_.back().weight /= group.area;
    places.push_back(group.facets[f]);
  }
  after.append(head, terms_);
}

}  // namespace brunt::contact
