#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Sources of tests that are compiled as one keep their names to themselves (scripts/lib/merged_sources.py)."""
import os
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts", "lib"))
from merged_sources import groups, merged  # noqa: E402


class MergedSources(unittest.TestCase):
    def setUp(self):
        keeper = tempfile.TemporaryDirectory()
        self.addCleanup(keeper.cleanup)
        self.folder = keeper.name

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text)
        return path

    def names(self, found):
        return [[os.path.basename(path) for path in group] for group in found]

    def test_the_same_names_do_not_clash_and_messages_name_the_source(self):
        self.write("own.hpp", "#pragma once\nnamespace brunt { inline int one() { return 1; } }\n")
        first = self.write("first.cpp", '// A\n#include "own.hpp"\n#include <vector>\n\nusing namespace brunt;\nnamespace {\nint count() { return one(); }\n}\n'
                           "int first() { return count(); }\n")
        second = self.write("second.cpp", '#include <vector>\n\nnamespace {\nstd::vector<int> count() { return {}; }\n}\nint second() { return count().size(); }\n')
        path = self.write("merged.cpp", merged([first, second]))
        done = subprocess.run(["g++", "-std=c++20", "-fsyntax-only", path], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(second, "a", encoding="utf-8") as stream:
            stream.write("int wrong = no_such_name;\n")
        path = self.write("merged.cpp", merged([first, second]))
        done = subprocess.run(["g++", "-std=c++20", "-fsyntax-only", path], capture_output=True, text=True, check=False)
        self.assertIn("second.cpp:7:", done.stderr)

    def test_what_cannot_stand_in_a_namespace_stays_alone(self):
        plain = self.write("a.cpp", "int a;\n")
        late = self.write("b.cpp", "int b;\n#include <vector>\n")
        named = self.write("c.cpp", "namespace brunt {\nint c;\n}\n")
        other = self.write("d.cpp", "int d;\n")
        self.assertEqual(self.names(groups(100, [plain, late, named, other])), [["a.cpp", "d.cpp"], ["b.cpp"], ["c.cpp"]])

    def test_a_function_that_a_header_of_another_has_is_kept_apart(self):
        """A call would mean both: the header's by the namespace of its argument."""
        self.write("shape.hpp", "namespace brunt { struct Mesh {}; inline int worst(const Mesh& mesh) { return 0; } struct Row {}; }\n")
        own = self.write("own.cpp", "namespace {\nint worst(int x) { return x; }\nstruct Row {};\n}\n")
        user = self.write("user.cpp", '#include "shape.hpp"\nint user() { return 0; }\n')
        self.assertEqual(self.names(groups(100, [own, user])), [["own.cpp"], ["user.cpp"]])
        self.write("shape.hpp", "namespace brunt { struct Mesh {}; struct Row {}; }\n")
        done = subprocess.run([sys.executable, "-B", os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts", "lib", "merged_sources.py"),
                               "--groups", "100", own, user], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout.strip(), f"{own};{user}")

    def test_groups_are_no_longer_than_asked_for(self):
        paths = [self.write(f"{name}.cpp", f"int {name};\n" * 4) for name in "abc"]
        self.assertEqual(self.names(groups(8, paths)), [["a.cpp", "b.cpp"], ["c.cpp"]])


if __name__ == "__main__":
    unittest.main()
