/* Medial axes in the plane as graphs. */
#include "boundary.h"

static const char untouched = 0;
#define UNTOUCHED ((const medax_medial_graph *)(const void *)&untouched)
static const double pi = 3.14159265358979323846;

static medax_medial_graph_options defaults(void) {
    medax_medial_graph_options options;
    CHECK_STATUS(OK, medax_medial_graph_options_init(&options, sizeof options));
    return options;
}

static const medax_medial_graph *built(const medax_sites *sites, const medax_medial_graph_options *options) {
    const medax_medial_graph *graph = NULL;
    CHECK_STATUS(OK, medax_medial_graph_build(sites, options, NULL, &graph));
    NEED(graph != NULL);
    CHECK(medax_medial_graph_torn(graph) == 0);
    return graph;
}

/* The graph finds nothing wrong with itself, and has looked at each of its points. */
static void sound(const medax_medial_graph *graph) {
    medax_validation report;
    report.struct_size = sizeof report;
    CHECK_STATUS(OK, medax_medial_graph_validate(graph, NULL, &report));
    CHECK(report.problems == 0 && report.first_index == UINT64_MAX && report.first_message[0] == 0);
    CHECK(report.checked > 3 * medax_medial_graph_points(graph).rows);
}

static void initial(void) {
    const medax_medial_graph_options options = defaults();
    CHECK(options.struct_size == sizeof options && options.spacing == 0 && options.object_angle == 0);
    CHECK(options.min_distance == 0 && options.has_clip == 0 && options.side == MEDAX_SIDE_INNER);
    CHECK(options.between_sites == 0 && options.reserved == 0);
}

/* The views are what the complex has for writing, and the arcs are its edges. */
static void written(const medax_medial_graph *graph) {
    const medax_complex *complex = NULL;
    CHECK_STATUS(OK, medax_medial_graph_complex(graph, NULL, &complex));
    const medax_view_f64 vertices = medax_complex_vertices(complex), points = medax_medial_graph_points(graph);
    const medax_view_u32 edges = medax_complex_edges(complex);
    const medax_view_rows arcs = medax_medial_graph_arcs(graph);
    NEED(vertices.rows == points.rows && points.cols == 3);
    CHECK(memcmp(vertices.data, points.data, 3 * points.rows * sizeof(double)) == 0);
    CHECK(same_f64(complex, "radius", medax_medial_graph_radii(graph)));
    CHECK(same_f64(complex, "object_angle", medax_medial_graph_object_angles(graph)));
    CHECK(same_f64(complex, "feet", medax_medial_graph_feet(graph)));
    CHECK(same_u32(complex, "pieces", medax_medial_graph_pieces(graph)));
    CHECK(same_u32(complex, "sites", medax_medial_graph_sites_of_points(graph)));
    size_t edge = 0, off = 0;
    for (size_t arc = 0; arc < arcs.rows; ++arc)
        for (uint32_t i = arcs.offsets[arc]; i + 1 < arcs.offsets[arc + 1]; ++i, ++edge)
            off += edge >= edges.rows || edges.data[2 * edge] != arcs.indices[i]
                   || edges.data[2 * edge + 1] != arcs.indices[i + 1];
    CHECK(off == 0 && edge == edges.rows);
    medax_complex_free(complex);
}

/* Five arcs: the middle line, and one to each corner. */
static void of_rectangle(void) {
    static const double expected[12] = {0, 0, 4, 0, 0, 2, 4, 2, 1, 1, 3, 1};
    const medax_sites *sites = rectangle(4, 2), *same = NULL;
    const medax_medial_graph *graph = built(sites, NULL);
    const medax_view_f64 points = medax_medial_graph_points(graph), radii = medax_medial_graph_radii(graph);
    const medax_view_rows arcs = medax_medial_graph_arcs(graph);
    const size_t nodes = medax_medial_graph_node_count(graph);
    NEED(nodes == 6 && arcs.rows == 5 && radii.rows == points.rows && points.rows > nodes);
    for (size_t k = 0; k < 6; ++k) {
        double d = HUGE_VAL;
        for (size_t i = 0; i < nodes; ++i)
            d = least(d, hypot(points.data[3 * i] - expected[2 * k], points.data[3 * i + 1] - expected[2 * k + 1]));
        CHECK(d < 1e-9);
    }
    double total = 0, longest = 0;
    for (size_t arc = 0; arc < 5; ++arc) {
        CHECK(arcs.indices[arcs.offsets[arc]] < nodes && arcs.indices[arcs.offsets[arc + 1] - 1] < nodes);
        for (uint32_t i = arcs.offsets[arc]; i + 1 < arcs.offsets[arc + 1]; ++i) {
            const double *p = points.data + 3 * arcs.indices[i], *q = points.data + 3 * arcs.indices[i + 1];
            const double d = hypot(p[0] - q[0], p[1] - q[1]);
            total += d;
            if (d > longest) longest = d;
        }
    }
    CHECK(fabs(total - 2 - 4 * sqrt(2)) < 1e-9 && longest <= 0.01 * sqrt(20) * (1 + 1e-9));
    size_t off = 0;
    for (size_t i = 0; i < points.rows; ++i) {
        const double *p = points.data + 3 * i;
        const double sides = least(least(p[0], 4 - p[0]), least(p[1], 2 - p[1]));
        off += to_axis(p, 4, 2) > 1e-9 || fabs(radii.data[i] - sides) > 1e-9;
    }
    CHECK(off == 0);
    written(graph);
    sound(graph);
    CHECK_STATUS(OK, medax_medial_graph_sites(graph, &same));
    CHECK(medax_sites_site_of_piece(same).data == medax_sites_site_of_piece(sites).data);
    medax_sites_free(same);

    /* Beyond a right angle only the middle line is left, and its ends are no nodes of other arcs. */
    medax_medial_graph_options options = defaults();
    options.object_angle = 2;
    options.spacing = 0.5;
    const medax_medial_graph *middle = built(sites, &options);
    const medax_view_f64 left = medax_medial_graph_points(middle);
    CHECK(medax_medial_graph_arcs(middle).rows == 1);
    for (size_t i = 0; i < left.rows; ++i)
        CHECK(fabs(left.data[3 * i + 1] - 1) < 1e-9 && left.data[3 * i] > 1 - 1e-9 && left.data[3 * i] < 3 + 1e-9);
    medax_medial_graph_free(middle);
    options = defaults();
    options.min_distance = 0.5;
    const medax_medial_graph *inner = built(sites, &options);
    const medax_view_f64 least_radii = medax_medial_graph_radii(inner);
    double least_radius = 9;
    for (size_t i = 0; i < least_radii.rows; ++i) least_radius = least(least_radius, least_radii.data[i]);
    CHECK(least_radius >= 0.5 && least_radius < 0.5 + 1e-9 && medax_medial_graph_arcs(inner).rows == 5);
    CHECK(medax_medial_graph_node_count(inner) == 2);
    medax_medial_graph_free(inner);
    /* All sides are of one site. */
    options = defaults();
    options.between_sites = 1;
    const medax_medial_graph *none = built(sites, &options);
    CHECK(medax_medial_graph_arcs(none).rows == 0 && medax_medial_graph_points(none).rows == 0);
    CHECK(medax_medial_graph_arcs(none).offsets[0] == 0);
    medax_medial_graph_free(none);

    medax_sites_free(sites);
    const medax_medial_graph *copy = medax_medial_graph_clone(graph);
    medax_medial_graph_free(graph);
    CHECK(copy == graph && medax_medial_graph_arcs(copy).indices == arcs.indices && arcs.offsets[0] == 0);
    medax_medial_graph_free(copy);
}

/* Two points have the line between them, clipped; two circles about one centre the one in the middle. */
static void other_boundaries(void) {
    const medax_sites *sites = two_points(2);
    medax_medial_graph_options options = defaults();
    options.side = MEDAX_SIDE_OUTER;
    options.has_clip = 1;
    options.clip_min[0] = options.clip_min[1] = -2;
    options.clip_max[0] = options.clip_max[1] = 2;
    for (uint32_t between = 0; between < 2; ++between) {
        options.between_sites = between;
        const medax_medial_graph *graph = built(sites, &options);
        const medax_view_f64 points = medax_medial_graph_points(graph);
        const medax_view_f64 angles = medax_medial_graph_object_angles(graph);
        double low = 9, high = -9;
        CHECK(medax_medial_graph_arcs(graph).rows == 1);
        for (size_t i = 0; i < points.rows; ++i) {
            const double *p = points.data + 3 * i;
            CHECK(fabs(p[0]) < 1e-9 && fabs(medax_medial_graph_radii(graph).data[i] - hypot(1, p[1])) < 1e-9);
            CHECK(fabs(angles.data[i] - 2 * atan2(1, fabs(p[1]))) < 1e-6);
            low = least(low, p[1]);
            high = -least(-high, -p[1]);
        }
        CHECK(fabs(low + 2) < 1e-6 && fabs(high - 2) < 1e-6);
        written(graph);
        medax_medial_graph_free(graph);
    }
    medax_sites_free(sites);

    static const uint8_t closed[2] = {1, 1};
    const medax_piece circles[2] = {piece(MEDAX_PIECE_KIND_SPHERE, 0, 0, 0, 0, 1, 0, 0),
                                    piece(MEDAX_PIECE_KIND_SPHERE, 1, 0, 0, 0, 2, 0, 0)};
    const medax_sites *ring = NULL;
    CHECK_STATUS(OK, medax_sites_create(2, circles, 2, closed, 2, NULL, &ring));
    const medax_medial_graph *loop = built(ring, NULL);
    const medax_view_f64 points = medax_medial_graph_points(loop);
    const medax_view_rows arcs = medax_medial_graph_arcs(loop);
    medax_topology topology;
    const medax_complex *complex = NULL;
    topology.struct_size = sizeof topology;
    CHECK_STATUS(OK, medax_medial_graph_complex(loop, NULL, &complex));
    CHECK_STATUS(OK, medax_complex_topology(complex, NULL, &topology));
    CHECK(topology.betti[0] == 1 && topology.betti[1] == 1 && arcs.rows >= 1);
    medax_complex_free(complex);
    for (size_t i = 0; i < points.rows; ++i) {
        CHECK(fabs(hypot(points.data[3 * i], points.data[3 * i + 1]) - 1.5) < 1e-9);
        CHECK(fabs(medax_medial_graph_radii(loop).data[i] - 0.5) < 1e-9);
        CHECK(fabs(medax_medial_graph_object_angles(loop).data[i] - pi) < 1e-6);
    }
    medax_medial_graph_free(loop);
    medax_sites_free(ring);
}

/* Of the diagram of three points the arcs that are asked for: from where all three meet to the rim of the box. */
static void between(void) {
    static const uint32_t pair[2] = {1, 0}, all[8] = {2, 1, 0, 1, 2, 0, 1, 0}, wrong[4] = {0, 2, 3, 1}, same[2] = {0, 0};
    const medax_piece pieces[3] = {piece(MEDAX_PIECE_KIND_POINT, 0, -1, 0, 0, 0, 0, 0),
                                   piece(MEDAX_PIECE_KIND_POINT, 1, 1, 0, 0, 0, 0, 0),
                                   piece(MEDAX_PIECE_KIND_POINT, 2, 0, 2, 0, 0, 0, 0)};
    const medax_sites *sites = sites_of(2, pieces, 3);
    medax_medial_graph_options options = defaults();
    options.side = MEDAX_SIDE_OUTER;
    options.has_clip = 1;
    options.clip_min[0] = options.clip_min[1] = -2;
    options.clip_max[0] = options.clip_max[1] = 2;
    const medax_medial_graph *some = NULL, *every = NULL, *none = NULL, *plain = built(sites, &options);
    CHECK(medax_medial_graph_arcs(plain).rows == 3);
    CHECK_STATUS(OK, medax_medial_graph_between(sites, pair, 1, &options, NULL, &some));
    const medax_view_f64 points = medax_medial_graph_points(some);
    NEED(points.rows > 2 && medax_medial_graph_arcs(some).rows == 1);
    double low = 9, high = -9;
    for (size_t i = 0; i < points.rows; ++i) {
        const double *p = points.data + 3 * i;
        CHECK(fabs(p[0]) < 1e-9 && fabs(medax_medial_graph_radii(some).data[i] - hypot(1, p[1])) < 1e-9);
        low = least(low, p[1]);
        high = -least(-high, -p[1]);
    }
    CHECK(fabs(low + 2) < 1e-6 && fabs(high - 0.75) < 1e-9);
    sound(some);
    written(some);
    medax_medial_graph_free(some);
    /* All pairs, one of them twice, are all that there is. */
    CHECK_STATUS(OK, medax_medial_graph_between(sites, all, 4, &options, NULL, &every));
    const medax_view_f64 p = medax_medial_graph_points(every), q = medax_medial_graph_points(plain);
    CHECK(p.rows == q.rows && memcmp(p.data, q.data, 24 * p.rows) == 0);
    medax_medial_graph_free(every);
    medax_medial_graph_free(plain);
    /* A point has no axis of its own. */
    CHECK_STATUS(OK, medax_medial_graph_between(sites, same, 1, &options, NULL, &none));
    CHECK(medax_medial_graph_points(none).rows == 0 && medax_medial_graph_arcs(none).rows == 0);
    medax_medial_graph_free(none);
    CHECK_STATUS(OK, medax_medial_graph_between(sites, NULL, 0, &options, NULL, &none));
    CHECK(medax_medial_graph_points(none).rows == 0 && medax_medial_graph_arcs(none).rows == 0);
    medax_medial_graph_free(none);

    const medax_job *spent = spent_job(), *small = job_with(200, 0);
    none = UNTOUCHED;
    CHECK_STATUS(INVALID_ARGUMENT, medax_medial_graph_between(sites, wrong, 2, &options, NULL, &none));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 1);
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_graph_between(sites, NULL, 1, &options, NULL, &none));
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_graph_between(NULL, pair, 1, &options, NULL, &none));
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_graph_between(sites, pair, 1, &options, NULL, NULL));
    CHECK_STATUS(INVALID_ARGUMENT, medax_medial_graph_between(sites, pair, SIZE_MAX, &options, NULL, &none));
    CHECK_STATUS(CANCELLED, medax_medial_graph_between(sites, pair, 1, &options, spent, &none));
    CHECK_STATUS(OUT_OF_MEMORY, medax_medial_graph_between(sites, pair, 1, &options, small, &none));
    CHECK(none == UNTOUCHED);
    medax_job_free(small);
    medax_job_free(spent);
    medax_sites_free(sites);
}

static void refusals(void) {
    const double nan = strtod("nan", NULL);
    const medax_sites *sites = rectangle(4, 2), *space = two_points(3);
    const medax_medial_graph *graph = UNTOUCHED;
    for (int i = 0; i < 14; ++i) {
        medax_medial_graph_options options = defaults();
        switch (i) {
        case 0: options.spacing = -1; break;
        case 1: options.spacing = nan; break;
        case 2: options.object_angle = -0.1; break;
        case 3: options.object_angle = 3.2; break;
        case 4: options.min_distance = -1; break;
        case 5: options.min_distance = HUGE_VAL; break;
        case 6: options.has_clip = 1; break;
        case 7: options.has_clip = 2; break;
        case 8: options.side = 3; break;
        case 9: options.between_sites = 2; break;
        case 10: options.reserved = 1; break;
        case 11: options.struct_size = 8; break;
        case 12: options.clip_min[0] = nan; options.has_clip = 1; break;
        default: options.clip_max[1] = options.clip_max[0] = 1e300; options.has_clip = 1;
        }
        CHECK_STATUS(INVALID_ARGUMENT, medax_medial_graph_build(sites, &options, NULL, &graph));
    }
    CHECK_STATUS(INVALID_ARGUMENT, medax_medial_graph_build(space, NULL, NULL, &graph));
    medax_sites_free(space);
    for (uint32_t kind = MEDAX_PIECE_KIND_RAY; kind <= MEDAX_PIECE_KIND_LINE; ++kind) {
        const medax_piece pieces[2] = {piece(MEDAX_PIECE_KIND_POINT, 0, 5, 5, 0, 0, 0, 0),
                                       piece(kind, 0, 0, 0, 0, 1, 0, 0)};
        const medax_sites *endless = sites_of(2, pieces, 2);
        medax_medial_graph_options options = defaults();
        options.has_clip = 1;
        options.clip_max[0] = options.clip_max[1] = 1;
        CHECK_STATUS(UNSUPPORTED, medax_medial_graph_build(endless, &options, NULL, &graph));
        CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 1);
        medax_sites_free(endless);
    }
    const medax_job *spent = spent_job(), *small = job_with(200, 0);
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_graph_build(NULL, NULL, NULL, &graph));
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_graph_build(sites, NULL, NULL, NULL));
    CHECK_STATUS(CANCELLED, medax_medial_graph_build(sites, NULL, spent, &graph));
    CHECK_STATUS(OUT_OF_MEMORY, medax_medial_graph_build(sites, NULL, small, &graph));
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_graph_options_init(NULL, sizeof(medax_medial_graph_options)));
    CHECK(graph == UNTOUCHED);
    const medax_complex *complex = NULL;
    CHECK_STATUS(OK, medax_medial_graph_build(sites, NULL, NULL, &graph));
    CHECK_STATUS(CANCELLED, medax_medial_graph_complex(graph, spent, &complex));
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_graph_complex(NULL, NULL, &complex));
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_graph_complex(graph, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_graph_sites(graph, NULL));
    CHECK(complex == NULL);
    medax_validation report;
    report.struct_size = 8;
    CHECK_STATUS(INVALID_ARGUMENT, medax_medial_graph_validate(graph, NULL, &report));
    report.struct_size = sizeof report;
    CHECK_STATUS(CANCELLED, medax_medial_graph_validate(graph, spent, &report));
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_graph_validate(graph, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_graph_validate(NULL, NULL, &report));
    medax_medial_graph_free(graph);
    medax_job_free(spent);
    medax_job_free(small);
    medax_sites_free(sites);
}

static void cancelled(void) {
    int stopped = 0;
    for (size_t count = 500; !stopped && count < 100000; count *= 4) {
        char stage[] = "field";
        const medax_job *job = stopping_job(stage);
        const medax_medial_graph *graph = UNTOUCHED;
        medax_piece *pieces = malloc(count * sizeof *pieces);
        uint64_t state = 9;
        NEED(pieces != NULL);
        for (size_t i = 0; i < count; ++i)
            pieces[i] = piece(MEDAX_PIECE_KIND_POINT, 0, check_random(&state), check_random(&state), 0, 0, 0, 0);
        const medax_sites *sites = sites_of(2, pieces, count);
        medax_medial_graph_options options = defaults();
        options.side = MEDAX_SIDE_OUTER;
        if (medax_medial_graph_build(sites, &options, job, &graph) == MEDAX_STATUS_OK) {
            medax_medial_graph_free(graph);
        } else {
            stopped = 1;
            CHECK(graph == UNTOUCHED && medax_job_is_cancelled(job));
        }
        free(pieces);
        medax_sites_free(sites);
        medax_job_free(job);
    }
    CHECK(stopped);
}

static void null_is_nothing(void) {
    const medax_sites *sites = NULL;
    CHECK(medax_medial_graph_points(NULL).cols == 3 && medax_medial_graph_points(NULL).data == NULL);
    CHECK(medax_medial_graph_radii(NULL).rows == 0 && medax_medial_graph_object_angles(NULL).rows == 0);
    CHECK(medax_medial_graph_feet(NULL).cols == 6 && medax_medial_graph_pieces(NULL).cols == 2);
    CHECK(medax_medial_graph_sites_of_points(NULL).cols == 2 && medax_medial_graph_arcs(NULL).rows == 0);
    CHECK(medax_medial_graph_arcs(NULL).offsets == NULL && medax_medial_graph_node_count(NULL) == 0);
    CHECK(medax_medial_graph_torn(NULL) == 0 && medax_medial_graph_clone(NULL) == NULL);
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_graph_sites(NULL, &sites));
    medax_medial_graph_free(NULL);
}

int main(void) {
    initial();
    of_rectangle();
    other_boundaries();
    between();
    refusals();
    cancelled();
    null_is_nothing();
    return check_end();
}
