// SPDX-License-Identifier: Apache-2.0
#include "driven_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <span>

#include "app/state/driven_words.hpp"
#include "geometry/closest_point.hpp"

namespace brunt::app {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t most_pairs = 8;  // further pairs are neither reported nor measured

/// One pair in the saved numbers. Gids and blocks are whole numbers below 2^53.
enum Place : std::size_t {
  in_use,
  left,
  since,
  slave_block,
  master_block,
  depth,
  slave,
  corners,
  weights = 11,
  limit = 15,
  is_rigid,
  in_chain,
  width
};
using Record = std::span<double>;

bool is_of(std::span<const double> record, const contact::DrivenMeeting& meeting) {
  return record[in_use] != 0 &&
         meeting.is_of(static_cast<std::int32_t>(record[slave_block]), static_cast<std::int32_t>(record[master_block]));
}

std::array<double, width> record_of(const contact::DrivenMeeting& meeting, double clock_start) {
  std::array<double, width> record{};
  record[in_use] = 1;
  record[since] = clock_start + meeting.since;
  record[slave_block] = meeting.slave_block;
  record[master_block] = meeting.master_block;
  record[depth] = meeting.penetration;
  record[slave] = static_cast<double>(meeting.slave);
  for (std::size_t i = 0; i < 4; ++i) {
    record[corners + i] = static_cast<double>(meeting.corners[i]);
    record[weights + i] = meeting.weights[i];
  }
  record[limit] = meeting.limit;
  record[is_rigid] = meeting.is_rigid ? 1 : 0;
  record[in_chain] = meeting.in_chain ? 1 : 0;
  return record;
}

/// Positions of the slave and the corners: every copy of a node has the same bits, so the largest is any of them.
std::array<Vec3, 5> positions_of(const comm::Communicator& ranks, const model::Model& model, const model::State& state,
                                 std::span<const double> record) {
  std::array<double, 15> found;
  found.fill(-infinity);
  for (std::size_t i = 0; i < 5; ++i) {
    const auto gid = static_cast<GlobalIndex>(i == 0 ? record[slave] : record[corners + i - 1]);
    const auto node = std::ranges::find(model.mesh.node_gid, gid);
    if (gid == no_index || node == model.mesh.node_gid.end()) continue;
    const model::NodeLine& line = nth(state.nodes, node - model.mesh.node_gid.begin());
    std::copy_n(line.x, 3, &found[3 * i]);
  }
  ranks.max(found);
  std::array<Vec3, 5> positions;
  for (std::size_t i = 0; i < 5; ++i) positions[i] = Vec3(&found[3 * i]);
  return positions;
}

/// Measures the depth of the node behind the face that it came through.
void follow(const std::array<Vec3, 5>& positions, Record record) {
  const std::size_t count = record[corners + 3] == static_cast<double>(no_index) ? 3 : 4;
  const geometry::Corners face{positions.data() + 1, count};
  Vec3 offset = positions[0];
  for (std::size_t i = 0; i < count; ++i) offset -= record[weights + i] * face[i];
  const Vec3 normal = geometry::area_vector(face).normalized();
  const double behind = -offset.dot(normal);
  if (!((offset + behind * normal).norm() <= geometry::longest_edge(face)))
    record[left] = 1;
  else
    record[depth] = std::max(record[depth], behind);
}

/// "part 'a' and rigid wall 'w'".
std::string pair_of(std::span<const double> record, const model::Model& model) {
  return driven_pair(model, static_cast<std::int32_t>(record[slave_block]),
                     static_cast<std::int32_t>(record[master_block]));
}

std::string warning_of(std::span<const double> record, const model::Model& model, const std::string& length_unit) {
  if (record[in_chain] == 0)
    return driven_through(model, static_cast<std::int32_t>(record[slave_block]),
                          static_cast<std::int32_t>(record[master_block]), record[since], record[depth], length_unit);
  return fmt::format(
      "supports or moving walls press {} into each other without a way out: since t = {:g} no motion satisfies all "
      "contacts of the rigid bodies between them; the depth is now {} (reported once for each pair; "
      "driven_penetration in summary.json is the largest depth)",
      pair_of(record, model), record[since], driven_length(record[depth], length_unit));
}

}  // namespace

void DrivenParts::prepare(const contact::Contact* contact) {
  saved_.assign(contact != nullptr && contact->derived.may_be_driven ? most_pairs * width : 0, 0.0);
}

double DrivenParts::largest() const {
  double most = 0;
  for (std::size_t k = 0; k < saved_.size(); k += width) most = std::max(most, saved_[k + depth]);
  return most;
}

std::string DrivenParts::beyond_limit(const model::Model& model, double time, const std::string& length_unit,
                                      bool certain) const {
  std::span<const double> worst;
  for (std::size_t k = 0; k < saved_.size(); k += width) {
    const auto record = std::span(saved_).subspan(k, width);
    if (record[in_use] == 0 || (!certain && record[is_rigid] != 0)) continue;  // contact watches these in every step
    if (worst.empty() || record[depth] * worst[limit] > worst[depth] * record[limit]) worst = record;
  }
  if (worst.empty() || (!certain && worst[depth] <= worst[limit])) return {};
  return fmt::format(
      "supports or moving walls drive {} into each other: the driven penetration is {} at t = {:g}, and began at t = "
      "{:g}; {} is admitted, {}. {}: give them a way out, drive them less far, or use forces in place of prescribed "
      "motions",
      pair_of(worst, model), driven_length(worst[depth], length_unit), time, worst[since],
      driven_length(worst[limit], length_unit), worst[is_rigid] != 0 ? "a hundredth of the rigid body" : "an element",
      worst[in_chain] != 0 ? "No motion satisfies all contacts of the rigid bodies between them"
                           : "Neither of them can yield");
}

std::vector<std::string> DrivenParts::look(const comm::Communicator& ranks, const contact::Contact& contact,
                                           const model::Model& model, const model::State& state,
                                           const std::string& length_unit) {
  if (saved_.empty()) return {};
  const auto record = [&](std::size_t k) { return Record(saved_).subspan(k * width, width); };
  const auto find = [&](const contact::DrivenMeeting& meeting) -> std::optional<std::size_t> {
    for (std::size_t k = 0; k < most_pairs; ++k)
      if (is_of(record(k), meeting)) return k;
    return std::nullopt;
  };
  std::size_t used = 0;
  while (used < most_pairs && record(used)[in_use] != 0) ++used;
  const std::size_t known = used;
  for (; used < most_pairs; ++used) {  // the earliest of those that are new, of equals the one with the lowest node
    const contact::DrivenMeeting* first = nullptr;
    for (const contact::DrivenMeeting& meeting : contact.driven)
      if (!find(meeting) &&
          (first == nullptr || std::pair(meeting.since, meeting.slave) < std::pair(first->since, first->slave)))
        first = &meeting;
    const double earliest = ranks.min(first != nullptr ? first->since : infinity);
    if (earliest == infinity) break;
    const bool may_be_mine = first != nullptr && first->since == earliest;
    const double lowest = ranks.min(may_be_mine ? static_cast<double>(first->slave) : infinity);
    std::array<double, width> chosen;
    chosen.fill(-infinity);
    if (may_be_mine && static_cast<double>(first->slave) == lowest) chosen = record_of(*first, clock_start_);
    ranks.max(chosen);
    std::ranges::copy(chosen, record(used).begin());
  }
  std::array<double, most_pairs> deepest{};
  for (const contact::DrivenMeeting& meeting : contact.driven)
    if (const auto k = find(meeting)) deepest[*k] = std::max(deepest[*k], meeting.penetration);
  if (used > 0) ranks.max(deepest);
  for (std::size_t k = 0; k < used; ++k) {
    record(k)[depth] = std::max(record(k)[depth], deepest[k]);
    const bool behind_face = record(k)[corners] != static_cast<double>(no_index);
    if (behind_face && record(k)[in_chain] == 0 && record(k)[left] == 0)
      follow(positions_of(ranks, model, state, record(k)), record(k));
  }
  std::vector<std::string> warnings;
  for (std::size_t k = known; k < used; ++k) warnings.push_back(warning_of(record(k), model, length_unit));
  return warnings;
}

}  // namespace brunt::app
