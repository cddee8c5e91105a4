# %% [markdown]
# # A rolling wheel
#
# A wheel rolls past at 0.93 c. Where it touches the road it rests, and its light comes unshifted. As *measured* on the road the
# wheel is contracted, and its spokes crowd at the top, which moves at $2\beta/(1 + \beta^2)$ = 0.997 c. As *seen*, each point is
# where it was when its light left: the wheel is long as it comes, short as it goes, and its spokes are bent.

# %%
import gamow
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection

plt.style.use("tableau-colorblind10")
beta, radius, y = 0.93, 1.0, 6.0
gamma = 1 / np.sqrt(1 - beta**2)
# The rim, and 16 spokes from the hub to it.
count = 801
rim, spokes = np.linspace(-np.pi, np.pi, count), np.repeat(np.pi / 8 * np.arange(16)[:, None], count, axis=1)
angle = np.vstack([rim, spokes])
rho = np.vstack([np.ones(count), np.tile(np.linspace(0.02, 1, count), (16, 1))])

# Measured at t = 0. In its own frame the wheel is round and turns; its points have other times there, t' = -beta x'.
x_rest = np.zeros_like(angle)
for _ in range(200):
    x_rest = radius * rho * np.cos(angle + beta / radius * beta * x_rest)
height = radius * rho * np.sin(angle + beta / radius * beta * x_rest)
pictures = {"measured": (x_rest / gamma, height, None)}

for words, place in [("seen as it comes", -8), ("abreast", 0), ("as it goes", 8)]:
    T = place / beta + np.hypot(place, y)
    seen = gamow.sightings(beta=beta, d=0, y=y, z=0, T=T, wheel_radius=radius, rho=rho, angle=angle)
    X, doppler = seen["x_left"], seen["doppler_left"]
    pictures[words] = (X, np.hypot(X, y) * np.tan(seen["theta_left"]), doppler)
    # The point that touches the road, at the angle -pi/2 when its light leaves, rests: it has D = 1.
    on_road = np.hypot(np.cos(seen["angle_left"][0]), np.sin(seen["angle_left"][0]) + 1)
    assert abs(doppler[0][np.argmin(on_road)] - 1) < 0.03

widths = [np.ptp(X) + 0.5 for X, _, _ in pictures.values()]
figure, axes = plt.subplots(1, 4, figsize=(9, 2.7), width_ratios=widths, sharey=True, layout="constrained")
for axis, (words, (X, height, doppler)) in zip(axes, pictures.items()):
    points = np.stack([X, radius + height], axis=-1)
    segments = np.stack([points[:, :-1], points[:, 1:]], axis=2).reshape(-1, 2, 2)
    colour = {"color": "white"} if doppler is None else {"array": np.log2(doppler[:, 1:]).ravel(), "cmap": "coolwarm_r", "clim": (-3, 3)}
    lines = axis.add_collection(LineCollection(segments, linewidth=1.7, **colour))
    axis.axhline(0, color="0.6", linewidth=1, zorder=0)
    axis.set(xlabel="x", xlim=(X.min() - 0.25, X.max() + 0.25), ylim=(-0.1, 2.1), aspect="equal", facecolor="0.1")
    axis.set_xticks([round(X.mean())])
    axis.set_title(words, fontsize="medium")
axes[0].set_ylabel("height")
figure.colorbar(lines, label=r"$\log_2 D$", pad=0.01)
figure.savefig("rolling_wheel.png")
