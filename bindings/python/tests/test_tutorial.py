# SPDX-License-Identifier: MIT OR Apache-2.0
"""docs/python.md does what it says: its blocks are run one after the other, and print what stands below them."""

import contextlib
import io
import re

import pytest
from conftest import REPOSITORY


def cells(text):
    """The blocks of code, each with the output that is shown below it, if any, and its line."""
    pattern = r"^```python\n(.*?)^```\n(?:\n^```text\n(.*?)^```\n)?"
    for match in re.finditer(pattern, text, flags=re.M | re.S):
        yield match[1], match[2], text[: match.start()].count("\n") + 2


def run(page, folder, monkeypatch):
    pytest.importorskip("pyvista").OFF_SCREEN = True
    monkeypatch.chdir(folder)
    names = {"__name__": "__main__"}
    count = 0
    for code, shown, line in cells(page.read_text(encoding="utf-8")):
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            exec(compile("\n" * (line - 1) + code, str(page), "exec"), names)
        if shown is not None:
            assert out.getvalue() == shown, f"{page.name}:{line}"
        count += 1
    return count


def test_the_tutorial(tmp_path, monkeypatch):
    assert run(REPOSITORY / "docs" / "python.md", tmp_path, monkeypatch) > 10
    for name in ("surface.ply", "axis.vtu", "axis.png"):
        assert (tmp_path / name).stat().st_size > 1000


def test_the_readme(tmp_path, monkeypatch):
    assert run(REPOSITORY / "bindings" / "python" / "README.md", tmp_path, monkeypatch) == 1
