/* Complexes: made of the caller's arrays, and looked at. */
#include "check.h"

static const char nothing = 0;
#define UNTOUCHED ((const medax_complex *)(const void *)&nothing)

/* A cube's top and bottom, a loose edge, a pyramid, a tetrahedron, and attributes on each kind. */
static const double vertices[27] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0,
                                    1, 1, 0, 1, 1, 1, 1, 0, 1, 1, 2, 2, 2};
static const uint32_t face_offsets[3] = {0, 4, 7};
static const uint32_t face_indices[7] = {0, 3, 2, 1, 4, 5, 6};
static const uint32_t edges[2] = {6, 8};
static const uint32_t cell_offsets[3] = {0, 5, 9};
static const uint32_t cell_indices[9] = {0, 1, 2, 3, 8, 4, 5, 6, 8};
static const uint32_t cell_types[2] = {MEDAX_CELL_TYPE_PYRAMID, MEDAX_CELL_TYPE_TETRAHEDRON};
static const double radius[9] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
static const uint32_t labels[4] = {10, 11, 12, 13};

static void fill(medax_complex_parts *parts, medax_attribute *attributes) {
    static const medax_attribute blank;
    NEED(medax_complex_parts_init(parts, sizeof *parts) == MEDAX_STATUS_OK);
    parts->vertices = vertices;
    parts->vertex_count = 9;
    parts->face_offsets = face_offsets;
    parts->face_indices = face_indices;
    parts->face_count = 2;
    parts->edges = edges;
    parts->edge_count = 1;
    parts->cell_offsets = cell_offsets;
    parts->cell_indices = cell_indices;
    parts->cell_types = cell_types;
    parts->cell_count = 2;
    attributes[0] = attributes[1] = blank;
    attributes[0].name = "radius";
    attributes[0].element = MEDAX_ELEMENT_VERTEX;
    attributes[0].value_type = MEDAX_VALUE_TYPE_F64;
    attributes[0].f64_values.data = radius;
    attributes[0].f64_values.rows = 9;
    attributes[0].f64_values.cols = 1;
    attributes[1].name = "label";
    attributes[1].element = MEDAX_ELEMENT_FACE;
    attributes[1].value_type = MEDAX_VALUE_TYPE_U32;
    attributes[1].u32_values.data = labels;
    attributes[1].u32_values.rows = 2;
    attributes[1].u32_values.cols = 2;
    parts->attributes = attributes;
    parts->attribute_count = 2;
}

static void round_trip(void) {
    medax_complex_parts parts;
    medax_attribute given[2], found;
    const medax_complex *complex = NULL;
    fill(&parts, given);
    CHECK_STATUS(OK, medax_complex_create(&parts, &complex));
    NEED(complex != NULL);
    const medax_view_f64 v = medax_complex_vertices(complex);
    const medax_view_rows f = medax_complex_faces(complex), c = medax_complex_cells(complex);
    const medax_view_u32 e = medax_complex_edges(complex), types = medax_complex_cell_types(complex);
    const medax_view_u32 t = medax_complex_triangles(complex);
    const medax_view_u32 of_triangle = medax_complex_face_of_triangle(complex);
    NEED(v.rows == 9 && v.cols == 3 && f.rows == 2 && c.rows == 2 && e.rows == 1 && e.cols == 2);
    NEED(types.rows == 2 && types.cols == 1 && t.rows == 3 && t.cols == 3);
    NEED(of_triangle.rows == 3 && of_triangle.cols == 1);
    CHECK(v.data != vertices && memcmp(v.data, vertices, sizeof vertices) == 0);
    CHECK(memcmp(f.offsets, face_offsets, sizeof face_offsets) == 0);
    CHECK(memcmp(f.indices, face_indices, sizeof face_indices) == 0);
    CHECK(memcmp(c.offsets, cell_offsets, sizeof cell_offsets) == 0);
    CHECK(memcmp(c.indices, cell_indices, sizeof cell_indices) == 0);
    CHECK(memcmp(e.data, edges, sizeof edges) == 0);
    CHECK(memcmp(types.data, cell_types, sizeof cell_types) == 0);
    CHECK(t.data[0] == 0 && t.data[1] == 3 && t.data[2] == 2 && t.data[3] == 0 && t.data[5] == 1);
    CHECK(of_triangle.data[0] == 0 && of_triangle.data[1] == 0 && of_triangle.data[2] == 1);
    CHECK(medax_complex_dimension(complex) == 3);

    CHECK(medax_complex_attribute_count(complex) == 2);
    CHECK_STATUS(OK, medax_complex_attribute(complex, MEDAX_ELEMENT_VERTEX, "radius", &found));
    CHECK(strcmp(found.name, "radius") == 0 && found.element == MEDAX_ELEMENT_VERTEX);
    CHECK(found.value_type == MEDAX_VALUE_TYPE_F64 && found.u32_values.data == NULL);
    CHECK(found.f64_values.rows == 9 && found.f64_values.cols == 1);
    CHECK(memcmp(found.f64_values.data, radius, sizeof radius) == 0);
    CHECK_STATUS(OK, medax_complex_attribute_at(complex, 1, &found));
    CHECK(strcmp(found.name, "label") == 0 && found.element == MEDAX_ELEMENT_FACE);
    CHECK(found.value_type == MEDAX_VALUE_TYPE_U32 && found.f64_values.data == NULL);
    CHECK(found.u32_values.rows == 2 && found.u32_values.cols == 2);
    CHECK(memcmp(found.u32_values.data, labels, sizeof labels) == 0);

    memset(&found, 0, sizeof found);
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_attribute_at(complex, 2, &found));
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_attribute_at(complex, SIZE_MAX, &found));
    CHECK_STATUS(INVALID_ARGUMENT,
                 medax_complex_attribute(complex, MEDAX_ELEMENT_FACE, "radius", &found));
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_attribute(complex, 4, "radius", &found));
    CHECK_STATUS(INVALID_ARGUMENT,
                 medax_complex_attribute(complex, MEDAX_ELEMENT_FACE, "\xff", &found));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_attribute(complex, 0, NULL, &found));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_attribute(complex, 0, "radius", NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_attribute(NULL, 0, "radius", &found));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_attribute_at(complex, 0, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_attribute_at(NULL, 0, &found));
    CHECK(found.name == NULL);

    const medax_complex *again = medax_complex_clone(complex);
    CHECK(again == complex);
    medax_complex_free(complex);
    CHECK(medax_complex_vertices(again).data == v.data && v.data[26] == 2);
    medax_complex_free(again);
}

static void plane_and_empty(void) {
    medax_complex_parts parts;
    const medax_complex *complex = NULL;
    NEED(medax_complex_parts_init(&parts, sizeof parts) == MEDAX_STATUS_OK);
    CHECK_STATUS(OK, medax_complex_create(&parts, &complex));
    CHECK(medax_complex_dimension(complex) == 3 && medax_complex_vertices(complex).rows == 0);
    CHECK(medax_complex_vertices(complex).data == NULL);
    CHECK(medax_complex_faces(complex).rows == 0 && medax_complex_faces(complex).offsets[0] == 0);
    medax_complex_free(complex);
    parts.vertices = vertices;
    parts.vertex_count = 4;
    parts.dimension = 2;
    CHECK_STATUS(OK, medax_complex_create(&parts, &complex));
    CHECK(medax_complex_dimension(complex) == 2);
    medax_complex_free(complex);
}

/* Each fault alone is found, and nothing is written. */
static void faults(void) {
    enum { CASES = 31 };
    const double nan = strtod("nan", NULL);
    double crooked[27];
    const uint32_t late[3] = {1, 4, 7}, falling[3] = {0, 5, 4}, huge[3] = {0, UINT32_MAX, 7};
    const uint32_t two[3] = {0, 5, 7}, short_cell[3] = {0, 4, 9}, pinched[7] = {0, 3, 3, 1, 4, 5, 6};
    const uint32_t unknown[9] = {0, 3, 2, 1, 4, 5, 9, 9, 9}, loop[2] = {6, 6}, far[2] = {6, 9};
    const uint32_t no_type[2] = {MEDAX_CELL_TYPE_PYRAMID, 0}, high_type[2] = {4, 2};
    const medax_complex *complex = UNTOUCHED;
    memcpy(crooked, vertices, sizeof crooked);
    crooked[16] = nan;
    for (int i = 0; i < CASES; ++i) {
        medax_complex_parts parts;
        medax_attribute given[2];
        medax_status expected = MEDAX_STATUS_INVALID_ARGUMENT;
        uint32_t kind = MEDAX_ERROR_KIND_NONE;
        uint64_t index = UINT64_MAX;
        fill(&parts, given);
        switch (i) {
        case 0: parts.vertices = NULL; expected = MEDAX_STATUS_NULL_ARGUMENT; break;
        case 1: parts.face_offsets = NULL; expected = MEDAX_STATUS_NULL_ARGUMENT; break;
        case 2: parts.face_indices = NULL; expected = MEDAX_STATUS_NULL_ARGUMENT; break;
        case 3: parts.edges = NULL; expected = MEDAX_STATUS_NULL_ARGUMENT; break;
        case 4: parts.cell_offsets = NULL; expected = MEDAX_STATUS_NULL_ARGUMENT; break;
        case 5: parts.cell_indices = NULL; expected = MEDAX_STATUS_NULL_ARGUMENT; break;
        case 6: parts.cell_types = NULL; expected = MEDAX_STATUS_NULL_ARGUMENT; break;
        case 7: parts.attributes = NULL; expected = MEDAX_STATUS_NULL_ARGUMENT; break;
        case 8: given[0].name = NULL; expected = MEDAX_STATUS_NULL_ARGUMENT; break;
        case 9: given[0].f64_values.data = NULL; expected = MEDAX_STATUS_NULL_ARGUMENT; break;
        case 10: given[1].u32_values.data = NULL; expected = MEDAX_STATUS_NULL_ARGUMENT; break;
        case 11: parts.vertex_count = SIZE_MAX; break;
        case 12: parts.face_count = SIZE_MAX; break;
        case 13: parts.cell_count = SIZE_MAX; break;
        case 14: parts.attribute_count = SIZE_MAX; break;
        case 15: given[1].u32_values.cols = SIZE_MAX; break;
        case 16: parts.face_offsets = late; break;
        case 17: parts.face_offsets = falling; break;
        case 18: parts.face_offsets = huge; break;
        case 19: parts.face_offsets = two; kind = MEDAX_ERROR_KIND_FACE; index = 1; break;
        case 20: parts.face_indices = pinched; kind = MEDAX_ERROR_KIND_FACE; index = 0; break;
        case 21: parts.face_indices = unknown; kind = MEDAX_ERROR_KIND_FACE; index = 1; break;
        case 22: parts.edges = loop; kind = MEDAX_ERROR_KIND_EDGE; index = 0; break;
        case 23: parts.edges = far; kind = MEDAX_ERROR_KIND_EDGE; index = 0; break;
        case 24: parts.cell_offsets = short_cell; kind = MEDAX_ERROR_KIND_CELL; index = 0; break;
        case 25: parts.cell_indices = unknown; kind = MEDAX_ERROR_KIND_CELL; index = 1; break;
        case 26: parts.cell_types = no_type; kind = MEDAX_ERROR_KIND_CELL; index = 1; break;
        case 27: parts.cell_types = high_type; kind = MEDAX_ERROR_KIND_CELL; index = 0; break;
        case 28: given[1].u32_values.rows = 1; expected = MEDAX_STATUS_MISMATCH; break;
        case 29: given[1].value_type = 2; break;
        default:
            parts.vertices = crooked;
            expected = MEDAX_STATUS_NON_FINITE;
            kind = MEDAX_ERROR_KIND_VERTEX;
            index = 5;
        }
        if (!CHECK(medax_complex_create(&parts, &complex) == expected)) printf("  case %d\n", i);
        if (!CHECK(medax_last_error_kind() == kind)) printf("  case %d\n", i);
        CHECK(medax_last_error_index() == index);
        CHECK(complex == UNTOUCHED);
    }
}

static void refusals(void) {
    medax_complex_parts parts;
    medax_attribute given[2];
    const medax_complex *complex = UNTOUCHED;
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_parts_init(NULL, sizeof parts));
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_parts_init(&parts, sizeof parts - 8));
    fill(&parts, given);
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_create(NULL, &complex));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_create(&parts, NULL));
    parts.dimension = 4;
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_create(&parts, &complex));
    parts.dimension = 1;
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_create(&parts, &complex));
    parts.dimension = 0;
    parts.reserved = 1;
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_create(&parts, &complex));
    parts.reserved = 0;
    given[1].element = 4;
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_create(&parts, &complex));
    given[1].element = MEDAX_ELEMENT_FACE;
    given[1].u32_values.cols = 0;
    CHECK(medax_complex_create(&parts, &complex) != MEDAX_STATUS_OK);
    given[1].u32_values.cols = 2;
    given[1].name = "\xc3";
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_create(&parts, &complex));
    CHECK(complex == UNTOUCHED);
}

static void null_is_nothing(void) {
    CHECK(medax_complex_dimension(NULL) == 3);
    CHECK(medax_complex_vertices(NULL).rows == 0 && medax_complex_vertices(NULL).cols == 3);
    CHECK(medax_complex_faces(NULL).rows == 0 && medax_complex_faces(NULL).offsets == NULL);
    CHECK(medax_complex_edges(NULL).rows == 0 && medax_complex_cells(NULL).rows == 0);
    CHECK(medax_complex_cell_types(NULL).rows == 0 && medax_complex_triangles(NULL).rows == 0);
    CHECK(medax_complex_face_of_triangle(NULL).rows == 0);
    CHECK(medax_complex_attribute_count(NULL) == 0);
    CHECK(medax_complex_clone(NULL) == NULL);
    medax_complex_free(NULL);
}

int main(void) {
    round_trip();
    plane_and_empty();
    faults();
    refusals();
    null_is_nothing();
    return check_end();
}
