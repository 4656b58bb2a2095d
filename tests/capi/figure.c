/* Plane figures: made of arrays, read from files, and what is refused. */
#include "check.h"

/* What an output points at before the call. */
static const char untouched = 0;
#define UNTOUCHED ((const medax_figure *)(const void *)&untouched)

/* A square with a square hole, both turned the wrong way, the outer ring closed; an L; two points; a circle. */
static const double ring_vertices[18] = {0, 0, 0, 9, 9, 9, 9, 0, 0, 0, 3, 3, 5, 3, 5, 5, 3, 5};
static const uint32_t ring_offsets[3] = {0, 5, 9}, polygon_offsets[2] = {0, 2};
static const double polyline_vertices[8] = {20, 0, 20, 0, 20, 5, 25, 5};
static const uint32_t polyline_offsets[2] = {0, 4};
static const double points[4] = {1, 1, 1, 1}, circles[3] = {50, 50, 2.5};

static medax_figure_parts all_parts(void) {
    medax_figure_parts parts;
    CHECK_STATUS(OK, medax_figure_parts_init(&parts, sizeof parts));
    parts.ring_vertices = ring_vertices;
    parts.ring_vertex_count = 9;
    parts.ring_offsets = ring_offsets;
    parts.ring_count = 2;
    parts.polygon_offsets = polygon_offsets;
    parts.polygon_count = 1;
    parts.polyline_vertices = polyline_vertices;
    parts.polyline_vertex_count = 4;
    parts.polyline_offsets = polyline_offsets;
    parts.polyline_count = 1;
    parts.points = points;
    parts.point_count = 2;
    parts.circles = circles;
    parts.circle_count = 1;
    return parts;
}

static void valid(const medax_figure *figure) {
    medax_validation report;
    report.struct_size = sizeof report;
    CHECK_STATUS(OK, medax_figure_validate(figure, NULL, &report));
    CHECK(report.problems == 0 && report.checked > 0);
}

static void accessors(void) {
    static const double vertices[26] = {0, 0, 9, 0, 9, 9, 0, 9, 3, 3,  3, 5, 5,
                                        5, 5, 3, 20, 0, 20, 5, 25, 5, 1, 1, 1, 1};
    static const uint32_t offsets[6] = {0, 4, 8, 11, 12, 13}, parts_of[5] = {0, 0, 1, 2, 3};
    static const uint32_t kinds_of[5] = {MEDAX_CHAIN_KIND_OUTER, MEDAX_CHAIN_KIND_HOLE,
                                         MEDAX_CHAIN_KIND_POLYLINE, MEDAX_CHAIN_KIND_POINT,
                                         MEDAX_CHAIN_KIND_POINT};
    const medax_figure_parts parts = all_parts();
    const medax_figure *figure = NULL;
    medax_normalised counts;
    double min[2], max[2];
    CHECK_STATUS(OK, medax_figure_create(&parts, NULL, &figure));
    NEED(figure != NULL);
    valid(figure);
    const medax_view_f64 found = medax_figure_vertices(figure);
    NEED(found.rows == 13 && found.cols == 2);
    CHECK(memcmp(found.data, vertices, sizeof vertices) == 0);
    const medax_view_rows chains = medax_figure_chains(figure);
    NEED(chains.rows == 5);
    CHECK(memcmp(chains.offsets, offsets, sizeof offsets) == 0);
    for (uint32_t v = 0; v < 13; ++v) CHECK(chains.indices[v] == v);
    const medax_view_u32 kinds = medax_figure_kinds(figure);
    const medax_view_u32 parts_found = medax_figure_parts_of_chains(figure);
    NEED(kinds.rows == 5 && kinds.cols == 1 && parts_found.rows == 5 && parts_found.cols == 1);
    CHECK(memcmp(kinds.data, kinds_of, sizeof kinds_of) == 0);
    CHECK(memcmp(parts_found.data, parts_of, sizeof parts_of) == 0);
    const medax_view_f64 discs = medax_figure_circles(figure);
    NEED(discs.rows == 1 && discs.cols == 3);
    CHECK(memcmp(discs.data, circles, sizeof circles) == 0);
    CHECK(medax_figure_part_count(figure) == 5);
    CHECK_STATUS(OK, medax_figure_bounds(figure, min, max));
    CHECK(min[0] == 0 && min[1] == 0 && max[0] >= 52.5 && max[0] < 52.6 && max[1] == max[0]);
    counts.struct_size = sizeof counts;
    CHECK_STATUS(OK, medax_figure_normalised(figure, &counts));
    CHECK(counts.closing_vertices == 1 && counts.repeated_vertices == 1);
    CHECK(counts.turned_rings == 2 && counts.crossings == 0 && counts.misplaced == 0);
    CHECK_STATUS(NULL_ARGUMENT, medax_figure_normalised(NULL, &counts));
    CHECK_STATUS(NULL_ARGUMENT, medax_figure_normalised(figure, NULL));
    counts.struct_size = 8;
    CHECK_STATUS(INVALID_ARGUMENT, medax_figure_normalised(figure, &counts));
    CHECK_STATUS(NULL_ARGUMENT, medax_figure_bounds(NULL, min, max));
    CHECK_STATUS(NULL_ARGUMENT, medax_figure_bounds(figure, NULL, max));
    CHECK_STATUS(NULL_ARGUMENT, medax_figure_bounds(figure, min, NULL));
    const medax_figure *again = medax_figure_clone(figure);
    CHECK(again == figure);
    medax_figure_free(figure);
    CHECK(medax_figure_part_count(again) == 5);
    medax_figure_free(again);
}

/* What is wrong with the parts: status, element, index. */
static void refusals(void) {
    static const double bow[8] = {0, 0, 4, 4, 4, 0, 0, 4};
    static const double flat[8] = {0, 0, 1, 1, 2, 2, 3, 3}, bad_circle[3] = {0, 0, -1};
    static const uint32_t one[2] = {0, 4}, fall[3] = {0, 5, 4}, single[2] = {0, 1};
    double nan_points[4] = {1, 1, 1, 1};
    const medax_figure *figure = UNTOUCHED;
    nan_points[3] = strtod("nan", NULL);
    for (int i = 0; i < 13; ++i) {
        medax_figure_parts parts = all_parts();
        medax_status status = MEDAX_STATUS_INVALID_ARGUMENT;
        uint32_t kind = MEDAX_ERROR_KIND_NONE;
        uint64_t index = UINT64_MAX;
        switch (i) {
        case 0: parts.ring_vertices = NULL; status = MEDAX_STATUS_NULL_ARGUMENT; break;
        case 1: parts.ring_offsets = NULL; status = MEDAX_STATUS_NULL_ARGUMENT; break;
        case 2: parts.polygon_count = 0; status = MEDAX_STATUS_MISMATCH; break;
        case 3: parts.ring_vertex_count = 8; status = MEDAX_STATUS_MISMATCH; break;
        case 4: parts.ring_offsets = fall; kind = MEDAX_ERROR_KIND_ROW; index = 2; break;
        case 5: parts.crossings = 2; break;
        case 6: parts.reserved = 1; break;
        case 7: parts.struct_size = 8; break;
        case 8:
            parts.points = nan_points;
            status = MEDAX_STATUS_NON_FINITE;
            kind = MEDAX_ERROR_KIND_ROW;
            index = 1;
            break;
        case 9: parts.circles = bad_circle; kind = MEDAX_ERROR_KIND_CIRCLE; index = 0; break;
        case 10:
        case 11:
            parts.ring_vertices = i == 10 ? bow : flat;
            parts.ring_vertex_count = 4;
            parts.ring_offsets = one;
            parts.ring_count = 1;
            parts.polygon_offsets = single;
            if (i == 11) status = MEDAX_STATUS_DEGENERATE;
            kind = MEDAX_ERROR_KIND_RING;
            index = 0;
            break;
        default:
            parts.polyline_vertices = bow;
            kind = MEDAX_ERROR_KIND_RING;
            index = 0;
        }
        CHECK(medax_figure_create(&parts, NULL, &figure) == status);
        CHECK(medax_last_error_kind() == kind && medax_last_error_index() == index);
    }
    const medax_figure_parts parts = all_parts();
    CHECK_STATUS(NULL_ARGUMENT, medax_figure_create(NULL, NULL, &figure));
    CHECK_STATUS(NULL_ARGUMENT, medax_figure_create(&parts, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_figure_parts_init(NULL, sizeof parts));
    CHECK(figure == UNTOUCHED);
}

static void accepted(void) {
    static const double bow[8] = {0, 0, 4, 4, 4, 0, 0, 4};
    static const uint32_t one[2] = {0, 4}, single[2] = {0, 1};
    medax_figure_parts parts;
    medax_normalised counts;
    const medax_figure *figure = NULL;
    CHECK_STATUS(OK, medax_figure_parts_init(&parts, sizeof parts));
    CHECK_STATUS(TOO_FEW_POINTS, medax_figure_create(&parts, NULL, &figure));
    parts.ring_vertices = bow;
    parts.ring_vertex_count = 4;
    parts.ring_offsets = one;
    parts.ring_count = 1;
    parts.polygon_offsets = single;
    parts.polygon_count = 1;
    CHECK_STATUS(INVALID_ARGUMENT, medax_figure_create(&parts, NULL, &figure));
    CHECK(strstr(medax_last_error_message(), "at (2, 2)") != NULL);
    parts.crossings = MEDAX_CROSSINGS_ACCEPT;
    CHECK_STATUS(OK, medax_figure_create(&parts, NULL, &figure));
    NEED(figure != NULL);
    valid(figure);
    counts.struct_size = sizeof counts;
    CHECK_STATUS(OK, medax_figure_normalised(figure, &counts));
    CHECK(counts.crossings == 1);
    medax_figure_free(figure);
}

/* Writes a file beside the program. */
static void put(const char *path, const char *text) {
    FILE *file = fopen(path, "w");
    NEED(file != NULL);
    CHECK(fputs(text, file) >= 0);
    CHECK(fclose(file) == 0);
}

static void files(void) {
    static const char *path = "capi_figure.geojson";
    const medax_figure *figure = NULL;
    const medax_points *no_points = NULL;
    medax_figure_read_options options;
    put(path, "{\"type\":\"FeatureCollection\",\"features\":[\n"
              "{\"type\":\"Feature\",\"properties\":{\"name\":\"a\"},\"geometry\":"
              "{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[9,0],[0,9],[0,0]]]}},\n"
              "{\"type\":\"Feature\",\"properties\":{\"name\":\"b\",\"radius\":8},\"geometry\":"
              "{\"type\":\"Point\",\"coordinates\":[5,5]}}]}\n");
    CHECK_STATUS(INVALID_ARGUMENT, medax_figure_read(path, NULL, NULL, &figure));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_RING && medax_last_error_index() == 0);
    CHECK_STATUS(OK, medax_figure_read_options_init(&options, sizeof options));
    options.crossings = MEDAX_CROSSINGS_ACCEPT;
    CHECK_STATUS(OK, medax_figure_read(path, &options, NULL, &figure));
    CHECK(medax_figure_part_count(figure) == 2 && medax_figure_circles(figure).rows == 1);
    medax_figure_free(figure);
    options.crossings = MEDAX_CROSSINGS_REFUSE;
    options.feature_name = "a";
    CHECK_STATUS(OK, medax_figure_read(path, &options, NULL, &figure));
    CHECK(medax_figure_vertices(figure).rows == 3 && medax_figure_circles(figure).rows == 0);
    medax_figure_free(figure);
    options.feature_number = 1;
    CHECK_STATUS(INVALID_ARGUMENT, medax_figure_read(path, &options, NULL, &figure));
    options.feature_name = NULL;
    CHECK_STATUS(OK, medax_figure_read(path, &options, NULL, &figure));
    CHECK(medax_figure_vertices(figure).rows == 0 && medax_figure_circles(figure).rows == 1);
    valid(figure);
    medax_figure_free(figure);
    figure = UNTOUCHED;
    options.feature_number = 2;
    CHECK_STATUS(INVALID_ARGUMENT, medax_figure_read(path, &options, NULL, &figure));
    options.feature_number = MEDAX_NONE;
    options.feature_name = "c";
    CHECK_STATUS(INVALID_ARGUMENT, medax_figure_read(path, &options, NULL, &figure));
    options.feature_name = "\xff";
    CHECK_STATUS(INVALID_ARGUMENT, medax_figure_read(path, &options, NULL, &figure));
    CHECK_STATUS(NULL_ARGUMENT, medax_figure_read(NULL, NULL, NULL, &figure));
    CHECK_STATUS(NULL_ARGUMENT, medax_figure_read(path, NULL, NULL, NULL));
    CHECK_STATUS(UNSUPPORTED, medax_figure_read("a.ply", NULL, NULL, &figure));
    CHECK_STATUS(IO, medax_figure_read("no such file.geojson", NULL, NULL, &figure));
    CHECK_STATUS(UNSUPPORTED, medax_points_read(path, NULL, NULL, &no_points));
    put(path, "{\"type\":\n7}");
    CHECK_STATUS(FORMAT, medax_figure_read(path, NULL, NULL, &figure));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_LINE && medax_last_error_index() == 2);
    CHECK(figure == UNTOUCHED);
    remove(path);
}

static void null_is_nothing(void) {
    medax_validation report;
    report.struct_size = sizeof report;
    CHECK(medax_figure_vertices(NULL).rows == 0 && medax_figure_vertices(NULL).cols == 2);
    CHECK(medax_figure_chains(NULL).offsets == NULL && medax_figure_kinds(NULL).data == NULL);
    CHECK(medax_figure_parts_of_chains(NULL).rows == 0 && medax_figure_circles(NULL).cols == 3);
    CHECK(medax_figure_part_count(NULL) == 0 && medax_figure_clone(NULL) == NULL);
    CHECK_STATUS(NULL_ARGUMENT, medax_figure_validate(NULL, NULL, &report));
    medax_figure_free(NULL);
}

int main(void) {
    accessors();
    refusals();
    accepted();
    files();
    null_is_nothing();
    return check_end();
}
