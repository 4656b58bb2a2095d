/* Pair-meshes: a ball and a block, their elements, surfaces, coordinates and deformations. */
#include "check.h"

static const char untouched = 0;
#define UNTOUCHED ((const medax_pair *)(const void *)&untouched)

/* The pair-mesh of points of which all cells are inner. */
static const medax_pair *pair_of(const double *xyz, size_t count) {
    const medax_points *points = NULL;
    const medax_triangulation *t = NULL;
    const medax_dual *dual = NULL;
    const medax_labels *labels = NULL;
    const medax_pair *pair = NULL;
    medax_dual_options options;
    CHECK_STATUS(OK, medax_points_create_f64(xyz, count, 0, NULL, NULL, &points));
    CHECK_STATUS(OK, medax_delaunay_build(points, NULL, NULL, &t));
    CHECK_STATUS(OK, medax_dual_options_init(&options, sizeof options));
    options.facets = 1;
    CHECK_STATUS(OK, medax_dual_build(t, &options, NULL, &dual));
    const size_t cells = medax_triangulation_cells(t).rows;
    uint8_t *inner = malloc(cells);
    NEED(inner != NULL);
    memset(inner, 1, cells);
    CHECK_STATUS(OK, medax_labels_create(t, inner, cells, &labels));
    CHECK_STATUS(OK, medax_pair_voronoi(dual, labels, NULL, &pair));
    NEED(pair != NULL);

    /* Nothing is touched where something is wrong. */
    const medax_pair *none = UNTOUCHED;
    CHECK_STATUS(NULL_ARGUMENT, medax_pair_voronoi(NULL, labels, NULL, &none));
    CHECK_STATUS(NULL_ARGUMENT, medax_pair_voronoi(dual, NULL, NULL, &none));
    CHECK_STATUS(NULL_ARGUMENT, medax_pair_voronoi(dual, labels, NULL, NULL));
    const medax_labels *outer = NULL;
    memset(inner, 0, cells);
    CHECK_STATUS(OK, medax_labels_create(t, inner, cells, &outer));
    CHECK_STATUS(DEGENERATE, medax_pair_voronoi(dual, outer, NULL, &none));
    const medax_dual *bare = NULL;
    options.facets = 0;
    CHECK_STATUS(OK, medax_dual_build(t, &options, NULL, &bare));
    CHECK_STATUS(INVALID_ARGUMENT, medax_pair_voronoi(bare, labels, NULL, &none));
    CHECK(none == UNTOUCHED);
    free(inner);
    /* It keeps what it needs. */
    medax_points_free(points);
    medax_triangulation_free(t);
    medax_dual_free(dual);
    medax_dual_free(bare);
    medax_labels_free(labels);
    medax_labels_free(outer);
    return pair;
}

static void elements(const medax_pair *pair, double volume) {
    const size_t count = medax_pair_element_count(pair, 0);
    const size_t pyramids = medax_pair_element_count(pair, MEDAX_PAIR_ELEMENT_FACE_VERTEX);
    const size_t between = medax_pair_element_count(pair, MEDAX_PAIR_ELEMENT_EDGE_EDGE);
    const size_t over = medax_pair_element_count(pair, MEDAX_PAIR_ELEMENT_VERTEX_FACE);
    CHECK(count == pyramids + between + over && medax_pair_element_count(pair, 7) == 0);
    CHECK(pyramids == 2 * medax_pair_inner_faces(pair).rows && medax_pair_rings(pair).rows == count);
    const medax_view_u32 nodes = medax_pair_nodes(pair);
    const medax_view_rows rings = medax_pair_rings(pair);
    const size_t boundary = medax_pair_boundary_vertices(pair).rows;
    const size_t inner = medax_pair_inner_vertices(pair).rows;
    CHECK(nodes.cols == 2 && medax_pair_boundary_samples(pair).rows == boundary);
    CHECK(medax_pair_inner_cells(pair).rows == inner && medax_pair_voronoi_vertices(pair).rows == inner);
    size_t wrong = 0;
    for (size_t i = 0; i < nodes.rows; ++i)
        wrong += nodes.data[2 * i] >= boundary || nodes.data[2 * i + 1] >= inner;
    for (size_t i = 0; i < rings.offsets[count]; ++i) wrong += rings.indices[i] >= nodes.rows;
    CHECK(wrong == 0);

    double *volumes = calloc(4 * count, sizeof *volumes);
    uint32_t *numbers = calloc(count, sizeof *numbers);
    NEED(volumes != NULL && numbers != NULL);
    CHECK_STATUS(OK, medax_pair_volumes(pair, NULL, volumes));
    double sum = 0;
    for (size_t i = 0; i < count; ++i) sum += volumes[i];
    CHECK(fabs(sum - volume) < 1e-9 * volume && fabs(medax_pair_enclosed_volume(pair) - volume) < 1e-9 * volume);
    CHECK_STATUS(OK, medax_pair_centroids(pair, NULL, volumes));
    CHECK_STATUS(OK, medax_pair_shells(pair, NULL, numbers));
    for (size_t i = 0; i < count; ++i) wrong += numbers[i] != 0;
    size_t folded = 99;
    CHECK_STATUS(OK, medax_pair_folded(pair, NULL, numbers, &folded));
    CHECK(folded == 0 && wrong == 0);
    CHECK_STATUS(NULL_ARGUMENT, medax_pair_folded(pair, NULL, numbers, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_pair_volumes(pair, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_pair_volumes(NULL, NULL, volumes));
    free(volumes);
    free(numbers);
    medax_validation report;
    report.struct_size = sizeof report;
    CHECK_STATUS(OK, medax_pair_validate(pair, NULL, &report));
    CHECK(report.problems == 0 && report.checked > 100);
}

static void surfaces(const medax_pair *pair) {
    const double times[] = {0, 0.001, 0.5, 0.9, 1};
    for (size_t i = 0; i < sizeof times / sizeof *times; ++i) {
        const medax_complex *surface = NULL;
        medax_topology topology;
        topology.struct_size = sizeof topology;
        CHECK_STATUS(OK, medax_pair_iso_surface(pair, times[i], NULL, &surface));
        CHECK_STATUS(OK, medax_complex_topology(surface, NULL, &topology));
        CHECK(topology.closed && topology.oriented && topology.genus == 0 && topology.components == 1);
        medax_complex_free(surface);
    }
    const medax_complex *made = NULL;
    CHECK_STATUS(INVALID_ARGUMENT, medax_pair_iso_surface(pair, 1.5, NULL, &made));
    CHECK_STATUS(OK, medax_pair_solid(pair, NULL, &made));
    CHECK(medax_complex_cells(made).rows == medax_pair_element_count(pair, 0));
    medax_complex_free(made);
    CHECK_STATUS(OK, medax_pair_boundary(pair, NULL, &made));
    CHECK(medax_complex_faces(made).rows == medax_pair_element_count(pair, MEDAX_PAIR_ELEMENT_VERTEX_FACE));
    medax_complex_free(made);
    CHECK_STATUS(OK, medax_pair_inner(pair, NULL, &made));
    CHECK(medax_complex_vertices(made).rows == medax_pair_inner_vertices(pair).rows);
    medax_complex_free(made);
}

static void places(const medax_pair *pair) {
    double queries[300], back[300];
    medax_place found[100];
    uint64_t state = 5;
    for (size_t i = 0; i < 300; ++i) queries[i] = 1.6 * check_random(&state) - 0.8;
    CHECK_STATUS(OK, medax_pair_locate(pair, queries, 100, NULL, found));
    size_t inside = 0, wrong = 0;
    for (size_t i = 0; i < 100; ++i) {
        if (found[i].element == MEDAX_NONE) {
            wrong += !isnan(found[i].t);
            found[i].element = found[i].piece = 0;
            continue;
        }
        ++inside;
        uint32_t corners[4];
        CHECK_STATUS(OK, medax_pair_piece(pair, found[i].element, found[i].piece, corners));
        CHECK_STATUS(OK, medax_pair_positions(pair, found + i, 1, back + 3 * i));
        for (int k = 0; k < 3; ++k) wrong += fabs(back[3 * i + (size_t)k] - queries[3 * i + (size_t)k]) > 1e-12;
        wrong += !(found[i].t >= 0 && found[i].t <= 1);
    }
    CHECK(inside > 30 && inside < 100 && wrong == 0);
    found[7].element = 4000000000u;
    CHECK_STATUS(INVALID_ARGUMENT, medax_pair_positions(pair, found, 100, back));
    CHECK(medax_last_error_index() == 7);
    queries[30] = NAN;
    CHECK_STATUS(NON_FINITE, medax_pair_locate(pair, queries, 100, NULL, found));
    CHECK(medax_last_error_index() == 10);
    CHECK_STATUS(OK, medax_pair_locate(pair, NULL, 0, NULL, NULL));
}

static void deformations(const medax_pair *pair) {
    const medax_view_f64 inner = medax_pair_inner_vertices(pair);
    double *xyz = calloc(3 * inner.rows, sizeof *xyz);
    NEED(xyz != NULL);
    for (size_t i = 0; i < 3 * inner.rows; ++i) xyz[i] = inner.data[i] + (i % 3 == 2 ? 5 : 0);
    const medax_pair *moved = NULL, *none = UNTOUCHED;
    CHECK_STATUS(OK, medax_pair_with_inner(pair, xyz, inner.rows, NULL, &moved));
    const double *before = medax_pair_boundary_vertices(pair).data, *after = medax_pair_boundary_vertices(moved).data;
    CHECK(fabs(after[2] - before[2] - 5) < 1e-12 && fabs(after[0] - before[0]) < 1e-12);
    const medax_pair *back = NULL;
    CHECK_STATUS(OK, medax_pair_with_boundary(moved, before, medax_pair_boundary_vertices(pair).rows, NULL, &back));
    CHECK(fabs(medax_pair_inner_vertices(back).data[2] - inner.data[2]) < 1e-12);
    CHECK_STATUS(MISMATCH, medax_pair_with_inner(pair, xyz, inner.rows - 1, NULL, &none));
    xyz[4] = INFINITY;
    CHECK_STATUS(NON_FINITE, medax_pair_with_inner(pair, xyz, inner.rows, NULL, &none));
    CHECK(none == UNTOUCHED && medax_last_error_index() == 1);
    free(xyz);
    medax_pair_free(moved);
    medax_pair_free(back);
}

static void half_faces(const medax_pair *pair) {
    const medax_half_faces *its = NULL;
    CHECK_STATUS(OK, medax_half_faces_build(pair, NULL, &its));
    const medax_view_u32 of_element = medax_half_faces_of_element(its), offsets = medax_half_faces_offsets(its);
    const medax_view_u32 duals = medax_half_faces_duals(its), origins = medax_half_faces_origins(its);
    const medax_view_u32 opposites = medax_half_faces_opposites(its), partners = medax_half_faces_partners(its);
    NEED(of_element.rows == medax_pair_element_count(pair, 0) + 1 && offsets.rows == duals.rows + 1);
    NEED(origins.rows == opposites.rows && partners.rows == origins.rows);
    size_t wrong = 0, bare = 0;
    for (size_t f = 0; f < duals.rows; ++f) {
        bare += duals.data[f] == MEDAX_NONE;
        wrong += duals.data[f] != MEDAX_NONE && duals.data[duals.data[f]] != f;
    }
    for (size_t h = 0; h < origins.rows; ++h) {
        wrong += opposites.data[opposites.data[h]] != h;
        wrong += partners.data[h] != MEDAX_NONE && partners.data[partners.data[h]] != h;
    }
    CHECK(wrong == 0 && bare == medax_pair_element_count(pair, MEDAX_PAIR_ELEMENT_VERTEX_FACE));
    const medax_half_faces *same = medax_half_faces_clone(its);
    medax_half_faces_free(its);
    CHECK(same == its && medax_half_faces_origins(same).rows == origins.rows);
    medax_half_faces_free(same);
    CHECK(medax_half_faces_origins(NULL).rows == 0 && medax_half_faces_clone(NULL) == NULL);
    CHECK_STATUS(NULL_ARGUMENT, medax_half_faces_build(NULL, NULL, &its));
}

/* As little of the inner structure as can be, and what is no part of it. */
static void parts(const medax_pair *pair) {
    medax_pair_onto_options options;
    CHECK_STATUS(OK, medax_pair_onto_options_init(&options, sizeof options));
    CHECK(options.subdivide == 0 && options.exact == 0);
    medax_complex_parts arrays;
    CHECK_STATUS(OK, medax_complex_parts_init(&arrays, sizeof arrays));
    const medax_complex *boundary = NULL, *nothing = NULL;
    CHECK_STATUS(OK, medax_pair_boundary(pair, NULL, &boundary));
    CHECK_STATUS(OK, medax_complex_create(&arrays, &nothing));

    const medax_pair *whole = NULL, *spine = NULL;
    const size_t faces = medax_pair_inner_faces(pair).rows;
    CHECK_STATUS(INVALID_ARGUMENT, medax_pair_onto(pair, boundary, &options, NULL, &whole));
    CHECK_STATUS(OK, medax_pair_onto(pair, nothing, NULL, NULL, &spine));
    NEED(spine != NULL);
    const size_t left = medax_pair_inner_faces(spine).rows;
    CHECK(left < faces && medax_pair_boundary_vertices(spine).rows == medax_pair_boundary_vertices(pair).rows);
    medax_validation report;
    report.struct_size = sizeof report;
    CHECK_STATUS(OK, medax_pair_validate(spine, NULL, &report));
    CHECK(report.problems == 0);
    uint32_t reasons[4096];
    NEED(left <= 4096 && faces <= 4096);
    CHECK_STATUS(OK, medax_pair_reasons(spine, reasons));
    for (size_t i = 0; i < left; ++i) CHECK(reasons[i] == MEDAX_PAIR_REASON_ENCLOSED || reasons[i] == MEDAX_PAIR_REASON_UNSEEN);
    CHECK_STATUS(OK, medax_pair_reasons(pair, reasons));
    for (size_t i = 0; i < faces; ++i) CHECK(reasons[i] == MEDAX_PAIR_REASON_ASKED);
    CHECK(medax_pair_missing(spine) == 0 && medax_pair_missing(NULL) == 0);
    CHECK_STATUS(INVALID_ARGUMENT, medax_pair_onto(spine, nothing, NULL, NULL, &whole));
    options.exact = 2;
    CHECK_STATUS(INVALID_ARGUMENT, medax_pair_onto(pair, nothing, &options, NULL, &whole));
    CHECK_STATUS(NULL_ARGUMENT, medax_pair_onto(NULL, nothing, NULL, NULL, &whole));
    CHECK_STATUS(NULL_ARGUMENT, medax_pair_onto(pair, NULL, NULL, NULL, &whole));
    CHECK_STATUS(NULL_ARGUMENT, medax_pair_reasons(NULL, reasons));
    CHECK(whole == NULL);
    medax_pair_free(spine);
    medax_complex_free(boundary);
    medax_complex_free(nothing);
}

int main(void) {
    double ball[3 * 300], block[3 * 27];
    uint64_t state = 1;
    for (size_t i = 0; i < 300; ++i) {
        check_direction(&state, ball + 3 * i);
        ball[3 * i + 1] *= 0.8;
    }
    for (size_t i = 0; i < 27; ++i) {
        block[3 * i] = (double)(i % 3);
        block[3 * i + 1] = (double)(i / 3 % 3);
        block[3 * i + 2] = (double)(i / 9);
    }
    const medax_pair *of_ball = pair_of(ball, 300);
    elements(of_ball, medax_pair_enclosed_volume(of_ball));
    surfaces(of_ball);
    places(of_ball);
    deformations(of_ball);
    half_faces(of_ball);
    parts(of_ball);
    const medax_pair *same = medax_pair_clone(of_ball);
    medax_pair_free(of_ball);
    CHECK(same == of_ball && medax_pair_nodes(same).rows > 0);
    medax_pair_free(same);

    /* The sample in its middle is removed. */
    const medax_pair *of_block = pair_of(block, 27);
    elements(of_block, 8);
    CHECK(medax_pair_removed(of_block).rows == 1);
    medax_pair_free(of_block);

    CHECK(medax_pair_nodes(NULL).rows == 0 && medax_pair_rings(NULL).rows == 0 && medax_pair_clone(NULL) == NULL);
    CHECK(medax_pair_inner_vertices(NULL).cols == 3 && medax_pair_enclosed_volume(NULL) == 0);
    medax_pair_free(NULL);
    return check_end();
}
