// SPDX-License-Identifier: Apache-2.0
#include "implicit/driven_apart.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "comm/rendezvous.hpp"
#include "core/sorted.hpp"
#include "model/curve.hpp"

namespace brunt::implicit {
namespace {

/// Prescribed displacement of a drive from t = 0 to a time; none for an acceleration, which requires the velocity
/// there.
double travel_of(const model::Drive& drive, double time) {
  switch (drive.gives) {
    case model::Drive::Gives::displacement:
      return drive.scale * (model::value_at(drive.curve, time) - model::value_at(drive.curve, 0));
    case model::Drive::Gives::velocity:
      return drive.scale * model::integral(drive.curve, 0, time);
    case model::Drive::Gives::acceleration:
      break;
  }
  return 0;
}

/// Whether one of the drives of a node gives its acceleration.
bool accelerates(const model::Model& model, const std::array<std::int32_t, 3>& drives) {
  return std::ranges::any_of(drives, [&](std::int32_t drive) {
    return drive >= 0 && nth(model.supports.drives, drive).gives == model::Drive::Gives::acceleration;
  });
}

/// Whether the prescribed motion of a body from t = 0 on contains rotations.
bool is_hard_to_foresee(const model::Model& model, const model::RigidBody& body) {
  for (std::size_t c = 0; c < body.drive.size(); ++c)
    if (body.drive[c] &&
        (c >= 3 || nth(model.supports.drives, *body.drive[c]).gives == model::Drive::Gives::acceleration))
      return true;
  return false;
}

/// The corner of a projection with the largest weight.
LocalIndex nearest_node(const contact::MasterPlace& place) {
  const auto most = std::ranges::max_element(place.weights) - place.weights.begin();
  return nth(place.nodes, most);
}

/// The opening of a row, and its number among all.
struct Opening {
  double share = 0;  ///< of a facet's edge
  GlobalIndex of_implied = 0, interface = 0, place = 0;
  GlobalIndex slave = -1, master = -1;
  std::array<double, 3> apart{}, reference{};
};

/// The larger opening; of equal ones that with the lower number.
bool comes_before(const Opening& a, const Opening& b) {
  if (a.share != b.share) return a.share > b.share;
  return std::tie(a.of_implied, a.interface, a.place) < std::tie(b.of_implied, b.interface, b.place);
}

/// Stores the row of this rank with the largest opening over a facet's edge.
class Widest {
 public:
  explicit Widest(const MortarContact& contact) : contact_(contact) {}

  void look(bool of_implied, std::size_t interface, std::size_t row, const Vec3& apart) {
    const Interface& face = contact_.interfaces[interface];
    const double share = apart.norm() / face.topology.edge;
    if (!(share > agreed)) return;
    const auto slave = static_cast<std::size_t>(face.surfaces.rows[row]);
    const LocalIndex master = nearest_node(face.start.tie.below[row]);
    Opening opening{share, of_implied ? 1 : 0, static_cast<GlobalIndex>(interface), face.numbering.place[row]};
    opening.slave = contact_.nodes.gid[slave];
    if (master != no_index) opening.master = nth(contact_.nodes.gid, master);
    Eigen::Map<Vec3>(opening.apart.data()) = apart;
    Eigen::Map<Vec3>(opening.reference.data()) = contact_.nodes.reference[slave];
    if (found_.empty() || comes_before(opening, found_[0])) found_ = {opening};
  }
  /// Over all ranks. Collective.
  [[nodiscard]] std::optional<DrivenApart> of_all(const comm::Communicator& ranks) const {
    if (!ranks.any(!found_.empty())) return {};
    const std::vector<Opening> all =
        comm::exchange(ranks, std::vector<std::vector<Opening>>(static_cast<std::size_t>(ranks.size()), found_)).values;
    const Opening widest = *std::ranges::min_element(all, comes_before);
    return DrivenApart{static_cast<std::size_t>(widest.interface), widest.slave, widest.master,
                       Vec3(widest.apart.data()), Vec3(widest.reference.data())};
  }

 private:
  const MortarContact& contact_;
  std::vector<Opening> found_;  ///< at most one
};

/// Along directions in which the slave node and its projection are constrained. displacement: of lasting nodes.
void look_at_places(const MortarContact& contact, std::span<const Vec3> displacement, Widest& widest) {
  for (std::size_t k = 0; k < contact.interfaces.size(); ++k) {
    const Interface& face = contact.interfaces[k];
    for (std::size_t row = 0; face.pair.tied && row < face.count(); ++row) {
      if (face.start.given_apart[row].isZero(0)) continue;
      const Vec3& of_slave = nth(displacement, face.surfaces.rows[row]);
      widest.look(
          false, k, row,
          face.start.given_apart[row] * contact::offset_from_below(face.start.tie.below[row], of_slave, displacement));
    }
  }
}

/// Along directions in which the equation of a row is redundant.
void look_at_implied(const MortarContact& contact, Widest& widest) {
  for (std::size_t k = 0; k < contact.interfaces.size(); ++k) {
    const Interface& face = contact.interfaces[k];
    if (!face.pair.tied) continue;
    std::vector<Vec3> left;
    contact::tie_residuals(face.start.tie, face.surfaces, face.topology, contact.nodes.x, left);
    for (std::size_t row = 0; row < face.count(); ++row) {
      if (face.start.tie.covered[row] == 0) continue;
      const Mat3 implied = Mat3::Identity() - face.start.given_apart[row] - face.start.tied[row];
      if (!implied.isZero()) widest.look(true, k, row, implied * left[row]);
    }
  }
}

/// For nodes of this rank, four each: prescribed displacement from t = 0 to `time`, and 1 if it is not known.
std::vector<double> travel_by_supports(const model::Model& model, double time) {
  std::vector<double> travel(4 * static_cast<std::size_t>(model.nodes()), 0.0);
  const auto give = [&](LocalIndex node, std::size_t axis, std::int32_t drive) {
    travel[4 * static_cast<std::size_t>(node) + axis] = travel_of(nth(model.supports.drives, drive), time);
  };
  for (std::size_t k = 0; k < model.supports.nodes.size(); ++k) {
    const LocalIndex node = model.supports.nodes[k].node;
    const std::array<std::int32_t, 3>& drive = model.supports.drive[k];
    for (std::size_t c = 0; c < 3; ++c)
      if (drive[c] >= 0) give(node, c, drive[c]);
    if (accelerates(model, drive)) travel[4 * static_cast<std::size_t>(node) + 3] = 1;
  }
  for (const model::RigidBody& body : model.bodies)
    for (const LocalIndex node : body.nodes) {
      for (std::size_t c = 0; c < 3; ++c)
        if (body.drive[c]) give(node, c, *body.drive[c]);
      if (is_hard_to_foresee(model, body)) travel[4 * static_cast<std::size_t>(node) + 3] = 1;
    }
  return travel;
}

}  // namespace

std::optional<DrivenApart> driven_apart(const comm::Communicator& ranks, const MortarContact& contact) {
  if (std::ranges::none_of(contact.interfaces, [](const Interface& face) { return face.pair.tied; })) return {};
  std::vector<Vec3> displacement;
  for (std::size_t k = 0; k < contact.nodes.lasting; ++k)
    displacement.emplace_back(contact.nodes.x[k] - contact.nodes.reference[k]);
  Widest widest(contact);
  look_at_places(contact, displacement, widest);
  look_at_implied(contact, widest);
  return widest.of_all(ranks);
}

std::optional<DrivenApart> driven_apart_at(const comm::Communicator& ranks, const model::Model& model, double time,
                                           const MortarContact& contact) {
  std::vector<double> here(4 * contact.nodes.gid.size());
  contact.nodes.gather.forward(travel_by_supports(model, time), here, 4);
  std::vector<Vec3> displacement;
  bool unknown = false;
  for (std::size_t k = 0; k < contact.nodes.lasting; ++k) {
    displacement.emplace_back(&here[4 * k]);
    unknown = unknown || here[4 * k + 3] != 0;
  }
  if (ranks.any(unknown)) return {};
  Widest widest(contact);
  look_at_places(contact, displacement, widest);
  return widest.of_all(ranks);
}

std::vector<double> turning_times(const model::Model& model, double end) {
  std::vector<double> times{end};
  for (const model::Drive& drive : model.supports.drives)
    for (const auto& [time, value] : drive.curve)
      if (time > 0 && time < end) times.push_back(time);
  sort_unique(times);
  return times;
}

}  // namespace brunt::implicit
