"""Hyperbolic or not: the lists thinned, made-up manifolds, certificates and their check."""

import copy
import functools
import itertools
import json
import subprocess
import sys
import time

import pytest
from conftest import DATA, column, signatures

import tripus
from tripus.hyperbolic import HyperbolicityCertificate, bigon, essential, presentation, search
from tripus.hyperbolic.decide import without_metric
from tripus.hyperbolic.normal import NormalSurface
from tripus.hyperbolic.pieces import group_name, surface_group
from tripus.hyperbolic.tables import Table

regina = pytest.importorskip("regina", exc_type=ImportError)

HYPERBOLIC = set(" ".join(column("census.tsv", 9)[1:]).split())


def decided(text, **options):
    """With its certificate checked, by itself and as text."""
    M = tripus.Manifold(text)
    answer = M.hyperbolicity(**options)
    if answer.certificate is not None:
        assert answer.certificate.objection(M) == ""
        assert HyperbolicityCertificate(answer.certificate.to_json()) == answer.certificate
    return answer


# The lists

@pytest.mark.parametrize(("name", "every"), [("2", 1), ("3", 4), ("4", 160)])
def test_lists_are_decided_rightly(name, every):
    for text in signatures(f"triangulations-{name}.txt", every):
        answer = decided(text, time_limit=60)
        assert answer.hyperbolic is (text in HYPERBOLIC), (text, answer)
        assert answer.proved


def test_shipped_table_says_hyperbolic_of_the_census_and_of_nothing_else():
    rows = [line.split("\t") for line in (DATA / "hyperbolicity.tsv").read_text().splitlines()[2:]]
    lists = [row for row in rows if row[0] in ("2", "3", "4")]
    assert len(lists) == 8 + 240 + 11048
    assert {row[1] for row in lists if row[2] == "true"} == HYPERBOLIC
    assert all(row[2] in ("true", "false") for row in rows)
    assert sum(row[2] == "true" for row in rows if row[1].startswith("hk")) == 42


@pytest.mark.parametrize(("name", "kind"), [
    ("hk4_1", "annulus"), ("hk6_14", "torus"), ("hk7_46", "annulus"), ("hk7_59", "moebius band"),
    ("6_9 handcuff", "annulus"),
])
def test_graphs(name, kind):
    answer = decided(name)
    assert (answer.hyperbolic, answer.kind) == (False, kind)


def test_torus_cusps_beside_the_boundary():
    for text in signatures("triangulations-cusped.txt", 6):
        geometric = tripus.Manifold(text).verdict().outcome == "geometric"
        M = tripus.Manifold(text)
        answer = M.hyperbolicity()
        assert answer.hyperbolic is geometric
        assert geometric or answer.certificate.check(M)


def test_shipped_controls_are_of_the_census_and_got_no_no():
    lines = (DATA / "hyperbolicity-controls.tsv").read_text().splitlines()
    head, rows = lines[1].split("\t"), [line.split("\t") for line in lines[2:]]
    firsts = {row.split()[0] for row in column("census.tsv", 9)[1:]}
    assert len({(row[0], row[1]) for row in rows}) == len(rows) > 1000
    for row in rows:
        entry = dict(zip(head, row, strict=True))
        assert entry["list"] in ("quick", "census") and entry["input"] in firsts
        assert entry["hyperbolic"] == ""
        assert "fundamental group" in entry["tried"]
        assert ("normal surfaces" in entry["tried"]) == (entry["list"] == "census")


def test_hyperbolic_manifolds_never_get_a_no():
    texts = [row.split()[0] for row in column("census.tsv", 9)[1::700]]
    covers = [M for t in texts[:3] for M in tripus.Manifold(t).covers(2)[:2]]
    for M in [tripus.Manifold(t) for t in texts] + covers:
        assert without_metric(M, 0.3).hyperbolic is None


# Made-up manifolds

def real(text):
    made = tripus.Manifold(text).to_regina()
    made.truncateIdeal()
    made.simplify()
    made.simplify()
    return made


def ideal(made):
    made.simplify()
    made.finiteToIdeal()
    made.simplify()
    return tripus.Manifold(made).simplified()


def boundary_sum(first, second):
    """Glued along one triangle of the boundary, which a subdivision makes a disc."""
    first, second = real(first), real(second)
    first.subdivide()
    second.subdivide()
    size = first.size()
    first.insertTriangulation(second)
    ends = [t.front() for t in first.triangles() if t.isBoundary()]
    a = next(e for e in ends if e.simplex().index() < size)
    b = next(e for e in ends if e.simplex().index() >= size)
    for k in itertools.permutations(range(3)):
        made = regina.Triangulation3(first)
        glue = b.vertices() * regina.Perm4(*k, 3) * a.vertices().inverse()
        made.tetrahedron(a.simplex().index()).join(
            a.vertices()[3], made.tetrahedron(b.simplex().index()), glue
        )
        if made.isValid() and made.isOrientable():
            return ideal(made)
    raise AssertionError("no gluing")


def glued_along_tori(first, second):
    whole = real(first)
    size = whole.size()
    whole.insertTriangulation(real(second))
    tori = [b for b in whole.boundaryComponents() if b.eulerChar() == 0]
    fronts = [[b.triangle(0).front(), b.triangle(1).front()] for b in tori]
    one = next(f for f in fronts if f[0].simplex().index() < size)
    two = next(f for f in fronts if f[0].simplex().index() >= size)
    for k, m in itertools.product(itertools.permutations(range(3)), repeat=2):
        made = regina.Triangulation3(whole)
        for a, b, turn in ((one[0], two[0], k), (one[1], two[1], m)):
            made.tetrahedron(a.simplex().index()).join(
                a.vertices()[3],
                made.tetrahedron(b.simplex().index()),
                b.vertices() * regina.Perm4(*turn, 3) * a.vertices().inverse(),
            )
        wanted = whole.countBoundaryComponents() - 2
        if made.isValid() and made.isOrientable() and made.countBoundaryComponents() == wanted:
            return ideal(made)
    raise AssertionError("no gluing")


def connected_sum(text, other):
    made = real(text)
    made.connectedSumWith(other) if hasattr(made, "connectedSumWith") else made.connectSumWith(other)
    return ideal(made)


TREFOIL, TRIPUS, CUSPED = "cPcbbbadh", "cPcbbbihq", "dLQacccjjkg"
MADE = {
    "boundary sum": (lambda: boundary_sum(TRIPUS, TREFOIL), "disc"),
    "lens space": (lambda: connected_sum(TRIPUS, regina.Example3.lens(3, 1)), "sphere"),
    "homology sphere": (lambda: connected_sum(TRIPUS, regina.Example3.poincare()), "sphere"),
    "sphere that does not separate": (lambda: connected_sum(TRIPUS, regina.Example3.s2xs1()), "sphere"),
    "trefoil's exterior": (lambda: glued_along_tori(CUSPED, TREFOIL), "torus"),
}


@functools.cache
def made(name):
    return MADE[name][0]()


@pytest.mark.parametrize("name", MADE)
def test_made_up_manifolds(name):
    M, kind = made(name), MADE[name][1]
    answer = M.hyperbolicity()
    assert answer.hyperbolic is False
    assert answer.certificate.objection(M) == ""
    # The search finds the surface, though a group may have said so before.
    table = Table(M.gluings)
    found = search.Search(table, lambda *_: None, time.monotonic() + 60).run()
    assert found["surface"]["kind"] == kind
    pieces = found.pop("pieces")
    data = {"by": "surface", "gluings": table.rows(), **found}
    assert HyperbolicityCertificate(data).objection(M) == ""
    if kind in ("disc", "sphere"):
        assert TRIPUS in [piece["signature"] for piece in pieces]


# Certificates

def spoiled(data, change):
    data = copy.deepcopy(data)
    change(data)
    return HyperbolicityCertificate(data)


@pytest.mark.parametrize("text", [TRIPUS, "dLQbcbcmebs", "dLQbcbcaekw", "dLQacccjkfr"])
def test_certificates_are_about_one_manifold(text):
    certificate = decided(text).certificate
    assert not certificate.check(tripus.Manifold("dLQbcccdero"))
    assert "another" in certificate.objection(tripus.Manifold("dLQbcccdero"))
    assert not spoiled(certificate.data, lambda d: d.update(by="magic")).check()
    assert not spoiled(certificate.data, lambda d: d.pop("gluings")).check()


def test_surfaces_that_are_changed_are_refused():
    data = decided("dLQacccjkfr").certificate.data
    surface = data["surface"]
    for i in range(0, len(surface["vector"]), 5):
        changed = spoiled(data, lambda d, i=i: d["surface"]["vector"].__setitem__(i, 1 - bool(surface["vector"][i])))
        assert not changed.check(), i
    assert not spoiled(data, lambda d: d["surface"].update(kind="annulus")).check()
    assert not spoiled(data, lambda d: d["surface"].update(vector=[0] * len(surface["vector"]))).check()
    other = decided("dLQacccjjwc").certificate.data["gluings"]
    assert "" != spoiled(data, lambda d: d.update(gluings=other)).objection()


def test_permutations_and_homology_are_looked_at():
    M = made("homology sphere")
    data = M.hyperbolicity().certificate.data
    why = data["surface"]["why_essential"]["sides"]
    at = next(i for i, side in enumerate(why) if "permutations" in side)
    identity = {g: [0, 1, 2, 3, 4] for g in why[at]["permutations"]}

    def trivial(d):
        d["surface"]["why_essential"]["sides"][at]["permutations"] = identity

    def one_wrong(d):
        given = d["surface"]["why_essential"]["sides"][at]["permutations"]
        given[next(iter(given))] = [1, 0, 2, 3, 4]

    assert not spoiled(data, trivial).check()
    assert not spoiled(data, one_wrong).check()


def test_groups_that_are_changed_are_refused():
    data = decided("dLQbcbcmebs").certificate.data
    assert not spoiled(data, lambda d: d["group"]["relators"].pop()).check()
    assert not spoiled(data, lambda d: d["group"]["moves"].pop()).check()
    assert not spoiled(data, lambda d: d["group"].update(factors=[])).check()


def test_metrics_carry_a_proof():
    data = decided(TRIPUS).certificate.data
    assert not spoiled(data, lambda d: d.update(proof=None)).check()
    assert not spoiled(data, lambda d: d["proof"]["lengths"].__setitem__(0, "0.7")).check()


# The parts

def test_closed_bigons_by_two_codes():
    """The library's and the certificate's: every consequence agrees."""
    seen = set()
    order = ["moebius band", "disc", "essential annulus", "none"]
    for text in signatures("triangulations-4.txt", 12):
        M = tripus.Manifold(text)
        table = Table(M.gluings)
        bigons = [bigon.ClosedBigon(table, e) for e in range(len(table.edges))]
        found = [b.consequence() for b in bigons if not b.error]
        library = M.verdict().closed_bigon
        assert (library and library["consequence"]) == min(found, key=order.index, default=None)
        seen.update(found)
    assert seen == {"moebius band", "essential annulus", "none"}


@pytest.mark.parametrize(("text", "kinds"), [
    ("dLQbcbcaekw", {"annulus", None}), ("dLQbcbcmebs", {"disc", "annulus", "moebius band"}),
])
def test_surfaces_are_counted_as_regina_does(text, kinds):
    solid = real(text)
    table = search.from_regina(solid)
    assert table.boundary_characteristics() == [-2]
    seen = set()
    for surface in regina.NormalSurfaces(solid, regina.NS_QUAD, regina.NS_VERTEX):
        vector = search.vector_of(surface, table.size)
        if sum(vector) > 40:
            continue
        mine = NormalSurface(table, vector)
        assert mine.euler_characteristic == surface.eulerChar().longValue()
        assert mine.is_connected() == surface.isConnected()
        assert mine.is_two_sided() == surface.isTwoSided()
        seen.add(essential.kind_of(mine))
        if not mine.is_two_sided():
            continue
        pieces = surface.cutAlong().triangulateComponents()
        assert mine.is_separating() == (len(pieces) == 2)
        roots = {mine.piece_at(0), mine.piece_at(1)}
        ranks = sorted(mine.group(root).presentation.homology()[1] for root in roots)
        assert ranks == sorted(piece.homology().rank() for piece in pieces)
    assert kinds <= seen


def test_vectors_that_are_none_are_refused():
    table = search.from_regina(real(TRIPUS))
    for vector in ([0] * 7 * table.size, [1] * 7 * table.size, [1], [1] + [0] * (7 * table.size - 1)):
        with pytest.raises(tripus.InvalidInput):
            NormalSurface(table, vector)


def test_moves_keep_the_group():
    for text in signatures("triangulations-4.txt", 500):
        group = presentation.of_table(Table(tripus.Manifold(text).gluings))
        before = group.homology()
        group.simplify()
        group.shorten()
        assert group.homology() == before
        again = presentation.of_table(Table(tripus.Manifold(text).gluings))
        again.replay(group.moves)
        assert (again.generators, again.relators) == (group.generators, group.relators)
    with pytest.raises(tripus.InvalidInput):
        presentation.Presentation([0, 1], [[1, 1, 2, 2]]).eliminate(0, 0)


def test_names():
    def name(generators, relators, boundary):
        return group_name(presentation.Presentation(range(generators), relators), boundary)

    assert name(3, [], [-4]) == "handlebody of genus 3"
    assert name(3, [], [-2]) == "connected sum of a handlebody of genus 2 and 1 S2 x S1"
    torus = [[1, 2, -1, -2]]
    double = [[1, 2, -1, -2, 3, 4, -3, -4]]
    assert name(4, double, [-2, -2]) == "product of a surface of genus 2 and an interval"
    assert surface_group(presentation.Presentation(range(2), torus)) == (0, True)
    assert surface_group(presentation.Presentation(range(2), [[1, 2, 1, -2]])) == (0, False)
    assert surface_group(presentation.Presentation(range(2), [[1, 2, 1, 2]])) is None
    assert name(3, [[1, 1, 2, 2, 3, 3]], [-2]).startswith("twisted I-bundle")


# Limits, and without Regina

def test_a_budget_ends_cleanly():
    text = "eLAkabcddjrkik"  # of genus 3, hyperbolic: no surface would be found
    begin = time.monotonic()
    answer = without_metric(tripus.Manifold(text), 1.0)
    assert answer.hyperbolic is None
    assert time.monotonic() - begin < 30
    assert answer.message.startswith("not decided; tried: ")
    assert any("normal surfaces" in words for words in answer.tried)
    with pytest.raises(tripus.Undecided):
        bool(answer)
    with pytest.raises(tripus.InvalidInput):
        tripus.Manifold(text).hyperbolicity(time_limit=0)


@pytest.mark.parametrize(("text", "words"), [
    (TREFOIL, "no boundary component has genus 2"), ("cMcabbgqs", "no boundary component has genus 2"),
])
def test_what_is_not_supported_says_so(text, words):
    answer = tripus.Manifold(text).hyperbolicity(time_limit=5)
    assert answer.hyperbolic is None
    assert any("not tried" in w and words in w for w in answer.tried)


def test_orbifolds_are_refused():
    orbifold = tripus.Manifold("dLQbcbcaekw", cone_orders={1: 2})
    with pytest.raises(tripus.Unsupported, match="cone angles"):
        orbifold.hyperbolicity(surfaces=False)
    assert orbifold.with_cone_angles().hyperbolicity(surfaces=False).hyperbolic is False
    answer = run("--no-surfaces", "dLQbcbcaekw 1=2")
    assert answer.returncode == 2 and "cone angles" in answer.stderr


def test_a_python_without_numpy_is_told_so(tmp_path):
    code = ("import sys; sys.modules['numpy'] = None; "
            "from tripus.hyperbolic.__main__ import main; sys.exit(main(['cPcbbbihq']))")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=tmp_path)
    assert (done.returncode, done.stdout) == (3, "")
    assert done.stderr.startswith("tripus: ") and "has no numpy: pip install" in done.stderr


def run(*arguments):
    return subprocess.run(
        [sys.executable, "-m", "tripus.hyperbolic", *arguments], capture_output=True, text=True
    )


def test_command(tmp_path):
    done = run("dLQbcbcmebs")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("dLQbcbcmebs: not hyperbolic: ")
    done = run("dLQbcbcaekw", "--json")
    answer = json.loads(done.stdout)
    assert (answer["input"], answer["hyperbolic"], answer["by"]) == ("dLQbcbcaekw", False, "closed bigon")
    (tmp_path / "answer.json").write_text(done.stdout)
    assert run("--check", str(tmp_path / "answer.json"), "dLQbcbcaekw").stdout == "valid, by closed bigon\n"
    assert run("--check", str(tmp_path / "answer.json"), TRIPUS).returncode == 1
    assert run("nonsense").returncode == 2
    assert run("--time-limit", "-1", TRIPUS).returncode == 2
    (tmp_path / "list.txt").write_text(f"{TRIPUS}\nnonsense\ndLQbcbcmebs\n")
    done = run("--batch", str(tmp_path / "list.txt"), "--json", "--no-surfaces")
    assert [json.loads(line).get("hyperbolic") for line in done.stdout.splitlines()] == [True, None, False]


def test_batches_go_on_where_they_ended(tmp_path):
    inputs = [TRIPUS, "nonsense", "-", "dLQbcbcmebs", "\u00e9", TREFOIL]
    (tmp_path / "list").write_text("# a comment\n" + "".join(f"{line}\n" for line in inputs))
    (tmp_path / "half").write_text("")
    options = ("--batch", str(tmp_path / "list"), "--json", "--no-surfaces")
    plain = run(*options)
    assert plain.returncode == 0
    # Errors name the line of the file, as for every other batch.
    assert [line.split(": ")[1] for line in plain.stderr.splitlines()] == ["line 3", "line 4", "line 6"]

    def answers(text):
        """Without times and what --resume adds."""
        lines = [json.loads(line) for line in text.splitlines()]
        return [{k: v for k, v in line.items() if k not in ("seconds", "checksum")} for line in lines]

    assert [line["input"] for line in answers(plain.stdout)] == inputs
    whole, half = tmp_path / "whole", tmp_path / "half"
    done = run(*options, "--resume", str(whole))
    assert (done.returncode, done.stdout) == (0, "")
    assert answers(whole.read_text()) == answers(plain.stdout)
    lines = whole.read_text().splitlines(keepends=True)
    half.write_text("".join(lines[:3]) + '{"torn')
    done = run(*options, "--resume", str(half))
    assert [line.split(": ")[1] for line in done.stderr.splitlines()] == ["line 6"]
    assert half.read_text().splitlines(keepends=True)[:3] == lines[:3]
    assert answers(half.read_text()) == answers(plain.stdout)
    # Other options, other answers; and what was changed.
    for arguments, change in ((options[:-1], ""), (options, "x")):
        half.write_text("".join(lines).replace("free group", "free group" + change))
        before = half.read_text()
        done = run(*arguments, "--resume", str(half))
        assert done.returncode == 2 and "answered with other options" in done.stderr
        assert half.read_text() == before
    for wrong in (options[:2], (TRIPUS, "--json")):
        assert run(*wrong, "--resume", str(half)).returncode == 2


def test_large_triangulations_keep_to_the_budget_and_are_made_small():
    for text, consequence in (("dLQbcbcaekw", "essential annulus"), ("dLQbcbcmebs", "essential annulus")):
        M = tripus.Manifold(text).covers(90, cover_type="cyclic")[0]
        answer = M.hyperbolicity(surfaces=False)
        assert (M.num_tetrahedra(), answer.hyperbolic) == (270, False)
        assert len(answer.certificate.data["gluings"]) < 270
        assert answer.certificate.objection(M) == ""
        assert "another" in answer.certificate.objection(tripus.Manifold(text))
    M = tripus.Manifold("dLQbcbcmebs").covers(2000, cover_type="cyclic")[0]
    begin = time.process_time()
    answer = M.hyperbolicity(time_limit=0.05)
    assert time.process_time() - begin < 10  # reading its group would take a minute
    assert (answer.hyperbolic, answer.advice) == (None, "more time")


def test_finite_vertices_go_first_and_the_certificate_is_of_the_manifold_given():
    made = tripus.Manifold("dLQbcbcaekw").to_regina()
    made.oneFourMove(made.tetrahedron(0)) if hasattr(made, "oneFourMove") else made.pachner(made.tetrahedron(0))
    M = tripus.Manifold(made)
    assert M.has_finite_vertices()
    answer = M.hyperbolicity(surfaces=False)
    assert answer.hyperbolic is False
    assert answer.certificate.objection(M) == ""


def test_what_may_help_is_said_where_it_may():
    assert tripus.Manifold(TREFOIL).hyperbolicity(time_limit=30).advice is None
    answer = tripus.Manifold("dLQacccjkfr").hyperbolicity(surfaces=False)
    assert (answer.hyperbolic, answer.advice) == (None, "surfaces")
    assert "More time" not in run(TREFOIL, "--time-limit", "30").stdout
    assert "without --no-surfaces" in run("dLQacccjkfr", "--no-surfaces").stdout


def test_without_regina():
    code = (
        "import sys; sys.modules['regina'] = None\n"
        "import tripus\n"
        "print(tripus.Manifold('dLQbcbcmebs').hyperbolicity(surfaces=False))\n"
        "print(tripus.Manifold('dLQacccjkfr').hyperbolicity(surfaces=False).hyperbolic)\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.stderr == ""
    assert done.stdout.splitlines()[1] == "None"
