"""The command that the package is held against."""

import os
import pathlib
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]


@pytest.fixture(scope="session")
def gamow_command():
    """Runs `gamow` with words; GAMOW names another program than the one in the target folder."""
    target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
    programs = [target / profile / "gamow" for profile in ("release", "debug")]
    there = [program for program in programs if program.exists()]
    newest = max(there, key=lambda program: program.stat().st_mtime, default=programs[0])
    program = os.environ.get("GAMOW", newest)

    def run(*words, stdin=""):
        done = subprocess.run([program, *map(str, words)], input=stdin, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        return done.stdout

    return run
