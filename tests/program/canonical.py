"""tripus canonize, compare, identify and census."""

import json
import re
import sqlite3

from support import DATA, TRIPUS, ProgramTest

# The same homology, boundary and volume, and not homeomorphic.
OTHER = "cPcbbbdhq"
AMPHICHEIRAL = "cMcabbjdw"
# A triangulation without a metric of its own, of a manifold with three tetrahedra.
WITHOUT_METRIC = "eLAkbccdddprdk"


class Canonize(ProgramTest):
    def test_json(self):
        answer = self.json_answer("canonize", TRIPUS)
        self.assertEqual(answer["outcome"], "geometric")
        self.assertAlmostEqual(answer["volume"], 6.451990270835033, delta=1e-12)
        self.assertEqual(answer["decomposition"], "2 tetrahedra")
        self.assertEqual([cell["type"] for cell in answer["cells"]], ["tetrahedron"] * 2)
        self.assertEqual(answer["signature"], TRIPUS)
        self.assertIn(answer["oriented_signature"], (TRIPUS + "+", TRIPUS + "-"))
        group = answer["isometry_group"]
        self.assertEqual((group["order"], group["orientation_preserving"]), (6, 6))
        self.assertIs(group["amphicheiral"], False)
        self.assertTrue(group["generators"])
        self.assertGreater(answer["tilts"]["margin"], 1)

    def test_moves_to_the_metric_first(self):
        answer = self.json_answer("canonize", WITHOUT_METRIC)
        self.assertEqual(answer["decomposition"], "3 tetrahedra")
        self.assertTrue(answer["path"])

    def test_signature_is_an_input(self):
        signature = self.json_answer("canonize", WITHOUT_METRIC)["signature"]
        self.assertEqual(self.json_answer("canonize", signature)["signature"], signature)


class Compare(ProgramTest):
    def compared(self, first, second):
        result = self.run_program("compare", first, second, "--json")
        return result.status, json.loads(result.text)

    def test_verdicts(self):
        status, answer = self.compared(TRIPUS, OTHER)
        self.assertEqual((status, answer["verdict"], answer["decided_by"]),
                         (1, "different", "decomposition"))
        self.assertIsNone(answer["isometry"])
        status, answer = self.compared(AMPHICHEIRAL, AMPHICHEIRAL)
        self.assertEqual((status, answer["verdict"]), (0, "homeomorphic"))
        self.assertTrue(answer["keeps_orientation"] and answer["reverses_orientation"])
        self.assertEqual(sorted(answer["isometry"]["cells"]), [0, 1])
        status, answer = self.compared(TRIPUS, WITHOUT_METRIC)
        self.assertEqual((status, answer["verdict"], answer["decided_by"]),
                         (1, "different", "volume"))

    def test_usage(self):
        self.assertEqual(self.run_program("compare", TRIPUS).status, 2)
        self.assertEqual(self.run_program("compare", TRIPUS, "nonsense!").status, 2)


class Census(ProgramTest):
    def test_identify(self):
        answer = self.json_answer("identify", WITHOUT_METRIC)
        self.assertRegex(answer["census"]["name"], r"^t3g2\.\d+$")
        self.assertIn(WITHOUT_METRIC, answer["census"]["triangulations"])

    def test_queries_of_the_shipped_census(self):
        def count(*arguments):
            return len(self.run_program("census", *arguments).text.splitlines())

        self.assertEqual(count(), 5295)
        self.assertEqual(count("--tetrahedra", "4", "--boundary", "g4"), 2340)
        self.assertEqual(count("--cells", "1 octahedron"), 78 + 2)
        self.assertEqual(count("--volume", "6.4:6.5"), 8)
        self.assertEqual(self.run_program("census", "--volume", "6").status, 2)

    def test_make_and_resume(self):
        list_file = str(DATA / "triangulations-3.txt")
        whole = self.run_program("census", "--from", list_file, "--tsv", "-", "--quiet").text
        # Eight of them have triangulations with two tetrahedra, which are not in this list.
        names = [line.split("\t")[0] for line in whole.splitlines() if line.startswith("t")]
        self.assertEqual([len([n for n in names if n.startswith(t)]) for t in ("t2", "t3")], [8, 150])
        # The journal of an interrupted run: some lines, the last of them torn.
        journal = self.folder / "j"
        self.run_program("census", "--from", list_file, "--journal", str(journal), "--tsv", "-")
        lines = journal.read_text().splitlines(keepends=True)
        self.assertEqual(len(lines), 1 + 240)
        self.assertIn("budget 20", lines[0])
        journal.write_text("".join(lines[:101]) + lines[101][:20])
        again = self.run_program("census", "--from", list_file, "--journal", str(journal),
                                 "--tsv", "-", "--threads", "1")
        self.assertEqual(again.text, whole)
        self.assertIn("100 known from an earlier run", again.err)
        self.assertEqual(sorted(journal.read_text().splitlines(keepends=True)), sorted(lines))

    def test_database(self):
        path = str(self.folder / "census.sqlite")
        list_file = str(DATA / "triangulations-2.txt")
        result = self.run_program("census", "--from", list_file, "--database", path)
        self.assertEqual(result.status, 0)
        with sqlite3.connect(path) as database:
            (count,), = database.execute("SELECT count(*) FROM manifold")
            (joined,), = database.execute(
                "SELECT count(*) FROM triangulation JOIN manifold ON manifold = name")
        self.assertEqual((count, joined), (8, 8))
        self.assertEqual(self.run_program("census", "--tetrahedra", "2", "--boundary", "g2",
                                          "--database", "two").out, b"")
        self.assertEqual(self.run_program("census", "--in", "two").text,
                         self.run_program("census", "--in", path).text)
        listed = self.run_program("census", "--in", path).text
        self.assertEqual(listed, self.run_program("census", "--tetrahedra", "2",
                                                  "--boundary", "g2").text)

    def test_from_table_to_database_and_back(self):
        table = DATA / "census.tsv"
        everything = self.run_program("census", "--tsv", "-").text
        for arguments, text in ((("--in", str(table)), table.read_text()), ((), everything)):
            result = self.run_program("census", *arguments, "--database", "census.sqlite")
            self.assertEqual((result.status, result.out, result.err), (0, b"", ""))
            back = self.run_program("census", "--in", "census.sqlite", "--tsv", "-").text
            self.assertEqual(back, text)
            with sqlite3.connect(self.folder / "census.sqlite") as database:
                (count,), = database.execute("SELECT count(*) FROM unresolved")
                verdicts = dict(database.execute(
                    "SELECT isosig, hyperbolic FROM hyperbolicity"))
            self.assertEqual(count, 4915)
            # By the package's own tests, which know more: a "no" here is one there.
            rows = [line.split("\t") for line in
                    (DATA / "hyperbolicity.tsv").read_text().splitlines()[2:]]
            known = {row[1]: row for row in rows if row[0] in "234"}
            if not arguments:  # the triangulations of manifolds with cusps are not in that table
                cusped = {signature for line in text.splitlines()
                          if not line.startswith("#") and re.search("[TK]", line.split("\t")[2])
                          for signature in line.split("\t")[-1].split()}
                self.assertEqual({verdicts.pop(signature) for signature in cusped}, {"yes"})
            self.assertEqual(set(verdicts), set(known))
            words = {"true": "yes", "false": "no"}
            for isosig, verdict in verdicts.items():
                self.assertIn(verdict, (words[known[isosig][2]], None), isosig)
                if known[isosig][4] == "closed bigon" or known[isosig][2] == "true":
                    self.assertIsNotNone(verdict, isosig)
        for query in (("--volume", "10:10.5"), ("--boundary", "g3", "--homology", "3 Z"),
                      ("--tetrahedra", "3")):
            self.assertEqual(self.run_program("census", "--in", "census.sqlite", *query).text,
                             self.run_program("census", *query).text)

    def test_nothing_found_is_said(self):
        for arguments in (("--boundary", "g9"), ("--homology", "7 Z"), ("--tetrahedra", "5"),
                          ("--volume", "100:200"), ("--cells", "1 cube"), ("--tetrahedra", "0")):
            for more in ((), ("--json",), ("--tsv", "x.tsv"), ("--database", "x.sqlite")):
                result = self.run_program("census", *arguments, *more)
                self.assertEqual((result.status, result.out), (1, b""))
                self.assertIn("tripus: nothing found: the census has 5295 manifolds", result.err)
        self.assertEqual(list(self.folder.glob("x.*")), [])

    def test_what_is_no_query_is_refused(self):
        for arguments in (("--boundary", "banana"), ("--boundary", ""), ("--boundary", "g1"),
                          ("--homology", "banana"), ("--homology", ""), ("--cells", "banana"),
                          ("--cells", ""), ("--volume", "10:6"), ("--volume", "nan:7"),
                          ("--volume", "6:nan"), ("--volume", "6"), ("--volume", "x:7"),
                          ("--volume", "inf:"), ("--tetrahedra", "many"), ("--tetrahedra", "-1")):
            result = self.run_program("census", *arguments)
            self.assertEqual((result.status, result.out), (2, b""), arguments)
            self.assertIn(arguments[0], result.err)

    def test_free_spelling(self):
        for text in ("2 Z + Z_3", "2Z+Z_3", "Z^2+Z/3", "z_3+2z"):
            self.assertEqual(len(self.run_program("census", "--homology", text).lines), 19)
        for text in ("g3", "3", "Genus 3"):
            self.assertEqual(len(self.run_program("census", "--boundary", text).lines), 2108)
        self.assertEqual(len(self.run_program("census", "--cells", "Octahedra").lines), 78 + 2)

    def test_names_belong_to_one_manifold(self):
        # Of six tetrahedra: not in the shipped census.
        other = self.run_program("cover", TRIPUS, "--degree", "3").text.split()[0]
        self.write("list", f"{TRIPUS}\n{other}\n")
        self.assertEqual(self.run_program("census", "--from", "list", "--tsv", "own.tsv").status, 0)
        shipped = {line.split()[0]: line.split()[-1]
                   for line in self.run_program("census").lines}
        for line in self.run_program("census", "--in", "own.tsv", "--json").lines:
            entry = json.loads(line)
            self.assertEqual(shipped.get(entry["name"], entry["signature"]), entry["signature"])
            if entry["name"] not in shipped:
                self.assertEqual(entry["tetrahedra"], 6)
                self.assertEqual(entry["name"], entry["signature"])
                self.assertEqual(self.run_program("info", entry["name"]).status, 0)
        self.assertEqual(self.run_program("identify", TRIPUS, "--in", "own.tsv").status, 0)
        self.assertEqual(self.run_program("identify", AMPHICHEIRAL, "--in", "own.tsv").status, 1)

    def test_lists_hold_what_every_batch_takes(self):
        self.run_program("simplify", TRIPUS, "-o", "tripus.json")
        self.write("list", f"tripus.json\nt2g2.2  # by name\r\n{OTHER}+\nnonsense!\n")
        result = self.run_program("census", "--from", "list", "--tsv", "-")
        self.assertEqual(result.status, 0)
        self.assertEqual(len([line for line in result.lines if line.startswith("t2g2")]), 3)
        self.assertIn("list: line 4: ", result.err)
        self.assertIn("1 refused", result.err)
        for text in ("nonsense!\nno.json\n", "# nothing\n", "bkaagj\n"):
            self.write("list", text)
            result = self.run_program("census", "--from", "list", "--tsv", "x.tsv")
            self.assertEqual((result.status, result.out), (2, b""), text)
            self.assertFalse((self.folder / "x.tsv").exists())

    def test_a_query_makes_no_census(self):
        list_file = str(DATA / "triangulations-2.txt")
        result = self.run_program("census", "--from", list_file, "--boundary", "g2")
        self.assertEqual((result.status, result.out), (2, b""))
        self.assertEqual(self.run_program("census", "--journal", "j").status, 2)

    def test_foreign_files_are_left_alone(self):
        list_file = str(DATA / "triangulations-2.txt")
        for text in ("cPcbbbihq\n", "cPcbbbihq", "a\tb\n"):
            self.write("journal", text)
            self.assert_refused("census", "--from", list_file, "--journal", "journal", "--tsv", "-",
                                says="name another file")
            self.assertEqual((self.folder / "journal").read_text(), text)
