/* Triangulations and incidences: bad input, views, order of freeing, two readers. */
#include "check.h"
#include <pthread.h>

static const char nothing = 0;
#define UNTOUCHED ((const medax_triangulation *)(const void *)&nothing)

static const medax_points *points_of(const double *xyz, size_t count) {
    const medax_points *points = NULL;
    CHECK_STATUS(OK, medax_points_create_f64(xyz, count, 0, NULL, NULL, &points));
    return points;
}

static void refusals(void) {
    const double flat[15] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 3, 4, 0};
    const double nan = strtod("nan", NULL);
    double weights[5] = {0, 0, 0, 0, 0};
    const medax_points *three = points_of(flat, 3), *plane = points_of(flat, 5);
    const medax_points *cloud = check_points(5);
    const medax_triangulation *made = UNTOUCHED;
    medax_triangulation_options options;
    NEED(three && plane && cloud);
    CHECK_STATUS(TOO_FEW_POINTS, medax_delaunay_build(three, NULL, NULL, &made));
    CHECK_STATUS(DEGENERATE, medax_delaunay_build(plane, NULL, NULL, &made));
    CHECK_STATUS(NULL_ARGUMENT, medax_delaunay_build(NULL, NULL, NULL, &made));
    CHECK_STATUS(NULL_ARGUMENT, medax_delaunay_build(cloud, NULL, NULL, NULL));
    CHECK_STATUS(DEGENERATE, medax_regular_build(plane, weights, 5, NULL, NULL, &made));
    CHECK_STATUS(NULL_ARGUMENT, medax_regular_build(NULL, weights, 5, NULL, NULL, &made));
    CHECK_STATUS(NULL_ARGUMENT, medax_regular_build(cloud, NULL, 5, NULL, NULL, &made));
    CHECK_STATUS(NULL_ARGUMENT, medax_regular_build(cloud, weights, 5, NULL, NULL, NULL));
    CHECK_STATUS(MISMATCH, medax_regular_build(cloud, weights, 4, NULL, NULL, &made));
    CHECK_STATUS(MISMATCH, medax_regular_build(cloud, NULL, 0, NULL, NULL, &made));
    CHECK_STATUS(INVALID_ARGUMENT,
                 medax_regular_build(cloud, weights, SIZE_MAX, NULL, NULL, &made));
    weights[3] = nan;
    CHECK_STATUS(NON_FINITE, medax_regular_build(cloud, weights, 5, NULL, NULL, &made));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 3);

    CHECK_STATUS(NULL_ARGUMENT, medax_triangulation_options_init(NULL, sizeof options));
    CHECK_STATUS(INVALID_ARGUMENT, medax_triangulation_options_init(&options, 4));
    CHECK_STATUS(OK, medax_triangulation_options_init(&options, sizeof options));
    options.struct_size = 0;
    CHECK_STATUS(INVALID_ARGUMENT, medax_delaunay_build(cloud, &options, NULL, &made));
    CHECK_STATUS(INVALID_ARGUMENT,
                 medax_regular_build(cloud, weights, 5, &options, NULL, &made));
    CHECK(made == UNTOUCHED);
    medax_points_free(cloud);
    medax_points_free(plane);
    medax_points_free(three);
}

static void null_is_nothing(void) {
    const double xyz[3] = {0, 0, 0};
    const medax_points *points = NULL;
    const medax_incidence *incidence = NULL;
    medax_validation report;
    uint32_t cell = 7, cells[4], closed = 7;
    size_t count = 7;
    report.struct_size = sizeof report;
    CHECK(medax_triangulation_cells(NULL).rows == 0 && medax_triangulation_cells(NULL).cols == 4);
    CHECK(medax_triangulation_neighbors(NULL).data == NULL);
    CHECK(medax_triangulation_hidden(NULL).rows == 0);
    CHECK(medax_triangulation_coords(NULL).rows == 0);
    CHECK(medax_triangulation_weights(NULL).rows == 0);
    CHECK(medax_triangulation_row_of_vertex(NULL).rows == 0);
    CHECK_STATUS(NULL_ARGUMENT, medax_triangulation_points(NULL, &points));
    CHECK_STATUS(NULL_ARGUMENT, medax_triangulation_locate(NULL, xyz, 0, &cell));
    CHECK_STATUS(NULL_ARGUMENT,
                 medax_triangulation_ring(NULL, 0, 0, 1, 4, cells, &count, &closed));
    CHECK_STATUS(NULL_ARGUMENT, medax_triangulation_validate(NULL, NULL, &report));
    CHECK_STATUS(NULL_ARGUMENT, medax_incidence_build(NULL, NULL, &incidence));
    CHECK(medax_incidence_cells_of_vertex(NULL).rows == 0);
    CHECK(medax_incidence_cells_of_vertex(NULL).offsets == NULL);
    CHECK(medax_incidence_edges(NULL).rows == 0 && medax_incidence_edges(NULL).cols == 2);
    CHECK(medax_incidence_cell_of_edge(NULL).rows == 0);
    CHECK(medax_triangulation_clone(NULL) == NULL && medax_incidence_clone(NULL) == NULL);
    medax_triangulation_free(NULL);
    medax_incidence_free(NULL);
    CHECK(points == NULL && incidence == NULL && cell == 7 && closed == 7 && count == 7);
}

/* A tetrahedron cut into four by a point in its middle. */
static void a_small_one(void) {
    const double xyz[15] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4, 1, 1, 1};
    const double nan = strtod("nan", NULL);
    const double inside[3] = {0.5, 0.5, 1}, outside[3] = {5, 5, 5}, bad[3] = {0, nan, 0};
    const medax_points *points = points_of(xyz, 5), *again = NULL;
    const medax_triangulation *t = NULL;
    const medax_incidence *incidence = NULL;
    medax_validation report;
    uint32_t cell = 7, ring[8], closed = 7;
    size_t count = 0, closed_rings = 0;
    NEED(points != NULL && medax_delaunay_build(points, NULL, NULL, &t) == MEDAX_STATUS_OK);
    const medax_view_u32 cells = medax_triangulation_cells(t);
    const medax_view_u32 neighbors = medax_triangulation_neighbors(t);
    NEED(cells.rows == 4 && cells.cols == 4 && neighbors.rows == 4 && neighbors.cols == 4);
    for (size_t i = 0; i < 16; ++i) {
        const uint32_t n = neighbors.data[i];
        CHECK(cells.data[i] < 5 && (n == MEDAX_NONE || n < 4));
        CHECK(i % 4 == 0 || cells.data[i] > cells.data[i - i % 4]);
    }
    CHECK(medax_triangulation_hidden(t).rows == 0 && medax_triangulation_weights(t).rows == 0);
    CHECK(medax_triangulation_coords(t).rows == 5 && medax_triangulation_row_of_vertex(t).rows == 5);
    CHECK(medax_triangulation_coords(t).data == medax_points_coords(points).data);

    CHECK_STATUS(OK, medax_triangulation_locate(t, inside, MEDAX_NONE, &cell));
    CHECK(cell < 4);
    CHECK_STATUS(OK, medax_triangulation_locate(t, outside, 2, &cell));
    CHECK(cell == MEDAX_NONE);
    cell = 7;
    CHECK_STATUS(NON_FINITE, medax_triangulation_locate(t, bad, 0, &cell));
    CHECK_STATUS(NULL_ARGUMENT, medax_triangulation_locate(t, NULL, 0, &cell));
    CHECK_STATUS(NULL_ARGUMENT, medax_triangulation_locate(t, inside, 0, NULL));
    CHECK(cell == 7);

    CHECK_STATUS(NULL_ARGUMENT, medax_incidence_build(t, NULL, NULL));
    CHECK_STATUS(OK, medax_incidence_build(t, NULL, &incidence));
    const medax_view_rows of_vertex = medax_incidence_cells_of_vertex(incidence);
    const medax_view_u32 edges = medax_incidence_edges(incidence);
    const medax_view_u32 of_edge = medax_incidence_cell_of_edge(incidence);
    NEED(of_vertex.rows == 5 && of_vertex.offsets[5] == 16 && edges.rows == 10);
    NEED(edges.cols == 2 && of_edge.rows == 10 && of_edge.cols == 1);
    for (size_t e = 0; e < edges.rows; ++e) {
        const uint32_t a = edges.data[2 * e], b = edges.data[2 * e + 1];
        CHECK(a < b && b < 5);
        CHECK_STATUS(OK, medax_triangulation_ring(t, of_edge.data[e], a, b, 8, ring, &count,
                                                  &closed));
        CHECK(count >= 2 && count <= 3 && closed <= 1);
        closed_rings += closed;
    }
    /* The four edges to the middle. */
    CHECK(closed_rings == 4);
    memset(ring, 0xff, sizeof ring);
    CHECK_STATUS(OK, medax_triangulation_ring(t, of_edge.data[0], edges.data[0], edges.data[1], 1,
                                              ring, &count, &closed));
    CHECK(ring[0] < 4 && ring[1] == MEDAX_NONE && count >= 2);
    CHECK_STATUS(OK, medax_triangulation_ring(t, of_edge.data[0], edges.data[0], edges.data[1], 0,
                                              NULL, &count, &closed));
    count = closed = 7;
    CHECK_STATUS(INVALID_ARGUMENT, medax_triangulation_ring(t, 4, 0, 1, 8, ring, &count, &closed));
    CHECK_STATUS(INVALID_ARGUMENT, medax_triangulation_ring(t, 0, cells.data[0], cells.data[0], 8,
                                                            ring, &count, &closed));
    CHECK_STATUS(INVALID_ARGUMENT, medax_triangulation_ring(t, 0, 5, 0, 8, ring, &count, &closed));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_CELL && medax_last_error_index() == 0);
    CHECK_STATUS(NULL_ARGUMENT, medax_triangulation_ring(t, 0, 0, 1, 8, NULL, &count, &closed));
    CHECK_STATUS(NULL_ARGUMENT, medax_triangulation_ring(t, 0, 0, 1, 8, ring, NULL, &closed));
    CHECK_STATUS(NULL_ARGUMENT, medax_triangulation_ring(t, 0, 0, 1, 8, ring, &count, NULL));
    CHECK(count == 7 && closed == 7);

    report.struct_size = 0;
    CHECK_STATUS(INVALID_ARGUMENT, medax_triangulation_validate(t, NULL, &report));
    CHECK_STATUS(NULL_ARGUMENT, medax_triangulation_validate(t, NULL, NULL));
    report.struct_size = sizeof report;
    CHECK_STATUS(OK, medax_triangulation_validate(t, NULL, &report));
    CHECK(report.struct_size == sizeof report && report.checked > 0 && report.problems == 0);
    CHECK(report.first_kind == MEDAX_ERROR_KIND_NONE && report.first_index == UINT64_MAX);
    CHECK(report.first_message[0] == 0);

    CHECK_STATUS(NULL_ARGUMENT, medax_triangulation_points(t, NULL));
    CHECK_STATUS(OK, medax_triangulation_points(t, &again));
    medax_points_free(points);
    medax_triangulation_free(t);
    CHECK(medax_points_count(again) == 5);
    CHECK(edges.data[0] == 0);
    medax_points_free(again);
    medax_incidence_free(incidence);
}

static void weighted(void) {
    /* The middle point is hidden; of its two rows the heavier one counts. */
    const double xyz[18] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4, 1, 1, 1, 1, 1, 1};
    const double weights[6] = {0, 0, 0, 0, -300, -200};
    const medax_points *points = points_of(xyz, 6);
    const medax_triangulation *t = NULL;
    NEED(points && medax_regular_build(points, weights, 6, NULL, NULL, &t) == MEDAX_STATUS_OK);
    const medax_view_u32 hidden = medax_triangulation_hidden(t);
    CHECK(medax_triangulation_cells(t).rows == 1);
    NEED(hidden.rows == 1 && hidden.cols == 1);
    CHECK(hidden.data[0] == medax_points_vertex_of_row(points).data[4]);
    CHECK(medax_triangulation_row_of_vertex(t).data[hidden.data[0]] == 5);
    CHECK(medax_triangulation_weights(t).data[hidden.data[0]] == -200);

    const medax_complex *complex = NULL;
    medax_attribute row;
    CHECK_STATUS(NULL_ARGUMENT, medax_triangulation_complex(NULL, &complex));
    CHECK_STATUS(NULL_ARGUMENT, medax_triangulation_complex(t, NULL));
    CHECK(complex == NULL);
    CHECK_STATUS(OK, medax_triangulation_complex(t, &complex));
    CHECK(medax_complex_cells(complex).rows == 1 && medax_complex_vertices(complex).rows == 5);
    CHECK(medax_complex_cell_types(complex).data[0] == MEDAX_CELL_TYPE_TETRAHEDRON);
    CHECK_STATUS(OK, medax_complex_attribute(complex, MEDAX_ELEMENT_VERTEX, "row", &row));
    CHECK(row.u32_values.data[hidden.data[0]] == 5);
    medax_complex_free(complex);
    medax_triangulation_free(t);
    medax_points_free(points);
}

/* Frees a parent, a child, a grandchild and a clone in the given order. */
static void freed_in_order(const int *order) {
    const medax_points *points = check_points(100);
    const medax_triangulation *t = NULL;
    const medax_incidence *incidence = NULL;
    NEED(points != NULL && medax_delaunay_build(points, NULL, NULL, &t) == MEDAX_STATUS_OK);
    NEED(medax_incidence_build(t, NULL, &incidence) == MEDAX_STATUS_OK);
    const medax_triangulation *again = medax_triangulation_clone(t);
    for (size_t i = 0; i < 4; ++i) {
        switch (order[i]) {
        case 0: medax_points_free(points); break;
        case 1: medax_triangulation_free(t); break;
        case 2: medax_incidence_free(incidence); break;
        default:
            CHECK(medax_triangulation_coords(again).data[299] < 1);
            medax_triangulation_free(again);
        }
    }
}

static void freed_in_every_order(void) {
    for (int code = 0; code < 256; ++code) {
        const int order[4] = {code & 3, code >> 2 & 3, code >> 4 & 3, code >> 6 & 3};
        const int seen = 1 << order[0] | 1 << order[1] | 1 << order[2] | 1 << order[3];
        if (seen == 15) freed_in_order(order);
    }
}

/* Reads every cell and locates every vertex; the sum must be the same in every thread. */
struct reader {
    const medax_triangulation *triangulation;
    uint64_t sum;
};

static void *read_all(void *argument) {
    struct reader *reader = argument;
    const medax_triangulation *t = medax_triangulation_clone(reader->triangulation);
    const medax_view_u32 cells = medax_triangulation_cells(t);
    const medax_view_f64 coords = medax_triangulation_coords(t);
    for (size_t i = 0; i < cells.rows * cells.cols; ++i) reader->sum += i * cells.data[i];
    for (size_t v = 0; v < coords.rows; ++v) {
        uint32_t cell = MEDAX_NONE;
        medax_triangulation_locate(t, coords.data + 3 * v, 0, &cell);
        reader->sum += cell;
    }
    medax_triangulation_free(t);
    return NULL;
}

static void two_readers(void) {
    const medax_points *points = check_points(2000);
    const medax_triangulation *t = NULL;
    struct reader readers[3] = {{NULL, 0}, {NULL, 0}, {NULL, 0}};
    pthread_t threads[2];
    NEED(points != NULL && medax_delaunay_build(points, NULL, NULL, &t) == MEDAX_STATUS_OK);
    for (size_t i = 0; i < 3; ++i) readers[i].triangulation = t;
    for (size_t i = 0; i < 2; ++i)
        NEED(pthread_create(&threads[i], NULL, read_all, &readers[i]) == 0);
    read_all(&readers[2]);
    for (size_t i = 0; i < 2; ++i) pthread_join(threads[i], NULL);
    CHECK(readers[0].sum == readers[2].sum && readers[1].sum == readers[2].sum);
    CHECK(readers[0].sum != 0);
    medax_triangulation_free(t);
    medax_points_free(points);
}

int main(void) {
    refusals();
    null_is_nothing();
    a_small_one();
    weighted();
    freed_in_every_order();
    two_readers();
    return check_end();
}
