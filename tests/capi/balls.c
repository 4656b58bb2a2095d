/* Unions of balls: how far points are from one, and its boundary. */
#include "boundary.h"

static const char untouched = 0;
#define UNTOUCHED ((const medax_balls *)(const void *)&untouched)
#define UNTOUCHED_MESH ((const medax_complex *)(const void *)&untouched)
static const double pi = 3.14159265358979323846;

static const medax_balls *balls_of(const double *centers, const double *radii, size_t count) {
    const medax_balls *balls = NULL;
    CHECK_STATUS(OK, medax_balls_create(centers, count, radii, count, NULL, &balls));
    NEED(balls != NULL);
    return balls;
}

static const medax_complex *boundary_of(const medax_balls *balls, double spacing) {
    medax_boundary_options options;
    const medax_complex *mesh = NULL;
    CHECK_STATUS(OK, medax_boundary_options_init(&options, sizeof options));
    CHECK(options.struct_size == sizeof options && options.spacing == 0);
    options.spacing = spacing;
    CHECK_STATUS(OK, medax_balls_boundary(balls, &options, NULL, &mesh));
    NEED(mesh != NULL && medax_complex_triangles(mesh).rows > 0);
    return mesh;
}

static double away(const double *p, const double *q) {
    return hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]);
}

/* Whether the mesh is a closed surface of so many pieces, all spheres, that points out; its area and volume. */
static int is_spheres(const medax_complex *mesh, uint64_t pieces, double *area, double *volume) {
    medax_topology topology;
    topology.struct_size = sizeof topology;
    CHECK_STATUS(OK, medax_complex_topology(mesh, NULL, &topology));
    CHECK_STATUS(OK, medax_complex_measure(mesh, NULL, area, volume));
    return topology.betti[0] == pieces && topology.betti[1] == 0 && topology.betti[2] == pieces && topology.closed
           && topology.oriented && topology.has_genus && topology.genus == 0 && topology.isolated_vertices == 0;
}

/* Vertices lie on the spheres that they name, and in no ball. */
static void on_spheres(const medax_balls *balls, const medax_complex *mesh) {
    const medax_view_f64 vertices = medax_complex_vertices(mesh), centers = medax_balls_centers(balls);
    medax_attribute ball;
    memset(&ball, 0, sizeof ball);
    CHECK_STATUS(OK, medax_complex_attribute(mesh, MEDAX_ELEMENT_VERTEX, "ball", &ball));
    NEED(ball.u32_values.rows == vertices.rows && ball.u32_values.cols == 1);
    double *distances = calloc(vertices.rows, sizeof *distances);
    NEED(distances != NULL);
    CHECK_STATUS(OK, medax_balls_distances(balls, vertices.data, vertices.rows, NULL, distances));
    size_t off = 0;
    for (size_t i = 0; i < vertices.rows; ++i) {
        const uint32_t b = ball.u32_values.data[i];
        NEED(b < centers.rows);
        const double r = medax_balls_radii(balls).data[b];
        off += fabs(away(vertices.data + 3 * i, centers.data + 3 * b) - r) > 1e-12 || fabs(distances[i]) > 1e-12;
    }
    CHECK(off == 0);
    free(distances);
}

/* Two balls that overlap in a lens, and one of them apart from a third. */
static void two_and_one(void) {
    static const double centers[9] = {0, 0, 0, 0, 1.1, 0, 5, 0, 0}, radii[3] = {1, 0.8, 0.5};
    static const double queries[15] = {0, 0, 0, 0, 1.1, 0.3, -3, -4, 0, 5, 0, 0.5, 4, 0, 0};
    static const double expected[5] = {-1, -0.5, 4, 0, 0.5};
    const medax_balls *balls = balls_of(centers, radii, 3);
    double found[6] = {7, 7, 7, 7, 7, 7}, min[3], max[3], area, volume;
    const medax_view_f64 c = medax_balls_centers(balls), r = medax_balls_radii(balls);
    NEED(medax_balls_count(balls) == 3 && c.rows == 3 && c.cols == 3 && r.rows == 3 && r.cols == 1);
    CHECK(memcmp(c.data, centers, sizeof centers) == 0 && memcmp(r.data, radii, sizeof radii) == 0);
    CHECK_STATUS(OK, medax_balls_bounds(balls, min, max));
    CHECK(min[0] == -1 && min[1] == -1 && min[2] == -1 && max[0] == 5.5 && max[1] == 1.1 + 0.8 && max[2] == 1);
    CHECK_STATUS(OK, medax_balls_distances(balls, queries, 5, NULL, found));
    for (size_t i = 0; i < 5; ++i) CHECK(fabs(found[i] - expected[i]) < 1e-15);
    CHECK(found[5] == 7);
    CHECK_STATUS(OK, medax_balls_distances(balls, NULL, 0, NULL, NULL));

    const medax_complex *mesh = boundary_of(balls, 0.16);
    const double d = 1.1, s = 0.8, t = d - 1 - s, height = (d * d + 1 - s * s) / (2 * d);
    const double lens = pi * t * t * (d * d + 2 * d * (1 + s) - 3 * (1 - s) * (1 - s)) / (12 * d);
    const double exact_volume = 4 * pi / 3 * (1 + s * s * s + 0.125) - lens;
    const double exact_area = 2 * pi * (1 + height + s * (s + d - height)) + pi;
    CHECK(is_spheres(mesh, 2, &area, &volume));
    CHECK(fabs(volume / exact_volume - 1) < 0.02 && fabs(area / exact_area - 1) < 0.02);
    on_spheres(balls, mesh);
    /* Finer it comes nearer. */
    double finer_area, finer_volume;
    const medax_complex *finer = boundary_of(balls, 0.08);
    CHECK(is_spheres(finer, 2, &finer_area, &finer_volume));
    CHECK(fabs(finer_volume - exact_volume) < 0.5 * fabs(volume - exact_volume));
    CHECK(fabs(finer_area - exact_area) < 0.5 * fabs(area - exact_area));
    medax_complex_free(finer);

    const medax_balls *copy = medax_balls_clone(balls);
    medax_balls_free(balls);
    CHECK(copy == balls && medax_balls_radii(copy).data == r.data && r.data[2] == 0.5);
    medax_balls_free(copy);
    CHECK(medax_complex_vertices(mesh).data[0] <= 5.5);
    medax_complex_free(mesh);
}

/* Without options the spacing is a hundredth of the diagonal. */
static void by_default(void) {
    static const double centers[6] = {0, 0, 0, 3, 4, 0}, radii[2] = {0.1, 0.2};
    const medax_balls *balls = balls_of(centers, radii, 2);
    double min[3], max[3];
    CHECK_STATUS(OK, medax_balls_bounds(balls, min, max));
    const medax_complex *plain = NULL, *zero = boundary_of(balls, 0), *same = boundary_of(balls, 0.01 * away(min, max));
    CHECK_STATUS(OK, medax_balls_boundary(balls, NULL, NULL, &plain));
    const medax_view_f64 a = medax_complex_vertices(plain), b = medax_complex_vertices(zero);
    const medax_view_f64 c = medax_complex_vertices(same);
    CHECK(a.rows == b.rows && memcmp(a.data, b.data, 24 * a.rows) == 0);
    CHECK(a.rows == c.rows && memcmp(a.data, c.data, 24 * a.rows) == 0);
    medax_complex_free(plain);
    medax_complex_free(zero);
    medax_complex_free(same);
    medax_balls_free(balls);
}

/* The axis of a sphere is its centre, whose ball is the solid again. */
static void of_an_axis(void) {
    const medax_piece sphere = piece(MEDAX_PIECE_KIND_SPHERE, 0, 1, 2, 3, 2, 0, 0);
    const medax_sites *sites = sites_of(3, &sphere, 1);
    static const double center[3] = {1, 2, 3};
    const medax_field_axis *axis = NULL;
    const medax_complex *complex = NULL, *bare = NULL;
    const medax_balls *balls = NULL;
    medax_field_axis_options options;
    double area, volume;
    CHECK_STATUS(OK, medax_field_axis_options_init(&options, sizeof options));
    options.side = MEDAX_SIDE_BOTH;
    options.density = 0.5;
    CHECK_STATUS(OK, medax_field_axis_build(sites, &options, NULL, &axis));
    CHECK_STATUS(OK, medax_field_axis_complex(axis, NULL, &complex));
    CHECK_STATUS(OK, medax_balls_of_complex(complex, NULL, &balls));
    NEED(medax_balls_count(balls) == medax_field_axis_points(axis).rows);
    medax_complex_free(complex);
    const medax_view_f64 centers = medax_balls_centers(balls), radii = medax_balls_radii(balls);
    CHECK(memcmp(centers.data, medax_field_axis_points(axis).data, 24 * centers.rows) == 0);
    CHECK(memcmp(radii.data, medax_field_axis_radii(axis).data, 8 * radii.rows) == 0);
    CHECK(away(centers.data, center) < 1e-4 && fabs(radii.data[0] - 2) < 1e-4);
    const medax_complex *mesh = boundary_of(balls, 0.2);
    CHECK(is_spheres(mesh, 1, &area, &volume));
    CHECK(fabs(volume / (32 * pi / 3) - 1) < 0.01 && fabs(area / (16 * pi) - 1) < 0.01);
    medax_field_axis_free(axis);
    medax_sites_free(sites);

    /* What carries no radius is no ball. */
    const medax_balls *none = UNTOUCHED;
    CHECK_STATUS(MISMATCH, medax_balls_of_complex(mesh, NULL, &none));
    medax_complex_parts parts;
    CHECK_STATUS(OK, medax_complex_parts_init(&parts, sizeof parts));
    static const double vertices[6] = {0, 0, 0, 1, 0, 0}, given[2] = {0.5, -0.25};
    medax_attribute radius;
    memset(&radius, 0, sizeof radius);
    radius.name = "radius";
    radius.element = MEDAX_ELEMENT_VERTEX;
    radius.value_type = MEDAX_VALUE_TYPE_F64;
    radius.f64_values.data = given;
    radius.f64_values.rows = 2;
    radius.f64_values.cols = 1;
    parts.vertices = vertices;
    parts.vertex_count = 2;
    parts.attributes = &radius;
    parts.attribute_count = 1;
    CHECK_STATUS(OK, medax_complex_create(&parts, &bare));
    CHECK_STATUS(INVALID_ARGUMENT, medax_balls_of_complex(bare, NULL, &none));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 1);
    const medax_job *spent = spent_job();
    CHECK_STATUS(CANCELLED, medax_balls_of_complex(bare, spent, &none));
    CHECK_STATUS(NULL_ARGUMENT, medax_balls_of_complex(NULL, NULL, &none));
    CHECK_STATUS(NULL_ARGUMENT, medax_balls_of_complex(bare, NULL, NULL));
    CHECK(none == UNTOUCHED);
    medax_job_free(spent);
    medax_complex_free(bare);
    medax_complex_free(mesh);
    medax_balls_free(balls);
}

/* Random balls that mostly overlap, in the unit cube. */
static const medax_balls *cloud(size_t count) {
    double *xyz = check_cloud(count), *radii = calloc(count, sizeof *radii);
    uint64_t state = 5;
    NEED(xyz != NULL && radii != NULL);
    for (size_t i = 0; i < count; ++i) radii[i] = (0.3 + 0.5 * check_random(&state)) / cbrt((double)count);
    const medax_balls *balls = balls_of(xyz, radii, count);
    free(xyz);
    free(radii);
    return balls;
}

/* The same bytes whatever the number of threads; and the least of all balls. */
static void threads(void) {
    const medax_balls *balls = cloud(60);
    const medax_job *one = job_with(0, 1), *three = job_with(0, 3);
    const medax_complex *a = NULL, *b = NULL;
    medax_boundary_options options;
    CHECK_STATUS(OK, medax_boundary_options_init(&options, sizeof options));
    options.spacing = 0.1;
    CHECK_STATUS(OK, medax_balls_boundary(balls, &options, one, &a));
    CHECK_STATUS(OK, medax_balls_boundary(balls, &options, three, &b));
    const medax_view_f64 p = medax_complex_vertices(a), q = medax_complex_vertices(b);
    const medax_view_u32 t = medax_complex_triangles(a), u = medax_complex_triangles(b);
    NEED(p.rows == q.rows && p.rows > 0 && t.rows == u.rows);
    CHECK(memcmp(p.data, q.data, 24 * p.rows) == 0 && memcmp(t.data, u.data, 12 * t.rows) == 0);
    on_spheres(balls, a);
    medax_complex_free(a);
    medax_complex_free(b);
    double *queries = check_cloud(200), found[200];
    NEED(queries != NULL);
    CHECK_STATUS(OK, medax_balls_distances(balls, queries, 200, three, found));
    size_t off = 0;
    for (size_t i = 0; i < 200; ++i) {
        double expected = HUGE_VAL;
        for (size_t k = 0; k < 60; ++k)
            expected = least(expected, away(queries + 3 * i, medax_balls_centers(balls).data + 3 * k)
                                           - medax_balls_radii(balls).data[k]);
        off += fabs(found[i] - expected) > 1e-14;
    }
    CHECK(off == 0);
    free(queries);
    medax_job_free(one);
    medax_job_free(three);
    medax_balls_free(balls);
}

static void no_balls(void) {
    const double nan = strtod("nan", NULL);
    const double center[9] = {0, 0, 0, 1, 0, 0, 2, 0, 0}, bad_center[9] = {0, 0, 0, 1, nan, 0, 2, 0, 0};
    const double far_center[9] = {0, 0, 0, 1, 0, 1e60, 2, 0, 0}, good[3] = {1, 1, 1};
    const double bad_radii[5] = {nan, HUGE_VAL, 0, -1, 1e-60};
    const medax_status expected[5] = {MEDAX_STATUS_NON_FINITE, MEDAX_STATUS_NON_FINITE, MEDAX_STATUS_INVALID_ARGUMENT,
                                      MEDAX_STATUS_INVALID_ARGUMENT, MEDAX_STATUS_COORDINATE_RANGE};
    const medax_balls *balls = UNTOUCHED;
    for (size_t i = 0; i < 5; ++i) {
        const double radii[3] = {1, 1, bad_radii[i]};
        CHECK(medax_balls_create(center, 3, radii, 3, NULL, &balls) == expected[i]);
        CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 2);
    }
    CHECK_STATUS(NON_FINITE, medax_balls_create(bad_center, 3, good, 3, NULL, &balls));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 1);
    CHECK_STATUS(COORDINATE_RANGE, medax_balls_create(far_center, 3, good, 3, NULL, &balls));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 1);
    const medax_job *spent = spent_job(), *small = job_with(100, 0);
    CHECK_STATUS(TOO_FEW_POINTS, medax_balls_create(NULL, 0, NULL, 0, NULL, &balls));
    CHECK_STATUS(NULL_ARGUMENT, medax_balls_create(NULL, 3, good, 3, NULL, &balls));
    CHECK_STATUS(NULL_ARGUMENT, medax_balls_create(center, 3, NULL, 3, NULL, &balls));
    CHECK_STATUS(NULL_ARGUMENT, medax_balls_create(center, 3, good, 3, NULL, NULL));
    CHECK_STATUS(INVALID_ARGUMENT, medax_balls_create(center, SIZE_MAX, good, 3, NULL, &balls));
    CHECK_STATUS(INVALID_ARGUMENT, medax_balls_create(center, 3, good, SIZE_MAX, NULL, &balls));
    CHECK_STATUS(MISMATCH, medax_balls_create(center, 3, good, 2, NULL, &balls));
    CHECK_STATUS(MISMATCH, medax_balls_create(center, 0, good, 3, NULL, &balls));
    CHECK_STATUS(CANCELLED, medax_balls_create(center, 3, good, 3, spent, &balls));
    CHECK_STATUS(OUT_OF_MEMORY, medax_balls_create(center, 3, good, 3, small, &balls));
    CHECK(balls == UNTOUCHED);
    medax_job_free(small);
    medax_job_free(spent);
}

static void refusals(void) {
    const double nan = strtod("nan", NULL);
    const medax_balls *balls = cloud(10);
    const medax_complex *mesh = UNTOUCHED_MESH;
    for (int i = 0; i < 5; ++i) {
        medax_boundary_options options;
        CHECK_STATUS(OK, medax_boundary_options_init(&options, sizeof options));
        switch (i) {
        case 0: options.spacing = -1; break;
        case 1: options.spacing = nan; break;
        case 2: options.spacing = HUGE_VAL; break;
        case 3: options.struct_size = 8; break;
        default: options.struct_size = 15;
        }
        CHECK_STATUS(INVALID_ARGUMENT, medax_balls_boundary(balls, &options, NULL, &mesh));
    }
    const medax_job *spent = spent_job(), *small = job_with(2000, 0);
    CHECK_STATUS(CANCELLED, medax_balls_boundary(balls, NULL, spent, &mesh));
    CHECK_STATUS(OUT_OF_MEMORY, medax_balls_boundary(balls, NULL, small, &mesh));
    CHECK_STATUS(NULL_ARGUMENT, medax_balls_boundary(NULL, NULL, NULL, &mesh));
    CHECK_STATUS(NULL_ARGUMENT, medax_balls_boundary(balls, NULL, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_boundary_options_init(NULL, sizeof(medax_boundary_options)));
    static const double ones[3] = {1, 1, 1}, speck = 1e-16;
    const medax_balls *tiny = balls_of(ones, &speck, 1);
    CHECK_STATUS(COORDINATE_RANGE, medax_balls_boundary(tiny, NULL, NULL, &mesh));
    medax_balls_free(tiny);
    /* A newer program's struct may be longer, if it asks for nothing new. */
    struct {
        medax_boundary_options known;
        double later;
    } newer;
    CHECK_STATUS(OK, medax_boundary_options_init(&newer.known, sizeof newer));
    newer.later = 1;
    CHECK_STATUS(INVALID_ARGUMENT, medax_balls_boundary(balls, &newer.known, NULL, &mesh));
    CHECK(mesh == UNTOUCHED_MESH);
    newer.later = 0;
    newer.known.spacing = 0.2;
    CHECK_STATUS(OK, medax_balls_boundary(balls, &newer.known, NULL, &mesh));
    medax_complex_free(mesh);

    double queries[9] = {0, 0, 0, 1, nan, 1, 0, 0, 1e300}, found[3] = {7, 7, 7};
    CHECK_STATUS(NON_FINITE, medax_balls_distances(balls, queries, 3, NULL, found));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 1);
    queries[4] = 1;
    CHECK_STATUS(COORDINATE_RANGE, medax_balls_distances(balls, queries, 3, NULL, found));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 2);
    CHECK_STATUS(NULL_ARGUMENT, medax_balls_distances(NULL, queries, 1, NULL, found));
    CHECK_STATUS(NULL_ARGUMENT, medax_balls_distances(balls, NULL, 1, NULL, found));
    CHECK_STATUS(NULL_ARGUMENT, medax_balls_distances(balls, queries, 1, NULL, NULL));
    CHECK_STATUS(INVALID_ARGUMENT, medax_balls_distances(balls, queries, SIZE_MAX, NULL, found));
    CHECK_STATUS(CANCELLED, medax_balls_distances(balls, queries, 2, spent, found));
    CHECK(found[0] == 7 && found[1] == 7 && found[2] == 7);
    CHECK_STATUS(NULL_ARGUMENT, medax_balls_bounds(balls, NULL, found));
    CHECK_STATUS(NULL_ARGUMENT, medax_balls_bounds(balls, found, NULL));
    CHECK(found[0] == 7);
    medax_job_free(small);
    medax_job_free(spent);
    medax_balls_free(balls);
}

static void cancelled(void) {
    char stage[] = "sample";
    const medax_balls *balls = cloud(500);
    const medax_job *job = stopping_job(stage);
    const medax_complex *mesh = UNTOUCHED_MESH;
    medax_boundary_options options;
    CHECK_STATUS(OK, medax_boundary_options_init(&options, sizeof options));
    options.spacing = 0.001;
    CHECK_STATUS(CANCELLED, medax_balls_boundary(balls, &options, job, &mesh));
    CHECK(mesh == UNTOUCHED_MESH && medax_job_is_cancelled(job));
    CHECK(strcmp(medax_job_stage(job), stage) == 0);
    medax_job_free(job);
    medax_balls_free(balls);
}

static void null_is_nothing(void) {
    double min[3], max[3];
    CHECK(medax_balls_count(NULL) == 0 && medax_balls_clone(NULL) == NULL);
    CHECK(medax_balls_centers(NULL).cols == 3 && medax_balls_centers(NULL).rows == 0);
    CHECK(medax_balls_radii(NULL).cols == 1 && medax_balls_radii(NULL).data == NULL);
    CHECK_STATUS(NULL_ARGUMENT, medax_balls_bounds(NULL, min, max));
    medax_balls_free(NULL);
}

int main(void) {
    two_and_one();
    by_default();
    of_an_axis();
    threads();
    no_balls();
    refusals();
    cancelled();
    null_is_nothing();
    return check_end();
}
