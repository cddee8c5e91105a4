"""Quantities of astropy and pint: in, as plain numbers in one unit of length, and out again.

Neither package is imported: a Quantity is known by the module that made it, which is loaded then. c = 1, so that a time
is the length that light travels in it.
"""

import importlib
import sys

import numpy as np

SPEED_OF_LIGHT = 299_792_458.0  # m/s, by definition

#: The kind of each input.
KINDS = {
    **dict.fromkeys(["beta", "observer_beta"], "speed"),
    **dict.fromkeys(["gamma", "rapidity", "rho", "observer_gamma", "observer_rapidity"], "number"),
    **dict.fromkeys(["d", "y", "z", "x0", "wheel_radius", "observer_x", "observer_y", "observer_z"], "length"),
    **dict.fromkeys(["T", "clock", "from_", "to"], "time"),
    **dict.fromkeys(["roll", "turn", "angle", "observer_azimuth", "observer_elevation"], "angle"),
    **dict.fromkeys(["dphi", "dtheta", "sigma_dphi", "sigma_dtheta"], "angle"),
}
#: The inputs that are degrees; all other angles, and all results, are radians.
IN_DEGREES = {"roll", "turn", "observer_azimuth", "observer_elevation"}
#: The kind of a result, by its name without the eye.
RESULTS = {
    **dict.fromkeys(["x", "y", "z", "distance", "stereo_x", "stereo_y", "stereo_z", "stereo_miss"], "length"),
    **dict.fromkeys(["t", "tau"], "time"),
    **dict.fromkeys(["phi", "theta", "dphi", "dtheta"], "angle"),
}


class _Astropy:
    """The units of astropy."""

    is_held_by_xarray = False

    def __init__(self, quantity):
        units = sys.modules["astropy.units"]
        self.units = units
        self.metre, self.second, self.speed = units.m, units.s, units.m / units.s
        self.radian, self.degree, self.number = units.rad, units.deg, units.dimensionless_unscaled

    def is_of(self, quantity, unit):
        return quantity.unit.is_equivalent(unit)

    def unit(self, quantity):
        return quantity.unit

    def value(self, quantity, unit):
        value = quantity.to_value(unit)
        return np.ma.MaskedArray(value.unmasked, value.mask) if hasattr(value, "unmasked") else value

    def with_unit(self, values, unit):
        if isinstance(values, np.ma.MaskedArray):
            masked = importlib.import_module("astropy.utils.masked")
            return masked.Masked(self.units.Quantity(values.data, unit), mask=values.mask)
        return self.units.Quantity(values, unit)

    def ratio(self, unit, other):
        return unit.to(other)


class _Pint:
    """The units of pint, of the registry that made the quantity."""

    is_held_by_xarray = True

    def __init__(self, quantity):
        units = quantity._REGISTRY
        self.units = units
        self.metre, self.second, self.speed = units.metre, units.second, units.metre / units.second
        self.radian, self.degree, self.number = units.radian, units.degree, units.Unit("")

    def is_of(self, quantity, unit):
        # To pint an angle is a number, but its unit remembers.
        is_angle = "radian" in str(quantity.to_root_units().units)
        return quantity.is_compatible_with(unit) and (unit == self.radian) == is_angle

    def unit(self, quantity):
        return quantity.units

    def value(self, quantity, unit):
        return quantity.m_as(unit)

    def with_unit(self, values, unit):
        return self.units.Quantity(values, unit)

    def ratio(self, unit, other):
        return self.units.Quantity(1.0, unit).m_as(other)


def library_of(value):
    """The library of a Quantity; None for anything else."""
    astropy, pint = sys.modules.get("astropy.units"), sys.modules.get("pint")
    if astropy is not None and isinstance(value, astropy.Quantity):
        return _Astropy(value)
    if pint is not None and isinstance(value, pint.Quantity):
        return _Pint(value)
    return None


def refuse_unknown(name, value):
    """Refuses what has a unit that would be lost."""
    if library_of(value) is None and (hasattr(value, "unit") or hasattr(value, "units")):
        raise TypeError(f"{name}: units of {type(value).__module__} are not known: astropy's, pint's, or a number is needed")
    items = value if isinstance(value, (list, tuple)) else ()
    for item in items:
        if type(item) in (float, int):
            continue
        if library_of(item) is not None:
            raise TypeError(f"{name}: a list of Quantities: it must be one Quantity, or numbers")
        refuse_unknown(name, item)


def _is_zero(value):
    return isinstance(value, (int, float)) and value == 0


class Converter:
    """Takes the units from the inputs of a call, and gives them to its results."""

    def __init__(self, inputs):
        """Chooses the unit of length: that of the first length among `inputs`, a dict of values by name."""
        self.library = self.length = self.time = None
        self.is_any = False
        lengths = [(name, value) for name, value in inputs.items() if KINDS.get(name) in ("length", "time")]
        for name, value in inputs.items():
            self._meet(name, value)
        if self.length is None and self.time is not None:
            # Times alone: light-seconds and their like.
            self.length = self.library.metre
        if self.length is not None:
            self._refuse_plain(lengths)

    def _meet(self, name, value):
        library = library_of(value)
        if library is None:
            return refuse_unknown(name, value)
        if self.library is not None and type(self.library) is not type(library):
            raise TypeError(f"{name}: Quantities of astropy and of pint in one call cannot be compared")
        if self.library is not None and self.library.units is not library.units:
            raise TypeError(f"{name}: its unit is of another pint registry than those before it")
        if name not in KINDS:
            raise _wrong(name, library.unit(value))
        self.library, self.is_any = library, True
        if KINDS[name] in ("length", "time"):
            if library.is_of(value, library.metre):
                self.length = library.unit(value) if self.length is None else self.length
            elif library.is_of(value, library.second) and KINDS[name] == "time":
                self.time = library.unit(value) if self.time is None else self.time
            elif not library.is_of(value, library.number):
                raise _wrong(name, library.unit(value))
        return None

    def _refuse_plain(self, lengths):
        """Refuses numbers without a unit beside lengths with one; 0 is the same in each."""
        for name, value in lengths:
            library = library_of(value)
            if not _is_zero(value) and (library is None or library.is_of(value, library.number)):
                raise TypeError(f"{name}: a number without a unit, beside others in {self.length}: it needs one too")

    def plain(self, name, value):
        """The value as numbers: lengths and times in the chosen unit of length, angles as the input takes them."""
        library = library_of(value)
        if library is None:
            return value
        kind, unit = KINDS[name], library.unit(value)
        if library.is_of(value, library.number):
            return library.value(value, library.number)
        if kind in ("length", "time") and library.is_of(value, library.metre):
            return library.value(value, self.length)
        if kind == "time" and library.is_of(value, library.second):
            light = SPEED_OF_LIGHT * library.ratio(library.metre, self.length)
            return library.value(value, library.second) * light
        if kind == "angle" and library.is_of(value, library.radian):
            return library.value(value, library.degree if name in IN_DEGREES else library.radian)
        if kind == "speed" and library.is_of(value, library.speed):
            return library.value(value, library.speed) / SPEED_OF_LIGHT
        raise _wrong(name, unit)

    def with_unit(self, name, values):
        """The results of this name as a Quantity: angles if any input was one, lengths and times if those were."""
        kind = kind_of_result(name)
        if not self.is_any or values is None:
            return values
        library = self.library
        if kind == "angle":
            return library.with_unit(values, library.degree if name in IN_DEGREES else library.radian)
        if self.length is None or kind not in ("length", "time"):
            return values
        if kind == "time" and self.time is not None:
            seconds = values * (library.ratio(self.length, library.metre) / SPEED_OF_LIGHT)
            return library.with_unit(seconds * library.ratio(library.second, self.time), self.time)
        return library.with_unit(values, self.length)


def kind_of_result(name):
    """The kind of a column of results."""
    return RESULTS.get(name) or RESULTS.get(name.removesuffix("_left").removesuffix("_right")) or KINDS.get(name)


_NEEDED = {"length": "a length", "time": "a time or a length", "angle": "an angle", "speed": "a speed"}


def _wrong(name, unit, needed=None):
    needed = needed or _NEEDED.get(KINDS.get(name), "a number without a unit")
    return TypeError(f"{name}: a Quantity in {unit}: it must be {needed}")


#: The settings of a State that are angles, in degrees.
_ANGLES_OF_STATES = {"roll", "turn", "gaze", "fov", "ride_azimuth", "ride_elevation"}


def setting(name, value):
    """A Quantity as the number that a setting of a State, or a flag, takes."""
    library = library_of(value)
    if library is None:
        refuse_unknown(name, value)
    if name in _ANGLES_OF_STATES and library.is_of(value, library.radian):
        return library.value(value, library.degree)
    if name in ("beta", "ride_speed") and library.is_of(value, library.speed):
        return library.value(value, library.speed) / SPEED_OF_LIGHT
    if library.is_of(value, library.number):
        return library.value(value, library.number)
    raise _wrong(name, library.unit(value), "a number, in the unit of its scene or its readings")
