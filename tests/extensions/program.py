"""The program with the worked examples in it: everything follows from the tables."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
PROGRAM = sys.argv.pop(1)
VOLUME = 6.45199027083503287  # of cPcbbbihq, docs/theory.md (28)


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=60,
                          check=False)


class Extended(unittest.TestCase):
    def test_the_tables_list_them(self):
        tables = json.loads(run("methods", "--json").stdout)
        self.assertIn("gradient-descent", [row["name"] for row in tables["methods"]])
        self.assertIn("weighted", [row["name"] for row in tables["energies"]])

    def test_a_method_and_an_energy_solve(self):
        for method in ("gradient-descent", "weighted:newton", "weighted:newton-cg",
                       "weighted:ceres-lbfgs", "weighted:gradient-descent"):
            answer = json.loads(run("solve", "dLQbcccdero", "--method", method, "--json").stdout)
            expected = json.loads(run("solve", "dLQbcccdero", "--json").stdout)
            self.assertEqual((answer["outcome"], answer["method"]), ("geometric", method))
            self.assertAlmostEqual(answer["volume"], expected["volume"], delta=1e-11)

    def test_an_unknown_method_lists_them(self):
        error = run("solve", "cPcbbbihq", "--method", "banana").stderr
        self.assertIn("gradient-descent", error)
        self.assertIn("weighted:newton", error)

    def test_a_format_is_read_wherever_an_input_is(self):
        gluings = json.loads(run("cover", "cPcbbbihq", "--cyclic", "1", "--json").stdout)["gluings"]
        rows = [f"{t},{f},{other},{p}"
                for t, faces in enumerate(gluings) for f, (other, p) in enumerate(faces)]
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "table.csv")
            file.write_text("\n".join(["tetrahedron,face,neighbour,gluing", *rows]) + "\n")
            answer = json.loads(run("solve", str(file), "--json").stdout)
            self.assertAlmostEqual(answer["volume"], VOLUME, delta=1e-12)
            file.write_text("tetrahedron,face,neighbour,gluing\n0,0,1,0122\n")
            refused = run("info", str(file))
            self.assertEqual(refused.returncode, 2)
            self.assertIn("line 2", refused.stderr)
            file.write_text("two words")
            self.assertIn("comma-separated gluing table", run("info", str(file)).stderr)

    def test_a_mesh_format_is_read_wherever_an_input_is(self):
        off = Path(SOURCE, "examples/surfaces/knotted-y.off").read_text().split("\n")
        points, triangles = (int(word) for word in off[1].split()[:2])
        rows = off[2:2 + points + triangles]
        corners = [row.split()[1:4] for row in rows[points:]]
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "y.raw")
            file.write_text("\n".join(" ".join(rows[int(c)] for c in each) for each in corners))
            answer = json.loads(run("solve", str(file), "--json").stdout)
            self.assertAlmostEqual(answer["volume"], VOLUME, delta=1e-12)
            file.write_text("0 0 0 1 0 0 0 1\n")
            refused = run("info", str(file))
            self.assertEqual(refused.returncode, 2)
            self.assertIn("line 1: expected nine numbers", refused.stderr)
            file.write_text("0 0 0 1 0 0 0 1 0 7\n")
            self.assertIn("line 1: more than nine numbers", run("info", str(file)).stderr)
            Path(folder, "y").write_text("two words")
            self.assertIn("raw triangles", run("info", str(Path(folder, "y"))).stderr)

    def test_a_verb_has_the_help_and_the_habits_of_all(self):
        self.assertIn("volume", run("--help").stdout)
        self.assertIn("--time-limit", run("volume", "--help").stdout)
        self.assertAlmostEqual(float(run("volume", "cPcbbbihq").stdout), VOLUME, delta=1e-12)
        answer = json.loads(run("volume", "cPcbbbihq", "--json").stdout)
        self.assertAlmostEqual(answer["volume"], VOLUME, delta=1e-12)
        none = run("volume", "dLQbcbcaekw")
        self.assertEqual(none.returncode, 1)
        refused = json.loads(run("volume", "dLQbcbcaekw", "--json").stdout)
        self.assertIsNone(refused["volume"])
        self.assertEqual(run("volume", "nonsense").returncode, 2)


if __name__ == "__main__":
    unittest.main()
