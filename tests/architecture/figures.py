#!/usr/bin/env python3
"""Prints the figures of the code: sizes of files and functions, comments, line lengths, tests per line of code, names
that several classes share and tuning numbers outside policies.

usage: tests/architecture/figures.py [FOLDER]     (default: this repository)
"""
import pathlib
import re
import statistics
import sys

ROOT = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[2])
SOURCES = ("core", "ui", "app")


def files_of(*folders):
    return [path for folder in folders for path in sorted((ROOT / folder).rglob("*.?pp"))]


def code_only(text):
    """The text with comments and literals blanked, its lines where they are."""
    comment = r"//[^\n]*|/\*.*?\*/"
    literal = r'R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<![0-9A-Za-z])\'(?:\\.|[^\'\\\n])*\''
    pattern = re.compile(comment + "|" + literal, re.S)
    return pattern.sub(lambda m: re.sub(r"[^\n]", " ", m[0]), text)


def function_lengths(text):
    """Lines of every function body at namespace or class scope, its head included."""
    lengths, scopes, head = [], [], 0
    code = re.sub(r"(?m)^\s*#.*(?:\\\n.*)*", lambda m: re.sub(r"[^\n]", " ", m[0]), code_only(text))
    start = None
    for position, sign in enumerate(code):
        if sign in ";}" and not (scopes and scopes[-1] == "body"):
            head = position + 1
        if sign == "{":
            words = code[head:position]
            if "body" in scopes:
                scopes.append("body")
            elif re.search(r"\b(namespace|struct|class|enum|union)\b[^()]*$", words):
                scopes.append("scope")
            elif ")" in words:
                scopes.append("body")
                start = head + len(words) - len(words.lstrip())
            else:
                scopes.append("scope")
            if scopes[-1] == "scope":
                head = position + 1
        elif sign == "}" and scopes:
            if scopes.pop() == "body" and "body" not in scopes:
                lengths.append(code.count("\n", start, position) + 1)
                head = position + 1
    return lengths


def definitions(path, text):
    """Qualified names of classes outside anonymous namespaces, as the compiler sees them."""
    names, scopes = [], []
    code = re.sub(r"(?m)^\s*#.*$", "", code_only(text))
    opened = r"namespace\s*([\w:]*)\s*\{"
    defined = r"\b(?:struct|class|enum(?:\s+class)?)\s+(\w+)\s*(?::(?!:)[^;{()]*|final[^;{()]*)?\{"
    for match in re.finditer(opened + "|" + defined + "|[{}]", code):
        if match[0] == "}":
            if scopes:
                scopes.pop()
        elif match[0].startswith("namespace"):
            scopes.append(match[1] or None)
        else:
            if match[2] and all(s != "" for s in scopes) and None not in scopes:
                names.append("::".join(scopes + [match[2]]))
            scopes.append("")
    return names


def tuning_numbers(path, text):
    """Numbers that are named at namespace or function scope rather than in a policy: by the rule of source_rules.cpp,
    sizes, codes and quadrature weights included."""
    kinds = r"double|float|int|long|std::size_t|std::uint64_t|(?:Eigen::)?Index|Effort|\w*Settling"
    declaration = re.compile(r"(?m)^(.*)\bconstexpr\s+(?:" + kinds + r")\s+([^;()]*(?:=|\{)[^;]*);")
    derived = re.compile(r"numeric_limits|numbers::|sizeof|decltype|Policy|_policy\.")
    count = 0
    for before, body in declaration.findall(code_only(text)):
        array = "[" in re.split(r"[={]", body)[0]
        if "static" not in before and not array and not derived.search(body) and re.search(r"[={]\s*[-+]?[\d.]", body):
            count += len(re.findall(r"\w\s*(?:=|\{)\s*[-+]?[\d.]", body))
    return count


def percentile(values, share):
    return sorted(values)[min(len(values) - 1, int(share * len(values)))] if values else 0


def row(name, value, goal=""):
    print(f"{name:58} {value:>16}   {goal}")


texts = {path: path.read_text() for path in files_of(*SOURCES)}
lines = {path: text.count("\n") for path, text in texts.items()}
tests = {path: path.read_text().count("\n") for path in files_of("tests")}
functions = {path: function_lengths(text) for path, text in texts.items()}
lengths = [length for path in functions for length in functions[path]]
all_lines = [line for text in list(texts.values()) + [p.read_text() for p in tests] for line in text.split("\n")]
comments = sum(1 for text in texts.values() for line in text.split("\n") if line.lstrip().startswith("//"))
names = {}
for path, text in texts.items():
    for name in set(definitions(path, text)):
        names.setdefault(name, []).append(path)

row("figure", "now", "goal")
row("lines of core, ui, app", sum(lines.values()))
row("files", len(lines))
row("lines of a file: median", int(statistics.median(lines.values())), "<= 80")
row("lines of a file: largest", f"{max(lines.values())}", "<= 400")
row("files of more than 400 lines", sum(1 for n in lines.values() if n > 400), "0")
row("lines of a function: 95th percentile", percentile(lengths, 0.95), "<= 30")
row("lines of a function: largest", max(lengths), "<= 80")
row("functions of more than 80 lines", sum(1 for n in lengths if n > 80), "0")
row("comments, share of lines", f"{100.0 * comments / sum(lines.values()):.1f} %", "12 to 18 %")
row("lines of more than 120 columns", sum(1 for line in all_lines if len(line) > 120), "0")
row("lines of tests per line of code", f"{sum(tests.values()) / sum(lines.values()):.2f}", ">= 0.5")
for module in sorted({path.relative_to(ROOT).parts[1] for path in texts if path.relative_to(ROOT).parts[0] == "core"}):
    own = sum(n for path, n in lines.items() if path.relative_to(ROOT).parts[:2] == ("core", module))
    tested = sum(n for path, n in tests.items() if path.relative_to(ROOT).parts[1] == module)
    if own:
        row(f"    {module}", f"{tested / own:.2f}", ">= 0.6" if module == "diagnosis" else "")
row("qualified names that several classes share", sum(1 for paths in names.values() if len(paths) > 1), "0")
row("tuning numbers outside policies, core",
    sum(tuning_numbers(path, text) for path, text in texts.items() if path.relative_to(ROOT).parts[0] == "core"), "0")
row("tuning numbers outside policies, ui and app",
    sum(tuning_numbers(path, text) for path, text in texts.items() if path.relative_to(ROOT).parts[0] != "core"), "")
if "--list" in sys.argv:
    for path in functions:
        for length in functions[path]:
            if length > 80:
                print(path.relative_to(ROOT), length)
