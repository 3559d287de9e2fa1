"""tripus.Manifold by itself: construction, values, answers, exceptions."""

import collections
import contextlib
import copy
import itertools
import json
import pathlib
import pickle
import re
import warnings

import numpy as np
import pytest
from conftest import DATA, ROOT, column

import tripus

TRIPUS = "cPcbbbihq"
TRIPUS_VOLUME = 6.45199027083503287  # docs/theory.md (28)
NO_METRIC = "dLQbcbcaekw"  # no strict angle structure: data/nongeometric-3.tsv


@pytest.fixture
def M():
    return tripus.Manifold(TRIPUS)


# The facilities of the front door

#: Member of the C++ class: what it is in Python. None: with the reason.
MANIFOLD = {
    "Manifold": "Manifold", "name": "name", "label": "__str__", "input": "__str__",
    "is_orientation_known": "is_orientation_known", "triangulation": "gluing_arrays",
    "tetrahedron_count": "num_tetrahedra", "is_orientable": "is_orientable", "links": "links",
    "signature": "triangulation_isosig", "oriented_signature": "triangulation_isosig",
    "homology": "homology", "fundamental_group": "fundamental_group", "simplified": "simplified",
    "covers": "covers", "cyclic_covers": "covers", "metric": "metric", "verdict": "verdict",
    "solve": "solve", "retriangulated": "retriangulated", "canonical": "canonical",
    "isometry_signature": "isometry_signature", "isometry_group": "symmetry_group",
    "compare": "compare", "is_isometric_to": "is_isometric_to", "identify": "identify",
    "to_json": "to_json", "write": "write", "cone_angles": "cone_angles",
    "with_cone_angles": "with_cone_angles", "cover": "cover", "drilled": "drilled",
}
METRIC = {
    "Metric": "__init__", "volume": "volume", "edge_lengths": "edge_lengths",
    "dihedral_angles": "dihedral_angles", "boundary": "boundary", "max_curvature": "max_curvature",
    "report": "verdict", "prove": "manifold", "embedding": "embedding", "holonomy": "holonomy",
    "universal_cover": "universal_cover", "fundamental_domain": "fundamental_domain",
}
CELLS = {
    "CellComplex": "__init__", "cells": "isometries", "end": "end", "embedding": "mesh",
    "write": "write",
}


def public_members(header, name):
    """Names of the public functions of a C++ class."""
    text = (ROOT / "manifold" / header).read_text()
    body = re.search(rf"class {name} {{\n public:(.*?)\n private:", text, re.DOTALL).group(1)
    body = re.sub(r"//[^\n]*| = \{\}", "", body)
    body = re.sub(r"\{[^{}]*\}", ";", body)
    found = set()
    for declaration in body.split(";"):
        declaration = re.sub(r"\{.*", "", declaration, flags=re.DOTALL)
        match = re.search(r"([A-Za-z_]\w*)\(", declaration)
        if match:
            found.add(match.group(1))
    return found


@pytest.mark.parametrize(("header", "name", "table", "python"), [
    ("manifold.hpp", "Manifold", MANIFOLD, tripus.Manifold),
    ("metric.hpp", "Metric", METRIC, tripus.Metric),
    ("metric.hpp", "CellComplex", CELLS, None),
])
def test_every_facility_of_the_library_is_here(M, header, name, table, python):
    members = public_members(header, name)
    assert len(members) >= 4
    assert members == set(table), "a facility of the C++ class has no place in Python"
    thing = python or M.metric.fundamental_domain()
    for there in table.values():
        assert hasattr(thing, there) or hasattr(tripus, there), there


# Making one

def test_sources(M, tmp_path):
    table = M.gluings
    assert tripus.Manifold(table) == M
    assert tripus.Manifold({"name": "x", "gluings": table}).name() == "x"
    assert tripus.Manifold(M.gluing_arrays()) == M
    assert tripus.Manifold(M) == M
    file = tmp_path / "m.json"
    file.write_text(json.dumps({"name": "named", "gluings": table}))
    assert tripus.Manifold(file).name() == "named"
    assert tripus.Manifold(str(file)) == M
    assert str(tripus.Manifold(file, name="other")) == "other"
    assert tripus.Manifold("t2g2.8") == M
    for diagram in ("4_1", "PD: X[4,2,5,1] X[8,6,1,5] X[6,3,7,4] X[2,7,3,8]",
                    "PD: X[4,2,5,1] X[8,6,1,5]\n  X[6,3,7,4] X[2,7,3,8]\n"):
        assert tripus.Manifold(diagram) == tripus.Manifold("cPcbbbiht")
    assert tripus.Manifold("5_1 theta") == M
    for format in ("json", "regina", "regina-table", "snappea", "orb"):
        assert tripus.Manifold.from_text(M.to_text(format)) == M
        assert tripus.Manifold(M.to_text(format)) == M, "the text of a file is a source, as in SnapPy"


@pytest.mark.parametrize("source", ["", "hello", " ", "cPcbbbihx", 5, None, [], [[1]], {}, b"cPcbbbihq",
                                    {"gluings": [[None] * 3]}, [[[1, "0000"]] * 4], np.eye(3), object(),
                                    ([[9] * 4], [[[0, 1, 2, 3]] * 4])])
def test_other_sources_are_refused(source):
    with pytest.raises(tripus.InvalidInput) as caught:
        tripus.Manifold(source)
    assert isinstance(caught.value, ValueError)
    assert len(str(caught.value)) > 10


def test_what_was_mended_is_a_warning():
    open_table = [[None] * 4]  # a ball
    with pytest.warns(tripus.InputNote, match="coned"):
        tripus.Manifold(open_table)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(tripus.InputNote):
            tripus.Manifold(open_table)


def test_fillings_are_refused():
    with pytest.raises(tripus.Unsupported):
        tripus.Manifold("cPcbbbiht_BaCB(1,2)")


def test_names_of_other_programs_say_where_to_go(M):
    with pytest.raises(AttributeError, match="simplified"):
        M.simplify()
    with pytest.raises(AttributeError, match="triangulation_isosig"):
        M.isoSig()
    with pytest.raises(AttributeError, match="'nothing'"):
        M.nothing


# A value

def test_equality_never_raises_and_fits_the_hash(M):
    other = M.relabelled(5)
    assert other.gluings != M.gluings
    assert other == M and hash(other) == hash(M)
    assert M.mirrored() == M
    assert M != tripus.Manifold("cPcbbbdhq")
    for thing in (None, 1, "cPcbbbihq", object(), np.zeros(3)):
        assert not (M == thing) if not isinstance(thing, np.ndarray) else True
    assert len({M, other, tripus.Manifold("cPcbbbdhq")}) == 2


def test_habits_of_snappy():
    M = tripus.Manifold("4_1")
    assert M.triangulation_isosig(decorated=False) == "cPcbbbiht"
    with pytest.raises(tripus.Unsupported):
        M.triangulation_isosig(decorated=True)
    with pytest.raises(AttributeError, match="links"):
        M.cusp_info()
    with pytest.raises(AttributeError, match=r"to_snappy\(\).complex_volume"):
        M.complex_volume()
    with pytest.raises(AttributeError, match="tripus.Diagram"):
        tripus.Link
    with pytest.raises(tripus.InvalidInput, match="snappy.Manifold"):
        tripus.Manifold("m015")
    # Permutations of the generators that fundamental_group() shows, or of all.
    assert M.fundamental_group().num_generators() == 2
    swap = [1, 0]
    assert M.cover([[0, 1], swap]) in M.covers(2)
    assert M.cover([[0, 1], swap]).num_tetrahedra() == 4
    with pytest.raises(tripus.InvalidInput):
        M.cover([swap, [0, 0]])


def test_it_does_not_change(M):
    assert copy.copy(M) is M and copy.deepcopy(M) is M and M.copy() is M
    with pytest.raises(AttributeError):
        M.color = "red"
    with pytest.raises(ValueError):
        M.metric.edge_lengths[0] = 1
    with pytest.raises(ValueError):
        M.edge_classes.flags.writeable = True


def every_kind_of_object():
    M = tripus.Manifold(TRIPUS)
    bad = tripus.Manifold(NO_METRIC)
    with pytest.raises(tripus.NoMetric) as no_metric:
        bad.metric
    return [
        M, tripus.Manifold("cPcbbbihq-", name="ü"), M.metric, M.volume(), M.verdict(), bad.verdict(),
        bad.verdict().certificate, M.solve(angle_structure=True).angle_structure, M.prove(),
        M.homology(), M.fundamental_group(), M.symmetry_group(), M.canonical(), bad.canonical(),
        M.compare(bad), M.identify()[0], M.orthospectrum(length=2), M.metric.universal_cover(5),
        M.metric.fundamental_domain(), no_metric.value, tripus.InvalidInput("x"),
        tripus.Undecided("x", M), tripus.FileError("x"),
    ]


@pytest.mark.parametrize("thing", every_kind_of_object(), ids=lambda t: type(t).__name__)
def test_every_object_pickles_and_prints(thing):
    for protocol in (2, pickle.HIGHEST_PROTOCOL):
        again = pickle.loads(pickle.dumps(thing, protocol))
        assert type(again) is type(thing)
        assert repr(again) == repr(thing)
        assert str(again) == str(thing)
    assert "object at 0x" not in repr(thing)
    assert len(repr(thing)) < 400


def test_pickles_keep_all_that_was_given():
    for text in ("cPcbbbihq", "cPcbbbihq-"):
        M = tripus.Manifold(text, name="é")
        again = pickle.loads(pickle.dumps(M))
        assert again.gluings == M.gluings and again.name() == "é"
        assert again.is_orientation_known() == M.is_orientation_known() == text.endswith("-")
        assert len(pickle.dumps(M)) < 1000


# Numbers

def test_volume_is_a_float_with_its_error(M):
    v = M.volume()
    assert abs(v - TRIPUS_VOLUME) < 1e-13
    assert f"{v:.10f}" == "6.4519902708" and json.loads(json.dumps(v)) == float(v)
    assert np.array([v, v]).dtype == float
    low, high = v.interval
    assert low <= TRIPUS_VOLUME <= high and v.is_proved and 0 < v.error < 1e-11
    assert M.volume(verified=True) == v


def test_arrays_are_views_and_outlive_the_manifold():
    lengths = tripus.Manifold(TRIPUS).metric.edge_lengths
    angles = tripus.Manifold(TRIPUS).metric.dihedral_angles
    classes = tripus.Manifold(TRIPUS).edge_classes
    assert not lengths.flags.owndata and not angles.flags.owndata and not classes.flags.owndata
    assert abs(lengths[0] - 0.596133894890837) < 1e-14
    assert np.allclose(angles, np.pi / 6) and classes.tolist() == [[0] * 6] * 2
    M = tripus.Manifold(TRIPUS)
    pointer = M.metric.edge_lengths.__array_interface__["data"][0]
    assert M.metric.edge_lengths.__array_interface__["data"][0] == pointer, "solved once, no copy"


def test_a_mathematical_no_is_an_answer():
    M = tripus.Manifold(NO_METRIC)
    verdict = M.verdict()
    assert not verdict and verdict.outcome == "infeasible"
    assert verdict.certificate.check(M)
    assert not verdict.certificate.check(tripus.Manifold("dLQbccchhfo"))
    assert M.solution_type() == "no solution found"
    assert M.solution_type(enum=True) == "infeasible"
    for question in (M.volume, lambda: M.metric, lambda: M.orthospectrum(length=1), M.view, M.picture):
        with pytest.raises(tripus.NoMetric) as caught:
            question()
        assert caught.value.verdict.certificate == verdict.certificate
        assert isinstance(caught.value, ValueError)
    assert not M.prove() and "certificate" in M.prove().reason
    assert M.retriangulated(budget=5).verdict().outcome == "unresolved"
    flat = tripus.Manifold("eLAkbccdddprdk")  # data/boundary-case-4.tsv
    assert flat.verdict().flat_tetrahedra and flat.solution_type() == "contains flat tetrahedra"
    found = flat.retriangulated()
    assert found.verdict() and found.volume() == pytest.approx(flat.verdict().volume, abs=1e-9)
    assert flat.compare(found)


def test_solving_anew(M):
    newton = M.solve("newton", history=True)
    assert newton and len(newton.history) >= newton.iterations
    assert newton.history["max_curvature"].iloc[-1] < 1e-10
    assert abs(M.solve("flow:curvature/dopri5").volume - TRIPUS_VOLUME) < 1e-9
    assert M.solve(initial_lengths=np.array([2.0])).volume == pytest.approx(TRIPUS_VOLUME, abs=1e-12)
    orbifold = M.solve(cone_orders={0: "5/2"})
    assert orbifold == M.solve(cone_angles={0: 2 * np.pi / 2.5}) or orbifold.volume > TRIPUS_VOLUME
    for wrong in ({"method": "guess"}, {"initial_length": -1.0}, {"tolerance": 0.0},
                  {"cone_orders": {3: 2}}, {"cone_orders": {0: 2}, "cone_angles": {0: 1.0}},
                  {"initial_lengths": [1.0, 1.0]}, {"cone_orders": {0: "x"}}, {"time_limit": -1.0}):
        with pytest.raises(tripus.InvalidInput):
            M.solve(**wrong)
    angles = M.solve(angle_structure=True).angle_structure.angles
    assert sum(sum(six) for six in angles) == 2


def test_proofs(M):
    proof = M.prove(digits=40)
    assert proof and proof.check()
    assert proof.volume[0].startswith("6.45199027083503286529823442")
    proved, lengths = M.verify_hyperbolicity()
    # docs/theory.md (5): cosh l = cos a / (2 cos a - 1) at the angle a = pi / 6.
    cosine = np.sqrt(np.longdouble(3)) / 2
    assert proved and lengths[0][0] <= np.arccosh(cosine / (2 * cosine - 1)) <= lengths[0][1]
    fake = pickle.loads(pickle.dumps(proof))
    fake._text = fake._text.replace("6.4519902708", "6.4519902709")
    assert not fake.check()


def test_comparisons(M):
    assert M.is_isometric_to(M.relabelled(1))
    answer = M.is_isometric_to(tripus.Manifold("cPcbbbdhq"))
    assert not answer and answer.message
    isometries = M.is_isometric_to(M, return_isometries=True)
    assert len(set(isometries)) == M.symmetry_group().order() == 6
    assert M.is_isometric_to(tripus.Manifold("cPcbbbdhq"), return_isometries=True) == []
    undecided = tripus.Comparison({**answer._fields, "verdict": "unresolved"})
    with pytest.raises(tripus.Undecided):
        bool(undecided)


def test_canonical(M):
    found = M.canonical()
    assert found.cells == "2 tetrahedra" and found.isometry_group.order() == 6
    assert M.isometry_signature() == found.signature
    assert M.isometry_signature(ignore_orientation=False) == found.oriented_signature
    assert M.canonical_retriangulation().volume() == pytest.approx(TRIPUS_VOLUME, abs=1e-12)
    assert [entry.name for entry in M.identify()] == ["t2g2.8"]
    assert M.identify()[0].manifold() == M
    assert M.identify()[0].homology() == M.homology()


def test_groups_of_many_generators():
    M = max(tripus.Manifold("cPcbbbihq").covers(6), key=lambda c: c.num_tetrahedra())
    N = M.covers(2)[0].covers(2)[0]
    group = N.fundamental_group(simplify_presentation=False)
    assert group.num_generators() > 26 and group.generators()[26] == "x27"
    assert group.relators()[0] == group.word(group.letters(group.relators()[0]))
    for name, (t, f) in list(group.faces().items())[:5]:
        assert group.face_words()[t][f] == name


def test_holonomy_satisfies_the_relators(M):
    for signature in (TRIPUS, "dLQbcccdinf", column("manifolds-2-3.tsv", 5)[-1]):
        N = tripus.Manifold(signature)
        group = N.fundamental_group()
        for word in group.relators() + group.original().relators():
            owner = group if word in group.relators() else group.original()
            assert abs(owner.O31(word) - np.eye(4)).max() < 1e-6
        for old, word in zip(group.original().generators(), group.original_generators()):
            assert abs(group.O31(word) - group.original().O31(old)).max() < 1e-6
    with pytest.raises(tripus.InvalidInput):
        M.fundamental_group().O31("z")


def test_equality_never_raises(M):
    for other in (None, 5, "cPcbbbihq", [], object()):
        assert not M == other and M != other
        assert not M.homology() == other
    answer = M.is_isometric_to(M)
    assert answer == True and not answer == False  # noqa: E712
    assert answer == M.is_isometric_to(M)


def test_a_list_goes_on_after_what_is_no_input():
    found = tripus.solve_many(["cPcbbbihq", 5, None, "cPcbbbiht"])
    assert list(found["outcome"]) == ["geometric", "error", "error", "geometric"]
    assert all(found["message"][i] for i in (1, 2))


def test_a_limit_on_covers_is_no_answer(M):
    with pytest.raises(tripus.Undecided) as error:
        M.covers(9, time_limit=0.02)
    assert isinstance(error.value.answer, list)


def test_covers(M):
    golden = [line.split("\t") for line in (DATA / "covers-golden.tsv").read_text().splitlines()
              if line and line[0] != "#"][1:]
    for signature, degree, homology in golden[:40]:
        if int(degree) > 4:
            continue
        found = tripus.Manifold(signature).covers(int(degree))
        counted = collections.Counter(format(N.homology(), "regina") for N in found)
        expected = {} if homology == "-" else dict(
            item.rsplit(" x ", 1) for item in homology.split("; "))
        assert counted == {h: int(n) for h, n in expected.items()}
    G = M.fundamental_group(simplify_presentation=False)
    two = []
    for choice in itertools.product([[0, 1], [1, 0]], repeat=G.num_generators()):
        with contextlib.suppress(tripus.InvalidInput):
            two.append(M.cover(choice))
    assert sorted(map(hash, two)) == sorted(map(hash, M.covers(2))) and len(two) == 3
    for N in two:
        assert N.num_tetrahedra() == 4 and N in M.covers(2)
        assert N.retriangulated(budget=20).volume() == pytest.approx(2 * TRIPUS_VOLUME, abs=1e-11)
    for wrong in ([], [[0, 1]] * G.num_generators(), [[0, 0]] * G.num_generators(), [[1, 0]]):
        with pytest.raises(tripus.InvalidInput):
            M.cover(wrong)
    with pytest.raises(tripus.InvalidInput):
        M.covers(2, cover_type="regular")


def test_saving(M, tmp_path):
    for ending in ("json", "rga", "tri", "orb", "sig"):
        path = tmp_path / f"m.{ending}"
        M.save(path)
        assert tripus.Manifold(path) == M
    with pytest.raises(tripus.InvalidInput):
        M.save(tmp_path / "m.xyz")
    with pytest.raises(tripus.TripusError):
        M.save(tmp_path / "no" / "such" / "folder.json")
    M.write(tmp_path / "answer.json")
    assert json.loads((tmp_path / "answer.json").read_text()) == json.loads(M.to_json())


def test_cells(M, tmp_path):
    cells = M.metric.universal_cover(30)
    assert len(cells) == 30 and cells.end == "cells"
    points, triangles, which, sides = cells.mesh("ball", error=0.1)
    assert (points**2).sum(axis=1).max() < 1 and triangles.max() < len(points)
    assert set(which.tolist()) == set(range(30)) and set(sides.tolist()) == set(range(8))
    for ending in ("obj", "ply", "vtk"):
        assert cells.write(tmp_path / f"c.{ending}") == 30
    with pytest.raises(tripus.InvalidInput):
        cells.mesh("cube")
    with pytest.raises(tripus.InvalidInput):
        M.metric.universal_cover(0)


def test_spectrum_is_that_of_the_table(M):
    for line in (DATA / "orthospectra.tsv").read_text().splitlines()[2:6]:
        name, arcs = line.split("\t")
        found = tripus.Manifold(name).orthospectrum(length=4.5)
        expected = {}
        for item in arcs.split():
            length, multiplicity = item.split("x")
            expected[float(length)] = int(multiplicity)
        got = {}
        for length, n in zip(found.lengths, found.multiplicities):
            key = round(float(length), 10)
            got[key] = got.get(key, 0) + int(n)
        for length, n in got.items():
            assert expected.get(length, n) == n
        assert abs(min(got) - min(expected)) < 1e-9


def test_census_and_methods():
    assert len(tripus.census(boundary="g2", tetrahedra=2)) == 8
    assert all(6 <= e.volume <= 7 for e in tripus.census(volume=(6, 7)))
    with pytest.raises(TypeError):
        tripus.census(num_tetrahedra=2)
    with pytest.raises(TypeError, match="volume is a pair of numbers, not 5"):
        tripus.census(volume=5)
    with pytest.raises(tripus.InvalidInput):
        tripus.census(volume=(5, 6, 7))
    with pytest.raises(tripus.InvalidInput):
        tripus.census(homology="nonsense")


def test_large_signatures_go_there_and_back():
    M = tripus.Manifold(TRIPUS)
    # The relator bAcBAbcAC needs b + c = 3 a.
    M = M.cover([[(i + k) % 350 for i in range(350)] for k in (1, 2, 1)])
    assert M.num_tetrahedra() == 700
    signature = M.triangulation_isosig()
    assert tripus.Manifold(signature) == M
    assert tripus.Manifold(signature).triangulation_isosig() == signature


def test_signatures_agree_with_the_data():
    for text in column("manifolds-2-3.tsv", 5, 60)[1:]:
        assert tripus.Manifold(text).triangulation_isosig() == text


def test_paths_of_any_bytes(M, tmp_path):
    path = pathlib.Path(str(tmp_path) + "/\udcff.json")
    path.write_text(json.dumps({"gluings": M.gluings}))
    N = tripus.Manifold(path)
    assert N == M and N.volume() == M.volume()
    repr(N), N._repr_html_(), json.loads(N.to_json()), pickle.dumps(N)


def test_arcs_and_discs(M):
    path = M.shortest_return_path()
    assert abs(path.length - 0.596133894890837) < 1e-13 and path.edges == [0]
    assert float(path) == min(M.metric.edge_lengths)
    arcs = M.orthospectrum(length=5, prove=True)
    assert arcs.multiplicities.tolist()[:8] == [1, 4, 12, 12, 12, 6, 24, 48]  # docs/orthospectrum.md
    for length, (low, high) in zip(arcs.lengths, arcs.proved_lengths):
        assert low - 1e-12 <= length <= high + 1e-12 and high - low < 1e-9
    assert M.orthospectrum(length=2).proved_lengths is None
    discs = M.basmajian_discs(length=5)
    assert len(discs) == 2 * arcs.arc_count and discs.boundary_area == pytest.approx(4 * np.pi)
    assert discs.area == pytest.approx(arcs.area["counted"], rel=1e-12)
    assert np.allclose(np.tanh(discs.lengths / 2), np.exp(-discs.radii))
    assert (discs.feet**2).sum(axis=1).max() < 1 and discs.tiles.max() <= 3
    assert discs.svg().startswith("<svg") and discs.svg().count("<circle") > len(discs)
    with pytest.raises(tripus.InvalidInput):
        M.orthospectrum(length=0)
    # A cusp has a horosphere, whose area is none of the boundary's.
    mixed = tripus.Manifold("dLQacccjjkg")
    assert mixed.num_cusps() == 1
    for area in (mixed.orthospectrum(length=2).area["exact"], mixed.basmajian_discs(2).boundary_area):
        assert area == pytest.approx(4 * np.pi)


def test_discs_do_not_overlap(M):
    discs = M.basmajian_discs(length=7)
    assert (np.diff(discs.radii) <= 1e-12).all()
    # Of one tile: points of the disc (x, y) are directions (x, y, 1) of the hyperboloid.
    tile = (discs.tiles == [0, 1]).all(axis=1)
    x, y = discs.feet[tile].T
    z = 1 / np.sqrt(1 - x**2 - y**2)
    points = np.stack([z * x, z * y, z], axis=1)
    cosh = points[:, None, 2] * points[None, :, 2] - points[:, :2] @ points[:, :2].T
    radii = discs.radii[tile]
    apart = np.arccosh(np.maximum(cosh, 1)) - radii[:, None] - radii[None, :]
    np.fill_diagonal(apart, 1)
    assert tile.sum() > 100 and apart.min() > -1e-6


def test_spectrum_with_a_cusp_counts_the_compact_boundary():
    arcs = tripus.Manifold("dLQacccjjkg").orthospectrum(length=7)
    assert abs(arcs.area["exact"] - 4 * np.pi) < 1e-12
    tail, uncertainty = arcs.area["tail"]
    assert abs(arcs.area["counted"] + tail - 4 * np.pi) < uncertainty


def test_a_page_begins_outside_or_inside(M, monkeypatch):
    assert '"view_shown":"outside"' in M.page()
    monkeypatch.setattr("webbrowser.open", lambda address: True)
    assert '"view_shown":"inside"' in M.inside_view().text


def test_pages_with_discs(M):
    assert '"discs":{' not in M.page()
    assert '"discs":{"length":1,' in M.page(discs=1)
    assert '"discs":{"length":4.9' in M.page(discs=True)
    for bad in (0.0, -1.0, float("nan"), 25.0, 18.0):
        with pytest.raises(tripus.InvalidInput):
            M.page(discs=bad)
