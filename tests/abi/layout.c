/* The size of every public struct and the place of every field, as version 0.1 has them on systems
   with 64-bit pointers. Lines are added for new fields at the end of sized structs, never changed. */
#include <medax.h>
#include <stddef.h>

#define SIZE(type, size) _Static_assert(sizeof(type) == (size), "sizeof " #type)
#define FIELD(type, field, place) \
    _Static_assert(offsetof(type, field) == (place), #type "." #field)

SIZE(medax_status, 4);
SIZE(void *, 8);

SIZE(medax_view_f64, 24);
FIELD(medax_view_f64, data, 0);
FIELD(medax_view_f64, rows, 8);
FIELD(medax_view_f64, cols, 16);

SIZE(medax_view_u32, 24);
FIELD(medax_view_u32, data, 0);
FIELD(medax_view_u32, rows, 8);
FIELD(medax_view_u32, cols, 16);

SIZE(medax_view_rows, 24);
FIELD(medax_view_rows, offsets, 0);
FIELD(medax_view_rows, indices, 8);
FIELD(medax_view_rows, rows, 16);

SIZE(medax_job_options, 40);
FIELD(medax_job_options, struct_size, 0);
FIELD(medax_job_options, memory_ceiling, 8);
FIELD(medax_job_options, threads, 16);
FIELD(medax_job_options, reserved, 20);
FIELD(medax_job_options, progress, 24);
FIELD(medax_job_options, payload, 32);

SIZE(medax_validation, 296);
FIELD(medax_validation, struct_size, 0);
FIELD(medax_validation, checked, 8);
FIELD(medax_validation, problems, 16);
FIELD(medax_validation, first_index, 24);
FIELD(medax_validation, first_kind, 32);
FIELD(medax_validation, reserved, 36);
FIELD(medax_validation, first_message, 40);

SIZE(medax_points_options, 16);
FIELD(medax_points_options, struct_size, 0);
FIELD(medax_points_options, skip_non_finite, 8);
FIELD(medax_points_options, reserved, 12);

SIZE(medax_triangulation_options, 8);
FIELD(medax_triangulation_options, struct_size, 0);

SIZE(medax_attribute, 64);
FIELD(medax_attribute, name, 0);
FIELD(medax_attribute, element, 8);
FIELD(medax_attribute, value_type, 12);
FIELD(medax_attribute, f64_values, 16);
FIELD(medax_attribute, u32_values, 40);

SIZE(medax_complex_parts, 120);
FIELD(medax_complex_parts, struct_size, 0);
FIELD(medax_complex_parts, vertices, 8);
FIELD(medax_complex_parts, vertex_count, 16);
FIELD(medax_complex_parts, face_offsets, 24);
FIELD(medax_complex_parts, face_indices, 32);
FIELD(medax_complex_parts, face_count, 40);
FIELD(medax_complex_parts, edges, 48);
FIELD(medax_complex_parts, edge_count, 56);
FIELD(medax_complex_parts, cell_offsets, 64);
FIELD(medax_complex_parts, cell_indices, 72);
FIELD(medax_complex_parts, cell_types, 80);
FIELD(medax_complex_parts, cell_count, 88);
FIELD(medax_complex_parts, attributes, 96);
FIELD(medax_complex_parts, attribute_count, 104);
FIELD(medax_complex_parts, dimension, 112);
FIELD(medax_complex_parts, reserved, 116);

SIZE(medax_figure_parts, 128);
FIELD(medax_figure_parts, struct_size, 0);
FIELD(medax_figure_parts, ring_vertices, 8);
FIELD(medax_figure_parts, ring_vertex_count, 16);
FIELD(medax_figure_parts, ring_offsets, 24);
FIELD(medax_figure_parts, ring_count, 32);
FIELD(medax_figure_parts, polygon_offsets, 40);
FIELD(medax_figure_parts, polygon_count, 48);
FIELD(medax_figure_parts, polyline_vertices, 56);
FIELD(medax_figure_parts, polyline_vertex_count, 64);
FIELD(medax_figure_parts, polyline_offsets, 72);
FIELD(medax_figure_parts, polyline_count, 80);
FIELD(medax_figure_parts, points, 88);
FIELD(medax_figure_parts, point_count, 96);
FIELD(medax_figure_parts, circles, 104);
FIELD(medax_figure_parts, circle_count, 112);
FIELD(medax_figure_parts, crossings, 120);
FIELD(medax_figure_parts, reserved, 124);

SIZE(medax_figure_read_options, 24);
FIELD(medax_figure_read_options, struct_size, 0);
FIELD(medax_figure_read_options, feature_name, 8);
FIELD(medax_figure_read_options, feature_number, 16);
FIELD(medax_figure_read_options, crossings, 20);

SIZE(medax_normalised, 48);
FIELD(medax_normalised, struct_size, 0);
FIELD(medax_normalised, closing_vertices, 8);
FIELD(medax_normalised, repeated_vertices, 16);
FIELD(medax_normalised, turned_rings, 24);
FIELD(medax_normalised, crossings, 32);
FIELD(medax_normalised, misplaced, 40);

SIZE(medax_view_u8, 24);
FIELD(medax_view_u8, data, 0);
FIELD(medax_view_u8, rows, 8);
FIELD(medax_view_u8, cols, 16);

SIZE(medax_write_options, 16);
FIELD(medax_write_options, struct_size, 0);
FIELD(medax_write_options, text, 8);
FIELD(medax_write_options, reserved, 12);

SIZE(medax_poles_options, 24);
FIELD(medax_poles_options, struct_size, 0);
FIELD(medax_poles_options, lambda, 8);
FIELD(medax_poles_options, omit, 16);
FIELD(medax_poles_options, reserved, 20);

SIZE(medax_power_crust_options, 72);
FIELD(medax_power_crust_options, struct_size, 0);
FIELD(medax_power_crust_options, deep, 8);
FIELD(medax_power_crust_options, lambda, 16);
FIELD(medax_power_crust_options, round_poles, 24);
FIELD(medax_power_crust_options, keep_shards, 28);
FIELD(medax_power_crust_options, omit, 32);
FIELD(medax_power_crust_options, label_rule, 36);
FIELD(medax_power_crust_options, viewpoint, 40);
FIELD(medax_power_crust_options, has_viewpoint, 64);
FIELD(medax_power_crust_options, reserved, 68);

SIZE(medax_simplify_options, 24);
FIELD(medax_simplify_options, struct_size, 0);
FIELD(medax_simplify_options, epsilon, 8);
FIELD(medax_simplify_options, delta, 16);

SIZE(medax_hole_options, 24);
FIELD(medax_hole_options, struct_size, 0);
FIELD(medax_hole_options, depth, 8);
FIELD(medax_hole_options, radius, 16);

SIZE(medax_dual_options, 16);
FIELD(medax_dual_options, struct_size, 0);
FIELD(medax_dual_options, facets, 8);
FIELD(medax_dual_options, reserved, 12);

SIZE(medax_cocone_options, 32);
FIELD(medax_cocone_options, struct_size, 0);
FIELD(medax_cocone_options, angle, 8);
FIELD(medax_cocone_options, ratio, 16);
FIELD(medax_cocone_options, normal_angle, 24);

SIZE(medax_medial_options, 32);
FIELD(medax_medial_options, struct_size, 0);
FIELD(medax_medial_options, normals, 8);
FIELD(medax_medial_options, normal_count, 16);
FIELD(medax_medial_options, scales, 24);
FIELD(medax_medial_options, reserved, 28);

SIZE(medax_medial_filter, 112);
FIELD(medax_medial_filter, struct_size, 0);
FIELD(medax_medial_filter, theta, 8);
FIELD(medax_medial_filter, rho, 16);
FIELD(medax_medial_filter, object_angle, 24);
FIELD(medax_medial_filter, lambda, 32);
FIELD(medax_medial_filter, scale, 40);
FIELD(medax_medial_filter, clip_min, 48);
FIELD(medax_medial_filter, clip_max, 72);
FIELD(medax_medial_filter, has_clip, 96);
FIELD(medax_medial_filter, rule, 100);
FIELD(medax_medial_filter, side, 104);
FIELD(medax_medial_filter, reserved, 108);

SIZE(medax_flow_options, 16);
FIELD(medax_flow_options, struct_size, 0);
FIELD(medax_flow_options, least_slope, 8);

SIZE(medax_simplex, 8);
FIELD(medax_simplex, dimension, 0);
FIELD(medax_simplex, number, 4);

SIZE(medax_flow_point, 72);
FIELD(medax_flow_point, simplex, 0);
FIELD(medax_flow_point, driver, 8);
FIELD(medax_flow_point, vector, 32);
FIELD(medax_flow_point, distance, 56);
FIELD(medax_flow_point, angle, 64);

SIZE(medax_core_options, 16);
FIELD(medax_core_options, struct_size, 0);
FIELD(medax_core_options, side, 8);
FIELD(medax_core_options, repair, 12);
SIZE(medax_pair_onto_options, 16);
FIELD(medax_pair_onto_options, struct_size, 0);
FIELD(medax_pair_onto_options, subdivide, 8);
FIELD(medax_pair_onto_options, exact, 12);

SIZE(medax_core_report, 48);
FIELD(medax_core_report, struct_size, 0);
FIELD(medax_core_report, taken, 8);
FIELD(medax_core_report, of_surface, 16);
FIELD(medax_core_report, elsewhere, 24);
FIELD(medax_core_report, leaving, 32);
FIELD(medax_core_report, unbounded, 40);

SIZE(medax_flow_element, 8);
FIELD(medax_flow_element, kind, 0);
FIELD(medax_flow_element, number, 4);
SIZE(medax_place, 48);
FIELD(medax_place, element, 0);
FIELD(medax_place, piece, 4);
FIELD(medax_place, weights, 8);
FIELD(medax_place, t, 40);

SIZE(medax_topology, 144);
FIELD(medax_topology, struct_size, 0);
FIELD(medax_topology, vertices, 8);
FIELD(medax_topology, isolated_vertices, 16);
FIELD(medax_topology, edges, 24);
FIELD(medax_topology, faces, 32);
FIELD(medax_topology, cells, 40);
FIELD(medax_topology, components, 48);
FIELD(medax_topology, euler_characteristic, 56);
FIELD(medax_topology, boundary_edges, 64);
FIELD(medax_topology, boundary_loops, 72);
FIELD(medax_topology, nonmanifold_edges, 80);
FIELD(medax_topology, nonmanifold_vertices, 88);
FIELD(medax_topology, genus, 96);
FIELD(medax_topology, betti, 104);
FIELD(medax_topology, has_genus, 128);
FIELD(medax_topology, closed, 132);
FIELD(medax_topology, oriented, 136);
FIELD(medax_topology, reserved, 140);

SIZE(medax_decimate_options, 24);
FIELD(medax_decimate_options, struct_size, 0);
FIELD(medax_decimate_options, triangles, 8);
FIELD(medax_decimate_options, max_error, 16);

SIZE(medax_flatten_options, 16);
FIELD(medax_flatten_options, struct_size, 0);
FIELD(medax_flatten_options, flatness, 8);

SIZE(medax_compare_options, 24);
FIELD(medax_compare_options, struct_size, 0);
FIELD(medax_compare_options, samples, 8);
FIELD(medax_compare_options, seed, 16);

SIZE(medax_comparison, 64);
FIELD(medax_comparison, struct_size, 0);
FIELD(medax_comparison, a_to_b_max, 8);
FIELD(medax_comparison, a_to_b_mean, 16);
FIELD(medax_comparison, a_to_b_rms, 24);
FIELD(medax_comparison, b_to_a_max, 32);
FIELD(medax_comparison, b_to_a_mean, 40);
FIELD(medax_comparison, b_to_a_rms, 48);
FIELD(medax_comparison, diagonal, 56);

SIZE(medax_piece, 80);
FIELD(medax_piece, kind, 0);
FIELD(medax_piece, site, 4);
FIELD(medax_piece, numbers, 8);

SIZE(medax_nearest, 64);
FIELD(medax_nearest, point, 0);
FIELD(medax_nearest, distance, 24);
FIELD(medax_nearest, direction, 32);
FIELD(medax_nearest, piece, 56);
FIELD(medax_nearest, site, 60);

SIZE(medax_decide_options, 24);
FIELD(medax_decide_options, struct_size, 0);
FIELD(medax_decide_options, tolerance, 8);
FIELD(medax_decide_options, epsilon, 16);

SIZE(medax_decision, 136);
FIELD(medax_decision, struct_size, 0);
FIELD(medax_decision, center, 8);
FIELD(medax_decision, radius, 32);
FIELD(medax_decision, object_angle, 40);
FIELD(medax_decision, feet, 48);
FIELD(medax_decision, gap, 96);
FIELD(medax_decision, theta_count, 104);
FIELD(medax_decision, unconfirmed, 112);
FIELD(medax_decision, pieces, 120);
FIELD(medax_decision, test, 128);
FIELD(medax_decision, reserved, 132);

SIZE(medax_field_axis_options, 120);
FIELD(medax_field_axis_options, struct_size, 0);
FIELD(medax_field_axis_options, density, 8);
FIELD(medax_field_axis_options, object_angle, 16);
FIELD(medax_field_axis_options, min_distance, 24);
FIELD(medax_field_axis_options, bound, 32);
FIELD(medax_field_axis_options, tolerance, 40);
FIELD(medax_field_axis_options, epsilon, 48);
FIELD(medax_field_axis_options, clip_min, 56);
FIELD(medax_field_axis_options, clip_max, 80);
FIELD(medax_field_axis_options, has_clip, 104);
FIELD(medax_field_axis_options, side, 108);
FIELD(medax_field_axis_options, samples, 112);
FIELD(medax_field_axis_options, between_sites, 116);

SIZE(medax_cover, 72);
FIELD(medax_cover, center, 0);
FIELD(medax_cover, radius, 24);
FIELD(medax_cover, half, 32);
FIELD(medax_cover, gap, 40);
FIELD(medax_cover, distance, 48);
FIELD(medax_cover, missed_angle, 56);
FIELD(medax_cover, found, 64);
FIELD(medax_cover, reserved, 68);

SIZE(medax_medial_graph_options, 96);
FIELD(medax_medial_graph_options, struct_size, 0);
FIELD(medax_medial_graph_options, spacing, 8);
FIELD(medax_medial_graph_options, object_angle, 16);
FIELD(medax_medial_graph_options, min_distance, 24);
FIELD(medax_medial_graph_options, clip_min, 32);
FIELD(medax_medial_graph_options, clip_max, 56);
FIELD(medax_medial_graph_options, has_clip, 80);
FIELD(medax_medial_graph_options, side, 84);
FIELD(medax_medial_graph_options, between_sites, 88);
FIELD(medax_medial_graph_options, reserved, 92);

SIZE(medax_boundary_options, 16);
FIELD(medax_boundary_options, struct_size, 0);
FIELD(medax_boundary_options, spacing, 8);

SIZE(medax_sample_options, 40);
FIELD(medax_sample_options, struct_size, 0);
FIELD(medax_sample_options, spacing, 8);
FIELD(medax_sample_options, density, 16);
FIELD(medax_sample_options, noise, 24);
FIELD(medax_sample_options, seed, 32);

SIZE(medax_shape_facts, 80);
FIELD(medax_shape_facts, struct_size, 0);
FIELD(medax_shape_facts, min, 8);
FIELD(medax_shape_facts, max, 32);
FIELD(medax_shape_facts, spacing, 56);
FIELD(medax_shape_facts, genus, 64);
FIELD(medax_shape_facts, components, 68);
FIELD(medax_shape_facts, smooth, 72);
FIELD(medax_shape_facts, reserved, 76);
