#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Sources that are compiled as one share no name that one of them keeps to itself (scripts/lib/source_groups.py)."""
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts", "lib"))
from source_groups import code_of, declared_in, groups_of  # noqa: E402

SOURCE = """
#include "room/a.hpp"
namespace brunt::room {
namespace {
constexpr double share = 0.1;  // not a_comment
using Row = std::array<double, 3>;
using geometry::Box;
struct Line { int inner = 0; };
enum class Side { left, right };
template <class Range>
double mean(const Range& range) { const double local = 1; return local; }
[[nodiscard]] std::vector<std::pair<int, int>> pairs();
}  // namespace
void public_one(const Row& row) { if (row[0] > share) { auto deeper = "not_a_string"; } }
void Owner::member() {}
}  // namespace brunt::room
TEST_CASE("words") {}
"""


class SourceGroups(unittest.TestCase):
    def test_names_outside_of_functions_and_classes_are_seen(self):
        self.assertEqual(declared_in(code_of(SOURCE)),
                         {"share", "Row", "Box", "Line", "Side", "mean", "pairs"})
        self.assertEqual(declared_in(code_of(SOURCE), private=False) - declared_in(code_of(SOURCE)), {"public_one"})

    def test_sources_that_declare_the_same_name_are_kept_apart(self):
        one, other = "namespace { int count() { return 1; } }", "namespace { double count() { return 2; } }"
        self.assertEqual(groups_of([("a", one), ("b", other)], 9), [["a"], ["b"]])

    def test_a_source_that_uses_the_name_is_kept_apart_in_either_order(self):
        declares, uses = "namespace { struct Row {}; }", "void f() { other::Row row; }"
        self.assertEqual(groups_of([("a", declares), ("b", uses)], 9), [["a"], ["b"]])
        self.assertEqual(groups_of([("b", uses), ("a", declares)], 9), [["b"], ["a"]])

    def test_names_of_headers_count(self):
        declares, includes = "namespace { struct Own {}; }", '#include "own.hpp"\n'
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "own.hpp"), "w", encoding="utf-8") as stream:
                stream.write("namespace brunt { struct Own; }\n")
            one, other = os.path.join(folder, "one.cpp"), os.path.join(folder, "other.cpp")
            self.assertEqual(groups_of([(one, declares), (other, includes)], 9), [[one], [other]])

    def test_others_go_together_up_to_the_limit(self):
        sources = [(name, f"namespace {{ int of_{name}() {{ return 1; }} }}") for name in "abc"]
        self.assertEqual(groups_of(sources, 2), [["a", "b"], ["c"]])


if __name__ == "__main__":
    unittest.main()
