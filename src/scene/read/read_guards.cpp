// SPDX-License-Identifier: Apache-2.0
// `guards`: thresholds of warnings and of stops.
#include "scene/guards.hpp"
#include "scene/read/sections.hpp"

namespace brunt::scene {

void read_guards(Section& scene, Input& input) {
  if (!scene.has("guards")) return;
  Section section(scene.at("guards"), "a map of thresholds, such as {energy_stop: 0.1}");
  if (!section.is_map()) return;
  Guards& guards = input.guards;
  section.optional("energy_warning", guards.energy_warning, positive);
  section.optional("energy_stop", guards.energy_stop, positive);
  section.optional("kinetic", guards.kinetic, positive);
  section.optional("depth_warning", guards.depth_warning, positive);
  section.optional("depth_stop", guards.depth_stop, positive);
  section.optional("depth_step", guards.depth_step, positive);
  section.optional("parted", guards.parted, positive);
  section.optional("hourglass", guards.hourglass, positive);
  section.optional("angular_momentum", guards.angular_momentum, positive);
  if (guards.energy_stop < guards.energy_warning)
    fault(section.has("energy_stop") ? section.at("energy_stop") : section.at("energy_warning"),
          "out of range: the run would stop before it warns; expected energy_stop, at least energy_warning");
  if (guards.depth_stop < guards.depth_warning)
    fault(section.has("depth_stop") ? section.at("depth_stop") : section.at("depth_warning"),
          "out of range: the run would stop before it warns; expected depth_stop, at least depth_warning");
}

}  // namespace brunt::scene
