"""Points: what both eyes see of them, in arrays."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._calls import computed
from ._keywords import checked

Model = Literal["exact", "one-cone", "published", "published-text"]
Exponent = float | Literal["surface", "photons", "paper"]


@checked
def sightings(
    *,
    beta: ArrayLike | None = None,
    gamma: ArrayLike | None = None,
    rapidity: ArrayLike | None = None,
    d: ArrayLike,
    y: ArrayLike,
    z: ArrayLike,
    T: ArrayLike,
    x0: ArrayLike | None = None,
    roll: ArrayLike | None = None,
    turn: ArrayLike | None = None,
    wheel_radius: ArrayLike | None = None,
    rho: ArrayLike | None = None,
    angle: ArrayLike | None = None,
    observer_beta: ArrayLike | None = None,
    observer_gamma: ArrayLike | None = None,
    observer_rapidity: ArrayLike | None = None,
    observer_azimuth: ArrayLike | None = None,
    observer_elevation: ArrayLike | None = None,
    observer_x: ArrayLike | None = None,
    observer_y: ArrayLike | None = None,
    observer_z: ArrayLike | None = None,
    model: Model = "exact",
    intensity_exponent: Exponent | None = None,
    conformal: bool = False,
    out: Mapping[str, np.ndarray] | None = None,
) -> dict[str, Any]:
    """What both eyes see of points: the columns of `gamow eval`, the same bit for bit.

    Arrays are broadcast together as NumPy does; the results have the common shape, and are scalars if all inputs are.
    Arrays of contiguous 64-bit floats are read where they are. The work is shared by all threads, without the
    interpreter's lock; Ctrl-C ends it.

    c = 1: lengths and times are numbers in one unit. Or they are Quantities of astropy or pint, all of them, in any units of
    length or time: they are converted to the unit of the first length, and the results are Quantities, lengths in that
    unit, times in that of the first time. Masked arrays, Series of pandas and DataArrays of xarray give such results.

    Args:
        beta, gamma, rapidity: speed of the points, given in one of three ways; beta from 0 to below 1 (or a Quantity of
            speed), gamma up to 1e30.
        d: separation of the eyes, 0 to 1e60, length.
        y, z: depth and height, length.
        T: observation time, when the light arrives, time.
        x0: the point's x at t = 0, length; 0 without it.
        roll, turn: tilt and turn of the head, degrees, -180 to 180.
        wheel_radius, rho, angle: a point on a rolling wheel, whose hub x0, y and z then are: the wheel's radius (length),
            the distance from the hub in radii (0 to 1), and the angle at t' = 0 from +x towards +z (radians). All or none.
        observer_beta, observer_gamma, observer_rapidity: speed of the observer, in one of three ways.
        observer_azimuth, observer_elevation: direction of that motion, degrees.
        observer_x, observer_y, observer_z: the middle between the eyes at T, length.
        model: how the two eyes' views are computed.
        intensity_exponent: N in intensity = doppler^N: 'surface' (4, the default), 'photons' (3), 'paper' (2) or a number.
        conformal: whether to add u_left, u_right, v_left and v_right, NaN where an eye sees the point along the baseline.
        out: arrays to fill in place of new ones, such as an earlier result; each contiguous, of 64-bit floats and of the
            common shape. For inputs that are plain numbers.

    Returns:
        x (apparent x from the eye, length), t (when the light left, time), doppler (received over rest frequency), intensity,
        phi, theta (radians) and tau (proper time of emission, time), each with `_left` and `_right`; dphi and dtheta, left
        minus right (radians). A wheel adds angle (radians); a moving observer adds y, z and distance (length).

    Raises:
        ValueError: a value out of range, with its index and its name; shapes that cannot be broadcast together; inputs that
            are missing or contradict each other; an array of `out` that is read-only or of another shape.
        TypeError: what is no array of real numbers; a unit of another kind, or none beside others; an unknown keyword.

    Source: E. A. Cryer-Jenkins, P. D. Stevenson, Proc. R. Soc. A 476 (2020), 10.1098/rspa.2019.0703, for the published
    models; the exact one solves each eye's light cone, and its error is at most 8 times what rounding the inputs permits.
    """
    return computed(_core.sightings, dict(locals()))


@checked
def disparity(
    *,
    beta: ArrayLike | None = None,
    gamma: ArrayLike | None = None,
    rapidity: ArrayLike | None = None,
    d: ArrayLike,
    y: ArrayLike,
    z: ArrayLike,
    T: ArrayLike,
    x0: ArrayLike | None = None,
    roll: ArrayLike | None = None,
    turn: ArrayLike | None = None,
    wheel_radius: ArrayLike | None = None,
    rho: ArrayLike | None = None,
    angle: ArrayLike | None = None,
    observer_beta: ArrayLike | None = None,
    observer_gamma: ArrayLike | None = None,
    observer_rapidity: ArrayLike | None = None,
    observer_azimuth: ArrayLike | None = None,
    observer_elevation: ArrayLike | None = None,
    observer_x: ArrayLike | None = None,
    observer_y: ArrayLike | None = None,
    observer_z: ArrayLike | None = None,
    model: Model = "exact",
    out: Mapping[str, np.ndarray] | None = None,
) -> dict[str, Any]:
    """The disparities dphi and dtheta of points, left minus right, radians.

    Arguments, shapes, units and errors are those of `sightings`. Where nothing but T is an array, the vectorised batch form
    of the core is used, which has the same bits.
    """
    return computed(_core.disparity, dict(locals()))


@checked
def stereo(
    *,
    beta: ArrayLike | None = None,
    gamma: ArrayLike | None = None,
    rapidity: ArrayLike | None = None,
    d: ArrayLike,
    y: ArrayLike,
    z: ArrayLike,
    T: ArrayLike,
    x0: ArrayLike | None = None,
    roll: ArrayLike | None = None,
    turn: ArrayLike | None = None,
    wheel_radius: ArrayLike | None = None,
    rho: ArrayLike | None = None,
    angle: ArrayLike | None = None,
    observer_beta: ArrayLike | None = None,
    observer_gamma: ArrayLike | None = None,
    observer_rapidity: ArrayLike | None = None,
    observer_azimuth: ArrayLike | None = None,
    observer_elevation: ArrayLike | None = None,
    observer_x: ArrayLike | None = None,
    observer_y: ArrayLike | None = None,
    observer_z: ArrayLike | None = None,
    model: Literal["exact", "one-cone"] = "exact",
    out: Mapping[str, np.ndarray] | None = None,
) -> dict[str, Any]:
    """Where two eyes take points to be: the columns that `gamow eval --stereo` adds.

    Arguments, shapes, units and errors are those of `sightings`; a published model has no such place, a ValueError.

    Returns:
        stereo_gain (1 for a point at rest), stereo_x, stereo_y, stereo_z (where the lines of sight meet, from the middle
        between the eyes, length). With roll, turn, a wheel or a moving observer also stereo_miss, by how much the lines pass
        each other (length). NaN where they do not meet in front of the eyes.
    """
    return computed(_core.stereo, dict(locals()))


@checked
def curve(
    *,
    beta: float | None = None,
    gamma: float | None = None,
    rapidity: float | None = None,
    d: Any = 0.1,
    y: Any = 3.0,
    z: Any = 2.0,
    x0: Any = 0.0,
    from_: Any = None,
    to: Any = None,
    samples: int = 201,
    roll: Any = None,
    turn: Any = None,
    wheel_radius: Any = None,
    rho: float | None = None,
    angle: Any = None,
    observer_beta: float | None = None,
    observer_gamma: float | None = None,
    observer_rapidity: float | None = None,
    observer_azimuth: Any = None,
    observer_elevation: Any = None,
    observer_x: Any = None,
    observer_y: Any = None,
    observer_z: Any = None,
    model: Model = "exact",
    intensity_exponent: Exponent | None = None,
    stereo: bool = False,
    conformal: bool = False,
) -> dict[str, Any]:
    """What both eyes see of one point over a range of observation times: the columns of `gamow curve`.

    Without arguments: the tracked point of the paper's cyclist, at 0.9 c.

    Args:
        from_, to: first and last observation time (of the observer's clock, if the observer moves); without them, when the
            point is seen at x = -2 R and +2 R, R being its distance at x = 0.
        samples: number of times, 2 to 10 million.
        stereo: whether to add what `gamow.stereo` returns.
        Others are one number each, with the meaning and the unit that they have in `sightings`.

    Returns:
        Arrays of shape (samples,): the inputs, and what `sightings` returns.

    Raises:
        ValueError, TypeError: as `sightings`.
    """
    return computed(_core.curve, dict(locals()))
