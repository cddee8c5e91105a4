"""How often the 95 % intervals of `gamow.fit` hold the truth, over speeds, noise and replicates; and a film, by
Dask.

`python examples/coverage_study.py [WORKERS]` runs both on a LocalCluster; on a cluster, pass its address to
Client. Needs the packages `distributed` and, of this one, nothing else. The results are the same for any number
of workers: each task has a seed that follows from its place in the study.
"""

import itertools
import sys

import gamow
import numpy as np
from dask.distributed import Client, LocalCluster

SPEEDS = [0.5, 0.8, 0.95]
NOISES = [1e-4, 1e-3]  # radians
REPLICATES = 20
POINT = {"d": 0.1, "y": 4.0, "z": 1.5}


def replicate(speed, noise, number):
    """Whether the interval of beta from one noisy curve holds the true speed; None where there is no fit."""
    draw = np.random.default_rng([round(1e6 * speed), round(1e9 * noise), number])
    curve = gamow.curve(beta=speed, **POINT, samples=40)
    readings = {name: curve[name] + draw.normal(0.0, noise, 40) for name in ("dphi", "dtheta")}
    try:
        found = gamow.fit({"T": curve["T"], "d": POINT["d"], **readings}, bootstrap=100, seed=number + 1)
    except ValueError:
        return None
    interval = found.beta.interval
    return interval is not None and interval[0] <= speed <= interval[1]


def study(client, speeds=SPEEDS, noises=NOISES, replicates=REPLICATES):
    """The coverage for each speed and noise: how many intervals hold the truth, of how many fits."""
    cases = list(itertools.product(speeds, noises, range(replicates)))
    held = client.gather(client.map(replicate, *zip(*cases)))
    table = {}
    for (speed, noise, _), is_held in zip(cases, held):
        hits, fits = table.get((speed, noise), (0, 0))
        table[speed, noise] = (hits + (is_held is True), fits + (is_held is not None))
    return table


def frame(time, state):
    """A frame of a film."""
    return state.replace(time=time).render()


def film(client, state, times):
    """Frames at `times`, an array of shape (frames, height, width, 3)."""
    return np.stack(client.gather(client.map(frame, times, state=state)))


if __name__ == "__main__":
    workers = int(sys.argv[1]) if len(sys.argv) > 1 else 2
    with LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        for (speed, noise), (hits, fits) in study(client).items():
            print(f"beta {speed:<5} noise {1e3 * noise:.1f} mrad: {hits} of {fits} intervals hold the truth")
        small = gamow.State("street", size="160x120", renderer="reference", samples=1)
        print("film", film(client, small, [0.0, 2.0, 4.0, 6.0]).shape)
