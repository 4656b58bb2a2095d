// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// The flow of the distance to a sample, and its cores.

#include <medax/labels.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace medax {

using FlowOptions = detail::Options<medax_flow_options, medax_flow_options_init>;
using CoreOptions = detail::Options<medax_core_options, medax_core_options_init>;

/// A Delaunay simplex, or its dual, a face of the Voronoi diagram.
using Simplex = medax_simplex;
/// The flow at a point.
using FlowPoint = medax_flow_point;

/// Where some points flow.
struct Orbits {
    /// The row of the critical point where each orbit ends; `none` at infinity.
    std::vector<std::uint32_t> ends;
    /// The orbits as loose edges, with `radius` of vertices, `orbit` and `end` of edges.
    Complex complex;
};

/// A core, and what became of the facets by which it was to be extended.
struct Core {
    Complex complex;
    medax_core_report report;
};

/// The flow of the distance to a sample: its critical points, and where it goes.
class Flow : public detail::Handle<medax_flow, medax_flow_clone, medax_flow_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Flow(const medax_flow *owned) noexcept : Handle(owned) {}

    /// The dual must have its facets; the labels tell the inner from the outer medial axis.
    static Flow of(const Dual &dual, const Labels &labels, const FlowOptions &options = {},
                   const Job &job = Job::fresh()) {
        const medax_flow *flow = nullptr;
        job.check(medax_flow_build(dual.get(), labels.get(), &options, job.get(), &flow));
        return Flow(flow);
    }

    Dual dual() const {
        const medax_dual *dual = nullptr;
        detail::check(medax_flow_dual(get(), &dual));
        return Dual(dual);
    }
    Labels labels() const {
        const medax_labels *labels = nullptr;
        detail::check(medax_flow_labels(get(), &labels));
        return Labels(labels);
    }

    std::size_t critical_count() const noexcept { return medax_flow_critical_count(get()); }
    /// Rows of two: dimension and number of the simplex whose centre each critical point is.
    View<std::uint32_t> critical_simplices() const noexcept {
        return detail::view(medax_flow_critical_simplices(get()));
    }
    View<double> critical_points() const noexcept {
        return detail::view(medax_flow_critical_points(get()));
    }
    View<double> critical_distances() const noexcept {
        return detail::view(medax_flow_critical_distances(get()));
    }
    /// The samples nearest to each critical point, one to four, then `none`.
    View<std::uint32_t> critical_corners() const noexcept {
        return detail::view(medax_flow_critical_corners(get()));
    }
    View<double> critical_slopes() const noexcept {
        return detail::view(medax_flow_critical_slopes(get()));
    }
    View<double> critical_shares() const noexcept {
        return detail::view(medax_flow_critical_shares(get()));
    }
    /// Where each critical point belongs: medax_critical_class.
    View<std::uint32_t> critical_classes() const noexcept {
        return detail::view(medax_flow_critical_classes(get()));
    }
    /// The critical point of a simplex; `none` if it has none.
    std::uint32_t critical_row(Simplex simplex) const noexcept {
        return medax_flow_critical_row(get(), simplex);
    }
    /// The largest slope of the surface's critical points, and the least of the others.
    std::array<double, 2> gap() const {
        std::array<double, 2> gap;
        detail::check(medax_flow_gap(get(), gap.data()));
        return gap;
    }
    /// The critical points but the samples as vertices, for writing.
    Complex critical_complex(const Job &job = Job::fresh()) const {
        const medax_complex *complex = nullptr;
        job.check(medax_flow_critical_complex(get(), job.get(), &complex));
        return Complex(complex);
    }
    /// The triangles of the triangulation: a cell of each, and the slot of the vertex opposite.
    View<std::uint32_t> triangles() const noexcept {
        return detail::view(medax_flow_triangles(get()));
    }
    Simplex driver_of_triangle(std::uint32_t triangle) const noexcept {
        return medax_flow_driver_of_triangle(get(), triangle);
    }
    Simplex driver_of_cell(std::uint32_t cell) const noexcept {
        return medax_flow_driver_of_cell(get(), cell);
    }

    /// The flow at each point.
    std::vector<FlowPoint> at(const std::vector<Point> &queries,
                              const Job &job = Job::fresh()) const {
        std::vector<FlowPoint> at(queries.size());
        const double *xyz = queries.empty() ? nullptr : queries.front().data();
        job.check(medax_flow_at(get(), xyz, queries.size(), job.get(), at.data()));
        return at;
    }
    /// Where each point flows.
    Orbits orbits(const std::vector<Point> &queries, const Job &job = Job::fresh()) const {
        std::vector<std::uint32_t> ends(queries.size());
        const double *xyz = queries.empty() ? nullptr : queries.front().data();
        const medax_complex *orbits = nullptr;
        job.check(
            medax_flow_orbits(get(), xyz, queries.size(), job.get(), ends.data(), &orbits));
        return {std::move(ends), Complex(orbits)};
    }
    /// The core of one side, extended by Voronoi facets, but for those that cannot extend it.
    Core core(const CoreOptions &options = {}, const std::vector<std::uint32_t> &facets = {},
              const Job &job = Job::fresh()) const {
        medax_core_report report;
        report.struct_size = sizeof report;
        const medax_complex *core = nullptr;
        job.check(medax_flow_core(get(), facets.data(), facets.size(), &options, job.get(),
                                  &report, &core));
        return {Complex(core), report};
    }
    /// What flows from the duals of some simplices.
    Complex closure(const std::vector<Simplex> &simplices, const Job &job = Job::fresh()) const {
        const medax_complex *closure = nullptr;
        job.check(medax_flow_closure(get(), simplices.data(), simplices.size(), job.get(),
                                     &closure));
        return Complex(closure);
    }
    Validation validate(const Job &job = Job::fresh()) const {
        return detail::validated(medax_flow_validate, get(), job);
    }
};

}  // namespace medax
