"""The types are right: mypy, strict, on the package and on what a user writes."""

import pathlib
import subprocess
import sys

import tripus

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = pathlib.Path(tripus.__file__).parent

USE = """
import numpy as np
import numpy.typing as npt
import tripus

M = tripus.Manifold("cPcbbbihq")
volume: float = M.volume()
lengths: npt.NDArray[np.float64] = M.metric.edge_lengths
names: list[str] = [entry.name for entry in M.identify()]
covers: list[tripus.Manifold] = M.covers(2)
order: int = M.symmetry_group().order()
yes: bool = bool(M.compare(covers[0]))
wrong: int = M.homology()  # type: ignore[assignment]
M.volume(verified="yes")  # type: ignore[arg-type]
"""


def mypy(*arguments):
    done = subprocess.run(
        [sys.executable, "-m", "mypy", f"--config-file={ROOT / 'pyproject.toml'}",
         f"--cache-dir={PACKAGE.parent / 'mypy_cache'}", *arguments],
        capture_output=True, text=True, env={"MYPYPATH": str(PACKAGE.parent), "PATH": ""},
    )
    return done.stdout + done.stderr, done.returncode


def test_package_and_use(tmp_path):
    (tmp_path / "use.py").write_text(USE)
    assert (PACKAGE / "_core.pyi").exists(), "build the target tripus_python_stub"
    output, status = mypy(str(PACKAGE), str(tmp_path / "use.py"))
    assert status == 0, output
