// SPDX-License-Identifier: Apache-2.0
#include "brunt/scene/tree.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <sstream>

#include "commas.hpp"

namespace brunt::scene {
namespace {

std::string join(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + "." + key;
}

/// Turns YAML's nodes into ours. Without a line number of its own (an override), every piece stands at `base`.
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

  void add(Tree& map, const YAML::Node& key, const YAML::Node& value, const std::string& path) {
    const Place at = place(key.Mark());
    if (!key.IsScalar()) {
      faults.add(at, path, "a key is no plain text; accepted: key: value");
      return;
    }
    const std::string& name = key.Scalar();
    if (!map.children.empty() && value.IsNull() && map.children.back().place.line == at.line &&
        is_rest_of_number(map.children.back(), name)) {
      map.children.back().text += "," + name;  // whoever reads the number says what is wrong with it
      return;
    }
    if (const Tree* first = map.find(name)) {
      const std::string before = first->place.line > 0 ? fmt::format(" (first in line {})", first->place.line) : "";
      faults.add(at, join(path, name), fmt::format("duplicate key{}; accepted: each key once", before));
      return;
    }
    map.keys.push_back(name);
    map.children.push_back(convert(value, at, join(path, name)));
  }
};

/// YAML forbids tabs as indentation; the parser would take some of them silently as part of a value.
bool indented_by_tabs(const std::string& text, const std::string& file, Faults& faults) {
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#') continue;
    if (line.find('\t') >= first) continue;
    faults.add({file, number}, "", "a tab indents this line; accepted: spaces");
    return true;
  }
  return false;
}

/// Notes where a document starts and lets everything else pass.
struct DocumentStart : YAML::EventHandler {
  YAML::Mark mark = YAML::Mark::null_mark();
  void OnDocumentStart(const YAML::Mark& at) override { mark = at; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}
};

/// Where a second document starts, if there is one. (YAML::LoadAll is no way to ask: it never returns on a text that
/// starts with a comma.)
std::optional<YAML::Mark> second_document(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  DocumentStart start;
  if (!parser.HandleNextDocument(start) || !parser.HandleNextDocument(start)) return {};
  return start.mark;
}

/// The one document of a text; a syntax error or a second document is a fault at its line (or at an override's place).
std::optional<YAML::Node> load(const std::string& text, const Place& base, Faults& faults) {
  const auto at = [&](const YAML::Mark& mark) {
    return base.line > 0 && !mark.is_null() ? Place{base.source, mark.line + 1} : base;
  };
  try {
    YAML::Node document = YAML::Load(text);
    if (const std::optional<YAML::Mark> second = second_document(text)) {
      faults.add(at(*second), "", "a second YAML document starts here; accepted: one, all top keys in one column");
      return std::nullopt;
    }
    return document;
  } catch (const YAML::Exception& error) {
    const bool known = base.line > 0 && !error.mark.is_null();
    const std::string column = known ? fmt::format(", column {}", error.mark.column + 1) : "";
    faults.add(at(error.mark), "", fmt::format("YAML syntax error{}: {}; accepted: YAML 1.2", column, error.msg));
    return std::nullopt;
  }
}

}  // namespace

const Tree* Tree::find(std::string_view key) const {
  const auto found = std::find(keys.begin(), keys.end(), key);
  return found == keys.end() ? nullptr : &children[static_cast<std::size_t>(found - keys.begin())];
}

Tree* Tree::find(std::string_view key) {
  return const_cast<Tree*>(static_cast<const Tree&>(*this).find(key));
}

Tree parse_yaml(const std::string& text, const std::string& file, Faults& faults) {
  const Place start{file, 1};
  if (text.find('\0') != std::string::npos) {
    faults.add(start, "", "the file holds zero bytes; accepted: a scene in YAML, as text");
    return {};
  }
  if (indented_by_tabs(text, file, faults)) return {};
  const std::optional<YAML::Node> document = load(text, start, faults);
  if (!document) return {};
  if (document->IsNull()) {
    faults.add(start, "", "the file is empty; accepted: a scene with units, mesh, materials, parts and run");
    return {};
  }
  return Converter{start, faults}.convert(*document, start, "");
}

std::optional<Tree> parse_value(const std::string& text, const Place& place, Faults& faults) {
  const std::optional<YAML::Node> document = load(text, place, faults);
  if (!document) return {};
  return Converter{place, faults}.convert(*document, place, "");
}

}  // namespace brunt::scene
