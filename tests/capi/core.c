/* Cores of a torus: a closed curve, alone and with facets. */
#include "torus.h"

static const char nothing = 0;
#define NO_COMPLEX ((const medax_complex *)(const void *)&nothing)

static medax_core_options defaults(void) {
    medax_core_options options;
    CHECK_STATUS(OK, medax_core_options_init(&options, sizeof options));
    return options;
}

static void initial(void) {
    medax_core_options options = defaults();
    CHECK(options.struct_size == sizeof options && options.side == MEDAX_SIDE_INNER);
    CHECK(options.repair == 1);
    CHECK_STATUS(NULL_ARGUMENT, medax_core_options_init(NULL, sizeof options));
    CHECK_STATUS(INVALID_ARGUMENT, medax_core_options_init(&options, 8));
}

static void refusals(const torus *made, const medax_flow *flow) {
    const medax_complex *core = NO_COMPLEX;
    const medax_job *spent = NULL;
    const uint32_t facets[] = {3, 7, (uint32_t)medax_dual_facets(made->dual).rows};
    medax_core_options options = defaults();
    medax_core_report report;
    report.struct_size = sizeof report;
    report.taken = 77;
    CHECK_STATUS(OK, medax_job_create(NULL, &spent));
    medax_job_cancel(spent);
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_core(NULL, NULL, 0, NULL, NULL, &report, &core));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_core(flow, NULL, 1, NULL, NULL, &report, &core));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_core(flow, NULL, 0, NULL, NULL, &report, NULL));
    CHECK_STATUS(CANCELLED, medax_flow_core(flow, NULL, 0, NULL, spent, &report, &core));
    CHECK_STATUS(INVALID_ARGUMENT,
                 medax_flow_core(flow, facets, SIZE_MAX, NULL, NULL, &report, &core));
    CHECK_STATUS(INVALID_ARGUMENT, medax_flow_core(flow, facets, 3, NULL, NULL, &report, &core));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_FACE
          && medax_last_error_index() == facets[2]);
    options.side = 3;
    CHECK_STATUS(INVALID_ARGUMENT, medax_flow_core(flow, NULL, 0, &options, NULL, &report, &core));
    options = defaults();
    options.repair = 2;
    CHECK_STATUS(INVALID_ARGUMENT, medax_flow_core(flow, NULL, 0, &options, NULL, &report, &core));
    options = defaults();
    options.struct_size = 3;
    CHECK_STATUS(INVALID_ARGUMENT, medax_flow_core(flow, NULL, 0, &options, NULL, &report, &core));
    CHECK(report.taken == 77 && report.struct_size == sizeof report);
    report.struct_size = 8;
    CHECK_STATUS(INVALID_ARGUMENT, medax_flow_core(flow, NULL, 0, NULL, NULL, &report, &core));
    CHECK(core == NO_COMPLEX);
    medax_job_free(spent);
}

static medax_topology topology_of(const medax_complex *complex) {
    medax_topology topology;
    topology.struct_size = sizeof topology;
    CHECK_STATUS(OK, medax_complex_topology(complex, NULL, &topology));
    return topology;
}

static const medax_complex *core_of(const medax_flow *flow, const medax_core_options *options,
                                    const uint32_t *facets, size_t count,
                                    medax_core_report *report) {
    const medax_complex *core = NULL;
    report->struct_size = sizeof *report;
    CHECK_STATUS(OK, medax_flow_core(flow, facets, count, options, NULL, report, &core));
    NEED(core != NULL);
    return core;
}

/* The core is a closed curve about the core circle of the torus, whether or not it is repaired. */
static void a_curve(const torus *made, const medax_flow *flow) {
    medax_core_report report;
    medax_core_options options = defaults();
    const medax_complex *core = core_of(flow, NULL, NULL, 0, &report), *plain, *again = NULL;
    const medax_topology topology = topology_of(core);
    CHECK(topology.betti[0] == 1 && topology.betti[1] == 1 && topology.betti[2] == 0);
    CHECK(report.taken + report.of_surface + report.elsewhere + report.leaving + report.unbounded
          == 0);
    const medax_view_f64 vertices = medax_complex_vertices(core);
    const medax_view_f64 centers = medax_dual_centers(made->dual);
    const medax_view_f64 points = medax_flow_critical_points(flow);
    const medax_view_f64 radius = attribute(core, MEDAX_ELEMENT_VERTEX, "radius").f64_values;
    const medax_view_u32 cell = attribute(core, MEDAX_ELEMENT_VERTEX, "cell").u32_values;
    const medax_view_u32 critical = attribute(core, MEDAX_ELEMENT_VERTEX, "critical").u32_values;
    const medax_view_u32 facet = attribute(core, MEDAX_ELEMENT_FACE, "facet").u32_values;
    const medax_view_u32 samples = attribute(core, MEDAX_ELEMENT_FACE, "samples").u32_values;
    const medax_view_u32 corners = attribute(core, MEDAX_ELEMENT_EDGE, "samples").u32_values;
    NEED(radius.rows == vertices.rows && cell.rows == vertices.rows
         && critical.rows == vertices.rows);
    NEED(corners.rows == medax_complex_edges(core).rows && corners.cols == 3 && corners.rows > 0);
    size_t found = 0;
    for (size_t v = 0; v < vertices.rows; ++v) {
        const double *p = vertices.data + 3 * v, ring = sqrt(p[0] * p[0] + p[1] * p[1]) - 1;
        CHECK(ring * ring + p[2] * p[2] < 0.01 && fabs(radius.data[v] - 0.4) < 0.1);
        if (cell.data[v] != MEDAX_NONE) CHECK(memcmp(p, centers.data + 3 * cell.data[v], 24) == 0);
        if (critical.data[v] == MEDAX_NONE) continue;
        ++found;
        CHECK(memcmp(p, points.data + 3 * critical.data[v], 24) == 0);
        CHECK(medax_flow_critical_classes(flow).data[critical.data[v]]
              == MEDAX_CRITICAL_CLASS_INNER);
    }
    CHECK(found > 10);
    for (size_t f = 0; f < facet.rows; ++f)
        CHECK(memcmp(samples.data + 2 * f,
                     medax_dual_facet_edges(made->dual).data + 2 * facet.data[f], 8)
              == 0);
    options.repair = 0;
    plain = core_of(flow, &options, NULL, 0, &report);
    CHECK(topology_of(plain).betti[0] == 1 && topology_of(plain).betti[1] == 1);
    /* The report need not be wanted. */
    CHECK_STATUS(OK, medax_flow_core(flow, NULL, 0, &options, NULL, NULL, &again));
    CHECK(medax_complex_vertices(again).rows == medax_complex_vertices(plain).rows);
    medax_complex_free(again);
    medax_complex_free(plain);
    medax_complex_free(core);
}

/* By all facets, each named twice: of the surface, outside, leaving, and the rest. */
static void extended(const torus *made, const medax_flow *flow) {
    const uint32_t facets = (uint32_t)medax_dual_facets(made->dual).rows;
    const medax_view_rows rings = medax_dual_facets(made->dual);
    const medax_view_u32 rays = medax_dual_facet_rays(made->dual);
    const uint8_t *is_inner = medax_labels_is_inner(made->labels).data;
    uint32_t *list = malloc(2 * facets * sizeof *list);
    NEED(list != NULL);
    size_t sides[3] = {0, 0, 0};
    for (uint32_t f = 0; f < facets; ++f) {
        list[2 * f] = list[2 * f + 1] = f;
        size_t inner = 0;
        for (uint32_t i = rings.offsets[f]; i < rings.offsets[f + 1]; ++i)
            inner += is_inner[rings.indices[i]];
        const int unbounded = rays.data[2 * f] != MEDAX_NONE;
        const int all = inner == rings.offsets[f + 1] - rings.offsets[f] && !unbounded;
        ++sides[inner == 0 ? MEDAX_SIDE_OUTER : all ? MEDAX_SIDE_INNER : MEDAX_SIDE_BOTH];
    }
    medax_core_report report;
    medax_core_options options = defaults();
    const medax_complex *core = core_of(flow, NULL, NULL, 0, &report), *fuller, *outer, *both;
    const size_t faces = medax_complex_faces(core).rows;
    fuller = core_of(flow, NULL, list, 2 * facets, &report);
    CHECK(report.of_surface == sides[MEDAX_SIDE_BOTH]
          && report.elsewhere == sides[MEDAX_SIDE_OUTER]);
    CHECK(report.taken + report.leaving == sides[MEDAX_SIDE_INNER] && report.unbounded == 0);
    CHECK(report.taken > 0 && report.leaving > 0);
    CHECK(medax_complex_faces(fuller).rows > faces);
    CHECK(topology_of(fuller).betti[0] == 1 && topology_of(fuller).betti[1] == 1);
    options.side = MEDAX_SIDE_OUTER;
    outer = core_of(flow, &options, list, 2 * facets, &report);
    CHECK(report.elsewhere == sides[MEDAX_SIDE_INNER] && report.unbounded > 0);
    CHECK(report.taken + report.leaving == sides[MEDAX_SIDE_OUTER]);
    options.side = MEDAX_SIDE_BOTH;
    both = core_of(flow, &options, list, 2 * facets, &report);
    CHECK(report.elsewhere == 0 && report.of_surface == sides[MEDAX_SIDE_BOTH]);
    CHECK(medax_complex_faces(both).rows
          == medax_complex_faces(outer).rows + medax_complex_faces(fuller).rows);
    medax_complex_free(both);
    medax_complex_free(outer);
    medax_complex_free(fuller);
    medax_complex_free(core);
    free(list);
}

int main(void) {
    torus made = sampled();
    const medax_flow *flow = NULL;
    CHECK_STATUS(OK, medax_flow_build(made.dual, made.labels, NULL, NULL, &flow));
    NEED(flow != NULL);
    initial();
    refusals(&made, flow);
    a_curve(&made, flow);
    extended(&made, flow);
    medax_flow_free(flow);
    done(made);
    return check_end();
}
