"""Makes smooth-paint.csv: the smoothest reflectances that are red, green and blue in sunlight and add up to 1.

The sum of the squares of their slopes is least, with linear sRGB of 1 for the own primary and 0 for the others,
for eyes that adapt to white paint in sunlight (Bradford, to D65). Needs numpy and scipy; run it in this folder.
"""

import numpy as np
from scipy.optimize import LinearConstraint, minimize

NM = np.arange(360.0, 831.0)
KNOWN_NM = np.arange(380, 781, 5)
TO_SRGB = np.array(
    [[3.2404542, -1.5371385, -0.4985314], [-0.9692660, 1.8760108, 0.0415560], [0.0556434, -0.2040259, 1.0572252]]
)
BRADFORD = np.array([[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]])


def table(name):
    return np.loadtxt(name, delimiter=",", skiprows=1)


def colours():
    """Returns linear sRGB of light that only the reflectance at each known wavelength lets through."""
    sun, matching = table("sun.csv"), table("cie-1931-2deg.csv")[:, 1:4]
    light = np.interp(NM, sun[:, 0], sun[:, 1])[:, None] * matching
    white, screen = light.sum(0), np.linalg.inv(TO_SRGB) @ np.ones(3)
    adapt = np.linalg.inv(BRADFORD) @ np.diag((BRADFORD @ screen) / (BRADFORD @ white)) @ BRADFORD
    hats = np.array([np.interp(NM, KNOWN_NM, hat) for hat in np.eye(len(KNOWN_NM))])
    return TO_SRGB @ adapt @ (hats @ light).T


def main():
    count, of_known = len(KNOWN_NM), colours()
    slope, none, one = np.diff(np.eye(count), axis=0), np.zeros((3, count)), np.eye(count)
    # Red and green are sought; blue is the rest.
    slopes = np.vstack([np.hstack([slope, 0 * slope]), np.hstack([0 * slope, slope]), np.hstack([-slope, -slope])])
    squares = slopes.T @ slopes
    seen = np.vstack([np.hstack([of_known, none]), np.hstack([none, of_known])])
    wanted = np.array([1.0, 0, 0, 0, 1.0, 0])
    found = minimize(
        lambda x: x @ squares @ x,
        np.clip(np.linalg.lstsq(seen, wanted, rcond=None)[0], 0, 1),
        jac=lambda x: 2 * squares @ x,
        hess=lambda x: 2 * squares,
        bounds=[(0, 1)] * (2 * count),
        constraints=[LinearConstraint(seen, wanted, wanted), LinearConstraint(np.hstack([one, one]), 0, 1)],
        method="trust-constr",
        options={"maxiter": 3000, "gtol": 1e-10, "xtol": 1e-12},
    ).x
    red, green = (np.clip(part, 0, 1).round(6) for part in (found[:count], found[count:]))
    with open("smooth-paint.csv", "w", encoding="utf-8") as out:
        out.write("wavelength_nm,red,green,blue\n")
        for nm, r, g in zip(KNOWN_NM, red, green):
            out.write(f"{nm},{r:g},{g:g},{round(1 - r - g, 6):g}\n")


if __name__ == "__main__":
    main()
