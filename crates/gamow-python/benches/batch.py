"""Cost of a million points from Python, beside that of the same batch in Rust: `python benches/batch.py [COMMAND ...]`.

Processor time on all threads, which other programs change least. The two take turns, since only ratios within one run carry over between machines. The package must be a release build; so is what
COMMAND runs by default, `cargo bench -p gamow-python --bench batch`.
"""

import pathlib
import subprocess
import sys
import time

import gamow
import numpy as np

ROWS, TURNS, REPETITIONS = 1_000_000, 3, 15
POINT = {"beta": 0.9, "d": 0.1, "y": 3.0, "z": 2.0}
TIMES = np.linspace(-20.0, 20.0, ROWS)
RUST = sys.argv[1:] or ["cargo", "bench", "--quiet", "--locked", "-p", "gamow-python", "--bench", "batch"]


def best(call):
    """Milliseconds of the fastest repetition."""

    def milliseconds():
        start = time.process_time()
        call()
        return 1e3 * (time.process_time() - start)

    return min(milliseconds() for _ in range(REPETITIONS))


def rust():
    root = pathlib.Path(__file__).resolve().parents[3]
    lines = subprocess.run(RUST, cwd=root, check=True, capture_output=True, text=True).stdout.splitlines()
    return {name: float(value) for name, value in map(str.split, lines)}


def python():
    found = {}
    for name in ("sightings", "disparity"):
        call = getattr(gamow, name)
        out = call(**POINT, T=TIMES)
        found[name] = best(lambda: call(**POINT, T=TIMES, out=out))
        found[f"{name}, new arrays"] = best(lambda: call(**POINT, T=TIMES))
    speeds = POINT | {"beta": np.arange(ROWS) / ROWS}
    found["speeds"] = best(lambda: gamow.disparity(**speeds, T=TIMES, out=out))
    return found


turns = [(rust(), python()) for _ in range(TURNS)]
least = lambda which, name: min(turn[which][name] for turn in turns)
print(f"ms of processor time per {ROWS} points, the best of {TURNS} turns of {REPETITIONS}")
for name in turns[0][1]:
    ours, theirs = least(1, name), least(0, name.split(",")[0])
    print(f"{name:24} Python {ours:8.2f}   Rust {theirs:8.2f}   ratio {ours / theirs:.3f}")
