// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/enforcement/softness.hpp"

namespace brunt::contact {
namespace {

/// Of a carried point, what the bodies answer along the normal.
double inverse_mass_of_leader(const System& system, std::size_t q, const CarriedScratch& carried) {
  const std::size_t leader = system.rows.leader(q);
  const std::span<const BodyShare> bodies = system.rows.bodies_of(q);
  if (bodies.empty() || carried.place[leader] == no_index) return system.mobility[leader].inverse_mass;
  double answer = 0;
  for (const BodyShare& share : bodies) answer += share.along * share.along;
  return answer;
}

}  // namespace

void soften(const System& system, std::span<const Vec3> before, EnforcementScratch& scratch) {
  scratch.compliance.assign(system.rows.size(), 0.0);
  scratch.borne.assign(system.rows.size(), Vec3::Zero());
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    const RowLaw& law = system.rows.laws[q];
    if (law.softness == 0 || !(scratch.diagonal[q] > 0)) continue;
    const double compliance = law.softness * inverse_mass_of_leader(system, q, scratch.carried);
    scratch.compliance[q] = compliance;
    scratch.diagonal[q] += compliance;
    const RowFigures& figures = system.rows.figures[q];
    const Vec3 along = law.normal.dot(before[q]) * law.normal;
    scratch.borne[q] = compliance * ((1 - figures.gap_share) * along + (1 - figures.drift_share) * (before[q] - along));
  }
}

}  // namespace brunt::contact
