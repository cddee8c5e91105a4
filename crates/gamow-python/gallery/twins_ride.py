# %% [markdown]
# # The twin's ride
#
# A twin rides away and back with the proper acceleration 1, in four legs of two units of her own time. She is 8 older, her
# brother at home $4 \sinh 2$ = 14.507. What she *sees* of his clock never jumps: it is slow until she turns, at 1.729, and
# fast from then on.

# %%
import gamow
import matplotlib.pyplot as plt
import numpy as np

plt.style.use("tableau-colorblind10")
LEG, legs = 2.0, [1, -1, -1, 1]
clock = np.linspace(0, LEG, 201)
# Each leg is a hyperbola, from the rapidity and the event at which the one before it ended.
rapidity, time, place, own = [np.array([0.0])] * 4
for acceleration in legs:
    eta = rapidity[-1] + acceleration * clock
    time = np.append(time, time[-1] + (np.sinh(eta) - np.sinh(eta[0])) / acceleration)
    place = np.append(place, place[-1] + (np.cosh(eta) - np.cosh(eta[0])) / acceleration)
    rapidity, own = np.append(rapidity, eta), np.append(own, own[-1] + clock)

# Home, just beside her line, as she sees it; on her way back she moves towards -x.
speed, azimuth = np.tanh(np.abs(rapidity)), np.where(rapidity < 0, 180, 0)
home = gamow.sightings(beta=0, d=0, y=1e-3, z=0, T=time, observer_beta=speed, observer_azimuth=azimuth, observer_x=place)
seen, doppler = home["t_left"], home["doppler_left"]
assert np.isclose(time[-1], 4 * np.sinh(2)) and np.isclose(own[-1], 8)
turn = np.argmin(np.abs(own - 4))
assert np.isclose(seen[turn], 2 * np.sinh(2) - 2 * (np.cosh(2) - 1), atol=1e-3)
# Home is straight behind or straight ahead.
assert np.allclose(doppler[place > 0.1], np.exp(-rapidity)[place > 0.1], rtol=1e-3)

figure, (left, middle, right) = plt.subplots(1, 3, figsize=(9, 3.6), width_ratios=[0.8, 1, 1], layout="constrained")
left.plot(0 * time, time, color="C0", label="he, at home")
left.plot(place, time, color="C1", label="she")
for tick in np.arange(1, 8):
    at = np.argmin(np.abs(own - tick))
    left.plot([0, place[at]], [seen[at], time[at]], color="0.7", linewidth=1, zorder=0)
    left.plot(place[at], time[at], "o", color="C1", markersize=4)
left.set(xlabel="x", ylabel="time at home", title="light from home")
left.legend(loc="lower right")
middle.plot(own, own, color="0.6", linestyle="--", label="her own clock")
middle.plot(own, seen, color="C0", label="his clock, as she sees it")
middle.set(xlabel="her clock", ylabel="reading", title="what the clocks show")
middle.legend()
right.plot(own, doppler, color="C0")
right.axhline(1, color="0.6", linestyle="--")
right.set_yscale("log", base=2)
right.set_yticks([1 / 8, 1 / 4, 1 / 2, 1, 2, 4, 8], ["1/8", "1/4", "1/2", "1", "2", "4", "8"])
right.set(xlabel="her clock", title="Doppler factor of home")
figure.savefig("twins_ride.png")
