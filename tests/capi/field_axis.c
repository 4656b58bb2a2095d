/* Points of medial axes that are read off the gradient of the distance. */
#include "boundary.h"

static const char untouched = 0;
#define UNTOUCHED ((const medax_field_axis *)(const void *)&untouched)
static const double pi = 3.14159265358979323846;

static medax_field_axis_options defaults(void) {
    medax_field_axis_options options;
    CHECK_STATUS(OK, medax_field_axis_options_init(&options, sizeof options));
    return options;
}

static const medax_field_axis *built(const medax_sites *sites, const medax_field_axis_options *options) {
    const medax_field_axis *axis = NULL;
    CHECK_STATUS(OK, medax_field_axis_build(sites, options, NULL, &axis));
    NEED(axis != NULL && medax_field_axis_points(axis).rows > 0);
    return axis;
}

/* Three points: sites 0 to 2, of which the first two have the plane x = 0 between them, as far as y = 0.75. */
static const medax_sites *three_points(uint32_t dimension) {
    const medax_piece pieces[3] = {piece(MEDAX_PIECE_KIND_POINT, 0, -1, 0, 0, 0, 0, 0),
                                   piece(MEDAX_PIECE_KIND_POINT, 1, 1, 0, 0, 0, 0, 0),
                                   piece(MEDAX_PIECE_KIND_POINT, 2, 0, 2, 0, 0, 0, 0)};
    return sites_of(dimension, pieces, 3);
}

/* What is outside, in a cube. */
static medax_field_axis_options in_cube(double density, double half) {
    medax_field_axis_options options = defaults();
    options.side = MEDAX_SIDE_OUTER;
    options.density = density;
    options.has_clip = 1;
    for (size_t k = 0; k < 3; ++k) {
        options.clip_min[k] = -half;
        options.clip_max[k] = half;
    }
    return options;
}

/* The axis finds nothing wrong with itself, and has looked at each of its points. */
static void sound(const medax_field_axis *axis) {
    medax_validation report;
    report.struct_size = sizeof report;
    CHECK_STATUS(OK, medax_field_axis_validate(axis, NULL, &report));
    CHECK(report.problems == 0 && report.first_index == UINT64_MAX && report.first_message[0] == 0);
    CHECK(report.checked > 8 * medax_field_axis_points(axis).rows);
}

static void initial(void) {
    const medax_field_axis_options options = defaults();
    CHECK(options.struct_size == sizeof options && options.density == 0 && options.object_angle == 0);
    CHECK(options.min_distance == 0 && fabs(options.bound - pi / 9) < 1e-15 && options.tolerance == 0);
    CHECK(options.epsilon == 0 && options.has_clip == 0 && options.side == MEDAX_SIDE_INNER);
    CHECK(options.samples == 0 && options.between_sites == 0 && options.clip_max[2] == 0);
}

/* The views are what the complex has for writing. */
static void written(const medax_field_axis *axis) {
    const medax_complex *complex = NULL;
    CHECK_STATUS(OK, medax_field_axis_complex(axis, NULL, &complex));
    const medax_view_f64 vertices = medax_complex_vertices(complex), points = medax_field_axis_points(axis);
    NEED(vertices.rows == points.rows);
    CHECK(memcmp(vertices.data, points.data, 3 * points.rows * sizeof(double)) == 0);
    CHECK(same_f64(complex, "radius", medax_field_axis_radii(axis)));
    CHECK(same_f64(complex, "object_angle", medax_field_axis_object_angles(axis)));
    CHECK(same_f64(complex, "feet", medax_field_axis_feet(axis)));
    CHECK(same_u32(complex, "pieces", medax_field_axis_pieces(axis)));
    CHECK(same_u32(complex, "sites", medax_field_axis_sites_of_points(axis)));
    medax_attribute missed;
    memset(&missed, 0, sizeof missed);
    CHECK_STATUS(OK, medax_complex_attribute(complex, MEDAX_ELEMENT_VERTEX, "missed_angle", &missed));
    const medax_view_u32 covers = medax_field_axis_cover_of_point(axis);
    NEED(covers.rows == points.rows && missed.f64_values.rows == points.rows);
    size_t off = 0;
    for (size_t i = 0; i < points.rows; ++i) {
        medax_cover cover;
        CHECK_STATUS(OK, medax_field_axis_covers(axis, covers.data[i], 1, &cover));
        const double *p = points.data + 3 * i;
        off += cover.missed_angle != missed.f64_values.data[i] || cover.found == 0 || cover.reserved != 0
               || hypot(hypot(p[0] - cover.center[0], p[1] - cover.center[1]), p[2] - cover.center[2])
                      > cover.radius * (1 + 1e-9);
    }
    CHECK(off == 0);
    medax_complex_free(complex);
}

/* Every point is on the axis of the rectangle, which is known; the claim holds for all that is not. */
static void of_rectangle(void) {
    const medax_sites *sites = rectangle(4, 2), *same = NULL;
    medax_field_axis_options options = defaults();
    options.density = 0.25;
    options.object_angle = 1;
    const medax_field_axis *axis = built(sites, &options);
    const medax_view_f64 points = medax_field_axis_points(axis), radii = medax_field_axis_radii(axis);
    const medax_view_f64 angles = medax_field_axis_object_angles(axis), feet = medax_field_axis_feet(axis);
    NEED(radii.rows == points.rows && angles.rows == points.rows && feet.rows == points.rows);
    CHECK(points.cols == 3 && radii.cols == 1 && feet.cols == 6 && points.rows > 24);
    size_t off = 0, straight = 0;
    for (size_t i = 0; i < points.rows; ++i) {
        const double *p = points.data + 3 * i, *f = feet.data + 6 * i;
        const double sides = least(least(p[0], 4 - p[0]), least(p[1], 2 - p[1]));
        /* Between the branches the angle is pi, on the branches a right one. */
        const int middle = p[0] > 1.001 && p[0] < 2.999;
        off += to_axis(p, 4, 2) > 2e-5 || fabs(radii.data[i] - sides) > 2e-5 || p[2] != 0;
        off += fabs(hypot(f[0] - p[0], f[1] - p[1]) - radii.data[i]) > 2e-5;
        off += (middle || (p[0] < 0.999 || p[0] > 3.001)) && fabs(angles.data[i] - (middle ? pi : pi / 2)) > 1e-3;
        straight += (size_t)middle;
    }
    CHECK(off == 0 && straight >= 8 && straight < points.rows);
    written(axis);
    sound(axis);

    /* Defaults in numbers. */
    medax_field_axis_options found;
    memset(&found, 0, sizeof found);
    found.struct_size = sizeof found;
    CHECK_STATUS(OK, medax_field_axis_resolved(axis, &found));
    CHECK(found.density == 0.25 && found.object_angle == 1 && found.min_distance == 0.0625);
    CHECK(found.bound == options.bound && fabs(found.tolerance - 1e-9 * sqrt(20)) < 1e-15);
    CHECK(fabs(found.epsilon - 1e-6 * sqrt(20)) < 1e-12 && found.side == MEDAX_SIDE_INNER);
    CHECK(found.samples == (uint32_t)ceil(pi / sin(pi / 18)) && found.has_clip == 1 && found.between_sites == 0);
    CHECK(found.clip_min[0] == 0 && found.clip_max[0] == 4 && found.clip_max[1] == 2);
    /* What was resolved asks for the same again. */
    const medax_field_axis *again = built(sites, &found);
    CHECK(medax_field_axis_points(again).rows == points.rows);
    CHECK(memcmp(medax_field_axis_points(again).data, points.data, 24 * points.rows) == 0);
    medax_field_axis_free(again);

    /* The claim is that of the covers. */
    const size_t count = medax_field_axis_cover_count(axis);
    medax_cover *covers = calloc(count, sizeof *covers);
    NEED(covers != NULL && count > 100);
    CHECK_STATUS(OK, medax_field_axis_covers(axis, 0, count, covers));
    double angle = 77, largest = 0;
    size_t unclaimed = 77, none = 0, found_points = 0;
    for (size_t i = 0; i < count; ++i) {
        const double *c = covers[i].center;
        const double sides = least(least(c[0], 4 - c[0]), least(c[1], 2 - c[1]));
        CHECK(fabs(covers[i].distance - sides) < 1e-12 && covers[i].radius > covers[i].half);
        found_points += covers[i].found;
        if (covers[i].missed_angle > 3.14) ++none;
        else if (covers[i].missed_angle > largest) largest = covers[i].missed_angle;
        if (covers[i].found == 0 && covers[i].missed_angle < 3.14)
            CHECK(covers[i].missed_angle > 0 && covers[i].missed_angle <= pi / 9);
    }
    CHECK(found_points == points.rows);
    CHECK_STATUS(OK, medax_field_axis_claim(axis, &angle, &unclaimed));
    CHECK(angle == largest && unclaimed == none && angle > 0 && angle <= pi / 9);
    CHECK_STATUS(OK, medax_field_axis_claim(axis, NULL, NULL));
    CHECK_STATUS(INVALID_ARGUMENT, medax_field_axis_covers(axis, count, 1, covers));
    CHECK_STATUS(INVALID_ARGUMENT, medax_field_axis_covers(axis, 1, SIZE_MAX / 2, covers));
    CHECK_STATUS(NULL_ARGUMENT, medax_field_axis_covers(axis, 0, 1, NULL));
    CHECK_STATUS(OK, medax_field_axis_covers(axis, count, 0, NULL));
    free(covers);

    /* The axis keeps its sites alive. */
    CHECK_STATUS(OK, medax_field_axis_sites(axis, &same));
    CHECK(medax_sites_site_of_piece(same).data == medax_sites_site_of_piece(sites).data);
    medax_sites_free(sites);
    const medax_field_axis *copy = medax_field_axis_clone(axis);
    medax_field_axis_free(axis);
    CHECK(copy == axis && medax_field_axis_points(copy).data == points.data && points.data[2] == 0);
    medax_field_axis_free(copy);
    CHECK(medax_sites_piece_count(same) == 4);
    medax_sites_free(same);
}

/* The middle plane of two points in space, and the centre of a sphere. */
static void in_space(void) {
    const medax_sites *sites = two_points(3);
    medax_field_axis_options options = in_cube(0.4, 1);
    double angle = 77;
    size_t unclaimed = 0;
    options.min_distance = 1.1;
    const medax_field_axis *axis = built(sites, &options);
    const medax_view_f64 points = medax_field_axis_points(axis);
    const medax_view_f64 angles = medax_field_axis_object_angles(axis);
    size_t off = 0;
    for (size_t i = 0; i < points.rows; ++i) {
        const double *p = points.data + 3 * i, h = hypot(p[1], p[2]);
        off += fabs(p[0]) > 1e-5 || medax_field_axis_radii(axis).data[i] < 1.1;
        off += fabs(angles.data[i] - 2 * atan2(1, h)) > 1e-4;
        off += medax_field_axis_sites_of_points(axis).data[2 * i] + medax_field_axis_sites_of_points(axis).data[2 * i + 1] != 1;
    }
    CHECK(off == 0 && points.rows > 20);
    written(axis);
    sound(axis);
    CHECK_STATUS(OK, medax_field_axis_claim(axis, &angle, &unclaimed));
    CHECK(angle == 0 && unclaimed == medax_field_axis_cover_count(axis));
    medax_field_axis_free(axis);
    medax_sites_free(sites);

    const medax_piece sphere = piece(MEDAX_PIECE_KIND_SPHERE, 0, 1, 2, 3, 2, 0, 0);
    const medax_sites *ball = sites_of(3, &sphere, 1);
    options = defaults();
    options.side = MEDAX_SIDE_BOTH;
    options.density = 0.5;
    axis = built(ball, &options);
    const medax_view_f64 centers = medax_field_axis_points(axis);
    for (size_t i = 0; i < centers.rows; ++i) {
        const double *c = centers.data + 3 * i;
        CHECK(hypot(hypot(c[0] - 1, c[1] - 2), c[2] - 3) < 1e-4);
        CHECK(fabs(medax_field_axis_radii(axis).data[i] - 2) < 1e-4);
    }
    medax_field_axis_free(axis);
    medax_sites_free(ball);
}

/* Between two points there is a square, which is crossed from the one to the other. */
static void surfaces(void) {
    const medax_sites *sites = two_points(3);
    const medax_field_axis_options options = in_cube(0.3, 1);
    const medax_field_axis *axis = built(sites, &options);
    const medax_job *one = job_with(0, 1), *three = job_with(0, 3);
    const medax_complex *surface = NULL, *again = NULL;
    medax_sites_free(sites);
    CHECK_STATUS(OK, medax_field_axis_surface(axis, one, &surface));
    CHECK_STATUS(OK, medax_field_axis_surface(axis, three, &again));
    const medax_view_f64 vertices = medax_complex_vertices(surface);
    const medax_view_rows faces = medax_complex_faces(surface);
    NEED(vertices.rows == medax_complex_vertices(again).rows && faces.rows == medax_complex_faces(again).rows);
    CHECK(memcmp(vertices.data, medax_complex_vertices(again).data, 24 * vertices.rows) == 0);
    CHECK(memcmp(faces.indices, medax_complex_faces(again).indices, 16 * faces.rows) == 0);
    medax_complex_free(again);

    medax_topology topology;
    topology.struct_size = sizeof topology;
    CHECK_STATUS(OK, medax_complex_topology(surface, NULL, &topology));
    CHECK(topology.betti[0] == 1 && topology.betti[1] == 0 && topology.betti[2] == 0 && topology.oriented);
    CHECK(topology.boundary_loops == 1 && topology.nonmanifold_edges == 0 && topology.isolated_vertices == 0);
    double area = 0, volume = 0;
    CHECK_STATUS(OK, medax_complex_measure(surface, NULL, &area, &volume));
    CHECK(area <= 4 && area > 4 * 0.7 * 0.7);

    medax_attribute radius, angle, feet, sites_of_faces;
    memset(&radius, 0, sizeof radius);
    memset(&angle, 0, sizeof angle);
    memset(&feet, 0, sizeof feet);
    memset(&sites_of_faces, 0, sizeof sites_of_faces);
    CHECK_STATUS(OK, medax_complex_attribute(surface, MEDAX_ELEMENT_VERTEX, "radius", &radius));
    CHECK_STATUS(OK, medax_complex_attribute(surface, MEDAX_ELEMENT_VERTEX, "object_angle", &angle));
    CHECK_STATUS(OK, medax_complex_attribute(surface, MEDAX_ELEMENT_VERTEX, "feet", &feet));
    CHECK_STATUS(OK, medax_complex_attribute(surface, MEDAX_ELEMENT_FACE, "sites", &sites_of_faces));
    NEED(radius.f64_values.rows == vertices.rows && angle.f64_values.rows == vertices.rows);
    NEED(feet.f64_values.rows == vertices.rows && feet.f64_values.cols == 6);
    NEED(sites_of_faces.u32_values.rows == faces.rows && sites_of_faces.u32_values.cols == 2);
    size_t off = 0;
    for (size_t i = 0; i < vertices.rows; ++i) {
        const double *p = vertices.data + 3 * i, h = hypot(p[1], p[2]), *f = feet.f64_values.data + 6 * i;
        off += fabs(p[0]) > 1e-5 || fabs(p[1]) > 1 || fabs(p[2]) > 1;
        off += fabs(radius.f64_values.data[i] - hypot(1, h)) > 1e-5;
        off += fabs(angle.f64_values.data[i] - 2 * atan2(1, h)) > 1e-4 || fabs(f[0] + f[3]) > 1e-9;
    }
    for (size_t face = 0; face < faces.rows; ++face) {
        const uint32_t *ring = faces.indices + faces.offsets[face];
        const double *a = vertices.data + 3 * ring[0], *b = vertices.data + 3 * ring[1];
        const double *c = vertices.data + 3 * ring[2], *d = vertices.data + 3 * ring[3];
        const uint32_t *pair = sites_of_faces.u32_values.data + 2 * face;
        off += (c[1] - a[1]) * (d[2] - b[2]) - (c[2] - a[2]) * (d[1] - b[1]) <= 0 || pair[0] + pair[1] != 1;
    }
    CHECK(off == 0 && faces.rows > 20 && medax_complex_edges(surface).rows == 0);
    medax_complex_free(surface);
    medax_job_free(one);
    medax_job_free(three);

    const medax_job *spent = spent_job(), *small = job_with(2000, 0);
    const medax_complex *none = NULL;
    CHECK_STATUS(CANCELLED, medax_field_axis_surface(axis, spent, &none));
    CHECK_STATUS(OUT_OF_MEMORY, medax_field_axis_surface(axis, small, &none));
    CHECK_STATUS(NULL_ARGUMENT, medax_field_axis_surface(NULL, NULL, &none));
    CHECK_STATUS(NULL_ARGUMENT, medax_field_axis_surface(axis, NULL, NULL));
    medax_field_axis_free(axis);
    const medax_sites *flat = rectangle(4, 2);
    axis = built(flat, NULL);
    CHECK_STATUS(INVALID_ARGUMENT, medax_field_axis_surface(axis, NULL, &none));
    CHECK(none == NULL);
    medax_field_axis_free(axis);
    medax_sites_free(flat);
    medax_job_free(small);
    medax_job_free(spent);
}

/* Of the diagram of three points the pieces that are asked for, and no others. */
static void between(void) {
    static const uint32_t pair[2] = {1, 0}, all[8] = {2, 1, 0, 1, 2, 0, 1, 0}, wrong[4] = {0, 2, 3, 1}, same[2] = {0, 0};
    for (uint32_t dimension = 2; dimension <= 3; ++dimension) {
        const medax_sites *sites = three_points(dimension);
        const double half = dimension == 2 ? 2 : 1.2;
        const medax_field_axis_options options = in_cube(dimension == 2 ? 0.2 : 0.4, half);
        const medax_field_axis *some = NULL, *every = NULL, *none = NULL, *plain = built(sites, &options);
        CHECK_STATUS(OK, medax_field_axis_between(sites, pair, 1, &options, NULL, &some));
        const medax_view_f64 points = medax_field_axis_points(some);
        const medax_view_u32 numbers = medax_field_axis_sites_of_points(some);
        NEED(points.rows > 10 && numbers.rows == points.rows && points.rows < medax_field_axis_points(plain).rows);
        size_t off = 0;
        double low = 9, high = -9;
        for (size_t i = 0; i < points.rows; ++i) {
            const double *p = points.data + 3 * i;
            off += fabs(p[0]) > 1e-4 || p[1] > 0.75 + 1e-3 || numbers.data[2 * i] + numbers.data[2 * i + 1] != 1;
            low = least(low, p[1]);
            high = p[1] > high ? p[1] : high;
        }
        CHECK(off == 0 && low < -half + options.density && high > 0.75 - 2 * options.density);
        sound(some);
        written(some);
        medax_field_axis_free(some);
        /* All pairs, one of them twice, are all that there is. */
        CHECK_STATUS(OK, medax_field_axis_between(sites, all, 4, &options, NULL, &every));
        const medax_view_f64 p = medax_field_axis_feet(every), q = medax_field_axis_feet(plain);
        CHECK(p.rows == q.rows && memcmp(p.data, q.data, 48 * p.rows) == 0);
        medax_field_axis_free(every);
        medax_field_axis_free(plain);
        /* A point has no axis of its own. */
        CHECK_STATUS(OK, medax_field_axis_between(sites, same, 1, &options, NULL, &none));
        CHECK(medax_field_axis_points(none).rows == 0);
        medax_field_axis_free(none);
        CHECK_STATUS(OK, medax_field_axis_between(sites, NULL, 0, &options, NULL, &none));
        CHECK(medax_field_axis_points(none).rows == 0);
        medax_field_axis_free(none);

        const medax_job *spent = spent_job(), *small = job_with(2000, 0);
        none = UNTOUCHED;
        CHECK_STATUS(INVALID_ARGUMENT, medax_field_axis_between(sites, wrong, 2, &options, NULL, &none));
        CHECK(medax_last_error_kind() == MEDAX_ERROR_KIND_ROW && medax_last_error_index() == 1);
        CHECK_STATUS(NULL_ARGUMENT, medax_field_axis_between(sites, NULL, 1, &options, NULL, &none));
        CHECK_STATUS(NULL_ARGUMENT, medax_field_axis_between(NULL, pair, 1, &options, NULL, &none));
        CHECK_STATUS(NULL_ARGUMENT, medax_field_axis_between(sites, pair, 1, &options, NULL, NULL));
        CHECK_STATUS(INVALID_ARGUMENT, medax_field_axis_between(sites, pair, SIZE_MAX, &options, NULL, &none));
        CHECK_STATUS(CANCELLED, medax_field_axis_between(sites, pair, 1, &options, spent, &none));
        CHECK_STATUS(OUT_OF_MEMORY, medax_field_axis_between(sites, pair, 1, &options, small, &none));
        CHECK(none == UNTOUCHED);
        medax_job_free(small);
        medax_job_free(spent);
        medax_sites_free(sites);
    }
}

/* The same bytes whatever the number of threads. */
static void threads(void) {
    const medax_sites *sites = rectangle(3, 2);
    const medax_job *one = job_with(0, 1), *three = job_with(0, 3);
    const medax_field_axis *a = NULL, *b = NULL;
    medax_field_axis_options options = defaults();
    options.density = 0.2;
    CHECK_STATUS(OK, medax_field_axis_build(sites, &options, one, &a));
    CHECK_STATUS(OK, medax_field_axis_build(sites, &options, three, &b));
    const medax_view_f64 p = medax_field_axis_feet(a), q = medax_field_axis_feet(b);
    NEED(p.rows == q.rows && p.rows > 0);
    CHECK(memcmp(p.data, q.data, p.rows * p.cols * sizeof(double)) == 0);
    CHECK(medax_field_axis_unconfirmed(a) == medax_field_axis_unconfirmed(b));
    medax_field_axis_free(a);
    medax_field_axis_free(b);
    medax_job_free(one);
    medax_job_free(three);
    medax_sites_free(sites);
}

static void refusals(void) {
    const double nan = strtod("nan", NULL);
    const medax_sites *sites = rectangle(4, 2);
    const medax_field_axis *axis = UNTOUCHED;
    for (int i = 0; i < 22; ++i) {
        medax_field_axis_options options = defaults();
        switch (i) {
        case 0: options.density = -1; break;
        case 1: options.density = nan; break;
        case 2: options.density = HUGE_VAL; break;
        case 3: options.min_distance = -1; break;
        case 4: options.min_distance = nan; break;
        case 5: options.object_angle = -0.1; break;
        case 6: options.object_angle = 3.2; break;
        case 7: options.bound = 0; break;
        case 8: options.bound = 3.2; break;
        case 9: options.bound = nan; break;
        case 10: options.samples = 11; break;
        case 11: options.samples = (1 << 20) + 1; break;
        case 12: options.tolerance = -1; break;
        case 13: options.epsilon = nan; break;
        case 14: options.has_clip = 1; break;
        case 15: options.has_clip = 2; break;
        case 16: options.side = 3; break;
        case 17: options.between_sites = 2; break;
        case 18: options.struct_size = 8; break;
        case 19: options.struct_size = 7; break;
        case 20: options.clip_max[0] = nan; options.has_clip = 1; break;
        default: options.clip_max[1] = options.clip_max[0] = 1e300; options.has_clip = 1;
        }
        CHECK_STATUS(INVALID_ARGUMENT, medax_field_axis_build(sites, &options, NULL, &axis));
    }
    const medax_piece line = piece(MEDAX_PIECE_KIND_LINE, 0, 0, 0, 0, 1, 0, 0);
    const medax_sites *endless = sites_of(2, &line, 1);
    CHECK_STATUS(INVALID_ARGUMENT, medax_field_axis_build(endless, NULL, NULL, &axis));
    medax_sites_free(endless);
    const medax_sites *space = two_points(3);
    medax_field_axis_options dense = defaults();
    dense.density = 1e-9;
    CHECK_STATUS(LIMIT_EXCEEDED, medax_field_axis_build(space, &dense, NULL, &axis));
    medax_sites_free(space);
    const medax_job *spent = spent_job(), *small = job_with(2000, 0);
    CHECK_STATUS(NULL_ARGUMENT, medax_field_axis_build(NULL, NULL, NULL, &axis));
    CHECK_STATUS(NULL_ARGUMENT, medax_field_axis_build(sites, NULL, NULL, NULL));
    CHECK_STATUS(CANCELLED, medax_field_axis_build(sites, NULL, spent, &axis));
    CHECK_STATUS(OUT_OF_MEMORY, medax_field_axis_build(sites, NULL, small, &axis));
    CHECK_STATUS(NULL_ARGUMENT, medax_field_axis_options_init(NULL, sizeof(medax_field_axis_options)));
    CHECK(axis == UNTOUCHED);
    medax_job_free(small);

    /* An older program's struct may be shorter, not than the first version's; a newer one's may be longer. */
    struct {
        medax_field_axis_options known;
        double later;
    } newer;
    CHECK_STATUS(OK, medax_field_axis_options_init(&newer.known, sizeof newer));
    newer.known.density = 0.2;
    CHECK_STATUS(OK, medax_field_axis_build(sites, &newer.known, NULL, &axis));
    const medax_complex *complex = NULL;
    medax_field_axis_options report;
    CHECK_STATUS(CANCELLED, medax_field_axis_complex(axis, spent, &complex));
    CHECK_STATUS(NULL_ARGUMENT, medax_field_axis_complex(NULL, NULL, &complex));
    CHECK_STATUS(NULL_ARGUMENT, medax_field_axis_complex(axis, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_field_axis_resolved(axis, NULL));
    report.struct_size = 8;
    CHECK_STATUS(INVALID_ARGUMENT, medax_field_axis_resolved(axis, &report));
    medax_validation found;
    found.struct_size = 8;
    CHECK_STATUS(INVALID_ARGUMENT, medax_field_axis_validate(axis, NULL, &found));
    found.struct_size = sizeof found;
    CHECK_STATUS(CANCELLED, medax_field_axis_validate(axis, spent, &found));
    CHECK_STATUS(NULL_ARGUMENT, medax_field_axis_validate(axis, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_field_axis_validate(NULL, NULL, &found));
    CHECK_STATUS(NULL_ARGUMENT, medax_field_axis_sites(axis, NULL));
    CHECK(complex == NULL);
    medax_field_axis_free(axis);
    axis = UNTOUCHED;
    newer.later = 1;
    CHECK_STATUS(INVALID_ARGUMENT, medax_field_axis_build(sites, &newer.known, NULL, &axis));
    CHECK(axis == UNTOUCHED);
    medax_job_free(spent);
    medax_sites_free(sites);
}

static void cancelled(void) {
    char stage[] = "field";
    const medax_sites *sites = rectangle(4, 2);
    const medax_field_axis *axis = UNTOUCHED;
    const medax_job *job = stopping_job(stage);
    medax_field_axis_options options = defaults();
    options.density = 0.001;
    CHECK_STATUS(CANCELLED, medax_field_axis_build(sites, &options, job, &axis));
    CHECK(axis == UNTOUCHED && medax_job_is_cancelled(job));
    CHECK(strcmp(medax_job_stage(job), stage) == 0);
    medax_job_free(job);
    medax_sites_free(sites);
}

static void null_is_nothing(void) {
    medax_cover cover;
    medax_field_axis_options options = defaults();
    const medax_sites *sites = NULL;
    CHECK(medax_field_axis_points(NULL).cols == 3 && medax_field_axis_points(NULL).data == NULL);
    CHECK(medax_field_axis_radii(NULL).rows == 0 && medax_field_axis_object_angles(NULL).rows == 0);
    CHECK(medax_field_axis_feet(NULL).cols == 6 && medax_field_axis_pieces(NULL).cols == 2);
    CHECK(medax_field_axis_sites_of_points(NULL).cols == 2);
    CHECK(medax_field_axis_cover_of_point(NULL).rows == 0 && medax_field_axis_cover_count(NULL) == 0);
    CHECK(medax_field_axis_unconfirmed(NULL) == 0 && medax_field_axis_clone(NULL) == NULL);
    CHECK_STATUS(NULL_ARGUMENT, medax_field_axis_covers(NULL, 0, 1, &cover));
    CHECK_STATUS(NULL_ARGUMENT, medax_field_axis_claim(NULL, NULL, NULL));
    CHECK_STATUS(NULL_ARGUMENT, medax_field_axis_resolved(NULL, &options));
    CHECK_STATUS(NULL_ARGUMENT, medax_field_axis_sites(NULL, &sites));
    medax_field_axis_free(NULL);
}

int main(void) {
    initial();
    of_rectangle();
    in_space();
    surfaces();
    between();
    threads();
    refusals();
    cancelled();
    null_is_nothing();
    return check_end();
}
