"""tripus view -o page.html and --gallery: the pages, and what they draw in a browser."""

import json
import math
import os
import re
import subprocess
import tempfile
from pathlib import Path
from random import Random

import samples
from browser import draw, notice, page_data, page_text
from drawn_pages import MAGENTA, DrawnPages, shown_and_missing
from live_browser import LiveBrowser
from support import DATA, TRIPUS, TRIPUS_VOLUME, ProgramTest, read_json
from tracers import CUT, InsideTracer, OutsideTracer, defect, multiply, product

# One of another shape, with two edge classes, and a triangulation that carries no metric.
ASYMMETRIC = "dLQbcccherw"
WITHOUT_METRIC = "eLAkbccdddprdk"
# With a cusp; the latter is not orientable.
FIGURE_EIGHT, GIESEKING = "cPcbbbiht", "bkaaid"
IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]


class Pictures(DrawnPages, ProgramTest):
    """Two pages, each drawn in all these ways by one browser, which takes seconds to start."""

    WISHES = {
        TRIPUS: {
            "ball": "size=200x150&model=ball&cells=20",
            "upper": "size=200x150&model=upper&cells=12&yaw=2&pitch=0.6",
            "many": "size=40x30&model=ball&cells=300",
            "very many": "size=80x60&model=ball&cells=2000",
            "dragged": "size=40x30&model=ball&drag=30:15",
            "klein": "size=200x150&model=klein&cells=20",
            "reference": "size=200x150&model=ball&cells=20&renderer=cells",
            "moved": "size=200x150&model=ball&cells=20&keys=w:0.6,d:0.5",
            "moved upper": "size=200x150&model=upper&cells=12&yaw=2&pitch=0.6&keys=a:0.4,r:0.3",
            "cut": "size=200x150&model=ball&cells=20&cut=0.1",
            "cut klein": "size=200x150&model=klein&cells=20&cut=-0.1&yaw=1",
            "clear": "size=200x150&model=ball&cells=20&transparent=1",
            "named": "size=300x220&model=ball&cells=6&labels=1",
            "by edge": "size=100x80&model=ball&cells=6&colour=edge",
            "by component": "size=100x80&model=ball&cells=6&colour=component",
            "joined": "size=200x150&model=ball&cells=2&distance=2",
            "apart": "size=200x150&model=ball&cells=2&distance=2&explode=0.0001",
            "apart bare": "size=200x150&model=ball&cells=2&distance=2&explode=0.0001&lines=0",
            "hollow": "size=100x80&model=ball&cells=6&hollow=1&cut=0",
            "walls": "size=100x80&model=ball&cells=6&truncations=0",
            "paced": "size=400x300&model=ball&motion=4&paces=300:20,40:20,5:60",
            "wheeled": "size=120x90&model=ball&wheel=-100:10:10",
            "pinched": "size=40x30&model=ball&pinch=2",
            "cycled": "size=40x30&model=ball&cells=1&keys=m:0,c:0,i:0",
            "edges said": "size=40x30&view=inside&tube=0.12&hover=" +
                          ",".join(f"{x / 20}:{y / 20}" for x in range(20) for y in range(20)),
            "nearer": "size=40x30&model=ball&keys=%2B:1",
            "centre": "size=200x150&view=inside&tube=0.05",
            "wall": "size=200x150&view=inside&tube=0.05&place=wall",
            "edge": "size=200x150&view=inside&tube=0.05&place=edge",
            "one sample": "size=80x60&view=inside&tube=0.05&place=wall&lines=0",
            "refined": "size=80x60&view=inside&tube=0.05&place=wall&lines=0&refine=16",
            "many samples": "size=80x60&view=inside&tube=0.05&place=wall&lines=0&refine=200",
            "large": "size=640x480&view=inside&tube=0.05&place=wall&lines=0",
            "walked": "size=40x30&view=inside&keys=w:0.5,ArrowLeft:0.3",
            "looked": "size=40x30&view=inside&drag=60:0",
        },
        ASYMMETRIC: {
            "one": "size=200x150&model=ball&cells=1&yaw=1.1",
            "far": "size=200x150&view=inside&tube=0.05&walk=forward:0.9,right:0.7,up:1.3",
            "at the wall": "size=200x150&view=inside&tube=0.05&walk=back:40,left:40",
        },
        FIGURE_EIGHT: {
            "cusps": "size=200x150&model=ball&cells=20",
            "cusps upper": "size=200x150&model=upper&cells=12&yaw=2&pitch=0.6",
            "cusps klein": "size=200x150&model=klein&cells=20&cut=0.1",
            "cusps reference": "size=200x150&model=ball&cells=20&renderer=cells",
            "cusps inside": "size=200x150&view=inside&tube=0.05&place=wall",
            "cusps said": "size=40x30&hover=0.5:0.5,0.4:0.4,0.6:0.6,0.45:0.65,0.3:0.5,0.36:0.62",
            "at the cusp": "size=200x150&view=inside&tube=0.05&walk=back:40,left:40",
        },
        GIESEKING: {
            "turned over": "size=200x150&model=ball&cells=30",
            "turned over inside": "size=200x150&view=inside&tube=0.05",
        },
    }

    def test_cells_stand_where_rays_meet_them(self):
        self.assertGreater(len(set(self.check_outside(TRIPUS, "ball", 0.2, 0.6))), 15)
        self.check_outside(TRIPUS, "upper", 0.05, 0.6)
        self.check_outside(ASYMMETRIC, "one", 0.02, 0.6)
        self.check_outside(TRIPUS, "klein", 0.2, 0.7)
        moved = self.check_outside(TRIPUS, "moved", 0.05, 0.7)
        self.assertNotEqual(moved, self.check_outside(TRIPUS, "ball", 0.2, 0.6))
        self.check_outside(TRIPUS, "moved upper", 0.02, 0.7)
        for name in ("cut", "cut klein"):
            self.assertIn(CUT + 1, {surface for _, surface in self.check_outside(TRIPUS, name, 0.05, 0.6)})
        clear = {cell for cell, surface in self.check_outside(TRIPUS, "clear", 0.05, 0.6) if surface}
        self.assertEqual({self.facts("clear")["cells"][cell]["tetrahedron"] for cell in clear}, {0})

    def test_two_thousand_cells_stand_where_rays_meet_them(self):
        picture = self.pictures["very many"]
        self.assertEqual(len(picture.facts["cells"]), 2000)
        tracer, compared, seen = OutsideTracer(self.data[TRIPUS], picture), 0, set()
        for x, y in ((x, y) for x in range(8, 80, 9) for y in range(7, 60, 9)):
            around = {tracer.see(x + 0.5 + dx, y + 0.5 + dy)
                      for dx, dy in ((0, 0), (-0.4, -0.4), (-0.4, 0.4), (0.4, -0.4), (0.4, 0.4))}
            if len(around) > 1:
                continue
            compared += 1
            low, high, surface = picture.at(picture.identities, x, y)[:3]
            self.assertEqual({(low + 256 * high, surface)}, around, (x, y))
            seen.add(low + 256 * high)
        self.assertGreater(compared, 25)
        self.assertGreater(max(seen), 15)

    def test_horospheres_stand_where_rays_meet_them(self):
        for name in ("cusps", "cusps upper", "cusps klein"):
            with self.subTest(name):
                seen = self.check_outside(FIGURE_EIGHT, name, 0.03, 0.9)
                self.assertTrue({5, 6, 7, 8} & {surface for _, surface in seen})
        self.check_outside(GIESEKING, "turned over", 0.1, 0.9)
        self.assertIn("horosphere", " ".join(self.facts("cusps said")["hover"]))
        for signature, name in ((FIGURE_EIGHT, "cusps inside"), (GIESEKING, "turned over inside")):
            with self.subTest(name):
                seen = self.check_inside(signature, name)
                self.assertEqual({kind for kind, _, _ in seen}, {1, 2})

    def test_a_walk_ends_before_the_cusp(self):
        self.check_inside(FIGURE_EIGHT, "at the cusp")
        shape = self.data[FIGURE_EIGHT]["tetrahedra"][self.facts("at the cusp")["tetrahedron"]]
        for normal in shape["vertices"]:
            self.assertLess(product(normal, self.place("at the cusp")), -1.05)
        self.assertIs(self.facts("at the cusp")["touched"], True)

    def test_what_is_clear_still_tints(self):
        clear, ball = self.pictures["clear"], self.pictures["ball"]
        tinted = 0
        for y in range(clear.height):
            for x in range(clear.width):
                behind = clear.at(clear.identities, x, y)[2] == 0
                if behind and ball.at(ball.identities, x, y)[2] != 0:
                    colours = [each.at(each.colours, x, y) for each in (clear, ball)]
                    tinted += colours[0] != colours[1]
        self.assertGreater(tinted, 300)

    def test_tubes_of_cells_apart_stand_at_their_edges(self):
        joined, apart, bare = (self.pictures[name] for name in ("joined", "apart", "apart bare"))

        def differ(one, other):
            return sum(max(abs(a - b) for a, b in zip(one.colours[i:i + 3], other.colours[i:i + 3])) > 40
                       for i in range(0, len(one.colours), 4))
        self.assertGreater(differ(joined, bare), 200)
        self.assertLess(10 * differ(joined, apart), differ(joined, bare))

    def test_names_stand_on_their_cells(self):
        picture = self.pictures["named"]
        labels = picture.facts["labels"]
        self.assertGreater(len(labels), 5)
        for label in labels:
            x = int(label["x"] * picture.width)
            y = picture.height - 1 - int(label["y"] * picture.height)
            around = {picture.at(picture.identities, x + i, y + j)
                      for i in range(-3, 4) for j in range(-3, 4)}
            cells = {p[0] + 256 * p[1] for p in around if p[2] != 0}
            tetrahedra = {str(picture.facts["cells"][cell]["tetrahedron"]) for cell in cells}
            self.assertTrue(label["text"] == "e0" or label["text"] in tetrahedra, label)

    def test_every_key_does_something(self):
        keys = [key for key, name, _ in self.data[TRIPUS]["keys"]
                if name and name not in ("save", "link", "help", "reset", "transparent")]
        self.assertGreater(len(keys), 12)
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / "page.html"
            subprocess.run([os.environ["TRIPUS_PROGRAM"], "view", TRIPUS, "-o", page],
                           check=True, stdout=subprocess.DEVNULL, timeout=100)
            usual = "size=20x15&cells=10&cut=0.5"
            escaped = {",": "%252C"}
            still, *pressed = draw(page, usual, *(f"{usual}&keys={escaped.get(key, key)}:0"
                                                  for key in keys))
            for key, picture in zip(keys, pressed):
                self.assertNotEqual(picture.facts["state"], still.facts["state"], key)

    def test_faces_and_whole_cells_make_the_same_picture(self):
        for faces, cells in (("ball", "reference"), ("cusps", "cusps reference")):
            self.check_same(self.pictures[faces], self.pictures[cells])

    def check_same(self, faces, cells):
        different = alone = 0
        for y in range(1, faces.height - 1):
            for x in range(1, faces.width - 1):
                around = {faces.at(faces.identities, x + dx, y + dy)
                          for dx in (-1, 0, 1) for dy in (-1, 0, 1)}
                if len(around) > 1:
                    continue
                alone += 1
                different += faces.at(faces.identities, x, y) != cells.at(cells.identities, x, y)
        self.assertGreater(alone, faces.width * faces.height / 3)
        self.assertLessEqual(1000 * different, alone)

    def test_wheel_and_fingers_move_the_cells(self):
        still, wheeled, pinched = (self.facts(name) for name in ("ball", "wheeled", "pinched"))
        self.assertLess(wheeled["distance"], still["distance"])
        # Towards the pointer, which is left of the middle and above it.
        right, up = wheeled["camera"]["axes"][:3], wheeled["camera"]["axes"][3:6]
        self.assertLess(sum(a * b for a, b in zip(right, wheeled["target"])), -0.01)
        self.assertGreater(sum(a * b for a, b in zip(up, wheeled["target"])), 0.01)
        self.assertAlmostEqual(pinched["distance"], still["distance"] / 2, delta=1e-9)

    def test_keys_change_what_is_shown(self):
        self.assertEqual((self.facts("cycled")["model"], self.facts("cycled")["view"]),
                         ("upper", "inside"))

    def test_edges_have_lengths_and_angles_under_the_pointer(self):
        said = "\n".join(self.facts("edges said")["hover"])
        self.assertIn("length 0.59613389, angle 30\u00b0", said)

    def test_a_link_shows_the_very_view(self):
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / "page.html"
            subprocess.run([os.environ["TRIPUS_PROGRAM"], "view", ASYMMETRIC, "-o", page],
                           check=True, stdout=subprocess.DEVNULL, timeout=100)
            wishes = ("model=klein&cells=7&yaw=1.1&wheel=-200:9:9",
                      "view=inside&walk=forward:0.9,up:1")
            first = draw(page, *(f"size=40x30&{wish}" for wish in wishes))
            second = draw(page, *(f"size=40x30&{picture.facts['fragment']}" for picture in first))
            for one, other in zip(first, second):
                places = [[each.facts["yaw"], each.facts["distance"], *each.facts["target"],
                           *each.facts["frame"]] for each in (one, other)]
                self.assertLess(max(abs(x - y) for x, y in zip(*places)), 1e-7)
                self.assertEqual(one.identities, other.identities)
                self.assertGreater(len(set(one.colours)), 20)

    def test_get_coarser_while_they_move_slowly(self):
        facts = self.facts("paced")
        self.assertEqual(len(facts["motion"]), 4)
        self.assertEqual(facts["motion"][0]["quality"], 1)
        coarse, steady, fine = facts["paces"]
        self.assertEqual(coarse, 0.15)  # the coarsest, and no coarser
        self.assertEqual(steady, coarse)
        self.assertEqual(fine, 1)

    def test_walls_and_edges_stand_where_geodesics_meet_them(self):
        for name in ("centre", "wall", "edge"):
            with self.subTest(name):
                seen = self.check_inside(TRIPUS, name)
                self.assertEqual({kind for kind, _, _ in seen}, {1, 2})
                self.assertEqual({t for _, t, _ in seen}, {0, 1})

    def test_at_rest_edges_get_smooth(self):
        """Means of samples come together, and nearer to the mean of 64 pixels of a larger picture
        than one sample does; not all the way, as lines there are thinner."""
        one, some, many = (self.pictures[name] for name in ("one sample", "refined", "many samples"))
        large = self.pictures["large"]
        away, from_many = {}, {}
        for name, picture in (("one", one), ("some", some)):
            away[name] = from_many[name] = 0
            for y in range(picture.height):
                for x in range(picture.width):
                    here, last = (each.at(each.colours, x, y) for each in (picture, many))
                    there = [large.at(large.colours, 8 * x + i, 8 * y + j)
                             for i in range(8) for j in range(8)]
                    for c in range(3):
                        away[name] += (here[c] - sum(p[c] for p in there) / 64) ** 2
                        from_many[name] += (here[c] - last[c]) ** 2
        self.assertLess(away["some"], away["one"])
        self.assertLess(10 * from_many["some"], from_many["one"])

    def test_a_walk_ends_inside_a_tetrahedron_and_before_the_wall(self):
        for name in ("far", "at the wall"):
            with self.subTest(name):
                self.check_inside(ASYMMETRIC, name)
                place = self.place(name)
                shape = self.data[ASYMMETRIC]["tetrahedra"][self.facts(name)["tetrahedron"]]
                for normal in shape["faces"]:
                    self.assertLess(product(normal, place), 1e-9)
                for normal in shape["vertices"]:
                    self.assertLess(product(normal, place), -0.05)
        self.assertNotEqual(self.facts("far")["tetrahedron"], 0)
        self.assertIs(self.facts("at the wall")["touched"], True)

    def test_cells_are_those_of_embed(self):
        """Each cell once, in the same places, up to the order of equal distances."""
        cells = self.facts("many")["cells"]
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
            self.assertLess(defect(cell["isometry"]), 1e-12 * cell["isometry"][15] ** 2)

    def axis(self, name, j):
        return [self.facts(name)["frame"][4 * i + j] for i in range(4)]

    def test_keys_and_pointers_move_the_walker(self):
        self.assertEqual(self.place("centre"), [0, 0, 0, 1])
        # 0.6 a second, straight ahead: the distance is arcosh of the time coordinate.
        place = self.place("walked")
        self.assertAlmostEqual(math.acosh(place[3]), 0.3, delta=0.02)
        ahead = sum(a * b for a, b in zip(self.axis("centre", 2)[:3], place[:3]))
        self.assertAlmostEqual(ahead, math.sqrt(place[3] ** 2 - 1), delta=1e-9)
        # Dragging to the right looks to the left.
        self.assertLess(product(self.axis("centre", 0), self.axis("looked", 2)), -0.05)

    def test_keys_and_pointers_move_the_cells(self):
        still, dragged, nearer = (self.facts(name) for name in ("ball", "dragged", "nearer"))
        self.assertLess(dragged["yaw"], still["yaw"])
        self.assertGreater(dragged["pitch"], still["pitch"])
        self.assertLess(nearer["distance"], 0.6 * still["distance"])


def disc_at(data, tetrahedron, vertex, x):
    """The number of the disc of a truncation that holds a point, from 1, or 0: its distance from the
    centre has cosh less than coth of the arc's length, cosh of log coth of half of it."""
    tile = data["discs"]["tiles"][4 * tetrahedron + vertex]
    for n in range(0, len(tile), 5):
        if -product(x, tile[n:n + 4]) < 1 / math.tanh(tile[n + 4]):
            return 1 + n // 5
    return 0


class Discs(ProgramTest):
    """The discs of arcs on the truncations, in every view."""

    WISHES = {
        "ball": "size=200x150&model=ball&cells=12",
        "upper": "size=200x150&model=upper&cells=12&yaw=2&pitch=0.6",
        "centre": "size=200x150&view=inside&tube=0.01&lines=0",
        "wall": "size=200x150&view=inside&tube=0.01&place=wall",
        "off": "size=40x30&model=ball&cells=12&discs=0",
        "said": "size=200x150&model=ball&cells=1&hover=" +
                ",".join(f"{x / 10}:{y / 10}" for x in range(2, 9) for y in range(2, 9)),
    }

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / "page.html"
            subprocess.run([os.environ["TRIPUS_PROGRAM"], "view", TRIPUS, "--discs", "4.5", "-o",
                            page], check=True, stdout=subprocess.DEVNULL, timeout=100)
            cls.text = page.read_text()
            cls.data = page_data(cls.text)
            cls.pictures = dict(zip(cls.WISHES, draw(page, *cls.WISHES.values())))

    def test_data(self):
        discs = self.data["discs"]
        self.assertEqual((discs["length"], discs["longest"]), (4.5, 4.5))
        self.assertAlmostEqual(discs["shortest"], self.data["edge_lengths"][0], delta=1e-12)
        self.assertEqual(len(discs["tiles"]), 8)
        for number, tile in enumerate(discs["tiles"]):
            pole = self.data["tetrahedra"][number // 4]["vertices"][number % 4]
            self.assertEqual(tile[4::5], sorted(tile[4::5]))
            for n in range(0, len(tile), 5):
                self.assertAlmostEqual(product(tile[n:n + 4], tile[n:n + 4]), -1, delta=1e-6)
                self.assertAlmostEqual(product(tile[n:n + 4], pole), 0, delta=1e-6)

    def assert_discs(self, name, tracer, tile_of, read):
        """Samples on truncations show the disc that is there, or one less than a pixel away."""
        picture, compared, held, moved = self.pictures[name], 0, 0, 0

        def expected(x, y):
            seen, point = tracer.see_point(x, y)
            tile = tile_of(seen)
            return seen, None if tile is None else disc_at(self.data, *tile, point)
        for y in range(2, picture.height, 4):
            for x in range(2, picture.width, 4):
                seen, disc = expected(x + 0.5, y + 0.5)
                wall, shown = read(picture.at(picture.identities, x, y))
                if disc is None or wall != seen:
                    continue
                compared += 1
                held += shown > 0
                if shown == min(disc, 15):
                    continue
                moved += 1
                around = [expected(x + 0.5 + dx, y + 0.5 + dy)[1]
                          for dx in (-0.7, 0, 0.7) for dy in (-0.7, 0, 0.7)]
                self.assertIn(shown, [min(n, 15) for n in around if n is not None], (name, x, y))
        self.assertGreater(compared, 80)
        self.assertGreater(held, compared / 3)
        self.assertLess(moved, compared / 8)

    def test_stand_where_rays_meet_them(self):
        for name in ("ball", "upper"):
            tracer = OutsideTracer(self.data, self.pictures[name])
            self.assert_discs(
                name, tracer,
                lambda seen: (tracer.tetrahedra[seen[0]], seen[1] - 5) if seen[1] > 4 else None,
                lambda pixel: ((pixel[0] + 256 * pixel[1], pixel[2] & 15), pixel[2] >> 4))

    def test_stand_where_geodesics_meet_them(self):
        for name in ("centre", "wall"):
            tracer = InsideTracer(self.data, self.pictures[name], tube=0.01)
            self.assert_discs(
                name, tracer,
                lambda seen: seen[1:] if seen is not None and seen[0] == 1 else None,
                lambda pixel: ((pixel[0], pixel[1], pixel[2] & 15), pixel[2] >> 4))

    def test_are_seen_and_can_be_switched_off(self):
        off = self.pictures["off"]
        self.assertEqual({off.identities[i] >> 4 for i in range(2, len(off.identities), 4)}, {0})
        for picture in self.pictures.values():
            self.assertEqual((picture.problem, picture.facts["error"]), ("", 0))
            self.assertNotIn(MAGENTA, {picture.at(picture.colours, x, y)[:3]
                                       for y in range(picture.height) for x in range(picture.width)})

        def reddish(picture):  # the colour of the largest discs, whatever the light
            colours = picture.colours
            return sum(colours[i] > 1.8 * max(colours[i + 1], colours[i + 2])
                       for i in range(0, len(colours), 4)) / (picture.width * picture.height)
        self.assertGreater(reddish(self.pictures["ball"]), 0.05)
        self.assertGreater(reddish(self.pictures["centre"]), 0.2)
        self.assertLess(reddish(off), 0.002)

    def test_are_told_of_under_the_pointer(self):
        said = "\n".join(self.pictures["said"].facts["hover"])
        self.assertIn("disc of an arc of length 0.596133894891", said)

    def test_have_a_legend_where_they_are(self):
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / "page.html"
            page.write_text(self.text)
            shown = page_text(page, "dump=1&size=20x15")
            self.assertIn('<section id="discs-part">', shown)
            self.assertIn("linear-gradient(to right, rgb(168, 28, 48)", shown)
            self.assertIn("<span>0.596</span>", shown)
            self.assertIn("<span>4.5</span>", shown)
        plain = self.run_program("view", TRIPUS, "-o", "plain.html")
        self.assertEqual(plain.status, 0)
        text = (self.folder / "plain.html").read_text()
        self.assertNotIn("discs", page_data(text))
        self.assertIn('<section id="discs-part" hidden', page_text(self.folder / "plain.html"))


class Files(ProgramTest):
    def page(self, *arguments):
        result = self.run_program("view", *arguments, "-o", "page.html")
        self.assertEqual(result.status, 0, result.err)
        return self.folder / "page.html"

    def test_a_page_is_small_and_needs_nothing_else(self):
        page = self.page(TRIPUS)
        text = page.read_text(encoding="utf-8")
        self.assertLess(page.stat().st_size, 200_000)
        self.assertNotRegex(text, r"https?://|@import|\bsrc=|\bimport\(|\bfetch\(")
        self.assertIn("default-src 'none'", text)
        data = page_data(text)
        self.assertAlmostEqual(data["volume"], TRIPUS_VOLUME, delta=1e-12)
        self.assertEqual(data["outcome"], "geometric")

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

    def losing(self, when, then=""):
        """A page whose context is lost: with `when`, a call of it, and what comes `then`."""
        page = self.page(TRIPUS)
        lose = ("const lose = () => { const lost = document.getElementById('picture')"
                ".getContext('webgl2').getExtension('WEBGL_lose_context'); lost.loseContext(); "
                + then + "}; " + when + ";")
        page.write_text(page.read_text().replace("'use strict';\n(() => {",
                                                 "'use strict';\n" + lose + "(() => {", 1))
        return notice(page_text(page))

    def test_a_lost_context_says_so(self):
        # Before the first picture, and in the very frame of it: before the page hears of the loss.
        for when in ("addEventListener('load', lose)", "requestAnimationFrame(lose)"):
            with self.subTest(when):
                self.assertIn("has given up on this page", self.losing(when))

    def test_a_context_that_comes_back_is_drawn_again(self):
        back = "setTimeout(() => lost.restoreContext(), 100);"
        for when in ("addEventListener('load', lose)", "requestAnimationFrame(lose)"):
            with self.subTest(when):
                self.assertEqual(self.losing(when, back), "")


class Large(ProgramTest):
    def test_inside_of_ten_thousand_tetrahedra(self):
        self.run_program("cover", TRIPUS, "--cyclic", "5000", "--limit", "1", "-o", "covers/")
        self.run_program("view", "covers/cover-000001.json", "-o", "page.html")
        page = self.folder / "page.html"
        data = page_data(page.read_text())
        self.assertEqual(data["tetrahedron_count"], 10000)
        picture, = draw(page, "size=100x75&view=inside&tube=0.05")
        self.assertEqual((picture.problem, picture.facts["error"]), ("", 0))
        tracer, seen = InsideTracer(data, picture, tube=0.05), set()
        compared = moved = 0
        for y in range(4, 75, 7):
            for x in range(4, 100, 7):
                expected = tracer.see(x + 0.5, y + 0.5)
                if expected is None:
                    continue
                kind, tetrahedron, number = expected
                compared += 1
                seen.add(tetrahedron)
                moved += picture.at(picture.identities, x, y)[:3] != (kind, tetrahedron & 255, number)
        self.assertGreater(compared, 100)
        self.assertGreater(len(seen), 5)
        self.assertGreater(max(seen), 255)
        self.assertLess(moved, compared / 10)


class Live(ProgramTest):
    """A page that stays open, moved by real pointers, fingers and keys."""

    def test_moves_and_counts_its_frames(self):
        self.run_program("view", TRIPUS, "-o", "page.html", "--cells", "60")
        with LiveBrowser() as browser:
            browser.open(self.folder / "page.html", "rate=1")
            first = browser.view()
            browser.drag(0.5)
            status = browser.hold("ArrowLeft", 1.5)
            rate, share = map(int, re.match(r"(\d+) frames a second, (\d+) % of", status).groups())
            self.assertGreater(rate, 0)
            self.assertLessEqual(share, 100)
            turned = browser.view()
            self.assertNotEqual((turned["yaw"], turned["pitch"]), (first["yaw"], first["pitch"]))
            self.assertEqual(turned["distance"], first["distance"])
            browser.mouse("mouseWheel", 200, 150, deltaX=0, deltaY=-120)
            nearer = browser.view()
            self.assertLess(float(nearer["distance"]), float(turned["distance"]))
            browser.fingers("touchStart", (150, 200), (250, 200))
            browser.fingers("touchMove", (100, 200), (300, 200))
            browser.fingers("touchEnd")
            spread = browser.view()
            self.assertAlmostEqual(float(spread["distance"]) / float(nearer["distance"]), 0.5,
                                   delta=0.01)
            # The tetrahedron under the pointer, and none again.
            browser.mouse("mouseMoved", 240, 280)
            browser.key("t")
            self.assertIn(browser.view().get("transparent"), ("0", "1"))
            browser.key("t")
            self.assertNotIn("transparent", browser.view())


class Polygons(ProgramTest):
    """A face has the pixels of a polygon around it: none that shows it is missing."""

    def test_hold_all_pixels_of_their_faces(self):
        random = Random(21)
        for arguments in ([TRIPUS], [ASYMMETRIC], ["eLMkbbddddhape"], [FIGURE_EIGHT], [GIESEKING],
                          ["dLQbccchrqg"], [TRIPUS, "--cone-order", "0=3"]):
            self.run_program("view", *arguments, "-o", "page.html")
            wishes = [f"size=100x75&model={model}&cells={random.choice((3, 20, 40))}"
                      f"&yaw={random.uniform(0, 6):.4f}&pitch={random.uniform(0.1, 1.5):.4f}"
                      f"&distance={random.uniform(1.1, 4.5):.4f}{more}"
                      for model in ("ball", "upper", "klein") for more in ("", "&cut=0.1", "")]
            seen = 0
            for wish, surfaces, missing in shown_and_missing(self.folder / "page.html", wishes):
                seen += sum(surface > 0 for surface in surfaces)
                self.assertLessEqual(len(missing), 1, (arguments, wish, missing))
            self.assertGreater(seen, 2000, arguments)


class Refusals(ProgramTest):
    def test_no_metric(self):
        result = self.run_program("view", WITHOUT_METRIC, "-o", "page.html")
        self.assertEqual(result.status, 1)
        self.assertFalse((self.folder / "page.html").exists())

    def test_names(self):
        for name in ("", "b.txt", ".html", "html"):
            self.assert_refused("view", TRIPUS, "-o", name, says=".html", kind="usage")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_bad_requests(self):
        self.assert_refused("view", TRIPUS, "-o", "no/such/folder/page.html", says="no/such/folder")
        for cells in ("0", "10001", "-3", "many"):
            with self.subTest(cells):
                self.assert_refused("view", TRIPUS, "-o", "page.html", "--cells", cells,
                                    says="--cells")


class Gallery(ProgramTest):
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

    def test_goes_on(self):
        lines = (DATA / "triangulations-2.txt").read_text().split()[:6]
        self.write("list", "\n".join([*lines, "nonsense!", WITHOUT_METRIC]) + "\n")
        arguments = ("view", "--gallery", "list", "-o", "index.html", "--json", "--resume", "done")
        self.assertEqual(self.run_program(*arguments).status, 0)
        whole = (self.folder / "done").read_text().splitlines(keepends=True)
        index = (self.folder / "index.html").read_text()
        for kept in (0, 3, len(whole) - 1, len(whole)):
            pages = [self.folder / answer["file"] for answer in map(json.loads, whole[kept:])
                     if "file" in answer]
            for page in pages:
                page.unlink()
            self.write("index.html", "an old one")
            self.write("done", "".join(whole[:kept]) + ('{"tripus": "0' if kept < 8 else ""))
            result = self.run_program(*arguments)
            self.assertEqual((result.status, result.out), (0, b""), result.err)
            self.assertEqual((self.folder / "index.html").read_text(), index)
            self.assertTrue(all(page.exists() for page in pages))
            self.assertEqual(len((self.folder / "done").read_text().splitlines()), len(whole))

    def test_does_not_go_on_without_its_pages(self):
        self.write("list", TRIPUS + "\n")
        arguments = ("view", "--gallery", "list", "-o", "index.html", "--json", "--resume", "done")
        self.run_program(*arguments)
        done = (self.folder / "done").read_text()
        page = self.folder / json.loads(done)["file"]
        page.unlink()
        result = self.run_program(*arguments)
        self.assertEqual(result.status, 2)
        self.assertIn("line 1 is of a page that is gone", result.err)
        other = ("view", "--gallery", "list", "-o", "other.html", "--json", "--resume", "done")
        self.run_program("view", "--gallery", "list", "-o", "index.html", "--json", "--resume", "anew")
        page.write_text(page.read_text() + " ")
        result = self.run_program(*arguments[:-1], "anew")
        self.assertEqual(result.status, 2)
        self.assertIn("line 1 is of a page that was changed", result.err)
        unmarked = re.sub(r', "checksum": "[0-9a-f]{16}"', "", done)
        for text, says in ((done.replace(page.name, "x.html"), "line 1 was changed"),
                           (unmarked.replace(page.name, "x.html"), "is of another index"),
                           (done.replace('"volume": 6', '"volume": "6').replace(
                               ', "file"', '", "file"'), "line 1")):
            self.write("done", text)
            result = self.run_program(*other)
            self.assertEqual(result.status, 2)
            self.assertIn(says, result.err)
        self.assertFalse((self.folder / "other.html").exists())

    def test_what_was_there_stays(self):
        self.write("list.html", TRIPUS + "\n")
        (self.folder / "alias.html").symlink_to("list.html")
        for index in ("list.html", "./list.html", "alias.html"):
            self.assert_refused("view", "--gallery", "list.html", "-o", index, says="which is read")
        self.assertEqual((self.folder / "list.html").read_text(), TRIPUS + "\n")
        self.write("index.html", "precious")
        self.assert_refused("view", "--gallery", "none", "-o", "index.html", says="none")
        self.assertEqual((self.folder / "index.html").read_text(), "precious")

    def test_refusals(self):
        self.write("list", TRIPUS + "\n")
        self.assert_refused("view", "--gallery", "list", says="-o")
        self.assert_refused("view", "--gallery", "none", "-o", "index.html", says="none")
        self.assert_refused("view", "--gallery", "list", "-o", "no/index.html", says="no/index.html")
