# %% [markdown]
# # A film
#
# A state that is drawn at one time after another makes a film: Gamow's cyclist passes at 0.9 c. He comes in ultraviolet and
# blue, and leaves in infrared, which eyes do not see and which is hatched here.

# %%
import gamow
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.animation import FuncAnimation, PillowWriter

plt.style.use("tableau-colorblind10")
beta, d = 0.9, 0.1
look = dict(layout="left", gaze=(112, -6), fov=120, size=(260, 150), renderer="reference")
state = gamow.State("street", beta=beta, d=d, samples=2, **look)
times = np.array([0.5, 1.5, 2.25, 3, 4, 5.5])
frames = [state.replace(time=time).render() for time in times]

# %% [markdown]
# Each pixel knows which point of which body it shows, and when its light left. Light that arrives at T has travelled for as long
# as it is far from the place of that point, $x = x'/\gamma + \beta t$.

# %%
riders_head = gamow.Scene("street").objects.index("head")
for time in times[1:]:
    pixels = state.replace(time=time, samples=1).render(channels=True)
    shows = pixels["left.id"] == riders_head
    x_rest, y, z, t = (pixels[f"left.{name}"][shows] for name in ("rest_x", "rest_y", "rest_z", "emission_time"))
    x = x_rest * np.sqrt(1 - beta**2) + beta * t + d / 2
    assert shows.any() and np.allclose(time - t, np.sqrt(x**2 + y**2 + z**2), atol=1e-4)

# %%
figure, axes = plt.subplots(2, 3, figsize=(8, 3.5), layout="constrained")
for axis, time, frame in zip(axes.flat, times, frames):
    axis.imshow(frame)
    axis.set(xticks=[], yticks=[])
    axis.set_title(f"T = {time:g}", fontsize="medium")
figure.savefig("film.png")

film, axis = plt.subplots(figsize=(2.6, 1.5))
axis.set_axis_off()
axis.set_position([0, 0, 1, 1])
shown = axis.imshow(frames[0])


def show(number):
    shown.set_data(frames[number])
    return [shown]


FuncAnimation(film, show, frames=len(frames)).save("film.gif", writer=PillowWriter(fps=2))
