"""Keywords: one that a function does not have is refused with the one that may be meant."""

import difflib
import functools
import inspect


def unknown(name, known):
    """The error for a keyword `name` that is none of those `known`."""
    known = list(known)
    near = difflib.get_close_matches(name, known, 1)
    there = f"did you mean `{near[0]}`?" if near else f"there are {', '.join(known)}"
    return TypeError(f"there is no keyword `{name}`: {there}")


def checked(function):
    """Has `function` refuse a keyword that it does not have with a proposal."""
    parameters = inspect.signature(function).parameters.values()
    known = [parameter.name for parameter in parameters if parameter.kind is parameter.KEYWORD_ONLY]

    @functools.wraps(function)
    def call(*words, **keywords):
        if not keywords.keys() <= set(known):
            raise unknown(next(name for name in keywords if name not in known), known)
        return function(*words, **keywords)

    return call
