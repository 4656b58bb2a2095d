/* What the tests of distances share: boundaries, pieces, spent jobs, attributes. */
#ifndef BOUNDARY_H
#define BOUNDARY_H

#include "check.h"

static inline medax_piece piece(uint32_t kind, uint32_t site, double a, double b, double c, double d,
                                double e, double f) {
    medax_piece made;
    memset(&made, 0, sizeof made);
    made.kind = kind;
    made.site = site;
    made.numbers[0] = a;
    made.numbers[1] = b;
    made.numbers[2] = c;
    made.numbers[3] = d;
    made.numbers[4] = e;
    made.numbers[5] = f;
    return made;
}

static inline const medax_sites *sites_of(uint32_t dimension, const medax_piece *pieces,
                                          size_t count) {
    const medax_sites *sites = NULL;
    CHECK_STATUS(OK, medax_sites_create(dimension, pieces, count, NULL, 0, NULL, &sites));
    NEED(sites != NULL);
    return sites;
}

/* Two points on the x axis, at -1 and 1: sites 0 and 1. */
static inline const medax_sites *two_points(uint32_t dimension) {
    const medax_piece pieces[2] = {piece(MEDAX_PIECE_KIND_POINT, 0, -1, 0, 0, 0, 0, 0),
                                   piece(MEDAX_PIECE_KIND_POINT, 1, 1, 0, 0, 0, 0, 0)};
    return sites_of(dimension, pieces, 2);
}

/* The sides of a rectangle with a corner at 0: pieces 0 to 3, from the lower one counterclockwise. */
static inline const medax_sites *rectangle(double width, double height) {
    const double vertices[8] = {0, 0, width, 0, width, height, 0, height};
    const uint32_t ring_offsets[2] = {0, 4}, polygon_offsets[2] = {0, 1};
    medax_figure_parts parts;
    const medax_figure *figure = NULL;
    const medax_sites *sites = NULL;
    medax_figure_parts_init(&parts, sizeof parts);
    parts.ring_vertices = vertices;
    parts.ring_vertex_count = 4;
    parts.ring_offsets = ring_offsets;
    parts.ring_count = 1;
    parts.polygon_offsets = polygon_offsets;
    parts.polygon_count = 1;
    CHECK_STATUS(OK, medax_figure_create(&parts, NULL, &figure));
    CHECK_STATUS(OK, medax_sites_of_figure(figure, NULL, &sites));
    medax_figure_free(figure);
    NEED(sites != NULL);
    return sites;
}

static inline double least(double a, double b) {
    return a < b ? a : b;
}

/* The distance of a point of the plane from a segment. */
static inline double to_segment(const double *p, double ax, double ay, double bx, double by) {
    const double ux = bx - ax, uy = by - ay;
    double t = ((p[0] - ax) * ux + (p[1] - ay) * uy) / (ux * ux + uy * uy);
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return hypot(p[0] - ax - t * ux, p[1] - ay - t * uy);
}

/* The distance of a point from the medial axis of a rectangle that is wider than high. */
static inline double to_axis(const double *p, double width, double height) {
    const double half = height / 2, end = width - half;
    double d = to_segment(p, half, half, end, half);
    d = least(d, to_segment(p, 0, 0, half, half));
    d = least(d, to_segment(p, 0, height, half, half));
    d = least(d, to_segment(p, width, 0, end, half));
    return least(d, to_segment(p, width, height, end, half));
}

static inline const medax_job *spent_job(void) {
    const medax_job *job = NULL;
    CHECK_STATUS(OK, medax_job_create(NULL, &job));
    medax_job_cancel(job);
    return job;
}

/* A job that may take so many bytes, and use so many threads; 0 for what it likes. */
static inline const medax_job *job_with(uint64_t bytes, uint32_t threads) {
    medax_job_options options;
    const medax_job *job = NULL;
    medax_job_options_init(&options, sizeof options);
    options.memory_ceiling = bytes;
    options.threads = threads;
    CHECK_STATUS(OK, medax_job_create(&options, &job));
    return job;
}

static inline int32_t stop_in(double progress, const char *stage, void *payload) {
    (void)progress;
    return strcmp(stage, payload) == 0;
}

/* A job that stops as soon as it is found in the stage. */
static inline const medax_job *stopping_job(char *stage) {
    medax_job_options options;
    const medax_job *job = NULL;
    medax_job_options_init(&options, sizeof options);
    options.progress = stop_in;
    options.payload = stage;
    CHECK_STATUS(OK, medax_job_create(&options, &job));
    return job;
}

/* Whether an attribute of the vertices has the values of a view. */
static inline int same_f64(const medax_complex *complex, const char *name, medax_view_f64 view) {
    medax_attribute found;
    memset(&found, 0, sizeof found);
    CHECK_STATUS(OK, medax_complex_attribute(complex, MEDAX_ELEMENT_VERTEX, name, &found));
    const medax_view_f64 values = found.f64_values;
    return values.rows == view.rows && values.cols == view.cols && view.rows > 0
           && memcmp(values.data, view.data, view.rows * view.cols * sizeof *view.data) == 0;
}

static inline int same_u32(const medax_complex *complex, const char *name, medax_view_u32 view) {
    medax_attribute found;
    memset(&found, 0, sizeof found);
    CHECK_STATUS(OK, medax_complex_attribute(complex, MEDAX_ELEMENT_VERTEX, name, &found));
    const medax_view_u32 values = found.u32_values;
    return values.rows == view.rows && values.cols == view.cols && view.rows > 0
           && memcmp(values.data, view.data, view.rows * view.cols * sizeof *view.data) == 0;
}

#endif
