"""tripus view -o page.html and --gallery: the pages, and what they draw in a browser."""

import json
import re
import unittest

import samples
from browser import draw, notice, page_data, page_text
from support import DATA, TRIPUS, TRIPUS_VOLUME, ProgramTest, read_json
from tracers import InsideTracer, OutsideTracer, defect, multiply, product

# One of another shape, with two edge classes, and a triangulation that carries no metric.
ASYMMETRIC = "dLQbcccherw"
WITHOUT_METRIC = "eLAkbccdddprdk"
BACKGROUND, MAGENTA = (0, 0), (255, 0, 255)
IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]


class Browser(ProgramTest):
    """What the tests of pages share; it has none of its own."""

    def page(self, *arguments, name="page.html"):
        result = self.run_program("view", *arguments, "-o", name)
        self.assertEqual(result.status, 0, result.err)
        return self.folder / name

    def draw(self, page, fragment):
        picture = draw(page, fragment)
        self.assertEqual(picture.problem, "")
        self.assertEqual(picture.facts["error"], 0)
        return picture

    def assert_sound(self, picture):
        """No pixel is left out, none is not a number, and there is something to see."""
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
        self.assertLess(moved, len(seen) / 20)
        return seen


class Outside(Browser):
    def check(self, page, fragment, covered):
        data = page_data(page.read_text())
        picture = self.draw(page, "view=outside&size=200x150&" + fragment)
        self.assert_sound(picture)
        self.assertLess(defect(picture.facts["toModel"]), 1e-9)
        seen = self.assert_shows(picture, OutsideTracer(data, picture),
                                 lambda pixel: (pixel[0] + 256 * pixel[1], pixel[2]), 6)
        share = sum(answer != BACKGROUND for answer in seen) / len(seen)
        self.assertGreater(share, covered[0])
        self.assertLess(share, covered[1])
        return seen

    def test_ball(self):
        seen = self.check(self.page(TRIPUS), "model=ball&cells=20", (0.2, 0.6))
        self.assertGreater(len(set(seen)), 15)

    def test_upper_half_space(self):
        self.check(self.page(TRIPUS, "--model", "upper"), "cells=12&yaw=2&pitch=0.6", (0.05, 0.6))

    def test_one_cell_of_an_asymmetric_manifold(self):
        self.check(self.page(ASYMMETRIC), "model=ball&cells=1&yaw=1.1", (0.02, 0.6))


class Cells(Browser):
    def test_are_those_of_embed(self):
        """Each cell once, in the same places, up to the order of equal distances."""
        page = self.page(TRIPUS)
        cells = self.draw(page, "cells=300&size=40x30").facts["cells"]
        answer = self.json_answer("embed", TRIPUS, "--cells", "300")
        distances = [sorted(round(cell["isometry"][15], 6) for cell in each)
                     for each in (cells, answer["cells"])]
        self.assertEqual(*distances)
        far = distances[0][-1] - 1e-5

        def inner(each):
            return sorted([cell["tetrahedron"]] + [round(cell["isometry"][4 * i + 3], 5) + 0.0
                                                   for i in range(3)]
                          for cell in each if cell["isometry"][15] < far)
        self.assertEqual(inner(cells), inner(answer["cells"]))
        self.assertEqual(cells[0]["isometry"], IDENTITY)
        for cell in cells:
            self.assertLess(defect(cell["isometry"]), 1e-9 * cell["isometry"][15] ** 2)

    def test_pairings_close_up_around_the_edge(self):
        data = page_data(self.page(TRIPUS).read_text())
        t, ends, place = 0, (0, 1), IDENTITY
        face = 2
        for _ in range(data["edge_valences"][0]):
            neighbour, word = data["gluings"][t][face]
            place = multiply(place, data["face_pairings"][t][face])
            ends = tuple(int(word[v]) for v in ends)
            entered = int(word[face])
            face = ({0, 1, 2, 3} - set(ends) - {entered}).pop()
            t = neighbour
        self.assertLess(max(abs(a - b) for a, b in zip(place, IDENTITY)), 1e-10)


class Inside(Browser):
    def check(self, page, fragment, step=8):
        picture = self.draw(page, "view=inside&size=200x150&" + fragment)
        self.assert_sound(picture)
        frame = picture.facts["frame"]
        self.assertLess(defect(frame), 1e-12)
        tracer = InsideTracer(page_data(page.read_text()), picture)
        seen = self.assert_shows(picture, tracer, lambda pixel: pixel[:3], step)
        self.assertGreater(len(seen), 300)
        return picture, seen

    def test_from_three_places(self):
        page = self.page(TRIPUS)
        for place in ("centre", "wall", "edge"):
            with self.subTest(place):
                _, seen = self.check(page, f"place={place}")
                self.assertEqual({kind for kind, _, _ in seen}, {1, 2})
                self.assertEqual({t for _, t, _ in seen}, {0, 1})

    def test_after_a_walk(self):
        """Through some faces; the camera stays inside its tetrahedron, and no wall is crossed."""
        page = self.page(ASYMMETRIC)
        data = page_data(page.read_text())
        for walk in ("forward:0.9,right:0.7,up:1.3", "back:40,left:40"):
            with self.subTest(walk):
                picture, _ = self.check(page, f"walk={walk}")
                place = [picture.facts["frame"][4 * i + 3] for i in range(4)]
                shape = data["tetrahedra"][picture.facts["tetrahedron"]]
                for normal in shape["faces"]:
                    self.assertLess(product(normal, place), 1e-9)
                for normal in shape["vertices"]:
                    self.assertLess(product(normal, place), -0.05)
        self.assertIs(picture.facts["touched"], True)


class Files(Browser):
    def test_a_page_is_small_and_needs_nothing_else(self):
        page = self.page(TRIPUS)
        text = page.read_text(encoding="utf-8")
        self.assertLess(page.stat().st_size, 200_000)
        self.assertNotRegex(text, r"(?i)https?://|@import|\bsrc=|\bimport\(|fetch\(")
        self.assertIn("default-src 'none'", text)
        data = page_data(text)
        self.assertAlmostEqual(data["volume"], TRIPUS_VOLUME, delta=1e-12)
        self.assertEqual(data["outcome"], "geometric")

    def test_names_cannot_break_out(self):
        name = "</script><script>document.title='broken'</script><!--{{data}}&\"'\u2028\u0007\u20ac"
        self.write("m.json", samples.as_json(samples.TRIPUS_GLUINGS, name))
        page = self.page("m.json")
        source = page.read_text(encoding="utf-8")
        self.assertEqual(page_data(source)["name"], name)
        self.assertNotIn("<script>document", source)
        text = page_text(page, "dump=1&size=20x15")
        self.assertNotIn("<title>broken", text)
        self.assertIn("&lt;/script&gt;&lt;script&gt;document.title", text)
        self.assertIn('id="dump"', text)

    def test_a_browser_without_webgl2_says_so(self):
        page = self.page(TRIPUS)
        text = page_text(page, "dump=1", flags=["--disable-3d-apis"])
        self.assertIn("WebGL2 is missing", notice(text))
        self.assertIn("6.45199027083", text)

    def test_a_shader_that_fails_says_so(self):
        page = self.page(TRIPUS)
        page.write_text(page.read_text().replace("uniform vec3 uEye;", "uniform vec9 uEye;"))
        text = page_text(page, "dump=1")
        self.assertIn("does not compile", notice(text))

    def test_a_lost_context_says_so(self):
        page = self.page(TRIPUS)
        lose = ("addEventListener('load', () => document.getElementById('picture')"
                ".getContext('webgl2').getExtension('WEBGL_lose_context').loseContext());")
        page.write_text(page.read_text().replace("'use strict';\n(() => {",
                                                 "'use strict';\n" + lose + "(() => {", 1))
        self.assertIn("has given up on this page", notice(page_text(page)))


class Refusals(ProgramTest):
    def test_no_metric(self):
        result = self.run_program("view", WITHOUT_METRIC, "-o", "page.html")
        self.assertEqual(result.status, 1)
        self.assertFalse((self.folder / "page.html").exists())

    def test_bad_requests(self):
        self.assert_refused("view", TRIPUS, "-o", "no/such/folder/page.html", says="no/such/folder")
        for cells in ("0", "10001", "-3", "many"):
            with self.subTest(cells):
                self.assert_refused("view", TRIPUS, "-o", "page.html", "--cells", cells,
                                    says="--cells")


class Gallery(Browser):
    def test_of_the_two_tetrahedron_manifolds(self):
        lines = (DATA / "triangulations-2.txt").read_text().splitlines()
        signatures = [line for line in lines if line and not line.startswith("#")]
        bad = ["nonsense!", WITHOUT_METRIC, "-"]
        self.write("list", "\n".join(signatures + bad) + "\n# end\n")
        (self.folder / "out").mkdir()
        result = self.run_program("view", "--gallery", "list", "-o", "out/index.html", "--json")
        self.assertEqual(result.status, 0, result.err)
        answers = [read_json(line) for line in result.lines]
        self.assertEqual([answer["input"] for answer in answers], signatures + bad)
        files = [answer.get("file") for answer in answers]
        self.assertEqual(files[len(signatures):], [None] * len(bad))
        for name in files[:len(signatures)]:
            page = self.folder / name
            self.assertAlmostEqual(page_data(page.read_text())["volume"], TRIPUS_VOLUME, delta=1e-11)
            self.assertEqual(page.with_suffix(".png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        index = page_text(self.folder / "out" / "index.html")
        links = re.findall(r'<a href="([^"]+)">', index)
        self.assertEqual([f"out/{link}" for link in links], files[:len(signatures)])
        self.assertIn(f"Without a page ({len(bad)})", index)
        self.assertIn("nonsense!", index)

    def test_refusals(self):
        self.write("list", TRIPUS + "\n")
        self.assert_refused("view", "--gallery", "list", says="-o")
        self.assert_refused("view", "--gallery", "none", "-o", "index.html", says="none")
        self.assert_refused("view", "--gallery", "list", "-o", "no/index.html", says="no/index.html")


if __name__ == "__main__":
    unittest.main()
