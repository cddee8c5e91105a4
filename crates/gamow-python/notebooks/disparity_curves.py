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
# # The paper's disparity curves
#
# A point passes two eyes at 0.9 c. The differences of its azimuth and its elevation between the left and the right eye are
# plotted against the observation time $T$, as in the paper by Cryer-Jenkins and Stevenson (2020,
# [10.1098/rspa.2019.0703](https://doi.org/10.1098/rspa.2019.0703)): $d = 0.3$, $y = z = 0.5$.
#
# The paper's binocular model leaves parallax out. Each eye has a light cone of its own, which is the exact model.

# %%
import gamow
import matplotlib.pyplot as plt
import numpy as np

point = {"beta": 0.9, "d": 0.3, "y": 0.5, "z": 0.5}
T = np.linspace(-2, 5, 1401)
models = {"published": "as printed in the paper", "exact": "two light cones"}
curves = {model: gamow.disparity(**point, T=T, model=model) for model in models}

# %%
figure, axes = plt.subplots(1, 2, figsize=(9, 3.5), sharex=True, layout="constrained")
for model, label in models.items():
    axes[0].plot(T, curves[model]["dphi"], label=label)
    axes[1].plot(T, curves[model]["dtheta"], label=label)
axes[0].set(xlabel="T", ylabel=r"$\Delta\phi$ (rad)", title="azimuth, left minus right")
axes[1].set(xlabel="T", ylabel=r"$\Delta\theta$ (rad)", title="elevation, left minus right")
axes[0].legend()
figure.savefig("disparity_curves.png", dpi=150)

# %% [markdown]
# Both eyes see the point equally far at $T_0 = \sqrt{y^2 + z^2 + d^2/4}$. There the published azimuth curve crosses zero, and the
# exact one shows the parallax that was left out.

# %%
T0 = np.sqrt(point["y"] ** 2 + point["z"] ** 2 + point["d"] ** 2 / 4)
at_T0 = {model: gamow.disparity(**point, T=T0, model=model)["dphi"] for model in models}
print(f"T0 = {T0:.4f}: published {at_T0['published']:.1e} rad, exact {at_T0['exact']:.4f} rad")
assert abs(at_T0["published"]) < 1e-12
assert abs(at_T0["exact"] + 0.5829) < 1e-4  # what parallax makes of the paper's section 3

# %% [markdown]
# The same for many speeds at once: arrays are broadcast, so one call fills a table of speeds and times.

# %%
speeds = np.array([0.1, 0.5, 0.9, 0.99])
table = gamow.disparity(**(point | {"beta": speeds[:, None]}), T=T)
figure, axis = plt.subplots(figsize=(6, 3.5), layout="constrained")
for speed, row in zip(speeds, table["dphi"]):
    axis.plot(T, row, label=f"{speed} c")
axis.set(xlabel="T", ylabel=r"$\Delta\phi$ (rad)", title="exact, by speed")
axis.legend()
figure.savefig("speeds.png", dpi=150)
