# %% [markdown]
# # Doppler factor and aberration on the sky
#
# A traveller sees 800 stars, spread evenly over the sky. At speed they crowd together ahead (aberration), bluer there and
# redder behind: $\cos\theta' = (\cos\theta + \beta) / (1 + \beta\cos\theta)$ and $D = \gamma (1 + \beta\cos\theta)$. The
# maps keep areas, and the direction of the motion is in their middle.

# %%
import gamow
import matplotlib.pyplot as plt
import numpy as np

plt.style.use("tableau-colorblind10")
# Evenly spread stars: a spiral of Fibonacci, from behind to ahead.
count, distance = 800, 1e6
number = np.arange(count) + 0.5
cosine, turn = 2 * number / count - 1, np.pi * (3 - np.sqrt(5)) * number
sine = np.sqrt(1 - cosine**2)
stars = {"x0": distance * cosine, "y": distance * sine * np.cos(turn), "z": distance * sine * np.sin(turn)}

figure, axes = plt.subplots(1, 3, figsize=(9, 1.9), layout="constrained", subplot_kw={"projection": "mollweide"})
for beta, axis in zip([0, 0.5, 0.9], axes):
    # The stars rest, and the observer moves along x.
    seen = gamow.sightings(beta=0, d=0, T=0, observer_beta=beta, **stars)
    azimuth, elevation, doppler = seen["phi_left"], seen["theta_left"], seen["doppler_left"]
    assert np.allclose(np.cos(azimuth) * np.cos(elevation), (cosine + beta) / (1 + beta * cosine))
    assert np.allclose(doppler, (1 + beta * cosine) / np.sqrt(1 - beta**2))

    dots = axis.scatter(azimuth, elevation, s=6, c=np.log2(doppler), cmap="coolwarm_r", vmin=-2.2, vmax=2.2, linewidths=0)
    axis.set(xticks=[], yticks=[], facecolor="black")
    axis.set_title(f"{beta} c" if beta else "at rest")
figure.colorbar(dots, ax=axes, label=r"$\log_2 D$", shrink=0.8, pad=0.01)
figure.savefig("doppler_and_aberration.png")
