#!/usr/bin/env python3
"""How soon the page for browsers is there, and answers: headless Chromium with a software renderer, the page
from disk, a browser that has never been open before in every round.

    bench/page.py [PAGE]        default: build/page/tripus.html

Milliseconds by the page's own clock, which begins with the navigation:
  ready     the field takes a text and the page answers
  module    the module is compiled, and its worker waits for a question
  picture   a frame with the universal cover of cPcbbbihq, the address asking for it
  large     from the drop of a gluing table of 10,000 tetrahedra to its volume
"""

import os
import statistics
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "tests/page"), str(ROOT / "tests/program")]
import samples
from page_browser import PageBrowser, page_path

ROUNDS = 5
#: Writes down when an element is first as it is waited for.
WATCH = """(() => {
  window.moments = {};
  const look = () => {
    const put = (name, is) => { if (is && !(name in moments)) moments[name] = performance.now(); };
    put('solved', document.querySelector('#subject-badge .badge'));
    put('drawn', document.getElementById('cells-shown')?.dataset.drawn === '1');
  };
  new MutationObserver(look).observe(document, {subtree: true, childList: true, attributes: true});
})()"""

MODULE = "performance.getEntriesByName('module')[0]?.startTime"


def round_of(large):
    found = {}
    with PageBrowser(1280, 800) as browser:
        browser.call("Page.addScriptToEvaluateOnNewDocument", source=WATCH)
        browser.go("input=cPcbbbihq")
        browser.wait("moments.drawn")
        found["ready"] = float(browser.value("document.documentElement.dataset.ready"))
        found["module"], found["picture"] = browser.value(f"[{MODULE}, moments.drawn]")
    with PageBrowser(1280, 800) as browser:
        browser.call("Page.addScriptToEvaluateOnNewDocument", source=WATCH)
        browser.go()
        browser.wait(MODULE)
        browser.value("document.addEventListener('drop', () => { moments.dropped = performance.now(); }, true)")
        browser.drop(large)
        browser.wait("moments.solved")
        found["large"] = browser.value("moments.solved - moments.dropped")
    return found


def main():
    if len(sys.argv) > 2 or (len(sys.argv) == 2 and not Path(sys.argv[1]).is_file()):
        print(__doc__, file=sys.stderr)
        return 2
    if len(sys.argv) == 2:
        os.environ["TRIPUS_PAGE"] = str(Path(sys.argv[1]).resolve())
    if not page_path().is_file():
        print(f"page.py: there is no {page_path()}; scripts/page makes it", file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory() as folder:
        large = Path(folder) / "cover.json"
        large.write_text(samples.as_json(samples.tripus_cover(5000)))
        rounds = [round_of(large) for _ in range(ROUNDS)]
    for name in rounds[0]:
        values = [one[name] for one in rounds]
        print(f"{name:8} median {statistics.median(values):6.0f} ms   all {' '.join(f'{v:.0f}' for v in values)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
