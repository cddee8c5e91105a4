"""Remarks of Gamow, as warnings of Python."""


class GamowWarning(UserWarning):
    """A remark on what was found, which may be ignored: `warnings.simplefilter("ignore", gamow.GamowWarning)`."""
