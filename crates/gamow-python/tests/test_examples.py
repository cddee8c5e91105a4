"""The guide's code, the notebooks, the gallery, and the study on several workers."""

import importlib
import os
import pathlib
import re
import runpy
import subprocess
import sys
import warnings

import gamow
import pytest

HERE = pathlib.Path(__file__).resolve().parents[1]
DOCS = HERE.parents[1] / "docs"
GUIDE = DOCS / "python.md"
NOTEBOOKS = sorted((HERE / "notebooks").glob("*.py"))
GALLERY = sorted(path for path in (HERE / "gallery").glob("*.py") if path.stem != "pictures")


def test_the_guide_runs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"^```python\n(.*?)^```", GUIDE.read_text(), re.MULTILINE | re.DOTALL)
    assert len(blocks) > 3
    names = {}
    for block in blocks:
        if "astropy" in block:
            pytest.importorskip("astropy")
        if "dask" not in block:
            exec(compile(block, str(GUIDE), "exec"), names)
    assert abs(names["beta"].value - 0.9) < 5 * names["beta"].uncertainty
    assert names["rgb"].shape[2] == 3 and (names["rgb"] == names["same"]).all()
    assert len(names["angles"]["T"]) == 3


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs(notebook, tmp_path):
    pytest.importorskip("matplotlib")
    environment = os.environ | {"MPLBACKEND": "Agg"}
    subprocess.run([sys.executable, "-W", "error", notebook], cwd=tmp_path, env=environment, check=True)
    assert list(tmp_path.glob("*.png"))


def test_there_are_notebooks():
    assert [path.stem for path in NOTEBOOKS] == ["disparity_curves", "readings"]


@pytest.mark.parametrize("example", GALLERY, ids=lambda path: path.stem)
def test_an_example_of_the_gallery_runs(example, tmp_path, monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    if "dask" in example.stem:
        pytest.importorskip("dask.distributed")
    matplotlib.use("Agg")
    monkeypatch.chdir(tmp_path)
    # In this process: to import the libraries ten times would take as long as the examples.
    with matplotlib.rc_context(), warnings.catch_warnings():
        warnings.simplefilter("error")
        runpy.run_path(str(example), run_name="__main__")
    matplotlib.pyplot.close("all")
    assert (tmp_path / f"{example.stem}.png").exists()


def test_the_gallery_shows_every_example():
    page = (DOCS / "gallery.md").read_text()
    pictures = {path.stem: path for path in (DOCS / "pictures" / "gallery").iterdir()}
    assert len(GALLERY) >= 10 and pictures.keys() == {example.stem for example in GALLERY}
    for example in GALLERY:
        assert f"gallery/{example.name})" in page and f"(pictures/gallery/{pictures[example.stem].name})" in page
        assert pictures[example.stem].stat().st_size < 60_000


def test_a_study_does_not_depend_on_the_number_of_workers(monkeypatch):
    distributed = pytest.importorskip("dask.distributed")
    path = HERE / "examples" / "coverage_study.py"
    # Workers import it by its name.
    monkeypatch.syspath_prepend(path.parent)
    monkeypatch.setenv("PYTHONPATH", str(path.parent))
    example = importlib.import_module("coverage_study")
    state = gamow.State(scene="cyclist", size="48x36", renderer="reference", samples=1)

    def results(workers):
        cluster = distributed.LocalCluster(
            n_workers=workers, threads_per_worker=1, dashboard_address=None)
        with cluster, distributed.Client(cluster) as client:
            return example.study(client, [0.6, 0.9], [1e-4], 6), example.film(client, state, [0.0, 3.0, 6.0])

    (table, frames), *others = [results(workers) for workers in (1, 2, 4)]
    assert all(fits == 6 and hits >= 3 for hits, fits in table.values())
    assert frames.shape[0] == 3 and (frames[0] != frames[1]).any()
    for other_table, other_frames in others:
        assert other_table == table and (other_frames == frames).all()
