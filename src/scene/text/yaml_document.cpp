// SPDX-License-Identifier: Apache-2.0
// The document is traversed event by event before its nodes are created: repetitions by aliases are counted, not
// copied.
#include "yaml_document.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include "yaml_explain.hpp"

namespace brunt::scene {
namespace {

/// Valid YAML that cannot be a scene.
struct Refused {
  YAML::Mark mark;
  std::string what;
};

/// Counts values as if every alias were written out; throws Refused.
class Survey : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t anchor) override { add_value(anchor); }
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t anchor, const std::string&) override {
    add_value(anchor);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, anchor);
  }
  void OnMapEnd() override { close(); }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const bool within = std::ranges::any_of(open_, [&](const Level& level) { return level.anchor == anchor; });
    if (within)
      throw Refused{mark, "invalid alias within its own anchor; expected an alias after the end of its anchor"};
    const Extent& extent = extents_[anchor];
    repeated_ += extent.values;
    if (repeated_ > most_repeated_values)
      throw Refused{mark,
                    fmt::format("out of range: aliases repeat more than {} values up to this line; expected at most {}",
                                most_repeated_values, most_repeated_values)};
    demand_depth(mark, open_.size() + extent.levels);
    if (!open_.empty()) {
      open_.back().extent.values += extent.values;
      open_.back().extent.levels = std::max(open_.back().extent.levels, extent.levels + 1);
    }
  }

 private:
  struct Extent {
    std::size_t values = 0, levels = 0;
  };
  struct Level {
    YAML::anchor_t anchor;
    Extent extent;
  };

  static void demand_depth(const YAML::Mark& mark, std::size_t levels) {
    if (levels > static_cast<std::size_t>(deepest_document))
      throw Refused{mark, fmt::format("out of range: more than {} nested levels of lists and maps; expected at most {}",
                                      deepest_document, deepest_document)};
  }

  void add_value(YAML::anchor_t anchor) {
    if (anchor != 0) extents_[anchor] = {1, 0};
    if (!open_.empty()) ++open_.back().extent.values;
  }
  void open(const YAML::Mark& mark, YAML::anchor_t anchor) {
    open_.push_back({anchor, {1, 1}});
    demand_depth(mark, open_.size());
  }
  void close() {
    const Level level = open_.back();
    open_.pop_back();
    if (level.anchor != 0) extents_[level.anchor] = level.extent;
    if (open_.empty()) return;
    Extent& above = open_.back().extent;
    above.values += level.extent.values;
    above.levels = std::max(above.levels, level.extent.levels + 1);
  }

  std::vector<Level> open_;
  std::map<YAML::anchor_t, Extent> extents_;
  std::size_t repeated_ = 0;
};

/// Records where a document starts and ignores everything else.
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

/// Surveys the first document; the start of a second one, if there is one. (YAML::LoadAll cannot be used: it does not
/// return for a text that starts with a comma.)
std::optional<YAML::Mark> survey(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  Survey first;
  DocumentStart second;
  if (!parser.HandleNextDocument(first) || !parser.HandleNextDocument(second)) return {};
  return second.mark;
}

}  // namespace

std::optional<YAML::Node> load_yaml(const std::string& text, const Place& base, Faults& faults) {
  const auto at = [&](int line) { return base.line > 0 ? Place{base.source, line} : base; };
  if (const std::optional<YamlFault> open = unclosed_quote(text)) {
    faults.add(at(open->line), "", "invalid YAML: " + open->what);
    return std::nullopt;
  }
  try {
    const std::optional<YAML::Mark> second = survey(text);
    YAML::Node document = YAML::Load(text);
    if (!second) return document;
    faults.add(at(second->line + 1), "",
               "invalid second YAML document; expected one document, with all top keys in one column");
  } catch (const Refused& refused) {
    faults.add(at(refused.mark.line + 1), "", refused.what);
  } catch (const YAML::Exception& error) {
    const YamlFault fault = explain(text, error);
    const std::string column = base.line > 0 && fault.column > 0 ? fmt::format(", column {}", fault.column) : "";
    faults.add(fault.line > 0 ? at(fault.line) : base, "", fmt::format("invalid YAML{}: {}", column, fault.what));
  }
  return std::nullopt;
}

}  // namespace brunt::scene
