"""The guide's code, the notebooks, and the study on several workers."""

import importlib
import os
import pathlib
import re
import subprocess
import sys

import gamow
import pytest

HERE = pathlib.Path(__file__).resolve().parents[1]
GUIDE = HERE.parents[1] / "docs" / "python.md"
NOTEBOOKS = sorted((HERE / "notebooks").glob("*.py"))


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
