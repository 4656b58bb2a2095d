/* Samples of shapes and meshes. */
#include "check.h"

static const char nothing = 0;
#define UNTOUCHED ((const medax_samples *)(const void *)&nothing)

static void shapes(void) {
    static const char *const names[8] = {"torus", "box", "capsule", "ellipsoid",
                                         "trefoil", "genus3", "bracket", "sphere"};
    static const uint32_t genera[8] = {1, 0, 0, 0, 1, 3, 3, 0};
    medax_shape_facts facts;
    for (uint32_t shape = 0; shape < 8; ++shape) {
        facts.struct_size = sizeof facts;
        CHECK(strcmp(medax_shape_name(shape), names[shape]) == 0);
        CHECK_STATUS(OK, medax_shape_describe(shape, &facts));
        CHECK(facts.genus == genera[shape] && facts.components == 1 && facts.spacing > 0);
        CHECK(facts.min[0] < facts.max[0] && facts.min[2] < facts.max[2] && facts.reserved == 0);
        CHECK(facts.smooth == (shape != MEDAX_SHAPE_BOX && shape != MEDAX_SHAPE_BRACKET));
    }
    memset(&facts, 0, sizeof facts);
    CHECK_STATUS(INVALID_ARGUMENT, medax_shape_describe(MEDAX_SHAPE_TORUS, &facts));
    facts.struct_size = sizeof facts;
    CHECK(*medax_shape_name(8) == 0 && *medax_shape_name(UINT32_MAX) == 0);
    CHECK_STATUS(INVALID_ARGUMENT, medax_shape_describe(8, &facts));
    CHECK_STATUS(NULL_ARGUMENT, medax_shape_describe(0, NULL));
    CHECK(facts.spacing == 0);
}

static void a_sphere(void) {
    const medax_samples *samples = NULL;
    const medax_complex *complex = NULL, *mesh = NULL;
    const medax_points *points = NULL;
    const medax_power_crust *crust = NULL;
    medax_attribute normal;
    medax_sample_options options;
    CHECK_STATUS(OK, medax_sample_options_init(&options, sizeof options));
    CHECK(options.spacing == 0 && options.density == 0 && options.noise == 0 && options.seed == 0);
    options.spacing = 0.3;
    CHECK_STATUS(OK, medax_samples_build(MEDAX_SHAPE_SPHERE, &options, NULL, &samples));
    NEED(samples != NULL);
    const medax_view_f64 coords = medax_samples_coords(samples);
    const medax_view_f64 normals = medax_samples_normals(samples);
    NEED(coords.rows > 50 && coords.cols == 3 && normals.rows == coords.rows);
    for (size_t i = 0; i < coords.rows; ++i) {
        double square = 0, along = 0;
        for (size_t k = 0; k < 3; ++k) {
            square += coords.data[3 * i + k] * coords.data[3 * i + k];
            along += coords.data[3 * i + k] * normals.data[3 * i + k];
        }
        CHECK(square > 0.999999 && square < 1.000001 && along > 0.999999);
    }
    CHECK(medax_samples_spacing(samples) == 0.3);
    CHECK(medax_samples_area(samples) > 12 && medax_samples_area(samples) < 13.2);
    CHECK_STATUS(OK, medax_samples_complex(samples, &complex));
    CHECK_STATUS(NULL_ARGUMENT, medax_samples_complex(samples, NULL));
    CHECK_STATUS(OK, medax_complex_attribute(complex, MEDAX_ELEMENT_VERTEX, "normal", &normal));
    CHECK(normal.f64_values.rows == coords.rows && normal.f64_values.cols == 3);

    /* From the samples a surface, and from the surface samples again. */
    CHECK_STATUS(OK,
                 medax_points_create_f64(coords.data, coords.rows, 0, NULL, NULL, &points));
    CHECK_STATUS(OK, medax_power_crust_build(points, NULL, NULL, &crust));
    CHECK_STATUS(OK, medax_power_crust_surface(crust, &mesh));
    const medax_samples *more = NULL, *none = UNTOUCHED;
    CHECK_STATUS(OK, medax_samples_build_from_mesh(mesh, &options, NULL, &more));
    CHECK(medax_samples_coords(more).rows > 50);
    CHECK_STATUS(DEGENERATE, medax_samples_build_from_mesh(complex, NULL, NULL, &none));
    CHECK_STATUS(NULL_ARGUMENT, medax_samples_build_from_mesh(NULL, NULL, NULL, &none));
    CHECK_STATUS(NULL_ARGUMENT, medax_samples_build_from_mesh(mesh, NULL, NULL, NULL));
    CHECK(none == UNTOUCHED);
    const medax_samples *again = medax_samples_clone(samples);
    medax_samples_free(samples);
    CHECK(again == samples && medax_samples_coords(again).data == coords.data);
    medax_samples_free(again);
    medax_samples_free(more);
    medax_complex_free(mesh);
    medax_complex_free(complex);
    medax_power_crust_free(crust);
    medax_points_free(points);
}

static void refusals(void) {
    const double nan = strtod("nan", NULL), bad[] = {nan, -1, strtod("inf", NULL)};
    const medax_samples *samples = UNTOUCHED;
    const medax_complex *complex = NULL;
    const medax_job *spent = NULL;
    medax_sample_options options;
    NEED(medax_job_create(NULL, &spent) == MEDAX_STATUS_OK);
    medax_job_cancel(spent);
    CHECK_STATUS(NULL_ARGUMENT, medax_sample_options_init(NULL, sizeof options));
    CHECK_STATUS(INVALID_ARGUMENT, medax_sample_options_init(&options, 32));
    CHECK_STATUS(INVALID_ARGUMENT, medax_samples_build(8, NULL, NULL, &samples));
    CHECK_STATUS(NULL_ARGUMENT, medax_samples_build(0, NULL, NULL, NULL));
    CHECK_STATUS(CANCELLED, medax_samples_build(0, NULL, spent, &samples));
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        for (size_t field = 0; field < 3; ++field) {
            CHECK_STATUS(OK, medax_sample_options_init(&options, sizeof options));
            *(field == 0 ? &options.spacing : field == 1 ? &options.density : &options.noise) = bad[i];
            CHECK_STATUS(INVALID_ARGUMENT, medax_samples_build(0, &options, NULL, &samples));
        }
    }
    medax_sample_options_init(&options, sizeof options);
    options.spacing = options.density = 1;
    CHECK_STATUS(INVALID_ARGUMENT, medax_samples_build(0, &options, NULL, &samples));
    CHECK(samples == UNTOUCHED);
    CHECK_STATUS(NULL_ARGUMENT, medax_samples_complex(NULL, &complex));
    CHECK(medax_samples_coords(NULL).rows == 0 && medax_samples_normals(NULL).cols == 3);
    CHECK(medax_samples_spacing(NULL) == 0 && medax_samples_area(NULL) == 0);
    CHECK(medax_samples_clone(NULL) == NULL && complex == NULL);
    medax_samples_free(NULL);
    medax_job_free(spent);
}

int main(void) {
    shapes();
    a_sphere();
    refusals();
    return check_end();
}
