/* A test frame for C: CHECK counts, check_end tells. */
#ifndef CHECK_H
#define CHECK_H

#include <math.h>
#include <medax.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static unsigned check_passed, check_failed;

static inline int check_that(int holds, const char *what, const char *file, int line) {
    if (holds) {
        ++check_passed;
    } else {
        ++check_failed;
        printf("%s:%d: failed: %s (last error: %s)\n", file, line, what,
               medax_last_error_message());
    }
    return holds;
}

static inline int check_status(medax_status expected, medax_status found, const char *what,
                               const char *file, int line) {
    if (expected != found)
        printf("%s instead of %s\n", medax_status_name((int32_t)found),
               medax_status_name((int32_t)expected));
    return check_that(expected == found, what, file, line);
}

/* Prints the closing line and gives main's result. */
static inline int check_end(void) {
    printf("%u passed, %u failed\n", check_passed, check_failed);
    return check_failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

#define CHECK(condition) check_that((condition) ? 1 : 0, #condition, __FILE__, __LINE__)
/* Whether a call returns MEDAX_STATUS_<status>. */
#define CHECK_STATUS(status, call) \
    check_status(MEDAX_STATUS_##status, call, #status " == " #call, __FILE__, __LINE__)
/* Stops a test that cannot go on. */
#define NEED(condition)               \
    do {                              \
        if (!CHECK(condition)) {      \
            check_end();              \
            exit(EXIT_FAILURE);       \
        }                             \
    } while (0)

/* A number in [0, 1) from a linear congruential generator (Knuth's MMIX). */
static inline double check_random(uint64_t *state) {
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) / 9007199254740992.0;
}

/* A random point of the unit sphere. */
static inline void check_direction(uint64_t *state, double u[3]) {
    double square;
    do {
        square = 0;
        for (size_t k = 0; k < 3; ++k) {
            u[k] = 2 * check_random(state) - 1;
            square += u[k] * u[k];
        }
    } while (square > 1 || square < 0.01);
    for (size_t k = 0; k < 3; ++k) u[k] /= sqrt(square);
}

/* `count` random points in the unit cube, for the caller to free. */
static inline double *check_cloud(size_t count) {
    uint64_t state = 1;
    double *xyz = malloc(count * 3 * sizeof *xyz);
    for (size_t i = 0; xyz != NULL && i < 3 * count; ++i) xyz[i] = check_random(&state);
    return xyz;
}

/* Random points in the unit cube, as points. */
static inline const medax_points *check_points(size_t count) {
    const medax_points *points = NULL;
    double *xyz = check_cloud(count);
    if (xyz != NULL) medax_points_create_f64(xyz, count, 0, NULL, NULL, &points);
    free(xyz);
    return points;
}

#endif
