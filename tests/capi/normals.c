/* Normals of complexes at their vertices. */
#include "check.h"

/* An octahedron round the origin and a vertex without faces; with `inward`, turned inside out. */
static const medax_complex *octahedron(int inward) {
    static const double xyz[21] = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 9, 9, 9};
    uint32_t offsets[9] = {0}, rings[24];
    medax_complex_parts parts;
    const medax_complex *complex = NULL;
    for (uint32_t face = 0; face < 8; ++face) {
        const uint32_t x = face & 1, y = 2 + (face >> 1 & 1), z = 4 + (face >> 2 & 1);
        const int odd = ((face ^ face >> 1 ^ face >> 2) & 1) != (uint32_t)inward;
        rings[3 * face] = x;
        rings[3 * face + 1] = odd ? z : y;
        rings[3 * face + 2] = odd ? y : z;
        offsets[face + 1] = 3 * (face + 1);
    }
    medax_complex_parts_init(&parts, sizeof parts);
    parts.vertices = xyz;
    parts.vertex_count = 7;
    parts.face_offsets = offsets;
    parts.face_indices = rings;
    parts.face_count = 8;
    CHECK_STATUS(OK, medax_complex_create(&parts, &complex));
    NEED(complex != NULL);
    return complex;
}

static void directions(void) {
    for (int inward = 0; inward < 2; ++inward) {
        const medax_complex *complex = octahedron(inward);
        const medax_view_f64 vertices = medax_complex_vertices(complex);
        double found[22];
        found[21] = 7;
        CHECK_STATUS(OK, medax_complex_vertex_normals(complex, NULL, 7, found));
        for (size_t i = 0; i < 18; ++i)
            CHECK(fabs(found[i] - (inward ? -1 : 1) * vertices.data[i]) < 1e-12);
        CHECK(found[18] == 0 && found[19] == 0 && found[20] == 0 && found[21] == 7);
        medax_complex_free(complex);
    }
}

static void refusals(void) {
    const medax_complex *complex = octahedron(0), *empty = NULL;
    const medax_job *spent = NULL;
    medax_complex_parts parts;
    double found[24] = {7};
    medax_complex_parts_init(&parts, sizeof parts);
    CHECK_STATUS(OK, medax_complex_create(&parts, &empty));
    NEED(medax_job_create(NULL, &spent) == MEDAX_STATUS_OK);
    medax_job_cancel(spent);
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_vertex_normals(NULL, NULL, 7, found));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_vertex_normals(complex, NULL, 7, NULL));
    CHECK_STATUS(MISMATCH, medax_complex_vertex_normals(complex, NULL, 0, NULL));
    CHECK_STATUS(MISMATCH, medax_complex_vertex_normals(complex, NULL, 6, found));
    CHECK_STATUS(MISMATCH, medax_complex_vertex_normals(complex, NULL, 8, found));
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_vertex_normals(complex, NULL, SIZE_MAX, found));
    CHECK_STATUS(CANCELLED, medax_complex_vertex_normals(complex, spent, 7, found));
    CHECK(found[0] == 7);
    CHECK_STATUS(OK, medax_complex_vertex_normals(empty, NULL, 0, NULL));
    medax_job_free(spent);
    medax_complex_free(empty);
    medax_complex_free(complex);
}

int main(void) {
    directions();
    refusals();
    return check_end();
}
