// What medax says, through its C++ layer over the C ABI, as plain arrays.
#pragma once

#include "reference.hpp"

#include <medax.hpp>

#include <string>
#include <utility>
#include <vector>

namespace subject {

using reference::Cell;
using reference::Point;

struct Triangulation {
    std::vector<Point> vertices;
    std::vector<std::array<std::uint32_t, 4>> cells, neighbors;
    std::vector<double> weights;               // one a vertex, or none
    std::vector<std::uint32_t> hidden;         // vertices
    std::vector<std::uint32_t> vertex_of_row;  // none for a row left out
    std::vector<std::uint32_t> duplicate_of;   // rows
};

// The distinct points of a file, without rows that are not finite.
std::vector<Point> read(const std::string& path);

// Samples of each built-in shape, with its name.
std::vector<std::pair<std::string, std::vector<Point>>> shapes();

Triangulation delaunay(const std::vector<Point>& rows);
Triangulation regular(const std::vector<Point>& rows, const std::vector<double>& weights);

// Poles with what they were made from.
struct Poles {
    std::vector<Point> vertices;  // the samples, then the far box if there is one
    std::vector<std::array<std::uint32_t, 4>> cells;
    std::vector<std::array<double, 4>> balls;
    std::vector<double> radii_squared;
    std::vector<std::uint32_t> cell_of_pole;
    std::vector<bool> touches_far_box;
    std::vector<std::array<std::uint32_t, 2>> pole_of_sample;
    std::vector<Point> normals;
};

// The poles of a sample alone.
Poles poles(const std::vector<Point>& samples);

// A power crust. Poles are numbered by medax.
struct Crust {
    Poles poles;
    bool solid = true;  // false: medax says that the poles lie in a plane, and the rest is empty
    std::vector<std::array<std::uint32_t, 4>> regular_cells;  // of vertices
    std::vector<std::uint32_t> pole_of_vertex;
    std::vector<bool> inner;  // one a pole
    std::size_t forced = 0;
    std::vector<std::array<std::uint32_t, 2>> facets;  // (inner pole, outer pole), one a face
    // The surface with the shards of samples, of which the facets are, and with these merged.
    struct Surface {
        std::vector<Point> vertices;
        std::vector<std::array<std::uint32_t, 3>> triangles;
    };
    Surface with_shards, merged;
};

Crust power_crust(const std::vector<Point>& samples, bool round_poles);

// What MEDIAL selects of a sample.
struct Axis {
    std::vector<Point> vertices;
    std::vector<Point> directions;  // to the first pole of each sample
    std::vector<reference::Edge> edges;  // ascending
    double delaunay_seconds = 0, filter_seconds = 0;  // by one thread
};

Axis medial(const std::vector<Point>& samples, double theta, double rho);

}  // namespace subject
