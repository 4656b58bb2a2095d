/* Sites: made of pieces, figures and complexes, and what is refused. */
#include "boundary.h"

/* What an output points at before the call. */
static const char untouched = 0;
#define UNTOUCHED ((const medax_sites *)(const void *)&untouched)

/* One piece of each kind, on three sites. */
static void each_kind(medax_piece pieces[6]) {
    for (uint32_t kind = 0; kind < 6; ++kind)
        pieces[kind] = piece(kind, kind / 2, kind, 2, 3, 4, kind == 5 ? 0 : 5, kind == 5 ? 0 : -6);
    pieces[0].numbers[3] = pieces[0].numbers[4] = pieces[0].numbers[5] = 0;
    pieces[4].numbers[6] = 7;
    pieces[4].numbers[8] = -9;
}

static void pieces_come_back(void) {
    medax_piece given[6], found[6], with_noise[6];
    double min[3], max[3];
    each_kind(given);
    memcpy(with_noise, given, sizeof given);
    /* Numbers that a kind does not have are not looked at. */
    with_noise[0].numbers[3] = with_noise[1].numbers[6] = with_noise[5].numbers[4] = strtod("nan", NULL);
    const medax_sites *sites = sites_of(3, with_noise, 6);
    CHECK(medax_sites_dimension(sites) == 3 && medax_sites_piece_count(sites) == 6);
    CHECK(medax_sites_site_count(sites) == 3);
    CHECK_STATUS(OK, medax_sites_pieces(sites, 0, 6, found));
    CHECK(memcmp(found, given, sizeof given) == 0);
    memset(found, 0, sizeof found);
    CHECK_STATUS(OK, medax_sites_pieces(sites, 4, 2, found));
    CHECK(memcmp(found, given + 4, 2 * sizeof *given) == 0 && found[2].kind == 0);
    CHECK_STATUS(OK, medax_sites_pieces(sites, 6, 0, NULL));
    CHECK_STATUS(INVALID_ARGUMENT, medax_sites_pieces(sites, 5, 2, found));
    CHECK_STATUS(INVALID_ARGUMENT, medax_sites_pieces(sites, 7, 0, found));
    CHECK_STATUS(INVALID_ARGUMENT, medax_sites_pieces(sites, SIZE_MAX, 2, found));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_pieces(sites, 0, 1, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_pieces(NULL, 0, 1, found));
    const medax_view_u32 numbers = medax_sites_site_of_piece(sites);
    NEED(numbers.rows == 6 && numbers.cols == 1);
    for (uint32_t i = 0; i < 6; ++i) CHECK(numbers.data[i] == i / 2);
    /* The ray and the line are unbounded; the sphere has its centre at (5, 2, 3) and the radius 4. */
    CHECK_STATUS(OK, medax_sites_bounds(sites, min, max));
    CHECK(min[0] == 0 && min[1] == -2 && min[2] == -9 && max[0] == 9 && max[1] == 6 && max[2] == 7);
    CHECK(fabs(medax_sites_size(sites) - sqrt(81 + 64 + 256)) < 1e-12);
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_bounds(NULL, min, max));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_bounds(sites, NULL, max));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_bounds(sites, min, NULL));
    const medax_sites *again = medax_sites_clone(sites);
    CHECK(again == sites);
    medax_sites_free(sites);
    CHECK(medax_sites_piece_count(again) == 6);
    medax_sites_free(again);

    const medax_sites *endless = sites_of(3, given + 2, 2);
    min[0] = 77;
    CHECK_STATUS(DEGENERATE, medax_sites_bounds(endless, min, max));
    CHECK(min[0] == 77 && medax_sites_size(endless) == 1);
    medax_sites_free(endless);
}

static void figures(void) {
    /* A square with a square hole, an L, a point, a circle. */
    static const double ring_vertices[16] = {0, 0, 9, 0, 9, 9, 0, 9, 3, 3, 3, 5, 5, 5, 5, 3};
    static const uint32_t ring_offsets[3] = {0, 4, 8}, polygon_offsets[2] = {0, 2};
    static const double polyline[6] = {20, 0, 20, 5, 25, 5}, points[2] = {1, 1}, circles[3] = {50, 50, 2};
    static const uint32_t polyline_offsets[2] = {0, 3};
    static const uint32_t site_of[12] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 2, 3};
    const double queries[15] = {1, 2, 0, 4, 4, 0, 22, 3, 0, 50, 51, 0, 10, 10, 0};
    static const uint8_t expected[5] = {1, 0, 0, 1, 0};
    uint8_t is_inside[5] = {9, 9, 9, 9, 9};
    medax_piece found[12];
    medax_figure_parts parts;
    const medax_figure *figure = NULL;
    const medax_sites *sites = UNTOUCHED;
    medax_figure_parts_init(&parts, sizeof parts);
    parts.ring_vertices = ring_vertices;
    parts.ring_vertex_count = 8;
    parts.ring_offsets = ring_offsets;
    parts.ring_count = 2;
    parts.polygon_offsets = polygon_offsets;
    parts.polygon_count = 1;
    parts.polyline_vertices = polyline;
    parts.polyline_vertex_count = 3;
    parts.polyline_offsets = polyline_offsets;
    parts.polyline_count = 1;
    parts.points = points;
    parts.point_count = 1;
    parts.circles = circles;
    parts.circle_count = 1;
    CHECK_STATUS(OK, medax_figure_create(&parts, NULL, &figure));
    NEED(figure != NULL);
    const medax_job *spent = spent_job();
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_of_figure(NULL, NULL, &sites));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_of_figure(figure, NULL, NULL));
    CHECK_STATUS(CANCELLED, medax_sites_of_figure(figure, spent, &sites));
    CHECK(sites == UNTOUCHED);
    medax_job_free(spent);
    CHECK_STATUS(OK, medax_sites_of_figure(figure, NULL, &sites));
    medax_figure_free(figure);
    NEED(sites != UNTOUCHED && medax_sites_piece_count(sites) == 12);
    CHECK(medax_sites_dimension(sites) == 2 && medax_sites_site_count(sites) == 4);
    CHECK(memcmp(medax_sites_site_of_piece(sites).data, site_of, sizeof site_of) == 0);
    CHECK_STATUS(OK, medax_sites_pieces(sites, 0, 12, found));
    for (size_t i = 0; i < 10; ++i) CHECK(found[i].kind == MEDAX_PIECE_KIND_SEGMENT);
    CHECK(found[1].numbers[0] == 9 && found[1].numbers[4] == 9 && found[1].numbers[5] == 0);
    CHECK(found[10].kind == MEDAX_PIECE_KIND_POINT && found[10].numbers[1] == 1);
    CHECK(found[11].kind == MEDAX_PIECE_KIND_SPHERE && found[11].numbers[3] == 2);
    CHECK_STATUS(OK, medax_sites_is_inside(sites, queries, 5, NULL, is_inside));
    CHECK(memcmp(is_inside, expected, sizeof expected) == 0);
    medax_sites_free(sites);
}

static void complexes(void) {
    /* A tetrahedron whose faces point out, a loose edge, a lone vertex. */
    static const double vertices[21] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4, 8, 0, 0, 9, 0, 0, 9, 9, 9};
    static const uint32_t offsets[5] = {0, 3, 6, 9, 12}, edge[2] = {4, 5};
    static const uint32_t faces[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    static const uint8_t flags[4] = {1, 1, 1, 0};
    const double queries[6] = {0.5, 0.5, 0.5, 5, 5, 5};
    uint8_t is_inside[2] = {9, 9};
    medax_piece found[6];
    medax_complex_parts parts;
    const medax_complex *complex = NULL;
    const medax_sites *sites = UNTOUCHED;
    medax_complex_parts_init(&parts, sizeof parts);
    CHECK_STATUS(OK, medax_complex_create(&parts, &complex));
    CHECK_STATUS(INVALID_ARGUMENT, medax_sites_of_complex(complex, NULL, 0, NULL, &sites));
    medax_complex_free(complex);
    parts.vertices = vertices;
    parts.vertex_count = 7;
    parts.face_offsets = offsets;
    parts.face_indices = faces;
    parts.face_count = 4;
    parts.edges = edge;
    parts.edge_count = 1;
    CHECK_STATUS(OK, medax_complex_create(&parts, &complex));
    CHECK_STATUS(INVALID_ARGUMENT, medax_sites_of_complex(complex, flags, 4, NULL, &sites));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_of_complex(complex, NULL, 4, NULL, &sites));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_of_complex(NULL, NULL, 0, NULL, &sites));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_of_complex(complex, NULL, 0, NULL, NULL));
    const medax_job *small = job_with(64, 0);
    CHECK_STATUS(OUT_OF_MEMORY, medax_sites_of_complex(complex, NULL, 0, small, &sites));
    medax_job_free(small);
    CHECK(sites == UNTOUCHED);
    CHECK_STATUS(INVALID_ARGUMENT, medax_sites_of_components(complex, flags, 4, NULL, &sites));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_of_components(NULL, NULL, 0, NULL, &sites));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_of_components(complex, NULL, 0, NULL, NULL));
    CHECK(sites == UNTOUCHED);
    CHECK_STATUS(OK, medax_sites_of_components(complex, NULL, 0, NULL, &sites));
    /* The faces, the edge, the vertex. */
    NEED(medax_sites_piece_count(sites) == 6);
    static const uint32_t components[6] = {0, 0, 0, 0, 1, 2};
    CHECK(medax_sites_site_count(sites) == 3);
    CHECK(memcmp(medax_sites_site_of_piece(sites).data, components, sizeof components) == 0);
    medax_sites_free(sites);
    sites = UNTOUCHED;
    CHECK_STATUS(OK, medax_sites_of_complex(complex, NULL, 0, NULL, &sites));
    /* The sites keep the mesh alive, whose faces wind round what is inside. */
    medax_complex_free(complex);
    NEED(medax_sites_piece_count(sites) == 6);
    CHECK(medax_sites_dimension(sites) == 3 && medax_sites_site_count(sites) == 1);
    CHECK_STATUS(OK, medax_sites_pieces(sites, 0, 6, found));
    CHECK(found[3].kind == MEDAX_PIECE_KIND_TRIANGLE && found[3].numbers[8] == 4);
    CHECK(found[4].kind == MEDAX_PIECE_KIND_SEGMENT && found[4].numbers[3] == 9);
    CHECK(found[5].kind == MEDAX_PIECE_KIND_POINT && found[5].numbers[2] == 9 && found[5].site == 0);
    CHECK_STATUS(OK, medax_sites_is_inside(sites, queries, 2, NULL, is_inside));
    CHECK(is_inside[0] == 1 && is_inside[1] == 0);
    medax_sites_free(sites);
}

/* Three loose edges of a plane complex that close, and one that does not belong to them. */
static void closed_edges(void) {
    static const double vertices[15] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 0.5, 0.2, 0, 1, 0.2, 0};
    static const uint32_t edges[8] = {0, 1, 1, 2, 2, 0, 3, 4};
    static const uint8_t flags[4] = {1, 1, 1, 0}, wrong[4] = {1, 1, 2, 0};
    const double queries[9] = {0.5, 1, 0, 0.5, 0.1, 0, 3, 3, 0};
    uint8_t is_inside[3] = {9, 9, 9};
    medax_complex_parts parts;
    const medax_complex *complex = NULL;
    const medax_sites *sites = UNTOUCHED;
    medax_complex_parts_init(&parts, sizeof parts);
    parts.dimension = 2;
    parts.vertices = vertices;
    parts.vertex_count = 5;
    parts.edges = edges;
    parts.edge_count = 4;
    CHECK_STATUS(OK, medax_complex_create(&parts, &complex));
    CHECK_STATUS(MISMATCH, medax_sites_of_complex(complex, flags, 3, NULL, &sites));
    CHECK_STATUS(INVALID_ARGUMENT, medax_sites_of_complex(complex, wrong, 4, NULL, &sites));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 2);
    CHECK(sites == UNTOUCHED);
    for (int closed = 0; closed < 2; ++closed) {
        CHECK_STATUS(OK, medax_sites_of_complex(complex, flags, closed ? 4 : 0, NULL, &sites));
        CHECK(medax_sites_dimension(sites) == 2);
        CHECK_STATUS(OK, medax_sites_is_inside(sites, queries, 3, NULL, is_inside));
        CHECK(is_inside[0] == closed && is_inside[1] == closed && is_inside[2] == 0);
        medax_sites_free(sites);
    }
    medax_complex_free(complex);
}

/* What is wrong with the pieces: status and row. */
static void refusals(void) {
    const double nan = strtod("nan", NULL);
    const uint8_t flags[3] = {1, 0, 1}, wrong[3] = {1, 0, 7};
    const medax_sites *sites = UNTOUCHED;
    for (int i = 0; i < 20; ++i) {
        medax_piece pieces[3];
        medax_status status = MEDAX_STATUS_INVALID_ARGUMENT;
        uint32_t dimension = 2;
        uint64_t row = 1;
        size_t count = 3, flag_count = 0;
        const uint8_t *is_closed = flags;
        medax_piece *middle = pieces + 1;
        pieces[0] = piece(MEDAX_PIECE_KIND_POINT, 0, 1, 2, 0, 0, 0, 0);
        pieces[1] = piece(MEDAX_PIECE_KIND_SEGMENT, 0, 3, 4, 0, 5, 6, 0);
        pieces[2] = piece(MEDAX_PIECE_KIND_SPHERE, 7, 5, 6, 0, 1, 0, 0);
        switch (i) {
        case 0: middle->numbers[4] = nan; status = MEDAX_STATUS_NON_FINITE; break;
        case 1: middle->numbers[4] = HUGE_VAL; status = MEDAX_STATUS_NON_FINITE; break;
        case 2: middle->numbers[0] = 1e300; status = MEDAX_STATUS_COORDINATE_RANGE; break;
        case 3: middle->kind = 6; break;
        case 4: middle->kind = UINT32_MAX; break;
        case 5: middle->kind = MEDAX_PIECE_KIND_TRIANGLE; break;
        case 6: middle->numbers[2] = 1; break;
        case 7: *middle = piece(MEDAX_PIECE_KIND_RAY, 0, 1, 1, 0, 0, 0, 0); break;
        case 8: *middle = piece(MEDAX_PIECE_KIND_LINE, 0, 1, 1, 0, 0, 0, 0); break;
        case 9: pieces[2].numbers[3] = 0; row = 2; break;
        case 10: pieces[2].numbers[3] = nan; status = MEDAX_STATUS_NON_FINITE; row = 2; break;
        case 11: pieces[2].site = MEDAX_NONE; row = 2; break;
        case 12: dimension = 1; row = UINT64_MAX; break;
        case 13: dimension = 4; row = UINT64_MAX; break;
        case 14: count = 0; row = UINT64_MAX; break;
        case 15: dimension = 3; flag_count = 3; row = UINT64_MAX; break;
        case 16: flag_count = 2; status = MEDAX_STATUS_MISMATCH; row = UINT64_MAX; break;
        case 17: flag_count = 3; is_closed = wrong; row = 2; break;
        case 18: count = SIZE_MAX; row = UINT64_MAX; break;
        default: flag_count = 3; is_closed = NULL; status = MEDAX_STATUS_NULL_ARGUMENT; row = UINT64_MAX;
        }
        CHECK(medax_sites_create(dimension, pieces, count, is_closed, flag_count, NULL, &sites) == status);
        CHECK(medax_last_error_index() == row);
        CHECK(medax_last_error_kind()
              == (row == UINT64_MAX ? MEDAX_ERROR_KIND_NONE : MEDAX_ERROR_KIND_ROW));
    }
    const medax_piece good = piece(MEDAX_PIECE_KIND_POINT, 0, 1, 2, 0, 0, 0, 0);
    const medax_job *spent = spent_job();
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_create(2, NULL, 1, NULL, 0, NULL, &sites));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_create(2, &good, 1, NULL, 0, NULL, NULL));
    CHECK_STATUS(CANCELLED, medax_sites_create(2, &good, 1, NULL, 0, spent, &sites));
    medax_job_free(spent);
    CHECK(sites == UNTOUCHED);
}

/* The caller's arrays and what is made of them count. */
static void memory(void) {
    enum { COUNT = 2000 };
    medax_piece *pieces = malloc(COUNT * sizeof *pieces);
    const medax_sites *sites = UNTOUCHED;
    uint64_t state = 3;
    NEED(pieces != NULL);
    for (size_t i = 0; i < COUNT; ++i)
        pieces[i] = piece(MEDAX_PIECE_KIND_POINT, 0, check_random(&state), check_random(&state), 0, 0, 0, 0);
    const medax_job *small = job_with(100000, 0), *large = job_with(0, 0);
    CHECK_STATUS(OUT_OF_MEMORY, medax_sites_create(2, pieces, COUNT, NULL, 0, small, &sites));
    CHECK(sites == UNTOUCHED);
    CHECK_STATUS(OK, medax_sites_create(2, pieces, COUNT, NULL, 0, large, &sites));
    CHECK(medax_job_memory_peak(large) >= COUNT * sizeof *pieces);
    medax_sites_free(sites);
    medax_job_free(small);
    medax_job_free(large);
    free(pieces);
}

static void null_is_nothing(void) {
    CHECK(medax_sites_dimension(NULL) == 0 && medax_sites_piece_count(NULL) == 0);
    CHECK(medax_sites_site_count(NULL) == 0 && medax_sites_size(NULL) == 0);
    CHECK(medax_sites_site_of_piece(NULL).rows == 0 && medax_sites_site_of_piece(NULL).data == NULL);
    CHECK(medax_sites_clone(NULL) == NULL);
    medax_sites_free(NULL);
}

int main(void) {
    pieces_come_back();
    figures();
    complexes();
    closed_edges();
    refusals();
    memory();
    null_is_nothing();
    return check_end();
}
