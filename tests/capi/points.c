/* Points: strides, maps, bad rows, NULL. */
#include "check.h"

static const double corners[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
static const char nothing = 0;
#define UNTOUCHED ((const medax_points *)(const void *)&nothing)

static void refusals(void) {
    const double nan = strtod("nan", NULL), infinity = strtod("inf", NULL);
    const float nan_f = strtof("nan", NULL);
    const medax_points *points = UNTOUCHED;
    double xyz[12];
    float xyz_f[12] = {0};
    const struct {
        double value;
        medax_status status;
    } bad[] = {{nan, MEDAX_STATUS_NON_FINITE},
               {infinity, MEDAX_STATUS_NON_FINITE},
               {-infinity, MEDAX_STATUS_NON_FINITE},
               {1e300, MEDAX_STATUS_COORDINATE_RANGE},
               {-1e-300, MEDAX_STATUS_COORDINATE_RANGE}};
    for (size_t b = 0; b < sizeof bad / sizeof *bad; ++b) {
        for (size_t i = 0; i < 12; ++i) {
            memcpy(xyz, corners, sizeof xyz);
            xyz[i] = bad[b].value;
            CHECK(medax_points_create_f64(xyz, 4, 0, NULL, NULL, &points) == bad[b].status);
            CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW);
            CHECK(medax_last_error_index() == i / 3);
        }
    }
    xyz_f[7] = nan_f;
    CHECK_STATUS(NON_FINITE, medax_points_create_f32(xyz_f, 4, 0, NULL, NULL, &points));
    CHECK(medax_last_error_index() == 2);

    CHECK_STATUS(TOO_FEW_POINTS, medax_points_create_f64(corners, 0, 0, NULL, NULL, &points));
    CHECK_STATUS(TOO_FEW_POINTS, medax_points_create_f64(NULL, 0, 0, NULL, NULL, &points));
    CHECK_STATUS(NULL_ARGUMENT, medax_points_create_f64(NULL, 1, 0, NULL, NULL, &points));
    CHECK_STATUS(NULL_ARGUMENT, medax_points_create_f32(NULL, 1, 0, NULL, NULL, &points));
    CHECK_STATUS(NULL_ARGUMENT, medax_points_create_f64(corners, 4, 0, NULL, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_points_create_f32(xyz_f, 4, 0, NULL, NULL, NULL));
    CHECK_STATUS(INVALID_ARGUMENT, medax_points_create_f64(corners, 4, 23, NULL, NULL, &points));
    CHECK_STATUS(INVALID_ARGUMENT, medax_points_create_f32(xyz_f, 4, 11, NULL, NULL, &points));
    CHECK_STATUS(INVALID_ARGUMENT,
                 medax_points_create_f64(corners, SIZE_MAX, 0, NULL, NULL, &points));
    CHECK_STATUS(INVALID_ARGUMENT,
                 medax_points_create_f64(corners, 4, SIZE_MAX / 2, NULL, NULL, &points));
    /* Refused before a row is read. */
    CHECK_STATUS(LIMIT_EXCEEDED,
                 medax_points_create_f64(corners, (1u << 28) + 1, 0, NULL, NULL, &points));
    CHECK(points == UNTOUCHED);
}

static void maps(void) {
    const double nan = strtod("nan", NULL);
    const double xyz[18] = {5, 0, 0, nan, 0, 0, -0.0, 1, 0, 5, 0, 0, 0, 1, 0, 0, 0, 1};
    const uint32_t duplicate_of[6] = {MEDAX_NONE, MEDAX_NONE, MEDAX_NONE, 0, 2, MEDAX_NONE};
    medax_points_options options;
    const medax_points *points = NULL;
    double min[3], max[3];
    CHECK_STATUS(NULL_ARGUMENT, medax_points_options_init(NULL, sizeof options));
    CHECK_STATUS(INVALID_ARGUMENT, medax_points_options_init(&options, 8));
    CHECK_STATUS(OK, medax_points_options_init(&options, sizeof options));
    options.skip_non_finite = 2;
    CHECK_STATUS(INVALID_ARGUMENT, medax_points_create_f64(xyz, 6, 0, &options, NULL, &points));
    options.skip_non_finite = 1;
    options.reserved = 1;
    CHECK_STATUS(INVALID_ARGUMENT, medax_points_create_f64(xyz, 6, 0, &options, NULL, &points));
    options.reserved = 0;
    CHECK(points == NULL);
    CHECK_STATUS(OK, medax_points_create_f64(xyz, 6, 0, &options, NULL, &points));
    NEED(points != NULL);
    CHECK(medax_points_count(points) == 3 && medax_points_row_count(points) == 6);
    CHECK(medax_points_duplicate_count(points) == 2 && medax_points_skipped_count(points) == 1);

    const medax_view_f64 coords = medax_points_coords(points);
    const medax_view_u32 vertices = medax_points_vertex_of_row(points);
    const medax_view_u32 rows = medax_points_row_of_vertex(points);
    const medax_view_u32 duplicates = medax_points_duplicate_of(points);
    NEED(coords.rows == 3 && coords.cols == 3 && vertices.rows == 6 && vertices.cols == 1);
    NEED(rows.rows == 3 && rows.cols == 1 && duplicates.rows == 6 && duplicates.cols == 1);
    for (size_t row = 0; row < 6; ++row) {
        const uint32_t vertex = vertices.data[row];
        CHECK(duplicates.data[row] == duplicate_of[row]);
        if (row == 1) {
            CHECK(vertex == MEDAX_NONE);
            continue;
        }
        NEED(vertex < 3);
        for (size_t i = 0; i < 3; ++i) CHECK(coords.data[3 * vertex + i] == xyz[3 * row + i]);
        CHECK(rows.data[vertex] <= row);
    }
    CHECK_STATUS(OK, medax_points_bounds(points, min, max));
    CHECK(min[0] == 0 && min[1] == 0 && min[2] == 0 && max[0] == 5 && max[1] == 1 && max[2] == 1);
    CHECK_STATUS(NULL_ARGUMENT, medax_points_bounds(NULL, min, max));
    CHECK_STATUS(NULL_ARGUMENT, medax_points_bounds(points, NULL, max));
    CHECK_STATUS(NULL_ARGUMENT, medax_points_bounds(points, min, NULL));
    medax_points_free(points);
}

/* The same points through every kind of array give the same bytes. */
static void strides(void) {
    enum { COUNT = 50 };
    struct vertex {
        float normal[3];
        float xyz[3];
        unsigned char color;
    } vertices[COUNT];
    uint64_t state = 7;
    float packed[3 * COUNT];
    double wide[3 * COUNT];
    unsigned char crooked[1 + COUNT * 25];
    const medax_points *made[4] = {NULL, NULL, NULL, NULL};
    for (size_t i = 0; i < COUNT; ++i) {
        for (size_t k = 0; k < 3; ++k) {
            packed[3 * i + k] = vertices[i].xyz[k] = (float)check_random(&state);
            wide[3 * i + k] = packed[3 * i + k];
        }
        memcpy(crooked + 1 + i * 25, wide + 3 * i, 24);
    }
    CHECK_STATUS(OK, medax_points_create_f64(wide, COUNT, 24, NULL, NULL, &made[0]));
    CHECK_STATUS(OK, medax_points_create_f32(packed, COUNT, 0, NULL, NULL, &made[1]));
    CHECK_STATUS(OK, medax_points_create_f32(vertices[0].xyz, COUNT, sizeof *vertices, NULL, NULL,
                                             &made[2]));
    CHECK_STATUS(OK, medax_points_create_f64((const double *)(const void *)(crooked + 1), COUNT, 25,
                                             NULL, NULL, &made[3]));
    for (size_t i = 0; i < 4; ++i) {
        const medax_view_f64 first = medax_points_coords(made[0]);
        const medax_view_f64 coords = medax_points_coords(made[i]);
        NEED(coords.rows == COUNT);
        CHECK(memcmp(first.data, coords.data, sizeof wide) == 0);
    }
    for (size_t i = 0; i < 4; ++i) medax_points_free(made[i]);
}

static void null_is_nothing(void) {
    const medax_view_f64 coords = medax_points_coords(NULL);
    CHECK(coords.data == NULL && coords.rows == 0 && coords.cols == 3);
    CHECK(medax_points_vertex_of_row(NULL).rows == 0);
    CHECK(medax_points_row_of_vertex(NULL).rows == 0);
    CHECK(medax_points_duplicate_of(NULL).data == NULL);
    CHECK(medax_points_count(NULL) == 0 && medax_points_row_count(NULL) == 0);
    CHECK(medax_points_duplicate_count(NULL) == 0 && medax_points_skipped_count(NULL) == 0);
    CHECK(medax_points_clone(NULL) == NULL);
    medax_points_free(NULL);
}

static void references(void) {
    const medax_points *points = check_points(10);
    const medax_points *again = medax_points_clone(points);
    CHECK(again == points);
    medax_points_free(points);
    CHECK(medax_points_count(again) == 10);
    medax_points_free(again);
}

int main(void) {
    refusals();
    maps();
    strides();
    null_is_nothing();
    references();
    return check_end();
}
