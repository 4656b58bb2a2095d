// The medial axis of polygons, read off CGAL's Voronoi diagram of segments.
#include "reference.hpp"

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Segment_Delaunay_graph_2.h>
#include <CGAL/Segment_Delaunay_graph_filtered_traits_2.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace {

using reference::PlanePoint;
using reference::PlaneSegment;
using reference::Polylines;

using Kernel = CGAL::Simple_cartesian<double>;
// Segments share ends and nothing else.
using Traits = CGAL::Segment_Delaunay_graph_filtered_traits_without_intersections_2<Kernel>;
using Graph = CGAL::Segment_Delaunay_graph_2<Traits>;
using Site = Graph::Site_2;

PlanePoint plain(const Graph::Point_2& p) { return {p.x(), p.y()}; }

// By the parity of the segments to the right of a point.
bool is_inside(const std::vector<PlaneSegment>& segments, const PlanePoint& p) {
    bool inside = false;
    for (const auto& [a, b] : segments)
        if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
    return inside;
}

// The points of a Voronoi edge between two of its own, no farther apart than a step.
std::vector<PlanePoint> traced(const Site& p, const Site& q, const PlanePoint& a, const PlanePoint& b, double step) {
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const int parts = std::max(1, static_cast<int>(std::ceil(length / step)));
    std::vector<PlanePoint> points{a};
    for (int i = 1; i < parts; ++i) {
        const double share = static_cast<double>(i) / parts;
        PlanePoint x{a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])};
        if (p.is_point() != q.is_point()) {
            // On the parabola, above the same place of the line.
            const PlanePoint focus = plain(p.is_point() ? p.point() : q.point());
            const Site& line = p.is_point() ? q : p;
            const PlanePoint from = plain(line.source()), to = plain(line.target());
            const double size = std::hypot(to[0] - from[0], to[1] - from[1]);
            const PlanePoint along{(to[0] - from[0]) / size, (to[1] - from[1]) / size}, up{-along[1], along[0]};
            const auto place = [&](const PlanePoint& y, const PlanePoint& axis) {
                return (y[0] - from[0]) * axis[0] + (y[1] - from[1]) * axis[1];
            };
            const double t = place(x, along), off = t - place(focus, along), height = place(focus, up);
            const double rise = (off * off + height * height) / (2 * height);
            x = {from[0] + t * along[0] + rise * up[0], from[1] + t * along[1] + rise * up[1]};
        }
        points.push_back(x);
    }
    points.push_back(b);
    return points;
}

// Whether a site is an end of the other: what lies between them is no part of the axis.
bool is_end(const Site& end, const Site& of) {
    return end.is_point() && of.is_segment() && (end.point() == of.source() || end.point() == of.target());
}

}  // namespace

namespace reference {

PlaneAxis plane_axis(const std::vector<PlaneSegment>& segments, double step) {
    const auto begun = std::chrono::steady_clock::now();
    std::vector<Graph::Point_2> ends;
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (const auto& [a, b] : segments) {
        pairs.push_back({ends.size(), ends.size() + 1});
        ends.insert(ends.end(), {{a[0], a[1]}, {b[0], b[1]}});
    }
    Graph graph;
    graph.insert_segments(ends.begin(), ends.end(), pairs.begin(), pairs.end());
    PlaneAxis axis;
    axis.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    for (auto edge = graph.finite_edges_begin(); edge != graph.finite_edges_end(); ++edge) {
        const auto face = edge->first, other = face->neighbor(edge->second);
        // What is unbounded lies outside.
        if (graph.is_infinite(face) || graph.is_infinite(other)) continue;
        const Site p = face->vertex(graph.cw(edge->second))->site(), q = face->vertex(graph.ccw(edge->second))->site();
        if (is_end(p, q) || is_end(q, p)) continue;
        const auto line = traced(p, q, plain(graph.circumcenter(face)), plain(graph.circumcenter(other)), step);
        const PlanePoint &a = line[(line.size() - 1) / 2], &b = line[line.size() / 2];
        if (is_inside(segments, {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2})) axis.lines.push_back(line);
    }
    return axis;
}

Distance distance(const Polylines& from, const Polylines& to) {
    using Segments = std::vector<Kernel::Segment_3>;
    using Primitive = CGAL::AABB_segment_primitive<Kernel, Segments::iterator>;
    const auto lifted = [](const PlanePoint& p) { return Kernel::Point_3(p[0], p[1], 0); };
    Segments segments;
    for (const auto& line : to)
        for (std::size_t i = 1; i < line.size(); ++i) segments.push_back({lifted(line[i - 1]), lifted(line[i])});
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree(segments.begin(), segments.end());
    Distance distance;
    std::size_t count = 0;
    for (const auto& line : from)
        for (const PlanePoint& p : line) {
            const double its = std::sqrt(tree.squared_distance(lifted(p)));
            distance.max = std::max(distance.max, its);
            distance.mean += its;
            ++count;
        }
    distance.mean /= static_cast<double>(std::max<std::size_t>(count, 1));
    return distance;
}

}  // namespace reference
