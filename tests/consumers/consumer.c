/* What any program does first: the library is the header's, and merges equal points. */
#include <medax.h>
#include <stdio.h>

int main(void) {
    const double xyz[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0};
    const medax_points *points = NULL;
    size_t count;
    if (medax_version() != MEDAX_VERSION) {
        fprintf(stderr, "the header is of another version than the library\n");
        return 1;
    }
    if (medax_points_create_f64(xyz, 5, 3 * sizeof *xyz, NULL, NULL, &points) != MEDAX_STATUS_OK) {
        fprintf(stderr, "%s\n", medax_last_error_message());
        return 1;
    }
    count = medax_points_count(points);
    printf("medax %s: %zu points\n", medax_version_string(), count);
    medax_points_free(points);
    return count == 4 ? 0 : 1;
}
