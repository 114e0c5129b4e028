// SPDX-License-Identifier: Apache-2.0
#include "brunt/contact_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "comm/native.hpp"
#include "comm/rendezvous.hpp"
#include "contact/contact.hpp"
#include "core/sorted.hpp"
#include "gathered_mesh.hpp"
#include "partition/distribute.hpp"

namespace brunt::api {
namespace {

/// Throws std::invalid_argument on all ranks.
void judge(const comm::Communicator& ranks, const ContactSettings& settings) {
  const std::array<double, 4> given{settings.friction, settings.self ? 1.0 : 0.0, settings.tolerance,
                                    static_cast<double>(settings.iterations)};
  for (const double value : given)
    if (ranks.any(!std::isfinite(value)) || ranks.max(value) != ranks.min(value))
      throw std::invalid_argument("settings of contact are finite, and the same on all ranks");
  if (!(settings.friction >= 0 && settings.tolerance > 0 && settings.tolerance < 1 && settings.iterations >= 1))
    throw std::invalid_argument("friction is at least 0, tolerance between 0 and 1, and iterations at least 1");
}

/// A part of hexahedra and tetrahedra has two blocks.
std::string part_of(const std::string& block) {
  return block.substr(0, block.find(" ("));
}

contact::ContactSettings internal(const ContactSettings& settings, const std::vector<std::string>& block_names) {
  const std::size_t blocks = block_names.size();
  contact::ContactSettings inner;
  contact::PairSpecification pair{.rule = contact::PairRule::automatic, .passes = contact::Passes::automatic};
  pair.friction.fixed = pair.friction.kinetic = settings.friction;
  inner.specification.pairs = contact::PairTable(blocks, pair);
  pair.rule = contact::PairRule::apart;
  for (std::size_t a = 0; a < blocks && !settings.self; ++a)
    for (std::size_t b = 0; b <= a; ++b)
      if (part_of(block_names[a]) == part_of(block_names[b]))
        inner.specification.pairs.set(static_cast<std::int32_t>(a), static_cast<std::int32_t>(b), pair);
  inner.specification.enforcement.tolerance = settings.tolerance;
  inner.specification.enforcement.max_iterations = settings.iterations;
  return inner;
}

/// An impulse on its way from the owner of a node to a copy.
struct SentImpulse {
  GlobalIndex gid = 0;
  std::array<double, 3> impulse{};
};

/// The largest of each component and of its negative.
void bound(contact::VelocitySpan& span, std::size_t place, const std::vector<Vec3>& velocities) {
  for (const Vec3& one : velocities)
    for (std::size_t c = 0; c < 6; ++c)
      span[place + c] = std::max(span[place + c], (c < 3 ? 1 : -1) * one[static_cast<int>(c % 3)]);
}

}  // namespace

struct ContactStep::Data {
  comm::Communicator ranks;
  mesh::LocalMesh mesh;
  std::vector<std::size_t> place;  ///< of each node of `mesh` in the caller's arrays
  std::size_t numbers;             ///< of the caller's arrays: three a node
  contact::Contact contact;
  std::vector<Vec3> position, position_before, velocity_before, velocity;
  double dt_before = 0;

  void give(const std::vector<Vec3>& from, std::span<double> to) const {
    for (std::size_t n = 0; n < place.size(); ++n)
      for (std::size_t c = 0; c < 3; ++c) to[3 * place[n] + c] = from[n][static_cast<int>(c)];
  }
  void take(std::span<const double> from, std::vector<Vec3>& to) const {
    to.resize(place.size());
    for (std::size_t n = 0; n < place.size(); ++n) to[n] = Vec3(&from[3 * place[n]]);
  }
  /// Of the motion since the last step, and of that to come.
  [[nodiscard]] contact::VelocitySpan velocities() const {
    contact::VelocitySpan span;
    span.fill(std::numeric_limits<double>::lowest());
    std::vector<Vec3> moved_by;
    for (std::size_t n = 0; n < position_before.size(); ++n)
      moved_by.push_back((position[n] - position_before[n]) / dt_before);
    bound(span, 0, moved_by);
    bound(span, 6, velocity);
    ranks.max(span);
    return span;
  }
  [[nodiscard]] std::vector<Vec3> impulses() const;
};

/// Of all local nodes: those of the owner on every copy.
std::vector<Vec3> ContactStep::Data::impulses() const {
  std::vector<Vec3> impulse(mesh.node_gid.size(), Vec3::Zero());
  contact::add_impulses(contact, impulse);
  std::vector<std::vector<SentImpulse>> outgoing(static_cast<std::size_t>(ranks.size()));
  for (std::size_t s = 0; s < mesh.shared.size(); ++s) {
    const auto node = static_cast<std::size_t>(mesh.shared[s]);
    if (mesh.owner[node] != ranks.rank()) continue;
    for (const Rank rank : mesh.sharers.row(static_cast<LocalIndex>(s)))
      nth(outgoing, rank).push_back({mesh.node_gid[node], {impulse[node][0], impulse[node][1], impulse[node][2]}});
  }
  for (const SentImpulse& sent : comm::exchange(ranks, outgoing).values) {
    const auto node = std::ranges::lower_bound(mesh.node_gid, sent.gid) - mesh.node_gid.begin();
    nth(impulse, node) = Vec3(sent.impulse.data());
  }
  return impulse;
}

ContactStep::ContactStep(MPI_Comm on, const ContactMesh& given, const ContactSettings& settings) {
  const comm::Communicator ranks = comm::NativeAccess::on(on);
  judge(ranks, settings);
  const GatheredMesh whole = gather(ranks, given);
  mesh::LocalMesh local = partition::distribute(ranks, whole.mesh, whole.rank_of_element);
  const std::vector<std::size_t> place = places_of(given.node_number, local.node_id);
  std::vector<double> inverse_mass;
  std::vector<contact::ConstrainedNode> held;
  for (std::size_t n = 0; n < place.size(); ++n) {
    const double mass = given.mass[place[n]];
    inverse_mass.push_back(std::isinf(mass) ? 1.0 : 1 / mass);
    if (std::isinf(mass)) held.push_back({static_cast<LocalIndex>(n), Mat3::Zero()});
  }
  const std::vector<char> excluded(local.faces.size(), 0);
  contact::Contact contact =
      contact::make_contact(ranks, local, excluded, inverse_mass, held, {}, internal(settings, local.block_name));
  data_.reset(new Data{ranks, std::move(local), place, given.position.size(), std::move(contact), {}, {}, {}, {}});
}

ContactStep::~ContactStep() = default;
ContactStep::ContactStep(ContactStep&&) noexcept = default;
ContactStep& ContactStep::operator=(ContactStep&&) noexcept = default;

ContactReport ContactStep::correct(std::span<const double> position, std::span<const double> velocity_before,
                                   std::span<double> velocity, double dt, std::span<double> impulse) {
  Data& data = *data_;
  const auto is_finite = [](double x) { return std::isfinite(x); };
  const bool fits = position.size() == data.numbers && velocity_before.size() == data.numbers &&
                    velocity.size() == data.numbers && (impulse.empty() || impulse.size() == data.numbers);
  const bool right = fits && std::ranges::all_of(position, is_finite) &&
                     std::ranges::all_of(velocity_before, is_finite) && std::ranges::all_of(velocity, is_finite);
  if (data.ranks.any(!right || !(dt > 0) || !std::isfinite(dt)) || data.ranks.max(dt) != data.ranks.min(dt))
    throw std::invalid_argument(
        "arrays have three finite numbers for each node of ContactMesh; dt is positive, and the same on all ranks");
  data.position_before = std::exchange(data.position, {});
  data.take(position, data.position);
  data.take(velocity_before, data.velocity_before);
  data.take(velocity, data.velocity);
  const contact::StepInput input{
      .position = {data.position.empty() ? nullptr : data.position.front().data()},
      .old_velocity = {data.velocity_before.empty() ? nullptr : data.velocity_before.front().data()},
      .velocity = {data.velocity.empty() ? nullptr : data.velocity.front().data()},
      .walls = {},
      .dt = dt};
  contact::search(data.contact, input, data.velocities());
  contact::correct(data.contact, input);
  data.dt_before = dt;
  data.give(data.velocity, velocity);
  if (data.ranks.any(!impulse.empty())) {
    const std::vector<Vec3> given = data.impulses();
    std::ranges::fill(impulse, 0.0);
    if (!impulse.empty()) data.give(given, impulse);
  }
  const contact::ContactTotals totals = contact::collect(data.contact);
  const contact::EnforcementResult& last = data.contact.ledger.statistics.last;
  return {totals.active, last.iterations, last.residual, totals.penetration};
}

}  // namespace brunt::api
