"""Runs the program and reads what it wrote."""

import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

DATA = Path(__file__).resolve().parents[2] / "data"

# Volume and edge length of the tripus: docs/theory.md (28) and (5).
TRIPUS = "cPcbbbihq"
TRIPUS_VOLUME = 6.45199027083503287
TRIPUS_LENGTH = 0.596133894890837


class Result:
    def __init__(self, completed):
        self.status = completed.returncode
        self.out = completed.stdout
        self.err = completed.stderr.decode("utf-8", "replace")

    @property
    def text(self):
        return self.out.decode("utf-8")

    @property
    def lines(self):
        return self.text.splitlines()


def no_special_numbers(word):
    raise ValueError(f"{word} in JSON")


def read_json(text):
    """One JSON object; its keys in order, without NaN and infinity and repeated keys."""

    def unique(pairs):
        keys = [key for key, _ in pairs]
        if len(set(keys)) != len(keys):
            raise ValueError(f"repeated key in {keys}")
        return dict(pairs)

    return json.loads(text, parse_constant=no_special_numbers, object_pairs_hook=unique)


class ProgramTest(unittest.TestCase):
    """Each test has a folder of its own, in which the program runs."""

    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)

    def command(self, *arguments):
        return [os.environ["TRIPUS_PROGRAM"], *arguments]

    def run_program(self, *arguments, stdin=b"", timeout=120, **options):
        if isinstance(stdin, str):
            stdin = stdin.encode()
        options.setdefault("stdout", subprocess.PIPE)
        completed = subprocess.run(
            self.command(*arguments), input=stdin, stderr=subprocess.PIPE, cwd=self.folder,
            timeout=timeout, check=False, **options)
        return Result(completed)

    def write(self, name, content):
        """A file in the test's folder; returns its name."""
        if isinstance(content, str):
            content = content.encode()
        (self.folder / name).write_bytes(content)
        return name

    def json_answer(self, *arguments, status=0, stdin=b"", err=""):
        """The one JSON object of a run that has no more than `err` to say on standard error."""
        result = self.run_program(*arguments, "--json", stdin=stdin)
        self.assertEqual(result.status, status, result.err or result.text)
        self.assertEqual(result.err, err)
        self.assertEqual(result.text.count("\n"), 1)
        return read_json(result.text)

    def assert_refused(self, *arguments, says, stdin=b"", kind=None):
        """Exit status 2, the words on standard error, and nothing else anywhere, twice: in text and
        as JSON."""
        plain = self.run_program(*arguments, stdin=stdin)
        self.assertEqual(plain.status, 2, plain.err or plain.text)
        self.assertEqual(plain.out, b"")
        self.assertIn(says, plain.err)
        self.assertTrue(plain.err.startswith("tripus: "), plain.err)
        self.assertEqual(plain.err.count("\n"), 1, plain.err)
        result = self.run_program(*arguments, "--json", stdin=stdin)
        self.assertEqual(result.status, 2)
        self.assertEqual(result.err, plain.err)
        answer = read_json(result.text)
        self.assertEqual(list(answer), ["tripus", "input", "error"])
        self.assertEqual(list(answer["error"]), ["kind", "message"])
        self.assertIn(answer["error"]["kind"], ["usage", "invalid-input", "unsupported"])
        if kind:
            self.assertEqual(answer["error"]["kind"], kind)
        self.assertIn(says, answer["error"]["message"])
        return answer
