"""Pictures, and angles measured in them."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from . import _core
from ._core import Scene, State
from ._keywords import checked
from ._remarks import GamowWarning


def render(
    state: State | Scene | str | os.PathLike[str] | Mapping[str, Any] | None = None,
    /,
    *,
    channels: bool = False,
    **settings: Any,
) -> Any:
    """The picture of a state, as `gamow render` draws it, or what its pixels show.

    Args:
        state, **settings: as of `State`.
        channels: whether to return measurements in place of the picture.

    Returns:
        An array of shape (height, width, 3), 8-bit sRGB, the pixels of the command's PNG file; (count, height, width, 3) where
        pictures alternate. With channels a dict of arrays of shape (height, width), 32-bit floats, by the names of the EXR
        channels: left.id, left.distance, left.emission_time, left.proper_time, left.doppler, left.wavelength_nm and so on.

    The interpreter's lock is released; Ctrl-C ends it. renderer='reference' draws the same on every machine.

    Raises:
        ValueError: a setting that is out of range, or a renderer that this machine does not have.
        TypeError: a setting that does not exist.
    """
    return State(state, **settings).render(channels=channels)


@checked
def measure(
    source: State | str | os.PathLike[str] | Sequence[str | os.PathLike[str]],
    /,
    *,
    point: Sequence[float] | None = None,
    object: str | int | None = None,
    marker: str | None = None,
    times: Iterable[float] | None = None,
    d: float | None = None,
    fov: float | None = None,
    gaze: Any = None,
    projection: str | None = None,
    layout: str | None = None,
    roll: float | None = None,
    turn: float | None = None,
) -> dict[str, Any]:
    """Angles of a point in pictures, as `gamow measure` finds them, ready for `fit`.

    Args:
        source: files by `gamow render` (.exr; .png for a marker), folders of these, or a list; or a State, drawn at each of
            `times`.
        point: the mark on a body's surface at these rest-frame coordinates (x, y, z), length.
        object: the middle of the body of this name or number.
        marker: the middle of all pixels of this colour, 'ff0000'. One of these three is needed.
        times: observation times: of a State, or of photographs, one for each or the first and the last.
        d: separation of the eyes of photographs, length.
        fov, gaze, roll, turn: how photographs were taken, degrees.
        projection, layout: likewise, as in `State`.

    Returns:
        Arrays of shape (pictures,) by column: T, d, phi_left, phi_right, theta_left, theta_right, dphi, dtheta, sigma_dphi and
        sigma_dtheta, radians; roll and turn, degrees, of a head that is tilted or turned.

    Remarks on what was found are warnings of the kind `GamowWarning`. Ctrl-C ends it, and leaves no files.

    Raises:
        ValueError: files that do not say enough, or a target that none of them shows.
        TypeError: a source of another kind, or an unknown keyword.
    """
    flags = {name: value for name, value in locals().items() if name != "source" and value is not None}
    if "times" in flags:
        flags["times"] = [float(time) for time in flags["times"]]
    columns, remarks = _core.measure(source, **flags)
    for remark in remarks:
        warnings.warn(remark, GamowWarning, stacklevel=3)
    return columns
