// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact/enforcement/softness.hpp"

namespace brunt::contact {

void soften(const System& system, std::span<const Vec3> before, EnforcementScratch& scratch) {
  scratch.compliance.assign(system.rows.size(), 0.0);
  scratch.borne.assign(system.rows.size(), Vec3::Zero());
  for (std::size_t q = 0; q < system.rows.size(); ++q) {
    const Row& row = system.rows[q];
    if (row.softness == 0 || !(scratch.diagonal[q] > 0)) continue;
    const double compliance = row.softness * system.mobility[static_cast<std::size_t>(row.nodes[0])].inverse_mass;
    scratch.compliance[q] = compliance;
    scratch.diagonal[q] += compliance;
    const Vec3 along = row.normal.dot(before[q]) * row.normal;
    scratch.borne[q] = compliance * ((1 - row.gap_share) * along + (1 - row.drift_share) * (before[q] - along));
  }
}

}  // namespace brunt::contact
