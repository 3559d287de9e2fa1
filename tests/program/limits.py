"""--time-limit: every verb, on an input that takes far longer, ends soon, says so, and tears nothing."""

import json
import random
import re
import shutil
import tempfile
from pathlib import Path

import samples
from support import DATA, TRIPUS, ProgramTest, read_json

OLD = "what was here before\n"
GRAPH = Path(__file__).resolve().parents[1] / "drawings" / "kinoshita-local-trefoil.json"

# Far more than the limits, and far less than the work would take: what would hang does.
PATIENCE = 60

#: Verb, seconds, arguments, and the file that is written.
TABLE = [
    ("info", 0.05, "huge.json", None),
    ("solve", 0.3, "huge.json --method flow:curvature/euler --tolerance 1e-15 -o out.json",
     "out.json"),
    ("simplify", 0.3, "large.json --effort 1000000 -o out.json", "out.json"),
    ("mesh", 0.3, "surface.off --tetrahedra 50000000 --save-mesh out.vtk", "out.vtk"),
    ("cover", 0.3, f"{TRIPUS} --degree 9 -o out.txt", "out.txt"),
    ("cover", 0.3, f"{TRIPUS} --cyclic 1000000 -o out.txt", "out.txt"),
    ("canonize", 0.3, "huge.json", None),
    ("compare", 0.3, "huge.json huge.json", None),
    ("identify", 0.3, "huge.json", None),
    ("enumerate", 0.3, "8 -o out.txt", "out.txt"),
    ("census", 0.3, "--from list --tsv out.tsv", "out.tsv"),
    ("census", 0.3, "--check", None),
    ("prove", 0.3, f"{TRIPUS} --digits 100000", None),
    ("check", 0.05, "proof.json large.json", None),
    ("study", 0.3, "convergence --covers 500,1000 -o folder", None),
    ("embed", 0.3, f"{TRIPUS} --cells 2000000 -o out.json", "out.json"),
    ("embed", 0.3, f"{TRIPUS} --radius 30 -o out.ply", "out.ply"),
    ("orthospectrum", 0.3, f"{TRIPUS} --length 20 --force --tsv out.tsv", "out.tsv"),
    ("view", 0.3, f"{TRIPUS} --cells 10000 --png out.png", "out.png"),
    ("parameterise", 0.3, "surface.off --tetrahedra 50000000 -o out.vtu", "out.vtu"),
    ("tube", 0.3, "graph.json --triangles 2000000 -o out.off", "out.off"),
    ("draw", 0.01, "braid -o out.svg", "out.svg"),
    ("table", 0.3, "all --compute --tsv out.tsv", "out.tsv"),
]


def is_whole(path):
    """A file of ours that is as long as its beginning says, or ends as such files do."""
    data = path.read_bytes()
    if data == OLD.encode():
        return True
    ends = {".svg": b"</svg>\n", ".png": b"IEND\xaeB`\x82", ".tsv": b"\n",
            ".txt": b"\n", ".vtu": b"</VTKFile>\n"}
    if path.suffix in ends:
        return data.endswith(ends[path.suffix])
    if path.suffix == ".json":
        return bool(json.loads(data))
    if path.suffix == ".ply":
        header, _, body = data.partition(b"end_header\n")
        points = int(re.search(rb"element vertex (\d+)", header)[1])
        return len(body) >= 12 * points
    return False


class TimeLimits(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.inputs = Path(tempfile.mkdtemp())
        for name, degree in (("huge", 100000), ("large", 4000)):
            (cls.inputs / f"{name}.json").write_text(samples.as_json(samples.tripus_cover(degree)))
        chance = random.Random(1)
        (cls.inputs / "braid").write_text("Braid: " + " ".join(
            str(chance.choice((1, -1)) * chance.randrange(1, 6)) for _ in range(990)))
        (cls.inputs / "list").write_text((DATA / "triangulations-4.txt").read_text())
        shutil.copy(GRAPH, cls.inputs / "graph.json")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.inputs)

    def setUp(self):
        super().setUp()
        for path in self.inputs.iterdir():
            (self.folder / path.name).symlink_to(path)

    def make_proof(self):
        result = self.run_program("prove", "large.json", "--json")
        self.write("proof.json", result.out)
        self.assertTrue(read_json(result.text)["proof"]["proved"])

    def run_limited(self, verb, seconds, arguments, *more):
        return self.run_program(verb, *arguments.split(), *more, "--time-limit", str(seconds),
                                timeout=PATIENCE)

    def test_every_verb_ends(self):
        self.run_program("tube", "graph.json", "-o", "surface.off", "--quiet")
        self.make_proof()
        for verb, seconds, arguments, output in TABLE:
            with self.subTest(verb, arguments=arguments):
                if output:
                    self.write(output, OLD)
                before = {path.name for path in self.folder.iterdir()}
                result = self.run_limited(verb, seconds, arguments)
                # `info` is done before it has to be, if all is read in time.
                if verb == "info" and result.status == 0:
                    continue
                self.assertEqual(result.status, 1, result.err)
                self.assertIn(f"the time limit of {seconds} s was reached", result.err)
                left = {path.name for path in self.folder.iterdir()} - before
                self.assertLessEqual(left, {"out.tsv.journal", "folder"})
                if output:
                    self.assertTrue(is_whole(self.folder / output), output)

    def test_table_is_complete(self):
        verbs = re.findall(r"(?m)^  ([a-z]+)  +\S", self.run_program("--help").text.split("Verbs:")[1]
                           .split("INPUT,")[0])
        self.assertGreater(len(verbs), 15)
        # `hyperbolic` gives its limit to Python, whose tests try it; `page` copies a file.
        self.assertEqual(set(verbs) - {"methods", "help", "hyperbolic", "page"},
                         {row[0] for row in TABLE})

    def test_is_an_error_of_its_own_for_programs(self):
        self.run_program("tube", "graph.json", "-o", "surface.off", "--quiet")
        result = self.run_limited("mesh", 0.3, "surface.off --tetrahedra 50000000", "--json")
        self.assertEqual(result.status, 1)
        self.assertEqual(read_json(result.text)["error"], {
            "kind": "time-limit", "message": "the time limit of 0.3 s was reached"})

    def test_is_of_each_line_of_a_batch(self):
        self.write("inputs", f"{TRIPUS}\n{TRIPUS}\n")
        for arguments in ("orthospectrum --length 20 --force --summary", "cover --degree 9"):
            result = self.run_program(*arguments.split(), "--batch", "inputs", "--json",
                                      "--time-limit", "0.3", timeout=PATIENCE)
            self.assertEqual(result.status, 0, result.err)
            for line in (1, 2):
                self.assertIn(f"line {line}: the time limit of 0.3 s was reached", result.err)
            answers = [read_json(line) for line in result.lines]
            self.assertGreaterEqual(len(answers), 2)
            if arguments.startswith("orthospectrum"):
                self.assertEqual([answer["end"] for answer in answers], ["time-limit"] * 2)

    def test_lets_a_census_go_on(self):
        lines = (DATA / "triangulations-3.txt").read_text().split()
        self.write("short", "\n".join(lines) + "\n")
        arguments = ("census", "--from", "short", "--tsv", "out.tsv")
        status, runs = 1, 0
        while status == 1:
            result = self.run_program(*arguments, "--time-limit", "0.01", timeout=PATIENCE)
            status = result.status
            runs += 1
        self.assertEqual(status, 0, result.err)
        limited = (self.folder / "out.tsv").read_bytes()
        self.run_program("census", "--from", "short", "--tsv", "whole.tsv")
        self.assertEqual(limited, (self.folder / "whole.tsv").read_bytes())

    def test_is_a_number_above_zero(self):
        for value in ("0", "-1", "nan", "many", ""):
            self.assertEqual(self.run_program("draw", "8_19", "--time-limit", value).status, 2)
        result = self.run_program("info", TRIPUS, "--time-limit", "1e300")
        self.assertEqual(result.status, 0)
