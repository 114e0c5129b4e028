// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/enforcement/softness.hpp"

namespace brunt::contact {

void soften(const System& system, std::span<const Vec3> before, EnforcementScratch& scratch) {
  scratch.compliance.assign(system.rows.size(), 0.0);
  scratch.borne.assign(system.rows.size(), Vec3::Zero());
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    const RowLaw& law = system.rows.laws[q];
    if (law.softness == 0 || !(scratch.diagonal[q] > 0)) continue;
    const double compliance = law.softness * system.mobility[system.rows.leader(q)].inverse_mass;
    scratch.compliance[q] = compliance;
    scratch.diagonal[q] += compliance;
    const RowFigures& figures = system.rows.figures[q];
    const Vec3 along = law.normal.dot(before[q]) * law.normal;
    scratch.borne[q] = compliance * ((1 - figures.gap_share) * along + (1 - figures.drift_share) * (before[q] - along));
  }
}

}  // namespace brunt::contact
