"""tripus view: pictures without a display, and what is refused."""

import json
import os
import resource
import signal
import struct
import subprocess
import time
import zlib

from support import TRIPUS, ProgramTest, read_json


def read_png(data):
    """Width, height, and the colours of the pixels as (red, green, blue), rows from the top."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "no PNG file"
    at, packed, size = 8, b"", None
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            size = struct.unpack(">IIBBBBB", body)
        packed += body if kind == b"IDAT" else b""
        at += 12 + length
    width, height, depth, colour, _, _, interlaced = size
    assert depth == 8 and colour in (2, 6) and interlaced == 0, "not 8-bit RGB or RGBA"
    n = 3 if colour == 2 else 4  # bytes of a pixel
    raw, stride, rows = zlib.decompress(packed), n * width, []
    before = bytearray(stride)
    for y in range(height):
        kind = raw[y * (stride + 1)]
        row = bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left = row[i - n] if i >= n else 0
            up, corner = before[i], before[i - n] if i >= n else 0
            guess = left + up - corner
            paeth = min((abs(guess - v), k, v) for k, v in enumerate((left, up, corner)))[2]
            row[i] = (row[i] + (0, left, up, (left + up) // 2, paeth)[kind]) & 255
        rows.append([tuple(row[n * x:n * x + 3]) for x in range(width)])
        before = row
    return width, height, rows


class Pictures(ProgramTest):
    def picture(self, *arguments, size=(96, 72)):
        result = self.run_program("view", *arguments, "--png", "out.png",
                                  "--size", f"{size[0]}x{size[1]}")
        self.assertEqual(result.status, 0, result.err)
        self.assertEqual(result.err, "")
        width, height, rows = read_png((self.folder / "out.png").read_bytes())
        self.assertEqual((width, height), size)
        return rows

    def drawn(self, rows):
        """Pixels with a colour: the background has none."""
        return sum(max(p) - min(p) > 40 for row in rows for p in row)

    def test_of_every_model_and_number_of_cells(self):
        seen = []
        for model in ("upper", "ball", "klein"):
            for cells in ("1", "2", "20"):
                rows = self.picture(TRIPUS, "--model", model, "--cells", cells,
                                    "--camera", "60,20,4.2")
                self.assertGreater(self.drawn(rows), 40, (model, cells))
                self.assertGreater(min(rows[0][0]), 200)  # the corner is background
                self.assertNotIn(rows, seen)
                seen.append(rows)

    def test_shows_what_was_asked_for(self):
        usual = self.picture(TRIPUS, "--model", "ball")
        self.assertEqual(usual, self.picture(TRIPUS, "--model", "ball"))  # the same every time
        for change in (["--renderer", "opencsg"], ["--colour-by", "face"],
                       ["--colour-by", "depth"], ["--no-truncations"],
                       ["--colour-by", "component"], ["--colour-by", "edge"],
                       ["--dark"], ["--transparent", "1"], ["--no-lines"],
                       ["--moebius", "1,0,0.2,0.1,0,0,1,0"], ["--camera", "30,20,4.2,2,0.1,0"],
                       ["--no-faces"], ["--cut-away", "0"], ["--camera", "120,-30,6"]):
            self.assertFalse(usual == self.picture(TRIPUS, "--model", "ball", *change), change)

    def test_from_inside(self):
        seen = []
        for options in (["centre"], ["wall"], ["edge"], ["wall", "--dark"], ["wall", "--no-lines"],
                        ["wall", "--colour-by", "component"]):
            rows = self.picture(TRIPUS, "--inside", *options)
            self.assertGreater(len({p for row in rows for p in row}), 200, options)
            self.assertNotIn(rows, seen)
            seen.append(rows)
        identity = "0," + ",".join(str(int(i % 5 == 0)) for i in range(16))
        self.assertNotIn(self.picture(TRIPUS, "--inside", identity), seen)
        answer = self.json_answer("view", TRIPUS, "--inside", "wall", "--png", "inside.png")
        self.assertEqual((answer["cells"], answer["file"]), (None, "inside.png"))
        for signature in ("cPcbbbiht", "bkaaid"):  # with a cusp, and not orientable
            self.assertGreater(self.drawn(self.picture(signature, "--inside", "centre")), 200)

    def test_from_inside_of_ten_thousand_tetrahedra(self):
        self.run_program("cover", TRIPUS, "--cyclic", "5000", "--limit", "1", "-o", "covers/")
        rows = self.picture("covers/cover-000001.json", "--inside", "wall", "--no-lines")
        self.assertEqual(rows, self.picture("covers/cover-000001.json", "--inside", "wall", "--no-lines"))
        self.assertGreater(len({p for row in rows for p in row}), 200)
        cover = read_json((self.folder / "covers/cover-000001.json").read_bytes())
        self.write("parabolic.json", json.dumps(cover | {"cone_orders": [0] * 5000}))
        # The same walls as in the manifold that it covers, with other colours.
        ink = [{(x, y) for y, row in enumerate(self.picture(manifold, "--inside", "wall", "--no-lines"))
                for x in range(3, len(row) - 3)
                if sum(row[x]) < 0.85 * min(sum(row[x - 3]), sum(row[x + 3]))}
               for manifold in ("parabolic.json", TRIPUS + " 0=0")]
        self.assertGreater(len(ink[0] & ink[1]), 0.9 * len(ink[1]))
        self.assertGreater(len(ink[1]), 50)

    def test_of_cusps_finite_vertices_and_singular_edges(self):
        seen = []
        for arguments in (["cPcbbbiht"], ["dLQacccjjkg"], ["bkaaid", "--model", "klein"],
                          ["cPcbbbiht", "--cone-order", "0=2,1=2"],
                          ["cPcbbbiht", "--cone-order", "0=3", "--cone-order", "1=3"],
                          ["dLQacccjjkg", "--renderer", "opencsg", "--cells", "3"]):
            rows = self.picture(*arguments)
            self.assertGreater(self.drawn(rows), 40, arguments)
            self.assertNotIn(rows, seen)
            seen.append(rows)
        # Singular edges are red.
        usual, singular = (self.picture("cPcbbbihq", *more, size=(640, 480))
                           for more in ([], ["--cone-order", "0=2"]))
        red = [sum(p[0] > p[1] + p[2] + 40 and p[1] < 1.3 * p[2] for row in rows for p in row)
               for rows in (usual, singular)]
        self.assertEqual(red[0], 0)
        self.assertGreater(red[1], 20)

    def test_of_parabolic_edges(self):
        seen = []
        for arguments in (["--model", "upper"], ["--model", "ball"], ["--model", "klein"],
                          ["--model", "klein", "--cut-away", "0"], ["--colour-by", "component"],
                          ["--colour-by", "edge"], ["--renderer", "opencsg", "--cells", "3"],
                          ["--inside", "centre"], ["--inside", "wall"], ["--no-faces"],
                          ["--inside", "wall", "--colour-by", "component"], ["--transparent", "0"]):
            for manifold in (TRIPUS + " 0=0", "dLQbcccherw 1=0"):
                rows = self.picture(manifold, *arguments)
                self.assertGreater(len({p for row in rows for p in row}), 200, arguments)
                self.assertNotIn(rows, seen)
                seen.append(rows)
        message = self.run_program("view", TRIPUS + " 0=0", "--png", "a.png", "--model", "klein",
                                   "--renderer", "opencsg")
        self.assertEqual(message.status, 2)
        self.assertIn("opencsg", message.err)

    def test_names_are_written_where_there_is_room(self):
        pictures = [self.picture(TRIPUS, "--cells", "2", *labels, size=size)
                    for size in ((240, 180), (40, 30)) for labels in ([], ["--labels"])]
        ink = [sum(max(p) < 60 for row in rows for p in row) for rows in pictures]
        self.assertGreater(ink[1], ink[0] + 20)
        self.assertEqual(ink[2], ink[3])

    def test_works_without_a_display(self):
        environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        result = self.run_program("view", TRIPUS, "--png", "a.png", "--size", "40x30", "--json",
                                  env=environment)
        self.assertEqual((result.status, result.err), (0, ""))
        self.assertIn('"cells": 20', result.text)
        self.assertIn('"file": "a.png"', result.text)


class Discs(ProgramTest):
    """--discs: what the option takes. Where they are drawn: tests/cross/viewer_discs.cpp, web.py."""

    def picture(self, *arguments):
        result = self.run_program("view", *arguments, "--png", "out.png", "--size", "64x48",
                                  "--cells", "2")
        self.assertEqual((result.status, result.err), (0, ""))
        return (self.folder / "out.png").read_bytes()

    def test_with_and_without_a_length_before_and_after_the_input(self):
        usual = self.picture(TRIPUS)
        some = self.picture(TRIPUS, "--discs")
        few = self.picture(TRIPUS, "--discs", "1")
        self.assertEqual(len({usual, some, few}), 3)
        self.assertEqual(self.picture("--discs", TRIPUS), some)
        self.assertEqual(self.picture("--discs", "1", TRIPUS), few)
        self.assertEqual(self.picture("--discs=1", TRIPUS), few)

    def test_bad_lengths(self):
        for length in ("0", "-1", "nan", "inf", "1e9", "20.1"):
            self.assert_refused("view", TRIPUS, "--discs", length, "--png", "a.png",
                                says="at most 20", kind="usage")
        self.assert_refused("view", TRIPUS, "--discs", "many", "--png", "a.png", says="--discs",
                            kind="usage")
        self.assert_refused("view", "--discs", "2", "--png", "a.png", says="INPUT", kind="usage")
        self.assert_refused("view", TRIPUS, "--discs", "17", "--png", "a.png", says="--discs 17")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_in_a_gallery(self):
        self.write("list", TRIPUS + "\ndLQbccchrqg\n")
        result = self.run_program("view", "--gallery", "list", "--discs", "2", "-o", "index.html")
        self.assertEqual((result.status, result.err), (0, ""))
        for page in self.folder.glob("0*.html"):
            self.assertIn('"discs":{"length":2', page.read_text())


class WindowsWithoutADisplay(ProgramTest):
    def test_say_what_to_do(self):
        environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        result = self.run_program("view", TRIPUS, "--cells", "1", env=environment)
        self.assertEqual((result.status, result.out), (2, b""))
        self.assertIn("--png", result.err)
        self.assertIn("page.html", result.err)
        self.assertEqual(len(result.err.splitlines()), 1)


class InterruptedPictures(ProgramTest):
    def test_hold_the_cells_drawn_so_far(self):
        # A minute of work, of which the nearest cells are soon done.
        run = subprocess.Popen(
            self.command("view", TRIPUS, "--model", "ball", "--cells", "20000", "--size",
                         "1600x1200", "--png", "a.png", "--json", "--renderer", "opencsg"),
            cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        time.sleep(2)
        run.send_signal(signal.SIGINT)
        out, err = run.communicate(timeout=100)
        # Of the processor: a machine may be busy. The whole picture takes a minute.
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.assertLess(used.ru_utime + used.ru_stime, 30)
        self.assertEqual(run.returncode, 1)
        answer = read_json(out.decode())
        written = (self.folder / "a.png").exists()
        if written:
            self.assertIn(answer["cells"], range(1, 20000))
            self.assertEqual(answer["file"], "a.png")
            self.assertEqual(err, b"")
        else:  # it had come to no cell yet
            self.assertEqual(answer["error"]["kind"], "interrupted")


class RefusedViews(ProgramTest):
    def refused(self, *arguments):
        result = self.run_program("view", TRIPUS, *arguments)
        self.assertEqual((result.status, result.out), (2, b""), arguments)
        self.assertFalse((self.folder / "a.png").exists())
        return result.err

    def test_sizes(self):
        for size in ("0x10", "10", "10x", "x", "1e9x10", "99999x10", "10x-5", "10x10x10", "nanx4",
                     "1.5x3"):
            self.assertIn("4096", self.refused("--png", "a.png", "--size", size))

    def test_cells(self):
        for cells in ("0", "-1", "1000000000", "99999999999999999999", "x", "1.5"):
            self.assertIn("--cells", self.refused("--png", "a.png", "--cells", cells))

    def test_cameras_and_cuts(self):
        for camera in ("1,2", "a,b,c", "0,90,4", "0,0,1", "nan,0,4", "0,inf,4", "0,0,1e9",
                       "0,0,4,0,0,0", "0,0,4,1e9,0,0", "0,0,4,1e-9,0,0", "0,0,4,1,9,0",
                       "0,0,4,1,0,-1e9", "0,0,4,1,nan,0", "0,0,4,1,0"):
            self.assertIn("camera", self.refused("--png", "a.png", "--camera", camera))
        for cut in ("x", "nan", "inf"):
            self.assertIn("cut", self.refused("--png", "a.png", "--cut-away", cut))

    def test_options_of_pictures_alone(self):
        for option in (["--labels"], ["--dark"], ["--camera", "1,2,4"], ["--transparent", "0"],
                       ["--colour-by", "edge"], ["--moebius", "1,0,0.2,0,0,0,1,0"]):
            self.assertIn(option[0], self.refused("-o", "a.html", *option))

    def test_places_inside(self):
        for place in ("somewhere", "1", "2" + ",0" * 16, "0" + ",0" * 16, "0,nan" + ",0" * 15,
                      "0,1,0,0,0,0,1,0,0,0,0,1,9,0,0,0,9"):
            self.assertIn("inside", self.refused("--png", "a.png", "--inside", place))
        self.assertIn("--inside", self.refused("-o", "a.html", "--inside", "wall"))

    def test_moebius_maps(self):
        for numbers in ("1", "1,0,0,0,0,0,1", "1,0,0,0,0,0,1,x", "0,0,0,0,0,0,0,0",
                        "1,0,1,0,1,0,1,0", "nan,0,0,0,0,0,1,0", "1e9,0,0,0,0,0,1,0", "inf,0,0,0,0,0,1,0"):
            self.assertIn("moebius", self.refused("--png", "a.png", "--moebius", numbers))
        for options in (["--moebius", "2,0,0,0,0,0,1,0"], ["--transparent", "0"],
                        ["--colour-by", "edge"], ["--no-lines"]):
            self.assertIn("opencsg", self.refused("--png", "a.png", "--renderer", "opencsg", *options))

    def test_tetrahedra(self):
        for number in ("2", "-1", "x", "99999999999"):
            self.assertIn("transparent", self.refused("--png", "a.png", "--transparent", number))

    def test_names(self):
        self.refused("--png", "a.png", "--model", "disk")
        self.refused("--png", "a.png", "--renderer", "rays")
        self.refused("--png", "a.png", "--colour-by", "mood")
        self.refused("--png", "a.png", "--no-faces", "--no-truncations")

    def test_files_that_cannot_be_written(self):
        (self.folder / "folder.png").mkdir()
        for path in ("missing/a.png", "folder.png"):
            self.assertIn("cannot write", self.refused("--png", path, "--size", "20x20"))

    def test_names_of_files(self):
        for name in ("", "a.gif", "png", "/", "."):
            self.assertIn("must end with .png", self.refused("--png", name))
            self.assertFalse((self.folder / "a.gif").exists())

    def test_no_metric(self):
        result = self.run_program("view", "dLQbcbcaekw", "--png", "a.png")
        self.assertEqual(result.status, 1)
        self.assertIn("infeasible", result.text)
        self.assertFalse((self.folder / "a.png").exists())

    def test_no_input(self):
        result = self.run_program("view", "--png", "a.png")
        self.assertEqual(result.status, 2)
        self.assertIn("INPUT", result.err)
