"""A bootstrap of the same fit with SciPy's curve_fit, to compare with `cargo bench --bench bootstrap`.

Run by hand: python3 bootstrap_scipy.py (needs numpy and scipy). Exact model, the paper's tracked point,
240 samples, noise 1 % of the curve's range; each replicate starts at the original optimum.
"""

import sys
import time

import numpy as np
from scipy.optimize import curve_fit

D = 0.1
TRUTH = (0.9, 3.0, 2.0)


def apparent_x(T, a, beta, y, z):
    gamma_squared = 1.0 / ((1.0 - beta) * (1.0 + beta))
    S = beta * T - a
    return gamma_squared * (S - beta * np.sqrt(S * S + (y * y + z * z) / gamma_squared))


def dphi(T, beta, y, z):
    left, right = apparent_x(T, -D / 2, beta, y, z), apparent_x(T, D / 2, beta, y, z)
    return np.arctan2(y, left) - np.arctan2(y, right)


def dtheta(T, beta, y, z):
    left, right = apparent_x(T, -D / 2, beta, y, z), apparent_x(T, D / 2, beta, y, z)
    return np.arctan2(z, np.hypot(left, y)) - np.arctan2(z, np.hypot(right, y))


def both(T, beta, y, z):
    return np.concatenate([dphi(T, beta, y, z), dtheta(T, beta, y, z)])


def bootstrap_seconds(curve, T, data, sigma, replicates, random):
    """Time of `replicates` refits; data and sigma have one column per curve."""
    bounds = ([1e-6, 1e-6, -np.inf], [1 - 1e-12, np.inf, np.inf])
    for name, keywords in (("lm, unbounded", {}), ("trf, bounded", {"bounds": bounds})):
        optimum, _ = curve_fit(curve, T, data.T.ravel(), p0=TRUTH, sigma=sigma.T.ravel(), **keywords)
        start = time.perf_counter()
        estimates = []
        for _ in range(replicates):
            drawn = random.integers(0, len(T), len(T))
            refit, _ = curve_fit(
                curve, T[drawn], data[drawn].T.ravel(), p0=optimum, sigma=sigma[drawn].T.ravel(), **keywords
            )
            estimates.append(refit)
        seconds = time.perf_counter() - start
        errors = np.std(estimates, axis=0, ddof=1)
        yield name, seconds, errors


def main():
    replicates = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    random = np.random.default_rng(1)
    beta, y, z = TRUTH
    rho = np.hypot(y, z)
    T = np.linspace(-3 * rho / beta + rho * np.sqrt(10), 3 * rho / beta + rho * np.sqrt(10), 240)
    clean = np.stack([dphi(T, *TRUTH), dtheta(T, *TRUTH)], axis=1)
    sigma = np.broadcast_to(0.01 * np.ptp(clean, axis=0), clean.shape)
    data = clean + sigma * random.standard_normal(clean.shape)
    for name, curve, columns in (("dphi", dphi, [0]), ("dtheta", dtheta, [1]), ("both", both, [0, 1])):
        parts = bootstrap_seconds(curve, T, data[:, columns], sigma[:, columns], replicates, random)
        for method, seconds, errors in parts:
            errors = ", ".join(f"{error:.2e}" for error in errors)
            print(f"{name:6} {method:14} {1e3 * seconds:9.0f} ms for {replicates} replicates; errors {errors}")


main()
