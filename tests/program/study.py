"""tripus study: reports, interruption and resumption, refusals."""

import signal
import subprocess
import time
from random import Random

import samples
from support import TRIPUS, ProgramTest, read_json

TABLES = {
    "stability": ["thresholds.csv", "angles.csv", "irregular_angles.csv", "starts.csv",
                  "flow_thresholds.csv", "outcomes.csv"],
    "triangulations": ["triangulations.csv"],
    "convergence": ["runs.csv", "iterations.csv", "theory.csv", "laws.csv"],
    "paper": ["triangulations.csv", "manifolds.csv", "same_volume.csv"],
    "valence": ["valence.csv", "counts.csv"],
}


class Study(ProgramTest):
    def rows(self, folder, table):
        """The rows without their timing columns, which summary.json names."""
        summary = read_json((self.folder / folder / "summary.json").read_text())
        columns = next(t["columns"] for t in summary["tables"] if t["file"] == table)
        keep = [i for i, column in enumerate(columns) if not column["timing"]]
        lines = (self.folder / folder / table).read_text().splitlines()
        if len(keep) == len(columns):
            return lines
        return [[line.split(",")[i] for i in keep] for line in lines]

    def test_every_study_writes_its_report(self):
        for name, tables in TABLES.items():
            with self.subTest(study=name):
                answer = self.json_answer("study", name, TRIPUS, "-o", name, "--samples", "3")
                self.assertTrue(answer["finished"])
                self.assertEqual(answer["items"], answer["items_done"])
                self.assertGreater(len(answer["findings"]), 100)
                self.assertNotIn("nan", answer["findings"])
                for file in tables + ["summary.json", "report.html"]:
                    self.assertIn(file, answer["files"])
                summary = read_json((self.folder / name / "summary.json").read_text())
                for key in ("tripus", "study", "seed", "machine", "facts", "tables"):
                    self.assertIn(key, summary)
                page = (self.folder / name / "report.html").read_text()
                self.assertIn("<svg", page)
                self.assertNotIn("<script", page)

    def test_same_tables_for_any_number_of_threads_and_after_interruptions(self):
        self.write("cover.json", samples.as_json(samples.tripus_cover(3)))
        arguments = ["study", "triangulations", "cover.json", TRIPUS, "--samples", "400",
                     "--seed", "5"]
        self.json_answer(*arguments, "-o", "whole", "--threads", "1")
        self.json_answer(*arguments, "-o", "threads", "--threads", "3")
        interruptions = 0
        for attempt in range(30):
            process = subprocess.Popen(
                self.command(*arguments, "-o", "stopped"), cwd=self.folder,
                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
            time.sleep(0.05 + 0.02 * attempt)
            # One in two without any chance to clean up.
            process.send_signal(signal.SIGKILL if attempt % 2 else signal.SIGINT)
            process.communicate(timeout=60)
            if process.returncode == 0:
                break
            interruptions += 1
        self.json_answer(*arguments, "-o", "stopped")
        self.assertGreater(interruptions, 0)
        expected = self.rows("whole", "triangulations.csv")
        self.assertGreater(len(expected), 500)
        self.assertEqual(self.rows("threads", "triangulations.csv"), expected)
        self.assertEqual(self.rows("stopped", "triangulations.csv"), expected)

    def test_every_study_survives_interruptions_at_random_moments(self):
        """Cut off by signals, by kill -9, and with the last line of its journal torn."""
        arguments = {
            "stability": [TRIPUS, "--samples", "4", "--methods", "newton"],
            "convergence": [TRIPUS, "--covers", "2,40", "--methods", "newton,flow:curvature/euler"],
            "paper": ["--census", "2", TRIPUS],
        }
        random = Random(11)
        for name, options in arguments.items():
            with self.subTest(study=name):
                command = ["study", name, *options, "--threads", "2"]
                start = time.monotonic()
                self.json_answer(*command, "-o", name + "-whole")
                whole = time.monotonic() - start
                stopped = self.folder / (name + "-stopped")
                for attempt in range(8):
                    process = subprocess.Popen(
                        self.command(*command, "-o", stopped.name), cwd=self.folder,
                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                    time.sleep(random.uniform(0, whole))
                    process.send_signal(random.choice([signal.SIGKILL, signal.SIGINT]))
                    process.communicate(timeout=60)
                    journal = stopped / "items.jsonl"
                    if journal.exists() and attempt % 2:
                        data = journal.read_bytes()
                        journal.write_bytes(data[:random.randint(0, len(data))])
                self.json_answer(*command, "-o", stopped.name)
                for table in TABLES[name]:
                    self.assertEqual(self.rows(stopped.name, table),
                                     self.rows(name + "-whole", table), table)

    def test_census_is_taken_as_a_whole(self):
        answer = self.json_answer("study", "paper", "--census", "3", "-o", "out")
        summary = read_json((self.folder / "out" / "summary.json").read_text())
        facts = {name: fact["value"] for name, fact in summary["facts"].items()}
        # The manifolds with up to three tetrahedra that the literature lists.
        self.assertEqual(facts["manifolds"], 8 + 150)
        self.assertEqual(facts["algebraic_found"], facts["geometric"])
        self.assertEqual(facts["flow_found"], facts["geometric"])
        self.assertLessEqual(facts["flow_error"], 1e-8)
        self.assertIn("158 different manifolds", answer["findings"])
        shared = self.rows("out", "same_volume.csv")
        self.assertEqual(len(shared) - 1, facts["manifolds_sharing"])

    def test_other_options_do_not_mix_with_what_is_there(self):
        self.json_answer("study", "paper", TRIPUS, "-o", "out")
        self.assert_refused("study", "paper", TRIPUS, "-o", "out", "--seed", "2",
                            says="is of other inputs, options or version")

    def test_refuses_what_it_cannot_study(self):
        self.assert_refused("study", "weather", "-o", "out",
                            says="the studies are convergence, stability, paper, triangulations, valence")
        self.assert_refused("study", "paper", "no such file", "-o", "out", says="no such file")
        self.assert_refused("study", "stability", "cPcbbbiht", "-o", "out", says="cPcbbbiht")
        self.assert_refused("study", "convergence", TRIPUS, "--methods", "guess", "-o", "out",
                            says="guess")
        self.write("file", "")
        self.assert_refused("study", "paper", TRIPUS, "-o", "file/out", says="file/out")
