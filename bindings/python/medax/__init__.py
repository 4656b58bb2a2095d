# SPDX-License-Identifier: MIT OR Apache-2.0
"""medax: exact Delaunay and regular triangulations, poles, power crusts, medial axes, flow complexes, pair-meshes.

    import medax
    points = medax.Points(xyz)                       # (n, 3) numbers
    crust = medax.PowerCrust.of(points)              # closed surface, and labels
    crust.surface.write("surface.ply")

- Every class holds one counted reference to an immutable structure. Copies share it, and any thread may use it.
- What a structure has is a property, an array among them: read-only, a view of the library's memory, which it keeps
  alive. What takes an argument, or long, is a method; `complex()` makes what can be drawn or written.
- Everything long takes `job=`, or `progress=`, `threads=`, `memory_ceiling=`; Ctrl-C cancels it.
- What fails raises MedaxError, which has `status`, `message`, `index` and `kind`.
- Lengths are in the units of the input, angles in radians. An enumeration's member may be given by its name.
"""

from __future__ import annotations

from ._explained import explain_methods as _explain_methods
from ._ffi import (
    CellType,
    ChainKind,
    CriticalClass,
    Crossings,
    DecideTest,
    Element,
    ErrorKind,
    Label,
    LabelRule,
    MedialRule,
    Omit,
    PairElement,
    PairReason,
    PieceKind,
    Shape,
    Side,
    Status,
    ValueType,
)
from ._library import lib as _lib
from .error import ArgumentError, MedaxError
from .view import NONE, Rows
from .handle import Handle
from .job import Job, ProgressBar, StageTime, Validation, progress_bar
from .io import Warnings
from .points import Points
from .complex import Attribute, Comparison, Complex, Flattened, Intersections, Measure, Topology
from .file import File
from .triangulation import Incidence, Ring, Triangulation
from .dual import Dual
from .poles import Poles
from .crust import PowerCrust, Simplified, Sizes
from .cocone import Cocone
from .labels import Labels
from .medial import Medial, MedialFilter
from .flow import Core, CoreReport, Flow, Orbits, Simplex
from .flow_complex import FlowComplex
from .pair import HalfFaces, Pair
from .figure import Figure, Normalised
from .distance import (
    AllNearest,
    Claim,
    Decision,
    FieldAxis,
    FieldAxisOptions,
    MedialGraph,
    MedialGraphOptions,
    Piece,
    Sites,
    largest_missed_angle,
)
from .balls import Balls
from .sample import Samples, ShapeFacts, describe
from . import convert

#: The version of the loaded library.
__version__: str = _lib.medax_version_string().decode()

__all__ = [
    "AllNearest",
    "ArgumentError",
    "Attribute",
    "Balls",
    "CellType",
    "ChainKind",
    "Claim",
    "Cocone",
    "Comparison",
    "Complex",
    "Core",
    "CoreReport",
    "CriticalClass",
    "Crossings",
    "DecideTest",
    "Decision",
    "Dual",
    "Element",
    "ErrorKind",
    "FieldAxis",
    "FieldAxisOptions",
    "Figure",
    "File",
    "Flattened",
    "Flow",
    "FlowComplex",
    "HalfFaces",
    "Handle",
    "Incidence",
    "Intersections",
    "Job",
    "Label",
    "LabelRule",
    "Labels",
    "Measure",
    "MedaxError",
    "Medial",
    "MedialFilter",
    "MedialGraph",
    "MedialGraphOptions",
    "MedialRule",
    "NONE",
    "Normalised",
    "Omit",
    "Orbits",
    "Pair",
    "PairElement",
    "PairReason",
    "Piece",
    "PieceKind",
    "Points",
    "Poles",
    "PowerCrust",
    "ProgressBar",
    "Ring",
    "Rows",
    "Samples",
    "Shape",
    "ShapeFacts",
    "Side",
    "Simplex",
    "Simplified",
    "Sites",
    "Sizes",
    "StageTime",
    "Status",
    "Topology",
    "Triangulation",
    "Validation",
    "ValueType",
    "Warnings",
    "convert",
    "describe",
    "largest_missed_angle",
    "progress_bar",
]

# What `**` takes is told where it is taken, of the classes that others inherit from, too.
_explain_methods(
    {
        base
        for kind in list(vars().values())
        if isinstance(kind, type) and issubclass(kind, Handle)
        for base in kind.__mro__
        if base.__module__.startswith(__name__)
    }
)
