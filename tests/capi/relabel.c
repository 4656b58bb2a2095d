/* Power crusts with other labels: given ones, and those that a mesh tells. */
#include "check.h"

#include <math.h>

static const char nothing = 0;
#define UNTOUCHED ((const medax_power_crust *)(const void *)&nothing)

enum { LATITUDES = 20, LONGITUDES = 40 };

/* Samples of the unit sphere. */
static const medax_points *samples(void) {
    enum { COUNT = 1000 };
    uint64_t state = 5;
    static double xyz[3 * COUNT];
    const medax_points *points = NULL;
    for (size_t i = 0; i < COUNT; ++i) check_direction(&state, xyz + 3 * i);
    CHECK_STATUS(OK, medax_points_create_f64(xyz, COUNT, 0, NULL, NULL, &points));
    NEED(points != NULL);
    return points;
}

/* A mesh of the unit sphere, its poles left out; turned inside out if `inward`. */
static const medax_complex *mesh(int inward) {
    static double xyz[3 * LATITUDES * LONGITUDES];
    static uint32_t offsets[LATITUDES * LONGITUDES + 1], rings[4 * LATITUDES * LONGITUDES];
    const double pi = 3.14159265358979323846;
    const medax_complex *complex = NULL;
    medax_complex_parts parts;
    size_t faces = 0;
    for (size_t i = 0; i < LATITUDES; ++i)
        for (size_t j = 0; j < LONGITUDES; ++j) {
            const double v = pi * ((double)i + 0.5) / LATITUDES, u = 2 * pi * (double)j / LONGITUDES;
            double *p = xyz + 3 * (i * LONGITUDES + j);
            p[0] = sin(v) * cos(u);
            p[1] = sin(v) * sin(u);
            p[2] = cos(v);
        }
    for (uint32_t i = 0; i + 1 < LATITUDES; ++i)
        for (uint32_t j = 0; j < LONGITUDES; ++j) {
            const uint32_t a = i * LONGITUDES + j, b = i * LONGITUDES + (j + 1) % LONGITUDES;
            uint32_t *ring = rings + 4 * faces;
            ring[0] = a;
            ring[inward ? 3 : 1] = a + LONGITUDES;
            ring[2] = b + LONGITUDES;
            ring[inward ? 1 : 3] = b;
            ++faces;
            offsets[faces] = (uint32_t)(4 * faces);
        }
    medax_complex_parts_init(&parts, sizeof parts);
    parts.vertices = xyz;
    parts.vertex_count = LATITUDES * LONGITUDES;
    parts.face_offsets = offsets;
    parts.face_indices = rings;
    parts.face_count = faces;
    CHECK_STATUS(OK, medax_complex_create(&parts, &complex));
    NEED(complex != NULL);
    return complex;
}

static int is_valid(const medax_power_crust *crust) {
    medax_validation report;
    report.struct_size = sizeof report;
    CHECK_STATUS(OK, medax_power_crust_validate(crust, NULL, &report));
    return report.problems == 0;
}

static size_t faces(const medax_power_crust *crust) {
    const medax_complex *surface = NULL;
    CHECK_STATUS(OK, medax_power_crust_surface(crust, &surface));
    const size_t count = medax_complex_faces(surface).rows;
    medax_complex_free(surface);
    return count;
}

static void given(const medax_power_crust *crust) {
    const medax_view_u32 labels = medax_power_crust_labels(crust);
    const medax_power_crust *other = NULL;
    uint32_t *changed = malloc(labels.rows * sizeof *changed);
    NEED(changed != NULL);
    memcpy(changed, labels.data, labels.rows * sizeof *changed);
    CHECK_STATUS(OK, medax_power_crust_with_labels(crust, changed, labels.rows, NULL, &other));
    NEED(other != NULL);
    CHECK(is_valid(other) && faces(other) == faces(crust) && faces(other) > 0);
    medax_power_crust_free(other);
    for (size_t p = 0; p < labels.rows; ++p) changed[p] = MEDAX_LABEL_INNER;
    CHECK_STATUS(OK, medax_power_crust_with_labels(crust, changed, labels.rows, NULL, &other));
    CHECK(is_valid(other) && medax_power_crust_forced_count(other) > 0);
    CHECK(medax_power_crust_unreached_count(other) == 0);
    medax_power_crust_free(other);

    other = UNTOUCHED;
    CHECK_STATUS(MISMATCH, medax_power_crust_with_labels(crust, changed, 1, NULL, &other));
    CHECK_STATUS(MISMATCH, medax_power_crust_with_labels(crust, NULL, 0, NULL, &other));
    changed[2] = 2;
    CHECK_STATUS(INVALID_ARGUMENT,
                 medax_power_crust_with_labels(crust, changed, labels.rows, NULL, &other));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 2);
    changed[2] = 0;
    CHECK_STATUS(NULL_ARGUMENT,
                 medax_power_crust_with_labels(NULL, changed, labels.rows, NULL, &other));
    CHECK_STATUS(NULL_ARGUMENT,
                 medax_power_crust_with_labels(crust, NULL, labels.rows, NULL, &other));
    CHECK_STATUS(NULL_ARGUMENT,
                 medax_power_crust_with_labels(crust, changed, labels.rows, NULL, NULL));
    CHECK(other == UNTOUCHED);
    free(changed);
}

static void by_mesh(const medax_power_crust *crust) {
    const medax_complex *outward = mesh(0), *inward = mesh(1);
    const medax_power_crust *other = NULL, *none = NULL, *offset = NULL;
    const medax_poles *poles = NULL;
    CHECK_STATUS(OK, medax_power_crust_labelled_by_mesh(crust, outward, NULL, &other));
    NEED(other != NULL);
    CHECK_STATUS(OK, medax_power_crust_poles(other, &poles));
    CHECK(is_valid(other));
    const medax_view_f64 balls = medax_poles_balls(poles);
    const medax_view_u32 labels = medax_power_crust_labels(other);
    for (size_t p = 0; p < balls.rows; ++p) {
        const double *c = balls.data + 4 * p;
        const double far = sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]) - 1;
        if (fabs(far) > 0.1) CHECK(labels.data[p] == (far > 0 ? MEDAX_LABEL_OUTER : MEDAX_LABEL_INNER));
    }
    CHECK_STATUS(OK, medax_power_crust_labelled_by_mesh(crust, inward, NULL, &none));
    CHECK(is_valid(none) && faces(none) == 0);
    medax_power_crust_free(none);
    medax_poles_free(poles);

    none = UNTOUCHED;
    const medax_job *spent = NULL;
    medax_complex_parts parts;
    const medax_complex *bare = NULL;
    medax_complex_parts_init(&parts, sizeof parts);
    CHECK_STATUS(OK, medax_complex_create(&parts, &bare));
    NEED(medax_job_create(NULL, &spent) == MEDAX_STATUS_OK);
    medax_job_cancel(spent);
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_labelled_by_mesh(NULL, outward, NULL, &none));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_labelled_by_mesh(crust, NULL, NULL, &none));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_labelled_by_mesh(crust, outward, NULL, NULL));
    CHECK_STATUS(INVALID_ARGUMENT, medax_power_crust_labelled_by_mesh(crust, bare, NULL, &none));
    CHECK_STATUS(CANCELLED, medax_power_crust_labelled_by_mesh(crust, outward, spent, &none));
    CHECK(none == UNTOUCHED);
    medax_job_free(spent);
    medax_complex_free(bare);
    medax_complex_free(inward);
    medax_complex_free(outward);

    /* The result keeps alive what it needs, and so do its variants. */
    medax_power_crust_free(crust);
    CHECK_STATUS(OK, medax_power_crust_offset(other, 0.1, NULL, &offset));
    medax_power_crust_free(other);
    CHECK(is_valid(offset) && faces(offset) > 0);
    medax_power_crust_free(offset);
}

int main(void) {
    const medax_points *points = samples();
    const medax_power_crust *crust = NULL;
    CHECK_STATUS(OK, medax_power_crust_build(points, NULL, NULL, &crust));
    NEED(crust != NULL);
    medax_points_free(points);
    given(crust);
    by_mesh(crust);
    return check_end();
}
