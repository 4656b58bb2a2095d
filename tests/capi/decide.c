/* Whether circles and spheres hold medial points. */
#include "boundary.h"

static const double pi = 3.14159265358979323846;

static medax_decision decided(const medax_sites *sites, double x, double y, double z, double radius,
                              size_t samples) {
    double directions[3 * 256], theta[6 * 256];
    const double center[3] = {x, y, z};
    medax_decision found;
    memset(&found, 0, sizeof found);
    found.struct_size = sizeof found;
    NEED(samples <= 256);
    CHECK_STATUS(OK, medax_sites_even_directions(sites, samples, directions));
    CHECK_STATUS(OK, medax_sites_decide(sites, center, radius, directions, samples, NULL, NULL,
                                        2 * samples, theta, &found));
    CHECK(found.struct_size == sizeof found && found.reserved == 0);
    /* Theta lies on the circle or sphere. */
    for (size_t i = 0; i < found.theta_count; ++i) {
        const double *p = theta + 3 * i;
        const double d = sqrt((p[0] - x) * (p[0] - x) + (p[1] - y) * (p[1] - y) + (p[2] - z) * (p[2] - z));
        CHECK(fabs(d - radius) < 1e-12 * (1 + radius));
    }
    return found;
}

static void even_directions(void) {
    double directions[3 * 60] = {0};
    const medax_sites *plane = two_points(2), *space = two_points(3);
    CHECK_STATUS(OK, medax_sites_even_directions(plane, 8, directions));
    for (size_t i = 0; i < 8; ++i) {
        CHECK(fabs(directions[3 * i] - cos((double)i * pi / 4)) < 1e-15);
        CHECK(fabs(directions[3 * i + 1] - sin((double)i * pi / 4)) < 1e-15 && directions[3 * i + 2] == 0);
    }
    CHECK_STATUS(OK, medax_sites_even_directions(space, 60, directions));
    double sum[3] = {0, 0, 0};
    for (size_t i = 0; i < 60; ++i) {
        const double *u = directions + 3 * i;
        CHECK(fabs(u[0] * u[0] + u[1] * u[1] + u[2] * u[2] - 1) < 1e-14);
        for (size_t k = 0; k < 3; ++k) sum[k] += u[k] / 60;
    }
    CHECK(fabs(sum[0]) < 0.02 && fabs(sum[1]) < 0.02 && fabs(sum[2]) < 1e-14);
    CHECK_STATUS(OK, medax_sites_even_directions(plane, 0, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_even_directions(plane, 1, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_sites_even_directions(NULL, 8, directions));
    CHECK_STATUS(INVALID_ARGUMENT, medax_sites_even_directions(plane, SIZE_MAX, directions));
    medax_sites_free(plane);
    medax_sites_free(space);
}

/* A strip: on its middle line two sides are nearest. */
static void strip(void) {
    const medax_sites *sites = rectangle(10, 2);
    const medax_decision across = decided(sites, 5, 1.1, 0, 0.5, 16);
    CHECK(across.test == MEDAX_DECIDE_TEST_OPPOSITE && across.unconfirmed == 0);
    CHECK(fabs(across.center[1] - 1) < 1e-5 && fabs(across.radius - 1) < 1e-5);
    CHECK(fabs(across.object_angle - pi) < 1e-4 && across.pieces[0] + across.pieces[1] == 2);
    CHECK(fabs(across.feet[1] - across.feet[4]) > 2 - 1e-5 && across.feet[2] == 0);
    /* Below the middle all nearest points are on one side: each opposite is the mirror image, and the eight points are
       their own images. */
    const medax_decision below = decided(sites, 5, 0.5, 0, 0.3, 8);
    CHECK(below.test == MEDAX_DECIDE_TEST_NONE && below.theta_count == 8);
    CHECK(fabs(below.gap - 0.3 * pi / 4) < 1e-12);
    CHECK(below.radius == 0 && below.object_angle == 0 && below.center[0] == 0 && below.feet[5] == 0);
    CHECK(below.pieces[0] == MEDAX_NONE && below.pieces[1] == MEDAX_NONE);
    medax_sites_free(sites);
}

/* Of two points at -1 and 1 the axis is x = 0: at height h the radius is the root of 1 + h^2, and half the angle has the tangent 1 / h. */
static void points(void) {
    for (uint32_t dimension = 2; dimension <= 3; ++dimension) {
        const medax_sites *sites = two_points(dimension);
        const medax_decision found = decided(sites, 0.1, 3, dimension == 3 ? 1 : 0, 0.5, dimension == 2 ? 16 : 64);
        const double h = hypot(found.center[1], found.center[2]);
        CHECK(found.test != MEDAX_DECIDE_TEST_NONE && fabs(found.center[0]) < 3e-6);
        CHECK(fabs(found.radius - sqrt(1 + h * h)) < 3e-6);
        CHECK(fabs(found.object_angle - 2 * atan(1 / h)) < 3e-6);
        CHECK(found.pieces[0] + found.pieces[1] == 1 && fabs(found.feet[0] + found.feet[3]) < 1e-12);
        CHECK((found.gap > 0) == (dimension == 2));
        /* Far from the axis there is none; in space both points of each direction are in Theta. */
        const medax_decision none = decided(sites, 3, 3, 0, 0.5, 64);
        CHECK(none.test == MEDAX_DECIDE_TEST_NONE && (dimension == 2 || none.theta_count == 128));
        medax_sites_free(sites);
    }
    /* The axis of the inside of a sphere is its centre. */
    const medax_piece sphere = piece(MEDAX_PIECE_KIND_SPHERE, 0, 1, 2, 3, 2, 0, 0);
    const medax_sites *sites = sites_of(3, &sphere, 1);
    const medax_decision found = decided(sites, 1, 2.1, 3, 0.5, 64);
    CHECK(found.test == MEDAX_DECIDE_TEST_OPPOSITE && fabs(found.radius - 2) < 1e-5);
    CHECK(fabs(found.center[0] - 1) < 1e-5 && fabs(found.center[1] - 2) < 1e-5 && fabs(found.center[2] - 3) < 1e-5);
    medax_sites_free(sites);
}

/* With two samples of the same side of the axis, the first test is blind; the others are not. */
static void later_tests(void) {
    uint64_t state = 21;
    size_t fired[4] = {0, 0, 0, 0};
    for (int i = 0; i < 2000; ++i) {
        medax_piece pieces[4];
        for (uint32_t k = 0; k < 4; ++k) {
            const double x = 2 * check_random(&state) - 1, y = 2 * check_random(&state) - 1;
            pieces[k] = piece(k % 2 ? MEDAX_PIECE_KIND_SEGMENT : MEDAX_PIECE_KIND_POINT, k, x, y, 0,
                              x + check_random(&state) - 0.5, y + check_random(&state) - 0.5, 0);
        }
        const medax_sites *sites = sites_of(2, pieces, 4);
        const double center[3] = {2 * check_random(&state) - 1, 2 * check_random(&state) - 1, 0};
        medax_nearest free_of;
        CHECK_STATUS(OK, medax_sites_nearest(sites, center, 1, NULL, &free_of));
        const medax_decision found = decided(sites, center[0], center[1], 0,
                                             (0.2 + 0.8 * check_random(&state)) * free_of.distance, 4);
        NEED(found.test < 4);
        ++fired[found.test];
        if (found.test != MEDAX_DECIDE_TEST_NONE) {
            medax_nearest nearest;
            CHECK_STATUS(OK, medax_sites_nearest(sites, found.center, 1, NULL, &nearest));
            CHECK(fabs(nearest.distance - found.radius) < 1e-5);
        }
        medax_sites_free(sites);
    }
    for (size_t test = 0; test < 4; ++test) CHECK(fired[test] > 0);
}

static void bounds(void) {
    CHECK(fabs(medax_largest_missed_angle(0.2, 0.5, 1) - asin(0.2) - asin(0.2)) < 1e-15);
    CHECK(fabs(medax_largest_missed_angle(0.2, 0.5, 0.4) - asin(0.2) - pi / 6) < 1e-15);
    CHECK(medax_largest_missed_angle(0, 0.5, 1) == 0);
    /* No claim: too wide a gap, too near, no numbers. */
    CHECK(fabs(medax_largest_missed_angle(1, 0.5, 9) - pi) < 1e-15);
    CHECK(fabs(medax_largest_missed_angle(0.2, 0.5, 0.39) - pi) < 1e-15);
    CHECK(fabs(medax_largest_missed_angle(-0.1, 0.5, 1) - pi) < 1e-15);
    CHECK(fabs(medax_largest_missed_angle(strtod("nan", NULL), 0.5, 1) - pi) < 1e-15);
    CHECK(fabs(medax_largest_missed_angle(0.2, strtod("nan", NULL), 1) - pi) < 1e-15);
    CHECK(fabs(medax_largest_missed_angle(0.2, 0.5, strtod("nan", NULL)) - pi) < 1e-15);
}

/* A decision with two directions. */
static medax_status ask(const medax_sites *sites, const double *center, double radius,
                        const double *directions, const medax_decide_options *options,
                        const medax_job *job, double *theta, medax_decision *found) {
    return medax_sites_decide(sites, center, radius, directions, 2, options, job, 4, theta, found);
}

static void refusals(void) {
    const double nan = strtod("nan", NULL);
    const double center[3] = {5, 1, 0}, off_plane[3] = {5, 1, 0.5}, no_number[3] = {5, nan, 0};
    double directions[6] = {1, 0, 0, 0, 2, 0}, theta[12];
    const double radii[4] = {0, -1, nan, HUGE_VAL};
    medax_decide_options options;
    medax_decision found;
    const medax_sites *sites = rectangle(10, 2);
    const medax_job *spent = spent_job(), *small = job_with(100, 0);
    memset(&found, 7, sizeof found);
    found.struct_size = sizeof found;
    theta[0] = 77;
    for (size_t i = 0; i < 4; ++i)
        CHECK_STATUS(INVALID_ARGUMENT,
                     ask(sites, center, radii[i], directions, NULL, NULL, theta, &found));
    CHECK_STATUS(INVALID_ARGUMENT, ask(sites, center, 1.5, directions, NULL, NULL, theta, &found));
    CHECK_STATUS(INVALID_ARGUMENT, ask(sites, off_plane, 0.2, directions, NULL, NULL, theta, &found));
    CHECK_STATUS(NON_FINITE, ask(sites, no_number, 0.2, directions, NULL, NULL, theta, &found));
    CHECK_STATUS(NULL_ARGUMENT, ask(NULL, center, 0.5, directions, NULL, NULL, theta, &found));
    CHECK_STATUS(NULL_ARGUMENT, ask(sites, NULL, 0.5, directions, NULL, NULL, theta, &found));
    CHECK_STATUS(NULL_ARGUMENT, ask(sites, center, 0.5, NULL, NULL, NULL, theta, &found));
    CHECK_STATUS(NULL_ARGUMENT, ask(sites, center, 0.5, directions, NULL, NULL, NULL, &found));
    CHECK_STATUS(NULL_ARGUMENT, ask(sites, center, 0.5, directions, NULL, NULL, theta, NULL));
    CHECK_STATUS(CANCELLED, ask(sites, center, 0.5, directions, NULL, spent, theta, &found));
    CHECK_STATUS(OUT_OF_MEMORY, ask(sites, center, 0.5, directions, NULL, small, theta, &found));
    for (size_t i = 0; i < 3; ++i) {
        directions[3] = i == 1 ? nan : 0;
        directions[4] = i == 0 ? 0 : 2;
        directions[5] = i == 2 ? 1 : 0;
        CHECK_STATUS(INVALID_ARGUMENT, ask(sites, center, 0.5, directions, NULL, NULL, theta, &found));
        CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 1);
    }
    directions[5] = 0;
    for (size_t i = 0; i < 5; ++i) {
        CHECK_STATUS(OK, medax_decide_options_init(&options, sizeof options));
        if (i == 0) options.tolerance = -1;
        if (i == 1) options.tolerance = nan;
        if (i == 2) options.epsilon = -1;
        if (i == 3) options.epsilon = HUGE_VAL;
        if (i == 4) options.struct_size = 8;
        CHECK_STATUS(INVALID_ARGUMENT,
                     ask(sites, center, 0.5, directions, &options, NULL, theta, &found));
    }
    CHECK_STATUS(NULL_ARGUMENT, medax_decide_options_init(NULL, sizeof options));
    const size_t many = 65537;
    double *too_many = calloc(3 * many, sizeof *too_many);
    NEED(too_many != NULL);
    CHECK_STATUS(LIMIT_EXCEEDED,
                 medax_sites_decide(sites, center, 0.5, too_many, many, NULL, NULL, 4, theta, &found));
    free(too_many);
    CHECK(theta[0] == 77 && found.reserved == 0x07070707);
    found.struct_size = 16;
    CHECK_STATUS(INVALID_ARGUMENT, ask(sites, center, 0.5, directions, NULL, NULL, theta, &found));
    medax_job_free(spent);
    medax_job_free(small);
    medax_sites_free(sites);
}

/* Less room than Theta takes, options, and no direction at all. */
static void rooms(void) {
    const double center[3] = {5, 0.5, 0};
    double directions[24], theta[6] = {77, 77, 77, 77, 77, 77};
    medax_decide_options options;
    medax_decision found;
    const medax_sites *sites = rectangle(10, 2);
    found.struct_size = sizeof found;
    CHECK_STATUS(OK, medax_sites_even_directions(sites, 8, directions));
    CHECK_STATUS(OK,
                 medax_sites_decide(sites, center, 0.3, directions, 8, NULL, NULL, 1, theta, &found));
    CHECK(found.theta_count == 8 && theta[0] != 77 && theta[3] == 77);
    CHECK_STATUS(OK, medax_sites_decide(sites, center, 0.3, directions, 8, NULL, NULL, 0, NULL, &found));
    CHECK(found.theta_count == 8);
    CHECK_STATUS(OK, medax_sites_decide(sites, center, 0.3, NULL, 0, NULL, NULL, 0, NULL, &found));
    CHECK(found.theta_count == 0 && found.test == MEDAX_DECIDE_TEST_NONE);
    /* The smaller epsilon, the nearer to the middle of the strip. */
    const double across[3] = {5, 1.1, 0};
    for (int i = 0; i < 2; ++i) {
        medax_decide_options_init(&options, sizeof options);
        CHECK(options.tolerance == 0 && options.epsilon == 0);
        options.epsilon = i == 0 ? 1e-3 : 1e-12;
        CHECK_STATUS(OK,
                     medax_sites_decide(sites, across, 0.5, directions, 8, &options, NULL, 0, NULL, &found));
        CHECK(fabs(found.center[1] - 1) <= options.epsilon);
    }
    /* All nearest points of the strip's sides are within this tolerance: nothing differs. */
    options.tolerance = 20;
    CHECK_STATUS(OK,
                 medax_sites_decide(sites, across, 0.5, directions, 8, &options, NULL, 0, NULL, &found));
    CHECK(found.test != MEDAX_DECIDE_TEST_OPPOSITE);
    medax_sites_free(sites);
}

int main(void) {
    even_directions();
    strip();
    points();
    later_tests();
    bounds();
    refusals();
    rooms();
    return check_end();
}
