#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Each wall stops what it is there to stop: small trees with one fault each."""
import os
import tempfile
import unittest

import budget
import includes
import kinds
import links
import messages
import text
import unit_folders

LAYERS = "core:\nmesh:\ncontact: mesh\ncontact/search: contact\napp: *\napi: mesh\nvendor mpi.h: src/comm\n"


class Walls(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = self.folder.name

    def tearDown(self):
        self.folder.cleanup()

    def write(self, path, content):
        full = os.path.join(self.root, path)
        os.makedirs(os.path.dirname(full), exist_ok=True)
        with open(full, "w", encoding="utf-8") as stream:
            stream.write(content)

    def include_faults(self, layers=LAYERS):
        return "\n".join(includes.check(self.root, layers)[0])

    def test_allowed_includes_pass(self):
        self.write("src/mesh/a.hpp", "")
        self.write("src/contact/b.cpp", '#include "mesh/a.hpp"\n')
        self.assertEqual(self.include_faults(), "")

    def test_forbidden_room(self):
        self.write("src/contact/search/a.hpp", "")
        self.write("src/mesh/b.cpp", '#include "contact/search/a.hpp"\n')
        self.assertIn("mesh may not include contact/search", self.include_faults())

    def test_headers_for_others_belong_to_their_room(self):
        self.write("src/contact/a.hpp", "")
        self.write("include/brunt/b.hpp", '#include "contact/a.hpp"\n')
        self.assertIn("api may not include contact", self.include_faults())

    def test_circle_of_files(self):
        self.write("src/mesh/a.hpp", '#include "mesh/b.hpp"\n')
        self.write("src/mesh/b.hpp", '#include "mesh/a.hpp"\n')
        self.assertIn("circle of files", self.include_faults())

    def test_circle_of_rooms(self):
        self.assertIn("circle of rooms", self.include_faults("core:\na: b\nb: a\n"))

    def test_circle_of_folders(self):
        self.write("src/contact/a.hpp", "")
        self.write("src/contact/search/b.hpp", '#include "contact/a.hpp"\n')
        self.write("src/contact/c.cpp", '#include "contact/search/b.hpp"\n')
        self.assertIn("circle of folders contact -> contact/search -> contact", self.include_faults())

    def test_vendor_out_of_its_place(self):
        self.write("src/mesh/b.cpp", "#include <mpi.h>\n")
        self.assertIn("mpi.h is allowed in src/comm only", self.include_faults())

    def test_included_source_and_unknown_room(self):
        self.write("src/attic/b.cpp", '#include "x.cpp"\n')
        self.assertIn("includes a source file", self.include_faults())
        self.assertIn("lies in no room", self.include_faults())

    def test_long_file_and_long_function(self):
        self.write("src/mesh/a.cpp", "namespace m {\nint f(int x) {\n" + "  x += 1;  // }\n" * 80 + "  return x;\n}\n}\n")
        self.write("src/mesh/b.cpp", "int g();\n" * 401)
        faults = "\n".join(budget.check(self.root)[0])
        self.assertIn("a.cpp:2: f has 83 lines", faults)
        self.assertIn("b.cpp: 401 lines", faults)

    def test_case_without_a_kind(self):
        self.write("tests/hard/a_test.cpp", 'TEST_CASE("falls [law] of a name") {\n}\n'
                   'TEST_CASE(\n    "two "\n    "lines", "[.][long]"\n    "[law]") {\n}\n')
        faults = kinds.check(self.root)[0]
        self.assertEqual(len(faults), 1)
        self.assertIn("a_test.cpp:1: 'falls [law] of a name' has none of the tags", faults[0])

    def test_regression_out_of_its_folder_and_without_a_figure(self):
        self.write("tests/verification/a_test.cpp", 'TEMPLATE_TEST_CASE("a", "[regression]", int) {\n}\n')
        self.write("tests/regression/b_test.cpp", 'TEST_CASE("b", "[law]") {\n  // ours: 1, margin 2\n}\n'
                   'TEST_CASE("c", "[regression]") {\n}\n')
        faults = "\n".join(kinds.check(self.root)[0])
        self.assertIn("'a' belongs to tests/regression", faults)
        self.assertIn("'b' is in tests/regression, and no [regression]", faults)
        self.assertIn("'c' has no line 'ours:'", faults)

    def test_room_without_unit_tests(self):
        for room in ("mesh", "contact", "contact/search"):
            self.write(f"src/{room}/a.hpp", "")
        self.write("tests/unit/mesh/a_test.cpp", "")
        self.write("tests/unit/contact/search/a_test.cpp", "")
        faults = unit_folders.check(self.root, LAYERS)[0]
        self.assertEqual(faults, ["contact: the room has no tests in tests/unit/contact"])

    def test_licence_and_leftovers(self):
        self.write("src/mesh/a.cpp", "int x;  // TO" + "DO later\n")
        self.assertEqual(len(text.check_licence(self.root)[0]), 1)
        self.assertIn("a.cpp:1", text.check_leftovers(self.root)[0][0])

    def link_faults(self, page):
        self.write("README.md", page)
        self.write("room/README.md", "# A room\n\n## What `it` does: [twice](x)\n\n## Same\n\n## Same\n")
        return "\n".join(links.faults(self.root)[0]).replace("room/README.md:3: x: no such file", "").strip()

    def test_links_that_lead_somewhere(self):
        self.assertEqual(self.link_faults("# Top\n[a](room/README.md#what-it-does-twice) [b](room) [c](#top) [d](https://x.org/none)\n"
                                          "[e](room/README.md#same-1) `[f](none)`\n```\n[g](none)\n```\n"), "")

    def test_links_to_nowhere(self):
        self.assertIn("README.md:2: none.md: no such file", self.link_faults("# Top\n![a](none.md)\n"))
        self.assertIn("README.md:3: room/README.md#a-roof: no such heading", self.link_faults("```\n```\n[a](room/README.md#a-roof)\n"))

    def test_messages_out_of_form(self):
        self.write("src/scene/a.cpp", 'void f() { fault(key, "invalid size of the box; expected a number > 0"); }\n')
        self.write("scripts/run", '#!/usr/bin/env bash\nfail 2 "missing value of --out; expected a folder"\n')
        self.assertEqual(messages.check_sources(self.root)[0] + messages.check_scripts(self.root)[0], [])
        self.write("src/scene/a.cpp", 'void f() { fault(key, "the box is too small"); }\n')
        self.write("src/scene/b.cpp", 'void f() { fault(key, "the box is "\n"flat; expected a number > 0"); }\n')
        self.write("src/scene/c.cpp", 'const char* text = "invalid size, which is no number; expected one";\n')
        self.write("scripts/run", '#!/usr/bin/env bash\nfail 2 "--out has no value at all"\n')
        faults = "\n".join(messages.check_sources(self.root)[0] + messages.check_scripts(self.root)[0])
        for phrase in ("a.cpp:1: no 'expected'", "b.cpp:1: none of invalid", "c.cpp:1: 'is no number'", "run:2: no 'expected'"):
            self.assertIn(phrase, faults)


if __name__ == "__main__":
    unittest.main()
