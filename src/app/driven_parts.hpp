// SPDX-License-Identifier: Apache-2.0
// Parts that supports move through each other, or through a rigid wall, where contact can do nothing: which pairs,
// since when, and how deep.
#pragma once
#include <string>
#include <vector>

#include "brunt/comm/communicator.hpp"
#include "brunt/contact/contact.hpp"
#include "brunt/model/model.hpp"

namespace brunt::app {

/// The first pairs of parts that were found, the same on all ranks. As plain numbers, so that a checkpoint holds them.
class DrivenParts {
 public:
  /// Room for the pairs, where the scene has any that could be driven; else nothing is done or saved.
  void prepare(const contact::Contact* contact);
  /// time: where the clock of `contact` stood at 0.
  void start_clock(double time) { clock_start_ = time; }
  /// Takes over what the ranks have found, and follows the nodes that were the first to come through: contact looks but
  /// a share of an element behind a face, so that the depth of such a node is measured from the face that it came
  /// through, until it leaves the column behind that face. Returns a warning for each pair that is new. Collective.
  std::vector<std::string> look(const comm::Communicator& ranks, const contact::Contact& contact,
                                const model::Model& model, const model::State& state, const std::string& length_unit);
  [[nodiscard]] double largest() const;  ///< depth of all pairs [length]
  [[nodiscard]] std::vector<double>& saved() { return saved_; }

 private:
  std::vector<double> saved_;
  double clock_start_ = 0;
};

}  // namespace brunt::app
