# SPDX-License-Identifier: MIT OR Apache-2.0
"""What was built of the last sample. Blender takes an operator back and runs it again when one of its settings is changed:
only what this setting decides is then made anew."""

from __future__ import annotations

from typing import Any, Callable, Hashable


class Kept:
    """By name the last thing that was built, and what it was built with."""

    def __init__(self) -> None:
        self._made: dict[str, tuple[Hashable, Any]] = {}

    def once(self, name: str, key: Hashable, make: Callable[[], Any]) -> Any:
        """The thing of this name and key, which is made unless it is there."""
        found = self._made.get(name)
        if found is not None and found[0] == key:
            return found[1]
        made = make()
        self._made[name] = (key, made)
        return made


_key: Hashable = None
_kept = Kept()


def of(key: Hashable) -> Kept:
    """What is kept of one sample; what was kept of another one goes."""
    global _key, _kept
    if key != _key:
        _key, _kept = key, Kept()
    return _kept


def clear() -> None:
    """Forgets everything."""
    of(None)
