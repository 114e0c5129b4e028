// SPDX-License-Identifier: Apache-2.0
#include "info_keys.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "io/json_text.hpp"
#include "scene/keys/described.hpp"

namespace brunt::app {
namespace {

/// Markdown without marks of code and targets of links.
std::string plain(const std::string& markdown) {
  static const std::regex link(R"(\[([^\]]*)\]\([^)]*\))"), code("`");
  return std::regex_replace(std::regex_replace(markdown, link, "$1"), code, "");
}

std::string one_key(const scene::Described& map, const scene::Said& said) {
  const std::string path = map.name == "scene" ? said.key : map.name + "." + said.key;
  const std::string of = said.of.empty() ? "" : fmt::format(" ({})", fmt::join(said.of, ", "));
  const std::string unit = said.unit == "-" ? "" : fmt::format(" [{}]", said.unit);
  const bool stated = said.fallback.starts_with("required");
  return fmt::format("{}{}: {}{}; {}{}\n    {}\n", path, of, plain(said.type), unit, stated ? "" : "default ",
                     plain(said.fallback), plain(said.meaning));
}

}  // namespace

std::string keys_as_text() {
  std::string text;
  for (const scene::Described* map : scene::all_keys())
    for (const scene::Said& said : map->rows) text += one_key(*map, said);
  return text;
}

std::string keys_as_json() {
  nlohmann::ordered_json maps = nlohmann::ordered_json::array();
  for (const scene::Described* map : scene::all_keys()) {
    nlohmann::ordered_json keys = nlohmann::ordered_json::array();
    for (const scene::Said& said : map->rows)
      keys.push_back({{"key", said.key},
                      {"of", said.of},
                      {"type", said.type},
                      {"unit", said.unit},
                      {"default", said.fallback},
                      {"meaning", said.meaning}});
    maps.push_back({{"map", map->name}, {"keys", std::move(keys)}});
  }
  return io::json_text(maps, 1) + "\n";
}

}  // namespace brunt::app
