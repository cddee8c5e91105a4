"""What two eyes see of bodies that move at nearly the speed of light: numbers in NumPy arrays, and pictures.

c = 1; lengths and times share one unit, or are Quantities of astropy or pint. x points along the motion, y forward, z up; the
eyes rest at x = -d/2 (left) and x = +d/2 (right) unless they move. Angles that are seen, and those on a wheel, are radians; how a
head is held and where somebody looks or moves (`roll`, `turn`, `gaze`, `observer_azimuth`, ...) are degrees. What cannot be
computed is a `ValueError`, an argument of another type or name a `TypeError`, each in one line.
"""

from ._core import Scene, State, __version__, presets, scenes
from ._fits import Estimate, FitResult, fit
from ._pictures import measure, render
from ._points import curve, disparity, sightings, stereo
from ._remarks import GamowWarning

__all__ = [
    "Estimate",
    "FitResult",
    "GamowWarning",
    "Scene",
    "State",
    "__version__",
    "curve",
    "disparity",
    "fit",
    "measure",
    "presets",
    "render",
    "scenes",
    "sightings",
    "stereo",
]
