"""How often the intervals of a fit hold the truth, from the picture on: rendered, measured, fitted.

`python examples/chain_study.py [CASES]` prints the table of `docs/accuracy.md`: of 100 marks on the paper's cyclist and as many balls by
default. Each case has a speed, a size and a number of pictures of its own, drawn by the reference. A case whose target fewer than 16
pictures show to both eyes counts for nothing, as one whose fit is refused.
"""

import sys
import tempfile
import warnings
from pathlib import Path

import gamow
import numpy as np

SIZES = [(320, 240), (400, 300), (480, 360), (640, 480)]
LEAST_PICTURES = 16


def mark(state, draw):
    """A place on a body that a random pixel of the left eye's picture shows; None where it shows none."""
    seen = {name: values.ravel() for name, values in state.render(channels=True).items()}
    pixels = np.flatnonzero(seen["left.id"] >= 0)
    if not pixels.size:
        return None
    pixel = draw.choice(pixels)
    return tuple(float(seen[f"left.rest_{axis}"][pixel]) for axis in "xyz")


def ball(draw, folder):
    """The file of a scene of one ball, and its middle."""
    place = [float(draw.uniform(*ends)) for ends in [(-1, 1), (2, 5), (0.5, 3)]]
    sphere = {"shape": "sphere", "name": "ball", "centre": place, "radius": float(draw.uniform(0.01, 0.04))}
    return gamow.Scene({"name": "Ball", "object": [sphere]}).save(folder / "ball.toml"), place


def case(kind, number, folder):
    """A fit and the true beta, y, z and x0; None where there is no fit."""
    draw = np.random.default_rng([number, kind == "balls"])
    beta, size = float(draw.uniform(0.3, 0.95)), SIZES[draw.integers(len(SIZES))]
    state = gamow.State("overhead", beta=beta, size=size, renderer="reference")
    times = tuple(np.linspace(-6.0, 12.0, draw.integers(30, 60)))
    if kind == "balls":
        # A gaze that rests: one that follows the ball has it at the same place among the pixels in all pictures.
        scene, place = ball(draw, folder)
        state, target = state.replace(scene=scene, gaze=(90, 35), fov=110), {"object": "ball"}
    else:
        place = mark(state.replace(time=float(draw.uniform(1.5, 5))), draw)
        target = {"point": place}
    if place is None:
        return None
    try:
        readings = gamow.measure(state, times=times, **target)
        if len(readings["T"]) < LEAST_PICTURES:
            return None
        found = gamow.fit(readings, fit_x0=True, seed=number + 1)
    except ValueError:
        return None
    return found, {"beta": beta, "y": place[1], "z": place[2], "x0": place[0] * np.sqrt(1 - beta**2)}


def study(kind, cases):
    """For each parameter the shares of cases whose standard error, and whose 95 % interval, hold the truth; and their number."""
    held, fits = {name: np.zeros(2) for name in ("beta", "y", "z", "x0")}, 0
    with tempfile.TemporaryDirectory() as folder:
        for number in range(cases):
            found = case(kind, number, Path(folder))
            values = found and {name: getattr(found[0], name) for name in held}
            if not values or any(value.uncertainty is None for value in values.values()):
                continue
            fits += 1
            for name, value in values.items():
                truth = found[1][name]
                low, high = value.interval
                held[name] += [abs(value.value - truth) <= value.uncertainty, low <= truth <= high]
    return {name: shares / max(fits, 1) for name, shares in held.items()}, fits


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    for kind in ("marks", "balls"):
        shares, fits = study(kind, int(sys.argv[1]) if len(sys.argv) > 1 else 100)
        print(kind, fits, *(f"{name} {one:.2f} {two:.2f}" for name, (one, two) in shares.items()))
