// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// What the converters of medax_openmesh.hpp and medax_cgal.hpp have in common; of use without them where
/// a program has a mesh of its own.

#include <medax/complex.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace medax {

/// A face that a halfedge structure cannot hold beside those before it: one of its sides has its faces already, or is turned the other
/// way, or other faces close round one of its corners. index() is its number in the complex.
class NotManifold : public Error {
public:
    explicit NotManifold(std::uint32_t face)
        : Error(MEDAX_STATUS_INVALID_ARGUMENT,
                "face " + std::to_string(face) + " does not fit a halfedge mesh: it is not manifold there",
                MEDAX_ERROR_KIND_FACE, face) {}
};

/// Polygons of any kind, manifold or not.
template <class P = Point>
struct Soup {
    std::vector<P> points;
    std::vector<std::vector<std::size_t>> polygons;
};

/// The vertices and faces of a complex, its points made of three coordinates.
template <class P = Point>
Soup<P> soup(const Complex &complex) {
    Soup<P> soup;
    const View<double> xyz = complex.vertices();
    const Rows faces = complex.faces();
    soup.points.reserve(xyz.rows());
    soup.polygons.reserve(faces.rows());
    for (std::size_t v = 0; v < xyz.rows(); ++v) soup.points.push_back(P{xyz[v][0], xyz[v][1], xyz[v][2]});
    for (std::size_t f = 0; f < faces.rows(); ++f) soup.polygons.emplace_back(faces[f].begin(), faces[f].end());
    return soup;
}

/// A value for each input row, such as a normal, in the order of the vertices that the rows became.
template <class T>
std::vector<T> by_vertex(const Points &points, const std::vector<T> &of_rows) {
    if (of_rows.size() != points.row_count())
        throw std::invalid_argument("the values and the points' rows differ in number");
    std::vector<T> ordered;
    ordered.reserve(points.count());
    for (const std::uint32_t row : points.row_of_vertex()) ordered.push_back(of_rows[row]);
    return ordered;
}

namespace detail {

/// Rings one by one, each only if a halfedge structure can take it beside those that it has.
class Fitting {
public:
    /// Of all rings that may come: Rows, or a View of triangles.
    template <class Rings>
    Fitting(std::size_t vertices, const Rings &rings) : begin_(vertices + 1), faces_at_(vertices), closed_(vertices) {
        std::size_t sides = 0;
        for (std::size_t f = 0; f < rings.rows(); ++f)
            for (const std::uint32_t v : rings[f]) ++begin_[v], ++sides;
        for (std::size_t v = 0, sum = 0; v <= vertices; ++v) begin_[v] = sum += begin_[v];
        to_.resize(sides);
        before_.resize(sides, none);
        for (std::size_t f = 0; f < rings.rows(); ++f) {
            const Span<std::uint32_t> ring = rings[f];
            for (std::size_t i = 0; i < ring.size(); ++i) to_[--begin_[ring[i]]] = next(ring, i);
        }
        for (std::size_t v = 0; v < vertices; ++v) std::sort(to_.begin() + place(v), to_.begin() + place(v + 1));
    }

    /// Whether the ring fits those that were taken; it is taken then.
    bool take(Span<std::uint32_t> ring) {
        const std::size_t n = ring.size();
        for (std::size_t i = 0; i < n; ++i)
            if (closed_[ring[i]] || before(ring[i], next(ring, i)) != none) return false;
        for (std::size_t i = 0; i < n; ++i) {
            before_[find(ring[i], next(ring, i))] = previous(ring, i);
            ++faces_at_[ring[i]];
        }
        bool fits = true;
        for (std::size_t i = 0; i < n && fits; ++i) {
            const std::uint32_t around = turn(ring, i);
            fits = around == 0 || around == faces_at_[ring[i]];
            closed_[ring[i]] = around != 0;
        }
        for (std::size_t i = 0; i < n && !fits; ++i) {
            before_[find(ring[i], next(ring, i))] = none;
            --faces_at_[ring[i]];
            closed_[ring[i]] = false;
        }
        return fits;
    }

private:
    static std::uint32_t next(Span<std::uint32_t> ring, std::size_t i) noexcept {
        return ring[i + 1 < ring.size() ? i + 1 : 0];
    }
    static std::uint32_t previous(Span<std::uint32_t> ring, std::size_t i) noexcept {
        return ring[(i > 0 ? i : ring.size()) - 1];
    }
    std::ptrdiff_t place(std::size_t vertex) const noexcept { return static_cast<std::ptrdiff_t>(begin_[vertex]); }

    /// The place of a side, or the number of sides.
    std::size_t find(std::uint32_t from, std::uint32_t to) const {
        const auto end = to_.begin() + place(from + std::size_t{1});
        const auto found = std::lower_bound(to_.begin() + place(from), end, to);
        return found != end && *found == to ? static_cast<std::size_t>(found - to_.begin()) : to_.size();
    }
    /// The vertex before a side in the ring that was taken with it, or none.
    std::uint32_t before(std::uint32_t from, std::uint32_t to) const {
        const std::size_t side = find(from, to);
        return side < to_.size() ? before_[side] : none;
    }
    /// The number of faces round a corner of a ring if they close, 0 if they do not.
    std::uint32_t turn(Span<std::uint32_t> ring, std::size_t corner) const {
        const std::uint32_t v = ring[corner], first = next(ring, corner);
        // Only a face with neighbours on both sides can close them: so a long fan is walked seldom.
        if (before(first, v) == none) return 0;
        std::uint32_t count = 0, to = first;
        do {
            to = before(v, to);
            if (to == none) return 0;
            ++count;
        } while (to != first);
        return count;
    }

    /// Where the sides from each vertex begin; their other ends, in order; what is before each where it was taken.
    std::vector<std::size_t> begin_;
    std::vector<std::uint32_t> to_, before_;
    std::vector<std::uint32_t> faces_at_;
    std::vector<bool> closed_;
};

/// Tells of a face that does not fit.
inline void left_out(std::uint32_t face, std::vector<std::uint32_t> *list) {
    if (list == nullptr) throw NotManifold(face);
    if (list->empty() || list->back() != face) list->push_back(face);
}

/// The arrays of a complex while it is made.
struct Parts {
    std::vector<Point> vertices;
    std::vector<std::uint32_t> offsets{0}, indices;
    std::vector<std::pair<std::string, std::vector<double>>> values;

    /// A value, or several, for each vertex.
    void add(const std::string &name, std::vector<double> of_vertices) {
        values.emplace_back(name, std::move(of_vertices));
    }
    void add(const std::string &name, const std::vector<Point> &of_vertices) {
        std::vector<double> flat;
        flat.reserve(3 * of_vertices.size());
        for (const Point &p : of_vertices) flat.insert(flat.end(), p.begin(), p.end());
        add(name, std::move(flat));
    }
    void end_face() {
        if (indices.size() > UINT32_MAX) throw std::length_error("more than 2^32 - 1 corners of faces");
        offsets.push_back(static_cast<std::uint32_t>(indices.size()));
    }
    Complex complex() const {
        std::vector<medax_attribute> attributes;
        for (const auto &[name, of_vertices] : values) {
            if (vertices.empty()) continue;
            medax_attribute attribute{};
            attribute.name = name.c_str();
            attribute.element = MEDAX_ELEMENT_VERTEX;
            attribute.value_type = MEDAX_VALUE_TYPE_F64;
            attribute.f64_values = {of_vertices.data(), vertices.size(), of_vertices.size() / vertices.size()};
            attributes.push_back(attribute);
        }
        ComplexParts parts;
        parts.vertices = vertices.empty() ? nullptr : vertices.front().data();
        parts.vertex_count = vertices.size();
        parts.face_offsets = offsets.data();
        parts.face_indices = indices.data();
        parts.face_count = offsets.size() - 1;
        parts.attributes = attributes.data();
        parts.attribute_count = attributes.size();
        return Complex::from(parts);
    }
};

}  // namespace detail

}  // namespace medax
