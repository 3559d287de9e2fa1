"""Every example in a docstring runs; everything public has one."""

import doctest
import importlib
import inspect
import pkgutil

import pytest

import tripus

MODULES = sorted(
    m.name
    for m in pkgutil.walk_packages(tripus.__path__, "tripus.")
    if m.name.rpartition(".")[2] not in ("_core", "__main__")
)
FLAGS = doctest.ELLIPSIS | doctest.IGNORE_EXCEPTION_DETAIL


@pytest.mark.parametrize("name", ["tripus", *MODULES])
def test_examples(name):
    module = importlib.import_module(name)
    result = doctest.testmod(module, optionflags=FLAGS)
    assert result.failed == 0


def test_there_are_examples():
    finder = doctest.DocTestFinder()
    examples = sum(
        len(t.examples) for name in MODULES for t in finder.find(importlib.import_module(name))
    )
    assert examples > 60


def public_things():
    for name in tripus.__all__:
        thing = getattr(tripus, name)
        yield name, thing
        if inspect.isclass(thing) and thing.__module__.startswith("tripus"):
            for member, value in vars(thing).items():
                if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                    yield f"{name}.{member}", value


@pytest.mark.parametrize(("name", "thing"), list(public_things()), ids=lambda x: str(x)[:40])
def test_everything_has_a_docstring(name, thing):
    assert inspect.getdoc(thing), name
