"""Pictures and measurements against the commands."""

import pickle
import struct
import zlib

import gamow
import numpy as np
import pytest

SMALL = {"renderer": "reference", "samples": 1, "size": "96x72"}


def words(flags):
    return [word for name, value in flags.items() for word in (f"--{name.replace('_', '-')}", str(value))]


def pixels(data):
    """The pixels of a PNG file of 8-bit RGB."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    place, body = 8, b""
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        chunk = data[place + 8:place + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", chunk[:10])
            assert (depth, colour) == (8, 2)
        elif kind == b"IDAT":
            body += chunk
        place += 12 + length
    rows = np.frombuffer(zlib.decompress(body), np.uint8).reshape(height, 1 + 3 * width)
    picture = np.zeros((height, width, 3), np.uint8)
    above = np.zeros((width, 3), np.uint8)
    for y, row in enumerate(rows):
        line = unfiltered(row[0], row[1:].reshape(width, 3), above)
        picture[y] = above = line
    return picture


def unfiltered(kind, line, above):
    """A row of a PNG file without its filter (PNG specification, 9.2)."""
    if kind == 0:
        return line
    if kind == 2:
        return line + above
    if kind == 1:
        return np.cumsum(line, axis=0, dtype=np.uint8)
    out = np.zeros_like(line)
    left, corner = np.zeros(3, int), np.zeros(3, int)
    for x in range(len(line)):
        up = above[x].astype(int)
        if kind == 3:
            guess = (left + up) // 2
        else:
            distances = np.abs([up - corner, left - corner, left + up - 2 * corner])
            guess = np.choose(np.argmin(distances, axis=0), [left, up, corner])
        out[x] = (line[x] + guess) % 256
        left, corner = out[x].astype(int), up
    return out


@pytest.mark.parametrize("state, flags", [
    (None, {}),
    ("abreast", {"beta": 0.6}),
    ("street", {"layout": "anaglyph", "time": 2}),
    ("rolling-wheel", {"layout": "over-under", "labels": "off"}),
])
def test_a_picture_has_the_pixels_of_the_command(gamow_command, tmp_path, state, flags):
    flags = SMALL | flags
    file = tmp_path / "picture.png"
    gamow_command("render", "--out", file, *(["--state", state] if state else []), *words(flags))
    theirs = pixels(file.read_bytes())
    ours = gamow.render(state, **flags)
    assert ours.dtype == np.uint8 and ours.shape == theirs.shape and (ours == theirs).all()
    assert (pixels(gamow.State(state, **flags)._repr_png_()) == theirs).all()
    # What the command wrote is a state, too.
    assert (gamow.render(file) == theirs).all()


def test_ways_to_give_a_state_agree(tmp_path):
    text = 'scene = "cyclist"\ntime = 3.0\n[motion]\nbeta = 0.6\n[look]\ngaze = [80, 0]\n'
    file = tmp_path / "state.toml"
    file.write_text(text)
    table = {"scene": "cyclist", "time": 3.0, "motion": {"beta": 0.6}, "look": {"gaze": [80, 0]}}
    link = "gamow:?scene=cyclist&time=3&beta=0.6&gaze=80,0"
    state = gamow.State(text)
    for other in (file, str(file), table, link, state, state.toml(), state.link()):
        assert gamow.State(other) == state, other
    assert gamow.State(scene="cyclist", time=3, beta=0.6, gaze=(80, 0)) == state
    assert state.replace(beta=0.7) != state and state.replace(beta=0.7).replace(beta=0.6) == state
    assert eval(repr(state), {"State": gamow.State}) == state
    assert pickle.loads(pickle.dumps(state)) == state


def test_channels_are_measured(gamow_command, tmp_path):
    channels = gamow.render("abreast", channels=True, **SMALL)
    assert len(channels) == 32 and {array.shape for array in channels.values()} == {(72, 96)}
    assert {array.dtype for array in channels.values()} == {np.dtype(np.float32)}
    seen = channels["left.id"] >= 0
    assert seen.any() and (channels["left.distance"][seen] > 0).all()
    # Light left as long ago as it is far: T - t = distance.
    emitted = channels["left.emission_time"][seen] + channels["left.distance"][seen]
    assert np.ptp(emitted) < 1e-4


def test_a_state_is_measured_like_files(gamow_command, tmp_path):
    flags = SMALL | {"size": "240x180", "scene": "cyclist"}
    gamow_command("render", "--frames", 3, "--from", 1, "--to", 5, "--exr", "--out", tmp_path / "ride", *words(flags))
    from_files = gamow.measure(tmp_path / "ride", object="front tyre")
    from_state = gamow.measure(gamow.State(**flags), times=[1, 3, 5], object="front tyre")
    assert list(from_files) == list(from_state) and from_files["T"].tolist() == [1, 3, 5]
    for name, values in from_files.items():
        assert (values == from_state[name]).all(), name
    text = gamow_command("measure", tmp_path / "ride", "--object", "front tyre")
    assert text.splitlines()[0] == ",".join(from_files)
    assert [float(field) for field in text.splitlines()[1].split(",")] == [values[0] for values in from_files.values()]


def test_a_state_is_read():
    state = gamow.State("street", beta=0.6, size=(96, 72), gaze=(80, 0))
    assert (state.beta, state["beta"], state.size, state.gaze, state.scene) == (0.6, 0.6, "96x72", (80.0, 0.0), "street")
    assert gamow.State("street", size="96x72").size == "96x72"
    assert "observer" not in dict(state) and {"beta", "roll", "time", "size", "renderer"} <= dict(state).keys() <= set(dir(state))
    with pytest.raises(AttributeError, match="no setting `betta`"):
        state.betta
    with pytest.raises(KeyError, match="betta"):
        state["betta"]


@pytest.mark.parametrize("name", gamow.presets())
def test_a_preset_is_what_its_settings_make(name):
    state = gamow.State(name)
    assert gamow.State(**dict(state)) == state == gamow.State(state.toml())


def test_states_are_compared_and_hashed():
    a, b, c = gamow.State(beta=0.6), gamow.State(gamow.State(beta=0.5), beta=0.6), gamow.State(beta=0.7)
    assert a == b != c and hash(a) == hash(b) and {a: 1, c: 2}[b] == 1
    assert gamow.State(gaze=(0.0, 0.0)) == gamow.State(gaze=(-0.0, 0.0)) and len({gamow.State(gaze=(z, 0)) for z in (0.0, -0.0)}) == 1


def test_remarks_are_warnings(capfd):
    # Half the sky is drawn by the reference, which is said where the choice is automatic.
    with pytest.warns(gamow.GamowWarning, match="drawing with the reference renderer"):
        gamow.render("street", projection="vr180", size=(16, 16))
    assert capfd.readouterr().err == ""


def test_presets_and_scenes_have_titles(gamow_command):
    assert "street" in gamow.presets() and all(gamow.presets().values())
    assert next(iter(gamow.scenes())) == "street" and gamow.scenes()["tram"] == gamow.Scene("tram").name
