/* Power crusts of other balls: offsets, simplified ones, holes; poles left out. */
#include "check.h"

#include <math.h>

static const char nothing = 0;
#define UNTOUCHED(type) ((const type *)(const void *)&nothing)

/* Samples of an ellipsoid with half axes 1, 0.7, 0.4, for the caller to free. */
static const medax_points *ellipsoid(void) {
    enum { COUNT = 1500 };
    uint64_t state = 9;
    static double xyz[3 * COUNT];
    const medax_points *points = NULL;
    for (size_t i = 0; i < COUNT; ++i) {
        check_direction(&state, xyz + 3 * i);
        xyz[3 * i + 1] *= 0.7;
        xyz[3 * i + 2] *= 0.4;
    }
    CHECK_STATUS(OK, medax_points_create_f64(xyz, COUNT, 0, NULL, NULL, &points));
    NEED(points != NULL);
    return points;
}

static void refusals(const medax_power_crust *crust) {
    const double nan = strtod("nan", NULL);
    const medax_power_crust *offset = UNTOUCHED(medax_power_crust);
    const medax_simplified *simplified = UNTOUCHED(medax_simplified);
    const medax_complex *surface = UNTOUCHED(medax_complex);
    medax_simplify_options simplify;
    medax_hole_options holes;
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_offset(NULL, 0.1, NULL, &offset));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_offset(crust, 0.1, NULL, NULL));
    CHECK_STATUS(INVALID_ARGUMENT, medax_power_crust_offset(crust, nan, NULL, &offset));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_simplify(NULL, NULL, NULL, &simplified));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_simplify(crust, NULL, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_simplify_options_init(NULL, sizeof simplify));
    CHECK_STATUS(INVALID_ARGUMENT, medax_simplify_options_init(&simplify, 8));
    CHECK_STATUS(OK, medax_simplify_options_init(&simplify, sizeof simplify));
    CHECK(simplify.epsilon < 0 && simplify.delta < 0);
    simplify.delta = nan;
    CHECK_STATUS(INVALID_ARGUMENT, medax_power_crust_simplify(crust, &simplify, NULL, &simplified));
    CHECK_STATUS(NULL_ARGUMENT, medax_hole_options_init(NULL, sizeof holes));
    CHECK_STATUS(INVALID_ARGUMENT, medax_hole_options_init(&holes, 8));
    CHECK_STATUS(OK, medax_hole_options_init(&holes, sizeof holes));
    CHECK(holes.depth == 0.1 && holes.radius == 0);
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_open(NULL, NULL, NULL, &surface, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_open(crust, NULL, NULL, NULL, NULL));
    holes.radius = -1;
    CHECK_STATUS(INVALID_ARGUMENT, medax_power_crust_open(crust, &holes, NULL, &surface, NULL));
    CHECK(offset == UNTOUCHED(medax_power_crust) && simplified == UNTOUCHED(medax_simplified));
    CHECK(surface == UNTOUCHED(medax_complex));
    offset = NULL;
    CHECK_STATUS(NULL_ARGUMENT, medax_simplified_crust(NULL, &offset));
    CHECK(medax_simplified_epsilon(NULL) == 0 && medax_simplified_delta(NULL) == 0);
    CHECK(medax_simplified_unstable(NULL).rows == 0 && medax_simplified_redundant(NULL).rows == 0);
    CHECK(medax_simplified_clone(NULL) == NULL);
    medax_simplified_free(NULL);
}

static int is_valid(const medax_power_crust *crust) {
    medax_validation report;
    report.struct_size = sizeof report;
    CHECK_STATUS(OK, medax_power_crust_validate(crust, NULL, &report));
    return report.problems == 0;
}

static void offsets(const medax_power_crust *crust) {
    const double distances[] = {-0.1, 0.1};
    for (size_t i = 0; i < 2; ++i) {
        const medax_power_crust *offset = NULL;
        const medax_complex *surface = NULL;
        CHECK_STATUS(OK, medax_power_crust_offset(crust, distances[i], NULL, &offset));
        NEED(offset != NULL);
        CHECK(is_valid(offset));
        CHECK_STATUS(OK, medax_power_crust_surface(offset, &surface));
        const medax_view_f64 at = medax_complex_vertices(surface);
        double longest = 0;
        for (size_t v = 0; v < at.rows; ++v)
            if (at.data[3 * v] > longest) longest = at.data[3 * v];
        CHECK(fabs(longest - 1 - distances[i]) < 0.02);
        medax_complex_free(surface);
        medax_power_crust_free(offset);
    }
}

/* An ellipsoid's inner axis is a disc, at any scale that keeps a ball. */
static void scale_axes(const medax_power_crust *crust) {
    const double factors[] = {1.01, 1.1};
    for (size_t i = 0; i < 2; ++i) {
        const medax_complex *axis = NULL;
        medax_topology topology;
        topology.struct_size = sizeof topology;
        CHECK_STATUS(OK, medax_power_crust_scale_axis(crust, MEDAX_LABEL_INNER, factors[i], NULL, &axis));
        CHECK_STATUS(OK, medax_complex_topology(axis, NULL, &topology));
        CHECK(topology.betti[0] == 1 && topology.betti[1] == 0 && topology.betti[2] == 0);
        const medax_view_f64 at = medax_complex_vertices(axis);
        for (size_t v = 0; v < at.rows; ++v) CHECK(fabs(at.data[3 * v + 2]) < 0.1);
        medax_complex_free(axis);
    }
    const medax_complex *none = UNTOUCHED(medax_complex);
    CHECK_STATUS(INVALID_ARGUMENT, medax_power_crust_scale_axis(crust, MEDAX_LABEL_INNER, 0.5, NULL, &none));
    CHECK_STATUS(INVALID_ARGUMENT, medax_power_crust_scale_axis(crust, 7, 1, NULL, &none));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_scale_axis(NULL, MEDAX_LABEL_INNER, 1, NULL, &none));
    CHECK_STATUS(NULL_ARGUMENT, medax_power_crust_scale_axis(crust, MEDAX_LABEL_INNER, 1, NULL, NULL));
    CHECK(none == UNTOUCHED(medax_complex));
}

static void simplified(const medax_power_crust *crust) {
    const medax_simplified *result = NULL, *again = NULL;
    const medax_power_crust *simple = NULL;
    CHECK_STATUS(OK, medax_power_crust_simplify(crust, NULL, NULL, &result));
    NEED(result != NULL);
    again = medax_simplified_clone(result);
    medax_simplified_free(result);
    /* The defaults, as shares of the diagonal of a box of 2 x 1.4 x 0.8. */
    CHECK(fabs(medax_simplified_epsilon(again) - 0.0257) < 1e-3);
    CHECK(fabs(medax_simplified_delta(again) - 0.0077) < 1e-3);
    const medax_view_u32 redundant = medax_simplified_redundant(again);
    CHECK(redundant.cols == 2 && redundant.rows > 100);
    CHECK_STATUS(OK, medax_simplified_crust(again, &simple));
    NEED(simple != NULL);
    CHECK(is_valid(simple));
    for (size_t i = 0; i < redundant.rows; ++i) {
        CHECK(!medax_power_crust_is_visible(simple, redundant.data[2 * i]));
        CHECK(medax_power_crust_is_visible(simple, redundant.data[2 * i + 1]));
    }
    const medax_view_u32 unstable = medax_simplified_unstable(again);
    for (size_t i = 0; i < unstable.rows; ++i)
        CHECK(!medax_power_crust_is_visible(simple, unstable.data[i]));
    medax_simplified_free(again);
    CHECK(is_valid(simple));
    medax_power_crust_free(simple);
}

static void opened(const medax_power_crust *crust) {
    const medax_complex *whole = NULL, *left = NULL, *left_out = NULL;
    medax_hole_options options;
    CHECK_STATUS(OK, medax_hole_options_init(&options, sizeof options));
    options.depth = 0;
    CHECK_STATUS(OK, medax_power_crust_open(crust, &options, NULL, &left, &left_out));
    CHECK_STATUS(OK, medax_power_crust_surface(crust, &whole));
    const size_t faces = medax_complex_faces(whole).rows;
    CHECK(medax_complex_faces(left).rows + medax_complex_faces(left_out).rows == faces);
    medax_complex_free(left);
    medax_complex_free(left_out);
    CHECK_STATUS(OK, medax_power_crust_open(crust, NULL, NULL, &left, NULL));
    medax_complex_free(left);
    medax_complex_free(whole);
}

static void omitted(const medax_points *points) {
    const medax_power_crust *crust = NULL;
    const medax_poles *poles = NULL;
    medax_power_crust_options options;
    medax_poles_options of_poles;
    CHECK_STATUS(OK, medax_power_crust_options_init(&options, sizeof options));
    options.omit = MEDAX_OMIT_BOTH;
    options.lambda = 0.25;
    CHECK_STATUS(OK, medax_power_crust_build(points, &options, NULL, &crust));
    NEED(crust != NULL);
    CHECK_STATUS(OK, medax_power_crust_poles(crust, &poles));
    CHECK(medax_poles_lambda(poles) == 0.25 && is_valid(crust));
    const medax_view_rows samples = medax_poles_samples_on_balls(poles);
    CHECK(samples.rows == medax_poles_balls(poles).rows);
    for (size_t p = 0; p < samples.rows; ++p) {
        CHECK(samples.offsets[p] < samples.offsets[p + 1]);
        for (uint32_t i = samples.offsets[p]; i < samples.offsets[p + 1]; ++i)
            CHECK(samples.indices[i] < medax_points_count(points));
    }
    medax_poles_free(poles);
    medax_power_crust_free(crust);
    poles = NULL;
    CHECK_STATUS(OK, medax_poles_options_init(&of_poles, sizeof of_poles));
    of_poles.omit = MEDAX_OMIT_SIDE;
    CHECK_STATUS(OK, medax_poles_build_with_far_box(points, &of_poles, NULL, &poles));
    CHECK(medax_poles_lambda(poles) >= 0.4);
    medax_poles_free(poles);
    CHECK(medax_poles_lambda(NULL) == 0 && medax_poles_samples_on_balls(NULL).rows == 0);
}

int main(void) {
    const medax_points *points = ellipsoid();
    const medax_power_crust *crust = NULL;
    CHECK_STATUS(OK, medax_power_crust_build(points, NULL, NULL, &crust));
    NEED(crust != NULL);
    refusals(crust);
    offsets(crust);
    scale_axes(crust);
    simplified(crust);
    opened(crust);
    omitted(points);
    medax_power_crust_free(crust);
    medax_points_free(points);
    return check_end();
}
