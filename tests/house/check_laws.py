#!/usr/bin/env python3
"""Every law of a module's README has a test that stands for it.

usage: check_laws.py ROOT           prints what is wrong; exit status 1 if anything is
       check_laws.py --self-test    shows on small trees that everything below can be wrong

A section "Laws" lists laws as "- X1 text", X being letters and each name once in the section. A law
is held by a test if its text, or the section's heading, names files under tests/, fuzz/ or scripts/
that exist (lists like {a,b}.py and words like `test_x.py` of the folder in the heading count), or
if a test file whose path or text names the module says "law X1", "Laws X1 to X4" or the like.
"""
import re
import sys
from pathlib import Path

LAW = re.compile(r"^- ([A-Z]{1,2})(\d+) ")
PLACE = re.compile(r"\b((?:tests|fuzz|scripts)/[\w./-]*\w)")
CITED = re.compile(r"[Ll]aws?\b((?:[\s,()/]|and|to|of|[A-Z]{1,2}\d+)*)")


def sections(text):
    """(heading, lines) of the sections called Laws."""
    for part in re.split(r"^(?=## )", text, flags=re.M):
        if part.startswith("## Laws"):
            heading, _, body = part.partition("\n")
            yield heading, body.splitlines()


def laws_of(lines):
    """{name: text} in order, and what is wrong with the list."""
    laws, wrong, name = {}, [], None
    for line in lines:
        found = LAW.match(line)
        if found:
            name = found.group(1) + found.group(2)
            if name in laws:
                wrong.append(f"{name} stands there twice")
            laws[name] = line
        elif re.match(r"^(\d+\.|- )", line):
            wrong.append(f"a law without a name: {line[:60]}")
            name = None
        elif name:
            laws[name] += " " + line.strip()
    return laws, wrong


def cited_in(text):
    """Names of laws that a test's text speaks of."""
    names = set()
    for found in CITED.finditer(text):
        words = re.findall(r"[A-Z]{1,2}\d+|to", found.group(1))
        for i, word in enumerate(words):
            if word == "to" and 0 < i < len(words) - 1:
                letters = re.match(r"[A-Z]+", words[i - 1]).group()
                first, last = (int(words[j][len(letters):]) for j in (i - 1, i + 1))
                names |= {f"{letters}{n}" for n in range(first, last + 1)}
            elif word != "to":
                names.add(word)
    return names


def check(files):
    """Violations in a tree {path: text}."""
    tests = {path: text for path, text in files.items() if path.startswith("tests/")}
    problems = []
    for readme, text in sorted(files.items()):
        if not readme.endswith("README.md"):
            continue
        module = readme.split("/")[0]
        spoken_of = set()
        for path, content in tests.items():
            if module in path or readme in content:
                spoken_of |= cited_in(content)
        for heading, lines in sections(text):
            laws, wrong = laws_of(lines)
            problems += [f"{readme}: {what}" for what in wrong]
            for name, law in laws.items():
                places = PLACE.findall(heading) + PLACE.findall(law)
                for place in places:
                    if not any(path == place or path.startswith(place + "/") for path in files):
                        problems.append(f"{readme}: law {name} names {place}, which is not there")
                if not places and name not in spoken_of:
                    problems.append(f"{readme}: no test cites law {name}")
    return problems


def read_tree(root):
    folders = ("tests", "fuzz", "scripts")
    paths = [p for folder in folders for p in (root / folder).rglob("*") if p.is_file()]
    paths += [p for p in root.glob("*/README.md")] + [p for p in root.glob("*/*/README.md")]
    files = {}
    for path in paths:
        name = path.relative_to(root).as_posix()
        if not name.startswith("build/"):
            files[name] = path.read_text("utf-8", "replace")
    return files


GOOD = {
    "m/README.md": "## Laws\n- A1 one thing\n- A2 another (tests/x.py)\n- A3 third\n",
    "tests/m_things.cpp": "// Laws A1 to A1 hold.",
    "tests/x.py": "",
    "tests/other.cpp": "// Law A3 of m/README.md",
}
BAD = {
    "m/README.md": ["## Laws\n1. one\n", "## Laws\n- A1 x\n- A1 y\n", "## Laws\n- A4 nobody\n",
                    "## Laws\n- A1 see tests/gone.cpp\n", "## Laws (tests/gone.py)\n- A1 x\n"],
    "tests/m_things.cpp": ["// nothing about A1"],
    "tests/other.cpp": ["// Law A3 of another/README.md"],
}


def self_test():
    wrong = [f"the good tree: {problem}" for problem in check(GOOD)]
    for name, contents in BAD.items():
        wrong += [f"nothing was said of {name}: {text!r}"
                  for text in contents if not check({**GOOD, name: text})]
    return wrong


def main():
    problems = self_test() if sys.argv[1] == "--self-test" else check(read_tree(Path(sys.argv[1])))
    print("\n".join(problems))
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
