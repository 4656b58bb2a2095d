# SPDX-License-Identifier: MIT OR Apache-2.0
"""Arrays: those that come from the library without a copy, and those that are handed to it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _ffi
from ._ffi import ErrorKind
from .error import ArgumentError

#: "No such element": the only sentinel in any array of indices.
NONE = _ffi.NONE

Floats = NDArray[np.float64]
Indices = NDArray[np.uint32]
Flags = NDArray[np.bool_]
#: Rows of varying length, as they may be given.
RowsLike = Union["Rows", ArrayLike, Sequence[Sequence[int]], tuple[ArrayLike, ArrayLike]]

_TYPES = {
    _ffi.medax_view_f64: np.dtype(np.float64),
    _ffi.medax_view_u32: np.dtype(np.uint32),
    # Flags, 0 or 1: as booleans they choose rows of other arrays.
    _ffi.medax_view_u8: np.dtype(np.bool_),
}


class _Memory:
    """Memory of the library that numpy reads; it keeps a reference to its owner."""

    __slots__ = ("__array_interface__", "owner")

    def __init__(self, owner: object, address: int, shape: tuple[int, ...], dtype: np.dtype[Any]) -> None:
        self.owner = owner
        self.__array_interface__ = {
            "version": 3,
            "data": (address, True),
            "shape": shape,
            "typestr": dtype.str,
        }


def borrowed(owner: object, address: Optional[int], shape: tuple[int, ...], dtype: Any) -> NDArray[Any]:
    """A read-only array of memory that `owner` keeps."""
    dtype = np.dtype(dtype)
    if not address or 0 in shape:
        empty = np.empty(shape, dtype)
        empty.flags.writeable = False
        return empty
    return np.asarray(_Memory(owner, address, shape, dtype))


def of_view(owner: object, view: Any, cols: int) -> NDArray[Any]:
    """The array of a view: `rows` x `cols`, or of `rows` values where `cols` is 1."""
    shape = (view.rows,) if cols == 1 else (view.rows, cols)
    return borrowed(owner, view.data, shape, _TYPES[type(view)])


class Rows(Sequence[Indices]):
    """Rows of varying length: `rows[i]` is an array, `len(rows)` their number.

    - `offsets`: `len(rows) + 1` positions in `indices`, uint32.
    - `indices`: all rows, one after the other, uint32.
    """

    __slots__ = ("indices", "offsets")

    def __init__(self, offsets: Indices, indices: Indices) -> None:
        self.offsets = offsets
        self.indices = indices

    @classmethod
    def _of_view(cls, owner: object, view: Any) -> Rows:
        if not view.offsets:
            return cls(borrowed(owner, None, (0,), np.uint32), borrowed(owner, None, (0,), np.uint32))
        offsets = borrowed(owner, view.offsets, (view.rows + 1,), np.uint32)
        return cls(offsets, borrowed(owner, view.indices, (int(offsets[-1]),), np.uint32))

    @property
    def lengths(self) -> NDArray[np.uint32]:
        """The length of each row."""
        return np.diff(self.offsets)

    def __len__(self) -> int:
        return max(len(self.offsets) - 1, 0)

    def __getitem__(self, row: Any) -> Any:
        if isinstance(row, slice):
            return [self[i] for i in range(*row.indices(len(self)))]
        index = row.__index__()
        if index < 0:
            index += len(self)
        if not 0 <= index < len(self):
            raise IndexError(f"row {row} of {len(self)}")
        return self.indices[self.offsets[index] : self.offsets[index + 1]]

    def __iter__(self) -> Iterator[Indices]:
        return (self[i] for i in range(len(self)))

    def to_list(self) -> list[list[int]]:
        """All rows as lists."""
        return [row.tolist() for row in self]

    def __repr__(self) -> str:
        return f"<medax.Rows: {len(self)} rows, {len(self.indices)} indices>"


def _array(value: Any, name: str) -> NDArray[Any]:
    if isinstance(value, np.ma.MaskedArray) and np.ma.is_masked(value):
        raise ArgumentError(f"{name}: a masked array whose masked values would be read; fill or compress it first")
    try:
        array = np.asarray(value)
    except (ValueError, TypeError) as error:
        raise ArgumentError(f"{name} is no array: {error}") from None
    # What is empty has no dtype of its own: np.asarray([]) is one of floats.
    return array


def _shaped(array: NDArray[Any], name: str, cols: int) -> NDArray[Any]:
    wanted = "(n,)" if cols == 1 else f"(n, {cols})"
    if array.size == 0 and array.ndim <= 2 and (array.ndim < 2 or array.shape[1] in (0, cols)):
        return array.reshape((0,) if cols == 1 else (0, cols))
    if cols == 1 and array.ndim == 2 and array.shape[1] == 1:
        array = array[:, 0]
    if array.ndim != (1 if cols == 1 else 2) or (cols != 1 and array.shape[1] != cols):
        raise ArgumentError(f"{name} must have the shape {wanted}, not {array.shape}")
    return array


def _plain(array: NDArray[Any], dtype: Any) -> NDArray[Any]:
    return np.require(array, dtype, ["C", "ALIGNED"])


def real(array: NDArray[Any], name: str) -> NDArray[Any]:
    """An array of floats or integers as one of floats, if that loses nothing."""
    kind = array.dtype.kind
    if kind == "f" and array.dtype.itemsize <= 8:
        return array
    if kind in "iu":
        if array.dtype.itemsize == 8 and array.size and (array.max() > 2**53 or array.min() < -(2**53)):
            raise ArgumentError(f"{name}: integers beyond 2**53 are no float64")
        return array.astype(np.float64)
    if array.size == 0 and kind in "bO":
        return array.astype(np.float64)
    raise ArgumentError(f"{name}: {array.dtype} cannot be converted to float64 without loss")


def floats(value: ArrayLike, name: str, cols: int = 3, count: Optional[int] = None) -> Floats:
    """C-contiguous float64: the array itself if it is that, else a converted copy."""
    array = _shaped(real(_array(value, name), name), name, cols)
    counted(array, name, count)
    return _plain(array, np.float64)


def counted(array: NDArray[Any], name: str, count: Optional[int]) -> None:
    if count is not None and len(array) != count:
        raise ArgumentError(f"{name} must have {count} rows, not {len(array)}")


def indices(value: ArrayLike, name: str, cols: int = 1, count: Optional[int] = None) -> Indices:
    """C-contiguous uint32: the array itself if it is that, else a converted copy."""
    array = _shaped(_array(value, name), name, cols)
    counted(array, name, count)
    if array.size == 0:
        return _plain(array, np.uint32)
    if array.dtype.kind not in "iu":
        raise ArgumentError(f"{name} must be integers, not {array.dtype}")
    if array.dtype != np.uint32:
        wrong = (array < 0) | (array > NONE) if array.dtype.itemsize > 4 else array < 0
        if wrong.any():
            row = int(np.argwhere(wrong)[0][0])
            raise ArgumentError(
                f"{name}: row {row} is {array[row].tolist()}; indices are from 0 to 2**32 - 1", row, ErrorKind.ROW
            )
    return _plain(array, np.uint32)


def flags(value: ArrayLike, name: str, count: Optional[int] = None) -> NDArray[np.uint8]:
    """C-contiguous bytes that are 0 or 1, of booleans or integers."""
    array = _shaped(_array(value, name), name, 1)
    counted(array, name, count)
    if array.size and array.dtype.kind not in "biu":
        raise ArgumentError(f"{name} must be booleans, not {array.dtype}")
    if array.dtype.kind in "iu" and array.size:
        wrong = (array != 0) & (array != 1)
        if wrong.any():
            row = int(np.argmax(wrong))
            raise ArgumentError(f"{name}: row {row} is {array[row]}; flags are 0 or 1", row, ErrorKind.ROW)
    plain = _plain(array, np.bool_)
    return plain.view(np.uint8)


def vector(value: ArrayLike, name: str, length: int = 3) -> Floats:
    """Some numbers in a row, such as a point."""
    array = real(_array(value, name), name)
    if array.shape != (length,):
        raise ArgumentError(f"{name} must be {length} numbers, not an array of shape {array.shape}")
    return _plain(array, np.float64)


def rows(value: RowsLike, name: str) -> Rows:
    """Rows of varying length: `Rows`, a tuple of offsets and indices, an array with a row each, or lists."""
    if isinstance(value, Rows):
        # The library's own are none, empty, where there is no row.
        value = (np.asarray(value.offsets if len(value.offsets) else [0]), np.asarray(value.indices))
    if isinstance(value, tuple) and len(value) == 2 and all(isinstance(part, np.ndarray) for part in value):
        offsets, inside = indices(value[0], f"{name} (offsets)"), indices(value[1], f"{name} (indices)")
        falls = (np.diff(offsets.astype(np.int64)) < 0).any()
        if len(offsets) == 0 or offsets[0] != 0 or offsets[-1] != len(inside) or falls:
            raise ArgumentError(f"{name}: offsets ascend from 0 to the number of indices, {len(inside)}")
        return Rows(offsets, inside)
    if isinstance(value, np.ndarray) and value.ndim == 2:
        cols = value.shape[1]
        offsets = np.arange(0, len(value) * cols + 1, cols, dtype=np.uint32) if cols else np.zeros(1, np.uint32)
        return Rows(offsets, indices(value, name, cols).reshape(-1) if cols > 1 else indices(value, name))
    if isinstance(value, np.ndarray) and value.size:
        raise ArgumentError(f"{name} must have the shape (n, k), not {value.shape}")
    try:
        lists = [np.asarray(row) for row in value]  # type: ignore[union-attr]
        ends = np.cumsum([0, *(len(row) for row in lists)])
    except (TypeError, ValueError):
        raise ArgumentError(f"{name} must be rows of indices") from None
    if ends[-1] > NONE:
        raise ArgumentError(f"{name}: more than 2**32 - 1 indices")
    for number, row in enumerate(lists):
        if row.size and (row.ndim != 1 or row.dtype.kind not in "iu"):
            raise ArgumentError(f"{name}: row {number} must be integers, not {row.tolist()}", number, ErrorKind.ROW)
    # Types that are mixed have floats in common, and so have empty rows.
    inside = np.concatenate(lists, dtype=np.int64, casting="unsafe") if ends[-1] else np.empty(0, np.uint32)
    return Rows(ends.astype(np.uint32), indices(inside, name))


def pointer(array: NDArray[Any]) -> Optional[int]:
    """Where an array lies; None for one without a row. The array must outlive the call."""
    return array.ctypes.data if array.size else None
