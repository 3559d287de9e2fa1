"""Cusps, cone angles, finite vertices: by the command line."""

import json
import math

from support import TRIPUS, ProgramTest, read_json


class Cusps(ProgramTest):
    VOLUMES = {"cPcbbbiht": 2.02988321281931, "dLQacccjjkg": 7.79763688029484,
               "bkaaid": 1.01494160640966}

    def test_volumes_and_kinds(self):
        for signature, volume in self.VOLUMES.items():
            with self.subTest(signature):
                answer = self.json_answer("solve", signature)
                self.assertEqual(answer["outcome"], "geometric")
                self.assertAlmostEqual(answer["volume"], volume, delta=1e-13)
                kinds = sorted(vertex["kind"] for vertex in answer["vertices"])
                expected = ["cusp", "geodesic"] if signature == "dLQacccjjkg" else ["cusp"]
                self.assertEqual(kinds, expected)
                for vertex in answer["vertices"]:
                    if vertex["kind"] == "cusp":
                        self.assertAlmostEqual(vertex["area"], math.sqrt(3) / 2, delta=1e-12)
        text = self.run_program("solve", "bkaaid").text
        self.assertIn("complete hyperbolic metric with cusps", text)
        self.assertIn("cusp            a Klein bottle", text)
        self.assertIn("geodesic surface of genus 2", self.run_program("solve", "dLQacccjjkg").text)

    def test_what_does_not_know_them_says_so(self):
        self.assert_refused("embed", "cPcbbbiht", says="is a torus", kind="unsupported")
        self.assert_refused("solve", "cPcbbbiht", "--method", "angles:newton",
                            says="works with geodesic boundary only", kind="unsupported")

    def test_canonical_decompositions(self):
        for signature, order in [("cPcbbbiht", 8), ("cPcbbbdxm", 8), ("bkaaid", 2)]:
            answer = self.json_answer("canonize", signature)
            self.assertEqual(answer["outcome"], "geometric")
            self.assertEqual(answer["isometry_group"]["order"], order)
        self.assertEqual(self.json_answer("canonize", "dLQacccjjkg")["outcome"], "geometric")
        different = self.run_program("compare", "cPcbbbiht", "cPcbbbdxm")
        self.assertEqual(different.status, 1)

    def test_a_census_of_them(self):
        self.write("list", "cPcbbbiht\ndLQacccjjkg\nbkaaid\n4_1\n")
        result = self.run_program("census", "--from", "list", "--tsv", "-", "--quiet")
        self.assertEqual(result.status, 0, result.err)
        rows = [line.split("\t") for line in result.lines if not line.startswith("#")][1:]
        self.assertEqual([row[2] for row in rows], ["K", "T", "g2+T"])
        for row, volume in zip(rows, (1.01494160640966, 2.02988321281931, 7.79763688029484)):
            self.assertAlmostEqual(float(row[3]), volume, delta=1e-12)
        self.assertIn("no manifolds with cusps",
                      self.run_program("identify", "cPcbbbiht").text)

    def test_a_certificate(self):
        answer = self.run_program("solve", "eLAkbbcddpucaj", "--json")
        self.assertEqual(read_json(answer.text)["outcome"], "infeasible")
        self.write("answer", answer.out)
        self.assertIs(self.json_answer("check", "answer", "eLAkbbcddpucaj")["valid"], True)


class ConeAngles(ProgramTest):
    def test_orders_on_the_command_line_in_json_and_in_a_batch(self):
        direct = self.json_answer("solve", "cPcbbbiht", "--cone-order", "0=2,1=2")
        self.assertAlmostEqual(direct["volume"], 6.45199027083503, delta=1e-13)
        self.assertEqual(direct["cone_orders"], [2, 2])
        self.assertEqual(direct["vertices"][0]["kind"], "geodesic")
        self.assertEqual(direct["vertices"][0]["orbifold_euler_characteristic"], -2)
        info = self.json_answer("info", "cPcbbbihq")
        self.write("list", "cPcbbbiht 0=2,1=2\ncPcbbbiht\ncPcbbbiht 0=5/2\ncPcbbbiht 2=2\n")
        lines = [read_json(line) for line in
                 self.run_program("solve", "--batch", "list", "--json").lines]
        self.assertEqual(lines[0]["volume"], direct["volume"])
        self.assertAlmostEqual(lines[1]["volume"], 2.02988321281931, delta=1e-13)
        self.assertEqual(lines[2]["cone_orders"], ["5/2", 1])
        self.assertIn("only the edge classes 0 to 1", lines[3]["error"]["message"])
        self.assertNotIn("cone_orders", info)

    def test_orders_behind_an_input_are_refused_by_name(self):
        for verb in (("orthospectrum",), ("embed",), ("cover", "--cyclic", "2"), ("simplify",)):
            with self.subTest(verb[0]):
                self.assert_refused(*verb, "cPcbbbihq 0=2", says="singular edges", kind="unsupported")

    def test_orders_stay_in_what_is_written(self):
        self.run_program("solve", "cPcbbbiht", "--cone-order", "0=2", "-o", "labelled.json")
        written = self.json_answer("solve", "labelled.json")
        self.assertEqual(written["cone_orders"], [2, 1])
        self.assertLess(abs(written["volume"] - 4.9386073157377043), 1e-12)
        self.assert_refused("solve", "cPcbbbiht", "--cone-order", "0=2", "-o", "labelled.sig",
                            says="keeps no cone angles")
        drilled = self.json_answer("simplify", "cPcbbbiht 0=2", "--drill", "singular")
        self.assertEqual(drilled["tetrahedron_count"], 3)

    def test_in_a_file(self):
        gluings = [[[1, "1230"], [1, "3012"], [1, "0321"], [1, "0213"]],
                   [[0, "1230"], [0, "3012"], [0, "0321"], [0, "0213"]]]
        self.write("m.json", json.dumps({"gluings": gluings, "cone_orders": [3]}))
        labelled = self.json_answer("solve", "m.json")
        self.assertEqual(labelled["volume"],
                         self.json_answer("solve", TRIPUS, "--cone-order", "0=3")["volume"])
        self.assertIn("cPcbbbihq 0=3", self.run_program("canonize", "m.json").text)
        self.assert_refused("embed", "m.json", says="has singular edges", kind="unsupported")
        self.write("wrong.json", json.dumps({"gluings": gluings, "cone_orders": [3, 3]}))
        self.assert_refused("solve", "wrong.json", says="expected 1 cone orders")

    def test_a_parabolic_edge(self):
        answer = self.json_answer("solve", TRIPUS, "--cone-order", "0=0")
        self.assertEqual(answer["outcome"], "geometric")
        self.assertEqual(answer["edge_lengths"], [0])
        # Two regular ideal octahedra: all angles are 0.
        self.assertAlmostEqual(answer["volume"], 2 * 3.66386237670887606, delta=1e-12)

    def test_orders_that_the_certificate_needs(self):
        answer = self.run_program("solve", "dLQbcbcaekw", "--cone-angle", "0=2pi", "--json")
        self.write("answer", answer.out)
        self.assertEqual(answer.status, 1)
        self.assertIs(self.json_answer("check", "answer", "dLQbcbcaekw")["valid"], True)
