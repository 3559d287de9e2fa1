"""The texts that a new user meets."""

from support import ProgramTest

VERBS = ["info", "solve", "simplify", "mesh", "cover", "canonize", "compare", "identify", "enumerate",
         "census", "prove", "hyperbolic", "check", "study", "embed", "orthospectrum", "view", "tube", "draw",
         "table", "page", "methods"]


class Help(ProgramTest):
    def help_of(self, *arguments):
        result = self.run_program(*arguments, "--help")
        self.assertEqual((result.status, result.err), (0, ""))
        return result.text

    def test_of_the_program_lists_the_verbs(self):
        text = self.help_of()
        for verb in VERBS:
            self.assertRegex(text, rf"(?m)^  {verb} +\S")
        for words in ("Usage: tripus VERB", "INPUT", "Exit status", "geodesic boundary"):
            self.assertIn(words, text)

    def test_of_every_verb(self):
        for verb in VERBS:
            text = self.help_of(verb)
            self.assertIn(f"Usage: tripus {verb}", text)
            self.assertEqual(text, self.run_program(verb, "-h").text)

    def test_by_the_verb_help(self):
        self.assertEqual(self.run_program("help").text, self.help_of())
        for verb in VERBS:
            result = self.run_program("help", verb)
            self.assertEqual((result.status, result.err), (0, ""))
            self.assertEqual(result.text, self.help_of(verb))
        self.assertEqual(self.run_program("help", "banana").status, 2)

    def test_of_solve_lists_the_documented_options(self):
        text = self.help_of("solve")
        for option in ("--json", "--batch FILE", "--threads N", "--quiet", "--method NAME",
                       "--initial X", "--initial-lengths FILE", "--tolerance X",
                       "--max-iterations N", "--time-limit S", "--cone-angle EDGE=ANGLE",
                       "--history FILE", "--components"):
            self.assertIn(f"  {option}", text)
        for outcome in ("geometric", "degenerate", "infeasible", "unresolved"):
            self.assertIn(f"  {outcome} ", text)

    def test_fits_a_page(self):
        for arguments in [[]] + [[verb] for verb in VERBS]:
            for line in self.help_of(*arguments).splitlines():
                self.assertLessEqual(len(line), 100, line)
                self.assertNotRegex(line, "TEXT|FLOAT|UINT|Excludes")

    def test_version(self):
        result = self.run_program("--version")
        self.assertEqual((result.status, result.err), (0, ""))
        self.assertRegex(result.text, r"^tripus \d+\.\d+\.\d+\n$")
        self.assertEqual(self.json_answer("methods")["tripus"], result.text.split()[1])
