#!/usr/bin/env python3
"""Processor time of frames of a page in headless Chromium, which draws WebGL2 in software.

usage: bench/page_frames.py PAGE.html [WISHES...]

PAGE.html is what `tripus view INPUT -o PAGE.html` wrote. WISHES are what its address may ask for, such as
model=ball&cells=500; without any, those of bench/README.md. Prints milliseconds of processor time a frame of
800x600, over all cores and processes: the difference of two runs, one with more frames."""

import os
import sys
import threading
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "program"))
from browser import draw  # noqa: E402

USUAL = ("model=ball&cells=20", "model=ball&cells=500", "model=ball&cells=500&renderer=cells",
         "model=upper&cells=500", "model=ball&cells=2000", "view=inside")
TICKS = os.sysconf("SC_CLK_TCK")


def processor_seconds(seen):
    """Notes in `seen` what processes that this one started have used."""
    parents, used = {}, {}
    for folder in Path("/proc").iterdir():
        if not folder.name.isdigit():
            continue
        try:
            fields = (folder / "stat").read_text().rsplit(")", 1)[1].split()
        except OSError:
            continue  # it has ended
        parents[int(folder.name)] = int(fields[1])
        used[int(folder.name)] = (int(fields[11]) + int(fields[12])) / TICKS
    for process, seconds in used.items():
        at = parents[process]
        while at not in (0, os.getpid()):
            at = parents.get(at, 0)
        if at:
            seen[process] = seconds


def run(page, wishes, frames):
    """Processor seconds and milliseconds by the page's clock of a run with so many frames."""
    seen, stop = {}, threading.Event()

    def watch():
        while not stop.is_set():
            processor_seconds(seen)
            time.sleep(0.02)
    thread = threading.Thread(target=watch)
    thread.start()
    try:
        picture = draw(page, f"{wishes}&size=800x600&frames={frames}")[0]
    finally:
        stop.set()
        thread.join()
    if picture.problem:
        raise SystemExit(picture.problem)
    return sum(seen.values()), picture.facts["milliseconds"]


def main():
    if len(sys.argv) < 2 or sys.argv[1] in ("-h", "--help"):
        print(__doc__.split("\n\n", 1)[1])
        raise SystemExit(0 if len(sys.argv) > 1 else 2)
    page = Path(sys.argv[1]).resolve()
    print(f"{'wishes':50}{'processor ms':>14}{'clock ms':>10}")
    for wishes in sys.argv[2:] or USUAL:
        few, many = (2, 6) if "renderer=cells" in wishes else (4, 64)
        short, _ = run(page, wishes, few)
        long, clock = run(page, wishes, many)
        print(f"{wishes:50}{1000 * (long - short) / (many - few):14.0f}{clock:10.0f}", flush=True)


if __name__ == "__main__":
    main()
