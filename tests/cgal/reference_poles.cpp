#include "reference.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
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

struct Facets {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> shared;  // pairs of cells
    std::vector<std::pair<std::array<std::uint32_t, 3>, std::uint32_t>> hull;  // with their cell
};

Facets facets_of(const std::vector<Cell>& cells) {
    std::vector<std::pair<std::array<std::uint32_t, 3>, std::uint32_t>> sides;
    for (std::uint32_t c = 0; c < cells.size(); ++c) {
        Cell cell = cells[c];
        std::sort(cell.begin(), cell.end());
        const auto& [i, j, k, l] = cell;
        sides.insert(sides.end(), {{{j, k, l}, c}, {{i, k, l}, c}, {{i, j, l}, c}, {{i, j, k}, c}});
    }
    std::sort(sides.begin(), sides.end());
    Facets facets;
    for (std::size_t i = 0; i < sides.size(); ++i)
        if (i + 1 < sides.size() && sides[i].first == sides[i + 1].first) {
            facets.shared.emplace_back(sides[i].second, sides[i + 1].second);
            ++i;
        } else {
            facets.hull.push_back(sides[i]);
        }
    return facets;
}

// The vertex of the cell that the facet lacks.
template <class Facet>
std::uint32_t apex_of(const Cell& cell, const Facet& facet) {
    for (std::uint32_t v : cell)
        if (std::find(facet.begin(), facet.end(), v) == facet.end()) return v;
    return none;
}

std::vector<Point> directions_to_infinity(const std::vector<Point>& points, std::size_t sample_count,
                                          const std::vector<Cell>& cells, const Facets& facets) {
    std::vector<Point> sums(sample_count, Point{0, 0, 0});
    const auto unit = [](Point p) {
        const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        for (double& x : p) x /= length;
        return p;
    };
    for (const auto& [facet, cell] : facets.hull) {
        const Exact::Point_3 a = at<Exact>(points[facet[0]]);
        Exact::Vector_3 normal =
            CGAL::cross_product(at<Exact>(points[facet[1]]) - a, at<Exact>(points[facet[2]]) - a);
        if (normal * (at<Exact>(points[apex_of(cells[cell], facet)]) - a) > 0) normal = -normal;
        const Point outward = unit({CGAL::to_double(CGAL::exact(normal.x())), CGAL::to_double(CGAL::exact(normal.y())),
                                    CGAL::to_double(CGAL::exact(normal.z()))});
        for (std::uint32_t v : facet)
            if (v < sample_count)
                for (int i = 0; i < 3; ++i) sums[v][i] += outward[i];
    }
    for (Point& sum : sums)
        if (sum != Point{0, 0, 0}) sum = unit(sum);
    return sums;
}

// Cells of one circumcentre are joined by facets across which the sphere test gives zero.
std::vector<std::uint32_t> voronoi_vertices(const std::vector<Point>& points, const std::vector<Cell>& cells,
                                            const Facets& facets) {
    std::vector<std::uint32_t> parent(cells.size());
    std::iota(parent.begin(), parent.end(), 0);
    auto root = [&](std::uint32_t c) {
        while (parent[c] != c) c = parent[c] = parent[parent[c]];
        return c;
    };
    for (const auto& [a, b] : facets.shared) {
        const Cell& cell = cells[a];
        const std::uint32_t apex = apex_of(cells[b], cell);
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

Poles poles(const std::vector<Point>& points, std::size_t sample_count, const std::vector<Cell>& cells,
            const std::vector<Point>& directions) {
    Poles result;
    const Facets facets = facets_of(cells);
    result.vertex_of_cell = voronoi_vertices(points, cells, facets);
    result.to_infinity = directions_to_infinity(points, sample_count, cells, facets);
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

    // Rounding keeps the order of distances that it does not make equal.
    auto farther = [&](const Exact::Point_3& sample, std::uint32_t a, std::uint32_t b) {
        if (result.radius_squared[a] != result.radius_squared[b])
            return result.radius_squared[a] > result.radius_squared[b];
        const auto order = CGAL::compare_distance_to_point(sample, exact[a], exact[b]);
        if (order != CGAL::EQUAL) return order == CGAL::LARGER;
        if (result.centre[a] != result.centre[b]) return result.centre[a] < result.centre[b];
        return a < b;
    };
    for (std::uint32_t s = 0; s < sample_count; ++s) {
        std::uint32_t first = none, second = none;
        const Exact::Point_3 sample = at<Exact>(points[s]);
        Exact::Vector_3 towards;
        if (result.to_infinity[s] != Point{0, 0, 0}) {
            const auto& [x, y, z] = directions.at(s);
            towards = Exact::Vector_3(x, y, z);
        } else {
            for (std::uint32_t c : around[s])
                if (first == none || farther(sample, c, first)) first = c;
            towards = exact[first] - sample;
        }
        for (std::uint32_t c : around[s])
            if ((second == none || farther(sample, c, second)) && (exact[c] - sample) * towards < 0) second = c;
        const auto vertex = [&](std::uint32_t c) { return c == none ? none : result.vertex_of_cell[c]; };
        result.pole_of_sample.push_back({vertex(first), vertex(second)});
    }
    return result;
}

Rounded rounded(const std::vector<Point>& centres, const std::vector<Point>& samples,
                const std::vector<std::array<std::uint32_t, 2>>& pole_of_sample) {
    double side = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto less = [axis](const Point& p, const Point& q) { return p[axis] < q[axis]; };
        const auto [least, most] = std::minmax_element(samples.begin(), samples.end(), less);
        side = std::max(side, (*most)[axis] - (*least)[axis]);
    }
    int exponent = 0;
    while (std::ldexp(1, exponent) < side) ++exponent;
    while (std::ldexp(1, exponent - 1) >= side) --exponent;
    const double step = std::ldexp(1, exponent - 36);
    const auto multiple = [](double x, double of) { return std::nearbyint(x / of) * of; };
    Rounded result;
    for (const Point& p : centres) result.centres.push_back({multiple(p[0], step), multiple(p[1], step), multiple(p[2], step)});
    result.weights.resize(centres.size());
    for (std::size_t s = samples.size(); s-- > 0;)
        for (std::uint32_t pole : pole_of_sample[s]) {
            if (pole == none) continue;
            const Exact::FT square = CGAL::squared_distance(at<Exact>(result.centres[pole]), at<Exact>(samples[s]));
            result.weights[pole] = multiple(nearest(square), step * step);
        }
    return result;
}

}  // namespace reference
