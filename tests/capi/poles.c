/* Poles with the far box. */
#include "check.h"

static const char nothing = 0;
#define UNTOUCHED ((const medax_poles *)(const void *)&nothing)

static void refusals(void) {
    const double flat[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    const medax_points *plane = NULL, *three = NULL, *cloud = check_points(20);
    const medax_poles *poles = UNTOUCHED;
    const medax_job *spent = NULL;
    medax_poles_options options;
    CHECK_STATUS(OK, medax_points_create_f64(flat, 4, 0, NULL, NULL, &plane));
    CHECK_STATUS(OK, medax_points_create_f64(flat, 3, 0, NULL, NULL, &three));
    CHECK_STATUS(OK, medax_job_create(NULL, &spent));
    medax_job_cancel(spent);
    CHECK_STATUS(DEGENERATE, medax_poles_build_with_far_box(plane, NULL, NULL, &poles));
    CHECK_STATUS(TOO_FEW_POINTS, medax_poles_build_with_far_box(three, NULL, NULL, &poles));
    CHECK_STATUS(NULL_ARGUMENT, medax_poles_build_with_far_box(NULL, NULL, NULL, &poles));
    CHECK_STATUS(NULL_ARGUMENT, medax_poles_build_with_far_box(cloud, NULL, NULL, NULL));
    CHECK_STATUS(CANCELLED, medax_poles_build_with_far_box(cloud, NULL, spent, &poles));
    CHECK_STATUS(NULL_ARGUMENT, medax_poles_options_init(NULL, sizeof options));
    CHECK_STATUS(INVALID_ARGUMENT, medax_poles_options_init(&options, 0));
    CHECK_STATUS(OK, medax_poles_options_init(&options, sizeof options));
    options.struct_size = 1;
    CHECK_STATUS(INVALID_ARGUMENT, medax_poles_build_with_far_box(cloud, &options, NULL, &poles));
    CHECK(poles == UNTOUCHED);
    medax_job_free(spent);
    medax_points_free(cloud);
    medax_points_free(three);
    medax_points_free(plane);
}

static void null_is_nothing(void) {
    const double xyz[3] = {0, 0, 0};
    double distance = -1;
    const medax_triangulation *triangulation = NULL;
    medax_validation report;
    report.struct_size = sizeof report;
    CHECK(medax_poles_balls(NULL).rows == 0 && medax_poles_balls(NULL).cols == 4);
    CHECK(medax_poles_radii_squared(NULL).data == NULL && medax_poles_normals(NULL).rows == 0);
    CHECK(medax_poles_cell_of_pole(NULL).rows == 0 && medax_poles_pole_of_sample(NULL).cols == 2);
    CHECK(medax_poles_touches_far_box(NULL).rows == 0 && !medax_poles_has_far_box(NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_poles_triangulation(NULL, &triangulation));
    CHECK_STATUS(NULL_ARGUMENT, medax_poles_feature_size(NULL, xyz, 1, NULL, &distance));
    CHECK_STATUS(NULL_ARGUMENT, medax_poles_validate(NULL, NULL, &report));
    CHECK(medax_poles_clone(NULL) == NULL && triangulation == NULL && distance == -1);
    medax_poles_free(NULL);
}

/* Samples of the unit sphere: the inner poles are its centre, nearly. */
static void a_sphere(void) {
    enum { COUNT = 300 };
    const double nan = strtod("nan", NULL);
    uint64_t state = 3;
    double xyz[3 * COUNT];
    double queries[9] = {0, 0, 0.5, 0, 0, 0, 0, nan, 0}, distances[3] = {-1, -1, -1};
    const medax_points *points = NULL;
    const medax_poles *poles = NULL;
    const medax_triangulation *triangulation = NULL;
    medax_validation report;
    for (size_t i = 0; i < COUNT;) {
        double p[3], square = 0;
        for (size_t k = 0; k < 3; ++k) {
            p[k] = 2 * check_random(&state) - 1;
            square += p[k] * p[k];
        }
        if (square < 0.1 || square > 1) continue;
        /* Newton's method for 1 / sqrt(square), without the mathematics library. */
        double scale = 1;
        for (int step = 0; step < 60; ++step) scale *= 1.5 - 0.5 * square * scale * scale;
        for (size_t k = 0; k < 3; ++k) xyz[3 * i + k] = scale * p[k];
        ++i;
    }
    CHECK_STATUS(OK, medax_points_create_f64(xyz, COUNT, 0, NULL, NULL, &points));
    CHECK_STATUS(OK, medax_poles_build_with_far_box(points, NULL, NULL, &poles));
    NEED(poles != NULL);
    const medax_view_f64 balls = medax_poles_balls(poles), normals = medax_poles_normals(poles);
    const medax_view_f64 squares = medax_poles_radii_squared(poles);
    const medax_view_u32 of_sample = medax_poles_pole_of_sample(poles);
    const medax_view_u32 cells = medax_poles_cell_of_pole(poles);
    const medax_view_u8 far_box = medax_poles_touches_far_box(poles);
    const medax_view_f64 coords = medax_points_coords(points);
    NEED(balls.rows > 0 && balls.cols == 4 && normals.rows == COUNT && normals.cols == 3);
    NEED(squares.rows == balls.rows && squares.cols == 1 && of_sample.rows == COUNT);
    NEED(of_sample.cols == 2 && cells.rows == balls.rows && far_box.rows == balls.rows);
    CHECK(medax_poles_has_far_box(poles) && far_box.cols == 1);
    for (size_t i = 0; i < COUNT; ++i) {
        const uint32_t first = of_sample.data[2 * i], second = of_sample.data[2 * i + 1];
        NEED(first < balls.rows && second < balls.rows);
        /* The far pole is outside, far away; the other one is the centre. */
        CHECK(balls.data[4 * first + 3] > 1.5);
        CHECK(balls.data[4 * second + 3] > 0.99 && balls.data[4 * second + 3] < 1.01);
        double outward = 0;
        for (size_t k = 0; k < 3; ++k) outward += normals.data[3 * i + k] * coords.data[3 * i + k];
        CHECK(outward > 0.9);
    }
    for (size_t p = 0; p < balls.rows; ++p) {
        const double radius = balls.data[4 * p + 3], square = squares.data[p];
        CHECK(radius * radius > 0.999999 * square && radius * radius < 1.000001 * square);
        CHECK(far_box.data[p] <= 1);
    }
    CHECK_STATUS(OK, medax_poles_triangulation(poles, &triangulation));
    CHECK(medax_triangulation_coords(triangulation).rows == COUNT + 8);
    for (size_t p = 0; p < cells.rows; ++p)
        CHECK(cells.data[p] < medax_triangulation_cells(triangulation).rows);

    CHECK_STATUS(OK, medax_poles_feature_size(poles, queries, 2, NULL, distances));
    CHECK(distances[0] > 0.49 && distances[0] < 0.51 && distances[1] < 0.01);
    CHECK(distances[2] == -1);
    distances[0] = -1;
    CHECK_STATUS(NON_FINITE, medax_poles_feature_size(poles, queries, 3, NULL, distances));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 2);
    CHECK_STATUS(NULL_ARGUMENT, medax_poles_feature_size(poles, NULL, 1, NULL, distances));
    CHECK_STATUS(NULL_ARGUMENT, medax_poles_feature_size(poles, queries, 1, NULL, NULL));
    CHECK_STATUS(INVALID_ARGUMENT,
                 medax_poles_feature_size(poles, queries, SIZE_MAX, NULL, distances));
    CHECK(distances[0] == -1);
    CHECK_STATUS(OK, medax_poles_feature_size(poles, NULL, 0, NULL, NULL));

    const medax_complex *complex = NULL;
    medax_attribute attribute;
    CHECK_STATUS(NULL_ARGUMENT, medax_poles_complex(NULL, &complex));
    CHECK_STATUS(NULL_ARGUMENT, medax_poles_complex(poles, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_poles_samples_complex(NULL, &complex));
    CHECK_STATUS(NULL_ARGUMENT, medax_poles_samples_complex(poles, NULL));
    CHECK(complex == NULL);
    CHECK_STATUS(OK, medax_poles_complex(poles, &complex));
    CHECK_STATUS(OK, medax_complex_attribute(complex, MEDAX_ELEMENT_VERTEX, "radius", &attribute));
    CHECK(attribute.f64_values.rows == balls.rows);
    CHECK(attribute.f64_values.data[0] == balls.data[3]);
    medax_complex_free(complex);
    CHECK_STATUS(OK, medax_poles_samples_complex(poles, &complex));
    CHECK_STATUS(OK, medax_complex_attribute(complex, MEDAX_ELEMENT_VERTEX, "normal", &attribute));
    CHECK(memcmp(attribute.f64_values.data, normals.data, sizeof xyz) == 0);
    medax_complex_free(complex);

    report.struct_size = sizeof report;
    CHECK_STATUS(OK, medax_poles_validate(poles, NULL, &report));
    CHECK(report.problems == 0 && report.checked > 0);
    CHECK_STATUS(NULL_ARGUMENT, medax_poles_validate(poles, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_poles_triangulation(poles, NULL));

    const medax_poles *again = medax_poles_clone(poles);
    medax_points_free(points);
    medax_poles_free(poles);
    CHECK(medax_poles_balls(again).data == balls.data && balls.data[3] > 0);
    medax_poles_free(again);
    CHECK(medax_triangulation_cells(triangulation).rows > 0);
    medax_triangulation_free(triangulation);
}

int main(void) {
    refusals();
    null_is_nothing();
    a_sphere();
    return check_end();
}
