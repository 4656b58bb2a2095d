/* Distances between complexes. */
#include "check.h"

static const medax_complex *square_at(double z) {
    const double xyz[12] = {0, 0, z, 1, 0, z, 1, 1, z, 0, 1, z};
    const uint32_t offsets[2] = {0, 4}, ring[4] = {0, 1, 2, 3};
    medax_complex_parts parts;
    const medax_complex *complex = NULL;
    medax_complex_parts_init(&parts, sizeof parts);
    parts.vertices = xyz;
    parts.vertex_count = 4;
    parts.face_offsets = offsets;
    parts.face_indices = ring;
    parts.face_count = 1;
    CHECK_STATUS(OK, medax_complex_create(&parts, &complex));
    NEED(complex != NULL);
    return complex;
}

/* Equal up to rounding. */
static int is(double found, double expected) {
    return found - expected < 1e-9 && expected - found < 1e-9;
}

int main(void) {
    const medax_complex *low = square_at(0), *high = square_at(2), *empty = NULL;
    const medax_job *spent = NULL;
    medax_complex_parts none;
    medax_compare_options options;
    medax_comparison report;
    NEED(medax_job_create(NULL, &spent) == MEDAX_STATUS_OK);
    medax_job_cancel(spent);
    medax_complex_parts_init(&none, sizeof none);
    CHECK_STATUS(OK, medax_complex_create(&none, &empty));

    CHECK_STATUS(NULL_ARGUMENT, medax_compare_options_init(NULL, sizeof options));
    CHECK_STATUS(INVALID_ARGUMENT, medax_compare_options_init(&options, 16));
    CHECK_STATUS(OK, medax_compare_options_init(&options, sizeof options));
    CHECK(options.samples == 100000 && options.seed == 0);
    options.samples = 1000;
    report.struct_size = sizeof report;
    CHECK_STATUS(OK, medax_complex_compare(low, high, &options, NULL, &report));
    CHECK(report.struct_size == sizeof report);
    CHECK(is(report.a_to_b_max, 2) && is(report.a_to_b_mean, 2) && is(report.a_to_b_rms, 2));
    CHECK(is(report.b_to_a_max, 2) && is(report.b_to_a_mean, 2) && is(report.b_to_a_rms, 2));
    CHECK(is(report.diagonal * report.diagonal, 6));
    CHECK_STATUS(OK, medax_complex_compare(low, low, NULL, NULL, &report));
    CHECK(is(report.a_to_b_max, 0) && is(report.b_to_a_rms, 0));
    options.samples = 0;
    CHECK_STATUS(OK, medax_complex_compare(low, high, &options, NULL, &report));
    CHECK(is(report.a_to_b_max, 2));

    memset(&report, 0, sizeof report);
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_compare(low, high, NULL, NULL, &report));
    report.struct_size = sizeof report;
    CHECK_STATUS(TOO_FEW_POINTS, medax_complex_compare(low, empty, NULL, NULL, &report));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_compare(NULL, high, NULL, NULL, &report));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_compare(low, NULL, NULL, NULL, &report));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_compare(low, high, NULL, NULL, NULL));
    CHECK_STATUS(CANCELLED, medax_complex_compare(low, high, NULL, spent, &report));
    options.struct_size = 8;
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_compare(low, high, &options, NULL, &report));
    CHECK(report.diagonal == 0);
    medax_complex_free(empty);
    medax_complex_free(high);
    medax_complex_free(low);
    medax_job_free(spent);
    return check_end();
}
