// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// Delaunay and regular triangulations.

#include <medax/complex.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace medax {

using TriangulationOptions =
    detail::Options<medax_triangulation_options, medax_triangulation_options_init>;

/// A Delaunay or regular triangulation.
class Triangulation : public detail::Handle<medax_triangulation, medax_triangulation_clone,
                                            medax_triangulation_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Triangulation(const medax_triangulation *owned) noexcept : Handle(owned) {}

    static Triangulation delaunay(const Points &points, const TriangulationOptions &options = {},
                                  const Job &job = Job::fresh()) {
        const medax_triangulation *built = nullptr;
        job.check(medax_delaunay_build(points.get(), &options, job.get(), &built));
        return Triangulation(built);
    }
    /// One weight per input row of the points, in squared units.
    static Triangulation regular(const Points &points, const std::vector<double> &weights,
                                 const TriangulationOptions &options = {},
                                 const Job &job = Job::fresh()) {
        const medax_triangulation *built = nullptr;
        job.check(medax_regular_build(points.get(), weights.data(), weights.size(), &options,
                                      job.get(), &built));
        return Triangulation(built);
    }

    Points points() const {
        const medax_points *points = nullptr;
        detail::check(medax_triangulation_points(get(), &points));
        return Points(points);
    }
    View<double> coords() const noexcept { return detail::view(medax_triangulation_coords(get())); }
    View<double> weights() const noexcept {
        return detail::view(medax_triangulation_weights(get()));
    }
    View<std::uint32_t> row_of_vertex() const noexcept {
        return detail::view(medax_triangulation_row_of_vertex(get()));
    }
    View<std::uint32_t> cells() const noexcept {
        return detail::view(medax_triangulation_cells(get()));
    }
    View<std::uint32_t> neighbors() const noexcept {
        return detail::view(medax_triangulation_neighbors(get()));
    }
    View<std::uint32_t> hidden() const noexcept {
        return detail::view(medax_triangulation_hidden(get()));
    }

    /// A cell that holds the point, or medax::none outside the convex hull.
    std::uint32_t locate(const Point &point, std::uint32_t hint_cell = 0) const {
        std::uint32_t cell = none;
        detail::check(medax_triangulation_locate(get(), point.data(), hint_cell, &cell));
        return cell;
    }

    /// The cells round an edge; not closed on the hull.
    struct Ring {
        std::vector<std::uint32_t> cells;
        bool closed;
    };
    /// The ring round the edge from `a` to `b`, given one of its cells.
    Ring ring(std::uint32_t cell, std::uint32_t a, std::uint32_t b) const {
        std::vector<std::uint32_t> cells(32);
        std::size_t count = 0;
        std::uint32_t closed = 0;
        const auto fill = [&] {
            detail::check(medax_triangulation_ring(get(), cell, a, b, cells.size(), cells.data(),
                                                   &count, &closed));
            const bool fits = count <= cells.size();
            cells.resize(count);
            return fits;
        };
        if (!fill()) fill();
        return {std::move(cells), closed != 0};
    }

    /// The vertices and the cells as tetrahedra, for writing.
    Complex complex() const {
        const medax_complex *complex = nullptr;
        detail::check(medax_triangulation_complex(get(), &complex));
        return Complex(complex);
    }
    Validation validate(const Job &job = Job::fresh()) const {
        return detail::validated(medax_triangulation_validate, get(), job);
    }
};

/// The cells of each vertex of a triangulation, and its edges.
class Incidence
    : public detail::Handle<medax_incidence, medax_incidence_clone, medax_incidence_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Incidence(const medax_incidence *owned) noexcept : Handle(owned) {}

    static Incidence of(const Triangulation &triangulation, const Job &job = Job::fresh()) {
        const medax_incidence *built = nullptr;
        job.check(medax_incidence_build(triangulation.get(), job.get(), &built));
        return Incidence(built);
    }

    Rows cells_of_vertex() const noexcept { return Rows(medax_incidence_cells_of_vertex(get())); }
    View<std::uint32_t> edges() const noexcept {
        return detail::view(medax_incidence_edges(get()));
    }
    View<std::uint32_t> cell_of_edge() const noexcept {
        return detail::view(medax_incidence_cell_of_edge(get()));
    }
};

}  // namespace medax
