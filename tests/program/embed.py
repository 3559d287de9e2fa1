"""tripus embed: the JSON, the files, bad input, interruption."""

import math
import os
import signal
import stat
import struct
import subprocess
import time
import xml.etree.ElementTree as ElementTree
from collections import Counter
from pathlib import Path

from support import TRIPUS, TRIPUS_LENGTH, ProgramTest, read_json

WITHOUT_METRIC = "dLQbcbcaekw"
NON_ORIENTABLE = "dLQbccchrqg"


def product(x, y):
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2] - x[3] * y[3]


def times(a, b):
    return [sum(a[4 * i + k] * b[4 * k + j] for k in range(4)) for i in range(4) for j in range(4)]


IDENTITY = [float(i == j) for i in range(4) for j in range(4)]


def defect(a):
    return max(abs(x - y) for x, y in zip(a, IDENTITY))


def writes_a_draft(process):
    """Whether it has written something to a file that has no name yet, or that of a draft."""
    for link in Path(f"/proc/{process.pid}/fd").iterdir():
        try:
            status = link.stat()
            name = os.readlink(link)
        except OSError:
            continue
        if stat.S_ISREG(status.st_mode) and status.st_size > 0 and (
                status.st_nlink == 0 or name.endswith(".draft")):
            return True
    return False


class EmbedJson(ProgramTest):
    def test_keys(self):
        answer = self.json_answer("embed", TRIPUS)
        solved = self.json_answer("solve", TRIPUS)
        self.assertEqual(list(answer), list(solved) + ["tetrahedra", "face_pairings", "horosphere_area", "holonomy",
                                                       "cells", "cells_end"])
        self.assertEqual(list(answer["tetrahedra"][0]), ["vertices", "faces", "kinds"])
        self.assertEqual(list(answer["cells"][0]),
                         ["tetrahedron", "isometry", "word", "depth", "parent"])
        self.assertEqual(answer["cells"][0]["isometry"], IDENTITY)
        self.assertIsNone(answer["cells"][0]["parent"])
        self.assertEqual([cell["tetrahedron"] for cell in answer["cells"]], [0, 1])
        self.assertEqual(answer["cells_end"], "complete")

    def test_is_the_default_on_standard_output(self):
        plain = self.run_program("embed", TRIPUS)
        self.assertEqual((plain.status, plain.err), (0, ""))
        self.assertEqual(read_json(plain.text)["tetrahedra"],
                         self.json_answer("embed", TRIPUS)["tetrahedra"])

    def test_tetrahedra_have_the_gram_matrix_of_the_lengths(self):
        for tetrahedron in self.json_answer("embed", TRIPUS)["tetrahedra"]:
            v, n = tetrahedron["vertices"], tetrahedron["faces"]
            for i in range(4):
                self.assertAlmostEqual(product(v[i], v[i]), 1, delta=1e-14)
                self.assertAlmostEqual(product(n[i], n[i]), 1, delta=1e-14)
                for j in range(4):
                    if i != j:
                        self.assertAlmostEqual(product(v[i], v[j]), -math.cosh(TRIPUS_LENGTH),
                                               delta=1e-13)
                        self.assertAlmostEqual(product(n[i], v[j]), 0, delta=1e-14)

    def test_relators_hold(self):
        for manifold, orientable in ((TRIPUS, True), (NON_ORIENTABLE, False)):
            holonomy = self.json_answer("embed", manifold)["holonomy"]
            generators = holonomy["generators"]
            self.assertEqual(any(g["reverses_orientation"] for g in generators), not orientable)
            for relator in holonomy["relators"]:
                matrix = IDENTITY
                for letter in relator:
                    a = generators[abs(letter) - 1]["isometry"]
                    if letter < 0:  # J A^T J
                        a = [(-1) ** ((i == 3) + (j == 3)) * a[4 * j + i]
                             for i in range(4) for j in range(4)]
                    matrix = times(matrix, a)
                self.assertLess(defect(matrix), 1e-9)
            for g in generators:
                (a, b, c, d) = (complex(*w) for w in g["moebius"])
                self.assertLess(abs(a * d - b * c - 1), 1e-11)

    def test_cells(self):
        cells = self.json_answer("embed", TRIPUS, "--cells", "50")["cells"]
        self.assertEqual(len(cells), 50)
        distances = [cell["isometry"][15] for cell in cells]
        self.assertEqual(len({tuple(round(x, 6) for x in cell["isometry"][3::4])
                              for cell in cells}), 50)
        self.assertLess(distances[1], distances[-1])
        for number, cell in enumerate(cells[1:], start=1):
            self.assertLess(cell["parent"], number)
        self.assertEqual(len(self.json_answer("embed", TRIPUS, "--depth", "3")["cells"]), 53)
        self.assertEqual(len(self.json_answer("embed", TRIPUS, "--depth", "0")["cells"]), 1)
        near = self.json_answer("embed", TRIPUS, "--radius", "2")
        self.assertEqual(near["cells_end"], "complete")
        self.assertGreater(len(near["cells"]), 5)


class EmbedFiles(ProgramTest):
    def embed(self, *arguments):
        result = self.run_program("embed", TRIPUS, *arguments)
        self.assertEqual((result.status, result.err), (0, ""), result.err)
        return result.text

    def test_json_file(self):
        self.assertIn("written to      x.json", self.embed("-o", "x.json"))
        text = (self.folder / "x.json").read_text()
        self.assertTrue(text.endswith("}\n"))
        self.assertEqual(read_json(text)["tetrahedra"],
                         self.json_answer("embed", TRIPUS)["tetrahedra"])

    def obj(self, *arguments):
        self.embed("-o", "x.obj", *arguments)
        points, groups = [], {}
        for line in (self.folder / "x.obj").read_text().splitlines():
            words = line.split()
            if words[0] == "v":
                points.append([float(x) for x in words[1:4]])
            elif words[0] == "g":
                faces = groups.setdefault(words[1], [])
            elif words[0] == "f":
                faces.append([int(x) - 1 for x in words[1:]])
        return points, groups

    def test_obj_cells_are_closed_and_oriented(self):
        for model in ("upper", "ball", "klein"):
            points, groups = self.obj("--cells", "20", "--model", model)
            self.assertEqual(len(groups), 20)
            for faces in groups.values():
                sides = Counter((f[n], f[(n + 1) % 3]) for f in faces for n in range(3))
                self.assertTrue(all(count == 1 and sides[b, a] == 1
                                    for (a, b), count in sides.items()))
            if model == "upper":
                self.assertTrue(all(p[2] > 0 for p in points))
            else:
                self.assertTrue(all(sum(x * x for x in p) < 1 for p in points))

    def test_tessellation_error_refines(self):
        coarse, _ = self.obj("--tessellation", "0.1")
        fine, _ = self.obj("--tessellation", "0.001")
        self.assertGreater(len(fine), 8 * len(coarse))

    def test_ply(self):
        self.embed("-o", "x.ply", "--cells", "7", "--model", "klein")
        data = (self.folder / "x.ply").read_bytes()
        header, body = data.split(b"end_header\n", 1)
        lines = header.decode().splitlines()
        self.assertEqual(lines[:2], ["ply", "format binary_little_endian 1.0"])
        self.assertIn("element vertex 112", lines)
        self.assertIn("element face 196", lines)
        for property_ in ("uchar red", "int cell", "int tetrahedron"):
            self.assertIn(f"property {property_}", lines)
        self.assertEqual(len(body), 112 * 35 + 196 * 13)
        cells = [struct.unpack_from("<i", body, 35 * n + 27)[0] for n in range(112)]
        self.assertEqual(Counter(cells), Counter({c: 16 for c in range(7)}))

    def test_vtk(self):
        self.embed("-o", "x.VTK", "--cells", "3", "--model", "klein")
        data = (self.folder / "x.VTK").read_bytes()
        self.assertTrue(data.startswith(b"# vtk DataFile Version 3.0\n"))
        for words in (b"POINTS 48 double\n", b"POLYGONS 84 336\n", b"CELL_DATA 84\n",
                      b"SCALARS cell int 1\n", b"COLOR_SCALARS colour 3\n"):
            self.assertIn(words, data)

    def test_svg(self):
        self.embed("-o", "x.svg", "--cells", "1", "--circles", "y.svg")
        text = (self.folder / "x.svg").read_text()
        self.assertEqual(text, (self.folder / "y.svg").read_text())
        root = ElementTree.fromstring(text)
        tags = Counter(child.tag.split("}")[1] for child in root)
        # f1 and f2 are lines; f3, f4 and the four truncations are circles.
        self.assertEqual((tags["line"], tags["circle"], tags["text"]), (2, 6, 8))


class EmbedRefusals(ProgramTest):
    def test_bad_usage(self):
        for arguments, says in (
                (("--cells", "0"), "1 to 2000000"),
                (("--cells", "99999999999999"), "1 to 2000000"),
                (("--cells", "3", "--depth", "2"), "--"),
                (("--radius", "-1"), "--radius"),
                (("--radius", "nan"), "--radius"),
                (("--model", "disc"), "--model"),
                (("--tessellation", "0"), "--tessellation")):
            self.assert_refused("embed", TRIPUS, *arguments, says=says, kind="usage")

    def test_files(self):
        self.assert_refused("embed", TRIPUS, "-o", "x.dxf", says=".json or .obj or .ply or .off or .stl or .glb or .gltf or .float.vtk or .vtk or .svg")
        for option in ("-o", "--circles"):
            self.assert_refused("embed", TRIPUS, option, "", says=".svg", kind="usage")
        self.assert_refused("embed", TRIPUS, "--circles", "x.obj", says=".svg", kind="usage")
        self.assert_refused("embed", TRIPUS, "-o", "x.svg", "--circles", "./x.svg",
                            says="another name")
        self.assert_refused("embed", TRIPUS, "-o", "no/such/x.obj", says="No such file")
        self.assert_refused("embed", TRIPUS, "--circles", "no/such/x.svg", says="No such file")
        self.assert_refused("embed", TRIPUS, "-o", "x.obj", "--tessellation", "1e-30",
                            says="cannot be drawn")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_a_full_disk_is_reported(self):
        (self.folder / "full.obj").symlink_to("/dev/full")
        result = self.run_program("embed", TRIPUS, "-o", "full.obj")
        self.assertEqual((result.status, result.out), (3, b""))
        self.assertIn("No space left", result.err)

    def test_no_metric(self):
        result = self.run_program("embed", WITHOUT_METRIC, "-o", "x.ply")
        self.assertEqual(result.status, 1)
        self.assertIn("nothing was embedded", result.text)
        self.assertFalse((self.folder / "x.ply").exists())
        answer = self.json_answer("embed", WITHOUT_METRIC, status=1)
        self.assertEqual(answer["outcome"], "infeasible")
        self.assertNotIn("cells", answer)

    def test_what_was_there_stays_if_nothing_is_written(self):
        self.write("x.ply", "precious")
        self.assertEqual(self.run_program("embed", WITHOUT_METRIC, "-o", "x.ply").status, 1)
        self.assertEqual((self.folder / "x.ply").read_text(), "precious")

    def test_interruption_of_the_writing_leaves_whole_cells(self):
        process = subprocess.Popen(
            self.command("embed", TRIPUS, "--cells", "100000", "-o", "x.obj", "--json",
                         "--tessellation", "0.001"),
            cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        file, end = self.folder / "x.obj", time.monotonic() + 100
        while time.monotonic() < end and not writes_a_draft(process):
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        out, _ = process.communicate(timeout=100)
        answer = read_json(out.decode())
        self.assertEqual((process.returncode, answer["cells_end"]), (1, "interrupted"))
        lines = file.read_text().splitlines()
        groups = [line for line in lines if line.startswith("g ")]
        self.assertEqual(len(groups), len(answer["cells"]))
        self.assertLess(len(groups), 100000)
        points = sum(line.startswith("v ") for line in lines)
        self.assertEqual(lines[-1].split()[0], "f")
        self.assertEqual(max(int(word) for line in lines if line.startswith("f ")
                             for word in line.split()[1:]), points)

    def test_interruption_writes_what_is_there(self):
        for wait in (0.4, 1, 2, 4, 8):  # until it has begun to grow
            process = subprocess.Popen(
                self.command("embed", TRIPUS, "--cells", "2000000", "-o", "x.json"),
                cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            time.sleep(wait)
            process.send_signal(signal.SIGINT)
            out, _ = process.communicate(timeout=120)
            if (self.folder / "x.json").exists():
                break
            self.assertEqual(process.returncode, 1)
        else:
            return  # on a busy machine writing would have taken more than a second each time
        answer = read_json((self.folder / "x.json").read_text())
        if process.returncode == 1:
            self.assertEqual(answer["cells_end"], "interrupted")
            self.assertIn(b"interrupted", out)
            self.assertLess(len(answer["cells"]), 2000000)
        else:
            self.assertEqual(process.returncode, 0)  # a very fast machine
