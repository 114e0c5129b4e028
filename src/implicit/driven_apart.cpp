// SPDX-License-Identifier: Apache-2.0
#include "brunt/implicit/driven_apart.hpp"

#include <algorithm>

#include "brunt/model/curve.hpp"

namespace brunt::implicit {
namespace {

/// Displacement that a drive gives from t = 0 to a time; nothing of an acceleration, which needs the velocity there.
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

bool accelerates(const model::Model& model, const model::ConstrainedNode& node) {
  return std::ranges::any_of(node.drive, [&](std::int32_t drive) {
    return drive >= 0 && model.drives[static_cast<std::size_t>(drive)].gives == model::Drive::Gives::acceleration;
  });
}

/// The corner of a place with the largest share.
LocalIndex nearest_node(const contact::MasterPlace& place) {
  const auto most = std::ranges::max_element(place.weights) - place.weights.begin();
  return place.nodes[static_cast<std::size_t>(most)];
}

/// Keeps the row that opens most, over a facet's edge.
class Widest {
 public:
  explicit Widest(const MortarContact& contact) : contact_(contact) {}

  void look(std::size_t interface, std::size_t row, const Vec3& apart) {
    const Interface& face = contact_.interfaces[interface];
    const double share = apart.norm() / face.topology.edge;
    if (!(share > agreed && share > widest_)) return;
    widest_ = share;
    const auto slave = static_cast<std::size_t>(face.surfaces.rows[row]);
    const LocalIndex master = nearest_node(face.tie.below[row]);
    found_ = {interface, contact_.nodes.gid[slave],
              master == no_index ? -1 : contact_.nodes.gid[static_cast<std::size_t>(master)], apart,
              contact_.nodes.reference[slave]};
  }
  [[nodiscard]] const std::optional<DrivenApart>& found() const { return found_; }

 private:
  const MortarContact& contact_;
  double widest_ = 0;
  std::optional<DrivenApart> found_;
};

/// Along directions in which the slave node and the place under it are held.
void look_at_places(const MortarContact& contact, std::span<const Vec3> displacement, Widest& widest) {
  for (std::size_t k = 0; k < contact.interfaces.size(); ++k) {
    const Interface& face = contact.interfaces[k];
    for (std::size_t row = 0; face.pair.tied && row < face.count(); ++row) {
      if (face.given_apart[row].isZero(0)) continue;
      const Vec3& of_slave = displacement[static_cast<std::size_t>(face.surfaces.rows[row])];
      widest.look(k, row,
                  face.given_apart[row] * contact::offset_from_below(face.tie.below[row], of_slave, displacement));
    }
  }
}

/// Along directions in which other rows imply a row's equation.
void look_at_implied(const MortarContact& contact, Widest& widest) {
  for (std::size_t k = 0; k < contact.interfaces.size(); ++k) {
    const Interface& face = contact.interfaces[k];
    if (!face.pair.tied) continue;
    std::vector<Vec3> left;
    contact::tie_residuals(face.tie, contact.nodes.x, face.rows.normals, left);
    for (std::size_t row = 0; row < face.count(); ++row) {
      if (face.tie.covered[row] == 0) continue;
      const Mat3 implied = Mat3::Identity() - face.given_apart[row] - face.tied[row];
      if (!implied.isZero()) widest.look(k, row, implied * left[row]);
    }
  }
}

}  // namespace

std::optional<DrivenApart> driven_apart(const MortarContact& contact) {
  if (std::ranges::none_of(contact.interfaces, [](const Interface& face) { return face.pair.tied; })) return {};
  std::vector<Vec3> displacement;
  for (std::size_t k = 0; k < contact.nodes.gid.size(); ++k)
    displacement.emplace_back(contact.nodes.x[k] - contact.nodes.reference[k]);
  Widest widest(contact);
  look_at_places(contact, displacement, widest);
  look_at_implied(contact, widest);
  return widest.found();
}

std::optional<DrivenApart> driven_apart_at(const model::Model& model, double time, const MortarContact& contact) {
  std::vector<double> local(4 * static_cast<std::size_t>(model.nodes()), 0.0), everywhere(4 * contact.nodes.gid.size());
  for (const model::ConstrainedNode& node : model.constrained) {
    const std::size_t at = 4 * static_cast<std::size_t>(node.node);
    for (std::size_t c = 0; c < 3; ++c)
      if (node.drive[c] >= 0) local[at + c] = travel_of(model.drives[static_cast<std::size_t>(node.drive[c])], time);
    local[at + 3] = accelerates(model, node) ? 1 : 0;
  }
  contact.nodes.gather.forward(local, everywhere, 4);
  std::vector<Vec3> displacement;
  bool known = true;
  for (std::size_t k = 0; k < contact.nodes.gid.size(); ++k) {
    displacement.emplace_back(&everywhere[4 * k]);
    known = known && everywhere[4 * k + 3] == 0;
  }
  Widest widest(contact);
  if (known) look_at_places(contact, displacement, widest);
  return widest.found();
}

std::vector<double> turning_times(const model::Model& model, double end) {
  std::vector<double> times{end};
  for (const model::Drive& drive : model.drives)
    for (const auto& [time, value] : drive.curve)
      if (time > 0 && time < end) times.push_back(time);
  std::ranges::sort(times);
  const auto repeated = std::ranges::unique(times);
  times.erase(repeated.begin(), repeated.end());
  return times;
}

}  // namespace brunt::implicit
