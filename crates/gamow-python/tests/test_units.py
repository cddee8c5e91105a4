"""Quantities, masks and labels: right, or refused in a line."""

import pickle

import gamow
import numpy as np
import pytest

C = 299_792_458.0
T = np.linspace(-5.0, 20.0, 7)
POINT = {"beta": 0.8, "d": 0.1, "y": 3.0, "z": 2.0, "T": T}


def astropy_units():
    units = pytest.importorskip("astropy.units")
    names = {"m": units.m, "km": units.km, "s": units.s, "ns": units.ns, "us": units.us, "deg": units.deg, "rad": units.rad,
             "mrad": units.mrad, "mm": units.mm, "kg": units.kg, "K": units.K, "m/s": units.m / units.s,
             "": units.dimensionless_unscaled}
    return lambda value, name: units.Quantity(value, names[name])


def pint_units():
    registry = pytest.importorskip("pint").UnitRegistry()
    return lambda value, name: registry.Quantity(value, name)


def value_in(quantity, unit):
    return quantity.to_value(unit) if hasattr(quantity, "to_value") else quantity.m_as(unit)


LIBRARIES = pytest.mark.parametrize("library", [astropy_units, pint_units])


def complaint(call, **inputs):
    with pytest.raises((ValueError, TypeError)) as caught:
        call(**inputs)
    text = str(caught.value)
    assert text and "\n" not in text, text
    return text


@LIBRARIES
def test_lengths_in_several_units_go_together(library):
    """y in m and d in km: the first length's unit holds for all, and times are the lengths of light in them."""
    q = library()
    expected = gamow.sightings(beta=0.8, d=0.1, y=3.0, z=2.0, T=T)
    seen = gamow.sightings(beta=0.8, y=q(3.0, "m"), d=q(1e-4, "km"), z=q(2000.0, "mm"), T=q(T / C * 1e9, "ns"))
    for name, values in expected.items():
        found = seen[name]
        stem = name.rsplit("_", 1)[0]
        if stem in ("x",):
            found = value_in(found, "m")
        elif stem in ("t", "tau"):
            assert str(getattr(found, "unit", None) or found.units) in ("ns", "nanosecond")
            found = value_in(found, "s") * C
        elif stem in ("phi", "theta", "dphi", "dtheta"):
            found = value_in(found, "rad")
        assert np.allclose(found, values, rtol=1e-10, atol=1e-13), name
    in_km = gamow.sightings(beta=0.8, d=q(1e-4, "km"), y=q(3.0, "m"), z=q(2.0, "m"), T=q(T, "m"))
    assert str(getattr(in_km["x_left"], "unit", None) or in_km["x_left"].units) [:2] in ("km", "ki")
    assert np.allclose(value_in(in_km["t_left"], "m"), expected["t_left"], rtol=1e-10, atol=1e-12)


@LIBRARIES
def test_angles_and_speeds_are_converted(library):
    q = library()
    expected = gamow.stereo(beta=0.5, d=0.1, y=3, z=2, T=4.0, roll=30.0, turn=-10.0)
    found = gamow.stereo(beta=q(0.5 * C, "m/s"), d=0.1, y=3, z=2, T=4.0, roll=q(np.radians(30.0), "rad"), turn=q(-10.0, "deg"))
    assert all(np.isclose(found[name], expected[name], rtol=1e-10) for name in expected)
    wheel = {"wheel_radius": 0.525, "rho": 1.0}
    expected = gamow.disparity(beta=0.5, d=0.1, y=3, z=2, T=4.0, angle=np.radians(50), **wheel)
    found = gamow.disparity(beta=0.5, d=0.1, y=3, z=2, T=4.0, angle=q(50.0, "deg"), **wheel)
    assert np.isclose(value_in(found["dphi"], "rad"), expected["dphi"], rtol=1e-10)
    curve = gamow.curve(d=q(10.0, "mm"), y=q(3.0, "m"), z=q(2.0, "m"), samples=5, roll=q(20.0, "deg"))
    assert np.allclose(value_in(curve["dphi"], "rad"), gamow.curve(d=0.01, samples=5, roll=20)["dphi"], rtol=1e-9)
    assert np.allclose(value_in(curve["roll"], "deg"), 20.0) and np.allclose(value_in(curve["y"], "m"), 3.0)


@LIBRARIES
def test_a_fit_takes_and_gives_units(library):
    q = library()
    seen = gamow.disparity(**POINT | {"T": np.linspace(-5, 20, 60)})
    noise = np.random.default_rng(2).normal(0, 1e-5, (2, 60))
    readings = {"dphi": seen["dphi"] + noise[0], "dtheta": seen["dtheta"] + noise[1]}
    plain = gamow.fit({"T": np.linspace(-5, 20, 60), **readings}, d=0.1, bootstrap=50)
    found = gamow.fit({"T": q(np.linspace(-5, 20, 60) / C * 1e6, "us"), "dphi": q(readings["dphi"] * 1e3, "mrad"),
                       "dtheta": readings["dtheta"]}, d=q(100.0, "mm"), bootstrap=50)
    assert np.isclose(found.beta.value, plain.beta.value, rtol=1e-9)
    assert np.isclose(value_in(found.y.value, "m"), plain.y.value, rtol=1e-8)
    assert np.isclose(value_in(found.y.interval[1], "m"), plain.y.interval[1], rtol=1e-6)


@LIBRARIES
@pytest.mark.parametrize("changed, told", [
    ({"y": (3.0, "kg")}, "y: a Quantity in kg"),
    ({"y": (3.0, "s")}, "it must be a length"),
    ({"roll": (3.0, "m")}, "it must be an angle"),
    ({"beta": (3.0, "deg")}, "beta: a Quantity in deg"),
    ({"gamma": (3.0, "m"), "beta": None}, "a number without a unit"),
    ({"rho": (3.0, "deg"), "wheel_radius": 1.0, "angle": 0.0}, "rho: a Quantity in deg"),
    ({"y": (3.0, "m")}, "a number without a unit, beside others in m"),
    ({"T": (3.0, "s")}, "a number without a unit"),
    ({"T": (3.0, "K")}, "it must be a time or a length"),
])
def test_other_units_are_refused_in_a_line(library, changed, told):
    q = library()
    given = {name: q(*value) if isinstance(value, tuple) else value for name, value in changed.items()}
    assert told in complaint(gamow.disparity, **POINT | given).replace("kilogram", "kg").replace("degree", "deg").replace("meter", "m")


@LIBRARIES
def test_what_would_lose_its_unit_is_refused(library):
    q = library()
    assert "a list of Quantities" in complaint(gamow.disparity, **POINT | {"y": [q(3.0, "m"), q(2.0, "km")]})
    assert "a list of Quantities" in complaint(gamow.disparity, **POINT | {"y": [[q(3.0, "m")], [q(2.0, "km")]]})
    lengths = {name: q(POINT[name], "m") for name in ("d", "y", "z", "T")}
    out = {name: np.empty(7) for name in ("dphi", "dtheta")}
    assert "out" in complaint(gamow.disparity, beta=0.5, **lengths, out=out)
    with pytest.raises(TypeError, match="a number, in the unit of its scene"):
        gamow.State(d=q(1.0, "km"))
    with pytest.raises(TypeError, match="files?"):
        gamow.fit("readings.csv", d=q(1.0, "km"))
    assert gamow.State(roll=q(np.pi / 6, "rad"), gaze=(q(1.0, "rad"), 0)).roll == pytest.approx(30.0)


def test_units_of_other_packages_are_refused():
    class Length:
        units = "m"

        def __array__(self, dtype=None, copy=None):
            return np.array(3.0)

    assert "are not known" in complaint(gamow.disparity, **POINT | {"y": Length()})


def test_two_packages_in_one_call_are_refused():
    a, p = astropy_units(), pint_units()
    assert "in one call" in complaint(gamow.disparity, **POINT | {"y": a(3.0, "m"), "d": p(3.0, "m")})


def test_masks_are_kept():
    times = np.ma.MaskedArray(T.copy(), mask=[False, True, False, False, False, True, False])
    times.data[1] = np.nan
    seen = gamow.sightings(**POINT | {"T": times})
    plain = gamow.sightings(**POINT)
    for name, values in seen.items():
        assert (values.mask == times.mask).all() and (values.compressed() == plain[name][~times.mask]).all()
    speeds = np.ma.MaskedArray([[0.1], [5.0]], mask=[[False], [True]])
    both = gamow.disparity(**POINT | {"T": times, "beta": speeds})["dphi"]
    assert (both.mask == times.mask | speeds.mask).all() and both.shape == (2, 7)
    assert complaint(gamow.disparity, **POINT | {"T": np.ma.MaskedArray([0, np.nan], mask=[True, False])}).startswith("[1]: ")
    units = astropy_units()
    masked = gamow.sightings(beta=speeds, d=units(0.1, "m"), y=units(3.0, "m"), z=units(2.0, "m"), T=0)["x_left"]
    assert masked.mask.tolist() == speeds.mask.tolist() and str(masked.unit) == "m"


def test_the_index_is_kept():
    pandas = pytest.importorskip("pandas")
    times = pandas.Series(T, index=list("abcdefg"), name="clock")
    seen = gamow.sightings(**POINT | {"T": times})
    assert all(series.index.equals(times.index) and series.name == name for name, series in seen.items())
    assert (seen["dphi"].to_numpy() == gamow.disparity(**POINT)["dphi"]).all()
    assert "another index" in complaint(gamow.disparity, **POINT | {"T": times, "y": pandas.Series(T, index=range(7))})
    assert "2 dimensions" in complaint(gamow.disparity, **POINT | {"T": times, "y": np.ones((2, 7))})
    assert "a table" in complaint(gamow.disparity, **POINT | {"T": times.to_frame()})
    assert "numbers are needed" in complaint(gamow.disparity, **POINT | {"T": pandas.Series(["a"] * 7)})
    units = astropy_units()
    lengths = {name: units(POINT[name], "m") for name in ("d", "y", "z")}
    assert "cannot be returned" in complaint(gamow.disparity, beta=pandas.Series([0.5]), **lengths, T=0)
    table = pandas.DataFrame({"T": T, "d": 0.1, **gamow.disparity(**POINT)})
    assert gamow.fit(table, bootstrap=0).beta.value == pytest.approx(0.8)


def test_dimensions_are_kept():
    xarray = pytest.importorskip("xarray")
    times = xarray.DataArray(T, dims="time", coords={"time": T}, attrs={"note": "mine"})
    speeds = xarray.DataArray([0.1, 0.5], dims="speed", coords={"speed": [0.1, 0.5]})
    seen = gamow.disparity(**POINT | {"T": times, "beta": speeds})["dphi"]
    assert set(seen.dims) == {"time", "speed"} and (seen.time.data == T).all()
    for speed in (0.1, 0.5):
        assert (seen.sel(speed=speed).data == gamow.disparity(**POINT | {"beta": speed})["dphi"]).all()
    assert "without names of dimensions" in complaint(gamow.disparity, **POINT | {"T": times, "y": T})
    shifted = times.assign_coords(time=T + 1)
    assert "coordinates differ" in complaint(gamow.disparity, **POINT | {"T": times, "y": shifted})
    assert "attrs['units'] = 'km'" in complaint(gamow.disparity, **POINT | {"T": times.assign_attrs(units="km")})
    q = pint_units()
    inside = gamow.sightings(beta=0.8, d=q(0.1, "m"), y=q(3.0, "m"), z=q(2.0, "m"), T=xarray.DataArray(q(T, "m"), dims="time"))
    assert inside["x_left"].dims == ("time",) and str(inside["x_left"].data.units) == "meter"


def test_missing_readings_may_be_masked():
    T = np.linspace(-5, 20, 40)
    seen = gamow.disparity(**POINT | {"T": T})
    noise = np.random.default_rng(5).normal(0, 1e-5, 40)
    holes = np.arange(40) % 5 == 0
    masked = gamow.fit({"T": T, "d": 0.1, "dphi": np.ma.MaskedArray(seen["dphi"] + noise, holes)}, bootstrap=0)
    missing = gamow.fit({"T": T, "d": 0.1, "dphi": np.where(holes, np.nan, seen["dphi"] + noise)}, bootstrap=0)
    assert masked.readings == 32 and masked.beta == missing.beta
    assert (np.isnan(masked.residuals["dphi"]) == holes).all()
    assert "T is masked" in complaint(lambda **data: gamow.fit(data), T=np.ma.MaskedArray(T, holes), d=0.1, dphi=seen["dphi"])


#: Factors to metres, or to metres of light, and to radians.
LENGTHS = {"m": 1.0, "km": 1e3, "mm": 1e-3}
TIMES = {"s": C, "ns": C * 1e-9, "us": C * 1e-6}
ANGLES = {"deg": np.pi / 180, "rad": 1.0, "mrad": 1e-3}
WRONG = ["kg", "K"]


def mixed(rng, q):
    """Inputs of random kinds, those as numbers in metres, and whether they must be refused."""
    plain = {"beta": rng.uniform(0, 0.95), "d": rng.uniform(0.01, 1), "y": rng.uniform(-5, 5), "z": rng.uniform(-5, 5),
             "T": rng.uniform(-10, 20, rng.integers(1, 5)), "x0": rng.uniform(-2, 2), "roll": rng.uniform(-180, 180)}
    for name in [name for name in ("x0", "roll") if rng.random() < 0.5]:
        del plain[name]
    has_units, is_wrong, given = rng.random() < 0.7, False, {}
    for name, value in plain.items():
        kind = rng.random()
        if name == "beta":
            given[name] = q(value * C, "m/s") if kind < 0.3 else q(value, "") if kind < 0.4 else value
        elif name == "roll":
            unit = rng.choice(list(ANGLES))
            given[name] = q(np.radians(value) / ANGLES[unit], unit) if kind < 0.5 else value
        elif has_units:
            units = LENGTHS | (TIMES if name == "T" else {})
            unit = rng.choice(list(units))
            given[name] = q(value / units[unit], unit)
        else:
            given[name] = value
    if rng.random() < 0.3:
        name = rng.choice(list(given))
        if has_units and name in ("d", "y", "z", "T", "x0") and rng.random() < 0.5:
            given[name] = plain[name]
        else:
            given[name] = q(plain[name], rng.choice(WRONG + (["s"] if name in ("d", "y", "z", "x0") else [])))
        is_wrong = True
    return given, plain, is_wrong


@LIBRARIES
def test_mixed_inputs_are_right_or_refused(library):
    q, rng = library(), np.random.default_rng(64)
    refused = 0
    for _ in range(1000):
        given, plain, is_wrong = mixed(rng, q)
        if is_wrong:
            complaint(gamow.sightings, **given)
            refused += 1
            continue
        seen, expected = gamow.sightings(**given), gamow.sightings(**plain)
        for name, unit in {"x_left": "m", "t_right": "m", "tau_left": "m", "phi_left": "rad", "dphi": "rad", "dtheta": "rad"}.items():
            found = seen[name]
            if hasattr(found, "unit") or hasattr(found, "units"):
                is_time = name[0] == "t" and not is_length(found)
                found = value_in(found, "s") * C if is_time else value_in(found, unit)
            assert np.allclose(found, expected[name], rtol=1e-8, atol=1e-9), (name, given)
    assert 200 < refused < 400


def is_length(quantity):
    unit = getattr(quantity, "unit", None)
    return unit.is_equivalent("m") if unit is not None else quantity.check("[length]")


def test_states_stay_picklable_with_units_loaded():
    astropy_units()
    state = gamow.State("street", roll=10)
    assert pickle.loads(pickle.dumps(state)) == state
