# %% [markdown]
# # Stereo depth 1/gamma
#
# One eye sees no contraction: a small ball keeps its round outline. Two eyes do: they place the ball with its depth along the
# line of sight contracted by exactly $1/\gamma$, wherever it is seen (`docs/two-eyes.md` derives it).

# %%
import gamow
import matplotlib.pyplot as plt
import numpy as np

plt.style.use("tableau-colorblind10")
d, y, radius = 1e-4, 10, 0.5
round_it = np.linspace(0, 2 * np.pi, 201)


def placed(beta, x):
    """Where two eyes place the equator of a ball whose middle they see at x, and where they place its middle: both (x, y)."""
    gamma, T = 1 / np.sqrt(1 - beta**2), x / beta + np.hypot(x, y)
    ball = {"x0": np.append(radius * np.cos(round_it), 0) / gamma, "y": np.append(y + radius * np.sin(round_it), y)}
    seen = gamow.stereo(beta=beta, d=d, z=0, T=T, **ball)
    points = np.stack([seen["stereo_x"], seen["stereo_y"]], axis=-1)
    return points[:-1], points[-1]


figure, (map_, plot) = plt.subplots(1, 2, figsize=(9, 3.5), width_ratios=[1.3, 1], layout="constrained")
for x in (-10, -5, 0, 5, 10):
    outline, middle = placed(0.9, x)
    map_.fill(*outline.T, color="C0", alpha=0.8)
    map_.plot([0, middle[0]], [0, middle[1]], color="0.8", linewidth=1, zorder=0)
map_.plot(0, 0, "o", color="black")
map_.annotate("eyes", (0, 0), (8, 0), textcoords="offset points")
map_.set(xlabel="x, along the motion", ylabel="y, distance", title="a ball at 0.9 c, as two eyes place it", aspect="equal")

speeds = np.linspace(0.01, 0.99, 45)
# Each marker at a third of the speeds, so that none hides another.
for first, (x, marker) in enumerate([(-10, "o"), (0, "s"), (10, "^")]):
    depths = []
    for beta in speeds:
        outline, middle = placed(beta, x)
        sight = middle / np.linalg.norm(middle)
        # In the ball's rest frame the depth of this small ball is its diameter.
        depths.append(np.ptp(outline @ sight) / (2 * radius))
    where = "abreast" if x == 0 else "as it comes" if x < 0 else "as it goes"
    plot.plot(speeds[first::3], depths[first::3], marker, label=where)
    assert np.allclose(depths, np.sqrt(1 - speeds**2), atol=1e-3)
plot.plot(speeds, np.sqrt(1 - speeds**2), color="black", linewidth=1, label=r"$1/\gamma$", zorder=0)
plot.set(xlabel=r"$\beta$", ylabel="depth / diameter", title="depth along the line of sight", ylim=(0, 1.05))
plot.legend()
figure.savefig("stereo_depth.png")
