"""Every object is a value: it pickles, is equal afterwards, has a hash that fits, and is a table in
notebooks."""

import copy
import html.parser
import pathlib
import pickle

import pytest

import tripus
from tripus import study, view


SOLID = pathlib.Path(__file__).resolve().parents[2] / "examples/surfaces/knotted-y.off"


def every_kind_of_object():
    M = tripus.Manifold("cPcbbbihq")
    bad = tripus.Manifold("dLQbcbcaekw")
    cusped = tripus.Manifold("cPcbbbiht")
    isometries = M.is_isometric_to(M, return_isometries=True)
    return [
        M, tripus.Manifold("cPcbbbdhq-", name="ü"), tripus.Manifold(cusped, cone_orders={0: 2}),
        cusped, M.metric, cusped.metric, M.volume(), M.verdict(), bad.verdict(),
        bad.verdict().certificate, M.solve(angle_structure=True).angle_structure, M.prove(),
        cusped.prove(), M.homology(), M.fundamental_group(), M.fundamental_group(False),
        M.symmetry_group(), M.canonical(), bad.canonical(), M.compare(bad), M.compare(M),
        isometries[1], M.identify()[0], M.orthospectrum(length=3), M.metric.universal_cover(5),
        M.metric.fundamental_domain(), view.Page("<p>x</p>"), tripus.Diagram("5_1 theta"),
        M.basmajian_discs(length=2), M.shortest_return_path(), tripus.AbelianGroup(0),
        tripus.Diagram("PD: X[4,2,5,1] X[8,6,1,5] X[6,3,7,4] X[2,7,3,8] Cone[1,4]"),
        study.convergence(["cPcbbbihq"], methods=["newton"], samples=1),
        tripus.parameterise(SOLID),
    ]


@pytest.fixture(scope="module")
def things():
    return every_kind_of_object()


def test_there_is_one_of_each_class(things):
    classes = {c for c in vars(tripus).values() if isinstance(c, type)}
    classes -= {c for c in classes if issubclass(c, (Exception, Warning))}
    assert classes <= set(map(type, things)), classes - set(map(type, things))


def test_equal_after_pickling(things):
    for thing in things:
        for again in (pickle.loads(pickle.dumps(thing)), pickle.loads(pickle.dumps(thing, 2)),
                      copy.copy(thing), copy.deepcopy(thing)):
            assert type(again) is type(thing)
            assert again == thing and not again != thing, thing
            assert hash(again) == hash(thing), thing
            assert repr(again) == repr(thing)


def test_all_differ_and_comparing_never_raises(things):
    for i, a in enumerate(things):
        for other in (None, 5, "x", [], object(), float("nan")):
            assert (a == other) is False or isinstance(a, float)
        for j, b in enumerate(things):
            if i != j and not isinstance(a, (float, tripus.Comparison, tripus.Metric)):
                assert a != b, (a, b)
    assert len(set(things)) > len(things) - 3


def test_an_undecided_comparison_is_neither():
    M = tripus.Manifold("cPcbbbihq")
    undecided = tripus.Comparison({**M.compare(M)._fields, "verdict": "unresolved"})
    assert not (undecided == True) and not (undecided == False)  # noqa: E712
    assert undecided == pickle.loads(pickle.dumps(undecided)) != M.compare(M)
    assert hash(M.compare(M)) == hash(True)


class Balance(html.parser.HTMLParser):
    """Every tag that is opened is closed."""

    def __init__(self):
        super().__init__()
        self.open, self.seen = [], []

    def handle_starttag(self, tag, attributes):
        self.seen.append(tag)
        if tag not in ("img", "br"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_startendtag(self, tag, attributes):
        self.seen.append(tag)


def test_every_object_is_a_table_in_notebooks(things):
    for thing in things:
        text = thing._repr_html_()
        balance = Balance()
        balance.feed(text)
        assert balance.open == [], thing
        assert {"table", "iframe"} & set(balance.seen), thing
        assert len(text) < 3_000_000
    pictures = [t for t in things if "<img" in t._repr_html_() or "<svg" in t._repr_html_()]
    classes = {type(t).__name__ for t in pictures}
    assert {"Manifold", "Metric", "CanonicalDecomposition", "CellComplex", "Diagram",
            "Orthospectrum", "BasmajianDiscs"} <= classes, classes


def test_texts_are_escaped():
    M = tripus.Manifold("cPcbbbihq", name="<script>")
    assert "<script>" not in M._repr_html_() and "&lt;script&gt;" in M._repr_html_()
