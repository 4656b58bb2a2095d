// SPDX-License-Identifier: MIT OR Apache-2.0
// Checks what MeshLab wrote: outputs <what> <file> [<samples>].

#include <medax.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>

namespace {

void require(bool holds, const std::string &what) {
    if (!holds) throw std::runtime_error(what);
}

medax::View<double> quality(const medax::File &file) {
    const auto found = file.attribute(MEDAX_ELEMENT_VERTEX, "quality");
    require(found.f64_values.rows() == file.vertices().rows(), "there is no quality");
    return found.f64_values;
}

double distance(medax::Span<double> a, medax::Span<double> b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// The quality of every vertex is the distance to the nearest sample, and the vertex is near the torus' circle of centres.
void check_radii(const medax::File &file, const medax::File &samples) {
    const auto vertices = file.vertices(), points = samples.vertices(), radius = quality(file);
    require(!vertices.empty(), "there are no vertices");
    double worst = 0, off = 0;
    for (std::size_t v = 0; v < vertices.rows(); ++v) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t p = 0; p < points.rows(); ++p)
            nearest = std::min(nearest, distance(vertices[v], points[p]));
        worst = std::max(worst, std::abs(nearest - radius[v][0]));
        const auto at = vertices[v];
        off = std::max(off, std::hypot(std::hypot(at[0], at[1]) - 1, at[2]));
    }
    std::cout << vertices.rows() << " vertices, radii wrong by " << worst
              << " at most, off the circle by " << off << '\n';
    // MeshLab keeps floats.
    require(worst < 1e-6, "the quality is not the radius");
    require(off < 0.05, "vertices are not on the axis of the torus");
}

void check_surface(const std::string &path) {
    const auto surface = medax::Complex::read(path);
    const auto topology = surface.topology();
    const auto measure = surface.measure();
    std::cout << surface.faces().rows() << " faces, volume " << measure.volume << '\n';
    require(topology.components == 1, "the surface is not connected");
    require(topology.closed == 1, "the surface is not closed");
    require(topology.has_genus == 1 && topology.genus == 1, "the genus is not 1");
    // A torus of radii 1 and 0.4.
    const double volume = 2 * std::pow(std::acos(-1.0) * 0.4, 2);
    require(std::abs(measure.volume - volume) < 0.02 * volume, "the volume is wrong");
}

void check_axis(const std::string &path, const std::string &samples) {
    const auto file = medax::File::read(path);
    const auto topology = file.complex().topology();
    require(!file.faces().empty(), "the axis has no faces");
    require(topology.components == 1 && topology.betti[1] == 1, "the axis is no ring");
    check_radii(file, medax::File::read(samples));
}

/// At a point of a box's face the ball touches the opposite face, or the nearest other one.
void check_thickness(const std::string &path) {
    const auto file = medax::File::read(path);
    const auto vertices = file.vertices(), thickness = quality(file);
    const double sides[] = {4, 3, 1};
    double worst = 0, worst_middle = 0;
    for (std::size_t v = 0; v < vertices.rows(); ++v) {
        double to[3];
        for (int k = 0; k < 3; ++k) to[k] = std::min(vertices[v][k], sides[k] - vertices[v][k]);
        const double value = thickness[v][0];
        // By the two large faces alone; the others are as high as the ball.
        if (to[2] > 1e-6) continue;
        const double expected = std::min(1.0, 2 * std::min(to[0], to[1]));
        worst = std::max(worst, std::abs(value - expected));
        if (std::min(to[0], to[1]) > 0.6)
            worst_middle = std::max(worst_middle, std::abs(value - 1));
    }
    std::cout << vertices.rows() << " vertices, wrong by " << worst << " at most, in the middle by "
              << worst_middle << '\n';
    require(worst_middle < 0.01, "the thickness is wrong");
    // The spacing is a hundredth of the diagonal; the nearest sample, and the other side of its ball, may be a little more from
    // where they would be best.
    require(worst < 6 * 0.051, "the thickness is wrong near edges");
}

}  // namespace

int main(int, char **argv) try {
    const std::string what = argv[1], path = argv[2];
    if (what == "surface") check_surface(path);
    if (what == "axis") check_axis(path, argv[3]);
    if (what == "core") check_radii(medax::File::read(path), medax::File::read(argv[3]));
    if (what == "thickness") check_thickness(path);
    return 0;
} catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 1;
}
