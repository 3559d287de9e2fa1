"""What is refused: exit status 2, the place in the message, nothing else on standard output."""

import json
import os

import samples
from support import DATA, TRIPUS, ProgramTest


def tripus_json(old="", new=""):
    """The gluing table of the tripus with one piece of its text exchanged."""
    text = samples.as_json(samples.TRIPUS_GLUINGS)
    assert old in text
    return text.replace(old, new, 1)


class AnotherPython(ProgramTest):
    def test_what_is_no_python_is_named(self):
        for program in ("/bin/false", "/bin/true", "/bin/cat", "no-such-program"):
            with self.subTest(program):
                environment = {**os.environ, "TRIPUS_PYTHON": program}
                result = self.run_program("hyperbolic", TRIPUS, env=environment)
                self.assertEqual((result.status, result.out), (3, b""))
                self.assertIn(f'TRIPUS_PYTHON="{program}"', result.err)
                self.assertIn("name a Python 3.11 or newer", result.err)

    def test_answers_go_on_only_in_a_batch(self):
        self.write("list", TRIPUS + "\n")
        for arguments in ((TRIPUS, "--json"), ("--batch", "list")):
            result = self.run_program("hyperbolic", *arguments, "--resume", "answers")
            self.assertEqual(result.status, 2)
            self.assertIn("--resume requires", result.err)


class InstructionSets(ProgramTest):
    """TRIPUS_SIMD chooses the kernels (geometry/README.md)."""

    def say(self, name, *arguments):
        return self.run_program(*arguments, env={**os.environ, "TRIPUS_SIMD": name})

    def test_are_named_where_a_name_is_none(self):
        self.write("list", f"{TRIPUS}\n{TRIPUS}\n")
        for name in ("avx1024", "AVX2", "none", " "):
            for arguments in (("solve", TRIPUS), ("solve", "--batch", "list"), ("info", TRIPUS)):
                with self.subTest(name, arguments=arguments):
                    result = self.say(name, *arguments)
                    self.assertEqual((result.status, result.out), (2, b""))
                    self.assertIn(f'TRIPUS_SIMD is "{name}"; this processor runs portable', result.err)
                    self.assertEqual(result.err.count("\n"), 1)

    def test_give_the_same_answers(self):
        listed = self.say("?", "solve", TRIPUS).err.split("runs ")[1].split(".")[0].split(", ")
        self.assertEqual(listed[0], "portable")
        inputs = (DATA / "triangulations-4.txt").read_text().splitlines()[::50]
        self.write("list", "\n".join(inputs))

        def answers(name):
            result = self.say(name, "solve", "--batch", "list", "--json", "--threads", "1")
            found = [json.loads(line) for line in result.lines]
            for answer in found:
                answer.pop("seconds", None)
            return found

        fastest = answers("")
        self.assertGreater(len(fastest), 200)
        for name in listed:
            with self.subTest(name):
                self.assertEqual(answers(name), fastest)


class Signatures(ProgramTest):
    CASES = [
        ("cPcbbb", "character 7: the signature ends here"),
        ("cPc", "expected 3 destinations"),
        ("c", "the header announces 2 tetrahedra"),
        ("c3c", "character 2: face action 3"),
        ("cPcbbbihz", "character 9: permutation number 25"),
        ("cPcbdbihq", "character 5: a gluing to tetrahedron 3"),
        ("bkaahi", "glued already or declared open"),
        ("cPcbbbihqq", "character 10"),
        ("a", "no tetrahedra"),
        ("zzzz", "the header announces 25 tetrahedra"),
        ("cPcb!bihq", "neither a file nor an isomorphism signature"),
        ("hello, world", "neither a file nor an isomorphism signature"),
        ("no/such/file.json", "neither a file nor an isomorphism signature"),
        ("\u00e9\u20ac", "neither a file nor an isomorphism signature"),
        ("", "the input is empty"),
        ("-l" + "a" * 100, "numbers of 11 characters"),
        ("-k" + "-" * 100, "the header announces 1152921504606846975"),
    ]

    def test_are_refused_with_their_place(self):
        for signature, says in self.CASES:
            with self.subTest(signature):
                answer = self.assert_refused("info", signature, says=says, kind="invalid-input")
                self.assertEqual(answer["input"], signature)
                self.assert_refused("solve", signature, says=says)


class Links(ProgramTest):
    """A 3-sphere and others of their kind: what does not know finite vertices refuses them, and solve
    what no metric can have."""

    CASES = [
        ("bkaagj", "unsupported", "this is a finite vertex, and the canonical decomposition"),
        ("bkaagb", "unsupported", "this is a finite vertex, and the canonical decomposition"),
        ("cMcabbgqs", "unsupported", "this is a finite vertex, and the canonical decomposition"),
        ("bkaahd", "invalid-input", "its own reverse"),
        ("bkaagd", "invalid-input", "its own reverse"),
    ]

    def test_are_refused_by_name(self):
        for signature, kind, says in self.CASES:
            with self.subTest(signature):
                self.assert_refused("canonize", signature, says=says, kind=kind)
        for signature, kind, says in self.CASES[-2:]:
            self.assert_refused("solve", signature, says=says, kind=kind)


class Files(ProgramTest):
    CASES = {
        "empty": ("", "the input is empty"),
        "blank": (" \n\t\r\n", "the input is empty"),
        "comments": ("# nothing\n# else\n", ""),
        "prose": ("the knotted Y\n", "no format that is known"),
        "gzip": (b"\x1f\x8b\x08\x00", "compressed data are"),
        "zeros": (b"\0" * 1000, "no format that is known"),
        "signature with a zero": (b"cPcbb\0bihq", "no format that is known"),
        "two signatures": ("cPcbbbihq\ncPcbbbiht\n", "holds 2 inputs; give it to --batch"),
        "bad signature": ("cPcbbb\n", "character 7"),
        "json syntax": ('{"gluings": [}', "syntax error at byte 14"),
        "json end": (tripus_json()[:-5], "syntax error at byte"),
        "json other": ('{"name": "x"}', 'an array "gluings"'),
        "json array": ("[1, 2]", "numbers alone do not say what they are"),
        "json number": ('{"gluings": 3}', 'an array "gluings"'),
        "json empty": ('{"gluings": []}', "no tetrahedra"),
        "json name": (tripus_json('"tripus"', "7"), '"name" is'),
        "json row": ('{"gluings": [3]}', "tetrahedron 0"),
        "json short row": ('{"gluings": [[null, null, null]]}', "tetrahedron 0"),
        "json face": (tripus_json('[1, "0321"]', "5"), "face 2 of tetrahedron 0"),
        "json neighbour": (tripus_json('[1, "0321"]', '[7, "0321"]'),
                           'face 2 of tetrahedron 0: tetrahedron "7"; expected 0 to 1'),
        "json negative": (tripus_json('[1, "0321"]', '[-1, "0321"]'), "face 2 of tetrahedron 0"),
        "json fraction": (tripus_json('[1, "0321"]', '[1.5, "0321"]'), "face 2 of tetrahedron 0"),
        "json large": (tripus_json('[1, "0321"]', '[1e999, "0321"]'), "JSON"),
        "json word": (tripus_json('[0, "3012"]', '[0, "3013"]'), "face 1 of tetrahedron 1: perm"),
        "json no word": (tripus_json('[0, "3012"]', "[0, 3012]"), "face 1 of tetrahedron 1"),
        "json one-sided": (tripus_json('[0, "3012"]', '[0, "3021"]'), "face 1 of tetrahedron 1"),
        "json open": (tripus_json('[1, "0321"]', "null"), "of tetrahedron 0 is open"),
        "json itself": ('{"gluings": [[[0, "0213"], null, null, null]]}', "glued to itself"),
        "json deep": ("[" * 200000, "nested more than 32 levels deep"),
        "json deep objects": ('{"a":' * 200000, "nested more than 32 levels deep"),
        "json not utf8": (b'{"gluings": "\xff"}', "JSON"),
        "orb": ("% orb\nx\n", 'expected "% orb"'),
        "snappea short": ("% Triangulation\nx\n", "the number of tetrahedra is missing"),
        "snappea huge": ("% Triangulation\nx\n99999999999\n", "line 3"),
        "snappea missing": ("% Triangulation\nx\n1\n0 0 0 0\n", "tetrahedron 0 is missing"),
        "snappea neighbour": (samples.as_snappea(samples.TRIPUS_GLUINGS).replace("1 1 1 1",
                                                                                 "1 1 9 1"),
                              'line 10: face 2 of tetrahedron 0: neighbour "9"'),
        "snappea permutation": (samples.as_snappea(samples.TRIPUS_GLUINGS).replace("0213", "0212"),
                                "line 11: face 3 of tetrahedron 0: permutation"),
        "regina nothing": ("<regina></regina>", "no 3-manifold triangulation"),
        "regina cut": ('<tri dim="3"><simplex> -1 0 -1 0 -1 0 -1 0', "not closed"),
        "table row": ("Tet | glued to: (012) (013) (023) (123)\n 1 | 0 (012)\n", "line 2"),
        "table entry": (samples.as_regina_table(samples.TRIPUS_GLUINGS).replace("(", "[", 6),
                        "line"),
    }

    def test_are_refused_with_their_name_and_place(self):
        for name, (content, says) in self.CASES.items():
            with self.subTest(name):
                self.write(name, content)
                answer = self.assert_refused("solve", name, says=says, kind="invalid-input")
                self.assertEqual(answer["input"], name)
                self.assertIn(name, self.run_program("info", "--batch", "-", "--json",
                                                     stdin=name).text)

    def test_are_refused_on_standard_input(self):
        for name, (content, says) in self.CASES.items():
            with self.subTest(name):
                self.assert_refused("info", "-", stdin=content, says=says)

    def test_folder(self):
        (self.folder / "folder").mkdir()
        self.assert_refused("info", "folder", says='"folder" is a folder')
        self.assert_refused("info", "--batch", "folder", says='"folder" is a folder')
        self.assert_refused("solve", TRIPUS, "--initial-lengths", "folder", says="is a folder")
        self.write("lengths", b"\x00\x01\xff 0.7\n")
        self.assert_refused("solve", TRIPUS, "--initial-lengths", "lengths",
                            says="a binary file and holds no lengths")

    def test_batch_that_is_not_there(self):
        self.assert_refused("info", "--batch", "none.txt", says='cannot open "none.txt": No such')

    def test_garbage_of_fifty_megabytes(self):
        for block in (b"x", b"{", b"[", b"<", b"% ", b"\0", b"\n", b"Tet | glued to: ", b"# "):
            with self.subTest(block):
                self.write("garbage", (block * 50_000_000)[:50_000_000])
                result = self.run_program("info", "garbage", "--json")
                self.assertEqual(result.status, 2)
                self.assertEqual(result.text.count("\n"), 1)
                self.assertLess(len(result.out), 1000)


class Options(ProgramTest):
    CASES = [
        (["--initial", "-1"], "--initial"), (["--initial", "0"], "--initial"),
        (["--initial", "nan"], "--initial"), (["--initial", "inf"], "--initial"),
        (["--initial", "1e999"], "--initial"), (["--initial", "1e-999"], "--initial"),
        (["--initial", "one"], "--initial"), (["--initial", "0x10"], "--initial"),
        (["--initial", ""], "--initial"), (["--initial", "1,5"], "--initial"),
        (["--tolerance", "0"], "--tolerance"), (["--tolerance", "-1e-9"], "--tolerance"),
        (["--tolerance", "nan"], "--tolerance"), (["--tolerance", "inf"], "--tolerance"),
        (["--max-iterations", "-1"], "--max-iterations"),
        (["--max-iterations", "1.5"], "--max-iterations"),
        (["--max-iterations", "99999999999"], "--max-iterations"),
        (["--time-limit", "0"], "--time-limit"), (["--time-limit", "-3"], "--time-limit"),
        (["--time-limit", "nan"], "--time-limit"),
        (["--threads", "-1"], "--threads"), (["--threads", "2000"], "--threads"),
        (["--threads", "two"], "--threads"),
        (["--method", "simplex"], 'there is no method "simplex"; the methods are auto, newton'),
        (["--method", ""], "there is no method"), (["--method", "flow:"], "there is no method"),
        (["--method", "flow:curvature/euler/rk4"], "there is no method"),
        (["--method", "angles:angles:newton"], "there is no method"),
        (["--method", "newton\x1b[2J"], "\\x1b"),
        (["--cone-angle", "0"], 'write EDGE=ANGLE'), (["--cone-angle", "=1"], "write EDGE=ANGLE"),
        (["--cone-angle", "x=1"], "write EDGE=ANGLE"),
        (["--cone-angle", "-1=1"], "write EDGE=ANGLE"),
        (["--cone-angle", "18446744073709551616=1"], "write EDGE=ANGLE"),
        (["--cone-angle", "1=2pi"], "only the edge classes 0 to 0"),
        (["--cone-angle", "0="], "is not an angle"), (["--cone-angle", "0=two"], "is not an angle"),
        (["--cone-angle", "0=nan"], "is not an angle"),
        (["--cone-angle", "0=1e999"], "is not an angle"),
        (["--cone-angle", "0=2pi/0"], "is not an angle"),
        (["--cone-angle", "0=2pi3"], "is not an angle"),
        (["--cone-angle", "0=1,1=2"], "only the edge classes 0 to 0"),
        (["--cone-angle", "0=-1"], "a cone angle is not negative"),
        (["--cone-angle", "0=pi", "--cone-angle", "0=1"], "edge class 0 has a label already"),
        (["--cone-order", "0=2,0=3"], "edge class 0 has a label already"),
        (["--cone-order", "0=2", "--cone-angle", "0=1"], "edge class 0 has a label already"),
        (["--cone-order", "1=2"], "only the edge classes 0 to 0"),
        (["--cone-order", "0"], "write EDGE=ORDER"), (["--cone-order", "0="], "not a cone order"),
        (["--cone-order", "0=1.5"], "not a cone order"), (["--cone-order", "0=-2"], "not a cone order"),
        (["--cone-order", "0=nan"], "not a cone order"),
        (["--cone-angle", "0=40"], "carries no metric of positive curvature"),
        (["--cone-angle", "0=-pi"], "is not an angle"),
        (["--initial", "1", "--initial-lengths", "x"], "--initial"),
        (["--initial-lengths", "none"], 'cannot open "none"'),
        (["--batch", "list"], "--batch"),
        (["--history", "h", "--components"], "--components"),
        (["--unknown"], "--unknown"), (["another"], "another"), (["--Json"], "--Json"),
    ]

    def test_are_refused_by_name(self):
        for options, says in self.CASES:
            with self.subTest(options):
                self.assert_refused("solve", TRIPUS, *options, says=says)

    def test_without_their_value(self):
        result = self.run_program("solve", TRIPUS, "--json", "--initial")
        self.assertEqual(result.status, 2)
        self.assertIn("--initial", result.err)

    def test_a_value_that_is_missing_is_called_so(self):
        for option in ("--batch", "--initial", "--cone-order"):
            result = self.run_program("solve", TRIPUS, option)
            self.assertEqual(result.status, 2)
            self.assertIn(f"{option}: its value is missing", result.err)

    def test_that_a_verb_does_not_have(self):
        self.assert_refused("info", TRIPUS, "--method", "newton", says="--method")
        self.assert_refused("methods", TRIPUS, says=TRIPUS)

    def test_missing_input(self):
        self.assert_refused("solve", says="INPUT or --batch FILE is required")
        self.assert_refused("info", "--threads", "2", says="INPUT or --batch FILE is required")

    def test_missing_and_wrong_verbs(self):
        for verb in ("slove", "helps", "SOLVE", TRIPUS):
            self.assert_refused(verb, says=f'there is no verb "{verb}"; the verbs are info, solve')
        result = self.run_program()
        self.assertEqual((result.status, result.out), (2, b""))
        self.assertIn("Usage: tripus VERB", result.err)

    def test_history_of_a_batch(self):
        self.write("list", TRIPUS)
        self.assert_refused("solve", "--batch", "list", "--history", "h", says="--history")

    def test_standard_input_twice(self):
        self.assert_refused("solve", "-", "--initial-lengths", "-", says="standard input")


class Lengths(ProgramTest):
    CASES = {
        "empty": ("", "holds no numbers"), "comment": ("# 1\n", "holds no numbers"),
        "word": ("1 2\none\n", 'line 2: "one" is not a number'),
        "overflow": ("1e999\n", 'line 1: "1e999" is not a number'),
        "hexadecimal": ("0x1p3", "is not a number"), "signs": ("+-1", "is not a number"),
        "infinite": ("inf", "initial length 0 is inf"), "nan": ("nan", "initial length 0 is nan"),
        "zero": ("0", "initial length 0 is 0"), "tiny": ("-1e-30", "initial length 0 is -1e-30"),
        "two": ("1 2", "2 initial lengths for 1 edge classes"),
        "zeros": (b"\0\0", "is a binary file"), "not utf8": (b"1\xff", "is not a number"),
        "json": ("[1", "syntax error at byte"), "json empty": ("[]", "holds no numbers"),
        "json overflow": ("[1e999]", "JSON"), "json word": ('[1, "2"]', "edge length 1 is not"),
        "json twice": ('{"edge_lengths": [1], "edge_lengths": [2]}', "occurs twice"),
        "json null": ("[null]", "edge length 0 is not a number"),
        "json object": ("{}", 'no "edge_lengths"'), "json list": ('{"edge_lengths": 1}', "array"),
        "json deep": ("[" * 200000, "nested more than 32"), "json not utf8": (b'{"\xff": 1}', "JSON"),
        "json error": (json.dumps({"error": {"kind": "internal"}}), 'no "edge_lengths"'),
    }

    def test_are_refused_with_their_place(self):
        for name, (content, says) in self.CASES.items():
            with self.subTest(name):
                self.write(name, content)
                self.assert_refused("solve", TRIPUS, "--initial-lengths", name, says=says)
