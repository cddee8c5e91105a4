"""The functions against the commands: the same numbers, bit for bit."""

import csv
import io
import json

import gamow
import numpy as np
import pytest

ROWS = 10_000
RNG = np.random.default_rng(7)


def spread(low, high):
    return RNG.uniform(low, high, ROWS)


def plain():
    """Points of all speeds and distances, and times around their passage."""
    return {
        "gamma": 10.0 ** spread(0.0, 12.0),
        "d": 10.0 ** spread(-3.0, 1.0),
        "y": spread(-20.0, 20.0),
        "z": spread(-20.0, 20.0),
        "T": spread(-40.0, 40.0),
        "x0": spread(-5.0, 5.0),
    }


def inputs(kind):
    columns = plain()
    if kind in ("turned", "all"):
        columns |= {"roll": spread(-180.0, 180.0), "turn": spread(-180.0, 180.0)}
    if kind in ("wheel", "all"):
        columns |= {"wheel_radius": spread(0.1, 2.0), "rho": spread(0.0, 1.0), "angle": spread(-4.0, 4.0)}
        columns["gamma"] = 10.0 ** spread(0.0, 2.0)
    if kind in ("riding", "all"):
        columns |= {
            "observer_rapidity": spread(0.0, 3.0),
            "observer_azimuth": spread(-180.0, 180.0),
            "observer_elevation": spread(-85.0, 85.0),
            "observer_x": spread(-5.0, 5.0),
            "observer_y": spread(-5.0, 5.0),
            "observer_z": spread(-5.0, 5.0),
        }
        columns["gamma"] = 10.0 ** spread(0.0, 3.0)
    return columns


def as_csv(columns):
    rows = zip(*(column.tolist() for column in columns.values()))
    return "\n".join([",".join(columns), *(",".join(map(repr, row)) for row in rows)]) + "\n"


def read(text):
    rows = csv.reader(io.StringIO(text))
    names = next(rows)
    values = np.array([[float(field or "nan") for field in row] for row in rows])
    return dict(zip(names, values.T))


def assert_same_bits(ours, theirs):
    for name, values in ours.items():
        both_nan = np.isnan(values) & np.isnan(theirs[name])
        same = both_nan | (values.view(np.int64) == theirs[name].view(np.int64)) | (values == theirs[name]) & (values == 0)
        assert same.all(), f"{name}: {np.flatnonzero(~same)[:5]}"


KINDS = ["plain", "turned", "wheel", "riding", "all"]


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("model", ["exact", "one-cone"])
def test_points_are_those_of_eval(gamow_command, kind, model):
    columns = inputs(kind)
    text = gamow_command("eval", "--stereo", "--conformal", "--model", model, stdin=as_csv(columns))
    theirs = read(text)
    seen = gamow.sightings(**columns, model=model, conformal=True)
    stereo = gamow.stereo(**columns, model=model)
    assert set(columns) | set(seen) | set(stereo) == set(theirs)
    assert_same_bits(seen, theirs)
    assert_same_bits(stereo, theirs)
    assert_same_bits(gamow.disparity(**columns, model=model), theirs)


@pytest.mark.parametrize("model", ["published", "published-text"])
def test_published_models_are_those_of_eval(gamow_command, model):
    columns = plain()
    text = gamow_command("eval", "--model", model, "--intensity-exponent", "paper", stdin=as_csv(columns))
    theirs = read(text)
    assert_same_bits(gamow.sightings(**columns, model=model, intensity_exponent="paper"), theirs)
    assert_same_bits(gamow.disparity(**columns, model=model), theirs)


def test_disparities_over_time_are_those_of_eval(gamow_command):
    times = spread(-40.0, 40.0)
    same = {"beta": 0.9, "d": 0.1, "y": 3.0, "z": 2.0, "roll": 20.0}
    columns = {name: np.full(ROWS, value) for name, value in same.items()} | {"T": times}
    theirs = read(gamow_command("eval", stdin=as_csv(columns)))
    assert_same_bits(gamow.disparity(**same, T=times), theirs)
    assert_same_bits(gamow.sightings(**same, T=times), theirs)


def test_curves_are_those_of_the_command(gamow_command):
    for flags, words in [
        ({}, []),
        ({"beta": 0.5, "samples": 50, "stereo": True, "roll": 20}, ["--beta", 0.5, "--samples", 50, "--stereo", "--roll", 20]),
        ({"from_": -2, "to": 8, "wheel_radius": 0.525, "rho": 1, "angle": 0.25},
         ["--from", -2, "--to", 8, "--wheel-radius", 0.525, "--rho", 1, "--angle", 0.25]),
        ({"beta": 0, "x0": 5, "observer_beta": 0.9, "conformal": True},
         ["--beta", 0, "--x0", 5, "--observer-beta", 0.9, "--conformal"]),
    ]:
        theirs = read(gamow_command("curve", *words))
        ours = gamow.curve(**flags)
        assert list(ours) == list(theirs)
        assert_same_bits(ours, theirs)


def test_results_broadcast_as_numpy_does():
    beta, times = np.array([0.1, 0.5, 0.9]), np.linspace(-3.0, 3.0, 8).astype(np.float32)
    whole = gamow.disparity(beta=beta[:, None], d=0.1, y=3, z=[2], T=times)["dphi"]
    assert whole.shape == np.broadcast_shapes((3, 1), (1,), (8,))
    for row, speed in enumerate(beta):
        for column, time in enumerate(times):
            one = gamow.disparity(beta=speed, d=0.1, y=3, z=2, T=time)["dphi"]
            assert isinstance(one, np.float64) and one == whole[row, column]
    every_other = np.linspace(-3.0, 3.0, 16)[::2]
    assert (gamow.disparity(beta=0.5, d=0.1, y=3, z=2, T=every_other)["dphi"]
            == gamow.disparity(beta=0.5, d=0.1, y=3, z=2, T=every_other.copy())["dphi"]).all()
    assert gamow.disparity(beta=0.5, d=0.1, y=3, z=2, T=[])["dphi"].shape == (0,)


def test_given_arrays_are_filled():
    times = np.linspace(-3.0, 3.0, 10)
    times.flags.writeable = False
    first = gamow.sightings(beta=0.5, d=0.1, y=3, z=2, T=times)
    held = {name: np.empty(10) for name in first}
    assert gamow.sightings(beta=0.5, d=0.1, y=3, z=2, T=times, out=held) is held
    assert_same_bits(held, first)


READINGS = {"samples": 41, "beta": 0.8, "y": 4.0, "z": 1.5}


def noisy():
    curve = gamow.curve(**READINGS)
    noise = np.random.default_rng(3).normal(0.0, 1e-5, (2, 41))
    return {"T": curve["T"], "d": curve["d"], "dphi": curve["dphi"] + noise[0], "dtheta": curve["dtheta"] + noise[1]}


@pytest.mark.parametrize("flags", [
    {},
    {"bootstrap": 0, "use": "dphi"},
    {"bootstrap": 64, "seed": 5, "fit_x0": True},
    {"bootstrap": 0, "model": "one-cone"},
])
def test_fits_are_those_of_the_command(gamow_command, tmp_path, flags):
    readings = noisy()
    text = as_csv(readings)
    words = [word for name, value in flags.items() if value is not True for word in (f"--{name.replace('_', '-')}", value)]
    words += [f"--{name.replace('_', '-')}" for name, value in flags.items() if value is True]
    theirs = json.loads(gamow_command("fit", "--json", *words, stdin=text))
    assert gamow.fit(readings, **flags).report == theirs
    file = tmp_path / "readings.csv"
    file.write_text(text)
    assert gamow.fit(file, **flags).report == theirs


def test_a_fit_finds_what_was_measured():
    readings = noisy()
    readings["dphi"][::7] = np.nan
    found = gamow.fit(readings, d=0.1, bootstrap=200)
    for name in ("beta", "y", "z"):
        estimate = getattr(found, name)
        assert abs(estimate.value - READINGS[name]) < 5 * estimate.uncertainty
        low, high = estimate.interval
        assert low < estimate.value < high
    assert found.readings == 82 - 6


def test_a_fit_has_its_covariance_and_residuals():
    readings = noisy()
    readings["dphi"][::7] = np.nan
    found = gamow.fit(readings, bootstrap=0)
    assert found.parameters == ("beta", "y", "z") and found.covariance.shape == (3, 3)
    sigmas = [getattr(found, name).uncertainty for name in found.parameters]
    assert np.allclose(np.sqrt(np.diag(found.covariance)), sigmas) and np.allclose(found.covariance, found.covariance.T)
    best = {name: getattr(found, name).value for name in found.parameters}
    fitted = gamow.disparity(**best, d=readings["d"], T=readings["T"])
    for name, values in found.residuals.items():
        assert np.allclose(values, readings[name] - fitted[name], rtol=1e-6, atol=1e-15, equal_nan=True)
    of_all = np.concatenate(list(found.residuals.values()))
    assert np.isclose(np.sqrt(np.nanmean(of_all**2)), found.rms, rtol=0.05)


def test_remarks_of_a_fit_are_warnings():
    readings = noisy()
    readings["dphi"][20] += 1e-3
    with pytest.warns(gamow.GamowWarning, match="dphi at T = .* stands out") as warned:
        found = gamow.fit(readings, bootstrap=0)
    assert [str(warning.message) for warning in warned] == list(found.remarks) and warned[0].filename == __file__
