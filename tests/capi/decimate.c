/* Fewer triangles for the same surface. */
#include "check.h"

enum { SIDE = 8, ROWS = SIDE + 1 };

/* A square of SIDE x SIDE squares. */
static const medax_complex *sheet(void) {
    static double xyz[3 * ROWS * ROWS];
    static uint32_t offsets[SIDE * SIDE + 1], rings[4 * SIDE * SIDE];
    medax_complex_parts parts;
    const medax_complex *complex = NULL;
    for (uint32_t i = 0; i < ROWS * ROWS; ++i) {
        xyz[3 * i] = i / ROWS;
        xyz[3 * i + 1] = i % ROWS;
    }
    for (uint32_t f = 0; f < SIDE * SIDE; ++f) {
        const uint32_t a = f / SIDE * ROWS + f % SIDE;
        const uint32_t ring[4] = {a, a + ROWS, a + ROWS + 1, a + 1};
        memcpy(rings + 4 * f, ring, sizeof ring);
        offsets[f + 1] = 4 * f + 4;
    }
    medax_complex_parts_init(&parts, sizeof parts);
    parts.vertices = xyz;
    parts.vertex_count = ROWS * ROWS;
    parts.face_offsets = offsets;
    parts.face_indices = rings;
    parts.face_count = SIDE * SIDE;
    CHECK_STATUS(OK, medax_complex_create(&parts, &complex));
    NEED(complex != NULL);
    return complex;
}

static size_t triangles_of(const medax_complex *complex) {
    return medax_complex_triangles(complex).rows;
}

int main(void) {
    const medax_complex *square = sheet(), *small = NULL;
    const medax_job *spent = NULL;
    medax_decimate_options options;
    double area = 0;
    NEED(medax_job_create(NULL, &spent) == MEDAX_STATUS_OK);
    medax_job_cancel(spent);

    CHECK_STATUS(NULL_ARGUMENT, medax_decimate_options_init(NULL, sizeof options));
    CHECK_STATUS(INVALID_ARGUMENT, medax_decimate_options_init(&options, 16));
    CHECK_STATUS(OK, medax_decimate_options_init(&options, sizeof options));
    CHECK(options.triangles == 0 && options.max_error > 1e308);
    options.triangles = 32;
    CHECK_STATUS(OK, medax_complex_decimate(square, &options, NULL, &small));
    NEED(small != NULL);
    CHECK(triangles_of(square) == 128 && triangles_of(small) <= 32 && triangles_of(small) > 28);
    CHECK_STATUS(OK, medax_complex_measure(small, NULL, &area, NULL));
    CHECK(area > 64 - 1e-9 && area < 64 + 1e-9);
    medax_complex_free(small);
    options.triangles = 2;
    options.max_error = 0;
    CHECK_STATUS(OK, medax_complex_decimate(square, &options, NULL, &small));
    CHECK(triangles_of(small) == 2);
    medax_complex_free(small);

    small = NULL;
    options.max_error = -1;
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_decimate(square, &options, NULL, &small));
    CHECK_STATUS(CANCELLED, medax_complex_decimate(square, NULL, spent, &small));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_decimate(NULL, NULL, NULL, &small));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_decimate(square, NULL, NULL, NULL));
    options.struct_size = 8;
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_decimate(square, &options, NULL, &small));
    CHECK(small == NULL);
    medax_complex_free(square);
    medax_job_free(spent);
    return check_end();
}
