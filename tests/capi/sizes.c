/* Local feature size and thickness of a wall between two spheres. */
#include "check.h"

#include <math.h>

static const char nothing = 0;
#define UNTOUCHED(type) ((const type *)(const void *)&nothing)

enum { OUTER = 3000, INNER = 1500, COUNT = OUTER + INNER };

/* Samples of spheres of radius 1 and 0.6 about the origin. */
static double xyz[3 * COUNT];

static const medax_points *shell(void) {
    uint64_t state = 4;
    const medax_points *points = NULL;
    for (size_t i = 0; i < COUNT; ++i) {
        check_direction(&state, xyz + 3 * i);
        for (size_t k = 0; k < 3; ++k) xyz[3 * i + k] *= i < OUTER ? 1 : 0.6;
    }
    CHECK_STATUS(OK, medax_points_create_f64(xyz, COUNT, 0, NULL, NULL, &points));
    NEED(points != NULL);
    return points;
}

static void refusals(const medax_power_crust *crust, const medax_complex *surface) {
    const double nan = strtod("nan", NULL);
    const double queries[] = {0, 0, 0, 1e-300, 2, 0, 1e300, 0, 0, nan, 0, 0};
    const medax_complex *out = UNTOUCHED(medax_complex);
    double size[4], thickness[4];
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_sizes_at(NULL, queries, 1, NULL, size, thickness));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_sizes_at(crust, NULL, 1, NULL, size, thickness));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_sizes_at(crust, queries, 1, NULL, NULL, thickness));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_sizes_at(crust, queries, 1, NULL, size, NULL));
    CHECK_STATUS(INVALID_ARGUMENT,
                 medax_power_crust_sizes_at(crust, queries, SIZE_MAX, NULL, size, thickness));
    CHECK_STATUS(COORDINATE_RANGE, medax_power_crust_sizes_at(crust, queries, 3, NULL, size, thickness));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 2);
    CHECK_STATUS(NON_FINITE, medax_power_crust_sizes_at(crust, queries + 9, 1, NULL, size, thickness));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 0);
    CHECK_STATUS(OK, medax_power_crust_sizes_at(crust, NULL, 0, NULL, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_samples_complex(NULL, NULL, &out));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_samples_complex(crust, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_with_sizes(NULL, surface, NULL, &out));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_with_sizes(crust, NULL, NULL, &out));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_with_sizes(crust, surface, NULL, NULL));
    const medax_job *spent = NULL;
    CHECK_STATUS(OK, medax_job_create(NULL, &spent));
    medax_job_cancel(spent);
    CHECK_STATUS(CANCELLED, medax_power_crust_sizes_at(crust, queries, 1, spent, size, thickness));
    CHECK_STATUS(CANCELLED, medax_power_crust_samples_complex(crust, spent, &out));
    CHECK_STATUS(CANCELLED, medax_power_crust_with_sizes(crust, surface, spent, &out));
    medax_job_free(spent);
    CHECK(out == UNTOUCHED(medax_complex));
}

static const double *values(const medax_complex *complex, const char *name) {
    medax_attribute attribute;
    CHECK_STATUS(OK, medax_complex_attribute(complex, MEDAX_ELEMENT_VERTEX, name, &attribute));
    CHECK(attribute.f64_values.cols == 1);
    CHECK(attribute.f64_values.rows == medax_complex_vertices(complex).rows);
    return attribute.f64_values.data;
}

/* The sizes at the samples, given row by row and as a complex. */
static void at_samples(const medax_power_crust *crust) {
    static double size[COUNT], thickness[COUNT];
    const medax_complex *samples = NULL;
    medax_attribute row;
    CHECK_STATUS(OK, medax_power_crust_sizes_at(crust, xyz, COUNT, NULL, size, thickness));
    for (size_t i = 0; i < COUNT; ++i) {
        CHECK(thickness[i] > 0.399 && thickness[i] < 0.45);
        /* The medial axis is a sphere in the middle of the wall, and the centre. */
        CHECK(size[i] > 0.19 && size[i] < 0.23);
    }
    CHECK_STATUS(OK, medax_power_crust_samples_complex(crust, NULL, &samples));
    NEED(samples != NULL && medax_complex_vertices(samples).rows == COUNT);
    const double *sizes = values(samples, "feature_size"), *thick = values(samples, "thickness");
    CHECK_STATUS(OK, medax_complex_attribute(samples, MEDAX_ELEMENT_VERTEX, "row", &row));
    NEED(row.u32_values.rows == COUNT);
    for (size_t v = 0; v < COUNT; ++v) {
        const uint32_t r = row.u32_values.data[v];
        NEED(r < COUNT);
        CHECK(memcmp(medax_complex_vertices(samples).data + 3 * v, xyz + 3 * r, 24) == 0);
        CHECK(sizes[v] == size[r] && thick[v] == thickness[r]);
    }
    medax_complex_free(samples);
}

static void on_surface(const medax_power_crust *crust, const medax_complex *surface) {
    const medax_complex *sized = NULL;
    const medax_view_f64 at = medax_complex_vertices(surface);
    double size = 0, thickness = 0;
    CHECK_STATUS(OK, medax_power_crust_with_sizes(crust, surface, NULL, &sized));
    NEED(sized != NULL);
    CHECK(medax_complex_faces(sized).rows == medax_complex_faces(surface).rows);
    CHECK(medax_complex_attribute_count(sized) == medax_complex_attribute_count(surface) + 2);
    CHECK(memcmp(medax_complex_vertices(sized).data, at.data, at.rows * 24) == 0);
    for (size_t v = 0; v < at.rows; v += 97) {
        CHECK_STATUS(OK, medax_power_crust_sizes_at(crust, at.data + 3 * v, 1, NULL, &size, &thickness));
        CHECK(values(sized, "feature_size")[v] == size && values(sized, "thickness")[v] == thickness);
    }
    medax_complex_free(sized);
}

int main(void) {
    const medax_points *points = shell();
    const medax_power_crust *crust = NULL;
    const medax_complex *surface = NULL;
    CHECK_STATUS(OK, medax_power_crust_build(points, NULL, NULL, &crust));
    NEED(crust != NULL);
    CHECK_STATUS(OK, medax_power_crust_surface(crust, &surface));
    refusals(crust, surface);
    at_samples(crust);
    on_surface(crust, surface);
    medax_complex_free(surface);
    medax_power_crust_free(crust);
    medax_points_free(points);
    return check_end();
}
