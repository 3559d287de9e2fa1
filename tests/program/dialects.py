"""Files as other programs write them, read and written: tests/dialects."""

import gzip
import struct
from pathlib import Path

from support import DATA, TRIPUS, TRIPUS_VOLUME, ProgramTest, read_json

ROOT = DATA.parent
DIALECTS = ROOT / "tests" / "dialects"
SURFACE = ROOT / "examples" / "surfaces" / "knotted-y.off"
WORD = "[[1, \"1230\"], [1, \"3012\"], [1, \"0321\"], [1, \"0213\"]]"


def table():
    lines = (DIALECTS / "answers.tsv").read_text().splitlines()
    return dict(line.split("\t") for line in lines if line and not line.startswith("#"))


def surface():
    """Points and triangles of the knotted Y."""
    words = SURFACE.read_text().split()
    points, faces = int(words[1]), int(words[2])
    numbers = words[4:]
    return ([numbers[3 * i:3 * i + 3] for i in range(points)],
            [[int(x) for x in numbers[3 * points + 4 * i + 1:3 * points + 4 * i + 4]]
             for i in range(faces)])


class Dialects(ProgramTest):
    def mesh(self, name, content, note=None):
        answer = self.json_answer("mesh", self.write(name, content))
        self.assertEqual(answer["isosig"], TRIPUS, name)
        if note is not None:
            self.assertTrue(any(note in each for each in answer["notes"]), answer["notes"])
        return answer

    def test_files_of_the_table(self):
        for name, notes in table().items():
            with self.subTest(name):
                answer = self.mesh(name, (DIALECTS / name).read_bytes())
                if notes == "-":
                    self.assertEqual(answer["notes"], [])
                else:
                    for note in notes.split("; "):
                        self.assertIn(note, "\n".join(answer["notes"]))

    def test_notes_are_said_by_every_verb(self):
        name = "off-t-junction.off"
        self.write(name, (DIALECTS / name).read_bytes())
        result = self.run_program("solve", name)
        self.assertEqual(result.status, 0)
        self.assertEqual(result.err, f'tripus: note: "{name}": 1 triangle split at points in the '
                                     "middle of a side\n")
        self.assertIn("\n  note ", self.run_program("mesh", name).text)

    def test_gzip(self):
        self.mesh("y.off.gz", gzip.compress(SURFACE.read_bytes()))
        cut = gzip.compress(SURFACE.read_bytes())[:-400]
        self.assert_refused("mesh", self.write("cut.gz", cut), says="the compressed data are cut off")

    def test_binary_off(self):
        points, faces = surface()
        data = b"OFF BINARY\n" + struct.pack(">3i", len(points), len(faces), 0)
        data += b"".join(struct.pack(">3f", *map(float, p)) for p in points)
        data += b"".join(struct.pack(">5i", 3, *f, 0) for f in faces)
        self.mesh("binary.off", data)
        # As OpenMesh writes it.
        data = b"OFF BINARY\n" + struct.pack("<3i", len(points), len(faces), 0)
        data += b"".join(struct.pack("<3f", *map(float, p)) for p in points)
        data += b"".join(struct.pack("<4i", 3, *f) for f in faces)
        self.mesh("little-endian.off", data)

    def test_off_headers_and_colours(self):
        points, faces = surface()
        rows = "".join("3 %d %d %d 200 0 0\n" % tuple(f) for f in faces)

        def file(head, extra, colours=rows):
            return head + f"\n{len(points)} {len(faces)}\n" + "".join(
                " ".join(p) + extra + "\n" for p in points) + colours

        for head, extra in (("COFF", " 255 0 0 255"), ("COFF", " 255 0 0"), ("NOFF", " 0 0 1"),
                            ("STOFF", " 0.5 0.5"), ("STCNOFF", " 0 0 1 1 0 0 1 0 0"),
                            ("4OFF", " 1"), ("OFF", " 255 0 0"), ("OFF # a comment", "")):
            with self.subTest(head=head, extra=extra):
                self.mesh("x.off", file(head, extra))
        self.mesh("n.off", file("nOFF 3", ""))
        self.mesh("braces.off", "{ " + file("OFF", "") + "}\n")
        self.mesh("cr.off", file("OFF", "").replace("\n", "\r"))
        flat = file("OFF", "", "".join("3 %d %d %d\n" % tuple(f) for f in faces))
        self.mesh("one-line.off", " ".join(flat.split()))
        wide = "OFF\n%d %d 0\n" % (len(points), len(faces)) + "\n".join(
            " ".join(points[i] + points[i + 1]) for i in range(0, len(points), 2)) + "\n" + rows
        self.mesh("two-a-line.off", wide)

    def test_polygons(self):
        points, faces = surface()
        # A pyramid on the first triangle makes three; the first of them and a neighbour, one quad.
        a, b, c = faces[0]
        side = next(f for f in faces[1:] if a in f and b in f)
        d = next(x for x in side if x not in (a, b))
        rest = [f for f in faces[1:] if f is not side]
        polygon = [a, d, b, c]
        text = "OFF\n%d %d 0\n" % (len(points), len(rest) + 1)
        text += "".join(" ".join(p) + "\n" for p in points)
        text += "".join(" ".join(map(str, [len(f)] + f)) + "\n" for f in [polygon] + rest)
        self.mesh("quad.off", text, "1 face of more than three corners cut into triangles")
        text = "".join("v " + " ".join(p) + "\n" for p in points)
        text += "".join("f " + " ".join(str(x + 1) for x in f) + "\n" for f in [polygon] + rest)
        self.mesh("quad.obj", text, "cut into triangles")

    def test_save_mesh_has_the_boundary(self):
        self.write("y.off", SURFACE.read_bytes())
        for name in ("y.mesh", "y.msh", "y.vtk"):
            with self.subTest(name):
                self.json_answer("mesh", "y.off", "--save-mesh", name)
                answer = self.json_answer("mesh", name)
                self.assertEqual(answer["isosig"], TRIPUS)
                self.assertEqual(answer["notes"], [])
        text = (self.folder / "y.mesh").read_text()
        self.assertIn("\nTriangles\n3000\n", text)

    def test_tube_writes_what_the_name_says(self):
        graph = (ROOT / "examples" / "graphs" / "knotted-y.json").read_bytes()
        self.write("y.json", graph)
        for name, begin in (("x.stl", b"binary STL"), ("x.ply", b"ply\n"), ("x.obj", b"# a surface"),
                            ("x.off", b"OFF\n"), ("x.OFF", b"OFF\n")):
            with self.subTest(name):
                result = self.run_program("tube", "y.json", "-o", name, "--resolution", "4")
                self.assertEqual(result.status, 0, result.err)
                self.assertTrue((self.folder / name).read_bytes().startswith(begin))
        self.assertEqual(self.json_answer("mesh", "x.stl")["isosig"], TRIPUS)
        result = self.run_program("tube", "y.json", "-o", "x.xyz")
        self.assertEqual(result.status, 2)
        self.assertIn("must end with one of .off, .obj, .ply, .stl", result.err)

    def test_one_message_for_unknown_files(self):
        for content in (b"\x01\x02\xff\xfe raw", b"two words\n", b"2750\n 0.37 1.35\n 0.6 1.5\n",
                        b"<html></html>"):
            name = self.write("unknown.bin", content)
            messages = set()
            for verb in ("info", "solve", "mesh", "simplify", "canonize"):
                result = self.run_program(verb, name)
                self.assertEqual(result.status, 2)
                messages.add(result.err)
            self.assertEqual(len(messages), 1, messages)
            message = messages.pop()
            for words in ("has no format that is known; looked for: JSON", "isomorphism signature",
                          "VTK legacy", "Gmsh mesh", "TetGen .node and .ele"):
                self.assertIn(words, message)
            self.assertNotIn("\\x", message)

    FOREIGN = (
        (b"glTF\x02\0\0\0", "a binary glTF file", "assimp export"),
        (b'{"asset": {"version": "2.0"}, "accessors": []}', "a glTF file", "assimp export"),
        (b"PK\x03\x04\x14\0", "a zip archive, as 3MF files are", ""),
        (b'<?xml version="1.0"?>\n<COLLADA xmlns="x" version="1.4.1"/>', "a COLLADA file", "assimp"),
        (b'<?xml version="1.0"?>\n<X3D version="3.0"/>', "an X3D file", "assimp export"),
        (b'<?xml version="1.0"?>\r\n<amf unit="millimeter"/>', "an AMF file", "assimp export"),
        (b"#VRML V2.0 utf8\n", "a VRML file", ""),
        (b"MM\x0c\0\0\0\x02\0\x06\0\0\0", "a 3DS file", "assimp export"),
        (b"  0\nSECTION\n  2\nENTITIES\n  0\nEOF\n", "a DXF file", "assimp export"),
        (b"999\nby hand\n0\nSECTION\n", "a DXF file", "assimp export"),
        (b"xof 0303txt 0032\n", "a DirectX file", "assimp export"),
        (b"Kaydara FBX Binary  \0", "an FBX file", "assimp export"),
        (b"BLENDER-v300", "a Blender file", ""),
        (b"OCTM\x05\0\0\0", "an OpenCTM file", ""),
        (b"ISO-10303-21;\nHEADER;\n", "a STEP file", ""),
        (b"\x01\0\0\0\x02\0\0\0", "a binary Medit mesh", "meshio convert"),
        (b"\0\0\0\x01\0\0\0\x03", "a binary Medit mesh", "meshio convert"),
        (b"*Heading\n model\n*NODE\n", "an Abaqus mesh", "meshio convert"),
        (b'(1 "meshio 5.3.5")\n(2 3)\n', "an ANSYS (Fluent) mesh", "meshio convert"),
        (b"\x89HDF\r\n\x1a\n", "an HDF5 file", "meshio convert"),
        (b"CDF\x02\0\0\0\0", "a NetCDF file", "meshio convert"),
        (b"# by NETGEN\n\nmesh3d\ndimension\n3\n", "a Netgen mesh", "meshio convert"),
        (b"surfacemesh\n4\n", "a surface mesh of Netgen", ""),
        (b"$NOD\n4\n", "a Gmsh mesh of the version 1", ""),
    )

    def test_meshes_of_other_formats_are_named(self):
        for content, name, converter in self.FOREIGN:
            with self.subTest(name):
                path = self.write("x.bin", content)
                for verb in ("mesh", "solve"):
                    self.assert_refused(verb, path, says=f"it is {name}")
                    self.assertIn(converter, self.run_program(verb, path).err)


class Triangulations(ProgramTest):
    def test_old_regina_and_several(self):
        for name in ("regina-4.5.rga", "regina-two-plain.rga", "regina-two-compressed.rga"):
            with self.subTest(name):
                self.write(name, (DIALECTS / name).read_bytes())
                label = 'Tripus & "co" <1>'
                self.assertEqual(self.json_answer("info", f"{name}#{label}")["isosig"], TRIPUS)
                self.assertEqual(self.json_answer("info", f"{name}#{label}")["name"], label)
                self.assertEqual(self.json_answer("info", f"{name}#1")["isosig"], TRIPUS)
                self.assertEqual(self.json_answer("info", f"{name}#second")["tetrahedron_count"], 3)
                self.assert_refused("info", name, says="it holds 2 triangulations")
                self.assert_refused("info", f"{name}#third", says="no triangulation has the label")
                batch = self.run_program("info", "--batch", name, "--json")
                answers = [read_json(line) for line in batch.lines]
                self.assertEqual([a["input"] for a in answers],
                                 [f"{name}#{label}", f"{name}#second"])
                self.assertEqual(answers[0]["isosig"], TRIPUS)
                result = self.run_program("census", "--from", name, "--tsv", "-")
                self.assertEqual(result.status, 0, result.err)
                self.assertIn("6.4519902708350", result.text)
                self.assertIn("\tdLQ", result.text)
                result = self.run_program("view", "--gallery", name, "-o", "index.html")
                self.assertEqual(result.text.count("page written to"), 2, result.err)

    def test_files_that_are_not_there_are_no_signatures(self):
        for name in ("graph.json", "surface.v2.off"):
            self.assert_refused("solve", name, says="there is no file")

    def test_line_ends_of_old_macintoshes(self):
        for name in ("snappea-free-form.tri", "regina-two-plain.rga"):
            old = self.write(name, (DIALECTS / name).read_bytes().replace(b"\n", b"\r"))
            self.assertEqual(self.json_answer("info", f"{old}#1")["isosig"], TRIPUS)
        self.write("list", f"{TRIPUS}\r# a comment\rcPcbbbiht\r")
        answers = [read_json(line)["isosig"]
                   for line in self.run_program("info", "--batch", "list", "--json").lines]
        self.assertEqual(answers, [TRIPUS, "cPcbbbiht"])

    def test_snappea_without_a_name(self):
        lines = (DIALECTS / "snappea-free-form.tri").read_text().splitlines(keepends=True)
        for second in ("", "\n"):
            name = self.write("x.tri", "".join(lines[:1] + [second] + lines[2:]))
            answer = self.json_answer("info", name)
            self.assertEqual(answer["isosig"], TRIPUS)
            self.assertNotIn("name", answer)

    def test_free_form_snappea(self):
        name = self.write("free.tri", (DIALECTS / "snappea-free-form.tri").read_bytes())
        answer = self.json_answer("solve", name)
        self.assertEqual(answer["isosig"], TRIPUS)
        self.assertAlmostEqual(answer["volume"], TRIPUS_VOLUME, delta=1e-12)

    def test_fillings_are_refused(self):
        text = (DIALECTS / "snappea-free-form.tri").read_text().replace(
            "0 0\n", "1 0\ntorus -3.000000000000 1.000000000000\n", 1)
        self.assert_refused("info", self.write("filled.tri", text), kind="unsupported",
                            says="has the Dehn filling \"(-3.000000000000,1.000000000000)\"")
        for word in ("cPcbbbiht_BaCB(1,2)", "eLPkbdcddhgggb_BaaBBaaB(0,0)(3,2)", "cPcbbbiht(5,1)"):
            self.assert_refused("info", word, kind="unsupported", says="has the Dehn filling")

    def test_decorated_and_locked_signatures(self):
        for word, signature, note in (
                ("cPcbbbiht_BaCB", "cPcbbbiht", "the peripheral curves of the decorated signature"),
                ("cPcbbbiht_BaCB(0,0)", "cPcbbbiht", "the peripheral curves"),
                ("cPcbbbihq.qa", TRIPUS, "the locks of the signature")):
            for as_file in (False, True):
                with self.subTest(word, as_file=as_file):
                    given = self.write("x.sig", word + "\n") if as_file else word
                    result = self.run_program("info", given, "--json")
                    self.assertEqual(read_json(result.text)["isosig"], signature)
                    self.assertIn(note, result.err)

    def test_what_is_written_is_read(self):
        for ending in ("json", "sig", "rga", "tri"):
            with self.subTest(ending):
                self.run_program("simplify", TRIPUS, "-o", f"x.{ending}")
                self.assertEqual(self.json_answer("info", f"x.{ending}")["isosig"], TRIPUS)
        self.assertIn('<tri dim="3" size="2" perm="index"', (self.folder / "x.rga").read_text())


class Graphs(ProgramTest):
    def mesh_of(self, name, content):
        self.write(name, content)
        result = self.run_program("tube", name, "-o", "x.off", "--resolution", "4")
        self.assertEqual(result.status, 0, result.err)
        return self.json_answer("mesh", "x.off")

    def test_a_graph_in_every_format(self):
        graph = read_json((ROOT / "examples" / "graphs" / "knotted-theta.json").read_text())
        edges = graph["edges"]
        self.assertNotIn("outer", graph)
        lists = "\n\n".join("\n".join("%r, %r %r" % tuple(p) for p in edge) for edge in edges)
        vect = "VECT\n%d %d 0\n%s\n%s\n%s\n" % (
            len(edges), sum(map(len, edges)), " ".join(str(len(e)) for e in edges),
            " ".join("0" for _ in edges), "\n".join("%r %r %r" % tuple(p) for e in edges for p in e))
        obj, pieces, count = "o graph\n", "", 0
        for edge in edges:
            obj += "".join("v %r %r %r\n" % tuple(p) for p in edge)
            pieces += "".join("l %d %d\n" % (count + i, count + i + 1) for i in range(1, len(edge)))
            count += len(edge)
        wanted = self.mesh_of("y.json", (ROOT / "examples/graphs/knotted-theta.json").read_bytes())
        for name, content in (("y.xyz", lists), ("y.vect", vect), ("y.obj", obj + pieces),
                              ("before.obj", pieces + obj),
                              ("continued.obj", "vn 0 0 1\n" + obj + pieces.replace(" ", " \\\n")),
                              ("brace.vect", "{ " + vect + "}"), ("glued.vect", "{" + vect + "}"),
                              ("named.vect", "{ appearance { linewidth 4 }\n= " + vect + "}")):
            with self.subTest(name):
                answer = self.mesh_of(name, content)
                self.assertEqual(answer["boundary_genera"], wanted["boundary_genera"])
                self.assertEqual(answer["isosig"], wanted["isosig"])

    def test_drawings_are_told_from_triangulations_by_every_verb(self):
        line = "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3 1\n"
        for name, content in (("g.json", (ROOT / "examples/graphs/trefoil.json").read_text()),
                              ("g.vect", "VECT 1 3 0 -3 0\n0 0 0 1 0 0 0 1 0\n"),
                              ("b.vect", "{ = VECT 1 3 0 -3 0\n0 0 0 1 0 0 0 1 0\n}"),
                              ("g.obj", "# Blender\no knot\n" + line),
                              ("g.xyz", "0 0 0\n1 0 0\n0, 1, 0\n")):
            self.write(name, content)
            for verb in ("info", "solve", "mesh", "canonize", "embed"):
                with self.subTest(name, verb=verb):
                    self.assert_refused(verb, name, says="it is a drawing of a graph in space")
                    self.assertIn("tripus tube", self.run_program(verb, name).err)
        self.assert_refused("mesh", self.write("s.obj", line + "f 1 2 3\n"), says="is open")
        result = self.run_program("info", self.write("dt.txt", "[4, 6, 2]\n"), "--json")
        self.assertEqual(read_json(result.text)["H1"], "Z")

    def test_a_knot_closes_up(self):
        triangle = "0 0 0\n1 0 0\n0 1 0\n"
        for name, content in (("k.xyz", triangle), ("k.vect", "VECT 1 3 0 -3 0\n" + triangle)):
            self.assertEqual(self.mesh_of(name, content)["boundary_genera"], [0, 1])

    def test_refusals(self):
        for content, says in (("OFF\n", "looked for: VECT, JSON, Wavefront OBJ with lines, list of"),
                              ("v 0 0 0\nv 1 0 0\nf 1 2 1\n", "this is a surface"),
                              ("v 0 0 0\nl 1 7\n", "point 7 does not exist"),
                              ("0 0 0\n1 0\n", "line 2: nothing where a coordinate"),
                              ("VECT 1 2 0 3 0", "were announced")):
            with self.subTest(content):
                result = self.run_program("tube", self.write("bad", content), "-o", "x.off")
                self.assertEqual(result.status, 2)
                self.assertIn(says, result.err)


class Surfaces(ProgramTest):
    def test_embed_in_every_format(self):
        for name, begin in (("x.off", b"OFF\n224 392 0\n"), ("x.stl", b"cells of a universal"),
                            ("x.glb", b"glTF\x02\0\0\0"), ("x.gltf", b'{"asset":{"version":"2.0"'),
                            ("x.float.vtk", b"# vtk DataFile Version 3.0")):
            with self.subTest(name):
                result = self.run_program("embed", TRIPUS, "--cells", "14", "--model", "klein", "-o",
                                          name)
                self.assertEqual(result.status, 0, result.err)
                self.assertTrue((self.folder / name).read_bytes().startswith(begin))
        self.assertEqual((self.folder / "x.stl").stat().st_size, 84 + 50 * 392)
        self.assertIn(b"POINTS 224 float\n", (self.folder / "x.float.vtk").read_bytes())

    def test_binary_gltf_is_well_formed(self):
        self.run_program("embed", TRIPUS, "--cells", "5", "--model", "klein", "-o", "x.glb")
        data = (self.folder / "x.glb").read_bytes()
        magic, version, size, length, kind = struct.unpack_from("<4sIII4s", data)
        self.assertEqual((magic, version, size, kind), (b"glTF", 2, len(data), b"JSON"))
        document = read_json(data[20:20 + length].decode())
        body = data[28 + length:]
        self.assertEqual(struct.unpack_from("<I4s", data, 20 + length), (len(body), b"BIN\0"))
        self.assertEqual(document["buffers"], [{"byteLength": len(body)}])
        triangles = 0
        for mesh in document["meshes"]:
            primitive = mesh["primitives"][0]
            points = document["accessors"][primitive["attributes"]["POSITION"]]
            corners = document["accessors"][primitive["indices"]]
            view = document["bufferViews"][corners["bufferView"]]
            numbers = struct.unpack_from(f"<{corners['count']}I", body, view["byteOffset"])
            self.assertLess(max(numbers), points["count"])
            triangles += corners["count"] // 3
        self.assertEqual(triangles, 5 * 28)
