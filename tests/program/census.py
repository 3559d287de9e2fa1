"""Censuses in shards: whole or absent, in any order, and the same in the end."""

import collections
import csv
import gzip
import os
import random
import re
import resource
import signal
import subprocess
import sys
import time
import zipfile
from pathlib import Path

from support import DATA, ProgramTest

LISTS = ("--from", str(DATA / "triangulations-2.txt"), "--from", str(DATA / "triangulations-3.txt"))


class Shards(ProgramTest):
    def shard(self, k, count, *more, status=0):
        result = self.run_program("census", *LISTS, "--shard", f"{k}/{count}", "-o", f"{k}.tcs", *more)
        self.assertEqual(result.status, status, result.err)
        return result

    def merge(self, count, *more, order=None):
        names = [f"{k}.tcs" for k in order or range(1, count + 1)]
        return self.run_program("census", "--merge", *names, *more)

    def whole(self):
        self.run_program("census", *LISTS, "--tsv", "whole.tsv", "--database", "whole.sqlite")
        return (self.folder / "whole.tsv").read_bytes()

    def test_of_any_size_make_the_same_census(self):
        whole = self.whole()
        for count in (1, 3, 50, 300):
            for k in range(1, count + 1):
                self.shard(k, count, "--threads", str(1 + k % 3), "--quiet")
            order = list(range(1, count + 1))
            random.Random(count).shuffle(order)
            result = self.merge(count, "--tsv", "out.tsv", "-o", "out.sqlite", order=order)
            self.assertEqual(result.status, 0, result.err)
            self.assertEqual((self.folder / "out.tsv").read_bytes(), whole)
            again = self.run_program("census", "--in", "out.sqlite", "--tsv", "-").text
            self.assertEqual(again.encode(), whole)
            for path in self.folder.glob("*.tcs"):
                path.unlink()

    def test_are_made_once(self):
        self.assertIn("shard 1/4: 62 lines: ", self.shard(1, 4).err)
        before = (self.folder / "1.tcs").stat()
        self.assertIn("is there already", self.shard(1, 4).err)
        self.assertEqual((self.folder / "1.tcs").stat().st_mtime_ns, before.st_mtime_ns)
        self.assertIn("is not this shard", self.run_program(
            "census", *LISTS, "--shard", "2/4", "-o", "1.tcs").err)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["1.tcs"])

    def test_that_do_not_fit_are_named(self):
        for k in (1, 2, 3):
            self.shard(k, 4)
        result = self.merge(3, "--tsv", "out.tsv")
        self.assertEqual(result.status, 2)
        self.assertIn("1 of 4 shards are missing: 4", result.err)
        self.shard(4, 4)
        (self.folder / "copy.tcs").write_bytes((self.folder / "4.tcs").read_bytes())
        result = self.run_program("census", "--merge", "1.tcs", "2.tcs", "3.tcs", "4.tcs", "copy.tcs")
        self.assertIn("are both shard 4/4", result.err)
        result = self.run_program("census", "--merge", *(f"{k}.tcs" for k in (1, 2, 3, 4)), "-o", "1.tcs")
        self.assertIn('-o "1.tcs" would write over', result.err)
        self.run_program("census", *LISTS, "--shard", "4/4", "-o", "other.tcs", "--budget", "3")
        result = self.run_program("census", "--merge", "1.tcs", "2.tcs", "3.tcs", "other.tcs")
        self.assertIn("not of the same census", result.err)
        self.assertIn("budget 3", result.err)
        self.assertFalse((self.folder / "out.tsv").exists())

    def test_that_are_missing_are_named_however_many(self):
        self.run_program("census", *LISTS, "--shard", "5/1000000000", "-o", "one.tcs")
        result = self.run_program("census", "--merge", "one.tcs")
        self.assertEqual(result.status, 2)
        self.assertIn("999999999 of 1000000000 shards are missing: 1 to 4, 6 to 1000000000;", result.err)
        for k in range(1, 26, 2):
            self.shard(k, 26, "--quiet")
        result = self.run_program("census", "--merge", *(f"{k}.tcs" for k in range(25, 0, -2)))
        self.assertIn("13 of 26 shards are missing: 2, 4, 6, 8, 10, 12, 14, 16, 18, 20 and 3 more;",
                      result.err)

    def test_that_are_damaged_are_refused_and_made_anew(self):
        self.shard(1, 2)
        self.shard(2, 2)
        good = (self.folder / "1.tcs").read_bytes()
        chance = random.Random(1)
        for _ in range(20):
            bad = bytearray(good)
            if chance.random() < 0.5:
                bad[chance.randrange(len(bad))] ^= 1 << chance.randrange(7)
            else:
                bad = bad[:chance.randrange(len(bad))]
            if bytes(bad) == good:
                continue
            (self.folder / "1.tcs").write_bytes(bad)
            result = self.merge(2, "--tsv", "out.tsv")
            self.assertEqual(result.status, 2)
            self.assertIn('"1.tcs"', result.err)
        (self.folder / "1.tcs").write_bytes(good[:-1])
        self.assertIn("it is made anew", self.shard(1, 2).err)
        self.assertEqual((self.folder / "1.tcs").read_bytes(), good)

    def test_record_bad_lines(self):
        self.write("list", "cPcbbbihq\nbanana\nno such file\ncPcbbbiht\tx\ncMcabbjdw\n")
        for k in (1, 2):
            result = self.run_program("census", "--from", "list", "--shard", f"{k}/2", "-o", f"{k}.tcs")
            self.assertEqual(result.status, 0, result.err)
        self.assertIn("refused\t", (self.folder / "2.tcs").read_text())
        result = self.merge(2, "--tsv", "out.tsv")
        self.assertEqual(result.status, 0)
        self.assertIn("3 refused", result.err)
        self.assertIn("banana", result.err)

    def test_survive_kills(self):
        """Workers are killed at random moments, two at a time on each shard; then it is the same."""
        whole = self.whole()
        count, chance = 3, random.Random(22)
        for _ in range(50):
            k = chance.randrange(1, count + 1)
            workers = [subprocess.Popen(
                [*self.command("census", *LISTS, "--shard", f"{k}/{count}", "-o", f"{k}.tcs",
                               "--threads", "1")], cwd=self.folder, stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL) for _ in range(2)]
            time.sleep(chance.uniform(0, 0.08))
            for worker in workers:
                os.kill(worker.pid, signal.SIGKILL)
                worker.wait()
            for path in self.folder.glob("*.tcs"):  # whole or absent
                self.assertTrue(path.read_text().splitlines()[-1].startswith("# end of the shard"))
        for k in range(1, count + 1):
            self.shard(k, count)
        self.assertEqual(list(self.folder.glob("*.journal")), [])
        self.assertEqual(self.merge(count, "--tsv", "out.tsv", "--quiet").status, 0)
        self.assertEqual((self.folder / "out.tsv").read_bytes(), whole)

    def test_on_a_disk_that_fills_are_absent_and_go_on_with_room(self):
        """A limit on the length of files stands for the disk. What fitted is not made again."""
        self.shard(1, 2)
        good = (self.folder / "1.tcs").read_bytes()
        for limits in (range(0, len(good), len(good) // 12 + 1), [len(good) // 2, 0, len(good) - 1]):
            (self.folder / "1.tcs").unlink()
            for limit in limits:
                result = self.run_program(
                    "census", *LISTS, "--shard", "1/2", "-o", "1.tcs",
                    preexec_fn=lambda limit=limit: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
                self.assertEqual(result.status, 3, (limit, result.err))
                self.assertIn("File too large", result.err)
                self.assertFalse((self.folder / "1.tcs").exists())
            self.shard(1, 2)
            self.assertEqual((self.folder / "1.tcs").read_bytes(), good)
        self.assertEqual(list(self.folder.glob("*.journal")), [])

    def test_that_are_no_files_are_refused(self):
        for path, says in (("/dev/full", "is no ordinary file"), (".", "Is a directory")):
            result = self.run_program("census", *LISTS, "--shard", "1/2", "-o", path)
            self.assertEqual(result.status, 2)
            self.assertIn(says, result.err)

    def test_make_tables_that_may_be_compressed(self):
        whole = self.whole()
        (self.folder / "whole.tsv.gz").write_bytes(gzip.compress(whole))
        result = self.run_program("census", "--in", "whole.tsv.gz", "--tsv", "-")
        self.assertEqual((result.status, result.text.encode()), (0, whole))
        (self.folder / "torn.tsv.gz").write_bytes(gzip.compress(whole)[:-9])
        self.assertEqual(self.run_program("census", "--in", "torn.tsv.gz", "g2").status, 2)

    def test_want_their_options(self):
        for arguments, says in (
                (("--shard", "1/2"), "--from"), ((*LISTS, "--shard", "1/2"), "-o"),
                ((*LISTS, "--shard", "3/2", "-o", "x"), "NUMBER/COUNT"),
                ((*LISTS, "-o", "x"), "--shard"), ((*LISTS, "--shard", "", "-o", "x"), "NUMBER/COUNT"),
                (("--merge", "x", "--check"), "--check"),
                (("--merge", "x", "--budget", "3"), "--budget"),
                (("--merge", "x", "--prove"), "--proofs"),
                ((*LISTS, "--prove", "--proofs", "-", "--tsv", "-"), "--proofs"),
                (("--check", "--volume", "2"), "--volume"), (("--check", "g2_1"), "NAME"),
                ((*LISTS, "--shard", "1/2", "-o", "x", "--tsv", "y"), "--tsv"),
                ((*LISTS, "--merge", "x"), "--merge"), (("--merge", "x"), '"x"')):
            result = self.run_program("census", *arguments)
            self.assertEqual((result.status, result.text), (2, ""), arguments)
            self.assertIn(says, result.err)


class Published(ProgramTest):
    """scripts/census_table: what is new, what is open, volumes proved."""

    SCRIPT = Path(__file__).resolve().parents[2] / "scripts/census_table"

    def make(self, *arguments):
        return subprocess.run([sys.executable, self.SCRIPT, *arguments, "--program", self.command()[0]],
                              cwd=self.folder, capture_output=True, text=True, check=False)

    def test_has_what_is_new_and_what_is_open(self):
        self.run_program("census", *LISTS, "--tsv", "all.tsv", "--quiet")
        self.run_program("census", *LISTS[:2], "--tsv", "old.tsv", "--quiet")
        for name in ("a", "b"):
            made = self.make("all.tsv", "--without", "old.tsv", "-o", f"{name}.tsv.gz", "--proofs",
                             f"{name}.proofs")
            self.assertEqual(made.returncode, 0, made.stderr)
        self.assertEqual((self.folder / "a.tsv.gz").read_bytes(), (self.folder / "b.tsv.gz").read_bytes())
        # 74 of three tetrahedra are unresolved; each is counted as decided or stands in the table.
        new, known, undecided, decided = map(int, re.findall(r"\d+", made.stdout))
        self.assertEqual((new, known, undecided + decided), (150, 8, 74))
        self.assertGreater(decided, 0)
        text = gzip.decompress((self.folder / "a.tsv.gz").read_bytes()).decode()
        self.assertIn(" 150 manifolds, ", text.split("\n")[0])
        self.assertIn(f"{undecided} unresolved.\n# All volumes are proved", text)
        still = [line.split()[2] for line in text.split("\n") if line.startswith("# unresolved")]
        self.assertEqual(len(still), undecided)
        known_not = {line.split("\t")[1] for line in (DATA / "hyperbolicity.tsv").read_text().split("\n")
                     if line.startswith("3\t") and "\tfalse\t" in line}
        self.assertLessEqual(set(still), known_not)  # which the package's own tests decide
        checked = self.run_program("census", "--in", "a.tsv.gz", "--check", "--proofs", "a.proofs")
        self.assertEqual((checked.status, checked.text), (0, "150 of 150 manifolds have a valid proof\n"))

    def test_refuses_what_is_no_census(self):
        self.write("no.tsv", "hello\n")
        (self.folder / "torn.tsv.gz").write_bytes(b"\x1f\x8b\x08")
        self.run_program("census", *LISTS[:2], "--tsv", "two.tsv", "--quiet")
        for census, says, output in (("no.tsv", "no table", "x.tsv.gz"), ("none.tsv", "none.tsv", "x.tsv.gz"),
                                     ("torn.tsv.gz", "census_table:", "x.tsv.gz"),
                                     ("two.tsv", "no manifold", "x.tsv.gz"),
                                     ("two.tsv", ".tsv.gz", "x.tsv")):
            made = self.make(census, "--without", "two.tsv", "-o", output, "--proofs", "p")
            self.assertEqual(made.returncode, 2)
            self.assertIn(says, made.stderr)
            self.assertNotIn("Traceback", made.stderr)
        self.assertFalse((self.folder / "x.tsv.gz").exists())
        made = self.make("two.tsv", "-o", "absent/x.tsv.gz", "--proofs", "p")  # before the proofs
        self.assertEqual((made.returncode, made.stdout), (2, ""))
        self.assertIn("there is no folder absent", made.stderr)
        self.assertFalse((self.folder / "p").exists())

    def test_says_that_a_census_has_no_manifold(self):
        self.write("list", "eLAkbbcddpuchf\n")
        self.run_program("census", "--from", "list", "--tsv", "none.tsv", "--quiet")
        made = self.make("none.tsv", "-o", "x.tsv.gz", "--proofs", "p")
        self.assertEqual((made.returncode, made.stderr), (2, "census_table: none.tsv has no manifold\n"))


class Dask(ProgramTest):
    """scripts/cluster/dask_census.py; that it makes a census is tested in tests/cluster."""

    def test_refuses_what_it_cannot_do(self):
        script = Path(__file__).resolve().parents[2] / "scripts/cluster/dask_census.py"
        self.write("list", "cPcbbbihq\n")
        for arguments, says in ((("none", "2", "--local", "1"), "there is no list none"),
                                (("list", "0", "--local", "1"), "shards"),
                                (("list", "2", "--local", "0"), "--local"), (("list", "2"), "--local")):
            made = subprocess.run([sys.executable, script, *arguments], cwd=self.folder, text=True,
                                  env=dict(os.environ, TRIPUS=str(self.command()[0])),
                                  capture_output=True, check=False)
            self.assertEqual(made.returncode, 2, made.stderr)
            self.assertIn(says, made.stderr)
            self.assertNotIn("Traceback", made.stderr)


class Cusps(ProgramTest):
    def census(self, links, *sizes):
        lists = []
        for size in sizes:
            self.run_program("enumerate", str(size), "--links", links, "-o", f"{links}{size}")
            lists += ["--from", f"{links}{size}"]
        result = self.run_program("census", *lists, "--tsv", "-", "--quiet")
        self.assertEqual(result.status, 0, result.err)
        return list(csv.DictReader((line for line in result.text.splitlines()
                                    if not line.startswith("#")), delimiter="\t"))

    def table(self, name):
        return list(csv.DictReader((line for line in (DATA / name).read_text().splitlines()
                                    if not line.startswith("#")), delimiter="\t"))

    def test_alone_are_those_of_another_census(self):
        """Of SnapPy: up to three tetrahedra, each of its triangulations in a manifold of its own."""
        manifolds = self.census("cusped", 1, 2, 3)
        theirs = [row for row in self.table("cusped-census-5.tsv")
                  if row["orientable"] == "yes" and int(row["tetrahedra"]) <= 3]
        of = {name: row for row in manifolds for name in row["triangulations"].split()}
        self.assertEqual(len(theirs), 11)
        self.assertEqual({of[row["isosig"]]["name"] for row in theirs},
                         {row["name"] for row in manifolds})
        for row in theirs:
            self.assertAlmostEqual(float(of[row["isosig"]]["volume"]), float(row["volume"]), 10)
            self.assertEqual(of[row["isosig"]]["tetrahedra"], row["tetrahedra"])

    def test_beside_boundary_are_as_many_as_published(self):
        found = collections.Counter((row["tetrahedra"], row["boundary"])
                                    for row in self.census("mixed", 3, 4))
        self.assertEqual(found, {("3", "g2+T"): 1, ("4", "g3+T"): 12, ("4", "g2+T"): 18,
                                 ("4", "g2+T+T"): 1})
        shipped = self.run_program("census", "--in", str(DATA / "census-mixed-5.tsv.gz"), "--tsv", "-")
        self.assertEqual(shipped.status, 0, shipped.err)
        self.assertIn(" 942 manifolds", shipped.text.split("\n")[0])


class Package(ProgramTest):
    def test_wants_a_name_of_a_package(self):
        script = Path(__file__).resolve().parents[2] / "scripts/census_package"
        for name in ("a b", "../x", "1", ""):
            made = subprocess.run([sys.executable, script, "list.tsv", "--name", name, "--program",
                                   self.command()[0]], cwd=self.folder, capture_output=True, text=True,
                                  check=False)
            self.assertEqual(made.returncode, 2)
            self.assertIn("--name", made.stderr)

    def test_holds_the_census(self):
        """scripts/census_package: the wheel is the same each time, and its functions answer."""
        script = Path(__file__).resolve().parents[2] / "scripts/census_package"
        self.run_program("census", *LISTS, "--tsv", "list.tsv")
        wheels = []
        for into in ("a", "b"):
            made = subprocess.run([sys.executable, script, self.folder / "list.tsv", "--name",
                                   "census-of-three", "--into", self.folder / into, "--program",
                                   self.command()[0]], check=True, capture_output=True, text=True)
            wheels.append(Path(made.stdout.strip()))
        self.assertEqual(wheels[0].read_bytes(), wheels[1].read_bytes())
        with zipfile.ZipFile(wheels[0]) as archive:
            self.assertIsNone(archive.testzip())
            archive.extractall(self.folder / "site")
        asked = subprocess.run(
            [sys.executable, "-c", "import census_of_three as c; e = c.find('cPcbbbihq-')\n"
             "print(len(c.manifolds()), len(c.manifolds(tetrahedra=2)), e.name, e.boundary, "
             "c.find(c.triangulations(e)[0]) == e, c.find('cPcbbbiht'), "
             "len(c.manifolds(boundary='g3', volume=(10, 11))))"],
            cwd=self.folder / "site", check=True, capture_output=True, text=True).stdout
        self.assertEqual(asked.split(), ["158", "8", "t2g2.8", "g2", "True", "None", "74"])
