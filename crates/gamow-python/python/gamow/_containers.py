"""Masked arrays, Series of pandas and DataArrays of xarray: in, as plain arrays, and out again with mask, index and dims.

Neither package is imported: what they made is known by the module that made it, which is loaded then.
"""

import sys

import numpy as np

#: Stands in for masked values of a column that has no others.
_STAND_INS = {"y": 1.0, "gamma": 1.0, "observer_gamma": 1.0, "wheel_radius": 1.0}
#: The text of a unit that says nothing.
_NO_UNITS = {"", "1", "dimensionless", "rad", "radian", "radians"}


def _class(module, name):
    return getattr(sys.modules.get(module), name, ())


class Arrays:
    """Takes the containers from the inputs of a call, and puts its results into such ones."""

    def __init__(self, inputs):
        """Finds the container of `inputs`, a dict of values by name, in which `plain` has arrays then."""
        self.plain, self._wrap = dict(inputs), None
        self._mask, self._holds_units = False, False
        for name, value in inputs.items():
            if isinstance(value, (_class("pandas", "DataFrame"), _class("xarray", "Dataset"))):
                raise TypeError(f"{name}: a table: give one of its columns")
        series = {name: value for name, value in inputs.items() if isinstance(value, _class("pandas", "Series"))}
        labelled = {name: value for name, value in inputs.items() if isinstance(value, _class("xarray", "DataArray"))}
        if series and labelled:
            raise TypeError(f"{next(iter(labelled))}: a DataArray beside a Series: both must be of one kind")
        if series:
            self._take_series(series)
        if labelled:
            self._take_labelled(labelled)

    def _take_series(self, series):
        (first, one), *others = series.items()
        for name, other in others:
            if not other.index.equals(one.index):
                raise ValueError(f"{name} has another index than {first}: align them first, as by pandas.concat")
        for name, value in self.plain.items():
            if name not in series and np.ndim(value) > 1:
                raise TypeError(f"{name}: an array of {np.ndim(value)} dimensions beside a Series")
        self.plain |= {name: _values_of_series(name, value) for name, value in series.items()}
        pandas = sys.modules["pandas"]
        self._wrap = lambda name, values: pandas.Series(np.asarray(values), index=one.index, name=name)

    def _take_labelled(self, labelled):
        xarray = sys.modules["xarray"]
        for name, value in self.plain.items():
            if name in labelled:
                unit = str(value.attrs.get("units", ""))
                if unit not in _NO_UNITS:
                    raise TypeError(f"{name}: attrs['units'] = {unit!r} is not read: give a Quantity, or drop it")
            elif np.ndim(value) > 0:
                raise TypeError(f"{name}: an array without names of dimensions beside a DataArray")
        try:
            aligned = xarray.align(*labelled.values(), join="exact", copy=False)
        except ValueError as error:
            names = ", ".join(labelled)
            raise ValueError(f"{names}: the coordinates differ: align them first, as by xarray.align") from error
        together = dict(zip(labelled, xarray.broadcast(*aligned)))
        self.plain |= {name: value.data for name, value in together.items()}
        self._holds_units = True
        template = next(iter(together.values()))
        self._wrap = lambda name, values: xarray.DataArray(values, coords=template.coords, dims=template.dims, name=name)

    def take_masks(self, plain):
        """The arrays of numbers `plain` without their masks, under which a valid number stands in."""
        masked = {name: value for name, value in plain.items() if isinstance(value, np.ma.MaskedArray)}
        if not masked:
            return plain
        self._mask = np.ma.nomask
        for name, value in masked.items():
            mask = np.ma.getmaskarray(value)
            try:
                self._mask = mask if self._mask is np.ma.nomask else np.logical_or(self._mask, mask)
            except ValueError as error:
                raise ValueError(f"{name} has the shape {list(mask.shape)}, which cannot be broadcast to the others'") from error
        return plain | {name: _filled(name, value) for name, value in masked.items()}

    @property
    def is_any(self):
        """Whether there is any container."""
        return self._wrap is not None or self._mask is not False

    def check_units(self, units):
        """Refuses containers in which the lengths and times of `units` would be lost."""
        if units.length is not None and not (self._wrap is None or self._holds_units and units.library.is_held_by_xarray):
            raise TypeError("lengths with units cannot be returned in such a container: give numbers in one unit")

    def masked(self, values):
        """Values with the mask of the inputs."""
        if self._mask is False:
            return values
        values = np.asarray(values)
        return np.ma.MaskedArray(values, np.broadcast_to(self._mask, values.shape).copy())

    def wrapped(self, name, values):
        """Values as a Series or a DataArray like the inputs."""
        return values if self._wrap is None else self._wrap(name, values)


def _values_of_series(name, series):
    """The numbers of a Series; NaN where it has none."""
    try:
        return series.to_numpy(dtype=float, na_value=np.nan)
    except (TypeError, ValueError) as error:
        raise TypeError(f"{name}: a Series of {series.dtype}: numbers are needed") from error


def _filled(name, value):
    mask, data = np.ma.getmaskarray(value), np.array(np.ma.getdata(value), float)
    valid = data[~mask & np.isfinite(data)]
    data[mask] = valid[0] if valid.size else _STAND_INS.get(name, 0.0)
    return data
