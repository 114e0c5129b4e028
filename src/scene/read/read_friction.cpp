// SPDX-License-Identifier: Apache-2.0
#include "read_friction.hpp"

#include <fmt/format.h>

namespace brunt::scene {
namespace {

using contact::FrictionLaw;

void judge_friction(const Key& map, FrictionLaw& law) {
  if (!has(map, "kinetic")) law.kinetic = law.fixed;
  if (has(map, "static") && law.kinetic > law.fixed)
    fault(at(map, "kinetic"),
          fmt::format("invalid kinetic coefficient {}: larger than the static one, {}; expected at most the static one",
                      law.kinetic, law.fixed));
}

}  // namespace

const Table<FrictionLaw> friction_keys{
    "contact.friction",
    "a map {static: number, kinetic: number, decay: number, lag: number}",
    {
        {"static", value(&FrictionLaw::fixed, not_negative), "-", "Coefficient at rest.", required},
        {"kinetic", value(&FrictionLaw::kinetic, not_negative), "-",
         "Coefficient at high slip rate, at most `static`: kinetic + (static - kinetic) exp(-decay slip rate).",
         "as `static`"},
        {"decay", value(&FrictionLaw::decay, not_negative), "time/length", "See `kinetic`."},
        {"lag", value(&FrictionLaw::lag, not_negative), "time",
         "[Delay](../contact/FRICTION.md#friction-with-a-lag) of the friction limit behind the pressure, for steady "
         "sliding in one pass."},
    },
    judge_friction,
};

void read_friction(const Key& key, FrictionLaw& law) {
  if (is_map(key)) {
    friction_keys.read(key, law);
  } else if (read(key, law.fixed, not_negative)) {
    law.kinetic = law.fixed;
  }
}

}  // namespace brunt::scene
