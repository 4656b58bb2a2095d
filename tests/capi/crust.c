/* Power crusts: options, parts, cancel at every stage. */
#include "check.h"

static const char nothing = 0;
#define UNTOUCHED ((const medax_power_crust *)(const void *)&nothing)

/* Samples of the faces of the unit cube, for the caller to free. */
static const medax_points *cube(void) {
    enum { COUNT = 600 };
    uint64_t state = 5;
    double xyz[3 * COUNT];
    const medax_points *points = NULL;
    for (size_t i = 0; i < COUNT; ++i) {
        for (size_t k = 0; k < 3; ++k) xyz[3 * i + k] = check_random(&state);
        xyz[3 * i + i % 3] = i / 3 % 2 == 0 ? 0 : 1;
    }
    CHECK_STATUS(OK, medax_points_create_f64(xyz, COUNT, 0, NULL, NULL, &points));
    NEED(points != NULL);
    return points;
}

static void refusals(void) {
    const double flat[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    const double nan = strtod("nan", NULL), bad[] = {nan, -0.1, 1.1, 1e300};
    const medax_points *plane = NULL, *points = cube();
    const medax_poles *poles = NULL;
    const medax_power_crust *crust = UNTOUCHED;
    medax_power_crust_options options;
    CHECK_STATUS(OK, medax_points_create_f64(flat, 4, 0, NULL, NULL, &plane));
    CHECK_STATUS(OK, medax_poles_build_with_far_box(points, NULL, NULL, &poles));
    CHECK_STATUS(DEGENERATE, medax_power_crust_build(plane, NULL, NULL, &crust));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_build(NULL, NULL, NULL, &crust));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_build(points, NULL, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_build_from_poles(NULL, NULL, NULL, &crust));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_build_from_poles(poles, NULL, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_options_init(NULL, sizeof options));
    CHECK_STATUS(INVALID_ARGUMENT, medax_power_crust_options_init(&options, 8));
    CHECK_STATUS(OK, medax_power_crust_options_init(&options, sizeof options));
    CHECK(options.deep == 0.4 && options.round_poles == 0);
    CHECK(options.label_rule == MEDAX_LABEL_RULE_AUTO);
    CHECK(options.lambda == 0 && options.keep_shards == 0 && options.omit == MEDAX_OMIT_NOTHING);
    options.round_poles = 2;
    CHECK_STATUS(INVALID_ARGUMENT, medax_power_crust_build(points, &options, NULL, &crust));
    options.round_poles = 0;
    options.keep_shards = 2;
    CHECK_STATUS(INVALID_ARGUMENT, medax_power_crust_build(points, &options, NULL, &crust));
    options.keep_shards = 0;
    options.omit = 3;
    CHECK_STATUS(INVALID_ARGUMENT, medax_power_crust_build(points, &options, NULL, &crust));
    options.omit = MEDAX_OMIT_SIDE;
    options.lambda = nan;
    CHECK_STATUS(INVALID_ARGUMENT, medax_power_crust_build(points, &options, NULL, &crust));
    options.omit = MEDAX_OMIT_NOTHING;
    options.lambda = 0;
    options.label_rule = 3;
    CHECK_STATUS(INVALID_ARGUMENT, medax_power_crust_build(points, &options, NULL, &crust));
    options.label_rule = MEDAX_LABEL_RULE_AUTO;
    options.has_viewpoint = 2;
    CHECK_STATUS(INVALID_ARGUMENT, medax_power_crust_build(points, &options, NULL, &crust));
    options.has_viewpoint = 1;
    options.viewpoint[1] = nan;
    CHECK_STATUS(INVALID_ARGUMENT, medax_power_crust_build(points, &options, NULL, &crust));
    options.has_viewpoint = 0;
    options.reserved = 1;
    CHECK_STATUS(INVALID_ARGUMENT, medax_power_crust_build(points, &options, NULL, &crust));
    options.reserved = 0;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        options.deep = bad[i];
        CHECK_STATUS(INVALID_ARGUMENT, medax_power_crust_build(points, &options, NULL, &crust));
        CHECK_STATUS(INVALID_ARGUMENT,
                     medax_power_crust_build_from_poles(poles, &options, NULL, &crust));
    }
    memset(&options, 0, sizeof options);
    CHECK_STATUS(INVALID_ARGUMENT, medax_power_crust_build(points, &options, NULL, &crust));
    CHECK(crust == UNTOUCHED);
    medax_poles_free(poles);
    medax_points_free(points);
    medax_points_free(plane);
}

static void null_is_nothing(void) {
    const medax_complex *complex = NULL;
    const medax_poles *poles = NULL;
    const medax_triangulation *regular = NULL;
    medax_validation report;
    report.struct_size = sizeof report;
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_surface(NULL, &complex));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_shape(NULL, MEDAX_LABEL_INNER, &complex));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_poles(NULL, &poles));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_regular(NULL, &regular));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_validate(NULL, NULL, &report));
    CHECK(medax_power_crust_labels(NULL).rows == 0 && !medax_power_crust_is_visible(NULL, 0));
    CHECK(medax_power_crust_unreached_count(NULL) == 0);
    CHECK(medax_power_crust_forced_count(NULL) == 0);
    CHECK(medax_power_crust_conflict(NULL) == 0 && !medax_power_crust_is_settled(NULL));
    CHECK(medax_power_crust_clone(NULL) == NULL);
    CHECK(complex == NULL && poles == NULL && regular == NULL);
    medax_power_crust_free(NULL);
}

/* Every directed side of a face has its reverse, once each. */
static int is_closed(medax_view_rows faces) {
    for (size_t f = 0; f < faces.rows; ++f) {
        const uint32_t begin = faces.offsets[f], end = faces.offsets[f + 1];
        for (uint32_t i = begin; i < end; ++i) {
            const uint32_t from = faces.indices[i];
            const uint32_t to = faces.indices[i + 1 < end ? i + 1 : begin];
            size_t same = 0, reverse = 0;
            for (size_t g = 0; g < faces.rows; ++g) {
                const uint32_t first = faces.offsets[g], last = faces.offsets[g + 1];
                for (uint32_t j = first; j < last; ++j) {
                    const uint32_t a = faces.indices[j];
                    const uint32_t b = faces.indices[j + 1 < last ? j + 1 : first];
                    same += a == from && b == to;
                    reverse += a == to && b == from;
                }
            }
            if (same != 1 || reverse != 1) return 0;
        }
    }
    return faces.rows > 0;
}

/* The samples' box is the unit cube, so that a rounded centre is a multiple of 2^-36. */
static void rounded(void) {
    const double step = 1.0 / 68719476736.0;
    const medax_points *points = cube();
    const medax_power_crust *crust = NULL;
    const medax_poles *poles = NULL;
    const medax_triangulation *regular = NULL;
    const medax_complex *surface = NULL;
    medax_power_crust_options options;
    medax_validation report;
    size_t moved = 0;
    CHECK_STATUS(OK, medax_power_crust_options_init(&options, sizeof options));
    options.round_poles = 1;
    CHECK_STATUS(OK, medax_power_crust_build(points, &options, NULL, &crust));
    NEED(crust != NULL);
    CHECK_STATUS(OK, medax_power_crust_poles(crust, &poles));
    CHECK_STATUS(OK, medax_power_crust_regular(crust, &regular));
    CHECK_STATUS(OK, medax_power_crust_surface(crust, &surface));
    CHECK(is_closed(medax_complex_faces(surface)));
    const medax_view_f64 balls = medax_poles_balls(poles), centers = medax_triangulation_coords(regular);
    const medax_view_u32 pole = medax_triangulation_row_of_vertex(regular);
    NEED(centers.rows == pole.rows && centers.cols == 3 && balls.cols == 4);
    for (size_t v = 0; v < centers.rows; ++v) {
        for (size_t k = 0; k < 3; ++k) {
            const double to = centers.data[3 * v + k], from = balls.data[4 * (size_t)pole.data[v] + k];
            CHECK(to / step == (double)(int64_t)(to / step));
            CHECK(to - from <= step / 2 && from - to <= step / 2);
            moved += to != from;
        }
    }
    CHECK(moved > centers.rows);
    report.struct_size = sizeof report;
    CHECK_STATUS(OK, medax_power_crust_validate(crust, NULL, &report));
    CHECK(report.problems == 0 && report.checked > 0);
    medax_triangulation_free(regular);
    medax_complex_free(surface);
    medax_poles_free(poles);
    medax_power_crust_free(crust);
    medax_points_free(points);
}

static void parts(void) {
    const medax_points *points = cube();
    const medax_power_crust *crust = NULL, *again = NULL;
    const medax_complex *surface = NULL, *inner = NULL, *outer = NULL, *other = NULL;
    const medax_poles *poles = NULL;
    const medax_triangulation *regular = NULL;
    medax_attribute attribute;
    medax_validation report;
    size_t visible = 0;
    CHECK_STATUS(OK, medax_power_crust_build(points, NULL, NULL, &crust));
    NEED(crust != NULL);
    CHECK_STATUS(OK, medax_power_crust_surface(crust, &surface));
    CHECK_STATUS(OK, medax_power_crust_shape(crust, MEDAX_LABEL_INNER, &inner));
    CHECK_STATUS(OK, medax_power_crust_shape(crust, MEDAX_LABEL_OUTER, &outer));
    CHECK_STATUS(OK, medax_power_crust_poles(crust, &poles));
    CHECK_STATUS(OK, medax_power_crust_regular(crust, &regular));
    CHECK(is_closed(medax_complex_faces(surface)));

    const medax_view_u32 labels = medax_power_crust_labels(crust);
    NEED(labels.rows == medax_poles_balls(poles).rows && labels.cols == 1);
    for (uint32_t p = 0; p < labels.rows; ++p) {
        CHECK(labels.data[p] <= MEDAX_LABEL_INNER);
        visible += medax_power_crust_is_visible(crust, p);
    }
    CHECK(!medax_power_crust_is_visible(crust, (uint32_t)labels.rows));
    CHECK(!medax_power_crust_is_visible(crust, MEDAX_NONE));
    CHECK(visible == medax_complex_vertices(inner).rows + medax_complex_vertices(outer).rows);
    CHECK(medax_power_crust_unreached_count(crust) <= labels.rows);
    CHECK(medax_power_crust_forced_count(crust) <= labels.rows);
    CHECK(medax_power_crust_conflict(crust) >= 0);
    CHECK_STATUS(OK, medax_complex_attribute(surface, MEDAX_ELEMENT_FACE, "inner_pole", &attribute));
    CHECK(attribute.u32_values.rows == medax_complex_faces(surface).rows);
    CHECK(labels.data[attribute.u32_values.data[0]] == MEDAX_LABEL_INNER);
    CHECK_STATUS(OK, medax_complex_attribute(inner, MEDAX_ELEMENT_VERTEX, "radius", &attribute));
    CHECK(attribute.f64_values.rows == medax_complex_vertices(inner).rows);

    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_poles_complex(NULL, &other));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_poles_complex(crust, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_both_shapes(NULL, &other));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_both_shapes(crust, NULL));
    CHECK(other == NULL);
    CHECK_STATUS(OK, medax_power_crust_poles_complex(crust, &other));
    CHECK_STATUS(OK, medax_complex_attribute(other, MEDAX_ELEMENT_VERTEX, "label", &attribute));
    CHECK(attribute.u32_values.rows == labels.rows);
    CHECK(memcmp(attribute.u32_values.data, labels.data, labels.rows * sizeof(uint32_t)) == 0);
    medax_complex_free(other);
    CHECK_STATUS(OK, medax_power_crust_both_shapes(crust, &other));
    CHECK(medax_complex_vertices(other).rows == visible);
    medax_complex_free(other);

    /* From the poles the same comes out. */
    CHECK_STATUS(OK, medax_power_crust_build_from_poles(poles, NULL, NULL, &again));
    CHECK_STATUS(OK, medax_power_crust_surface(again, &other));
    NEED(medax_complex_vertices(other).rows == medax_complex_vertices(surface).rows);
    CHECK(memcmp(medax_complex_vertices(other).data, medax_complex_vertices(surface).data,
                 3 * sizeof(double) * medax_complex_vertices(surface).rows) == 0);

    report.struct_size = sizeof report;
    CHECK_STATUS(OK, medax_power_crust_validate(crust, NULL, &report));
    CHECK(report.problems == 0 && report.checked > 0);
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_validate(crust, NULL, NULL));
    report.struct_size = 8;
    CHECK_STATUS(INVALID_ARGUMENT, medax_power_crust_validate(crust, NULL, &report));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_surface(crust, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_shape(crust, 0, NULL));
    CHECK_STATUS(INVALID_ARGUMENT, medax_power_crust_shape(crust, 2, &other));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_poles(crust, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_regular(crust, NULL));
    medax_complex_free(other);
    medax_power_crust_free(again);
    medax_triangulation_free(regular);
    medax_poles_free(poles);
    medax_complex_free(outer);
    medax_complex_free(inner);
    medax_complex_free(surface);
    again = medax_power_crust_clone(crust);
    medax_power_crust_free(crust);
    CHECK(medax_power_crust_labels(again).data == labels.data && labels.data[0] <= 1);
    medax_power_crust_free(again);
    medax_points_free(points);
}

/* Cancels when the build enters, or is found in, the stage. */
struct stop {
    const char *stage;
    int seen;
};

static int32_t stop_at(double progress, const char *stage, void *payload) {
    struct stop *stop = payload;
    (void)progress;
    if (strcmp(stage, stop->stage) != 0) return 0;
    stop->seen = 1;
    return 1;
}

static void cancelled_at(const char *stage) {
    struct stop stop = {stage, 0};
    for (size_t count = 4000; !stop.seen && count < 2000000; count *= 2) {
        medax_job_options options;
        const medax_job *job = NULL;
        const medax_points *points = check_points(count);
        const medax_power_crust *crust = UNTOUCHED;
        medax_job_options_init(&options, sizeof options);
        options.progress = stop_at;
        options.payload = &stop;
        NEED(points != NULL && medax_job_create(&options, &job) == MEDAX_STATUS_OK);
        if (medax_power_crust_build(points, NULL, job, &crust) == MEDAX_STATUS_OK) {
            CHECK(!stop.seen);
            medax_power_crust_free(crust);
        } else {
            CHECK(stop.seen && crust == UNTOUCHED && medax_job_is_cancelled(job));
            CHECK(strcmp(medax_job_stage(job), stage) == 0);
        }
        medax_points_free(points);
        medax_job_free(job);
    }
    CHECK(stop.seen);
}

int main(void) {
    refusals();
    null_is_nothing();
    parts();
    rounded();
    cancelled_at("triangulate");
    cancelled_at("poles");
    cancelled_at("regular");
    return check_end();
}
