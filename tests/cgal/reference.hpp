// What CGAL says: plain arrays out, so that only the reference's own files compile CGAL.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace reference {

using Point = std::array<double, 3>;
// Four indices into the caller's points, ascending.
using Cell = std::array<std::uint32_t, 4>;

// "None": as MEDAX_NONE.
constexpr std::uint32_t none = UINT32_MAX;

struct Triangulation {
    std::vector<Cell> cells;            // finite cells, sorted
    std::vector<std::uint32_t> hidden;  // points that no cell uses, ascending
};

// CGAL::Delaunay_triangulation_3 (EPICK) of distinct points.
Triangulation delaunay(const std::vector<Point>& points);

// CGAL::Regular_triangulation_3 (EPICK) of rows that may repeat a position. A row is hidden when the
// triangulation shows another row of its position, or none at all; of equal rows the first is shown.
Triangulation regular(const std::vector<Point>& rows, const std::vector<double>& weights);

// The sign of the determinant of q - p, r - p, s - p, exactly.
int orientation(const Point& p, const Point& q, const Point& r, const Point& s);

// Voronoi vertices and poles, decided with exact constructions.
struct Poles {
    std::vector<Cell> cells;                    // the Delaunay cells, sorted
    std::vector<std::uint32_t> vertex_of_cell;  // the least cell of the same circumcentre
    // The Voronoi vertices (as least cells) that are a sample's first and second pole, or none. A
    // sample on the hull has its first pole at infinity: both are left none.
    std::vector<std::array<std::uint32_t, 2>> pole_of_sample;
    std::vector<bool> on_hull;
};

// The poles of distinct points: the farthest Voronoi vertex, then the farthest one whose vector has
// a negative scalar product with the first; equally far ones by their coordinates, least first.
Poles poles(const std::vector<Point>& points);

// Whether `centre` is the circumcentre of the cell, each coordinate one of the two doubles about it.
bool is_circumcentre(const std::vector<Point>& points, const Cell& cell, const Point& centre);

}  // namespace reference
