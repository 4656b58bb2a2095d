// The poles of a file of points, with the radii of their balls.
#include <medax.hpp>

#include <iostream>

int main(int argc, char **argv) {
    if (argc != 3) {
        std::cerr << "usage: poles POINTS POLES\n";
        return 1;
    }
    try {
        const auto points = medax::Points::read(argv[1]);
        const auto triangulation = medax::Triangulation::delaunay(points);
        const auto poles = medax::Poles::of(medax::Dual::of(triangulation));
        poles.complex().write(argv[2]);
        std::cout << points.count() << " samples, " << poles.balls().rows() << " poles\n";
    } catch (const medax::Error &error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
