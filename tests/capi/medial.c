/* Medial axes straight from Voronoi diagrams. */
#include "torus.h"

static const char nothing = 0;
#define UNTOUCHED ((const medax_medial *)(const void *)&nothing)
#define NO_COMPLEX ((const medax_complex *)(const void *)&nothing)

static const double pi = 3.14159265358979323846;

static const medax_medial *built(const torus *made, const medax_medial_options *options) {
    const medax_medial *medial = NULL;
    CHECK_STATUS(OK, medax_medial_build(made->dual, made->labels, options, NULL, &medial));
    NEED(medial != NULL);
    return medial;
}

static medax_medial_filter defaults(void) {
    medax_medial_filter filter;
    CHECK_STATUS(OK, medax_medial_filter_init(&filter, sizeof filter));
    return filter;
}

/* The facets that pass, for the caller to free. */
static uint32_t *selected(const medax_medial *medial, const medax_medial_filter *filter, size_t *count) {
    const size_t facets = medax_medial_sines(medial).rows;
    uint32_t *found = malloc((facets + 1) * sizeof *found);
    NEED(found != NULL);
    *count = facets + 1;
    CHECK_STATUS(OK, medax_medial_selected(medial, filter, NULL, facets, found, count));
    NEED(*count <= facets);
    return found;
}

static size_t count_of(const medax_medial *medial, const medax_medial_filter *filter) {
    size_t count = 0;
    CHECK_STATUS(OK, medax_medial_selected(medial, filter, NULL, 0, NULL, &count));
    return count;
}

static void initial(void) {
    medax_medial_options options;
    medax_medial_filter filter = defaults();
    CHECK(filter.struct_size == sizeof filter && fabs(filter.theta - pi / 8) < 1e-15);
    CHECK(filter.rho == 8 && filter.object_angle == 0 && filter.lambda == 0 && filter.scale == 0);
    CHECK(filter.rule == MEDAX_MEDIAL_RULE_ANGLE_OR_RATIO && filter.side == MEDAX_SIDE_INNER);
    CHECK(filter.has_clip == 0 && filter.reserved == 0);
    CHECK_STATUS(OK, medax_medial_options_init(&options, sizeof options));
    CHECK(options.normals == NULL && options.normal_count == 0 && options.scales == 0);
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_filter_init(NULL, sizeof filter));
    CHECK_STATUS(INVALID_ARGUMENT, medax_medial_filter_init(&filter, sizeof filter - 8));
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_options_init(NULL, sizeof options));
    CHECK_STATUS(INVALID_ARGUMENT, medax_medial_options_init(&options, 8));
}

static void null_is_nothing(void) {
    const medax_dual *dual = NULL;
    const medax_labels *labels = NULL;
    const medax_complex *complex = NO_COMPLEX;
    size_t count = 99;
    medax_validation report;
    report.struct_size = sizeof report;
    CHECK(medax_medial_sines(NULL).rows == 0 && medax_medial_sines(NULL).cols == 2);
    CHECK(medax_medial_ratios(NULL).data == NULL && medax_medial_reaches(NULL).cols == 2);
    CHECK(medax_medial_least_cell(NULL).rows == 0 && medax_medial_scales(NULL).rows == 0);
    CHECK(medax_medial_umbrella_offsets(NULL).rows == 0);
    CHECK(medax_medial_umbrella_rims(NULL).cols == 2);
    CHECK(medax_medial_umbrella_is_disk(NULL).data == NULL && medax_medial_torn_count(NULL) == 0);
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_dual(NULL, &dual));
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_labels(NULL, &labels));
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_axis(NULL, NULL, NULL, &complex));
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_selected(NULL, NULL, NULL, 0, NULL, &count));
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_validate(NULL, NULL, &report));
    CHECK(medax_medial_clone(NULL) == NULL && dual == NULL && labels == NULL);
    CHECK(complex == NO_COMPLEX && count == 99);
    medax_medial_free(NULL);
}

static void refused_builds(const torus *made) {
    const medax_points *cloud = check_points(30);
    const medax_triangulation *of_cloud = NULL, *regular = NULL;
    const medax_dual *plain = NULL, *power = NULL, *other = NULL;
    const medax_medial *medial = UNTOUCHED;
    const medax_job *spent = NULL;
    medax_dual_options with_facets;
    medax_medial_options options;
    double weights[30], bad[6] = {1, 0, 0, 0, strtod("nan", NULL), 0};
    for (size_t i = 0; i < 30; ++i) weights[i] = (double)i / 1e4;
    medax_dual_options_init(&with_facets, sizeof with_facets);
    with_facets.facets = 1;
    CHECK_STATUS(OK, medax_delaunay_build(cloud, NULL, NULL, &of_cloud));
    CHECK_STATUS(OK, medax_regular_build(cloud, weights, 30, NULL, NULL, &regular));
    CHECK_STATUS(OK, medax_dual_build(made->t, NULL, NULL, &plain));
    CHECK_STATUS(OK, medax_dual_build(regular, &with_facets, NULL, &power));
    CHECK_STATUS(OK, medax_dual_build(of_cloud, &with_facets, NULL, &other));
    CHECK_STATUS(OK, medax_job_create(NULL, &spent));
    medax_job_cancel(spent);
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_build(NULL, NULL, NULL, NULL, &medial));
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_build(made->dual, NULL, NULL, NULL, NULL));
    CHECK_STATUS(INVALID_ARGUMENT, medax_medial_build(plain, NULL, NULL, NULL, &medial));
    CHECK_STATUS(INVALID_ARGUMENT, medax_medial_build(power, NULL, NULL, NULL, &medial));
    CHECK_STATUS(MISMATCH, medax_medial_build(other, made->labels, NULL, NULL, &medial));
    CHECK_STATUS(CANCELLED, medax_medial_build(made->dual, NULL, NULL, spent, &medial));
    medax_medial_options_init(&options, sizeof options);
    options.scales = 2;
    CHECK_STATUS(INVALID_ARGUMENT, medax_medial_build(made->dual, NULL, &options, NULL, &medial));
    options.scales = 0;
    options.reserved = 1;
    CHECK_STATUS(INVALID_ARGUMENT, medax_medial_build(made->dual, NULL, &options, NULL, &medial));
    options.reserved = 0;
    options.normal_count = 2;
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_build(made->dual, NULL, &options, NULL, &medial));
    options.normals = bad;
    CHECK_STATUS(MISMATCH, medax_medial_build(made->dual, NULL, &options, NULL, &medial));
    options.normal_count = 0;
    CHECK_STATUS(MISMATCH, medax_medial_build(made->dual, NULL, &options, NULL, &medial));
    options.normal_count = SIZE_MAX;
    CHECK_STATUS(INVALID_ARGUMENT, medax_medial_build(made->dual, NULL, &options, NULL, &medial));
    double *normals = check_cloud(30);
    NEED(normals != NULL);
    normals[3 * 17 + 1] = bad[4];
    options.normals = normals;
    options.normal_count = 30;
    CHECK_STATUS(INVALID_ARGUMENT, medax_medial_build(other, NULL, &options, NULL, &medial));
    CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_VERTEX && medax_last_error_index() == 17);
    options.struct_size = 8;
    CHECK_STATUS(INVALID_ARGUMENT, medax_medial_build(other, NULL, &options, NULL, &medial));
    CHECK(medial == UNTOUCHED);
    free(normals);
    medax_job_free(spent);
    medax_dual_free(other);
    medax_dual_free(power);
    medax_dual_free(plain);
    medax_triangulation_free(regular);
    medax_triangulation_free(of_cloud);
    medax_points_free(cloud);
}

static void refused_filters(const torus *made) {
    const double nan = strtod("nan", NULL);
    const medax_medial *medial = built(made, NULL), *bare = NULL;
    const medax_complex *axis = NO_COMPLEX;
    const medax_job *spent = NULL;
    uint32_t facet = 77;
    size_t count = 99;
    CHECK_STATUS(OK, medax_medial_build(made->dual, NULL, NULL, NULL, &bare));
    CHECK_STATUS(OK, medax_job_create(NULL, &spent));
    medax_job_cancel(spent);
    medax_medial_filter wrong[16];
    size_t wrongs = 0;
    for (size_t i = 0; i < 16; ++i) wrong[i] = defaults();
    wrong[wrongs++].theta = pi / 2 + 1e-9;
    wrong[wrongs++].theta = -1e-9;
    wrong[wrongs++].theta = nan;
    wrong[wrongs++].rho = -1;
    wrong[wrongs++].rho = nan;
    wrong[wrongs++].object_angle = 3.2;
    wrong[wrongs++].lambda = -1;
    wrong[wrongs++].scale = -1;
    wrong[wrongs++].scale = 1.5; /* Scales were not calculated. */
    wrong[wrongs++].rule = 4;
    wrong[wrongs++].side = 3;
    wrong[wrongs++].has_clip = 2;
    wrong[wrongs++].has_clip = 1; /* An empty box. */
    wrong[wrongs++].reserved = 1;
    wrong[wrongs++].struct_size = 3;
    for (size_t i = 0; i < wrongs; ++i) {
        CHECK_STATUS(INVALID_ARGUMENT, medax_medial_axis(medial, wrong + i, NULL, &axis));
        CHECK_STATUS(INVALID_ARGUMENT,
                     medax_medial_selected(medial, wrong + i, NULL, 1, &facet, &count));
    }
    /* Without labels there is no inner axis. */
    CHECK_STATUS(INVALID_ARGUMENT, medax_medial_axis(bare, NULL, NULL, &axis));
    CHECK_STATUS(INVALID_ARGUMENT, medax_medial_selected(bare, NULL, NULL, 1, &facet, &count));
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_axis(medial, NULL, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_selected(medial, NULL, NULL, 1, NULL, &count));
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_selected(medial, NULL, NULL, 1, &facet, NULL));
    CHECK_STATUS(CANCELLED, medax_medial_axis(medial, NULL, spent, &axis));
    CHECK_STATUS(CANCELLED, medax_medial_selected(medial, NULL, spent, 1, &facet, &count));
    CHECK(axis == NO_COMPLEX && facet == 77 && count == 99);
    medax_job_free(spent);
    medax_medial_free(bare);
    medax_medial_free(medial);
}

static void views(const torus *made) {
    const medax_medial *medial = NULL, *bare = NULL;
    const medax_job *job = NULL;
    const char *stage = NULL;
    const medax_dual *dual = NULL;
    const medax_labels *labels = made->labels;
    medax_validation report;
    const size_t cells = medax_triangulation_cells(made->t).rows;
    const size_t samples = medax_triangulation_coords(made->t).rows;
    const size_t facets = medax_dual_facets(made->dual).rows;
    CHECK_STATUS(OK, medax_job_create(NULL, &job));
    CHECK_STATUS(OK, medax_medial_build(made->dual, made->labels, NULL, job, &medial));
    CHECK_STATUS(OK, medax_medial_build(made->dual, NULL, NULL, job, &bare));
    NEED(medial != NULL && bare != NULL);
    CHECK_STATUS(OK, medax_job_stage_time(job, 0, &stage, NULL, NULL));
    CHECK(strcmp(stage, "medial") == 0 && medax_job_stage_count(job) >= 2);
    const medax_view_f64 sines = medax_medial_sines(medial), ratios = medax_medial_ratios(medial);
    const medax_view_f64 reaches = medax_medial_reaches(medial);
    const medax_view_u32 least = medax_medial_least_cell(medial);
    const medax_view_u32 offsets = medax_medial_umbrella_offsets(medial);
    const medax_view_u32 rims = medax_medial_umbrella_rims(medial);
    const medax_view_u8 is_disk = medax_medial_umbrella_is_disk(medial);
    NEED(sines.rows == facets && sines.cols == 2 && ratios.rows == facets && ratios.cols == 2);
    NEED(reaches.rows == facets && reaches.cols == 2 && least.rows == cells && least.cols == 1);
    NEED(offsets.rows == samples + 1 && offsets.cols == 1 && offsets.data[0] == 0);
    NEED(rims.rows == offsets.data[samples] && rims.cols == 2 && is_disk.rows == samples);
    CHECK(medax_medial_scales(medial).rows == 0);
    const medax_view_u32 rays = medax_dual_facet_rays(made->dual);
    for (size_t f = 0; f < facets; ++f) {
        for (size_t i = 2 * f; i < 2 * f + 2; ++i) {
            CHECK((sines.data[i] >= 0 && sines.data[i] <= 1) || sines.data[i] == -HUGE_VAL);
            CHECK((sines.data[i] == -HUGE_VAL) == (ratios.data[i] == -HUGE_VAL));
        }
        CHECK(reaches.data[2 * f] >= 0 && reaches.data[2 * f] <= reaches.data[2 * f + 1]);
        CHECK((reaches.data[2 * f + 1] == HUGE_VAL) == (rays.data[2 * f] != MEDAX_NONE));
    }
    for (size_t c = 0; c < cells; ++c) CHECK(least.data[c] <= c);
    size_t torn = 0;
    for (size_t v = 0; v < samples; ++v) {
        const uint32_t begin = offsets.data[v], end = offsets.data[v + 1];
        torn += is_disk.data[v] == 0;
        for (uint32_t i = begin; is_disk.data[v] == 1 && i < end; ++i)
            CHECK(rims.data[2 * i + 1] == rims.data[2 * (i + 1 < end ? i + 1 : begin)]);
    }
    CHECK(torn == medax_medial_torn_count(medial) && torn < samples / 10);

    report.struct_size = sizeof report;
    CHECK_STATUS(OK, medax_medial_validate(medial, NULL, &report));
    CHECK(report.problems == 0 && report.checked > 0);
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_validate(medial, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_dual(medial, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_medial_labels(medial, NULL));
    CHECK_STATUS(OK, medax_medial_dual(medial, &dual));
    CHECK(medax_dual_centers(dual).data == medax_dual_centers(made->dual).data);
    CHECK_STATUS(OK, medax_medial_labels(bare, &labels));
    CHECK(labels == NULL);
    CHECK_STATUS(OK, medax_medial_labels(medial, &labels));
    CHECK(medax_labels_is_inner(labels).data == medax_labels_is_inner(made->labels).data);
    medax_labels_free(labels);
    medax_dual_free(dual);
    medax_job_free(job);
    medax_medial_free(bare);
    medax_medial_free(medial);
}

/* Whether every cell of the ring is inner, of a facet that is bounded. */
static int is_inside(const torus *made, size_t facet) {
    const medax_view_rows facets = medax_dual_facets(made->dual);
    const uint8_t *is_inner = medax_labels_is_inner(made->labels).data;
    if (medax_dual_facet_rays(made->dual).data[2 * facet] != MEDAX_NONE) return 0;
    for (uint32_t i = facets.offsets[facet]; i < facets.offsets[facet + 1]; ++i)
        if (!is_inner[facets.indices[i]]) return 0;
    return 1;
}

/* What passes is what the thresholds on the views say. */
static void by_hand(const torus *made) {
    const medax_medial *medial = built(made, NULL);
    const medax_view_f64 sines = medax_medial_sines(medial), ratios = medax_medial_ratios(medial);
    medax_medial_filter filter = defaults();
    for (uint32_t rule = 0; rule < 4; ++rule) {
        size_t count = 0, next = 0;
        filter.rule = rule;
        filter.rho = rule == 0 ? 8 : 4;
        uint32_t *found = selected(medial, rule == 0 ? NULL : &filter, &count);
        for (size_t f = 0; f < sines.rows; ++f) {
            const double *s = sines.data + 2 * f, *r = ratios.data + 2 * f;
            const int angle = fmax(s[0], s[1]) > sin(filter.theta);
            const int ratio = fmax(r[0], r[1]) > filter.rho;
            const int passes = rule == MEDAX_MEDIAL_RULE_ANGLE_OR_RATIO ? angle || ratio
                               : rule == MEDAX_MEDIAL_RULE_ANGLE        ? angle
                               : rule == MEDAX_MEDIAL_RULE_RATIO        ? ratio
                                                                        : 1;
            if (passes && is_inside(made, f)) CHECK(next < count && found[next++] == f);
        }
        CHECK(next == count && count > 0);
        /* A buffer that is too short is filled, and the count is told. */
        uint32_t few[3] = {77, 77, 77};
        CHECK_STATUS(OK, medax_medial_selected(medial, &filter, NULL, 2, few, &next));
        CHECK(next == count && few[0] == found[0] && few[1] == found[1] && few[2] == 77);
        free(found);
    }
    filter.side = MEDAX_SIDE_BOTH;
    CHECK(count_of(medial, &filter) == sines.rows);
    filter = defaults();
    filter.side = MEDAX_SIDE_BOTH;
    const size_t both = count_of(medial, &filter);
    filter.side = MEDAX_SIDE_OUTER;
    const size_t outer = count_of(medial, &filter);
    CHECK(outer > 0 && count_of(medial, NULL) + outer <= both);
    filter.side = MEDAX_SIDE_INNER;
    filter.lambda = 0.3;
    CHECK(count_of(medial, &filter) < count_of(medial, NULL));
    filter.lambda = 0;
    filter.object_angle = 3;
    CHECK(count_of(medial, &filter) < count_of(medial, NULL));
    medax_medial_free(medial);
}

/* Moving the thresholds gives what a fresh build gives. */
static void a_slider(const torus *made) {
    const medax_medial *medial = built(made, NULL);
    medax_medial_filter filter = defaults();
    size_t before = SIZE_MAX;
    for (int step = 0; step < 4; ++step) {
        const medax_medial *fresh = built(made, NULL);
        const medax_complex *moved = NULL, *anew = NULL;
        size_t count = 0, again = 0;
        filter.theta = 0.1 + 0.3 * step;
        filter.rho = 2 + 3 * step;
        uint32_t *found = selected(medial, &filter, &count);
        uint32_t *expected = selected(fresh, &filter, &again);
        CHECK(count == again && memcmp(found, expected, count * sizeof *found) == 0);
        CHECK(count <= before && count > 0);
        before = count;
        CHECK_STATUS(OK, medax_medial_axis(medial, &filter, NULL, &moved));
        CHECK_STATUS(OK, medax_medial_axis(fresh, &filter, NULL, &anew));
        const medax_view_f64 a = medax_complex_vertices(moved), b = medax_complex_vertices(anew);
        const medax_view_rows p = medax_complex_faces(moved), q = medax_complex_faces(anew);
        NEED(a.rows == b.rows && p.rows == q.rows && p.rows > 0);
        CHECK(memcmp(a.data, b.data, 3 * a.rows * sizeof *a.data) == 0);
        CHECK(memcmp(p.offsets, q.offsets, (p.rows + 1) * sizeof *p.offsets) == 0);
        CHECK(memcmp(p.indices, q.indices, p.offsets[p.rows] * sizeof *p.indices) == 0);
        medax_complex_free(moved);
        medax_complex_free(anew);
        free(found);
        free(expected);
        medax_medial_free(fresh);
    }
    medax_medial_free(medial);
}

static void an_axis(const torus *made) {
    const medax_medial *medial = built(made, NULL);
    const medax_complex *axis = NULL;
    medax_attribute absent;
    medax_validation report;
    size_t count = 0, next = 0;
    uint32_t *found = selected(medial, NULL, &count);
    CHECK_STATUS(OK, medax_medial_axis(medial, NULL, NULL, &axis));
    NEED(axis != NULL);
    const size_t faces = medax_complex_faces(axis).rows;
    const medax_view_f64 vertices = medax_complex_vertices(axis);
    const medax_view_u32 cell = attribute(axis, MEDAX_ELEMENT_VERTEX, "cell").u32_values;
    const medax_view_f64 radius = attribute(axis, MEDAX_ELEMENT_VERTEX, "radius").f64_values;
    const medax_view_u32 facet = attribute(axis, MEDAX_ELEMENT_FACE, "facet").u32_values;
    const medax_view_u32 ends = attribute(axis, MEDAX_ELEMENT_FACE, "samples").u32_values;
    const medax_view_u32 condition = attribute(axis, MEDAX_ELEMENT_FACE, "condition").u32_values;
    const medax_view_u32 side = attribute(axis, MEDAX_ELEMENT_FACE, "side").u32_values;
    const medax_view_f64 angle = attribute(axis, MEDAX_ELEMENT_FACE, "object_angle").f64_values;
    const medax_view_f64 lambda = attribute(axis, MEDAX_ELEMENT_FACE, "lambda").f64_values;
    NEED(faces > 0 && faces <= count && vertices.rows > 0);
    NEED(cell.rows == vertices.rows && radius.rows == vertices.rows && facet.rows == faces);
    NEED(ends.rows == faces && ends.cols == 2 && condition.rows == faces && side.rows == faces);
    NEED(angle.rows == faces && angle.cols == 2 && lambda.rows == faces);
    CHECK_STATUS(INVALID_ARGUMENT,
                 medax_complex_attribute(axis, MEDAX_ELEMENT_VERTEX, "scale", &absent));
    const medax_view_f64 centers = medax_dual_centers(made->dual);
    const medax_view_f64 squares = medax_dual_radii_squared(made->dual);
    const medax_view_u32 edges = medax_dual_facet_edges(made->dual);
    const medax_view_f64 coords = medax_triangulation_coords(made->t);
    for (size_t v = 0; v < vertices.rows; ++v) {
        const double *p = vertices.data + 3 * v;
        NEED(cell.data[v] < centers.rows);
        CHECK(memcmp(p, centers.data + 3 * cell.data[v], 3 * sizeof *p) == 0);
        CHECK(radius.data[v] == sqrt(squares.data[cell.data[v]]));
        /* The core circle is the axis of the solid. */
        CHECK(fabs(sqrt(p[0] * p[0] + p[1] * p[1]) - 1) < 0.2 && fabs(p[2]) < 0.2);
    }
    for (size_t f = 0; f < faces; ++f) {
        while (next < count && found[next] != facet.data[f]) ++next;
        NEED(next < count);
        const uint32_t *e = ends.data + 2 * f;
        CHECK(memcmp(e, edges.data + 2 * facet.data[f], 2 * sizeof *e) == 0);
        double square = 0;
        for (size_t k = 0; k < 3; ++k) {
            const double d = coords.data[3 * e[0] + k] - coords.data[3 * e[1] + k];
            square += d * d;
        }
        CHECK(fabs(lambda.data[f] - sqrt(square) / 2) < 1e-12);
        CHECK(condition.data[f] >= 1 && condition.data[f] <= 3);
        CHECK(side.data[f] == MEDAX_SIDE_INNER);
        CHECK(angle.data[2 * f] >= 0 && angle.data[2 * f] <= angle.data[2 * f + 1]);
        CHECK(angle.data[2 * f + 1] <= pi + 1e-15);
    }
    report.struct_size = sizeof report;
    CHECK_STATUS(OK, medax_complex_validate(axis, NULL, &report));
    CHECK(report.problems == 0);
    free(found);
    medax_medial_free(medial);
    CHECK(medax_complex_vertices(axis).data == vertices.data);
    medax_complex_free(axis);
}

/* A box that holds all of an axis leaves it as it is; what is no box is refused. */
static void a_box(const torus *made) {
    const medax_medial *medial = built(made, NULL);
    const medax_complex *whole = NULL, *clipped = NULL;
    medax_medial_filter filter = defaults();
    filter.has_clip = 1;
    for (size_t k = 0; k < 3; ++k) {
        filter.clip_min[k] = -9;
        filter.clip_max[k] = 9;
    }
    CHECK_STATUS(OK, medax_medial_axis(medial, NULL, NULL, &whole));
    CHECK_STATUS(OK, medax_medial_axis(medial, &filter, NULL, &clipped));
    CHECK(medax_complex_faces(clipped).rows == medax_complex_faces(whole).rows);
    CHECK(medax_complex_vertices(clipped).rows == medax_complex_vertices(whole).rows);
    medax_complex_free(clipped);
    medax_complex_free(whole);
    clipped = NULL;

    /* With a box unbounded facets are there too, as far as the box goes. */
    filter.side = MEDAX_SIDE_BOTH;
    filter.rule = MEDAX_MEDIAL_RULE_EVERY;
    CHECK_STATUS(OK, medax_medial_axis(medial, &filter, NULL, &clipped));
    const medax_view_u32 facet = attribute(clipped, MEDAX_ELEMENT_FACE, "facet").u32_values;
    const medax_view_u32 rays = medax_dual_facet_rays(made->dual);
    size_t unbounded = 0;
    for (size_t f = 0; f < facet.rows; ++f) unbounded += rays.data[2 * facet.data[f]] != MEDAX_NONE;
    CHECK(unbounded > 0 && unbounded < facet.rows);
    const medax_view_f64 vertices = medax_complex_vertices(clipped);
    const medax_view_u32 cell = attribute(clipped, MEDAX_ELEMENT_VERTEX, "cell").u32_values;
    size_t cut = 0;
    for (size_t i = 0; i < 3 * vertices.rows; ++i) CHECK(fabs(vertices.data[i]) < 9 + 1e-9);
    for (size_t v = 0; v < vertices.rows; ++v) cut += cell.data[v] == MEDAX_NONE;
    CHECK(cut > 0 && cut < vertices.rows);
    medax_complex_free(clipped);
    clipped = NO_COMPLEX;
    filter.clip_min[1] = 10;
    CHECK_STATUS(INVALID_ARGUMENT, medax_medial_axis(medial, &filter, NULL, &clipped));
    filter.clip_min[1] = -HUGE_VAL;
    CHECK_STATUS(INVALID_ARGUMENT, medax_medial_axis(medial, &filter, NULL, &clipped));
    filter.clip_min[1] = -ldexp(1.25, 200);
    CHECK_STATUS(COORDINATE_RANGE, medax_medial_axis(medial, &filter, NULL, &clipped));
    filter.clip_min[1] = -ldexp(1, 200);
    CHECK_STATUS(OK, medax_medial_axis(medial, &filter, NULL, &clipped));
    medax_complex_free(clipped);
    clipped = NO_COMPLEX;
    CHECK(clipped == NO_COMPLEX);
    medax_medial_free(medial);
}

static void scales(const torus *made) {
    medax_medial_options options;
    medax_medial_filter filter = defaults();
    const medax_complex *axis = NULL;
    medax_medial_options_init(&options, sizeof options);
    options.scales = 1;
    const medax_medial *medial = built(made, &options);
    const medax_view_f64 values = medax_medial_scales(medial);
    NEED(values.rows == medax_triangulation_cells(made->t).rows && values.cols == 1);
    size_t largest = 0;
    for (size_t c = 0; c < values.rows; ++c) {
        /* No ball covers another as they are: none has a sample inside, and each has some on it. */
        CHECK(values.data[c] > 0.999);
        largest += values.data[c] == HUGE_VAL;
    }
    CHECK(largest >= 2 && largest < values.rows / 10);
    const size_t all = count_of(medial, &filter);
    filter.scale = 4;
    CHECK(count_of(medial, &filter) < all);
    CHECK_STATUS(OK, medax_medial_axis(medial, &filter, NULL, &axis));
    CHECK(attribute(axis, MEDAX_ELEMENT_VERTEX, "scale").f64_values.rows
          == medax_complex_vertices(axis).rows);
    medax_complex_free(axis);
    medax_medial_free(medial);
}

/* The exact normals of the samples in place of their poles: nearly the same axis. */
static void normals(const torus *made) {
    const medax_view_u32 row = medax_points_row_of_vertex(made->points);
    const medax_view_f64 exact = medax_samples_normals(made->samples);
    medax_medial_options options;
    double *given = malloc(3 * row.rows * sizeof *given);
    NEED(given != NULL);
    for (size_t v = 0; v < row.rows; ++v)
        for (size_t k = 0; k < 3; ++k) given[3 * v + k] = 2 * exact.data[3 * row.data[v] + k];
    medax_medial_options_init(&options, sizeof options);
    options.normals = given;
    options.normal_count = row.rows;
    const medax_medial *medial = built(made, &options), *by_poles = built(made, NULL);
    memset(given, 0, 3 * row.rows * sizeof *given);
    const double share = (double)count_of(medial, NULL) / (double)count_of(by_poles, NULL);
    CHECK(share > 0.9 && share < 1.1);
    CHECK(medax_medial_torn_count(medial) < row.rows / 10);
    const medax_medial *flat = built(made, &options);
    /* Copied; and without a normal there is no umbrella. */
    CHECK(medax_medial_umbrella_rims(medial).rows > 0);
    CHECK(medax_medial_umbrella_rims(flat).rows == 0 && count_of(flat, NULL) == 0);
    CHECK(medax_medial_torn_count(flat) == row.rows);
    free(given);
    medax_medial_free(flat);
    medax_medial_free(by_poles);
    medax_medial_free(medial);
}

/* Handles may be freed in any order. */
static void lifetimes(torus made) {
    const medax_medial *medial = built(&made, NULL), *copy = medax_medial_clone(medial);
    const medax_dual *dual = NULL;
    const medax_labels *labels = NULL;
    const medax_complex *axis = NULL;
    const double *sines = medax_medial_sines(medial).data;
    const size_t count = count_of(medial, NULL);
    done(made);
    medax_medial_free(medial);
    CHECK(copy == medial && medax_medial_sines(copy).data == sines && sines[0] <= 1);
    CHECK(count_of(copy, NULL) == count);
    CHECK_STATUS(OK, medax_medial_axis(copy, NULL, NULL, &axis));
    CHECK_STATUS(OK, medax_medial_dual(copy, &dual));
    CHECK_STATUS(OK, medax_medial_labels(copy, &labels));
    medax_medial_free(copy);
    CHECK(medax_dual_centers(dual).rows == medax_labels_is_inner(labels).rows);
    CHECK(medax_complex_faces(axis).rows > 0);
    medax_dual_free(dual);
    CHECK(medax_labels_inner_count(labels) > 0);
    medax_labels_free(labels);
    medax_complex_free(axis);
}

int main(void) {
    torus made = sampled();
    initial();
    null_is_nothing();
    refused_builds(&made);
    refused_filters(&made);
    views(&made);
    by_hand(&made);
    a_slider(&made);
    an_axis(&made);
    a_box(&made);
    scales(&made);
    normals(&made);
    lifetimes(made);
    return check_end();
}
