// SPDX-License-Identifier: Apache-2.0
#include "move_report.hpp"

#include <fmt/core.h>

#include "scene/build/select.hpp"

namespace brunt::app {

std::vector<std::string> report_refused_moves(const scene::Input& input, const mesh::Mesh& mesh,
                                              const std::vector<std::string>& held, const setup::OverlapMoves& moves) {
  std::vector<std::string> faults;
  const std::string where = input.at("contact");
  const auto number = [&](LocalIndex node) { return nth(mesh.node_id, node); };
  for (const setup::HeldMove& move : moves.held)
    faults.push_back(
        fmt::format("{}: invalid initial_overlap: move would displace {} node{} constrained by {} (first: node {}, by "
                    "{:.4g}); expected another `slave` that can move, or offset to keep the overlap",
                    where, move.count, move.count == 1 ? "" : "s", held[move.held], number(move.first), move.distance));
  if (moves.spoiled) {
    const setup::SpoiledElement& spoiled = *moves.spoiled;
    const std::string& part = input.parts[scene::parts_of_blocks(input, mesh)[spoiled.block]].name;
    faults.push_back(
        fmt::format("{}: invalid initial_overlap: move would {} element {} of part '{}' (a corner keeps {:.3g} of its "
                    "volume, at least {:g} is required); expected parts farther apart, or offset to keep the overlap",
                    where, spoiled.kept > 0 ? "flatten" : "invert",
                    nth(mesh.blocks[spoiled.block].element_id, spoiled.element), part, spoiled.kept, spoiled.wanted));
  }
  if (!moves.left.empty() && faults.empty())
    faults.push_back(fmt::format(
        "{}: invalid initial_overlap: move leaves {} overlapping node{} after {} passes (the deepest: node {}, by "
        "{:.4g}); expected parts farther apart, or offset to keep the overlap",
        where, moves.left.size(), moves.left.size() == 1 ? "" : "s", setup::most_moving_passes,
        number(moves.left[0].node), moves.left[0].penetration));
  return faults;
}

}  // namespace brunt::app
