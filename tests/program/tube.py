"""tripus tube: surfaces from drawings, and what Tripus makes of them."""

import json

from support import DATA, TRIPUS_VOLUME, ProgramTest, read_json

GRAPHS = DATA.parent / "examples" / "graphs"
SURFACES = DATA.parent / "examples" / "surfaces"


def off_counts(text):
    words = text.split()
    assert words[0] == "OFF"
    return int(words[1]), int(words[2])


class Tube(ProgramTest):
    def test_writes_the_surface(self):
        run = self.run_program("tube", str(GRAPHS / "knotted-y.json"), "-o", "y.off",
                               "--triangles", "3000")
        self.assertEqual(run.status, 0, run.err)
        self.assertEqual(run.text, "")
        points, triangles = off_counts((self.folder / "y.off").read_text())
        self.assertEqual(points - triangles // 2, -2)  # Euler characteristic
        self.assertIn("1 component: genus 2", run.err)
        self.assertIn("tube of radius 0.25", run.err)

    def test_writes_to_standard_output_and_reads_standard_input(self):
        graph = (GRAPHS / "unknotted-theta.json").read_text()
        run = self.run_program("tube", "-", "-o", "-", "--quiet", "--triangles", "2000",
                               stdin=graph)
        self.assertEqual((run.status, run.err), (0, ""))
        points, triangles = off_counts(run.text)
        self.assertEqual(points - triangles // 2, 0)  # genus 2 and a sphere

    def test_json(self):
        run = self.run_program("tube", str(GRAPHS / "four-legs.json"), "-o", "f.off", "--json")
        self.assertEqual(run.status, 0, run.err)
        answer = read_json(run.text)
        self.assertEqual(list(answer), ["tripus", "input", "output", "triangle_count",
                                        "point_count", "genera", "radius", "thickest_radius",
                                        "largest_radius", "limited_by"])
        self.assertEqual(answer["genera"], [3])
        self.assertEqual((answer["point_count"], answer["triangle_count"]),
                         off_counts((self.folder / "f.off").read_text()))

    def test_radius_and_resolution(self):
        counts = []
        for options in (["--resolution", "6"], ["--resolution", "12"],
                        ["--resolution", "12", "--radius", "0.4"]):
            run = self.run_program("tube", str(GRAPHS / "knotted-theta.json"), "-o", "t.off",
                                   "--json", *options)
            self.assertEqual(run.status, 0, run.err)
            answer = read_json(run.text)
            counts.append(answer["triangle_count"])
        self.assertEqual(answer["radius"], 0.4)
        self.assertGreater(counts[1], 2 * counts[0])
        self.assertLess(counts[2], counts[1])

    def test_the_examples_are_made_by_the_commands_that_their_readme_names(self):
        for name in ("knotted-y", "knotted-theta"):
            self.run_program("tube", str(GRAPHS / f"{name}.json"), "--triangles", "3000", "-o",
                             "made.off")
            self.assertEqual((self.folder / "made.off").read_text(),
                             (SURFACES / f"{name}.off").read_text(), name)


class TubeErrors(ProgramTest):
    def fails(self, *arguments, status=2, says="", stdin=b""):
        run = self.run_program("tube", *arguments, stdin=stdin)
        self.assertEqual(run.status, status, run.err)
        self.assertIn(says, run.err)
        self.assertEqual(list(self.folder.glob("*.off")), [])
        return run

    def test_usage(self):
        self.fails(says="GRAPH")
        self.fails(str(GRAPHS / "knotted-y.json"), says="--output")
        self.fails("missing.json", "-o", "a.off", says="missing.json")
        for option, value in (("--radius", "0"), ("--radius", "nan"), ("--triangles", "-3"),
                              ("--triangles", "x"), ("--resolution", "0")):
            self.fails(str(GRAPHS / "knotted-y.json"), "-o", "a.off", option, value, says=option)
        self.fails(str(GRAPHS / "knotted-y.json"), "-o", "a.off", "--triangles", "5000",
                   "--resolution", "8", says="--resolution")

    def test_bad_graphs_name_the_place(self):
        touching = {"vertices": [[-1, 0, 0], [1, 0, 0]],
                    "edges": [[[-1, 0, 0], [1, 0, 0]], [[0, -1, 0], [0, 1, 0]]],
                    "outer": {"sphere": {"center": [0, 0, 0], "radius": 2}}}
        self.fails("-", "-o", "a.off", stdin=json.dumps(touching),
                   says="edge 0 segment 0 and edge 1 segment 0 touch")
        run = self.fails(str(GRAPHS / "knotted-y.json"), "-o", "a.off", "--radius", "0.6", "--json",
                         says="must not exceed 0.475")
        self.assertEqual(read_json(run.text)["error"]["kind"], "invalid-input")

    def test_json_and_surface_do_not_share_standard_output(self):
        self.fails(str(GRAPHS / "knotted-y.json"), "-o", "-", "--json", says="standard output")

    def test_a_place_that_cannot_be_written(self):
        self.fails(str(GRAPHS / "knotted-y.json"), "-o", "no/such/folder.off",
                   says='cannot write "no/such/folder.off": No such file')
        self.fails("missing.json", "-o", "no/such.off", says="cannot write")  # before all work

    def test_errors_name_the_file_and_nothing_of_the_library(self):
        for text, says in (('{"edges": [[[1e999, 0, 0]]]}', "must be finite"), ("{", "syntax"),
                           ('{"edges": 3}', "expected an array"), ('{"edges": []}', "")):
            (self.folder / "g.json").write_text(text)
            run = self.fails("g.json", "-o", "a.off", says='"g.json": ')
            self.assertIn(says, run.err)
            self.assertNotIn("exception", run.err)


DRAWINGS = DATA.parent / "tests" / "drawings"


class Pipes(ProgramTest):
    """Without wishes: few triangles, and the same manifolds."""

    def tube(self, path, *options):
        run = self.run_program("tube", str(path), "-o", "p.off", "--json", *options)
        self.assertEqual(run.status, 0, run.err)
        return read_json(run.text)

    def test_are_few(self):
        for path in sorted(GRAPHS.glob("*.json")) + sorted(DRAWINGS.glob("*.json")):
            answer = self.tube(path)
            self.assertLess(answer["triangle_count"], 700, path)
            self.assertLess(answer["radius"], answer["thickest_radius"], path)

    def test_have_the_metric_of_the_drawing(self):
        for path in (GRAPHS / "knotted-y.json", GRAPHS / "knotted-theta.json",
                     DRAWINGS / "repeated-point.json"):
            self.tube(path)
            answer = read_json(self.run_program("solve", "p.off", "--json").text)
            self.assertEqual(answer["isosig"], "cPcbbbihq", path)
            self.assertAlmostEqual(answer["volume"], TRIPUS_VOLUME, delta=1e-12)

    def test_are_thin_where_the_drawing_is_fine_and_nowhere_else(self):
        answer = self.tube(DRAWINGS / "kinoshita-local-trefoil.json")
        self.assertEqual(answer["genera"], [2, 0])
        self.assertLess(answer["radius"], 0.5)
        self.assertGreater(answer["thickest_radius"], 4)

    def test_of_two_wishes_the_round_tube_has_one_radius(self):
        answer = self.tube(GRAPHS / "unknotted-theta.json", "--radius", "0.3", "--triangles", "1000")
        self.assertEqual(answer["radius"], 0.3)
        self.assertEqual(answer["thickest_radius"], 0.3)


class TubeToMetric(ProgramTest):
    """From a drawing to the metric of what lies around it."""

    def solve(self, name):
        run = self.run_program("tube", str(GRAPHS / f"{name}.json"), "-o", "s.off",
                               "--triangles", "3000")
        self.assertEqual(run.status, 0, run.err)
        return self.run_program("solve", "s.off", "--json")

    def test_both_forms_of_the_knotted_y(self):
        for name in ("knotted-y", "knotted-theta"):
            answer = read_json(self.solve(name).text)
            self.assertEqual(answer["outcome"], "geometric", name)
            self.assertEqual(answer["isosig"], "cPcbbbihq")
            self.assertAlmostEqual(answer["volume"], TRIPUS_VOLUME, delta=1e-12)

    def test_four_legs_carry_a_metric_with_boundary_of_genus_3(self):
        answer = read_json(self.solve("four-legs").text)
        self.assertEqual(answer["outcome"], "geometric")
        self.assertEqual([v["genus"] for v in answer["vertices"]], [3])

    def test_an_unknotted_theta_carries_none(self):
        run = self.solve("unknotted-theta")
        self.assertEqual(run.status, 1, run.err)
        self.assertNotEqual(read_json(run.text)["outcome"], "geometric")

    def test_the_trefoil_is_a_cusp_without_a_metric(self):
        run = self.solve("trefoil")
        self.assertEqual(run.status, 1, run.err)
        answer = read_json(run.text)
        self.assertEqual([v["kind"] for v in answer["vertices"]], ["cusp"])
        self.assertIn(answer["outcome"], ("degenerate", "infeasible"))
        self.assertEqual(answer["certificate"]["kind"], "semi")
