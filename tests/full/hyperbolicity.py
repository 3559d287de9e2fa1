#!/usr/bin/env python3
"""Hyperbolic or not, for whole lists, every certificate checked; run by scripts/hyperbolicity.

    hyperbolicity.py run LIST [--limit S] [--jobs N] [--every N]    decides what is not in the journal
    hyperbolicity.py table FILE.tsv                                 writes the journals as one table
    hyperbolicity.py mark FILE.tsv                                  writes its "no" into a table of diagrams
    hyperbolicity.py summary                                        prints them as Markdown

LIST is 2, 3, 4 or cusped (data/triangulations-*.txt), graphs (the handlebody-knots, theta curves and
handcuffs of the tables), census or covers (hyperbolic manifolds, on which all tests but the metric
are tried: none may say "no"). Journals are build/hyperbolicity/LIST.jsonl, a line each, so that a run
that was interrupted goes on where it ended.
"""

import argparse
import collections
import concurrent.futures
import json
import multiprocessing
import pathlib
import statistics
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
JOURNALS = ROOT / "build" / "hyperbolicity"
LISTS = ("2", "3", "4", "cusped", "graphs", "census", "covers")
CONTROLS = ("census", "covers")
COVERS = 500


def rows(name):
    """Of a table of data/: dicts, and lines of lists."""
    lines = (ROOT / "data" / name).read_text().splitlines()
    lines = [line for line in lines if line and not line.startswith("#")]
    if not name.endswith(".tsv"):
        return lines
    head = lines[0].split("\t")
    return [dict(zip(head, line.split("\t"))) for line in lines[1:]]


def inputs(which):
    if which in ("2", "3", "4", "cusped"):
        return rows(f"triangulations-{which}.txt")
    if which == "graphs":
        tables = ("diagrams-handlebody-knots.tsv", "diagrams-theta-curves.tsv")
        return [row["name"] for table in tables for row in rows(table)]
    signatures = [row["triangulations"].split(" ")[0] for row in rows("census.tsv")]
    if which == "census":
        return signatures
    import tripus

    out = []
    for signature in signatures[::7]:
        for degree in (2, 3):
            for cover in tripus.Manifold(signature).covers(degree):
                out.append(cover.triangulation_isosig())
                if len(out) == COVERS:
                    return out
    return out


def decide(job):
    """One line of the journal."""
    key, limit, control = job
    import tripus
    from tripus.hyperbolic.decide import hyperbolicity, without_metric

    manifold = tripus.Manifold(key)
    begin = time.perf_counter()
    answer = (without_metric if control else hyperbolicity)(manifold, limit)
    seconds = time.perf_counter() - begin
    line = {"input": key, "seconds": round(seconds, 4)}
    for name in ("hyperbolic", "proved", "by", "kind", "name", "pieces"):
        line[name] = getattr(answer, name)
    if answer.hyperbolic is None:
        line["tried"] = answer.tried
    else:
        begin = time.perf_counter()
        line["objection"] = answer.certificate.objection(manifold)
        line["check_seconds"] = round(time.perf_counter() - begin, 4)
        surface = answer.certificate.data.get("surface")
        if surface:
            line["because"] = surface["why_essential"]["because"]
            line["round"] = answer.certificate.data["round"]
    return line


def journal(which):
    path = JOURNALS / f"{which}.jsonl"
    if not path.exists():
        return []
    whole = (line for line in path.read_text().split("\n") if line.endswith("}"))
    return [json.loads(line) for line in whole]


def run(arguments):
    JOURNALS.mkdir(parents=True, exist_ok=True)
    known = {line["input"] for line in journal(arguments.list)}
    todo = [key for key in inputs(arguments.list)[:: arguments.every] if key not in known]
    control = arguments.list in CONTROLS
    jobs = [(key, arguments.limit, control) for key in todo]
    print(f"{arguments.list}: {len(known)} done, {len(todo)} to do", flush=True)
    context = multiprocessing.get_context("spawn")
    begin, failures = time.monotonic(), 0
    with (
        (JOURNALS / f"{arguments.list}.jsonl").open("a") as out,
        concurrent.futures.ProcessPoolExecutor(arguments.jobs, mp_context=context) as pool,
    ):
        for number, line in enumerate(pool.map(decide, jobs), 1):
            out.write("\n" * (out.tell() > 0 and number == 1) + json.dumps(line) + "\n")
            out.flush()
            failures += bool(line.get("objection")) or (control and line["hyperbolic"] is False)
            if number % 500 == 0:
                print(f"  {number} in {time.monotonic() - begin:.0f} s", flush=True)
    print(f"{arguments.list}: done, {failures} failures", flush=True)
    return failures


def what(line):
    """The kind, for the table of kinds."""
    if line["hyperbolic"] is None:
        return "not decided"
    if line["hyperbolic"]:
        return "hyperbolic, proved" if line["proved"] else "hyperbolic"
    if line["by"] in ("free group", "free product"):
        return f"disc or sphere ({line['by']})"
    return f"{line['kind']} ({line['by']})"


def table(arguments):
    names = ("list", "input", "hyperbolic", "proved", "by", "kind", "because", "name")
    with open(arguments.file, "w") as out:
        out.write(
            "# Hyperbolic or not, by scripts/hyperbolicity; every certificate checked. by, kind, because: what "
            "decided, docs/verdicts.md\n"
        )
        out.write("\t".join(names) + "\n")
        for which in LISTS:
            if which in CONTROLS:
                continue
            known = {line["input"]: line for line in journal(which)}
            for key in inputs(which):
                if key in known:
                    line = {**known[key], "list": which}
                    out.write("\t".join(cell(line.get(name)) for name in names) + "\n")
    return 0


def mark(arguments):
    """Rows under "hyperbolic" that are empty get the "no" of data/hyperbolicity.tsv."""
    path = pathlib.Path(arguments.file)
    known = {row["input"] for row in rows("hyperbolicity.tsv") if row["hyperbolic"] == "false"}
    lines = path.read_text().splitlines()
    head = next(i for i, line in enumerate(lines) if not line.startswith("#"))
    column = lines[head].split("\t").index("hyperbolic")
    for i in range(head + 1, len(lines)):
        cells = lines[i].split("\t")
        if cells[0] in known and not cells[column]:
            cells[column] = "no"
            lines[i] = "\t".join(cells)
    path.write_text("\n".join(lines) + "\n")
    return 0


def cell(value):
    return "" if value is None else str(value).lower() if isinstance(value, bool) else str(value)


def summary(arguments):
    for which in LISTS:
        lines = journal(which)
        if not lines:
            continue
        kinds = collections.Counter(map(what, lines))
        seconds = sorted(line["seconds"] for line in lines)
        print(f"\n### {which}: {len(lines)}, median {statistics.median(seconds):.3g} s, "
              f"mean {statistics.mean(seconds):.3g} s, most {seconds[-1]:.3g} s, in all {sum(seconds):.0f} s\n")
        print("| kind | number | median s | most s |\n|---|---|---|---|")
        for kind, number in kinds.most_common():
            some = sorted(line["seconds"] for line in lines if what(line) == kind)
            print(f"| {kind} | {number} | {statistics.median(some):.3g} | {some[-1]:.3g} |")
        bad = [line["input"] for line in lines if line.get("objection")]
        print(f"\ncertificates that do not check: {bad or 'none'}")
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    verbs = parser.add_subparsers(required=True)
    verb = verbs.add_parser("run")
    verb.add_argument("list", choices=LISTS)
    verb.add_argument("--limit", type=float, default=600.0)
    verb.add_argument("--jobs", type=int, default=1)
    verb.add_argument("--every", type=int, default=1)
    verb.set_defaults(call=run)
    verb = verbs.add_parser("table")
    verb.add_argument("file")
    verb.set_defaults(call=table)
    verb = verbs.add_parser("mark")
    verb.add_argument("file")
    verb.set_defaults(call=mark)
    verbs.add_parser("summary").set_defaults(call=summary)
    arguments = parser.parse_args()
    sys.exit(1 if arguments.call(arguments) else 0)


if __name__ == "__main__":
    main()
