# SPDX-License-Identifier: MIT OR Apache-2.0
"""What a call that fails raises."""

from __future__ import annotations

from typing import Optional

from ._ffi import ErrorKind, Status
from ._library import lib

_NO_INDEX = 2**64 - 1


class MedaxError(Exception):
    """A call that failed.

    - `status`: a `Status`, such as `Status.NON_FINITE`.
    - `message`: a sentence for a person; also what `str()` gives.
    - `index`: which element is to blame, such as the row of an array; None if there is none.
    - `kind`: the `ErrorKind` of that element; `ErrorKind.NONE` if there is none.
    """

    def __init__(
        self,
        status: Status,
        message: str,
        index: Optional[int] = None,
        kind: ErrorKind = ErrorKind.NONE,
    ) -> None:
        super().__init__(status, message, index, kind)
        self.status = status
        self.message = message
        self.index = index
        self.kind = kind

    def __str__(self) -> str:
        return self.message

    @classmethod
    def last(cls, status: int) -> MedaxError:
        """This thread's last error, of the call that returned `status`."""
        index = lib.medax_last_error_index()
        return MedaxError(
            Status(status),
            lib.medax_last_error_message().decode("utf-8", "replace"),
            None if index == _NO_INDEX else index,
            ErrorKind(lib.medax_last_error_kind()),
        )


class ArgumentError(MedaxError, ValueError):
    """An argument that cannot be handed to the library: an array of another shape, a dtype that cannot be
    converted without loss, an option that is none. It is a ValueError, too."""

    def __init__(self, message: str, index: Optional[int] = None, kind: ErrorKind = ErrorKind.NONE) -> None:
        super().__init__(Status.INVALID_ARGUMENT, message, index, kind)

    def __reduce__(self):  # type: ignore[no-untyped-def]
        return ArgumentError, (self.message, self.index, self.kind)


def check(status: int) -> None:
    """Raises what a call failed with, if it failed."""
    if status != Status.OK:
        raise MedaxError.last(status)
