"""The stubs name what there is."""

import ast
import pathlib

import gamow
import pytest

STUBS = ast.parse((pathlib.Path(__file__).resolve().parents[1] / "python" / "gamow" / "__init__.pyi").read_text())
POINTS = ["sightings", "disparity", "stereo"]


def defined(kind):
    return {node.name: node for node in STUBS.body if isinstance(node, kind)}


def test_every_name_has_a_stub_and_a_docstring():
    functions, classes = defined(ast.FunctionDef), defined(ast.ClassDef)
    public = {name for name in gamow.__all__ if not name.startswith("_")}
    assert public == set(functions) | set(classes)
    for name, node in (functions | classes).items():
        assert ast.get_docstring(node) and getattr(gamow, name).__doc__, name
    for name, node in classes.items():
        methods = {node.name for node in node.body if isinstance(node, ast.FunctionDef)}
        assert {method for method in vars(getattr(gamow, name)) if not method.startswith("__")} <= methods


@pytest.mark.parametrize("name", POINTS)
def test_every_keyword_of_the_stubs_is_one(name):
    keywords = [argument.arg for argument in defined(ast.FunctionDef)[name].args.kwonlyargs]
    assert len(keywords) > 20
    given = {keyword: None for keyword in keywords if keyword != "model" and keyword != "conformal"}
    # None stands for a column that is not there: all that is missing is what is needed.
    with pytest.raises(ValueError, match="there is no header"):
        getattr(gamow, name)(**given)
