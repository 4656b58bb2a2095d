/* Winding numbers of complexes. */
#include "check.h"

#include <math.h>

/* A tetrahedron round the origin, pointing out; with `inward`, in. Without faces if `bare`. */
static const medax_complex *tetrahedron(int inward, int bare) {
    static const double xyz[12] = {1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1};
    static const uint32_t offsets[5] = {0, 3, 6, 9, 12};
    static const uint32_t out[12] = {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2};
    static const uint32_t in[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    medax_complex_parts parts;
    const medax_complex *complex = NULL;
    medax_complex_parts_init(&parts, sizeof parts);
    parts.vertices = xyz;
    parts.vertex_count = 4;
    parts.face_offsets = bare ? NULL : offsets;
    parts.face_indices = bare ? NULL : inward ? in : out;
    parts.face_count = bare ? 0 : 4;
    CHECK_STATUS(OK, medax_complex_create(&parts, &complex));
    NEED(complex != NULL);
    return complex;
}

static void numbers(void) {
    /* The last one lies on an edge, round which the solid fills its dihedral angle. */
    const double queries[12] = {0, 0, 0, 0.1, 0.2, -0.1, 9, 9, 9, 1, 0, 0};
    const double expected[4] = {1, 1, 0, acos(1.0 / 3) / (2 * 3.14159265358979323846)};
    for (int inward = 0; inward < 2; ++inward) {
        const medax_complex *complex = tetrahedron(inward, 0);
        double found[5] = {7, 7, 7, 7, 7};
        CHECK_STATUS(OK, medax_complex_winding_numbers(complex, queries, 4, NULL, found));
        for (size_t i = 0; i < 4; ++i)
            CHECK(fabs(found[i] - (inward ? -1 : 1) * expected[i]) < 1e-12);
        CHECK(found[4] == 7);
        medax_complex_free(complex);
    }
}

static void refusals(void) {
    const double nan = strtod("nan", NULL);
    const medax_complex *complex = tetrahedron(0, 0), *bare = tetrahedron(0, 1);
    const medax_job *spent = NULL;
    double queries[6] = {0, 0, 0, 0, nan, 0}, found[2] = {7, 7};
    NEED(medax_job_create(NULL, &spent) == MEDAX_STATUS_OK);
    medax_job_cancel(spent);
    CHECK_STATUS(NON_FINITE, medax_complex_winding_numbers(complex, queries, 2, NULL, found));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 1);
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_winding_numbers(NULL, queries, 1, NULL, found));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_winding_numbers(complex, NULL, 1, NULL, found));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_winding_numbers(complex, queries, 1, NULL, NULL));
    CHECK_STATUS(INVALID_ARGUMENT,
                 medax_complex_winding_numbers(complex, queries, SIZE_MAX, NULL, found));
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_winding_numbers(bare, queries, 1, NULL, found));
    CHECK_STATUS(CANCELLED, medax_complex_winding_numbers(complex, queries, 1, spent, found));
    CHECK(found[0] == 7 && found[1] == 7);
    CHECK_STATUS(OK, medax_complex_winding_numbers(complex, NULL, 0, NULL, NULL));
    medax_job_free(spent);
    medax_complex_free(bare);
    medax_complex_free(complex);
}

int main(void) {
    numbers();
    refusals();
    return check_end();
}
