"""Diagrams as INPUT, tripus draw and tripus table."""

import json
import re
import xml.etree.ElementTree

from support import ProgramTest, TRIPUS_VOLUME, read_json

FIGURE_EIGHT = "PD: X[4,2,5,1] X[8,6,1,5] X[6,3,7,4] X[2,7,3,8]"


class Diagrams(ProgramTest):
    def solved(self, diagram):
        run = self.run_program("solve", diagram, "--json")
        self.assertEqual(run.status, 0, run.err)
        return read_json(run.text)

    def test_a_knot_as_text_and_by_name(self):
        for diagram in (FIGURE_EIGHT, "4_1", "Braid: 1 -2 1 -2", "DT: 4 6 8 2"):
            self.assertAlmostEqual(self.solved(diagram)["volume"], 2.029883212819307, 12)

    def test_handlebody_knots_and_theta_curves_by_name(self):
        for name in ("hk5_3", "5_1 theta", "T5_1"):
            self.assertAlmostEqual(self.solved(name)["volume"], TRIPUS_VOLUME, 12)

    def test_mirror_images_by_name(self):
        # hk5_3 is chiral; 4_1 is not, and hk6_7 neither.
        for one, two, words in (
                ("hk5_3", "hk5_3m", "as mirror images"),
                ("m(hk5_3)", "hk5_3*", "keeping the given orientations"),
                ("m(m(hk5_3))", "hk5_3", "keeping the given orientations"),
                ("L5a1", "L5a1m", "as mirror images"),
                ("4_1", "mirror 4_1", "with either orientation"),
                ("hk6_7", "hk6_7 mirror", "with either orientation")):
            run = self.run_program("compare", one, two)
            self.assertEqual(run.status, 0, run.err)
            self.assertIn(f"Homeomorphic, {words}", run.text)
        self.write("list.txt", "m(5_1 theta)\n")
        self.write("name.txt", "5_1m theta\n")
        answers = self.run_program("info", "--batch", "list.txt", "--json").lines
        text = self.run_program("draw", "name.txt", "--pd").text
        signatures = {read_json(answers[0])["oriented_isosig"]}
        for name in ("T5_1m", "name.txt", text.strip()):
            signatures.add(self.json_answer("info", name)["oriented_isosig"])
        self.assertEqual(len(signatures), 1)
        self.assertNotIn(self.json_answer("info", "5_1 theta")["oriented_isosig"], signatures)

    def test_files_of_all_forms(self):
        forms = {
            "text.pd": FIGURE_EIGHT,
            "lists.txt": "[[4,2,5,1], [8,6,1,5],\n [6,3,7,4], [2,7,3,8]]\n",
            "diagram.json": json.dumps({"name": "eight", "diagram": [
                ["X", [4, 2, 5, 1]], ["X", [8, 6, 1, 5]], [6, 3, 7, 4], [2, 7, 3, 8]]}),
            "name.txt": "4_1\n",
        }
        for name, text in forms.items():
            (self.folder / name).write_text(text)
            self.assertAlmostEqual(self.solved(name)["volume"], 2.029883212819307, 12)

    def test_a_batch_of_diagrams(self):
        (self.folder / "list.txt").write_text(f"{FIGURE_EIGHT}\nhk5_3\nhk9_9\n8_19 # a torus knot\n")
        run = self.run_program("info", "--batch", "list.txt", "--json")
        rows = [read_json(line) for line in run.lines]
        self.assertEqual([row.get("isosig") for row in rows[:2]], ["cPcbbbiht", "cPcbbbihq"])
        self.assertIn("the nearest names there are hk", rows[2]["error"]["message"])
        self.assertEqual([v["genus"] for v in rows[3]["vertices"]], [1])

    def test_a_knot_that_is_not_hyperbolic_gets_an_answer(self):
        run = self.run_program("solve", "8_19")
        self.assertEqual(run.status, 1)
        self.assertIn("8_19", run.text + run.err)

    def test_errors_name_the_place(self):
        for text, message in (
                ("PD: V[1,6,11]", "arc 1 is named once"),
                ("PD: X[4,2,5,1", "is not closed"),
                ("hk9_9", "there is no \"hk9_9\" in the tables"),
                ("10_1", "is a SnapPy name"),
                ("PD: X[1,2,1,2]", "cannot be drawn in the plane")):
            run = self.run_program("info", text)
            self.assertEqual(run.status, 2)
            self.assertIn(message, run.err)

    def test_spellings_that_people_bring(self):
        nodes = FIGURE_EIGHT[len("PD: "):]
        trefoil = {"X_{1425} X_{3641} X_{5263}", "X1425 X3641 X5263", "3_1", "trefoil", "BR[2, {1,1,1}]",
                   "Gauss: 1 -2 3 -1 2 -3", "[4, 6, 2]", "knot { ^ ^ ; | X | ; | X | ; | X | ; U U ; }"}
        eight = {"PD: PD[" + nodes.replace("] X", "], X") + "]", "pd = " + nodes.lower(), "Figure-eight knot",
                 "{{4,2,5,1},{8,6,1,5},{6,3,7,4},{2,7,3,8}}", "PD Clockwise: " + nodes}
        for texts, signatures in ((trefoil, {"cPcbbbadh", "cPcbbbadu"}), (eight, {"cPcbbbiht"})):
            for text in texts:
                run = self.run_program("info", text, "--json")
                self.assertEqual(run.status, 0, run.err)
                self.assertIn(read_json(run.text)["isosig"], signatures, text)

    def test_slips_are_not_passed_over(self):
        for text, message in (
                ('{"diagram": [["V",[1,1]]], "cone_order": {"1": 3}}', "is no key of a diagram"),
                ('{"diagram": [["V",[1,1]]], "clockwise": "yes"}', "write true or false"),
                ("PD: X[4,2,5,1 X[8,6,1,5]", "add ] before"),
                ("m(8_19", "is not closed; add ) at the end"),
                ("hk5_9m", "the nearest names there are hk5_"),
                ("K4a1", "the nearest names there are 4_1"),
                ("4^2_1", "the nearest names there are L4a1"),
                ("morse { ^ ; U ; }", "it is the contour of a surface")):
            run = self.run_program("info", text)
            self.assertEqual(run.status, 2, text)
            self.assertIn(message, run.err)

    def test_strands_are_drilled_out_again(self):
        kept = FIGURE_EIGHT + " Cone[1,4]"
        answer = self.json_answer("simplify", kept, "--drill", "singular")
        self.assertEqual((answer["isosig"], answer["stages"]["drilled"]), ("cPcbbbiht", 7))
        # An arc from the cusp to itself: a boundary of genus 2 is left.
        answer = self.json_answer("simplify", "4_1", "--drill", "0")
        self.assertEqual(answer["isosig"], self.json_answer("simplify", "4_1", "--drill", "0,0")["isosig"])
        for arguments, message in (
                ((kept,), "singular edges"),
                ((kept, "--drill", "9"), "expected an edge class from 0 to"),
                ((kept, "--drill", "x"), "expected an edge class"),
                ((kept, "--drill", "0"), "would lose it"),
                (("4_1", "--drill", "singular"), "no edge has a cone order")):
            run = self.run_program("simplify", *arguments)
            self.assertEqual(run.status, 2)
            self.assertIn(message, run.err)

    def test_a_piece_that_touches_nothing_is_told(self):
        run = self.run_program("info", FIGURE_EIGHT + " V[21,22] V[21,22]")
        self.assertEqual(run.status, 0)
        self.assertIn("arcs 21 and 22 form a piece of their own", run.err)


class Draw(ProgramTest):
    def test_pictures_are_well_formed_and_have_gaps(self):
        for name, crossings in (("8_19", 8), ("hk6_9", 6), ("L6a4", 6), ("0_1 theta", 0)):
            run = self.run_program("draw", name, "-o", "picture.svg")
            self.assertEqual((run.status, run.err), (0, ""))
            root = xml.etree.ElementTree.parse(self.folder / "picture.svg").getroot()
            paths = [p.get("d") for p in root.iter("{http://www.w3.org/2000/svg}path")]
            # Each under-strand lifts the pen once.
            self.assertEqual(sum(p.count("M") for p in paths), len(paths) + crossings)
            self.assertNotRegex("".join(paths), "nan|inf")
            self.assertEqual(root.find("{http://www.w3.org/2000/svg}title").text, name)

    def test_arcs_have_their_numbers_if_asked(self):
        run = self.run_program("draw", "hk6_9", "--arcs")
        texts = xml.etree.ElementTree.fromstring(run.text).iter("{http://www.w3.org/2000/svg}text")
        named = re.findall(r"\d+", self.run_program("draw", "hk6_9", "--pd").text[len("PD:"):])
        self.assertEqual(sorted(text.text for text in texts), sorted(set(named)))
        for other in ("--pd", "--polylines"):
            self.assertEqual(self.run_program("draw", "hk6_9", "--arcs", other).status, 2)

    def test_the_drawing_in_space_becomes_the_same_manifold(self):
        run = self.run_program("draw", "hk5_3", "--polylines", "-o", "space.json")
        self.assertEqual(run.status, 0, run.err)
        run = self.run_program("tube", "space.json", "-o", "space.off", "--quiet")
        self.assertEqual(run.status, 0, run.err)
        mesh = read_json(self.run_program("mesh", "space.off", "--json").text)
        info = read_json(self.run_program("info", "hk5_3", "--json").text)
        self.assertEqual(mesh["oriented_isosig"], info["oriented_isosig"])

    def test_diagrams_are_written_as_text(self):
        run = self.run_program("draw", "4_1", "--pd")
        again = self.run_program("draw", run.text.strip(), "--pd")
        self.assertEqual(run.text, again.text)

    def test_what_is_no_diagram_is_refused(self):
        run = self.run_program("draw", "cPcbbbihq")
        self.assertEqual(run.status, 2)
        self.assertIn("is no diagram", run.err)


class Table(ProgramTest):
    def test_lists_what_is_known(self):
        run = self.run_program("table", "handlebody-knots")
        self.assertEqual((run.status, len(run.lines)), (0, 90))
        self.assertRegex(run.text, r"hk5_3 .*6\.451990270835\d* *\* isometries 6 \+ 0")
        self.assertRegex(run.text, r"(?m)^hk6_2 .*= 6_4 handcuff, hk7_10$")

    def test_knots_have_isometries_too(self):
        run = self.run_program("table", "knots", "4_1")
        self.assertRegex(run.text, r"4_1 .*volume 2\.02988321\d* +\* isometries 4 \+ 4")
        rows = read_json(self.run_program("table", "links", "L5a1", "--json").text)["rows"]
        self.assertEqual(rows[0]["same_as"], ["L7n2", "L8n2", "L9n3"])
        self.assertEqual(rows[0]["isometry_group"]["order"], 8)

    def test_a_database_is_replaced_whole(self):
        self.write("k.sqlite", "what stood there before")
        run = self.run_program("table", "knots", "4_1", "--database", "k.sqlite")
        self.assertEqual(run.status, 0, run.err)
        self.assertTrue((self.folder / "k.sqlite").read_bytes().startswith(b"SQLite format 3"))

    def test_json_has_diagrams(self):
        rows = read_json(self.run_program("table", "theta-curves", "5_1 theta", "--json").text)["rows"]
        self.assertEqual([row["name"] for row in rows], ["5_1 theta"])
        self.assertEqual(rows[0]["tetrahedron_count"], 2)
        self.assertEqual(rows[0]["diagram"][0], ["V", [1, 6, 11]])

    def test_other_formats(self):
        run = self.run_program("table", "knots", "4_1", "3_1", "--tsv", "k.tsv", "--page", "k.html",
                               "--database", "k.sqlite")
        self.assertEqual((run.status, run.text), (0, ""))
        self.assertEqual(len((self.folder / "k.tsv").read_text().splitlines()), 3)
        page = (self.folder / "k.html").read_text()
        self.assertEqual(len(re.findall("<svg", page)), 2)
        self.assertTrue((self.folder / "k.sqlite").read_bytes().startswith(b"SQLite format 3"))

    def test_unknown_tables_and_names(self):
        self.assertEqual(self.run_program("table", "braids").status, 2)
        run = self.run_program("table", "knots", "4_7")
        self.assertEqual(run.status, 2)
        self.assertIn("nearest names", run.err)
        run = self.run_program("table", "knots", "5_1 theta")
        self.assertEqual(run.status, 2)
        self.assertIn('is in another table: tripus table theta-curves "5_1 theta"', run.err)

    def test_names_of_mirror_images(self):
        run = self.run_program("table", "handlebody-knots", "hk5_3m")
        self.assertEqual(run.status, 0)
        self.assertEqual(run.text, self.run_program("table", "handlebody-knots", "hk5_3").text)
        self.assertIn('"hk5_3m" is the mirror image of hk5_3', run.err)

    def test_slips_get_the_nearest_names(self):
        for name, nearest in (("Knot[8,19]", "8_19"), ("!4_1", "4_1"), ("4_1!", "4_1"),
                              ("5_1 tehta", "5_1 theta"), ("Knot[8,77]", "8_7")):
            for verb in ("info", "draw"):
                run = self.run_program(verb, name)
                self.assertEqual(run.status, 2)
                self.assertIn(f"the nearest names there are {nearest}", run.err)


class DiagramHabits(ProgramTest):
    EIGHT = "PD: X[4,2,5,1] X[8,6,1,5] X[6,3,7,4] X[2,7,3,8]"

    def test_quotes_in_a_list(self):
        self.write("list", "'5_1 theta'\n\"hk5_3\"\n4_1\n")
        result = self.run_program("solve", "--batch", "list", "--json")
        self.assertEqual(result.status, 0, result.err)
        self.assertEqual([line.count('"outcome": "geometric"') for line in result.lines], [1] * 3)

    def test_labels_stay_in_the_text(self):
        text = self.run_program("draw", self.EIGHT + " Cone[1,4]", "--pd").text
        self.assertIn("Cone[1,4]", text)
        self.write("labelled.pd", text)
        volume = self.json_answer("solve", "labelled.pd")["volume"]
        self.assertAlmostEqual(volume, 0.5074708031, delta=1e-9)

    def test_pictures_are_svg(self):
        result = self.run_program("draw", "hk5_3", "-o", "x.png")
        self.assertEqual(result.status, 2)
        self.assertIn("ends with .svg", result.err)
        self.assertFalse((self.folder / "x.png").exists())

    def test_short_names_in_a_table(self):
        result = self.run_program("table", "theta-curves", "5_1")
        self.assertEqual(result.status, 0, result.err)
        self.assertIn("5_1 theta", result.text)
