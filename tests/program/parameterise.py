"""tripus parameterise: a solid mapped onto its hyperbolic manifold."""

import base64
import math
import re
import struct

from support import DATA, TRIPUS_VOLUME, ProgramTest, read_json

EXAMPLES = DATA.parent / "examples"
SURFACE = EXAMPLES / "surfaces" / "knotted-y.off"


def arrays_of(text):
    """The numbers of a .vtu file, by the names of its arrays; the last one of a name."""
    found = {}
    for kind, name, body in re.findall(
            r'<DataArray type="(\w+)" Name="(\w+)"[^>]*>([^<]*)<', text):
        data = base64.b64decode(body)
        letter = {"Float64": "d", "Int32": "i", "UInt8": "B"}[kind]
        size = struct.unpack("<I", data[:4])[0]
        assert size == len(data) - 4
        found[name] = struct.unpack(f"<{size // struct.calcsize(letter)}{letter}", data[4:])
    return found


class Parameterise(ProgramTest):
    def test_maps_the_knotted_y(self):
        run = self.run_program("parameterise", str(SURFACE), "-o", "y.vtu", "--report", "y.html",
                               "--picture", "y.svg", "--json", timeout=300)
        self.assertEqual(run.status, 0, run.err)
        answer = read_json(run.text)
        self.assertEqual(answer["termination"], "converged")
        self.assertLess(answer["max_gradient"], 1e-10)
        self.assertLess(answer["relator_defect"], 1e-10)
        self.assertLess(answer["equivariance_defect"], 1e-10)
        self.assertLess(answer["off_boundary"], 1e-12)
        self.assertAlmostEqual(answer["manifold_volume"], TRIPUS_VOLUME, delta=1e-9)
        self.assertAlmostEqual(answer["image_volume"], TRIPUS_VOLUME, delta=1e-8)
        self.assert_is_the_map((self.folder / "y.vtu").read_text(), answer)
        for name, end in (("y.html", "</html>\n"), ("y.svg", "</svg>\n")):
            text = (self.folder / name).read_text()
            self.assertTrue(text.endswith(end))
            self.assertGreater(text.count("<polygon"), 1000)
            self.assertNotIn("nan", text.lower())

        shown = self.run_program("view", "--solid", "y.vtu", "-o", "solid.html")
        self.assertEqual((shown.status, shown.text), (0, ""), shown.err)
        self.assertIn("cut away", (self.folder / "solid.html").read_text())

    def assert_is_the_map(self, text, answer):
        """By what is in the file alone: lengths of edges are the same from all cells around them."""
        data = arrays_of(text)
        points = len(data["Points"]) // 3
        cells = len(data["connectivity"]) // 4
        self.assertEqual((points, cells), (answer["points"], answer["tetrahedra"]))
        h3 = [data["point_h3"][4 * v:4 * v + 4] for v in range(points)]
        for x in h3:
            self.assertAlmostEqual(x[0]**2 + x[1]**2 + x[2]**2 - x[3]**2, -1, delta=1e-9 * x[3]**2)
        matrices = [data["deck_matrices"][16 * n:16 * n + 16]
                    for n in range(len(data["deck_matrices"]) // 16)]
        lengths = {}
        for t in range(cells):
            corners = data["connectivity"][4 * t:4 * t + 4]
            images = []
            for v, row in zip(corners, data["deck"][4 * t:4 * t + 4]):
                m = matrices[row]
                images.append([sum(m[4 * i + j] * h3[v][j] for j in range(4)) for i in range(4)])
            for i in range(4):
                for j in range(i):
                    x, y = images[i], images[j]
                    cosh = x[3] * y[3] - x[0] * y[0] - x[1] * y[1] - x[2] * y[2]
                    edge = tuple(sorted((corners[i], corners[j])))
                    lengths.setdefault(edge, []).append(math.acosh(max(1, cosh)))
        self.assertEqual(len(lengths), answer["edges"])
        for found in lengths.values():  # seen from all tetrahedra at the edge
            self.assertAlmostEqual(max(found), min(found), delta=1e-6)
        self.assertEqual(answer["filled_volume"], 0)
        self.assertAlmostEqual(sum(data["volume"]), answer["image_volume"], delta=1e-9)

    def test_uniform_weights_and_text(self):
        run = self.run_program("parameterise", str(SURFACE), "--weights", "uniform", timeout=300)
        self.assertEqual(run.status, 0, run.err)
        # 6.451990270835: the twelfth digit is rounded either way.
        self.assertRegex(run.text, r"image +volume 6\.4519902708[34]\b")
        self.assertIn("converged", run.text)

    def test_says_what_is_no_solid_for_it(self):
        self.write("ball.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                   "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")
        run = self.run_program("parameterise", "ball.off")
        self.assertEqual(run.status, 2)
        self.assertIn("fundamental group is trivial", run.err)
        for graph, words in (("trefoil", "cusp"), ("unknotted-theta", "carries a hyperbolic metric")):
            self.run_program("tube", str(EXAMPLES / "graphs" / f"{graph}.json"), "-o", "g.off",
                             "--quiet")
            run = self.run_program("parameterise", "g.off", timeout=300)
            self.assertEqual(run.status, 2)
            self.assertIn(words, run.err)

    def test_refines_where_the_map_stretches(self):
        coarse, fine = (read_json(self.run_program("parameterise", str(SURFACE), "--json", *more, timeout=300).text)
                        for more in ((), ("--refine", "12000")))
        self.assertEqual((coarse["termination"], fine["termination"]), ("converged", "converged"))
        self.assertLess(abs(fine["tetrahedra"] - 12000), 100)
        self.assertLess(fine["energy"], coarse["energy"])
        self.assertLess(fine["relator_defect"], 1e-10)
        self.assertLess(fine["off_boundary"], 1e-12)
        self.assertAlmostEqual(fine["image_volume"], TRIPUS_VOLUME, delta=1e-8)
        for wrong in ("-1", "x", "2000000000"):
            self.assert_refused("parameterise", str(SURFACE), "--refine", wrong, says="--refine")

    def test_advises_where_no_minimum_is_found(self):
        run = self.run_program("parameterise", str(SURFACE), "--tolerance", "1e-300", timeout=300)
        self.assertEqual(run.status, 1)
        self.assertRegex(run.text, "advice +a larger tolerance")

    def test_refuses_names_and_files_of_others(self):
        for arguments in (("-o", "y.vtk"), ("--report", "y.txt"), ("--picture", "y.png"),
                          ("--weights", "best"), ("--method", "luck"), ("--tolerance", "0"),
                          ("--cut-away", "nan", "--picture", "y.svg"), ("--cut-away", "0.2")):
            self.assertEqual(self.run_program("parameterise", str(SURFACE), *arguments).status, 2)
        self.write("other.vtu", "<VTKFile/>")
        run = self.run_program("view", "--solid", "other.vtu", "-o", "x.html")
        self.assertEqual(run.status, 2)
        self.assertIn("no array", run.err)
