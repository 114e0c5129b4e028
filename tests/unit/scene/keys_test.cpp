// SPDX-License-Identifier: Apache-2.0
// A table of keys: what it reads and refuses, and what it says of itself.
#include <catch2/catch.hpp>
#include <set>

#include "core/error.hpp"
#include "scene/keys/table.hpp"

using namespace brunt;
using namespace brunt::scene;
using Catch::Contains;

namespace {

struct Shape {
  std::string kind = "ball";
  double radius = 0.5, height = 1.0e-3;
  std::optional<double> limit;
  int count = 3;
  bool open = false;
};

void judge_shape(const Key& map, Shape& shape) {
  if (shape.height > shape.radius) fault(at(map, "height"), "out of range: too high; expected a smaller number");
}

const Choices<bool> words{{{"open", true}, {"closed", false}}, {}};

const Table<Shape> shape_keys{
    "shape",
    "a map {kind: word, ...}",
    {
        {"kind", value(&Shape::kind, Text{"name", "a name"}), "-", "The kind.", required},
        {"radius", value(&Shape::radius, positive), "length", "Its radius."},
        {"height", of("rod"), value(&Shape::height, share), "length", "Its height."},
        {"limit", value(&Shape::limit, positive), "length", "A limit."},
        {"count", value(&Shape::count, Count{1}), "-", "A count.", "three"},
        {"open", value(&Shape::open, words), "-", "Whether it is open."},
        refused<Shape>("mass", {}, [](const Key& key, Shape&) { fault(key, "invalid mass; expected no mass"); }),
    },
    judge_shape,
    [](const Shape& shape) -> std::string_view { return shape.kind; },
};

/// The faults of a map of this text; `shape` gets its values.
std::vector<std::string> faults_of(const std::string& text, Shape& shape) {
  Findings findings;
  const Tree tree = parse_yaml(text, "a.yaml", findings.faults);
  shape_keys.read({&tree, tree.place, "shape", &findings}, shape);
  try {
    findings.faults.throw_if_any();
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

std::vector<std::string> faults_of(const std::string& text) {
  Shape shape;
  return faults_of(text, shape);
}

}  // namespace

TEST_CASE("a table reads the keys of the kind, and leaves the defaults of others") {
  Shape shape;
  CHECK(faults_of("{kind: rod, height: 0.25, open: open}", shape).empty());
  CHECK(shape.height == 0.25);
  CHECK(shape.radius == 0.5);
  CHECK(shape.open);
}

TEST_CASE("a table refuses missing, wrong and unknown keys, and judges the rest") {
  const auto refuse = [](const std::string& text, const std::string& what) {
    const std::vector<std::string> faults = faults_of(text);
    REQUIRE(faults.size() == 1);
    CHECK_THAT(faults[0], Contains(what));
  };
  refuse("[]", "shape: invalid list of 0 entries; expected a map {kind: word, ...}");
  refuse("{radius: 1}", "shape.kind: missing; expected a name");
  refuse("{kind: ball, radius: 0}", "shape.radius: out of range: 0; expected a number > 0");
  refuse("{kind: ball, radios: 1}",
         "shape.radios: unknown key (did you mean 'radius'?); expected one of kind, radius, "
         "limit, count, open");
  refuse("{kind: ball, height: 1}", "shape.height: unknown key");
  refuse("{kind: ball, mass: 1}", "shape.mass: invalid mass; expected no mass");
  refuse("{kind: rod, radius: 0.1, height: 0.5}", "shape.height: out of range: too high");
  refuse("{knid: ball}", "shape.knid: unknown key (did you mean 'kind'?)");
}

TEST_CASE("a table says types and defaults by what reads, and leaves out what is only refused") {
  const std::vector<std::array<std::string, 4>> expected{{"kind", "name", "-", "required"},
                                                         {"radius", "number > 0", "length", "0.5"},
                                                         {"height", "number from 0 to 1", "length", "1.0e-3"},
                                                         {"limit", "number > 0", "length", "none"},
                                                         {"count", "integer >= 1", "-", "three"},
                                                         {"open", "`open`, `closed`", "-", "`closed`"}};
  REQUIRE(shape_keys.rows.size() == expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const Said& said = shape_keys.rows[k];
    CHECK(std::array{said.key, said.type, said.unit, said.fallback} == expected[k]);
  }
  CHECK(shape_keys.rows[2].of == std::vector<std::string>{"rod"});
}

TEST_CASE("numbers are shown in their shortest decimals") {
  for (const auto& [number, text] : {std::pair{0.0, "0"},
                                     {1.0, "1"},
                                     {0.05, "0.05"},
                                     {100000.0, "100000"},
                                     {1e-4, "1.0e-4"},
                                     {2.5e-3, "2.5e-3"},
                                     {1e-10, "1.0e-10"},
                                     {-0.5, "-0.5"}})
    CHECK(shown(number) == text);
  CHECK(shown(Vec3(0, 1, 0.5)) == "`[0, 1, 0.5]`");
}

TEST_CASE("every key of a scene has a type, a unit, a default and a sentence; no map stands twice") {
  std::set<std::string> maps;
  for (const Described* map : all_keys()) {
    CHECK(maps.insert(map->name).second);
    for (const Said& said : map->rows) {
      INFO(map->name << '.' << said.key);
      CHECK((!said.type.empty() && !said.unit.empty() && !said.fallback.empty()));
      CHECK(said.meaning.ends_with('.'));
      for (const std::string& text : {said.type, said.unit, said.fallback, said.meaning})
        CHECK(text.find(" | ") == std::string::npos);  // it would part a cell of the reference
    }
  }
  CHECK(maps.contains("scene"));
  CHECK(maps.contains("mesh.BODY.nose"));
}
