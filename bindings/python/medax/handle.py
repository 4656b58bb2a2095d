# SPDX-License-Identifier: MIT OR Apache-2.0
"""What every class is made of: a counted reference, and sized options."""

from __future__ import annotations

import ctypes
import dataclasses
import operator
import os
from collections.abc import Sequence
from typing import Any, Callable, ClassVar, Optional, TypeVar, Union

import numpy as np
from numpy.typing import NDArray

from . import _ffi
from .error import ArgumentError, check
from ._library import lib
from .view import Rows, of_view

H = TypeVar("H", bound="Handle")
R = TypeVar("R")


class Reference:
    """One counted reference. Arrays hold it, too: the last of all who do gives it back."""

    __slots__ = ("_as_parameter_", "_free", "__weakref__")

    def __init__(self, owned: Any, free: Callable[[Any], None]) -> None:
        self._as_parameter_ = owned
        self._free = free

    def __del__(self) -> None:
        self._free(self._as_parameter_)


class Handle:
    """A counted reference to an immutable structure.

    Copies (`copy.copy`, `clone`) share the structure, and any thread may use any of them. `close`, or the end of a
    `with`, gives the reference back; arrays that came from it stay, and keep what they show alive.
    """

    _struct: ClassVar[Any]
    _stem: ClassVar[str]
    _reference: Optional[Reference]

    def __init_subclass__(cls, stem: str = "", **others: Any) -> None:
        super().__init_subclass__(**others)
        if stem:
            cls._stem = f"medax_{stem}"
            cls._struct = getattr(_ffi, cls._stem)

    def __init__(self, *arguments: Any, **options: Any) -> None:
        ways = [name for name in ("of", "read", "delaunay", "voronoi") if hasattr(type(self), name)]
        made_by = " or ".join(ways) or "other structures"
        raise TypeError(f"{type(self).__name__} is made by {made_by}, not by calling it")

    @classmethod
    def _take(cls: type[H], owned: Any) -> H:
        """Takes over a reference that a function of medax.h gave."""
        made = cls.__new__(cls)
        made._reference = Reference(owned, getattr(lib, cls._stem + "_free"))
        return made

    @classmethod
    def _slot(cls) -> Any:
        """A pointer that receives a handle."""
        return ctypes.POINTER(cls._struct)()

    @property
    def _ref(self) -> Reference:
        reference = self._reference
        if reference is None:
            raise ArgumentError(f"this {type(self).__name__} is closed")
        return reference

    @property
    def closed(self) -> bool:
        """Whether `close` was called."""
        return self._reference is None

    def close(self) -> None:
        """Gives the reference back. Whatever else refers to the structure stays as it is."""
        self._reference = None

    def clone(self: H) -> H:
        """Another object for the same structure."""
        return self._take(getattr(lib, self._stem + "_clone")(self._ref))

    def __copy__(self: H) -> H:
        return self.clone()

    def __deepcopy__(self: H, memo: Any) -> H:
        # What nobody can change need not be copied.
        return self.clone()

    def __reduce__(self) -> Any:
        raise TypeError(f"a {type(self).__name__} cannot be pickled; write it to a file, or pickle its arrays")

    def __enter__(self: H) -> H:
        return self

    def __exit__(self, *exception: Any) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<medax.{type(self).__name__}{': closed' if self.closed else self._told()}>"

    def _told(self) -> str:
        """What `repr` tells after the name."""
        return ""

    def _get(self, name: str) -> Any:
        return getattr(lib, f"{self._stem}_{name}")(self._ref)

    def _view(self, name: str, cols: int = 1) -> NDArray[Any]:
        reference = self._ref
        return of_view(reference, getattr(lib, f"{self._stem}_{name}")(reference), cols)

    def _rows(self, name: str) -> Rows:
        reference = self._ref
        return Rows._of_view(reference, getattr(lib, f"{self._stem}_{name}")(reference))

    def _kept(self, name: str, kind: type[H], *arguments: Any) -> H:
        """A handle that costs no job."""
        slot = kind._slot()
        check(getattr(lib, f"{self._stem}_{name}")(self._ref, *arguments, ctypes.byref(slot)))
        return kind._take(slot)

    def _box(self, dimension: int = 3) -> NDArray[np.float64]:
        box = np.empty((2, dimension))
        check(getattr(lib, self._stem + "_bounds")(self._ref, box[0].ctypes.data, box[1].ctypes.data))
        box.flags.writeable = False
        return box


def ref(value: Any, kind: type[Handle], name: str) -> Reference:
    """The reference of an argument that must be of a kind."""
    if not isinstance(value, kind):
        raise TypeError(f"{name} must be a medax.{kind.__name__}, not {type(value).__name__}")
    return value._ref


def path_of(value: Union[str, bytes, os.PathLike[Any]]) -> bytes:
    """A path as the library takes it."""
    path = os.fsencode(value)
    if b"\0" in path:
        raise ArgumentError(f"a path cannot hold a NUL: {value!r}")
    return path


def text_of(value: Any, name: str) -> bytes:
    """A text as the library takes it."""
    if not isinstance(value, str):
        raise ArgumentError(f"{name} must be text, not {value!r}")
    if "\0" in value:
        raise ArgumentError(f"{name} cannot hold a NUL: {value!r}")
    return value.encode()


_UNSIGNED = {_ffi.u32: 32, _ffi.u64: 64, _ffi.usize: 8 * ctypes.sizeof(ctypes.c_size_t)}


def whole(value: Any, name: str, bits: int) -> int:
    """A number from 0 to 2**bits - 1."""
    try:
        number = operator.index(value)
    except TypeError:
        raise ArgumentError(f"{name} must be an integer, not {value!r}") from None
    if not 0 <= number < 1 << bits:
        raise ArgumentError(f"{name} must be from 0 to 2**{bits} - 1, not {number}")
    return number


def number(value: Any, name: str) -> float:
    """A real number."""
    if isinstance(value, (str, bytes)):
        raise ArgumentError(f"{name} must be a number, not {value!r}")
    try:
        return float(value)
    except (TypeError, ValueError):
        raise ArgumentError(f"{name} must be a number, not {value!r}") from None


def options(struct: Any, **given: Any) -> Any:
    """A sized struct at its defaults, but for what is given; None asks for the default."""
    from .view import vector

    made = struct()
    check(getattr(lib, struct.__name__ + "_init")(ctypes.byref(made), ctypes.sizeof(made)))
    kinds = dict(field[:2] for field in struct._fields_)
    for name, value in given.items():
        if value is None:
            continue
        kind = kinds[name]
        if kind is _ffi.f64:
            setattr(made, name, number(value, name))
        elif kind in _UNSIGNED:
            setattr(made, name, whole(value, name, _UNSIGNED[kind]))
        elif issubclass(kind, ctypes.Array):
            setattr(made, name, kind(*vector(value, name, kind._length_).tolist()))
        else:
            setattr(made, name, value)
    return made


def clipped(clip: Any) -> dict[str, Any]:
    """The options of a box, which is given as its least corner and its largest."""
    if clip is None:
        return {}
    is_pair = isinstance(clip, (Sequence, np.ndarray)) and len(clip) == 2
    if not is_pair or any(corner is None for corner in clip):
        raise ArgumentError("clip must be two corners of a box, the least and the largest")
    return {"clip_min": clip[0], "clip_max": clip[1], "has_clip": 1}


def report_of(struct: Any) -> Any:
    """A report for the library to fill."""
    made = struct()
    made.struct_size = ctypes.sizeof(made)
    return made


def told(kind: Callable[..., R], struct: Any, **changed: Any) -> R:
    """A dataclass with the fields of a struct that have the same names."""
    found = {}
    for field in dataclasses.fields(kind):  # type: ignore[arg-type]
        if field.name in changed:
            found[field.name] = changed[field.name]
            continue
        value = getattr(struct, field.name)
        if isinstance(value, ctypes.Array):
            value = tuple(value)
        elif isinstance(value, bytes):
            value = value.decode("utf-8", "replace")
        elif field.type in (bool, "bool"):
            value = bool(value)
        found[field.name] = value
    return kind(**found)
