"""tripus enumerate: lists of triangulations as a stream."""

import shutil
import unittest

from support import DATA, ProgramTest


def lines_of(name):
    return [line for line in (DATA / name).read_text().splitlines() if not line.startswith("#")]


class Enumerate(ProgramTest):
    def enumerate(self, *arguments, status=0):
        result = self.run_program("enumerate", *arguments, "--quiet")
        self.assertEqual((result.status, result.err), (status, ""))
        return result.lines

    def test_gives_the_lists(self):
        for n in (2, 3, 4):
            self.assertEqual(sorted(self.enumerate(str(n))), sorted(lines_of(f"triangulations-{n}.txt")))
        mixed = self.enumerate("3", "--links", "mixed") + self.enumerate("4", "--links", "mixed")
        self.assertEqual(sorted(mixed), sorted(lines_of("triangulations-cusped.txt")))

    def test_does_not_depend_on_threads(self):
        one = self.enumerate("4", "--threads", "1")
        self.assertEqual(one, self.enumerate("4", "--threads", "3"))

    def test_in_shards_is_the_whole(self):
        whole = self.enumerate("4")
        for count in (2, 7, 400):
            parts = [line for k in range(1, count + 1)
                     for line in self.enumerate("4", "--shard", f"{k}/{count}")]
            self.assertEqual(sorted(parts), sorted(whole))

    def test_counts(self):
        self.assertEqual(self.enumerate("3", "--count"), ["240"])
        result = self.run_program("enumerate", "2", "-o", "list.txt")
        self.assertEqual((result.status, result.text, result.err), (0, "", "8 triangulations\n"))
        self.assertEqual(len((self.folder / "list.txt").read_text().splitlines()), 8)

    def test_draws_at_random(self):
        some = self.enumerate("4", "--random", "1200", "--seed", "3", "--threads", "1")
        self.assertEqual(len(some), 1200)
        self.assertLess(set(some), set(lines_of("triangulations-4.txt")))
        self.assertEqual(some, self.enumerate("4", "--random", "1200", "--seed", "3", "--threads", "3"))
        self.assertNotEqual(some, self.enumerate("4", "--random", "1200"))
        self.assertEqual(self.enumerate("4", "--random", "0"), [])

    def test_knows_what_is_not_orientable(self):
        for links in ("geodesic", "mixed", "cusped"):
            parts = [self.enumerate("3", "--links", links, *flags) for flags in ((), ("--non-orientable",))]
            self.assertEqual(sorted(sum(parts, [])), sorted(self.enumerate("3", "--links", links, "--all")))
        self.assertIn("bkaaid", self.enumerate("1", "--links", "cusped", "--non-orientable"))
        for line in self.enumerate("2", "--links", "cusped", "--non-orientable", "--random", "3"):
            self.assertFalse(self.json_answer("info", line)["orientable"])

    def test_refuses(self):
        for arguments, says in (
                (("0",), "N: "), (("13",), "N: "), (("x",), "N: "),
                (("3", "--shard", "0/4"), "NUMBER/COUNT"), (("3", "--shard", "5/4"), "NUMBER/COUNT"),
                (("3", "--shard", "1of4"), "NUMBER/COUNT"), (("3", "--links", "round"), "geodesic"),
                (("3", "--shard", ""), "NUMBER/COUNT"), (("3", "--engine", "luck"), "tricensus"),
                (("3", "--engine", "tricensus", "--shard", "1/2"), "--shard"),
                (("3", "--engine", "tricensus", "--random", "2"), "--random"),
                (("2", "--links", "mixed", "--random", "2"), "mixed"),
                (("2", "--all", "--non-orientable"), "--all"),
                (("1", "--links", "mixed", "--all", "--random", "2"), "mixed"),
                (("1", "--links", "cusped", "--random", "2"), "cusped")):
            result = self.run_program("enumerate", *arguments)
            self.assertEqual(result.status, 2, arguments)
            self.assertIn(says, result.err)

    def test_by_tricensus(self):
        if not shutil.which("tricensus"):
            result = self.run_program("enumerate", "2", "--engine", "tricensus")
            self.assertEqual(result.status, 2)
            self.assertIn("regina-normal", result.err)
            raise unittest.SkipTest("Regina's tricensus is not installed")
        for n, links, *more in ((2, "geodesic"), (3, "geodesic"), (3, "mixed"), (3, "cusped"),
                                (2, "geodesic", "--all"), (3, "geodesic", "--non-orientable"),
                                (3, "mixed", "--non-orientable"), (3, "cusped", "--non-orientable")):
            arguments = (str(n), "--links", links, *more)
            self.assertEqual(sorted(self.enumerate(*arguments, "--engine", "tricensus")),
                             sorted(self.enumerate(*arguments)))
