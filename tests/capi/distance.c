/* What is nearest, all that is as near, and what lies inside. */
#include "boundary.h"

static const char untouched = 0;
#define UNTOUCHED ((const medax_all_nearest *)(const void *)&untouched)

static int near(double a, double b) {
    return fabs(a - b) < 1e-12;
}

/* One piece of each kind, with the nearest point of it worked out by hand. */
static void kinds(void) {
    static const double queries[6][3] = {{4, 6, 2}, {3, 4, 5}, {-3, 4, 0}, {7, 3, 4}, {1, 1, 5}, {0, 6, 8}};
    static const double nearest[6][3] = {{1, 2, 2}, {3, 0, 0}, {0, 0, 0}, {7, 0, 0}, {1, 1, 0}, {0, 3, 4}};
    static const double distances[6] = {5, 0, 5, 5, 5, 5};
    medax_piece pieces[6];
    pieces[0] = piece(MEDAX_PIECE_KIND_POINT, 4, 1, 2, 2, 0, 0, 0);
    pieces[1] = piece(MEDAX_PIECE_KIND_SEGMENT, 4, 0, 0, 0, 10, 0, 0);
    pieces[2] = piece(MEDAX_PIECE_KIND_RAY, 4, 0, 0, 0, 1e-9, 0, 0);
    pieces[3] = piece(MEDAX_PIECE_KIND_LINE, 4, 100, 0, 0, -1e9, 0, 0);
    pieces[4] = piece(MEDAX_PIECE_KIND_TRIANGLE, 4, 0, 0, 0, 4, 0, 0);
    pieces[4].numbers[7] = 4;
    pieces[5] = piece(MEDAX_PIECE_KIND_SPHERE, 4, 0, 0, 0, 5, 0, 0);
    for (size_t i = 0; i < 6; ++i) {
        medax_nearest found;
        const medax_sites *sites = sites_of(3, pieces + i, 1);
        const double d = i == 1 ? sqrt(41) : distances[i];
        CHECK_STATUS(OK, medax_sites_nearest(sites, queries[i], 1, NULL, &found));
        CHECK(near(found.distance, d) && found.piece == 0 && found.site == 4);
        for (size_t k = 0; k < 3; ++k) {
            CHECK(near(found.point[k], nearest[i][k]));
            CHECK(near(found.direction[k], (nearest[i][k] - queries[i][k]) / d));
        }
        /* On the boundary there is no way to it; that of a sphere is rounded. */
        CHECK_STATUS(OK, medax_sites_nearest(sites, nearest[i], 1, NULL, &found));
        CHECK(near(found.distance, 0));
        CHECK(i == 5 || (found.direction[0] == 0 && found.direction[1] == 0 && found.direction[2] == 0));
        medax_sites_free(sites);
    }
}

/* Where the medial axis of a rectangle branches three sides are as near, in the middle of a square four. */
static void ties(void) {
    const double queries[9] = {1, 1, 0, 2, 1, 0, 2, 0.5, 0};
    static const uint32_t offsets[4] = {0, 3, 5, 6}, pieces[6] = {0, 2, 3, 0, 2, 0};
    const medax_sites *sites = rectangle(4, 2);
    const medax_all_nearest *all = UNTOUCHED;
    CHECK_STATUS(OK, medax_sites_all_nearest(sites, queries, 3, 0, NULL, &all));
    medax_sites_free(sites);
    const medax_view_rows rows = medax_all_nearest_pieces(all);
    const medax_view_f64 points = medax_all_nearest_points(all);
    const medax_view_f64 distances = medax_all_nearest_distances(all);
    const medax_view_f64 directions = medax_all_nearest_directions(all);
    const medax_view_u32 numbers = medax_all_nearest_sites(all);
    NEED(rows.rows == 3 && points.rows == 6 && points.cols == 3 && distances.rows == 6);
    NEED(distances.cols == 1 && directions.rows == 6 && directions.cols == 3 && numbers.rows == 6);
    CHECK(memcmp(rows.offsets, offsets, sizeof offsets) == 0);
    CHECK(memcmp(rows.indices, pieces, sizeof pieces) == 0);
    for (uint32_t row = 0; row < 3; ++row)
        for (uint32_t i = offsets[row]; i < offsets[row + 1]; ++i) {
            CHECK(numbers.data[i] == 0 && near(distances.data[i], row == 2 ? 0.5 : 1));
            for (size_t k = 0; k < 3; ++k)
                CHECK(near(points.data[3 * i + k],
                           queries[3 * row + k] + distances.data[i] * directions.data[3 * i + k]));
        }
    const medax_all_nearest *again = medax_all_nearest_clone(all);
    medax_all_nearest_free(all);
    CHECK(again == all && medax_all_nearest_pieces(again).indices[2] == 3);
    medax_all_nearest_free(again);

    /* A tolerance lets pass what is a little farther. */
    const double aside[3] = {1, 1.01, 0}, *none = NULL;
    const medax_sites *square = rectangle(2, 2);
    for (int wide = 0; wide < 2; ++wide) {
        CHECK_STATUS(OK, medax_sites_all_nearest(square, aside, 1, wide ? 0.021 : 0.019, NULL, &all));
        CHECK(medax_all_nearest_pieces(all).offsets[1] == (wide ? 4 : 3));
        medax_all_nearest_free(all);
    }
    CHECK_STATUS(OK, medax_sites_all_nearest(square, none, 0, 0, NULL, &all));
    CHECK(medax_all_nearest_pieces(all).rows == 0 && medax_all_nearest_pieces(all).offsets[0] == 0);
    CHECK(medax_all_nearest_points(all).data == NULL);
    medax_all_nearest_free(all);
    medax_sites_free(square);
}

/* Random points against all pieces one by one, with one thread and with several. */
static void many(void) {
    enum { PIECES = 300, QUERIES = 5000 };
    static double queries[3 * QUERIES];
    static medax_piece pieces[PIECES];
    static medax_nearest one[QUERIES], several[QUERIES];
    uint64_t state = 5;
    for (size_t i = 0; i < PIECES; ++i) {
        const double x = check_random(&state), y = check_random(&state);
        pieces[i] = piece(MEDAX_PIECE_KIND_SEGMENT, (uint32_t)i % 7, x, y, 0,
                          x + 0.1 * check_random(&state), y + 0.1 * check_random(&state), 0);
    }
    for (size_t i = 0; i < 3 * QUERIES; ++i)
        queries[i] = i % 3 == 2 ? 0 : 1.4 * check_random(&state) - 0.2;
    const medax_sites *sites = sites_of(2, pieces, PIECES);
    const medax_job *single = job_with(0, 1), *three = job_with(0, 3);
    CHECK_STATUS(OK, medax_sites_nearest(sites, queries, QUERIES, single, one));
    CHECK_STATUS(OK, medax_sites_nearest(sites, queries, QUERIES, three, several));
    CHECK(memcmp(one, several, sizeof one) == 0);
    size_t off = 0;
    for (size_t i = 0; i < QUERIES; ++i) {
        double d = HUGE_VAL;
        for (size_t k = 0; k < PIECES; ++k) {
            const double *n = pieces[k].numbers;
            d = least(d, to_segment(queries + 3 * i, n[0], n[1], n[3], n[4]));
        }
        const double *n = pieces[one[i].piece].numbers;
        const double found = to_segment(queries + 3 * i, n[0], n[1], n[3], n[4]);
        off += !near(one[i].distance, d) || !near(found, d) || one[i].site != one[i].piece % 7;
    }
    CHECK(off == 0);
    medax_job_free(single);
    medax_job_free(three);
    medax_sites_free(sites);
}

static void refusals(void) {
    double queries[9] = {0, 0, 0, 1, 1, 0, 2, 2, 0};
    const double bad[3] = {strtod("nan", NULL), HUGE_VAL, 1e200};
    const double tolerances[2] = {strtod("nan", NULL), -1e-9};
    medax_nearest found[3];
    uint8_t is_inside[3] = {9, 9, 9};
    const medax_all_nearest *all = UNTOUCHED;
    const medax_sites *sites = rectangle(4, 2);
    const medax_job *spent = spent_job(), *small = job_with(100, 0);
    memset(found, 0, sizeof found);
    for (size_t i = 0; i < 3; ++i) {
        const medax_status status = i < 2 ? MEDAX_STATUS_NON_FINITE : MEDAX_STATUS_COORDINATE_RANGE;
        queries[7] = bad[i];
        CHECK(medax_sites_nearest(sites, queries, 3, NULL, found) == status);
        CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 2);
        CHECK(medax_sites_all_nearest(sites, queries, 3, 0, NULL, &all) == status);
        CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 2);
        CHECK(medax_sites_is_inside(sites, queries, 3, NULL, is_inside) == status);
        CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 2);
    }
    queries[7] = 2;
    for (size_t i = 0; i < 2; ++i)
        CHECK_STATUS(INVALID_ARGUMENT,
                     medax_sites_all_nearest(sites, queries, 3, tolerances[i], NULL, &all));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_nearest(NULL, queries, 3, NULL, found));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_nearest(sites, NULL, 3, NULL, found));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_nearest(sites, queries, 3, NULL, NULL));
    CHECK_STATUS(INVALID_ARGUMENT, medax_sites_nearest(sites, queries, SIZE_MAX, NULL, found));
    CHECK_STATUS(CANCELLED, medax_sites_nearest(sites, queries, 3, spent, found));
    CHECK_STATUS(OUT_OF_MEMORY, medax_sites_nearest(sites, queries, 3, small, found));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_all_nearest(NULL, queries, 3, 0, NULL, &all));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_all_nearest(sites, NULL, 3, 0, NULL, &all));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_all_nearest(sites, queries, 3, 0, NULL, NULL));
    CHECK_STATUS(INVALID_ARGUMENT, medax_sites_all_nearest(sites, queries, SIZE_MAX, 0, NULL, &all));
    CHECK_STATUS(CANCELLED, medax_sites_all_nearest(sites, queries, 3, 0, spent, &all));
    CHECK_STATUS(OUT_OF_MEMORY, medax_sites_all_nearest(sites, queries, 3, 0, small, &all));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_is_inside(NULL, queries, 3, NULL, is_inside));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_is_inside(sites, NULL, 3, NULL, is_inside));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_is_inside(sites, queries, 3, NULL, NULL));
    CHECK_STATUS(INVALID_ARGUMENT, medax_sites_is_inside(sites, queries, SIZE_MAX, NULL, is_inside));
    CHECK_STATUS(CANCELLED, medax_sites_is_inside(sites, queries, 3, spent, is_inside));
    CHECK(all == UNTOUCHED && is_inside[0] == 9 && found[0].distance == 0 && found[0].piece == 0);
    CHECK_STATUS(OK, medax_sites_nearest(sites, NULL, 0, NULL, NULL));
    CHECK_STATUS(OK, medax_sites_is_inside(sites, NULL, 0, NULL, NULL));
    medax_job_free(spent);
    medax_job_free(small);
    medax_sites_free(sites);
}

/* A query is cancelled on its way. */
static void cancelled(void) {
    int stopped = 0;
    for (size_t count = 20000; !stopped && count < 100000000; count *= 4) {
        char stage[] = "query";
        const medax_job *job = stopping_job(stage);
        const medax_sites *sites = rectangle(4, 2);
        double *queries = check_cloud(count);
        const medax_all_nearest *all = UNTOUCHED;
        NEED(queries != NULL);
        if (medax_sites_all_nearest(sites, queries, count, 10, job, &all) == MEDAX_STATUS_OK) {
            medax_all_nearest_free(all);
        } else {
            stopped = 1;
            CHECK(all == UNTOUCHED && medax_job_is_cancelled(job));
        }
        free(queries);
        medax_sites_free(sites);
        medax_job_free(job);
    }
    CHECK(stopped);
}

static void null_is_nothing(void) {
    CHECK(medax_all_nearest_pieces(NULL).rows == 0 && medax_all_nearest_pieces(NULL).offsets == NULL);
    CHECK(medax_all_nearest_sites(NULL).cols == 1 && medax_all_nearest_points(NULL).cols == 3);
    CHECK(medax_all_nearest_distances(NULL).rows == 0 && medax_all_nearest_directions(NULL).cols == 3);
    CHECK(medax_all_nearest_clone(NULL) == NULL);
    medax_all_nearest_free(NULL);
}

int main(void) {
    kinds();
    ties();
    many();
    refusals();
    cancelled();
    null_is_nothing();
    return check_end();
}
