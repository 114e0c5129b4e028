# SPDX-License-Identifier: Apache-2.0
"""Wrong inputs of scripts/COMMAND that show results or write tables."""


def cases(Wrong):
    shown = [
        Wrong(f"{script} {what}", [script, *says], command=script, target=target, files=files)
        for script, inside in (("render", "state.h5"), ("plot", "history.csv"))
        for what, target, says, files in (
            ("of nothing", "nope", ["nope", "does not exist", inside], {}),
            ("of an empty folder", "old", [f"old/{inside}", "does not exist"], {"old/x": b""}),
            ("of a scene", "scene.yaml", ["scene.yaml"], {}),
            ("of another kind of file", "old", [f"old/{inside}"], {f"old/{inside}": bytes(range(256)) * 8}))
    ]
    tables = [
        Wrong("tables with a misspelt option", ["tables", "--halp"], command="tables", target="", arguments=["--halp"], lines=1),
        Wrong("tables of a case that is not there", ["tables", "'nope'", "expected"], command="tables", target="", arguments=["nope"], lines=1),
        Wrong("tables that are checked and run", ["tables", "--check"], command="tables", target="", arguments=["--check", "--run"], lines=1),
    ]
    return shown + tables
