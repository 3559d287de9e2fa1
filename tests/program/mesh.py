"""tripus mesh, and surfaces and solids as INPUT of the other verbs."""

import os
import signal
import subprocess
import time
from pathlib import Path

from support import DATA, TRIPUS, TRIPUS_VOLUME, ProgramTest, read_json

ROOT = DATA.parent
SURFACES = ROOT / "examples" / "surfaces"
BROKEN = ROOT / "tests" / "broken-meshes"

KEYS = ["tripus", "input", "isosig", "tetrahedron_count", "edge_count", "orientable",
        "edge_valences", "oriented_isosig", "points", "triangles", "turned_triangles",
        "boundary_genera", "stages", "notes", "ball", "gluings", "message"]

BALL = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"


class Mesh(ProgramTest):
    def surface(self, name):
        return self.write(name, (SURFACES / name).read_bytes())

    def test_stages_of_the_knotted_y(self):
        for name, genera in (("knotted-y.off", [2]), ("knotted-theta.off", [0, 2])):
            with self.subTest(name):
                answer = self.json_answer("mesh", self.surface(name))
                self.assertEqual(list(answer), KEYS)
                self.assertEqual(answer["input"], name)
                self.assertEqual(answer["isosig"], TRIPUS)
                self.assertEqual(answer["boundary_genera"], genera)
                self.assertEqual(list(answer["stages"]), ["mesh", "coned", "collapsed", "minimal"])
                stages = answer["stages"]
                self.assertEqual(stages["coned"], stages["mesh"] + answer["triangles"])
                self.assertGreater(stages["mesh"], stages["collapsed"])
                self.assertEqual(stages["minimal"], 2)
                text = self.run_program("mesh", name)
                self.assertEqual((text.status, text.err), (0, ""))
                for stage, count in stages.items():
                    self.assertRegex(text.text, rf"\n  {stage} +{count} tetrahedra\n")

    def test_its_output_is_input_again(self):
        self.surface("knotted-y.off")
        whole = self.run_program("mesh", "knotted-y.off", "--json", "-o", "y.json", "--save-mesh",
                                 "y.vtk")
        self.write("whole.json", whole.out)
        self.run_program("mesh", "knotted-y.off", "-o", "y.sig", "--save-mesh", "y.mesh")
        for name in ("whole.json", "y.json", "y.sig", "y.vtk", "y.mesh"):
            with self.subTest(name):
                answer = self.json_answer("solve", name)
                self.assertEqual(answer["isosig"], TRIPUS)
                self.assertAlmostEqual(answer["volume"], TRIPUS_VOLUME, delta=1e-12)

    def test_seeds_and_sizes(self):
        self.surface("knotted-y.off")
        for options in (["--seed", "3"], ["--tetrahedra", "9000"], ["--max-volume", "0.01"]):
            with self.subTest(options):
                answer = self.json_answer("mesh", "knotted-y.off", *options)
                self.assertEqual(answer["isosig"], TRIPUS)
                again = self.json_answer("mesh", "knotted-y.off", *options)
                self.assertEqual(again, answer)

    def test_sizes_that_the_boundary_alone_does_not_give(self):
        self.write("ball.off", BALL)
        stages = self.json_answer("mesh", "ball.off", "--tetrahedra", "1000", status=1)["stages"]
        self.assertAlmostEqual(stages["mesh"], 1000, delta=100)
        stages = self.json_answer("mesh", "ball.off", "--max-volume", "1e-2", status=1)["stages"]
        self.assertGreaterEqual(stages["mesh"], 17)  # the volume is 1/6
        self.assert_refused("mesh", "ball.off", "--max-volume", "1e-300", says="memory")

    def test_a_ball(self):
        self.write("ball.off", BALL)
        answer = self.json_answer("mesh", "ball.off", status=1)
        self.assertIs(answer["ball"], True)
        self.assertIn("it bounds a ball", answer["message"])
        self.assertIn("it bounds a ball", self.run_program("mesh", "ball.off").text)
        self.assert_refused("solve", "ball.off", says='"ball.off": it bounds a ball')

    def test_a_ball_filled_in_is_a_triangulation(self):
        self.write("ball.off", BALL)
        answer = self.json_answer("info", "ball.off")
        self.assertEqual([v["genus"] for v in answer["vertices"]], [0])
        self.assertEqual(self.json_answer("simplify", "ball.off")["tetrahedron_count"], 1)
        none = self.run_program("cover", "ball.off", "--cyclic", "2")
        self.assertEqual(none.status, 1)
        self.assertIn("no cyclic cover", none.err)

    def test_what_cannot_carry_a_metric_is_named(self):
        self.write("trefoil.json", (ROOT / "examples" / "graphs" / "trefoil.json").read_bytes())
        self.run_program("tube", "trefoil.json", "-o", "torus.off")
        text = self.run_program("mesh", "torus.off")
        self.assertEqual(text.status, 0)
        self.assertNotIn("not solvable", text.text)
        self.assertEqual(self.run_program("embed", "torus.off").status, 1)
        self.assertEqual(self.run_program("canonize", "torus.off", "--budget", "20").status, 1)
        result = self.run_program("compare", TRIPUS, "torus.off")
        self.assertEqual(result.status, 1)
        self.assertIn("the boundary of one is genus 2, that of the other genus 1", result.text)
        self.assertEqual(self.run_program("compare", "cPcbbbiht", "cPcbbbiht").status, 0)

    def test_a_batch(self):
        self.surface("knotted-y.off")
        self.write("ball.off", BALL)
        self.write("list", "knotted-y.off\nball.off\nnone.off\n")
        result = self.run_program("mesh", "--batch", "list", "--json")
        self.assertEqual(result.status, 0)
        first, second, third = map(read_json, result.lines)
        self.assertEqual(first["isosig"], TRIPUS)
        self.assertIs(second["ball"], True)
        self.assertIn("error", third)

    def test_what_it_refuses(self):
        self.write("ball.off", BALL)
        self.write("tripus.sig", TRIPUS)
        self.assert_refused("mesh", "tripus.sig", says="is a triangulation (isomorphism signature) and no mesh")
        self.assert_refused("mesh", "none.off", says='cannot open "none.off"')
        self.assert_refused("mesh", "ball.off", "-o", "x.txt", says="must end with .json")
        self.assert_refused("mesh", "ball.off", "--save-mesh", "x.off", says="must end with .vtk")
        self.assert_refused("mesh", "ball.off", "--save-mesh", "none/x.vtk", says="cannot write")
        self.assert_refused("mesh", "none.off", "--pictures", "none/x", says="cannot write")
        for option in ("-o", "--save-mesh", "--pictures"):
            self.assert_refused("mesh", "ball.off", option, "", says="is empty")
        self.assert_refused("simplify", TRIPUS, "-o", "", says="is empty")
        self.assert_refused("simplify", "none.off", "-o", "none/x.sig", says="cannot write")
        self.assert_refused("cover", TRIPUS, "--degree", "2", "-o", "", says="is empty")
        self.assert_refused("cover", TRIPUS, "--degree", "2", "-o", "no/x", says="No such file")
        for option in ("--tsv", "--database"):
            result = self.run_program("census", "--from", "tripus.sig", option, "no/x")
            self.assertEqual(result.status, 2)
            self.assertIn('cannot write "no/x": No such file', result.err)
        (self.folder / "full.json").symlink_to("/dev/full")
        late = self.run_program("mesh", "ball.off", "-o", "full.json")
        self.assertEqual((late.status, late.err),
                         (3, 'tripus: cannot write "full.json": No space left on device\n'))
        self.assert_refused("mesh", "ball.off", "--tetrahedra", "-1", says="--tetrahedra")
        self.assert_refused("mesh", "ball.off", "--max-volume", "0", says="--max-volume")


class MeshInput(ProgramTest):
    def test_of_every_verb(self):
        name = self.write("y.off", (SURFACES / "knotted-y.off").read_bytes())
        answer = self.json_answer("solve", name)
        self.assertEqual((answer["input"], answer["isosig"]), (name, TRIPUS))
        self.assertAlmostEqual(answer["volume"], TRIPUS_VOLUME, delta=1e-12)
        self.assertEqual(list(answer), list({**self.json_answer("solve", TRIPUS)}))
        self.assertEqual(self.json_answer("info", name)["isosig"], TRIPUS)
        self.assertEqual(self.json_answer("identify", name)["census"]["name"], "t2g2.8")
        self.assertEqual(self.json_answer("canonize", name)["isosig"], TRIPUS)
        self.assertEqual(self.run_program("compare", name, TRIPUS).status, 0)

    def test_from_standard_input(self):
        text = (SURFACES / "knotted-theta.off").read_bytes()
        self.assertEqual(self.json_answer("info", "-", stdin=text)["isosig"], TRIPUS)

    def test_broken_meshes(self):
        for line in (BROKEN / "messages.tsv").read_text().splitlines()[1:]:
            name, says = line.split("\t")
            # One of each format; the library's tests take all.
            if not name.startswith(("open-edge", "wrong-index", "overlap", "claims")):
                continue
            with self.subTest(name):
                for part in BROKEN.glob(Path(name).stem + ".*"):
                    self.write(part.name, part.read_bytes())
                self.assert_refused("solve", name, says=says, kind="invalid-input")
                self.assert_refused("mesh", name, says=f'"{name}": ', kind="invalid-input")

    def test_without_tetgen(self):
        self.write("ball.off", BALL)
        result = self.run_program("mesh", "ball.off", env={**os.environ, "TRIPUS_TETGEN": "/none"})
        self.assertEqual(result.status, 2)
        self.assertIn("TRIPUS_TETGEN names", result.err)


class MeshInterrupt(ProgramTest):
    def children(self, process):
        path = Path(f"/proc/{process}/task/{process}/children")
        return path.read_text().split() if path.exists() else []

    def interrupt(self, how):
        """Starts a run whose mesher hangs, interrupts it, and waits for both to be gone."""
        script = self.folder / "tetgen"
        script.write_text("#!/bin/sh\nexec sleep 1000\n")
        script.chmod(0o755)
        name = self.write("ball.off", BALL)
        run = subprocess.Popen(self.command("solve", name, "--json"), cwd=self.folder,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               env={**os.environ, "TRIPUS_TETGEN": str(script)})
        end = time.monotonic() + 60
        while not self.children(run.pid) and time.monotonic() < end:
            time.sleep(0.01)
        child = self.children(run.pid)[0]
        run.send_signal(how)
        out, err = run.communicate(timeout=60)
        return run.returncode, out, err.decode(), child

    def test_ends_cleanly(self):
        status, out, err, child = self.interrupt(signal.SIGINT)
        self.assertEqual(status, 1)
        self.assertEqual(read_json(out.decode())["error"]["kind"], "interrupted")
        self.assertIn("interrupted", err)
        self.assertFalse(Path(f"/proc/{child}").exists())


class MeshKilled(ProgramTest):
    def test_leaves_no_process(self):
        """The real mesher on a large job, whose parent is killed and cannot clean up."""
        name = self.write("y.off", (SURFACES / "knotted-y.off").read_bytes())
        run = subprocess.Popen(self.command("mesh", name, "--tetrahedra", "20000000"),
                               cwd=self.folder, stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
        children = Path(f"/proc/{run.pid}/task/{run.pid}/children")
        child, end = None, time.monotonic() + 60
        while child is None and time.monotonic() < end:
            child = next(iter(children.read_text().split()), None)
        run.kill()
        run.wait()
        while Path(f"/proc/{child}").exists() and time.monotonic() < end:
            time.sleep(0.05)
        self.assertFalse(Path(f"/proc/{child}").exists())
