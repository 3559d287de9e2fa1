"""tripus prove, solve --prove, check of proofs, canonize and compare --prove, census --check."""

import json
import math
import re
from fractions import Fraction

from support import TRIPUS, TRIPUS_LENGTH, TRIPUS_VOLUME, ProgramTest, read_json



class Prove(ProgramTest):
    def test_proves_the_tripus(self):
        answer = self.json_answer("prove", TRIPUS)
        self.assertEqual(answer["outcome"], "geometric")
        self.assertTrue(answer["message"].startswith("Proved: "))
        proof = answer["proof"]
        self.assertIs(proof["proved"], True)
        self.assertEqual((proof["kind"], proof["claim"], proof["bits"]),
                         ("strong-convexity", "metric", 53))
        length = float.fromhex(proof["lengths"][0])
        self.assertLessEqual(abs(length - TRIPUS_LENGTH), 1e-14)
        self.assertLess(float(proof["radii"][0]), 1e-15)
        lower, upper = map(float, proof["volume"])
        self.assertLessEqual(lower, TRIPUS_VOLUME)
        self.assertGreaterEqual(upper, TRIPUS_VOLUME)
        self.assertIn("proved", self.run_program("prove", TRIPUS).text.lower())

    def test_many_digits(self):
        answer = self.json_answer("prove", TRIPUS, "--digits", "1000")
        proof = answer["proof"]
        lower, upper = proof["volume"]
        self.assertTrue(lower.startswith("6.45199027083503286529823442106030815281373253970455"))
        self.assertEqual(len(lower), 1002)
        self.assertLessEqual(int(upper.replace(".", "")) - int(lower.replace(".", "")), 1)
        # pi/6 at every edge.
        for low, high in (pair for angles in proof["dihedral_angles"] for pair in angles):
            self.assertTrue(low.startswith("0.52359877559829887307710723054658381403286156656"))
            self.assertLessEqual(int(high.replace(".", "")) - int(low.replace(".", "")), 1)
        self.write("proof.json", json.dumps(answer))
        self.assertIs(self.json_answer("check", "proof.json", TRIPUS)["valid"], True)

    def test_batch(self):
        self.write("list.txt", f"{TRIPUS}\ncPcbbbihz\ncMcabbjds\n")
        answer = self.run_program("prove", "--batch", "list.txt", "--json")
        self.assertEqual(answer.status, 0)
        lines = [read_json(line) for line in answer.lines]
        self.assertEqual(["proof" in line for line in lines], [True, False, True])

    def test_check_accepts_and_refuses(self):
        self.write("answer.json", self.run_program("prove", TRIPUS, "--json").out)
        valid = self.json_answer("check", "answer.json", TRIPUS)
        self.assertEqual((valid["valid"], valid["kind"]), (True, "strong-convexity"))
        proof = read_json((self.folder / "answer.json").read_text())["proof"]
        tampered = {
            "length": {"lengths": ["0x1.3p-1"]},
            "radius": {"radii": ["1e-30"]},
            "volume": {"volume": ["6.46", "6.47"]},
            "count": {"lengths": proof["lengths"] * 2},
            "flat": {"claim": "flat", "flat_tetrahedra": [0]},
        }
        for name, change in tampered.items():
            with self.subTest(name):
                self.write("tampered.json", json.dumps({"proof": {**proof, **change}}))
                answer = self.json_answer("check", "tampered.json", TRIPUS, status=1)
                self.assertIs(answer["valid"], False)
                self.assertTrue(answer["message"].startswith("not valid: "))
        other = self.json_answer("check", "answer.json", "dLQbcbcmens", status=1)
        self.assertIs(other["valid"], False)
        for name, change in {"word": {"lengths": ["long"]}, "number": {"radii": [1]},
                             "nan": {"lengths": ["nan"]}, "huge": {"lengths": ["1e999999999"]},
                             "kind": {"kind": "magic"}, "proved": {"proved": False}}.items():
            with self.subTest(name):
                self.write("broken.json", json.dumps({"proof": {**proof, **change}}))
                self.assert_refused("check", "broken.json", TRIPUS, says="proof: ")

    def test_solve_with_a_proof(self):
        answer = self.json_answer("solve", TRIPUS, "--prove")
        self.assertIs(answer["proof"]["proved"], True)
        self.assertIn("Proved", self.run_program("solve", TRIPUS, "--prove").text)

    def test_no_metric(self):
        answer = self.json_answer("prove", "dLQbcbcaekw", status=1)
        self.assertIs(answer["proof"]["proved"], False)
        self.assertIn("certificate", answer["proof"]["reason"])

    def test_cusps_and_cone_angles(self):
        # The figure-eight knot's volume (OEIS A091518).
        answer = self.json_answer("prove", "cPcbbbiht", "--digits", "40")
        lower, upper = answer["proof"]["volume"]
        self.assertTrue(lower.startswith("2.02988321281930725004240510854904057188"))
        self.write("cusp.json", json.dumps(answer))
        self.assertIs(self.json_answer("check", "cusp.json", "cPcbbbiht")["valid"], True)
        self.assertIs(self.json_answer("check", "cusp.json", "cPcbbbdxm", status=0)["valid"], True)
        labelled = "cPcbbbiht 0=2,1=3"
        answer = self.json_answer("prove", labelled)
        self.assertEqual(answer["proof"]["cone_angles"], ["1", "2/3"])
        self.write("orbifold.json", json.dumps(answer))
        self.assertIs(self.json_answer("check", "orbifold.json", labelled)["valid"], True)
        unlabelled = self.json_answer("check", "orbifold.json", "cPcbbbiht", status=1)
        self.assertIn("cone angles", unlabelled["message"])
        for broken in ("2/0", "-1", "0x", "nan", "1/3/5"):
            with self.subTest(broken):
                changed = {**answer["proof"], "cone_angles": [broken, "2"]}
                self.write("broken.json", json.dumps({"proof": changed}))
                self.assert_refused("check", "broken.json", labelled, says="cone angle")
        parabolic = self.json_answer("solve", "cPcbbbihq", "--cone-order", "0=0", "--prove")
        self.assertEqual((parabolic["proof"]["lengths"], parabolic["proof"]["radii"]),
                         (["0x0p+0"], ["0"]))

    def test_closed_manifolds(self):
        # The Weeks manifold; its volume by SnapPy.
        weeks = "jLvAMPQadfgghhiiijaqgjqxims"
        proof = self.json_answer("prove", weeks)["proof"]
        self.assertEqual((proof["proved"], proof["kind"]), (True, "interval-newton"))
        lower, upper = map(float, proof["volume"])
        self.assertLess(upper - lower, 1e-14)
        self.assertAlmostEqual(lower, 0.942707362776927720921, 14)
        answer = self.json_answer("prove", weeks, "--digits", "50", status=1)
        self.assertIn("finite", answer["proof"]["reason"])

    def test_canonize_with_cusps(self):
        for signature in ("cPcbbbiht", "dLQacccjjkg"):
            self.assertIs(self.json_answer("canonize", signature, "--prove")["proof"]["proved"], True)

    def test_census_of_a_list_with_proofs(self):
        self.write("list.txt", "cPcbbbihq\ncMcabbjds\ndLQacccjjkg\n")
        answer = self.run_program("census", "--from", "list.txt", "--prove", "--tsv", "c.tsv",
                                  "--proofs", "p.tsv", "--quiet")
        self.assertEqual(answer.status, 0, answer.text)
        answer = self.run_program("census", "--in", "c.tsv", "--check", "--proofs", "p.tsv")
        self.assertEqual((answer.status, answer.out), (0, b"3 of 3 manifolds have a valid proof\n"))
        self.assert_refused("census", "--from", "list.txt", "--prove", says="--proofs")
        self.assert_refused("census", "--from", "list.txt", "--proofs", "q.tsv", says="--prove")

    def test_census_with_proved_volumes(self):
        self.write("list.txt", "cPcbbbihq\ncMcabbjds\ndLQacccjjkg\ndLQbcccdhkw\n")
        answer = self.run_program("census", "--from", "list.txt", "--prove", "--tsv", "c.tsv",
                                  "--database", "c.sqlite", "--proofs", "p.tsv", "--quiet")
        self.assertEqual((answer.status, answer.err), (0, ""))
        lines = (self.folder / "c.tsv").read_text().split("\n")
        self.assertIn("which is digit 13 after the point", lines[1])
        volumes = [line.split("\t")[3] for line in lines[3:7]]
        self.assertEqual(volumes.count("6.4519902708350"), 3)
        for line in lines[3:7]:  # by the digits that `prove` gives
            lower, upper = (Fraction(x) for x in self.json_answer(
                "prove", line.split("\t")[-1].split(" ")[0], "--digits", "30")["proof"]["volume"])
            volume, half = Fraction(line.split("\t")[3]), Fraction(1, 2 * 10**13)
            self.assertTrue(volume - half <= lower <= upper <= volume + half)
        # A database keeps them, and a part of a census.
        self.assertEqual(self.run_program("census", "--in", "c.sqlite", "--tsv", "-").text,
                         "\n".join(lines))
        self.assertIn("\n# All volumes are proved", self.run_program(
            "census", "--in", "c.tsv", "--boundary", "g2", "--tsv", "-").text)
        valid = self.run_program("census", "--in", "c.tsv", "--check", "--proofs", "p.tsv")
        self.assertEqual((valid.status, valid.text), (0, "4 of 4 manifolds have a valid proof\n"))
        # One unit of the last digit is too much for the checker.
        text = "\n".join(line for line in lines if not line.startswith("# checksums"))
        self.write("wrong.tsv", text.replace("6.4519902708350", "6.4519902708351", 1))
        wrong = self.run_program("census", "--in", "wrong.tsv", "--check", "--proofs", "p.tsv")
        self.assertEqual(wrong.status, 1)
        self.assertIn("the volume", wrong.text)
        self.write("cut.tsv", text.replace("6.4519902708350", "6.451990270835", 1))
        self.assert_refused("census", "--in", "cut.tsv", says="digits after the point")

    def test_census_of_volumes_that_are_not_proved(self):
        # A triangulation that carries no metric.
        self.write("c.tsv", "name\ttetrahedra\tboundary\tvolume\thomology\tcells\tkeeping\treversing\t"
                            "signature\ttriangulations\nx\t3\tg2\t7\t2 Z\t1\t1\t1\tx\tdLQbcbcaekw\n")
        answer = self.run_program("census", "--in", "c.tsv", "--prove", "--proofs", "p.tsv", "--tsv", "-")
        self.assertEqual(answer.status, 1)
        self.assertIn("1 of 1 are not proved", answer.err)
        self.assertNotIn("All volumes", answer.text)
        self.assert_refused("census", "--in", "c.tsv", "--prove", "--tsv", "-", says="--proofs")

    def test_canonize_an_octahedron(self):
        proof = self.json_answer("canonize", "t4g2.98", "--prove")["proof"]
        self.assertEqual((proof["proved"], proof["unproved_faces"], len(proof["inner_faces"])),
                         (True, [], 4))
        # By hand: f changes its sign between the two numbers, and the entries are cosh of the
        # lengths.
        field = proof["field"]
        polynomial = field["polynomial"].replace("^", "**")
        below, above = (eval(polynomial, {"x": Fraction(root)}) for root in field["root"])
        self.assertLess(below * above, 0)
        x = Fraction(field["root"][0])
        for entry, length in zip(field["gram"], proof["metric"]["lengths"], strict=True):
            terms = re.sub(r"(\d+)", r"F(\1)", re.sub(r"x\^(\d)", lambda m: "*".join("x" * int(m[1])), entry))
            self.assertAlmostEqual(float(eval(terms, {"x": x, "F": Fraction})),
                                   math.cosh(float.fromhex(length)), 12)

    def test_checks_decompositions(self):
        for input, text in (("t4g2.98", "merged across the inner faces"), ("cPcbbbiht", "tetrahedra are")):
            answer = self.json_answer("canonize", input, "--prove")
            self.write("answer", json.dumps(answer))
            self.write("proof", json.dumps(answer["proof"]))
            for given in ("answer", "proof"):
                self.assertIn(text, self.run_program("check", given, input).text)
                checked = self.json_answer("check", given, input)
                self.assertEqual((checked["kind"], checked["valid"]), ("canonical-decomposition", True))
        answer = self.json_answer("canonize", "t4g2.98", "--prove")
        self.write("answer", json.dumps(answer))
        self.assertIn('it is about the triangulation "' + answer["proof"]["triangulation"],
                      self.run_program("check", "answer", TRIPUS).text)
        self.assertEqual(self.run_program("check", "answer", TRIPUS).status, 1)
        answer["proof"]["inner_faces"].pop()
        self.write("answer", json.dumps(answer))
        refused = self.json_answer("check", "answer", "t4g2.98", status=1)
        self.assertIs(refused["valid"], False)
        self.assertIn("its tilt sum < 0 fails", refused["message"])
        answer["proof"]["field"]["gram"][0] = "x^"
        self.write("answer", json.dumps(answer))
        self.assert_refused("check", "answer", "t4g2.98", says='"answer": proof: "x^" is no polynomial')

    def test_canonize_and_compare(self):
        answer = self.json_answer("canonize", TRIPUS, "--prove")
        self.assertIs(answer["proof"]["proved"], True)
        self.assertEqual(answer["proof"]["unproved_faces"], [])
        answer = self.json_answer("compare", TRIPUS, "cMcabbjds", "--prove", status=1)
        self.assertEqual(answer["verdict"], "different")
        self.assertIs(answer["proof"]["proved"], True)

    def test_census_check(self):
        self.write("proofs.tsv", "name\ttriangulation\tlengths\tradius\n"
                                 "t2g2.1\tcMcabbjds\t0x1.3p-1\t1e-10\n")
        self.run_program("census", "--tetrahedra", "2", "--tsv", "two.tsv")
        answer = self.run_program("census", "--in", "two.tsv", "--check", "--proofs", "proofs.tsv")
        self.assertEqual(answer.status, 1)
        self.assertIn("t2g2.1: edge class 0", answer.text)
        self.assertIn("t2g2.2: there is no proof of it", answer.text)
        answer = self.run_program("census", "--in", "two.tsv", "--check")
        self.assertEqual((answer.status, answer.text), (0, "12 of 12 manifolds have a valid proof\n"))
        made = self.run_program("census", "--in", "two.tsv", "--prove").text
        shipped = (self.folder / "made.tsv")
        shipped.write_text(made)
        self.assertEqual(self.run_program("census", "--in", "two.tsv", "--check", "--proofs",
                                          "made.tsv").status, 0)
