// How thick the walls of a part are, at the vertices of its mesh.
#include <medax.hpp>

#include <algorithm>
#include <cstdlib>
#include <iostream>

int main(int argc, char **argv) {
    char *end = nullptr;
    const double limit = argc == 4 ? std::strtod(argv[2], &end) : 0;
    if (argc != 4 || end == argv[2] || *end != 0) {
        std::cerr << "usage: wall_thickness PART LIMIT MESH\n";
        return 2;
    }
    try {
        const auto part = medax::Complex::read(argv[1]);
        const auto points = medax::Samples::of(part).points();
        // The part has sharp edges; its own faces tell inside from outside.
        medax::PowerCrustOptions options;
        options.omit = MEDAX_OMIT_BOTH;
        const auto crust = medax::PowerCrust::of(points, options).labelled_by_mesh(part);
        const auto sized = crust.with_sizes(part);
        sized.write(argv[3]);
        const auto thickness = sized.attribute(MEDAX_ELEMENT_VERTEX, "thickness").f64_values;
        const auto thin = std::count_if(thickness.begin(), thickness.end(), [&](double t) { return t < limit; });
        std::cout << points.count() << " samples, " << thickness.rows() << " vertices, " << thin
                  << " thinner than " << argv[2] << '\n';
    } catch (const medax::Error &error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
