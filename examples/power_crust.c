#include <medax.h>
#include <stdio.h>

int main(int argc, char **argv) {
    const medax_points *points = NULL;
    const medax_power_crust *crust = NULL;
    const medax_complex *surface = NULL;
    int failed = argc != 3
        || medax_points_read(argv[1], NULL, NULL, &points)
        || medax_power_crust_build(points, NULL, NULL, &crust)
        || medax_power_crust_surface(crust, &surface)
        || medax_complex_write(surface, argv[2], NULL, NULL, NULL);
    if (failed)
        fprintf(stderr, "%s\n", argc == 3 ? medax_last_error_message() : "usage: power_crust POINTS MESH");
    else
        printf("%zu samples, %zu faces\n", medax_points_count(points), medax_complex_faces(surface).rows);
    medax_complex_free(surface);
    medax_power_crust_free(crust);
    medax_points_free(points);
    return failed;
}
