"""Bad input: an exception in a line, and never a crash."""

import gamow
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

GOOD = {"beta": 0.5, "d": 0.1, "y": 3.0, "z": 2.0, "T": 1.0}


def complaint(call, *words, **flags):
    with pytest.raises((ValueError, TypeError)) as caught:
        call(*words, **flags)
    text = str(caught.value)
    assert text and "\n" not in text and len(text) < 4200, text
    # Words of the command line are none of Python's.
    assert "--" not in text and "header" not in text, text
    return text


@pytest.mark.parametrize("changed, told", [
    ({"beta": 1.2}, "beta = 1.2 is out of range: it must be at least 0 and below 1"),
    ({"T": [0.0, np.nan]}, '[1]: T: "NaN" is not finite; it should be a number that a 64-bit float can hold'),
    ({"d": [[0.1], [-1.0]]}, "[1, 0]: d = -1.0 is out of range: it must be between 0 and 1e60"),
    ({"roll": 181.0}, "roll = 181.0 is out of range: it must be between -180 and 180, in degrees"),
    ({"gamma": 2.0}, "beta and gamma both give the speed; there should be one of beta, gamma, rapidity"),
    ({"rho": 1.0}, "rho is given, and wheel_radius is not; wheel_radius, rho and angle go together"),
    ({"y": [1, 2, 3], "T": [1, 2]}, "y has the shape [3] and T has [2], which cannot be broadcast together"),
    ({"y": "far"}, "y: numbers are needed, not text"),
    ({"y": 1j}, "y: numbers are needed, not complex ones"),
    ({"y": object()}, "y: numbers are needed, not objects"),
    ({"y": [[1, 2], [3]]}, "y: numbers are needed, not a list of unequal lists"),
    ({"model": "newton"}, "model = newton: must be one of exact, one-cone, published, published-text"),
])
def test_bad_points_are_refused_in_a_line(changed, told):
    assert complaint(gamow.disparity, **(GOOD | changed)) == told


def test_what_is_missing_or_unknown_is_named():
    assert "'d', 'y', 'z', and 'T'" in complaint(gamow.disparity)
    assert "'z'" in complaint(gamow.sightings, beta=0.5, d=1, y=1, T=0)
    assert complaint(gamow.sightings, beta=None, d=1, y=1, z=None, T=0) == "missing: z, one of beta, gamma, rapidity"
    assert complaint(gamow.sightings, **GOOD, foo=1).startswith("there is no keyword `foo`: there are beta, gamma, ")
    assert complaint(gamow.sightings, **GOOD, observer_betta=1) == "there is no keyword `observer_betta`: did you mean `observer_beta`?"
    assert complaint(gamow.stereo, **GOOD, model="published").startswith("the model published has no stereo")


def test_arrays_that_cannot_be_filled_are_refused():
    times = np.linspace(0.0, 1.0, 5)
    fresh = lambda: {name: np.empty(5) for name in ("dphi", "dtheta")}
    points = GOOD | {"T": times}
    read_only = fresh()
    read_only["dphi"].flags.writeable = False
    one = np.empty(5)
    for out, told in [
        (read_only, "out['dphi'] is read-only"),
        ({"dphi": one, "dtheta": one}, "out['dtheta'] is read-only, or is given twice"),
        (fresh() | {"dtheta": times}, "out['dtheta'] is read-only, or is given twice"),
        ({"dphi": one}, "out['dtheta'] is missing"),
        (fresh() | {"dphi": np.empty(4)}, "out['dphi'] must be a contiguous array of the shape [5]"),
        (fresh() | {"dphi": np.empty(10)[::2]}, "out['dphi'] must be a contiguous array of the shape [5]"),
        (fresh() | {"dphi": np.empty(5, np.float32)}, "out['dphi'] must be an array of 64-bit floats"),
        (fresh() | {"dphi": [0.0] * 5}, "out['dphi'] must be an array of 64-bit floats"),
    ]:
        assert complaint(gamow.disparity, **points, out=out).startswith(told)
    # Nothing is held after a refusal.
    gamow.disparity(**points, out={"dphi": one, "dtheta": np.empty(5)})


@pytest.mark.parametrize("call, words, flags, told", [
    (gamow.curve, [], {"beta": 3}, "beta = 3 is out of range"),
    (gamow.curve, [], {"betta": 3}, "there is no keyword `betta`: did you mean `beta`?"),
    (gamow.curve, [], {"out": "x.csv"}, "there is no keyword `out`"),
    (gamow.curve, [], {"from_": 5, "to": 3}, "from_=5 must be below to=3"),
    (gamow.State, [], {"gazze": 3}, "there is no keyword `gazze`: did you mean `gaze`?"),
    (gamow.State().replace, [], {"samplse": 3}, "there is no keyword `samplse`: did you mean `samples`?"),
    (gamow.measure, ["x.exr"], {"objects": 3}, "there is no keyword `objects`: did you mean `object`?"),
    (gamow.fit, [{}], {"bootstrapp": 3}, "there is no keyword `bootstrapp`: did you mean `bootstrap`?"),
    (gamow.curve, [], {"samples": 1e9}, "samples = 1000000000: must be at most 10000000"),
    (gamow.curve, [], {"beta": [0.1, 0.2]}, "beta = 0.1,0.2: not a number"),
    (gamow.curve, [], {"stereo": "yes"}, "stereo: must be True or False"),
    (gamow.curve, [], {"rho": 1}, "angle, wheel_radius is missing"),
    (gamow.fit, [{}], {}, "data: column T is missing"),
    (gamow.fit, [3], {}, "data: must be the path of a CSV file, or arrays by column"),
    (gamow.fit, ["/nowhere.csv"], {}, "/nowhere.csv: "),
    (gamow.fit, [{"T": [0, 1], "dphi": [0, np.inf]}], {"d": 0.1}, "data: [1]: column dphi: a number must be finite"),
    (gamow.fit, [{"T": [0, 1], "dphi": [0, 1]}], {"d": 0.1, "bootstrap": 1}, "bootstrap = 1: must be 0, or a number from 2 to 10000000"),
    (gamow.State, ["nowhere"], {}, "no preset is called `nowhere`"),
    (gamow.State, ["/nowhere.toml"], {}, "/nowhere.toml: cannot read these settings"),
    (gamow.State, ["beta = 3\n"], {}, "state:1: unknown setting `beta`"),
    (gamow.State, [{"motion": {"beta": 3}}], {}, "state:2: beta = 3 is out of range"),
    (gamow.State, [{"motion": {"beta": {}}}], {}, "motion: a section holds settings, and no sections"),
    (gamow.State, [{1: 2}], {}, "the keys of a dict must be text"),
    (gamow.State, [7], {}, "a state is a name, a path, a link, TOML text, a dict, a Scene or a State"),
    (gamow.render, [], {"size": "0x0"}, "size = 0x0"),
    (gamow.render, [], {"renderer": "packets", "geometry": "published"}, "geometry='published' is defined point by point: only `renderer='mesh'` draws it"),
    (gamow.measure, ["/nowhere.exr"], {"point": (0, 3, 2)}, "/nowhere.exr: "),
    (gamow.measure, ["/nowhere.exr"], {}, "point or object or marker is missing"),
    (gamow.measure, [5], {"point": (0, 3, 2)}, "what is measured is a path, a list of paths or a State"),
    (gamow.measure, [gamow.State()], {"point": (0, 3, 2)}, "times: the T at which the state is drawn are needed"),
])
def test_bad_calls_are_refused_in_a_line(call, words, flags, told):
    assert told in complaint(call, *words, **flags)


NUMBERS = st.floats(width=64) | st.floats(-10, 10) | st.integers(-3, 10**400) | st.booleans() | st.none()
SHAPES = arrays.array_shapes(min_dims=0, max_dims=3, min_side=0, max_side=3)
ARRAYS = arrays.arrays(st.sampled_from([float, "f4", "f2", int, "u1", bool, complex, "U2", object, "M8[s]"]), SHAPES)
ODD = st.text(max_size=8) | st.binary(max_size=4) | st.lists(NUMBERS, max_size=3) | st.dictionaries(st.text(max_size=2), NUMBERS, max_size=2)
VALUES = NUMBERS | ARRAYS | ODD
COLUMNS = ["beta", "gamma", "rapidity", "d", "y", "z", "T", "x0", "roll", "turn", "wheel_radius", "rho", "angle",
           "observer_beta", "observer_gamma", "observer_azimuth", "observer_x", "observer_", "conformal", "model", "out", "é"]
FUZZ = settings(max_examples=300, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))


def is_survived(call, *words, **flags):
    """Calls it; an exception must be one of Python's own, in a line."""
    try:
        return call(*words, **flags)
    except (ValueError, TypeError, OverflowError) as error:
        assert "\n" not in str(error), error
        return None


@FUZZ
@given(st.sampled_from([gamow.sightings, gamow.disparity, gamow.stereo]), st.dictionaries(st.sampled_from(COLUMNS), VALUES))
def test_no_points_crash(call, changed):
    is_survived(call, **(GOOD | changed))
    is_survived(call, **changed)


@FUZZ
@given(st.dictionaries(st.sampled_from(["T", "d", "dphi", "dtheta", "sigma_dphi", "roll", "clock", "x"]), VALUES), st.dictionaries(
    st.sampled_from(["d", "use", "model", "seed", "x0", "fit_x0", "riding", "rho", "angle", "wheel_radius", "roll"]), VALUES))
def test_no_readings_crash(data, flags):
    is_survived(gamow.fit, data, **(flags | {"bootstrap": 0}))


@FUZZ
@given(VALUES, st.dictionaries(st.sampled_from(
    ["beta", "gamma", "time", "scene", "point", "gaze", "fov", "size", "layout", "state", "labels", "colour", "points"]), VALUES))
def test_no_state_crashes(source, changed):
    is_survived(gamow.State, source, **changed)
    is_survived(gamow.State, changed)
    state = is_survived(gamow.State, **changed)
    if state is not None:
        assert gamow.State(state.toml()) == state


@FUZZ
@given(st.dictionaries(st.sampled_from(["beta", "d", "y", "z", "x0", "from_", "to", "stereo", "model", "roll", "rho"]), VALUES))
def test_no_curve_crashes(flags):
    is_survived(gamow.curve, **(flags | {"samples": 3}))


OBJECTS = st.dictionaries(st.sampled_from(["name", "shape", "centre", "radius", "repeat", "step", "light", "hub"]), VALUES)


@FUZZ
@given(VALUES, st.dictionaries(st.sampled_from(["name", "object", "wheel", "group", "include", "street"]), VALUES | st.lists(OBJECTS, max_size=2)))
def test_no_scene_crashes(source, changed):
    is_survived(gamow.Scene, source)
    is_survived(gamow.Scene, {"name": "Ball"} | changed)
