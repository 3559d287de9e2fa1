"""Pages of manifolds with parabolic edges: what is cut off at their horospheres."""

from drawn_pages import DrawnPages, shown_and_missing
from support import TRIPUS, ProgramTest
from tracers import CUT, edge_walls, product

# All six edges of each tetrahedron; one of two edge classes; beside a cusp; not orientable.
ALL, SOME = TRIPUS + " 0=0", "dLQbcccherw 0=0"
BESIDE_A_CUSP, TURNED_OVER = "dLQacccjjkg 0=0", "dLQbccchrqg 1=0"
EDGE_WALLS = set(range(9, 15))  # the numbers that pixels show

OUTSIDE = {"ball": "size=200x150&model=ball&cells=20",
           "upper": "size=200x150&model=upper&cells=12&yaw=2&pitch=0.6",
           "klein": "size=200x150&model=klein&cells=20",
           "cut": "size=200x150&model=ball&cells=12&cut=0.1",
           "klein cut": "size=200x150&model=klein&cells=12&cut=-0.1&yaw=1"}
INSIDE = {"centre": "size=200x150&view=inside&tube=0.05",
          "wall": "size=200x150&view=inside&tube=0.05&place=wall",
          "far": "size=200x150&view=inside&tube=0.05&walk=forward:0.9,right:0.7,up:1.3",
          "at the wall": "size=200x150&view=inside&tube=0.05&walk=back:40,left:40"}
MORE = {"by edge": "size=100x80&model=ball&cells=6&colour=edge",
        "by component": "size=100x80&model=ball&cells=6&colour=component",
        "reference": "size=200x150&model=ball&cells=20&renderer=cells",
        "moved": "size=200x150&model=ball&cells=20&keys=w:0.6,d:0.5",
        "hollow": "size=100x80&model=ball&cells=6&hollow=1&cut=0",
        "named": "size=300x220&model=ball&cells=1&yaw=1.1&labels=1",
        "said": "size=80x60&model=ball&cells=1&yaw=1.1&hover=" +
                ",".join(f"{x / 20}:{y / 20}" for x in range(20) for y in range(20)),
        "said inside": "size=80x60&view=inside&tube=0.12&hover=" +
                       ",".join(f"{x / 10}:{y / 10}" for x in range(10) for y in range(10))}
WISHES = {manifold: {f"{name} of {manifold}": wish
                     for name, wish in (OUTSIDE | INSIDE | more).items()}
          for manifold, more in ((ALL, MORE), (SOME, MORE), (BESIDE_A_CUSP, {}), (TURNED_OVER, {}))}


class Parabolic(DrawnPages, ProgramTest):
    WISHES = WISHES

    def test_cells_stand_where_rays_meet_them(self):
        for manifold in WISHES:
            walls = set()
            for name in OUTSIDE:
                with self.subTest(name, manifold=manifold):
                    seen = self.check_outside(manifold, f"{name} of {manifold}", 0.02, 0.95)
                    walls |= {surface for _, surface in seen} & EDGE_WALLS
                    if "cut" in name:
                        self.assertIn(CUT + 1, {surface for _, surface in seen})
            self.assertTrue(walls, manifold)
        for manifold in (ALL, SOME):
            self.check_outside(manifold, f"moved of {manifold}", 0.02, 0.95)
            # Whole cells are no reference here: there are faces in their place.
            self.assertEqual(self.pictures[f"reference of {manifold}"].identities,
                             self.pictures[f"ball of {manifold}"].identities)

    def test_walls_and_edges_stand_where_geodesics_meet_them(self):
        for manifold in WISHES:
            seen = set()
            for name in INSIDE:
                with self.subTest(name, manifold=manifold):
                    seen |= set(self.check_inside(manifold, f"{name} of {manifold}"))
            self.assertTrue({number for kind, _, number in seen if kind == 1} & set(range(4, 10)))
            if manifold != ALL:  # which has no other edges
                self.assertIn(2, {kind for kind, _, _ in seen})

    def test_a_walk_ends_before_the_horosphere(self):
        for manifold in WISHES:
            name = f"at the wall of {manifold}"
            shape = self.data[manifold]["tetrahedra"][self.facts(name)["tetrahedron"]]
            for wall in edge_walls(shape):
                if wall:
                    self.assertLess(product(wall, self.place(name)), -1.05)
            self.assertIs(self.facts(name)["touched"], True)

    def test_are_told_of(self):
        said = " ".join(self.facts(f"said of {ALL}")["hover"])
        self.assertIn("horosphere of the parabolic edge", said)
        self.assertIn("edges 0 (parabolic), 0 (parabolic), 0 (parabolic)", said)
        self.assertNotIn("NaN", said)
        self.assertIn("horosphere of the parabolic edge",
                      " ".join(self.facts(f"said inside of {ALL}")["hover"]))
        self.assertRegex(" ".join(self.facts(f"said inside of {SOME}")["hover"]),
                         "edge .. of class 1, length [0-9.]+, angle")
        for manifold in (ALL, SOME):
            self.assertIn("e0", [label["text"] for label in self.facts(f"named of {manifold}")["labels"]])


class ParabolicPolygons(ProgramTest):
    def test_hold_all_pixels_of_their_faces(self):
        for manifold in (ALL, SOME):
            self.run_program("view", manifold, "-o", "page.html")
            wishes = [f"size=100x75&model={model}&cells=20&yaw={yaw}&pitch=0.7&distance={distance}"
                      for model in ("ball", "upper", "klein")
                      for yaw, distance in ((0.4, 1.4), (3.3, 2.9))]
            seen = 0
            for wish, surfaces, missing in shown_and_missing(self.folder / "page.html", wishes):
                seen += sum(surface in EDGE_WALLS for surface in surfaces)
                self.assertLessEqual(len(missing), 1, (manifold, wish, missing))
            self.assertGreater(seen, 100, manifold)
