"""Special relativity as two eyes would see it: numbers in NumPy arrays, pictures, fits."""

from .gamow import *
from .gamow import __all__, __doc__
