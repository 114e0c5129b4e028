// SPDX-License-Identifier: Apache-2.0
// Probes: quantities that the history records in addition to energies and momentum.
#include <fmt/format.h>

#include <algorithm>

#include "core/excerpt.hpp"
#include "scene/read/sections.hpp"
#include "scene/text/commas.hpp"

namespace brunt::scene {
namespace {

using Kind = Probe::Kind;

/// The name of a probe is part of column headers in a table of comma-separated values.
void read_probe_name(const Key& key, Probe& probe) {
  if (!read(key, probe.name, "a name")) return;
  const bool good = std::none_of(probe.name.begin(), probe.name.end(), [](char c) {
    return (static_cast<unsigned char>(c) < 0x80 && std::string_view("_-.").find(c) == std::string_view::npos) &&
           !(c >= '0' && c <= '9') && !(c >= 'a' && c <= 'z') && !(c >= 'A' && c <= 'Z');
  });
  if (!good)
    fault(key,
          fmt::format("invalid name '{}' of a column; expected letters, digits, '_', '-' or '.'", excerpt(probe.name)));
}

/// A number, or the prefix of a mesh file and a number.
void read_node(const Key& key, Probe& probe) {
  constexpr GlobalIndex most = 1'000'000'000'000;
  const std::string text = is_value(key) ? key.tree->text : "";
  GlobalIndex node = 0;
  if (scene::is_number(text) || text.find(',') != std::string::npos) {
    if (read(key, node, Count{0, most})) probe.where = std::to_string(node);
  } else if (!text.empty() && text.back() >= '0' && text.back() <= '9') {
    probe.where = text;
  } else {
    wrong(key, fmt::format("an integer from 0 to {}, or the prefix of a mesh file and a number", most));
  }
}

/// A part against all others, against another one, or against itself.
void read_touching(const Key& key, Probe& probe) {
  if (!is_list(key)) {
    read(key, probe.where, Named::part);
    return;
  }
  const std::vector<Key> parts = items(key, "a part a, two parts [a, b], or [a, a] for self-contact", 2);
  if (parts.size() == 2 && read(parts[0], probe.where, Named::part)) read(parts[1], probe.other, Named::part);
}

/// The parts whose elements count: `part` or `parts`.
void read_one_part(const Key& key, Probe& probe) {
  std::string name;
  if (read(key, name, Named::part)) probe.parts.push_back(name);
}
void read_many_parts(const Key& key, Probe& probe) {
  for (const Key& part : items(key, "a list of parts [a, b]")) read_one_part(part, probe);
}

void judge_section(const Key& map, Probe&) {
  demand_one(map, {"part", "parts"}, "missing part; expected part: name, or parts: [a, b]",
             "invalid section: part and parts are both given; expected one of them");
  const bool plane = has(map, "point") || has(map, "normal");
  if (has(map, "set") && plane)
    fault(map, "invalid section: set and a plane are both given; expected set: name, or point and normal");
  if (has(map, "set")) return;
  demand(map, "point", "three numbers [x, y, z]");
  demand(map, "normal", "three numbers [x, y, z], not all zero");
}

const Table<Probe> section_keys{
    "probes.section",
    "a map {part: name, point: [x, y, z], normal: [x, y, z]}, or {part: name, set: name}",
    {
        {"part", special("name", read_one_part), "-", "Part whose elements count.", "required, or `parts`"},
        {"parts", special("list", read_many_parts), "-", "Several parts.", "required, or `part`"},
        {"point", value(&Probe::point, Vector::any), "length", "Point of the plane, in the initial configuration.",
         "required, or `set`"},
        {"normal", value(&Probe::normal, Vector::direction), "-", "Normal of the plane; tension along it is positive.",
         "required, or `set`"},
        {"set", value(&Probe::where, Text{"name", "the name of a set"}), "-",
         "In place of the plane: nodes at an end or side of the parts."},
        {"about", value(&Probe::about, Vector::any), "length",
         "Reference point of the moment; by default the mean current position of the nodes of the section.",
         "mean position"},
    },
    judge_section,
};

/// The judge reads it, when the place is known.
void read_later(const Key&, Probe&) {}

void read_field(const Key& key, Probe& probe) {
  std::vector<std::string> fields{"displacement", "velocity", "position"};
  for (const char* turning : {"rotation", "angular_velocity"}) fields.emplace_back(turning);
  if (probe.kind == Kind::set || probe.kind == Kind::part)
    for (const char* of_supports : {"reaction", "reaction_moment"}) fields.emplace_back(of_supports);
  if (probe.kind == Kind::part)
    for (const char* sum : {"mass", "force", "moment", "center", "momentum", "angular_momentum", "energy"})
      fields.emplace_back(sum);
  const std::size_t chosen = read_choice(key, fields, {});
  if (chosen < fields.size()) probe.field = fields[chosen];
}

void read_field_of_joint(const Key& key, Probe& probe) {
  const std::vector<std::string> fields{"force", "moment", "angle", "gap"};
  const std::size_t chosen = read_choice(key, fields, {});
  if (chosen < fields.size()) probe.field = fields[chosen];
}

/// The place: a node, the nodes of a part or set, or what has a force of its own. `near` may name a part or set too.
std::vector<Kind> places_of(const Key& map) {
  std::vector<Kind> given;
  const bool near = has(map, "near"), part = has(map, "part");
  if (has(map, "node")) given.push_back(Kind::node);
  if (near) given.push_back(Kind::near);
  if (!near && (part || has(map, "set"))) given.push_back(part ? Kind::part : Kind::set);
  if (has(map, "wall")) given.push_back(Kind::wall);
  if (has(map, "contact")) given.push_back(Kind::contact);
  if (has(map, "section")) given.push_back(Kind::section);
  if (has(map, "joint")) given.push_back(Kind::joint);
  return given;
}

void judge_probe(const Key& map, Probe& probe) {
  const std::vector<Kind> given = places_of(map);
  if (given.size() != 1) {
    const std::string what = fmt::format(
        "invalid probe: {} places are given; expected one of node, near, set, part, wall, contact, "
        "section, joint",
        given.size());
    return given.empty() ? lacking(map, {"node", "near", "set", "part", "wall", "contact", "section", "joint"}, what)
                         : fault(map, what);
  }
  probe.kind = given.front();
  if (has(map, "part") && has(map, "set"))
    fault(map, "invalid selection: part and set are both given; expected one of them");
  if (probe.kind == Kind::wall || probe.kind == Kind::contact || probe.kind == Kind::section)
    refuse_any(map, {"field"}, "invalid for a force; expected no such key");
  else if (probe.kind == Kind::joint)
    read_field_of_joint(at(map, "field"), probe);
  else
    read_field(at(map, "field"), probe);
  if (probe.field != "angular_momentum")
    refuse_any(map, {"about"}, "invalid without field: angular_momentum; expected no such key");
}

}  // namespace

const Table<Probe> probe_keys{
    "probes",
    "{name: ..., node: ..., field: ...}",
    {
        {"name", special("name", read_probe_name), "-", "Letters, digits, `_`, `-` and `.`; unique.", required},
        {"node", special("integer >= 0 or name", read_node), "-",
         "Number of a node in the mesh file; with several files the prefix of the file and the number, such as `a_17`.",
         "required, or another place"},
        {"near", value(&Probe::point, Vector::any), "length",
         "The nearest node at the start, of all nodes or of a `part` or `set`.", "required, or another place"},
        {"set", value(&Probe::where, Text{"name", "the name of a set or part"}), "-",
         "Set whose nodes are averaged or summed.", "required, or another place"},
        {"part", value(&Probe::where, Named::part), "-", "Part whose nodes or elements are averaged or summed.",
         "required, or another place"},
        {"wall", value(&Probe::where, Named::wall), "-", "Rigid wall: its force on the bodies.",
         "required, or another place"},
        {"contact", special("name or list of 2 parts", read_touching), "-",
         "Contact force on part a: from all others (`a`), from part b (`[a, b]`), or from itself (`[a, a]`).",
         "required, or another place"},
        {"section", map_of(section_keys), "-", "Force and moment through a cross section.",
         "required, or another place"},
        {"joint", value(&Probe::where, Named::joint), "-", "Joint between rigid parts.", "required, or another place"},
        {"field", special("word", read_later), "-", "Quantity, see the next table.",
         "required for nodes, sets, parts and joints"},
        {"about", value(&Probe::about, Vector::any), "length", "Reference point of `angular_momentum`.", "origin"},
    },
    judge_probe,
};

}  // namespace brunt::scene
