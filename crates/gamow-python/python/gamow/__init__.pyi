"""What two eyes see of bodies that move at nearly the speed of light: numbers in NumPy arrays, and pictures.

c = 1; lengths and times share one unit. x points along the motion, y forward, z up; the eyes rest at x = -d/2 (left) and
x = +d/2 (right) unless they move. Angles are radians in `sightings`, `disparity` and `stereo`, whose keywords are columns of
`gamow eval`, and degrees where keywords are flags of a command (`roll`, `turn`, `gaze`, ...). What a command refuses is a
`ValueError` with its line; an argument of another type is a `TypeError`.
"""

from collections.abc import Mapping, Sequence
from os import PathLike
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str

_Model = Literal["exact", "one-cone", "published", "published-text"]
_Exponent = float | Literal["surface", "photons", "paper"]
_Path = str | PathLike[str]
_Floats = dict[str, NDArray[np.float64]]

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
    model: _Model = "exact",
    intensity_exponent: _Exponent | None = None,
    conformal: bool = False,
    out: _Floats | None = None,
) -> _Floats:
    """What both eyes see of points: the columns of `gamow eval`, the same bit for bit.

    Arrays are broadcast together as NumPy does; the results have the common shape, and are scalars if all inputs are. Arrays of
    contiguous 64-bit floats are read where they are. The work is shared by all threads, without the interpreter's lock.

    Args:
        beta, gamma, rapidity: speed of the points, given in one of three ways; beta from 0 to below 1, gamma up to 1e30.
        d: separation of the eyes, 0 to 1e60.
        y, z: depth and height.
        T: observation time, when the light arrives.
        x0: the point's x at t = 0; 0 without it.
        roll, turn: tilt and turn of the head, radians, -pi to pi.
        wheel_radius, rho, angle: a point on a rolling wheel, whose hub x0, y and z then are: the wheel's radius, the distance
            from the hub in radii (0 to 1), and the angle at t' = 0 from +x towards +z, radians. All three or none.
        observer_beta, observer_gamma, observer_rapidity: speed of the observer, in one of three ways.
        observer_azimuth, observer_elevation: direction of that motion, radians.
        observer_x, observer_y, observer_z: the middle between the eyes at T.
        model: how the two eyes' views are computed.
        intensity_exponent: N in intensity = doppler^N: 'surface' (4, the default), 'photons' (3), 'paper' (2) or a number.
        conformal: whether to add u_left, u_right, v_left and v_right, NaN where an eye sees the point along the baseline.
        out: arrays to fill in place of new ones, such as an earlier result; each contiguous, of 64-bit floats and of the common
            shape.

    Returns:
        x (apparent x from the eye), t (when the light left), doppler (received over rest frequency), intensity, phi, theta
        (radians) and tau (proper time of emission), each with `_left` and `_right`; dphi and dtheta, left minus right. A wheel adds
        angle; a moving observer adds y, z and distance.

    Raises:
        ValueError: a value out of range, with its index and its column; shapes that cannot be broadcast together; columns that
            are missing or contradict each other; an array of `out` that is read-only or of another shape.
        TypeError: what is no array of real numbers; an unknown keyword.

    Source: E. A. Cryer-Jenkins, P. D. Stevenson, Proc. R. Soc. A 476 (2020), 10.1098/rspa.2019.0703, for the published
    models; the exact one solves each eye's light cone, and its error is at most 8 times what rounding the inputs permits.
    """

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
    model: _Model = "exact",
    out: _Floats | None = None,
) -> _Floats:
    """The disparities dphi and dtheta of points, left minus right, radians.

    Arguments, shapes and errors are those of `sightings`. Where nothing but T is an array, the vectorised batch form of the core
    is used, which has the same bits.
    """

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
    out: _Floats | None = None,
) -> _Floats:
    """Where two eyes take points to be: the columns that `gamow eval --stereo` adds.

    Arguments, shapes and errors are those of `sightings`; a published model has no such place, a ValueError.

    Returns:
        stereo_gain (1 for a point at rest), stereo_x, stereo_y, stereo_z (where the lines of sight meet, from the middle between
        the eyes). With roll, turn, a wheel or a moving observer also stereo_miss, by how much the lines pass each other. NaN where
        they do not meet in front of the eyes.
    """

def curve(**flags: Any) -> _Floats:
    """What both eyes see of one point over a range of observation times: the columns of `gamow curve`.

    The keywords are the command's flags, `from_` for --from: beta (or gamma, rapidity), d, y, z, x0, from_, to, samples (at most
    10 million), roll and turn (degrees), wheel_radius, rho, angle (radians), observer_beta and others, model, intensity_exponent,
    stereo, conformal. Without any: the tracked point of the paper's cyclist.

    Returns arrays of shape (samples,): the inputs, and what `sightings` returns. Raises ValueError as the command ends.
    """

def fit(data: _Path | Mapping[str, ArrayLike], /, **flags: Any) -> dict[str, Any]:
    """Speed and distance of a point from the disparities that two eyes measured: what `gamow fit --json` writes.

    Args:
        data: path of a CSV file, or arrays by column, such as a dict, a result of `curve` or `measure`, or a pandas DataFrame: T;
            dphi, dtheta or both (radians, NaN where there is no reading); optionally sigma_dphi, sigma_dtheta, d, roll, turn. Arrays are
            broadcast together; errors count their rows as lines of a CSV file, whose first has the names.
        **flags: the command's: d, roll and turn (degrees), model, use ('dphi', 'dtheta' or 'both'), bootstrap (replicates,
            0 for none), seed, x0, fit_x0, loss ('linear', 'soft-l1', 'huber' or 'cauchy'), loss_scale, riding, wheel_radius, rho, angle.

    Returns:
        The report: parameters (each with value, uncertainty, ci95 and uncertainty_linear, None where the residuals
        are no chance, and the replicates' scatter), residuals, warning, correlations, rms (radians),
        reduced_chi_squared, readings, bootstrap, fits and more, the same for the same seed on any number of threads.

    Raises:
        ValueError: what the data cannot tell, or where they are wrong.
        KeyboardInterrupt: Ctrl-C, within tenths of a second.
    """

def render(state: State | _Path | Mapping[str, Any] | None = None, /, *, channels: bool = False, **settings: Any) -> Any:
    """The picture of a state, as `gamow render` draws it, or what its pixels show.

    Args:
        state, **settings: as of `State`.
        channels: whether to return measurements in place of the picture.

    Returns:
        An array of shape (height, width, 3), 8-bit sRGB, the pixels of the command's PNG file; (count, height, width, 3) where
        pictures alternate. With channels a dict of arrays of shape (height, width), 32-bit floats, by the names of the EXR
        channels: left.id, left.distance, left.emission_time, left.proper_time, left.doppler, left.wavelength_nm and so on.

    Raises:
        ValueError: a setting that does not exist or is out of range, or a renderer that this machine does not have.
    """

def measure(source: State | _Path | Sequence[_Path], /, **flags: Any) -> _Floats:
    """Angles of a point in pictures, as `gamow measure` finds them, ready for `fit`.

    Args:
        source: files by `gamow render` (.exr; .png for a marker), folders of these, or a list; or a State, drawn at each of `times`.
        **flags: the command's: one of point=(x, y, z), object=name and marker='ff0000'; of photographs also times, d, fov, gaze,
            projection, layout, roll and turn.

    Returns:
        Arrays of shape (pictures,) by column: T, d, phi_left, phi_right, theta_left, theta_right, dphi, dtheta, sigma_dphi and
        sigma_dtheta, radians. The command's remarks are warnings.

    Raises:
        ValueError: files that do not say enough, or a target that none of them shows.
    """

class State:
    """The state of the program: everything that decides what a picture shows. A notebook shows its picture.

    Args:
        source: name of a preset; path of a state file (.toml), or of a picture (.png) or measurements (.exr) by `gamow render`; a link
            (gamow:?...); TOML text; a dict of settings in sections as in TOML; another State. The defaults without it.
        **settings: the flags of `gamow render`, on top: State('street', beta=0.6, size='640x480', gaze=(60, 0)).

    Raises:
        ValueError: a setting that does not exist or is out of range, a preset or a file that does not exist.
    """

    def __init__(self, source: State | _Path | Mapping[str, Any] | None = None, /, **settings: Any) -> None: ...
    def __eq__(self, other: object, /) -> bool: ...
    def replace(self, **settings: Any) -> State:
        """The same state with other settings."""
    def toml(self) -> str:
        """All settings as the text of a state file."""
    def link(self) -> str:
        """The link that opens this state in the window; a ValueError where its scene is a file."""
    def render(self, *, channels: bool = False) -> Any:
        """The picture, or what its pixels show: see `gamow.render`."""
    def _repr_png_(self) -> bytes: ...

class Scene:
    """A scene: the bodies that ride past, their names, and the groups in which they move.

    Args:
        source: name of a preset ('cyclist'); path of a scene file; TOML text; a dict as in TOML, such as
            {'name': 'Ball', 'object': [{'shape': 'sphere', 'centre': (0, 3, 2), 'radius': 0.5}]}; another Scene. The street
            without it.

    Lengths are in the scene's unit, places in the rest frame of their group. `State(scene=scene)` shows it; one from text or a
    dict must be saved before.

    Raises:
        ValueError: a file that breaks a rule of the format, with its line; a preset that does not exist.
    """

    def __init__(self, source: Scene | _Path | Mapping[str, Any] | None = None, /) -> None: ...
    def __eq__(self, other: object, /) -> bool: ...
    @property
    def name(self) -> str:
        """The name of the scene, as the window shows it."""
    @property
    def metres(self) -> float | None:
        """The length of a unit in metres; None if the scene leaves it open."""
    @property
    def objects(self) -> list[str]:
        """The names of all bodies: the one at index i has the number i in the channels left.id and right.id."""
    @property
    def groups(self) -> list[tuple[str, list[int]]]:
        """The groups in the order of the channels left.group and right.group: the name of each, and the numbers of its bodies."""
    def place(self, object: str | int | None = None, /) -> list[float]:
        """The place [x, y, z] of a point at rest in the frame of its group.

        It is the forward-most point of the body of this name or number, the one that is selected at first without one. On the
        ground x0 is x/gamma.
        """
    def save(self, path: _Path) -> Scene:
        """Writes a scene from text or a dict as a scene file, whole or not at all, and returns the scene in that file."""
    def __fspath__(self) -> str: ...
