/* Duals, and poles of a sample alone. */
#include "check.h"

static const char nothing = 0;
#define UNTOUCHED ((const medax_dual *)(const void *)&nothing)

static const medax_triangulation *delaunay(size_t count) {
    const medax_points *points = check_points(count);
    const medax_triangulation *triangulation = NULL;
    CHECK_STATUS(OK, medax_delaunay_build(points, NULL, NULL, &triangulation));
    medax_points_free(points);
    NEED(triangulation != NULL);
    return triangulation;
}

static void refusals(void) {
    const medax_triangulation *t = delaunay(10);
    const medax_dual *dual = UNTOUCHED;
    const medax_job *spent = NULL;
    medax_dual_options options;
    NEED(medax_job_create(NULL, &spent) == MEDAX_STATUS_OK);
    medax_job_cancel(spent);
    CHECK_STATUS(NULL_ARGUMENT, medax_dual_build(NULL, NULL, NULL, &dual));
    CHECK_STATUS(NULL_ARGUMENT, medax_dual_build(t, NULL, NULL, NULL));
    CHECK_STATUS(CANCELLED, medax_dual_build(t, NULL, spent, &dual));
    CHECK_STATUS(NULL_ARGUMENT, medax_dual_options_init(NULL, sizeof options));
    CHECK_STATUS(INVALID_ARGUMENT, medax_dual_options_init(&options, 12));
    CHECK_STATUS(OK, medax_dual_options_init(&options, sizeof options));
    CHECK(options.facets == 0);
    options.facets = 2;
    CHECK_STATUS(INVALID_ARGUMENT, medax_dual_build(t, &options, NULL, &dual));
    options.facets = 1;
    options.reserved = 1;
    CHECK_STATUS(INVALID_ARGUMENT, medax_dual_build(t, &options, NULL, &dual));
    CHECK(dual == UNTOUCHED);
    medax_job_free(spent);
    medax_triangulation_free(t);
}

static void null_is_nothing(void) {
    const medax_triangulation *triangulation = NULL;
    medax_validation report;
    report.struct_size = sizeof report;
    CHECK(medax_dual_centers(NULL).rows == 0 && medax_dual_radii_squared(NULL).data == NULL);
    CHECK(medax_dual_ray_facets(NULL).rows == 0 && medax_dual_ray_directions(NULL).cols == 3);
    CHECK(medax_dual_facets(NULL).offsets == NULL && medax_dual_facet_edges(NULL).rows == 0);
    CHECK(medax_dual_facet_rays(NULL).rows == 0 && medax_dual_clone(NULL) == NULL);
    CHECK_STATUS(NULL_ARGUMENT, medax_dual_triangulation(NULL, &triangulation));
    CHECK_STATUS(NULL_ARGUMENT, medax_dual_validate(NULL, NULL, &report));
    CHECK(triangulation == NULL);
    medax_dual_free(NULL);
}

static double square_distance(const double *p, const double *q) {
    double sum = 0;
    for (size_t k = 0; k < 3; ++k) sum += (p[k] - q[k]) * (p[k] - q[k]);
    return sum;
}

static void views(void) {
    const medax_triangulation *t = delaunay(200), *again = NULL;
    const medax_dual *dual = NULL, *plain = NULL;
    const medax_incidence *incidence = NULL;
    medax_dual_options options;
    medax_validation report;
    size_t unbounded = 0, on_hull = 0;
    medax_dual_options_init(&options, sizeof options);
    options.facets = 1;
    CHECK_STATUS(OK, medax_dual_build(t, &options, NULL, &dual));
    CHECK_STATUS(OK, medax_dual_build(t, NULL, NULL, &plain));
    CHECK_STATUS(OK, medax_incidence_build(t, NULL, &incidence));
    NEED(dual != NULL && plain != NULL && incidence != NULL);
    const medax_view_u32 cells = medax_triangulation_cells(t);
    const medax_view_u32 neighbors = medax_triangulation_neighbors(t);
    const medax_view_f64 coords = medax_triangulation_coords(t);
    const medax_view_f64 centers = medax_dual_centers(dual);
    const medax_view_f64 squares = medax_dual_radii_squared(dual);
    NEED(centers.rows == cells.rows && centers.cols == 3);
    NEED(squares.rows == cells.rows && squares.cols == 1);
    for (size_t c = 0; c < cells.rows; ++c) {
        for (size_t i = 0; i < 4; ++i) {
            const uint32_t vertex = cells.data[4 * c + i];
            const double square = square_distance(centers.data + 3 * c, coords.data + 3 * vertex);
            CHECK(square > 0.999 * squares.data[c] && square < 1.001 * squares.data[c]);
            on_hull += neighbors.data[4 * c + i] == MEDAX_NONE;
        }
    }
    const medax_view_u32 rays = medax_dual_ray_facets(dual);
    const medax_view_f64 directions = medax_dual_ray_directions(dual);
    const double origin[3] = {0, 0, 0};
    NEED(rays.rows == on_hull && rays.cols == 2 && directions.rows == on_hull);
    for (size_t r = 0; r < rays.rows; ++r) {
        const double square = square_distance(origin, directions.data + 3 * r);
        CHECK(neighbors.data[4 * rays.data[2 * r] + rays.data[2 * r + 1]] == MEDAX_NONE);
        CHECK(square > 0.999999 && square < 1.000001);
    }
    const medax_view_rows facets = medax_dual_facets(dual);
    const medax_view_u32 edges = medax_dual_facet_edges(dual);
    const medax_view_u32 facet_rays = medax_dual_facet_rays(dual);
    NEED(facets.rows == medax_incidence_edges(incidence).rows && edges.rows == facets.rows);
    NEED(facet_rays.rows == facets.rows && facet_rays.cols == 2);
    CHECK(memcmp(edges.data, medax_incidence_edges(incidence).data, 8 * edges.rows) == 0);
    for (size_t f = 0; f < facets.rows; ++f) {
        const int open = facet_rays.data[2 * f] != MEDAX_NONE;
        CHECK(open == (facet_rays.data[2 * f + 1] != MEDAX_NONE));
        CHECK(facets.offsets[f + 1] - facets.offsets[f] >= (open ? 1u : 3u));
        unbounded += (size_t)open;
    }
    /* Every edge of the hull, which is a triangulated sphere: 3/2 of its facets. */
    CHECK(2 * unbounded == 3 * on_hull);
    CHECK(medax_dual_facets(plain).rows == 0 && medax_dual_facet_edges(plain).rows == 0);
    CHECK(medax_dual_facet_rays(plain).rows == 0 && medax_dual_centers(plain).rows == cells.rows);

    report.struct_size = sizeof report;
    CHECK_STATUS(OK, medax_dual_validate(dual, NULL, &report));
    CHECK(report.problems == 0 && report.checked > 0);
    CHECK_STATUS(NULL_ARGUMENT, medax_dual_validate(dual, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_dual_triangulation(dual, NULL));
    CHECK_STATUS(OK, medax_dual_triangulation(dual, &again));
    medax_triangulation_free(t);
    const medax_dual *copy = medax_dual_clone(dual);
    medax_dual_free(dual);
    CHECK(copy == dual && medax_dual_centers(copy).data == centers.data);
    medax_dual_free(copy);
    CHECK(medax_triangulation_cells(again).data[0] < 200);
    medax_triangulation_free(again);
    medax_incidence_free(incidence);
    medax_dual_free(plain);
}

/* Poles of a sample alone: at infinity on the hull. */
static void poles(void) {
    const medax_triangulation *t = delaunay(200), *r = NULL;
    const medax_points *points = NULL;
    const medax_dual *dual = NULL, *power = NULL;
    const medax_poles *found = NULL;
    const medax_power_crust *crust = NULL;
    medax_poles_options options;
    medax_validation report;
    double weights[200];
    size_t at_infinity = 0;
    for (size_t i = 0; i < 200; ++i) weights[i] = (double)i / 1e4;
    CHECK_STATUS(OK, medax_triangulation_points(t, &points));
    CHECK_STATUS(OK, medax_regular_build(points, weights, 200, NULL, NULL, &r));
    CHECK_STATUS(OK, medax_dual_build(t, NULL, NULL, &dual));
    CHECK_STATUS(OK, medax_dual_build(r, NULL, NULL, &power));
    CHECK_STATUS(INVALID_ARGUMENT, medax_poles_build(power, NULL, NULL, &found));
    CHECK_STATUS(NULL_ARGUMENT, medax_poles_build(NULL, NULL, NULL, &found));
    CHECK_STATUS(NULL_ARGUMENT, medax_poles_build(dual, NULL, NULL, NULL));
    options.struct_size = 0;
    CHECK_STATUS(INVALID_ARGUMENT, medax_poles_build(dual, &options, NULL, &found));
    CHECK(found == NULL);
    CHECK_STATUS(OK, medax_poles_build(dual, NULL, NULL, &found));
    NEED(found != NULL);
    CHECK(!medax_poles_has_far_box(found));
    const medax_view_u32 of_sample = medax_poles_pole_of_sample(found);
    NEED(of_sample.rows == 200);
    for (size_t i = 0; i < 200; ++i) at_infinity += of_sample.data[2 * i] == MEDAX_NONE;
    CHECK(at_infinity >= 4 && at_infinity < 200);
    report.struct_size = sizeof report;
    CHECK_STATUS(OK, medax_poles_validate(found, NULL, &report));
    CHECK(report.problems == 0);
    CHECK_STATUS(MISMATCH, medax_power_crust_build_from_poles(found, NULL, NULL, &crust));
    CHECK(crust == NULL);
    medax_triangulation_free(t);
    medax_triangulation_free(r);
    medax_dual_free(dual);
    medax_dual_free(power);
    medax_points_free(points);
    CHECK(medax_poles_balls(found).rows > 0 && medax_poles_balls(found).data[3] > 0);
    medax_poles_free(found);
}

int main(void) {
    refusals();
    null_is_nothing();
    views();
    poles();
    return check_end();
}
