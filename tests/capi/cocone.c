/* Cocone and Tight Cocone, and labels by them. */
#include "check.h"

static const char nothing = 0;
#define UNTOUCHED ((const medax_cocone *)(const void *)&nothing)

static const medax_dual *dual_of(medax_shape shape, const medax_triangulation **t) {
    const medax_samples *samples = NULL;
    const medax_points *points = NULL;
    const medax_dual *dual = NULL;
    CHECK_STATUS(OK, medax_samples_build(shape, NULL, NULL, &samples));
    const medax_view_f64 xyz = medax_samples_coords(samples);
    CHECK_STATUS(OK, medax_points_create_f64(xyz.data, xyz.rows, 0, NULL, NULL, &points));
    CHECK_STATUS(OK, medax_delaunay_build(points, NULL, NULL, t));
    CHECK_STATUS(OK, medax_dual_build(*t, NULL, NULL, &dual));
    NEED(dual != NULL);
    medax_points_free(points);
    medax_samples_free(samples);
    return dual;
}

static void null_is_nothing(void) {
    const medax_complex *surface = NULL;
    const medax_labels *labels = NULL;
    medax_validation report;
    report.struct_size = sizeof report;
    CHECK(medax_cocone_is_inner(NULL).data == NULL && medax_cocone_is_inner(NULL).rows == 0);
    CHECK(medax_cocone_is_undersampled(NULL).rows == 0 && medax_cocone_used_count(NULL) == 0);
    CHECK(medax_cocone_is_well_sampled(NULL).rows == 0 && medax_cocone_marked_count(NULL) == 0);
    CHECK_STATUS(NULL_ARGUMENT, medax_cocone_surface(NULL, &surface));
    CHECK_STATUS(NULL_ARGUMENT, medax_cocone_open_surface(NULL, &surface));
    CHECK_STATUS(NULL_ARGUMENT, medax_labels_of_cocone(NULL, NULL, &labels));
    CHECK_STATUS(NULL_ARGUMENT, medax_cocone_validate(NULL, NULL, &report));
    CHECK(medax_cocone_clone(NULL) == NULL && surface == NULL && labels == NULL);
    medax_cocone_free(NULL);
}

static void refusals(const medax_dual *dual) {
    const medax_cocone *cocone = UNTOUCHED;
    const medax_job *spent = NULL;
    medax_cocone_options options;
    CHECK_STATUS(OK, medax_job_create(NULL, &spent));
    medax_job_cancel(spent);
    CHECK_STATUS(NULL_ARGUMENT, medax_cocone_build(NULL, NULL, NULL, &cocone));
    CHECK_STATUS(NULL_ARGUMENT, medax_cocone_build(dual, NULL, NULL, NULL));
    CHECK_STATUS(CANCELLED, medax_cocone_build(dual, NULL, spent, &cocone));
    CHECK_STATUS(NULL_ARGUMENT, medax_cocone_options_init(NULL, sizeof options));
    CHECK_STATUS(INVALID_ARGUMENT, medax_cocone_options_init(&options, 0));
    CHECK_STATUS(OK, medax_cocone_options_init(&options, sizeof options));
    CHECK(options.ratio == 1.2 && fabs(options.angle - acos(-1) / 8) < 1e-15);
    options.ratio = -1;
    CHECK_STATUS(INVALID_ARGUMENT, medax_cocone_build(dual, &options, NULL, &cocone));
    CHECK_STATUS(OK, medax_cocone_options_init(&options, sizeof options));
    options.angle = NAN;
    CHECK_STATUS(INVALID_ARGUMENT, medax_cocone_build(dual, &options, NULL, &cocone));
    CHECK(cocone == UNTOUCHED);
    medax_job_free(spent);
}

/* A torus: closed, one handle, all samples used, and the cells inside are those of the labels. */
static void torus(void) {
    const medax_triangulation *t = NULL;
    const medax_dual *dual = dual_of(MEDAX_SHAPE_TORUS, &t);
    const medax_cocone *cocone = NULL;
    const medax_complex *surface = NULL, *open = NULL;
    const medax_labels *labels = NULL;
    medax_topology topology;
    medax_validation report;
    refusals(dual);
    CHECK_STATUS(OK, medax_cocone_build(dual, NULL, NULL, &cocone));
    NEED(cocone != NULL);
    report.struct_size = sizeof report;
    CHECK_STATUS(OK, medax_cocone_validate(cocone, NULL, &report));
    CHECK(report.problems == 0 && report.checked > 0);
    CHECK_STATUS(OK, medax_cocone_surface(cocone, &surface));
    topology.struct_size = sizeof topology;
    CHECK_STATUS(OK, medax_complex_topology(surface, NULL, &topology));
    CHECK(topology.components == 1 && topology.euler_characteristic == 0 && topology.closed);
    const size_t samples = medax_triangulation_coords(t).rows;
    CHECK(medax_cocone_used_count(cocone) == samples);
    CHECK(medax_complex_vertices(surface).rows == samples);
    CHECK_STATUS(OK, medax_cocone_open_surface(cocone, &open));
    CHECK(medax_complex_faces(open).rows > samples);
    CHECK(medax_cocone_is_undersampled(cocone).rows == samples);
    /* All samples are dense enough, and every cell at one of them has a mark. */
    const medax_view_u8 well = medax_cocone_is_well_sampled(cocone);
    CHECK(well.rows == samples && memchr(well.data, 0, samples) == NULL);
    CHECK(medax_cocone_marked_count(cocone) == medax_triangulation_cells(t).rows);
    CHECK_STATUS(OK, medax_labels_of_cocone(cocone, NULL, &labels));
    const medax_view_u8 inner = medax_cocone_is_inner(cocone);
    CHECK(inner.rows == medax_triangulation_cells(t).rows);
    CHECK(memcmp(inner.data, medax_labels_is_inner(labels).data, inner.rows) == 0);
    /* What is left keeps alive what it needs. */
    const medax_cocone *copy = medax_cocone_clone(cocone);
    medax_cocone_free(cocone);
    medax_dual_free(dual);
    medax_triangulation_free(t);
    CHECK(medax_cocone_used_count(copy) == samples);
    medax_cocone_free(copy);
    CHECK(medax_labels_inner_count(labels) > 0);
    medax_labels_free(labels);
    medax_complex_free(open);
    medax_complex_free(surface);
}

int main(void) {
    null_is_nothing();
    torus();
    return check_end();
}
