// SPDX-License-Identifier: Apache-2.0
// Does contact give back what it took? Its term of the ledger is energy taken from the bodies, and ought not to fall
// but by what soft rows have stored.
#pragma once
#include <algorithm>

#include "support/simulation.hpp"

namespace brunt::test {

/// Looked at after each step.
struct GivenBack {
  double now = 0;    ///< taken so far [energy]
  double least = 0;  ///< the same, at any time
  double most = 0;
  double given = 0;  ///< by how much it fell at most from what it was at most before

  void look(double taken) {
    now = taken;
    least = std::min(least, now);
    most = std::max(most, now);
    given = std::max(given, most - now);
  }
};

/// Taken for good.
inline double lost_in_contact(Simulation& scene) {
  return scene.ledger().contact - contact::collect(*scene.contact).stored;
}

/// Steps on until `end` [time], and looks after each step.
inline GivenBack run_until(Simulation& scene, double end) {
  GivenBack contact;
  while (scene.state.time < end) {
    scene.step();
    contact.look(lost_in_contact(scene));
  }
  return contact;
}

}  // namespace brunt::test
