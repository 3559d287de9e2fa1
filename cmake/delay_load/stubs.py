#!/usr/bin/env python3
"""Writes stubs for functions of shared libraries that a program loads when it first calls one.

A program linked with a stub for each function that it calls does not need the library to start.
The stub jumps through a slot. At first the slot leads to load.cpp, which loads the library and
puts the function's address there; from then on a call costs one indirect jump, as any call into a
shared library does. For x86-64 and ELF: arguments lie in registers, which are saved meanwhile, and
on the stack, which is left as it is.
"""
import argparse
import collections
import re
import subprocess
import sys

FUNCTIONS = "TW"  # nm's letters for what can be called
DATA = "BDRVGSu"

INTEGERS = ["rax", "rdi", "rsi", "rdx", "rcx", "r8", "r9", "r10"]  # rax: the number of vectors
VECTORS = [f"xmm{i}" for i in range(8)]
SAVED = 8 * len(INTEGERS) + 16 * len(VECTORS)

# Loading may throw: the unwinder is told where the frame is.
LOAD_AND_GO = f"""\
        .text
        .type   load_and_go, @function
load_and_go:
        .cfi_startproc
        .cfi_def_cfa_offset 16
        subq    ${SAVED}, %rsp
        .cfi_def_cfa_offset {16 + SAVED}
{{save}}
        movq    {SAVED}(%rsp), %rdi
        call    tripus_delayed_function
        movq    %rax, %r11
{{restore}}
        addq    ${SAVED + 8}, %rsp
        .cfi_def_cfa_offset 8
        jmp     *%r11
        .cfi_endproc
        .size   load_and_go, . - load_and_go
"""

STUB = """\
        .globl  {name}
        .type   {name}, @function
{name}:
        .cfi_startproc
        jmp     *tripus_delayed_slots+{offset}(%rip)
        .cfi_endproc
        .size   {name}, . - {name}
first_{number}:
        .cfi_startproc
        pushq   ${number}
        .cfi_def_cfa_offset 16
        jmp     load_and_go
        .cfi_endproc
"""


def places_of_registers():
    for i, register in enumerate(INTEGERS):
        yield "movq   ", register, 8 * i
    for i, register in enumerate(VECTORS):
        yield "movups ", register, 8 * len(INTEGERS) + 16 * i


def assembly(functions):
    save = [f"        {move} %{r}, {at}(%rsp)" for move, r, at in places_of_registers()]
    restore = [f"        {move} {at}(%rsp), %{r}" for move, r, at in places_of_registers()]
    lines = [LOAD_AND_GO.format(save="\n".join(save), restore="\n".join(restore))]
    lines += [STUB.format(name=name, number=i, offset=8 * i) for i, (_, name) in enumerate(functions)]
    lines += ["        .data", "        .balign 8", "        .globl  tripus_delayed_slots",
              "        .hidden tripus_delayed_slots", "tripus_delayed_slots:"]
    lines += [f"        .quad   first_{i}" for i in range(len(functions))]
    lines += ['        .section .note.GNU-stack,"",@progbits', ""]
    return "\n".join(lines)


def table(functions):
    rows = "".join(f'    {{"{library}", "{name}"}},\n' for library, name in functions)
    return ("// Written by stubs.py: the library and the function of each slot.\n"
            f"extern \"C\" void* tripus_delayed_slots[{len(functions)}];\n"
            f"constexpr Function kFunctions[] = {{\n{rows}}};\n")


def symbols(nm, file, *options):
    """(object, letter, name) of each symbol of an archive, an object or a shared library."""
    out = subprocess.run([nm, "--format=posix", "--print-file-name", *options, file], check=True,
                         capture_output=True, text=True).stdout
    for line in out.splitlines():
        place, name, letter = re.match(r"(.*?):? (\S+) (\S)(?: |$)", line).groups()
        found = re.search(r"\[(.+)\]$", place)
        yield found.group(1) if found else place, letter, name.split("@")[0]


def soname(readelf, library):
    """The name by which the loader finds a shared library."""
    out = subprocess.run([readelf, "--dynamic", "--wide", library], check=True,
                         capture_output=True, text=True).stdout
    return re.search(r"\(SONAME\).*\[(.+)\]", out).group(1)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--nm", default="nm")
    parser.add_argument("--readelf", default="readelf")
    parser.add_argument("--objects", nargs="+", required=True,
                        help="what the program is linked from: archives and objects")
    parser.add_argument("--libraries", nargs="*", default=[], help="to be loaded when called")
    parser.add_argument("--instead", nargs="*", default=[], metavar="OBJECT",
                        help="objects of the archives that libraries have as well: not linked")
    parser.add_argument("--assembly", required=True)
    parser.add_argument("--table", required=True)
    options = parser.parse_args()

    needed, defined = set(), set()
    for file in options.objects:
        for place, letter, name in symbols(options.nm, file):
            if place in options.instead:
                continue
            (needed if letter in "Uvw" else defined).add(name)
    needed -= defined

    functions, data = [], collections.defaultdict(list)
    for library in options.libraries:
        name_of_library = soname(options.readelf, library)
        for _, letter, name in symbols(options.nm, library, "--dynamic", "--defined-only"):
            if name in needed and letter in FUNCTIONS:
                functions.append((name_of_library, name))
                needed.discard(name)
            elif name in needed and letter in DATA:
                data[name_of_library].append(name)
    for library, names in data.items():
        sys.exit(f"stubs.py: {library} cannot be loaded later: the program uses its data "
                 f"{', '.join(names)}")

    with open(options.assembly, "w", encoding="ascii") as file:
        file.write(assembly(functions))
    with open(options.table, "w", encoding="ascii") as file:
        file.write(table(functions))


if __name__ == "__main__":
    main()
