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

// Whether all points lie in a plane, exactly.
bool is_flat(const std::vector<Point>& points);

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

// Voronoi vertices and poles, from exact circumcentres.
struct Poles {
    std::vector<Point> centre;                  // of each cell, every coordinate the nearest double
    std::vector<double> radius_squared;         // of each cell, the nearest double
    std::vector<std::uint32_t> vertex_of_cell;  // the least cell of the same circumcentre
    // The Voronoi vertices (as least cells) that are the first and the second pole of each of the first
    // `sample_count` points, or none.
    std::vector<std::array<std::uint32_t, 2>> pole_of_sample;
    // For points on the hull the mean of the unit outward normals of its hull facets, made a unit vector; 0 for
    // others. Their first pole lies at infinity.
    std::vector<Point> to_infinity;
};

// The poles of the first `sample_count` points: the farthest Voronoi vertex, then the farthest one at an
// obtuse angle to it. Distances are compared as the nearest doubles of their exact squares, equal
// ones by the coordinates of the centres, least first, then by cell. `cells` are those of the Delaunay
// triangulation. Where the first pole is at infinity, `directions` has the direction to which the
// angle is taken, for every sample.
Poles poles(const std::vector<Point>& points, std::size_t sample_count, const std::vector<Cell>& cells,
            const std::vector<Point>& directions);

// Two vertices, ascending.
using Edge = std::array<std::uint32_t, 2>;

// What MEDIAL selects.
struct Axis {
    std::vector<Edge> edges;  // ascending
    std::vector<Edge> near;   // those of which a condition is within 1e-9 of its threshold, selected or not; ascending
    double delaunay_seconds = 0, filter_seconds = 0;  // with rounded Voronoi vertices; the edges are decided with exact ones
};

// MEDIAL with both conditions, as the paper has it, on CGAL. The pole of a point on the hull lies in the direction that `directions` has
// for it.
Axis medial(const std::vector<Point>& points, const std::vector<Point>& directions, double theta, double rho);

// What CGAL::Surface_mesh makes of triangles.
struct Surface {
    bool oriented_manifold = false;  // if not, the rest is empty
    bool closed = false;
    double volume = 0;
    long euler_characteristic = 0;
    // Pairs of triangles that meet anywhere but in what they share; twice the same one where it has no area.
    std::vector<std::array<std::uint32_t, 2>> meeting;
};
Surface surface(const std::vector<Point>& points, const std::vector<std::array<std::uint32_t, 3>>& triangles);

// A point on the way between two others, by a number from 0 to 1: not rounded.
struct Between {
    Point from, to;
    double t;
};
// Whether two triangles meet anywhere but in corners that they share, or one has no area. The first three corners are of one.
bool meet(const std::array<Between, 6>& corners, const std::array<std::uint32_t, 6>& names);

using PlanePoint = std::array<double, 2>;
using PlaneSegment = std::array<PlanePoint, 2>;
using Polylines = std::vector<std::vector<PlanePoint>>;

// The part of the Voronoi diagram of segments that lies inside the polygons of which they are the sides, but for edges
// between a segment and its own end. Its points are no farther apart than the step.
struct PlaneAxis {
    Polylines lines;
    double seconds = 0;  // of the diagram
};
PlaneAxis plane_axis(const std::vector<PlaneSegment>& segments, double step);

// How far the points of polylines are from others.
struct Distance {
    double max = 0, mean = 0;
};
Distance distance(const Polylines& from, const Polylines& to);

// Balls on a grid: each centre moved to the nearest multiple of 2^-36 of the least power of two that the longest side of
// the samples' box does not exceed; its weight the squared distance to the least sample that has the
// ball as a pole, as the nearest double, then as the nearest multiple of the squared step.
struct Rounded {
    std::vector<Point> centres;
    std::vector<double> weights;
};
Rounded rounded(const std::vector<Point>& centres, const std::vector<Point>& samples,
                const std::vector<std::array<std::uint32_t, 2>>& pole_of_sample);

}  // namespace reference
