// The poles of S + Z against exact circumcentres, labels and facets of the power crust against the same
// labelling on CGAL's regular triangulation of the same balls, the surface in OpenMesh.
#include "clouds.hpp"
#include "labels.hpp"
#include "models.hpp"
#include "poles.hpp"
#include "report.hpp"
#include "solid.hpp"
#include "subject.hpp"

#include <algorithm>
#include <cmath>

namespace {

using reference::Cell;
using reference::none;
using reference::Point;

// What is wrong with the labels and facets, or nothing.
std::string wrong_crust(const subject::Crust& medax, bool round_poles) {
    reference::Balls balls;
    for (const auto& ball : medax.poles.balls) {
        balls.centres.push_back(centre_of(ball));
        balls.radii.push_back(ball[3]);
    }
    balls.samples.assign(medax.poles.vertices.begin(), medax.poles.vertices.end() - 8);
    balls.pole_of_sample = medax.poles.pole_of_sample;
    balls.seed = medax.poles.touches_far_box;
    reference::Rounded weighted{balls.centres, medax.poles.radii_squared};
    if (round_poles) weighted = reference::rounded(balls.centres, balls.samples, balls.pole_of_sample);
    const reference::Triangulation regular = reference::regular(weighted.centres, weighted.weights);

    std::vector<Cell> ours(medax.regular_cells.begin(), medax.regular_cells.end());
    std::vector<bool> visible(balls.centres.size());
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
    balls.sites = weighted.centres;
    balls.weights = weighted.weights;
    balls.rank.assign(visible.size(), none);
    for (std::uint32_t v = 0; v < medax.pole_of_vertex.size(); ++v) balls.rank[medax.pole_of_vertex[v]] = v;

    const reference::Crust crust = reference::power_crust(balls, regular, 0.4);
    std::size_t differing = 0;
    for (std::size_t p = 0; p < balls.centres.size(); ++p) differing += medax.inner.at(p) != crust.inner[p];
    if (differing != 0) return std::to_string(differing) + " labels differ";
    if (medax.forced != crust.forced) return "CGAL's crust forces " + std::to_string(crust.forced) + " poles";
    auto facets = medax.facets;
    std::sort(facets.begin(), facets.end());
    return facets == crust.facets ? "" : "the facets differ";
}

void compare(const std::string& name, const std::vector<Point>& rows, bool round_poles, Report& report) {
    const subject::Crust medax = subject::power_crust(rows, round_poles);
    std::string text = std::to_string(medax.poles.pole_of_sample.size()) + " samples, " + std::to_string(medax.poles.balls.size()) + " poles, " +
                       std::to_string(medax.facets.size()) + " facets";
    std::string wrong = wrong_poles(medax.poles);
    if (!medax.solid) {
        std::vector<Point> centres;
        for (const auto& ball : medax.poles.balls) centres.push_back(centre_of(ball));
        if (wrong.empty() && !reference::is_flat(centres)) wrong = "the poles do not lie in a plane, as medax says";
        return report.line(wrong.empty(), name, wrong.empty() ? text + " in a plane" : text + ": " + wrong);
    }
    if (wrong.empty()) wrong = wrong_crust(medax, round_poles);
    const Solid whole = load_into_openmesh(medax.with_shards.vertices, medax.with_shards.triangles);
    const Solid merged = load_into_openmesh(medax.merged.vertices, medax.merged.triangles);
    text += ", Euler characteristic " + std::to_string(whole.euler_characteristic);
    if (medax.forced != 0) text += ", " + std::to_string(medax.forced) + " forced";
    for (const Solid& solid : {whole, merged})
        if (!solid.closed_manifold())
            wrong += "; not closed in OpenMesh: " + std::to_string(solid.boundary_edges) + " boundary edges, " +
                     std::to_string(solid.complex_faces) + " complex faces, " + std::to_string(solid.complex_vertices) +
                     " complex and " + std::to_string(solid.isolated_vertices) + " isolated vertices";
    if (merged.euler_characteristic != whole.euler_characteristic)
        wrong += "; merging shards makes the Euler characteristic " + std::to_string(merged.euler_characteristic);
    report.line(wrong.empty(), name, wrong.empty() ? text : text + ": " + wrong);
}

}  // namespace

int main() {
    Report report;
    for (const Cloud& cloud : plain_clouds()) compare(cloud.name, cloud.rows, false, report);
    for (const Model& shape : shapes()) {
        compare(shape.name, shape.points, false, report);
        compare(shape.name + ", rounded", shape.points, true, report);
    }
    for (const Cloud& cloud : plain_clouds()) compare(cloud.name + ", rounded", cloud.rows, true, report);
    for (const Model& model : models(50000)) compare(model.name, model.points, false, report);
    return report.finish("power crusts like CGAL's, closed in OpenMesh");
}
