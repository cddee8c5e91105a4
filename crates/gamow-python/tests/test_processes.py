"""Children of a fork, which takes no threads along."""

import os
import subprocess
import sys

import pytest

PROGRAM = """
import multiprocessing
import numpy
import gamow

SMALL = {"renderer": "reference", "samples": 1, "size": "16x12"}

def work(seed):
    beta = numpy.full(100_000, 0.5)
    dphi = gamow.disparity(beta=beta, d=0.1, y=3, z=2, T=seed)["dphi"]
    return dphi[0], gamow.render("street", **SMALL).sum()

if __name__ == "__main__":
    # The parent has its threads before the fork.
    expected = [work(seed) for seed in range(4)]
    with multiprocessing.get_context("fork").Pool(2) as pool:
        assert pool.map(work, range(4)) == expected
    print("done")
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork")
def test_a_child_of_a_fork_computes_the_same():
    done = subprocess.run([sys.executable, "-c", PROGRAM], capture_output=True, text=True, timeout=120, check=False)
    assert (done.returncode, done.stdout) == (0, "done\n"), done.stderr
