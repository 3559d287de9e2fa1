"""Heavy libraries are loaded when they are used (cmake/delay_load)."""

import os
import shutil
import subprocess
import unittest
from pathlib import Path

from support import TRIPUS, ProgramTest

PROGRAM = Path(os.environ["TRIPUS_PROGRAM"])
PLUGINS = PROGRAM.parents[1] / "lib" / "tripus"


@unittest.skipUnless((PLUGINS / "libtripus_minimisers.so").exists(),
                     "this build is linked with all libraries")
class Loading(ProgramTest):
    def loaded_by(self, *arguments):
        """Names of the shared libraries that a run loads, as the loader itself tells them."""
        environment = dict(os.environ, LD_DEBUG="files", LD_DEBUG_OUTPUT=str(self.folder / "log"))
        result = self.run_program(*arguments, env=environment)
        self.assertEqual(result.status, 0, result.err)
        logs = list(self.folder.glob("log.*"))
        log = "".join(path.read_text() for path in logs)
        for path in logs:
            path.unlink()
        return {Path(line.split("calling init: ")[1]).name.split(".so")[0]
                for line in log.splitlines() if "calling init: " in line}

    def test_little_is_loaded_at_the_start(self):
        for arguments in (["--version"], ["info", TRIPUS], ["solve", TRIPUS, "--json"]):
            names = self.loaded_by(*arguments)
            self.assertIn("libstdc++", names)
            for heavy in ("libtripus_minimisers", "libtripus_graphics", "libcholmod",
                          "libopenblas", "libglpk", "libflint", "libGL", "libEGL", "libopencsg",
                          "libglfw", "libsqlite3"):
                self.assertNotIn(heavy, names, arguments)

    def test_a_library_comes_when_it_is_used(self):
        self.assertIn("libtripus_minimisers", self.loaded_by("solve", TRIPUS, "--method", "ceres-lm"))
        self.assertIn("libflint-arb", self.loaded_by("prove", TRIPUS, "--digits", "50"))
        self.assertIn("libtripus_graphics", self.loaded_by("view", TRIPUS, "--png", "a.png",
                                                           "--cells", "1", "--size", "20x20"))

    def test_a_library_that_is_not_there_is_named(self):
        moved = self.folder / "bin" / "tripus"
        moved.parent.mkdir()
        shutil.copy(PROGRAM, moved)
        moved.write_bytes(moved.read_bytes().replace(str(PLUGINS).encode(),
                                                             b"/" * len(str(PLUGINS))))
        done = subprocess.run([moved, "solve", TRIPUS, "--method", "ceres-lm"],
                              capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("libtripus_minimisers.so", done.stderr)
        self.assertIn("install", done.stderr)
        done = subprocess.run([moved, "solve", TRIPUS], capture_output=True, timeout=60)
        self.assertEqual(done.returncode, 0)
