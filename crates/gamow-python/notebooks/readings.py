# ---
# jupyter:
#   jupytext:
#     text_representation:
#       extension: .py
#       format_name: percent
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [markdown]
# # Speed and distance from a student's readings
#
# A student read the disparities of a lamp off the two pictures, at 24 times, and typed them into a table. How fast was the
# lamp, and how far away did it pass? `gamow.fit` takes the file as it is.

# %%
import csv
import pathlib

import gamow
import matplotlib.pyplot as plt
import numpy as np

try:
    folder = pathlib.Path(__file__).parent
except NameError:  # in a notebook
    folder = pathlib.Path()
file = folder / "readings.csv"
with file.open() as rows:
    readings = {name: np.array(column, float) for name, *column in zip(*csv.reader(rows))}
print(len(readings["T"]), "readings of", ", ".join(readings))

# %%
found = gamow.fit(file, bootstrap=1000)
for name in found.parameters:
    estimate = getattr(found, name)
    low, high = estimate.interval
    print(f"{name:5} {estimate.value:.4f} +- {estimate.uncertainty:.4f}   95 %: {low:.4f} to {high:.4f}")
print(f"reduced chi squared {found.reduced_chi_squared:.2f}")

# %% [markdown]
# Residuals should scatter about zero by their standard deviations, and show no trend: a trend says that the model is wrong.

# %%
best = {name: getattr(found, name).value for name in found.parameters}
T = readings["T"]
fine = np.linspace(T[0], T[-1], 400)
smooth = gamow.disparity(**best, d=readings["d"][0], T=fine)

figure, axes = plt.subplots(2, 2, figsize=(9, 5), sharex=True, height_ratios=[2, 1], layout="constrained")
residuals = found.residuals
for column, name in enumerate(["dphi", "dtheta"]):
    sigma = readings[f"sigma_{name}"]
    axes[0, column].errorbar(T, readings[name], sigma, fmt=".", label="readings")
    axes[0, column].plot(fine, smooth[name], label="fit")
    axes[0, column].set(title=name, ylabel="rad")
    axes[1, column].errorbar(T, residuals[name], sigma, fmt=".")
    axes[1, column].axhline(0, color="grey", linewidth=1)
    axes[1, column].set(xlabel="T", ylabel="residual (rad)")
axes[0, 0].legend()
figure.savefig("residuals.png", dpi=150)

# %% [markdown]
# The readings in this example were made of a lamp at 0.8 c, 4 away and 1.5 higher than the eyes, with noise of 0.5 mrad.

# %%
for name, truth in {"beta": 0.8, "y": 4.0, "z": 1.5}.items():
    assert abs(best[name] - truth) < 5 * getattr(found, name).uncertainty, name
assert 0.5 < found.reduced_chi_squared < 2
assert max(np.abs(residual).max() for residual in residuals.values()) < 4 * 5e-4
