"""Takes libblas and liblapack out of a repaired wheel: Debian's OpenBLAS has all that is in them.

usage: slim_wheel.py WHEEL        which is replaced
"""

import os
import subprocess
import sys
from pathlib import Path

from auditwheel.wheeltools import InWheelCtx


def patchelf(*arguments: str) -> str:
    return subprocess.run(["patchelf", *arguments], check=True, capture_output=True, text=True).stdout


def symbols(library: Path, which: str) -> set[str]:
    listed = subprocess.run(["nm", "-D", which, library], check=True, capture_output=True, text=True)
    return {line.split()[-1].split("@")[0] for line in listed.stdout.splitlines()}


def slim(root: Path) -> None:
    libraries = [path for path in root.rglob("*.so*") if path.is_file()]
    [openblas] = [path for path in libraries if path.name.startswith("libopenblas")]
    doubles = [path for path in libraries if path.name.startswith(("libblas-", "liblapack-"))]
    there = symbols(openblas, "--defined-only")
    for library in (path for path in libraries if path not in doubles and path != openblas):
        needed = patchelf("--print-needed", str(library)).split()
        gone = [double for double in doubles if double.name in needed]
        if not gone:
            continue
        wanted = symbols(library, "--undefined-only")
        missing = [s for double in gone for s in symbols(double, "--defined-only") & wanted - there]
        if missing:
            sys.exit(f"slim_wheel.py: {openblas.name} has no {missing[0]}, which {library.name} needs")
        for double in gone:
            patchelf("--replace-needed", double.name, openblas.name, str(library))
    for double in doubles:
        double.unlink()


def main() -> None:
    wheel = Path(sys.argv[1]).resolve()
    draft = wheel.with_name("slim-" + wheel.name)
    with InWheelCtx(wheel, draft) as context:
        slim(Path(str(context.name)))
    os.replace(draft, wheel)


if __name__ == "__main__":
    main()
