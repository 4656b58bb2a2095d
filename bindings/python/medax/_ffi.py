# SPDX-License-Identifier: MIT OR Apache-2.0
# Made by generate.py from include/medax.h: do not edit.
"""What medax.h declares, for ctypes.

Pointers to handles and to sized structs keep their types, so that one cannot be passed for another;
arrays are addresses. Every other name is as in the header; enumerations are classes.
"""

import ctypes

from ._choice import Choice

f64, f32 = ctypes.c_double, ctypes.c_float
u8, u32, i32 = ctypes.c_uint8, ctypes.c_uint32, ctypes.c_int32
u64, i64 = ctypes.c_uint64, ctypes.c_int64
usize, boolean, char = ctypes.c_size_t, ctypes.c_bool, ctypes.c_char
text, address = ctypes.c_char_p, ctypes.c_void_p
P = ctypes.POINTER

VERSION = (0, 1, 0)
NONE = 0xFFFFFFFF


class Status(Choice):
    """What a fallible function returns. 1-19 lie with the caller or the data, 20-39 with the run, 40-59 with files. Numbers are never reused."""

    OK = 0
    NULL_ARGUMENT = 1
    INVALID_ARGUMENT = 2
    NON_FINITE = 3
    COORDINATE_RANGE = 4
    TOO_FEW_POINTS = 5
    DEGENERATE = 6
    MISMATCH = 7
    CANCELLED = 20
    OUT_OF_MEMORY = 21
    LIMIT_EXCEEDED = 22
    BUSY = 23
    IO = 40
    FORMAT = 41
    UNSUPPORTED = 42
    INTERNAL = 99


class ErrorKind(Choice):
    """The kind of the element that an error points at."""

    NONE = 0
    ROW = 1
    LINE = 2
    BYTE = 3
    RING = 4
    FACE = 5
    CELL = 6
    VERTEX = 7
    EDGE = 8
    POLYLINE = 9
    CIRCLE = 10


class Element(Choice):
    """The kinds of elements of a complex."""

    VERTEX = 0
    EDGE = 1
    FACE = 2
    CELL = 3


class ValueType(Choice):
    """The type of an attribute's values."""

    F64 = 0
    U32 = 1


class Omit(Choice):
    """What is left out where the Voronoi cell of a sample is not long and thin: where one of its poles is nearer than the cell's width allows for the spacing `lambda` (section 6 of the paper)."""

    NOTHING = 0
    SIDE = 1
    BOTH = 2


class Label(Choice):
    """The side of the surface on which a pole lies."""

    OUTER = 0
    INNER = 1


class LabelRule(Choice):
    """How poles are labelled."""

    AUTO = 0
    SPREAD = 1
    LEAST_CONFLICT = 2


class MedialRule(Choice):
    """Which of the two conditions of the paper decide whether a facet belongs to the axis."""

    ANGLE_OR_RATIO = 0
    ANGLE = 1
    RATIO = 2
    EVERY = 3


class Side(Choice):
    """The side of the surface on which an axis lies. The first two are those of #medax_label."""

    OUTER = 0
    INNER = 1
    BOTH = 2


class CriticalClass(Choice):
    """Where a critical point belongs."""

    SURFACE = 0
    INNER = 1
    OUTER = 2


class PairElement(Choice):
    """The kinds of elements. (Shaham, Shamir, Cohen-Or 2004, figure 1.)"""

    FACE_VERTEX = 1
    EDGE_EDGE = 2
    VERTEX_FACE = 3


class PairReason(Choice):
    """Why a face or a loose edge of the inner structure is there."""

    ASKED = 0
    ENCLOSED = 1
    UNSEEN = 2


class CellType(Choice):
    """The shape of a volume cell; its vertices are in VTK's order."""

    TETRAHEDRON = 1
    PYRAMID = 2
    POLYGONAL_PYRAMID = 3


class ChainKind(Choice):
    """What a chain of a figure is."""

    OUTER = 0
    HOLE = 1
    POLYLINE = 2
    POINT = 3


class Crossings(Choice):
    """What becomes of curves that cross or touch, and of polygons in the wrong place."""

    REFUSE = 0
    ACCEPT = 1


class PieceKind(Choice):
    """What a piece is."""

    POINT = 0
    SEGMENT = 1
    RAY = 2
    LINE = 3
    TRIANGLE = 4
    SPHERE = 5


class DecideTest(Choice):
    """Which test has found a medial point."""

    NONE = 0
    OPPOSITE = 1
    SIDES = 2
    BETWEEN = 3


class Shape(Choice):
    """A solid of known form."""

    TORUS = 0
    BOX = 1
    CAPSULE = 2
    ELLIPSOID = 3
    TREFOIL = 4
    GENUS3 = 5
    BRACKET = 6
    SPHERE = 7


class medax_all_nearest(ctypes.Structure):
    pass


class medax_balls(ctypes.Structure):
    pass


class medax_cocone(ctypes.Structure):
    pass


class medax_complex(ctypes.Structure):
    pass


class medax_dual(ctypes.Structure):
    pass


class medax_field_axis(ctypes.Structure):
    pass


class medax_figure(ctypes.Structure):
    pass


class medax_file(ctypes.Structure):
    pass


class medax_flattened(ctypes.Structure):
    pass


class medax_flow(ctypes.Structure):
    pass


class medax_flow_complex(ctypes.Structure):
    pass


class medax_half_faces(ctypes.Structure):
    pass


class medax_incidence(ctypes.Structure):
    pass


class medax_intersections(ctypes.Structure):
    pass


class medax_job(ctypes.Structure):
    pass


class medax_labels(ctypes.Structure):
    pass


class medax_medial(ctypes.Structure):
    pass


class medax_medial_graph(ctypes.Structure):
    pass


class medax_pair(ctypes.Structure):
    pass


class medax_points(ctypes.Structure):
    pass


class medax_poles(ctypes.Structure):
    pass


class medax_power_crust(ctypes.Structure):
    pass


class medax_samples(ctypes.Structure):
    pass


class medax_simplified(ctypes.Structure):
    pass


class medax_sites(ctypes.Structure):
    pass


class medax_triangulation(ctypes.Structure):
    pass


class medax_warnings(ctypes.Structure):
    pass


medax_progress_callback = ctypes.CFUNCTYPE(i32, f64, text, address)


class medax_view_f64(ctypes.Structure):
    _fields_ = [
        ("data", address),
        ("rows", usize),
        ("cols", usize),
    ]


class medax_view_u32(ctypes.Structure):
    _fields_ = [
        ("data", address),
        ("rows", usize),
        ("cols", usize),
    ]


class medax_view_u8(ctypes.Structure):
    _fields_ = [
        ("data", address),
        ("rows", usize),
        ("cols", usize),
    ]


class medax_view_rows(ctypes.Structure):
    _fields_ = [
        ("offsets", address),
        ("indices", address),
        ("rows", usize),
    ]


class medax_attribute(ctypes.Structure):
    _fields_ = [
        ("name", text),
        ("element", u32),
        ("value_type", u32),
        ("f64_values", medax_view_f64),
        ("u32_values", medax_view_u32),
    ]


class medax_job_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("memory_ceiling", u64),
        ("threads", u32),
        ("reserved", u32),
        ("progress", medax_progress_callback),
        ("payload", address),
    ]


class medax_validation(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("checked", u64),
        ("problems", u64),
        ("first_index", u64),
        ("first_kind", u32),
        ("reserved", u32),
        ("first_message", char * 256),
    ]


class medax_points_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("skip_non_finite", u32),
        ("reserved", u32),
    ]


class medax_triangulation_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
    ]


class medax_dual_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("facets", u32),
        ("reserved", u32),
    ]


class medax_poles_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("lambda", f64),
        ("omit", u32),
        ("reserved", u32),
    ]


class medax_power_crust_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("deep", f64),
        ("lambda", f64),
        ("round_poles", u32),
        ("keep_shards", u32),
        ("omit", u32),
        ("label_rule", u32),
        ("viewpoint", f64 * 3),
        ("has_viewpoint", u32),
        ("reserved", u32),
    ]


class medax_simplify_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("epsilon", f64),
        ("delta", f64),
    ]


class medax_hole_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("depth", f64),
        ("radius", f64),
    ]


class medax_cocone_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("angle", f64),
        ("ratio", f64),
        ("normal_angle", f64),
    ]


class medax_medial_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("normals", address),
        ("normal_count", usize),
        ("scales", u32),
        ("reserved", u32),
    ]


class medax_medial_filter(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("theta", f64),
        ("rho", f64),
        ("object_angle", f64),
        ("lambda", f64),
        ("scale", f64),
        ("clip_min", f64 * 3),
        ("clip_max", f64 * 3),
        ("has_clip", u32),
        ("rule", u32),
        ("side", u32),
        ("reserved", u32),
    ]


class medax_flow_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("least_slope", f64),
    ]


class medax_simplex(ctypes.Structure):
    _fields_ = [
        ("dimension", u32),
        ("number", u32),
    ]


class medax_flow_point(ctypes.Structure):
    _fields_ = [
        ("simplex", medax_simplex),
        ("driver", f64 * 3),
        ("vector", f64 * 3),
        ("distance", f64),
        ("angle", f64),
    ]


class medax_core_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("side", u32),
        ("repair", u32),
    ]


class medax_core_report(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("taken", u64),
        ("of_surface", u64),
        ("elsewhere", u64),
        ("leaving", u64),
        ("unbounded", u64),
    ]


class medax_flow_element(ctypes.Structure):
    _fields_ = [
        ("kind", u32),
        ("number", u32),
    ]


class medax_pair_onto_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("subdivide", u32),
        ("exact", u32),
    ]


class medax_place(ctypes.Structure):
    _fields_ = [
        ("element", u32),
        ("piece", u32),
        ("weights", f64 * 4),
        ("t", f64),
    ]


class medax_complex_parts(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("vertices", address),
        ("vertex_count", usize),
        ("face_offsets", address),
        ("face_indices", address),
        ("face_count", usize),
        ("edges", address),
        ("edge_count", usize),
        ("cell_offsets", address),
        ("cell_indices", address),
        ("cell_types", address),
        ("cell_count", usize),
        ("attributes", address),
        ("attribute_count", usize),
        ("dimension", u32),
        ("reserved", u32),
    ]


class medax_figure_parts(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("ring_vertices", address),
        ("ring_vertex_count", usize),
        ("ring_offsets", address),
        ("ring_count", usize),
        ("polygon_offsets", address),
        ("polygon_count", usize),
        ("polyline_vertices", address),
        ("polyline_vertex_count", usize),
        ("polyline_offsets", address),
        ("polyline_count", usize),
        ("points", address),
        ("point_count", usize),
        ("circles", address),
        ("circle_count", usize),
        ("crossings", u32),
        ("reserved", u32),
    ]


class medax_figure_read_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("feature_name", text),
        ("feature_number", u32),
        ("crossings", u32),
    ]


class medax_normalised(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("closing_vertices", u64),
        ("repeated_vertices", u64),
        ("turned_rings", u64),
        ("crossings", u64),
        ("misplaced", u64),
    ]


class medax_topology(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("vertices", u64),
        ("isolated_vertices", u64),
        ("edges", u64),
        ("faces", u64),
        ("cells", u64),
        ("components", u64),
        ("euler_characteristic", i64),
        ("boundary_edges", u64),
        ("boundary_loops", u64),
        ("nonmanifold_edges", u64),
        ("nonmanifold_vertices", u64),
        ("genus", u64),
        ("betti", u64 * 3),
        ("has_genus", u32),
        ("closed", u32),
        ("oriented", u32),
        ("reserved", u32),
    ]


class medax_compare_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("samples", u64),
        ("seed", u64),
    ]


class medax_comparison(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("a_to_b_max", f64),
        ("a_to_b_mean", f64),
        ("a_to_b_rms", f64),
        ("b_to_a_max", f64),
        ("b_to_a_mean", f64),
        ("b_to_a_rms", f64),
        ("diagonal", f64),
    ]


class medax_decimate_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("triangles", u64),
        ("max_error", f64),
    ]


class medax_flatten_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("flatness", f64),
    ]


class medax_piece(ctypes.Structure):
    _fields_ = [
        ("kind", u32),
        ("site", u32),
        ("numbers", f64 * 9),
    ]


class medax_nearest(ctypes.Structure):
    _fields_ = [
        ("point", f64 * 3),
        ("distance", f64),
        ("direction", f64 * 3),
        ("piece", u32),
        ("site", u32),
    ]


class medax_decide_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("tolerance", f64),
        ("epsilon", f64),
    ]


class medax_decision(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("center", f64 * 3),
        ("radius", f64),
        ("object_angle", f64),
        ("feet", f64 * 6),
        ("gap", f64),
        ("theta_count", u64),
        ("unconfirmed", u64),
        ("pieces", u32 * 2),
        ("test", u32),
        ("reserved", u32),
    ]


class medax_field_axis_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("density", f64),
        ("object_angle", f64),
        ("min_distance", f64),
        ("bound", f64),
        ("tolerance", f64),
        ("epsilon", f64),
        ("clip_min", f64 * 3),
        ("clip_max", f64 * 3),
        ("has_clip", u32),
        ("side", u32),
        ("samples", u32),
        ("between_sites", u32),
    ]


class medax_cover(ctypes.Structure):
    _fields_ = [
        ("center", f64 * 3),
        ("radius", f64),
        ("half", f64),
        ("gap", f64),
        ("distance", f64),
        ("missed_angle", f64),
        ("found", u32),
        ("reserved", u32),
    ]


class medax_medial_graph_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("spacing", f64),
        ("object_angle", f64),
        ("min_distance", f64),
        ("clip_min", f64 * 3),
        ("clip_max", f64 * 3),
        ("has_clip", u32),
        ("side", u32),
        ("between_sites", u32),
        ("reserved", u32),
    ]


class medax_boundary_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("spacing", f64),
    ]


class medax_write_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("text", u32),
        ("reserved", u32),
    ]


class medax_shape_facts(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("min", f64 * 3),
        ("max", f64 * 3),
        ("spacing", f64),
        ("genus", u32),
        ("components", u32),
        ("smooth", u32),
        ("reserved", u32),
    ]


class medax_sample_options(ctypes.Structure):
    _fields_ = [
        ("struct_size", usize),
        ("spacing", f64),
        ("density", f64),
        ("noise", f64),
        ("seed", u64),
    ]


FUNCTIONS = {
    "medax_version": (u32, ()),
    "medax_version_string": (text, ()),
    "medax_status_name": (text, (i32,)),
    "medax_last_error_message": (text, ()),
    "medax_last_error_kind": (u32, ()),
    "medax_last_error_index": (u64, ()),
    "medax_job_options_init": (i32, (P(medax_job_options), usize)),
    "medax_job_create": (i32, (P(medax_job_options), P(P(medax_job)))),
    "medax_job_cancel": (None, (P(medax_job),)),
    "medax_job_is_cancelled": (boolean, (P(medax_job),)),
    "medax_job_progress": (f64, (P(medax_job),)),
    "medax_job_stage": (text, (P(medax_job),)),
    "medax_job_memory_peak": (u64, (P(medax_job),)),
    "medax_job_stage_count": (usize, (P(medax_job),)),
    "medax_job_stage_time": (i32, (P(medax_job), usize, address, address, address)),
    "medax_job_clone": (P(medax_job), (P(medax_job),)),
    "medax_job_free": (None, (P(medax_job),)),
    "medax_points_options_init": (i32, (P(medax_points_options), usize)),
    "medax_points_create_f64": (i32, (address, usize, usize, P(medax_points_options), P(medax_job), P(P(medax_points)))),
    "medax_points_create_f32": (i32, (address, usize, usize, P(medax_points_options), P(medax_job), P(P(medax_points)))),
    "medax_points_coords": (medax_view_f64, (P(medax_points),)),
    "medax_points_vertex_of_row": (medax_view_u32, (P(medax_points),)),
    "medax_points_row_of_vertex": (medax_view_u32, (P(medax_points),)),
    "medax_points_duplicate_of": (medax_view_u32, (P(medax_points),)),
    "medax_points_count": (usize, (P(medax_points),)),
    "medax_points_row_count": (usize, (P(medax_points),)),
    "medax_points_duplicate_count": (usize, (P(medax_points),)),
    "medax_points_skipped_count": (usize, (P(medax_points),)),
    "medax_points_bounds": (i32, (P(medax_points), address, address)),
    "medax_points_clone": (P(medax_points), (P(medax_points),)),
    "medax_points_free": (None, (P(medax_points),)),
    "medax_triangulation_options_init": (i32, (P(medax_triangulation_options), usize)),
    "medax_delaunay_build": (i32, (P(medax_points), P(medax_triangulation_options), P(medax_job), P(P(medax_triangulation)))),
    "medax_regular_build": (i32, (P(medax_points), address, usize, P(medax_triangulation_options), P(medax_job), P(P(medax_triangulation)))),
    "medax_triangulation_points": (i32, (P(medax_triangulation), P(P(medax_points)))),
    "medax_triangulation_coords": (medax_view_f64, (P(medax_triangulation),)),
    "medax_triangulation_weights": (medax_view_f64, (P(medax_triangulation),)),
    "medax_triangulation_row_of_vertex": (medax_view_u32, (P(medax_triangulation),)),
    "medax_triangulation_cells": (medax_view_u32, (P(medax_triangulation),)),
    "medax_triangulation_neighbors": (medax_view_u32, (P(medax_triangulation),)),
    "medax_triangulation_hidden": (medax_view_u32, (P(medax_triangulation),)),
    "medax_triangulation_locate": (i32, (P(medax_triangulation), address, u32, address)),
    "medax_triangulation_ring": (i32, (P(medax_triangulation), u32, u32, u32, usize, address, address, address)),
    "medax_triangulation_complex": (i32, (P(medax_triangulation), P(P(medax_complex)))),
    "medax_triangulation_validate": (i32, (P(medax_triangulation), P(medax_job), P(medax_validation))),
    "medax_triangulation_clone": (P(medax_triangulation), (P(medax_triangulation),)),
    "medax_triangulation_free": (None, (P(medax_triangulation),)),
    "medax_incidence_build": (i32, (P(medax_triangulation), P(medax_job), P(P(medax_incidence)))),
    "medax_incidence_cells_of_vertex": (medax_view_rows, (P(medax_incidence),)),
    "medax_incidence_edges": (medax_view_u32, (P(medax_incidence),)),
    "medax_incidence_cell_of_edge": (medax_view_u32, (P(medax_incidence),)),
    "medax_incidence_clone": (P(medax_incidence), (P(medax_incidence),)),
    "medax_incidence_free": (None, (P(medax_incidence),)),
    "medax_dual_options_init": (i32, (P(medax_dual_options), usize)),
    "medax_dual_build": (i32, (P(medax_triangulation), P(medax_dual_options), P(medax_job), P(P(medax_dual)))),
    "medax_dual_triangulation": (i32, (P(medax_dual), P(P(medax_triangulation)))),
    "medax_dual_centers": (medax_view_f64, (P(medax_dual),)),
    "medax_dual_radii_squared": (medax_view_f64, (P(medax_dual),)),
    "medax_dual_ray_facets": (medax_view_u32, (P(medax_dual),)),
    "medax_dual_ray_directions": (medax_view_f64, (P(medax_dual),)),
    "medax_dual_facets": (medax_view_rows, (P(medax_dual),)),
    "medax_dual_facet_edges": (medax_view_u32, (P(medax_dual),)),
    "medax_dual_facet_rays": (medax_view_u32, (P(medax_dual),)),
    "medax_dual_validate": (i32, (P(medax_dual), P(medax_job), P(medax_validation))),
    "medax_dual_clone": (P(medax_dual), (P(medax_dual),)),
    "medax_dual_free": (None, (P(medax_dual),)),
    "medax_poles_options_init": (i32, (P(medax_poles_options), usize)),
    "medax_poles_build": (i32, (P(medax_dual), P(medax_poles_options), P(medax_job), P(P(medax_poles)))),
    "medax_poles_build_with_far_box": (i32, (P(medax_points), P(medax_poles_options), P(medax_job), P(P(medax_poles)))),
    "medax_poles_triangulation": (i32, (P(medax_poles), P(P(medax_triangulation)))),
    "medax_poles_has_far_box": (boolean, (P(medax_poles),)),
    "medax_poles_balls": (medax_view_f64, (P(medax_poles),)),
    "medax_poles_radii_squared": (medax_view_f64, (P(medax_poles),)),
    "medax_poles_cell_of_pole": (medax_view_u32, (P(medax_poles),)),
    "medax_poles_touches_far_box": (medax_view_u8, (P(medax_poles),)),
    "medax_poles_pole_of_sample": (medax_view_u32, (P(medax_poles),)),
    "medax_poles_samples_on_balls": (medax_view_rows, (P(medax_poles),)),
    "medax_poles_object_angles": (medax_view_f64, (P(medax_poles),)),
    "medax_poles_lambda": (f64, (P(medax_poles),)),
    "medax_poles_normals": (medax_view_f64, (P(medax_poles),)),
    "medax_poles_feature_size": (i32, (P(medax_poles), address, usize, P(medax_job), address)),
    "medax_poles_complex": (i32, (P(medax_poles), P(P(medax_complex)))),
    "medax_poles_samples_complex": (i32, (P(medax_poles), P(P(medax_complex)))),
    "medax_poles_validate": (i32, (P(medax_poles), P(medax_job), P(medax_validation))),
    "medax_poles_clone": (P(medax_poles), (P(medax_poles),)),
    "medax_poles_free": (None, (P(medax_poles),)),
    "medax_power_crust_options_init": (i32, (P(medax_power_crust_options), usize)),
    "medax_power_crust_build": (i32, (P(medax_points), P(medax_power_crust_options), P(medax_job), P(P(medax_power_crust)))),
    "medax_power_crust_build_from_poles": (i32, (P(medax_poles), P(medax_power_crust_options), P(medax_job), P(P(medax_power_crust)))),
    "medax_power_crust_surface": (i32, (P(medax_power_crust), P(P(medax_complex)))),
    "medax_power_crust_shape": (i32, (P(medax_power_crust), u32, P(P(medax_complex)))),
    "medax_power_crust_poles": (i32, (P(medax_power_crust), P(P(medax_poles)))),
    "medax_power_crust_regular": (i32, (P(medax_power_crust), P(P(medax_triangulation)))),
    "medax_power_crust_labels": (medax_view_u32, (P(medax_power_crust),)),
    "medax_power_crust_poles_complex": (i32, (P(medax_power_crust), P(P(medax_complex)))),
    "medax_power_crust_both_shapes": (i32, (P(medax_power_crust), P(P(medax_complex)))),
    "medax_power_crust_is_visible": (boolean, (P(medax_power_crust), u32)),
    "medax_power_crust_unreached_count": (usize, (P(medax_power_crust),)),
    "medax_power_crust_forced_count": (usize, (P(medax_power_crust),)),
    "medax_power_crust_conflict": (f64, (P(medax_power_crust),)),
    "medax_power_crust_is_settled": (boolean, (P(medax_power_crust),)),
    "medax_power_crust_validate": (i32, (P(medax_power_crust), P(medax_job), P(medax_validation))),
    "medax_power_crust_clone": (P(medax_power_crust), (P(medax_power_crust),)),
    "medax_power_crust_free": (None, (P(medax_power_crust),)),
    "medax_power_crust_with_labels": (i32, (P(medax_power_crust), address, usize, P(medax_job), P(P(medax_power_crust)))),
    "medax_power_crust_labelled_by_mesh": (i32, (P(medax_power_crust), P(medax_complex), P(medax_job), P(P(medax_power_crust)))),
    "medax_power_crust_offset": (i32, (P(medax_power_crust), f64, P(medax_job), P(P(medax_power_crust)))),
    "medax_power_crust_scale_axis": (i32, (P(medax_power_crust), u32, f64, P(medax_job), P(P(medax_complex)))),
    "medax_simplify_options_init": (i32, (P(medax_simplify_options), usize)),
    "medax_power_crust_simplify": (i32, (P(medax_power_crust), P(medax_simplify_options), P(medax_job), P(P(medax_simplified)))),
    "medax_simplified_crust": (i32, (P(medax_simplified), P(P(medax_power_crust)))),
    "medax_simplified_epsilon": (f64, (P(medax_simplified),)),
    "medax_simplified_delta": (f64, (P(medax_simplified),)),
    "medax_simplified_unstable": (medax_view_u32, (P(medax_simplified),)),
    "medax_simplified_redundant": (medax_view_u32, (P(medax_simplified),)),
    "medax_simplified_clone": (P(medax_simplified), (P(medax_simplified),)),
    "medax_simplified_free": (None, (P(medax_simplified),)),
    "medax_hole_options_init": (i32, (P(medax_hole_options), usize)),
    "medax_power_crust_open": (i32, (P(medax_power_crust), P(medax_hole_options), P(medax_job), P(P(medax_complex)), P(P(medax_complex)))),
    "medax_power_crust_sizes_at": (i32, (P(medax_power_crust), address, usize, P(medax_job), address, address)),
    "medax_power_crust_samples_complex": (i32, (P(medax_power_crust), P(medax_job), P(P(medax_complex)))),
    "medax_power_crust_with_sizes": (i32, (P(medax_power_crust), P(medax_complex), P(medax_job), P(P(medax_complex)))),
    "medax_cocone_options_init": (i32, (P(medax_cocone_options), usize)),
    "medax_cocone_build": (i32, (P(medax_dual), P(medax_cocone_options), P(medax_job), P(P(medax_cocone)))),
    "medax_cocone_surface": (i32, (P(medax_cocone), P(P(medax_complex)))),
    "medax_cocone_open_surface": (i32, (P(medax_cocone), P(P(medax_complex)))),
    "medax_cocone_is_inner": (medax_view_u8, (P(medax_cocone),)),
    "medax_cocone_is_undersampled": (medax_view_u8, (P(medax_cocone),)),
    "medax_cocone_is_well_sampled": (medax_view_u8, (P(medax_cocone),)),
    "medax_cocone_marked_count": (usize, (P(medax_cocone),)),
    "medax_cocone_used_count": (usize, (P(medax_cocone),)),
    "medax_cocone_validate": (i32, (P(medax_cocone), P(medax_job), P(medax_validation))),
    "medax_cocone_clone": (P(medax_cocone), (P(medax_cocone),)),
    "medax_cocone_free": (None, (P(medax_cocone),)),
    "medax_labels_create": (i32, (P(medax_triangulation), address, usize, P(P(medax_labels)))),
    "medax_labels_of_cocone": (i32, (P(medax_cocone), P(medax_job), P(P(medax_labels)))),
    "medax_labels_of_crust": (i32, (P(medax_dual), P(medax_power_crust), P(medax_job), P(P(medax_labels)))),
    "medax_labels_of_mesh": (i32, (P(medax_dual), P(medax_complex), P(medax_job), P(P(medax_labels)))),
    "medax_labels_triangulation": (i32, (P(medax_labels), P(P(medax_triangulation)))),
    "medax_labels_is_inner": (medax_view_u8, (P(medax_labels),)),
    "medax_labels_inner_count": (usize, (P(medax_labels),)),
    "medax_labels_disagreement": (i32, (P(medax_labels), P(medax_labels), address)),
    "medax_labels_clone": (P(medax_labels), (P(medax_labels),)),
    "medax_labels_free": (None, (P(medax_labels),)),
    "medax_medial_options_init": (i32, (P(medax_medial_options), usize)),
    "medax_medial_filter_init": (i32, (P(medax_medial_filter), usize)),
    "medax_medial_build": (i32, (P(medax_dual), P(medax_labels), P(medax_medial_options), P(medax_job), P(P(medax_medial)))),
    "medax_medial_axis": (i32, (P(medax_medial), P(medax_medial_filter), P(medax_job), P(P(medax_complex)))),
    "medax_medial_selected": (i32, (P(medax_medial), P(medax_medial_filter), P(medax_job), usize, address, address)),
    "medax_medial_dual": (i32, (P(medax_medial), P(P(medax_dual)))),
    "medax_medial_labels": (i32, (P(medax_medial), P(P(medax_labels)))),
    "medax_medial_sines": (medax_view_f64, (P(medax_medial),)),
    "medax_medial_ratios": (medax_view_f64, (P(medax_medial),)),
    "medax_medial_reaches": (medax_view_f64, (P(medax_medial),)),
    "medax_medial_least_cell": (medax_view_u32, (P(medax_medial),)),
    "medax_medial_scales": (medax_view_f64, (P(medax_medial),)),
    "medax_medial_umbrella_offsets": (medax_view_u32, (P(medax_medial),)),
    "medax_medial_umbrella_rims": (medax_view_u32, (P(medax_medial),)),
    "medax_medial_umbrella_is_disk": (medax_view_u8, (P(medax_medial),)),
    "medax_medial_torn_count": (usize, (P(medax_medial),)),
    "medax_medial_validate": (i32, (P(medax_medial), P(medax_job), P(medax_validation))),
    "medax_medial_clone": (P(medax_medial), (P(medax_medial),)),
    "medax_medial_free": (None, (P(medax_medial),)),
    "medax_flow_options_init": (i32, (P(medax_flow_options), usize)),
    "medax_flow_build": (i32, (P(medax_dual), P(medax_labels), P(medax_flow_options), P(medax_job), P(P(medax_flow)))),
    "medax_flow_dual": (i32, (P(medax_flow), P(P(medax_dual)))),
    "medax_flow_labels": (i32, (P(medax_flow), P(P(medax_labels)))),
    "medax_flow_critical_count": (usize, (P(medax_flow),)),
    "medax_flow_critical_simplices": (medax_view_u32, (P(medax_flow),)),
    "medax_flow_critical_points": (medax_view_f64, (P(medax_flow),)),
    "medax_flow_critical_distances": (medax_view_f64, (P(medax_flow),)),
    "medax_flow_critical_corners": (medax_view_u32, (P(medax_flow),)),
    "medax_flow_critical_slopes": (medax_view_f64, (P(medax_flow),)),
    "medax_flow_critical_shares": (medax_view_f64, (P(medax_flow),)),
    "medax_flow_critical_classes": (medax_view_u32, (P(medax_flow),)),
    "medax_flow_critical_row": (u32, (P(medax_flow), medax_simplex)),
    "medax_flow_gap": (i32, (P(medax_flow), address)),
    "medax_flow_critical_complex": (i32, (P(medax_flow), P(medax_job), P(P(medax_complex)))),
    "medax_flow_triangles": (medax_view_u32, (P(medax_flow),)),
    "medax_flow_driver_of_triangle": (medax_simplex, (P(medax_flow), u32)),
    "medax_flow_driver_of_cell": (medax_simplex, (P(medax_flow), u32)),
    "medax_flow_at": (i32, (P(medax_flow), address, usize, P(medax_job), address)),
    "medax_flow_orbits": (i32, (P(medax_flow), address, usize, P(medax_job), address, P(P(medax_complex)))),
    "medax_flow_closure": (i32, (P(medax_flow), address, usize, P(medax_job), P(P(medax_complex)))),
    "medax_flow_validate": (i32, (P(medax_flow), P(medax_job), P(medax_validation))),
    "medax_flow_clone": (P(medax_flow), (P(medax_flow),)),
    "medax_flow_free": (None, (P(medax_flow),)),
    "medax_core_options_init": (i32, (P(medax_core_options), usize)),
    "medax_flow_core": (i32, (P(medax_flow), address, usize, P(medax_core_options), P(medax_job), P(medax_core_report), P(P(medax_complex)))),
    "medax_flow_complex_build": (i32, (P(medax_flow), P(medax_job), P(P(medax_flow_complex)))),
    "medax_flow_complex_flow": (i32, (P(medax_flow_complex), P(P(medax_flow)))),
    "medax_flow_complex_vertex_count": (usize, (P(medax_flow_complex),)),
    "medax_flow_complex_points": (medax_view_f64, (P(medax_flow_complex),)),
    "medax_flow_complex_triangle_of_point": (medax_view_u32, (P(medax_flow_complex),)),
    "medax_flow_complex_edges": (medax_view_u32, (P(medax_flow_complex),)),
    "medax_flow_complex_triangle_of_edge": (medax_view_u32, (P(medax_flow_complex),)),
    "medax_flow_complex_faces": (medax_view_rows, (P(medax_flow_complex),)),
    "medax_flow_complex_face_edges": (medax_view_rows, (P(medax_flow_complex),)),
    "medax_flow_complex_faces_of_facet": (medax_view_u32, (P(medax_flow_complex),)),
    "medax_flow_complex_edge_of_vertex": (medax_view_u32, (P(medax_flow_complex),)),
    "medax_flow_complex_face_of_edge": (medax_view_u32, (P(medax_flow_complex),)),
    "medax_flow_complex_elements_of": (i32, (P(medax_flow_complex), medax_simplex, usize, address, address)),
    "medax_flow_complex_closure": (i32, (P(medax_flow_complex), address, usize, P(medax_job), usize, address, address)),
    "medax_flow_complex_upstream": (i32, (P(medax_flow_complex), address, usize, P(medax_job), usize, address, address)),
    "medax_flow_complex_critical_sets": (i32, (P(medax_flow_complex), address, usize, P(medax_job), address, usize, address, address)),
    "medax_flow_complex_complex": (i32, (P(medax_flow_complex), P(medax_job), P(P(medax_complex)))),
    "medax_flow_complex_validate": (i32, (P(medax_flow_complex), P(medax_job), P(medax_validation))),
    "medax_flow_complex_clone": (P(medax_flow_complex), (P(medax_flow_complex),)),
    "medax_flow_complex_free": (None, (P(medax_flow_complex),)),
    "medax_pair_voronoi": (i32, (P(medax_dual), P(medax_labels), P(medax_job), P(P(medax_pair)))),
    "medax_pair_element_count": (usize, (P(medax_pair), u32)),
    "medax_pair_boundary_vertices": (medax_view_f64, (P(medax_pair),)),
    "medax_pair_boundary_samples": (medax_view_u32, (P(medax_pair),)),
    "medax_pair_inner_vertices": (medax_view_f64, (P(medax_pair),)),
    "medax_pair_inner_cells": (medax_view_u32, (P(medax_pair),)),
    "medax_pair_voronoi_vertices": (medax_view_f64, (P(medax_pair),)),
    "medax_pair_inner_faces": (medax_view_rows, (P(medax_pair),)),
    "medax_pair_nodes": (medax_view_u32, (P(medax_pair),)),
    "medax_pair_rings": (medax_view_rows, (P(medax_pair),)),
    "medax_pair_removed": (medax_view_u32, (P(medax_pair),)),
    "medax_pair_enclosed_volume": (f64, (P(medax_pair),)),
    "medax_pair_volumes": (i32, (P(medax_pair), P(medax_job), address)),
    "medax_pair_centroids": (i32, (P(medax_pair), P(medax_job), address)),
    "medax_pair_shells": (i32, (P(medax_pair), P(medax_job), address)),
    "medax_pair_folded": (i32, (P(medax_pair), P(medax_job), address, address)),
    "medax_pair_iso_surface": (i32, (P(medax_pair), f64, P(medax_job), P(P(medax_complex)))),
    "medax_pair_solid": (i32, (P(medax_pair), P(medax_job), P(P(medax_complex)))),
    "medax_pair_boundary": (i32, (P(medax_pair), P(medax_job), P(P(medax_complex)))),
    "medax_pair_inner": (i32, (P(medax_pair), P(medax_job), P(P(medax_complex)))),
    "medax_pair_validate": (i32, (P(medax_pair), P(medax_job), P(medax_validation))),
    "medax_pair_clone": (P(medax_pair), (P(medax_pair),)),
    "medax_pair_free": (None, (P(medax_pair),)),
    "medax_pair_onto_options_init": (i32, (P(medax_pair_onto_options), usize)),
    "medax_pair_onto": (i32, (P(medax_pair), P(medax_complex), P(medax_pair_onto_options), P(medax_job), P(P(medax_pair)))),
    "medax_pair_missing": (usize, (P(medax_pair),)),
    "medax_pair_reasons": (i32, (P(medax_pair), address)),
    "medax_pair_locate": (i32, (P(medax_pair), address, usize, P(medax_job), address)),
    "medax_pair_positions": (i32, (P(medax_pair), address, usize, address)),
    "medax_pair_piece": (i32, (P(medax_pair), u32, u32, address)),
    "medax_pair_with_inner": (i32, (P(medax_pair), address, usize, P(medax_job), P(P(medax_pair)))),
    "medax_pair_with_boundary": (i32, (P(medax_pair), address, usize, P(medax_job), P(P(medax_pair)))),
    "medax_half_faces_build": (i32, (P(medax_pair), P(medax_job), P(P(medax_half_faces)))),
    "medax_half_faces_of_element": (medax_view_u32, (P(medax_half_faces),)),
    "medax_half_faces_offsets": (medax_view_u32, (P(medax_half_faces),)),
    "medax_half_faces_duals": (medax_view_u32, (P(medax_half_faces),)),
    "medax_half_faces_origins": (medax_view_u32, (P(medax_half_faces),)),
    "medax_half_faces_opposites": (medax_view_u32, (P(medax_half_faces),)),
    "medax_half_faces_partners": (medax_view_u32, (P(medax_half_faces),)),
    "medax_half_faces_clone": (P(medax_half_faces), (P(medax_half_faces),)),
    "medax_half_faces_free": (None, (P(medax_half_faces),)),
    "medax_complex_parts_init": (i32, (P(medax_complex_parts), usize)),
    "medax_complex_create": (i32, (P(medax_complex_parts), P(P(medax_complex)))),
    "medax_complex_dimension": (u32, (P(medax_complex),)),
    "medax_complex_vertices": (medax_view_f64, (P(medax_complex),)),
    "medax_complex_faces": (medax_view_rows, (P(medax_complex),)),
    "medax_complex_edges": (medax_view_u32, (P(medax_complex),)),
    "medax_complex_cells": (medax_view_rows, (P(medax_complex),)),
    "medax_complex_cell_types": (medax_view_u32, (P(medax_complex),)),
    "medax_complex_triangles": (medax_view_u32, (P(medax_complex),)),
    "medax_complex_face_of_triangle": (medax_view_u32, (P(medax_complex),)),
    "medax_complex_attribute_count": (usize, (P(medax_complex),)),
    "medax_complex_attribute_at": (i32, (P(medax_complex), usize, address)),
    "medax_complex_attribute": (i32, (P(medax_complex), u32, text, address)),
    "medax_complex_clone": (P(medax_complex), (P(medax_complex),)),
    "medax_complex_free": (None, (P(medax_complex),)),
    "medax_figure_parts_init": (i32, (P(medax_figure_parts), usize)),
    "medax_figure_create": (i32, (P(medax_figure_parts), P(medax_job), P(P(medax_figure)))),
    "medax_figure_read_options_init": (i32, (P(medax_figure_read_options), usize)),
    "medax_figure_read": (i32, (text, P(medax_figure_read_options), P(medax_job), P(P(medax_figure)))),
    "medax_figure_vertices": (medax_view_f64, (P(medax_figure),)),
    "medax_figure_chains": (medax_view_rows, (P(medax_figure),)),
    "medax_figure_kinds": (medax_view_u32, (P(medax_figure),)),
    "medax_figure_parts_of_chains": (medax_view_u32, (P(medax_figure),)),
    "medax_figure_circles": (medax_view_f64, (P(medax_figure),)),
    "medax_figure_part_count": (usize, (P(medax_figure),)),
    "medax_figure_bounds": (i32, (P(medax_figure), address, address)),
    "medax_figure_normalised": (i32, (P(medax_figure), P(medax_normalised))),
    "medax_figure_validate": (i32, (P(medax_figure), P(medax_job), P(medax_validation))),
    "medax_figure_clone": (P(medax_figure), (P(medax_figure),)),
    "medax_figure_free": (None, (P(medax_figure),)),
    "medax_complex_topology": (i32, (P(medax_complex), P(medax_job), P(medax_topology))),
    "medax_complex_measure": (i32, (P(medax_complex), P(medax_job), address, address)),
    "medax_complex_self_intersections": (i32, (P(medax_complex), P(medax_job), P(P(medax_intersections)))),
    "medax_intersections_pairs": (medax_view_u32, (P(medax_intersections),)),
    "medax_intersections_clone": (P(medax_intersections), (P(medax_intersections),)),
    "medax_intersections_free": (None, (P(medax_intersections),)),
    "medax_complex_orient": (i32, (P(medax_complex), P(medax_job), P(P(medax_complex)))),
    "medax_complex_validate": (i32, (P(medax_complex), P(medax_job), P(medax_validation))),
    "medax_complex_winding_numbers": (i32, (P(medax_complex), address, usize, P(medax_job), address)),
    "medax_complex_vertex_normals": (i32, (P(medax_complex), P(medax_job), usize, address)),
    "medax_compare_options_init": (i32, (P(medax_compare_options), usize)),
    "medax_complex_compare": (i32, (P(medax_complex), P(medax_complex), P(medax_compare_options), P(medax_job), P(medax_comparison))),
    "medax_decimate_options_init": (i32, (P(medax_decimate_options), usize)),
    "medax_complex_decimate": (i32, (P(medax_complex), P(medax_decimate_options), P(medax_job), P(P(medax_complex)))),
    "medax_flatten_options_init": (i32, (P(medax_flatten_options), usize)),
    "medax_complex_flatten": (i32, (P(medax_complex), P(medax_flatten_options), P(medax_job), P(P(medax_flattened)))),
    "medax_flattened_complex": (i32, (P(medax_flattened), P(P(medax_complex)))),
    "medax_flattened_collapses": (medax_view_u32, (P(medax_flattened),)),
    "medax_flattened_left_count": (usize, (P(medax_flattened),)),
    "medax_flattened_clone": (P(medax_flattened), (P(medax_flattened),)),
    "medax_flattened_free": (None, (P(medax_flattened),)),
    "medax_sites_create": (i32, (u32, address, usize, address, usize, P(medax_job), P(P(medax_sites)))),
    "medax_sites_of_figure": (i32, (P(medax_figure), P(medax_job), P(P(medax_sites)))),
    "medax_sites_of_complex": (i32, (P(medax_complex), address, usize, P(medax_job), P(P(medax_sites)))),
    "medax_sites_of_components": (i32, (P(medax_complex), address, usize, P(medax_job), P(P(medax_sites)))),
    "medax_sites_dimension": (u32, (P(medax_sites),)),
    "medax_sites_piece_count": (usize, (P(medax_sites),)),
    "medax_sites_pieces": (i32, (P(medax_sites), usize, usize, address)),
    "medax_sites_site_of_piece": (medax_view_u32, (P(medax_sites),)),
    "medax_sites_site_count": (usize, (P(medax_sites),)),
    "medax_sites_bounds": (i32, (P(medax_sites), address, address)),
    "medax_sites_size": (f64, (P(medax_sites),)),
    "medax_sites_clone": (P(medax_sites), (P(medax_sites),)),
    "medax_sites_free": (None, (P(medax_sites),)),
    "medax_sites_nearest": (i32, (P(medax_sites), address, usize, P(medax_job), address)),
    "medax_sites_is_inside": (i32, (P(medax_sites), address, usize, P(medax_job), address)),
    "medax_sites_all_nearest": (i32, (P(medax_sites), address, usize, f64, P(medax_job), P(P(medax_all_nearest)))),
    "medax_all_nearest_pieces": (medax_view_rows, (P(medax_all_nearest),)),
    "medax_all_nearest_sites": (medax_view_u32, (P(medax_all_nearest),)),
    "medax_all_nearest_points": (medax_view_f64, (P(medax_all_nearest),)),
    "medax_all_nearest_distances": (medax_view_f64, (P(medax_all_nearest),)),
    "medax_all_nearest_directions": (medax_view_f64, (P(medax_all_nearest),)),
    "medax_all_nearest_clone": (P(medax_all_nearest), (P(medax_all_nearest),)),
    "medax_all_nearest_free": (None, (P(medax_all_nearest),)),
    "medax_decide_options_init": (i32, (P(medax_decide_options), usize)),
    "medax_sites_decide": (i32, (P(medax_sites), address, f64, address, usize, P(medax_decide_options), P(medax_job), usize, address, P(medax_decision))),
    "medax_sites_even_directions": (i32, (P(medax_sites), usize, address)),
    "medax_largest_missed_angle": (f64, (f64, f64, f64)),
    "medax_field_axis_options_init": (i32, (P(medax_field_axis_options), usize)),
    "medax_field_axis_build": (i32, (P(medax_sites), P(medax_field_axis_options), P(medax_job), P(P(medax_field_axis)))),
    "medax_field_axis_between": (i32, (P(medax_sites), address, usize, P(medax_field_axis_options), P(medax_job), P(P(medax_field_axis)))),
    "medax_field_axis_sites": (i32, (P(medax_field_axis), P(P(medax_sites)))),
    "medax_field_axis_resolved": (i32, (P(medax_field_axis), P(medax_field_axis_options))),
    "medax_field_axis_points": (medax_view_f64, (P(medax_field_axis),)),
    "medax_field_axis_radii": (medax_view_f64, (P(medax_field_axis),)),
    "medax_field_axis_object_angles": (medax_view_f64, (P(medax_field_axis),)),
    "medax_field_axis_feet": (medax_view_f64, (P(medax_field_axis),)),
    "medax_field_axis_pieces": (medax_view_u32, (P(medax_field_axis),)),
    "medax_field_axis_sites_of_points": (medax_view_u32, (P(medax_field_axis),)),
    "medax_field_axis_cover_of_point": (medax_view_u32, (P(medax_field_axis),)),
    "medax_field_axis_cover_count": (usize, (P(medax_field_axis),)),
    "medax_field_axis_covers": (i32, (P(medax_field_axis), usize, usize, address)),
    "medax_field_axis_claim": (i32, (P(medax_field_axis), address, address)),
    "medax_field_axis_unconfirmed": (usize, (P(medax_field_axis),)),
    "medax_field_axis_complex": (i32, (P(medax_field_axis), P(medax_job), P(P(medax_complex)))),
    "medax_field_axis_surface": (i32, (P(medax_field_axis), P(medax_job), P(P(medax_complex)))),
    "medax_field_axis_validate": (i32, (P(medax_field_axis), P(medax_job), P(medax_validation))),
    "medax_field_axis_clone": (P(medax_field_axis), (P(medax_field_axis),)),
    "medax_field_axis_free": (None, (P(medax_field_axis),)),
    "medax_medial_graph_options_init": (i32, (P(medax_medial_graph_options), usize)),
    "medax_medial_graph_build": (i32, (P(medax_sites), P(medax_medial_graph_options), P(medax_job), P(P(medax_medial_graph)))),
    "medax_medial_graph_between": (i32, (P(medax_sites), address, usize, P(medax_medial_graph_options), P(medax_job), P(P(medax_medial_graph)))),
    "medax_medial_graph_sites": (i32, (P(medax_medial_graph), P(P(medax_sites)))),
    "medax_medial_graph_node_count": (usize, (P(medax_medial_graph),)),
    "medax_medial_graph_arcs": (medax_view_rows, (P(medax_medial_graph),)),
    "medax_medial_graph_torn": (usize, (P(medax_medial_graph),)),
    "medax_medial_graph_points": (medax_view_f64, (P(medax_medial_graph),)),
    "medax_medial_graph_radii": (medax_view_f64, (P(medax_medial_graph),)),
    "medax_medial_graph_object_angles": (medax_view_f64, (P(medax_medial_graph),)),
    "medax_medial_graph_feet": (medax_view_f64, (P(medax_medial_graph),)),
    "medax_medial_graph_pieces": (medax_view_u32, (P(medax_medial_graph),)),
    "medax_medial_graph_sites_of_points": (medax_view_u32, (P(medax_medial_graph),)),
    "medax_medial_graph_complex": (i32, (P(medax_medial_graph), P(medax_job), P(P(medax_complex)))),
    "medax_medial_graph_validate": (i32, (P(medax_medial_graph), P(medax_job), P(medax_validation))),
    "medax_medial_graph_clone": (P(medax_medial_graph), (P(medax_medial_graph),)),
    "medax_medial_graph_free": (None, (P(medax_medial_graph),)),
    "medax_balls_create": (i32, (address, usize, address, usize, P(medax_job), P(P(medax_balls)))),
    "medax_balls_of_complex": (i32, (P(medax_complex), P(medax_job), P(P(medax_balls)))),
    "medax_balls_count": (usize, (P(medax_balls),)),
    "medax_balls_centers": (medax_view_f64, (P(medax_balls),)),
    "medax_balls_radii": (medax_view_f64, (P(medax_balls),)),
    "medax_balls_bounds": (i32, (P(medax_balls), address, address)),
    "medax_balls_distances": (i32, (P(medax_balls), address, usize, P(medax_job), address)),
    "medax_boundary_options_init": (i32, (P(medax_boundary_options), usize)),
    "medax_balls_boundary": (i32, (P(medax_balls), P(medax_boundary_options), P(medax_job), P(P(medax_complex)))),
    "medax_balls_clone": (P(medax_balls), (P(medax_balls),)),
    "medax_balls_free": (None, (P(medax_balls),)),
    "medax_file_read": (i32, (text, P(medax_job), P(P(medax_file)))),
    "medax_file_is_mesh": (boolean, (P(medax_file),)),
    "medax_file_vertices": (medax_view_f64, (P(medax_file),)),
    "medax_file_faces": (medax_view_rows, (P(medax_file),)),
    "medax_file_edges": (medax_view_u32, (P(medax_file),)),
    "medax_file_attribute_count": (usize, (P(medax_file),)),
    "medax_file_attribute_at": (i32, (P(medax_file), usize, address)),
    "medax_file_attribute": (i32, (P(medax_file), u32, text, address)),
    "medax_file_warnings": (i32, (P(medax_file), P(P(medax_warnings)))),
    "medax_file_points": (i32, (P(medax_file), P(medax_points_options), P(medax_job), P(P(medax_points)))),
    "medax_file_complex": (i32, (P(medax_file), P(medax_job), P(P(medax_complex)))),
    "medax_file_clone": (P(medax_file), (P(medax_file),)),
    "medax_file_free": (None, (P(medax_file),)),
    "medax_points_read": (i32, (text, P(medax_points_options), P(medax_job), P(P(medax_points)))),
    "medax_complex_read": (i32, (text, P(medax_job), P(P(medax_complex)))),
    "medax_write_options_init": (i32, (P(medax_write_options), usize)),
    "medax_complex_write": (i32, (P(medax_complex), text, P(medax_write_options), P(medax_job), P(P(medax_warnings)))),
    "medax_points_write": (i32, (P(medax_points), text, P(medax_write_options), P(medax_job), P(P(medax_warnings)))),
    "medax_warnings_count": (usize, (P(medax_warnings),)),
    "medax_warnings_text": (text, (P(medax_warnings), usize)),
    "medax_warnings_clone": (P(medax_warnings), (P(medax_warnings),)),
    "medax_warnings_free": (None, (P(medax_warnings),)),
    "medax_shape_name": (text, (u32,)),
    "medax_shape_describe": (i32, (u32, P(medax_shape_facts))),
    "medax_sample_options_init": (i32, (P(medax_sample_options), usize)),
    "medax_samples_build": (i32, (u32, P(medax_sample_options), P(medax_job), P(P(medax_samples)))),
    "medax_samples_build_from_mesh": (i32, (P(medax_complex), P(medax_sample_options), P(medax_job), P(P(medax_samples)))),
    "medax_samples_coords": (medax_view_f64, (P(medax_samples),)),
    "medax_samples_normals": (medax_view_f64, (P(medax_samples),)),
    "medax_samples_spacing": (f64, (P(medax_samples),)),
    "medax_samples_area": (f64, (P(medax_samples),)),
    "medax_samples_complex": (i32, (P(medax_samples), P(P(medax_complex)))),
    "medax_samples_clone": (P(medax_samples), (P(medax_samples),)),
    "medax_samples_free": (None, (P(medax_samples),)),
}
