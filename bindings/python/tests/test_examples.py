# SPDX-License-Identifier: MIT OR Apache-2.0
"""The examples in Python count and write what those in C, C++ and Rust do: tests/examples/expected.txt."""

import functools
import pathlib
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]
DATA = ROOT / "tests" / "examples"
RUNS = {
    "poles": [str(DATA / "scan.xyz")],
    "power_crust": [str(DATA / "scan.xyz")],
    "wall_thickness": [str(DATA / "bracket.off"), "2.5"],
}


def run(example, *arguments):
    command = [sys.executable, str(ROOT / "examples" / f"{example}.py"), *arguments]
    return subprocess.run(command, capture_output=True, text=True)


@pytest.mark.parametrize("example", RUNS)
def test_counts_and_bytes_are_those_of_the_other_languages(example, tmp_path):
    out = tmp_path / "out.ply"
    done = run(example, *RUNS[example], str(out))
    assert done.returncode == 0, done.stderr
    # 64-bit FNV-1a.
    digest = functools.reduce(
        lambda hash, byte: (hash ^ byte) * 0x100000001B3 % 2**64, out.read_bytes(), 0xCBF29CE484222325
    )
    assert f"{example} {digest:016x} {done.stdout.strip()}" in (DATA / "expected.txt").read_text().splitlines()


@pytest.mark.parametrize("example", RUNS)
def test_what_is_wrong_is_said_in_a_line(example, tmp_path):
    done = run(example)
    assert done.returncode == (2 if example == "wall_thickness" else 1)
    assert done.stderr.startswith(f"usage: {example} ")
    done = run(example, str(tmp_path / "nothing.ply"), *RUNS[example][1:], str(tmp_path / "out.ply"))
    assert done.returncode == 1 and done.stdout == "" and done.stderr.count("\n") == 1


@pytest.mark.parametrize("limit", ("abc", "2.5mm", ""))
def test_a_limit_that_is_no_number_is_answered_with_the_usage(limit, tmp_path):
    out = tmp_path / "out.ply"
    done = run("wall_thickness", str(DATA / "bracket.off"), limit, str(out))
    assert (done.returncode, done.stdout) == (2, "") and not out.exists()
    assert done.stderr == "usage: wall_thickness PART LIMIT MESH\n"
