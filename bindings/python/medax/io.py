# SPDX-License-Identifier: MIT OR Apache-2.0
"""What files did not hold."""

from __future__ import annotations

from collections.abc import Iterator

from ._library import lib
from .handle import Handle


class Warnings(Handle, stem="warnings"):
    """Sentences about what a file did not hold, or what was left out of it: `len(warnings)`, `warnings[i]`."""

    @property
    def count(self) -> int:
        """The number of sentences."""
        return int(self._get("count"))

    def __len__(self) -> int:
        return self.count

    def __getitem__(self, index: int) -> str:
        if index < 0:
            index += self.count
        if not 0 <= index < self.count:
            raise IndexError(f"warning {index} of {self.count}")
        return str(lib.medax_warnings_text(self._ref, index).decode())

    def __iter__(self) -> Iterator[str]:
        return (self[i] for i in range(self.count))

    def _told(self) -> str:
        return f": {list(self)}"
