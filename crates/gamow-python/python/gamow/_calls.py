"""Calls of the compiled functions with values of any kind: units, masks and labels off, and on again."""

import numpy as np

from . import _core
from ._containers import Arrays
from ._units import Converter

#: The keywords that are no inputs of a point.
_OPTIONS = {"model", "intensity_exponent", "conformal", "stereo", "out", "samples"}
#: The inputs without which there is no point, and those of which one gives its speed.
_NEEDED, _SPEEDS = ("d", "y", "z", "T"), ("beta", "gamma", "rapidity")
#: The types that the compiled functions take as they are.
_PLAIN = {float, int, bool, np.ndarray, np.float64, type(None)}


def computed(function, keywords):
    """What `function` computes for `keywords`, those that are None left out, in the containers and units of the inputs."""
    inputs = {name: value for name, value in keywords.items() if name not in _OPTIONS and value is not None}
    options = {name: keywords[name] for name in keywords.keys() & _OPTIONS if keywords[name] is not None}
    if function is not _core.curve:
        _check_needed(inputs)
    if all(type(value) in _PLAIN for value in inputs.values()):
        return function(**inputs, **options)
    arrays = Arrays(inputs)
    units = Converter(arrays.plain)
    plain = {name: units.plain(name, value) for name, value in arrays.plain.items()}
    plain = arrays.take_masks(plain)
    if "out" in options and (units.is_any or arrays.is_any):
        raise TypeError("out: only results of plain numbers can be written into given arrays")
    arrays.check_units(units)
    results = function(**plain, **options)
    return {name: arrays.wrapped(name, units.with_unit(name, arrays.masked(values))) for name, values in results.items()}


def _check_needed(inputs):
    """Refuses inputs that describe no point."""
    missing = [name for name in _NEEDED if name not in inputs]
    if inputs.keys().isdisjoint(_SPEEDS):
        missing.append("one of beta, gamma, rapidity")
    if missing:
        raise TypeError(f"missing: {', '.join(missing)}")
