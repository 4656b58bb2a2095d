// What medax says, through its C++ layer over the C ABI, as plain arrays.
#pragma once

#include "reference.hpp"

#include <medax.hpp>

#include <string>
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

Triangulation delaunay(const std::vector<Point>& rows);
Triangulation regular(const std::vector<Point>& rows, const std::vector<double>& weights);

}  // namespace subject
