# %% [markdown]
# # Apparent shape
#
# A square sheet flies past at 0.9 c. Measured, it is contracted to 0.44 of its length, always. *Seen*, it is long as it comes
# and short as it goes: light from its far side has further to travel, so it left earlier, when the sheet was further back.
# Lines across the motion become hyperbolas.

# %%
import gamow
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection

plt.style.use("tableau-colorblind10")
beta = 0.9
gamma = 1 / np.sqrt(1 - beta**2)
lines, along = np.linspace(-2, 2, 9), np.linspace(-2, 2, 81)
# The sheet at rest: nine lines along the motion and nine across it, each of 81 points; its middle passes 5 away.
x_rest = np.concatenate([np.tile(along, (9, 1)), np.repeat(lines[:, None], 81, axis=1)])
y = 5 + np.concatenate([np.repeat(lines[:, None], 81, axis=1), np.tile(along, (9, 1))])

figure, axis = plt.subplots(figsize=(8, 2.8), layout="constrained")
for place in (-10, 0, 10):
    # The time at which the middle of the sheet is seen at this x.
    T = place / beta + np.hypot(place, 5)
    seen = gamow.sightings(beta=beta, d=0, x0=x_rest / gamma, y=y, z=0, T=T)
    X = seen["x_left"]
    # The light cone: x = x0 + beta t, and t is as long before T as light takes from there.
    assert np.allclose(X, x_rest / gamma + beta * (T - np.hypot(X, y)))

    points = np.stack([X, y], axis=-1)
    segments = np.stack([points[:, :-1], points[:, 1:]], axis=2).reshape(-1, 2, 2)
    shades = np.log2(seen["doppler_left"])[:, 1:].ravel()
    colours = LineCollection(segments, array=shades, cmap="coolwarm_r", clim=(-2.1, 2.1), linewidth=1.2)
    axis.add_collection(colours)
    if place:
        axis.plot([0, place], [0, 5], color="0.5", linewidth=1, zorder=0)
axis.plot(0, 0, "o", color="white")
axis.annotate("eye", (0, 0), (8, -3), textcoords="offset points", color="white")
axis.set(xlabel="x, along the motion", ylabel="y, distance", xlim=(-24, 14), ylim=(-0.8, 8.6), aspect="equal", facecolor="0.1")
for x, words in [(-14.5, "it comes"), (-2, "it passes"), (9.5, "it goes")]:
    axis.text(x, 8.2, words, ha="center", va="top", color="white")
figure.colorbar(colours, label=r"$\log_2 D$", shrink=0.75, pad=0.01)
figure.savefig("apparent_shape.png")
