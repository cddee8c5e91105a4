# %% [markdown]
# # Leaves by speed: through the seasons
#
# A rider receives, as visible, what leaves reflect at D times the visible wavelengths. Leaves are bright in the near infrared, so
# ahead of a faster rider summer turns into autumn (`docs/real-light.md`). Below: materials straight ahead, by the Doppler factor.

# %%
import gamow
import matplotlib.pyplot as plt
import numpy as np

plt.style.use("tableau-colorblind10")
ride = gamow.State("ride-seasons", ride="coast", ride_from=-40, time=0, renderer="reference", samples=1)
speeds = [0, 0.1, 0.2, 0.3]
views = [ride.replace(ride_speed=speed, size=(240, 180), samples=2).render() for speed in speeds]

# A distant wall that rests, a row of each material, in pictures of a few pixels; speeds below 0 lead away from it.
materials = ["leaves", "white_paint", "yellow_paint", "red_paint", "blue_paint", "clay_tile"]
rows = [{"shape": "box", "centre": (100, 0, 2.5 - k), "size": (0.1, 9, 1), "material": name} for k, name in enumerate(materials)]
wall = gamow.Scene({"name": "Wall", "group": [{"name": "wall", "beta": 0, "object": rows}]})
# Another scene ends a ride, so it starts anew here.
look = ride.replace(scene=wall, ride="coast", ride_from=0, time=0, gaze=(0, 0), size=(2, 30), projection="gaze", depth_shift=0, exposure=0)
doppler = np.linspace(0.7, 1.8, 56)
stripes = []
for D in doppler:
    beta = (D**2 - 1) / (D**2 + 1)
    # The rows fill the height of the picture: aberration makes them smaller ahead, by 1/D.
    fov = np.degrees(2 * np.arctan(3 / 100 / 15 / D))
    stripes.append(look.replace(ride_speed=beta, fov=fov).render()[2::5, 0])
stripes = np.stack(stripes, axis=1)
leaves = stripes[0].astype(int)
at_rest = leaves[np.argmin(np.abs(doppler - 1))]
assert at_rest[1] > at_rest[0] > at_rest[2]  # green
faster = leaves[np.argmin(np.abs(doppler - 1.2))]
assert faster[0] > faster[1]  # red

figure = plt.figure(figsize=(8, 4.6), layout="constrained")
above, below = figure.subfigures(2, 1, height_ratios=[1, 1.2])
for axis, speed, view in zip(above.subplots(1, 4), speeds, views):
    axis.imshow(view)
    axis.set(xticks=[], yticks=[], title=f"{speed} c" if speed else "at rest")
axis = below.subplots()
axis.imshow(stripes, extent=(doppler[0], doppler[-1], len(materials), 0), aspect="auto", interpolation="nearest")
axis.hlines(range(1, len(materials)), doppler[0], doppler[-1], color="white", linewidth=3)
axis.set_yticks(np.arange(len(materials)) + 0.5, [name.replace("_", " ") for name in materials])
axis.tick_params(axis="y", length=0)
axis.set(xlabel="Doppler factor D, received over emitted frequency")
figure.savefig("leaves_by_speed.png")
