/* Samples of the built-in torus with what axes and flows are built of. */
#ifndef TORUS_H
#define TORUS_H

#include "check.h"

/* The core circle has radius 1 about the z axis, the tube 0.4. */
typedef struct {
    const medax_samples *samples;
    const medax_points *points;
    const medax_triangulation *t;
    const medax_dual *dual;
    const medax_labels *labels;
} torus;

static inline torus sampled(void) {
    torus made = {NULL, NULL, NULL, NULL, NULL};
    const medax_power_crust *crust = NULL;
    medax_sample_options options;
    medax_dual_options with_facets;
    medax_sample_options_init(&options, sizeof options);
    options.spacing = 0.15;
    CHECK_STATUS(OK, medax_samples_build(MEDAX_SHAPE_TORUS, &options, NULL, &made.samples));
    const medax_view_f64 xyz = medax_samples_coords(made.samples);
    CHECK_STATUS(OK, medax_points_create_f64(xyz.data, xyz.rows, 0, NULL, NULL, &made.points));
    CHECK_STATUS(OK, medax_delaunay_build(made.points, NULL, NULL, &made.t));
    medax_dual_options_init(&with_facets, sizeof with_facets);
    with_facets.facets = 1;
    CHECK_STATUS(OK, medax_dual_build(made.t, &with_facets, NULL, &made.dual));
    CHECK_STATUS(OK, medax_power_crust_build(made.points, NULL, NULL, &crust));
    CHECK_STATUS(OK, medax_labels_of_crust(made.dual, crust, NULL, &made.labels));
    medax_power_crust_free(crust);
    NEED(made.dual != NULL && made.labels != NULL);
    return made;
}

static inline void done(torus made) {
    medax_samples_free(made.samples);
    medax_points_free(made.points);
    medax_triangulation_free(made.t);
    medax_labels_free(made.labels);
    medax_dual_free(made.dual);
}

/* The attribute, which must be there. */
static inline medax_attribute attribute(const medax_complex *complex, uint32_t element,
                                        const char *name) {
    medax_attribute found;
    memset(&found, 0, sizeof found);
    CHECK_STATUS(OK, medax_complex_attribute(complex, element, name, &found));
    return found;
}

#endif
