// SPDX-License-Identifier: Apache-2.0
// The stiffness of the bodies: derivatives of the forces on the nodes that a rank owns with respect to the positions of
// all nodes, assembled from the matrices of elements and pressed faces in canonical order, independent of the rank that
// computes them.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "comm/communicator.hpp"
#include "comm/halo.hpp"
#include "core/cells.hpp"
#include "core/ragged.hpp"
#include "force/trial.hpp"
#include "implicit/data/unknowns.hpp"
#include "model/model.hpp"

namespace brunt::implicit {

/// Rows of 3 x 3 blocks, a row for each of Unknowns::node.
struct NodeRows {
  std::vector<std::int64_t> begin;     ///< rows + 1 offsets into `column`
  std::vector<GlobalIndex> column;     ///< canonical numbers of nodes, ascending in a row
  std::vector<std::int64_t> diagonal;  ///< place of the row's own node in `column`
  std::vector<double> value;           ///< nine for each column, row by row [force/length]
};

class Stiffness {
 public:
  /// The pattern is that of the mesh. Collective.
  Stiffness(const comm::Communicator& ranks, const model::Model& model, const Unknowns& unknowns);

  /// d(internal force - forces of pressure)/du at the end of the motion, as computed by force::element_tangents; loads
  /// of State::time. Collective.
  void assemble(const model::Model& model, const model::State& state, const force::Motion& motion,
                const force::History& committed);

  [[nodiscard]] const NodeRows& rows() const { return rows_; }

 private:
  /// Contribution of an element or face to the rows of a border node, as identified by the owner of the node.
  struct Slot {
    GlobalIndex key = 0;  ///< orders the sum at a node: element, then corner; faces under pressure after all elements
    GlobalIndex row = 0;
    std::array<GlobalIndex, cells::most_corners> column{};
    std::int32_t nodes = 0;
    LocalIndex slot = 0;  ///< on the rank that computes it
  };
  static constexpr int slot_width = 9 * cells::most_corners;

  void number_corners(const model::Model& model, const Unknowns& unknowns, std::vector<std::vector<Slot>>& to_rank);
  void lay_pattern(const model::Model& model, const Unknowns& unknowns, const Ragged<Slot>& received);
  void add_elements(const model::Model& model, const force::Motion& motion, const force::History& committed);
  void add_pressures(const model::Model& model, const model::State& state);
  /// One element or face: `matrix` is square, of 3 nodes.size() rows.
  void add(const model::Model& model, std::span<const LocalIndex> nodes, std::span<const double> matrix);
  void add_block(LocalIndex row, GlobalIndex column, const double* block);
  void add_border();

  NodeRows rows_;
  std::vector<LocalIndex> target_;  ///< of corners in the order of addition: a row, or -1 - slot
  std::size_t next_target_ = 0;
  std::vector<double> slots_, leaves_;
  std::vector<Slot> leaf_;    ///< contents of the leaves
  Ragged<LocalIndex> terms_;  ///< by row: leaves, in the order of their keys
  comm::Halo border_;
  std::vector<double> matrices_;  ///< of some elements
};

}  // namespace brunt::implicit
