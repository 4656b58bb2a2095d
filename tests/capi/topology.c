/* Topology, measure, self-intersections, orientation and checks of complexes. */
#include "check.h"

static const char nothing = 0;

/* The unit cube's surface; with `flip`, one face turned inward. */
static const medax_complex *cube(int flip) {
    static const double xyz[24] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0,
                                   0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
    static const uint32_t offsets[7] = {0, 4, 8, 12, 16, 20, 24};
    uint32_t rings[24] = {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
    medax_complex_parts parts;
    const medax_complex *complex = NULL;
    medax_complex_parts_init(&parts, sizeof parts);
    if (flip) {
        rings[5] = 7;
        rings[7] = 5;
    }
    parts.vertices = xyz;
    parts.vertex_count = 8;
    parts.face_offsets = offsets;
    parts.face_indices = rings;
    parts.face_count = 6;
    CHECK_STATUS(OK, medax_complex_create(&parts, &complex));
    NEED(complex != NULL);
    return complex;
}

static void a_cube(void) {
    const medax_complex *complex = cube(0), *crooked = cube(1), *oriented = NULL;
    medax_topology topology;
    double area = 0, volume = 0;
    memset(&topology, 0xa5, sizeof topology);
    topology.struct_size = sizeof topology;
    CHECK_STATUS(OK, medax_complex_topology(complex, NULL, &topology));
    CHECK(topology.struct_size == sizeof topology && topology.vertices == 8);
    CHECK(topology.isolated_vertices == 0 && topology.edges == 12 && topology.faces == 6);
    CHECK(topology.cells == 0 && topology.components == 1 && topology.euler_characteristic == 2);
    CHECK(topology.boundary_edges == 0 && topology.boundary_loops == 0);
    CHECK(topology.nonmanifold_edges == 0 && topology.nonmanifold_vertices == 0);
    CHECK(topology.has_genus == 1 && topology.genus == 0 && topology.closed == 1);
    CHECK(topology.oriented == 1 && topology.reserved == 0);
    CHECK(topology.betti[0] == 1 && topology.betti[1] == 0 && topology.betti[2] == 1);
    CHECK_STATUS(OK, medax_complex_measure(complex, NULL, &area, &volume));
    CHECK(area > 5.999999 && area < 6.000001 && volume > 0.999999 && volume < 1.000001);
    CHECK_STATUS(OK, medax_complex_measure(complex, NULL, NULL, NULL));

    CHECK_STATUS(OK, medax_complex_topology(crooked, NULL, &topology));
    CHECK(topology.closed == 1 && topology.oriented == 0);
    CHECK_STATUS(OK, medax_complex_orient(crooked, NULL, &oriented));
    medax_complex_free(crooked);
    CHECK_STATUS(OK, medax_complex_topology(oriented, NULL, &topology));
    CHECK(topology.oriented == 1);
    CHECK(memcmp(medax_complex_faces(oriented).indices, medax_complex_faces(complex).indices,
                 24 * sizeof(uint32_t)) == 0);
    medax_complex_free(oriented);
    medax_complex_free(complex);
}

static void without_genus(void) {
    static const uint32_t edge[2] = {0, 1};
    medax_complex_parts parts;
    const medax_complex *complex = NULL;
    medax_topology topology;
    const double xyz[9] = {0, 0, 0, 1, 0, 0, 5, 5, 5};
    medax_complex_parts_init(&parts, sizeof parts);
    parts.vertices = xyz;
    parts.vertex_count = 3;
    parts.edges = edge;
    parts.edge_count = 1;
    CHECK_STATUS(OK, medax_complex_create(&parts, &complex));
    topology.struct_size = sizeof topology;
    CHECK_STATUS(OK, medax_complex_topology(complex, NULL, &topology));
    CHECK(topology.has_genus == 0 && topology.genus == 0 && topology.closed == 0);
    CHECK(topology.components == 2 && topology.isolated_vertices == 1);
    medax_complex_free(complex);
}

/* Two triangles that cross, and one beside them. */
static void intersections(void) {
    static const double xyz[27] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, -1, 1, 1, 1,
                                   2, 1, 1, 9, 9, 9, 9, 8, 9, 8, 9, 9};
    static const uint32_t offsets[4] = {0, 3, 6, 9};
    static const uint32_t rings[9] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    medax_complex_parts parts;
    const medax_complex *whole = cube(0), *complex = NULL;
    const medax_job *spent = NULL;
    const medax_intersections *found = NULL, *same = NULL;
    medax_view_u32 pairs;
    CHECK_STATUS(OK, medax_complex_self_intersections(whole, NULL, &found));
    CHECK(found != NULL && medax_intersections_pairs(found).rows == 0);
    medax_intersections_free(found);
    found = NULL;
    medax_complex_parts_init(&parts, sizeof parts);
    parts.vertices = xyz;
    parts.vertex_count = 9;
    parts.face_offsets = offsets;
    parts.face_indices = rings;
    parts.face_count = 3;
    CHECK_STATUS(OK, medax_complex_create(&parts, &complex));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_self_intersections(NULL, NULL, &found));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_self_intersections(complex, NULL, NULL));
    NEED(medax_job_create(NULL, &spent) == MEDAX_STATUS_OK);
    medax_job_cancel(spent);
    CHECK_STATUS(CANCELLED, medax_complex_self_intersections(complex, spent, &found));
    CHECK(found == NULL);
    medax_job_free(spent);
    CHECK_STATUS(OK, medax_complex_self_intersections(complex, NULL, &found));
    medax_complex_free(complex);
    /* They outlive the complex, and their first reference. */
    same = medax_intersections_clone(found);
    CHECK(same == found);
    medax_intersections_free(found);
    pairs = medax_intersections_pairs(same);
    NEED(pairs.rows == 1 && pairs.cols == 2);
    CHECK(pairs.data[0] == 0 && pairs.data[1] == 1);
    medax_intersections_free(same);
    CHECK(medax_intersections_pairs(NULL).rows == 0 && medax_intersections_pairs(NULL).cols == 2);
    CHECK(medax_intersections_clone(NULL) == NULL);
    medax_intersections_free(NULL);
    medax_complex_free(whole);
}

static void refusals(void) {
    const medax_complex *complex = cube(0);
    const medax_complex *oriented = (const medax_complex *)(const void *)&nothing;
    const medax_job *spent = NULL;
    medax_topology topology;
    medax_validation report;
    double area = -1, volume = -1;
    NEED(medax_job_create(NULL, &spent) == MEDAX_STATUS_OK);
    medax_job_cancel(spent);
    memset(&topology, 0xa5, sizeof topology);
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_topology(complex, NULL, &topology));
    topology.struct_size = sizeof topology - 8;
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_topology(complex, NULL, &topology));
    topology.struct_size = sizeof topology;
    CHECK_STATUS(CANCELLED, medax_complex_topology(complex, spent, &topology));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_topology(NULL, NULL, &topology));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_topology(complex, NULL, NULL));
    CHECK(topology.vertices == 0xa5a5a5a5a5a5a5a5u);
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_measure(NULL, NULL, &area, &volume));
    CHECK_STATUS(CANCELLED, medax_complex_measure(complex, spent, &area, &volume));
    CHECK(area == -1 && volume == -1);
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_orient(NULL, NULL, &oriented));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_orient(complex, NULL, NULL));
    CHECK_STATUS(CANCELLED, medax_complex_orient(complex, spent, &oriented));
    CHECK(oriented == (const void *)&nothing);
    report.struct_size = sizeof report;
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_validate(NULL, NULL, &report));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_validate(complex, NULL, NULL));
    CHECK_STATUS(CANCELLED, medax_complex_validate(complex, spent, &report));
    CHECK_STATUS(OK, medax_complex_validate(complex, NULL, &report));
    CHECK(report.problems == 0 && report.checked > 0);
    medax_job_free(spent);
    medax_complex_free(complex);
}

/* A newer caller's report is larger; what this library does not know becomes 0. */
static void a_larger_report(void) {
    union {
        medax_topology topology;
        unsigned char bytes[sizeof(medax_topology) + 32];
    } memory;
    const medax_complex *complex = cube(0);
    memset(memory.bytes, 0xa5, sizeof memory.bytes);
    memory.topology.struct_size = sizeof(medax_topology) + 16;
    CHECK_STATUS(OK, medax_complex_topology(complex, NULL, &memory.topology));
    CHECK(memory.topology.struct_size == sizeof(medax_topology) + 16);
    CHECK(memory.topology.edges == 12);
    for (size_t i = 0; i < 32; ++i)
        CHECK(memory.bytes[sizeof(medax_topology) + i] == (i < 16 ? 0 : 0xa5));
    medax_complex_free(complex);
}

int main(void) {
    a_cube();
    without_genus();
    intersections();
    refusals();
    a_larger_report();
    return check_end();
}
