"""tripus solve: its JSON, its text and its options."""

import csv
import json
import math

import samples
from support import DATA, TRIPUS, TRIPUS_LENGTH, TRIPUS_VOLUME, ProgramTest, read_json

KEYS = ["tripus", "input", "isosig", "tetrahedron_count", "edge_count", "orientable",
        "edge_valences", "vertices", "outcome", "method", "iterations", "evaluations", "seconds",
        "max_curvature", "volume", "edge_lengths", "dihedral_angles", "edge_classes",
        "flat_tetrahedra", "certificate", "message"]
OUTCOMES = ["geometric", "degenerate", "infeasible", "unresolved"]
OPTIONAL_KEYS = {"name", "valence_theorem", "angle_structure", "retriangulation", "advice", "manifold"}
NUMBER = (int, float)


def three_tetrahedra():
    """All triangulations of data/triangulations-3.txt."""
    lines = (DATA / "triangulations-3.txt").read_text().splitlines()
    return [line for line in lines if line and not line.startswith("#")]


class SolveJson(ProgramTest):
    def check(self, answer, status):
        """The keys in their order, the types and shapes, and the exit status."""
        count, edges = answer["tetrahedron_count"], answer["edge_count"]
        self.assertEqual([key for key in answer if key not in OPTIONAL_KEYS], KEYS)
        for key in ("tripus", "input", "isosig", "method", "message"):
            self.assertIsInstance(answer[key], str, key)
        for key in ("tetrahedron_count", "edge_count", "iterations", "evaluations"):
            self.assertIs(type(answer[key]), int, key)
        for key in ("seconds", "max_curvature", "volume"):
            self.assertIsInstance(answer[key], NUMBER, key)
        self.assertIs(type(answer["orientable"]), bool)
        self.assertIn(answer["outcome"], OUTCOMES)
        self.assertEqual(status, 0 if answer["outcome"] == "geometric" else 1)
        self.assertEqual(len(answer["edge_valences"]), edges)
        self.assertEqual(sum(answer["edge_valences"]), 6 * count)
        self.assertEqual(len(answer["edge_lengths"]), edges)
        self.assertTrue(all(isinstance(x, NUMBER) for x in answer["edge_lengths"]))
        for key, kind in (("dihedral_angles", NUMBER), ("edge_classes", int)):
            self.assertEqual([len(row) for row in answer[key]], [6] * count, key)
            self.assertTrue(all(isinstance(x, kind) for row in answer[key] for x in row), key)
        for vertex in answer["vertices"]:
            self.assertEqual(list(vertex), ["link_euler_characteristic", "genus", "kind", "area"])
            self.assertEqual(vertex["kind"], "geodesic")
            self.assertEqual(vertex["link_euler_characteristic"], 2 - 2 * vertex["genus"])
        self.assertTrue(set(answer["flat_tetrahedra"]) <= set(range(count)))
        if answer["outcome"] == "geometric":
            self.assertNotIn("advice", answer)
            self.assertEqual(answer["flat_tetrahedra"], [])
        if answer["outcome"] == "degenerate":
            self.assertNotEqual(answer["flat_tetrahedra"], [])
        if answer["certificate"] is None:
            self.assertNotEqual(answer["outcome"], "infeasible")
        else:
            self.assertIn(answer["outcome"], ["infeasible", "degenerate"])
            self.check_certificate(answer)

    def check_certificate(self, answer):
        """docs/theory.md (43), in integers."""
        certificate = answer["certificate"]
        self.assertEqual(list(certificate), ["kind", "edge", "vertex"])
        edge, vertex = certificate["edge"], certificate["vertex"]
        self.assertEqual(len(edge), answer["edge_count"])
        self.assertEqual([len(row) for row in vertex], [4] * answer["tetrahedron_count"])
        self.assertTrue(all(type(w) is int and w >= 0 for row in vertex for w in row))
        ends = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)]
        slack = [row[i] + row[j] - edge[e] for row, classes in zip(vertex, answer["edge_classes"])
                 for (i, j), e in zip(ends, classes)]
        self.assertGreaterEqual(min(slack), 0)
        total = sum(map(sum, vertex)) - 2 * sum(edge)
        if certificate["kind"] == "none":
            self.assertLess(total, 0)
        else:
            self.assertEqual((certificate["kind"], total), ("semi", 0))
            self.assertTrue(any(slack) or any(map(any, vertex)))

    def test_of_the_tripus(self):
        answer = self.json_answer("solve", TRIPUS)
        self.check(answer, 0)
        self.assertAlmostEqual(answer["volume"], TRIPUS_VOLUME, delta=1e-13)
        self.assertAlmostEqual(answer["edge_lengths"][0], TRIPUS_LENGTH, delta=1e-13)
        self.assertLessEqual(answer["max_curvature"], 1e-12)
        self.assertAlmostEqual(answer["vertices"][0]["area"], 4 * math.pi, delta=1e-11)
        for row in answer["dihedral_angles"]:
            for angle in row:
                self.assertAlmostEqual(angle, math.pi / 6, delta=1e-13)

    def test_of_every_format(self):
        for name, content in samples.TRIPUS_FORMATS.items():
            with self.subTest(name):
                answer = self.json_answer("solve", self.write(name, content))
                self.check(answer, 0)
                self.assertAlmostEqual(answer["volume"], TRIPUS_VOLUME, delta=1e-13)
                text = self.run_program("solve", "-", stdin=content)
                self.assertEqual(text.status, 0)
                self.assertTrue(text.text.startswith("-: geometric\n"), text.text)

    def test_of_all_triangulations_with_three_tetrahedra(self):
        lines = three_tetrahedra()
        result = self.run_program("solve", "--batch", str(DATA / "triangulations-3.txt"), "--json")
        self.assertEqual((result.status, result.err), (0, ""))
        answers = [read_json(line) for line in result.lines]
        self.assertEqual([answer["input"] for answer in answers], lines)
        for answer in answers:
            with self.subTest(answer["input"]):
                self.check(answer, 0 if answer["outcome"] == "geometric" else 1)

    def test_a_no_has_exit_status_1(self):
        refused = [line.split("\t")[0]
                   for line in (DATA / "nongeometric-3.tsv").read_text().splitlines()
                   if line and not line.startswith("#")][1:4]
        for signature in refused:
            with self.subTest(signature):
                result = self.run_program("solve", signature, "--json")
                self.assertEqual(result.status, 1)
                self.assertEqual(result.err, "")
                answer = read_json(result.text)
                self.check(answer, 1)
                self.assertNotEqual(answer["outcome"], "geometric")

    def test_angles_add_up_around_every_edge(self):
        """The printed digits are those of the numbers: sums of them hold to rounding."""
        answer = self.json_answer("solve", three_tetrahedra()[0])
        sums = [0.0] * answer["edge_count"]
        for angles, classes in zip(answer["dihedral_angles"], answer["edge_classes"]):
            for angle, edge in zip(angles, classes):
                sums[edge] += angle
        worst = max(abs(total - 2 * math.pi) for total in sums)
        self.assertLessEqual(worst, answer["max_curvature"] + 1e-14)

    def test_numbers_round_trip(self):
        """Solving from the printed lengths finds nothing left to do."""
        first = self.json_answer("solve", three_tetrahedra()[0])
        self.write("first.json", json.dumps(first))
        again = self.json_answer("solve", three_tetrahedra()[0], "--initial-lengths", "first.json",
                                 "--tolerance", "1e-12")
        self.assertEqual(again["edge_lengths"], first["edge_lengths"])
        self.assertEqual(again["iterations"], 0)
        self.assertEqual(again["volume"], first["volume"])
        for x in first["edge_lengths"]:
            self.assertEqual(float(repr(x)), x)


class SolveText(ProgramTest):
    def test_says_the_verdict_first(self):
        result = self.run_program("solve", TRIPUS)
        self.assertEqual((result.status, result.err), (0, ""))
        self.assertEqual(result.lines[0], "cPcbbbihq: geometric")
        for words in ("volume", "6.4519902708350", "genus 2", "0.5961338948908", "0.1666666667"):
            self.assertIn(words, result.text)

    def test_shortens_long_tables(self):
        self.write("cover.json", samples.as_json(samples.tripus_cover(50)))
        result = self.run_program("solve", "cover.json")
        self.assertEqual(result.status, 0)
        self.assertLess(len(result.lines), 60)
        self.assertIn("(50 in all; --json prints every one)", result.text)

    def test_quiet_changes_nothing_off_a_terminal(self):
        plain, quiet = (self.run_program("info", TRIPUS, *more) for more in ([], ["--quiet"]))
        self.assertEqual(plain.out, quiet.out)


class Starts(ProgramTest):
    """Every start leads to the same metric."""

    def check(self, *options):
        answer = self.json_answer("solve", TRIPUS, *options)
        self.assertAlmostEqual(answer["edge_lengths"][0], TRIPUS_LENGTH, delta=1e-12)

    def test_one_length(self):
        for length in ("1", "0.01", "+3", "2e1", "1e-3"):
            with self.subTest(length):
                self.check("--initial", length)

    def test_a_file_of_numbers(self):
        for text in ("1.5\n", "# lengths\n 1.5 # of the one edge\n", "+1.5,", "15e-1;"):
            with self.subTest(text):
                self.check("--initial-lengths", self.write("lengths", text))

    def test_a_json_array(self):
        self.check("--initial-lengths", self.write("lengths", "[1.5]"))

    def test_an_answer(self):
        self.write("answer", self.run_program("solve", TRIPUS, "--json").out)
        self.check("--initial-lengths", "answer")

    def test_standard_input(self):
        result = self.run_program("solve", TRIPUS, "--initial-lengths", "-", stdin="2")
        self.assertEqual(result.status, 0, result.err)

    def test_several_edges_in_several_lines(self):
        self.write("cover.json", samples.as_json(samples.tripus_cover(5)))
        self.write("lengths", "1 2 # two\n\n3,4\n5\n")
        answer = self.json_answer("solve", "cover.json", "--initial-lengths", "lengths")
        for length in answer["edge_lengths"]:
            self.assertAlmostEqual(length, TRIPUS_LENGTH, delta=1e-12)


class Limits(ProgramTest):
    def test_one_iteration_is_unresolved(self):
        for options, err in ((["--max-iterations", "1"], ""),
                             (["--time-limit", "1e-9"],
                              "tripus: the time limit of 1e-09 s was reached\n")):
            with self.subTest(options):
                answer = self.json_answer("solve", TRIPUS, "--initial", "5", *options, status=1,
                                          err=err)
                self.assertEqual(answer["outcome"], "unresolved")
                self.assertIn("limit", answer["message"])
                self.assertLessEqual(answer["iterations"], 1)
                text = self.run_program("solve", TRIPUS, "--initial", "5", *options)
                self.assertEqual(text.status, 1)
                self.assertTrue(text.text.startswith("cPcbbbihq: unresolved\n"))

    def test_a_loose_tolerance_is_met_sooner(self):
        loose = self.json_answer("solve", TRIPUS, "--initial", "5", "--tolerance", "1e-3")
        tight = self.json_answer("solve", TRIPUS, "--initial", "5", "--tolerance", "1e-13")
        self.assertLess(loose["iterations"], tight["iterations"])
        self.assertLessEqual(tight["max_curvature"], 1e-13)

    def test_a_tolerance_below_rounding_is_unresolved(self):
        for method in ("newton", "newton-cg", "flow:newton-flow/rk4"):
            answer = self.json_answer("solve", three_tetrahedra()[0], "--tolerance", "1e-300",
                                      "--method", method, status=1)
            self.assertEqual(answer["outcome"], "unresolved")


class ConeAngles(ProgramTest):
    def test_in_radians_and_in_pi(self):
        lengths = [self.json_answer("solve", TRIPUS, "--cone-angle", angle)["edge_lengths"][0]
                   for angle in ("0=2pi/3", f"0={2 * math.pi / 3!r}", "0=0.6666666666666666pi")]
        for length in lengths:
            self.assertAlmostEqual(length, lengths[0], delta=1e-12)
        # All dihedral angles are 2 pi / 36: docs/theory.md (26).
        c = math.cos(math.pi / 18)
        self.assertAlmostEqual(lengths[0], math.acosh(c / (2 * c - 1)), delta=1e-12)

    def test_are_said_to_be_there(self):
        answer = self.json_answer("solve", TRIPUS, "--cone-angle", "0=pi")
        self.assertIn("cone metric", answer["message"])

    def test_of_a_full_turn_changes_nothing(self):
        answer = self.json_answer("solve", TRIPUS, "--cone-angle", "0=2pi")
        self.assertNotIn("cone", answer["message"])
        self.assertAlmostEqual(answer["volume"], TRIPUS_VOLUME, delta=1e-12)

    def test_repeated(self):
        self.write("cover.json", samples.as_json(samples.tripus_cover(3)))
        answer = self.json_answer("solve", "cover.json", "--cone-angle", "0=pi", "--cone-angle",
                                  "1=pi", "--cone-angle", "2=pi")
        c = math.cos(math.pi / 12)
        for length in answer["edge_lengths"]:
            self.assertAlmostEqual(length, math.acosh(c / (2 * c - 1)), delta=1e-11)


class Histories(ProgramTest):
    COLUMNS = ["iteration", "evaluations", "seconds", "max_curvature", "energy", "volume",
               "shortest_edge", "longest_edge"]

    def test_have_a_row_for_each_iteration(self):
        for method in ("newton", "newton-cg", "flow:newton-flow/rk4", "ceres-lbfgs"):
            with self.subTest(method):
                answer = self.json_answer("solve", TRIPUS, "--initial", "2", "--method", method,
                                          "--history", "run.csv")
                with open(self.folder / "run.csv", encoding="ascii", newline="") as file:
                    table = csv.DictReader(file)
                    rows = list(table)
                self.assertEqual(table.fieldnames, self.COLUMNS)
                self.assertEqual([int(row["iteration"]) for row in rows],
                                 list(range(answer["iterations"] + 1)))
                self.assertEqual(float(rows[0]["shortest_edge"]), 2)
                self.assertEqual(float(rows[0]["longest_edge"]), 2)
                self.assertAlmostEqual(float(rows[-1]["volume"]), TRIPUS_VOLUME, delta=1e-9)
                self.assertLessEqual(float(rows[-1]["max_curvature"]), 1e-12)
                evaluations = [int(row["evaluations"]) for row in rows]
                self.assertEqual(evaluations, sorted(evaluations))

    def test_that_cannot_be_written_are_refused(self):
        for place in ("no-such-folder/run.csv", "."):
            self.assert_refused("solve", TRIPUS, "--history", place,
                                says="cannot write \"")

    def test_on_a_full_disk_are_our_failure(self):
        result = self.run_program("solve", TRIPUS, "--history", "/dev/full")
        self.assertEqual(result.status, 3)
        self.assertIn("cannot write \"/dev/full\": No space left", result.err)


class Retriangulations(ProgramTest):
    def test_of_a_boundary_case_find_the_metric(self):
        lines = (DATA / "boundary-case-4.tsv").read_text().splitlines()
        for line in [x for x in lines if x and not x.startswith("#")][1:]:
            signature = line.split("\t")[0]
            with self.subTest(signature):
                plain = self.json_answer("solve", signature, status=1)
                self.assertEqual(plain["outcome"], "degenerate")
                answer = self.json_answer("solve", signature, "--retriangulate")
                self.assertEqual([key for key in answer if key not in KEYS], ["retriangulation"])
                self.assertEqual(answer["outcome"], "geometric")
                search = answer["retriangulation"]
                self.assertEqual(list(search), ["from", "tried", "ended", "path", "volumes"])
                self.assertEqual(search["from"], signature)
                self.assertGreater(len(search["path"]), 0)
                again = self.json_answer("solve", answer["isosig"])
                self.assertAlmostEqual(again["volume"], answer["volume"], delta=1e-11)

    def test_that_give_up_say_so(self):
        result = self.run_program("solve", "dLQbcbcaekw", "--retriangulate", "--budget", "1",
                                  "--json")
        self.assertEqual(result.status, 1)
        self.assertNotEqual(read_json(result.text)["outcome"], "geometric")

    def test_options_are_checked(self):
        for options in (["--budget", "-1"], ["--seed", "x"]):
            self.assert_refused("solve", TRIPUS, "--retriangulate", *options, says=options[0])
        self.assert_refused("solve", TRIPUS, "--seed", "1", says="--retriangulate")


class Components(ProgramTest):
    def setUp(self):
        super().setUp()
        two = samples.disjoint_union(samples.TRIPUS_GLUINGS, samples.tripus_cover(3))
        self.write("two.json", samples.as_json(two))

    def test_are_not_solved_unasked(self):
        for given in ("two.json", TRIPUS + TRIPUS):
            self.assert_refused("solve", given, says="--components")

    def test_are_solved_one_by_one(self):
        answer = self.json_answer("solve", "two.json", "--components")
        self.assertEqual(list(answer), ["tripus", "input", "components"])
        parts = answer["components"]
        self.assertEqual([[key for key in part if key not in OPTIONAL_KEYS] for part in parts],
                         [KEYS, KEYS])
        self.assertEqual([part["input"] for part in parts],
                         ["two.json (component 0)", "two.json (component 1)"])
        self.assertAlmostEqual(parts[0]["volume"], TRIPUS_VOLUME, delta=1e-12)
        self.assertAlmostEqual(parts[1]["volume"], 3 * TRIPUS_VOLUME, delta=1e-11)

    def test_as_text(self):
        result = self.run_program("solve", "two.json", "--components")
        self.assertEqual(result.status, 0)
        self.assertIn("two.json (component 1): geometric", result.lines)

    def test_of_a_connected_triangulation(self):
        answer = self.json_answer("solve", TRIPUS, "--components")
        self.assertEqual(len(answer["components"]), 1)

    def test_the_worst_one_decides_the_exit_status(self):
        result = self.run_program("solve", "two.json", "--components", "--initial", "5",
                                  "--max-iterations", "1")
        self.assertEqual(result.status, 1)

    def test_one_that_cannot_be_solved_is_named(self):
        self.assert_refused("solve", TRIPUS + "cPcbbbiht", "--components", "--cone-order", "1=2",
                            says="only the edge classes 0 to 0")

    def test_each_by_its_kind(self):
        answer = self.json_answer("solve", TRIPUS + "cPcbbbiht", "--components")
        kinds = [one["vertices"][0]["kind"] for one in answer["components"]]
        self.assertEqual(kinds, ["geodesic", "cusp"])


class Methods(ProgramTest):
    def test_as_json(self):
        answer = self.json_answer("methods")
        self.assertEqual(list(answer), ["tripus", "input", "energies", "methods", "flows",
                                        "steppers"])
        for table in ("energies", "methods", "flows", "steppers"):
            self.assertGreater(len(answer[table]), 1)
            for row in answer[table]:
                self.assertEqual(list(row), ["name", "description"])
                self.assertTrue(row["name"] and row["description"])

    def test_as_text(self):
        text = self.run_program("methods").text
        answer = self.json_answer("methods")
        for table in ("energies", "methods", "flows", "steppers"):
            for row in answer[table]:
                self.assertRegex(text, rf"(?m)^  {row['name']} +\S")

    def test_every_name_solves(self):
        table = self.json_answer("methods")
        names = [row["name"] for row in table["methods"]]
        names += ["angles:" + name for name in names]
        names += [f"flow:{flow['name']}/{stepper['name']}"
                  for flow in table["flows"] for stepper in table["steppers"]]
        for name in names:
            with self.subTest(name):
                answer = self.json_answer("solve", TRIPUS, "--method", name)
                self.assertEqual(answer["method"], name)
                self.assertAlmostEqual(answer["volume"], TRIPUS_VOLUME, delta=1e-11)
