# SPDX-License-Identifier: Apache-2.0
"""A scene that is written, run, and read back row by row."""
import csv

from run_test import Program


class SceneProgram(Program):
    def rows(self, result):
        table = csv.DictReader(self.text(result, "history.csv").splitlines())
        return [{name.split(" [")[0]: float(value) for name, value in row.items()} for row in table]

    def go(self, scene, ranks=1, out="out", code=0):
        """Rows of the history, or what is told where the run ends with another code."""
        self.write("scene.yaml", scene)
        told = self.run_scene(ranks, "scene.yaml", "--out", out, "--force", code=code)
        return told if code else self.rows(out)
