/* Handles of one chain, freed in every order: those that are left stay whole. */
#include "check.h"

enum { POINTS, TRIANGULATION, DUAL, POLES, CRUST, SURFACE, PERMUTED, INCIDENCE = PERMUTED, REGULAR, FAR_POLES, KINDS };

/* The handles, NULL where freed. */
struct chain {
    const medax_points *points;
    const medax_triangulation *triangulation, *regular;
    const medax_incidence *incidence;
    const medax_dual *dual;
    const medax_poles *poles, *far_poles;
    const medax_power_crust *crust;
    const medax_complex *surface;
};

/* Everything that can be made of twenty points. */
static struct chain build(void) {
    struct chain c;
    memset(&c, 0, sizeof c);
    c.points = check_points(20);
    NEED(c.points != NULL);
    CHECK_STATUS(OK, medax_delaunay_build(c.points, NULL, NULL, &c.triangulation));
    CHECK_STATUS(OK, medax_incidence_build(c.triangulation, NULL, &c.incidence));
    CHECK_STATUS(OK, medax_dual_build(c.triangulation, NULL, NULL, &c.dual));
    CHECK_STATUS(OK, medax_poles_build(c.dual, NULL, NULL, &c.poles));
    CHECK_STATUS(OK, medax_power_crust_build(c.points, NULL, NULL, &c.crust));
    CHECK_STATUS(OK, medax_power_crust_poles(c.crust, &c.far_poles));
    CHECK_STATUS(OK, medax_power_crust_regular(c.crust, &c.regular));
    CHECK_STATUS(OK, medax_power_crust_surface(c.crust, &c.surface));
    NEED(c.surface != NULL);
    return c;
}

/* What there is to read in what is left. A freed handle is NULL, which has no rows. */
static uint64_t sum(const struct chain *c) {
    uint64_t sum = 0;
    const medax_view_f64 floats[] = {
        medax_points_coords(c->points),           medax_triangulation_coords(c->triangulation),
        medax_dual_centers(c->dual),              medax_poles_balls(c->poles),
        medax_complex_vertices(c->surface),       medax_poles_balls(c->far_poles),
        medax_triangulation_coords(c->regular)};
    const medax_view_u32 integers[] = {
        medax_triangulation_cells(c->triangulation), medax_incidence_edges(c->incidence),
        medax_power_crust_labels(c->crust),          medax_triangulation_cells(c->regular)};
    for (size_t v = 0; v < sizeof floats / sizeof *floats; ++v)
        for (size_t i = 0; i < floats[v].rows * floats[v].cols; ++i) sum += floats[v].data[i] > 0.5;
    for (size_t v = 0; v < sizeof integers / sizeof *integers; ++v)
        for (size_t i = 0; i < integers[v].rows * integers[v].cols; ++i)
            sum += integers[v].data[i];
    return sum;
}

/* Frees one handle. */
static void drop(struct chain *c, int kind) {
    switch (kind) {
    case POINTS: medax_points_free(c->points); c->points = NULL; break;
    case TRIANGULATION: medax_triangulation_free(c->triangulation); c->triangulation = NULL; break;
    case DUAL: medax_dual_free(c->dual); c->dual = NULL; break;
    case POLES: medax_poles_free(c->poles); c->poles = NULL; break;
    case CRUST: medax_power_crust_free(c->crust); c->crust = NULL; break;
    case SURFACE: medax_complex_free(c->surface); c->surface = NULL; break;
    case INCIDENCE: medax_incidence_free(c->incidence); c->incidence = NULL; break;
    case REGULAR: medax_triangulation_free(c->regular); c->regular = NULL; break;
    default: medax_poles_free(c->far_poles); c->far_poles = NULL; break;
    }
}

/* The `number`th of the 720 orders of six kinds; the other three come in at places that move on
 * from order to order. */
static void order_of(int number, int order[KINDS]) {
    int left[PERMUTED] = {POINTS, TRIANGULATION, DUAL, POLES, CRUST, SURFACE};
    int count = 0, rest = number;
    for (int n = PERMUTED; n > 0; --n) {
        const int chosen = rest % n;
        order[count++] = left[chosen];
        left[chosen] = left[n - 1];
        rest /= n;
    }
    for (int kind = INCIDENCE; kind < KINDS; ++kind) {
        const int place = number * (2 * kind + 1) % (count + 1);
        memmove(order + place + 1, order + place, sizeof *order * (size_t)(count - place));
        order[place] = kind;
        ++count;
    }
}

int main(void) {
    /* What each handle adds to the sum when it is the only one. */
    struct chain alone = build();
    uint64_t shares[KINDS];
    const uint64_t all = sum(&alone);
    uint64_t left = all;
    for (int kind = 0; kind < KINDS; ++kind) {
        drop(&alone, kind);
        shares[kind] = left - sum(&alone);
        left -= shares[kind];
        CHECK(shares[kind] > 0);
    }
    CHECK(left == 0);
    for (int number = 0; number < 720; ++number) {
        struct chain chain = build();
        int order[KINDS];
        order_of(number, order);
        left = all;
        for (int i = 0; i < KINDS; ++i) {
            CHECK(sum(&chain) == left);
            drop(&chain, order[i]);
            left -= shares[order[i]];
        }
        CHECK(sum(&chain) == 0 && left == 0);
    }
    return check_end();
}
