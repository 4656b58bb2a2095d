/* Flat tetrahedra of power shapes, collapsed. */
#include "check.h"

/* Two tetrahedra with a common triangle, the first one flat. */
static const medax_complex *pair(void) {
    static const double xyz[] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 0.1, 1, 1, -3};
    static const uint32_t offsets[] = {0, 4, 8}, corners[] = {0, 1, 2, 3, 0, 2, 1, 4};
    static const uint32_t types[] = {MEDAX_CELL_TYPE_TETRAHEDRON, MEDAX_CELL_TYPE_TETRAHEDRON};
    medax_complex_parts parts;
    const medax_complex *complex = NULL;
    medax_complex_parts_init(&parts, sizeof parts);
    parts.vertices = xyz;
    parts.vertex_count = 5;
    parts.cell_offsets = offsets;
    parts.cell_indices = corners;
    parts.cell_types = types;
    parts.cell_count = 2;
    CHECK_STATUS(OK, medax_complex_create(&parts, &complex));
    NEED(complex != NULL);
    return complex;
}

static void collapses(const medax_complex *two) {
    const medax_flattened *result = NULL, *again = NULL;
    const medax_complex *left = NULL;
    medax_flatten_options options;
    CHECK_STATUS(NULL_ARGUMENT, medax_flatten_options_init(NULL, sizeof options));
    CHECK_STATUS(INVALID_ARGUMENT, medax_flatten_options_init(&options, 8));
    CHECK_STATUS(OK, medax_flatten_options_init(&options, sizeof options));
    CHECK(options.flatness == 0.1);
    CHECK_STATUS(OK, medax_complex_flatten(two, NULL, NULL, &result));
    NEED(result != NULL);
    CHECK(medax_flattened_collapses(result).rows == 1 && medax_flattened_left_count(result) == 0);
    CHECK(medax_flattened_collapses(result).data[0] == 0);
    medax_flattened_free(result);
    options.flatness = 1;
    CHECK_STATUS(OK, medax_complex_flatten(two, &options, NULL, &result));
    again = medax_flattened_clone(result);
    medax_flattened_free(result);
    const medax_view_u32 collapses = medax_flattened_collapses(again);
    NEED(collapses.rows == 2 && collapses.cols == 2);
    /* The second one loses the triangle between them, which then is free. */
    CHECK(collapses.data[0] == 0 && collapses.data[2] == 1);
    CHECK_STATUS(OK, medax_flattened_complex(again, &left));
    NEED(left != NULL);
    medax_flattened_free(again);
    CHECK(medax_complex_cells(left).rows == 0 && medax_complex_faces(left).rows == 5);
    CHECK(medax_complex_vertices(left).rows == 5 && medax_complex_edges(left).rows == 0);
    medax_complex_free(left);
}

static void refusals(const medax_complex *two) {
    const medax_flattened *result = NULL;
    const medax_complex *left = NULL;
    const medax_job *spent = NULL;
    medax_flatten_options options;
    NEED(medax_job_create(NULL, &spent) == MEDAX_STATUS_OK);
    medax_job_cancel(spent);
    CHECK_STATUS(OK, medax_flatten_options_init(&options, sizeof options));
    options.flatness = -1;
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_flatten(two, &options, NULL, &result));
    options.flatness = strtod("nan", NULL);
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_flatten(two, &options, NULL, &result));
    options.struct_size = 8;
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_flatten(two, &options, NULL, &result));
    CHECK_STATUS(CANCELLED, medax_complex_flatten(two, NULL, spent, &result));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_flatten(NULL, NULL, NULL, &result));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_flatten(two, NULL, NULL, NULL));
    CHECK(result == NULL);
    CHECK_STATUS(NULL_ARGUMENT, medax_flattened_complex(NULL, &left));
    CHECK(left == NULL && medax_flattened_clone(NULL) == NULL);
    CHECK(medax_flattened_collapses(NULL).rows == 0 && medax_flattened_left_count(NULL) == 0);
    medax_flattened_free(NULL);
    CHECK_STATUS(OK, medax_complex_flatten(two, NULL, NULL, &result));
    CHECK_STATUS(NULL_ARGUMENT, medax_flattened_complex(result, NULL));
    medax_flattened_free(result);
    medax_job_free(spent);
}

/* A power shape keeps its Betti numbers, and its attributes. */
static void power_shape(void) {
    enum { COUNT = 600 };
    static double xyz[3 * COUNT];
    uint64_t state = 5;
    const medax_points *points = NULL;
    const medax_power_crust *crust = NULL;
    const medax_poles *poles = NULL;
    const medax_complex *shape = NULL, *flat = NULL;
    const medax_flattened *result = NULL;
    medax_attribute angle, label, pole, flatness;
    medax_topology before, after;
    for (size_t i = 0; i < COUNT; ++i) {
        for (size_t k = 0; k < 3; ++k) xyz[3 * i + k] = check_random(&state);
        xyz[3 * i + i % 3] = i / 3 % 2 == 0 ? 0 : 1;
    }
    CHECK_STATUS(OK, medax_points_create_f64(xyz, COUNT, 0, NULL, NULL, &points));
    CHECK_STATUS(OK, medax_power_crust_build(points, NULL, NULL, &crust));
    CHECK_STATUS(OK, medax_power_crust_poles(crust, &poles));
    CHECK_STATUS(OK, medax_power_crust_shape(crust, MEDAX_LABEL_INNER, &shape));
    NEED(shape != NULL);
    CHECK_STATUS(OK, medax_complex_flatten(shape, NULL, NULL, &result));
    CHECK_STATUS(OK, medax_flattened_complex(result, &flat));
    before.struct_size = after.struct_size = sizeof before;
    CHECK_STATUS(OK, medax_complex_topology(shape, NULL, &before));
    CHECK_STATUS(OK, medax_complex_topology(flat, NULL, &after));
    CHECK(memcmp(before.betti, after.betti, sizeof before.betti) == 0);
    CHECK(medax_flattened_collapses(result).rows > 100);
    CHECK(medax_complex_cells(shape).rows - medax_complex_cells(flat).rows
          == medax_flattened_collapses(result).rows);
    CHECK_STATUS(OK, medax_complex_attribute(flat, MEDAX_ELEMENT_CELL, "flatness", &flatness));
    CHECK(flatness.f64_values.rows == medax_complex_cells(flat).rows);
    CHECK_STATUS(OK, medax_complex_attribute(flat, MEDAX_ELEMENT_VERTEX, "label", &label));
    CHECK_STATUS(OK, medax_complex_attribute(flat, MEDAX_ELEMENT_VERTEX, "pole", &pole));
    CHECK_STATUS(OK, medax_complex_attribute(flat, MEDAX_ELEMENT_VERTEX, "object_angle", &angle));
    const medax_view_f64 angles = medax_poles_object_angles(poles);
    CHECK(angles.rows == medax_poles_balls(poles).rows && angles.cols == 1);
    for (size_t v = 0; v < pole.u32_values.rows; ++v) {
        CHECK(label.u32_values.data[v] == MEDAX_LABEL_INNER);
        CHECK(angle.f64_values.data[v] == angles.data[pole.u32_values.data[v]]);
        CHECK(angle.f64_values.data[v] > 0 && angle.f64_values.data[v] < 3.1416);
    }
    CHECK(medax_poles_object_angles(NULL).rows == 0);
    medax_complex_free(flat);
    medax_complex_free(shape);
    medax_flattened_free(result);
    medax_poles_free(poles);
    medax_power_crust_free(crust);
    medax_points_free(points);
}

int main(void) {
    const medax_complex *two = pair();
    collapses(two);
    refusals(two);
    power_shape();
    medax_complex_free(two);
    return check_end();
}
