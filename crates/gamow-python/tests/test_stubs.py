"""Signatures and docstrings: every public name has them, and the stub of the compiled part agrees with it."""

import inspect
import pathlib
import subprocess
import sys

import gamow
import pytest

FUNCTIONS = ["sightings", "disparity", "stereo", "curve", "fit", "measure"]


def test_every_name_has_a_docstring():
    for name in gamow.__all__:
        thing = getattr(gamow, name)
        assert name == "__version__" or inspect.getdoc(thing), name
    for kind in (gamow.State, gamow.Scene):
        methods = {name for name in vars(kind) if not name.startswith("_")}
        assert all(inspect.getdoc(getattr(kind, name)) for name in methods)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_argument_is_named_and_explained(name):
    function = getattr(gamow, name)
    keywords = [parameter for parameter in inspect.signature(function).parameters.values() if parameter.kind is parameter.KEYWORD_ONLY]
    assert len(keywords) > 10 and not any(parameter.kind is parameter.VAR_KEYWORD for parameter in keywords)
    text = inspect.getdoc(function) + ("" if name in ("sightings", "fit", "measure") else inspect.getdoc(gamow.sightings))
    missing = [parameter.name for parameter in keywords if parameter.name not in text]
    assert not missing
    # As people read it.
    assert len(str(inspect.signature(function))) < 50 * len(keywords)


def test_the_stub_is_clean(tmp_path):
    pytest.importorskip("mypy")
    allowed = tmp_path / "allowed"
    # A class of pyo3 has `__getattr__` in another slot; an alias of words is no union at run time.
    allowed.write_text("gamow._core.State.__getattr__\ngamow._points.Model\n")
    words = [sys.executable, "-m", "mypy.stubtest", "gamow", "--ignore-missing-stub", "--allowlist", allowed, "--ignore-unused-allowlist"]
    done = subprocess.run(words, capture_output=True, text=True, cwd=tmp_path, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_package_is_typed(tmp_path):
    pytest.importorskip("mypy")
    words = [sys.executable, "-m", "mypy", "--cache-dir", tmp_path, "-p", "gamow"]
    done = subprocess.run(words, capture_output=True, text=True, cwd=tmp_path, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
