// SPDX-License-Identifier: Apache-2.0
// Probes: quantities that the history records in addition to energies and momentum.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/excerpt.hpp"
#include "scene/read/sections.hpp"
#include "scene/text/commas.hpp"

namespace brunt::scene {
namespace {

using Kind = Probe::Kind;

/// The name of a probe is part of column headers in a table of comma-separated values.
void read_name(Section& entry, Probe& probe) {
  if (!entry.required("name", probe.name, "a name")) return;
  const bool good = std::none_of(probe.name.begin(), probe.name.end(), [](char c) {
    return (static_cast<unsigned char>(c) < 0x80 && std::string_view("_-.").find(c) == std::string_view::npos) &&
           !(c >= '0' && c <= '9') && !(c >= 'a' && c <= 'z') && !(c >= 'A' && c <= 'Z');
  });
  if (!good) {
    fault(entry.at("name"),
          fmt::format("invalid name '{}' of a column; expected letters, digits, '_', '-' or '.'", excerpt(probe.name)));
  }
}

void read_field(Section& entry, Probe& probe) {
  std::vector<std::string> fields{"displacement", "velocity", "position"};
  if (probe.kind == Kind::set || probe.kind == Kind::part) fields.emplace_back("reaction");
  if (probe.kind == Kind::part)
    for (const char* sum : {"mass", "rotation", "angular_velocity", "force", "moment", "reaction_moment", "center",
                            "momentum", "angular_momentum", "energy"})
      fields.emplace_back(sum);
  const std::size_t chosen = read_choice(entry.at("field"), fields, {});
  if (chosen < fields.size()) probe.field = fields[chosen];
  if (probe.field == "angular_momentum" && entry.has("about")) {
    Vec3 about = Vec3::Zero();
    if (entry.required("about", about, Vector::any)) probe.about = about;
  }
}

/// The parts whose elements count: `part` or `parts`.
void read_section_parts(Section& section, Probe& probe) {
  const bool one = section.has("part"), many = section.has("parts");
  if (one == many) {
    const std::string what = one ? "invalid section: part and parts are both given; expected one of them"
                                 : "missing part; expected part: name, or parts: [a, b]";
    return one ? fault(section.key(), what) : lacking(section.key(), {"part", "parts"}, what);
  }
  std::string name;
  if (one && section.required("part", name, Named::part)) probe.parts.push_back(name);
  if (many)
    for (const Key& key : items(section.at("parts"), "a list of parts [a, b]"))
      if (read(key, name, Named::part)) probe.parts.push_back(name);
}

void read_section(const Key& key, Probe& probe) {
  Section section(key, "a map {part: name, point: [x, y, z], normal: [x, y, z]}, or {part: name, set: name}");
  if (!section.is_map()) return;
  read_section_parts(section, probe);
  const bool set = section.has("set"), plane = section.has("point") || section.has("normal");
  if (set && plane) {
    fault(section.key(), "invalid section: set and a plane are both given; expected set: name, or point and normal");
  } else if (set) {
    section.required("set", probe.where, "the name of a set");
  } else {
    section.required("point", probe.point, Vector::any);
    section.required("normal", probe.normal, Vector::direction);
  }
  if (section.has("about")) {
    Vec3 about = Vec3::Zero();
    if (section.required("about", about, Vector::any)) probe.about = about;
  }
}

/// A part against all others, against another one, or against itself.
void read_parts(const Key& key, Probe& probe) {
  const bool one = key.tree == nullptr || key.tree->kind != Tree::Kind::list;
  if (one) {
    read(key, probe.where, Named::part);
    return;
  }
  const std::vector<Key> parts = items(key, "a part a, two parts [a, b], or [a, a] for self-contact", 2);
  if (parts.size() != 2) return;
  if (read(parts[0], probe.where, Named::part)) read(parts[1], probe.other, Named::part);
}

/// A number, or the prefix of a mesh file and a number.
void read_node(Section& entry, Probe& probe) {
  constexpr GlobalIndex most = 1'000'000'000'000;
  const Key key = entry.at("node");
  const bool is_value = key.tree != nullptr && key.tree->kind == Tree::Kind::value;
  const std::string text = is_value ? key.tree->text : "";
  GlobalIndex node = 0;
  if (scene::is_number(text) || text.find(',') != std::string::npos) {
    if (read(key, node, Count{0, most})) probe.where = std::to_string(node);
  } else if (!text.empty() && text.back() >= '0' && text.back() <= '9') {
    probe.where = text;
  } else {
    wrong(key, fmt::format("an integer from 0 to {}, or the prefix of a mesh file and a number", most));
  }
}

/// The node nearest to a point, of all nodes or of a part or set.
void read_near(Section& entry, Probe& probe) {
  probe.kind = Kind::near;
  entry.required("near", probe.point, Vector::any);
  if (entry.has("part") || entry.has("set")) read_selection(entry, probe.where);
}

/// Of a joint, its name and a field.
void read_joint(Section& entry, Probe& probe) {
  probe.kind = Kind::joint;
  entry.required("joint", probe.where, Named::joint);
  const std::vector<std::string> fields{"force", "moment", "angle", "gap"};
  const std::size_t chosen = read_choice(entry.at("field"), fields, {});
  if (chosen < fields.size()) probe.field = fields[chosen];
}

void read_place(Section& entry, Probe& probe) {
  const bool near = entry.has("near"), part = entry.has("part"), set = entry.has("set");
  const std::array given{
      entry.has("node"), near, !near && (part || set), entry.has("wall"), entry.has("contact"), entry.has("section"),
      entry.has("joint")};
  const auto places = std::ranges::count(given, true);
  if (given[0]) read_node(entry, probe);
  if (given[1]) read_near(entry, probe);
  if (given[2]) {
    probe.kind = part ? Kind::part : Kind::set;
    read_selection(entry, probe.where);
  }
  if (given[3]) {
    probe.kind = Kind::wall;
    entry.required("wall", probe.where, Named::wall);
  }
  if (given[4]) {
    probe.kind = Kind::contact;
    read_parts(entry.at("contact"), probe);
  }
  if (given[5]) {
    probe.kind = Kind::section;
    read_section(entry.at("section"), probe);
  }
  if (given[6]) read_joint(entry, probe);
  if (places != 1) {
    entry.has("field");  // a known key at any place
    const std::string what = fmt::format(
        "invalid probe: {} places are given; expected one of node, near, set, part, wall, contact, section, joint",
        places);
    return places > 0
               ? fault(entry.key(), what)
               : lacking(entry.key(), {"node", "near", "set", "part", "wall", "contact", "section", "joint"}, what);
  }
  if (!given[3] && !given[4] && !given[5] && !given[6]) read_field(entry, probe);
}

}  // namespace

void read_probes(Section& scene, Input& input) {
  if (!scene.has("probes")) return;
  for (const Key& key : items(scene.at("probes"), "a list of {name: ..., node: ..., field: ...}")) {
    Section entry(key, "a map {name: ..., node: ..., field: ...}");
    if (!entry.is_map()) continue;
    Probe probe;
    read_name(entry, probe);
    read_place(entry, probe);
    input.probes.push_back(std::move(probe));
  }
}

}  // namespace brunt::scene
