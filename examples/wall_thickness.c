/* How thick the walls of a part are, at the vertices of its mesh. */
#include <medax.h>
#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv) {
    const medax_complex *part = NULL, *sized = NULL;
    const medax_samples *samples = NULL;
    const medax_points *points = NULL;
    const medax_power_crust *crust = NULL, *labelled = NULL;
    medax_power_crust_options options;
    medax_view_f64 xyz;
    medax_attribute thickness;
    size_t thin = 0, i;
    char *end = NULL;
    const double limit = argc == 4 ? strtod(argv[2], &end) : 0;
    int failed;
    if (argc != 4 || end == argv[2] || *end != 0) {
        fprintf(stderr, "usage: wall_thickness PART LIMIT MESH\n");
        return 2;
    }
    failed = medax_complex_read(argv[1], NULL, &part)
        || medax_samples_build_from_mesh(part, NULL, NULL, &samples);
    xyz = medax_samples_coords(samples);
    /* The part has sharp edges; its own faces tell inside from outside. */
    failed = failed || medax_power_crust_options_init(&options, sizeof options);
    options.omit = MEDAX_OMIT_BOTH;
    failed = failed
        || medax_points_create_f64(xyz.data, xyz.rows, 0, NULL, NULL, &points)
        || medax_power_crust_build(points, &options, NULL, &crust)
        || medax_power_crust_labelled_by_mesh(crust, part, NULL, &labelled)
        || medax_power_crust_with_sizes(labelled, part, NULL, &sized)
        || medax_complex_attribute(sized, MEDAX_ELEMENT_VERTEX, "thickness", &thickness)
        || medax_complex_write(sized, argv[3], NULL, NULL, NULL);
    if (failed) {
        fprintf(stderr, "%s\n", medax_last_error_message());
    } else {
        for (i = 0; i < thickness.f64_values.rows; ++i)
            thin += thickness.f64_values.data[i] < limit;
        printf("%zu samples, %zu vertices, %zu thinner than %s\n", medax_points_count(points), i, thin, argv[2]);
    }
    medax_power_crust_free(labelled);
    medax_power_crust_free(crust);
    medax_points_free(points);
    medax_samples_free(samples);
    medax_complex_free(sized);
    medax_complex_free(part);
    return failed;
}
