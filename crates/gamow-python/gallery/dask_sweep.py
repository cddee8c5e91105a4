# %% [markdown]
# # A parameter sweep with Dask
#
# How well can a speed be measured by two eyes? One fit for each speed and distance, spread over workers by Dask: the nearer
# the lamp passes, the better.

# %%
import gamow
import matplotlib.pyplot as plt
import numpy as np
from dask.distributed import Client

plt.style.use("tableau-colorblind10")
speeds, distances, noise = np.linspace(0.1, 0.94, 8), np.geomspace(1, 10, 6), 1e-4


def uncertainty(case):
    """The speed that is fitted to 40 noisy readings of each curve, and its standard error."""
    beta, y, seed = case
    draw = np.random.default_rng(seed)
    curve = gamow.curve(beta=beta, d=0.1, y=y, z=0.5 * y, samples=40)
    readings = {name: curve[name] + draw.normal(0, noise, 40) for name in ("dphi", "dtheta")}
    sigmas = {f"sigma_{name}": np.full(40, noise) for name in readings}
    found = gamow.fit({"T": curve["T"], "d": 0.1, **readings, **sigmas}, bootstrap=0)
    return found.beta.value, found.beta.uncertainty


cases = [(beta, y, seed) for seed, (y, beta) in enumerate((y, beta) for y in distances for beta in speeds)]
# Threads do, as Gamow releases the interpreter's lock; Client("tcp://...") is a cluster.
with Client(processes=False, dashboard_address=None) as client:
    results = np.array(client.gather(client.map(uncertainty, cases)))
assert (results[:3] == [uncertainty(case) for case in cases[:3]]).all()
value, sigma = results.T.reshape(2, len(distances), len(speeds))
# The fits hold the truth, and ten times as far away the same noise costs ten times as much.
assert np.sqrt(np.mean(((value - speeds) / sigma) ** 2)) < 1.3
assert np.allclose(sigma[-1] / sigma[0], 10, rtol=0.1)

figure, axis = plt.subplots(figsize=(7, 3.6), layout="constrained")
mesh = axis.pcolormesh(speeds, distances, 1e3 * sigma, norm="log", edgecolors="white")
axis.set(yscale="log", xlabel=r"$\beta$", ylabel="distance y", title=r"standard error of $\beta$, from readings to 0.1 mrad")
axis.set_yticks(distances, [f"{y:.1f}" for y in distances])
axis.minorticks_off()
figure.colorbar(mesh, ticks=[0.1, 0.3, 1, 3], format="%g", label="thousandths of c")
figure.savefig("dask_sweep.png")
