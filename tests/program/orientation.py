"""Signatures with a sign: the orientation goes through files and verbs, and is not made up."""

import json

import samples
from support import TRIPUS, ProgramTest, read_json

AMPHICHEIRAL = "cMcabbjdw"
NON_ORIENTABLE = "bkaaid"  # Gieseking's manifold


class Signed(ProgramTest):
    def compared(self, first, second):
        result = self.run_program("compare", first, second, "--json")
        self.assertEqual((result.status, result.err), (0, ""))
        answer = read_json(result.text)
        return answer["keeps_orientation"], answer["reverses_orientation"], answer["message"]

    def test_are_inputs_of_every_verb(self):
        for sign in "+-":
            signed = TRIPUS + sign
            self.assertEqual(self.json_answer("info", signed)["oriented_isosig"], signed)
            self.assertEqual(self.json_answer("info", signed)["isosig"], TRIPUS)
            self.assertIn(signed, self.run_program("info", signed).text)
            self.assertEqual(self.json_answer("solve", signed)["outcome"], "geometric")
            self.assertEqual(self.json_answer("canonize", signed)["oriented_signature"], signed)
            self.assertEqual(self.json_answer("simplify", signed)["oriented_isosig"], signed)
            self.assertEqual(self.json_answer("identify", signed)["census"]["signature"], TRIPUS)
            self.write("list", f"{signed}\n")
            batch = self.run_program("info", "--batch", "list", "--json")
            self.assertEqual(read_json(batch.text)["oriented_isosig"], signed)

    def test_are_compared(self):
        keeping, mirror = TRIPUS + "+", TRIPUS + "-"
        self.assertEqual(self.compared(keeping, keeping)[:2], (True, False))
        self.assertEqual(self.compared(mirror, mirror)[:2], (True, False))
        keeps, reverses, message = self.compared(keeping, mirror)
        self.assertEqual((keeps, reverses), (False, True))
        self.assertIn("as mirror images", message)
        self.assertEqual(self.compared(AMPHICHEIRAL + "+", AMPHICHEIRAL + "-")[:2], (True, True))

    def test_plain_ones_do_not_tell(self):
        for first, second in ((TRIPUS, TRIPUS), (TRIPUS, TRIPUS + "+"), (TRIPUS + "-", TRIPUS)):
            keeps, reverses, message = self.compared(first, second)
            self.assertEqual((keeps, reverses), (None, None))
            self.assertIn("orientation not known", message)
            self.assertNotIn("keeping", message)
        self.assertEqual(self.compared(AMPHICHEIRAL, AMPHICHEIRAL)[:2], (True, True))
        self.assertIsNone(self.json_answer("info", TRIPUS)["oriented_isosig"])
        self.assertIs(self.json_answer("canonize", TRIPUS)["orientation_known"], False)
        self.assertIn("orientation is not known", self.run_program("canonize", TRIPUS).text)
        # Where the mirror image is the same triangulation there is nothing to know.
        self.assertEqual(self.json_answer("info", AMPHICHEIRAL)["oriented_isosig"],
                         AMPHICHEIRAL + "+")

    def test_files_keep_the_orientation(self):
        for sign in "+-":
            signed = TRIPUS + sign
            for name in ("x.sig", "x.json"):
                for verb in ("simplify", "solve"):
                    self.assertEqual(self.run_program(verb, signed, "-o", name).status, 0)
                    self.assertEqual(self.compared(name, signed)[:2], (True, False))
            self.assertEqual((self.folder / "x.sig").read_text(), TRIPUS + "+\n"
                             if sign == "+" else TRIPUS + "-\n")
        for verb in ("simplify", "solve"):
            result = self.run_program(verb, TRIPUS, "-o", "plain.sig")
            self.assertIn('note: "plain.sig" tells no orientation', result.err)
            self.assertEqual(self.run_program(verb, TRIPUS, "-o", "plain.json").err, "")
            self.assertEqual(self.run_program(verb, TRIPUS + "-", "-o", "plain.sig").err, "")
        self.assertEqual(self.run_program("simplify", AMPHICHEIRAL, "-o", "plain.sig").err, "")
        self.run_program("simplify", TRIPUS, "-o", "plain.sig")
        self.assertEqual((self.folder / "plain.sig").read_text(), TRIPUS + "\n")

    def test_mirrored_tables(self):
        """Labels 2 and 3 exchanged everywhere: the mirror image."""
        swap = str.maketrans("23", "32")

        def mirrored(word):
            word = word.translate(swap)
            return word[:2] + word[3] + word[2]

        self.write("y.json", samples.as_json(samples.TRIPUS_GLUINGS))
        table = [[row[0], row[1], row[3], row[2]] for row in samples.TRIPUS_GLUINGS]
        self.write("mirror.json", json.dumps(
            {"gluings": [[[other, mirrored(word)] for other, word in row] for row in table]}))
        signs = {self.json_answer("info", name)["oriented_isosig"] for name in ("y.json",
                                                                               "mirror.json")}
        self.assertEqual(signs, {TRIPUS + "+", TRIPUS + "-"})
        self.assertEqual(self.compared("y.json", "mirror.json")[:2], (False, True))

    def test_lines_of_cover(self):
        plain = self.run_program("cover", TRIPUS, "--degree", "3").lines
        signed = {sign: self.run_program("cover", TRIPUS + sign, "--degree", "3").lines
                  for sign in "+-"}
        self.assertEqual(len(plain), 7)
        for k in range(7):
            word = plain[k].split()[0]
            found = [signed[sign][k].split()[0] for sign in "+-"]
            self.assertTrue(set(found) <= {word + "+", word + "-"}, found)
            answer = self.json_answer("info", found[0])
            self.assertEqual(answer["oriented_isosig"], found[0])
            # The same cover of the mirror image.
            self.assertIn(self.compared(found[0], found[1])[:2], [(False, True), (True, True)])

    def test_without_orientation(self):
        for verb in ("info", "solve"):
            self.assert_refused(verb, NON_ORIENTABLE + "+", says="not orientable")
            self.assert_refused(verb, TRIPUS + TRIPUS + "-", says="several components")
        self.assertIsNone(self.json_answer("info", NON_ORIENTABLE)["oriented_isosig"])
