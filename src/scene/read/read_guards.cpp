// SPDX-License-Identifier: Apache-2.0
// `guards`: thresholds of warnings and of stops.
#include "scene/guards.hpp"
#include "scene/keys/table.hpp"
#include "scene/read/sections.hpp"

namespace brunt::scene {
namespace {

void judge_guards(const Key& map, Guards& guards) {
  if (guards.energy_stop < guards.energy_warning)
    fault(at(map, has(map, "energy_stop") ? "energy_stop" : "energy_warning"),
          "out of range: the run would stop before it warns; expected energy_stop, at least energy_warning");
  if (guards.depth_stop < guards.depth_warning)
    fault(at(map, has(map, "depth_stop") ? "depth_stop" : "depth_warning"),
          "out of range: the run would stop before it warns; expected depth_stop, at least depth_warning");
}

}  // namespace

const Table<Guards> guards_keys{
    "guards",
    "a map of thresholds, such as {energy_stop: 0.1}",
    {
        {"energy_warning", value(&Guards::energy_warning, positive), "-",
         "Share of the largest energy, of a false energy or a change of `total`: warning."},
        {"energy_stop", value(&Guards::energy_stop, positive), "-",
         "Likewise: stop with exit code 3. At least `energy_warning`."},
        {"kinetic", value(&Guards::kinetic, positive), "-", "Kinetic energy over the energy that was supplied: stop."},
        {"depth_warning", value(&Guards::depth_warning, positive), "-",
         "Depth of nodes and edges in other bodies, in elements: warning."},
        {"depth_stop", value(&Guards::depth_stop, positive), "-", "Likewise: stop. At least `depth_warning`."},
        {"depth_step", value(&Guards::depth_step, positive), "-",
         "Likewise, deeper than at the start of an implicit step: the step is halved."},
        {"parted", value(&Guards::parted, positive), "-",
         "`contact` of bodies that are apart again, over their largest energy: warning."},
        {"hourglass", value(&Guards::hourglass, positive), "-",
         "`hourglass` over the largest internal energy: warning."},
        {"angular_momentum", value(&Guards::angular_momentum, positive), "-",
         "`angular_momentum_error` in summary.json: warning."},
    },
    judge_guards,
};

}  // namespace brunt::scene
