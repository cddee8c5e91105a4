"""Time per point of the naive (printed) formulas in NumPy, plain and in blocks that fit the cache.

Run by hand beside `cargo bench -p relativity-core --bench batch`: the same 10 million points in f64.
"""

import time

import numpy as np

ROWS = 10_000_000
BLOCK = 8192
REPETITIONS = 5
BETA, TIME, APERTURE = 0.9, 1.5, -0.05
GAMMA = 1 / np.sqrt(1 - BETA * BETA)


def sightings(x0, y, z, x, t, d):
    s = x0 - APERTURE + BETA * TIME
    rho_squared = y * y + z * z
    x[:] = GAMMA * GAMMA * s - GAMMA * BETA * np.sqrt(GAMMA * GAMMA * s * s + rho_squared)
    r = np.sqrt(x * x + rho_squared)
    t[:] = TIME - r
    d[:] = 1 / (GAMMA * (1 + BETA * x / r))


def blocked(*columns):
    for start in range(0, ROWS, BLOCK):
        sightings(*(column[start : start + BLOCK] for column in columns))


def best_ns_per_point(work, columns):
    times = []
    for _ in range(REPETITIONS):
        start = time.perf_counter()
        work(*columns)
        times.append(time.perf_counter() - start)
    return min(times) / ROWS * 1e9


index = np.arange(ROWS, dtype=np.float64)
inputs = [((index * step) % 1 - 0.5) * 20 for step in (0.618034, 0.324718, 0.220744)]
outputs = [np.zeros(ROWS) for _ in range(3)]
print(f"plain   {best_ns_per_point(sightings, inputs + outputs):6.2f} ns per point")
print(f"blocked {best_ns_per_point(blocked, inputs + outputs):6.2f} ns per point")
