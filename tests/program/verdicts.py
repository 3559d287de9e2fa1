"""Verdicts with their evidence: certificates and `tripus check`, exact angles, retriangulation."""

import json
from fractions import Fraction

from support import DATA, TRIPUS, TRIPUS_VOLUME, ProgramTest

# An edge of valence 1; a semi case; a boundary case, whose neighbour by a 3-2 carries the metric.
NONE = "dLQbcbcmebs"
SEMI = "dLQbcbcaekw"
# As NONE, and without a quick proof that the manifold is not hyperbolic.
OPEN = "eLAkbcbddmpbds"
# Not orientable, so that no quick proof applies, without angle structure.
ENDLESS = "dLQbcbcmkdv"
BOUNDARY_CASE = "eLAkbccdddprdk"
ENDS = ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))


def table(name):
    lines = [line.split("\t") for line in (DATA / name).read_text().splitlines()
             if line and not line.startswith("#")]
    return [dict(zip(lines[0], line)) for line in lines[1:]]


def proves(answer):
    """docs/theory.md (43) once more, in Python's integers: the kind that is proved, or None."""
    certificate = answer["certificate"]
    u, w = certificate["edge"], certificate["vertex"]
    positive = any(x > 0 for four in w for x in four)
    if any(x < 0 for four in w for x in four):
        return None
    for classes, four in zip(answer["edge_classes"], w):
        for (i, j), edge in zip(ENDS, classes):
            a = four[i] + four[j] - u[edge]
            if a < 0:
                return None
            positive = positive or a > 0
    r = sum(map(sum, w)) - 2 * sum(u)
    if r < 0:
        return "none"
    return "semi" if r == 0 and positive else None


class Certificates(ProgramTest):
    def certificate(self, signature):
        """Writes the answer and the certificate alone; returns the answer."""
        answer = self.json_answer("solve", signature, status=1)
        self.write("answer.json", json.dumps(answer))
        self.write("certificate.json", json.dumps(answer["certificate"]))
        return answer

    def test_of_every_small_triangulation_without_metric(self):
        for row in table("nongeometric-3.tsv"):
            with self.subTest(row["isosig"]):
                answer = self.json_answer("solve", row["isosig"], status=1)
                expected = "none" if float(row["angle_margin"]) < -1e-5 else "semi"
                self.assertEqual(proves(answer), expected)
                self.assertEqual(answer["certificate"]["kind"], expected)

    def test_are_confirmed(self):
        for signature, kind in ((NONE, "none"), (SEMI, "semi")):
            self.certificate(signature)
            for name in ("answer.json", "certificate.json"):
                with self.subTest((signature, name)):
                    text = self.run_program("check", name, signature)
                    self.assertEqual((text.status, text.err), (0, ""))
                    self.assertTrue(text.text.startswith(f'valid, kind "{kind}": '), text.text)
                    answer = self.json_answer("check", name, signature)
                    self.assertEqual(list(answer), ["tripus", "input", "kind", "valid", "message"])
                    self.assertEqual((answer["kind"], answer["valid"]), (kind, True))

    def test_are_read_from_standard_input(self):
        text = json.dumps(self.certificate(NONE))
        self.assertEqual(self.run_program("check", "-", NONE, stdin=text).status, 0)

    def test_of_a_degenerate_triangulation(self):
        """A minimiser with flat tetrahedra where only semi-angle structures exist: both."""
        signature = "eLAkbbcddadgej"
        answer = self.certificate(signature)
        self.assertEqual(answer["outcome"], "degenerate")
        self.assertEqual(len(answer["flat_tetrahedra"]), 2)
        self.assertLessEqual(answer["max_curvature"], 1e-12)
        self.assertEqual(proves(answer), "semi")
        self.assertEqual(self.run_program("check", "answer.json", signature).status, 0)

    def rejected(self, certificate, signature, says):
        name = self.write("tampered.json", json.dumps(certificate))
        text = self.run_program("check", name, signature)
        self.assertEqual((text.status, text.err), (1, ""))
        self.assertTrue(text.text.startswith("not valid: "), text.text)
        self.assertIn(says, text.text)
        answer = self.json_answer("check", name, signature, status=1)
        self.assertFalse(answer["valid"])
        self.assertIn(says, answer["message"])

    def test_tampered_with_name_what_fails(self):
        good = self.certificate(NONE)["certificate"]
        cases = [
            (("edge", 1), 5, "vertex + vertex - edge = "),
            (("edge", 1), 0, 'kind "none" needs less than 0'),
            (("vertex", 1), [0, 0, 0, 0], "edge 01 of tetrahedron 1 (edge class 1)"),
            (("vertex", 0), [0, 0, -3, 0], "vertex 2 of tetrahedron 0 is -3, below 0"),
            (("vertex", 0), [9, 9, 9, 9], 'kind "none" needs less than 0'),
        ]
        for (key, place), value, says in cases:
            with self.subTest((key, place, value)):
                bad = json.loads(json.dumps(good))
                bad[key][place] = value
                self.rejected(bad, NONE, says)
        self.rejected(dict(good, kind="semi"), NONE, 'kind "semi" needs 0')

    def test_of_another_triangulation(self):
        good = self.certificate(NONE)["certificate"]
        self.rejected(good, TRIPUS, "2 edge multipliers, the triangulation 1 edge class")
        self.rejected(good, SEMI, "below 0")
        self.rejected(good, BOUNDARY_CASE, "edge multipliers")

    def test_that_are_none(self):
        for content, says in (("{", "syntax error"), ("[]", "expected an object"),
                              ('{"kind": "none", "edge": [0.5], "vertex": []}', "edge class 0"),
                              ('{"proof": {"radii": 1}, "proof": 2}', "occurs twice"),
                              ('{"proof": ' * 100000, "nested more than 32 levels deep"),
                              ('{"kind": "perhaps", "edge": [], "vertex": []}', '"kind"'),
                              (json.dumps(self.json_answer("solve", TRIPUS)), "carries none")):
            with self.subTest(content[:40]):
                self.write("bad.json", content)
                for more in ([], ["--json"]):
                    result = self.run_program("check", "bad.json", NONE, *more)
                    self.assertEqual(result.status, 2)
                    self.assertIn(says, result.err)
        self.assertEqual(self.run_program("check", "no-such-file", NONE).status, 2)


class AngleStructures(ProgramTest):
    def check(self, answer):
        """Strict, in exact fractions of pi."""
        angles = answer["angle_structure"]
        sums = [0] * answer["edge_count"]
        for classes, six in zip(answer["edge_classes"], angles["numerators"]):
            corners = [0] * 4
            for (i, j), edge, numerator in zip(ENDS, classes, six):
                angle = Fraction(numerator, angles["denominator"])
                self.assertGreater(angle, 0)
                sums[edge] += angle
                corners[i] += angle
                corners[j] += angle
            self.assertLess(max(corners), 1)
        self.assertEqual(sums, [2] * len(sums))

    def test_of_a_metric_are_printed_on_request(self):
        self.assertNotIn("angle_structure", self.json_answer("solve", TRIPUS))
        self.check(self.json_answer("solve", TRIPUS, "--angle-structure"))
        text = self.run_program("solve", TRIPUS, "--angle-structure").text
        self.assertIn("strict angle structure at 01 02 03 12 13 23, exact, in units of pi/6", text)
        self.assertEqual(text.count("            0  1 1 1 1 1 1\n"), 1)

    def test_are_the_evidence_of_a_boundary_case(self):
        for row in table("boundary-case-4.tsv"):
            with self.subTest(row["isosig"]):
                answer = self.json_answer("solve", row["isosig"], status=1)
                self.assertEqual((answer["outcome"], answer["certificate"]), ("degenerate", None))
                self.assertEqual(len(answer["flat_tetrahedra"]), 1)
                self.check(answer)

    def test_do_not_exist_without_metric(self):
        self.assertNotIn("angle_structure",
                         self.json_answer("solve", SEMI, "--angle-structure", status=1))


class Retriangulation(ProgramTest):
    def test_finds_the_metric_next_door(self):
        answer = self.json_answer("solve", BOUNDARY_CASE, "--retriangulate")
        self.assertEqual((answer["outcome"], answer["input"]), ("geometric", BOUNDARY_CASE))
        self.assertEqual(answer["tetrahedron_count"], 3)
        search = answer["retriangulation"]
        self.assertEqual(list(search), ["from", "tried", "ended", "path", "volumes"])
        self.assertEqual((search["from"], search["ended"]), (BOUNDARY_CASE, "found"))
        self.assertEqual(len(search["path"]), 1)
        self.assertEqual(search["volumes"][0]["isosig"], BOUNDARY_CASE)
        for other in search["volumes"]:
            self.assertAlmostEqual(other["volume"], answer["volume"], delta=1e-11)
        again = self.json_answer("solve", answer["isosig"])
        self.assertAlmostEqual(again["volume"], answer["volume"], delta=1e-12)

    def test_tells_its_path(self):
        text = self.run_program("solve", BOUNDARY_CASE, "--retriangulate")
        self.assertEqual(text.status, 0)
        self.assertEqual(text.lines[0], f"{BOUNDARY_CASE}: geometric")
        self.assertIn(f"retriangulated  from {BOUNDARY_CASE}: 1 triangulation tried", text.text)
        self.assertIn("3-2 at edge ", text.text)
        self.assertIn("volume again", text.text)

    def test_leaves_a_metric_alone(self):
        answer = self.json_answer("solve", TRIPUS, "--retriangulate")
        self.assertNotIn("retriangulation", answer)
        self.assertAlmostEqual(answer["volume"], TRIPUS_VOLUME, delta=1e-12)

    def test_is_unresolved_when_the_budget_ends(self):
        answer = self.json_answer("solve", OPEN, "--retriangulate", "--budget", "5", status=1)
        self.assertEqual(answer["outcome"], "unresolved")
        self.assertEqual(proves(answer), "none")
        search = answer["retriangulation"]
        self.assertEqual((search["tried"], search["ended"], search["path"]), (5, "budget", []))
        for words in ("5 other triangulations", "nothing follows about the manifold"):
            self.assertIn(words, answer["message"])
        text = self.run_program("solve", OPEN, "--retriangulate", "--budget", "5")
        self.assertEqual(text.status, 1)
        self.assertEqual(text.lines[0], f"{OPEN}: unresolved")
        self.assertIn("--budget", text.text)

    def test_ends_where_the_manifold_is_not_hyperbolic(self):
        answer = self.json_answer("solve", NONE, "--retriangulate", status=1)
        self.assertEqual((answer["outcome"], proves(answer)), ("unresolved", "none"))
        self.assertEqual(answer["retriangulation"]["ended"], "not hyperbolic")
        self.assertIn("its fundamental group is free", answer["message"])

    def test_is_the_same_for_the_same_seed(self):
        def search(seed):
            answer = self.json_answer("solve", NONE, "--retriangulate", "--budget", "30", "--seed",
                                      seed, status=1)
            return answer["retriangulation"]

        for seed in ("0", "7"):
            self.assertEqual(search(seed), search(seed))

    def test_ends_in_time(self):
        answer = self.json_answer("solve", ENDLESS, "--retriangulate", "--budget", "100000000",
                                  "--time-limit", "0.2", status=1,
                                  err="tripus: the time limit of 0.2 s was reached\n")
        self.assertEqual(answer["retriangulation"]["ended"], "time limit")
        self.assertIn("the time limit was reached", answer["message"])

    def test_options_belong_together(self):
        self.assert_refused("solve", NONE, "--budget", "5", says="--retriangulate", kind="usage")
        self.assert_refused("solve", NONE, "--seed", "5", says="--retriangulate", kind="usage")
        self.assert_refused("solve", NONE, "--retriangulate", "--budget", "x", says="--budget",
                            kind="usage")

    def test_labels_stay_when_it_looks_for_another_triangulation(self):
        # The triangulation of the trefoil's complement, order 5 on one edge: moves keep the label.
        answer = self.json_answer("solve", "dLQbcbcaekw", "--cone-order", "0=3", "--retriangulate",
                                  "--budget", "20", status=1)
        self.assertEqual(answer["cone_orders"].count(1), len(answer["cone_orders"]) - 1)
        self.assertEqual(answer["retriangulation"]["from"], "dLQbcbcaekw 0=3")
        self.write("list", "dLQbcbcaekw 0=3\n")
        batch = self.run_program("solve", "--batch", "list", "--retriangulate", "--budget", "5",
                                 "--json")
        self.assertIn('"cone_orders"', batch.text)

    def test_theorems_from_valences(self):
        answer = self.json_answer("solve", TRIPUS)["valence_theorem"]
        self.assertEqual((answer["claim"], answer["least_valence"], answer["source"]),
                         ("geometric", 12, "arXiv 2601.15174"))
        self.assertIn("theorem         every valence is at least 9",
                      self.run_program("solve", TRIPUS).text)
        self.assertNotIn("valence_theorem",
                         self.json_answer("solve", TRIPUS, "--cone-order", "0=2"))
