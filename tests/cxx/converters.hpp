// Complexes for the tests of converters.
#pragma once

#include "check.hpp"

#include <medax/convert.hpp>

#include <algorithm>
#include <string>

/// A complex of polygons, with `radius` at its vertices.
inline medax::Complex polygons(const std::vector<medax::Point> &vertices,
                               const std::vector<std::vector<std::uint32_t>> &rings) {
    medax::detail::Parts parts;
    parts.vertices = vertices;
    std::vector<double> radius;
    for (std::size_t v = 0; v < vertices.size(); ++v) radius.push_back(0.5 + static_cast<double>(v));
    for (const auto &ring : rings) {
        parts.indices.insert(parts.indices.end(), ring.begin(), ring.end());
        parts.end_face();
    }
    parts.add("radius", std::move(radius));
    return parts.complex();
}

/// A cube of six quadrilaterals, turned outward.
inline medax::Complex cube() {
    return polygons({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                    {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

/// The sample of a torus.
inline medax::Points torus() {
    medax::SampleOptions options;
    options.spacing = 0.25;
    return medax::Samples::of(MEDAX_SHAPE_TORUS, options).points();
}

/// Faces that no halfedge structure holds together, and how many it does hold: three at an edge; two that turn against
/// each other; two closed fans at a vertex; a fan that closes beside another.
struct Misfit {
    std::vector<std::vector<std::uint32_t>> rings;
    std::vector<std::uint32_t> left_out;
};
inline std::vector<Misfit> misfits() {
    return {{{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, {2}},
            {{{0, 1, 2}, {0, 1, 3}, {1, 0, 4}}, {1}},
            {{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}}, {3, 4, 5}},
            {{{0, 4, 5}, {0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 5, 6}}, {3}}};
}
inline medax::Complex misfit(const Misfit &from) {
    return polygons({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}, from.rings);
}

/// Whether two complexes have the same vertices and rings.
inline bool same(const medax::Complex &a, const medax::Complex &b) {
    const auto equal = [](const auto &left, const auto &right) {
        return std::equal(left.begin(), left.end(), right.begin(), right.end());
    };
    return equal(a.vertices(), b.vertices()) && equal(a.faces().offsets(), b.faces().offsets())
           && equal(a.faces().indices(), b.faces().indices());
}
