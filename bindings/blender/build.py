#!/usr/bin/env python3
# SPDX-License-Identifier: MIT OR Apache-2.0
"""Makes the extension of medax's wheels: `build.py -o FOLDER WHEEL...`, one wheel a platform."""

import argparse
import pathlib
import re
import zipfile

SOURCE = pathlib.Path(__file__).resolve().parent / "medax_blender"
#: Blender's platforms by how the platform tag of a wheel begins and ends.
PLATFORMS = {
    ("linux", "x86_64"): "linux-x64",
    ("manylinux", "x86_64"): "linux-x64",
    ("linux", "aarch64"): "linux-arm64",
    ("manylinux", "aarch64"): "linux-arm64",
    ("macosx", "x86_64"): "macos-x64",
    ("macosx", "arm64"): "macos-arm64",
    ("win", "amd64"): "windows-x64",
    ("win", "arm64"): "windows-arm64",
}


def platform(wheel: pathlib.Path) -> str:
    tag = wheel.stem.split("-")[-1]
    for (begin, end), name in PLATFORMS.items():
        if tag.startswith(begin) and tag.endswith(end):
            return name
    raise SystemExit(f"{wheel.name}: Blender has no platform {tag}")


def manifest(version: str, wheels: list[pathlib.Path]) -> str:
    """The manifest with what only the wheels know."""
    text = (SOURCE / "blender_manifest.toml").read_text(encoding="utf-8")
    names = sorted({platform(wheel) for wheel in wheels})
    paths = [f"./wheels/{wheel.name}" for wheel in wheels]
    for key, value in (("version", f'"{version}"'), ("platforms", list_of(names)), ("wheels", list_of(paths))):
        text, count = re.subn(rf"(?m)^{key} = .*$", f"{key} = {value}", text)
        assert count == 1, key
    return re.sub(r"(?m)^#.*\n", "", text)


def list_of(words: list[str]) -> str:
    return "[" + ", ".join(f'"{word}"' for word in words) + "]"


def build(out: pathlib.Path, wheels: list[pathlib.Path]) -> pathlib.Path:
    versions = {wheel.name.split("-")[1] for wheel in wheels}
    if len(versions) != 1:
        raise SystemExit(f"wheels must be of one version, not of {', '.join(sorted(versions))}")
    version = versions.pop()
    out.mkdir(parents=True, exist_ok=True)
    path = out / f"medax-{version}.zip"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("blender_manifest.toml", manifest(version, wheels))
        for file in sorted(SOURCE.glob("*.py")):
            archive.write(file, file.name)
        for licence in sorted(SOURCE.parent.parent.parent.glob("LICENSE-*")):
            archive.write(licence, licence.name)
        for wheel in wheels:
            # A wheel is compressed already.
            archive.write(wheel, f"wheels/{wheel.name}", zipfile.ZIP_STORED)
    return path


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--out", type=pathlib.Path, required=True)
    parser.add_argument("wheels", type=pathlib.Path, nargs="+")
    given = parser.parse_args()
    print(build(given.out, given.wheels))
