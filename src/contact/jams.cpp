// SPDX-License-Identifier: Apache-2.0
#include "jams.hpp"

#include <algorithm>

namespace brunt::contact {
namespace {

/// Angular velocity of the body of a contact node: predicted, and by contact.
struct Spin {
  const Carrier* carrier = nullptr;  ///< none: the node turns with nothing
  Vec3 predicted = Vec3::Zero(), change = Vec3::Zero();
};

Spin spin_of(const Contact& contact, const Carriers& carriers, LocalIndex node) {
  Spin spin{.carrier = carriers.of(node)};
  if (spin.carrier == nullptr) return spin;
  const auto body = static_cast<std::size_t>(spin.carrier - carriers.bodies.data());
  spin.predicted = spin.carrier->spin;
  spin.change = contact.step.scratch.enforcement.carried.answer[body].change.tail<3>();
  return spin;
}

/// Nothing but rigid bodies can yield.
bool is_stiff(const Contact& contact, const Row& row) {
  if (row.cone != Cone::compression || row.is_edge() || row.holds) return false;
  return std::ranges::all_of(row.points(),
                             [&](LocalIndex node) { return nth(contact.step.nodes.mobility, node).inverse_mass == 0; });
}

bool is_jammed(const Contact& contact, const Carriers& carriers, std::size_t q, double dt) {
  const Row& row = contact.step.rows[q];
  if (!(row.normal.dot(contact.step.impulses[q]) > 0) || !is_stiff(contact, row)) return false;
  const std::vector<NodeMotion>& motion = contact.step.nodes.motion;
  const std::vector<Vec3>& after = contact.step.nodes.velocity;
  const auto slave = static_cast<std::size_t>(row.nodes[0]);
  const Spin own = spin_of(contact, carriers, row.nodes[0]);
  Spin other;
  SecondOrder gap{.normal = row.normal};
  Vec3 shift = motion[slave].predicted, change = after[slave] - motion[slave].predicted;
  if (own.carrier != nullptr) gap.arm = motion[slave].position - own.carrier->centre;
  if (!row.is_wall()) {
    const auto master = static_cast<std::size_t>(row.nodes[1]);
    other = spin_of(contact, carriers, row.nodes[1]);
    Vec3 arm = Vec3::Zero();
    if (other.carrier != nullptr) {
      gap.reach = motion[slave].position - other.carrier->centre;
      arm = motion[master].position - other.carrier->centre;
    }
    shift -= motion[master].predicted - other.predicted.cross(arm);
    change -= after[master] - motion[master].predicted - other.change.cross(arm);
  }
  const auto predicted = [&](const Vec3& one, const Vec3& two) { return Vec3(dt * (one + two)); };
  const Vec3 none = Vec3::Zero();
  const double by_all = gap.of({predicted(own.predicted, own.change), predicted(other.predicted, other.change),
                                predicted(shift, change)}),
               by_prediction =
                   gap.of({predicted(own.predicted, none), predicted(other.predicted, none), predicted(shift, none)}),
               second = gap.of({predicted(own.change, none), predicted(other.change, none), predicted(change, none)});
  const double gain = dt * row.normal.dot(relative_velocity(row, after) - relative_velocity(row, [&](LocalIndex node) {
                                            return nth(motion, node).predicted;
                                          }));
  return gain > 0 && has_no_multiple(gain + by_all - by_prediction - second, second, gain);
}

}  // namespace

bool drop_jammed_rows(Contact& contact, const StepInput& input, const EnforcementResult& result) {
  if (!result.acted) return false;
  const Carriers carriers = carriers_of(contact, input);
  std::vector<Row>& rows = contact.step.rows;
  Unmet& unmet = contact.unmet;
  unmet.rows.assign(rows.size(), 0);
  double any = 0;
  for (std::size_t q = 0; q < rows.size(); ++q)
    if (is_jammed(contact, carriers, q, input.dt)) unmet.rows[q] = 1, any = 1;
  contact.lists.exchange.max({&any, 1});
  if (any > 0) {
    std::size_t kept = 0;
    for (std::size_t q = 0; q < rows.size(); ++q) {
      if (unmet.rows[q] != 0) {
        unmet.jammed.push_back(rows[q]);
        continue;
      }
      rows[kept] = rows[q];
      unmet.held[kept++] = unmet.held[q];
    }
    rows.resize(kept);
    unmet.held.resize(kept);
  }
  unmet.rows.clear();
  return any > 0;
}

}  // namespace brunt::contact
