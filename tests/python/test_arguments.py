"""Wrong arguments to everything public: a typed error that names the argument, and nothing else."""

import inspect
import pathlib
import signal

import numpy as np
import pytest

import tripus
from tripus import diagrams, plot, study, view

M = tripus.Manifold("cPcbbbihq")
SURROGATE = "\ud800"
WRONG = [None, "2", "x", SURROGATE, "\udcff", "a\0b", b"2", b"", 2, 0, -1, 2**70, -(2**70), 1.5,
         float("nan"), float("inf"), 1e400, 1j, True, [], [1, 2], ["x"], [[1.5]], [[None]], {},
         {"a": 1}, {1: "x"}, (), object(), object, len, np.float32(2), np.int64(3), np.zeros(3),
         np.zeros((2, 2)), np.array(2), np.array(["x"]), np.bool_(True), range(3), M, Ellipsis,
         pathlib.Path("/nonexistent/x.json"), pathlib.Path("/nonexistent/" + SURROGATE)]

ALLOWED = (tripus.TripusError, TypeError)


def things():
    """Objects of every public class that has functions."""
    group = M.fundamental_group()
    cells = M.metric.universal_cover(3)
    verdict = tripus.Manifold("dLQbcbcaekw").verdict()
    return [M, M.metric, cells, group, M.symmetry_group(), M.homology(), M.canonical(), M.compare(M),
            M.identify()[0], M.orthospectrum(length=2), M.prove(), verdict, verdict.certificate,
            view.Page("x"), tripus.Diagram("4_1")]


def public_functions():
    """(name, function) of the package, of its modules, and bound ones of objects."""
    out = [(name, getattr(tripus, name)) for name in
           ("census", "load", "methods", "read_batch", "solve_many", "Manifold", "AbelianGroup",
            "Diagram")]
    out += [("Manifold." + name, getattr(tripus.Manifold, name))
            for name in ("from_text", "from_mesh", "from_drawing")]
    for module in (plot, study, diagrams):
        out += [(f"{module.__name__}.{name}", f) for name, f in vars(module).items()
                if inspect.isfunction(f) and f.__module__ == module.__name__ and name[0] != "_"]
    for thing in things():
        for name in dir(type(thing)):
            member = inspect.getattr_static(type(thing), name)
            if name[0] != "_" and inspect.isfunction(member):
                out.append((f"{type(thing).__name__}.{name}", getattr(thing, name)))
    return dict(out)


FUNCTIONS = public_functions()
#: What would open a window, and what takes objects of other packages whole.
LEFT_OUT = {"Page.open", "Manifold.view", "tripus.plot.draw", "tripus.diagrams.tables"}
#: Arguments that any value is good for, or that others are made of.
OTHERS = ("ax", "options", "unknown", "limits", "self", "memo")


class TooLong(Exception):
    pass


def stop(*_):
    raise TooLong


def required(function):
    """Good values for the arguments that have to be given."""
    good = {"source": "cPcbbbihq", "other": M, "manifold": M, "degree": 2, "text": "cPcbbbihq",
            "permutation_rep": [[0, 1]] * 3, "mesh": None, "drawing": [[(0, 0, 0), (1, 0, 0), (0, 1, 0)]],
            "path": "/nonexistent/x", "name": "convergence", "word": "a", "letters": [1],
            "inputs": ["cPcbbbihq"], "lines": [[(0, 0, 0), (1, 0, 0), (0, 1, 0)]], "arcs": M,
            "many": [M], "rank": 1, "edges": [0], "diagram": "4_1"}
    return {name: good[name] for name, p in inspect.signature(function).parameters.items()
            if p.default is p.empty and p.kind not in (p.VAR_POSITIONAL, p.VAR_KEYWORD)}


def quick(name, arguments):
    """Options that keep what is accepted short."""
    if name == "Manifold.orthospectrum" or name == "Metric.orthospectrum":
        if not {"length", "count"} & set(arguments):
            arguments["length"] = 1.0
    return arguments


@pytest.mark.parametrize("name", sorted(set(FUNCTIONS) - LEFT_OUT))
def test_wrong_arguments_are_typed_errors(name, tmp_path, monkeypatch):
    function = FUNCTIONS[name]
    monkeypatch.chdir(tmp_path)
    parameters = [p for p in inspect.signature(function).parameters if p not in OTHERS]
    previous = signal.signal(signal.SIGALRM, stop)
    try:
        for parameter in parameters:
            for value in WRONG:
                arguments = quick(name, {**required(function), parameter: value})
                signal.setitimer(signal.ITIMER_REAL, 20)
                try:
                    with np.errstate(all="raise"):
                        function(**arguments)
                except ALLOWED as error:
                    text = str(error)
                    assert text.isprintable() or "\n" in text
                    for word in ("bad_cast", "incompatible function arguments", "_core",
                                 "nanobind"):
                        assert word not in text, (parameter, value, text)
                except TooLong:
                    pytest.fail(f"{parameter}={value!r} takes too long")
                except Exception as error:
                    raise AssertionError(f"{parameter}={value!r}: {error!r}") from error
                finally:
                    signal.setitimer(signal.ITIMER_REAL, 0)
    finally:
        signal.signal(signal.SIGALRM, previous)


@pytest.mark.parametrize(("work", "words"), [
    (lambda: tripus.census(tetrahedra="2"), "census.*tetrahedra is a whole number, not '2'"),
    (lambda: M.solve(tolerance="x"), "solve.*tolerance is a number, not 'x'"),
    (lambda: M.covers(2.5), "covers.*degree is a whole number, not 2.5"),
    (lambda: M.solve(initial_lengths="abc"), "initial_lengths is a list of numbers"),
    (lambda: M.isomorphisms_to("cPcbbbihq"), "other is a tripus.Manifold"),
    (lambda: M.is_isometric_to(None), "other is a tripus.Manifold"),
    (lambda: tripus.solve_many(5), "inputs is a list"),
    (lambda: tripus.solve_many(M), "inputs is a list"),
    (lambda: M.renamed(5), "name is a text, not 5"),
    (lambda: plot.convergence(M, 5), "methods"),
    (lambda: tripus.Manifold((np.eye(2, 4), np.zeros((2, 4, 4)))), "neighbours are whole numbers"),
    (lambda: tripus.Manifold.from_mesh((np.zeros((4, 3)), [[0, 1.5, 2, 3]])), "are whole numbers"),
    (lambda: tripus.Manifold.from_mesh((np.zeros((4, 3), complex), [[0, 1, 2, 3]])), "real numbers"),
])
def test_types_are_named(work, words):
    with pytest.raises(TypeError, match=words):
        work()


@pytest.mark.parametrize(("work", "words"), [
    (lambda: M.covers(-1), "degree is from 0"),
    (lambda: M.relabelled(2**64), "seed is from 0"),
    (lambda: M.solve(tolerance=float("nan")), "tolerance is a number"),
    (lambda: M.verdict(time_limit=0), "time_limit is a number of seconds > 0"),
    (lambda: M.renamed(SURROGATE), "surrogate"),
    (lambda: tripus.Manifold(SURROGATE), "surrogate"),
    (lambda: tripus.Manifold.from_text(SURROGATE), "surrogate"),
    (lambda: tripus.Manifold(([[-1] * 4], [[[0, 1, 2, 3]] * 4])), "neighbours are from 0"),
    (lambda: tripus.Manifold(([[0] * 4], [[[0, 1, 2, 259]] * 4])), "from 0 to 3, not 259"),
    (lambda: tripus.Manifold.from_mesh((np.zeros((4, 3)), [[0, 1, 2, 2**32 + 3]])), "from 0 to 3"),
    (lambda: tripus.Manifold.from_mesh(([[0, 0, float("nan")]] * 4, [[0, 1, 2, 3]])), "not finite"),
    (lambda: tripus.Manifold.from_drawing([[(0, 0, 0), (1, 0, float("inf")), (0, 1, 0)]]),
     "not finite"),
])
def test_values_are_named(work, words):
    with pytest.raises(tripus.InvalidInput, match=words):
        work()


def test_numbers_of_numpy_are_numbers():
    assert len(M.covers(np.int32(2))) == 3
    assert M.solve(tolerance=np.float32(1e-6)).volume > 6
    assert M.orthospectrum(length=np.float32(2)).arc_count == 1
    assert len(tripus.census(tetrahedra=np.int64(2), volume=np.array([6.0, 7.0]))) > 0


@pytest.mark.parametrize("work", [
    lambda path: tripus.Manifold(path),
    lambda path: tripus.Manifold(str(path)),
    lambda path: tripus.Manifold.from_drawing(path),
    lambda path: tripus.Manifold.from_mesh(path),
    lambda path: tripus.solve_many(path),
    lambda path: tripus.read_batch(path),
    lambda path: M.save(path),
    lambda path: M.write(path),
    lambda path: M.metric.fundamental_domain().write(path.with_suffix(".ply")),
    lambda path: plot.drawing(path),
    lambda path: view.Page("x").save(path),
    lambda path: tripus.Diagram("4_1").save(path.with_suffix(".svg")),
    lambda path: study.convergence(["cPcbbbihq"], methods=["newton"], samples=1,
                                   folder=pathlib.Path("/proc") / "nowhere"),
])
def test_paths_that_cannot_be_used_are_file_errors(work, tmp_path):
    path = tmp_path / "no" / "such" / "folder.json"
    with pytest.raises(tripus.FileError) as caught:
        work(path)
    assert isinstance(caught.value, OSError)
    words = ("No such file", "no file", "neither a file", "cannot make the folder")
    assert any(word in str(caught.value) for word in words), caught.value
    with pytest.raises(tripus.FileError, match="folder|directory|No such"):
        tripus.Manifold(tmp_path)
