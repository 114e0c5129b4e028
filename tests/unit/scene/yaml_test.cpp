// SPDX-License-Identifier: Apache-2.0
// What YAML allows and no scene needs (cycles, floods of aliases, towers of lists), and what its syntax errors say.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "scene/text/tree.hpp"

using namespace brunt;
using namespace brunt::scene;

namespace {

std::string only_fault(const std::string& text) {
  Faults faults;
  parse_yaml(text, "a.yaml", faults);
  try {
    faults.throw_if_any();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "none";
}

std::string repeated(const std::string& piece, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += piece;
  return text;
}

/// A list of `width` entries, then `levels` lists of `width` aliases of the one before.
std::string bomb(int width, int levels, bool map) {
  std::string text = "a0: &a0 [" + repeated("x, ", width) + "]\n";
  for (int i = 1; i <= levels; ++i) {
    const std::string name = fmt::format("a{}", i), before = fmt::format("*a{}", i - 1);
    text += name + ": &" + name + (map ? " {" : " [");
    for (int k = 0; k < width; ++k) text += (map ? fmt::format("k{}: ", k) : "") + before + " , ";
    text += map ? "}\n" : "]\n";
  }
  return text;
}

}  // namespace

TEST_CASE("an alias within its own anchor is one fault at its line", "[yaml]") {
  for (const std::string text : {"a: &a {b: *a}", "a: &a [*a]", "a: &a [1, {b: [2, *a]}]", "&a {b: *a}", "&a [*a , 1]"})
    CHECK_THAT(only_fault(text), Catch::StartsWith("a.yaml:1: invalid alias within its own anchor"));
  CHECK_THAT(only_fault("title: t\nsets: &c\n  s1: 1\n  s2:\n    - *c\n"), Catch::StartsWith("a.yaml:5: "));
  CHECK_THAT(only_fault("a: &a {b: &b {c: *b}}\n"), Catch::StartsWith("a.yaml:1: "));
  CHECK(only_fault("a: &a {b: 1}\nc: *a\nd: [*a , *a]\n") == "none");
  CHECK_THAT(only_fault("a: &a {b: 1}\nc: &a {b: *a}\n"), Catch::StartsWith("a.yaml:2: "));  // the nearest of a name
}

TEST_CASE("aliases repeat so many values and no more", "[yaml]") {
  for (const bool map : {false, true})
    for (const int width : {2, 9, 300}) {
      INFO(width << (map ? " maps" : " lists"));
      CHECK_THAT(only_fault(bomb(width, width == 2 ? 40 : 12, map)),
                 Catch::Contains("aliases repeat more than 100000"));
      CHECK(only_fault(bomb(width, 1, map)) == "none");
    }
  // what is written out is not limited
  CHECK(only_fault("a: [" + repeated("1, ", 150'000) + "2]") == "none");
  CHECK(only_fault("a: &a [" + repeated("1, ", 49'000) + "2]\nb: *a\nc: *a\n") == "none");
  CHECK_THAT(only_fault("a: &a [" + repeated("1, ", 49'000) + "2]\nb: *a\nc: *a\nd: *a\n"),
             Catch::StartsWith("a.yaml:4: "));
}

TEST_CASE("lists and maps lie so deep within each other and no deeper", "[yaml]") {
  for (const auto& [open, close] : {std::pair<std::string, std::string>{"[", "]"}, {"{a: ", "}"}, {"[{a: ", "}]"}}) {
    const int levels = open.size() > 4 ? 2 : 1;
    CHECK(only_fault("a: " + repeated(open, 60 / levels) + "1" + repeated(close, 60 / levels)) == "none");
    for (const int depth : {65, 1000, 200'000})
      CHECK_THAT(only_fault("a: " + repeated(open, depth)), Catch::Contains("more than 64 nested levels"));
  }
  CHECK_THAT(only_fault(repeated("- ", 5000)), Catch::Contains("more than 64 nested levels"));
  // also by aliases: each line one level more
  std::string stairs = "a0: &a0 [1]\n";
  for (int i = 1; i < 100; ++i) stairs += fmt::format("a{0}: &a{0} [*a{1} ]\n", i, i - 1);
  CHECK_THAT(only_fault(stairs), Catch::Contains("more than 64 nested levels"));
}

TEST_CASE("an override is bounded as a file is", "[yaml]") {
  for (const std::string value : {"&a [*a]", "&a {b: *a}", "[[[[[", "'open", "a: b: c"}) {
    Faults faults;
    CHECK_FALSE(parse_value(value, {"--set x=" + value, 0}, faults));
    CHECK_THROWS(faults.throw_if_any());
  }
  Faults faults;
  CHECK_FALSE(parse_value(repeated("[", 100'000), {"--set x=", 0}, faults));
}

TEST_CASE("a syntax error says what to write", "[yaml]") {
  const std::vector<std::array<std::string, 3>> table{
      {"title: steel: a test", "a.yaml:1: ",
       "invalid colon in the value of 'title'; expected quotes around a text with a colon, title: \"steel: a test\""},
      {"run:\n  end: 1: 2", "a.yaml:2: ", "the value of 'end'"},
      {"- {a: b: c}", "a.yaml:1: ", "expected"},
      {"title: abc\n  foo: bar", "a.yaml:2: ", "deeper than line 1"},
      {"a:\n  b: 1\n\n  # c\n    d: 2", "a.yaml:5: ", "deeper than line 2"},
      {"a:\n  density:7800\n  young: 1",
       "a.yaml:2: ", "missing space after the colon of 'density:7800'; expected density: 7800"},
      {"a: {m: e, density:7800}", "a.yaml:1: a.density: ", "expected density: 7800"},
      {"a:\n  m: elastic\n  density:7800", "a.yaml:3: ", "expected density: 7800"},
      {"a: {at:[0, 0, 1]}", "a.yaml:1: ", "missing space after the colon of 'at:"},
      {"run: {end: 1\nunits: SI", "a.yaml:1: ", "column 6: missing closing bracket for '{'"},
      {"a: 1\nb: [1, {c: 2]\nd: 3", "a.yaml:2: ", "invalid closing bracket ']': '{' of line 2 is still open"},
      {"a: [1, 2\nb: 3\nc: 4", "a.yaml:1: ", "column 4: missing closing bracket for '['"},
      {"a: {b: 1}}", "a.yaml:1: ", "invalid closing bracket '}': no bracket is open"},
      {"a: {b: c, d: e\n  f: g}", "a.yaml:2: ", "missing comma or closing bracket"},
      {"t: x\ntitle: 'abc\nunits: SI", "a.yaml:2: ", "missing closing quote '"},
      {"title: \"abc\nunits: 'SI'", "a.yaml:1: ", "missing closing quote \""},
      {"- a\n- [b, 'c]", "a.yaml:2: ", "missing closing quote '"},
      {"title: 'John's test'\na: 1", "a.yaml:1: ", "doubled ('')"},
      {"title: [draft] test", "a.yaml:1: ", "quotes around a text that begins with a bracket"},
      {"title: %foo", "a.yaml:1: ", "invalid first character '%' of a value"},
      {"title: *foo", "a.yaml:1: ", "quotes around a text with '*'"},
      {"title: \"a\\qb\"", "a.yaml:1: ", "backslashes"},
      {"run:\n    end: 1\n  steps: 3", "a.yaml:3: ", "no map or list above it"},
      {"a: - b", "a.yaml:1: ", "invalid list entry '- '"},
      {"a: 1\n\tb: 2", "a.yaml:2: ", "tab"},
      {"a: 1\na: 2", "a.yaml:2: a: ", "given twice (first in line 1)"},
  };
  for (const auto& [text, where, what] : table) {
    INFO(text);
    const std::string fault = only_fault(text);
    CHECK_THAT(fault, Catch::StartsWith(where));
    CHECK_THAT(fault, Catch::Contains(what));
    CHECK_THAT(fault, Catch::Contains("expected"));
    CHECK(fault.find('\n') == std::string::npos);
  }
}

TEST_CASE("texts that look broken and are not", "[yaml]") {
  for (const std::string text : {"title: John's test",
                                 "title: a 'b",
                                 "title: 5\" pipe",
                                 "title: a [b",
                                 "title: it {is",
                                 "a: b]",
                                 "a: # 'b\n  c: 1",
                                 "a: |\n  it's [\n  {\nb: 1",
                                 "a: >\n  'x\n\n  \"y\nb: 2",
                                 "a: 'it''s'",
                                 "a: \"\\\"'[\"",
                                 "a: [b'c, d\"e]",
                                 "'a': 1",
                                 "a: {'b': [1, 2], \"c\": '}'}",
                                 "a: [1, # ]\n 2]",
                                 "title: at 12:30",
                                 "file: http://x/y",
                                 "a: b\n  'c",
                                 "title: see a:b",
                                 "a: &x [1, 2]\nb: *x",
                                 "a: !x b",

                                 "a: \n- b\n- c",
                                 "? a\n: b"}) {
    INFO(text);
    CHECK(only_fault(text) == "none");
  }
}
