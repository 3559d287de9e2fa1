"""tripus orthospectrum: the JSON, the text, the files, bad input, interruption."""

import json
import math
import signal
import subprocess
import time
import xml.etree.ElementTree as ElementTree

import samples
from support import TRIPUS, TRIPUS_LENGTH, TRIPUS_VOLUME, ProgramTest, read_json

WITHOUT_METRIC = "dLQbcbcaekw"
NON_ORIENTABLE = "dLQbccchrqg"


class OrthospectrumJson(ProgramTest):
    def test_keys_and_the_shortest_arcs(self):
        answer = self.json_answer("orthospectrum", TRIPUS, "--length", "6")
        self.assertEqual(list(answer), [
            "tripus", "input", "isosig", "tetrahedron_count", "edge_count", "orientable",
            "edge_valences", "length", "end", "arc_count", "shortest_return_path", "arcs", "area",
            "volume", "dimension", "dimension_uncertainty", "return_time",
            "return_time_uncertainty", "return_time_square", "return_time_square_uncertainty"])
        self.assertEqual((answer["length"], answer["end"], answer["arc_count"]),
                         (6, "complete", 527))
        arcs = answer["arcs"]
        self.assertEqual(list(arcs[0]), ["length", "multiplicity", "ends", "edge", "edges"])
        self.assertEqual([arc["multiplicity"] for arc in arcs[:8]], [1, 4, 12, 12, 12, 6, 24, 48])
        self.assertEqual(sum(arc["multiplicity"] for arc in arcs), 527)
        self.assertAlmostEqual(arcs[0]["length"], TRIPUS_LENGTH, delta=1e-13)
        self.assertEqual((arcs[0]["edge"], arcs[1]["edge"]), (0, None))
        self.assertEqual(answer["shortest_return_path"], arcs[0]["length"])
        self.assertAlmostEqual(answer["volume"]["exact"], TRIPUS_VOLUME, delta=1e-12)
        area = answer["area"]
        self.assertAlmostEqual(area["exact"], 4 * math.pi, delta=1e-12)
        self.assertAlmostEqual(area["counted"] + area["tail"], area["exact"],
                               delta=area["tail_uncertainty"])
        by_hand = sum(arc["multiplicity"] * 8 * math.pi / math.expm1(2 * arc["length"])
                      for arc in arcs)
        self.assertAlmostEqual(area["counted"], by_hand, delta=1e-10)

    def test_ends_are_boundary_components(self):
        answer = self.json_answer("orthospectrum", NON_ORIENTABLE, "--length", "4")
        components = {v for arc in answer["arcs"] for v in arc["ends"]}
        self.assertEqual(components, {0})
        self.assertFalse(answer["orientable"])

    def test_words(self):
        answer = self.json_answer("orthospectrum", TRIPUS, "--count", "40", "--words")
        for arc in answer["arcs"]:
            self.assertEqual(len(arc["words"]), arc["multiplicity"])
            for word in arc["words"]:
                self.assertEqual(list(word), ["start", "faces", "end"])
                self.assertEqual(list(word["start"]), ["tetrahedron", "vertex", "foot"])
                self.assertLess(math.hypot(*word["end"]["foot"]), 1)
                if word["faces"]:
                    # The first face is opposite to the vertex where the arc begins.
                    self.assertEqual(word["faces"][0], word["start"]["vertex"])
                self.assertEqual(word["faces"] == [], arc["edge"] is not None)

    def test_canonical_edges(self):
        answer = self.json_answer("orthospectrum", TRIPUS, "--count", "5", "--canonical")
        self.assertEqual([arc["canonical_edges"] for arc in answer["arcs"]], [1, 0])

    def test_few_arcs_have_no_estimates(self):
        answer = self.json_answer("orthospectrum", TRIPUS, "--length", "0.1")
        self.assertEqual(answer["arcs"], [])
        self.assertIsNone(answer["shortest_return_path"])
        for key in ("dimension", "return_time"):
            self.assertIsNone(answer[key])
        self.assertIsNone(answer["area"]["tail"])

    def test_threads_change_nothing(self):
        one, two = (self.run_program("orthospectrum", TRIPUS, "--length", "7", "--words", "--json",
                                     "--threads", n).text for n in "12")
        self.assertEqual(one, two)

    def test_a_batch_answers_each_line(self):
        name = self.write("list.txt", f"{TRIPUS}\nnonsense\n{NON_ORIENTABLE}\n")
        result = self.run_program("orthospectrum", "--batch", name, "--json", "--count", "5")
        self.assertEqual(result.status, 0)
        answers = [read_json(line) for line in result.lines]
        self.assertEqual([("error" in answer) for answer in answers], [False, True, False])

    def test_summary_has_sums_without_arcs(self):
        whole = self.json_answer("orthospectrum", TRIPUS, "--length", "7")
        sums = self.json_answer("orthospectrum", TRIPUS, "--length", "7", "--summary")
        self.assertEqual(sums["arcs"], [])
        for key in ("arc_count", "shortest_return_path", "area", "volume", "dimension"):
            self.assertEqual(sums[key], whole[key])


class OrthospectrumText(ProgramTest):
    def test_table_and_sums(self):
        result = self.run_program("orthospectrum", TRIPUS, "--length", "6")
        self.assertEqual((result.status, result.err), (0, ""))
        self.assertIn("0.596133894890", result.text)
        self.assertIn("edge 0", result.text)
        self.assertIn("527 up to length 6", result.text)
        self.assertIn("limit set", result.text)

    def test_default_is_the_hundred_shortest(self):
        answer = self.json_answer("orthospectrum", TRIPUS)
        self.assertGreaterEqual(answer["arc_count"], 100)
        self.assertLess(answer["arc_count"] - answer["arcs"][-1]["multiplicity"], 100)

    def test_table_of_arcs(self):
        self.run_program("orthospectrum", TRIPUS, "--length", "5", "--tsv", "arcs.tsv")
        lines = (self.folder / "arcs.tsv").read_text().splitlines()
        rows = [dict(zip(lines[0].split("\t"), line.split("\t"))) for line in lines[1:]]
        answer = self.json_answer("orthospectrum", TRIPUS, "--length", "5")
        self.assertEqual(len(rows), answer["arc_count"])
        for row in rows:
            length = float(row["length"])
            self.assertAlmostEqual(float(row["disc_radius"]),
                                   -math.log(math.tanh(length / 2)), delta=1e-12)
            self.assertEqual(row["faces"] == "-", row["edge"] != "-")

    def test_pictures_are_svg(self):
        result = self.run_program("orthospectrum", TRIPUS, "--length", "6.5", "--picture",
                                  "spots.svg", "--plot", "plot.svg")
        self.assertEqual((result.status, result.err), (0, ""))
        spots = ElementTree.parse(self.folder / "spots.svg").getroot()
        self.assertGreater(len(spots.findall(".//{*}circle")), 500)
        # Eight tiles drawn strongly: the fundamental domain.
        strong = [group for group in spots.findall("{*}g") if group.get("stroke-width") == "1.3"]
        self.assertEqual(len(strong[0].findall("{*}path")), 8)
        plot = ElementTree.parse(self.folder / "plot.svg").getroot()
        self.assertEqual(len(plot.findall("{*}path")), 1)


class OrthospectrumProofs(ProgramTest):
    def test_proved_lengths(self):
        answer = self.json_answer("orthospectrum", TRIPUS, "--length", "5", "--prove")
        self.assertIs(answer["proved"], True)
        for arc in answer["arcs"]:
            lower, upper = arc["proved_length"]
            self.assertLessEqual(lower, upper)
            self.assertAlmostEqual(lower, arc["length"], delta=1e-12)
            self.assertLess(upper - lower, 1e-13)
        result = self.run_program("orthospectrum", TRIPUS, "--length", "5", "--prove", "--tsv",
                                  "arcs.tsv")
        self.assertEqual(result.text.count("proved to within"), len(answer["arcs"]))
        self.assertIn("not that there are no others", result.text)
        lines = (self.folder / "arcs.tsv").read_text().splitlines()
        self.assertTrue(lines[0].endswith("\tproved_from\tproved_to"))
        self.assertEqual(len(lines), 1 + answer["arc_count"])
        for line in lines[1:]:
            cells = line.split("\t")
            self.assertLessEqual(float(cells[-2]), float(cells[-1]))


class OrthospectrumCusps(ProgramTest):
    CUSPED = "dLQacccjjkg"  # genus 2 and a torus

    def test_proved_lengths(self):
        answer = self.json_answer("orthospectrum", self.CUSPED, "--length", "4", "--prove")
        self.assertIs(answer["proved"], True)
        for arc in answer["arcs"]:
            lower, upper = arc["proved_length"]
            self.assertLess(upper - lower, 1e-12)
            self.assertLessEqual(abs(arc["length"] - lower), 1e-12)

    def test_cone_points_are_refused_by_name(self):
        gluings = json.loads(samples.as_json(samples.TRIPUS_GLUINGS, "orbifold"))
        self.write("orbifold.json", json.dumps({**gluings, "cone_orders": [3]}))
        self.assert_refused("orthospectrum", "orbifold.json", says="singular edges",
                            kind="unsupported")

    def test_arcs_and_picture(self):
        answer = self.json_answer("orthospectrum", self.CUSPED, "--length", "8", "--summary")
        self.assertAlmostEqual(answer["volume"]["from_area"], 7.79763688,
                               delta=answer["volume"]["from_area_uncertainty"])
        self.assertAlmostEqual(answer["area"]["exact"], 4 * math.pi, delta=1e-12)
        result = self.run_program("orthospectrum", self.CUSPED, "--length", "6", "--picture",
                                  "spots.svg")
        self.assertEqual((result.status, result.err), (0, ""))
        text = (self.folder / "spots.svg").read_text()
        self.assertIn("genus 2", text)
        self.assertNotIn("genus 1", text)
        self.assertNotIn("nan", text)


class OrthospectrumRefusals(ProgramTest):
    def expect_refused(self, *arguments, says, status=2):
        result = self.run_program("orthospectrum", *arguments)
        self.assertEqual(result.status, status, result.text)
        self.assertIn(says, result.err + (result.text if status == 1 else ""))
        if status == 2:
            self.assertEqual(result.out, b"")

    def test_bad_usage(self):
        self.expect_refused(TRIPUS, "--length", "-1", says="greater than 0")
        self.expect_refused(TRIPUS, "--length", "25", says="at most 20")
        self.expect_refused(TRIPUS, "--length", "3", "--count", "4", says="--count")
        self.expect_refused(TRIPUS, "--count", "0", says="greater than 0")
        self.expect_refused(TRIPUS, "--picture", "spots.png", says=".svg")
        self.expect_refused(TRIPUS, "--picture", "nowhere/spots.svg", says="nowhere")
        self.expect_refused(says="INPUT")

    def test_too_many_arcs_are_named_with_the_remedy(self):
        self.expect_refused(TRIPUS, "--length", "18", says="--force")

    def test_inputs_without_geodesic_boundary(self):
        self.expect_refused("cPcbbbiht", says="without geodesic boundary")
        self.expect_refused("bkaaid", says="Klein bottle")
        self.expect_refused("bkaagj", says="closed")

    def test_no_metric(self):
        self.expect_refused(WITHOUT_METRIC, says="without a metric there are no arcs", status=1)


class OrthospectrumEnds(ProgramTest):
    def test_time_limit(self):
        answer = self.json_answer("orthospectrum", TRIPUS, "--length", "19", "--force", "--summary",
                                  "--time-limit", "0.3", status=1,
                                  err="tripus: the time limit of 0.3 s was reached\n")
        self.assertEqual(answer["end"], "time-limit")
        self.assertLess(answer["length"], 19)

    def test_ctrl_c_ends_with_what_is_complete(self):
        process = subprocess.Popen(
            self.command("orthospectrum", TRIPUS, "--length", "19", "--force", "--summary",
                         "--json"),
            stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        out, _ = process.communicate(timeout=60)
        answer = read_json(out.decode())
        self.assertEqual((process.returncode, answer["end"]), (1, "interrupted"))
        self.assertLess(answer["length"], 19)
