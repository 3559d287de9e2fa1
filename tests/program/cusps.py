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
        self.assert_refused("embed", "cPcbbbiht", "--circles", "x.svg",
                            says="circles at infinity are drawn for geodesic boundary only",
                            kind="unsupported")
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
        self.assertIn("It is t2T.2.", self.run_program("identify", "4_1").text)
        self.assertIn("It is t3g2+T.1.", self.run_program("identify", "dLQacccjjkg").text)
        self.assertEqual(self.json_answer("solve", "t1K.1")["isosig"], "bkaaid")
        self.assertIn("ends with four tetrahedra",
                      self.run_program("identify", "fLLQcbdeedemnamjp").text)
        table = self.run_program("census", "--boundary", "T+T", "--tsv", "-", "--quiet").text
        self.assertEqual(table.count("\nt4T+T."), 4)

    def test_places_in_space(self):
        eight = self.json_answer("embed", "cPcbbbiht")
        self.assertEqual(eight["tetrahedra"][0]["kinds"], ["ideal"] * 4)
        self.assertAlmostEqual(eight["horosphere_area"], math.sqrt(3) / 2, delta=1e-12)
        for v in eight["tetrahedra"][0]["vertices"]:
            self.assertAlmostEqual(v[0]**2 + v[1]**2 + v[2]**2 - v[3]**2, 0, delta=1e-12)
        self.assertFalse(any(g["reverses_orientation"] for g in eight["holonomy"]["generators"]))
        self.assertLess(eight["holonomy"]["relator_defect"], 1e-12)
        small = self.json_answer("embed", "cPcbbbiht", "--horosphere-area", "0.5")
        self.assertEqual(small["horosphere_area"], 0.5)
        self.assert_refused("embed", "cPcbbbiht", "--horosphere-area", "4",
                            says="the largest possible area here is 3.46")
        for wrong in ("-1", "0", "nan", "1e400", "x"):
            self.assert_refused("embed", "cPcbbbiht", "--horosphere-area", wrong,
                                says="--horosphere-area", kind="usage")
        self.assert_refused("embed", "cPcbbbiht", "--horosphere-area", "1e-320", says="from 1e-100 on")
        tiny = self.run_program("embed", "cPcbbbiht", "--horosphere-area", "1e-100", "--json")
        self.assertEqual(tiny.status, 0)
        self.assertNotRegex(tiny.text, "(?i)nan|inf")
        self.assert_refused("embed", TRIPUS, "--horosphere-area", "1", says="has no cusp")
        gieseking = self.json_answer("embed", "bkaaid")
        self.assertTrue(any(g["reverses_orientation"]
                            for g in gieseking["holonomy"]["generators"]))
        mixed = self.json_answer("embed", "dLQacccjjkg", "--cells", "20")
        self.assertEqual({kind for t in mixed["tetrahedra"] for kind in t["kinds"]},
                         {"ideal", "hyperideal"})
        self.assertEqual(len(mixed["cells"]), 20)
        self.run_program("embed", "bkaaid", "--cells", "5", "-o", "cells.ply")
        shown = self.run_program("view", "cPcbbbiht", "-o", "x.html")
        self.assertEqual(shown.status, 0, shown.err)
        self.assertIn("<html", (self.folder / "x.html").read_text()[:200])

    def test_singular_edges_in_space(self):
        orbifold = self.json_answer("embed", TRIPUS + " 0=3", "--radius", "1")
        self.assertEqual(orbifold["cone_orders"], [3])
        self.assertIsNone(orbifold["horosphere_area"])
        self.assertGreater(len(orbifold["cells"]), 2)
        relators = orbifold["holonomy"]["relators"]
        self.assertEqual(relators[0], 3 * relators[0][:len(relators[0]) // 3])
        self.write("list.json", json.dumps({
            "gluings": [[[1, "1230"], [1, "3012"], [1, "0321"], [1, "0213"]],
                        [[0, "1230"], [0, "3012"], [0, "0321"], [0, "0213"]]],
            "cone_orders": ["5/2"]}))
        self.assertEqual(len(self.json_answer("embed", "list.json")["cells"]), 2)
        self.assert_refused("embed", "list.json", "--cells", "5",
                            says="is not 2 pi / n for a whole number n", kind="unsupported")
        parabolic = self.json_answer("embed", TRIPUS + " 0=0", "--cells", "3", "-o", "x.ply",
                                     "--json")
        self.assertEqual(len(parabolic["cells"]), 3)

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
        for verb in (("orthospectrum",), ("cover", "--cyclic", "2"), ("simplify",)):
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
        shown = self.run_program("view", "m.json", "-o", "x.html")
        self.assertEqual(shown.status, 0, shown.err)
        self.assertIn("<html", (self.folder / "x.html").read_text()[:200])
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
