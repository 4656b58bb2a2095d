// Poles against exact circumcentres, labels and facets of the power crust against the same labelling
// on CGAL's regular triangulation of the same balls, the surface in OpenMesh.
#include "clouds.hpp"
#include "labels.hpp"
#include "models.hpp"
#include "report.hpp"
#include "solid.hpp"
#include "subject.hpp"

#include <algorithm>
#include <cmath>

namespace {

using reference::Cell;
using reference::none;
using reference::Point;

std::vector<Cell> sorted(std::vector<Cell> cells) {
    for (Cell& cell : cells) std::sort(cell.begin(), cell.end());
    std::sort(cells.begin(), cells.end());
    return cells;
}

Point centre_of(const std::array<double, 4>& ball) { return {ball[0], ball[1], ball[2]}; }

// What is wrong with the poles of S + Z, or nothing.
std::string wrong_poles(const subject::Crust& medax, std::size_t& near_ties) {
    const std::size_t sample_count = medax.pole_of_sample.size();
    if (medax.vertices.size() != sample_count + 8) return "the far box has not eight points";
    const std::vector<Cell> cells(medax.cells.begin(), medax.cells.end());
    if (sorted(cells) != reference::delaunay(medax.vertices).cells) return "the cells of S + Z differ";
    const reference::Poles exact = reference::poles(medax.vertices, sample_count, cells);
    near_ties = exact.near_ties;

    std::vector<bool> far_vertex(cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c)
        for (std::uint32_t v : cells[c])
            if (v >= sample_count) far_vertex[exact.vertex_of_cell[c]] = true;
    std::vector<bool> chosen(cells.size());
    for (std::size_t p = 0; p < medax.balls.size(); ++p) {
        const std::uint32_t cell = medax.cell_of_pole[p];
        const double squared = exact.radius_squared[cell];
        if (centre_of(medax.balls[p]) != exact.centre[cell]) return "the centre of pole " + std::to_string(p);
        if (medax.radii_squared[p] != squared || medax.balls[p][3] != std::sqrt(squared))
            return "the radius of pole " + std::to_string(p);
        if (chosen[exact.vertex_of_cell[cell]]) return "one Voronoi vertex is two poles";
        chosen[exact.vertex_of_cell[cell]] = true;
        // The whole Delaunay polytope counts, not only the cell that stands for it.
        if (medax.touches_far_box[p] != far_vertex[exact.vertex_of_cell[cell]])
            return "whether pole " + std::to_string(p) + " touches the far box";
    }
    std::size_t differing = 0;
    for (std::size_t s = 0; s < sample_count; ++s)
        for (int side : {0, 1}) {
            const std::uint32_t pole = medax.pole_of_sample[s][side];
            const std::uint32_t vertex = pole == none ? none : exact.vertex_of_cell[medax.cell_of_pole.at(pole)];
            differing += vertex != exact.pole_of_sample[s][side];
        }
    return differing == 0 ? "" : std::to_string(differing) + " poles of samples differ";
}

// What is wrong with the labels and facets, or nothing.
std::string wrong_crust(const subject::Crust& medax) {
    reference::Balls balls;
    for (const auto& ball : medax.balls) {
        balls.centres.push_back(centre_of(ball));
        balls.radii.push_back(ball[3]);
    }
    balls.samples.assign(medax.vertices.begin(), medax.vertices.end() - 8);
    balls.pole_of_sample = medax.pole_of_sample;
    balls.seed = medax.touches_far_box;
    const reference::Triangulation regular = reference::regular(balls.centres, medax.radii_squared);

    std::vector<Cell> ours(medax.regular_cells.begin(), medax.regular_cells.end());
    std::vector<bool> visible(medax.balls.size());
    for (Cell& cell : ours)
        for (std::uint32_t& v : cell) {
            v = medax.pole_of_vertex.at(v);
            visible[v] = true;
        }
    if (sorted(ours) != regular.cells) return "the regular triangulation differs";
    std::vector<std::uint32_t> hidden;
    for (std::uint32_t p = 0; p < visible.size(); ++p)
        if (!visible[p]) hidden.push_back(p);
    if (hidden != regular.hidden) return "the hidden poles differ";

    const reference::Crust crust = reference::power_crust(balls, regular, 0.4);
    std::size_t differing = 0;
    for (std::size_t p = 0; p < balls.centres.size(); ++p) differing += medax.inner.at(p) != crust.inner[p];
    if (differing != 0) return std::to_string(differing) + " labels differ";
    if (medax.forced != crust.forced) return "CGAL's crust forces " + std::to_string(crust.forced) + " poles";
    auto facets = medax.facets;
    std::sort(facets.begin(), facets.end());
    return facets == crust.facets ? "" : "the facets differ";
}

void compare(const std::string& name, const std::vector<Point>& rows, Report& report) {
    const subject::Crust medax = subject::power_crust(rows);
    std::string text = std::to_string(medax.pole_of_sample.size()) + " samples, " + std::to_string(medax.balls.size()) + " poles, " +
                       std::to_string(medax.facets.size()) + " facets";
    std::size_t near_ties = 0;
    std::string wrong = wrong_poles(medax, near_ties);
    if (!medax.solid) {
        std::vector<Point> centres;
        for (const auto& ball : medax.balls) centres.push_back(centre_of(ball));
        if (wrong.empty() && !reference::is_flat(centres)) wrong = "the poles do not lie in a plane, as medax says";
        return report.line(wrong.empty(), name, wrong.empty() ? text + " in a plane" : text + ": " + wrong);
    }
    if (wrong.empty()) wrong = wrong_crust(medax);
    const Solid solid = load_into_openmesh(medax.surface_vertices, medax.surface_triangles);
    text += ", Euler characteristic " + std::to_string(solid.euler_characteristic);
    if (medax.forced != 0) text += ", " + std::to_string(medax.forced) + " forced";
    if (near_ties != 0) text += ", " + std::to_string(near_ties) + " first poles tied but for rounding";
    if (!solid.closed_manifold())
        wrong += "; not closed in OpenMesh: " + std::to_string(solid.boundary_edges) + " boundary edges, " +
                 std::to_string(solid.complex_faces) + " complex faces, " + std::to_string(solid.complex_vertices) +
                 " complex and " + std::to_string(solid.isolated_vertices) + " isolated vertices";
    report.line(wrong.empty(), name, wrong.empty() ? text : text + ": " + wrong);
}

}  // namespace

int main() {
    Report report;
    for (const Cloud& cloud : plain_clouds()) compare(cloud.name, cloud.rows, report);
    for (const Model& model : models(50000)) compare(model.name, model.points, report);
    return report.finish("power crusts like CGAL's, closed in OpenMesh");
}
