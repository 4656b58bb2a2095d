/* Files: there and back, bad ones, warnings, NULL. */
#include "check.h"

static char directory[] = "medax_io_XXXXXX";
static const char nothing = 0;

/* A path in the test's directory; the text of the last four calls is kept. */
static const char *path(const char *name) {
    static char texts[4][128];
    static unsigned next;
    char *text = texts[next++ % 4];
    snprintf(text, sizeof texts[0], "%s/%s", directory, name);
    return text;
}

static const char *with_text(const char *name, const char *content) {
    const char *where = path(name);
    FILE *file = fopen(where, "wb");
    NEED(file != NULL);
    CHECK(fputs(content, file) >= 0);
    fclose(file);
    return where;
}

static const medax_complex *square(void) {
    static const double xyz[15] = {0, 0, 0, 1, 0, 0, 1, 1, 0.1, 0, 1, 0, 3, 3, 3};
    static const uint32_t offsets[2] = {0, 4}, ring[4] = {0, 1, 2, 3}, edge[2] = {2, 4};
    static const double radius[5] = {0.1, 0.2, 0.3, 0.4, 0.5};
    medax_complex_parts parts;
    medax_attribute attribute;
    const medax_complex *complex = NULL;
    medax_complex_parts_init(&parts, sizeof parts);
    memset(&attribute, 0, sizeof attribute);
    parts.vertices = xyz;
    parts.vertex_count = 5;
    parts.face_offsets = offsets;
    parts.face_indices = ring;
    parts.face_count = 1;
    parts.edges = edge;
    parts.edge_count = 1;
    attribute.name = "radius";
    attribute.element = MEDAX_ELEMENT_VERTEX;
    attribute.value_type = MEDAX_VALUE_TYPE_F64;
    attribute.f64_values.data = radius;
    attribute.f64_values.rows = 5;
    attribute.f64_values.cols = 1;
    parts.attributes = &attribute;
    parts.attribute_count = 1;
    CHECK_STATUS(OK, medax_complex_create(&parts, &complex));
    NEED(complex != NULL);
    return complex;
}

static void there_and_back(void) {
    const medax_complex *complex = square(), *again = NULL;
    const medax_warnings *warnings = NULL;
    medax_write_options options;
    medax_attribute attribute;
    CHECK_STATUS(NULL_ARGUMENT, medax_write_options_init(NULL, sizeof options));
    CHECK_STATUS(INVALID_ARGUMENT, medax_write_options_init(&options, 8));
    CHECK_STATUS(OK, medax_write_options_init(&options, sizeof options));
    for (uint32_t text = 0; text <= 1; ++text) {
        options.text = text;
        const char *ply = path("square.ply");
        CHECK_STATUS(OK, medax_complex_write(complex, ply, &options, NULL, NULL));
        CHECK_STATUS(OK, medax_complex_read(ply, NULL, &again));
        NEED(again != NULL);
        CHECK(medax_complex_vertices(again).rows == 5 && medax_complex_faces(again).rows == 1);
        CHECK(memcmp(medax_complex_vertices(again).data, medax_complex_vertices(complex).data,
                     15 * sizeof(double)) == 0);
        CHECK(medax_complex_edges(again).rows == 1);
        CHECK_STATUS(OK, medax_complex_attribute(again, MEDAX_ELEMENT_VERTEX, "radius", &attribute));
        CHECK(attribute.f64_values.rows == 5 && attribute.f64_values.data[4] == 0.5);
        medax_complex_free(again);
        again = NULL;

        const medax_file *file = NULL;
        CHECK_STATUS(OK, medax_file_read(ply, NULL, &file));
        CHECK_STATUS(OK, medax_file_attribute(file, MEDAX_ELEMENT_VERTEX, "radius", &attribute));
        CHECK(attribute.f64_values.rows == 5 && attribute.f64_values.data[4] == 0.5);
        const double *values = attribute.f64_values.data;
        CHECK(medax_file_attribute_count(file) >= 1);
        attribute.name = NULL;
        for (size_t i = 0; i < medax_file_attribute_count(file); ++i) {
            CHECK_STATUS(OK, medax_file_attribute_at(file, i, &attribute));
            if (strcmp(attribute.name, "radius") == 0) CHECK(attribute.f64_values.data == values);
        }
        attribute.name = NULL;
        CHECK_STATUS(INVALID_ARGUMENT, medax_file_attribute_at(file, SIZE_MAX, &attribute));
        CHECK_STATUS(INVALID_ARGUMENT, medax_file_attribute(file, 4, "radius", &attribute));
        CHECK_STATUS(INVALID_ARGUMENT, medax_file_attribute(file, 2, "radius", &attribute));
        CHECK_STATUS(NULL_ARGUMENT, medax_file_attribute(file, 0, NULL, &attribute));
        CHECK_STATUS(NULL_ARGUMENT, medax_file_attribute(file, 0, "radius", NULL));
        CHECK_STATUS(NULL_ARGUMENT, medax_file_attribute(NULL, 0, "radius", &attribute));
        CHECK_STATUS(NULL_ARGUMENT, medax_file_attribute_at(NULL, 0, &attribute));
        CHECK_STATUS(NULL_ARGUMENT, medax_file_attribute_at(file, 0, NULL));
        CHECK(attribute.name == NULL && medax_file_attribute_count(NULL) == 0);
        medax_file_free(file);
    }
    CHECK_STATUS(OK, medax_complex_write(complex, path("square.off"), NULL, NULL, &warnings));
    NEED(warnings != NULL);
    CHECK(medax_warnings_count(warnings) == 2);
    CHECK(strstr(medax_warnings_text(warnings, 0), "loose edges") != NULL);
    CHECK(strstr(medax_warnings_text(warnings, 1), "radius") != NULL);
    CHECK(strcmp(medax_warnings_text(warnings, 2), "") == 0);
    const medax_warnings *more = medax_warnings_clone(warnings);
    medax_warnings_free(warnings);
    CHECK(more == warnings && medax_warnings_count(more) == 2);
    medax_warnings_free(more);
    medax_complex_free(complex);
}

static void contents(void) {
    const char *off = with_text("mesh.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n9 9 9\n3 0 1 2\n");
    const medax_file *file = NULL;
    const medax_points *points = NULL, *read = NULL;
    const medax_complex *complex = NULL;
    const medax_warnings *warnings = NULL;
    CHECK_STATUS(OK, medax_file_read(off, NULL, &file));
    NEED(file != NULL);
    CHECK(medax_file_is_mesh(file) && medax_file_vertices(file).rows == 4);
    CHECK(medax_file_vertices(file).data[11] == 9 && medax_file_edges(file).rows == 0);
    CHECK(medax_file_faces(file).rows == 1 && medax_file_faces(file).offsets[1] == 3);
    CHECK_STATUS(OK, medax_file_warnings(file, &warnings));
    CHECK(warnings != NULL && medax_warnings_count(warnings) == 0);
    medax_warnings_free(warnings);

    /* Of a mesh only the used vertices are points; the complex has all. */
    CHECK_STATUS(OK, medax_file_points(file, NULL, NULL, &points));
    CHECK(medax_points_count(points) == 3 && medax_points_row_count(points) == 4);
    CHECK(medax_points_vertex_of_row(points).data[3] == MEDAX_NONE);
    CHECK_STATUS(OK, medax_points_read(off, NULL, NULL, &read));
    CHECK(medax_points_count(read) == 3);
    CHECK_STATUS(OK, medax_file_complex(file, NULL, &complex));
    const medax_file *more = medax_file_clone(file);
    medax_file_free(file);
    CHECK(more == file && medax_file_vertices(more).data[3] == 1);
    medax_file_free(more);
    CHECK(medax_complex_vertices(complex).rows == 4);

    CHECK_STATUS(OK, medax_points_write(points, path("points.xyz"), NULL, NULL, NULL));
    medax_points_free(read);
    CHECK_STATUS(OK, medax_points_read(path("points.xyz"), NULL, NULL, &read));
    CHECK(medax_points_count(read) == 3);
    CHECK(memcmp(medax_points_coords(read).data, medax_points_coords(points).data, 72) == 0);
    medax_complex_free(complex);
    medax_points_free(read);
    medax_points_free(points);
}

static void bad_files(void) {
    const medax_points *points = (const medax_points *)(const void *)&nothing;
    const medax_complex *complex = (const medax_complex *)(const void *)&nothing;
    const medax_file *file = (const medax_file *)(const void *)&nothing;
    medax_points_options options;
    static const char huge[] =
        "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n"
        "property double x\nproperty double y\nproperty double z\nend_header\n";
    CHECK_STATUS(IO, medax_file_read(path("missing.ply"), NULL, &file));
    CHECK_STATUS(UNSUPPORTED, medax_file_read(path("a.step"), NULL, &file));
    CHECK_STATUS(FORMAT, medax_points_read(with_text("empty.ply", ""), NULL, NULL, &points));
    CHECK_STATUS(FORMAT, medax_points_read(with_text("huge.ply", huge), NULL, NULL, &points));
    CHECK_STATUS(FORMAT, medax_complex_read(with_text("word.off", "OFF\n1 0 0\n\n0 zero 1.0\n"),
                                            NULL, &complex));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_LINE && medax_last_error_index() == 4);
    const char *nan = with_text("nan.xyz", "0 0 0\n1 nan 0\n2 0 0\n");
    CHECK_STATUS(NON_FINITE, medax_points_read(nan, NULL, NULL, &points));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 1);
    CHECK_STATUS(NON_FINITE, medax_complex_read(nan, NULL, &complex));
    CHECK(points == (const void *)&nothing && complex == (const void *)&nothing);
    CHECK(file == (const void *)&nothing);
    medax_points_options_init(&options, sizeof options);
    options.skip_non_finite = 1;
    CHECK_STATUS(OK, medax_points_read(nan, &options, NULL, &points));
    CHECK(medax_points_count(points) == 2 && medax_points_skipped_count(points) == 1);
    medax_points_free(points);
}

static void refusals(void) {
    const medax_complex *complex = square();
    const medax_points *points = NULL;
    const medax_file *file = NULL;
    const medax_warnings *warnings = NULL;
    const medax_job *spent = NULL;
    medax_write_options options;
    const char *xyz = with_text("one.xyz", "1 2 3\n");
    NEED(medax_job_create(NULL, &spent) == MEDAX_STATUS_OK);
    medax_job_cancel(spent);
    CHECK_STATUS(NULL_ARGUMENT, medax_file_read(NULL, NULL, &file));
    CHECK_STATUS(NULL_ARGUMENT, medax_file_read(xyz, NULL, NULL));
    CHECK_STATUS(INVALID_ARGUMENT, medax_file_read("\xff.ply", NULL, &file));
    CHECK_STATUS(CANCELLED, medax_file_read(xyz, spent, &file));
    CHECK_STATUS(NULL_ARGUMENT, medax_points_read(NULL, NULL, NULL, &points));
    CHECK_STATUS(NULL_ARGUMENT, medax_points_read(xyz, NULL, NULL, NULL));
    CHECK_STATUS(CANCELLED, medax_points_read(xyz, NULL, spent, &points));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_read(NULL, NULL, &complex));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_read(xyz, NULL, NULL));
    CHECK_STATUS(CANCELLED, medax_complex_read(xyz, spent, &complex));
    CHECK_STATUS(OK, medax_file_read(xyz, NULL, &file));
    CHECK(!medax_file_is_mesh(file));
    CHECK_STATUS(NULL_ARGUMENT, medax_file_points(NULL, NULL, NULL, &points));
    CHECK_STATUS(NULL_ARGUMENT, medax_file_points(file, NULL, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_file_complex(NULL, NULL, &complex));
    CHECK_STATUS(NULL_ARGUMENT, medax_file_complex(file, NULL, NULL));
    CHECK_STATUS(CANCELLED, medax_file_complex(file, spent, &complex));
    CHECK_STATUS(NULL_ARGUMENT, medax_file_warnings(NULL, &warnings));
    CHECK_STATUS(NULL_ARGUMENT, medax_file_warnings(file, NULL));
    CHECK(!medax_file_is_mesh(NULL) && medax_file_vertices(NULL).rows == 0);
    CHECK(medax_file_faces(NULL).rows == 0 && medax_file_edges(NULL).rows == 0);
    CHECK(medax_file_clone(NULL) == NULL && medax_warnings_clone(NULL) == NULL);
    CHECK(medax_warnings_count(NULL) == 0 && *medax_warnings_text(NULL, 0) == 0);
    medax_file_free(NULL);
    medax_warnings_free(NULL);

    /* A failed write leaves what was there, and nothing beside it. */
    medax_write_options_init(&options, sizeof options);
    options.text = 2;
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_write(complex, xyz, &options, NULL, &warnings));
    options.text = 0;
    options.reserved = 1;
    CHECK_STATUS(INVALID_ARGUMENT, medax_complex_write(complex, xyz, &options, NULL, &warnings));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_write(NULL, xyz, NULL, NULL, &warnings));
    CHECK_STATUS(NULL_ARGUMENT, medax_complex_write(complex, NULL, NULL, NULL, &warnings));
    CHECK_STATUS(CANCELLED, medax_complex_write(complex, xyz, NULL, spent, &warnings));
    CHECK_STATUS(UNSUPPORTED, medax_complex_write(complex, path("a.pwn"), NULL, NULL, &warnings));
    CHECK_STATUS(UNSUPPORTED, medax_complex_write(complex, "noending", NULL, NULL, &warnings));
    CHECK_STATUS(IO, medax_complex_write(complex, path("no/where.ply"), NULL, NULL, &warnings));
    CHECK_STATUS(OK, medax_points_read(xyz, NULL, NULL, &points));
    CHECK_STATUS(NULL_ARGUMENT, medax_points_write(NULL, xyz, NULL, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_points_write(points, NULL, NULL, NULL, NULL));
    CHECK_STATUS(CANCELLED, medax_points_write(points, xyz, NULL, spent, NULL));
    CHECK(medax_points_count(points) == 1 && warnings == NULL);
    medax_points_free(points);
    medax_file_free(file);
    medax_complex_free(complex);
    medax_job_free(spent);
}

int main(void) {
    static const char *const made[] = {"square.ply", "square.off", "mesh.off", "points.xyz",
                                       "empty.ply", "huge.ply", "word.off", "nan.xyz", "one.xyz"};
    NEED(mkdtemp(directory) != NULL);
    there_and_back();
    contents();
    bad_files();
    refusals();
    for (size_t i = 0; i < sizeof made / sizeof *made; ++i) CHECK(remove(path(made[i])) == 0);
    /* Nothing else is left: the directory is empty. */
    CHECK(remove(directory) == 0);
    return check_end();
}
