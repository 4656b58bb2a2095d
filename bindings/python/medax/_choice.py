# SPDX-License-Identifier: MIT OR Apache-2.0
"""Enumerations whose members can be given by name."""

from __future__ import annotations

import enum
from typing import TypeVar, Union

C = TypeVar("C", bound="Choice")


class Choice(enum.IntEnum):
    """An enumeration of the header. Wherever one is asked for, a member's name as text will do: `"inner"`."""

    @classmethod
    def of(cls: type[C], value: Union[C, str, int]) -> C:
        """The member that a value stands for."""
        from .error import ArgumentError

        if isinstance(value, str):
            found = cls.__members__.get(value.upper().replace("-", "_"))
            if found is not None:
                return found
        elif not isinstance(value, Choice) or isinstance(value, cls):
            try:
                return cls(value)
            except ValueError:
                pass
        names = ", ".join(repr(member.name.lower()) for member in cls)
        raise ArgumentError(f"{value!r} is no {cls.__name__}: there are {names}")
