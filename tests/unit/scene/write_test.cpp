// SPDX-License-Identifier: Apache-2.0
// A tree as YAML again: what is read from it is the same tree.
#include "scene/text/write.hpp"

#include <array>
#include <catch2/catch.hpp>

#include "scene/text/fingerprint.hpp"

using namespace brunt;
using scene::Tree;

namespace {

Tree parsed(const std::string& text) {
  scene::Faults faults;
  Tree tree = scene::parse_yaml(text, "scene.yaml", faults);
  CHECK_NOTHROW(faults.throw_if_any());
  return tree;
}

void check_same(const Tree& a, const Tree& b, const std::string& path) {
  INFO(path << ": '" << a.text << "' and '" << b.text << "'");
  REQUIRE(a.kind == b.kind);
  CHECK(a.text == b.text);
  CHECK(a.keys == b.keys);
  REQUIRE(a.children.size() == b.children.size());
  for (std::size_t k = 0; k < a.children.size(); ++k) check_same(a.children[k], b.children[k], path + "/");
}

}  // namespace

TEST_CASE("scene as YAML: maps, lists, empty ones and values of all kinds come back as they were") {
  for (const char* text : {
           "units: SI\nrun: {end: 1.0e-5, wall_limit: 3h55m}\n",
           "mesh:\n  - {box: {part: a, size: [1, 2, 3]}}\n  - {file: ../a b/c.exo}\nlist: []\nmap: {}\nnothing:\n",
           "curves: {ramp: [[0, 0], [1.0e-3, 1]], deep: [[[1], []], [{a: 1}]]}\n",
           "title: steel, copper [and] {more}\nnext: -3\nurl: a:b\n",
           "title: \"a: b # c\"\nempty: \"\"\nquote: \"say \\\"no\\\" \\\\ 'yes'\"\nlines: |\n  one\n  two\n",
           "title: \"tab\\there, bell\\a, nul-like \\x01, \xc3\xa4\xe2\x82\xac\"\n\"odd key: x\": 1\n\"-\": 2\n",
           "numbers: [\"1\", 1, -1, +1, .5, 1e5, -.inf]\ndash: \"-\"\nquestion: \"? x\"\nstar: \"*a\"\nper: \"%x\"\n",
           "folded: one\n  line\n\n  more\n",
           "long: {a: a text that alone fills half of a line, b: another text that fills the rest, c: {d: [1, 2, {e: "
           "and "
           "one more that is far too long for it}]}}\n",
           "list:\n  - a list of texts that are too long to stand in one line of a hundred letters\n  - [and, "
           "another]\n"
           "  - [[one, within, another, one], a text that goes on for long enough, a text that goes on for long "
           "enough]\n",
       }) {
    INFO(text);
    const Tree tree = parsed(text);
    const std::string written = scene::as_yaml(tree);
    INFO(written);
    check_same(tree, parsed(written), "");
    CHECK(scene::as_yaml(parsed(written)) == written);
  }
}

TEST_CASE("scene as YAML: what was in quotes stays text, what was not may be a number still") {
  const Tree again = parsed(scene::as_yaml(parsed("a: \"1\"\nb: 1\nc: [\"2\", 2]\n")));
  CHECK(again.find("a")->quoted);
  CHECK_FALSE(again.find("b")->quoted);
  CHECK(again.find("c")->children[0].quoted);
  CHECK_FALSE(again.find("c")->children[1].quoted);
}

TEST_CASE("scene as YAML: overrides are in it, and it is the same scene to a restart") {
  const std::string text = "units: SI\nrun: {end: 1}\nmaterials: {m: {density: 1}}\n";
  const std::array<std::string, 2> overrides{"materials.m.density=7.5e3", "mesh=[{file: b.exo}]"};
  const std::string written = scene::as_yaml(text, "scene.yaml", overrides);
  CHECK(scene::fingerprint(written, "scene.yaml", {}) == scene::fingerprint(text, "scene.yaml", overrides));
  CHECK(scene::as_yaml("a: [", "scene.yaml", {}).empty());
}
