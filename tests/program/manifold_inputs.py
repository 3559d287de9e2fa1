"""What is about the manifold, and not about the triangulation that is given: names, boundaries,
finite vertices, triangulations that are large for no reason."""

import json

from support import TRIPUS, TRIPUS_VOLUME, ProgramTest, read_json

# Of the tripus: 25 random moves away from cPcbbbihq; with a boundary of triangles.
AFTER_25_MOVES = "BLLLLzLQvzLzALAPQQQccfhfkhlllnoqrrwttAvwwAyzyzAajaffmnmmwflvojagbtldsknsjwb"
REAL_BOUNDARY = "rffLLfzAwQOjkcfhikmlopnpopqqqlavaldhpujrkadi"
FIGURE_EIGHT = "cPcbbbiht"


class Simplified(ProgramTest):
    def test_first(self):
        answer = self.json_answer("canonize", AFTER_25_MOVES)
        self.assertEqual((answer["signature"], answer["outcome"]), (TRIPUS, "geometric"))
        self.assertEqual(answer["simplified"][:-1], TRIPUS)
        self.assertIn("t2g2.", self.run_program("identify", AFTER_25_MOVES).text)
        result = self.run_program("compare", AFTER_25_MOVES, TRIPUS)
        self.assertEqual(result.status, 0)
        self.assertTrue(result.text.startswith("Homeomorphic"))
        for verb, *rest in (("solve",), ("embed",)):
            answer = self.json_answer(verb, AFTER_25_MOVES, "--retriangulate", *rest)
            self.assertAlmostEqual(answer["volume"], TRIPUS_VOLUME, delta=1e-11)
            self.assertEqual(answer["retriangulation"]["simplified"][:-1] if verb == "solve"
                             else TRIPUS, TRIPUS)
        self.assertEqual(self.run_program("view", AFTER_25_MOVES, "--retriangulate", "-o",
                                          "x.html").status, 0)

    def test_keeps_the_orientation(self):
        for sign in "+-":
            signed = AFTER_25_MOVES + sign
            small = self.json_answer("simplify", signed)["oriented_isosig"]
            for other in (small, self.json_answer("canonize", signed)["oriented_signature"]):
                answer = self.json_answer("compare", signed, other)
                self.assertEqual((answer["keeps_orientation"], answer["reverses_orientation"]),
                                 (True, False))
            self.run_program("solve", signed, "--retriangulate", "-o", "x.sig")
            self.assertEqual((self.folder / "x.sig").read_text().strip(), small)

    def test_one_manifold_by_moves(self):
        """Without a metric: by a triangulation that moves reach from both."""
        answer = self.json_answer("compare", "dLQacccjcoo", "dLQacccjcoc")
        self.assertEqual((answer["verdict"], answer["decided_by"]), ("homeomorphic", "triangulation"))


class Boundaries(ProgramTest):
    def test_are_coned_off_with_a_note(self):
        result = self.run_program("solve", REAL_BOUNDARY, "--retriangulate")
        self.assertIn("tripus: note: ", result.err)
        self.assertIn("coned off", result.err)
        for verb in ("info", "canonize", "identify"):
            result = self.run_program(verb, REAL_BOUNDARY)
            self.assertNotEqual(result.status, 2, result.err)
            self.assertIn("coned off", result.err)
        answer = read_json(self.run_program("info", REAL_BOUNDARY, "--json").text)
        self.assertIn("coned off", answer["notes"][0])
        self.write("list", f"{TRIPUS}\n{REAL_BOUNDARY}\n")
        batch = self.run_program("info", "--batch", "list")
        self.assertRegex(batch.err, r"^tripus: note: .*coned off")

    def test_finite_vertices_are_removed_with_a_note(self):
        """The tripus, with a tetrahedron parted into four at a new vertex, and its faces folded."""
        table = {"gluings": [[[1, "1230"], [1, "3012"], [1, "0321"], [1, "0213"]],
                             [[0, "1230"], [0, "3012"], [0, "0321"], [0, "0213"]]]}
        parted = self.parted(table["gluings"])
        self.write("parted.json", json.dumps({"gluings": parted}))
        info = self.json_answer("info", "parted.json")
        self.assertIn("finite", [vertex["kind"] for vertex in info["vertices"]])
        answer = read_json(self.run_program("solve", "parted.json", "--json").text)
        self.assertAlmostEqual(answer["volume"], TRIPUS_VOLUME, delta=1e-12)
        self.assertIn("finite vertex", answer["notes"][0])
        canonized = read_json(self.run_program("canonize", "parted.json", "--json").text)
        self.assertEqual(canonized["signature"], TRIPUS)
        self.assertIn("finite vertex", self.run_program("solve", "parted.json").err)

    @staticmethod
    def parted(gluings):
        """A 1-4 move at tetrahedron 0: piece i keeps the face opposite vertex i, and vertex i is the
        new one."""
        place = {0: 0, 1: 4, 2: 5, 3: 6}  # of pieces; the other tetrahedra keep their numbers
        count = len(gluings) + 3
        place = {0: 0, **{i: len(gluings) + i - 1 for i in (1, 2, 3)}}
        result = [[None] * 4 for _ in range(count)]
        for t, row in enumerate(gluings):
            for face, (other, word) in enumerate(row):
                source = place[face] if t == 0 else t
                target = place[int(word[face])] if other == 0 else other
                result[source][face] = [target, word]
        for i in range(4):
            for j in range(4):
                if i == j:
                    continue
                word = ["0", "1", "2", "3"]
                word[i], word[j] = word[j], word[i]
                result[place[i]][j] = [place[j], "".join(word)]
        return result

    def test_kinds_of_boundary_are_an_answer(self):
        result = self.run_program("compare", TRIPUS, FIGURE_EIGHT, "--json")
        answer = read_json(result.text)
        self.assertEqual((result.status, answer["verdict"], answer["decided_by"]),
                         (1, "different", "boundary"))
        self.assertIn("cusp", answer["message"])


class Names(ProgramTest):
    def test_of_the_census_are_inputs(self):
        answer = self.json_answer("info", "t3g2.13")
        self.assertEqual((answer["name"], answer["tetrahedron_count"]), ("t3g2.13", 3))
        for verb in ("solve", "canonize", "identify", "simplify"):
            self.assertEqual(self.run_program(verb, "t3g2.13").status, 0, verb)
        self.assertIn("t3g2.13", self.run_program("identify", "t3g2.13").text)
        self.write("list", "t2g2.1\n# two\nt2g2.2  # of them\n")
        self.assertEqual(len(self.run_program("solve", "--batch", "list", "--json").lines), 2)
        self.assert_refused("info", "t3g2.1300", says="no t3g2.1300 in the shipped census")

    def test_of_other_tables_are_refused_by_name(self):
        for name in ("m004", "L10a1", "10_165", "o9_00001", "K11n34", "m003(-3,1)", "v1234"):
            for verb in ("info", "solve", "identify"):
                self.assert_refused(verb, name, says="is a SnapPy name")
        self.assert_refused("info", self.write("list", "m004\n"), says="is a SnapPy name")

    def test_in_the_census(self):
        text = self.run_program("census", "t3g2.13")
        self.assertEqual((text.status, len(text.lines)), (0, 1))
        self.assertTrue(text.text.startswith("t3g2.13 "))
        both = self.run_program("census", "t3g2.13", TRIPUS, TRIPUS + "-", "--json")
        self.assertEqual([read_json(line)["name"] for line in both.lines][0], "t3g2.13")
        self.assertEqual(len(both.lines), 3)
        self.assertEqual(self.run_program("census", "t3g2.999").status, 2)

    def test_drawings_and_unknown_files(self):
        self.write("graph.json", '{"vertices": [[0, 0, 0]], "edges": []}')
        self.write("binary", b"\x89PNG\r\n\x1a\n\x00\x00")
        self.write("prose", "hello world, this is no triangulation\n")
        for verb in ("info", "solve", "mesh", "canonize"):
            self.assert_refused(verb, "graph.json", says="tripus tube")
            for name in ("binary", "prose"):
                self.assert_refused(verb, name, says="no format that is known; looked for")
            message = self.run_program(verb, "binary").err
            self.assertNotIn("PNG", message)
            for words in ("isomorphism signature", "JSON", "OFF", "Medit"):
                self.assertIn(words, message)
