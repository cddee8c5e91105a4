"""Fits: speed and distance of a point from the disparities that two eyes measured."""

from __future__ import annotations

import os
import warnings
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

from . import _core
from ._containers import Arrays
from ._keywords import checked
from ._points import Model
from ._remarks import GamowWarning
from ._units import Converter

#: The columns of readings.
COLUMNS = ("T", "clock", "dphi", "dtheta", "sigma_dphi", "sigma_dtheta", "d", "roll", "turn")
#: The inputs beside the columns that may have units.
_WITH_UNITS = ("d", "x0", "roll", "turn", "wheel_radius", "rho", "angle")
#: The columns in which a value may be missing.
_MAY_BE_MISSING = ("dphi", "dtheta", "sigma_dphi", "sigma_dtheta")


@dataclass(frozen=True)
class Estimate:
    """A fitted value and its uncertainty, which is None where the residuals are no chance."""

    value: Any
    """Best value: a number, or a Quantity where the readings had units."""
    uncertainty: Any | None
    """Standard error, by the bootstrap if there was one."""
    interval: tuple[Any, Any] | None
    """Interval that holds 95 %."""
    uncertainty_linear: Any | None
    """Standard error from the covariance at the best fit."""


@dataclass(frozen=True)
class FitResult:
    """What `fit` found."""

    beta: Estimate
    """Speed over c."""
    y: Estimate
    """Depth."""
    z: Estimate
    """Height."""
    x0: Estimate | None
    """The point's x at t = 0, if it was fitted."""
    parameters: tuple[str, ...]
    """Names of the parameters, in the order of the covariance."""
    covariance: np.ndarray | None = field(compare=False)
    """Covariance of the parameters, as numbers: of the replicates, or at the best fit without any. None where the residuals
    are no chance."""
    residuals: dict[str, np.ndarray] = field(compare=False, repr=False)
    """Readings minus fit, radians, by curve: 'dphi' and 'dtheta'. One for each reading of the data in their order, NaN where
    there was none."""
    rms: float
    """Root mean square of the residuals, radians."""
    reduced_chi_squared: float | None
    """Chi squared per degree of freedom, if the readings had sigmas."""
    readings: int
    """Number of readings fitted."""
    remarks: tuple[str, ...]
    """What the fit has to say of the readings; each is a `GamowWarning`, too."""
    report: dict[str, Any] = field(repr=False)
    """All of it as `gamow fit --json` writes it."""


@checked
def fit(
    data: str | os.PathLike[str] | Mapping[str, Any],
    /,
    *,
    d: Any = None,
    roll: Any = None,
    turn: Any = None,
    model: Model = "exact",
    use: Literal["dphi", "dtheta", "both"] | None = None,
    bootstrap: int | None = None,
    seed: int | None = None,
    x0: Any = None,
    fit_x0: bool = False,
    loss: Literal["linear", "soft-l1", "huber", "cauchy"] = "linear",
    loss_scale: float | None = None,
    riding: bool = False,
    wheel_radius: Any = None,
    rho: Any = None,
    angle: Any = None,
    angle_unit: str | None = None,
    time_unit: str | None = None,
    negate: Literal["dphi", "dtheta", "both"] | None = None,
    shift_dtheta: float | None = None,
) -> FitResult:
    """Speed and distance of a point from the disparities that two eyes measured, as `gamow fit` finds them.

    Args:
        data: path of a CSV file, or arrays by column, such as a dict, a result of `curve` or `measure`, or a pandas DataFrame:
            T (time); dphi, dtheta or both (radians; NaN or masked where there is no reading); optionally sigma_dphi,
            sigma_dtheta (radians), d (length), roll, turn (degrees). Arrays are broadcast together. Quantities of astropy or
            pint are converted as in `sightings`.
        d: separation of the eyes, length, in place of the column.
        roll, turn: tilt and turn of the head, degrees, in place of the columns.
        model: how the two eyes' views are computed.
        use: the curves that are fitted; without it, those that there are.
        bootstrap: number of replicates, up to 10 million; 0 for none, 1000 without it.
        seed: seed of the replicates; 1 without it. The same seed gives the same numbers on any number of threads.
        x0: the point's x at t = 0, if it is known, length; 0 without it.
        fit_x0: whether to fit x0.
        loss: loss function, as in SciPy; a robust one counts large residuals less.
        loss_scale: residual from which on a robust loss does, in standard deviations.
        riding: whether the eyes rode past a point at rest; data then has clock in place of T.
        wheel_radius, rho, angle: place on a rolling wheel, as in `sightings`.
        angle_unit, time_unit: unit of a file's angles ('mrad', ...) and times ('ms', ...) where it does not say.
        negate: curves whose readings have the other sign.
        shift_dtheta: time to add to those of dtheta.

    Remarks on the readings are warnings of the kind `GamowWarning`.

    Raises:
        ValueError: what the data cannot tell, or where they are wrong; `data: [2]` is the third row, a file's line has its number.
        TypeError: what is no array of real numbers; a unit of another kind, or none beside others; an unknown keyword.
        KeyboardInterrupt: Ctrl-C, within tenths of a second.
    """
    flags = {name: value for name, value in locals().items() if name != "data" and value is not None}
    columns, flags, units = _readings(data, flags)
    shape = None if columns is None else np.broadcast_shapes(*(np.shape(column) for column in columns.values()))
    report, rows, residuals = _core.fit(data if columns is None else columns, **flags)
    result = _result(report, _in_rows(rows, residuals, shape), units)
    for remark in result.remarks:
        warnings.warn(remark, GamowWarning, stacklevel=3)
    return result


def _readings(data, flags):
    """The columns of `data` as plain arrays, None of a file; the flags without units; and the converter of the results."""
    inputs = {name: flags[name] for name in _WITH_UNITS if name in flags}
    if isinstance(data, (str, os.PathLike)):
        units = Converter(inputs)
        if units.is_any:
            raise TypeError("units beside a file, whose numbers have none: give its columns as Quantities")
        return None, flags, units
    if not (hasattr(data, "keys") and hasattr(data, "__getitem__")):
        raise TypeError("data: must be the path of a CSV file, or arrays by column, as in a dict or a DataFrame")
    columns = {name: data[name] for name in data.keys() if name in COLUMNS and data[name] is not None}
    arrays = Arrays(columns)
    units = Converter(arrays.plain | inputs)
    columns = {name: _without_mask(name, units.plain(name, value)) for name, value in arrays.plain.items()}
    return columns, flags | {name: units.plain(name, value) for name, value in inputs.items()}, units


def _without_mask(name, values):
    """The values with NaN where they are masked."""
    if not np.ma.is_masked(values):
        return np.ma.getdata(values) if isinstance(values, np.ma.MaskedArray) else values
    if name not in _MAY_BE_MISSING:
        raise ValueError(f"data: {name} is masked in places: only dphi, dtheta and their sigmas may be missing")
    return values.astype(float).filled(np.nan)


def _in_rows(rows, residuals, shape):
    """The residuals of each curve in arrays of `shape`, NaN where there is no reading."""
    if shape is None:
        return residuals
    placed = {}
    for name, values in residuals.items():
        whole = np.full(int(np.prod(shape)), np.nan)
        whole[rows] = values
        placed[name] = whole.reshape(shape)
    return placed


def _result(report, residuals, units):
    def estimate(name, found):
        with_unit = lambda value: units.with_unit(name, value)
        interval = found["ci95"]
        return Estimate(
            value=with_unit(found["value"]),
            uncertainty=with_unit(found["uncertainty"]),
            interval=None if interval is None else (with_unit(interval[0]), with_unit(interval[1])),
            uncertainty_linear=with_unit(found["uncertainty_linear"]),
        )

    found = report["parameters"]
    estimates = {name: estimate(name, value) for name, value in found.items()}
    scatter = np.array([value["scatter"] for value in found.values()])
    is_stated = all(value["ci95"] is not None for value in found.values())
    return FitResult(
        **{name: estimates.get(name) for name in ("beta", "y", "z", "x0")},
        parameters=tuple(found),
        covariance=np.array(report["correlations"], float) * np.outer(scatter, scatter) if is_stated else None,
        residuals=residuals,
        rms=report["rms"],
        reduced_chi_squared=report.get("reduced_chi_squared"),
        readings=report["readings"],
        remarks=tuple(_remarks(report)),
        report=report,
    )


def _remarks(report):
    """The remarks of a report, a line each."""
    for key in ("data", "warning", "cause", "sigmas", "other_side"):
        if key in report:
            yield report[key]
    outliers = sorted(report.get("outliers", ()), key=lambda outlier: -abs(outlier["deviation"]))
    if outliers:
        curve, time, deviation = ("dphi", "dtheta")[outliers[0]["curve"]], outliers[0]["time"], outliers[0]["deviation"]
        others = f"; so do {len(outliers) - 1} others, see report['outliers']" if len(outliers) > 1 else ""
        yield f"{curve} at T = {time:g} stands out: {deviation:+.1f} standard deviations off the fit{others}"
