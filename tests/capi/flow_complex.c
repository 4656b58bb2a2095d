/* The unstable flow complex of samples of a torus, and its flow DAG. */
#include "torus.h"

static const char nothing = 0;
#define UNTOUCHED ((const medax_flow_complex *)(const void *)&nothing)
#define NO_COMPLEX ((const medax_complex *)(const void *)&nothing)

static medax_flow_element element(uint32_t kind, uint32_t number) {
    const medax_flow_element made = {kind, number};
    return made;
}

static void null_is_nothing(const medax_flow *flow) {
    const medax_simplex cell = {3, 0};
    const medax_flow_complex *made = UNTOUCHED;
    const medax_flow *its = NULL;
    const medax_complex *complex = NO_COMPLEX;
    const medax_job *spent = NULL;
    uint32_t offset = 77;
    size_t count = 99;
    medax_validation report;
    report.struct_size = sizeof report;
    CHECK_STATUS(OK, medax_job_create(NULL, &spent));
    medax_job_cancel(spent);
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_complex_build(NULL, NULL, &made));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_complex_build(flow, NULL, NULL));
    CHECK_STATUS(CANCELLED, medax_flow_complex_build(flow, spent, &made));
    CHECK(made == UNTOUCHED);
    CHECK(medax_flow_complex_vertex_count(NULL) == 0 && medax_flow_complex_points(NULL).cols == 3);
    CHECK(medax_flow_complex_points(NULL).data == NULL && medax_flow_complex_edges(NULL).cols == 2);
    CHECK(medax_flow_complex_triangle_of_point(NULL).rows == 0);
    CHECK(medax_flow_complex_triangle_of_edge(NULL).rows == 0);
    CHECK(medax_flow_complex_faces(NULL).rows == 0
          && medax_flow_complex_faces(NULL).offsets == NULL);
    CHECK(medax_flow_complex_face_edges(NULL).indices == NULL);
    CHECK(medax_flow_complex_faces_of_facet(NULL).rows == 0);
    CHECK(medax_flow_complex_edge_of_vertex(NULL).rows == 0);
    CHECK(medax_flow_complex_face_of_edge(NULL).cols == 1);
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_complex_flow(NULL, &its));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_complex_elements_of(NULL, cell, 0, NULL, &count));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_complex_closure(NULL, NULL, 0, NULL, 0, NULL, &count));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_complex_upstream(NULL, NULL, 0, NULL, 0, NULL, &count));
    CHECK_STATUS(NULL_ARGUMENT,
                 medax_flow_complex_critical_sets(NULL, NULL, 0, NULL, &offset, 0, NULL, &count));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_complex_complex(NULL, NULL, &complex));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_complex_validate(NULL, NULL, &report));
    CHECK(medax_flow_complex_clone(NULL) == NULL && its == NULL && complex == NO_COMPLEX);
    CHECK(count == 99 && offset == 77);
    medax_flow_complex_free(NULL);
    medax_job_free(spent);
}

/* What the views have: elements of the Voronoi diagram, in parts that fit together. */
static void views(const torus *made, const medax_flow *flow, const medax_flow_complex *its) {
    const size_t cells = medax_triangulation_cells(made->t).rows;
    const size_t facets = medax_dual_facets(made->dual).rows;
    const size_t triangles = medax_flow_triangles(flow).rows;
    const size_t count = medax_flow_complex_vertex_count(its);
    const medax_view_f64 points = medax_flow_complex_points(its);
    const medax_view_u32 of_point = medax_flow_complex_triangle_of_point(its);
    const medax_view_u32 edges = medax_flow_complex_edges(its);
    const medax_view_u32 of_edge = medax_flow_complex_triangle_of_edge(its);
    const medax_view_rows faces = medax_flow_complex_faces(its);
    const medax_view_rows rims = medax_flow_complex_face_edges(its);
    const medax_view_u32 of_facet = medax_flow_complex_faces_of_facet(its);
    const medax_view_u32 down = medax_flow_complex_edge_of_vertex(its);
    const medax_view_u32 across = medax_flow_complex_face_of_edge(its);
    NEED(count == cells + points.rows && points.cols == 3 && points.rows > 0);
    NEED(of_point.rows == points.rows && down.rows == count && down.cols == 1);
    NEED(edges.cols == 2 && across.rows == edges.rows && of_edge.rows > triangles);
    NEED(of_edge.rows < edges.rows && faces.rows > facets && rims.rows == faces.rows);
    NEED(of_facet.rows == facets + 1 && of_facet.data[0] == 0
         && of_facet.data[facets] == faces.rows);
    NEED(faces.offsets == rims.offsets && faces.indices != rims.indices);
    for (size_t i = 0; i < points.rows; ++i) CHECK(of_point.data[i] < triangles);
    for (size_t e = 0; e < of_edge.rows; ++e) CHECK(of_edge.data[e] < triangles);
    for (size_t f = 0; f < facets; ++f) CHECK(of_facet.data[f] < of_facet.data[f + 1]);
    for (size_t i = 0; i < 2 * edges.rows; ++i)
        CHECK(edges.data[i] < count || edges.data[i] == MEDAX_NONE);
    size_t still = 0, crossed = 0;
    for (uint32_t v = 0; v < count; ++v) {
        still += down.data[v] == MEDAX_NONE;
        if (down.data[v] == MEDAX_NONE) continue;
        NEED(down.data[v] < edges.rows);
        CHECK(edges.data[2 * down.data[v]] == v || edges.data[2 * down.data[v] + 1] == v);
    }
    for (uint32_t e = 0; e < edges.rows; ++e) {
        if (across.data[e] == MEDAX_NONE) continue;
        ++crossed;
        NEED(across.data[e] < faces.rows && e < of_edge.rows);
        size_t sides = 0;
        for (uint32_t i = rims.offsets[across.data[e]]; i < rims.offsets[across.data[e] + 1]; ++i)
            sides += rims.indices[i] == e;
        CHECK(sides == 1);
    }
    for (size_t f = 0; f < faces.rows; ++f) {
        const uint32_t begin = faces.offsets[f], end = faces.offsets[f + 1];
        NEED(end >= begin + 2);
        for (uint32_t i = begin; i < end; ++i) {
            const uint32_t from = faces.indices[i], to = faces.indices[i + 1 < end ? i + 1 : begin];
            const uint32_t *ends = edges.data + 2 * rims.indices[i];
            CHECK((ends[0] == from && ends[1] == to) || (ends[0] == to && ends[1] == from));
        }
    }
    size_t saddles = 0;
    const medax_view_u32 simplices = medax_flow_critical_simplices(flow);
    for (size_t i = 0; i < simplices.rows; ++i) saddles += simplices.data[2 * i] >= 2;
    CHECK(still == saddles && crossed > 0);
}

/* All elements that can be reached in one step. */
static size_t steps(const medax_flow_complex *its, medax_flow_element from,
                    medax_flow_element to[64]) {
    size_t count = 0;
    if (from.kind == MEDAX_ELEMENT_VERTEX)
        to[count++] = element(MEDAX_ELEMENT_EDGE,
                              medax_flow_complex_edge_of_vertex(its).data[from.number]);
    if (from.kind == MEDAX_ELEMENT_EDGE) {
        const uint32_t *ends = medax_flow_complex_edges(its).data + 2 * from.number;
        to[count++] = element(MEDAX_ELEMENT_VERTEX, ends[0]);
        to[count++] = element(MEDAX_ELEMENT_VERTEX, ends[1]);
        to[count++] = element(MEDAX_ELEMENT_FACE,
                              medax_flow_complex_face_of_edge(its).data[from.number]);
    }
    if (from.kind == MEDAX_ELEMENT_FACE) {
        const medax_view_rows rims = medax_flow_complex_face_edges(its);
        for (uint32_t i = rims.offsets[from.number]; i < rims.offsets[from.number + 1]
             && count < 64; ++i)
            to[count++] = element(MEDAX_ELEMENT_EDGE, rims.indices[i]);
    }
    return count;
}

static int compare(const void *a, const void *b) {
    const medax_flow_element *x = a, *y = b;
    if (x->kind != y->kind) return x->kind < y->kind ? -1 : 1;
    return (x->number > y->number) - (x->number < y->number);
}

static int has(const medax_flow_element *list, size_t count, medax_flow_element one) {
    return bsearch(&one, list, count, sizeof one, compare) != NULL;
}

typedef medax_status (*reach)(const medax_flow_complex *, const medax_flow_element *, size_t,
                              const medax_job *,
                              size_t, medax_flow_element *, size_t *);

/* The elements that can be reached from one, for the caller to free. */
static medax_flow_element *reached(reach how, const medax_flow_complex *its, medax_flow_element one,
                                   size_t *count) {
    medax_flow_element short_of[1] = {{9, 9}};
    CHECK_STATUS(OK, how(its, &one, 1, NULL, 0, NULL, count));
    const size_t expected = *count;
    medax_flow_element *found = malloc((expected + 1) * sizeof *found);
    NEED(found != NULL && expected > 0);
    CHECK_STATUS(OK, how(its, &one, 1, NULL, expected + 1, found, count));
    CHECK(*count == expected && has(found, expected, one));
    CHECK_STATUS(OK, how(its, &one, 1, NULL, 1, short_of, count));
    CHECK(*count == expected && compare(short_of, found) == 0);
    for (size_t i = 1; i < expected; ++i) CHECK(compare(found + i - 1, found + i) < 0);
    return found;
}

/* Closures have what their elements flow into; what is upstream of one has it in its closure. */
static void the_dag(const medax_flow_complex *its) {
    uint64_t state = 3;
    const size_t counts[3] = {medax_flow_complex_vertex_count(its),
                              medax_flow_complex_edges(its).rows,
                              medax_flow_complex_faces(its).rows};
    for (uint32_t i = 0; i < 12; ++i) {
        const medax_flow_element one
            = element(i % 3, (uint32_t)(check_random(&state) * (double)counts[i % 3]));
        size_t count = 0, before = 0, above = 0;
        medax_flow_element to[64], *closure = reached(medax_flow_complex_closure, its, one, &count);
        for (size_t k = 0; k < count; ++k) {
            const size_t next = steps(its, closure[k], to);
            for (size_t n = 0; n < next; ++n)
                CHECK(to[n].number == MEDAX_NONE || has(closure, count, to[n]));
        }
        const medax_flow_element last = closure[count / 2];
        medax_flow_element *upstream = reached(medax_flow_complex_upstream, its, last, &before);
        CHECK(has(upstream, before, one));
        for (size_t k = 0; k < before; k += 1 + before / 5) {
            medax_flow_element *of = reached(medax_flow_complex_closure, its, upstream[k], &above);
            CHECK(has(of, above, last));
            free(of);
        }
        free(upstream);
        free(closure);
    }
}

/* An element is in the closure of the faces of each of its critical points, and of no other. */
static void critical_sets(const torus *made, const medax_flow *flow,
                          const medax_flow_complex *its) {
    enum { COUNT = 6 };
    const medax_view_u32 simplices = medax_flow_critical_simplices(flow);
    const medax_view_u32 classes = medax_flow_critical_classes(flow);
    const size_t samples = medax_triangulation_coords(made->t).rows;
    medax_flow_element asked[COUNT];
    uint32_t offsets[COUNT + 1], first = 77;
    size_t count = 0, seen = 0, found = 0;
    const uint32_t faces = (uint32_t)medax_flow_complex_faces(its).rows;
    const uint32_t edges = (uint32_t)medax_flow_complex_edges(its).rows;
    for (uint32_t i = 0; i < COUNT; ++i)
        asked[i] = i % 2 == 0 ? element(MEDAX_ELEMENT_FACE, faces / COUNT * i)
                              : element(MEDAX_ELEMENT_EDGE, edges / COUNT * i);
    CHECK_STATUS(OK,
                 medax_flow_complex_critical_sets(its, asked, COUNT, NULL, offsets, 0, NULL,
                                                  &count));
    uint32_t *rows = malloc((count + 1) * sizeof *rows);
    NEED(rows != NULL && count > 0 && offsets[0] == 0 && offsets[COUNT] == count);
    CHECK_STATUS(OK,
                 medax_flow_complex_critical_sets(its, asked, COUNT, NULL, offsets, count, rows,
                                                  &count));
    CHECK_STATUS(OK,
                 medax_flow_complex_critical_sets(its, asked, COUNT, NULL, offsets, 1, &first,
                                                  &count));
    CHECK(offsets[COUNT] == count && first == rows[0]);
    for (size_t k = 0; k < count; ++k) CHECK(rows[k] < simplices.rows);
    for (uint32_t i = 0; i < COUNT; ++i)
        for (uint32_t k = offsets[i] + 1; k < offsets[i + 1]; ++k) CHECK(rows[k - 1] < rows[k]);
    medax_flow_element parts[256], *closure = malloc((faces + 2 * edges) * sizeof *closure);
    NEED(closure != NULL);
    for (uint32_t r = (uint32_t)samples; r < simplices.rows; ++r) {
        /* Those of the surface are many: of them those of the sets, and some others. */
        size_t in_sets = 0;
        for (size_t k = 0; k < count; ++k) in_sets += rows[k] == r;
        if (in_sets == 0 && classes.data[r] == MEDAX_CRITICAL_CLASS_SURFACE
            && r % 97 != 0) continue;
        const medax_simplex simplex = {simplices.data[2 * r], simplices.data[2 * r + 1]};
        size_t its_count = 0, reached_count = 0;
        CHECK_STATUS(OK, medax_flow_complex_elements_of(its, simplex, 256, parts, &its_count));
        NEED(its_count > 0 && its_count <= 256);
        CHECK_STATUS(OK,
                     medax_flow_complex_closure(its, parts, its_count, NULL, faces + 2 * edges,
                                                closure,
                                                    &reached_count));
        for (uint32_t i = 0; i < COUNT; ++i) {
            size_t in_set = 0;
            for (uint32_t k = offsets[i]; k < offsets[i + 1]; ++k) in_set += rows[k] == r;
            CHECK((in_set == 1) == has(closure, reached_count, asked[i]));
            found += in_set;
            ++seen;
        }
    }
    CHECK(found > 0 && seen > found);
    free(closure);
    free(rows);
}

static void parts(const torus *made, const medax_flow *flow, const medax_flow_complex *its) {
    medax_flow_element found[2] = {{9, 9}, {9, 9}};
    medax_simplex one = {3, 5};
    size_t count = 0;
    CHECK_STATUS(OK, medax_flow_complex_elements_of(its, one, 2, found, &count));
    CHECK(count == 1 && compare(found, &(const medax_flow_element){MEDAX_ELEMENT_VERTEX, 5}) == 0);
    CHECK(found[1].kind == 9);
    for (one.dimension = 1,
         one.number = 0; one.number < medax_dual_facets(made->dual).rows; ++one.number) {
        const uint32_t *begin = medax_flow_complex_faces_of_facet(its).data + one.number;
        CHECK_STATUS(OK, medax_flow_complex_elements_of(its, one, 1, found, &count));
        CHECK(count == begin[1] - begin[0] && found->kind == MEDAX_ELEMENT_FACE
              && found->number == *begin);
    }
    size_t edges = 0;
    for (one.dimension = 2,
         one.number = 0; one.number < medax_flow_triangles(flow).rows; ++one.number) {
        CHECK_STATUS(OK, medax_flow_complex_elements_of(its, one, 1, found, &count));
        CHECK(found->kind == MEDAX_ELEMENT_EDGE
              && medax_flow_complex_triangle_of_edge(its).data[found->number] == one.number);
        edges += count;
    }
    CHECK(edges == medax_flow_complex_triangle_of_edge(its).rows);
    CHECK_STATUS(INVALID_ARGUMENT, medax_flow_complex_elements_of(its, one, 1, found, &count));
    one.dimension = 0;
    one.number = 0;
    CHECK_STATUS(INVALID_ARGUMENT, medax_flow_complex_elements_of(its, one, 1, found, &count));
    one.dimension = 4;
    CHECK_STATUS(INVALID_ARGUMENT, medax_flow_complex_elements_of(its, one, 1, found, &count));
    one.dimension = 3;
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_complex_elements_of(its, one, 1, NULL, &count));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_complex_elements_of(its, one, 1, found, NULL));
}

static void refusals(const medax_flow_complex *its) {
    const reach ways[] = {medax_flow_complex_closure, medax_flow_complex_upstream};
    const medax_complex *complex = NO_COMPLEX;
    const medax_job *spent = NULL;
    medax_flow_element given[3] = {{MEDAX_ELEMENT_VERTEX, 0}, {MEDAX_ELEMENT_EDGE, 0},
                                   {MEDAX_ELEMENT_FACE, 0}};
    medax_flow_element found[1] = {{9, 9}};
    const medax_flow_element wrong[] = {
        {MEDAX_ELEMENT_VERTEX, (uint32_t)medax_flow_complex_vertex_count(its)},
        {MEDAX_ELEMENT_EDGE, (uint32_t)medax_flow_complex_edges(its).rows},
        {MEDAX_ELEMENT_FACE, (uint32_t)medax_flow_complex_faces(its).rows},
        {MEDAX_ELEMENT_CELL, 0},
        {4, 0},
    };
    uint32_t offsets[4] = {77, 77, 77, 77}, rows[1] = {77};
    size_t count = 99;
    CHECK_STATUS(OK, medax_job_create(NULL, &spent));
    medax_job_cancel(spent);
    for (size_t i = 0; i < 2; ++i) {
        CHECK_STATUS(CANCELLED, ways[i](its, given, 3, spent, 1, found, &count));
        CHECK_STATUS(NULL_ARGUMENT, ways[i](its, NULL, 1, NULL, 1, found, &count));
        CHECK_STATUS(NULL_ARGUMENT, ways[i](its, given, 3, NULL, 1, NULL, &count));
        CHECK_STATUS(NULL_ARGUMENT, ways[i](its, given, 3, NULL, 1, found, NULL));
        CHECK_STATUS(INVALID_ARGUMENT, ways[i](its, given, SIZE_MAX, NULL, 1, found, &count));
    }
    CHECK_STATUS(CANCELLED,
                 medax_flow_complex_critical_sets(its, given, 3, spent, offsets, 1, rows, &count));
    CHECK_STATUS(NULL_ARGUMENT,
                 medax_flow_complex_critical_sets(its, NULL, 1, NULL, offsets, 1, rows, &count));
    CHECK_STATUS(NULL_ARGUMENT,
                 medax_flow_complex_critical_sets(its, given, 3, NULL, NULL, 1, rows, &count));
    CHECK_STATUS(NULL_ARGUMENT,
                 medax_flow_complex_critical_sets(its, given, 3, NULL, offsets, 1, NULL, &count));
    CHECK_STATUS(NULL_ARGUMENT,
                 medax_flow_complex_critical_sets(its, given, 3, NULL, offsets, 1, rows, NULL));
    CHECK_STATUS(INVALID_ARGUMENT,
                 medax_flow_complex_critical_sets(its, given, SIZE_MAX, NULL, offsets, 1, rows,
                                                  &count));
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; ++i) {
        given[2] = wrong[i];
        for (size_t k = 0; k < 2; ++k) {
            CHECK_STATUS(INVALID_ARGUMENT, ways[k](its, given, 3, NULL, 1, found, &count));
            CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 2);
        }
        CHECK_STATUS(INVALID_ARGUMENT,
                     medax_flow_complex_critical_sets(its, given, 3, NULL, offsets, 1, rows,
                                                      &count));
        CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 2);
    }
    CHECK(found->kind == 9 && offsets[0] == 77 && rows[0] == 77 && count == 99);
    CHECK_STATUS(CANCELLED, medax_flow_complex_complex(its, spent, &complex));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_complex_complex(its, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_complex_validate(its, NULL, NULL));
    CHECK(complex == NO_COMPLEX);
    /* Nothing flows nowhere. */
    CHECK_STATUS(OK, medax_flow_complex_closure(its, NULL, 0, NULL, 0, NULL, &count));
    CHECK(count == 0);
    CHECK_STATUS(OK,
                 medax_flow_complex_critical_sets(its, NULL, 0, NULL, offsets, 0, NULL, &count));
    CHECK(count == 0 && offsets[0] == 0 && offsets[1] == 77);
    medax_job_free(spent);
}

/* All that is bounded is written; and handles may be freed in any order. */
static void lifetimes(torus made, const medax_flow *flow, const medax_flow_complex *its) {
    const medax_flow_complex *copy = medax_flow_complex_clone(its);
    const medax_complex *complex = NULL;
    const medax_flow *same = NULL;
    medax_validation report;
    report.struct_size = sizeof report;
    CHECK_STATUS(OK, medax_flow_complex_validate(its, NULL, &report));
    CHECK(report.problems == 0 && report.checked > 0);
    CHECK_STATUS(NULL_ARGUMENT, medax_flow_complex_flow(its, NULL));
    CHECK_STATUS(OK, medax_flow_complex_flow(its, &same));
    const double *points = medax_flow_critical_points(flow).data;
    CHECK(medax_flow_critical_points(same).data == points);
    done(made);
    medax_flow_free(flow);
    medax_flow_complex_free(its);
    CHECK(copy == its && medax_flow_complex_points(copy).rows > 0);
    CHECK_STATUS(OK, medax_flow_complex_complex(copy, NULL, &complex));
    const medax_view_rows faces = medax_flow_complex_faces(copy);
    size_t bounded = 0;
    for (size_t f = 0; f < faces.rows; ++f) {
        size_t infinite = 0;
        for (uint32_t i = faces.offsets[f]; i < faces.offsets[f + 1]; ++i)
            infinite += faces.indices[i] == MEDAX_NONE;
        bounded += infinite == 0;
    }
    CHECK(medax_complex_faces(complex).rows == bounded && bounded < faces.rows && bounded > 0);
    CHECK(attribute(complex, MEDAX_ELEMENT_FACE, "facet").u32_values.rows == bounded);
    medax_flow_complex_free(copy);
    CHECK(medax_flow_critical_points(same).data == points && points[0] < 2);
    medax_flow_free(same);
    medax_complex_free(complex);
}

int main(void) {
    torus made = sampled();
    const medax_flow *flow = NULL;
    const medax_flow_complex *its = NULL;
    CHECK_STATUS(OK, medax_flow_build(made.dual, made.labels, NULL, NULL, &flow));
    NEED(flow != NULL);
    null_is_nothing(flow);
    CHECK_STATUS(OK, medax_flow_complex_build(flow, NULL, &its));
    NEED(its != NULL);
    views(&made, flow, its);
    the_dag(its);
    critical_sets(&made, flow, its);
    parts(&made, flow, its);
    refusals(its);
    lifetimes(made, flow, its);
    return check_end();
}
