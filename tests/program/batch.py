"""--batch: one answer a line, in the order of the input, whatever the lines are."""

import json
import os
import random
import signal
import subprocess
import time

import samples
from support import DATA, TRIPUS, ProgramTest, read_json


def all_triangulations(number):
    lines = (DATA / f"triangulations-{number}.txt").read_text().splitlines()
    return [line for line in lines if line and not line.startswith("#")]


class Order(ProgramTest):
    BAD = ["cPcbbb", "no such file.json", "bkaahd", "cPcbbbiht 7=2", "-", "{}", "\ufffd", "cPcbbbihq x"]

    def setUp(self):
        super().setUp()
        chance = random.Random(7)
        good = all_triangulations(3) + [TRIPUS]
        self.lines = [chance.choice(self.BAD if chance.random() < 0.3 else good)
                      for _ in range(500)]
        self.write("list", "".join(line + "\n" for line in self.lines))

    def test_is_that_of_the_input_on_any_number_of_threads(self):
        outputs = []
        for verb in ("info", "solve"):
            for threads in ("1", "2", "7"):
                with self.subTest(verb=verb, threads=threads):
                    result = self.run_program(verb, "--batch", "list", "--json", "--threads",
                                              threads)
                    self.assertEqual(result.status, 0)
                    answers = [read_json(line) for line in result.lines]
                    self.assertEqual([answer["input"] for answer in answers], self.lines)
                    for answer in answers:
                        if answer["input"] not in self.BAD:
                            self.assertNotIn("error", answer)
                        elif verb == "solve":
                            self.assertIn("error", answer)
                    messages = result.err.splitlines()
                    self.assertEqual(len(messages), sum("error" in a for a in answers))
                    for answer in answers:
                        answer.pop("seconds", None)
                    outputs.append((verb, answers))
        for verb in ("info", "solve"):
            same = [answers for kind, answers in outputs if kind == verb]
            self.assertEqual(same[0], same[1])
            self.assertEqual(same[0], same[2])

    def test_messages_name_the_line(self):
        result = self.run_program("solve", "--batch", "list", "--json")
        numbers = [number for number, line in enumerate(self.lines, start=1) if line in self.BAD]
        self.assertEqual([line.split(":")[1] for line in result.err.splitlines()],
                         [f" line {number}" for number in numbers])

    def test_as_text_bad_lines_leave_nothing(self):
        result = self.run_program("solve", "--batch", "list")
        self.assertEqual(result.status, 0)
        heads = [line.split(":")[0] for line in result.lines if not line.startswith(" ")]
        self.assertEqual(heads, [line for line in self.lines if line not in self.BAD])


class Lists(ProgramTest):
    def test_with_comments_and_files(self):
        self.write("m.json", samples.as_json(samples.TRIPUS_GLUINGS))
        self.write("list", f"# tripus\n\n{TRIPUS} # as a signature\r\n  m.json\t\n#{TRIPUS}\n{TRIPUS}")
        result = self.run_program("info", "--batch", "list", "--json")
        self.assertEqual((result.status, result.err), (0, ""))
        self.assertEqual([read_json(line)["input"] for line in result.lines],
                         [TRIPUS, "m.json", TRIPUS])

    def test_on_standard_input(self):
        result = self.run_program("info", "--batch", "-", "--json", stdin=f"{TRIPUS}\nbad!\n")
        self.assertEqual(result.status, 0)
        answers = [read_json(line) for line in result.lines]
        self.assertEqual(answers[0]["isosig"], TRIPUS)
        self.assertEqual(answers[1]["error"]["kind"], "invalid-input")
        self.assertTrue(result.err.startswith("tripus: line 2: "))

    def test_without_lines(self):
        self.write("list", "# nothing\n")
        result = self.run_program("info", "--batch", "list", "--json")
        self.assertEqual((result.status, result.out), (0, b""))

    def test_of_garbage(self):
        chance = random.Random(11)
        letters = bytes(b for b in range(256) if b >= 32 or b in b"\t\r\n")
        self.write("list", bytes(chance.choices(letters, k=200_000)))
        result = self.run_program("info", "--batch", "list", "--json")
        self.assertEqual(result.status, 0)
        self.assertGreater(len(result.lines), 500)
        for line in result.text.split("\n")[:-1]:
            self.assertEqual(read_json(line)["error"]["kind"], "invalid-input")

    def test_that_are_no_lists(self):
        self.write("list", random.Random(12).randbytes(20_000))
        self.write("y.off", (DATA.parent / "examples" / "surfaces" / "knotted-y.off").read_bytes())
        for verb in ("info", "solve", "identify"):
            self.assert_refused(verb, "--batch", "list", says="a binary file and no list")
            self.assert_refused(verb, "--batch", "y.off", says="a mesh (OFF) and no list")

    def test_of_a_hundred_thousand_lines(self):
        known = all_triangulations(2) + all_triangulations(3)
        lines = [known[i % len(known)] for i in range(100_000)]
        self.write("list", "\n".join(lines))
        result = self.run_program("solve", "--batch", "list", "--json", timeout=280)
        self.assertEqual((result.status, result.err), (0, ""))
        answered = [line.split('"input": "')[1].split('"')[0] for line in result.lines]
        self.assertEqual(answered, lines)
        for i in range(0, 100_000, 997):
            read_json(result.lines[i])

    def test_whose_lengths_fit_only_some(self):
        self.write("cover.json", samples.as_json(samples.tripus_cover(2)))
        self.write("list", f"{TRIPUS}\ncover.json\n{TRIPUS}\n")
        self.write("lengths", "1")
        result = self.run_program("solve", "--batch", "list", "--initial-lengths", "lengths",
                                  "--json")
        self.assertEqual(result.status, 0)
        self.assertEqual(["error" in read_json(line) for line in result.lines],
                         [False, True, False])

    def test_of_components(self):
        self.write("list", f"{TRIPUS + TRIPUS}\n{TRIPUS}\n")
        result = self.run_program("solve", "--batch", "list", "--components", "--json")
        self.assertEqual([len(read_json(line)["components"]) for line in result.lines], [2, 1])


class Interrupts(ProgramTest):
    def start(self, *arguments, **options):
        process = subprocess.Popen(self.command(*arguments), cwd=self.folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, bufsize=0, **options)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def long_list(self):
        self.write("cover.json", samples.as_json(samples.tripus_cover(300)))
        return self.write("list", "cover.json\n" * 100_000)

    def test_end_a_batch_between_lines(self):
        self.long_list()
        for verb in ("solve", "info"):
            for number in (signal.SIGINT, signal.SIGTERM):
                with self.subTest(verb=verb, signal=number):
                    process = self.start(verb, "--batch", "list", "--json", "--threads", "2")
                    first = process.stdout.readline()
                    process.send_signal(number)
                    out, err = process.communicate(timeout=60)
                    self.assertEqual(process.returncode, 1)
                    self.assertTrue(out.endswith(b"\n") or not out)
                    lines = [read_json(line) for line in (first + out).splitlines()]
                    self.assertLess(len(lines), 100_000)
                    self.assertIn(f"interrupted: {len(lines)} of 100000 inputs answered",
                                  err.decode())

    def test_end_a_long_run_with_what_is_known(self):
        self.write("cover.json", samples.as_json(samples.tripus_cover(20_000)))
        os.mkfifo(self.folder / "run.csv")  # through a pipe the rows come as they are made
        process = self.start("solve", "cover.json", "--json", "--initial", "5", "--method",
                             "flow:curvature/euler", "--history", "run.csv")
        with open(self.folder / "run.csv", encoding="ascii") as history:
            rows = [history.readline() for _ in range(4)]
            process.send_signal(signal.SIGINT)
            rows += history.readlines()
        out, _ = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1)
        answer = read_json(out.decode())
        self.assertEqual(answer["outcome"], "unresolved")
        self.assertEqual(len(rows), answer["iterations"] + 2)

    def test_end_a_program_that_waits_for_its_input(self):
        for arguments in (["solve", "-"], ["solve", "--batch", "-"], ["info", "-"],
                          ["solve", TRIPUS, "--initial-lengths", "-"]):
            with self.subTest(arguments):
                process = self.start(*arguments, stdin=subprocess.PIPE)
                time.sleep(0.3)
                process.send_signal(signal.SIGINT)
                self.assertEqual(process.wait(timeout=20), 1)
                self.assertIn(b"interrupted", process.stderr.read())


class FullDisks(ProgramTest):
    def test_are_reported(self):
        self.write("list", f"{TRIPUS}\n" * 5000)
        for arguments in (["info", TRIPUS], ["solve", TRIPUS, "--json"], ["solve", TRIPUS],
                          ["methods"], ["methods", "--json"], ["--help"], ["--version"],
                          ["solve", "--help"], ["solve", "--batch", "list", "--json"],
                          ["solve", "--unknown", "--json"]):
            with self.subTest(arguments):
                with open("/dev/full", "wb") as full:
                    result = self.run_program(*arguments, stdout=full)
                self.assertEqual(result.status, 3)
                self.assertEqual(
                    result.err.splitlines()[-1],
                    "tripus: cannot write to standard output: No space left on device")
                self.assertEqual(result.err.count("cannot write"), 1)
