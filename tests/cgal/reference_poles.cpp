#include "reference.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <map>
#include <numeric>

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

Exact::Point_3 circumcentre(const std::vector<Point>& points, const Cell& cell) {
    return CGAL::circumcenter(at<Exact>(points[cell[0]]), at<Exact>(points[cell[1]]), at<Exact>(points[cell[2]]),
                              at<Exact>(points[cell[3]]));
}

// The facets that two cells share, and those that only one cell has.
struct Facets {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> shared;
    std::vector<std::array<std::uint32_t, 3>> hull;
};

Facets facets_of(const std::vector<Cell>& cells) {
    std::vector<std::pair<std::array<std::uint32_t, 3>, std::uint32_t>> sides;
    for (std::uint32_t c = 0; c < cells.size(); ++c) {
        const auto& [i, j, k, l] = cells[c];
        sides.insert(sides.end(), {{{j, k, l}, c}, {{i, k, l}, c}, {{i, j, l}, c}, {{i, j, k}, c}});
    }
    std::sort(sides.begin(), sides.end());
    Facets facets;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if (i + 1 < sides.size() && sides[i].first == sides[i + 1].first) {
            facets.shared.emplace_back(sides[i].second, sides[i + 1].second);
            ++i;
        } else {
            facets.hull.push_back(sides[i].first);
        }
    }
    return facets;
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
        std::uint32_t apex = none;
        for (std::uint32_t v : cells[b])
            if (std::find(cells[a].begin(), cells[a].end(), v) == cells[a].end()) apex = v;
        const Cell& cell = cells[a];
        if (CGAL::side_of_oriented_sphere(at<Inexact>(points[cell[0]]), at<Inexact>(points[cell[1]]),
                                          at<Inexact>(points[cell[2]]), at<Inexact>(points[cell[3]]),
                                          at<Inexact>(points[apex])) == CGAL::ON_ORIENTED_BOUNDARY) {
            std::uint32_t least = std::min(root(a), root(b));
            parent[root(a)] = parent[root(b)] = least;
        }
    }
    for (std::uint32_t c = 0; c < cells.size(); ++c) parent[c] = root(c);
    return parent;
}

}  // namespace

namespace reference {

Poles poles(const std::vector<Point>& points) {
    Poles result;
    result.cells = delaunay(points).cells;
    const Facets facets = facets_of(result.cells);
    result.vertex_of_cell = voronoi_vertices(points, result.cells, facets);
    result.on_hull.resize(points.size());
    for (const auto& facet : facets.hull)
        for (std::uint32_t v : facet) result.on_hull[v] = true;

    std::vector<std::vector<std::uint32_t>> around(points.size());
    std::vector<Exact::Point_3> centres(result.cells.size());
    for (std::uint32_t c = 0; c < result.cells.size(); ++c) {
        if (result.vertex_of_cell[c] == c) centres[c] = circumcentre(points, result.cells[c]);
        for (std::uint32_t v : result.cells[c]) around[v].push_back(result.vertex_of_cell[c]);
    }

    result.pole_of_sample.assign(points.size(), {none, none});
    for (std::uint32_t s = 0; s < points.size(); ++s) {
        if (result.on_hull[s]) continue;
        const Exact::Point_3 sample = at<Exact>(points[s]);
        auto& candidates = around[s];
        std::sort(candidates.begin(), candidates.end());
        candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
        auto better = [&](std::uint32_t a, std::uint32_t b) {
            CGAL::Comparison_result by_distance = CGAL::compare_distance_to_point(sample, centres[a], centres[b]);
            if (by_distance != CGAL::EQUAL) return by_distance == CGAL::LARGER;
            return centres[a] < centres[b];
        };
        auto& [first, second] = result.pole_of_sample[s];
        for (std::uint32_t v : candidates)
            if (first == none || better(v, first)) first = v;
        const Exact::Vector_3 axis = centres[first] - sample;
        for (std::uint32_t v : candidates)
            if ((centres[v] - sample) * axis < 0 && (second == none || better(v, second))) second = v;
    }
    return result;
}

bool is_circumcentre(const std::vector<Point>& points, const Cell& cell, const Point& centre) {
    const Exact::Point_3 exact = circumcentre(points, cell);
    for (int i = 0; i < 3; ++i) {
        auto [low, high] = CGAL::to_interval(CGAL::exact(exact[i]));
        if (centre[i] < low || centre[i] > high) return false;
    }
    return true;
}

}  // namespace reference
