"""Notebooks: executed by nbclient, looked at in headless Chromium; plots, studies, the browser."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

import numpy as np
import pytest
from conftest import DATA, ROOT

import tripus

nbformat = pytest.importorskip("nbformat")
nbclient = pytest.importorskip("nbclient")
matplotlib_image = pytest.importorskip("matplotlib.image")


@pytest.fixture(scope="module")
def executed():
    cells = [
        "import tripus\nM = tripus.Manifold('cPcbbbihq')\nM",
        "M.view(cells=5, height=400)",
        "M.metric",
        "tripus.plot.valences(M)",
        "tripus.Manifold('dLQbcbcaekw')",
    ]
    book = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(c) for c in cells])
    os.environ.setdefault("IPYTHONDIR", "/tmp/tripus-ipython")
    client = nbclient.NotebookClient(book, timeout=120, kernel_name="python3")
    kernel = pathlib.Path(sys.prefix) / "share/jupyter/kernels"
    client.km = client.create_kernel_manager()
    client.km.kernel_spec_manager.kernel_dirs = [str(kernel)]
    return client.execute()


def html_of(cell):
    (output,) = [o for o in cell.outputs if "data" in o]
    return output["data"]["text/html"]


def test_objects_show_themselves(executed):
    manifold, _, metric, plot, bad = executed.cells
    assert "6.45199027084" in html_of(manifold) and "data:image/png" in html_of(manifold)
    assert "0.596134" in html_of(metric)
    (output,) = plot.outputs
    assert len(output["data"]["image/png"]) > 1000
    assert "infeasible" in html_of(bad) and "data:image/png" not in html_of(bad)


def test_the_view_is_live(executed, tmp_path):
    page = html_of(executed.cells[1])
    assert page.startswith("<iframe srcdoc=") and 'sandbox="allow-scripts"' in page
    assert not re.search(r"""(src|href)=["']https?:""", page), "nothing from the network"
    chromium = shutil.which("chromium")
    assert chromium, "scripts/setup installs chromium"
    document = tmp_path / "notebook.html"
    # The frame is in sight, so that it need not wait until it is.
    eager = page.replace(' loading="lazy"', "")
    document.write_text(f"<!doctype html><body style='margin:0;background:#fff'>{eager}", "utf-8")
    picture = tmp_path / "picture.png"
    # Time in the page is not that of a busy machine's graphics: it gets more until it has drawn.
    for budget in (5_000, 20_000, 80_000, 320_000):
        subprocess.run(
            [chromium, "--headless=new", "--no-sandbox", "--use-angle=swiftshader",
             "--enable-unsafe-swiftshader", f"--user-data-dir={tmp_path / 'profile'}",
             "--window-size=800,600", f"--virtual-time-budget={budget}",
             f"--screenshot={picture}", document.as_uri()],
            capture_output=True, timeout=240, check=True)
        pixels = matplotlib_image.imread(picture)[:300, :, :3]
        colours = len(np.unique((pixels * 15).astype(int).reshape(-1, 3), axis=0))
        if colours > 40:
            break
    assert colours > 40, "cells are drawn in the middle of the frame"


def test_the_browser_opens_a_page(tmp_path):
    opened = tmp_path / "opened"
    browser = tmp_path / "browser"
    browser.write_text(f"#!/bin/sh\necho \"$1\" > {opened}\n")
    browser.chmod(0o755)
    code = "import tripus; tripus.Manifold('cPcbbbihq').view()"
    subprocess.run([sys.executable, "-c", code], check=True, timeout=60,
                   env={**os.environ, "BROWSER": str(browser)})
    path = opened.read_text().strip().removeprefix("file://")
    assert "<!doctype html>" in pathlib.Path(path).read_text()[:100].lower()
    pathlib.Path(path).unlink()


def test_pages_are_those_of_the_program(program, tmp_path):
    program("view", "cPcbbbihq", "-o", str(tmp_path / "program.html"), "--cells", "7")
    page = tripus.Manifold("cPcbbbihq").page(cells=7)
    assert page == (tmp_path / "program.html").read_text()
    with pytest.raises(tripus.InvalidInput):
        tripus.Manifold("cPcbbbihq").page(cells=0)


def test_plots():
    M = tripus.Manifold("dLQbcccdinf")
    for figure in (
        tripus.plot.valences(M), tripus.plot.spectrum(M, length=3),
        tripus.plot.convergence(M, ["newton", "ceres-lbfgs"]),
        tripus.plot.volumes(["cPcbbbihq", "cPcbbbiht", "dLQbcbcaekw"]),
        tripus.plot.volumes(tripus.solve_many(["cPcbbbihq", "dLQbcccdinf"])),
        tripus.plot.volumes(tripus.solve_many(["cPcbbbihq"], as_array=True)),
        tripus.plot.drawing(ROOT / "examples/graphs/knotted-y.json"),
    ):
        assert figure._repr_png_()[:4] == b"\x89PNG"
        assert figure.axes[0].has_data()


def test_studies_are_those_of_the_program(program, tmp_path):
    pandas = pytest.importorskip("pandas")
    texts = ["cPcbbbihq", "dLQbcccdinf"]
    for name in ("convergence", "valence"):
        folder = tmp_path / name
        program("study", name, *texts, "--samples", "3", "-o", str(folder), "--quiet")
        study = tripus.study.run(name, texts, samples=3)
        assert study.paragraph and len(study.facts) > 0
        assert {f"{t}.csv" for t in study.tables} == {p.name for p in folder.glob("*.csv")}
        for table, frame in study.tables.items():
            theirs = pandas.read_csv(folder / f"{table}.csv", keep_default_na=False, dtype=str)
            assert list(frame.columns) == list(theirs.columns) and len(frame) == len(theirs)
            for column, (unit, _) in study.columns[table].items():
                if unit != "seconds" and frame[column].dtype == float:
                    numbers = pandas.to_numeric(theirs[column], errors="coerce")
                    assert np.array_equal(frame[column], numbers, equal_nan=True), column
        figures = study.figures()
        assert set(figures) == {p.stem for p in folder.glob("*.svg")}
        for figure in figures.values():
            assert figure.caption and figure._repr_png_()


def test_a_study_goes_on_in_its_folder(tmp_path):
    first = tripus.study.convergence(["cPcbbbihq"], samples=2, folder=tmp_path / "s")
    again = tripus.study.convergence(["cPcbbbihq"], samples=2, folder=tmp_path / "s")
    for name, frame in first.tables.items():
        assert frame.equals(again.tables[name]), "times too: nothing was done twice"
    with pytest.raises(tripus.InvalidInput):
        tripus.study.convergence(["cPcbbbihq"], samples=3, folder=tmp_path / "s")
    with pytest.raises(tripus.InvalidInput):
        tripus.study.run("nothing")


@pytest.mark.parametrize("script", sorted((ROOT / "examples/python").glob("*.py")), ids=lambda p: p.stem)
def test_examples_run(script):
    done = subprocess.run([sys.executable, str(script)], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    assert done.stdout.count("\n") >= 2


def test_the_documentation_builds_without_network():
    """With every tutorial executed; a warning is an error."""
    nowhere = "http://127.0.0.1:9"
    env = {**os.environ, "http_proxy": nowhere, "https_proxy": nowhere,
           "TRIPUS_PACKAGE": str(pathlib.Path(tripus.__file__).parents[1])}
    done = subprocess.run([ROOT / "scripts/docs", "--no-build"], capture_output=True, text=True,
                          timeout=500, env=env)
    assert done.returncode == 0, done.stderr
    site = ROOT / "build/docs"
    api = (site / "api.html").read_text()
    for name in tripus.__all__:
        if name[0].isupper():
            assert f'id="tripus.{name}"' in api, f"{name} is not in docs/api.md"
    tutorial = (site / "notebooks/drawing.html").read_text()
    assert "srcdoc=" in tutorial and "m004" in tutorial and "6.451990270835" in tutorial
    for page in site.rglob("*.html"):
        loaded = re.findall(r'''<(?:script|img|iframe|link)[^>]*(?:src|href)=["'](https?:[^"']*)''',
                            page.read_text())
        assert not loaded, f"{page} loads {loaded}"


def test_readme_lines_run(program):
    """The lines of README.md and docs/python.md that begin with >>>."""
    import doctest

    for name in ("README.md", "docs/python.md"):
        result = doctest.testfile(str(ROOT / name), module_relative=False,
                                  optionflags=doctest.ELLIPSIS | doctest.IGNORE_EXCEPTION_DETAIL)
        assert result.failed == 0 and result.attempted >= 2, name
    assert DATA.is_dir()


def test_the_page_says_what_the_pointer_rests_on(tmp_path):
    """Tetrahedron, face and word of what is seen; the word leads to the cell that is there."""
    sys.path.insert(0, str(ROOT / "tests/program"))
    from browser import draw

    M = tripus.Manifold("dLQbcccherw")
    page = tmp_path / "page.html"
    page.write_text(M.page(cells=20))
    width, height = 200, 150
    places = [(x, y) for x in range(60, 141, 10) for y in range(40, 111, 10)]
    # Pixels are counted from the lower left corner, places from the upper left one.
    wish = "&hover=" + ",".join(
        f"{(x + 0.5) / width}:{1 - (y + 0.5) / height}" for x, y in places)
    size = f"size={width}x{height}"
    outside, inside = draw(page, f"{size}&model=ball&cells=20{wish}", f"{size}&view=inside{wish}")
    group = M.fundamental_group(simplify_presentation=False)
    domain = M.metric.fundamental_domain()
    place = dict(zip(domain.tetrahedra.tolist(), domain.isometries))
    words = set()
    for (x, y), text in zip(places, outside.facts["hover"]):
        low, high, surface, _ = outside.at(outside.identities, x, y)
        assert bool(text) == (surface > 0)
        if not text:
            continue
        cell = outside.facts["cells"][low + 256 * high]
        match = re.match(r"tetrahedron (\d+), (face|truncation) (\d).*; word (\w+)$", text)
        t, kind, number, word = match.groups()
        assert int(t) == cell["tetrahedron"]
        assert (kind == "truncation") == (surface > 4) and int(number) == (surface - 1) % 4
        isometry = group.O31("" if word == "1" else word) @ place[int(t)]
        assert abs(isometry - np.array(cell["isometry"]).reshape(4, 4)).max() < 1e-6, word
        words.add(word)
    assert len(words) >= 4
    seen = 0
    for (x, y), text in zip(places, inside.facts["hover"]):
        kind, tetrahedron, number, rest = inside.at(inside.identities, x, y)
        if text:
            seen += 1
            assert text.startswith(f"tetrahedron {tetrahedron}, ")
            assert ("truncation" in text) == (kind == 1) and f"; {255 - rest} faces away" in text
    assert seen > 20
