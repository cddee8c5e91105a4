# %% [markdown]
# # A fit, and how often its interval holds the truth
#
# Speed and distance of a lamp follow from the disparities that two eyes measure. The fit states an interval for the speed that
# should hold the truth in 95 of 100 cases; here 50 observers with noise of their own put that to the test.

# %%
import gamow
import matplotlib.pyplot as plt
import numpy as np

plt.style.use("tableau-colorblind10")
truth, noise, observers = 0.8, 1e-3, 50
curve = gamow.curve(beta=truth, d=0.1, y=4, z=1.5, samples=40)


def fitted(seed):
    """The readings of an observer, and the fit of them."""
    draw = np.random.default_rng(seed)
    readings = {name: curve[name] + draw.normal(0, noise, 40) for name in ("dphi", "dtheta")}
    sigmas = {f"sigma_{name}": np.full(40, noise) for name in readings}
    return readings, gamow.fit({"T": curve["T"], "d": 0.1, **readings, **sigmas}, bootstrap=0)


fits = [fitted(seed) for seed in range(observers)]
intervals = np.array([found.beta.interval for _, found in fits])
holds = (intervals[:, 0] <= truth) & (truth <= intervals[:, 1])
# 95 %, give or take three standard deviations of a binomial count.
assert abs(holds.sum() - 0.95 * observers) <= 3 * np.sqrt(observers * 0.95 * 0.05)

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
readings, found = fits[0]
fine = np.linspace(curve["T"][0], curve["T"][-1], 400)
smooth = gamow.disparity(beta=found.beta.value, d=0.1, y=found.y.value, z=found.z.value, T=fine)
for name, label, colour in [("dphi", r"$\Delta\varphi$", "C0"), ("dtheta", r"$\Delta\theta$", "C1")]:
    left.errorbar(curve["T"], 1e3 * readings[name], 1e3 * noise, fmt=".", color=colour, label=label)
    left.plot(fine, 1e3 * smooth[name], color=colour)
left.set(xlabel="observation time T", ylabel="disparity (mrad)", title="one observer's readings and fit")
left.legend()
rank = np.argsort([found.beta.value for _, found in fits])
for place, number in enumerate(rank):
    style = dict(color="C0", linewidth=2) if holds[number] else dict(color="C1", linewidth=3)
    right.plot(intervals[number], [place, place], **style)
right.axvline(truth, color="black", linewidth=1)
right.set(xlabel=r"95 % interval of $\beta$", ylabel="observer", title=f"{holds.sum()} of {observers} intervals hold the truth")
figure.savefig("fit_and_coverage.png")
