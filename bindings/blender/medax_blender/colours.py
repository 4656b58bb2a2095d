# SPDX-License-Identifier: MIT OR Apache-2.0
"""Colours of lengths: red where a wall is thin, blue where it is thick, told apart by the colour-blind, too."""

from __future__ import annotations

import numpy as np

#: ColorBrewer's RdYlBu, sRGB.
STOPS = np.array([(165, 0, 38), (244, 109, 67), (254, 224, 144), (171, 217, 233), (69, 117, 180), (49, 54, 149)]) / 255


def linear(srgb: np.ndarray) -> np.ndarray:
    """Scene-linear colours, as float colour attributes hold them."""
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def ends(values: np.ndarray, least: float, most: float) -> tuple[float, float]:
    """What red and blue mean: what is asked for, or where 0 is, all values but the fiftieth at either end."""
    finite = values[np.isfinite(values)]
    low, high = np.quantile(finite, (0.02, 0.98)) if len(finite) else (0.0, 1.0)
    return least or float(low), most or float(high)


def of(values: np.ndarray, least: float, most: float) -> np.ndarray:
    """Linear RGBA of each value; grey where there is none."""
    # Where all are the same, but for rounding, there is no share.
    width = most - least
    flat = abs(width) <= 1e-6 * max(abs(least), abs(most))
    share = np.full(len(values), 0.5) if flat else np.clip((values - least) / width, 0, 1)
    at = np.linspace(0, 1, len(STOPS))
    rgba = np.ones((len(values), 4), np.float32)
    for channel in range(3):
        rgba[:, channel] = linear(np.interp(share, at, STOPS[:, channel]))
    rgba[~np.isfinite(values), :3] = 0.2
    return rgba
