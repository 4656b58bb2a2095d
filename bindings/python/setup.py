# SPDX-License-Identifier: MIT OR Apache-2.0
"""Puts the library into the package: what MEDAX_LIBRARY names, or what cargo builds."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Distribution, setup
from setuptools.command.bdist_wheel import bdist_wheel
from setuptools.command.build_py import build_py

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
NAME = {"win32": "medax.dll", "darwin": "libmedax.dylib"}.get(sys.platform, "libmedax.so")


def library():
    """The path of the library."""
    named = os.environ.get("MEDAX_LIBRARY")
    if named:
        return pathlib.Path(named).resolve(strict=True)
    target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
    subprocess.run(
        ["cargo", "build", "--release", "--locked", "--lib", "--no-default-features", "--target-dir", str(target)],
        cwd=ROOT,
        check=True,
    )
    return target / "release" / NAME


class Build(build_py):
    def run(self):
        super().run()
        if not self.editable_mode:
            package = pathlib.Path(self.build_lib) / "medax"
            package.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(library(), package / NAME)
            for text in ROOT.glob("LICENSE-*"):
                shutil.copyfile(text, package / text.name)
            strip = shutil.which("strip") if sys.platform.startswith("linux") else None
            if strip:
                # Debugging information is six sevenths of it.
                subprocess.run([strip, "--strip-unneeded", str(package / NAME)], check=True)


class Wheel(bdist_wheel):
    def get_tag(self):
        # Any Python, since ctypes loads the library; but one platform.
        return "py3", "none", super().get_tag()[2]


class Binary(Distribution):
    def has_ext_modules(self):
        return True


version = re.search(r'^version = "(.+)"', (ROOT / "Cargo.toml").read_text(encoding="utf-8"), re.M)[1]
setup(version=version, cmdclass={"build_py": Build, "bdist_wheel": Wheel}, distclass=Binary)
