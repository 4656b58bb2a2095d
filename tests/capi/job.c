/* Jobs: sized options, progress, cancel, busy, times. */
#include "check.h"
#include <pthread.h>
#include <time.h>

/* sizeof(medax_job_options) in version 0.1. */
enum { FIRST_SIZE = 40 };

static void options(void) {
    union {
        medax_job_options options;
        unsigned char bytes[128];
    } memory;
    const medax_job *job = NULL;
    static const char nothing = 0;
    const medax_job *const untouched = (const medax_job *)(const void *)&nothing;
    CHECK_STATUS(NULL_ARGUMENT, medax_job_options_init(NULL, sizeof memory.options));
    CHECK_STATUS(INVALID_ARGUMENT, medax_job_options_init(&memory.options, 0));
    CHECK_STATUS(INVALID_ARGUMENT, medax_job_options_init(&memory.options, FIRST_SIZE - 8));
    CHECK_STATUS(INVALID_ARGUMENT, medax_job_options_init(&memory.options, FIRST_SIZE + 1));
    CHECK_STATUS(INVALID_ARGUMENT, medax_job_options_init(&memory.options, SIZE_MAX));

    /* Every size from the first version's up: the caller's size, and not a byte beyond it. */
    for (size_t size = FIRST_SIZE; size <= 120; size += 8) {
        memset(memory.bytes, 0xa5, sizeof memory.bytes);
        CHECK_STATUS(OK, medax_job_options_init(&memory.options, size));
        CHECK(memory.options.struct_size == size);
        CHECK(memory.options.threads == 0 && memory.options.memory_ceiling == 0);
        CHECK(memory.options.progress == NULL && memory.options.payload == NULL);
        CHECK(memory.bytes[size - 1] == 0 && memory.bytes[size] == 0xa5);
        if (CHECK_STATUS(OK, medax_job_create(&memory.options, &job))) medax_job_free(job);
    }

    /* A newer caller may set what this library does not know only to 0. */
    memset(memory.bytes, 0, sizeof memory.bytes);
    memory.options.struct_size = sizeof(medax_job_options) + 16;
    memory.bytes[sizeof(medax_job_options) + 15] = 1;
    job = untouched;
    CHECK_STATUS(INVALID_ARGUMENT, medax_job_create(&memory.options, &job));
    CHECK(job == untouched);

    /* Zeroed, garbage and reserved. */
    memset(memory.bytes, 0, sizeof memory.bytes);
    CHECK_STATUS(INVALID_ARGUMENT, medax_job_create(&memory.options, &job));
    memset(memory.bytes, 0xff, sizeof memory.bytes);
    CHECK_STATUS(INVALID_ARGUMENT, medax_job_create(&memory.options, &job));
    medax_job_options_init(&memory.options, sizeof memory.options);
    memory.options.reserved = 1;
    CHECK_STATUS(INVALID_ARGUMENT, medax_job_create(&memory.options, &job));
    CHECK_STATUS(NULL_ARGUMENT, medax_job_create(NULL, NULL));
    CHECK(job == untouched);
}

static void null_is_nothing(void) {
    const char *stage = "untouched";
    double wall = -1, cpu = -1;
    medax_job_cancel(NULL);
    CHECK(!medax_job_is_cancelled(NULL));
    CHECK(medax_job_progress(NULL) == 0);
    CHECK(strcmp(medax_job_stage(NULL), "idle") == 0);
    CHECK(medax_job_memory_peak(NULL) == 0);
    CHECK(medax_job_stage_count(NULL) == 0);
    CHECK_STATUS(NULL_ARGUMENT, medax_job_stage_time(NULL, 0, &stage, &wall, &cpu));
    CHECK(strcmp(stage, "untouched") == 0 && wall == -1 && cpu == -1);
    CHECK(medax_job_clone(NULL) == NULL);
    medax_job_free(NULL);
}

static void stages(void) {
    const medax_job *job = NULL;
    const medax_points *points = NULL;
    const char *stage = NULL;
    double wall = -1, cpu = -1;
    double *xyz = check_cloud(1000);
    NEED(xyz != NULL && medax_job_create(NULL, &job) == MEDAX_STATUS_OK);
    CHECK(strcmp(medax_job_stage(job), "idle") == 0);
    CHECK(medax_job_stage_count(job) == 0);
    CHECK_STATUS(INVALID_ARGUMENT, medax_job_stage_time(job, 0, &stage, &wall, &cpu));
    CHECK(stage == NULL && wall == -1 && cpu == -1);
    CHECK_STATUS(OK, medax_points_create_f64(xyz, 1000, 0, NULL, job, &points));
    CHECK(strcmp(medax_job_stage(job), "order") == 0);
    CHECK(medax_job_progress(job) == 1);
    CHECK(medax_job_memory_peak(job) >= 1000 * 3 * sizeof(double));
    CHECK(medax_job_stage_count(job) == 1);
    CHECK_STATUS(OK, medax_job_stage_time(job, 0, &stage, &wall, &cpu));
    CHECK(strcmp(stage, "order") == 0 && wall >= 0 && cpu >= 0);
    CHECK_STATUS(OK, medax_job_stage_time(job, 0, NULL, NULL, NULL));
    CHECK_STATUS(INVALID_ARGUMENT, medax_job_stage_time(job, 1, &stage, &wall, &cpu));
    CHECK_STATUS(INVALID_ARGUMENT, medax_job_stage_time(job, SIZE_MAX, NULL, NULL, NULL));
    medax_points_free(points);
    medax_job_free(job);
    free(xyz);
}

static void ceiling(void) {
    medax_job_options options;
    const medax_job *job = NULL;
    const medax_points *points = NULL;
    double *xyz = check_cloud(1000);
    medax_job_options_init(&options, sizeof options);
    options.memory_ceiling = 1000;
    NEED(xyz != NULL && medax_job_create(&options, &job) == MEDAX_STATUS_OK);
    CHECK_STATUS(OUT_OF_MEMORY, medax_points_create_f64(xyz, 1000, 0, NULL, job, &points));
    CHECK(points == NULL);
    /* A job that failed, unlike a cancelled one, can run again. */
    CHECK_STATUS(OK, medax_points_create_f64(xyz, 4, 0, NULL, job, &points));
    medax_points_free(points);
    medax_job_free(job);
    free(xyz);
}

struct host {
    const medax_job *job;
    pthread_t thread;
    const medax_points *points;
    int calls, faults, cancel;
    double progress;
};

/* Watches a build from inside, and cancels it if asked to. */
static int32_t watch(double progress, const char *stage, void *payload) {
    struct host *host = payload;
    const medax_points *points = NULL;
    const double xyz[3] = {0, 0, 0};
    ++host->calls;
    if (!pthread_equal(host->thread, pthread_self())) ++host->faults;
    if (progress < host->progress || progress > 1) ++host->faults;
    if (strcmp(stage, "triangulate") != 0) ++host->faults;
    host->progress = progress;
    /* One build at a time, but any accessor at any time. */
    if (medax_points_create_f64(xyz, 1, 0, NULL, host->job, &points) != MEDAX_STATUS_BUSY)
        ++host->faults;
    if (medax_points_count(host->points) == 0) ++host->faults;
    return host->cancel;
}

/* Triangulates larger and larger sets until the callback was called. */
static medax_status watched(struct host *host, const medax_triangulation **triangulation) {
    medax_status status = MEDAX_STATUS_OK;
    for (size_t count = 10000; host->calls == 0 && count < 10000000; count *= 2) {
        medax_job_options options;
        medax_triangulation_free(*triangulation);
        medax_points_free(host->points);
        medax_job_free(host->job);
        *triangulation = NULL;
        host->thread = pthread_self();
        host->points = check_points(count);
        medax_job_options_init(&options, sizeof options);
        options.progress = watch;
        options.payload = host;
        NEED(host->points != NULL && medax_job_create(&options, &host->job) == MEDAX_STATUS_OK);
        host->progress = 0;
        status = medax_delaunay_build(host->points, NULL, host->job, triangulation);
    }
    return status;
}

static void callback(void) {
    for (int32_t cancel = 0; cancel <= 1; ++cancel) {
        struct host host = {0};
        const medax_triangulation *triangulation = NULL;
        host.cancel = cancel ? -7 : 0;
        if (cancel) {
            CHECK_STATUS(CANCELLED, watched(&host, &triangulation));
            CHECK(host.calls == 1 && triangulation == NULL);
            CHECK(medax_job_is_cancelled(host.job));
            /* The job is spent. */
            CHECK_STATUS(CANCELLED,
                         medax_delaunay_build(host.points, NULL, host.job, &triangulation));
            CHECK(triangulation == NULL);
        } else {
            CHECK_STATUS(OK, watched(&host, &triangulation));
            CHECK(host.calls >= 1 && triangulation != NULL);
            CHECK(!medax_job_is_cancelled(host.job) && medax_job_progress(host.job) == 1);
        }
        CHECK(host.faults == 0);
        medax_triangulation_free(triangulation);
        medax_points_free(host.points);
        medax_job_free(host.job);
    }
}

/* Cancels from another thread as soon as a stage is reached. */
struct canceller {
    const medax_job *job;
    const char *stage;
};

static void *cancel_at_stage(void *argument) {
    const struct canceller *canceller = argument;
    const struct timespec pause = {0, 100000};
    while (!medax_job_is_cancelled(canceller->job)
           && strcmp(medax_job_stage(canceller->job), canceller->stage) != 0)
        nanosleep(&pause, NULL);
    medax_job_cancel(canceller->job);
    medax_job_cancel(canceller->job);
    medax_job_free(canceller->job);
    return NULL;
}

static void cancel_from_elsewhere(const char *stage) {
    medax_status status = MEDAX_STATUS_OK;
    for (size_t count = 20000; status == MEDAX_STATUS_OK && count < 10000000; count *= 2) {
        const medax_job *job = NULL;
        const medax_points *points = NULL;
        const medax_triangulation *triangulation = NULL;
        struct canceller canceller;
        pthread_t thread;
        double *xyz = check_cloud(count);
        NEED(xyz != NULL && medax_job_create(NULL, &job) == MEDAX_STATUS_OK);
        canceller.job = medax_job_clone(job);
        canceller.stage = stage;
        CHECK(canceller.job == job);
        NEED(pthread_create(&thread, NULL, cancel_at_stage, &canceller) == 0);
        status = medax_points_create_f64(xyz, count, 0, NULL, job, &points);
        if (status == MEDAX_STATUS_OK)
            status = medax_delaunay_build(points, NULL, job, &triangulation);
        /* Whoever came too late is told by the next build. */
        medax_job_cancel(job);
        pthread_join(thread, NULL);
        if (status != MEDAX_STATUS_OK) CHECK(triangulation == NULL);
        medax_triangulation_free(triangulation);
        medax_points_free(points);
        medax_job_free(job);
        free(xyz);
    }
    CHECK_STATUS(CANCELLED, status);
}

int main(void) {
    options();
    null_is_nothing();
    stages();
    ceiling();
    callback();
    cancel_from_elsewhere("order");
    cancel_from_elsewhere("triangulate");
    return check_end();
}
