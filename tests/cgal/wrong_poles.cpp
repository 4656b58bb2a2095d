#include "poles.hpp"

#include <algorithm>
#include <cmath>

using reference::Cell;
using reference::none;
using reference::Point;

std::vector<Cell> sorted(std::vector<Cell> cells) {
    for (Cell& cell : cells) std::sort(cell.begin(), cell.end());
    std::sort(cells.begin(), cells.end());
    return cells;
}

std::string wrong_poles(const subject::Poles& medax) {
    const std::size_t sample_count = medax.pole_of_sample.size();
    const std::vector<Cell> cells(medax.cells.begin(), medax.cells.end());
    if (sorted(cells) != reference::delaunay(medax.vertices).cells) return "the Delaunay cells differ";
    const reference::Poles exact = reference::poles(medax.vertices, sample_count, cells, medax.normals);

    std::vector<bool> far_vertex(cells.size()), chosen(cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c)
        for (std::uint32_t v : cells[c])
            if (v >= sample_count) far_vertex[exact.vertex_of_cell[c]] = true;
    for (std::size_t p = 0; p < medax.balls.size(); ++p) {
        const std::uint32_t cell = medax.cell_of_pole.at(p), vertex = exact.vertex_of_cell.at(cell);
        const double squared = exact.radius_squared[cell];
        if (cell != vertex) return "the cell of pole " + std::to_string(p) + " is not the least of its centre";
        if (centre_of(medax.balls[p]) != exact.centre[cell]) return "the centre of pole " + std::to_string(p);
        if (medax.radii_squared.at(p) != squared || medax.balls[p][3] != std::sqrt(squared))
            return "the radius of pole " + std::to_string(p);
        if (chosen[vertex]) return "one Voronoi vertex is two poles";
        chosen[vertex] = true;
        // The whole Delaunay polytope counts, not only the cell that stands for it.
        if (medax.touches_far_box.at(p) != far_vertex[vertex])
            return "whether pole " + std::to_string(p) + " touches the far box";
    }
    std::size_t differing = 0;
    for (std::size_t s = 0; s < sample_count; ++s) {
        for (int side : {0, 1}) {
            const std::uint32_t pole = medax.pole_of_sample[s][side];
            const std::uint32_t vertex = pole == none ? none : medax.cell_of_pole.at(pole);
            differing += vertex != exact.pole_of_sample[s][side];
        }
        // The sum of many unit vectors may be short: its direction is good to a few digits less.
        if (const Point& out = exact.to_infinity[s]; out != Point{0, 0, 0}) {
            const Point& normal = medax.normals.at(s);
            for (int i = 0; i < 3; ++i)
                if (!(std::abs(out[i] - normal[i]) < 1e-9)) return "the direction to infinity of sample " + std::to_string(s);
        }
    }
    return differing == 0 ? "" : std::to_string(differing) + " poles of samples differ";
}
