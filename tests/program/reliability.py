"""What docs/reliability.md promises of outputs, damaged files and batches."""

import json
import sqlite3

from support import DATA, TRIPUS, ProgramTest, read_json

LIST = str(DATA / "triangulations-2.txt")


class Outputs(ProgramTest):
    def assert_refused(self, *arguments, kept, says):
        before = (self.folder / kept).read_bytes()
        result = self.run_program(*arguments)
        self.assertEqual(result.status, 2, arguments)
        self.assertIn(says, result.err)
        self.assertEqual((self.folder / kept).read_bytes(), before)

    def test_are_never_the_input(self):
        self.write("a.sig", TRIPUS + "\n")
        self.write("list", "a.sig\n")
        for arguments in (("simplify", "a.sig", "-o", "a.sig"), ("solve", "a.sig", "-o", "./a.sig"),
                          ("solve", "a.sig", "--history", "a.sig"),
                          ("cover", "a.sig", "--degree", "2", "-o", "a.sig"),
                          ("cover", "--batch", "list", "--degree", "2", "-o", "list"),
                          ("census", "--from", "a.sig", "--tsv", "a.sig"),
                          ("census", "--from", "a.sig", "--journal", "a.sig", "--tsv", "-")):
            kept = "list" if "list" in arguments[-1:] else "a.sig"
            self.assert_refused(*arguments, kept=kept, says="would write over")

    def test_are_two_files(self):
        self.write("out", "old")
        for arguments in (("census", "--from", LIST, "--tsv", "out", "--database", "out"),
                          ("solve", TRIPUS, "-o", "out.json", "--history", "out.json")):
            result = self.run_program(*arguments)
            self.assertEqual(result.status, 2)
            self.assertIn("would both write", result.err)

    def test_of_a_bad_input_stay(self):
        self.write("out", "old")
        self.assertEqual(self.run_program("cover", "banana", "--degree", "2", "-o", "out").status, 2)
        self.assertEqual((self.folder / "out").read_text(), "old")


class Damage(ProgramTest):
    def test_in_a_table_is_named(self):
        self.run_program("census", "--from", LIST, "--tsv", "t.tsv")
        whole = (self.folder / "t.tsv").read_text()
        lines = whole.splitlines(keepends=True)
        for text, says in ((whole.replace("6.45199", "6.45198", 1), "line 3"),
                           ("".join(lines[:4]), "line 1"), ("".join(lines[:4] + lines[5:]), "lines")):
            self.write("t.tsv", text)
            result = self.run_program("census", "--in", "t.tsv")
            self.assertEqual((result.status, result.out), (2, b""))
            self.assertIn(says, result.err)
            self.assertIn("t.tsv", result.err)

    def test_in_a_database_is_named(self):
        self.run_program("census", "--from", LIST, "--database", "t.sqlite")
        with sqlite3.connect(self.folder / "t.sqlite") as database:
            database.execute("UPDATE manifold SET homology = '3 Z' WHERE rowid = 2")
        result = self.run_program("census", "--in", "t.sqlite")
        self.assertEqual((result.status, result.out), (2, b""))
        self.assertIn("row 2", result.err)

    def test_another_budget_is_other_work(self):
        self.run_program("census", "--from", LIST, "--journal", "j", "--budget", "0", "--tsv", "-")
        result = self.run_program("census", "--from", LIST, "--journal", "j", "--tsv", "-")
        self.assertEqual((result.status, result.out), (2, b""))
        self.assertIn("budget 0", result.err)


class Batches(ProgramTest):
    def test_go_on(self):
        lines = (DATA / "triangulations-2.txt").read_text().split()
        self.write("list", "\n".join([lines[0], "banana", *lines]) + "\n")
        for verb in ("info", "canonize", "solve"):
            whole = self.run_program(verb, "--batch", "list", "--json").lines
            for cut in (0, 1, 3, len(whole)):
                text = "".join(line + "\n" for line in whole[:cut])
                self.write("out", text + (whole[cut][:30] if cut < len(whole) else ""))
                result = self.run_program(verb, "--batch", "list", "--json", "--resume", "out")
                self.assertEqual((result.status, result.out), (0, b""))
                again = (self.folder / "out").read_text().splitlines()
                self.assertEqual([self.plain(line) for line in again],
                                 [self.plain(line) for line in whole])

    @staticmethod
    def plain(line):
        answer = read_json(line)
        for key in ("seconds", "checksum"):  # --resume adds the second
            answer.pop(key, None)
        return json.dumps(answer)

    def test_answers_that_were_changed_or_asked_otherwise_are_refused(self):
        self.write("list", f"{TRIPUS}\n{TRIPUS}\n")
        arguments = ("solve", "--batch", "list", "--json", "--resume", "out")
        self.assertEqual(self.run_program(*arguments).status, 0)
        whole = (self.folder / "out").read_text()
        self.assertEqual(self.run_program(*arguments, "--threads", "2", "--quiet").status, 0)
        for options in (("--max-iterations", "1"), ("--method", "newton")):
            result = self.run_program(*arguments, *options)
            self.assertEqual(result.status, 2)
            self.assertIn("line 1 was changed, or was answered with other options", result.err)
        second = whole.index("\n") + 1
        for at in range(second + 60, len(whole) - 2, 17):
            digit = "1" if whole[at] != "1" else "2"
            self.write("out", whole[:at] + digit + whole[at + 1:])
            result = self.run_program(*arguments)
            self.assertEqual(result.status, 2, whole[at - 9:at + 9])
            self.assertIn("line 2", result.err)

    def test_of_covers_go_on(self):
        self.write("list", f"{TRIPUS}\nbanana\n{TRIPUS}\n")
        arguments = ("cover", "--batch", "list", "--degree", "3", "--json", "--resume", "out")
        self.run_program(*arguments)
        whole = (self.folder / "out").read_text()
        for cut in range(0, len(whole), 997):
            self.write("out", whole[:cut])
            self.assertEqual(self.run_program(*arguments).status, 0)
            self.assertEqual((self.folder / "out").read_text(), whole)

    def test_do_not_go_on_with_another(self):
        self.write("list", f"{TRIPUS}\n")
        for text in ('{"tripus": "0.1.0", "input": "banana"}\n', "x\n", '{"tripus": "0.0.1"}\n'):
            self.write("out", text)
            result = self.run_program("info", "--batch", "list", "--json", "--resume", "out")
            self.assertEqual(result.status, 2)
            self.assertIn("line 1", result.err)
            self.assertEqual((self.folder / "out").read_text(), text)
