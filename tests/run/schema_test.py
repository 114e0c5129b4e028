#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""src/scene/scene.schema.json, with which editors complete and check scenes: it is what the table of keys gives, byte for byte, as are the
tables of the scene reference; it takes every scene of the cases, and refuses whatever the program refuses for its keys, types and ranges. Needs BRUNT and BRUNT_CASES (the
folder cases/) in the environment."""
import copy
import glob
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

import jsonschema
import yaml

ROOT = os.path.dirname(os.environ["BRUNT_CASES"])
sys.path.insert(0, os.path.join(ROOT, "tests", "input"))
import wrong_inputs  # noqa: E402
from run_test import of_all  # noqa: E402

# what a schema knows too, unlike names of the scene and values that depend on each other
KNOWN = re.compile(r"unknown key|out of range: [-+.\w]+; expected an? (number|integer)")


class Numbers(yaml.SafeLoader):
    """Numbers as in YAML 1.2: 1e5 is one."""


Numbers.add_implicit_resolver("tag:yaml.org,2002:float", re.compile(r"^[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?$"), list("-+0123456789."))


class Schema(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with open(os.path.join(ROOT, "src", "scene", "scene.schema.json"), encoding="utf-8") as stream:
            schema = json.load(stream)
        jsonschema.Draft7Validator.check_schema(schema)
        cls.validator = jsonschema.Draft7Validator(schema)

    def faults(self, scene):
        return [f"{'.'.join(map(str, fault.absolute_path))}: {fault.message[:200]}" for fault in self.validator.iter_errors(scene)]

    def test_it_is_what_the_table_of_keys_gives(self):
        for script in ("scene_schema.py", "scene_page.py"):
            done = subprocess.run(["/usr/bin/python3", "-B", os.path.join(ROOT, "scripts", "lib", script), "--check"], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_right_scenes(self):
        count = 0
        for path in sorted(glob.glob(os.path.join(ROOT, "cases", "*", "*.yaml"))):
            with open(path, encoding="utf-8") as stream:
                scene = yaml.load(stream, Loader=Numbers)
            if isinstance(scene, dict) and "mesh" in scene and "parts" in scene:
                self.assertEqual(self.faults(scene), [], path)
                count += 1
        self.assertGreater(count, 40)
        self.assertEqual(self.faults(yaml.load(wrong_inputs.GOOD, Loader=Numbers)), [])

    def test_wrong_scenes(self):
        refused = accepted = 0
        for wrong in wrong_inputs.ALL:
            if wrong.command != "check" or wrong.arguments or wrong.files:
                continue
            text = wrong.scene if wrong.scene is not None else wrong_inputs.GOOD.replace(*(wrong.change or ("", "")), 1)
            try:
                scene = yaml.load(text, Loader=Numbers)
            except (yaml.YAMLError, ValueError, UnicodeDecodeError, RecursionError):
                continue
            if self.faults(scene):
                refused += 1
                continue
            accepted += 1
            if accepted % of_all(1, 4) == 0:
                with self.subTest(wrong.name):
                    self.assertNotRegex(self.told(text), KNOWN)
        self.assertGreater(refused, 70)

    def test_required_keys(self):
        good = yaml.load(wrong_inputs.GOOD, Loader=Numbers)
        for path in (["units"], ["mesh"], ["materials"], ["parts"], ["run"], ["run", "end"], ["materials", "steel", "model"],
                     ["materials", "steel", "density"], ["parts", "bar", "material"], ["fixed", 0, "set"], ["fixed", 0, "dofs"]):
            scene = copy.deepcopy(good)
            inner = scene
            for key in path[:-1]:
                inner = inner[key]
            del inner[path[-1]]
            self.assertNotEqual(self.faults(scene), [], path)

    def told(self, text):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "scene.yaml"), "w", encoding="utf-8") as stream:
                stream.write(text if isinstance(text, str) else text.decode())
            return subprocess.run([os.environ["BRUNT"], "check", "scene.yaml"], cwd=folder, capture_output=True, text=True, check=False, timeout=60).stderr


if __name__ == "__main__":
    unittest.main()
