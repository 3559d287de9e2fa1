"""The README's tour and the tutorials: every command in them runs and prints what it shows."""

import re
import shlex
from pathlib import Path

from support import DATA, ProgramTest

ROOT = Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs" / "tutorials").glob("*.md"))]
NUMBER = re.compile(r"[-+]?\d+\.\d+(?:e[-+]?\d+)?|[-+]?\d+e[-+]?\d+")


def commands(page):
    """(command, the lines shown under it) for each "$ tripus ..." of a page."""
    found = []
    for line in page.read_text(encoding="utf-8").splitlines():
        if line.startswith("    $ "):
            found.append((line[6:], []))
        elif found and found[-1][1] is not None:
            if line.startswith("    ") or not line:
                found[-1][1].append(line[4:])
            else:
                found.append(("", None))
    return [(command, "\n".join(shown).strip("\n").splitlines())
            for command, shown in found if command.startswith("tripus ")]


class Tour(ProgramTest):
    def assert_shown(self, shown, printed):
        """Numbers agree to nine digits; times and rounding errors are left out."""
        if shown and shown[-1].strip() == "...":
            shown = shown[:-1]
            printed = printed[:len(shown)]
        self.assertEqual(len(shown), len(printed), "\n".join(printed))
        for ours, theirs in zip(shown, printed):
            if re.match(r"\s+(largest \|K\||method  )", ours):
                continue
            self.assertEqual(NUMBER.sub("#", ours), NUMBER.sub("#", theirs))
            for one, other in zip(NUMBER.findall(ours), NUMBER.findall(theirs)):
                self.assertAlmostEqual(float(one), float(other), delta=1e-9)

    def test_is_what_the_program_prints(self):
        (self.folder / "data").symlink_to(DATA)
        (self.folder / "examples").symlink_to(DATA.parent / "examples")
        for page in PAGES:
            run = commands(page)
            self.assertGreater(len(run), 4, page.name)
            for command, shown in run:
                with self.subTest(command, page=page.name):
                    self.assert_runs(command, shown)

    def test_every_page_is_in_the_index(self):
        index = (ROOT / "docs" / "index.md").read_text(encoding="utf-8")
        for page in [*(ROOT / "docs").glob("*.md"), *(ROOT / "docs" / "tutorials").glob("*.md")]:
            if page.name != "index.md":
                self.assertIn(f"({page.relative_to(ROOT / 'docs')})", index)

    def assert_runs(self, command, shown):
        words = shlex.split(command, comments=True)[1:]
        target = None
        if ">" in words:
            target = words[words.index(">") + 1]
            words = words[:words.index(">")]
        result = self.run_program(*words)
        self.assertIn(result.status, (0, 1), result.err)
        self.assertEqual(result.err, "")
        if target:
            self.write(target, result.out)
        elif shown:
            self.assert_shown(shown, result.lines)
