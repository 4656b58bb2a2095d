# SPDX-License-Identifier: MIT OR Apache-2.0
"""The options that `**` takes, told in the docstring of whatever takes them, as their TypedDicts explain them."""

from __future__ import annotations

import inspect
from collections.abc import Iterable
from types import FunctionType
from typing import Any

#: Kinds of options that exist only for the checkers of types, and what they consist of.
_PARTS = {
    "FilterAndHow": ("MedialFilter", "How"),
    "FieldAxisAndHow": ("FieldAxisOptions", "How"),
    "MedialGraphAndHow": ("MedialGraphOptions", "How"),
    "CrustAndHow": ("CrustOptions", "How"),
}


def explain(function: FunctionType) -> None:
    """Adds to a docstring what the options mean."""
    # Where docstrings are stripped there is nothing to add.
    if explain.__doc__ is None or not function.__code__.co_flags & inspect.CO_VARKEYWORDS:
        return
    code = function.__code__
    last = code.co_argcount + code.co_kwonlyargcount + bool(code.co_flags & inspect.CO_VARARGS)
    told = str(function.__annotations__.get(code.co_varnames[last], ""))
    if not told.startswith("Unpack["):
        return
    name = told.removeprefix("Unpack[").removesuffix("]")
    kinds = [function.__globals__[part] for part in _PARTS.get(name, (name,))]
    text = inspect.cleandoc(function.__doc__ or "See the class.")
    lines = [line for kind in kinds for line in _lines(kind)]
    function.__doc__ = "\n".join([text, "", "Options:", "", *lines])


def explain_methods(kinds: Iterable[Any]) -> None:
    """So for the methods of some classes."""
    for kind in kinds:
        for value in vars(kind).values():
            function = getattr(value, "__func__", value)
            if isinstance(function, FunctionType):
                explain(function)


def _lines(kind: Any) -> list[str]:
    """The list in the docstring of a TypedDict."""
    lines = inspect.cleandoc(kind.__doc__ or "").splitlines()
    return [line for line in lines if line.startswith(("- ", "  "))]
