"""The package and the program give the same answers, bit for bit."""

import json

import numpy as np
import pytest
from conftest import DATA, column, signatures

import tripus

EVERY = (
    signatures("triangulations-2.txt") + signatures("triangulations-3.txt")
    + signatures("triangulations-4.txt", 25) + signatures("triangulations-cusped.txt")
    + column("cusped-census-5.tsv", 1)[1::5]
)


def comparable(answer):
    return {key: value for key, value in answer.items() if key != "seconds"}


def test_answers_are_those_of_the_program(program_json):
    answers = program_json("solve", EVERY)
    assert len(answers) == len(EVERY)
    for text, answer in zip(EVERY, answers):
        M = tripus.Manifold(text)
        assert comparable(json.loads(M.to_json())) == comparable(answer), text
        verdict = M.verdict()
        assert verdict.edge_lengths.tolist() == answer["edge_lengths"]
        assert verdict.dihedral_angles.tolist() == answer["dihedral_angles"]
        assert verdict.volume == answer["volume"] and verdict.message == answer["message"]
        assert M.edge_classes.tolist() == answer["edge_classes"]
        assert M.valences == answer["edge_valences"]
        if answer["certificate"] is None:
            assert verdict.certificate is None
        else:
            assert json.loads(verdict.certificate.to_json()) == answer["certificate"]


def test_many_are_those_of_the_program(program_json):
    answers = program_json("solve", EVERY)
    many = tripus.solve_many(EVERY, as_array=True)
    for row, answer in zip(many, answers):
        assert row["outcome"] == answer["outcome"]
        assert row["iterations"] == answer["iterations"]
        assert row["max_curvature"] == answer["max_curvature"]
        if row["outcome"] == "geometric":
            assert row["volume"] == answer["volume"]
        else:
            assert np.isnan(row["volume"])


def test_what_it_is(program_json):
    texts = EVERY[::7]
    for text, answer in zip(texts, program_json("info", texts)):
        M = tripus.Manifold(text)
        assert format(M.homology(), "regina") == answer["H1"]
        assert M.num_vertices() == answer["vertex_count"]
        assert [link["kind"] for link in M.links()] == [v["kind"] for v in answer["vertices"]]
        assert M.triangulation_isosig() == answer["isosig"]
        if answer["oriented_isosig"]:
            assert M.triangulation_isosig(oriented=True) == answer["oriented_isosig"]


def test_canonical_answers(program_json):
    texts = [t for t in EVERY[:250:9] if tripus.Manifold(t).num_cusps() == 0]
    for text, answer in zip(texts, program_json("canonize", texts)):
        found = tripus.Manifold(text).canonical()
        assert found.message == answer.get("message", found.message)
        if found:
            assert found.volume == answer["volume"]
            assert found.cells == answer["decomposition"]
            assert found.cell_types == [cell["type"] for cell in answer["cells"]]
            assert found.signature == answer["signature"]


def test_labelled_answers(program):
    """Orb's examples, with labels on their edges."""
    rows = [line.split("\t") for line in (DATA / "orb-examples.tsv").read_text().splitlines()
            if line and line[0] != "#"][1:]
    tried = 0
    for name, _, finite, _, gluings, labels in rows:
        if finite == "yes" or "=" not in labels:
            continue
        table = [[[int(item.split(":")[0]), item.split(":")[1]] for item in gluings.split()[i:i + 4]]
                 for i in range(0, len(gluings.split()), 4)]
        M = tripus.Manifold(table, name=name)
        orders = {}
        for label in labels.split():
            place, order = label.split("=")
            t, ends = place.split(":")
            edge = ["01", "02", "03", "12", "13", "23"].index(ends)
            orders[int(M.edge_classes[int(t), edge])] = order
        options = [f"--cone-order={edge}={order}" for edge, order in orders.items()]
        out = program("solve", "-", "--json", *options, input=M.to_text("json"))
        answer = json.loads(out)
        verdict = M.solve(cone_orders=orders)
        assert verdict.volume == answer["volume"] and verdict.outcome == answer["outcome"], name
        assert verdict.edge_lengths.tolist() == answer["edge_lengths"]
        tried += 1
    assert tried >= 10


def test_methods_are_those_of_the_program(program):
    listed = program("methods", "--json")
    for name in tripus.methods():
        assert json.dumps(name) in listed or name.split(":")[-1].split("/")[0] in listed, name


def test_version(program):
    assert tripus.__version__ in program("--version")


@pytest.mark.parametrize("name", ["nowhere.json", "cPcbbbihx", "t9g9.9"])
def test_errors_are_those_of_the_program(name):
    import os
    import subprocess

    done = subprocess.run([os.environ["TRIPUS_PROGRAM"], "info", name], capture_output=True,
                          text=True)
    expected = tripus.FileError if name.endswith(".json") else tripus.InvalidInput
    with pytest.raises(expected) as caught:
        tripus.Manifold(name)
    assert str(caught.value) in done.stderr


def test_the_package_is_the_program_too(program, tmp_path):
    import os
    import subprocess
    import sys

    def package(*arguments, **options):
        return subprocess.run([sys.executable, "-m", "tripus", *arguments], capture_output=True,
                              text=True, timeout=100, **options)

    assert package("info", "cPcbbbihq").stdout == program("info", "cPcbbbihq")
    assert package("--version").stdout == program("--version")
    assert package("solve", "hello").returncode == 2
    assert package("solve", "dLQbcbcaekw").returncode == 1
    away = {key: value for key, value in os.environ.items() if key != "TRIPUS_PROGRAM"}
    assert "volume" in package("solve", "cPcbbbihq", env=away).stdout
