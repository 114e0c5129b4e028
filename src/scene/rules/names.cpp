// SPDX-License-Identifier: Apache-2.0
// Checks that require the complete scene: names that are used must be defined, and only once, and every body must have
// a part. Sets and blocks of mesh files are unknown here; they are checked when the model is built.
#include <fmt/format.h>

#include <algorithm>

#include "core/excerpt.hpp"
#include "scene/build/build.hpp"
#include "scene/build/rigid_parts.hpp"
#include "scene/curve.hpp"
#include "scene/rules/rules.hpp"
#include "scene/text/nearest.hpp"

namespace brunt::scene {
namespace {

std::vector<std::string> defined(const Input& input, Named kind) {
  std::vector<std::string> names;
  switch (kind) {
    case Named::material:
      for (const auto& [name, law] : input.materials) names.push_back(name);
      break;
    case Named::curve:
      for (const auto& [name, curve] : input.curves) names.push_back(name);
      break;
    case Named::part:
      for (const Part& part : input.parts) names.push_back(part.name);
      break;
    case Named::wall:
      for (const RigidWall& wall : input.rigid_walls) names.push_back(wall.name);
      break;
    case Named::joint:
      for (const Joint& joint : input.joints) names.push_back(joint.name);
      break;
  }
  return names;
}

/// Names of a missing required section are not reported separately.
void judge_uses(const Key& scene, const Input& input) {
  Findings& findings = *scene.findings;
  constexpr std::array words{"material", "curve", "part", "rigid wall", "joint"};
  constexpr std::array sections{"materials", "curves", "parts", "rigid_walls", "joints"};
  for (const Reference& use : findings.references) {
    const auto kind = static_cast<std::size_t>(use.kind);
    const std::vector<std::string> names = defined(input, use.kind);
    if (std::find(names.begin(), names.end(), use.name) != names.end()) continue;
    const bool required = use.kind == Named::material || use.kind == Named::part;
    if (required && !has(scene, sections[kind])) continue;
    const std::string what = fmt::format("unknown {} '{}'", words[kind], excerpt(use.name));
    const std::string expected =
        names.empty() ? fmt::format("; expected a name defined in {}, which is empty", sections[kind])
                      : fmt::format("{}; expected one of {}", did_you_mean(use.name, names), listed(names));
    findings.faults.add(use.place, use.path, what + expected);
  }
}

std::string generated_part(const MeshEntry& entry) {
  return std::visit(
      [](const auto& body) -> std::string {
        if constexpr (requires { body.part; }) return body.part;
        return {};
      },
      entry.body);
}

bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

/// Every generated body needs a part; if the whole mesh is generated, every part needs a body.
void judge_bodies(const Key& scene, const Input& input) {
  std::vector<std::string> bodies;
  bool any_file = input.mesh.empty();
  const Key mesh = at(scene, "mesh");
  std::size_t position = 0;
  for (const MeshEntry& entry : input.mesh) {
    any_file = any_file || std::holds_alternative<MeshFile>(entry.body);
    const std::string part = generated_part(entry);
    const Key key = is_list(mesh) ? at(mesh, position++) : mesh;
    if (part.empty()) continue;
    if (std::find(bodies.begin(), bodies.end(), part) != bodies.end()) {
      fault(key, fmt::format("invalid body: part '{}' already has one; expected a part of its own for each body",
                             excerpt(part)));
      continue;
    }
    bodies.push_back(part);
    const bool has_part =
        std::any_of(input.parts.begin(), input.parts.end(), [&](const Part& known) { return known.block == part; });
    if (!has_part && !input.parts.empty()) {
      fault(key, fmt::format("missing part of the generated body '{0}'; expected parts: {{{0}: {{material: ...}}}}",
                             excerpt(part)));
    }
  }
  for (const Part& part : input.parts) {
    if (any_file || is_number(part.block)) continue;
    if (std::find(bodies.begin(), bodies.end(), part.block) != bodies.end()) continue;
    fault(at(at(scene, "parts"), part.name),
          fmt::format("unknown block '{}'{}: no body of the mesh has this name; expected one of {}",
                      excerpt(part.block), did_you_mean(part.block, bodies), listed(bodies)));
  }
}

/// A displacement is measured from the initial position: a curve with another initial value would be a jump.
void judge_displacements(const Key& scene, const Input& input) {
  for (std::size_t k = 0; k < input.prescribed.size(); ++k) {
    const Prescribed& motion = input.prescribed[k];
    const auto curve = input.curves.find(motion.curve);
    if (motion.gives != Prescribed::Gives::displacement || curve == input.curves.end()) continue;
    const double start = value_at(curve->second, 0.0);
    if (start == 0) continue;
    fault(at(at(scene, "prescribed"), k),
          fmt::format("invalid curve '{}': its displacement at t = 0 is {:g}, a jump of the nodes; expected 0 at t = 0",
                      excerpt(motion.curve), start));
  }
}

/// The fault of a probe of contact with known parts; empty if it is valid. Columns that could only contain zeros are
/// faults.
std::string fault_of_contact_probe(const Input& input, const Probe& probe) {
  const auto touches = [&](const std::string& other) { return deciding_entry(input, probe.where, other).has_value(); };
  if (input.contact.empty())
    return "invalid probe: the scene has no contact; expected parts between which contact is defined";
  if (probe.other == probe.where && !touches(probe.where))
    return fmt::format(
        "invalid probe: part '{0}' has no contact with itself; expected an entry of contact with between: all, or "
        "between: [{0}, {0}]",
        excerpt(probe.where));
  if (!probe.other.empty() && probe.other != probe.where && !touches(probe.other))
    return fmt::format(
        "invalid probe: no entry of contact covers '{}' and '{}'; expected parts between which contact is defined",
        excerpt(probe.where), excerpt(probe.other));
  const auto is_met = [&](const Part& part) { return part.name != probe.where && touches(part.name); };
  if (probe.other.empty() && std::ranges::none_of(input.parts, is_met))
    return fmt::format(
        "invalid probe: part '{}' has no contact with any other part; expected a part with contact to another one",
        excerpt(probe.where));
  return {};
}

void judge_contact_probes(const Key& scene, const Input& input) {
  const auto known = [&](const std::string& name) {
    return name.empty() || std::ranges::find(input.parts, name, &Part::name) != input.parts.end();
  };
  for (std::size_t k = 0; k < input.probes.size(); ++k) {
    const Probe& probe = input.probes[k];
    if (probe.kind != Probe::Kind::contact || probe.where.empty() || !known(probe.where) || !known(probe.other))
      continue;
    const std::string what = fault_of_contact_probe(input, probe);
    if (!what.empty()) fault(at(at(at(scene, "probes"), k), "contact"), what);
  }
}

/// Warns of keys that apply to deformable elements only.
void warn_of_unused_keys(const Key& scene, const Input& input) {
  for (const Part& part : input.parts)
    if (names_rigid_part(input, part.name))
      for (const char* name : {"element", "hourglass", "bulk"})
        if (const Key map = at(at(scene, "parts"), part.name); has(map, name))
          warn(at(map, name), "no effect, since the part is rigid");
}

/// A name with two meanings.
void judge_twice(const Key& section, const std::vector<std::string>& names, std::string_view what) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) ==
        names.begin() + static_cast<std::ptrdiff_t>(i)) {
      continue;
    }
    const Tree& entry = section.tree->children[std::min(i, section.tree->children.size() - 1)];
    section.findings->faults.add(
        entry.place, fmt::format("{}.{}", section.path, i),
        fmt::format("invalid name '{}': used twice; expected a name of its own for each {}", excerpt(names[i]), what));
  }
}

}  // namespace

void judge_names(const Key& scene, const Input& input) {
  judge_uses(scene, input);
  judge_bodies(scene, input);
  judge_displacements(scene, input);
  judge_contact_probes(scene, input);
  warn_of_unused_keys(scene, input);
  std::vector<std::string> probes;
  for (const Probe& probe : input.probes) probes.push_back(probe.name);
  judge_twice(at(scene, "probes"), probes, "probe");
  judge_twice(at(scene, "joints"), defined(input, Named::joint), "joint");
  judge_twice(at(scene, "rigid_walls"), defined(input, Named::wall), "rigid wall");
  const std::vector<std::string> parts = defined(input, Named::part);
  for (const SetEntry& set : input.sets)
    if (std::find(parts.begin(), parts.end(), set.name) != parts.end())
      fault(at(at(scene, "sets"), set.name), "invalid name: a part has the same name; expected another name");
}

}  // namespace brunt::scene
