/* The flow of the distance to samples of a torus: critical points, drivers, orbits, closures. */
#include "torus.h"

static const char nothing = 0;
#define UNTOUCHED ((const medax_flow *)(const void *)&nothing)
#define NO_COMPLEX ((const medax_complex *)(const void *)&nothing)

static const medax_flow *built(const torus *made, const medax_flow_options *options) {
    const medax_flow *flow = NULL;
    CHECK_STATUS(OK, medax_flow_build(made->dual, made->labels, options, NULL, &flow));
    NEED(flow != NULL);
    return flow;
}

static medax_simplex simplex(uint32_t dimension, uint32_t number) {
    const medax_simplex made = {dimension, number};
    return made;
}

static void initial(void) {
    medax_flow_options options;
    CHECK_STATUS(OK, medax_flow_options_init(&options, sizeof options));
    CHECK(options.struct_size == sizeof options && options.least_slope == 0.5);
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_options_init(NULL, sizeof options));
    CHECK_STATUS(INVALID_ARGUMENT, medax_flow_options_init(&options, sizeof options - 8));
}

static void null_is_nothing(void) {
    const medax_dual *dual = NULL;
    const medax_labels *labels = NULL;
    const medax_complex *complex = NO_COMPLEX;
    const double origin[3] = {0, 0, 0};
    double gap[2] = {7, 7};
    uint32_t end = 77;
    medax_flow_point at;
    medax_validation report;
    at.angle = 9;
    report.struct_size = sizeof report;
    CHECK(medax_flow_critical_count(NULL) == 0 && medax_flow_critical_points(NULL).data == NULL);
    CHECK(medax_flow_critical_simplices(NULL).rows == 0
          && medax_flow_critical_simplices(NULL).cols == 2);
    CHECK(medax_flow_critical_distances(NULL).rows == 0
          && medax_flow_critical_points(NULL).cols == 3);
    CHECK(medax_flow_critical_corners(NULL).cols == 4
          && medax_flow_critical_slopes(NULL).rows == 0);
    CHECK(medax_flow_critical_shares(NULL).cols == 1
          && medax_flow_critical_classes(NULL).rows == 0);
    CHECK(medax_flow_critical_row(NULL, simplex(0, 0)) == MEDAX_NONE);
    CHECK(medax_flow_triangles(NULL).cols == 2 && medax_flow_triangles(NULL).data == NULL);
    CHECK(medax_flow_driver_of_triangle(NULL, 0).number == MEDAX_NONE);
    CHECK(medax_flow_driver_of_cell(NULL, 0).number == MEDAX_NONE);
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_gap(NULL, gap));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_critical_complex(NULL, NULL, &complex));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_dual(NULL, &dual));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_labels(NULL, &labels));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_at(NULL, origin, 1, NULL, &at));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_orbits(NULL, origin, 1, NULL, &end, &complex));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_closure(NULL, NULL, 0, NULL, &complex));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_validate(NULL, NULL, &report));
    CHECK(medax_flow_clone(NULL) == NULL && dual == NULL && labels == NULL);
    CHECK(complex == NO_COMPLEX && at.angle == 9 && gap[0] == 7 && end == 77);
    medax_flow_free(NULL);
}

static void refused_builds(const torus *made) {
    const medax_points *cloud = check_points(30);
    const medax_triangulation *of_cloud = NULL, *regular = NULL;
    const medax_dual *plain = NULL, *power = NULL, *other = NULL;
    const medax_flow *flow = UNTOUCHED;
    const medax_job *spent = NULL;
    medax_dual_options with_facets;
    medax_flow_options options;
    double weights[30];
    for (size_t i = 0; i < 30; ++i) weights[i] = (double)i / 1e4;
    medax_dual_options_init(&with_facets, sizeof with_facets);
    with_facets.facets = 1;
    CHECK_STATUS(OK, medax_delaunay_build(cloud, NULL, NULL, &of_cloud));
    CHECK_STATUS(OK, medax_regular_build(cloud, weights, 30, NULL, NULL, &regular));
    CHECK_STATUS(OK, medax_dual_build(made->t, NULL, NULL, &plain));
    CHECK_STATUS(OK, medax_dual_build(regular, &with_facets, NULL, &power));
    CHECK_STATUS(OK, medax_dual_build(of_cloud, &with_facets, NULL, &other));
    CHECK_STATUS(OK, medax_job_create(NULL, &spent));
    medax_job_cancel(spent);
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_build(NULL, made->labels, NULL, NULL, &flow));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_build(made->dual, NULL, NULL, NULL, &flow));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_build(made->dual, made->labels, NULL, NULL, NULL));
    CHECK_STATUS(INVALID_ARGUMENT, medax_flow_build(plain, made->labels, NULL, NULL, &flow));
    CHECK_STATUS(INVALID_ARGUMENT, medax_flow_build(power, made->labels, NULL, NULL, &flow));
    CHECK_STATUS(MISMATCH, medax_flow_build(other, made->labels, NULL, NULL, &flow));
    CHECK_STATUS(CANCELLED, medax_flow_build(made->dual, made->labels, NULL, spent, &flow));
    const double wrong[] = {0, 1, -0.5, strtod("nan", NULL)};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
        medax_flow_options_init(&options, sizeof options);
        options.least_slope = wrong[i];
        CHECK_STATUS(INVALID_ARGUMENT,
                     medax_flow_build(made->dual, made->labels, &options, NULL, &flow));
    }
    medax_flow_options_init(&options, sizeof options);
    options.struct_size = 3;
    CHECK_STATUS(INVALID_ARGUMENT,
                 medax_flow_build(made->dual, made->labels, &options, NULL, &flow));
    CHECK(flow == UNTOUCHED);
    medax_job_free(spent);
    medax_dual_free(other);
    medax_dual_free(power);
    medax_dual_free(plain);
    medax_triangulation_free(regular);
    medax_triangulation_free(of_cloud);
    medax_points_free(cloud);
}

/* The vertices of a simplex as triangulation, dual and flow have them, then MEDAX_NONE. */
static void corners_of(const torus *made, const medax_flow *flow, const uint32_t *s,
                       uint32_t corners[4]) {
    const uint32_t *cells = medax_triangulation_cells(made->t).data;
    for (size_t k = 0; k < 4; ++k) corners[k] = MEDAX_NONE;
    if (s[0] == 0) corners[0] = s[1];
    if (s[0] == 1) memcpy(corners, medax_dual_facet_edges(made->dual).data + 2 * s[1], 8);
    if (s[0] == 2) {
        const uint32_t *side = medax_flow_triangles(flow).data + 2 * s[1];
        for (size_t k = 0, next = 0; k < 4; ++k)
            if (k != side[1]) corners[next++] = cells[4 * side[0] + k];
    }
    if (s[0] == 3) memcpy(corners, cells + 4 * s[1], 16);
}

static double distance(const double *a, const double *b) {
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1])
                + (a[2] - b[2]) * (a[2] - b[2]));
}

/* Whether two lists of four vertices hold the same ones. */
static int are_same(const uint32_t *a, const uint32_t *b) {
    size_t shared = 0;
    for (size_t i = 0; i < 16; ++i) shared += a[i / 4] == b[i % 4] && a[i / 4] != MEDAX_NONE;
    size_t count = 0, others = 0;
    for (size_t k = 0; k < 4; ++k) {
        count += a[k] != MEDAX_NONE;
        others += b[k] != MEDAX_NONE;
    }
    return shared == count && count == others;
}

static void critical_points(const torus *made) {
    const medax_flow *flow = built(made, NULL);
    const size_t count = medax_flow_critical_count(flow);
    const medax_view_u32 simplices = medax_flow_critical_simplices(flow);
    const medax_view_u32 corners = medax_flow_critical_corners(flow);
    const medax_view_u32 classes = medax_flow_critical_classes(flow);
    const medax_view_f64 points = medax_flow_critical_points(flow);
    const medax_view_f64 distances = medax_flow_critical_distances(flow);
    const medax_view_f64 slopes = medax_flow_critical_slopes(flow);
    const medax_view_f64 shares = medax_flow_critical_shares(flow);
    const medax_view_f64 coords = medax_triangulation_coords(made->t);
    NEED(simplices.rows == count && simplices.cols == 2 && corners.rows == count
         && corners.cols == 4);
    NEED(classes.rows == count && classes.cols == 1 && points.rows == count && points.cols == 3);
    NEED(distances.rows == count && slopes.rows == count && shares.rows == count);
    long sum = 0;
    size_t of_class[3] = {0, 0, 0};
    double below = 0, above = 1;
    for (size_t i = 0; i < count; ++i) {
        const uint32_t *s = simplices.data + 2 * i, *c = corners.data + 4 * i;
        uint32_t expected[4];
        NEED(s[0] <= 3);
        sum += s[0] % 2 == 0 ? 1 : -1;
        CHECK(i == 0 || s[0] > s[-2] || (s[0] == s[-2] && s[1] > s[-1]));
        CHECK((i < coords.rows) == (s[0] == 0));
        corners_of(made, flow, s, expected);
        CHECK(are_same(c, expected));
        for (size_t k = 0; k < 4; ++k) {
            CHECK((c[k] != MEDAX_NONE) == (k <= s[0]));
            if (c[k] == MEDAX_NONE) continue;
            CHECK(fabs(distance(points.data + 3 * i,
                                coords.data + 3 * c[k]) - distances.data[i]) < 1e-9);
        }
        CHECK(slopes.data[i] >= 0 && slopes.data[i] <= 1 + 1e-15);
        CHECK(shares.data[i] >= 0 && shares.data[i] <= 1 + 1e-15);
        const double slope = slopes.data[i];
        if (slope <= 0.5) below = fmax(below, slope);
        if (slope > 0.5) above = fmin(above, slope);
        NEED(classes.data[i] <= 2);
        ++of_class[classes.data[i]];
        if (slope <= 0.5) CHECK(classes.data[i] == MEDAX_CRITICAL_CLASS_SURFACE);
        if (classes.data[i] == MEDAX_CRITICAL_CLASS_INNER) {
            /* In the tube, about its core circle. */
            const double *p = points.data + 3 * i, ring = sqrt(p[0] * p[0] + p[1] * p[1]) - 1;
            CHECK(ring * ring + p[2] * p[2] < 0.01 && fabs(distances.data[i] - 0.4) < 0.1);
        }
        CHECK(medax_flow_critical_row(flow, simplex(s[0], s[1])) == i);
    }
    CHECK(sum == 1);
    CHECK(of_class[MEDAX_CRITICAL_CLASS_SURFACE] > 3 * coords.rows);
    CHECK(of_class[MEDAX_CRITICAL_CLASS_INNER] > 10 && of_class[MEDAX_CRITICAL_CLASS_OUTER] > 0);
    CHECK(medax_flow_critical_row(flow, simplex(4, 0)) == MEDAX_NONE);
    CHECK(medax_flow_critical_row(flow, simplex(3, MEDAX_NONE)) == MEDAX_NONE);
    double gap[2];
    CHECK_STATUS(OK, medax_flow_gap(flow, gap));
    CHECK(gap[0] == below && gap[1] == above && below < 0.49 && above > 0.9);
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_gap(flow, NULL));

    /* For writing, without the samples. */
    const medax_complex *written = NO_COMPLEX;
    const medax_job *spent = NULL;
    CHECK_STATUS(OK, medax_job_create(NULL, &spent));
    medax_job_cancel(spent);
    CHECK_STATUS(CANCELLED, medax_flow_critical_complex(flow, spent, &written));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_critical_complex(flow, NULL, NULL));
    CHECK(written == NO_COMPLEX);
    CHECK_STATUS(OK, medax_flow_critical_complex(flow, NULL, &written));
    const size_t first = coords.rows;
    const medax_view_u32 its = attribute(written, MEDAX_ELEMENT_VERTEX, "class").u32_values;
    NEED(its.rows == count - first && medax_complex_vertices(written).rows == its.rows);
    CHECK(memcmp(its.data, classes.data + first, 4 * its.rows) == 0);
    CHECK(memcmp(medax_complex_vertices(written).data, points.data + 3 * first, 24 * its.rows)
          == 0);
    medax_complex_free(written);
    medax_job_free(spent);

    /* Above the least slope of the medial axis the surface takes some from it. */
    medax_flow_options options;
    medax_flow_options_init(&options, sizeof options);
    options.least_slope = 0.5 + above / 2;
    const medax_flow *strict = built(made, &options);
    size_t of_surface = 0;
    for (size_t i = 0; i < count; ++i)
        of_surface += medax_flow_critical_classes(strict).data[i] == MEDAX_CRITICAL_CLASS_SURFACE;
    CHECK(of_surface > of_class[MEDAX_CRITICAL_CLASS_SURFACE]);
    CHECK_STATUS(OK, medax_flow_gap(strict, gap));
    CHECK(gap[0] >= above && gap[0] <= options.least_slope && gap[1] > options.least_slope);
    medax_flow_free(strict);
    medax_flow_free(flow);
}

/* The cells that are their own drivers are those of critical points, and few. */
static void drivers(const torus *made) {
    const medax_flow *flow = built(made, NULL);
    const medax_view_u32 triangles = medax_flow_triangles(flow);
    const medax_view_u32 cells = medax_triangulation_cells(made->t);
    const uint32_t *neighbors = medax_triangulation_neighbors(made->t).data;
    const size_t facets = medax_dual_facets(made->dual).rows;
    size_t hull = 0, acute = 0, central = 0;
    for (size_t i = 0; i < 4 * cells.rows; ++i) hull += neighbors[i] == MEDAX_NONE;
    NEED(triangles.cols == 2 && triangles.rows == (4 * cells.rows + hull) / 2);
    for (uint32_t t = 0; t < triangles.rows; ++t) {
        const uint32_t *side = triangles.data + 2 * t;
        NEED(side[0] < cells.rows && side[1] < 4);
        CHECK(t == 0 || side[0] > side[-2] || (side[0] == side[-2] && side[1] > side[-1]));
        CHECK(neighbors[4 * side[0] + side[1]] > side[0]);
        const medax_simplex driver = medax_flow_driver_of_triangle(flow, t);
        CHECK(driver.dimension == 2 ? driver.number == t : driver.dimension == 1
              && driver.number < facets);
        acute += driver.dimension == 2;
        CHECK(driver.dimension == 2 || medax_flow_critical_row(flow, simplex(2, t)) == MEDAX_NONE);
    }
    CHECK(acute > 0 && acute < triangles.rows);
    for (uint32_t c = 0; c < cells.rows; ++c) {
        const medax_simplex driver = medax_flow_driver_of_cell(flow, c);
        CHECK(driver.dimension >= 1 && driver.dimension <= 3);
        CHECK((driver.dimension == 3)
              == (medax_flow_critical_row(flow, simplex(3, c)) != MEDAX_NONE));
        CHECK(driver.dimension != 3 || driver.number == c);
        central += driver.dimension == 3;
    }
    CHECK(central > 0 && central < cells.rows / 2);
    const medax_simplex absent = medax_flow_driver_of_cell(flow, (uint32_t)cells.rows);
    CHECK(absent.dimension == 0 && absent.number == MEDAX_NONE);
    CHECK(medax_flow_driver_of_triangle(flow, (uint32_t)triangles.rows).number == MEDAX_NONE);
    medax_flow_free(flow);
}

static void at_points(const torus *made) {
    const medax_flow *flow = built(made, NULL);
    const medax_view_f64 points = medax_flow_critical_points(flow);
    const medax_view_f64 coords = medax_triangulation_coords(made->t);
    const medax_view_u32 simplices = medax_flow_critical_simplices(flow);
    const double nan = strtod("nan", NULL);
    const double bad[] = {0, 0, 0, 1e300, 0, 0, nan, 0, 0};
    medax_flow_point *at = malloc(points.rows * sizeof *at);
    NEED(at != NULL);
    /* Samples are critical points, the first. */
    CHECK_STATUS(OK, medax_flow_at(flow, points.data, coords.rows, NULL, at));
    for (uint32_t v = 0; v < coords.rows; ++v) {
        CHECK(at[v].simplex.dimension == 0 && at[v].simplex.number == v);
        CHECK(memcmp(at[v].driver, coords.data + 3 * v, 24) == 0);
        CHECK(at[v].distance == 0 && at[v].angle == 0 && at[v].vector[1] == 0);
    }
    /* Near a sample everything flows away from it, at full speed. */
    double *near = malloc(3 * coords.rows * sizeof *near);
    NEED(near != NULL);
    for (size_t i = 0; i < 3 * coords.rows; ++i) near[i] = coords.data[i] + (i % 3 == 0 ? 1e-3 : 0);
    CHECK_STATUS(OK, medax_flow_at(flow, near, coords.rows, NULL, at));
    for (uint32_t v = 0; v < coords.rows; ++v) {
        CHECK(at[v].simplex.dimension == 0 && at[v].simplex.number == v);
        CHECK(fabs(at[v].vector[0] - 1) < 1e-9 && fabs(at[v].vector[1]) < 1e-9);
        CHECK(fabs(at[v].distance - 1e-3) < 1e-12 && at[v].angle == 0);
    }
    free(near);
    /* The middle of an edge is on its Voronoi facet as exactly as coordinates are. */
    size_t still = 0;
    CHECK_STATUS(OK, medax_flow_at(flow, points.data, points.rows, NULL, at));
    for (size_t i = coords.rows; i < points.rows; ++i)
        still += at[i].simplex.dimension == simplices.data[2 * i] && at[i].angle > 1.57;
    CHECK(still > 0);

    at->angle = 9;
    CHECK_STATUS(COORDINATE_RANGE, medax_flow_at(flow, bad, 2, NULL, at));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 1);
    CHECK_STATUS(NON_FINITE, medax_flow_at(flow, bad + 6, 1, NULL, at));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 0);
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_at(flow, NULL, 1, NULL, at));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_at(flow, bad, 1, NULL, NULL));
    CHECK_STATUS(INVALID_ARGUMENT, medax_flow_at(flow, bad, SIZE_MAX, NULL, at));
    CHECK_STATUS(INVALID_ARGUMENT, medax_flow_at(flow, bad, SIZE_MAX / 48, NULL, at));
    CHECK_STATUS(OK, medax_flow_at(flow, NULL, 0, NULL, NULL));
    const medax_job *spent = NULL;
    CHECK_STATUS(OK, medax_job_create(NULL, &spent));
    medax_job_cancel(spent);
    CHECK_STATUS(CANCELLED, medax_flow_at(flow, bad, 1, spent, at));
    CHECK(at->angle == 9);
    medax_job_free(spent);
    free(at);
    medax_flow_free(flow);
}

/* Inside the tube orbits end at inner critical points; from far away they go to infinity. */
static void orbits(const torus *made) {
    enum { COUNT = 40 };
    const medax_flow *flow = built(made, NULL);
    const medax_complex *found = NO_COMPLEX;
    const medax_job *job = NULL, *spent = NULL;
    const char *stage = NULL;
    double queries[3 * (COUNT + 2)];
    uint32_t ends[COUNT + 3];
    uint64_t state = 5;
    for (size_t i = 0; i < COUNT; ++i) {
        double u[3];
        check_direction(&state, u);
        const double ring = sqrt(u[0] * u[0] + u[1] * u[1]);
        for (size_t k = 0; k < 3; ++k) queries[3 * i + k] = (k < 2 ? u[k] / ring : 0) + 0.2 * u[k];
    }
    const double far[] = {30, 20, 10};
    memcpy(queries + 3 * COUNT, far, sizeof far);
    memcpy(queries + 3 * COUNT + 3, medax_triangulation_coords(made->t).data, 24);
    ends[COUNT + 2] = 77;
    CHECK_STATUS(OK, medax_job_create(NULL, &job));
    CHECK_STATUS(OK, medax_flow_orbits(flow, queries, COUNT + 2, job, ends, &found));
    NEED(found != NO_COMPLEX && found != NULL);
    CHECK(medax_job_stage_count(job) == 2 && medax_job_progress(job) == 1);
    CHECK_STATUS(OK, medax_job_stage_time(job, 1, &stage, NULL, NULL));
    CHECK(strcmp(stage, "extract") == 0);
    const medax_view_f64 vertices = medax_complex_vertices(found);
    const medax_view_u32 edges = medax_complex_edges(found);
    const medax_view_f64 radius = attribute(found, MEDAX_ELEMENT_VERTEX, "radius").f64_values;
    const medax_view_u32 orbit = attribute(found, MEDAX_ELEMENT_EDGE, "orbit").u32_values;
    const medax_view_u32 end = attribute(found, MEDAX_ELEMENT_EDGE, "end").u32_values;
    NEED(radius.rows == vertices.rows && orbit.rows == edges.rows && end.rows == edges.rows);
    CHECK(edges.rows + COUNT + 2 == vertices.rows && medax_complex_faces(found).rows == 0);
    size_t first = 0, edge = 0;
    for (uint32_t i = 0; i < COUNT + 2; ++i) {
        CHECK(memcmp(vertices.data + 3 * first, queries + 3 * i, 24) == 0);
        for (; edge < edges.rows && orbit.data[edge] == i; ++edge, ++first) {
            CHECK(edges.data[2 * edge] == first && edges.data[2 * edge + 1] == first + 1);
            CHECK(end.data[edge] == ends[i]
                  && radius.data[first] <= radius.data[first + 1] + 1e-12);
        }
        if (i < COUNT) {
            NEED(ends[i] < medax_flow_critical_count(flow));
            CHECK(medax_flow_critical_classes(flow).data[ends[i]] == MEDAX_CRITICAL_CLASS_INNER);
            CHECK(memcmp(vertices.data + 3 * first,
                         medax_flow_critical_points(flow).data + 3 * ends[i], 24)
                  == 0);
        }
        ++first;
    }
    CHECK(edge == edges.rows && first == vertices.rows && edge > COUNT);
    /* A sample does not flow. */
    CHECK(ends[COUNT] == MEDAX_NONE && ends[COUNT + 1] == 0 && ends[COUNT + 2] == 77);
    medax_complex_free(found);

    found = NO_COMPLEX;
    CHECK_STATUS(OK, medax_job_create(NULL, &spent));
    medax_job_cancel(spent);
    CHECK_STATUS(CANCELLED, medax_flow_orbits(flow, queries, COUNT, spent, ends, &found));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_orbits(flow, NULL, 1, NULL, ends, &found));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_orbits(flow, queries, 1, NULL, ends, NULL));
    CHECK_STATUS(INVALID_ARGUMENT, medax_flow_orbits(flow, queries, SIZE_MAX, NULL, ends, &found));
    queries[7] = strtod("inf", NULL);
    CHECK_STATUS(NON_FINITE, medax_flow_orbits(flow, queries, COUNT, NULL, ends, &found));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 2);
    CHECK(found == NO_COMPLEX);
    /* The ends need not be wanted. */
    CHECK_STATUS(OK, medax_flow_orbits(flow, far, 1, NULL, NULL, &found));
    CHECK(medax_complex_edges(found).rows > 0);
    medax_complex_free(found);
    CHECK_STATUS(OK, medax_flow_orbits(flow, NULL, 0, NULL, NULL, &found));
    CHECK(medax_complex_vertices(found).rows == 0);
    medax_complex_free(found);
    medax_job_free(spent);
    medax_job_free(job);
    medax_flow_free(flow);
}

/* What flows from a critical point: of index 3 nothing, of index 2 a curve, of index 1 a disk. */
static void closures(const torus *made) {
    const medax_flow *flow = built(made, NULL);
    const medax_view_u32 simplices = medax_flow_critical_simplices(flow);
    const medax_view_u32 classes = medax_flow_critical_classes(flow);
    size_t tried[4] = {0, 0, 0, 0};
    for (uint32_t i = 0; i < simplices.rows; ++i) {
        const uint32_t *s = simplices.data + 2 * i;
        if (classes.data[i] != MEDAX_CRITICAL_CLASS_INNER || tried[s[0]] == 5) continue;
        ++tried[s[0]];
        const medax_complex *closure = NULL;
        const medax_simplex one = simplex(s[0], s[1]);
        medax_topology topology;
        topology.struct_size = sizeof topology;
        CHECK_STATUS(OK, medax_flow_closure(flow, &one, 1, NULL, &closure));
        CHECK_STATUS(OK, medax_complex_topology(closure, NULL, &topology));
        CHECK(topology.components == 1 && topology.betti[2] == 0);
        CHECK((topology.faces > 0) == (s[0] == 1));
        CHECK(s[0] != 3 || (topology.vertices == 1 && topology.edges == 0));
        CHECK(s[0] != 2 || topology.edges > 0);
        const medax_view_u32 critical = attribute(closure, MEDAX_ELEMENT_VERTEX,
                                                  "critical").u32_values;
        size_t own = 0;
        for (size_t v = 0; v < critical.rows; ++v) own += critical.data[v] == i;
        /* The middle of an edge lies within a face. */
        CHECK(own == (s[0] == 1 ? 0 : 1));
        medax_complex_free(closure);
    }
    CHECK(tried[2] == 5 && tried[3] == 5);

    const medax_complex *closure = NO_COMPLEX;
    const medax_job *spent = NULL;
    CHECK_STATUS(OK, medax_job_create(NULL, &spent));
    medax_job_cancel(spent);
    medax_simplex wrong[3] = {{0, 0}, {1, 0}, {3, 0}};
    CHECK_STATUS(CANCELLED, medax_flow_closure(flow, wrong, 3, spent, &closure));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_closure(flow, NULL, 1, NULL, &closure));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_closure(flow, wrong, 1, NULL, NULL));
    CHECK_STATUS(INVALID_ARGUMENT, medax_flow_closure(flow, wrong, SIZE_MAX, NULL, &closure));
    wrong[1].number = (uint32_t)medax_dual_facets(made->dual).rows;
    CHECK_STATUS(INVALID_ARGUMENT, medax_flow_closure(flow, wrong, 3, NULL, &closure));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 1);
    wrong[1].number = 0;
    wrong[2].dimension = 4;
    CHECK_STATUS(INVALID_ARGUMENT, medax_flow_closure(flow, wrong, 3, NULL, &closure));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 2);
    CHECK(closure == NO_COMPLEX);
    CHECK_STATUS(OK, medax_flow_closure(flow, NULL, 0, NULL, &closure));
    CHECK(medax_complex_vertices(closure).rows == 0);
    medax_complex_free(closure);
    medax_job_free(spent);
    medax_flow_free(flow);
}

/* Handles may be freed in any order. */
static void lifetimes(torus made) {
    const medax_flow *flow = built(&made, NULL), *copy = medax_flow_clone(flow);
    const medax_dual *dual = NULL;
    const medax_labels *labels = NULL;
    medax_validation report;
    const double *points = medax_flow_critical_points(flow).data;
    report.struct_size = sizeof report;
    CHECK_STATUS(OK, medax_flow_validate(flow, NULL, &report));
    CHECK(report.problems == 0 && report.checked > 0);
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_validate(flow, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_dual(flow, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_labels(flow, NULL));
    CHECK_STATUS(OK, medax_flow_dual(copy, &dual));
    CHECK(medax_dual_centers(dual).data == medax_dual_centers(made.dual).data);
    CHECK_STATUS(OK, medax_flow_labels(copy, &labels));
    CHECK(medax_labels_is_inner(labels).data == medax_labels_is_inner(made.labels).data);
    done(made);
    medax_flow_free(flow);
    CHECK(copy == flow && medax_flow_critical_points(copy).data == points && points[0] < 2);
    CHECK(medax_flow_driver_of_cell(copy, 0).dimension > 0);
    medax_flow_free(copy);
    CHECK(medax_dual_facets(dual).rows > 0 && medax_labels_inner_count(labels) > 0);
    medax_dual_free(dual);
    medax_labels_free(labels);
}

int main(void) {
    torus made = sampled();
    initial();
    null_is_nothing();
    refused_builds(&made);
    critical_points(&made);
    drivers(&made);
    at_points(&made);
    orbits(&made);
    closures(&made);
    lifetimes(made);
    return check_end();
}
