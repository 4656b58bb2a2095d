/* Labels of cells: given ones, those of a power crust and those of a mesh. */
#include "check.h"

static const char nothing = 0;
#define UNTOUCHED ((const medax_labels *)(const void *)&nothing)

/* Samples of the built-in torus: core circle of radius 1 about the z axis, tube of radius 0.4. */
static const medax_points *torus(void) {
    const medax_samples *samples = NULL;
    const medax_points *points = NULL;
    medax_sample_options options;
    medax_sample_options_init(&options, sizeof options);
    options.spacing = 0.15;
    CHECK_STATUS(OK, medax_samples_build(MEDAX_SHAPE_TORUS, &options, NULL, &samples));
    const medax_view_f64 xyz = medax_samples_coords(samples);
    CHECK_STATUS(OK, medax_points_create_f64(xyz.data, xyz.rows, 0, NULL, NULL, &points));
    medax_samples_free(samples);
    NEED(points != NULL);
    return points;
}

/* Whether the Voronoi vertex of each cell lies in the torus, for the caller to free. */
static uint8_t *in_torus(const medax_dual *dual) {
    const medax_view_f64 centers = medax_dual_centers(dual);
    uint8_t *flags = malloc(centers.rows);
    NEED(flags != NULL);
    for (size_t c = 0; c < centers.rows; ++c) {
        const double *p = centers.data + 3 * c;
        const double to_circle = sqrt(p[0] * p[0] + p[1] * p[1]) - 1;
        flags[c] = to_circle * to_circle + p[2] * p[2] < 0.16;
    }
    return flags;
}

static void null_is_nothing(void) {
    const medax_triangulation *triangulation = NULL;
    CHECK(medax_labels_is_inner(NULL).data == NULL && medax_labels_is_inner(NULL).rows == 0);
    CHECK(medax_labels_is_inner(NULL).cols == 1 && medax_labels_inner_count(NULL) == 0);
    CHECK_STATUS(NULL_ARGUMENT, medax_labels_triangulation(NULL, &triangulation));
    CHECK(medax_labels_clone(NULL) == NULL && triangulation == NULL);
    medax_labels_free(NULL);
}

static void given(const medax_triangulation *t, uint8_t *flags) {
    const size_t count = medax_triangulation_cells(t).rows;
    const medax_labels *labels = NULL, *other = NULL;
    const medax_triangulation *again = NULL;
    size_t inner = 0, differ = 99;
    for (size_t c = 0; c < count; ++c) inner += flags[c];
    CHECK_STATUS(OK, medax_labels_create(t, flags, count, &labels));
    NEED(labels != NULL);
    CHECK(medax_labels_inner_count(labels) == inner && inner > 0 && inner < count);
    CHECK(medax_labels_is_inner(labels).rows == count && medax_labels_is_inner(labels).cols == 1);
    CHECK(memcmp(medax_labels_is_inner(labels).data, flags, count) == 0);
    CHECK_STATUS(OK, medax_labels_triangulation(labels, &again));
    CHECK(medax_triangulation_cells(again).data == medax_triangulation_cells(t).data);

    /* Copied: what the caller changes afterwards changes nothing. */
    for (size_t c = 0; c < 3; ++c) flags[c] = !flags[c];
    CHECK_STATUS(OK, medax_labels_create(t, flags, count, &other));
    CHECK_STATUS(OK, medax_labels_disagreement(labels, other, &differ));
    CHECK(differ == 3);
    CHECK_STATUS(OK, medax_labels_disagreement(labels, labels, &differ));
    CHECK(differ == 0);
    medax_labels_free(other);
    for (size_t c = 0; c < 3; ++c) flags[c] = !flags[c];

    other = UNTOUCHED;
    CHECK_STATUS(MISMATCH, medax_labels_create(t, flags, count - 1, &other));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_CELL && medax_last_error_index() == count - 1);
    CHECK_STATUS(MISMATCH, medax_labels_create(t, NULL, 0, &other));
    flags[2] += 2;
    CHECK_STATUS(INVALID_ARGUMENT, medax_labels_create(t, flags, count, &other));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_CELL && medax_last_error_index() == 2);
    flags[2] -= 2;
    CHECK_STATUS(NULL_ARGUMENT, medax_labels_create(NULL, flags, count, &other));
    CHECK_STATUS(NULL_ARGUMENT, medax_labels_create(t, NULL, count, &other));
    CHECK_STATUS(NULL_ARGUMENT, medax_labels_create(t, flags, count, NULL));
    CHECK_STATUS(INVALID_ARGUMENT, medax_labels_create(t, flags, SIZE_MAX, &other));
    CHECK_STATUS(NULL_ARGUMENT, medax_labels_triangulation(labels, NULL));
    differ = 99;
    CHECK_STATUS(NULL_ARGUMENT, medax_labels_disagreement(NULL, labels, &differ));
    CHECK_STATUS(NULL_ARGUMENT, medax_labels_disagreement(labels, NULL, &differ));
    CHECK_STATUS(NULL_ARGUMENT, medax_labels_disagreement(labels, labels, NULL));
    CHECK(other == UNTOUCHED && differ == 99);

    const medax_labels *copy = medax_labels_clone(labels);
    medax_labels_free(labels);
    CHECK(copy == labels && medax_labels_inner_count(copy) == inner);
    medax_labels_free(copy);
    medax_triangulation_free(again);
}

static void found(const medax_dual *dual, const medax_points *points, const uint8_t *flags) {
    const size_t count = medax_dual_centers(dual).rows;
    const medax_labels *exact = NULL, *of_crust = NULL, *of_mesh = NULL, *none = UNTOUCHED;
    const medax_power_crust *crust = NULL, *elsewhere = NULL;
    const medax_complex *mesh = NULL, *bare = NULL;
    const medax_points *cloud = check_points(30);
    const medax_triangulation *t = NULL, *of_cloud = NULL;
    const medax_dual *cloud_dual = NULL;
    const medax_job *job = NULL;
    medax_complex_parts parts;
    size_t differ = count;
    CHECK_STATUS(OK, medax_dual_triangulation(dual, &t));
    CHECK_STATUS(OK, medax_labels_create(t, flags, count, &exact));
    CHECK_STATUS(OK, medax_power_crust_build(points, NULL, NULL, &crust));
    CHECK_STATUS(OK, medax_power_crust_surface(crust, &mesh));
    CHECK_STATUS(OK, medax_labels_of_crust(dual, crust, NULL, &of_crust));
    CHECK_STATUS(OK, medax_job_create(NULL, &job));
    CHECK_STATUS(OK, medax_labels_of_mesh(dual, mesh, job, &of_mesh));
    CHECK(strcmp(medax_job_stage(job), "label") == 0);
    NEED(exact != NULL && of_crust != NULL && of_mesh != NULL);
    CHECK(medax_labels_is_inner(of_crust).rows == count && medax_labels_is_inner(of_mesh).rows == count);
    /* Only cells of which the Voronoi vertex is next to the surface may have another label. */
    CHECK_STATUS(OK, medax_labels_disagreement(exact, of_crust, &differ));
    CHECK(differ < count / 20);
    CHECK_STATUS(OK, medax_labels_disagreement(of_crust, of_mesh, &differ));
    CHECK(differ < count / 50);

    CHECK_STATUS(OK, medax_power_crust_build(cloud, NULL, NULL, &elsewhere));
    CHECK_STATUS(OK, medax_delaunay_build(cloud, NULL, NULL, &of_cloud));
    CHECK_STATUS(OK, medax_dual_build(of_cloud, NULL, NULL, &cloud_dual));
    medax_complex_parts_init(&parts, sizeof parts);
    CHECK_STATUS(OK, medax_complex_create(&parts, &bare));
    medax_job_cancel(job);
    CHECK_STATUS(MISMATCH, medax_labels_of_crust(dual, elsewhere, NULL, &none));
    CHECK_STATUS(MISMATCH, medax_labels_of_crust(cloud_dual, crust, NULL, &none));
    CHECK_STATUS(NULL_ARGUMENT, medax_labels_of_crust(NULL, crust, NULL, &none));
    CHECK_STATUS(NULL_ARGUMENT, medax_labels_of_crust(dual, NULL, NULL, &none));
    CHECK_STATUS(NULL_ARGUMENT, medax_labels_of_crust(dual, crust, NULL, NULL));
    CHECK_STATUS(CANCELLED, medax_labels_of_crust(dual, crust, job, &none));
    CHECK_STATUS(INVALID_ARGUMENT, medax_labels_of_mesh(dual, bare, NULL, &none));
    CHECK_STATUS(NULL_ARGUMENT, medax_labels_of_mesh(NULL, mesh, NULL, &none));
    CHECK_STATUS(NULL_ARGUMENT, medax_labels_of_mesh(dual, NULL, NULL, &none));
    CHECK_STATUS(NULL_ARGUMENT, medax_labels_of_mesh(dual, mesh, NULL, NULL));
    CHECK_STATUS(CANCELLED, medax_labels_of_mesh(dual, mesh, job, &none));
    CHECK(none == UNTOUCHED);

    /* A mesh may be about anything. */
    CHECK_STATUS(OK, medax_labels_of_mesh(cloud_dual, mesh, NULL, &none));
    differ = 99;
    CHECK_STATUS(MISMATCH, medax_labels_disagreement(none, of_mesh, &differ));
    CHECK(differ == 99);
    medax_labels_free(none);

    /* An equal triangulation is as good as the same. */
    const medax_triangulation *equal = NULL;
    const medax_labels *of_equal = NULL;
    CHECK_STATUS(OK, medax_delaunay_build(points, NULL, NULL, &equal));
    CHECK_STATUS(OK, medax_labels_create(equal, flags, count, &of_equal));
    CHECK_STATUS(OK, medax_labels_disagreement(exact, of_equal, &differ));
    CHECK(differ == 0);
    medax_triangulation_free(equal);
    CHECK(medax_labels_inner_count(of_equal) == medax_labels_inner_count(exact));
    medax_labels_free(of_equal);

    medax_job_free(job);
    medax_complex_free(bare);
    medax_complex_free(mesh);
    medax_dual_free(cloud_dual);
    medax_triangulation_free(of_cloud);
    medax_points_free(cloud);
    medax_power_crust_free(elsewhere);
    medax_power_crust_free(crust);
    /* Labels keep alive what they need. */
    medax_points_free(points);
    medax_triangulation_free(t);
    medax_dual_free(dual);
    const medax_triangulation *again = NULL;
    CHECK_STATUS(OK, medax_labels_triangulation(of_crust, &again));
    medax_labels_free(of_crust);
    CHECK(medax_triangulation_cells(again).rows == count);
    medax_triangulation_free(again);
    medax_labels_free(of_mesh);
    medax_labels_free(exact);
}

int main(void) {
    const medax_points *points = torus();
    const medax_triangulation *t = NULL;
    const medax_dual *dual = NULL;
    CHECK_STATUS(OK, medax_delaunay_build(points, NULL, NULL, &t));
    CHECK_STATUS(OK, medax_dual_build(t, NULL, NULL, &dual));
    NEED(dual != NULL);
    uint8_t *flags = in_torus(dual);
    null_is_nothing();
    given(t, flags);
    medax_triangulation_free(t);
    found(dual, points, flags);
    free(flags);
    return check_end();
}
