#!/usr/bin/env python3
"""Hyperbolic or not, for whole lists, every certificate checked; run by scripts/hyperbolicity.

    hyperbolicity.py run LIST [--limit S] [--jobs N] [--every N] [--seconds S]
                                                                    decides what is not in the journal
    hyperbolicity.py table FILE.tsv                                 writes the journals as one table
    hyperbolicity.py controls                                       adds them to data/hyperbolicity-controls.tsv
    hyperbolicity.py mark FILE.tsv                                  writes its "no" into a table of diagrams
    hyperbolicity.py summary                                        prints them as Markdown

LIST is 2, 3, 4 or cusped (data/triangulations-*.txt), graphs (the handlebody-knots, theta curves and
handcuffs of the tables), or one of the controls: hyperbolic manifolds, on which all tests but the
metric are tried, and none may say "no": census, covers, and quick (the census without the search for
surfaces). Journals are build/hyperbolicity/LIST.jsonl, a line each, so that a run that was interrupted,
or was given some seconds only, goes on where it ended. The controls come in an order in which every
beginning is spread over the whole list, and those in data/hyperbolicity-controls.tsv are done.
"""

import argparse
import collections
import concurrent.futures
import json
import math
import multiprocessing
import pathlib
import statistics
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
JOURNALS = ROOT / "build" / "hyperbolicity"
LISTS = ("2", "3", "4", "cusped", "graphs", "quick", "census", "covers")
CONTROLS = ("quick", "census", "covers")
CONTROLS_FILE = "hyperbolicity-controls.tsv"
COVERS = 500
#: Of the golden section; the census's places, this many apart, are spread evenly.
STEP = 0.6180339887


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
    if which in ("census", "quick"):
        return spread(signatures)
    import tripus

    out = []
    for signature in signatures[::7]:
        for degree in (2, 3):
            for cover in tripus.Manifold(signature).covers(degree):
                out.append(cover.triangulation_isosig())
                if len(out) == COVERS:
                    return out
    return out


def spread(things):
    """In an order of which every beginning is spread over the whole."""
    step = int(STEP * len(things))
    while math.gcd(step, len(things)) > 1:
        step += 1
    return [things[k * step % len(things)] for k in range(len(things))]


def decide(job):
    """One line of the journal."""
    key, limit, which = job
    import tripus
    from tripus.hyperbolic.decide import hyperbolicity, without_metric

    manifold = tripus.Manifold(key)
    begin = time.perf_counter()
    if which in CONTROLS:
        answer = without_metric(manifold, math.inf, surfaces=False)
    else:
        answer = hyperbolicity(manifold, limit)
    found, tried = None, list(answer.tried)
    if which in ("census", "covers") and answer.hyperbolic is None:
        found, told = search(manifold, limit)
        tried.append(told)
    seconds = time.perf_counter() - begin
    line = {"input": key, "seconds": round(seconds, 4), "limit": limit}
    for name in ("hyperbolic", "proved", "by", "kind", "name", "pieces"):
        line[name] = getattr(answer, name)
    if found is not None:
        line.update(hyperbolic=False, by="surface", objection=found)
    elif answer.hyperbolic is None:
        line["tried"] = tried
    else:
        begin = time.perf_counter()
        line["objection"] = answer.certificate.objection(manifold)
        line["check_seconds"] = round(time.perf_counter() - begin, 4)
        surface = answer.certificate.data.get("surface")
        if surface:
            line["because"] = surface["why_essential"]["because"]
            line["round"] = answer.certificate.data["round"]
    return line


def search(manifold, seconds):
    """For a surface, for so many seconds of this process's own time, so that a busy machine does not
    count: what was found, and in words what was tried."""
    from tripus.hyperbolic.decide import surfaces_tried
    from tripus.hyperbolic.search import Search
    from tripus.hyperbolic.tables import Table

    told = {}
    deadline = time.process_time() + seconds
    found = Search(Table(manifold.gluings), told.__setitem__, deadline, time.process_time).run()
    return found, surfaces_tried(told)


def journal(which):
    path = JOURNALS / f"{which}.jsonl"
    if not path.exists():
        return []
    whole = (line for line in path.read_text().split("\n") if line.endswith("}"))
    # What was tried again counts as it came out last.
    return list({line["input"]: line for line in map(json.loads, whole)}.values())


def run(arguments):
    JOURNALS.mkdir(parents=True, exist_ok=True)
    known = {line["input"] for line in journal(arguments.list) if was_tried(line)}
    known |= set(done(arguments.list))
    todo = [key for key in inputs(arguments.list)[:: arguments.every] if key not in known]
    control = arguments.list in CONTROLS
    jobs = [(key, arguments.limit, arguments.list) for key in todo]
    print(f"{arguments.list}: {len(known)} done, {len(todo)} to do", flush=True)
    context = multiprocessing.get_context("spawn")
    begin, failures, number = time.monotonic(), 0, 0
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
            if time.monotonic() - begin > arguments.seconds:
                pool.shutdown(cancel_futures=True)
                print("  the seconds are over; the same command goes on", flush=True)
                break
    print(f"{arguments.list}: {len(known) + number} of {len(known) + len(todo)}, {failures} failures", flush=True)
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


def done(which):
    """The lines of the shipped table of a control, by input."""
    if which not in CONTROLS or not (ROOT / "data" / CONTROLS_FILE).exists():
        return {}
    return {row["input"]: row for row in rows(CONTROLS_FILE) if row["list"] == which}


def was_tried(line):
    """Whether the tests came to their ends: on a busy machine the time may be over before the group
    is simple, or the first surface is seen."""
    tried = "; ".join(line.get("tried", []))
    return not any(words in tried for words in ("time was over", "not read", "normal surfaces: 0 in"))


def controls(arguments):
    """The shipped table of controls with what the journals have."""
    names = ("list", "input", "hyperbolic", "limit", "tried")
    lines = []
    for which in CONTROLS:
        known = done(which)
        for line in filter(was_tried, journal(which)):
            tried = "; ".join(line.get("tried", []))
            known[line["input"]] = {**line, "list": which, "tried": tried}
        if not known:
            continue
        order = inputs(which)
        lines += [known[key] for key in order if key in known]
        print(f"{which}: {len(known)} of {len(order)}")
    with (ROOT / "data" / CONTROLS_FILE).open("w") as out:
        out.write(
            "# Controls of hyperbolic or not, by scripts/hyperbolicity: hyperbolic manifolds on which all tests "
            "but the metric were tried. limit: seconds of the search (processor time)\n"
        )
        out.write("\t".join(names) + "\n")
        for line in lines:
            out.write("\t".join(cell(line.get(name)) for name in names) + "\n")
    return sum(line["hyperbolic"] not in (None, "") for line in lines)


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
    verb.add_argument("--seconds", type=float, default=math.inf)
    verb.set_defaults(call=run)
    verbs.add_parser("controls").set_defaults(call=controls)
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
