/* The poles of a file of points, with the radii of their balls. */
#include <medax.h>
#include <stdio.h>

int main(int argc, char **argv) {
    const medax_points *points = NULL;
    const medax_triangulation *triangulation = NULL;
    const medax_dual *dual = NULL;
    const medax_poles *poles = NULL;
    const medax_complex *balls = NULL;
    int failed = argc != 3
        || medax_points_read(argv[1], NULL, NULL, &points)
        || medax_delaunay_build(points, NULL, NULL, &triangulation)
        || medax_dual_build(triangulation, NULL, NULL, &dual)
        || medax_poles_build(dual, NULL, NULL, &poles)
        || medax_poles_complex(poles, &balls)
        || medax_complex_write(balls, argv[2], NULL, NULL, NULL);
    if (failed)
        fprintf(stderr, "%s\n", argc == 3 ? medax_last_error_message() : "usage: poles POINTS POLES");
    else
        printf("%zu samples, %zu poles\n", medax_points_count(points), medax_poles_balls(poles).rows);
    medax_complex_free(balls);
    medax_poles_free(poles);
    medax_dual_free(dual);
    medax_triangulation_free(triangulation);
    medax_points_free(points);
    return failed;
}
