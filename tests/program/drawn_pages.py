"""Pages that a browser draws in many ways, and what their pictures must show."""

import os
import subprocess
import tempfile
from pathlib import Path

from browser import draw, page_data
from tracers import InsideTracer, OutsideTracer, defect

BACKGROUND, MAGENTA = (0, 0), (255, 0, 255)


def shown_and_missing(page, wishes):
    """Of each wish the surfaces of all pixels, drawn with whole polygons, and the pixels which the
    polygons that follow the sides of faces leave out although a ray meets their face; faces seen
    edge-on may reach beyond their borders."""
    data = page_data(page.read_text())
    pictures = draw(page, *(wish + polygons for wish in wishes for polygons in ("", "&polygons=whole")))
    for wish, tight, whole in zip(wishes, pictures[::2], pictures[1::2]):
        assert (tight.problem, whole.problem) == ("", ""), (wish, tight.problem, whole.problem)
        tracer, surfaces, missing = OutsideTracer(data, whole), [], []
        for i in range(0, len(whole.identities), 4):
            low, high, surface = there = tuple(whole.identities[i:i + 3])
            surfaces.append(surface)
            x, y = i // 4 % whole.width, i // 4 // whole.width
            if (tuple(tight.identities[i:i + 3]) != there and
                    tracer.see(x + 0.5, y + 0.5) == (low + 256 * high, surface)):
                missing.append((x, y))
        yield wish, surfaces, missing


class DrawnPages:
    """For a ProgramTest with WISHES: of each input of `tripus view` the wishes of its page by name,
    drawn by one browser for each page, which takes seconds to start."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.data, cls.pictures = {}, {}
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / "page.html"
            for signature, wishes in cls.WISHES.items():
                subprocess.run([os.environ["TRIPUS_PROGRAM"], "view", signature, "-o", page],
                               check=True, stdout=subprocess.DEVNULL, timeout=100)
                cls.data[signature] = page_data(page.read_text())
                cls.pictures.update(zip(wishes, draw(page, *wishes.values())))

    def facts(self, name):
        return self.pictures[name].facts

    def test_are_sound(self):
        """No pixel is left out, none is not a number, and there is something to see."""
        for name, picture in self.pictures.items():
            with self.subTest(name):
                self.assertEqual((picture.problem, picture.facts["error"]), ("", 0))
                colours = [picture.at(picture.colours, x, y)
                           for y in range(picture.height) for x in range(picture.width)]
                self.assertEqual({colour[3] for colour in colours}, {255})
                self.assertNotIn(MAGENTA, {colour[:3] for colour in colours})
                self.assertGreater(len(set(colours)), 200)

    def assert_shows(self, picture, tracer, read, step):
        """Samples agree with the tracer, or with what it sees less than a pixel away; `read` makes
        an answer of the tracer's kind of the four bytes of a pixel. Returns what was seen."""
        seen, moved = [], 0
        for y in range(step // 2, picture.height, step):
            for x in range(step // 2, picture.width, step):
                shown = read(picture.at(picture.identities, x, y))
                expected = tracer.see(x + 0.5, y + 0.5)
                if expected is None:
                    continue
                seen.append(expected)
                if shown == expected:
                    continue
                moved += 1
                around = [tracer.see(x + 0.5 + dx, y + 0.5 + dy)
                          for dx in (-0.7, 0, 0.7) for dy in (-0.7, 0, 0.7)]
                self.assertIn(shown, around, f"at pixel {x}, {y}")
        self.assertGreater(len(seen), 300)
        self.assertLess(moved, len(seen) / 20)
        return seen

    def check_outside(self, signature, name, least, greatest):
        """`least`, `greatest`: the share of the picture that the cells cover."""
        picture = self.pictures[name]
        self.assertLess(defect(picture.facts["toModel"]), 1e-9)
        seen = self.assert_shows(picture, OutsideTracer(self.data[signature], picture),
                                 lambda pixel: (pixel[0] + 256 * pixel[1], pixel[2]), 6)
        share = sum(answer != BACKGROUND for answer in seen) / len(seen)
        self.assertGreater(share, least)
        self.assertLess(share, greatest)
        return seen

    def check_inside(self, signature, name):
        picture = self.pictures[name]
        self.assertLess(defect(picture.facts["frame"]), 1e-12)
        return self.assert_shows(picture, InsideTracer(self.data[signature], picture, tube=0.05),
                                 lambda pixel: pixel[:3], 9)

    def place(self, name):
        return [self.facts(name)["frame"][4 * i + 3] for i in range(4)]
