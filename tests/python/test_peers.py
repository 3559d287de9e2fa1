"""There and back, against the real packages: SnapPy, Regina, meshio, trimesh, PyVista, pandas."""

import math

import numpy as np
import pytest
from conftest import DATA, ROOT, column, signatures

import tripus

snappy = pytest.importorskip("snappy", exc_type=ImportError)
regina = pytest.importorskip("regina", exc_type=ImportError)

#: Every list of signatures in data/, the largest thinned; tests/full/python_peers.py takes all.
EVERY = (
    signatures("triangulations-2.txt") + signatures("triangulations-3.txt")
    + signatures("triangulations-4.txt", 100) + signatures("triangulations-cusped.txt")
    + column("cusped-census-5.tsv", 1)[1:200:4]
)


def same(first, second):
    return first.triangulation_isosig() == second.triangulation_isosig()


def test_regina_there_and_back():
    for text in EVERY:
        M = tripus.Manifold(text)
        R = M.to_regina()
        assert R.isoSig() == M.triangulation_isosig() == text
        again = tripus.Manifold(R)
        assert again.gluings == M.gluings, "the labels are kept"
    assert tripus.Manifold(regina.Example3.figureEight()) == tripus.Manifold("cPcbbbiht")


def test_regina_keeps_the_orientation():
    for sign in "+-":
        M = tripus.Manifold("dLQbcccdero" + sign)
        again = tripus.Manifold(M.to_regina())
        assert again.triangulation_isosig(oriented=True) == "dLQbcccdero" + sign


def test_regina_objects_that_are_more_or_less():
    R = regina.Triangulation3()
    R.newTetrahedron()
    with pytest.warns(tripus.InputNote, match="coned"):
        ball = tripus.Manifold(R)
    assert ball.has_finite_vertices()
    S = regina.SnapPeaTriangulation(regina.Example3.figureEight())
    assert tripus.Manifold(S).volume() == pytest.approx(2.029883212819307, abs=1e-12)
    S.fill(1, 2, 0)
    with pytest.raises(tripus.Unsupported, match="fillings"):
        tripus.Manifold(S)
    with pytest.raises(tripus.TripusError):
        tripus.Manifold(regina.Triangulation3())
    with pytest.raises(tripus.InvalidInput):
        tripus.Manifold(regina.Perm4())


def test_snappy_there_and_back():
    handed = 0
    for text in EVERY:
        M = tripus.Manifold(text)
        if M.num_boundary_components():
            with pytest.raises(tripus.Unsupported, match="to_regina"):
                M.to_snappy()  # never a vertex of genus 2: its kernel is not safe afterwards
            continue
        S = M.to_snappy()
        assert S.num_cusps() == M.num_cusps() and S.name() == text
        assert same(tripus.Manifold(S), M)
        handed += 1
    assert handed >= 40


def test_snappy_keeps_the_orientation_and_finite_vertices():
    for sign in "+-":
        M = tripus.Manifold("dLQbcccdero" + sign)
        again = tripus.Manifold(M.to_snappy())
        assert again.triangulation_isosig(oriented=True) == "dLQbcccdero" + sign
    sphere = tripus.Manifold(regina.Example3.poincare())
    assert sphere.has_finite_vertices()
    S = sphere.to_snappy()
    assert S.has_finite_vertices() and same(tripus.Manifold(S), sphere)
    assert str(S.homology()) == str(sphere.homology()) == "0"


def test_snappy_objects():
    assert tripus.Manifold(snappy.Manifold("m015")).volume() == pytest.approx(2.828122088330783)
    assert tripus.Manifold(snappy.Triangulation("m004")).name() == "m004"
    assert same(tripus.Manifold(snappy.ManifoldHP("m004")), tripus.Manifold("cPcbbbiht"))
    assert tripus.Manifold(snappy.Link("K4a1")).num_cusps() == 1
    filled = snappy.Manifold("m004(1,2)")
    with pytest.raises(tripus.Unsupported, match="filled_triangulation"):
        tripus.Manifold(filled)
    assert tripus.Manifold(snappy.Manifold("m125(1,2)(0,0)").filled_triangulation()).num_cusps() == 1


def test_cusped_volumes_are_snappys():
    for row in (line.split("\t") for line in (DATA / "cusped-census-5.tsv").read_text().splitlines()
                if line and line[0] != "#"):
        if row[0] == "name":
            continue
        assert abs(tripus.Manifold(row[1]).volume() - float(row[4])) < 1e-10, row[0]


def test_identify_asks_snappy_too():
    hits = tripus.Manifold("cPcbbbiht").identify(snappy=True)
    assert {"m004", "4_1"} <= {hit.name for hit in hits}
    with pytest.raises(tripus.Unsupported):
        tripus.Manifold("cPcbbbihq").to_snappy()


def cubed_torus():
    """A solid torus: 3 x 3 x 1 cubes without the middle one; points, quadrilaterals."""
    cubes = {(i, j, 0) for i in range(3) for j in range(3)} - {(1, 1, 0)}
    points, quads = {}, []
    for cube in sorted(cubes):
        for axis in range(3):
            for side in (0, 1):
                beside = list(cube)
                beside[axis] += 2 * side - 1
                if tuple(beside) in cubes:
                    continue
                corners = []
                for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    p = list(cube)
                    p[axis] += side
                    p[(axis + 1) % 3] += u
                    p[(axis + 2) % 3] += v
                    corners.append(points.setdefault(tuple(p), len(points)))
                quads.append(corners if side else corners[::-1])
    return np.array(list(points), dtype=float), np.array(quads)


def test_meshes_of_every_package(tmp_path):
    meshio, trimesh = pytest.importorskip("meshio"), pytest.importorskip("trimesh")
    pyvista = pytest.importorskip("pyvista")
    expected = tripus.Manifold(str(ROOT / "examples/surfaces/knotted-y.off"))
    source = trimesh.load(ROOT / "examples/surfaces/knotted-y.off", process=False)
    points, triangles = np.asarray(source.vertices), np.asarray(source.faces)
    faces = np.hstack([np.full((len(triangles), 1), 3), triangles]).ravel()
    objects = [
        (points, triangles), (points.tolist(), triangles.tolist()), source,
        meshio.Mesh(points, [("triangle", triangles)]), pyvista.PolyData(points, faces),
        pyvista.PolyData(points, faces).cast_to_unstructured_grid(),
        trimesh.Scene([source]),
    ]
    for thing in objects:
        M = tripus.Manifold.from_mesh(thing)
        assert same(M, expected), type(thing)
        assert abs(M.volume() - expected.volume()) < 1e-12
        if not isinstance(thing, tuple):
            assert same(tripus.Manifold(thing), expected)
    # A format that tripus does not read itself comes in through meshio.
    meshio.Mesh(points, [("triangle", triangles)]).write(tmp_path / "y.inp")  # Abaqus
    assert same(tripus.Manifold(tmp_path / "y.inp"), expected)


def test_quadrilaterals_and_tetrahedra():
    meshio, pyvista = pytest.importorskip("meshio"), pytest.importorskip("pyvista")
    points, quads = cubed_torus()
    M = tripus.Manifold(meshio.Mesh(points, [("quad", quads)]))
    assert M.num_cusps() == 1 and str(M.homology()) == "Z", "a solid torus"
    assert not M.verdict()
    tetrahedron = meshio.Mesh(np.vstack([np.zeros(3), np.eye(3)]), [("tetra", [[0, 1, 2, 3]])])
    assert tripus.Manifold(tetrahedron).has_finite_vertices()
    grid = pyvista.UnstructuredGrid({pyvista.CellType.TETRA: np.array([[0, 1, 2, 3]])},
                                    np.vstack([np.zeros(3), np.eye(3)]))
    assert tripus.Manifold(grid).has_finite_vertices()


@pytest.mark.parametrize("wrong", [
    lambda: tripus.Manifold.from_mesh((np.zeros((3, 2)), [[0, 1, 2]])),
    lambda: tripus.Manifold.from_mesh((np.zeros((3, 3)), [[0, 1, 3]])),
    lambda: tripus.Manifold.from_mesh((np.zeros((3, 3)), [[0, 1, -1]])),
    lambda: tripus.Manifold.from_mesh((np.zeros((3, 3)), [[0, 1]])),
    lambda: tripus.Manifold.from_mesh((np.full((3, 3), np.nan), [[0, 1, 2]])),
    lambda: tripus.Manifold.from_mesh((np.zeros((0, 3)), np.zeros((0, 3), int))),
    lambda: tripus.Manifold.from_mesh("nothing there"), lambda: tripus.Manifold.from_mesh(5),
])
def test_bad_meshes_are_refused(wrong):
    with pytest.raises(tripus.InvalidInput):
        wrong()


def test_cells_go_to_every_package():
    pytest.importorskip("pyvista"), pytest.importorskip("trimesh"), pytest.importorskip("meshio")
    cells = tripus.Manifold("cPcbbbihq").metric.universal_cover(6)
    surface = cells.to_pyvista("klein")
    solid = cells.to_trimesh("klein")
    mesh = cells.to_meshio("klein")
    assert surface.n_cells == len(solid.faces) == len(mesh.cells[0].data)
    assert solid.volume == pytest.approx(surface.volume, rel=1e-9) and solid.volume > 0
    assert set(surface.cell_data["cell"]) == set(range(6))


def test_many_as_a_frame_and_as_an_array():
    pandas = pytest.importorskip("pandas")
    texts = [*signatures("triangulations-3.txt", 8), "nonsense", "eLAkbbcddpuchf 0=7,1=2,2=7"]
    frame = tripus.solve_many(texts, threads=2)
    assert isinstance(frame, pandas.DataFrame) and list(frame["input"]) == texts
    array = tripus.solve_many([tripus.Manifold(t) for t in texts[:-2]], as_array=True)
    assert array.dtype["volume"] == float
    assert np.array_equal(array["volume"], frame["volume"].to_numpy()[:-2], equal_nan=True)
    assert frame["outcome"].iloc[-2] == "error" and "nonsense" in frame["message"].iloc[-2]
    assert frame["volume"].iloc[-1] > 0, "labels are known"
    proved = tripus.solve_many(["cPcbbbihq"], prove=True)
    assert proved["volume_lower"][0] <= 6.45199027083503287 <= proved["volume_upper"][0]
    assert len(tripus.solve_many([])) == 0
    assert math.isnan(frame["volume"].iloc[-2])
