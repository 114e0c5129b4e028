// SPDX-License-Identifier: Apache-2.0
#include "scene/text/tree.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <sstream>

#include "commas.hpp"
#include "core/excerpt.hpp"
#include "other_file.hpp"
#include "yaml_document.hpp"

namespace brunt::scene {
namespace {

std::string join(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + "." + key;
}

using Entry = std::pair<std::string, std::string>;

/// "density:7800" as a key and its value: a word, a colon and no space. (Not a time of day, and not an address.)
std::optional<Entry> joined_entry(std::string_view text) {
  const auto is_word = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  std::size_t colon = 0;
  while (colon < text.size() && is_word(text[colon])) ++colon;
  if (colon == 0 || colon + 1 >= text.size() || text[colon] != ':') return {};
  const std::string_view value = text.substr(colon + 1, text.find(' ', colon) - colon - 1);
  if (value.empty() || value.front() == '/' || value.front() == ':') return {};
  return Entry{text.substr(0, colon), value};
}

std::string no_blank(const Entry& entry) {
  return fmt::format("missing space after the colon of '{0}:{1}'; expected {0}: {1}", excerpt(entry.first),
                     excerpt(entry.second));
}

/// Converts YAML nodes to Tree. Without line numbers (an override), every piece has the place `base`.
struct Converter {
  const Place& base;
  Faults& faults;

  [[nodiscard]] Place place(const YAML::Mark& mark) const {
    return base.line == 0 || mark.is_null() ? base : Place{base.source, mark.line + 1};
  }

  Tree convert(const YAML::Node& node, const Place& at, const std::string& path) {
    Tree tree;
    tree.place = at;
    if (node.IsScalar()) {
      tree.kind = Tree::Kind::value;
      tree.text = node.Scalar();
      tree.quoted = node.Tag() == "!";
      if (!tree.quoted && path != "title") report_joined(tree, path);
    } else if (node.IsSequence()) {
      tree.kind = Tree::Kind::list;
      for (const YAML::Node& child : node) {
        tree.children.push_back(convert(child, place(child.Mark()), join(path, std::to_string(tree.children.size()))));
      }
    } else if (node.IsMap()) {
      tree.kind = Tree::Kind::map;
      for (const auto& entry : node) add(tree, entry.first, entry.second, path);
    }
    return tree;
  }

  /// "elastic density:7800": YAML joins a line without a space after its colon with the text of the previous line.
  void report_joined(const Tree& value, const std::string& path) {
    for (std::size_t blank = value.text.find(' '); blank != std::string::npos; blank = value.text.find(' ', blank + 1))
      if (const auto joined = joined_entry(std::string_view(value.text).substr(blank + 1))) {
        faults.add(value.place, path, no_blank(*joined));
        return;
      }
  }

  void add(Tree& map, const YAML::Node& key, const YAML::Node& value, const std::string& path) {
    const Place at = place(key.Mark());
    if (!key.IsScalar()) {
      faults.add(at, path, "invalid key: not plain text; expected key: value");
      return;
    }
    const std::string& name = key.Scalar();
    if (const auto joined = joined_entry(name); joined && value.IsNull()) {
      faults.add(at, join(path, joined->first), no_blank(*joined));
      if (map.find(joined->first) != nullptr) return;
      map.keys.push_back(joined->first);  // continue as intended, so that the key is not reported as missing
      map.children.push_back(Tree{.kind = Tree::Kind::value, .text = joined->second, .place = at});
      return;
    }
    if (!map.children.empty() && value.IsNull() && map.children.back().place.line == at.line &&
        is_rest_of_number(map.children.back(), name)) {
      map.children.back().text += "," + name;  // reported where the number is read
      return;
    }
    if (const Tree* first = map.find(name)) {
      const std::string before = first->place.line > 0 ? fmt::format(" (first in line {})", first->place.line) : "";
      faults.add(at, join(path, name), fmt::format("invalid key: given twice{}; expected each key once", before));
      return;
    }
    map.keys.push_back(name);
    map.children.push_back(convert(value, at, join(path, name)));
  }
};

/// YAML forbids tabs as indentation; the parser would accept some of them as part of a value.
bool indented_by_tabs(const std::string& text, const std::string& file, Faults& faults) {
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#') continue;
    if (line.find('\t') >= first) continue;
    faults.add({file, number}, "", "invalid indentation by a tab; expected spaces");
    return true;
  }
  return false;
}

}  // namespace

const Tree* Tree::find(std::string_view key) const {
  const auto found = std::find(keys.begin(), keys.end(), key);
  return found == keys.end() ? nullptr : &nth(children, found - keys.begin());
}

Tree* Tree::find(std::string_view key) {
  return const_cast<Tree*>(static_cast<const Tree&>(*this).find(key));
}

Tree parse_yaml(const std::string& text, const std::string& file, Faults& faults) {
  const Place start{file, 1};
  if (const std::string other = fault_of_other_file(text, file); !other.empty()) {
    faults.add(start, "", other);
    return {};
  }
  if (text.find('\0') != std::string::npos) {
    faults.add(start, "", "cannot read the scene: the file contains zero bytes; expected text in YAML");
    return {};
  }
  if (indented_by_tabs(text, file, faults)) return {};
  const std::optional<YAML::Node> document = load_yaml(text, start, faults);
  if (!document) return {};
  if (document->IsNull()) {
    faults.add(
        start, "",
        "cannot read the scene: the file is empty or has no keys; expected units, mesh, materials, parts and run");
    return {};
  }
  return Converter{start, faults}.convert(*document, start, "");
}

std::optional<Tree> parse_value(const std::string& text, const Place& place, Faults& faults) {
  const std::optional<YAML::Node> document = load_yaml(text, place, faults);
  if (!document) return {};
  return Converter{place, faults}.convert(*document, place, "");
}

}  // namespace brunt::scene
