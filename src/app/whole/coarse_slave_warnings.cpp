// SPDX-License-Identifier: Apache-2.0
#include "coarse_slave_warnings.hpp"

#include <fmt/core.h>

#include "scene/build/build.hpp"
#include "setup/coarse_slaves.hpp"
#include "start_rules.hpp"

namespace brunt::app {
namespace {

std::string describe(const scene::Input& input, const std::string& slave, const std::string& master, double coarse,
                     double fine) {
  const std::string finer = fmt::format(
      "{}: part '{}' is the slave of '{}', whose faces are much finer in the contact region (edges of {:.3g} against "
      "{:.3g})",
      input.at(scene::contact_key(input, slave, master) + ".slave"), slave, master, fine, coarse);
  return finer + fmt::format(
                     ": its nodes penetrate or pass between those of '{}', and max_penetration does not count them; "
                     "use slave: {}, or passes: two",
                     slave, master);
}

}  // namespace

std::vector<std::string> warn_of_coarse_slaves(const scene::Input& input, const mesh::CanonicalMesh& whole) {
  std::vector<std::string> warnings;
  const setup::StartRules rules = start_rules(input, whole.mesh);
  if (!rules.contact.pairs.forces_a_side()) return warnings;
  const std::vector<std::string> part = block_materials(input, whole.mesh).part;
  const FirstMotion motion = first_motion(input, whole);
  for (const setup::CoarseSlave& pair : setup::coarse_slaves(whole.mesh, rules, motion.velocity, motion.duration)) {
    const auto slave = static_cast<std::int32_t>(pair.slave), master = static_cast<std::int32_t>(pair.master);
    if (rules.contact.pairs.at(slave, master).tied != contact::Tied::no) continue;  // either side carries a tie
    warnings.push_back(describe(input, part[pair.slave], part[pair.master], pair.coarse, pair.fine));
  }
  return warnings;
}

}  // namespace brunt::app
