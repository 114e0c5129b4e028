// SPDX-License-Identifier: Apache-2.0
// Parts that supports move through each other, or through a rigid wall, where contact has no effect: the pairs, their
// first time, and the depth.
#pragma once
#include <string>
#include <vector>

#include "comm/communicator.hpp"
#include "contact/contact.hpp"
#include "model/model.hpp"

namespace brunt::app {

/// The first pairs of parts that were found, the same on all ranks. As plain numbers, so that a checkpoint holds them.
class DrivenParts {
 public:
  /// Memory for the pairs, if the scene has any that could be driven; otherwise nothing is done or saved.
  void prepare(const contact::Contact* contact);
  /// time: the time at which the clock of `contact` was 0.
  void start_clock(double time) { clock_start_ = time; }
  /// Collects the findings of the ranks, and follows the nodes that passed through first. Contact examines only a share
  /// of an element behind a face, so the depth of such a node is measured from the face through which it came, until it
  /// leaves the column behind that face. Returns a warning for each new pair. Collective.
  std::vector<std::string> look(const comm::Communicator& ranks, const contact::Contact& contact,
                                const model::Model& model, const model::State& state, const std::string& length_unit);
  /// Of the pair that is deepest beyond its limit, why the run stops; empty if none is. certain: contact has found that
  /// one is.
  [[nodiscard]] std::string beyond_limit(const model::Model& model, double time, const std::string& length_unit,
                                         bool certain) const;
  [[nodiscard]] double largest() const;  ///< depth of all pairs [length]
  [[nodiscard]] std::vector<double>& saved() { return saved_; }

 private:
  std::vector<double> saved_;
  double clock_start_ = 0;
};

}  // namespace brunt::app
