# SPDX-License-Identifier: MIT OR Apache-2.0
"""Loading, errors, enumerations, types."""

import inspect
import os
import pathlib
import pickle
import subprocess
import sys

import pytest

import medax
from medax import _library, distance, job, medial


def imported(**environment):
    """What a fresh interpreter says that imports medax."""
    code = "import medax; print(medax.__version__, medax._library.lib._name)"
    variables = {**os.environ, **environment}
    return subprocess.run([sys.executable, "-c", code], env=variables, capture_output=True, text=True)


def test_a_named_library(tmp_path):
    used = os.path.realpath(_library.lib._name)
    told = imported(MEDAX_LIBRARY=used)
    assert told.stdout.split() == [medax.__version__, used], told.stderr


def test_a_library_that_is_not_there(tmp_path):
    nowhere = str(tmp_path / "libmedax.so")
    told = imported(MEDAX_LIBRARY=nowhere)
    assert (
        told.returncode == 1 and "ImportError: medax: no library of version" in told.stderr and nowhere in told.stderr
    )


def test_a_library_that_is_another_one(tmp_path):
    (tmp_path / "text.so").write_text("no library")
    assert "ImportError: medax: no library" in imported(MEDAX_LIBRARY=str(tmp_path / "text.so")).stderr
    source = tmp_path / "other.c"
    for body, says in (
        ("int other(void) { return 0; }", "it is not medax"),
        ("unsigned medax_version(void) { return 7u << 12; }", "its version is 0.7.0, this package needs 0.1"),
    ):
        source.write_text(body)
        library = tmp_path / f"other{len(body)}.so"
        subprocess.run(["cc", "-shared", "-fPIC", source, "-o", library], check=True)
        assert says in imported(MEDAX_LIBRARY=str(library)).stderr


def test_errors_travel():
    with pytest.raises(medax.MedaxError) as caught:
        medax.Points([[float("nan"), 0, 0]])
    for error in (caught.value, medax.ArgumentError("wrong", 3, medax.ErrorKind.ROW)):
        again = pickle.loads(pickle.dumps(error))
        assert type(again) is type(error) and vars(again) == vars(error) and str(again) == error.message


def test_choices():
    assert medax.Side.of("inner") is medax.Side.of("INNER") is medax.Side.of(1) is medax.Side.of(medax.Side.INNER)
    assert medax.MedialRule.of("angle-or-ratio") is medax.MedialRule.ANGLE_OR_RATIO
    for wrong in ("middle", 7, medax.Label.INNER, None, 1.5):
        with pytest.raises(medax.ArgumentError, match="is no Side: there are 'outer', 'inner', 'both'"):
            medax.Side.of(wrong)


def test_names():
    assert set(medax.__all__) == {name for name in vars(medax) if not name.startswith("_")} - submodules() - {
        "annotations"
    } | {"convert"}
    for name in medax.__all__:
        assert getattr(medax, name).__doc__ or name == "NONE", name


def submodules():
    folder = pathlib.Path(medax.__file__).parent
    return {path.stem for path in folder.glob("*.py")}


def test_what_can_be_called_is_explained():
    for kind in vars(medax).values():
        if isinstance(kind, type) and issubclass(kind, medax.Handle):
            for name in dir(kind):
                if not name.startswith("_"):
                    assert getattr(kind, name).__doc__, f"{kind.__name__}.{name}"


def test_every_option_is_explained():
    """By name, where `help` shows it; those of a constructor in the docstring of the class as well."""
    more = {
        "Medial.axis": medial.MedialFilter,
        "Medial.selected": medial.MedialFilter,
        "FieldAxis.of": distance.FieldAxisOptions,
        "FieldAxis.between": distance.FieldAxisOptions,
        "MedialGraph.of": distance.MedialGraphOptions,
        "MedialGraph.between": distance.MedialGraphOptions,
    }
    seen = set()
    for kind in vars(medax).values():
        if not (isinstance(kind, type) and issubclass(kind, medax.Handle)):
            continue
        for name in ["__init__", *(name for name in dir(kind) if not name.startswith("_"))]:
            method = getattr(kind, name)
            if not inspect.isroutine(method):
                continue
            taken = inspect.signature(method).parameters.values()
            if not any(each.kind == each.VAR_KEYWORD and "Unpack" in str(each.annotation) for each in taken):
                continue
            label = f"{kind.__name__}.{name}"
            seen.add(label)
            wanted = {each.name for each in taken if each.kind == each.KEYWORD_ONLY} | set(job.How.__annotations__)
            if label in more:
                wanted |= set(more[label].__annotations__)
            told = method.__doc__ + (kind.__doc__ if name == "__init__" else "")
            missing = {option for option in wanted if f"`{option}`" not in told}
            assert not missing, f"{label}: {missing}"
    assert len(seen) > 60 and set(more) <= seen
    assert "- `theta`: of the angle condition, in radians in [0, pi/2); pi/8." in medax.Medial.axis.__doc__


def test_types(tmp_path):
    """A user's program is checked against the types of the installed package."""
    pytest.importorskip("mypy")
    program = tmp_path / "program.py"
    program.write_text(
        """
import numpy as np
import medax

points = medax.Points(np.zeros((4, 3)), skip_non_finite=True, threads=2)
dual = medax.Dual.of(medax.Triangulation.delaunay(points), facets=True)
axis: medax.Complex = medax.Medial.of(dual).axis(theta=0.3, side="both", progress=medax.progress_bar())
radius: np.ndarray = axis.values("radius")
count: int = points.count
"""
    )
    wrong = tmp_path / "wrong.py"
    wrong.write_text(
        """
import medax

points = medax.Points([[0, 0, 0]], threds=2)
medax.Dual.of(points)
medax.Medial.of(medax.Dual.of(medax.Triangulation.delaunay(points))).axis(theta="wide")
"""
    )
    command = [
        sys.executable,
        "-m",
        "mypy",
        "--strict",
        "--cache-dir",
        str(tmp_path / "cache"),
        str(program),
        str(wrong),
    ]
    told = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path)
    lines = [line.split(":")[:2] for line in told.stdout.splitlines() if ": error:" in line]
    assert {(pathlib.Path(path).name, line) for path, line in lines} == {
        ("wrong.py", "4"),
        ("wrong.py", "5"),
        ("wrong.py", "6"),
    }, told.stdout + told.stderr
