"""tripus simplify: answers, files, refusals, interruption."""

import json
import signal
import subprocess
import time

from support import TRIPUS, ProgramTest, read_json

# Carries no metric and has four tetrahedra; three are enough for its manifold.
LARGE = "eLAkbccdddprdk"
# Weeks's manifold with nine tetrahedra: not the least that E = T + chi/2 allows, so the search goes
# on as long as it is told.
WEEKS = "jLvAMPQadfgghhiiijaqgjqxims"


def table(gluings):
    return json.dumps({"gluings": gluings})


def open_ring(n):
    """A JSON gluing table of a ring of n tetrahedra around an edge, with open faces: a ball."""
    return table([[None, None, [(t + 1) % n, "0132"], [(t - 1) % n, "0132"]] for t in range(n)])


class Simplify(ProgramTest):
    def test_json(self):
        answer = self.json_answer("simplify", LARGE)
        self.assertEqual(answer["tetrahedron_count"], 3)
        self.assertEqual(list(answer["stages"]), ["given", "collapsed", "reduced", "simplified"])
        self.assertEqual(answer["stages"]["given"], 4)
        self.assertEqual(answer["stages"]["simplified"], 3)
        self.assertEqual(answer["finite_vertices_left"], 0)
        self.assertIs(answer["interrupted"], False)
        self.assertEqual(self.json_answer("compare", LARGE, answer["isosig"])["verdict"],
                         "homeomorphic")

    def test_least_ones_stay(self):
        answer = self.json_answer("simplify", TRIPUS)
        self.assertEqual((answer["isosig"], answer["tetrahedron_count"]), (TRIPUS, 2))

    def test_text(self):
        result = self.run_program("simplify", LARGE)
        self.assertEqual((result.status, result.err), (0, ""))
        self.assertIn("3 tetrahedra, 2 edge classes, orientable; vertex links: genus 2", result.text)
        self.assertRegex(result.text, r"(?m)^  given +4 tetrahedra$")
        self.assertRegex(result.text, r"(?m)^  signature +d")

    def test_open_faces_are_coned_off(self):
        ball = self.write("ball.json", open_ring(7))
        answer = self.json_answer("simplify", ball)
        self.assertEqual(answer["stages"]["coned"], 21)
        self.assertEqual(answer["tetrahedron_count"], 1)
        self.assertIn("finite", answer["message"])

    def test_same_seed_same_answer(self):
        first = self.json_answer("simplify", LARGE, "--seed", "7", "--effort", "0.5")
        self.assertEqual(first, self.json_answer("simplify", LARGE, "--seed", "7", "--effort", "0.5"))

    def test_output_is_an_input(self):
        for name in ("small.json", "small.sig"):
            answer = self.json_answer("simplify", LARGE + "+", "-o", name)
            again = self.json_answer("info", name)
            self.assertEqual(again["isosig"], answer["isosig"])

    def test_batch(self):
        batch = self.write("list.txt", f"{LARGE}\n{TRIPUS} # least\n")
        result = self.run_program("simplify", "--batch", batch, "--json")
        self.assertEqual((result.status, result.err), (0, ""))
        self.assertEqual([read_json(line)["tetrahedron_count"] for line in result.lines], [3, 2])


class Refusals(ProgramTest):
    def test_usage(self):
        self.assert_refused("simplify", TRIPUS, "-o", "small.off", says="must end with .json",
                            kind="invalid-input")
        self.assert_refused("simplify", TRIPUS, "--effort", "-1", says="not a number from 0",
                            kind="usage")
        self.assert_refused("simplify", TRIPUS, "-o", "no/such/folder.json", says="cannot write")
        self.assertEqual(
            self.run_program("simplify", "--batch", "x", "-o", "small.sig").status, 2)

    def test_a_pinched_boundary(self):
        pinched = self.write("pinched.json", table(
            [[[1, "0123"], [1, "1203"], None, None], [[0, "0123"], None, [0, "2013"], None]]))
        self.assert_refused("simplify", pinched, kind="invalid-input",
                            says="pinched at vertex 3 of tetrahedron 0: 2 sheets of it meet there")

    def test_reversed_edges(self):
        reversed_edge = self.write("reversed.json", table(
            [[[0, "1023"], [0, "1023"], [0, "1032"], [0, "1032"]]]))
        self.assert_refused("simplify", reversed_edge, says="identified with its own reverse")


class Interruption(ProgramTest):
    def test_ends_with_what_there_is(self):
        # Long enough a search to be interrupted, whatever the machine.
        process = subprocess.Popen(
            self.command("simplify", "--json", "--effort", "100000", WEEKS),
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=self.folder)
        time.sleep(1.0)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=60)
        self.assertEqual((process.returncode, err), (1, b"tripus: interrupted\n"))
        answer = read_json(out.decode())
        self.assertIs(answer["interrupted"], True)
        self.assertIn("interrupted", answer["message"])
        self.assertLessEqual(answer["tetrahedron_count"], 9)
