/* Version, statuses, the last error. */
#include "check.h"
#include <pthread.h>

static void version(void) {
    char text[32];
    CHECK(medax_version() == MEDAX_VERSION);
    CHECK(medax_version() >> 22 == MEDAX_VERSION_MAJOR);
    snprintf(text, sizeof text, "%d.%d.%d", MEDAX_VERSION_MAJOR, MEDAX_VERSION_MINOR,
             MEDAX_VERSION_PATCH);
    CHECK(strcmp(medax_version_string(), text) == 0);
}

static void names(void) {
    static const struct {
        int32_t number;
        const char *name;
    } known[] = {{0, "OK"},
                 {1, "NULL_ARGUMENT"},
                 {2, "INVALID_ARGUMENT"},
                 {3, "NON_FINITE"},
                 {4, "COORDINATE_RANGE"},
                 {5, "TOO_FEW_POINTS"},
                 {6, "DEGENERATE"},
                 {7, "MISMATCH"},
                 {20, "CANCELLED"},
                 {21, "OUT_OF_MEMORY"},
                 {22, "LIMIT_EXCEEDED"},
                 {23, "BUSY"},
                 {40, "IO"},
                 {41, "FORMAT"},
                 {42, "UNSUPPORTED"},
                 {99, "INTERNAL"}};
    const size_t prefix = strlen("MEDAX_STATUS_");
    size_t next = 0;
    for (int32_t number = -1; number <= 100; ++number) {
        const char *name = medax_status_name(number);
        const int listed = next < sizeof known / sizeof *known && known[next].number == number;
        CHECK(strncmp(name, "MEDAX_STATUS_", prefix) == 0);
        CHECK(strcmp(name + prefix, listed ? known[next].name : "UNKNOWN") == 0);
        if (listed) ++next;
    }
    CHECK(next == sizeof known / sizeof *known);
    CHECK(strcmp(medax_status_name(INT32_MIN), "MEDAX_STATUS_UNKNOWN") == 0);
}

static void *no_error_yet(void *unused) {
    (void)unused;
    CHECK(strcmp(medax_last_error_message(), "") == 0);
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_NONE);
    CHECK(medax_last_error_index() == UINT64_MAX);
    return NULL;
}

static void last_error(void) {
    const double nan = strtod("nan", NULL);
    const double xyz[6] = {0, 0, 0, 1, nan, 2};
    const medax_points *points = NULL;
    pthread_t thread;
    no_error_yet(NULL);
    CHECK_STATUS(NON_FINITE, medax_points_create_f64(xyz, 2, 0, NULL, NULL, &points));
    CHECK(strstr(medax_last_error_message(), "NaN") != NULL);
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW);
    CHECK(medax_last_error_index() == 1);

    /* Success does not clear it. */
    CHECK_STATUS(OK, medax_points_create_f64(xyz, 1, 0, NULL, NULL, &points));
    medax_points_free(points);
    CHECK(medax_last_error_index() == 1);

    /* It is this thread's alone. */
    if (CHECK(pthread_create(&thread, NULL, no_error_yet, NULL) == 0)) pthread_join(thread, NULL);
    CHECK(medax_last_error_index() == 1);

    /* The next failure replaces all of it. */
    CHECK_STATUS(NULL_ARGUMENT, medax_points_create_f64(xyz, 1, 0, NULL, NULL, NULL));
    CHECK(strstr(medax_last_error_message(), "out_points") != NULL);
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_NONE);
    CHECK(medax_last_error_index() == UINT64_MAX);
}

int main(void) {
    last_error();
    version();
    names();
    return check_end();
}
