# SPDX-License-Identifier: MIT OR Apache-2.0
"""Finds and loads the library: what MEDAX_LIBRARY names, else the one in this package, else the system's."""

import ctypes
import ctypes.util
import os
import pathlib
import sys
from collections.abc import Iterator

from . import _ffi

ABI = f"{_ffi.VERSION[0]}.{_ffi.VERSION[1]}" if _ffi.VERSION[0] == 0 else str(_ffi.VERSION[0])


def file_name() -> str:
    """What the library is called beside the package."""
    return {"win32": "medax.dll", "darwin": "libmedax.dylib"}.get(sys.platform, "libmedax.so")


def _candidates() -> Iterator[str]:
    """What to try, in this order."""
    named = os.environ.get("MEDAX_LIBRARY")
    if named:
        # Who names a library wants that one or an error.
        yield named
        return
    beside = pathlib.Path(__file__).resolve().parent / file_name()
    if beside.exists():
        yield str(beside)
    system = {"win32": "medax.dll", "darwin": f"libmedax.{ABI}.dylib"}.get(sys.platform, f"libmedax.so.{ABI}")
    yield system
    found = ctypes.util.find_library("medax")
    if found and found != system:
        yield found


def _declared(path: str) -> ctypes.CDLL:
    """The library of a path, if its version is that of the header from which this package was made."""
    library = ctypes.CDLL(path)
    try:
        version = library.medax_version
    except AttributeError:
        raise OSError("it is not medax") from None
    version.restype, version.argtypes = ctypes.c_uint32, ()
    number = version()
    found = (number >> 22, number >> 12 & 0x3FF, number & 0xFFF)
    # Each minor version is an ABI of its own before 1.0.
    same = found[:2] == _ffi.VERSION[:2] if found[0] == 0 else found[0] == _ffi.VERSION[0]
    if not same or found < _ffi.VERSION:
        raise OSError(f"its version is {'.'.join(map(str, found))}, this package needs {ABI}")
    for name, (result, arguments) in _ffi.FUNCTIONS.items():
        function = getattr(library, name)
        function.restype, function.argtypes = result, arguments
    return library


def load() -> ctypes.CDLL:
    """The library, or an ImportError that tells what was tried."""
    tried = []
    for path in _candidates():
        try:
            return _declared(path)
        except (OSError, AttributeError) as error:
            tried.append(f"\n  {path}: {error}")
    raise ImportError(
        f"medax: no library of version {ABI} was found; set MEDAX_LIBRARY to its path, or install the wheel, "
        f"which carries it. Tried:{''.join(tried)}"
    )


lib = load()
