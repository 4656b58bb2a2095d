// A watertight mesh of a file of points.
#include <medax.hpp>

#include <iostream>

int main(int argc, char **argv) {
    if (argc != 3) {
        std::cerr << "usage: power_crust POINTS MESH\n";
        return 1;
    }
    try {
        const auto points = medax::Points::read(argv[1]);
        const auto surface = medax::PowerCrust::of(points).surface();
        surface.write(argv[2]);
        std::cout << points.count() << " samples, " << surface.faces().rows() << " faces\n";
    } catch (const medax::Error &error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
