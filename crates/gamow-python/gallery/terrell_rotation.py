# %% [markdown]
# # Terrell rotation
#
# A small cube is seen abreast at rest, at 0.5 c, 0.8 c and 0.95 c. It does not look contracted: it looks turned, by arcsin
# $\beta$, so that one sees its back. Below each picture stands a cube at rest that somebody has turned by that angle.

# %%
import gamow
import matplotlib.pyplot as plt
import numpy as np

plt.style.use("tableau-colorblind10")
DISTANCE = 60
LOOK = dict(renderer="reference", layout="left", size=(240, 240), samples=2, gaze=(90, 0), fov=2.2, d=0.001, time=DISTANCE)
LOOK |= dict(doppler_shift=False, intensity_exponent="off", ground=False, sky=False, projection="gaze", light="on", shading="emission")


def cube(beta, turn):
    """The picture of a cube that moves at `beta`, turned by `turn` degrees about its upright axis; and which pixels show it."""
    body = {"shape": "box", "centre": (0, DISTANCE, 0), "size": (1, 1, 1), "angle": turn, "pattern": "faces", "light": "white"}
    state = gamow.State(gamow.Scene({"name": "Cube", "object": [body]}), beta=beta, **LOOK)
    return state.render(), state.render(channels=True)["left.id"] >= 0


speeds = [0, 0.5, 0.8, 0.95]
figure, axes = plt.subplots(2, 4, figsize=(8, 4.2), layout="constrained")
for speed, (above, below) in zip(speeds, axes.T):
    angle = np.degrees(np.arcsin(speed))
    moving, shows_moving = cube(speed, 0)
    turned, shows_turned = cube(0, angle)
    differ = (shows_moving != shows_turned).sum() / shows_turned.sum()
    assert differ < 0.03  # to first order in size over distance
    above.imshow(moving)
    below.imshow(turned)
    above.set_title(f"{speed} c" if speed else "at rest")
    below.set_title(f"turned by {angle:.0f}°")
for axis in axes.flat:
    axis.set(xticks=[], yticks=[])
axes[0, 0].set_ylabel("moves to the right")
axes[1, 0].set_ylabel("rests")
figure.savefig("terrell_rotation.png")
