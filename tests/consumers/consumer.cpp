// A tetrahedron with a point inside: four cells; a NaN: an exception that says which row.
#include <medax.hpp>

#include <cmath>
#include <iostream>

int main() {
    std::vector<medax::Point> rows{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {0.5, 0.5, 0.5}};
    const auto triangulation = medax::Triangulation::delaunay(medax::Points::from(rows));
    std::cout << triangulation.cells().rows() << " cells\n";
    rows[3][1] = NAN;
    try {
        medax::Points::from(rows);
    } catch (const medax::Error &error) {
        std::cout << error.what() << '\n';
        return triangulation.cells().rows() == 4 && error.index() == 3 ? 0 : 1;
    }
    return 1;
}
