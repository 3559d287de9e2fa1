"""tripus cover: streams of covers."""

import signal
import subprocess

import samples
from support import TRIPUS, TRIPUS_VOLUME, ProgramTest, read_json

KEYS = ["tripus", "input", "cover", "degree", "deck_group_order", "regular", "permutations", "isosig",
        "tetrahedron_count", "edge_count", "orientable", "edge_valences", "oriented_isosig", "vertices",
        "H1", "gluings"]
# H1 is Z_8: few covers.
LENS = "cMcabbjqs"


class Streams(ProgramTest):
    def covers(self, *arguments):
        result = self.run_program("cover", *arguments, "--json")
        self.assertEqual((result.status, result.err), (0, ""))
        return [read_json(line) for line in result.lines]

    def test_json_of_a_degree(self):
        covers = self.covers(TRIPUS, "--degree", "3")
        self.assertEqual(len(covers), 7)  # Regina
        self.assertEqual(sum(cover["regular"] for cover in covers), 4)  # classes of Z^2 onto Z/3
        for number, cover in enumerate(covers, start=1):
            self.assertEqual(list(cover), KEYS)
            self.assertEqual((cover["cover"], cover["degree"]), (number, 3))
            self.assertEqual((cover["tetrahedron_count"], cover["edge_valences"]), (6, [12] * 3))

    def test_a_line_is_an_input(self):
        line = self.run_program("cover", TRIPUS, "--cyclic", "2", "--limit", "1", "--json").text
        answer = self.json_answer("solve", self.write("cover.json", line))
        self.assertAlmostEqual(answer["volume"], 2 * TRIPUS_VOLUME, delta=1e-11)

    def test_text_can_be_piped(self):
        text = self.run_program("cover", TRIPUS, "--degree", "2").text
        self.assertEqual(len(text.splitlines()), 3)
        result = self.run_program("solve", "--batch", "-", "--json", stdin=text)
        for line in result.lines:
            self.assertAlmostEqual(read_json(line)["volume"], 2 * TRIPUS_VOLUME, delta=1e-11)

    def test_sheets_of_a_class(self):
        gluings = samples.as_json(samples.TRIPUS_GLUINGS)
        path = self.write("y.json", gluings)
        for values in ("1,0", "0,1", "2,3", "-1,2"):
            cover, = self.covers(path, "--cyclic", "5", f"--class={values}")
            self.assertEqual(cover["class"], [int(value) for value in values.split(",")])
            shifts = set()
            for t, row in enumerate(cover["gluings"]):
                for face, (other, word) in enumerate(row):
                    below = samples.TRIPUS_GLUINGS[t % 2][face]
                    self.assertEqual((other % 2, word), below)
                    shifts.add((t % 2, face, (other // 2 - t // 2) % 5))
            self.assertEqual(len(shifts), 8)  # one shift for each face, on every sheet

    def test_every_cyclic_cover_is_among_all(self):
        for degree in ("2", "3", "4", "5"):
            cyclic = self.covers(TRIPUS, "--cyclic", degree)
            every = {cover["isosig"] for cover in self.covers(TRIPUS, "--degree", degree)
                     if cover["regular"]}
            self.assertLessEqual({cover["isosig"] for cover in cyclic}, every)

    def test_batch_goes_on_after_a_bad_line(self):
        self.write("list", f"{TRIPUS}\nnonsense!\n{LENS}\n")
        result = self.run_program("cover", "--batch", "list", "--cyclic", "3", "--json")
        self.assertEqual(result.status, 0)
        answers = [read_json(line) for line in result.lines]
        self.assertEqual([answer["input"] for answer in answers], [TRIPUS] * 4 + ["nonsense!"])
        self.assertIn("line 2", result.err)
        self.assertIn("no map onto Z/3", result.err)
        text = self.run_program("cover", "--batch", "list", "--cyclic", "2").text
        self.assertEqual([line for line in text.splitlines() if line.startswith("#")],
                         [f"# {TRIPUS}", "# nonsense!", f"# {LENS}"])

    def test_files(self):
        lines = self.run_program("cover", TRIPUS, "--degree", "3").text
        result = self.run_program("cover", TRIPUS, "--degree", "3", "-o", "covers.txt")
        self.assertEqual((result.status, result.out), (0, b""))
        self.assertEqual((self.folder / "covers.txt").read_text(), lines)
        result = self.run_program("cover", TRIPUS, "--degree", "3", "-o", "folder/")
        self.assertEqual(result.text, lines)
        for number, line in enumerate(lines.splitlines(), start=1):
            answer = self.json_answer("info", f"folder/cover-{number:06}.json")
            self.assertEqual(answer["isosig"], line.split()[0])
            self.assertEqual(answer["name"], f"{TRIPUS}, degree 3, cover {number}")
        self.assert_refused("cover", TRIPUS, "--degree", "3", "-o", "no/such/file",
                            says="cannot write")


class Limits(ProgramTest):
    def test_refusals(self):
        for arguments, says in [
            ((TRIPUS,), "--cyclic N or --degree N"),
            ((TRIPUS, "--cyclic", "2", "--degree", "2"), "excludes"),
            ((TRIPUS, "--degree", "2", "--class", "1,0"), "--cyclic"),
            ((TRIPUS, "--degree", "0"), "degree 0"),
            ((TRIPUS, "--cyclic", "0"), "degree 0"),
            ((TRIPUS, "--degree", "101"), "from 1 to 100 sheets"),
            ((TRIPUS, "--degree", "-3"), "whole number"),
            ((TRIPUS, "--degree", "99999999999999999999"), "whole number"),
            ((TRIPUS, "--cyclic", "2147483647"), "would have 4294967294 tetrahedra"),
            ((TRIPUS, "--cyclic", "3", "--class", "1"), "has 2 values"),
            ((TRIPUS, "--cyclic", "6", "--class", "2,4"), "common divisor 2"),
            ((TRIPUS, "--cyclic", "3", "--class", "1,x"), "entry 2"),
            ((TRIPUS, "--cyclic", "3", "--class", "1,"), "entry 2"),
            ((TRIPUS, "--cyclic", "3", "--class", ""), "entry 1"),
            ((LENS, "--cyclic", "16", "--class", "1"), "order 8"),
            (("cPcbbbihqcPcbbbihq", "--degree", "2"), "2 components"),
        ]:
            with self.subTest(arguments):
                self.assert_refused("cover", *arguments, says=says)

    def test_orientable_double_cover_is_the_remedy_that_is_named(self):
        for base, volume in (("cMcabbidt", 2 * TRIPUS_VOLUME), ("cMcabbijr", 2 * TRIPUS_VOLUME),
                             ("cPcbbbchw", 2 * TRIPUS_VOLUME)):
            with self.subTest(base):
                self.assert_refused("orthospectrum", base, says="tripus cover INPUT --orientable")
                line = self.run_program("cover", base, "--orientable").text
                answer = self.json_answer("solve", line.split()[0])
                self.assertEqual((answer["orientable"], answer["tetrahedron_count"]), (True, 4))
                self.assertAlmostEqual(answer["volume"], volume, delta=1e-11)
        gieseking = self.run_program("cover", "bkaaid", "--orientable").text
        self.assertTrue(gieseking.startswith("cPcbbbiht"))  # the figure-eight knot's exterior
        self.assert_refused("cover", TRIPUS, "--orientable", says="orientable already")

    def test_no_cover(self):
        for arguments, says in [((LENS, "--degree", "3"), "no connected cover of degree 3"),
                                ((LENS, "--cyclic", "3"), "H1 is Z_8, which has no map onto Z/3")]:
            result = self.run_program("cover", *arguments, "--json")
            self.assertEqual((result.status, result.out), (1, b""))
            self.assertIn(says, result.err)

    def test_interrupt_leaves_whole_lines(self):
        process = subprocess.Popen(self.command("cover", TRIPUS, "--degree", "12", "--json"),
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, bufsize=0)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        first = process.stdout.readline()
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1)
        covers = [read_json(line) for line in (first + out).splitlines()]
        self.assertRegex(err.decode(), rf"interrupted after {len(covers)} cover")
        self.assertTrue((first + out).endswith(b"\n"))

    def test_many_tetrahedra(self):
        cover = read_json(self.run_program("cover", TRIPUS, "--cyclic", "100000", "--class", "1,0",
                                           "--json").text)
        self.assertEqual(cover["tetrahedron_count"], 200_000)
        self.assertEqual(cover["H1"], "100001 Z")
