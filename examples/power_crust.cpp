// A watertight mesh and the inner medial axis of a file of points.
#include <medax.hpp>

#include <iostream>

int main(int argc, char **argv) {
    if (argc != 4) {
        std::cerr << "usage: power_crust POINTS MESH AXIS\n";
        return 2;
    }
    try {
        const auto points = medax::Points::read(argv[1]);
        const auto crust = medax::PowerCrust::of(points);
        crust.surface().write(argv[2]);
        crust.shape(MEDAX_LABEL_INNER).write(argv[3]);
        std::cout << points.count() << " samples, " << crust.poles().balls().rows() << " poles, "
                  << crust.surface().faces().rows() << " faces\n";
    } catch (const medax::Error &error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
