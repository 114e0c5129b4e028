// SPDX-License-Identifier: Apache-2.0
// The cost of a rank's own part of a step, without waiting for others: weights of the next partition. Results do not
// depend on it.
#pragma once
#include <vector>

#include "contact/contact.hpp"
#include "core/timers.hpp"
#include "model/model.hpp"

namespace brunt::app {

/// One explicit step in so many is timed: 20 messages of a step cost a microsecond each then.
constexpr int steps_between_samples = 10;

/// Processor time of this rank less that in messages, of the steps that were timed [s].
struct StepWork {
  double evaluate = 0;  ///< forces of elements, sums at the border
  double advance = 0;   ///< motion of nodes, contact
  double motion = 0;    ///< of `advance`: what Timers book as Phase::other
  double steps = 0;

  bool contact = false;  ///< is there any?

  [[nodiscard]] double of_elements() const { return evaluate + (contact ? motion : advance); }
  [[nodiscard]] double of_contact() const { return contact && advance > motion ? advance - motion : 0.0; }
};

/// Adds the time from its making to its end, where `on`.
class WorkSample {
 public:
  WorkSample(double& seconds, bool on);
  ~WorkSample();
  WorkSample(const WorkSample&) = delete;
  WorkSample& operator=(const WorkSample&) = delete;

 private:
  double* seconds_;
  double start_ = 0;
};

/// Candidate pairs of contact that this rank looks at for the nodes of each of its elements: of a slave node those with
/// faces, walls and (for one end) edges, with the first element that has the node. By block; zeros without contact.
[[nodiscard]] std::vector<std::vector<double>> pairs_of_elements(const model::Model& model,
                                                                 const contact::Contact* contact);

}  // namespace brunt::app
