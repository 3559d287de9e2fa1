#!/usr/bin/env python3
"""Checks that the modules keep to the architecture.

    check_architecture.py ROOT          checks the repository at ROOT; exit status 1 if it fails
    check_architecture.py --self-test   shows on small trees that every law below can fail

The laws:
  order       a file includes only modules that its own may use (the table below)
  root        quoted includes are written from the root: "topology/triangulation.hpp"
  detail      headers in detail/ are included by their own module's sources and detail/ only (base's by all sources)
  link        tripus_add_module links what the files include, and nothing that the table forbids
  hidden      public headers (not in detail/) do not include Ceres, Boost, SuiteSparse, GLPK or Arb
  silent      no module but cli ends the process or writes to the standard streams
  listed      every module is in the table, and CMakeLists.txt adds them in its order
"""

import re
import sys
import tempfile
from pathlib import Path

# Module: the modules that it may use, besides everything that these may use. All may use base.
USES = {
    "base": [],
    "topology": [],
    "drawing": ["topology"],
    "geometry": [],
    "solver": [],
    "integrators": ["solver"],
    "energies": ["topology", "geometry", "solver"],
    "structure": ["energies", "solver", "integrators"],
    "orthospectrum": ["structure"],
    "canonical": ["structure", "orthospectrum"],
    "meshing": ["topology"],
    "embedding": ["structure"],
    # What brings a mesh and a metric together; neither meshing nor embedding knows the other.
    "parameterise": ["meshing", "embedding"],
    "manifold": ["canonical", "orthospectrum", "meshing", "embedding", "parameterise"],
    "viewer": ["embedding", "orthospectrum"],
    "studies": ["structure", "canonical"],
    "cli": ["manifold", "viewer", "studies", "drawing"],
    "python": ["cli"],
}

HIDDEN = re.compile(
    r"^(ceres/|boost/|suitesparse/|SuiteSparse|cholmod|umfpack|klu|spqr|amd|camd|colamd|ccolamd|glpk"
    r"|GL/|EGL/|GLFW/|opencsg\.h|stb/|flint/|(?:arb|acb|arf|mag)(?:_\w+)?\.h)"
)
FORBIDDEN_CALLS = re.compile(
    r"\b(?:exit|_exit|_Exit|quick_exit|abort|printf|fprintf|vprintf|vfprintf|puts|fputs|"
    r"putchar|perror)\s*\("
    r"|\bstd::(?:terminate|cout|cerr|clog|print|println)\b|\bfmt::(?:print|println)\b|\b(?:stdout|stderr)\b"
)
# Between fork and exec a child has no other end.
ALLOWED_CALLS = {("meshing/detail/child_process.cpp", "_exit(")}
# Where GMP is missing, and only there.
ALLOWED_HIDDEN = {("base/big_number.hpp", "boost/multiprecision/cpp_int.hpp")}
# Strings and comments, raw strings first; a quote in digits (1'000) opens no character constant.
TEXT = re.compile(
    r'R"(\w*)\(.*?\)\1"'
    r"|\"(?:\\.|[^\"\\\n])*\"|(?<!\w)'(?:\\.|[^'\\\n])*'|//[^\n]*|/\*.*?\*/",
    re.DOTALL,
)
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def closure(module, uses):
    found, todo = set(), list(uses.get(module, []))
    while todo:
        name = todo.pop()
        if name not in found:
            found.add(name)
            todo += uses.get(name, [])
    return found


def allowed(module):
    return closure(module, USES) | {"base", module}


def code_only(text):
    """The text without strings and comments, lines kept."""
    return TEXT.sub(lambda m: '""' + "\n" * m.group(0).count("\n"), text)


def link_lists(cmake):
    """{module: (public, private)} of the tripus_add_module calls in a CMakeLists.txt."""
    result = {}
    for call in re.findall(r"tripus_add_module\(([^)]*)\)", re.sub(r"#[^\n]*", "", cmake)):
        words = call.split()
        lists, key = {"SOURCES": [], "PUBLIC": [], "PRIVATE": []}, None
        for word in words[1:]:
            if word in lists:
                key = word
            elif key:
                lists[key].append(word)
        own = re.compile(r"^tripus(?:::|_)(\w+)$")
        result[words[0]] = tuple(
            [m.group(1) for m in map(own.match, lists[k]) if m] for k in ("PUBLIC", "PRIVATE")
        )
    return result


def check(root):
    """Every violation, as "law: place: what"."""
    problems = []
    links, included = {}, {}

    def complain(law, place, what):
        problems.append(f"{law}: {place}: {what}")

    for cmake in sorted(root.glob("*/CMakeLists.txt")):
        for name, lists in link_lists(cmake.read_text()).items():
            links[name] = lists
            if name != cmake.parent.name or name not in USES:
                complain("listed", cmake.relative_to(root), f"module {name} is not in the table")

    top = root / "CMakeLists.txt"
    if top.is_file():
        added = re.findall(r"^\s*add_subdirectory\((\w+)", top.read_text(), re.MULTILINE)
        added = [name for name in added if name in USES]
        for name in sorted(set(links) - set(added)):
            complain("listed", "CMakeLists.txt", f"module {name} is not added")
        if added != sorted(added, key=list(USES).index):
            complain("listed", "CMakeLists.txt", f"modules are not in the order of the table: {added}")

    for module in USES:
        files = [p for p in sorted((root / module).rglob("*")) if p.suffix in (".hpp", ".cpp", ".in")]
        for path in files:
            place = path.relative_to(root)
            text = path.read_text()
            in_detail = "detail" in place.parts
            public = ".hpp" in path.suffixes and not in_detail and module != "cli"
            for number, line in enumerate(text.splitlines(), start=1):
                match = INCLUDE.match(line)
                if not match:
                    continue
                where, target = f"{place}:{number}", match.group(2)
                allowed_here = (place.as_posix(), target) in ALLOWED_HIDDEN
                if public and HIDDEN.match(target) and not allowed_here:
                    complain("hidden", where, f"{target} in a public header")
                first = target.split("/")[0]
                if match.group(1) == "<":
                    if first in USES and "/" in target and (root / target).exists():
                        complain("root", where, f'write "{target}" for our own headers')
                    continue
                if first not in USES or "/" not in target:
                    complain("root", where, f'"{target}" does not start at the root')
                    continue
                if first not in allowed(module):
                    complain("order", where, f"{module} may not use {first}")
                if "/detail/" in target and (first not in (module, "base") or public):
                    complain("detail", where, f"{target} is not for this file")
                if first != module:
                    included.setdefault(module, {}).setdefault((first, public), where)
            if module != "cli":
                for number, line in enumerate(code_only(text).splitlines(), start=1):
                    match = FORBIDDEN_CALLS.search(line)
                    if match and (place.as_posix(), match.group(0).strip()) not in ALLOWED_CALLS:
                        complain("silent", f"{place}:{number}", match.group(0).strip())

    public_links = {name: lists[0] for name, lists in links.items()}
    for module, (public, private) in links.items():
        place = f"{module}/CMakeLists.txt"
        for name in public + private:
            if name not in allowed(module):
                complain("link", place, f"{module} may not link {name}")
        reached = closure(module, public_links)
        reached_by_sources = set(reached)
        for name in private:
            reached_by_sources |= {name} | closure(name, public_links)
        for (name, in_public_header), where in included.get(module, {}).items():
            if in_public_header and name not in reached:
                complain("link", place, f"PUBLIC does not reach {name}, included in {where}")
            elif name not in reached_by_sources:
                complain("link", place, f"does not link {name}, included in {where}")
    return problems


GOOD = {
    "CMakeLists.txt": "add_subdirectory(base)\nadd_subdirectory(topology)\nadd_subdirectory(solver)\n"
                      "add_subdirectory(integrators)\n",
    "base/CMakeLists.txt": "tripus_add_module(base)",
    "base/error.hpp": "#include <string>\n",
    "base/detail/json.hpp": "#include <string>\n",
    "topology/CMakeLists.txt": "tripus_add_module(topology SOURCES a.cpp PUBLIC tripus::base)",
    "topology/a.hpp": '#include "base/error.hpp"\n// printf("x") is only a comment\n',
    "topology/a.cpp": '#include "topology/a.hpp"\n#include "topology/detail/b.hpp"\n'
                      "const char* s = \"exit(1)\"; int n = 1'000; int on_exit_of(int); snprintf(b, 1, s);\n",
    "topology/detail/b.hpp": "#include <boost/graph/adjacency_list.hpp>\n",
    "solver/CMakeLists.txt": "tripus_add_module(solver SOURCES s.cpp PUBLIC tripus::base)",
    "solver/s.cpp": '#include "base/detail/json.hpp"\n#include <ceres/ceres.h>\n',
    "integrators/CMakeLists.txt": "tripus_add_module(integrators PUBLIC tripus::solver)",
    "integrators/flow.hpp": '#include "solver/s.hpp"\n#include "base/error.hpp"\n',
}
BAD = [  # law, file, content that breaks it
    ("order", "solver/s.cpp", '#include "topology/a.hpp"\n'),
    ("order", "base/error.hpp", '#include "topology/a.hpp"\n'),
    ("order", "integrators/flow.hpp", '#include "geometry/angles.hpp"\n'),
    ("root", "topology/a.cpp", '#include "a.hpp"\n'),
    ("root", "topology/a.cpp", '#include "../base/error.hpp"\n'),
    ("root", "topology/a.cpp", "#include <base/error.hpp>\n"),
    ("detail", "topology/a.hpp", '#include "topology/detail/b.hpp"\n'),
    ("detail", "integrators/i.cpp", '#include "solver/detail/b.hpp"\n'),
    ("detail", "solver/s.hpp", '#include "base/detail/json.hpp"\n'),
    ("link", "topology/CMakeLists.txt", "tripus_add_module(topology SOURCES a.cpp)"),
    ("link", "topology/CMakeLists.txt", "tripus_add_module(topology SOURCES a.cpp PRIVATE tripus::base)"),
    ("link", "solver/CMakeLists.txt", "tripus_add_module(solver PUBLIC tripus::topology)"),
    ("hidden", "topology/a.hpp", "#include <ceres/ceres.h>\n"),
    ("hidden", "topology/a.hpp", "#  include <boost/graph/adjacency_list.hpp>\n"),
    ("hidden", "solver/s.hpp", "#include <suitesparse/cholmod.h>\n"),
    ("hidden", "solver/s.hpp", "#include <arb_mat.h>\n"),
    ("silent", "topology/a.cpp", "void f() { exit(1); }\n"),
    ("silent", "topology/a.cpp", "void f() { std::abort (); }\n"),
    ("silent", "topology/a.hpp", 'inline void f() { printf("x"); }\n'),
    ("silent", "solver/s.cpp", 'void f() { std::cerr << "x"; }\n'),
    ("listed", "gadgets/CMakeLists.txt", "tripus_add_module(gadgets)"),
    ("listed", "CMakeLists.txt", "add_subdirectory(topology)\nadd_subdirectory(base)\n"
                                 "add_subdirectory(solver)\nadd_subdirectory(integrators)\n"),
    ("listed", "CMakeLists.txt", "add_subdirectory(base)\nadd_subdirectory(topology)\n"),
]


def check_tree(files):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return check(Path(folder))


def self_test():
    wrong = [f"the good tree fails: {p}" for p in check_tree(GOOD)]
    for law, name, text in BAD:
        laws = {p.split(":")[0] for p in check_tree({**GOOD, name: text})}
        if law not in laws:
            wrong.append(f"{law} was not reported for {name}: {text!r}, but {sorted(laws)}")
    missed = {line.split()[0] for line in __doc__.split("The laws:")[1].splitlines() if line.strip()}
    for law in missed - {law for law, _, _ in BAD}:
        wrong.append(f"{law} is never broken in the self-test")
    return wrong


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    if sys.argv[1] == "--self-test":
        problems, done = self_test(), f"{len(BAD)} broken trees reported, 1 good tree accepted"
    else:
        root = Path(sys.argv[1]).resolve()
        if not (root / "base").is_dir():
            print(f"{root} has no base/: not the root of the repository", file=sys.stderr)
            return 2
        problems, done = check(root), "the modules keep to the architecture"
    print("\n".join(problems) or done)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
