// SPDX-License-Identifier: Apache-2.0
// Probes: what the history records beside energies and momentum.
#include <fmt/format.h>

#include <algorithm>

#include "brunt/scene/sections.hpp"

namespace brunt::scene {
namespace {

using Kind = Probe::Kind;

/// A probe's name heads columns of a table of comma-separated values.
void read_name(Section& entry, Probe& probe) {
  if (!entry.required("name", probe.name, "a name")) return;
  const bool good = std::none_of(probe.name.begin(), probe.name.end(), [](char c) {
    return (static_cast<unsigned char>(c) < 0x80 && std::string_view("_-.").find(c) == std::string_view::npos) &&
           !(c >= '0' && c <= '9') && !(c >= 'a' && c <= 'z') && !(c >= 'A' && c <= 'Z');
  });
  if (!good) {
    fault(entry.at("name"), fmt::format("'{}' cannot head a column; accepted: letters, digits, _, -, .", probe.name));
  }
}

void read_field(Section& entry, Probe& probe) {
  std::vector<std::string> fields{"displacement", "velocity", "position"};
  if (probe.kind == Kind::set) fields.emplace_back("reaction");
  const std::size_t chosen = read_choice(entry.at("field"), fields, {});
  if (chosen < fields.size()) probe.field = fields[chosen];
}

void read_parts(const Key& key, Probe& probe) {
  const std::vector<Key> parts = items(key, "two parts [a, b]", 2);
  if (parts.size() != 2) return;
  const bool good = read(parts[0], probe.where, Named::part) && read(parts[1], probe.other, Named::part);
  if (good && probe.where == probe.other) fault(key, "the parts are the same; accepted: two different parts [a, b]");
}

void read_place(Section& entry, Probe& probe) {
  int places = 0;
  if (entry.has("node")) {
    ++places;
    GlobalIndex node = 0;
    if (entry.required("node", node, Count{0, 1'000'000'000'000})) probe.where = std::to_string(node);
  }
  if (entry.has("set") || entry.has("part")) {
    ++places;
    probe.kind = Kind::set;
    read_selection(entry, probe.where);
  }
  if (entry.has("wall")) {
    ++places;
    probe.kind = Kind::wall;
    entry.required("wall", probe.where, Named::wall);
  }
  if (entry.has("contact")) {
    ++places;
    probe.kind = Kind::contact;
    read_parts(entry.at("contact"), probe);
  }
  if (places != 1) {
    entry.has("field");  // known, whatever the place
    const std::string what = fmt::format("{} places to probe; accepted: one of node, set, part, wall, contact", places);
    return places > 0 ? fault(entry.key(), what)
                      : lacking(entry.key(), {"node", "set", "part", "wall", "contact"}, what);
  }
  if (probe.kind == Kind::node || probe.kind == Kind::set) read_field(entry, probe);
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
