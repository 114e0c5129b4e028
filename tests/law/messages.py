#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The form of messages: `PLACE: what is wrong; expected ...`, in plain terms. Usage: messages.py ROOT

What is wrong is said with one of VERBS. The message of each fault of the input (a call of FAULTS in C++, of SCRIPT_FAULTS in the scripts)
names what is expected. No text of a message has a word of HOMELY.
"""
import re
import sys

import tree

VERBS = re.compile(r"\b(invalid|missing|unknown|cannot (read|create|restart|report)|out of range)\b", re.I)
HOMELY = re.compile(r"\b(accepted|told|(is|are) no (number|integer|name|view|plane|group|tolerance|path|checkpoint|partition|study|fault)"
                    r"|(is|are) wanted|should stand|(is|are) not there|is there twice|stands? twice|give way|goes? on\b|cut off"
                    r"|holds? (no|results)|promise[ds]?|left out|does nothing)\b")
FAULTS = re.compile(r"\b(fault|report|fail|fail_at|refuse|lacking|InputError|Broken|Refused)\s*\(")
LOCAL = re.compile(r"(const auto|void|bool) (fault|fail|refuse) ?[=(][^;]*(;[^;]*)?(expected|MachineError)", re.S)  # adds what is expected by itself
SCRIPT_FAULTS = re.compile(r"\b(study\.stop|self\.stop|Fault|ArgumentTypeError|Refused|fail|error|self\.fault|refuse)\(")
READERS = ("src/scene", "src/io", "src/mesh", "src/app", "src/force", "src/implicit", "partition")
TOKENS = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|\'(?:\\.|[^\'\\\n])+\'|"(?:\\.|[^"\\\n])*"|#include[^\n]*', re.S)
WORDS = re.compile(r"[A-Za-z]{2,}")


def literals(text):
    """(start, text) of each string of C++, adjacent ones joined."""
    found = []
    for token in TOKENS.finditer(text):
        if not token.group().startswith('"'):
            continue
        if found and not text[found[-1][1]:token.start()].strip():
            found[-1] = (found[-1][0], token.end(), found[-1][2] + token.group()[1:-1])
        else:
            found.append((token.start(), token.end(), token.group()[1:-1]))
    return [(start, content) for start, _, content in found]


def call_at(text, begin):
    """The arguments of a call whose bracket opens just before `begin`."""
    depth, at = 1, begin
    while at < len(text) and depth:
        token = TOKENS.match(text, at)
        if token:
            at = token.end()
            continue
        depth += {"(": 1, ")": -1}.get(text[at], 0)
        at += 1
    return text[begin:at - 1]


def faults_of_text(path, line, content):
    if len(WORDS.findall(content)) < 3:
        return []
    faults = []
    if homely := HOMELY.search(content):
        faults.append(f"{path}:{line}: '{homely.group()}' in a message: {content}")
    body, _, _ = content.partition("; expected")
    if body != content and WORDS.search(re.sub(r"\{[^}]*\}", "", body)) and not VERBS.search(body) and not re.match(r"^[ ;,(]|^\{\}[ ;,]", content):
        faults.append(f"{path}:{line}: none of invalid, missing, unknown, cannot read, out of range: {content}")
    return faults


def check_sources(root):
    faults = []
    paths = tree.files(root, ("src", "partition"), (".cpp", ".hpp"))
    for path in paths:
        text = tree.read(root, path)
        for start, content in literals(text):
            faults += faults_of_text(path, text.count("\n", 0, start) + 1, content)
        if not path.startswith(READERS):
            continue
        plain = TOKENS.sub(lambda t: " " * len(t.group()) if t.group().startswith(("//", "/*")) else t.group(), text)
        local = [m.group(2) for m in LOCAL.finditer(plain)]
        for call in FAULTS.finditer(plain):
            if call.group(1) in local:
                continue
            arguments = call_at(plain, call.end())
            long = [content for _, content in literals(arguments) if len(WORDS.findall(content)) > 2]
            if long and not re.search(r"expected|\bfault\b", arguments):
                faults.append(f"{path}:{text.count(chr(10), 0, call.start()) + 1}: no 'expected' in the fault: {long[0]}")
    return faults, len(paths)


def check_scripts(root):
    faults = []
    paths = [p for p in tree.files(root, ("scripts",), ("",)) if not p.endswith((".css", ".js", ".html", ".sbatch"))]
    for path in paths:
        text = tree.read(root, path)
        is_shell = "bash" in text.split("\n", 1)[0] or path.endswith(".sh")
        calls = re.finditer(r"\bfail 2 (.*)", text) if is_shell else SCRIPT_FAULTS.finditer(text)
        for call in calls:
            arguments = call.group(1) if is_shell else call_at(text, call.end())
            line = text.count("\n", 0, call.start()) + 1
            quoted = re.sub(r"\{[^}]*\}", "{}", " ".join(re.findall(r'"((?:\\.|[^"\\])*)"', arguments)))
            if len(WORDS.findall(quoted)) < 4 or call.group(0) == "self.fault(" or "def " in text[max(0, call.start() - 10):call.start()]:
                continue
            if not re.search("expected|TIMES|NO_SLURM|SCENE_OR_STUDY", arguments) and not re.search(r"strerror|\berror\b\)", arguments):
                faults.append(f"{path}:{line}: no 'expected' in the fault: {quoted}")
            faults += faults_of_text(path, line, quoted)
    return faults, len(paths)


if __name__ == "__main__":
    in_sources, sources = check_sources(sys.argv[1])
    in_scripts, scripts = check_scripts(sys.argv[1])
    sys.exit(tree.report("messages", in_sources + in_scripts, f"{sources} sources, {scripts} scripts"))
