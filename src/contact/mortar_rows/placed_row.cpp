// SPDX-License-Identifier: Apache-2.0
#include "contact/mortar_rows/placed_row.hpp"

#include <algorithm>

#include "contact/mortar_rows/integrate.hpp"
#include "geometry/moments_across.hpp"

namespace brunt::contact {
namespace {

using geometry::MomentsAcross;

/// Against the normals of the facets, by what is covered of them.
Vec3 against_facets(const KeptRow& row, std::span<const Vec3> facet_normal) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = row.nodes; i < row.terms.size(); ++i)
    sum -= row.terms[i].weight * nth(facet_normal, row.places[i]);
  return sum.normalized();
}

/// The nodes of one side in a row, by what each reaches: their middle and second moments.
struct Spread {
  Vec3 middle = Vec3::Zero();
  Mat3 moments = Mat3::Zero();  ///< [length^2]

  Spread(const KeptRow& row, MortarPart part, std::span<const NodeMotion> motion) {
    const auto place = [&](std::size_t i) -> const Vec3& { return nth(motion, row.places[i]).position; };
    for (std::size_t i = 0; i < row.nodes; ++i)
      if (row.terms[i].part == part) middle += row.terms[i].reach * place(i);
    for (std::size_t i = 0; i < row.nodes; ++i) {
      if (row.terms[i].part != part || row.terms[i].reach == 0) continue;
      const Vec3 arm = place(i) - middle;
      moments += row.terms[i].reach * arm * arm.transpose();
    }
  }
};

/// Of the plane that fits the nodes, on the side of `near`: a point that slides along the plane keeps its height over
/// it.
Vec3 normal_of_plane(const Spread& nodes, const Vec3& near) {
  const MomentsAcross across(nodes.moments, near);
  return across.are_plane() ? (near - across.solve(nodes.moments * near)).normalized() : near;
}

/// Weights of linear functions along one side, of sum zero: they move its point by the moments times `slope`.
void move_point(const KeptRow& row, MortarPart part, const Spread& nodes, const Vec3& slope,
                std::span<const NodeMotion> motion, std::span<double> weights) {
  for (std::size_t i = 0; i < row.nodes; ++i)
    if (row.terms[i].part == part && row.terms[i].reach != 0)
      weights[i] += row.terms[i].reach * slope.dot(nth(motion, row.places[i]).position - nodes.middle);
}

/// Of accepted overlaps of the start, what the row's function makes of them [length].
double accepted_by(const KeptRow& row, std::span<const AcceptedOverlap> accepted) {
  double sum = 0;
  if (accepted.empty()) return sum;
  for (std::size_t i = 0; i < row.nodes; ++i)
    if (row.terms[i].part == MortarPart::slave)
      sum += row.terms[i].weight *
             accepted_penetration(accepted, row.terms[i].id, static_cast<std::int32_t>(row.head.key.master));
  return sum;
}

}  // namespace

KeptRow kept_row(const MortarHistory& history, std::span<const LocalIndex> places, std::size_t r) {
  const std::span<const MortarTerm> terms = history.terms.row(static_cast<LocalIndex>(r));
  const auto end = std::ranges::find(terms, MortarPart::facet, &MortarTerm::part);
  return {history.heads[r], terms, places.subspan(static_cast<std::size_t>(history.terms.offsets[r]), terms.size()),
          static_cast<std::size_t>(end - terms.begin())};
}

PlacedRow place_row(const KeptRow& row, const MortarScene& scene, std::span<const Vec3> facet_normal, const Vec3& apart,
                    std::span<double> weights) {
  // Where the facets are covered whole, what is covered moves with the slave, and the master's points below it change:
  // the normal is that of the master's plane. Otherwise what is covered moves with the rim of the master, along the
  // slave's facets. The points that move come over the others again, so that the row has no moment: to first order what
  // integration would do.
  const bool is_whole = row.head.whole > 0;
  const MortarPart moving = is_whole ? MortarPart::master : MortarPart::slave;
  const Spread nodes(row, moving, scene.motion);
  const Vec3 against = against_facets(row, facet_normal);
  PlacedRow placed{.normal = is_whole ? normal_of_plane(nodes, against) : against};
  Vec3 left = apart;
  const MomentsAcross across(nodes.moments, placed.normal);
  if (across.are_plane()) {
    const Vec3 slope = across.solve(-apart);
    move_point(row, moving, nodes, slope, scene.motion, weights);
    left += nodes.moments * slope;
  }
  placed.gap = placed.normal.dot(left) + accepted_by(row, scene.accepted);
  return placed;
}

}  // namespace brunt::contact
