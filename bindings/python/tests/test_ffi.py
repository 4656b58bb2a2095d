# SPDX-License-Identifier: MIT OR Apache-2.0
"""The header, _ffi.py and medax.hpp know the same functions, structs and numbers."""

import ctypes
import importlib.util
import inspect
import pathlib
import re
import subprocess
import sys

import pytest
from conftest import CALLS, REPOSITORY

import medax
from medax import _ffi

HEADER = (REPOSITORY / "include" / "medax.h").read_text(encoding="utf-8")
CODE = re.sub(r"/\*.*?\*/", " ", HEADER, flags=re.S)


def generator():
    spec = importlib.util.spec_from_file_location("generate", REPOSITORY / "bindings" / "python" / "generate.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.skipif(sys.version_info < (3, 9), reason="generate.py needs 3.9")
def test_ffi_is_what_the_header_makes():
    assert generator().generated(HEADER) == pathlib.Path(_ffi.__file__).read_text(encoding="utf-8")


def test_header_ffi_and_cpp_have_the_same_functions():
    header = set(re.findall(r"\b(medax_\w+)\(", CODE))
    cpp = "".join(
        re.sub(r"//.*", "", path.read_text(encoding="utf-8"))
        for path in (REPOSITORY / "bindings" / "cpp").rglob("*.hpp")
    )
    assert len(header) > 400
    assert header == set(_ffi.FUNCTIONS)
    known = set(re.findall(r"\bmedax_\w+\b", cpp))
    assert header - known == set()
    functions = {name for name in known if re.search(rf"\b{name}\(", cpp)}
    assert functions - header == set()


def test_header_and_classes_have_the_same_handles():
    opaque = {f"medax_{name}" for name in re.findall(r"typedef struct medax_(\w+) medax_\1;", CODE)}
    classes = {
        kind._stem
        for _, kind in inspect.getmembers(medax, inspect.isclass)
        if issubclass(kind, medax.Handle) and hasattr(kind, "_stem")
    }
    assert classes == opaque


def test_structs_have_the_sizes_of_c(tmp_path):
    """A compiler tells: sizes and offsets of all fields."""
    structs = {
        name: kind
        for name, kind in vars(_ffi).items()
        if inspect.isclass(kind) and issubclass(kind, ctypes.Structure) and hasattr(kind, "_fields_")
    }
    lines, expected = ["#include <medax.h>", "#include <stdio.h>", "int main(void) {"], []
    for name, kind in structs.items():
        lines.append(f'printf("%zu\\n", sizeof({name}));')
        expected.append(ctypes.sizeof(kind))
        for field in kind._fields_:
            lines.append(f'printf("%zu\\n", offsetof({name}, {field[0]}));')
            expected.append(getattr(kind, field[0]).offset)
    source, program = tmp_path / "layout.c", tmp_path / "layout"
    source.write_text("\n".join([*lines, "return 0; }"]))
    subprocess.run(["cc", f"-I{REPOSITORY / 'include'}", source, "-o", program], check=True)
    told = subprocess.run([program], check=True, capture_output=True, text=True).stdout
    assert list(map(int, told.split())) == expected


def test_numbers():
    assert _ffi.NONE == medax.NONE == 2**32 - 1
    assert medax.Status.LIMIT_EXCEEDED == 22
    for status in medax.Status:
        from medax._library import lib

        assert lib.medax_status_name(status) == f"MEDAX_STATUS_{status.name}".encode()
    for shape in medax.Shape:
        assert lib.medax_shape_name(shape) == shape.name.lower().encode()
    assert medax.__version__ == ".".join(map(str, _ffi.VERSION))


def test_every_function_was_called():
    """Runs after all other tests: whatever the header has, the classes use."""
    left = sorted(set(_ffi.FUNCTIONS) - set(CALLS))
    assert not left, left
