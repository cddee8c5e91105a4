"""Scenes against the command's list of bodies, and in pictures."""

import copy
import pickle

import gamow
import numpy as np
import pytest

BALL = {"name": "Ball", "object": [{"name": "ball", "shape": "sphere", "centre": (0, 3, 2), "radius": 0.5}]}
GROUPS = BALL | {"group": [{"name": "wall", "beta": 0, "object": [
    {"name": "brick", "shape": "box", "centre": [0, 9, 0], "size": (40, 1, 40)},
]}]}
SMALL = {"renderer": "reference", "samples": 1, "size": "64x48"}


@pytest.mark.parametrize("name", ["street", "cyclist", "lattice", "post-office"])
def test_objects_are_those_that_the_command_lists(gamow_command, name):
    listed = gamow_command("--list", "--scene", name).splitlines()
    assert sorted(set(gamow.Scene(name).objects)) == sorted(listed)


def test_numbers_in_pictures_are_those_of_the_scene(tmp_path):
    scene = gamow.Scene(GROUPS).save(tmp_path / "wall.toml")
    assert scene.name == "Ball" and scene.metres is None
    assert scene.groups == [("Ball", [0]), ("wall", [1])] and scene.objects == ["ball", "brick"]
    state = gamow.State(scene=scene, beta=0.5, time=0, gaze=(90, 0), **SMALL)
    channels = state.render(channels=True)
    assert set(np.unique(channels["left.id"])) <= {-1, 0, 1} and (channels["left.id"] == 1).any()
    assert (channels["left.group"] == channels["left.id"]).all()


def test_a_scene_is_shown_without_a_file(tmp_path):
    scene, others = gamow.Scene(GROUPS), {"beta": 0.5, "time": 0, "gaze": (90, 30), **SMALL}
    saved = gamow.State(scene=scene.save(tmp_path / "wall.toml"), **others)
    state = gamow.State(scene=scene, **others)
    assert (state.render() == saved.render()).all() and state.scene == scene and state != saved
    for other in (gamow.State(scene, **others), gamow.State({"scene": scene}, **others), state.replace(beta=0.6).replace(beta=0.5),
                  pickle.loads(pickle.dumps(state)), eval(repr(state), {"State": gamow.State, "Scene": gamow.Scene})):
        assert other == state and hash(other) == hash(state)
    assert state.replace(scene="street").scene == "street"
    times = [3.0, 3.5, 4.0]
    found = [gamow.measure(shown.replace(size="240x180"), times=times, object="ball") for shown in (state, saved)]
    assert all((found[0][name] == found[1][name]).all() for name in found[0])
    assert hash(scene) == hash(gamow.Scene(GROUPS))


def test_a_place_is_the_forward_most_point():
    scene = gamow.Scene(BALL)
    assert scene.place("ball") == scene.place(0) == scene.place() == [0.5, 3, 2]


def test_ways_to_give_a_scene_agree(tmp_path):
    text = 'name = "Ball"\n[[object]]\nname = "ball"\nshape = "sphere"\ncentre = [0, 3, 2]\nradius = 0.5\n'
    file = tmp_path / "ball.toml"
    file.write_text(text)
    saved = gamow.Scene(BALL).save(tmp_path / "saved.toml")
    scenes = [gamow.Scene(source) for source in (text, file, str(file), saved)]
    assert all(scene.objects == saved.objects and scene.place() == saved.place() for scene in scenes)
    pictures = [gamow.render(scene=scene, **SMALL) for scene in (file, saved)]
    pictures.append(gamow.render({"scene": saved}, **SMALL))
    assert all((picture == pictures[0]).all() for picture in pictures)
    assert gamow.Scene() == gamow.Scene("street") != gamow.Scene("cyclist")


def test_scenes_are_pickled_and_copied(tmp_path):
    for scene in (gamow.Scene("tram"), gamow.Scene(GROUPS), gamow.Scene(BALL).save(tmp_path / "ball.toml")):
        for other in (pickle.loads(pickle.dumps(scene)), copy.copy(scene), copy.deepcopy(scene)):
            assert other == scene and repr(other) == repr(scene)


@pytest.mark.parametrize("source, message", [
    ("no-such", "no-such"),
    (1.5, "a scene is a name, a path"),
    ({}, "name"),
    ({"name": "Ball", "object": [{"shape": "sphere", "centre": (0, 3, 2), "radius": -1}]}, "radius = -1"),
    ({"name": 1j}, "name: must be a number, a word or a list"),
    ({1: 2}, "keys of a dict must be text"),
    ("name = \n", "scene:1"),
])
def test_errors_are_one_line(source, message):
    with pytest.raises(ValueError, match=message) as error:
        gamow.Scene(source)
    assert "\n" not in str(error.value)


def test_nesting_ends():
    table = {}
    table["name"] = table
    with pytest.raises(ValueError, match="name: must be"):
        gamow.Scene(table)


def test_what_is_not_saved_is_no_file(tmp_path):
    with pytest.raises(ValueError, match="scene.save"):
        str(gamow.Scene(BALL).__fspath__())
    with pytest.raises(ValueError, match="in no file"):
        gamow.State(gamow.Scene(BALL)).toml()
    with pytest.raises(ValueError, match="already"):
        gamow.Scene("street").save(tmp_path / "street.toml")
    with pytest.raises(ValueError, match="no body called `wheel`"):
        gamow.Scene(BALL).place("wheel")
