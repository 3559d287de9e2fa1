"""The one table that every fault is tried on: what is run, and what it writes."""

import json
import re
import sys
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
DATA = HERE.parents[1] / "data"
sys.path.insert(0, str(HERE.parent / "program"))

import samples  # noqa: E402  (tests/program)

#: What every folder of a trial holds before the verb runs.
LIST = (DATA / "triangulations-2.txt", DATA / "triangulations-3.txt")

DRAWING = HERE.parent / "drawings" / "kinoshita-local-trefoil.json"


@dataclass(frozen=True)
class Verb:
    """A verb with its arguments. `outputs` are the files it writes, by name; `journal` is one that
    may stay of an interrupted run; `resumes`: the same command goes on where it was ended."""
    name: str
    arguments: tuple
    outputs: tuple = ()
    journal: tuple = ()
    resumes: bool = False
    #: Files of ours that it reads, to be damaged.
    reads: tuple = ()
    #: Arguments of runs that make what is read; run once.
    needs: tuple = ()
    prefix: bool = False  # a batch, whose answers are an unbroken prefix


SHARD = ("census", "--from", "list", "--shard", "1/2", "-o", "shards/1.tcs")

VERBS = [
    Verb("info", ("info", "cover.json", "--json")),
    Verb("solve", ("solve", "cover.json", "--json", "-o", "out.json"), ("out.json",)),
    Verb("history", ("solve", "cover.json", "--history", "out.csv"), ("out.csv",)),
    Verb("solve-batch", ("solve", "--batch", "list", "--json"), prefix=True),
    Verb("info-batch", ("info", "--batch", "list", "--json"), prefix=True),
    Verb("canonize-batch", ("canonize", "--batch", "short", "--json"), prefix=True),
    Verb("resume", ("canonize", "--batch", "short", "--json", "--resume", "out.jsonl"),
         journal=("out.jsonl",), resumes=True),
    Verb("cover-resume", ("cover", "--batch", "few", "--degree", "3", "--json", "--resume",
                          "out.jsonl"), journal=("out.jsonl",), resumes=True),
    Verb("gallery", ("view", "--gallery", "few", "-o", "index.html", "--json", "--resume",
                     "out.jsonl"), journal=("out.jsonl",), resumes=True),
    Verb("simplify", ("simplify", "cover.json", "-o", "out.json"), ("out.json",)),
    Verb("cover", ("cover", "cPcbbbihq", "--degree", "5", "-o", "out.txt"), ("out.txt",)),
    Verb("canonize", ("canonize", "cPcbbbihq", "--json")),
    Verb("embed", ("embed", "cPcbbbihq", "--cells", "2000", "-o", "out.json"), ("out.json",)),
    Verb("embed-ply", ("embed", "cPcbbbihq", "--cells", "200", "-o", "out.ply", "--circles",
                       "out.svg"), ("out.ply", "out.svg")),
    Verb("page", ("view", "cPcbbbihq", "-o", "out.html"), ("out.html",)),
    Verb("orthospectrum", ("orthospectrum", "cPcbbbihq", "--length", "5", "--tsv", "out.tsv"),
         ("out.tsv",)),
    Verb("draw", ("draw", "hk5_3", "-o", "out.svg"), ("out.svg",)),
    Verb("table", ("table", "theta-curves", "--tsv", "out.tsv", "--database", "out.sqlite"),
         ("out.tsv", "out.sqlite")),
    Verb("tube", ("tube", "graph.json", "-o", "out.off"), ("out.off",)),
    Verb("mesh", ("mesh", "in.off", "--save-mesh", "out.vtk"), ("out.vtk",),
         needs=(("tube", "graph.json", "-o", "in.off", "--quiet"),)),
    Verb("census-tsv", ("census", "--from", "list", "--tsv", "out.tsv"), ("out.tsv",),
         ("out.tsv.journal",), True),
    Verb("census-database", ("census", "--from", "short", "--database", "out.sqlite"),
         ("out.sqlite",), ("out.sqlite.journal",), True),
    Verb("census-journal", ("census", "--from", "short", "--journal", "work.journal", "--tsv",
                            "out.tsv"), ("out.tsv",), ("work.journal",), True,
         reads=("work.journal",), needs=(("census", "--from", "short", "--journal",
                                          "work.journal", "--tsv", "out.tsv"),)),
    Verb("census-shard", SHARD, ("shards/1.tcs",), ("shards/1.tcs.journal",), True),
    Verb("census-merge", ("census", "--merge", "1.tcs", "2.tcs", "--tsv", "out.tsv", "-o",
                          "out.sqlite"), ("out.tsv", "out.sqlite"), reads=("1.tcs", "2.tcs"),
         needs=(("census", "--from", "short", "--shard", "1/2", "-o", "1.tcs"),
                ("census", "--from", "short", "--shard", "2/2", "-o", "2.tcs"))),
    Verb("enumerate", ("enumerate", "4", "--shard", "1/9", "-o", "out.txt"), ("out.txt",)),
    Verb("study", ("study", "paper", "--samples", "40", "-o", "folder"), ("folder/summary.json",),
         ("folder/items.jsonl",), True, reads=("folder/items.jsonl",),
         needs=(("study", "paper", "--samples", "40", "-o", "folder"),)),
    Verb("look-up", ("census", "--in", "in.tsv", "--json", "--volume", "5:9"), reads=("in.tsv",),
         needs=(("census", "--from", "short", "--tsv", "in.tsv"),)),
    Verb("look-up-database", ("census", "--in", "in.sqlite", "--tsv", "out.tsv"), ("out.tsv",),
         reads=("in.sqlite",), needs=(("census", "--from", "short", "--database", "in.sqlite"),)),
]


def prepare(folder):
    """Fills the folder of a trial with what the verbs read."""
    lines = [line for path in LIST for line in path.read_text().split() if line]
    (folder / "shards").mkdir()
    (folder / "list").write_text("\n".join(lines * 2) + "\n")
    (folder / "short").write_text("\n".join(lines[:60]) + "\n")
    (folder / "few").write_text("\n".join(lines[:6]) + "\n")
    (folder / "cover.json").write_text(samples.as_json(samples.tripus_cover(400)))
    (folder / "graph.json").write_bytes(DRAWING.read_bytes())


def plain(data):
    """What must be the same in every run: all but times, and the machine's threads."""
    text = data if isinstance(data, bytes) else data.encode()
    text = re.sub(rb'"seconds": ?[-+.e0-9]+', b'"seconds": 0', text)
    text = re.sub(rb"\b[0-9][-+.e0-9]* s\b", b"some s", text)
    return text


def plain_file(path):
    """The same of a file; rows of a journal and tables of times in any order."""
    data = plain(path.read_bytes())
    if path.suffix == ".csv":  # iteration,evaluations,seconds,...
        return b"\n".join(b",".join(row.split(b",")[:2] + row.split(b",")[3:])
                          for row in data.split(b"\n"))
    if path.name == "summary.json":
        summary = json.loads(data)
        return json.dumps([summary["study"], summary["seed"], summary["samples"],
                           sorted(summary["tables"], key=str)]).encode()
    if path.suffix == ".jsonl":
        return re.sub(rb'"seconds": 0', b"", data)
    return data
