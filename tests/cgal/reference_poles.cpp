#include "reference.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <tuple>

namespace {

using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using reference::Cell;
using reference::none;
using reference::Point;

template <class Kernel>
typename Kernel::Point_3 at(const Point& p) {
    return {p[0], p[1], p[2]};
}

// The double nearest to an exact number; half way, the even one.
double nearest(const Exact::FT& x) {
    auto [low, high] = CGAL::to_interval(x);
    if (low == high) return low;
    std::tie(low, high) = CGAL::to_interval(CGAL::exact(x));  // as tight as doubles are
    if (low == high) return low;
    const Exact::FT below = x - Exact::FT(low), above = Exact::FT(high) - x;
    const CGAL::Comparison_result nearer = CGAL::compare(below, above);
    if (nearer != CGAL::EQUAL) return nearer == CGAL::SMALLER ? low : high;
    std::uint64_t bits;
    std::memcpy(&bits, &low, sizeof bits);
    return bits % 2 == 0 ? low : high;
}

// Pairs of cells that share a facet.
std::vector<std::pair<std::uint32_t, std::uint32_t>> neighbours(const std::vector<Cell>& cells) {
    std::vector<std::pair<std::array<std::uint32_t, 3>, std::uint32_t>> sides;
    for (std::uint32_t c = 0; c < cells.size(); ++c) {
        Cell cell = cells[c];
        std::sort(cell.begin(), cell.end());
        const auto& [i, j, k, l] = cell;
        sides.insert(sides.end(), {{{j, k, l}, c}, {{i, k, l}, c}, {{i, j, l}, c}, {{i, j, k}, c}});
    }
    std::sort(sides.begin(), sides.end());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::size_t i = 0; i + 1 < sides.size(); ++i)
        if (sides[i].first == sides[i + 1].first) pairs.emplace_back(sides[i].second, sides[i + 1].second);
    return pairs;
}

// Cells of one circumcentre are joined by facets across which the sphere test gives zero.
std::vector<std::uint32_t> voronoi_vertices(const std::vector<Point>& points, const std::vector<Cell>& cells) {
    std::vector<std::uint32_t> parent(cells.size());
    std::iota(parent.begin(), parent.end(), 0);
    auto root = [&](std::uint32_t c) {
        while (parent[c] != c) c = parent[c] = parent[parent[c]];
        return c;
    };
    for (const auto& [a, b] : neighbours(cells)) {
        const Cell& cell = cells[a];
        std::uint32_t apex = none;
        for (std::uint32_t v : cells[b])
            if (std::find(cell.begin(), cell.end(), v) == cell.end()) apex = v;
        if (CGAL::side_of_oriented_sphere(at<Inexact>(points[cell[0]]), at<Inexact>(points[cell[1]]),
                                          at<Inexact>(points[cell[2]]), at<Inexact>(points[cell[3]]),
                                          at<Inexact>(points[apex])) == CGAL::ON_ORIENTED_BOUNDARY) {
            const std::uint32_t least = std::min(root(a), root(b));
            parent[root(a)] = parent[root(b)] = least;
        }
    }
    for (std::uint32_t c = 0; c < cells.size(); ++c) parent[c] = root(c);
    return parent;
}

}  // namespace

namespace reference {

Poles poles(const std::vector<Point>& points, std::size_t sample_count, const std::vector<Cell>& cells) {
    Poles result;
    result.vertex_of_cell = voronoi_vertices(points, cells);
    std::vector<std::vector<std::uint32_t>> around(points.size());
    std::vector<Exact::Point_3> exact;
    for (std::uint32_t c = 0; c < cells.size(); ++c) {
        const Cell& cell = cells[c];
        const Exact::Point_3 corner = at<Exact>(points[cell[0]]);
        exact.push_back(CGAL::circumcenter(corner, at<Exact>(points[cell[1]]), at<Exact>(points[cell[2]]),
                                           at<Exact>(points[cell[3]])));
        result.centre.push_back({nearest(exact[c].x()), nearest(exact[c].y()), nearest(exact[c].z())});
        result.radius_squared.push_back(nearest(CGAL::squared_distance(exact[c], corner)));
        for (std::uint32_t v : cell) around[v].push_back(c);
    }

    auto farther = [&](std::uint32_t a, std::uint32_t b) {
        if (result.radius_squared[a] != result.radius_squared[b])
            return result.radius_squared[a] > result.radius_squared[b];
        if (result.centre[a] != result.centre[b]) return result.centre[a] < result.centre[b];
        return a < b;
    };
    for (std::uint32_t s = 0; s < sample_count; ++s) {
        std::uint32_t first = none, second = none;
        for (std::uint32_t c : around[s])
            if (first == none || farther(c, first)) first = c;
        const Exact::Point_3 sample = at<Exact>(points[s]);
        bool beaten = false;
        for (std::uint32_t c : around[s]) {
            if ((second == none || farther(c, second)) && CGAL::angle(exact[c], sample, exact[first]) == CGAL::OBTUSE)
                second = c;
            beaten = beaten || (c != first && result.radius_squared[c] == result.radius_squared[first] &&
                                CGAL::compare_distance_to_point(sample, exact[c], exact[first]) == CGAL::LARGER);
        }
        result.near_ties += beaten;
        result.pole_of_sample.push_back(
            {result.vertex_of_cell[first], second == none ? none : result.vertex_of_cell[second]});
    }
    return result;
}

}  // namespace reference
