"""What the tests share."""

import json
import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
DATA = ROOT / "data"


@pytest.fixture(scope="session")
def program():
    """Runs the program; its standard output."""
    path = os.environ.get("TRIPUS_PROGRAM", str(ROOT / "build/release/bin/tripus"))

    def run(*arguments, **options):
        done = subprocess.run([path, *arguments], capture_output=True, text=True, **options)
        assert done.returncode in (0, 1), done.stderr
        return done.stdout

    return run


@pytest.fixture(scope="session")
def program_json(program):
    """Runs the program on a list of inputs; an answer each."""

    def run(verb, inputs, *options, tmp=None):
        text = "\n".join(inputs) + "\n"
        out = program(verb, "--batch", "-", "--json", "--quiet", *options, input=text)
        return [json.loads(line) for line in out.splitlines()]

    return run


def column(name, field=0, count=None):
    """A column of a table in data/, comments and header left out."""
    lines = [line for line in (DATA / name).read_text().splitlines() if line and line[0] != "#"]
    return [line.split("\t")[field].strip() for line in lines][:count]


def signatures(name, every=1):
    """Every so many of the signatures of a list in data/."""
    lines = [line.split("#")[0].strip() for line in (DATA / name).read_text().splitlines()]
    return [line.split()[0] for line in lines if line][::every]
