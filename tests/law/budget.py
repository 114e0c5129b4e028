#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""No file and no function grows too long to be read in one go. Usage: budget.py ROOT"""
import ast
import re
import statistics
import sys

import tree

FILE_LINES, FUNCTION_LINES = 400, 80
FOLDERS = ("include", "src", "partition", "tests", "scripts", "cases")
CODE = (".cpp", ".hpp", ".h", ".c")
# Comments, strings and characters may hold braces that open nothing.
NO_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.S)


def blank(match):
    return re.sub(r"[^\n]", " ", match.group())


def cpp_functions(text):
    """(name, first line, number of lines) of each outermost braced block that follows a parameter list."""
    text = NO_CODE.sub(blank, text)
    found, opened, head = [], [], 0  # opened: (is function, name, line) of every open brace
    for match in re.finditer(r"[{};]", text):
        if match.group() == "{":
            before = text[head:match.start()].strip()
            is_function = ")" in before and not re.match(r"(?:\w+\s+)*(namespace|class|struct|enum|union)\b[^(]*$", before)
            name = re.search(r"([\w:~]+)\s*\(", before)
            start = head + len(text[head:]) - len(text[head:].lstrip())
            line = text.count("\n", 0, start) + 1
            inside = any(o[0] for o in opened)
            opened.append((is_function and not inside, name.group(1) if name else "?", line))
        elif match.group() == "}" and opened:
            is_function, name, line = opened.pop()
            if is_function:
                found.append((name, line, text.count("\n", 0, match.start()) + 2 - line))
        head = match.end()
    return found


def python_functions(text):
    nodes = (n for n in ast.walk(ast.parse(text)) if isinstance(n, ast.FunctionDef))
    return [(n.name, n.lineno, n.end_lineno - n.lineno + 1) for n in nodes]


def functions(path, text):
    if path.endswith(CODE):
        return cpp_functions(text)
    if path.endswith(".py") or text.startswith(("#!/usr/bin/python3", "#!/usr/bin/env python3")):
        return python_functions(text)
    return []


def check(root):
    faults, lengths, function_lengths = [], [], []
    paths = set(tree.files(root, FOLDERS, CODE + (".py",))) | set(tree.files(root, ("scripts", ".ci"), ("",)))
    for path in sorted(paths):
        text = tree.read(root, path)
        lines = text.count("\n")
        lengths.append(lines)
        if lines > FILE_LINES:
            faults.append(f"{path}: {lines} lines, more than {FILE_LINES}")
        for name, line, count in functions(path, text):
            function_lengths.append(count)
            if count > FUNCTION_LINES:
                faults.append(f"{path}:{line}: {name} has {count} lines, more than {FUNCTION_LINES}")
    summary = "nothing to measure"
    if lengths and function_lengths:
        p90 = sorted(function_lengths)[int(0.9 * len(function_lengths))]
        summary = (f"{len(lengths)} files, median {statistics.median(lengths):.0f} lines, longest {max(lengths)}; "
                   f"{len(function_lengths)} functions, median {statistics.median(function_lengths):.0f}, 90 % below {p90 + 1}")
    return faults, summary


if __name__ == "__main__":
    sys.exit(tree.report("budget", *check(sys.argv[1])))
