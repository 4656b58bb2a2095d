/* points FILE: writes a thousand points of an ellipsoid, evenly spread along a spiral. */
#include <math.h>
#include <stdio.h>

int main(int argc, char **argv) {
    const int count = 1000;
    FILE *file = argc == 2 ? fopen(argv[1], "w") : NULL;
    int i;
    if (file == NULL) return 1;
    for (i = 0; i < count; ++i) {
        const double z = 1 - (2 * i + 1.0) / count, r = sqrt(1 - z * z), angle = 2.39996322972865332 * i;
        fprintf(file, "%.17g %.17g %.17g\n", 2 * r * cos(angle), 1.5 * r * sin(angle), z);
    }
    return fclose(file);
}
