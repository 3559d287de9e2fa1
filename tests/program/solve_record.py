"""The short record of `solve`: fields, separated by tabs."""

from support import DATA, ProgramTest, read_json

LIST = str(DATA / "triangulations-3.txt")


class Record(ProgramTest):
    def records(self, *arguments, status=0):
        result = self.run_program("solve", *arguments, "--format", "tsv")
        self.assertEqual(result.status, status, result.err)
        header, *lines = result.text.split("\n")[:-1]
        names = header.split("\t")
        rows = [line.split("\t") for line in lines]
        self.assertTrue(all(len(row) == len(names) for row in rows))
        return [dict(zip(names, row)) for row in rows]

    def test_says_what_the_json_says(self):
        every = ("input,signature,tetrahedra,edges,links,outcome,certificate,volume,curvature,shortest,"
                 "longest,least-angle,largest-angle,condition")
        records = self.records("--batch", LIST, "--fields", every)
        reports = list(map(read_json, self.run_program(
            "solve", "--batch", LIST, "--json").text.splitlines()))
        self.assertEqual(len(records), 240)
        self.assertEqual(len(reports), 240)
        for record, report in zip(records, reports):
            self.assertEqual(record["input"], report["input"])
            self.assertEqual(record["signature"], report["input"])
            self.assertEqual(record["tetrahedra"], "3")
            self.assertEqual(record["outcome"], report["outcome"])
            found = report["outcome"] == "geometric"
            for field in ("volume", "curvature", "shortest", "longest", "least-angle", "largest-angle",
                          "condition"):
                self.assertEqual(record[field] != "", found, field)
            if not found:
                self.assertIn(record["certificate"], ("none", "semi"))
                continue
            self.assertEqual(float(record["volume"]), report["volume"])
            lengths = report["edge_lengths"]
            self.assertEqual(float(record["shortest"]), min(lengths))
            self.assertEqual(float(record["longest"]), max(lengths))
            angles = [angle for tetrahedron in report["dihedral_angles"] for angle in tetrahedron]
            self.assertEqual(float(record["least-angle"]), min(angles))
            self.assertEqual(float(record["largest-angle"]), max(angles))
            self.assertGreaterEqual(float(record["condition"]), 1)
        self.assertEqual(records, self.records("--batch", LIST, "--fields", every, "--threads", "1"))

    def test_of_what_cannot_be_read_is_refused(self):
        self.write("list", "cPcbbbihq\nbanana\ncPcbbbiht\n")
        result = self.run_program("solve", "--batch", "list", "--format", "tsv")
        self.assertEqual(result.text.split("\n")[2], "banana\trefused\t")
        self.assertIn("line 2:", result.err)
        self.assertIn("banana", result.err)
        records = self.records("--batch", "list", "--fields", "outcome,links,condition")
        self.assertEqual([list(each.values())[:2] for each in records],
                         [["geometric", "g2"], ["refused", ""], ["geometric", "T"]])
        self.assertEqual(records[2]["condition"], "")  # with a cusp the Hessian has a kernel
        self.assertEqual(self.records("cPcbbbihq")[0]["outcome"], "geometric")
        self.assertEqual(self.run_program("solve", "banana", "--format", "tsv").status, 2)

    def test_says_how_a_search_ended(self):
        fields = ("--fields", "outcome,search", "--retriangulate", "--budget", "5")
        self.write("list", "cPcbbbihq\ndLQbcbcaekw\n")
        self.assertEqual([tuple(each.values()) for each in self.records("--batch", "list", *fields)],
                         [("geometric", ""), ("unresolved", "not hyperbolic")])

    def test_has_a_record_for_every_line(self):
        self.write("list", "cPcbbbihq\n-\n# a comment\n\nnowhere/file\ncPcbbbiht\n")
        records = self.records("--batch", "list")
        self.assertEqual([(each["input"], each["outcome"]) for each in records],
                         [("cPcbbbihq", "geometric"), ("-", "refused"), ("nowhere/file", "refused"),
                          ("cPcbbbiht", "geometric")])

    def test_wants_fields_that_there_are(self):
        for arguments, says in (
                (("--format", "csv"), "tsv"), (("--format", "tsv", "--fields", "colour"), "colour"),
                (("--format", "tsv", "--fields", ""), "there is no field"),
                (("--format", "tsv", "--fields", "volume,"), "there is no field"),
                (("--format", "tsv", "--fields", "volume,volume"), "twice"),
                (("--fields", "volume"), "--format"), (("--format", "tsv", "--json"), "--json"),
                (("--format", "tsv", "--prove"), "--prove"),
                (("--format", "tsv", "--angle-structure"), "--angle-structure"),
                (("--format", "tsv", "--components"), "--components")):
            result = self.run_program("solve", "cPcbbbihq", *arguments)
            self.assertEqual(result.status, 2, arguments)
            self.assertIn(says, result.err + result.text)
            if "--json" not in arguments:  # there the error is an answer
                self.assertEqual(result.text, "")
