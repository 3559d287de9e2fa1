"""tripus info: every kind of INPUT, as text and as JSON."""

import json
import os

import samples
from support import TRIPUS, ProgramTest, read_json

KEYS = ["tripus", "input", "isosig", "tetrahedron_count", "edge_count", "orientable",
        "edge_valences", "oriented_isosig", "vertex_count", "component_count", "vertices", "H1",
        "edge_classes",
        "solvable", "message"]


class InfoJson(ProgramTest):
    def test_of_a_signature(self):
        answer = self.json_answer("info", TRIPUS)
        self.assertEqual(list(answer), KEYS)
        self.assertEqual(answer["input"], TRIPUS)
        self.assertEqual(answer["isosig"], TRIPUS)
        self.assertEqual(answer["tetrahedron_count"], 2)
        self.assertEqual(answer["edge_count"], 1)
        self.assertIs(answer["orientable"], True)
        self.assertEqual(answer["edge_valences"], [12])
        self.assertEqual(answer["vertex_count"], 1)
        self.assertEqual(answer["component_count"], 1)
        self.assertEqual(answer["vertices"],
                         [{"link_euler_characteristic": -2, "genus": 2, "link_orientable": True,
                           "kind": "geodesic", "triangle_count": 8}])
        self.assertEqual(answer["H1"], "2 Z")
        self.assertEqual(answer["edge_classes"], [[0] * 6] * 2)
        self.assertIs(answer["solvable"], True)
        self.assertIsInstance(answer["message"], str)

    def test_of_every_format(self):
        for name, content in samples.TRIPUS_FORMATS.items():
            with self.subTest(name):
                answer = self.json_answer("info", self.write(name, content))
                self.assertEqual([key for key in answer if key != "name"], KEYS)
                self.assertEqual(answer["input"], name)
                self.assertEqual(answer["isosig"], TRIPUS)

    def test_of_every_format_on_standard_input(self):
        for name, content in samples.TRIPUS_FORMATS.items():
            with self.subTest(name):
                answer = self.json_answer("info", "-", stdin=content)
                self.assertEqual(answer["input"], "-")
                self.assertEqual(answer["isosig"], TRIPUS)

    def test_repeats_the_name_that_a_file_gives(self):
        for name, text in {"a": samples.as_json(samples.TRIPUS_GLUINGS, "knotted-Y"),
                           "b": samples.as_snappea(samples.TRIPUS_GLUINGS, "knotted-Y")}.items():
            answer = self.json_answer("info", self.write(name, text))
            self.assertEqual(answer["name"], "knotted-Y")
            self.assertEqual(list(answer)[:3], ["tripus", "input", "name"])

    def test_of_cusps_and_finite_vertices(self):
        for signature, kind in [("cPcbbbiht", "cusp"), ("bkaagj", "finite"), ("bkaaid", "cusp")]:
            answer = self.json_answer("info", signature)
            self.assertIs(answer["solvable"], True)
            self.assertEqual(answer["vertices"][0]["kind"], kind)

    def test_of_a_disconnected_triangulation(self):
        answer = self.json_answer("info", TRIPUS + TRIPUS)
        self.assertEqual(answer["component_count"], 2)
        self.assertIs(answer["solvable"], False)
        self.assertIn("2 components", answer["message"])


class LongSignatures(ProgramTest):
    """63 tetrahedra and more: the signature begins with a hyphen, as options do."""

    def setUp(self):
        super().setUp()
        self.degree = 40
        self.write("cover.json", samples.as_json(samples.tripus_cover(self.degree), "cover"))
        self.signature = self.json_answer("info", "cover.json")["isosig"]

    def check(self, answer):
        self.assertEqual(answer["input"], self.signature)
        self.assertEqual(answer["isosig"], self.signature)
        self.assertEqual(answer["tetrahedron_count"], 2 * self.degree)
        self.assertEqual(answer["edge_valences"], [12] * self.degree)
        self.assertEqual([v["genus"] for v in answer["vertices"]], [self.degree + 1])

    def test_begin_with_a_hyphen(self):
        self.assertTrue(self.signature.startswith("-"))

    def test_are_an_argument(self):
        self.check(self.json_answer("info", self.signature))

    def test_are_an_argument_after_two_hyphens(self):
        result = self.run_program("info", "--json", "--", self.signature)
        self.assertEqual(result.status, 0, result.err)
        self.check(read_json(result.text))

    def test_are_a_file_and_a_line(self):
        self.write("signature", self.signature + "\n")
        answer = self.json_answer("info", "signature")
        self.assertEqual(answer["isosig"], self.signature)
        self.check(self.json_answer("info", "--batch", "signature"))

    def test_are_solved(self):
        answer = self.json_answer("solve", self.signature)
        self.assertEqual(answer["outcome"], "geometric")
        self.assertAlmostEqual(answer["volume"], self.degree * 6.45199027083503287, delta=1e-10)

    def test_longer_than_any_file_name(self):
        self.degree = 1000
        self.write("cover.json", samples.as_json(samples.tripus_cover(self.degree)))
        self.signature = self.json_answer("info", "cover.json")["isosig"]
        self.assertGreater(len(self.signature), os.pathconf(self.folder, "PC_PATH_MAX"))
        self.check(self.json_answer("info", self.signature))


class InfoText(ProgramTest):
    def test_says_what_it_is(self):
        result = self.run_program("info", TRIPUS)
        self.assertEqual((result.status, result.err), (0, ""))
        self.assertEqual(result.lines, [
            "cPcbbbihq",
            "  signature     cPcbbbihq",
            "  tetrahedra    2",
            "  edge classes  1, of valence 12",
            "  vertex links  genus 2 (geodesic)",
            "  orientable    yes",
            "  H1            2 Z"])

    def test_says_why_it_cannot_be_solved(self):
        result = self.run_program("info", TRIPUS + TRIPUS)
        self.assertEqual(result.status, 0)
        self.assertIn("not solvable", result.text)
        self.assertIn("2 components", result.text)

    def test_of_a_klein_bottle_for_a_cusp(self):
        result = self.run_program("info", "bkaaid")
        self.assertIn("  orientable    no", result.lines)
        self.assertIn("  vertex links  Euler characteristic 0, non-orientable (cusp)", result.lines)

    def test_says_how_many_components(self):
        self.assertIn("  components    2", self.run_program("info", TRIPUS + TRIPUS).lines)


class Names(ProgramTest):
    """Names come from files; nothing in them reaches a terminal or breaks the JSON."""

    def test_with_control_characters(self):
        self.write("m.json", json.dumps({"name": "a\x1b[2J\u0000b\n\u00e9",
                                         "gluings": samples.TRIPUS_GLUINGS}))
        self.assertEqual(self.json_answer("info", "m.json")["name"], "a\x1b[2J\u0000b\n\u00e9")
        text = self.run_program("info", "m.json").out
        self.assertNotIn(b"\x1b", text)
        self.assertNotIn(b"\x00", text)
        self.assertIn("m.json (a\\x1b[2J\\x00b\\x0a\u00e9)".encode(), text)

    def test_that_are_not_utf8(self):
        text = samples.as_snappea(samples.TRIPUS_GLUINGS, "NAME").encode()
        self.write("m.tri", text.replace(b"NAME", b"a\xff\xc3"))
        self.assertEqual(self.json_answer("info", "m.tri")["name"], "a\ufffd\ufffd")
        self.assertEqual(self.run_program("info", "m.tri").status, 0)

    def test_of_files_that_are_not_utf8(self):
        path = os.fsencode(self.folder) + b"/\xff\xfe.json"
        with open(path, "w", encoding="utf-8") as file:
            file.write(samples.as_json(samples.TRIPUS_GLUINGS))
        result = self.run_program("info", b"\xff\xfe.json", "--json")
        self.assertEqual(result.status, 0)
        self.assertEqual(read_json(result.text)["input"], "\ufffd\ufffd.json")

    def test_of_files_that_look_like_signatures(self):
        self.write("cPcbbbiht", TRIPUS)
        self.assertEqual(self.json_answer("info", "cPcbbbiht")["isosig"], TRIPUS)
