// SPDX-License-Identifier: Apache-2.0
// Placement of bodies and their union.
#include "mesh/assemble.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "core/error.hpp"
#include "core/excerpt.hpp"

namespace brunt::mesh {
namespace {

std::string shown(const Block& block) {
  return block.name.empty() ? fmt::format("{}", block.id) : block.name;
}

void name_with_prefix(Mesh& piece, const std::string& prefix) {
  if (prefix.empty()) return;
  for (Block& block : piece.blocks) block.name = prefix + shown(block);
  for (LeftOut& block : piece.left_out)
    block.name = prefix + (block.name.empty() ? std::to_string(block.id) : block.name);
  const auto rename = [&](auto& sets) {
    std::remove_reference_t<decltype(sets)> renamed;
    for (auto& [name, members] : sets) renamed[prefix + name] = std::move(members);
    sets = std::move(renamed);
  };
  rename(piece.node_sets);
  rename(piece.side_sets);
}

void refuse_clashes(const Mesh& whole, const Mesh& piece) {
  constexpr auto cure = "expected different names, by prefix or another part name";
  std::vector<std::string> faults;
  std::set<std::string> names;
  for (const Block& block : whole.blocks) names.insert(shown(block));
  for (const Block& block : piece.blocks)
    if (names.count(shown(block)))
      faults.push_back(fmt::format("invalid block {}: two meshes have it; {}", excerpt(shown(block)), cure));
  for (const auto& [name, nodes] : piece.node_sets)
    if (whole.node_sets.count(name))
      faults.push_back(fmt::format("invalid node set {}: two meshes have it; {}", excerpt(name), cure));
  for (const auto& [name, sides] : piece.side_sets)
    if (whole.side_sets.count(name))
      faults.push_back(fmt::format("invalid side set {}: two meshes have it; {}", excerpt(name), cure));
  const auto corners = [](const Mesh& mesh) {
    std::size_t sum = mesh.coordinates.size();
    for (const Block& block : mesh.blocks) sum += block.nodes.size();
    return sum;
  };
  if (corners(whole) + corners(piece) > static_cast<std::size_t>(std::numeric_limits<LocalIndex>::max()))
    faults.push_back("out of range: the bodies together have 2^31 element corners or more; expected fewer");
  if (!faults.empty()) throw InputError(faults);
}

GlobalIndex largest(const std::vector<GlobalIndex>& ids) {
  return ids.empty() ? 0 : *std::max_element(ids.begin(), ids.end());
}

void shift(std::vector<GlobalIndex>& ids, GlobalIndex by) {
  for (GlobalIndex& id : ids) id += by;
}

}  // namespace

std::array<double, 2> cosine_sine(double degrees) {
  const double turn = std::remainder(degrees, 360.0);
  if (turn == 0) return {1, 0};
  if (std::abs(turn) == 90) return {0, std::copysign(1.0, turn)};
  if (std::abs(turn) == 180) return {-1, 0};
  const double angle = turn * std::numbers::pi / 180;
  return {std::cos(angle), std::sin(angle)};
}

Mat3 rotation(const Vec3& axis, double degrees) {
  const Vec3 k = axis / axis.norm();
  const auto [c, s] = cosine_sine(degrees);
  Mat3 cross;
  cross << 0, -k[2], k[1], k[2], 0, -k[0], -k[1], k[0], 0;
  return c * Mat3::Identity() + s * cross + (1 - c) * k * k.transpose();
}

void place(Mesh& mesh, double scale, const Vec3& axis, double degrees, const Vec3& at) {
  if (!(scale > 0) || !std::isfinite(scale))
    throw InputError(fmt::format(
        "out of range: scale is {}; expected a number > 0 (a negative one would mirror the elements)", scale));
  if (!axis.allFinite() || !(axis.norm() > 0) || !std::isfinite(degrees))
    throw InputError("invalid rotate; expected an axis that is not zero and a finite number of degrees");
  if (!at.allFinite()) throw InputError("invalid at; expected three finite numbers");
  const Mat3 turn = scale * rotation(axis, degrees);
  for (Vec3& x : mesh.coordinates) x = turn * x + at;
}

void append(Mesh& whole, Mesh&& piece, const std::string& prefix, const std::string& file) {
  name_with_prefix(piece, prefix);
  refuse_clashes(whole, piece);

  const auto first_node = static_cast<LocalIndex>(whole.coordinates.size());
  const auto first_block = static_cast<LocalIndex>(whole.blocks.size());
  GlobalIndex last_element = 0, last_block = 0;
  std::set<GlobalIndex> taken;
  for (const Block& block : whole.blocks) {
    last_element = std::max(last_element, largest(block.element_id));
    last_block = std::max(last_block, block.id);
    taken.insert(block.id);
  }
  for (const Block& block : piece.blocks) last_block = std::max(last_block, block.id);

  const GlobalIndex last_node = largest(whole.node_id);
  shift(piece.node_id, last_node);
  if (!file.empty() && !piece.node_id.empty()) {
    const auto [first, last] = std::ranges::minmax(piece.node_id);
    whole.files.push_back({file, prefix, last_node, first, last});
  }
  whole.node_id.insert(whole.node_id.end(), piece.node_id.begin(), piece.node_id.end());
  whole.coordinates.insert(whole.coordinates.end(), piece.coordinates.begin(), piece.coordinates.end());
  for (Block& block : piece.blocks) {
    for (LocalIndex& node : block.nodes) node += first_node;
    shift(block.element_id, last_element);
    if (!file.empty()) block.file_id = block.id;
    if (taken.count(block.id)) block.id = ++last_block;
    whole.blocks.push_back(std::move(block));
  }
  whole.left_out.insert(whole.left_out.end(), piece.left_out.begin(), piece.left_out.end());
  whole.notes.insert(whole.notes.end(), piece.notes.begin(), piece.notes.end());
  for (auto& [name, nodes] : piece.node_sets) {
    for (LocalIndex& node : nodes) node += first_node;
    whole.node_sets[name] = std::move(nodes);
  }
  for (auto& [name, sides] : piece.side_sets) {
    for (Side& side : sides) side.block += first_block;
    whole.side_sets[name] = std::move(sides);
  }
}

}  // namespace brunt::mesh
